"""What the report of a fit shows beyond its numbers: profiles, replays, assumptions."""

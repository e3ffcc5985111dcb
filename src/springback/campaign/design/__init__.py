"""Design of a campaign: its plan, and the values of every flight."""

"""What a flight leaves: its record, step by step, and the measures that are read from it."""

"""Results: a flight, its measures, and its files."""

"""Results: a flight, its measures, and the files that hold it."""

"""Batches: many scenarios, built together and flown in lanes."""

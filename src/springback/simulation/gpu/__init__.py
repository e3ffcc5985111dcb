"""Flights on a GPU, one in each thread."""

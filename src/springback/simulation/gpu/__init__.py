"""Flights on a GPU, one a thread."""

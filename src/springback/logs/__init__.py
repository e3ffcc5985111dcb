"""Recordings of real and simulated flights: read, checked, searched for impacts, written."""

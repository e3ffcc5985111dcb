"""Vehicles: parameters, state, and the vehicles of the literature."""

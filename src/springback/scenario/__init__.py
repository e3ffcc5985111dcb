"""Scenarios: what a user writes down, checked, and the model and avionics built from it."""

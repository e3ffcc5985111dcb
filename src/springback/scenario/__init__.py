"""Scenarios: validated user input, and the model and avionics built from it."""

"""Flights as scenes, and their replay."""

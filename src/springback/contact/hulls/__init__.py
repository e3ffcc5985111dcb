"""Hulls of a vehicle against all solids of a scene."""

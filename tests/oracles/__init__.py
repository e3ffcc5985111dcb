"""Slow, plain and independent versions of the physics, to hold the package against."""

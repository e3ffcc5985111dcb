"""Vehicles that can be flown but are hardly intended: overlapping guards, sizes, springs."""

"""Vehicles that can be flown and are seldom meant: guards in each other, sizes, springs."""

"""Rotors apart from arms: any place, any axis, on the main body or at the end of an arm."""

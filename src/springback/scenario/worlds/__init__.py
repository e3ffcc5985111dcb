"""Worlds of other programs: read, placed, and converted to built-in obstacles."""

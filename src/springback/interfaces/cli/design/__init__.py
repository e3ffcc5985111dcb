"""A vehicle of one's own from a few answers."""

"""Recordings of others, read from the user's own copy, and what the package predicts of them."""

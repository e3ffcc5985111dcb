"""Figures of fits to recorded impacts."""

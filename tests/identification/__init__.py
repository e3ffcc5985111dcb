"""Identification from recorded impacts."""

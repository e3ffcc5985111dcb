"""Figures of the report on the paper."""

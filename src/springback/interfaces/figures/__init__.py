"""Figures of flights, campaigns and studies, in one style."""

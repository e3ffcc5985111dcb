"""Kernels compiled by two processes at once."""

"""Kernels compiled when a wheel is built, which it carries."""

"""Attacks that take long; `make attack` prints their table."""

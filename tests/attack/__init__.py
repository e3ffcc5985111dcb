"""Attacks that take long; `build attack` prints their table."""

"""``python -m springback``."""

from springback.command import run

run()

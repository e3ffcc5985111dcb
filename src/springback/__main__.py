"""``python -m springback``."""

from springback.interfaces.cli import run

run()

"""``python -m springback``."""

from springback.interfaces.cli import main

main()

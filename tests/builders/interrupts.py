"""Ctrl-C, for processes that tests start."""

from __future__ import annotations

import signal


def heed_interrupts() -> None:
    """Jobs in the background inherit an ignored SIGINT; a user at a terminal does not."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)

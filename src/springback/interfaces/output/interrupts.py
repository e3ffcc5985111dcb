"""Ctrl-C: end a command at once, with a message, whatever it is doing."""

from __future__ import annotations

import _thread
import signal
import sys
import threading
from types import FrameType
from typing import Any

NOTHING = "interrupted; nothing was written"
#: Delay until an exception that Python dropped is raised again [s] (chosen).
SOON = 0.02
_words = [NOTHING]
_came = threading.Event()


def say(words: str) -> None:
    """Set the message."""
    _words[0] = words


def message() -> str:
    """The message."""
    return _words[0]


def is_interrupted() -> bool:
    """True once Ctrl-C was pressed: later errors are its consequences."""
    return _came.is_set()


def install_handler() -> None:
    """Let Ctrl-C end this process whatever it is doing, and record it.

    Python drops exceptions raised in finalisers and in callbacks of libraries; one that Ctrl-C
    raised there is raised again.
    """
    before = sys.unraisablehook

    def unraisable(info: Any) -> None:
        if issubclass(info.exc_type, KeyboardInterrupt):
            again = threading.Timer(SOON, _once_more)  # not here, where it would be dropped
            again.daemon = True
            again.start()
        elif not is_interrupted():
            before(info)

    def interrupted(number: int, frame: FrameType | None) -> None:
        _came.set()
        raise KeyboardInterrupt

    sys.unraisablehook = unraisable
    if signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:  # a job in the background
        signal.signal(signal.SIGINT, interrupted)


def _once_more() -> None:
    """Interrupt the main thread again, which also wakes it."""
    ident = threading.main_thread().ident
    if ident is not None and hasattr(signal, "pthread_kill"):
        signal.pthread_kill(ident, signal.SIGINT)
    else:
        _thread.interrupt_main()


def ignore() -> None:
    """Ignore further Ctrl-C: one is being handled."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)

"""Progress as lines on stderr at intervals, where there is no terminal."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

SILENCE = 10.0
"""Seconds before a line says what is done where there is no terminal."""
LOOK = 1.0
"""Seconds between two looks at whether a line is due."""


class ProgressLines:
    """What a long task does, said when nothing was said of it for some seconds."""

    def __init__(
        self, label: str, say: Callable[[str], None], clock: Callable[[], float] = time.monotonic
    ) -> None:
        """Begin a task.

        Args:
            label: Name of the task; what follows a semicolon is said once.
            say: Prints a line.
            clock: Time [s].
        """
        self.label, self._say, self._clock = label, say, clock
        self._share: float | None = None
        self._doing = ""
        self._begun = self._last = clock()

    def show(self, share: float) -> None:
        """Take the share done, from 0 to 1."""
        self._share = share

    def tell(self, doing: str) -> None:
        """Take what is being done, in words."""
        self._doing = doing

    def look(self) -> None:
        """Say a line if one is due."""
        now = self._clock()
        if now - self._last < SILENCE:
            return
        self._last = now
        share = "" if self._share is None else f"{self._share:.0%}"
        said = ", ".join(part for part in (share, self._doing) if part)
        after = f"after {now - self._begun:.0f} s"
        self._say(f"{self.label}: {said}, {after}" if said else f"{self.label}, {after}")
        self.label = self.label.partition(";")[0]

    @contextmanager
    def looking(self) -> Iterator[None]:
        """Say lines while a task runs, also where it reports nothing for long."""
        done = threading.Event()

        def watch() -> None:
            while not done.wait(LOOK):
                self.look()

        thread = threading.Thread(target=watch, daemon=True)
        thread.start()
        try:
            yield
        finally:
            done.set()
            thread.join()

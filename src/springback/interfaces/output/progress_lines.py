"""Progress as lines on stderr at intervals, where there is no terminal."""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from springback.campaign.running import CampaignProgress

SILENCE = 10.0
"""Seconds before a line says what is done where there is no terminal."""
USUAL = 60.0
"""Seconds for which the first flights of a campaign are usually compiled, at most (chosen)."""
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

    def looking(self) -> AbstractContextManager[None]:
        """Say lines while a task runs, also where it reports nothing for long."""
        return _looking(self.look)


@contextmanager
def _looking(look: Callable[[], None]) -> Iterator[None]:
    """Look again and again, until the block ends."""
    done = threading.Event()

    def watch() -> None:
        while not done.wait(LOOK):
            look()

    thread = threading.Thread(target=watch, daemon=True)
    thread.start()
    try:
        yield
    finally:
        done.set()
        thread.join()


class CampaignLines:
    """Progress of a campaign, and how long its first flights are being compiled and flown."""

    def __init__(
        self, say: Callable[[str], None], clock: Callable[[], float] = time.monotonic
    ) -> None:
        """Begin a campaign.

        Args:
            say: Prints a line.
            clock: Time [s].
        """
        self._say, self._clock = say, clock
        self._begun = clock()
        self._last = -math.inf
        self._now: CampaignProgress | None = None

    def show(self, now: CampaignProgress) -> None:
        """Take the progress, and say it if a line is due or all is done."""
        self._now = now
        if self._clock() - self._last >= SILENCE or now.done == now.flights:
            self._tell(now)

    def look(self) -> None:
        """Say a line if no flight has been stored yet, and one is due."""
        if self._now is not None and not self._now.rate:
            waited = self._clock() - self._begun
            if waited > USUAL and self._clock() - self._last >= USUAL:
                self._tell(self._now)

    def _tell(self, now: CampaignProgress) -> None:
        self._last = self._clock()
        self._say(now.sentence() + self.wait(now))

    def wait(self, now: CampaignProgress) -> str:
        """What is waited for, after a semicolon; empty once flights were stored."""
        if now.rate or now.done == now.flights:
            return ""
        waited = self._clock() - self._begun
        if waited <= USUAL:
            return "; new kinds of flight are compiled first, which takes a minute or more"
        from springback.campaign.running import duration_text

        return f"; compiling, and flying the first part, for {duration_text(waited)} so far"

    def looking(self) -> AbstractContextManager[None]:
        """Say lines while no flight is stored."""
        return _looking(self.look)

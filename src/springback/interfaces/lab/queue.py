"""Request queue of the impact lab.

A flight takes milliseconds once its kernels are compiled, and a minute before.  A background thread
therefore compiles one kind of flight after another; until its kind is ready, a request is answered
with `NotReady`.  Flights that are ready run on a few threads (kernels release the interpreter
lock).  Only the newest request of each page counts, and when too many wait, the next is refused.
"""

from __future__ import annotations

import asyncio
import itertools
import json
import os
import threading
import time
import traceback
from collections import OrderedDict
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any, NamedTuple

from springback.interfaces.lab.responses import answer
from springback.interfaces.lab.settings import DEFAULTS, LabSettings

#: Most requests that may wait, and most pages that are remembered (chosen).
MOST_WAITING, MOST_PAGES = 100, 1000


class Kind(NamedTuple):
    """Flights that share compiled kernels."""

    mode: str
    guide: str
    mat: bool
    pilot: str

    @property
    def words(self) -> str:
        """Description on the page."""
        where = "a mat" if self.mat else "a wall"
        if self.mode == "flight":
            return f"flights into {where}, recovery {self.pilot}"
        return f"impacts on {where}, {'on the slider' if self.guide == 'slider' else 'free'}"


def kind_of(settings: LabSettings) -> Kind:
    """Kind of flight of some settings; all recoveries along a quintic are one kind."""
    flies, way = settings.mode == "flight", settings.recovery
    if way in ("pre-impact", "post-impact", "set-point"):
        way = "by a quintic"
    guide = "" if flies else settings.guide
    return Kind(settings.mode, guide, settings.surface == "mat", way if flies else "")


def example_of(settings: LabSettings) -> LabSettings:
    """Settings of the same kind with default numbers, which can always be flown."""
    words = {name: getattr(settings, name) for name in ("mode", "guide", "recovery")}
    surface = "mat" if settings.surface == "mat" else "wall"
    return DEFAULTS.with_checked(**{"robot": "arq", "surface": surface, **words})


def _default_with(**words: str) -> LabSettings:
    return DEFAULTS.with_checked(**words)


#: Kinds compiled from the start, in this order: the collision alone, and the paper's flight.
AT_START = (
    DEFAULTS, _default_with(guide="free"), _default_with(surface="mat"),
    _default_with(surface="mat", guide="free"), _default_with(mode="flight"),
)  # fmt: skip


class NotReady(Exception):  # a state, not an error
    """The kernels of a request are being compiled."""

    def __init__(self, kind: Kind, waited: float) -> None:
        """Kind being compiled, and for how long [s]."""
        super().__init__(kind.words)
        self.kind, self.waited = kind, waited


class Superseded(Exception):
    """A newer request of the same page has arrived."""


class Busy(Exception):
    """Too many requests are waiting."""


class RequestQueue:
    """Queue that compiles kinds of flights and answers requests with JSON."""

    def __init__(
        self,
        give: Callable[[LabSettings], dict[str, Any]] = answer,
        *,
        threads: int | None = None,
        prepared: tuple[LabSettings, ...] = AT_START,
    ) -> None:
        """Create the queue; compilation begins with `start`.

        Args:
            give: Function from settings to their answer.
            threads: Number of flying threads; by default the number of processors, from 2 to 8.
            prepared: One example of each kind to compile from the start.
        """
        self._give = give
        workers = threads or min(max(os.cpu_count() or 1, 2), 8)
        self._pool = ThreadPoolExecutor(workers, thread_name_prefix="lab")
        self._waiting = 0
        self._tickets = itertools.count()
        self._newest: OrderedDict[str, int] = OrderedDict()
        self._todo = OrderedDict((kind_of(one), example_of(one)) for one in prepared)
        self._under_way: Kind | None = None
        self._ready: set[Kind] = set()
        self._since: dict[Kind, float] = {}
        self._change = threading.Condition()

    def start(self) -> None:
        """Start compiling in the background."""
        threading.Thread(target=self._prepare, name="lab-prepares", daemon=True).start()

    def _prepare(self) -> None:
        """Fly one example of each requested kind, indefinitely."""
        while True:
            with self._change:
                while not self._todo:
                    self._change.wait()
                kind, example = self._todo.popitem(last=False)
                self._under_way = kind
                self._since.setdefault(kind, time.monotonic())
            try:
                self._give(example)
            except Exception:  # a request of this kind will raise it again, and report it
                traceback.print_exc()
            with self._change:
                self._under_way = None
                self._ready.add(kind)
                self._change.notify_all()

    def wait(self, settings: LabSettings, patience: float) -> bool:
        """Wait at most ``patience`` [s] for the kind of some settings; True if it is ready."""
        with self._change:
            return self._change.wait_for(lambda: kind_of(settings) in self._ready, patience)

    def _check_ready(self, settings: LabSettings) -> None:
        """Raise `NotReady`, and compile the kind next, if it is not ready."""
        kind = kind_of(settings)
        with self._change:
            if kind in self._ready:
                return
            since = self._since.setdefault(kind, time.monotonic())
            if kind != self._under_way:
                self._todo.setdefault(kind, example_of(settings))
                self._todo.move_to_end(kind, last=False)
            self._change.notify_all()
        raise NotReady(kind, time.monotonic() - since)

    async def ask(self, settings: LabSettings, page: str = "") -> bytes:
        """Answer to some settings, as JSON.

        Args:
            settings: Validated settings.
            page: Identifier of the requesting page; empty if it has none.

        Raises:
            InputError: If they cannot be flown.
            NotReady: While kernels are being compiled.
            Superseded: If a newer request of the same page arrives first.
            Busy: If too many requests are waiting.
        """
        self._check_ready(settings)
        if self._waiting >= MOST_WAITING:
            raise Busy
        ticket = next(self._tickets)
        if page:
            self._newest[page] = ticket
            self._newest.move_to_end(page)
            while len(self._newest) > MOST_PAGES:
                self._newest.popitem(last=False)
        self._waiting += 1
        try:
            loop = asyncio.get_running_loop()
            return await loop.run_in_executor(self._pool, self._turn, settings, page, ticket)
        finally:
            self._waiting -= 1

    def _turn(self, settings: LabSettings, page: str, ticket: int) -> bytes:
        """Answer a request, unless a newer one of its page has arrived."""
        if page and self._newest.get(page, ticket) > ticket:
            raise Superseded
        return json.dumps(self._give(settings), allow_nan=False).encode()

"""The desk of the impact lab: who is served when, so that many can ask at once and nobody stalls.

A flight is a matter of milliseconds once its kernels are compiled, and of a minute before.  So
kinds of flights are prepared aside, one after another, and until then a request is told to wait.
What is ready is flown by a few threads (kernels let others run); of one page only the newest
request counts, and when too many wait, the next is turned away.
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

#: Requests that may wait, and pages that are remembered (chosen: some browsers full).
MOST_WAITING, MOST_PAGES = 100, 1000


class Kind(NamedTuple):
    """Flights that share compiled kernels."""

    mode: str
    guide: str
    mat: bool
    pilot: str

    @property
    def words(self) -> str:
        """What the page calls it."""
        where = "a mat" if self.mat else "a wall"
        if self.mode == "flight":
            return f"flights into {where}, recovery {self.pilot}"
        return f"impacts on {where}, {'on the slider' if self.guide == 'slider' else 'free'}"


def kind_of(settings: LabSettings) -> Kind:
    """The kind of some settings: quintics of all sorts are one, for instance."""
    flies, way = settings.mode == "flight", settings.recovery
    if way in ("pre-impact", "post-impact", "set-point"):
        way = "by a quintic"
    guide = "" if flies else settings.guide
    return Kind(settings.mode, guide, settings.surface == "mat", way if flies else "")


def example_of(settings: LabSettings) -> LabSettings:
    """A flight of the same kind that can be flown, whatever the numbers are."""
    words = {name: getattr(settings, name) for name in ("mode", "guide", "recovery")}
    surface = "mat" if settings.surface == "mat" else "wall"
    return DEFAULTS.with_checked(**{"robot": "arq", "surface": surface, **words})


def _default_with(**words: str) -> LabSettings:
    return DEFAULTS.with_checked(**words)


#: Prepared from the start, in this order: the collision alone, and the paper's flight.
AT_START = (
    DEFAULTS, _default_with(guide="free"), _default_with(surface="mat"),
    _default_with(surface="mat", guide="free"), _default_with(mode="flight"),
)  # fmt: skip


class NotReady(Exception):  # it is a state of affairs, and no error
    """The kernels of a request are being compiled."""

    def __init__(self, kind: Kind, waited: float) -> None:
        """What is compiled, and for how long by now [s]."""
        super().__init__(kind.words)
        self.kind, self.waited = kind, waited


class Superseded(Exception):
    """A newer request of the same page has come."""


class Busy(Exception):
    """Too many requests wait."""


class RequestQueue:
    """Takes requests, prepares kinds, hands out answers as JSON."""

    def __init__(
        self,
        give: Callable[[LabSettings], dict[str, Any]] = answer,
        *,
        threads: int | None = None,
        prepared: tuple[LabSettings, ...] = AT_START,
    ) -> None:
        """Open the desk; preparing begins with `open`.

        Args:
            give: The answer to some settings.
            threads: That fly; by default as many as processors, at least 2 and at most 8.
            prepared: One example of each kind to prepare from the start.
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

    def open(self) -> None:
        """Begin to prepare, aside."""
        threading.Thread(target=self._prepare, name="lab-prepares", daemon=True).start()

    def _prepare(self) -> None:
        """Fly one example of each kind that is asked for, for ever."""
        while True:
            with self._change:
                while not self._todo:
                    self._change.wait()
                kind, example = self._todo.popitem(last=False)
                self._under_way = kind
                self._since.setdefault(kind, time.monotonic())
            try:
                self._give(example)
            except Exception:  # whoever asks for this kind will meet it again, and be told
                traceback.print_exc()
            with self._change:
                self._under_way = None
                self._ready.add(kind)
                self._change.notify_all()

    def wait(self, settings: LabSettings, patience: float) -> bool:
        """Whether the kind of some settings is ready, at the latest after some patience [s]."""
        with self._change:
            return self._change.wait_for(lambda: kind_of(settings) in self._ready, patience)

    def _check_ready(self, settings: LabSettings) -> None:
        """Have a kind prepared next if it is not ready."""
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
        """The answer to some settings, as JSON.

        Args:
            settings: Checked.
            page: Whose newest request this is; empty if nobody's.

        Raises:
            InputError: If they cannot be flown.
            NotReady: While kernels are compiled.
            Superseded: If the same page asks anew before it is this one's turn.
            Busy: If too many wait.
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
        """It is a request's turn."""
        if page and self._newest.get(page, ticket) > ticket:
            raise Superseded
        return json.dumps(self._give(settings), allow_nan=False).encode()

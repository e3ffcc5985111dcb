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

from springback.errors import InputError
from springback.interfaces.lab.obstacles import (
    MOVING,
    WITH_ARTICLE,
    is_on_slider,
    obstacle_of,
)
from springback.interfaces.lab.responses import answer
from springback.interfaces.lab.scenarios import is_piloted, lab_scenario, robots_of
from springback.interfaces.lab.settings import DEFAULTS, LabSettings, is_default
from springback.interfaces.lab.sweeps import Sweep, sweep_answer

#: Most requests that may wait, and most pages that are remembered (chosen).
MOST_WAITING, MOST_PAGES = 100, 1000


Request = LabSettings | Sweep
#: Duration of a compilation as the page states it [s], without a pilot and with one (measured, on
#: two to four processors that have other work too).
ABOUT, ABOUT_PILOTED = 30, 90
#: Surface of a kind that is any built-in shape: all are one structure to the compiler.  So are
#: those that move, but before a ball a pilot hovers.
SHAPE = "shape"
_PLACES = {
    "mat": "a mat", SHAPE: "poles, windows and the like", "moving": "what moves",
    "ball": "a ball", "door": "a door", "robot": "another robot",
}  # fmt: skip
_HOVERING = "a hovering robot by a ball"
_COUNTS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten",
           "eleven", "twelve")  # fmt: skip


class Kind(NamedTuple):
    """Flights that share compiled kernels."""

    mode: str
    guide: str
    surface: str
    pilot: str
    arms: int = 4
    robots: tuple[str, ...] = ()  # of a user's lab, whose robots differ in more than numbers

    @property
    def words(self) -> str:
        """Description of all its flights."""
        return self.words_with(_PLACES.get(self.surface, "a wall"))

    def words_with(self, where: str) -> str:
        """Description with what is hit, such as ``a door``."""
        what = f"impacts on {where}, {'on the slider' if self.guide == 'slider' else 'free'}"
        if self.mode == "flight":
            into = f"hits on {_HOVERING}" if self.surface == "ball" else f"flights into {where}"
            what = f"{into}, recovery {self.pilot}"
        elif self.mode == "file":
            what = f"your scenario{', with its pilot' if self.pilot else ''}"
        if self.robots or self.arms != DEFAULTS.arm_count:
            what += f", {_COUNTS[self.arms] if self.arms < len(_COUNTS) else self.arms} arms"
        return what

    @property
    def about(self) -> int:
        """Duration of its compilation [s], roughly."""
        return ABOUT_PILOTED if self.pilot else ABOUT


def kind_of(request: Request) -> Kind:
    """Kind of flight of a request; all recoveries along a quintic are one kind."""
    settings = _settings_of(request)
    way = settings.recovery
    if way in ("pre-impact", "post-impact", "set-point"):
        way = "by a quintic"
    pilot = way if settings.mode == "flight" else "its own" if is_piloted(settings) else ""
    shape = _shape_of(settings)
    surface = shape or ("mat" if settings.surface == "mat" else "wall")
    guide = ""
    if settings.mode == "impact":
        guide = "slider" if is_on_slider(settings) else "free"
    kind = Kind(settings.mode, guide, surface, pilot, round(settings.arm_count))
    if settings.user is None:
        return kind
    return kind._replace(surface=shape or settings.surface, robots=robots_of(settings))


def _shape_of(settings: LabSettings) -> str:
    """Surface of the kind of flights into other obstacles than the wall; empty for the wall."""
    obstacle = obstacle_of(settings)
    if obstacle == "robot":
        return obstacle
    if obstacle in MOVING:
        return "moving" if settings.mode == "impact" else obstacle
    return "" if obstacle == "wall" else SHAPE


def _words_of(settings: LabSettings, kind: Kind) -> str:
    """Description of a kind with the obstacle that was chosen, where it has several."""
    chosen = obstacle_of(settings)
    return kind.words if chosen == "wall" else kind.words_with(WITH_ARTICLE[chosen])


def _settings_of(request: Request) -> LabSettings:
    return request.settings if isinstance(request, Sweep) else request


def example_of(request: Request) -> LabSettings:
    """Settings of the same kind that can be flown: default numbers, where those can be."""
    settings = _settings_of(request)
    if _is_checked_first(settings):
        return settings
    words = {name: getattr(settings, name) for name in ("mode", "guide", "recovery")}
    surface = "mat" if settings.surface == "mat" else "wall"
    chosen = obstacle_of(settings)
    obstacle = chosen if chosen in ("wall", "robot", *MOVING) else "pole"
    what = {"robot": "arq", "surface": surface, "obstacle": obstacle}
    return DEFAULTS.with_checked(**what, **words)


def _is_checked_first(settings: LabSettings) -> bool:
    """True if default numbers need not be flyable: of a user's scenario, or other arms."""
    return settings.user is not None or not is_default(settings, "arm_count")


def _default_with(**words: str) -> LabSettings:
    return DEFAULTS.with_checked(**words)


#: Kinds compiled from the start, in this order: the collision alone, and the paper's flight.
AT_START = (
    DEFAULTS, _default_with(guide="free"), _default_with(surface="mat"),
    _default_with(surface="mat", guide="free"), _default_with(mode="flight"),
)  # fmt: skip


class NotReady(Exception):  # a state, not an error
    """The kernels of a request are being compiled."""

    def __init__(self, kind: Kind, waited: float, words: str = "") -> None:
        """Kind being compiled, for how long [s], and what was asked for, in words."""
        self.words = words or kind.words
        super().__init__(self.words)
        self.kind, self.waited = kind, waited


class Superseded(Exception):
    """A newer request of the same page has arrived."""


class Busy(Exception):
    """Too many requests are waiting."""


def respond(request: Request) -> dict[str, Any]:
    """Answer to a request."""
    return sweep_answer(request) if isinstance(request, Sweep) else answer(request)


class RequestQueue:
    """Queue that compiles kinds of flights and answers requests with JSON."""

    def __init__(
        self,
        give: Callable[[Any], dict[str, Any]] = respond,
        *,
        threads: int | None = None,
        prepared: tuple[Request, ...] = AT_START,
    ) -> None:
        """Create the queue; compilation begins with `start`.

        Args:
            give: Function from a request to its answer.
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
            except InputError:  # checked before, yet a request of this kind will report it
                pass
            except Exception:  # a request of this kind will raise it again, and report it
                traceback.print_exc()
            with self._change:
                self._under_way = None
                self._ready.add(kind)
                self._change.notify_all()

    def wait(self, settings: Request, patience: float) -> bool:
        """Wait at most ``patience`` [s] for the kind of some settings; True if it is ready."""
        with self._change:
            return self._change.wait_for(lambda: kind_of(settings) in self._ready, patience)

    def _check_ready(self, settings: Request) -> None:
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
        raise NotReady(kind, time.monotonic() - since, _words_of(_settings_of(settings), kind))

    def is_ready(self, request: Request) -> bool:
        """True if the kernels of a request are compiled."""
        with self._change:
            return kind_of(request) in self._ready

    async def ask(self, settings: Request, page: str = "") -> bytes:
        """Answer to some settings, as JSON.

        Args:
            settings: Validated settings, or a sweep of one of them.
            page: Identifier of the requesting page; empty if it has none.

        Raises:
            InputError: If they cannot be flown.
            NotReady: While kernels are being compiled.
            Superseded: If a newer request of the same page arrives first.
            Busy: If too many requests are waiting.
        """
        loop = asyncio.get_running_loop()
        numbers = _settings_of(settings)
        if _is_checked_first(numbers) and not self.is_ready(settings):
            await loop.run_in_executor(self._pool, _check, numbers)
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
            return await loop.run_in_executor(self._pool, self._turn, settings, page, ticket)
        finally:
            self._waiting -= 1

    def _turn(self, settings: Request, page: str, ticket: int) -> bytes:
        """Answer a request, unless a newer one of its page has arrived."""
        if page and self._newest.get(page, ticket) > ticket:
            raise Superseded
        return json.dumps(self._give(settings), allow_nan=False).encode()


def _check(settings: LabSettings) -> None:
    """Refuse what cannot be flown before anything is compiled for it."""
    for robot in robots_of(settings):
        lab_scenario(settings, robot)

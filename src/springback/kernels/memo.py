"""What was made before is not made again: results kept by the identity of what they are made of.

Flights of a campaign share most of their tables.  Whatever follows from some of them alone is made
once, by the same functions that make a single flight ready, each of which is given exactly what it
reads.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from operator import is_
from typing import Any, Protocol, TypeVar

R = TypeVar("R")


#: A place where all results are kept.
FOREVER = "ever"


class Build(Protocol):
    """How a part is made: `uncached`, or a `Memo` that remembers."""

    def __call__(self, function: Callable[..., R], /, *given: Any, place: Hashable = None) -> R:
        """``function(*given)``."""


def uncached(function: Callable[..., R], /, *given: Any, place: Hashable = None) -> R:
    """``function(*given)``, whatever was made before."""
    return function(*given)


class Memo:
    """Remembers the last result of every function, and what it was made of.

    Only one result is kept for each function and place, so memory does not grow with the number of
    flights; those that share parts had better come one after another.  For what comes again later,
    as the tables of a sample do with the next robot, there is the place `FOREVER`.
    """

    __slots__ = ("_ever", "_last")

    def __init__(self) -> None:
        """Remember nothing yet."""
        self._last: dict[Any, tuple[tuple[Any, ...], Any]] = {}
        self._ever: dict[Any, tuple[Any, Any]] = {}

    def forget(self) -> None:
        """Remember nothing any more: what is kept at `FOREVER` grows with the number of flights."""
        self._last.clear()
        self._ever.clear()

    def __call__(self, function: Callable[..., R], /, *given: Any, place: Hashable = None) -> R:
        """``function(*given)``, or what it gave for the very same objects the last time.

        Args:
            function: Gives the same for the same, and changes nothing; always given as many.
            *given: Compared by identity.
            place: Tells apart uses of one function that take turns; `FOREVER` keeps all results.
        """
        if place is FOREVER:
            known = self._ever.get((function, *map(id, given)))
            if known is None:  # what is kept is held, lest its id be used again
                known = given, function(*given)
                self._ever[function, *map(id, given)] = known
            ever: R = known[1]
            return ever
        key = function if place is None else (function, place)
        last = self._last.get(key)
        if last is not None and all(map(is_, last[0], given)):
            kept: R = last[1]
            return kept
        result = function(*given)
        self._last[key] = given, result
        return result

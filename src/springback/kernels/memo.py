"""Memoisation keyed on the identity of the inputs.

Flights of a campaign share most of their tables.  Whatever follows from shared tables alone is
built once, by the same functions that build a single flight, each of which is passed exactly what
it reads.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from operator import is_
from typing import Any, Protocol, TypeVar

R = TypeVar("R")


#: Place at which all results are cached.
FOREVER = "ever"


class Build(Protocol):
    """Interface of `plain_build` and of a `Memo`."""

    def __call__(self, function: Callable[..., R], /, *given: Any, place: Hashable = None) -> R:
        """``function(*given)``."""


def plain_build(function: Callable[..., R], /, *given: Any, place: Hashable = None) -> R:
    """``function(*given)``, computed anew."""
    return function(*given)


class Memo:
    """Cache of the last result of every function, with its inputs.

    Only one result is cached for each function and place, so memory does not grow with the number
    of flights; flights that share parts should follow one another.  Inputs that recur later, such
    as the tables of a sample with the next robot, use the place `FOREVER`.
    """

    __slots__ = ("_ever", "_last")

    def __init__(self) -> None:
        """Start with an empty cache."""
        self._last: dict[Any, tuple[tuple[Any, ...], Any]] = {}
        self._ever: dict[Any, tuple[Any, Any]] = {}

    def forget(self) -> None:
        """Clear the cache: results at `FOREVER` accumulate with the number of flights."""
        self._last.clear()
        self._ever.clear()

    def __call__(self, function: Callable[..., R], /, *given: Any, place: Hashable = None) -> R:
        """``function(*given)``, or its last result for the very same objects.

        Args:
            function: Deterministic and without side effects; always called with as many arguments.
            *given: Compared by identity.
            place: Distinguishes alternating uses of one function; `FOREVER` caches all results.
        """
        if place is FOREVER:
            entry = self._ever.get((function, *map(id, given)))
            if entry is None:  # holding the inputs prevents reuse of their ids
                entry = given, function(*given)
                self._ever[function, *map(id, given)] = entry
            ever: R = entry[1]
            return ever
        key = function if place is None else (function, place)
        last = self._last.get(key)
        if last is not None and all(map(is_, last[0], given)):
            cached: R = last[1]
            return cached
        result = function(*given)
        self._last[key] = given, result
        return result

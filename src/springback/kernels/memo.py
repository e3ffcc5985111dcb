"""Memoisation keyed on the identity of the inputs: within a scenario, nothing is built twice."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol, TypeVar

R = TypeVar("R")


class Build(Protocol):
    """Interface of `plain_build` and of a `Memo`."""

    def __call__(self, function: Callable[..., R], /, *given: Any) -> R:
        """``function(*given)``."""


def plain_build(function: Callable[..., R], /, *given: Any) -> R:
    """``function(*given)``, computed anew."""
    return function(*given)


class Memo:
    """Cache of the results of functions that are deterministic and without side effects."""

    __slots__ = ("_results",)

    def __init__(self) -> None:
        """Start with an empty cache."""
        self._results: dict[Any, tuple[Any, Any]] = {}

    def __call__(self, function: Callable[..., R], /, *given: Any) -> R:
        """``function(*given)``, or its earlier result for the very same objects."""
        key = function, *map(id, given)
        if key not in self._results:  # holding the inputs prevents reuse of their ids
            self._results[key] = given, function(*given)
        result: R = self._results[key][1]
        return result

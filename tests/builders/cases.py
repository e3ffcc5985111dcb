"""Cases of a loop."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence
from typing import TypeVar

T = TypeVar("T")


def nonempty(cases: Iterable[T]) -> list[T]:
    """The cases, of which there must be one: a loop over none asserts nothing."""
    found = list(cases)
    assert found, "no case to test"
    return found


def pairwise_combinations(choices: Sequence[Iterable[str]]) -> list[tuple[str, ...]]:
    """Combinations in which every two values of two settings meet, chosen greedily."""
    everything = list(itertools.product(*map(tuple, choices)))
    missing = {pair for one in everything for pair in _pairs(one)}
    found = []
    while missing:
        best = max(everything, key=lambda one: len(_pairs(one) & missing))
        missing -= _pairs(best)
        found.append(best)
    return found


def _pairs(one: tuple[str, ...]) -> set[tuple[tuple[int, str], tuple[int, str]]]:
    """Every two values of a combination, each with the number of its setting."""
    return set(itertools.combinations(enumerate(one), 2))

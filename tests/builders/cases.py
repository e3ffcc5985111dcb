"""Cases of a loop."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TypeVar

T = TypeVar("T")


def nonempty(cases: Iterable[T]) -> list[T]:
    """The cases, of which there must be one: a loop over none asserts nothing."""
    found = list(cases)
    assert found, "no case to test"
    return found

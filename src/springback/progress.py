"""Progress of long tasks: functions called with the fraction done, from 0 to 1."""

from __future__ import annotations

from collections.abc import Callable

Progress = Callable[[float], None]


def silent(share: float) -> None:
    """Ignore progress."""


def stage(progress: Progress, begin: float, size: float) -> Progress:
    """Progress function of a part of a task.

    Args:
        progress: Progress function of the whole.
        begin: Fraction of the whole at which the part begins.
        size: Fraction of the whole that it is.
    """
    return lambda share: progress(begin + size * share)

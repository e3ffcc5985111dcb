"""Memory of devices: none, or a delay line of their last samples."""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.kernels.angles import floor
from springback.kernels.compiler import kernel
from springback.kernels.trees import select

#: Longest delay of a sample, in sampling periods.
MOST_PERIODS = 4


class Nothing(NamedTuple):
    """Memory of a device that needs none."""

    unused: float


class Line(NamedTuple):
    """Delay line: the last five samples of a device, trees of one shape, newest first."""

    newest: Any
    second: Any
    third: Any
    fourth: Any
    fifth: Any


def constant_line(sample: Any) -> Line:
    """A line in which all samples are equal."""
    return Line(sample, sample, sample, sample, sample)


@kernel
def push(line: Line, sample: Any) -> Line:
    """The line with a new sample in front; the oldest is dropped."""
    return Line(sample, line.newest, line.second, line.third, line.fourth)


@kernel
def arrival(line: Line, delay: float, every: float) -> Any:
    """Sample taken a delay ago, at a tick at which one arrives.

    Args:
        line: Samples, the one of this tick included.
        delay: Whole ticks, at most four sampling periods.
        every: Sampling period, whole ticks.
    """
    back = floor(delay / every + 0.5 / every)
    late = select(back < 3.5, line.fourth, line.fifth)
    middle = select(back < 2.5, line.third, late)
    return select(back < 0.5, line.newest, select(back < 1.5, line.second, middle))

"""When values that change at known rates come through zero.

Times are compared as fractions, so that only the soonest is divided out.
"""

from __future__ import annotations

from typing import NamedTuple

from springback.contact.cage import LANDED
from springback.kernels.compiler import kernel
from springback.kernels.trees import fold

#: Time to the next crossing when none is ahead [s].
NO_CROSSING = 1e9


class Crossing(NamedTuple):
    """A value on its way to zero, there after distance / speed."""

    distance: float  # from zero, in the value's own unit
    speed: float  # towards zero, positive


@kernel
def crossing(value: float, rate: float) -> Crossing:
    """The crossing of a value that changes at a rate; none where it recedes, or is there."""
    distance = abs(value)
    ahead = (value * rate < 0.0) & (distance > LANDED)
    return Crossing(distance if ahead else NO_CROSSING, abs(rate) if ahead else 1.0)


@kernel
def sooner(a: Crossing, b: Crossing) -> Crossing:
    """The sooner of two crossings."""
    first = a.distance * b.speed < b.distance * a.speed
    return Crossing(a.distance if first else b.distance, a.speed if first else b.speed)


@kernel
def soonest(crossings: tuple[Crossing, ...]) -> Crossing:
    """The soonest of several crossings."""
    return fold(sooner, Crossing(NO_CROSSING, 1.0), crossings, ())


@kernel
def time_to(c: Crossing) -> float:
    """Time until a crossing [s]; `NO_CROSSING` for none."""
    return c.distance / c.speed

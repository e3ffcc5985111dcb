"""Time to the next zero crossing of values that change at known rates.

Times are compared as fractions, so that only the earliest needs a division.
"""

from __future__ import annotations

from typing import NamedTuple

from springback.contact.cage import LANDED
from springback.kernels.compiler import kernel
from springback.kernels.trees import fold

#: Time to the next crossing if there is none [s].
NO_CROSSING = 1e9


class Crossing(NamedTuple):
    """A value that approaches zero, and reaches it after distance / speed."""

    distance: float  # from zero, in the value's own unit
    speed: float  # towards zero, positive


@kernel
def crossing(value: float, rate: float) -> Crossing:
    """Crossing of a value that changes at a rate; none if it recedes or is at zero."""
    distance = abs(value)
    ahead = (value * rate < 0.0) & (distance > LANDED)
    return Crossing(distance if ahead else NO_CROSSING, abs(rate) if ahead else 1.0)


@kernel
def sooner(a: Crossing, b: Crossing) -> Crossing:
    """The earlier of two crossings."""
    first = a.distance * b.speed < b.distance * a.speed
    return Crossing(a.distance if first else b.distance, a.speed if first else b.speed)


@kernel
def soonest(crossings: tuple[Crossing, ...]) -> Crossing:
    """The earliest of several crossings."""
    return fold(sooner, Crossing(NO_CROSSING, 1.0), crossings, ())


@kernel
def time_to(c: Crossing) -> float:
    """Time until a crossing [s]; `NO_CROSSING` if there is none."""
    return c.distance / c.speed

"""End stops of the arms."""

from __future__ import annotations

from typing import NamedTuple

from springback.contact.cage import LANDED
from springback.dynamics.crossing import Crossing, crossing
from springback.kernels.compiler import kernel
from springback.kernels.vectors import positive_part
from springback.vehicle.state import Arm

#: Steps look so far ahead: contacts stiffen, and stops are met, within one [s].
AHEAD = 1e-4
#: A stop that will be pressed in by less than this does not matter to the step [m].
GRAZED = 1e-7


class Stop(NamedTuple):
    """Force of an end stop along the arm, its heat, and how it resists."""

    force: float  # positive lengthens the arm [N]
    loss: float  # [W]
    stiffness: float  # [N/m]
    damper: float  # [N s/m]


@kernel
def end_stop(arm: Arm, length: float, rate: float) -> Stop:
    """Push of the end stops, k δ (1 + d δ̇), never adhesive, and its heat.

    One acts on an arm that has bottomed out, the other on one past its free length.
    """
    low, high = positive_part(arm.shortest - length), positive_part(length - arm.length)
    pressing = -rate if low > 0.0 else rate
    elastic = arm.stop_stiffness * (low + high)
    force = positive_part(elastic * (1.0 + arm.stop_dissipation * pressing))
    # A step that lands on a stop ends a hair before it: the next one is taken on it.
    ahead = AHEAD * rate
    soon = (length - arm.length + ahead > GRAZED) | (arm.shortest - length - ahead > GRAZED)
    stiffness = arm.stop_stiffness if (elastic > 0.0) | soon else 0.0
    damper = arm.stop_dissipation * elastic
    return Stop(force if low > 0.0 else -force, (force - elastic) * pressing, stiffness, damper)


@kernel
def next_stop(arm: Arm, length: float, rate: float) -> Crossing:
    """The arm's coming to the next of its two stops, or off it."""
    low, high = length - arm.shortest, length - arm.length
    growing = low if low < -LANDED else high
    shrinking = high if high > LANDED else low
    return crossing(growing if rate > 0.0 else shrinking, rate)

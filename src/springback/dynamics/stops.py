"""End stops of the arms."""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.cage import LANDED
from springback.dynamics.crossing import NO_CROSSING, Crossing, crossing
from springback.kernels.compiler import kernel
from springback.kernels.vectors import larger, positive_part, smaller
from springback.vehicle.state import upper_stop

#: Steps look ahead by this time, in which contacts stiffen and stops are reached [s].
AHEAD = 1e-4
#: A stop that will be compressed by less than this is irrelevant to the step [m].
GRAZED = 1e-7
#: Share of the way to a stop, or from it, after which it is predicted once more.
APPROACH = 0.98
#: Stops count that many times as stiff for the step: unlike a contact, one has its full stiffness
#: from the first moment (chosen: the ledgers of arms at their stops then close to 2e-6).
SUDDEN = 2.0


class Stop(NamedTuple):
    """Force of an end stop along the arm, its heat, stiffness and damping."""

    force: float  # positive lengthens the arm [N]
    loss: float  # [W]
    stiffness: float  # `SUDDEN` times −∂force/∂length, for the step [N/m]
    damper: float  # the largest −∂force/∂rate within `AHEAD` [N s/m]


@kernel
def end_stop(arm: Any, length: float, rate: float) -> Stop:
    """Force of the end stops, k δ (1 + d δ̇), never adhesive, and its heat.

    One acts on an arm that has bottomed out, the other beyond its free length, or the other end of
    the travel of a joint.
    """
    longest = upper_stop(arm)
    within = larger(arm.shortest, smaller(length, longest))
    shift = within - length  # positive beyond the lower stop, negative beyond the upper one
    pressing = -rate if shift > 0.0 else rate
    elastic = arm.stop_stiffness * shift
    force = elastic * positive_part(1.0 + arm.stop_dissipation * pressing)
    # A step that ends at a stop ends slightly before it: the next one acts on it.
    ahead = AHEAD * rate
    soon = (length - longest + ahead > GRAZED) | (arm.shortest - length - ahead > GRAZED)
    closing = abs(rate) if shift == 0.0 else positive_part(pressing)
    steepest = SUDDEN * arm.stop_stiffness * (1.0 + arm.stop_dissipation * closing)
    stiffness = steepest if (shift != 0.0) | soon else 0.0
    deepest = abs(shift) + abs(ahead) if stiffness > 0.0 else 0.0
    damper = arm.stop_dissipation * arm.stop_stiffness * deepest
    return Stop(force, (elastic - force) * rate, stiffness, damper)


@kernel
def next_stop(arm: Any, length: float, rate: float) -> Crossing:
    """Crossing at which the arm reaches the next of its two stops, or leaves it."""
    low, high = length - arm.shortest, length - upper_stop(arm)
    growing = low if low < -LANDED else high
    shrinking = high if high > LANDED else low
    found = crossing(growing if rate > 0.0 else shrinking, rate)
    # Most of the way first: a stop that a step overshoots acts in its last stage, far stiffer
    # than what brought the arm there.
    far = (found.distance > 2.0 * GRAZED) & (found.distance < NO_CROSSING)
    return Crossing(APPROACH * found.distance if far else found.distance, found.speed)

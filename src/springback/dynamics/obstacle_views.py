"""What a moving obstacle shows of itself, for the choice of steps and the first impact."""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.moving.bodies import BodyPose
from springback.dynamics.crossing import NO_CROSSING, Crossing
from springback.dynamics.touches import PartPush, Pushes
from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import fold, replace, select, tree_map
from springback.kernels.vectors import Mat3, Vec

#: A moving obstacle that touches what is at rest rests itself below this speed [m/s] (chosen: its
#: energy is then a ten-thousandth of that of the throws it takes part in).
AT_REST = 0.01
_NONE = Vec(0.0, 0.0, 0.0)


class BodyView(NamedTuple):
    """Observable quantities of one moving obstacle, for the choice of steps."""

    gap: float  # to what is at rest in the world, if it can touch that [m]
    crossing: Crossing  # of that gap: the next zero
    engaged: float  # flags of its contacts with the world, as bits
    fastest: float  # upper bound on the speed of a point of it [m/s]
    contact_rate: float  # upper bound on the rate of its contacts [1/s]
    friction_rate: float  # likewise of friction [1/s]
    slip_rate: float  # rate of change of its slips, over their regularised speed [1/s]
    struck: float  # 1 while the vehicle touches it
    pose: BodyPose
    push: PartPush  # of the vehicle on it


#: View of a moving obstacle that touches nothing.
NO_VIEW = BodyView(
    1e9, Crossing(NO_CROSSING, 1.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    BodyPose(_NONE, Mat3(_NONE, _NONE, _NONE), _NONE, _NONE),
    PartPush(_NONE, _NONE, 0.0, 0.0, _NONE, _NONE, 0.0),
)  # fmt: skip


@kernel
def _touched_by(body: BodyView, touches: float) -> BodyView:
    return replace(body, struck=touches)


@generic
def touched_obstacles(pushed: Any, bodies: tuple[BodyView, ...]) -> tuple[BodyView, ...]:
    """Moving obstacles, of which parts of another vehicle tell themselves whether they touch."""
    return bodies


@touched_obstacles.register(Pushes)
@kernel
def _by_the_other(pushed: Pushes, bodies: tuple[BodyView, ...]) -> tuple[BodyView, ...]:
    return tree_map(_touched_by, (bodies, pushed.strikers), ())


class StepRates(NamedTuple):
    """Upper bounds on rates that limit a step [1/s], as in `springback.dynamics.motion.View`."""

    friction: float
    contact: float
    slip: float


@kernel
def with_body_rates(so_far: StepRates, body: BodyView) -> StepRates:
    """Bounds for a vehicle and one more moving obstacle: each at most the sum of both."""
    return StepRates(
        so_far.friction + body.friction_rate,
        so_far.contact + body.contact_rate,
        so_far.slip + body.slip_rate,
    )


@kernel
def nearer(gap: float, body: BodyView) -> float:
    """A gap, or that of a moving obstacle to the world, if it is open and smaller [m]."""
    return body.gap if (body.gap > 0.0) & (body.gap < gap) else gap


@kernel
def faster(speed: float, body: BodyView) -> float:
    """Upper bound on the speed at which a part and a moving obstacle approach [m/s]."""
    return speed + body.fastest


@kernel
def rebounding(so_far: float, body: BodyView) -> float:
    """1 if a moving obstacle hits, or scrapes along, what is at rest, or one before did."""
    hits = (body.engaged > 0.0) & (body.fastest > AT_REST)
    return 1.0 if hits else so_far


@kernel
def first_hit(before: float, body: BodyView, first: bool) -> float:
    """Flag of a moving obstacle, 1 if the first touch of the flight is with it."""
    return select(first, body.struck, before)


@kernel
def _along(struck: float, body: BodyView, inward: Vec) -> float:
    return struck * (body.pose.velocity @ inward)


@kernel
def _more(so_far: float, one: float) -> float:
    return so_far + one


@kernel
def speed_beside(
    speed: float, struck: tuple[float, ...], bodies: tuple[BodyView, ...], inward: Vec
) -> float:
    """Speed relative to the centres of the obstacles that are struck, along a direction [m/s].

    Args:
        speed: In the world [m/s].
        struck: 1 for the obstacle that counts, 0 for others.
        bodies: All moving obstacles.
        inward: Unit vector, world.
    """
    of_all = fold(_more, 0.0, tree_map(_along, (struck, bodies), (inward,)), ())
    count = fold(_more, 0.0, struck, ())
    return speed - of_all / (count if count > 0.0 else 1.0)

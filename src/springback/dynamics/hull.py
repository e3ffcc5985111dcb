"""The main body's hull in the equations of motion: contact, and what it asks of steps."""

from __future__ import annotations

from typing import NamedTuple

from springback.contact.cage import CageContact
from springback.contact.friction_rate import InverseInertia
from springback.contact.hull import hull_contact
from springback.contact.obstacles import Obstacle
from springback.dynamics.crossing import Crossing, soonest
from springback.dynamics.touches import (
    Contact,
    Rub,
    contact_of,
    crossing_of,
    rub_of,
    slip_rate,
    strikes,
    touched_normal,
    touching,
)
from springback.kernels.compiler import kernel
from springback.kernels.trees import field_of, maximum, minimum, tree_map, tree_sum
from springback.kernels.vectors import Mat3, Vec, positive_part
from springback.vehicle.state import Sphere


class HullView(NamedTuple):
    """What the hull feels, as seen from outside; as `springback.dynamics.motion.ArmView`."""

    gap: float  # to the nearest obstacle [m]
    depth: float  # deepest penetration [m]
    normal: float  # f_n [N]
    friction: Vec  # f_f, world [N]
    crossing: Crossing  # the next of a gap through zero
    engaged: tuple[float, ...]  # 1 while the hull touches, obstacle by obstacle
    impulsive: float  # 1 where it closes in on a surface of the impulse law


class HullState(NamedTuple):
    """Everything about the hull at one instant."""

    contact: Contact
    seen: HullView
    touched: Vec  # normal into what it touches, body; zero where it touches nothing
    damper: float  # that its friction amounts to [N s/m]
    farthest: float  # its point of contact is no farther from the main body [m²]
    rubs: tuple[Rub, ...]  # obstacle by obstacle


@kernel
def hull_state(
    hull: Sphere,
    engaged: tuple[float, ...],
    obstacles: tuple[Obstacle, ...],
    r: Mat3,
    velocity: Vec,
    omega: Vec,
    ahead: float,
) -> HullState:
    """The hull at one instant.

    Args:
        hull: Of the main body.
        engaged: 0 for every obstacle that it was apart from when the step began.
        obstacles: As they are seen from the main body.
        r: Body axes to world axes.
        velocity: Rᵀ v, of the main body, body axes [m/s].
        omega: ω [rad/s].
        ahead: How contacts resist is for depths up to so much farther [m].
    """
    vertical = Vec(r.z.x, r.z.y, r.z.z)
    met = tree_map(hull_contact, (obstacles, engaged), (hull, velocity, omega, vertical, ahead))
    touch, gap = tree_sum(field_of(met, "touch")), minimum(field_of(met, "gap"))
    engaged_now = tree_map(touching, (met,), ())
    view = HullView(
        gap=gap,
        depth=positive_part(-gap),
        normal=touch.normal,
        friction=r @ touch.friction,
        crossing=soonest(tree_map(crossing_of, (met,), ())),
        engaged=engaged_now,
        impulsive=maximum(tree_map(strikes, (met,), ())),
    )
    farthest = maximum(tree_map(_square_distance, (met,), ()))
    rubs = tree_map(rub_of, (met,), ())
    touched = touched_normal(met, gap, engaged_now)
    return HullState(contact_of(touch), view, touched, touch.grip.damper, farthest, rubs)


@kernel
def _square_distance(met: CageContact) -> float:
    return met.rubbing_at @ met.rubbing_at


@kernel
def hastened(rate: float, hull: HullState, mass: float, inverse: InverseInertia) -> float:
    """How fast friction brings parts to rest, at most, with the hull's beside the cages' [1/s].

    The largest eigenvalue of a sum is at most the sum of theirs, and the hull's is at most
    g (1/m + p²/J) for the least mass and the least moment of inertia.

    Args:
        rate: Without the hull [1/s].
        hull: At this instant.
        mass: That does not slide on arms [kg].
        inverse: Of the inertia about the main body.
    """
    return rate + hull.damper * (1.0 / mass + hull.farthest * inverse.largest)


@kernel
def hull_slip_rate(
    hull: HullState, obstacles: tuple[Obstacle, ...], linear: Vec, angular: Vec, vertical: Vec
) -> float:
    """Square of how fast the slip of the hull changes, at most [1/s²].

    Args:
        hull: At this instant.
        obstacles: As they are seen from the main body.
        linear: Acceleration of the main body, body axes [m/s²].
        angular: Angular acceleration, body axes [rad/s²].
        vertical: Rᵀ e_Z.
    """
    return maximum(tree_map(slip_rate, (obstacles, hull.rubs), (linear, angular, vertical)))

"""The main body's hull in the equations of motion: contact, and its limits on steps."""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.cage import BodyMotion, moving_bodies
from springback.contact.hull_contact import hull_faces, hull_pose
from springback.contact.laws.memory import PartBristles, bristles_of, pressed_of
from springback.contact.laws.step_bounds import InverseInertia
from springback.contact.loads import CageContact, contacts_with
from springback.dynamics.crossing import Crossing, soonest
from springback.dynamics.limbs.shell import (
    ShellState,
    as_shell,
    friction_rate_with_shell,
    hull_motion,
    shells_of,
    spin_of,
    with_shell,
)
from springback.dynamics.touches import (
    BodyAcceleration,
    Contact,
    PartPush,
    PartTouch,
    Slip,
    TurningPoint,
    contact_of,
    crossing_of,
    or_turn,
    slip_of,
    slip_rate,
    strikes,
    touch_of,
    turning_points_of,
    with_push,
)
from springback.kernels.compiler import kernel
from springback.kernels.trees import field_of, fold, maximum, one_tuple, replace, tree_map, tree_sum
from springback.kernels.vectors import Vec, positive_part
from springback.vehicle.state import PartMemory, PressedPoints


class HullView(NamedTuple):
    """Observable quantities of the hull; as `springback.dynamics.motion.ArmView` for an arm."""

    gap: float  # to the nearest obstacle [m]
    depth: float  # deepest penetration [m]
    normal: float  # f_n [N]
    friction: Vec  # f_f, world [N]
    crossing: Crossing  # of a gap: the next zero
    engaged: tuple[float, ...]  # 1 while the hull touches, for each face
    impulsive: float  # 1 where it closes in on a surface of the impulse law
    pressed: tuple[PressedPoints, ...]  # what its contacts remember, if a surface does


class HullState(NamedTuple):
    """All quantities of the hull at one instant."""

    contact: Contact
    seen: HullView
    touched: PartTouch
    damper: float  # friction as a damper [N s/m]
    farthest: float  # bound on the squared distance of its contact points from the main body [m²]
    slips: tuple[Slip, ...]  # one for each face
    bristles: tuple[PartBristles, ...]  # if a surface has any
    turns: tuple[TurningPoint, ...]  # one for each face, if a surface remembers the deepest depth
    shell: tuple[ShellState, ...]  # if it turns by itself
    spin: tuple[Vec, ...]  # Ω̇ of that, world axes [rad/s²]


@kernel
def hull_state(
    hull: Any,
    engaged: tuple[float, ...],
    push: tuple[PartPush, ...],
    memory: PartMemory,
    obstacles: Any,
    body: BodyMotion,
) -> HullState:
    """Contact, view and step limits of the hull at one instant.

    Args:
        hull: Hull of the main body, a `Sphere`, a `CompoundHull` or a `Shell`.
        engaged: For each face, 0 if it was not touched when the step began.
        push: Of another vehicle, if there is one.
        memory: Of its contacts.
        obstacles: In the body frame.
        body: Motion of the main body.
    """
    there = hull_motion(hull, memory, body)
    faces = hull_faces(hull, obstacles, maximum(engaged))
    pose = hull_pose(hull, there.velocity)
    met = contacts_with(obstacles, faces, engaged, memory, pose, there)
    load, touches = tree_sum(field_of(met, "touch")), touch_of(met, push, body.r)
    touch = fold(with_push, load, push, (Vec(0.0, 0.0, 0.0), body.r))
    view = HullView(
        gap=touches.gap,
        depth=positive_part(-touches.gap),
        normal=touch.normal,
        friction=body.r @ touch.friction,
        crossing=soonest(tree_map(crossing_of, (met,), ())),
        engaged=touches.engaged,
        impulsive=maximum(tree_map(strikes, (met,), ())),
        pressed=pressed_of(memory, met),
    )
    farthest = maximum(tree_map(_square_distance, (met,), ()))
    slips = tree_map(slip_of, (met,), ())
    contact = contact_of(touch, moving_bodies(obstacles), met)
    held = bristles_of(memory, met, body.r)
    turns = one_tuple(tree_map(turning_points_of, (met,), ()))
    shell = shells_of(hull, memory, contact, body)
    return HullState(
        fold(with_shell, contact, shell, ()), view, touches, touch.grip.alone, farthest,
        slips, held, turns, shell, tree_map(spin_of, (shell,), ()),
    )  # fmt: skip


@kernel
def view_with_turns(hull: HullState, body: BodyAcceleration) -> HullView:
    """View of the hull, with the next turn of its contacts."""
    moves = fold(as_shell, body, hull.shell, ())
    return replace(hull.seen, crossing=fold(or_turn, hull.seen.crossing, hull.turns, (moves,)))


@kernel
def _square_distance(met: CageContact) -> float:
    return met.rubbing_at @ met.rubbing_at


@kernel
def friction_rate_with_hull(
    rate: float, hull: HullState, mass: float, inverse: InverseInertia
) -> float:
    """Upper bound on the rate at which friction stops a part, hull and cages together [1/s].

    The largest eigenvalue of a sum is at most the sum of the largest eigenvalues, and that of the
    hull is at most g (1/m + p²/J) for the smallest mass and the smallest moment of inertia.

    Args:
        rate: Bound without the hull [1/s].
        hull: State of the hull.
        mass: Mass that does not slide on arms [kg].
        inverse: Reciprocals of the inertia about the main body.
    """
    alone = rate + hull.damper * (1.0 / mass + hull.farthest * inverse.largest)
    return fold(friction_rate_with_shell, alone, hull.shell, (hull.damper, inverse))


@kernel
def hull_slip_rate(hull: HullState, body: BodyAcceleration) -> float:
    """Square of an upper bound on the rate of change of the hull's slip [1/s²].

    Args:
        hull: State of the hull.
        body: Acceleration of the main body.
    """
    return maximum(tree_map(slip_rate, (hull.slips,), (fold(as_shell, body, hull.shell, ()),)))

"""Contacts that jump from one place of a part to another, and what they remember.

Where a rod lies across an edge, the deeper of its ends is part of the contact between them, and the
other end is a contact by itself.  When the other becomes the deeper one they change places: nothing
touches anew, and the contact goes on with the depth that it had.  A memory by place
(`springback.contact.laws.hysteresis`) would take it for a new one, with all its energy.

So contacts of two steps are the same if each is the nearest of the other.  One that is left takes
over the memory of one that is gone, the nearest; if it can have come so deep in a step, only of one
that was no deeper.
"""

from __future__ import annotations

from typing import NamedTuple

from springback.contact.cage import BodyMotion, ContactFace, FaceMotion
from springback.contact.laws.hysteresis import is_same_contact
from springback.kernels.compiler import called_kernel, kernel
from springback.kernels.trees import field_of, fold, maximum, replace, tree_map
from springback.kernels.vectors import Vec, norm, smaller
from springback.vehicle.state import ArmPose, PressedPoint, PressedPoints

#: A contact has jumped if it is deeper than this multiple of the way that contacts look ahead, and
#: than an obstacle moves in this time [s] (both chosen: twice a step of a contact).
JUMP, LONGEST = 2.0, 2e-4
#: Farther than any place of a part is from another, squared [m²], and deeper than any contact [m].
ANYWHERE, ANY_DEPTH = 1e18, 1e9


class _Now(NamedTuple):
    """A contact of the present; vectors in body axes."""

    place: Vec  # where it presses, from the main body [m]
    inward: Vec  # unit normal into the obstacle
    square: float  # of its distance from the nearest of the last step [m²]
    most: float  # of one that it can have been in the last step; 0: it is known [m]


class _Before(NamedTuple):
    """A contact of the last step."""

    point: PressedPoint
    square: float  # of its distance from the nearest of the present [m²]


@kernel
def _moves(so_far: float, motion: FaceMotion, place: Vec) -> float:
    return so_far + norm(motion.velocity + (motion.spin ^ place))


@kernel
def _between(before: PressedPoint, place: Vec, inward: Vec) -> float:
    """Square of the distance of two contacts that may be the same, else `ANYWHERE`."""
    away = before.place - place
    return away @ away if is_same_contact(before, place, inward) else ANYWHERE


@kernel
def _or_nearest(so_far: float, before: PressedPoint, place: Vec, inward: Vec) -> float:
    return smaller(so_far, _between(before, place, inward))


@kernel
def _present(face: ContactFace, points: PressedPoints, arm: ArmPose, body: BodyMotion) -> _Now:
    place, inward = arm.lever + face.nearest.at.normal_lever, face.nearest.inward
    square = fold(_or_nearest, ANYWHERE, points.points, (place, inward))
    depth = -face.nearest.gap
    far = JUMP * body.ahead + LONGEST * fold(_moves, 0.0, face.moving, (place,))
    return _Now(
        place, inward, square if depth > 0.0 else ANYWHERE, ANY_DEPTH if depth > far else depth
    )


@kernel
def _or_nearest_now(so_far: float, now: _Now, before: PressedPoint) -> float:
    square = _between(before, now.place, now.inward)
    return smaller(so_far, square) if now.square < ANYWHERE else so_far


@kernel
def _last(point: PressedPoint, present: tuple[_Now, ...]) -> _Before:
    return _Before(point, fold(_or_nearest_now, ANYWHERE, present, (point,)))


@kernel
def _goes_on(now: _Now, before: _Before) -> bool:
    """True for two contacts, each the nearest of the other."""
    square = _between(before.point, now.place, now.inward)
    return (square < ANYWHERE) & (square == now.square) & (square == before.square)


@kernel
def _or_known(so_far: float, before: _Before, now: _Now) -> float:
    return 1.0 if _goes_on(now, before) else so_far


@kernel
def _or_new(now: _Now, last: tuple[_Before, ...]) -> _Now:
    return replace(now, most=now.most * (1.0 - fold(_or_known, 0.0, last, (now,))))


@kernel
def _or_goes_on(so_far: float, now: _Now, before: _Before) -> float:
    return 1.0 if _goes_on(now, before) else so_far


class _Moved(NamedTuple):
    """A contact of the last step where it is now."""

    point: PressedPoint
    square: float  # of the way [m²]


@kernel
def _or_nearer(best: _Moved, now: _Now, before: PressedPoint) -> _Moved:
    away = now.place - before.place
    square = away @ away
    fits = (now.most >= before.depth) & (square < best.square)
    return _Moved(replace(before, place=now.place, inward=now.inward), square) if fits else best


@kernel
def _followed(before: _Before, present: tuple[_Now, ...]) -> PressedPoint:
    point = before.point
    gone = fold(_or_goes_on, 0.0, present, (before,)) == 0.0
    if gone & (point.depth > 0.0):
        return fold(_or_nearer, _Moved(point, ANYWHERE), present, (point,)).point
    return point


@called_kernel
def with_jumps(
    pressed: PressedPoints, faces: tuple[ContactFace, ...], arm: ArmPose, body: BodyMotion
) -> PressedPoints:
    """What a part remembers of the last step, where its contacts are now.

    Args:
        pressed: Of the part.
        faces: That it meets.
        arm: Pose of the part.
        body: Motion of the main body.
    """
    present = tree_map(_present, (faces,), (pressed, arm, body))
    last = tree_map(_last, (pressed.points,), (present,))
    present = tree_map(_or_new, (present,), (last,))
    points = pressed.points
    if maximum(field_of(present, "most")) > 0.0:
        points = tree_map(_followed, (last,), (present,))
    return PressedPoints(pressed.crushed, points)

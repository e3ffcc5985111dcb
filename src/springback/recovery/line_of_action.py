"""From a contact force to the normal of the face: by its line of action, without friction.

Friction deflects a contact force from the normal of the face, by up to atan μ, and the force alone
does not reveal by how much.  But force and moment together give the line on which the force acts,
and an arm's cage is a circle: a face touches it at one point only, where it is the tangent.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from springback.kernels.compiler import kernel
from springback.kernels.trees import maximum, minimum, select, tree_map, tree_sum
from springback.kernels.vectors import Mat3, Vec
from springback.recovery.wrench import RecentImpulse
from springback.vehicle.state import Airframe, end_place

#: Squared length below which a vector has no direction (chosen: far below any measurement).
NO_DIRECTION = 1e-12
#: Least cosine of the angle between an arm that is hit and the force (chosen).
IN_FRONT = 0.2
#: Sine that stands for an arm that is not in front; no line passes a circle with it.
MISSED = 1e3


class Pass(NamedTuple):
    """Pass of the line of action by the cages."""

    sines: tuple[float, ...]  # of the angle from normal to force if each arm alone was hit
    sine: float  # of the arm that is hit most squarely
    one: tuple[float, ...]  # 1 for that arm
    two: tuple[float, ...]  # 1 for the foremost arms on the left and on the right of the line
    span: Vec  # from the right arm's cage to the left arm's, body axes [m]


@kernel
def direction_of(a: Vec, level: float) -> Vec:
    """Unit vector along a vector, or along its horizontal part if ``level`` is 1; else zero."""
    kept = Vec(a.x, a.y, a.z * (1.0 - level))
    square = kept @ kept
    there = square > NO_DIRECTION
    return kept * select(there, 1.0 / math.sqrt(select(there, square, 1.0)), 0.0)


@kernel
def lever_of(recent: RecentImpulse) -> float:
    """Signed distance of the line of action from the main body, in the plane of the cages [m].

    It is (r × f)_z for a force f of one newton from robot to obstacle.  Both impulses decay at the
    same rate, so that their ratio is that of force and moment.
    """
    p = recent.carried
    square = p.x * p.x + p.y * p.y
    there = square > NO_DIRECTION
    return -recent.turning.z * select(there, 1.0 / math.sqrt(select(there, square, 1.0)), 0.0)


@kernel
def _sine(arm: Any, length: float, ahead: Vec, lever: float) -> float:
    """Sine of the angle φ from a cage's normal n to f: (l e × f)_z + r_0 sin φ = lever."""
    e, away = end_place(arm, length)
    across = e.x * ahead.y - e.y * ahead.x
    sine: float = (lever - away * across) / arm.cage_radius
    return select(e @ ahead > IN_FRONT, sine, MISSED)


@kernel
def _size(x: float) -> float:
    return abs(x)


@kernel
def _least_of(size: float, smallest: float) -> float:
    return select(size <= smallest, 1.0, 0.0)


@kernel
def _product(x: float, chosen: float) -> float:
    return x * chosen


@kernel
def _reach(arm: Any, length: float, ahead: Vec, side: float) -> float:
    """Reach of a cage on one side of the force along it [m]; 0 on the other side."""
    e, away = end_place(arm, length)
    turned = (ahead.x * e.y - ahead.y * e.x) * side
    reach = away * (e @ ahead)
    return select((turned >= 0.0) & (reach > 0.0), reach, 0.0)


@kernel
def _foremost(reach: float, most: float) -> float:
    return select((reach > 0.0) & (reach >= most), 1.0, 0.0)


@kernel
def _tip(arm: Any, length: float, chosen: float) -> Vec:
    at = end_place(arm, length)
    return at.direction * (at.distance * chosen)


@kernel
def _either(a: float, b: float) -> float:
    return select(a + b > 0.5, 1.0, 0.0)


@kernel
def pass_of(airframe: Airframe, lengths: tuple[float, ...], ahead: Vec, lever: float) -> Pass:
    """Pass of a line of action by the cages.

    Args:
        airframe: In the pilot's model.
        lengths: Of the arms [m].
        ahead: Direction of the force from robot to obstacle in the plane of the cages, body axes.
        lever: Signed distance of that line from the main body [m], see `lever_of`.
    """
    arms = airframe.arms
    sines = tree_map(_sine, (arms, lengths), (ahead, lever))
    sizes = tree_map(_size, (sines,), ())
    one = tree_map(_least_of, (sizes,), (minimum(sizes),))
    sine = tree_sum(tree_map(_product, (sines, one), ())) / tree_sum(one)
    left = tree_map(_reach, (arms, lengths), (ahead, 1.0))
    right = tree_map(_reach, (arms, lengths), (ahead, -1.0))
    at_left = tree_map(_foremost, (left,), (maximum(left),))
    at_right = tree_map(_foremost, (right,), (maximum(right),))
    span = tree_sum(tree_map(_tip, (arms, lengths, at_left), ()))
    span = span - tree_sum(tree_map(_tip, (arms, lengths, at_right), ()))
    return Pass(sines, sine, one, tree_map(_either, (at_left, at_right), ()), span)


@kernel
def level_normal(r: Mat3, t: Vec) -> Vec:
    """Horizontal normal n, world, from its projection t onto the plane of the cages.

    A cage touches an upright face where n − (n·b) b points, with b the body's z axis; so in body
    axes n ∥ t − (t·Z)/(Z·b) b, with Z the vertical.

    Args:
        r: Attitude.
        t: In the plane of the cages, body axes.
    """
    up = r.z
    steep = select(up.z * up.z > NO_DIRECTION, up.z, 1.0)
    return direction_of(r @ Vec(t.x, t.y, -(t.x * up.x + t.y * up.y) / steep), 1.0)


@kernel
def leaning_normal(t: Vec, force: Vec) -> Vec:
    """Normal of a face of any inclination, from its projection and the contact force.

    A cage is tangent to the face, so the normal has no part along the cage there: it lies between
    its projection t and the body's z axis.  Of the force, friction along the cage is left out so;
    friction across it is not, and deflects what is found.

    Args:
        t: Unit vector in the plane of the cages, body axes.
        force: From robot to obstacle, body axes.
    """
    along = force @ t
    return direction_of(Vec(t.x * along, t.y * along, force.z), 0.0)


@kernel
def face_normal(ahead: Vec, sine: float) -> Vec:
    """Normal of a face from the direction of the force, which is turned from it by asin sine."""
    bounded = select(sine > 1.0, 1.0, select(sine < -1.0, -1.0, sine))
    cosine = math.sqrt(1.0 - bounded * bounded)
    return Vec(ahead.x * cosine + ahead.y * bounded, ahead.y * cosine - ahead.x * bounded, 0.0)


@kernel
def tangent_normal(span: Vec, ahead: Vec) -> Vec:
    """Unit normal of the common tangent of two equal cages, on the side of a direction."""
    n = direction_of(Vec(span.y, -span.x, 0.0), 0.0)
    return n * select(n @ ahead >= 0.0, 1.0, -1.0)

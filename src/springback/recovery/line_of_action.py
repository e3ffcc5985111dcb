"""From a blow to the face that dealt it: by the line along which the force acts, rid of friction.

Friction turns a contact force away from the normal of the face, by up to atan μ, and no look at the
force alone can tell by how much.  But force and moment together give the line on which it acts; and
an arm's cage is a circle, which is met in one place only, where the face is its tangent.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from springback.kernels.compiler import kernel
from springback.kernels.trees import maximum, minimum, select, tree_map, tree_sum
from springback.kernels.vectors import Mat3, Vec
from springback.recovery.wrench import RecentImpulse
from springback.vehicle.state import Airframe, Arm, arm_direction

#: Squared length below which a vector has no direction (chosen: far below any reading).
NO_DIRECTION = 1e-12
#: Least share of an arm's length by which an arm that is hit points at the obstacle (chosen).
IN_FRONT = 0.2
#: Of an arm that is not in front: a sine that no circle is met with.
MISSED = 1e3


class Pass(NamedTuple):
    """How the line of action passes the cages."""

    sines: tuple[float, ...]  # of the angle from normal to force, had each arm alone been hit
    sine: float  # of the arm that it meets most squarely
    one: tuple[float, ...]  # 1 for that arm
    two: tuple[float, ...]  # 1 for the foremost arms to its left and right
    span: Vec  # from the latter's cage to the former's, body axes [m]


@kernel
def direction_of(a: Vec, level: float) -> Vec:
    """Unit vector along a vector or its horizontal part; zero where there is none."""
    kept = Vec(a.x, a.y, a.z * (1.0 - level))
    square = kept @ kept
    there = square > NO_DIRECTION
    return kept * select(there, 1.0 / math.sqrt(select(there, square, 1.0)), 0.0)


@kernel
def lever_of(recent: RecentImpulse) -> float:
    """Signed distance of the line of action from the main body, in the plane of the cages [m].

    (r × f)_z of the force f of one newton from robot to obstacle; both impulses fade alike, so that
    their ratio is that of force and moment.
    """
    p = recent.carried
    square = p.x * p.x + p.y * p.y
    there = square > NO_DIRECTION
    return -recent.turning.z * select(there, 1.0 / math.sqrt(select(there, square, 1.0)), 0.0)


@kernel
def _sine(arm: Arm, length: float, ahead: Vec, lever: float) -> float:
    """Of the angle φ from a cage's normal n to the force f: (l e × f)_z + r_0 sin φ = lever."""
    e = arm_direction(arm)
    across = e.x * ahead.y - e.y * ahead.x
    sine = (lever - length * across) / arm.cage_radius
    return select(e @ ahead > IN_FRONT, sine, MISSED)


@kernel
def _size(x: float) -> float:
    return abs(x)


@kernel
def _least_of(size: float, smallest: float) -> float:
    return select(size <= smallest, 1.0, 0.0)


@kernel
def _counted(x: float, chosen: float) -> float:
    return x * chosen


@kernel
def _reach(arm: Arm, length: float, ahead: Vec, side: float) -> float:
    """How far a cage on one side of the force reaches along it [m]; 0 for the other side."""
    e = arm_direction(arm)
    turned = (ahead.x * e.y - ahead.y * e.x) * side
    reach = length * (e @ ahead)
    return select((turned >= 0.0) & (reach > 0.0), reach, 0.0)


@kernel
def _foremost(reach: float, most: float) -> float:
    return select((reach > 0.0) & (reach >= most), 1.0, 0.0)


@kernel
def _tip(arm: Arm, length: float, chosen: float) -> Vec:
    return arm_direction(arm) * (length * chosen)


@kernel
def _either(a: float, b: float) -> float:
    return select(a + b > 0.5, 1.0, 0.0)


@kernel
def passed(airframe: Airframe, lengths: tuple[float, ...], ahead: Vec, lever: float) -> Pass:
    """How a line of action passes the cages.

    Args:
        airframe: As the pilot believes it to be.
        lengths: Of the arms [m].
        ahead: Direction of the force from robot to obstacle in the plane of the cages, body axes.
        lever: Of that line about the main body [m].
    """
    arms = airframe.arms
    sines = tree_map(_sine, (arms, lengths), (ahead, lever))
    sizes = tree_map(_size, (sines,), ())
    one = tree_map(_least_of, (sizes,), (minimum(sizes),))
    sine = tree_sum(tree_map(_counted, (sines, one), ())) / tree_sum(one)
    left = tree_map(_reach, (arms, lengths), (ahead, 1.0))
    right = tree_map(_reach, (arms, lengths), (ahead, -1.0))
    at_left, at_right = (
        tree_map(_foremost, (left,), (maximum(left),)),
        tree_map(_foremost, (right,), (maximum(right),)),
    )
    span = tree_sum(tree_map(_tip, (arms, lengths, at_left), ()))
    span = span - tree_sum(tree_map(_tip, (arms, lengths, at_right), ()))
    return Pass(sines, sine, one, tree_map(_either, (at_left, at_right), ()), span)


@kernel
def level_normal(r: Mat3, tangent_normal: Vec) -> Vec:
    """Horizontal n, world, whose part in the plane of the cages lies along a direction in it.

    A cage touches an upright face where n − (n·b) b points, with b the body's z axis; so in body
    axes n ∥ t − (t·Z)/(Z·b) b, with Z the vertical.

    Args:
        r: Attitude.
        tangent_normal: t, in the plane of the cages, body axes.
    """
    t, up = tangent_normal, r.z
    steep = select(up.z * up.z > NO_DIRECTION, up.z, 1.0)
    return direction_of(r @ Vec(t.x, t.y, -(t.x * up.x + t.y * up.y) / steep), 1.0)


@kernel
def turned_back(ahead: Vec, sine: float) -> Vec:
    """The normal from which a direction in the plane of the cages is turned by asin sine."""
    bounded = select(sine > 1.0, 1.0, select(sine < -1.0, -1.0, sine))
    cosine = math.sqrt(1.0 - bounded * bounded)
    return Vec(ahead.x * cosine + ahead.y * bounded, ahead.y * cosine - ahead.x * bounded, 0.0)


@kernel
def across(span: Vec, ahead: Vec) -> Vec:
    """Unit normal of the common tangent of two equal cages, on the side of a direction."""
    n = direction_of(Vec(span.y, -span.x, 0.0), 0.0)
    return n * select(n @ ahead >= 0.0, 1.0, -1.0)

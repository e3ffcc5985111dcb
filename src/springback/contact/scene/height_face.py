"""Distance from ground whose height is given on a grid: exact near its surface, else a lower bound.

The height is a bicubic B-spline, so surface, slope and curvature are continuous.  The body is what
lies below it within a rectangle, down to a level bottom; its sides are upright.

The nearest point of the surface is found by Newton's method from the point on the tangent plane
below.  A point that is nearer to the surface than the smallest radius of its hollows has one
nearest point only (the reach of H. Federer, "Curvature measures", 1959; the graph of a height has
no other narrow places), so what is found there is the distance.  Farther away it is the height
above the ground, over the length of the steepest normal: never more than the distance.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from springback.contact.scene.grid_face import dot, place_in, slopes, weights
from springback.contact.scene.sections import TINY, Face, PlanarFace, profile, rectangle
from springback.kernels.compiler import called_kernel, kernel
from springback.kernels.routines import number_at
from springback.kernels.splines import Four, blend, four_at
from springback.kernels.vectors import Vec

#: Numbers at the beginning of a table: nodes along x and y, and reciprocals of their spacings
#: [1/m]; then the coefficients, with one more on each side, those along y side by side.
COUNTS, PER_CELL, COEFFICIENTS = 0, 2, 4
#: Most steps of Newton's method, and the last step [m] (chosen: the ground is then known from where
#: it began by its slope and curvature, to rounding).
STEPS, LAST = 12, 1e-6


class Relief(NamedTuple):
    """Height at a place, with its first and second derivatives."""

    height: float  # [m]
    x: float
    y: float
    xx: float  # [1/m]
    xy: float
    yy: float


@kernel
def _bends(t: float) -> Four:
    """Second derivatives of the weights of a spline, per square of a cell."""
    s = 1.0 - t
    return Four(s, 3.0 * t - 2.0, 3.0 * s - 2.0, t)


@kernel
def relief_at(x: float, y: float, half: Vec, table: float) -> Relief:
    """The ground at a place within the rectangle, from its centre [m]."""
    nx, ny = int(number_at(table, COUNTS)), int(number_at(table, COUNTS + 1))
    per_x, per_y = number_at(table, PER_CELL), number_at(table, PER_CELL + 1)
    u, v = place_in((x + half.x) * per_x, nx), place_in((y + half.y) * per_y, ny)
    line = ny + 2
    k = COEFFICIENTS + line * u.first + v.first
    a, b = four_at(table, k), four_at(table, k + line)
    c, d = four_at(table, k + 2 * line), four_at(table, k + 3 * line)
    wy, sy = weights(v.share), slopes(v.share)
    level = blend(weights(u.share), a, b, c, d)
    rise = blend(slopes(u.share), a, b, c, d)
    bend = blend(_bends(u.share), a, b, c, d)
    return Relief(
        dot(wy, level), per_x * dot(wy, rise), per_y * dot(sy, level),
        per_x * per_x * dot(wy, bend),
        per_x * per_y * dot(sy, rise), per_y * per_y * dot(_bends(v.share), level),
    )  # fmt: skip


@kernel
def _beside_by(at: Relief, dx: float, dy: float) -> Relief:
    """The ground a very short way from a place [m]."""
    turn_x, turn_y = at.xx * dx + at.xy * dy, at.xy * dx + at.yy * dy
    return Relief(
        at.height + (at.x + 0.5 * turn_x) * dx + (at.y + 0.5 * turn_y) * dy,
        at.x + turn_x, at.y + turn_y, at.xx, at.xy, at.yy,
    )  # fmt: skip


@kernel
def _within(x: float, half: float) -> float:
    return half if x > half else (-half if x < -half else x)


class Foot(NamedTuple):
    """Point of the surface nearest to another one."""

    found: bool
    face: Face


@kernel
def _foot(q: Vec, begin: Relief, half: Vec, table: float) -> Foot:
    """Nearest point of the surface within its rectangle.

    Args:
        q: The point, from the centre of the box [m].
        begin: The ground below it.
        half: Half lengths of the box [m].
        table: Address of the numbers.
    """
    share = (q.z - begin.height) / (1.0 + begin.x * begin.x + begin.y * begin.y)
    x = _within(_within(q.x, half.x) + share * begin.x, half.x)
    y = _within(_within(q.y, half.y) + share * begin.y, half.y)
    at, ends = begin, False
    for _ in range(STEPS):
        at = relief_at(x, y, half, table)
        up = at.height - q.z
        fx, fy = x - q.x + up * at.x, y - q.y + up * at.y
        jx, jy, both = 1.0 + at.x * at.x, 1.0 + at.y * at.y, at.x * at.y
        bent_x, bent_y, bent = jx + up * at.xx, jy + up * at.yy, both + up * at.xy
        if (bent_x > 0.0) & (bent_x * bent_y > bent * bent):
            jx, jy, both = bent_x, bent_y, bent
        # On the rim the place moves along it, unless the way is inwards.
        held_x = ((x >= half.x) & (fx < 0.0)) | ((x <= -half.x) & (fx > 0.0))
        held_y = ((y >= half.y) & (fy < 0.0)) | ((y <= -half.y) & (fy > 0.0))
        if held_x:
            fx, both = 0.0, 0.0
        if held_y:
            fy, both = 0.0, 0.0
        inverse = 1.0 / (jx * jy - both * both)
        new_x = _within(x - inverse * (jy * fx - both * fy), half.x)
        new_y = _within(y - inverse * (jx * fy - both * fx), half.y)
        dx, dy = new_x - x, new_y - y
        x, y = new_x, new_y
        if abs(dx) + abs(dy) <= LAST:
            at, ends = _beside_by(at, dx, dy), True
            break
    scale = 1.0 / math.sqrt(1.0 + at.x * at.x + at.y * at.y)
    normal = Vec(-at.x * scale, -at.y * scale, scale)
    away = Vec(q.x - x, q.y - y, q.z - at.height)
    gap, length = away @ normal, math.sqrt(away @ away)
    if (length > TINY) & (abs(gap) < length * (1.0 - 1e-9)):  # the foot is on the rim
        return Foot(ends, Face(length, away * (1.0 / length)))
    return Foot(ends, Face(gap, normal))


@called_kernel
def height_face(q: Vec, half: Vec, table: float, share: float, reach: float) -> Face:
    """Distance and normal of ground of some height, own axes.

    Args:
        q: The point, from the centre of the ground's box [m].
        half: Half lengths of that box [m].
        table: Address of the numbers.
        share: 1/√(1 + s²) for the steepest slope s.
        reach: Distance within which the nearest point is unique [m].
    """
    x, y = _within(q.x, half.x), _within(q.y, half.y)
    at = relief_at(x, y, half, table)
    above, below = q.z - at.height, -half.z - q.z
    aside = rectangle(q.x, q.y, half.x, half.y)
    if above > 0.0:
        if (share * above < reach) & (aside.gap < reach):
            foot = _foot(q, at, half, table)
            if foot.found & (foot.face.gap < reach):
                return foot.face
        bound = Vec(-share * at.x, -share * at.y, share)
        if aside.gap > share * above:
            return Face(aside.gap, Vec(aside.x, aside.y, 0.0))
        if aside.gap > 0.0:  # the ground goes on level beyond its rim
            bound = Vec(bound.x if x == q.x else 0.0, bound.y if y == q.y else 0.0, share)
        return Face(share * above, bound)
    if (aside.gap > 0.0) | (below > 0.0):
        return _beside(aside, below)
    nearest = _beside(aside, below)
    if share * above > nearest.gap:
        foot = _foot(q, at, half, table)
        scale = 1.0 / math.sqrt(1.0 + at.x * at.x + at.y * at.y)
        face = Face(above * scale, Vec(-at.x * scale, -at.y * scale, scale))
        if foot.found & (foot.face.gap <= 0.0):
            face = foot.face
        return face if face.gap > nearest.gap else nearest
    return nearest


class Probe(NamedTuple):
    """Bounds on a distance, and a vector along the normal of a surface near by."""

    least: float  # [m]
    most: float  # [m]
    normal: Vec  # along a line: turns within a fraction of a cell of the least gap


@called_kernel
def height_probe(q: Vec, half: Vec, table: float, share: float, reach: float) -> Probe:
    """Bounds on the distance of `height_face`, and a first guess of its normal; as arguments there.

    The guess is the gradient of the height above the ground over the length of the normal below.
    """
    aside = rectangle(q.x, q.y, half.x, half.y)
    if aside.gap < 0.0:
        at = relief_at(q.x, q.y, half, table)
        above, square = q.z - at.height, 1.0 + at.x * at.x + at.y * at.y
        if (above > aside.gap) & (above > -half.z - q.z):  # neither a side nor the bottom is nearer
            tilt = above / square
            n = Vec(
                -at.x - tilt * (at.x * at.xx + at.y * at.xy),
                -at.y - tilt * (at.x * at.xy + at.y * at.yy), 1.0,
            )  # fmt: skip
            low, high = share * above, above
            return Probe(low, high, n) if above > 0.0 else Probe(high, low, n)
    found = height_face(q, half, table, share, reach)
    return Probe(found.gap, found.gap, found.normal)


@kernel
def _beside(aside: PlanarFace, below: float) -> Face:
    """Face of the upright sides and the bottom."""
    found = profile(aside.gap, below)
    return Face(found.gap, Vec(found.x * aside.x, found.x * aside.y, -found.y))

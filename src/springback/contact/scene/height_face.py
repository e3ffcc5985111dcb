"""Distance from ground whose height is given on a grid: exact near its surface, else a lower bound.

The height is a bicubic B-spline, so surface, slope and curvature are continuous.  The body is what
lies below it within a rectangle, down to a level bottom; its sides are upright.

The nearest point of the surface is found by Newton's method from the point on the tangent plane
below.  A point that is nearer to the surface than the smallest radius of its hollows has one
nearest point only (the reach of H. Federer, "Curvature measures", 1959; the graph of a height has
no other narrow places), so what is found there is the distance; likewise below the surface, by its
ridges.  Farther away all cells are searched that may hold a nearer point: those whose box, between
the lowest and the highest of a cell's coefficients, is nearer than what is known.  Beyond
some distance, and beside the rectangle, it is the height above the ground, over the length of the
steepest normal: never more than the distance.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from springback.contact.scene.grid_face import dot, place_in, slopes, weights
from springback.contact.scene.sections import FARTHEST, TINY, Face, PlanarFace, profile, rectangle
from springback.kernels.compiler import called_kernel, kernel
from springback.kernels.routines import number_at
from springback.kernels.splines import Four, blend, four_at
from springback.kernels.vectors import Vec

#: Numbers at the beginning of a table: nodes along x and y, reciprocals of their spacings [1/m],
#: and the depth within which the nearest point is unique [m]; then the coefficients, with one more
#: on each side, those along y side by side; then the highest and the lowest of each cell's.
COUNTS, PER_CELL, RIDGES, COEFFICIENTS = 0, 2, 4, 5
#: Most steps of Newton's method, and the last step [m] (chosen: the ground is then known from where
#: it began by its slope and curvature, to rounding).
STEPS, LAST = 12, 1e-6
#: Points along a side of a cell from the nearest of which Newton's method begins, its most steps
#: and its last one [m], and most halvings of a step that leads away (chosen).
SAMPLES, SAFE_STEPS, SHARP, HALVINGS = 4, 40, 1e-9, 12


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
def _square_slopes(
    q: Vec, x: float, y: float, at: Relief
) -> tuple[float, float, float, float, float]:
    """Derivatives of half the square of the way to the ground: by x, y, xx, yy and xy.

    Where the second ones are not positive, they are those of the plane that touches the ground.
    """
    up = at.height - q.z
    jx, jy, both = 1.0 + at.x * at.x, 1.0 + at.y * at.y, at.x * at.y
    bent_x, bent_y, bent = jx + up * at.xx, jy + up * at.yy, both + up * at.xy
    if (bent_x > 0.0) & (bent_x * bent_y > bent * bent):
        jx, jy, both = bent_x, bent_y, bent
    return x - q.x + up * at.x, y - q.y + up * at.y, jx, jy, both


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
        fx, fy, jx, jy, both = _square_slopes(q, x, y, at)
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
    return Foot(ends, _face_from(q, x, y, at, half))


@kernel
def _face_from(q: Vec, x: float, y: float, at: Relief, half: Vec) -> Face:
    """Distance from the nearest point of the surface; the way there is oblique on the rim only."""
    scale = 1.0 / math.sqrt(1.0 + at.x * at.x + at.y * at.y)
    normal = Vec(-at.x * scale, -at.y * scale, scale)
    away = Vec(q.x - x, q.y - y, q.z - at.height)
    gap, length = away @ normal, math.sqrt(away @ away)
    on_rim = (abs(x) >= half.x) | (abs(y) >= half.y)
    if on_rim & (length > TINY) & (abs(gap) < length * (1.0 - 1e-9)):
        return Face(length, away * (1.0 / length))
    return Face(gap, normal)


@kernel
def _square_from(q: Vec, x: float, y: float, height: float) -> float:
    dx, dy, dz = x - q.x, y - q.y, height - q.z
    return dx * dx + dy * dy + dz * dz


class _Spot(NamedTuple):
    """A point of the surface."""

    x: float  # [m]
    y: float  # [m]
    square: float  # of its distance [m²]


class _Cell(NamedTuple):
    """A rectangle [m]."""

    x: float
    to_x: float
    y: float
    to_y: float


@kernel
def _into(x: float, low: float, high: float) -> float:
    return low if x < low else (high if x > high else x)


@kernel
def _first_guess(q: Vec, cell: _Cell, half: Vec, table: float) -> _Spot:
    """The nearest of some points of a cell."""
    best = _Spot(cell.x, cell.y, 1e300)
    for a in range(SAMPLES):
        x = cell.x + (cell.to_x - cell.x) * a / (SAMPLES - 1)
        for b in range(SAMPLES):
            y = cell.y + (cell.to_y - cell.y) * b / (SAMPLES - 1)
            square = _square_from(q, x, y, relief_at(x, y, half, table).height)
            if square < best.square:
                best = _Spot(x, y, square)
    return best


@kernel
def _nearest_of_cell(q: Vec, cell: _Cell, half: Vec, table: float) -> _Spot:
    """Nearest point of a cell: Newton's steps, as far as they come nearer."""
    x, y, square = _first_guess(q, cell, half, table)
    at = relief_at(x, y, half, table)
    for _ in range(SAFE_STEPS):
        fx, fy, jx, jy, both = _square_slopes(q, x, y, at)
        if ((x >= cell.to_x) & (fx < 0.0)) | ((x <= cell.x) & (fx > 0.0)):
            fx, both = 0.0, 0.0
        if ((y >= cell.to_y) & (fy < 0.0)) | ((y <= cell.y) & (fy > 0.0)):
            fy, both = 0.0, 0.0
        inverse = -1.0 / (jx * jy - both * both)
        dx, dy = inverse * (jy * fx - both * fy), inverse * (jx * fy - both * fx)
        share, nearer = 1.0, False
        for k in range(2 * HALVINGS):
            if k == HALVINGS:  # held by a side of the cell, Newton's step may lead nowhere
                share, dx, dy = 1.0, -fx / jx, -fy / jy
            new_x = _into(x + share * dx, cell.x, cell.to_x)
            new_y = _into(y + share * dy, cell.y, cell.to_y)
            tried = relief_at(new_x, new_y, half, table)
            found = _square_from(q, new_x, new_y, tried.height)
            if found < square:
                x, y, square, at, nearer = new_x, new_y, found, tried, True
                break
            share *= 0.5
        if (not nearer) | (share * (abs(dx) + abs(dy)) <= SHARP):
            break
    return _Spot(x, y, square)


@kernel
def _beyond(x: float, low: float, high: float) -> float:
    """How far a number is outside a range."""
    return low - x if x < low else (x - high if x > high else 0.0)


@kernel
def _nearest(q: Vec, half: Vec, table: float, most: float) -> Foot:
    """Nearest point of all the surface, if one is nearer than some distance [m]."""
    nx, ny = int(number_at(table, COUNTS)), int(number_at(table, COUNTS + 1))
    per_x, per_y = number_at(table, PER_CELL), number_at(table, PER_CELL + 1)
    wide, long, bounds = 1.0 / per_x, 1.0 / per_y, COEFFICIENTS + (nx + 2) * (ny + 2)
    first_x = place_in(max((q.x - most + half.x) * per_x, 0.0), nx).first
    first_y = place_in(max((q.y - most + half.y) * per_y, 0.0), ny).first
    last_x = place_in((q.x + most + half.x) * per_x, nx).first
    last_y = place_in((q.y + most + half.y) * per_y, ny).first
    found, best = False, _Spot(0.0, 0.0, most * most)
    for i in range(first_x, last_x + 1):
        x = i * wide - half.x
        aside = _beyond(q.x, x, x + wide)
        for j in range(first_y, last_y + 1):
            y = j * long - half.y
            along, k = _beyond(q.y, y, y + long), bounds + 2 * (i * (ny - 1) + j)
            square = aside * aside + along * along
            if square >= best.square:
                continue
            off = _beyond(q.z, number_at(table, k + 1), number_at(table, k))
            if square + off * off >= best.square:
                continue
            low = _nearest_of_cell(q, _Cell(x, x + wide, y, y + long), half, table)
            if low.square < best.square:
                found, best = True, low
    return Foot(found, _face_from(q, best.x, best.y, relief_at(best.x, best.y, half, table), half))


@called_kernel
def height_face(q: Vec, half: Vec, table: float, share: float, reach: float, within: float) -> Face:
    """Distance and normal of ground of some height, own axes.

    Args:
        q: The point, from the centre of the ground's box [m].
        half: Half lengths of that box [m].
        table: Address of the numbers.
        share: 1/√(1 + s²) for the steepest slope s.
        reach: Distance within which the nearest point is unique [m].
        within: A distance above the ground beyond which it may be a lower bound [m].
    """
    x, y = _within(q.x, half.x), _within(q.y, half.y)
    at = relief_at(x, y, half, table)
    above, below = q.z - at.height, -half.z - q.z
    aside = rectangle(q.x, q.y, half.x, half.y)
    if above > 0.0:
        if (share * above < within) & (aside.gap <= 0.0):
            if share * above < reach:
                foot = _foot(q, at, half, table)
                if foot.found & (foot.face.gap >= 0.0) & (foot.face.gap < reach):
                    return foot.face
            least = within
            if q.z - half.z < within:
                near = _nearest(q, half, table, min(above + LAST, within))
                if near.found:
                    return near.face
                least = min(above, within)
            return _above_all(q, at, half, max(share * above, least), share)
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
        return _above_all(q, at, half, share * above, share)
    if (aside.gap > 0.0) | (below > 0.0):
        return _beside(aside, below)
    nearest = _beside(aside, below)
    if share * above > nearest.gap:
        foot = _foot(q, at, half, table)
        scale = 1.0 / math.sqrt(1.0 + at.x * at.x + at.y * at.y)
        face = Face(above * scale, Vec(-at.x * scale, -at.y * scale, scale))
        if foot.found & (foot.face.gap <= 0.0):
            face = foot.face
        if face.gap <= -number_at(table, RIDGES):
            near = _nearest(q, half, table, -max(face.gap, nearest.gap))
            if near.found & (near.face.gap <= 0.0):
                face = near.face
        return face if face.gap > nearest.gap else nearest
    return nearest


@kernel
def _above_all(q: Vec, at: Relief, half: Vec, least: float, share: float) -> Face:
    """Lower bound on the distance of a point far above the surface, or above its highest point."""
    if q.z - half.z > least:
        return Face(q.z - half.z, Vec(0.0, 0.0, 1.0))
    return Face(least, Vec(-share * at.x, -share * at.y, share))


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
        # Beyond the reach a part of the ground may be nearer that the slope below says nothing of;
        # nor is a side or the bottom to be nearer.
        inner = (above > aside.gap) & (above > -half.z - q.z)
        if (share * above < reach) & inner:
            tilt = above / square
            n = Vec(
                -at.x - tilt * (at.x * at.xx + at.y * at.xy),
                -at.y - tilt * (at.x * at.xy + at.y * at.yy), 1.0,
            )  # fmt: skip
            low, high = share * above, above
            return Probe(low, high, n) if above > 0.0 else Probe(high, low, n)
    found = height_face(q, half, table, share, reach, FARTHEST)
    return Probe(found.gap, found.gap, found.normal)


@kernel
def _beside(aside: PlanarFace, below: float) -> Face:
    """Face of the upright sides and the bottom."""
    found = profile(aside.gap, below)
    return Face(found.gap, Vec(found.x * aside.x, found.x * aside.y, -found.y))

"""Distance from a body of any form, by a grid of distances that is read between its nodes.

The numbers of a grid are a table of their own, so that bodies of one form share it wherever they
are: coefficients of a cubic B-spline in three dimensions along the signed distances at its nodes
(`springback.contact.grids.distance_grids`).  Value and gradient are continuous, and the gradient is
exactly that of the value, so the work of a contact is exact, although the distance is not.
M. Unser, "Splines: a perfect fit for signal and image processing" (1999).

Beyond the grid's box `grid_face` is a lower bound: the nearest point of the box and the distance
from there are at right angles or more.  `grid_distance` is the distance there, too: the way to the
nearest point of the surface enters the box somewhere, and the distance is what is left there and
the way up to it; any other way through the box is longer.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from springback.contact.scene.sections import Face
from springback.kernels.compiler import called_kernel, kernel
from springback.kernels.routines import number_at
from springback.kernels.splines import Four, spline_sums
from springback.kernels.vectors import Vec

#: Numbers at the beginning of a table: nodes along each axis, length of a cell and its reciprocal
#: [m], [1/m]; then the coefficients, with one more on each side, those along z side by side.
COUNTS, CELL, PER_CELL, COEFFICIENTS = 0, 3, 4, 5
#: Most corrections of the place where the way enters the box, by the nearest point of the surface;
#: and the last of these [m], which is also the step by which slopes are compared (chosen).
ENTRIES, BESIDE = 30, 1e-6
#: Most corrections by slopes, and the last one [m] (chosen).
POLISHES, LAST = 8, 1e-12
#: Least cosine of the way through a side of the box for which slopes correct it (chosen).
STEEP = 0.1


@kernel
def weights(t: float) -> Four:
    """Weights of the cubic B-spline at a share of a cell."""
    s = 1.0 - t
    tt, ss = t * t, s * s
    sixth = 1.0 / 6.0
    return Four(
        sixth * ss * s, sixth * (4.0 - 3.0 * tt * (1.0 + s)), sixth * (4.0 - 3.0 * ss * (1.0 + t)),
        sixth * tt * t,
    )  # fmt: skip


@kernel
def slopes(t: float) -> Four:
    """Derivatives of the weights, per cell."""
    s = 1.0 - t
    return Four(-0.5 * s * s, t * (1.5 * t - 2.0), s * (2.0 - 1.5 * s), 0.5 * t * t)


@kernel
def dot(w: Four, p: Four) -> float:
    """Sum of products."""
    return (w.a * p.a + w.b * p.b) + (w.c * p.c + w.d * p.d)


class Place(NamedTuple):
    """Place along one axis of a grid."""

    first: int  # number of the cell
    share: float  # of the cell


@kernel
def place_in(x: float, nodes: int) -> Place:
    """Cell of a coordinate from the first node on, in cells; at the ends the last one."""
    k = int(x)
    k = k if k < nodes - 2 else nodes - 2
    k = k if k > 0 else 0
    return Place(k, x - k)


@called_kernel
def grid_face(q: Vec, half: Vec, table: float) -> Face:
    """Distance and its gradient, which is 1 long to within the error of the grid; own axes.

    Args:
        q: The point, from the centre of the grid's box [m].
        half: Half lengths of that box [m].
        table: Address of the grid's numbers.
    """
    nx, ny = int(number_at(table, COUNTS)), int(number_at(table, COUNTS + 1))
    nz, per = int(number_at(table, COUNTS + 2)), number_at(table, PER_CELL)
    ox = q.x - half.x if q.x > half.x else (q.x + half.x if q.x < -half.x else 0.0)
    oy = q.y - half.y if q.y > half.y else (q.y + half.y if q.y < -half.y else 0.0)
    oz = q.z - half.z if q.z > half.z else (q.z + half.z if q.z < -half.z else 0.0)
    x = place_in((q.x - ox + half.x) * per, nx)
    y = place_in((q.y - oy + half.y) * per, ny)
    z = place_in((q.z - oz + half.z) * per, nz)
    wx, wy, wz = weights(x.share), weights(y.share), weights(z.share)
    sx, sy, sz = slopes(x.share), slopes(y.share), slopes(z.share)
    line = nz + 2
    page = line * (ny + 2)
    k = COEFFICIENTS + page * x.first + line * y.first + z.first
    values, along_x, along_y = spline_sums(table, k, line, page, wx, wy, sx, sy)
    gap = dot(wz, values)
    gx, gy, gz = per * dot(wz, along_x), per * dot(wz, along_y), per * dot(sz, values)
    square = ox * ox + oy * oy + oz * oz
    if square > 0.0:
        inside = gap if gap > 0.0 else 0.0
        length = math.sqrt(square + inside * inside)
        inverse = 1.0 / length
        gx = ox if ox != 0.0 else inside * gx
        gy = oy if oy != 0.0 else inside * gy
        gz = oz if oz != 0.0 else inside * gz
        return Face(length, Vec(gx * inverse, gy * inverse, gz * inverse))
    return Face(gap, Vec(gx, gy, gz))


class _GridWay(NamedTuple):
    """A way from a point through the box to the surface."""

    entry: Vec  # where it enters the box, or a place inside [m]
    length: float  # [m]
    face: Face  # at the entry


@kernel
def _way(q: Vec, entry: Vec, half: Vec, table: float) -> _GridWay:
    face, out = grid_face(entry, half, table), q - entry
    return _GridWay(entry, math.sqrt(out @ out) + face.gap, face)


@kernel
def _into_box(x: float, half: float) -> float:
    return half if x > half else (-half if x < -half else x)


@kernel
def _clamped(q: Vec, half: Vec) -> Vec:
    return Vec(_into_box(q.x, half.x), _into_box(q.y, half.y), _into_box(q.z, half.z))


@kernel
def _entered(x: float, step: float, half: float) -> float:
    """Share of a step after which a coordinate is between two planes; 0 if it is."""
    out = x - half if x > half else (x + half if x < -half else 0.0)
    return -out / step if out * step < 0.0 else 0.0


@kernel
def _entry_towards(q: Vec, foot: Vec, half: Vec) -> Vec:
    """Where a way from outside to a point in the box enters it."""
    way = foot - q
    share = max(
        _entered(q.x, way.x, half.x), _entered(q.y, way.y, half.y), _entered(q.z, way.z, half.z)
    )
    return _clamped(q + way * (share if share < 1.0 else 1.0), half)


@kernel
def _corrected(q: Vec, way: _GridWay, half: Vec, table: float) -> _GridWay:
    """The way towards the point of the surface that is nearest to where another one enters."""
    n = way.face.normal
    steep = math.sqrt(n @ n)
    if steep <= 0.0:
        return way
    foot = way.entry - n * (way.face.gap / steep)
    return _way(q, _entry_towards(q, _clamped(foot, half), half), half, table)


@kernel
def _turned(v: Vec, axis: int) -> Vec:
    """Components from one axis on."""
    if axis == 0:
        return v
    return Vec(v.y, v.z, v.x) if axis == 1 else Vec(v.z, v.x, v.y)


@kernel
def _back(v: Vec, axis: int) -> Vec:
    return _turned(v, 0 if axis == 0 else 3 - axis)


@kernel
def _enters_by(q: Vec, entry: Vec, half: Vec, axis: int) -> bool:
    """True for a way from outside that enters the box by one of the two sides across an axis."""
    at, p, h = _turned(q, axis), _turned(entry, axis), _turned(half, axis)
    off = at.x - p.x if at.x > p.x else p.x - at.x
    inside = h.x - p.x if p.x > 0.0 else h.x + p.x
    return (inside <= 1e-12) & (off > 1e-9)


class _Lean(NamedTuple):
    """How far a way would go aside if it entered along the slope of the distance [m]."""

    y: float
    z: float


@kernel
def _lean(off: float, n: Vec) -> _Lean:
    square = 1.0 - n.y * n.y - n.z * n.z
    scale = off / math.sqrt(square if square > STEEP * STEEP else STEEP * STEEP)
    return _Lean(scale * n.y, scale * n.z)


@kernel
def _polished(q: Vec, begin: _GridWay, half: Vec, table: float, axis: int) -> _GridWay:
    """The shortest way through a side of the box, if a way enters there: its length is stationary.

    So the way's direction is the gradient of its length, whatever the grid's errors.
    """
    best, at, box = begin, _turned(q, axis), _turned(half, axis)
    for _ in range(POLISHES if _enters_by(q, begin.entry, half, axis) else 0):
        p = _turned(best.entry, axis)
        off = at.x - p.x if at.x > p.x else p.x - at.x
        here = _lean(off, _turned(best.face.normal, axis))
        beside_y = grid_face(_back(Vec(p.x, p.y + BESIDE, p.z), axis), half, table)
        beside_z = grid_face(_back(Vec(p.x, p.y, p.z + BESIDE), axis), half, table)
        by_y, by_z = (
            _lean(off, _turned(beside_y.normal, axis)), _lean(off, _turned(beside_z.normal, axis)),
        )  # fmt: skip
        yy, zy = 1.0 + (by_y.y - here.y) / BESIDE, (by_y.z - here.z) / BESIDE
        yz, zz = (by_z.y - here.y) / BESIDE, 1.0 + (by_z.z - here.z) / BESIDE
        left_y, left_z = p.y - at.y + here.y, p.z - at.z + here.z
        whole = yy * zz - yz * zy
        if whole <= 0.0:
            break
        y = _into_box(p.y - (zz * left_y - yz * left_z) / whole, box.y)
        z = _into_box(p.z - (yy * left_z - zy * left_y) / whole, box.z)
        tried = _way(q, _back(Vec(p.x, y, z), axis), half, table)
        if tried.length > best.length + 1e-9:
            break
        best = tried
        if abs(y - p.y) + abs(z - p.z) <= LAST:
            break
    return best


@kernel
def _along_edge(q: Vec, begin: _GridWay, half: Vec, table: float, axis: int) -> _GridWay:
    """The shortest way through the edge of the box along an axis, if it is shorter than another."""
    at, box = _turned(q, axis), _turned(half, axis)
    y, z = _into_box(at.y, box.y), _into_box(at.z, box.z)
    if (y == at.y) | (z == at.z):  # ways lead past all edges along this axis
        return begin
    off = math.sqrt((at.y - y) * (at.y - y) + (at.z - z) * (at.z - z))
    best = _way(q, _back(Vec(_turned(begin.entry, axis).x, y, z), axis), half, table)
    for _ in range(POLISHES):
        from_x = _turned(best.entry, axis).x
        beside = grid_face(_back(Vec(from_x + BESIDE, y, z), axis), half, table)
        here = _lean(off, Vec(0.0, _turned(best.face.normal, axis).x, 0.0)).y
        rises = 1.0 + (_lean(off, Vec(0.0, _turned(beside.normal, axis).x, 0.0)).y - here) / BESIDE
        if rises <= 0.0:
            break
        x = _into_box(from_x - (from_x - at.x + here) / rises, box.x)
        tried = _way(q, _back(Vec(x, y, z), axis), half, table)
        if tried.length > best.length + 1e-9:
            break
        best = tried
        if abs(x - from_x) <= LAST:
            break
    return best if best.length < begin.length else begin


@called_kernel
def grid_distance(q: Vec, half: Vec, table: float, within: float) -> Face:
    """Distance and its gradient; arguments as for `grid_face`.

    Beyond the box and a distance of ``within`` it is a lower bound, and no less than that [m].
    """
    bound, nearest = grid_face(q, half, table), _clamped(q, half)
    out = q - nearest
    if (out @ out <= 0.0) | (bound.gap >= within):
        return bound
    best = _way(q, nearest, half, table)
    aside = best.length  # ways through other places: the nearest of the box may lead elsewhere
    for k in range(3):
        for side in range(2):
            by = aside if side == 0 else -aside
            x, y, z = by if k == 0 else 0.0, by if k == 1 else 0.0, by if k == 2 else 0.0
            tried = _way(q, _clamped(nearest + Vec(x, y, z), half), half, table)
            if tried.length < best.length:
                best = tried
    for _ in range(ENTRIES):
        before = best.entry
        best = _corrected(q, best, half, table)
        moved = best.entry - before
        if moved @ moved <= BESIDE * BESIDE:
            break
    for axis in range(3):
        best = _polished(q, best, half, table, axis)
    for axis in range(3):
        best = _along_edge(q, best, half, table, axis)
    away = q - best.entry
    length = math.sqrt(away @ away)
    if (length <= 0.0) | (best.length < bound.gap):
        return bound
    return Face(best.length, away * (1.0 / length))

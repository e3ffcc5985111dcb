"""Distance from a body of any form, by a grid of distances that is read between its nodes.

The numbers of a grid are a table of their own, so that bodies of one form share it wherever they
are: coefficients of a cubic B-spline in three dimensions, whose value at each node is the signed
distance there.  Value and gradient are continuous, and the gradient is exactly that of the value,
so the work of a contact is exact, although the distance is not.  M. Unser, "Splines: a perfect
fit for signal and image processing" (1999).

Beyond the grid's box the distance is a lower bound: the nearest point of the box and the distance
from there are at right angles or more.
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

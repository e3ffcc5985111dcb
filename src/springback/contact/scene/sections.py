"""Parts of signed distances: faces, and shapes in a plane from which solids are made."""

from __future__ import annotations

import math
from typing import NamedTuple

from springback.kernels.compiler import kernel
from springback.kernels.routines import number_at
from springback.kernels.vectors import Vec

#: Length below which a direction is undefined [m].
TINY = 1e-150
#: Distance within which that of a grid or height map is no bound [m]: no part is thicker (chosen).
FARTHEST = 0.5


class Face(NamedTuple):
    """Distance of a point from a solid, and the outward normal there."""

    gap: float  # [m]; negative inside
    normal: Vec


class PlanarFace(NamedTuple):
    """Distance of a point from a shape in a plane, and its gradient."""

    gap: float
    x: float
    y: float


@kernel
def vector_at(table: float, k: int) -> Vec:
    """Three numbers of a table."""
    return Vec(number_at(table, k), number_at(table, k + 1), number_at(table, k + 2))


@kernel
def sign(x: float) -> float:
    """Sign of a number, 1 for zero."""
    return 1.0 if x >= 0.0 else -1.0


@kernel
def profile(a: float, b: float) -> PlanarFace:
    """Quadrant a < 0 and b < 0: distance, and gradient along a and b."""
    out_a, out_b = a if a > 0.0 else 0.0, b if b > 0.0 else 0.0
    length = math.sqrt(out_a * out_a + out_b * out_b)
    if length > TINY:
        inverse = 1.0 / length
        return PlanarFace(length, out_a * inverse, out_b * inverse)
    return PlanarFace(a, 1.0, 0.0) if a > b else PlanarFace(b, 0.0, 1.0)


@kernel
def rectangle(x: float, y: float, half_x: float, half_y: float) -> PlanarFace:
    """Rectangle about the origin: distance, and gradient."""
    found = profile(abs(x) - half_x, abs(y) - half_y)
    return PlanarFace(found.gap, found.x * sign(x), found.y * sign(y))

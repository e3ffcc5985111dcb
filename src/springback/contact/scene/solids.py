"""Solids: signed distance and normal of the built-in shapes, with numbers read from a table.

A solid is a row of a table, its kind a number, so that every world of built-in shapes is one
structure to the compiler.  A row has a place, an orientation, up to six sizes, and the radius by
which its edges are rounded: sizes are those of the shape before it is rounded, smaller by that
radius on all sides.  Distances are exact outside; inside, they are exact to the nearest part of the
surface.  I. Quilez, "Distance functions", gives some of the formulas; the tests compare each with
sampled surfaces.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from springback.contact.scene.grid_face import grid_distance
from springback.contact.scene.height_face import height_face
from springback.contact.scene.sections import (
    FARTHEST,
    TINY,
    Face,
    PlanarFace,
    profile,
    rectangle,
    sign,
    vector_at,
)
from springback.kernels.compiler import kernel
from springback.kernels.routines import number_at
from springback.kernels.vectors import Vec

#: Columns of a row: kind, centre, the three axes of the solid in world axes, sizes, radius of the
#: rounded edges, surface, flag of the ground, and number of the obstacle that it belongs to.
KIND, CENTRE, AXES, SIZES, ROUNDING, SURFACE, GROUND, OWNER, WIDTH = 0, 1, 4, 13, 19, 20, 21, 22, 24

#: Kinds, and what their sizes are, along the solid's own axes.
HALF_SPACE = 0.0  # fills z < 0
BOX = 1.0  # half lengths along x, y and z
CAPSULE = 2.0  # half length of the axis, along z, and radius; a sphere if it is zero
FRUSTUM = 3.0  # radius at the bottom and at the top, half height along z
TORUS = 4.0  # radius of the axis, around z, and of the tube
WINDOW = (
    5.0  # half width (x), half height (y), half thickness (z); of the opening: half width, half
)
# height, and height of its centre
ROUND_WINDOW = 6.0  # half width, half height, half thickness; radius of the opening, in the middle
GRID = 7.0  # half lengths of a box around it; address of its numbers (`grid_distance`)
HEIGHTS = 8.0  # likewise; share of a height that is a distance, and reach (`height_face`)
NET = 9.0  # half lengths of its face along x and y; depth of the body behind it, along −z


@kernel
def _box(q: Vec, half: Vec) -> Face:
    u = Vec(abs(q.x) - half.x, abs(q.y) - half.y, abs(q.z) - half.z)
    out = Vec(
        u.x if u.x > 0.0 else 0.0, u.y if u.y > 0.0 else 0.0, u.z if u.z > 0.0 else 0.0
    )  # fmt: skip
    length = math.sqrt(out @ out)
    sx, sy, sz = sign(q.x), sign(q.y), sign(q.z)
    if length > TINY:
        inverse = 1.0 / length
        return Face(length, Vec(sx * out.x * inverse, sy * out.y * inverse, sz * out.z * inverse))
    if u.z >= u.x and u.z >= u.y:
        return Face(u.z, Vec(0.0, 0.0, sz))
    return Face(u.x, Vec(sx, 0.0, 0.0)) if u.x >= u.y else Face(u.y, Vec(0.0, sy, 0.0))


@kernel
def capsule_face(q: Vec, half: float, radius: float) -> Face:
    """Face of a capsule, in its own axes.

    Args:
        q: The point [m].
        half: Half length of its axis, along z [m].
        radius: [m].
    """
    along = half if q.z > half else (-half if q.z < -half else q.z)
    v = Vec(q.x, q.y, q.z - along)
    length = math.sqrt(v @ v)
    normal = v * (1.0 / length) if length > TINY else Vec(1.0, 0.0, 0.0)
    return Face(length - radius, normal)


@kernel
def _about_axis(q: Vec, rho: float, found: PlanarFace) -> Face:
    """Face of a body of revolution, from its section through the axis: along ρ and z."""
    if rho > TINY:
        outward = found.x / rho
        return Face(found.gap, Vec(outward * q.x, outward * q.y, found.y))
    return Face(found.gap, Vec(found.x, 0.0, found.y))


@kernel
def _frustum(q: Vec, bottom: float, top: float, half: float) -> Face:
    """A convex polygon, turned about z: bottom, side and top."""
    rho = math.sqrt(q.x * q.x + q.y * q.y)
    dx, dz = top - bottom, 2.0 * half
    inverse = 1.0 / math.sqrt(dx * dx + dz * dz)
    nx, nz = dz * inverse, -dx * inverse  # out of the side
    below, above = -half - q.z, q.z - half
    aside = nx * (rho - bottom) + nz * (q.z + half)
    if below <= 0.0 and above <= 0.0 and aside <= 0.0:
        if aside >= below and aside >= above:
            return _about_axis(q, rho, PlanarFace(aside, nx, nz))
        level = PlanarFace(below, 0.0, -1.0) if below > above else PlanarFace(above, 0.0, 1.0)
        return _about_axis(q, rho, level)
    t = ((rho - bottom) * dx + (q.z + half) * dz) * inverse * inverse
    t = 0.0 if t < 0.0 else (1.0 if t > 1.0 else t)
    sx, sz = rho - (bottom + t * dx), q.z - (-half + t * dz)
    bx, bz = rho - (rho if rho < bottom else bottom), q.z + half
    ax, az = rho - (rho if rho < top else top), q.z - half
    side, low, high = sx * sx + sz * sz, bx * bx + bz * bz, ax * ax + az * az
    vx, vz, square = sx, sz, side
    if low < square:
        vx, vz, square = bx, bz, low
    if high < square:
        vx, vz, square = ax, az, high
    length = math.sqrt(square)
    scale = 1.0 / length if length > TINY else 0.0
    return _about_axis(q, rho, PlanarFace(length, vx * scale, vz * scale))


@kernel
def _torus(q: Vec, radius: float, tube: float) -> Face:
    rho = math.sqrt(q.x * q.x + q.y * q.y)
    x, z = rho - radius, q.z
    length = math.sqrt(x * x + z * z)
    scale = 1.0 / length if length > TINY else 0.0
    return _about_axis(q, rho, PlanarFace(length - tube, x * scale, z * scale))


@kernel
def _net(q: Vec, half_x: float, half_y: float, depth: float) -> Face:
    """A face, and the body behind it, out of which the way is through the face or the sides."""
    section = rectangle(q.x, q.y, half_x, half_y)
    if q.z < -depth:
        below = profile(section.gap if section.gap > 0.0 else 0.0, -depth - q.z)
        return Face(below.gap, Vec(below.x * section.x, below.x * section.y, -below.y))
    found = profile(section.gap, q.z)
    return Face(found.gap, Vec(found.x * section.x, found.x * section.y, found.y))


@kernel
def _plate(q: Vec, half_thickness: float, section: PlanarFace) -> Face:
    """A shape in the plane of x and y, of some thickness along z."""
    found = profile(section.gap, abs(q.z) - half_thickness)
    return Face(
        found.gap, Vec(found.x * section.x, found.x * section.y, found.y * sign(q.z))
    )  # fmt: skip


@kernel
def _cut(outline: PlanarFace, opening: PlanarFace) -> PlanarFace:
    """An outline without an opening; below a doorway both are positive, at right angles."""
    inside = PlanarFace(-opening.gap, -opening.x, -opening.y)
    if outline.gap > 0.0 and inside.gap > 0.0:
        length = math.sqrt(outline.gap * outline.gap + inside.gap * inside.gap)
        a, b = outline.gap / length, inside.gap / length
        return PlanarFace(length, a * outline.x + b * inside.x, a * outline.y + b * inside.y)
    return outline if outline.gap > inside.gap else inside


@kernel
def _disc(x: float, y: float, radius: float) -> PlanarFace:
    rho = math.sqrt(x * x + y * y)
    scale = 1.0 / rho if rho > TINY else 0.0
    return PlanarFace(rho - radius, x * scale, y * scale)


class SolidForm(NamedTuple):
    """What a solid is, without its place."""

    kind: float
    a: float  # its sizes [m]
    b: float
    c: float
    d: float
    e: float
    f: float
    rounding: float  # [m]


@kernel
def form_at(table: float, row: int) -> SolidForm:
    """Form of the solid whose numbers begin at a position of a table."""
    k = row + SIZES
    return SolidForm(
        number_at(table, row + KIND), number_at(table, k), number_at(table, k + 1),
        number_at(table, k + 2), number_at(table, k + 3), number_at(table, k + 4),
        number_at(table, k + 5), number_at(table, row + ROUNDING),
    )  # fmt: skip


@kernel
def _sharp_face(s: SolidForm, q: Vec, within: float) -> Face:
    """Face of a solid before its edges are rounded."""
    if s.kind == CAPSULE:
        return capsule_face(q, s.a, s.b)
    if s.kind == BOX:
        return _box(q, Vec(s.a, s.b, s.c))
    if s.kind == FRUSTUM:
        return _frustum(q, s.a, s.b, s.c)
    if s.kind == TORUS:
        return _torus(q, s.a, s.b)
    if s.kind == GRID:
        return grid_distance(q, Vec(s.a, s.b, s.c), s.d, within)
    if s.kind == HEIGHTS:
        return height_face(q, Vec(s.a, s.b, s.c), s.d, s.e, s.f, within)
    if s.kind == NET:
        return _net(q, s.a, s.b, s.c)
    outline = rectangle(q.x, q.y, s.a, s.b)
    if s.kind == WINDOW:
        return _plate(q, s.c, _cut(outline, rectangle(q.x, q.y - s.f, s.d, s.e)))
    return _plate(q, s.c, _cut(outline, _disc(q.x, q.y, s.d)))


@kernel
def form_face(s: SolidForm, q: Vec, within: float) -> Face:
    """Distance and outward normal of a solid that is no half-space, all in its own axes."""
    found = _sharp_face(s, q, within)
    return Face(found.gap - s.rounding, found.normal)


@kernel
def solid_face(table: float, row: int, point: Vec) -> Face:
    """Distance of a point from a solid, and the outward normal there; world axes.

    Args:
        table: Of the world.
        row: Position of the solid's first number.
        point: [m].
    """
    return solid_face_within(table, row, point, FARTHEST)


@kernel
def solid_face_within(table: float, row: int, point: Vec, within: float) -> Face:
    """Distance, if it is less than a given one [m], and else a lower bound that is not less.

    The other arguments are as for `solid_face`; only grids and height maps have bounds.
    """
    relative = point - vector_at(table, row + CENTRE)
    ez = vector_at(table, row + AXES + 6)
    if number_at(table, row + KIND) == HALF_SPACE:
        return Face(ez @ relative, ez)
    ex, ey = vector_at(table, row + AXES), vector_at(table, row + AXES + 3)
    q = Vec(ex @ relative, ey @ relative, ez @ relative)
    found = form_face(form_at(table, row), q, within)
    n = found.normal
    return Face(found.gap, ex * n.x + ey * n.y + ez * n.z)

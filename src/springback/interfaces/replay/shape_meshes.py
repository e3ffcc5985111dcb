"""Exact meshes of the built-in shapes: vertices on the surface, closed, anticlockwise from outside.

Rounded bodies are outlines that move out and in again as they go up, as far as a rounded edge of
their radius does.  What has no end is cut off by flat ends.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.contact.scene.solids import BOX, CAPSULE, FRUSTUM, ROUND_WINDOW, TORUS, WINDOW
from springback.contact.scene.table import ENDLESS
from springback.contact.shapes import ShapeSettings, SolidShape, Stairs

Array = np.ndarray[Any, np.dtype[np.float64]]
Cells = np.ndarray[Any, np.dtype[np.intp]]

#: Distance of chords from their arc [m], and fewest and most sides of a full circle (chosen).
SAGITTA, LEAST_SIDES, MOST_SIDES = 4e-4, 24, 128
#: Vertices closer together than this are one [m].
SAME = 1e-9
QUARTER = 0.5 * math.pi

Outline = Callable[[float], Array]
"""Points of an outline, anticlockwise, that is moved out by a distance [m]; always as many."""


class ShapeMesh(NamedTuple):
    """Surface of a shape as triangles."""

    vertices: Array  # [m], shape (vertices, 3)
    triangles: Cells  # shape (triangles, 3)


class EndSpan(NamedTuple):
    """Where a body without end is cut off: places along its axis from its centre [m]."""

    low: float
    high: float


def mesh_of(shape: ShapeSettings, span: EndSpan | None = None) -> ShapeMesh:
    """Mesh of a shape: of a flight of stairs one body, else those of its solids.

    Args:
        shape: Not a slope, which has no end in two directions.
        span: Ends of what has none.
    """
    if isinstance(shape, Stairs):
        return _stairs(shape)
    return as_one([mesh_of_body(body, span) for body in shape.bodies()])


def mesh_of_body(body: SolidShape, span: EndSpan | None = None, sides: int = 0) -> ShapeMesh:
    """Mesh of one solid.

    Args:
        body: Not a half-space.
        span: Ends of a capsule without end.
        sides: Of a full circle, a multiple of four; by default as its radius asks for.
    """
    s, edge = body.sizes, body.rounding
    if body.kind == BOX:
        mesh = _plate(_levels(s[2], edge), lambda out: _rectangle(s[0], s[1], out, edge))
    elif body.kind == CAPSULE:
        count = sides or sides_of(s[1])
        mesh = _lathe(_rod(s[0], s[1], span, count // 4), count)
    elif body.kind == FRUSTUM:
        mesh = _lathe(_cone(s[0], s[1], s[2], edge), sides or sides_of(max(s[:2]) + edge))
    elif body.kind == TORUS:
        mesh = _torus(s[0], s[1], sides or sides_of(s[0] + s[1]))
    elif body.kind in (WINDOW, ROUND_WINDOW):
        mesh = _window(body, sides)
    else:
        raise ValueError(f"solids of kind {body.kind:g} have no mesh")
    return ShapeMesh(body.centre + mesh.vertices @ body.axes, mesh.triangles)


def as_one(meshes: Sequence[ShapeMesh]) -> ShapeMesh:
    """Several meshes as one."""
    first = np.cumsum([0, *(len(one.vertices) for one in meshes)])
    return ShapeMesh(
        np.concatenate([one.vertices for one in meshes]),
        np.concatenate([one.triangles + k for one, k in zip(meshes, first, strict=False)]),
    )


def trunks(bodies: Sequence[SolidShape], span: EndSpan, sides: int) -> ShapeMesh:
    """Upright poles without end as one mesh, fast for many of them.

    Args:
        bodies: Capsules along Z, with centres at one height.
        span: Their ends.
        sides: Of each.
    """
    one = mesh_of_body(bodies[0]._replace(centre=np.zeros(3)), span, sides)
    radii = np.array([body.sizes[1] for body in bodies]) / bodies[0].sizes[1]
    scale = np.stack([radii, radii, np.ones_like(radii)], axis=1)
    centres = np.array([body.centre for body in bodies])
    vertices = one.vertices * scale[:, None, :] + centres[:, None, :]
    first = len(one.vertices) * np.arange(len(bodies))
    triangles = one.triangles + first[:, None, None]
    return ShapeMesh(vertices.reshape(-1, 3), triangles.reshape(-1, 3))


def sides_of(radius: float) -> int:
    """Sides of a circle [m]: a multiple of four, so many that chords are close to the arc."""
    count = 4 * _steps(QUARTER, radius)
    return min(max(count, LEAST_SIDES), MOST_SIDES)


# -- outlines in a plane --------------------------------------------------------------------------


def _steps(angle: float, radius: float) -> int:
    """Chords of an arc of some angle and radius [m]."""
    widest = 2.0 * math.acos(max(1.0 - SAGITTA / max(radius, SAGITTA), 0.0))
    return max(1, math.ceil(angle / widest))


def _arc(x: float, y: float, out: float, first: float, edge: float, turn: float = QUARTER) -> Array:
    """An arc about a point from an angle on, with as many points as one of the radius ``edge``."""
    at = np.linspace(first, first + turn, _steps(turn, edge) + 1)
    return np.stack([x + out * np.cos(at), y + out * np.sin(at)], axis=1)


def _corners(a: float, b: float, out: float, edge: float) -> list[Array]:
    """Corners of a rectangle as arcs, from the lower left; a and b are half its sides."""
    signs = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))
    return [_arc(x * a, y * b, out, math.pi + QUARTER * k, edge) for k, (x, y) in enumerate(signs)]


def _rectangle(a: float, b: float, out: float, edge: float) -> Array:
    return np.concatenate(_corners(a, b, out, edge))


# -- bodies ---------------------------------------------------------------------------------------


def _welded(points: Array, triangles: Cells) -> ShapeMesh:
    """Vertices in one place become one, and triangles that have no area then are dropped."""
    cells = np.round(points / SAME).astype(np.int64)
    _, first, back = np.unique(cells, axis=0, return_index=True, return_inverse=True)
    a, b, c = back.reshape(-1)[triangles].T
    whole = (a != b) & (b != c) & (c != a)
    return ShapeMesh(points[first], np.stack([a, b, c], axis=1)[whole])


def _band(low: Cells, high: Cells) -> Cells:
    """Triangles between two loops, the second above the first, as seen from outside."""
    after, above = np.roll(low, -1), np.roll(high, -1)
    found = [np.stack([low, after, above], axis=1), np.stack([low, above, high], axis=1)]
    return np.concatenate(found)


def _fan(loop: Cells) -> Cells:
    """Triangles of a face that its first point can see whole."""
    first = np.full(len(loop) - 2, loop[0])
    return np.stack([first, loop[1:-1], loop[2:]], axis=1)


def _levels(half: float, edge: float) -> Array:
    """Heights from below and how far out a rounded plate of some thickness is there [m]."""
    rim = _arc(0.0, half, edge, 0.0, edge)[:, ::-1]
    return np.concatenate([rim[::-1] * [-1.0, 1.0], rim])


def _plate(
    levels: Array, outer: Outline, inner: Outline | None = None, lid: Cells | None = None
) -> ShapeMesh:
    """A shape of some thickness along z, perhaps with an opening.

    Args:
        levels: Of `_levels`.
        outer: Its outline.
        inner: That of the opening, which becomes narrower as the shape moves out.
        lid: Triangles of the face above, by numbers of the points of both outlines; a fan unless
            they are given.
    """
    outlines = [outer] if inner is None else [outer, inner]
    rows = [[outline(out) for outline in outlines] for _, out in levels]
    count, shared = len(rows[0][0]), sum(len(flat) for flat in rows[0])
    points = np.concatenate([
        np.insert(np.concatenate(row), 2, z, axis=1)
        for row, z in zip(rows, levels[:, 0], strict=True)
    ])  # fmt: skip
    numbers = np.arange(len(points)).reshape(-1, shared)
    lid = _fan(np.arange(count)) if lid is None else lid
    parts = [numbers[-1][lid], numbers[0][lid][:, ::-1]]
    for low, high in itertools.pairwise(numbers):
        parts.append(_band(low[:count], high[:count]))
        if inner is not None:
            parts.append(_band(low[count:], high[count:])[:, ::-1])
    return _welded(points, np.concatenate(parts))


def _window(body: SolidShape, sides: int) -> ShapeMesh:
    """A wall with an opening: round, rectangular, or open below."""
    (a, b, half, *hole), edge = body.sizes, body.rounding
    levels, per_corner = _levels(half, edge), _steps(QUARTER, edge) + 1
    corner = per_corner * np.arange(4)

    def outer(out: float) -> Array:
        return _rectangle(a, b, out, edge)

    if body.kind != WINDOW:
        count = sides or sides_of(hole[0])
        at = math.pi + math.tau * np.arange(count) / count
        around = np.stack([np.cos(at), np.sin(at)], axis=1)
        lid = _lid_of_circle(corner, 4 * per_corner + np.arange(count))
        return _plate(levels, outer, lambda out: (hole[0] - out) * around, lid)
    wide, high, middle = hole
    if middle - high > -b:
        square = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
        lid = _band(corner, 4 * per_corner + np.arange(4))
        return _plate(
            levels, outer, lambda out: [0.0, middle] + square * [wide - out, high - out], lid
        )  # fmt: skip

    def arch(out: float) -> Array:
        """Outline of a wall with an open door, from the right foot on."""
        left, *others = _corners(a, b, out, edge)
        x, foot, top = wide - out, -b - out, middle + high - out
        door = np.array([[-x, foot], [-x, top], [x, top]])
        return np.concatenate([[[x, foot]], *others, left, door])

    p, (b0, c0, d0, a0), last = 0, 1 + corner, 4 * per_corner
    s, r, q = last + 1, last + 2, last + 3
    faces = [(p, b0, c0), (p, c0, q), (q, c0, d0), (q, d0, r), (r, d0, a0), (r, a0, s)]
    return _plate(levels, arch, lid=np.array(faces))


def _lid_of_circle(corner: Cells, circle: Cells) -> Cells:
    """Face between four corners and a circle, of which each corner has a quarter."""
    quarters = np.append(circle, circle[0])
    found: list[tuple[int, int, int]] = []
    size = len(circle) // 4
    for k in range(4):
        part = quarters[k * size : (k + 1) * size + 1]
        found += [(corner[k], b, a) for a, b in itertools.pairwise(part)]
        found.append((corner[k], corner[(k + 1) % 4], part[-1]))
    return np.array(found, dtype=np.intp)


def _lathe(section: Array, sides: int) -> ShapeMesh:
    """A body of revolution about z.

    Args:
        section: Distance from the axis and height, from below [m], shape (points, 2); it begins
            and ends on the axis or with a flat end.
        sides: Of a full circle.
    """
    at = math.tau * np.arange(sides) / sides
    rho, z = section[:, :1], section[:, 1:]
    points = np.stack([rho * np.cos(at), rho * np.sin(at), np.broadcast_to(z, (len(z), sides))], 2)
    rings = np.arange(len(section) * sides).reshape(-1, sides)
    parts = [_fan(rings[0])[:, ::-1], _fan(rings[-1])]
    parts += [_band(low, high) for low, high in itertools.pairwise(rings)]
    return _welded(points.reshape(-1, 3), np.concatenate(parts))


def _rod(half: float, radius: float, span: EndSpan | None, steps: int) -> Array:
    """Section of a capsule, or of a part of a pole without end."""
    if half >= ENDLESS:
        assert span is not None, "a pole without end is cut off"
        return np.array([[radius, span.low], [radius, span.high]])
    at = np.linspace(0.0, QUARTER, steps + 1)
    cap = np.stack([radius * np.cos(at), half + radius * np.sin(at)], axis=1)
    return np.concatenate([cap[::-1] * [1.0, -1.0], cap])


def _cone(bottom: float, top: float, half: float, edge: float) -> Array:
    """Section of a cone with rounded edges."""
    lean = math.atan2(bottom - top, 2.0 * half)  # of the normal of its side
    below = _arc(bottom, -half, edge, -QUARTER, edge, QUARTER + lean)
    return np.concatenate([below, _arc(top, half, edge, lean, edge, QUARTER - lean)])


def _torus(radius: float, tube: float, sides: int) -> ShapeMesh:
    rings = sides_of(tube)
    at, up = math.tau * np.arange(sides) / sides, math.tau * np.arange(rings) / rings
    rho, z = radius + tube * np.cos(up)[:, None], tube * np.sin(up)[:, None]
    points = np.stack([rho * np.cos(at), rho * np.sin(at), np.broadcast_to(z, (rings, sides))], 2)
    numbers = np.arange(rings * sides).reshape(rings, sides)
    bands = [_band(numbers[k - 1], numbers[k]) for k in range(rings)]
    return ShapeMesh(points.reshape(-1, 3), np.concatenate(bands))


def _stairs(shape: Stairs) -> ShapeMesh:
    """A flight of stairs as one body: its profile, as thick as it is wide."""
    edge, rise, tread = shape.edge_radius, shape.rise, shape.tread
    end, top = shape.steps * tread - edge, shape.steps * rise - edge

    def profile(out: float) -> Array:
        parts = [_arc(end, edge, out, -QUARTER, edge), _arc(end, top, out, 0.0, edge)]
        for k in reversed(range(shape.steps)):
            foot, nose = k * tread + edge, (k + 1) * rise - edge
            parts.append(_arc(foot, nose, out, QUARTER, edge))
            if k:
                parts.append(np.array([[foot - out, k * rise - edge + out]]))
        parts.append(_arc(edge, edge, out, math.pi, edge))
        return np.concatenate(parts)

    mesh = _plate(_levels(0.5 * shape.width - edge, edge), profile)
    c, s = math.cos(shape.yaw), math.sin(shape.yaw)
    axes = np.array([[c, s, 0.0], [0.0, 0.0, 1.0], [s, -c, 0.0]])
    return ShapeMesh(np.array(shape.position) + mesh.vertices @ axes, mesh.triangles)

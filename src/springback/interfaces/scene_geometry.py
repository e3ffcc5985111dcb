"""Things to hit as things to draw: rectangles for walls, mats and the ground, else meshes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.contact.obstacles import outward_normal, signed_distance
from springback.contact.parameters import Ground, Mat, Own, Wall
from springback.kernels.vectors import Vec

Array = np.ndarray[Any, np.dtype[np.float64]]
Cells = np.ndarray[Any, np.dtype[np.intp]]

#: How far a drawn face reaches beyond what happens near it [m], and its least and largest sides;
#: chosen: a piece of wall, not all of it.
ROOM, LEAST_SIDE, LARGEST_SIDE = 0.6, 1.6, 20.0
#: Normals with a vertical part beyond this lie rather than stand.
LYING = 0.9
#: A shape of one's own is searched this far around where something touched, or else flew [m] ...
SEARCHED = 1.2
#: ... in cells that are halved so often; chosen: the last are 4 cm wide.
HALVINGS, FIRST_CELLS = 3, 8

_CORNERS = np.array([[(k >> a) & 1 for a in range(3)] for k in range(8)])


class Drawable(NamedTuple):
    """One thing to draw.

    A rectangle has a centre, an outward normal and the halves of its sides, and the matter behind
    it is ``thickness`` deep, without end where that is 0.  A mesh has vertices and triangles,
    counted anticlockwise from outside.
    """

    kind: str  # wall, mat, ground or mesh
    name: str  # for a legend
    centre: tuple[float, ...] = ()  # world [m]
    normal: tuple[float, ...] = ()  # unit vector, world
    across: tuple[float, ...] = ()  # half a side, world [m]
    along: tuple[float, ...] = ()  # half of the other, upwards where the face stands, world [m]
    thickness: float = 0.0  # [m]
    vertices: Array | None = None  # world [m], shape (vertices, 3)
    triangles: Cells | None = None  # shape (triangles, 3)
    normals: Array | None = None  # at the vertices, shape (vertices, 3)


class Drawn(NamedTuple):
    """Obstacles as things to draw, and what is to be said about them."""

    drawables: tuple[Drawable, ...]
    notes: tuple[str, ...]


def drawn(
    obstacles: Sequence[Wall | Ground | Mat], own: Sequence[Own], flown: Array, near: Array
) -> Drawn:
    """Everything that can be hit, as things to draw.

    Args:
        obstacles: Of the scenario.
        own: Shapes of the user's own, with their surfaces.
        flown: Where the vehicle was, world [m], shape (instants, 3).
        near: Where something touched, world [m], shape (touches, 3), possibly none.
    """
    levels = [entry.height for entry in obstacles if isinstance(entry, Ground)]
    floor = max((z for z in levels if z <= flown[:, 2].min()), default=None)
    things = [_face(entry, flown, floor) for entry in obstacles]
    notes = []
    middle = near if len(near) else flown
    for shape, _ in own:
        name = type(shape).__name__
        mesh = mesh_of(shape, middle.min(axis=0) - SEARCHED, middle.max(axis=0) + SEARCHED)
        if mesh is None:
            notes.append(f"{name} is not drawn: none of its surface was found near the flight")
        else:
            things.append(mesh)
    return Drawn(tuple(things), tuple(notes))


def _face(entry: Wall | Ground | Mat, flown: Array, floor: float | None) -> Drawable:
    """A rectangle of a face about what flew near it; a standing one reaches down to the floor."""
    if isinstance(entry, Ground):
        n, offset, thickness = np.array([0.0, 0.0, 1.0]), entry.height, 0.0
        close = flown
    else:
        thickness = entry.thickness if isinstance(entry, Mat) else 0.0
        face = entry.plane(thickness)
        n, offset = np.array(face.normal), face.offset
        heights = flown @ n
        close = flown[heights <= heights.min() + ROOM]
    centre, halves = n * offset, []
    for axis in _axes(n):
        places = close @ axis
        low, high = float(places.min()) - ROOM, float(places.max()) + ROOM
        side = min(max(high - low, LEAST_SIDE), LARGEST_SIDE)
        middle = 0.5 * (low + high)
        if floor is not None and axis[2] > 0.5:
            foot = (floor - n[2] * offset) / axis[2]
            side = min(max(side, middle + 0.5 * side - foot), LARGEST_SIDE)
            middle = foot + 0.5 * side
        centre = centre + middle * axis
        halves.append(_told(0.5 * side * axis))
    across, along = halves
    return Drawable(entry.type, entry.type, _told(centre), _told(n), across, along, thickness)


def _told(v: Array) -> tuple[float, ...]:
    return tuple(map(float, v))


def _axes(n: Array) -> tuple[Array, Array]:
    """Two unit vectors in a face, level and up it; for a lying face X or nearly, and the other."""
    up = np.array([0.0, 0.0, 1.0]) if abs(n[2]) < LYING else np.array([0.0, 1.0, 0.0])
    across = np.cross(up, n)
    across /= np.linalg.norm(across)
    return across, np.cross(n, across)


# -- shapes of one's own --------------------------------------------------------------------------


def mesh_of(shape: Any, low: Array, high: Array) -> Drawable | None:
    """A shape's surface inside a box, as triangles; None if there is none.

    Cells that the surface cannot reach, by their distance, are dropped before those that are left
    are halved.  Each of the last cells that the surface passes through has one vertex, laid onto
    the surface along the normal, and every edge that it crosses becomes a face ("surface nets",
    S. F. F. Gibson, 1998).

    Args:
        shape: Registered with `signed_distance` and `outward_normal`.
        low: Corner of the box, world [m].
        high: The other corner.
    """
    size = float((high - low).max()) / FIRST_CELLS
    counts = np.maximum(1, np.ceil((high - low) / size - 1e-9)).astype(int)
    cells = np.stack(np.meshgrid(*map(np.arange, counts), indexing="ij"), -1).reshape(-1, 3)
    for level in range(HALVINGS + 1):
        here = _distances(shape, low + size * (cells + 0.5))
        cells = cells[np.abs(here) <= size]  # half a diagonal is 0.87 of a side
        if level < HALVINGS:
            cells = (2 * cells[:, None, :] + _CORNERS).reshape(-1, 3)
            size *= 0.5
    if not len(cells):
        return None
    return _netted(shape, low, size, cells)


def _distances(shape: Any, points: Array) -> Array:
    return np.array([signed_distance(shape, Vec(*p)) for p in points.tolist()], dtype=float)


def _netted(shape: Any, low: Array, size: float, cells: Cells) -> Drawable | None:
    corners = (cells[:, None, :] + _CORNERS).reshape(-1, 3)
    unique, back = np.unique(corners, axis=0, return_inverse=True)
    inside = (_distances(shape, low + size * unique) < 0.0)[back.reshape(-1, 8)]
    crossed = inside.any(axis=1) & ~inside.all(axis=1)
    cells, inside = cells[crossed], inside[crossed]
    triangles = _faces(cells, inside)
    if not len(triangles):
        return None
    vertices, normals = _laid(shape, low + size * (cells + 0.5))
    return Drawable("mesh", type(shape).__name__, vertices=vertices, triangles=triangles,
                    normals=normals)  # fmt: skip


def _laid(shape: Any, points: Array) -> tuple[Array, Array]:
    """Points moved onto the surface along the normal, and the normals there."""
    n = np.zeros_like(points)
    for _ in range(2):
        n = np.array([outward_normal(shape, Vec(*p)) for p in points.tolist()], dtype=float)
        points = points - _distances(shape, points)[:, None] * n
    return points, n


def _faces(cells: Cells, inside: Any) -> Cells:
    """Two triangles for each edge of the grid with ends on either side of the surface."""
    number = {tuple(cell): k for k, cell in enumerate(cells.tolist())}
    found: list[tuple[int, int, int]] = []
    for axis in range(3):
        b, c = (axis + 1) % 3, (axis + 2) % 3
        # The edge from corner 0 along the axis is shared with the cells below in b and c.
        first, second = inside[:, 0], inside[:, 1 << axis]
        for k in np.flatnonzero(first != second).tolist():
            around = []
            for db, dc in ((0, 0), (-1, 0), (-1, -1), (0, -1)):
                neighbour = cells[k].copy()
                neighbour[b] += db
                neighbour[c] += dc
                around.append(number.get(tuple(neighbour.tolist()), -1))
            if min(around) >= 0:
                p, q, r, s = around if first[k] else around[::-1]
                found += [(p, q, r), (p, r, s)]
    return np.array(found, dtype=np.intp).reshape(-1, 3)

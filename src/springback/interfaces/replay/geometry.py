"""Drawable obstacles: rectangles for walls, mats and the ground, else meshes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.contact.parameters import Ground, Mat, Wall
from springback.contact.worlds import Own
from springback.results.meshes import Mesh, surfaces_of

Array = np.ndarray[Any, np.dtype[np.float64]]
Cells = np.ndarray[Any, np.dtype[np.intp]]

#: Margin of a drawn face around the flight near it, and its smallest and largest side [m]
#: (chosen: a piece of wall, not all of it).
ROOM, LEAST_SIDE, LARGEST_SIDE = 0.6, 1.6, 20.0
#: A face counts as horizontal if the vertical component of its normal exceeds this.
LYING = 0.9


class Drawable(NamedTuple):
    """A rectangle or a mesh to draw.

    A rectangle has a centre, an outward normal and its half sides, and the material behind it is
    ``thickness`` deep, or unlimited if that is 0.  A mesh has vertices and triangles, anticlockwise
    as seen from outside.
    """

    kind: str  # wall, mat, ground or mesh
    name: str  # for a legend
    centre: tuple[float, ...] = ()  # world [m]
    normal: tuple[float, ...] = ()  # unit vector, world
    across: tuple[float, ...] = ()  # half a side, world [m]
    along: tuple[float, ...] = ()  # half the other side, upwards if the face is upright, world [m]
    thickness: float = 0.0  # [m]
    vertices: Array | None = None  # world [m], shape (vertices, 3)
    triangles: Cells | None = None  # shape (triangles, 3)
    normals: Array | None = None  # at the vertices, shape (vertices, 3)


class DrawnWorld(NamedTuple):
    """Drawable obstacles, and remarks about them."""

    drawables: tuple[Drawable, ...]
    notes: tuple[str, ...]


def drawables(
    obstacles: Sequence[Wall | Ground | Mat],
    own: Sequence[Own],
    flown: Array,
    near: Array,
    stored: Sequence[Mesh] = (),
) -> DrawnWorld:
    """All obstacles as drawables.

    Args:
        obstacles: Obstacles of the scenario.
        own: The user's own shapes, with their surfaces.
        flown: Positions of the vehicle, world [m], shape (instants, 3).
        near: Contact points, world [m], shape (touches, 3), possibly none.
        stored: Meshes of the user's own shapes read from a file, used if ``own`` is empty.
    """
    levels = [entry.height for entry in obstacles if isinstance(entry, Ground)]
    floor = max((z for z in levels if z <= flown[:, 2].min()), default=None)
    things = [_face(entry, flown, floor) for entry in obstacles]
    notes = []
    for one in surfaces_of(own, near if len(near) else flown) if own else stored:
        if len(one.triangles):
            things.append(Drawable("mesh", one.name, vertices=one.vertices,
                                   triangles=one.triangles, normals=one.normals))  # fmt: skip
        else:
            notes.append(f"{one.name} is not drawn: none of its surface was found near the flight")
    return DrawnWorld(tuple(things), tuple(notes))


def _face(entry: Wall | Ground | Mat, flown: Array, floor: float | None) -> Drawable:
    """Rectangle of a face around the flight near it; an upright one extends down to the floor."""
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
        halves.append(_floats(0.5 * side * axis))
    across, along = halves
    return Drawable(entry.type, entry.type, _floats(centre), _floats(n), across, along, thickness)


def _floats(v: Array) -> tuple[float, ...]:
    return tuple(map(float, v))


def _axes(n: Array) -> tuple[Array, Array]:
    """Two unit vectors in a face: horizontal and upwards; in a horizontal face, near X and Y."""
    up = np.array([0.0, 0.0, 1.0]) if abs(n[2]) < LYING else np.array([0.0, 1.0, 0.0])
    across = np.cross(up, n)
    across /= np.linalg.norm(across)
    return across, np.cross(n, across)

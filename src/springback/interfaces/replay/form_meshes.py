"""Meshes of measured shapes for drawings: height maps, triangles of files, cells, and nets."""

from __future__ import annotations

from typing import Any

import numpy as np

from springback.contact.grids.distance_grids import spline_values
from springback.contact.grids.measured_shapes import HeightMap, MeshBody, OccupancyGrid
from springback.contact.scene.solids import CAPSULE
from springback.contact.shapes import SolidShape
from springback.interfaces.replay.shape_meshes import ShapeMesh, as_one, mesh_of_body

Array = np.ndarray[Any, np.dtype[np.float64]]
Cells = np.ndarray[Any, np.dtype[np.intp]]

#: Most triangles of one shape, and most points of a height map along a side (chosen: a page of some
#: MB).
MOST_TRIANGLES, MOST_ALONG = 20_000, 90
#: Threads of a net along its longer side, their radius [m], and sides of each (chosen).
THREADS, THREAD_RADIUS, THREAD_SIDES = 16, 0.003, 8


def in_place(mesh: ShapeMesh, body: SolidShape) -> ShapeMesh:
    """A mesh in the axes of a body, from its centre, in world axes."""
    return ShapeMesh(body.centre + mesh.vertices @ body.axes, mesh.triangles)


def heights_mesh(shape: HeightMap) -> ShapeMesh:
    """Surface of the ground, its sides and its bottom, from the centre of its box."""
    form = shape.form()
    (half_x, half_y, half_z), count = form.half, np.array(form.spline.shape) - 2
    many = np.clip(3 * (count - 1) + 1, 2, MOST_ALONG)
    places = np.meshgrid(*(np.linspace(0, n - 1, k) for n, k in zip(count, many, strict=True)),
                         indexing="ij")  # fmt: skip
    z = spline_values(form.spline, places) - form.middle
    x, y = (
        2.0 * h * p / (n - 1) - h for h, p, n in zip((half_x, half_y), places, count, strict=True)
    )
    top = np.stack([x, y, z], axis=-1).reshape(-1, 3)
    number = np.arange(len(top)).reshape(z.shape)
    a, b = number[:-1, :-1].ravel(), number[1:, :-1].ravel()
    c, d = number[1:, 1:].ravel(), number[:-1, 1:].ravel()
    rim = np.concatenate([number[:-1, 0], number[-1, :-1], number[:0:-1, -1], number[0, :0:-1]])
    low = top[rim] * [1.0, 1.0, 0.0] + [0.0, 0.0, -half_z]
    foot = len(top) + np.arange(len(rim))
    before, after = np.arange(len(rim)), np.roll(np.arange(len(rim)), -1)
    middle = len(top) + len(rim)
    faces = [(a, b, c), (a, c, d), (foot[before], foot[after], rim[after]),
             (foot[before], rim[after], rim[before]),
             (np.full(len(rim), middle), foot[after], foot[before])]  # fmt: skip
    vertices = np.concatenate([top, low, [[0.0, 0.0, -half_z]]])
    return ShapeMesh(vertices, np.concatenate([np.stack(one, axis=1) for one in faces]))


def mesh_body_mesh(shape: MeshBody) -> ShapeMesh:
    """The file's own triangles, fewer of them if they are too many, from the centre of the grid."""
    found = shape.triangles()
    mesh = ShapeMesh(found.vertices - shape.form().centre, found.faces)
    extent = float(np.ptp(mesh.vertices, axis=0).max())
    parts = 256
    while len(mesh.triangles) > MOST_TRIANGLES and parts > 8:
        mesh, parts = _merged(mesh, extent / parts), parts // 2
    return mesh


def _merged(mesh: ShapeMesh, size: float) -> ShapeMesh:
    """A mesh whose vertices in one cell are one, at their mean; its flat triangles are dropped."""
    cells = np.floor(mesh.vertices / size).astype(np.int64)
    _, back, count = np.unique(cells, axis=0, return_inverse=True, return_counts=True)
    back = back.reshape(-1)
    sums = np.zeros((len(count), 3))
    np.add.at(sums, back, mesh.vertices)
    faces = back[mesh.triangles]
    a, b, c = faces.T
    return ShapeMesh(sums / count[:, None], faces[(a != b) & (b != c) & (c != a)])


def cells_mesh(shape: OccupancyGrid) -> ShapeMesh:
    """Faces between occupied and free cells, of larger cells if there are too many."""
    cells, form = shape.cells(), shape.form()
    occupied, size = np.asarray(cells.occupied), cells.cell
    faces = _cell_faces(occupied)
    while 2 * len(faces) > MOST_TRIANGLES and min(occupied.shape) > 1:
        occupied, size = _coarser(occupied), 2.0 * size
        faces = _cell_faces(occupied)
    corners, back = np.unique(faces.reshape(-1, 3), axis=0, return_inverse=True)
    a, b, c, d = back.reshape(-1, 4).T
    triangles = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return ShapeMesh(corners * size + cells.low - form.centre, triangles)


def _coarser(occupied: Any) -> Any:
    """Cells of twice the length, occupied if one of their parts is."""
    even = np.pad(occupied, [(0, n % 2) for n in occupied.shape])
    x, y, z = (n // 2 for n in even.shape)
    return even.reshape(x, 2, y, 2, z, 2).any(axis=(1, 3, 5))


def _cell_faces(occupied: Any) -> Array:
    """Corners of the outer faces of occupied cells, anticlockwise from outside, in cells."""
    padded, found = np.pad(occupied, 1), []
    for axis in range(3):
        u, v = np.eye(3)[(axis + 1) % 3], np.eye(3)[(axis + 2) % 3]
        for sign in (1, -1):
            beside = np.roll(padded, -sign, axis=axis)
            low = np.argwhere(padded & ~beside) - 1.0
            if sign > 0:
                low = low + np.eye(3)[axis]
                loop = [low, low + u, low + u + v, low + v]
            else:
                loop = [low, low + v, low + u + v, low + u]
            found.append(np.stack(loop, axis=1))
    return np.concatenate(found)


def net_mesh(body: SolidShape) -> ShapeMesh:
    """Threads of a net in its face."""
    half_x, half_y = body.sizes[0], body.sizes[1]
    apart = 2.0 * max(half_x, half_y) / THREADS
    threads = []
    for axis, (along, across) in enumerate(((half_x, half_y), (half_y, half_x))):
        count = max(1, round(2.0 * across / apart))
        ez, ex = body.axes[axis], body.axes[1 - axis]
        axes = np.array([ex, np.cross(ez, ex), ez])
        for place in np.linspace(-across, across, count + 1):
            centre = body.centre + place * ex - THREAD_RADIUS * body.axes[2]
            sizes = (along, THREAD_RADIUS)
            one = SolidShape(CAPSULE, centre, axes, sizes, 0.0)
            threads.append(mesh_of_body(one, sides=THREAD_SIDES))
    return as_one(threads)

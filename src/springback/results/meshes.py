"""Meshes of the user's own obstacles, for files and drawings.

Their code is not in a result, so a saved flight contains their surface near the flight.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.contact.obstacles import outward_normal, signed_distance
from springback.contact.worlds import Own
from springback.errors import InputError
from springback.kernels.vectors import Vec

Array = np.ndarray[Any, np.dtype[np.float64]]
Cells = np.ndarray[Any, np.dtype[np.intp]]

#: Distance from contacts, or else from the trajectory, within which a shape is searched [m] ...
SEARCHED = 1.2
#: ... in cells that are halved this many times; chosen: the last are 4 cm wide.
HALVINGS, FIRST_CELLS = 3, 8
#: A surface is flat around a vertex within this [m] (chosen: the diagonal of such a cell).
REACH = 0.07
#: Decimal digits of a metre that a file stores (chosen).
DIGITS = 5

_CORNERS = np.array([[(k >> a) & 1 for a in range(3)] for k in range(8)])
_NO_CELLS: Cells = np.zeros((0, 3), dtype=np.intp)


class Mesh(NamedTuple):
    """Surface of a shape as triangles, counterclockwise as seen from outside."""

    name: str  # of the shape's type
    vertices: Array  # world [m], shape (vertices, 3)
    triangles: Cells  # shape (triangles, 3); empty if no surface was found
    normals: Array  # at the vertices, unit vectors, shape (vertices, 3)

    def as_dict(self) -> dict[str, Any]:
        """Plain data, for JSON."""
        return {
            "name": self.name,
            "vertices": np.round(self.vertices, DIGITS).tolist(),
            "triangles": self.triangles.tolist(),
            "normals": np.round(self.normals, DIGITS).tolist(),
        }

    def distance(self, point: Array) -> float:
        """Signed distance of a point near the surface [m], negative inside.

        Args:
            point: World [m].
        """
        if not len(self.vertices):
            return float("inf")
        away = point - self.vertices
        nearest = int(np.argmin((away**2).sum(axis=1)))
        far, along = np.linalg.norm(away[nearest]), away[nearest] @ self.normals[nearest]
        return float(along if far < REACH else far)


def surfaces_of(own: Sequence[Own], near: Array) -> tuple[Mesh, ...]:
    """Surfaces of shapes around some points.

    Args:
        own: Pairs of a shape and its contact law.
        near: World [m], shape (points, 3), at least one.
    """
    low, high = near.min(axis=0) - SEARCHED, near.max(axis=0) + SEARCHED
    return tuple(surface_of(shape, low, high) for shape, _ in own)


def read_surfaces(given: Any, where: str) -> tuple[Mesh, ...]:
    """Surfaces from plain data.

    Args:
        given: A list of dictionaries from `Mesh.as_dict`.
        where: Place, for errors.

    Raises:
        InputError: If it is something else.
    """
    try:
        return tuple(_read(entry) for entry in given)
    except (TypeError, ValueError, KeyError, AttributeError):
        raise InputError(f"{where}: must be a list of surfaces as springback writes them") from None


def _read(entry: Mapping[str, Any]) -> Mesh:
    vertices, normals = (
        np.array(entry[key], dtype=float).reshape(-1, 3) for key in ("vertices", "normals")
    )
    triangles = np.array(entry["triangles"], dtype=np.intp).reshape(-1, 3)
    inside = not triangles.size or (triangles.min() >= 0 and triangles.max() < len(vertices))
    if not inside or len(normals) != len(vertices) or not np.isfinite(vertices).all():
        raise ValueError
    return Mesh(str(entry["name"])[:60], vertices, triangles, normals)


def surface_of(shape: Any, low: Array, high: Array) -> Mesh:
    """Surface of a shape inside a box, as triangles; empty if there is none.

    Cells that the surface cannot reach, by their distance, are dropped before the remaining ones
    are halved.  Each of the last cells that the surface passes through has one vertex, projected to
    the surface along the normal, and every edge that it crosses becomes a face ("surface nets", S.
    F. F. Gibson, 1998).

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
    found = _mesh(shape, low, size, cells) if len(cells) else None
    nothing = Mesh(type(shape).__name__, np.zeros((0, 3)), _NO_CELLS, np.zeros((0, 3)))
    return found or nothing


def _distances(shape: Any, points: Array) -> Array:
    return np.array([signed_distance(shape, Vec(*p)) for p in points.tolist()], dtype=float)


def _mesh(shape: Any, low: Array, size: float, cells: Cells) -> Mesh | None:
    corners = (cells[:, None, :] + _CORNERS).reshape(-1, 3)
    unique, back = np.unique(corners, axis=0, return_inverse=True)
    inside = (_distances(shape, low + size * unique) < 0.0)[back.reshape(-1, 8)]
    crossed = inside.any(axis=1) & ~inside.all(axis=1)
    cells, inside = cells[crossed], inside[crossed]
    triangles = _faces(cells, inside)
    if not len(triangles):
        return None
    vertices, normals = _project(shape, low + size * (cells + 0.5))
    return Mesh(type(shape).__name__, vertices, triangles, normals)


def _project(shape: Any, points: Array) -> tuple[Array, Array]:
    """Points projected to the surface along the normal, and the normals there."""
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

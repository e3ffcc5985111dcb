"""Meshes of a vehicle's hulls, for pictures."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from scipy.spatial import ConvexHull

from springback.vehicle.hulls import CIRCLE, HullForm
from springback.vehicle.parameters import Vehicle

Array = np.ndarray[Any, np.dtype[np.float64]]
Cells = np.ndarray[Any, np.dtype[np.intp]]

#: Chosen: sides of a full circle, of a ring and on a ball, and half the thickness of a ring [m].
SIDES, WIRE = 48, 0.002


class HullMesh(NamedTuple):
    """Surface of one hull as triangles, anticlockwise from outside.

    Points are from the main body, or from the end of the hull's arm, in body axes.
    """

    vertices: Array  # [m], shape (vertices, 3)
    triangles: Cells  # shape (triangles, 3)


def hull_meshes(vehicle: Vehicle, part: str | int) -> tuple[HullMesh, ...]:
    """Meshes of the hulls on the main body, "body", or on an arm, from 1.

    A spherical hull alone (`Vehicle.hull`) is not among them.
    """
    return tuple(mesh_of_hull(one.form()) for one in vehicle.hulls_on(part))


def mesh_of_hull(form: HullForm) -> HullMesh:
    """Mesh of one hull; round parts are inscribed."""
    if form.kind == CIRCLE:
        return _tube(form)
    points = form.points
    if form.radius > 0.0:
        points = (points[:, None, :] + form.radius * _directions()).reshape(-1, 3)
    hull = ConvexHull(points)
    kept = np.unique(hull.simplices)
    number = np.zeros(len(points), dtype=np.intp)
    number[kept] = np.arange(len(kept))
    cells, at = number[hull.simplices], points[kept]
    a, b, c = (at[cells[:, k]] for k in range(3))
    inwards = np.einsum("ij,ij->i", np.cross(b - a, c - a), hull.equations[:, :3]) < 0.0
    cells[inwards] = cells[inwards][:, ::-1]
    return HullMesh(at, cells)


def _directions() -> Array:
    """Unit vectors all around, shape (directions, 3)."""
    up = np.linspace(-0.5 * np.pi, 0.5 * np.pi, SIDES // 2 + 1)[:, None]
    round_ = np.linspace(0.0, 2.0 * np.pi, SIDES, endpoint=False)[None, :]
    flat = np.cos(up)
    return np.stack(
        [flat * np.cos(round_), flat * np.sin(round_), np.sin(up) + 0.0 * round_], axis=2
    ).reshape(-1, 3)


def _tube(form: HullForm) -> HullMesh:
    """A thin tube along a circle."""
    angles = np.linspace(0.0, 2.0 * np.pi, SIDES, endpoint=False)
    around = np.linspace(0.0, 2.0 * np.pi, 6, endpoint=False)
    x, y, z = form.axes
    outward = np.cos(angles)[:, None] * x + np.sin(angles)[:, None] * y
    section = (
        np.cos(around)[None, :, None] * outward[:, None, :] + np.sin(around)[None, :, None] * z
    )
    points = form.centre + form.radius * outward[:, None, :] + WIRE * section
    cells = []
    for i in range(SIDES):
        for k in range(6):
            a, b = 6 * i + k, 6 * i + (k + 1) % 6
            c, d = (6 * (i + 1) + k) % (6 * SIDES), (6 * (i + 1) + (k + 1) % 6) % (6 * SIDES)
            cells += [(a, c, b), (b, c, d)]
    return HullMesh(points.reshape(-1, 3), np.array(cells, dtype=np.intp))

"""Thickness of the thinnest parts of a body: of balls between sides that face away from each other.

From points of the surface balls are shrunk until no point of an opposite side is within them.
After J. Ma, S. W. Bae and S. Choi, "3D medial axis point approximation using nearest neighbors and
the normal field", The Visual Computer 28 (2012), whose balls touch any side.
"""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import scipy  # submodules are loaded on first use

from springback.contact.grids.mesh_distance import SurfacePoints
from springback.contact.grids.mesh_files import Triangles
from springback.random_streams import Purpose, stream

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Points from which balls are shrunk, and most steps of each (chosen).
PROBES, STEPS = 1000, 20
#: Least cosine between the normal of a side and the reverse of those opposite to it (chosen).
OPPOSITE = 0.7
#: Share of the surface that is thinner (chosen: tips of wedges are no parts).
SHARE = 0.02
#: Error of the thickness (chosen: the search is many times as fast).
NEARLY = 0.02
#: Spacings of the surface's points within the thinnest part (chosen).
SPACINGS = 3.0
#: Directions by which sides are told apart: to sides, edges and corners of a cube.
_DIRECTIONS = np.array([v for v in itertools.product((-1.0, 0.0, 1.0), repeat=3) if any(v)])
_DIRECTIONS /= np.linalg.norm(_DIRECTIONS, axis=1)[:, None]


def thinnest_part(mesh: Triangles, apart: float) -> float:
    """Thickness of the thinnest parts [m]; infinite if no two sides face away from each other.

    Args:
        mesh: Closed, or of `union_surface`, faces anticlockwise from outside [m].
        apart: Spacing of the surface's points [m]; thinner parts are looked at more closely.
    """
    found = _thinnest(mesh, apart)
    if found < SPACINGS * apart:
        return _thinnest(mesh, max(found / SPACINGS, 0.2 * apart))
    return found


def _thinnest(mesh: Triangles, apart: float) -> float:
    surface = SurfacePoints(mesh, apart)
    normals, areas = _faces(mesh)
    share = (areas / np.bincount(surface.owners, minlength=len(areas)))[surface.owners]
    ends = np.cumsum(share)
    chosen = np.searchsorted(ends, stream(0, Purpose.POINTS).uniform(0.0, ends[-1], PROBES))
    points, outward = surface.tree.data, normals[surface.owners]
    side = np.argmax(outward[chosen] @ _DIRECTIONS.T, axis=1)
    thick = [
        _ball_sizes(
            points[chosen[side == k]], -outward[chosen[side == k]],
            points[outward @ direction < -OPPOSITE],
        )
        for k, direction in enumerate(_DIRECTIONS)
    ]  # fmt: skip
    least = math.ceil(SHARE * PROBES)
    return float(np.sort(np.concatenate(thick))[least - 1])


def _ball_sizes(points: Array, inward: Array, opposite: Array) -> Array:
    """Diameters of balls that touch a side at some points and reach an opposite one [m]."""
    size = np.full(len(points), math.inf)
    if not len(points) or not len(opposite):
        return size
    tree = scipy.spatial.cKDTree(opposite)
    moving, centre = np.arange(len(points)), points
    within = np.full(len(points), math.inf)
    for _ in range(STEPS):
        distance, k = tree.query(centre, eps=NEARLY)
        way, n = opposite[k] - points[moving], inward[moving]
        depth = np.einsum("ij,ij->i", way, n)
        smaller = (distance < within) & (depth > 0.0)
        moving, way, n, depth = moving[smaller], way[smaller], n[smaller], depth[smaller]
        if not len(moving):
            break
        radius = 0.5 * np.einsum("ij,ij->i", way, way) / depth
        size[moving] = 2.0 * radius
        centre, within = points[moving] + radius[:, None] * n, radius * (1.0 - NEARLY)
    return size


def _faces(mesh: Triangles) -> tuple[Array, Array]:
    """Outward unit normals and areas of triangles."""
    a, b, c = np.moveaxis(mesh.corners, 1, 0)
    across = np.cross(b - a, c - a)
    twice = np.linalg.norm(across, axis=1)
    return across / np.where(twice > 0.0, twice, 1.0)[:, None], 0.5 * twice

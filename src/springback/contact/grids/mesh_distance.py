"""Distances of many points from a surface of triangles.

Points of the surface, at most a cell apart, are put into a tree; the triangles of those nearest to
a point are the candidates for the nearest triangle, and the distance to each is exact.  A triangle
that is left out has no point of those nearest, so what it could shorten is less than the square of
their spacing over twice the distance; the tests compare with all triangles.  A distance is never
less than the true one, and far away more by less than 1 % outside and 3 % inside.
"""

from __future__ import annotations

import os
from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.contact.grids.mesh_files import Triangles

Array = np.ndarray[Any, np.dtype[np.float64]]
Cells = np.ndarray[Any, np.dtype[np.intp]]

#: Candidates for the nearest triangle of a point near the surface, and cells within which it counts
#: as near (chosen).
CANDIDATES, BAND = 16, 3.0
#: Spacing of the points that are looked at far away, where triangles are of any sizes, in cells
#: (chosen: four times as fast as all points).
THINNED = 0.5
#: Points looked at together (chosen: some 100 MB).
BLOCK = 20_000
#: Most points of a triangle along its sides (chosen).
MOST_ALONG = 400

_AROUND = np.array([[0, 0, 0], [1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]])


class NearestTriangles(NamedTuple):
    """Nearest triangle of each of some points."""

    distance: Array  # [m]; infinite if none was found
    owner: Cells  # number of the triangle; −1 if none was found


class SurfacePoints:
    """Points of a surface, at most some length apart, and the triangle of each."""

    def __init__(self, mesh: Triangles, apart: float) -> None:
        """Points of a mesh.

        Args:
            mesh: The surface.
            apart: Their spacing [m].
        """
        self.corners = mesh.corners
        longest = np.linalg.norm(self.corners - np.roll(self.corners, 1, axis=1), axis=2).max(
            axis=1
        )
        along = np.clip(np.ceil(longest / apart), 1, MOST_ALONG).astype(np.intp)
        places, owners = [], []
        for n in np.unique(along):
            shares = _shares(int(n))
            of = np.flatnonzero(along == n)
            places.append(np.einsum("sk,fkd->fsd", shares, self.corners[of]).reshape(-1, 3))
            owners.append(np.repeat(of, len(shares)))
        self.owners = np.concatenate(owners)
        self.tree = scipy.spatial.cKDTree(np.concatenate(places))

    def nearest(self, points: Array, within: float) -> NearestTriangles:
        """Nearest triangle of each point that is near the surface.

        Args:
            points: Shape (points, 3) [m].
            within: Distance from the points of the surface up to which triangles are found [m].
        """
        distance, owner = np.full(len(points), np.inf), np.full(len(points), -1, dtype=np.intp)
        most = min(CANDIDATES, len(self.owners))
        for part in np.array_split(np.arange(len(points)), max(1, len(points) // BLOCK)):
            _, k = self.tree.query(
                points[part], k=most, distance_upper_bound=within, workers=os.cpu_count() or 1
            )
            k = np.asarray(k).reshape(len(part), most)
            owners = np.append(self.owners, -1)[k]
            self.take(points, part, owners, distance, owner)
        return NearestTriangles(distance, owner)

    def take(
        self, points: Array, part: Cells, owners: Cells, distance: Array, owner: Cells
    ) -> None:
        """Take the nearest of some triangles for each point, where it is nearer than before.

        Args:
            points: All points [m].
            part: Numbers of those that are looked at.
            owners: Candidates for each of them; −1 for none, shape (of those, candidates).
            distance: Of all points, changed here [m].
            owner: Nearest triangle of all points, changed here.
        """
        owners = np.sort(owners, axis=1)
        new = owners >= 0
        new[:, 1:] &= owners[:, 1:] != owners[:, :-1]
        row, column = np.nonzero(new)
        which = owners[row, column]
        square = squares_to(points[part[row]], self.corners[which])
        order = np.lexsort((square, row))
        row, which, square = row[order], which[order], square[order]
        first = np.ones(len(row), dtype=bool)
        first[1:] = row[1:] != row[:-1]
        at, found = part[row[first]], np.sqrt(square[first])
        nearer = found < distance[at]
        distance[at[nearer]], owner[at[nearer]] = found[nearer], which[first][nearer]

    def grid_distances(self, nodes: Array, cell: float) -> Array:
        """Distance of every node of a grid from the surface, without a sign [m].

        Near the surface the nearest triangle is looked for; a node farther away takes those of the
        nearest node there, and of its neighbours.

        Args:
            nodes: Shape (nodes along x, y, z, 3) [m].
            cell: Length of a cell [m].
        """
        shape, points = nodes.shape[:3], nodes.reshape(-1, 3)
        distance, owner = self.nearest(points, (BAND + 1.0) * cell)
        near = (distance <= BAND * cell).reshape(shape)
        at = scipy.ndimage.distance_transform_edt(
            ~near, return_distances=False, return_indices=True
        )
        far = np.flatnonzero(~near)
        places = np.stack([one.reshape(-1)[far] for one in at], axis=1)
        owners = owner.reshape(shape)
        for part in np.array_split(np.arange(len(far)), max(1, len(far) // BLOCK)):
            around = places[part][:, None, :] + _AROUND
            around = np.clip(around, 0, np.array(shape) - 1)
            candidates = owners[around[..., 0], around[..., 1], around[..., 2]]
            self.take(points, far[part], candidates, distance, owner)
        return distance.reshape(shape)

    def distances(self, points: Array, cell: float) -> Array:
        """Distance of points anywhere from the surface, of triangles of any sizes [m].

        Far away the triangles of some nearest points count: what they are too far is of the order
        of the square of a cell over twice the distance.

        Args:
            points: Shape (points, 3) [m].
            cell: Length of a cell [m].
        """
        distance, owner = self.nearest(points, (BAND + 1.0) * cell)
        far = np.flatnonzero(distance > BAND * cell)
        places = self.tree.data
        each = np.unique(np.floor(places / (THINNED * cell)), axis=0, return_index=True)[1]
        tree, most = scipy.spatial.cKDTree(places[each]), min(CANDIDATES, len(each))
        for part in np.array_split(far, max(1, len(far) // BLOCK)):
            _, k = tree.query(points[part], k=most, workers=os.cpu_count() or 1)
            owners = self.owners[each[np.asarray(k).reshape(len(part), most)]]
            self.take(points, part, owners, distance, owner)
        return distance


def _shares(n: int) -> Array:
    """Barycentric shares of the middles of the n² parts of a triangle, shape (n², 3)."""
    i, j = np.meshgrid(np.arange(n), np.arange(n), indexing="ij")
    upright = i + j < n
    a, b = i[upright] + 1.0 / 3.0, j[upright] + 1.0 / 3.0
    turned = i + j < n - 1
    a = np.concatenate([a, i[turned] + 2.0 / 3.0]) / n
    b = np.concatenate([b, j[turned] + 2.0 / 3.0]) / n
    return np.stack([1.0 - a - b, a, b], axis=1)


def _dot(a: Array, b: Array) -> Array:
    return np.asarray(np.einsum("ij,ij->i", a, b))


def squares_to(points: Array, corners: Array) -> Array:
    """Square of the distance of each point from one triangle [m²].

    The foot on the plane counts if it is inside, else the nearest foot on the three sides.

    Args:
        points: Shape (pairs, 3) [m].
        corners: Shape (pairs, 3, 3) [m].
    """
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    normal = np.cross(b - a, c - a)
    size = _dot(normal, normal)
    best, within = np.full(len(points), np.inf), size > 0.0
    for p, q in ((a, b), (b, c), (c, a)):
        side, away = q - p, points - p
        length = _dot(side, side)
        share = np.clip(_dot(away, side) / np.where(length > 0.0, length, 1.0), 0.0, 1.0)
        left = away - share[:, None] * side
        best = np.minimum(best, _dot(left, left))
        within &= _dot(np.cross(side, away), normal) >= 0.0
    lift = _dot(points - a, normal)
    level = lift * lift / np.where(size > 0.0, size, 1.0)
    return np.asarray(np.where(within, level, best))

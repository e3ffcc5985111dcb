"""Meshes that bound a body: each edge has a face on either side, and all agree which is out."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from springback.contact.grids.mesh_files import Triangles
from springback.settings import problem

Array = np.ndarray[Any, np.dtype[np.float64]]
Cells = np.ndarray[Any, np.dtype[np.intp]]

#: Smallest extent of a mesh, as a share of its largest: thinner ones are no bodies (chosen).
FLAT = 1e-9
#: Pairs of points and faces looked at together, fewest and most columns along an axis, and most
#: faces in all columns (chosen: some 100 MB each).
PAIRS, FEWEST_COLUMNS, MOST_COLUMNS, MOST_IN_COLUMNS = 300_000, 50, 1000, 10_000_000


def closed_mesh(file: str, mesh: Triangles) -> Triangles:
    """The mesh, with its faces anticlockwise from outside.

    Args:
        file: Of the mesh, for errors.
        mesh: Its triangles.

    Raises:
        The problem, if it has no size, open edges, or faces that disagree with their neighbours.
    """
    extent = np.ptp(mesh.vertices[mesh.faces.ravel()], axis=0)
    if not extent.min() > FLAT * extent.max():
        sizes = " x ".join(f"{length:.4g}" for length in extent)
        raise problem(f"{file}: must have a size along each axis (got {sizes})", "file")
    edges = np.concatenate([mesh.faces[:, [0, 1]], mesh.faces[:, [1, 2]], mesh.faces[:, [2, 0]]])
    ahead = edges[:, 0] < edges[:, 1]
    key = edges.min(axis=1) * np.int64(len(mesh.vertices)) + edges.max(axis=1)
    unique, back = np.unique(key, return_inverse=True)
    sides = np.bincount(back.reshape(-1), minlength=len(unique))
    balance = np.bincount(back.reshape(-1), weights=np.where(ahead, 1.0, -1.0))
    if opened := int(((sides % 2) == 1).sum()):
        raise problem(
            f"{file}: is open: {opened} of {len(unique)} edges have a face on one side only; a "
            "body needs a closed surface",
            "file",
        )
    if turned := int((balance != 0.0).sum()):
        raise problem(
            f"{file}: has inverted faces: at {turned} of {len(unique)} edges two faces disagree on "
            "which side is outside",
            "file",
        )
    volume = signed_volume(mesh)
    if abs(volume) <= FLAT * float(extent.prod()):
        raise problem(f"{file}: must enclose a volume (got {volume:.3g} in its units)", "file")
    return mesh if volume > 0.0 else Triangles(mesh.vertices, mesh.faces[:, ::-1])


def signed_volume(mesh: Triangles) -> float:
    """Volume that a closed mesh encloses, negative if all its faces are inside out."""
    a, b, c = np.moveaxis(mesh.corners - mesh.vertices.mean(axis=0), 1, 0)
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6.0)


def inside(mesh: Triangles, axes: tuple[Array, Array, Array]) -> Array:
    """True for the nodes of a grid that are inside a closed mesh.

    Along each line parallel to z the faces above a node are counted, those that face upwards as 1,
    those downwards as −1: its winding number.  Lines that pass exactly through an edge belong to
    one of its faces, as if they were moved by an infinitely small distance.

    Args:
        mesh: A closed mesh.
        axes: Coordinates of the nodes along x, y and z [m].
    """
    x, y, z = axes
    count = np.zeros((len(x), len(y), len(z) + 1), dtype=np.int32)
    corners = mesh.corners
    for part in np.array_split(corners, max(1, len(corners) // 20_000)):
        _count_crossings(part, axes, count)
    return np.asarray(np.cumsum(count[:, :, ::-1], axis=2)[:, :, ::-1][:, :, 1:] != 0)


def _count_crossings(corners: Array, axes: tuple[Array, Array, Array], count: Any) -> None:
    """Add the crossings of lines with some faces, each to the first node above it."""
    x, y, z = axes
    low, high = corners[:, :, :2].min(axis=1), corners[:, :, :2].max(axis=1)
    first = np.stack([np.searchsorted(x, low[:, 0]), np.searchsorted(y, low[:, 1])], axis=1)
    last = np.stack(
        [np.searchsorted(x, high[:, 0], "right"), np.searchsorted(y, high[:, 1], "right")], axis=1
    )
    across = last - first
    number = across.prod(axis=1)
    face = np.repeat(np.arange(len(corners)), number)
    if not len(face):
        return
    step = np.arange(len(face)) - np.repeat(np.cumsum(number) - number, number)
    i, j = first[face, 0] + step // across[face, 1], first[face, 1] + step % across[face, 1]
    px, py = x[i], y[j]
    a, b, c = (corners[:, k] for k in range(3))
    sides = [_side(p[face], q[face], px, py) for p, q in ((a, b), (b, c), (c, a))]
    up = (sides[0] > 0) & (sides[1] > 0) & (sides[2] > 0)
    down = (sides[0] < 0) & (sides[1] < 0) & (sides[2] < 0)
    hit = up | down
    face, i, j, px, py = face[hit], i[hit], j[hit], px[hit], py[hit]
    normal = np.cross(b - a, c - a)[face]
    lift = normal[:, 0] * (px - a[face, 0]) + normal[:, 1] * (py - a[face, 1])
    height = a[face, 2] - lift / normal[:, 2]
    np.add.at(count, (i, j, np.searchsorted(z, height)), np.where(up[hit], 1, -1))


def winding_numbers(mesh: Triangles, points: Array) -> Cells:
    """Winding number of a closed mesh about points: 0 outside, 1 in a body, 2 in two at once.

    Faces above each point are counted as in `inside`; they are sought in columns along z.

    Args:
        mesh: A closed mesh.
        points: Shape (points, 3) [m].
    """
    found, columns = np.zeros(len(points), dtype=np.intp), _columns_of(mesh)
    column = columns.of(points)
    at = np.flatnonzero(column >= 0)
    number = columns.ends[column[at] + 1] - columns.ends[column[at]]
    ends = np.cumsum(number)
    for part in np.split(at, np.flatnonzero(np.diff(ends // PAIRS)) + 1):
        first = columns.ends[column[part]]
        each = columns.ends[column[part] + 1] - first
        k = np.repeat(part, each)
        step = np.arange(len(k)) - np.repeat(np.cumsum(each) - each, each)
        face = columns.faces[np.repeat(first, each) + step]
        there, low, high = points[k], columns.lowest[face], columns.highest[face]
        over = (high > there).all(axis=1) & (low[:, :2] < there[:, :2]).all(axis=1)
        k, corners = k[over], columns.corners[face[over]]
        x, y, z = points[k].T
        a, b, c = np.moveaxis(corners, 1, 0)
        sides = [_side(p, q, x, y) for p, q in ((a, b), (b, c), (c, a))]
        up = (sides[0] > 0) & (sides[1] > 0) & (sides[2] > 0)
        hit = np.flatnonzero(up | ((sides[0] < 0) & (sides[1] < 0) & (sides[2] < 0)))
        normal = np.cross(b[hit] - a[hit], c[hit] - a[hit])
        lift = normal[:, 0] * (x[hit] - a[hit, 0]) + normal[:, 1] * (y[hit] - a[hit, 1])
        higher = a[hit, 2] - lift / normal[:, 2] > z[hit]
        hit = hit[higher]
        np.add.at(found, k[hit], np.where(up[hit], 1, -1))
    return found


class _Columns(NamedTuple):
    """Columns along z, in a square pattern, and the faces that may be in each."""

    corners: Array  # of all faces [m]
    lowest: Array  # of the boxes of faces [m]
    highest: Array
    low: Array  # of the pattern along x and y [m]
    width: Array  # of a column along x and y [m]
    along: int  # their number along x, and along y
    faces: Cells  # of all columns, one after the other
    ends: Cells  # where those of a column begin, and the last ones end

    def of(self, points: Array) -> Cells:
        """Column of each point; −1 beside them all."""
        place = np.floor((points[:, :2] - self.low) / self.width).astype(np.intp)
        within = ((place >= 0) & (place < self.along)).all(axis=1)
        return np.where(within, place[:, 0] * self.along + place[:, 1], -1)


def _columns_of(mesh: Triangles) -> _Columns:
    """Columns of a mesh: some as many as faces, or fewer if these are in many."""
    corners = mesh.corners
    lowest, highest = corners.min(axis=1), corners.max(axis=1)
    low, high = lowest[:, :2], highest[:, :2]
    origin, most = low.min(axis=0), high.max(axis=0)
    count = min(int(2.0 * np.sqrt(len(corners))) + FEWEST_COLUMNS, MOST_COLUMNS)
    while True:
        width = (most - origin) * (1.0 + 1e-9) / count
        first = np.floor((low - origin) / width).astype(np.intp)
        across = np.floor((high - origin) / width).astype(np.intp) - first + 1
        number = across.prod(axis=1)
        if count == 1 or number.sum() <= MOST_IN_COLUMNS:
            break
        count //= 2
    face = np.repeat(np.arange(len(corners)), number)
    step = np.arange(len(face)) - np.repeat(np.cumsum(number) - number, number)
    i, j = first[face, 0] + step // across[face, 1], first[face, 1] + step % across[face, 1]
    column = i * count + j
    order = np.argsort(column, kind="stable")
    ends = np.searchsorted(column[order], np.arange(count * count + 1))
    return _Columns(corners, lowest, highest, origin, width, count, face[order], ends)


def _side(p: Array, q: Array, x: Array, y: Array) -> Array:
    """Side of an edge that a point is on, 1 or −1, seen from above; the same for both its faces."""
    swapped = (p[:, 0] > q[:, 0]) | ((p[:, 0] == q[:, 0]) & (p[:, 1] > q[:, 1]))
    s, t = np.where(swapped[:, None], q, p), np.where(swapped[:, None], p, q)
    area = (t[:, 0] - s[:, 0]) * (y - s[:, 1]) - (t[:, 1] - s[:, 1]) * (x - s[:, 0])
    # On the edge, a point moved by (ε, ε²): y counts less than x.
    dx, dy = t[:, 0] - s[:, 0], t[:, 1] - s[:, 1]
    sign = np.sign(area) + (area == 0.0) * np.where(dy != 0.0, -np.sign(dy), np.sign(dx))
    return np.asarray(np.where(swapped, -sign, sign))

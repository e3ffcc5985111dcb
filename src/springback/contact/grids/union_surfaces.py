"""Surface of the union of the bodies of a mesh, which may overlap, touch or be nested.

CAD programs export assemblies so: a table top and legs that end in it.  Faces within another body
bound nothing, and distances to them are none.  Triangles of bodies whose boxes touch are split to
the size of a cell; of each piece is asked whether the winding number of the mesh is zero on one of
its sides, and on one only.  Pieces that are partly so are split further, and pieces that agree are
joined again, so a triangle that is not covered anywhere stays as it is.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.contact.grids.closed_meshes import winding_numbers
from springback.contact.grids.mesh_files import Triangles

Array = np.ndarray[Any, np.dtype[np.float64]]
Cells = np.ndarray[Any, np.dtype[np.intp]]

#: Distance from a face at which its sides are looked at, as a share of the mesh's length (chosen:
#: more than what numbers of STL, in single precision, are rounded to).
ASIDE = 1e-6
#: Halvings of a piece along the border of another body (chosen: it is right to an 8th of a cell).
HALVINGS = 3
#: Most halvings of a triangle down to cells, as of the points of a surface (chosen).
MOST_HALVINGS = 9
#: Most bodies whose boxes are compared (chosen: of more, all faces are looked at).
MOST_BODIES = 1500
#: Corners at which a piece is looked at, as shares of the way to them from its middle (chosen).
TO_CORNERS = 0.9

COVERED, OUTER, PARTLY = 0, 1, 2


class _Pieces(NamedTuple):
    """Parts of triangles."""

    corners: Array  # [m], shape (pieces, 3, 3)
    bodies: Cells  # number of the body of each

    def at(self, which: Any) -> _Pieces:
        return _Pieces(self.corners[which], self.bodies[which])


class _Looked(NamedTuple):
    """What was found of some pieces."""

    states: Cells  # of each
    outer: Array  # corners of the outer parts of those that are partly so, shape (parts, 3, 3)
    owners: Cells  # number of the piece of each of these


class _Bodies(NamedTuple):
    """Bodies of a mesh: what hangs together by vertices."""

    of_faces: Cells
    low: Array  # of their boxes [m], shape (bodies, 3)
    high: Array
    beside: list[Cells]  # bodies whose boxes touch that of each; itself, if it touches itself


def union_surface(mesh: Triangles, apart: float) -> Triangles:
    """Surface of the union of a mesh's bodies, as triangles that need not fit together.

    Args:
        mesh: Closed, faces anticlockwise from outside [m].
        apart: Size of the pieces that are looked at [m].

    Returns:
        The mesh itself if none of its faces is within another body.
    """
    search = _Search(mesh, apart)
    looked_at = search.doubtful()
    if not looked_at.any():
        return mesh
    pieces = _Pieces(mesh.corners, search.bodies.of_faces).at(looked_at)
    found = search.look(pieces, 0)
    whole = found.states == OUTER
    if whole.all() or not (whole.any() or len(found.outer)):
        return mesh
    parts = (mesh.corners[~looked_at], pieces.corners[whole], found.outer)
    corners = np.concatenate(parts).reshape(-1, 3)
    return Triangles(corners, np.arange(len(corners)).reshape(-1, 3))


class _Search:
    """Search for the outer parts of a mesh's triangles."""

    def __init__(self, mesh: Triangles, apart: float) -> None:
        self.mesh, self.apart = mesh, apart
        self.aside = ASIDE * float(np.ptp(mesh.vertices, axis=0).max())
        self.bodies = _bodies_of(mesh, self.aside)

    def doubtful(self) -> Any:
        """True for faces of bodies whose boxes touch others."""
        return np.array([len(one) > 0 for one in self.bodies.beside])[self.bodies.of_faces]

    def look(self, pieces: _Pieces, depth: int) -> _Looked:
        """States of pieces that were split so many times, and their outer parts."""
        sides = pieces.corners - np.roll(pieces.corners, 1, axis=1)
        size = np.linalg.norm(sides, axis=2).max(axis=1)
        states = np.where(self._may_be_covered(pieces), PARTLY, OUTER)
        small = (size <= self.apart) | (depth >= MOST_HALVINGS)
        seen = np.flatnonzero(small & (states == PARTLY))
        states[seen] = self._seen(pieces.corners[seen], at_corners=True)
        smallest = size <= self.apart / 2.0**HALVINGS
        smallest |= depth >= MOST_HALVINGS + HALVINGS
        last = np.flatnonzero(smallest & small & (states == PARTLY))
        states[last] = self._seen(pieces.corners[last], at_corners=False)
        split = np.flatnonzero(states == PARTLY)
        if not len(split):
            return _Looked(states, np.empty((0, 3, 3)), np.empty(0, dtype=np.intp))
        quarters = _quarters(pieces.at(split))
        below = self.look(quarters, depth + 1)
        four = below.states.reshape(-1, 4)
        states[split] = np.where((four == four[:, :1]).all(axis=1), four[:, 0], PARTLY)
        whole = np.flatnonzero(below.states == OUTER)
        owners = split[np.concatenate([whole, below.owners]) // 4]
        outer = np.concatenate([quarters.corners[whole], below.outer])
        kept = states[owners] == PARTLY  # others are whole again
        return _Looked(states, outer[kept], owners[kept])

    def _may_be_covered(self, pieces: _Pieces) -> Any:
        """True for pieces whose box touches that of another body."""
        found, bodies = np.zeros(len(pieces.bodies), dtype=bool), self.bodies
        low = pieces.corners.min(axis=1) - self.aside
        high = pieces.corners.max(axis=1) + self.aside
        order = np.argsort(pieces.bodies, kind="stable")
        numbers, first = np.unique(pieces.bodies[order], return_index=True)
        for number, of in zip(numbers, np.split(order, first[1:]), strict=True):
            for other in bodies.beside[number]:
                is_beside = (low[of] <= bodies.high[other]) & (high[of] >= bodies.low[other])
                found[of] |= is_beside.all(axis=1)
        return found

    def _seen(self, corners: Array, *, at_corners: bool) -> Cells:
        """States of pieces, by what is on their sides at their middles, and near their corners."""
        middle = corners.mean(axis=1, keepdims=True)
        places = middle
        if at_corners:
            places = np.concatenate([middle, middle + TO_CORNERS * (corners - middle)], axis=1)
        across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        size = np.linalg.norm(across, axis=1, keepdims=True)
        step = self.aside * (across / np.where(size > 0.0, size, 1.0))[:, None, :]
        out, within = (
            winding_numbers(self.mesh, (places + way).reshape(-1, 3)) for way in (step, -step)
        )
        is_outer = ((out == 0) != (within == 0)).reshape(places.shape[:2])
        alike = (is_outer == is_outer[:, :1]).all(axis=1)
        return np.where(alike, np.where(is_outer[:, 0], OUTER, COVERED), PARTLY)


def _quarters(pieces: _Pieces) -> _Pieces:
    """Four similar parts of each piece, in a row."""
    a, b, c = np.moveaxis(pieces.corners, 1, 0)
    d, e, f = 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)
    four = [np.stack(one, axis=1) for one in ((a, d, f), (d, b, e), (f, e, c), (d, e, f))]
    corners = np.stack(four, axis=1).reshape(-1, 3, 3)
    return _Pieces(corners, np.repeat(pieces.bodies, 4))


def _bodies_of(mesh: Triangles, aside: float) -> _Bodies:
    """Bodies of a mesh, and which may meet."""
    edges = np.sort(np.concatenate([mesh.faces[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    links = scipy.sparse.coo_matrix(
        (np.ones(len(edges), dtype=bool), (edges[:, 0], edges[:, 1])),
        shape=(len(mesh.vertices),) * 2,
    )
    of_vertices = scipy.sparse.csgraph.connected_components(links, directed=False)[1]
    _, of_faces = np.unique(of_vertices[mesh.faces[:, 0]], return_inverse=True)
    of_faces = of_faces.reshape(-1)
    count = int(of_faces.max()) + 1
    low, high = np.full((count, 3), np.inf), np.full((count, 3), -np.inf)
    np.minimum.at(low, of_faces, mesh.corners.min(axis=1))
    np.maximum.at(high, of_faces, mesh.corners.max(axis=1))
    if count > MOST_BODIES:
        everywhere = np.full((count, 3), np.inf)
        return _Bodies(of_faces, -everywhere, everywhere, [np.array([0])] * count)
    before: Any = (low[:, None] <= high[None] + aside).all(axis=2)
    meets = before & before.T
    np.fill_diagonal(meets, False)
    # An edge of more than two faces: the body touches itself, or is several.
    unique, back = np.unique(edges[:, 0] * len(mesh.vertices) + edges[:, 1], return_inverse=True)
    crowded = (np.bincount(back.reshape(-1), minlength=len(unique)) > 2)[back.reshape(-1)]
    itself = np.tile(of_faces, 3)[crowded]
    meets[itself, itself] = True
    return _Bodies(of_faces, low, high, [np.flatnonzero(row) for row in meets])

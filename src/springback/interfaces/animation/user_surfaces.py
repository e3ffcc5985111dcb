"""Meshes of the user's own shapes in films: rounded between their vertices, filled where cut."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from springback.interfaces.animation.bodies import ViewPlane, section_outlines
from springback.interfaces.replay.geometry import Drawable

Array = np.ndarray[Any, np.dtype[np.float64]]
Cells = np.ndarray[Any, np.dtype[np.intp]]

#: Chosen: times that edges are halved, of meshes with at most so many triangles.
HALVINGS, MOST_TRIANGLES = 2, 20_000
#: Chosen: an edge is straight where the normals at its ends have a smaller product (60 deg apart).
SHARP = 0.5


class DrawnSection(NamedTuple):
    """Section of a shape with a plane [m]."""

    areas: list[Array]  # closed outlines to fill
    lines: list[Array]  # where the surface ends within the plane, or is a hole


def smooth(thing: Drawable) -> Drawable:
    """A mesh with more vertices, on a surface that follows the normals at those that it has.

    The middle of an edge is moved halfway to the mean of its projections on the planes of both
    ends: on a sphere it is then on the sphere, but for terms of the fourth order in the angle.

    Args:
        thing: With normals at its vertices; others stay as they are.
    """
    v, n, cells = thing.vertices, thing.normals, thing.triangles
    if v is None or n is None or cells is None or not 0 < len(cells) <= MOST_TRIANGLES:
        return thing
    for _ in range(HALVINGS):
        v, n, cells = _halved(v, n, cells)
    return thing._replace(vertices=v, normals=n, triangles=cells)


def _halved(v: Array, n: Array, cells: Cells) -> tuple[Array, Array, Cells]:
    """Four triangles for each; of no direction is a normal in the middle of a sharp edge."""
    ways = np.concatenate([cells[:, [0, 1]], cells[:, [1, 2]], cells[:, [2, 0]]])
    edges, number = np.unique(np.sort(ways, axis=1), axis=0, return_inverse=True)
    a, b = edges.T
    middle = 0.5 * (v[a] + v[b])
    lift = np.zeros_like(middle)
    for end in (a, b):
        lift += 0.25 * np.sum((v[end] - middle) * n[end], axis=1)[:, None] * n[end]
    normal = n[a] + n[b]
    is_sharp = np.sum(n[a] * n[b], axis=1) < SHARP
    lift[is_sharp], normal[is_sharp] = 0.0, 0.0  # nor are its halves rounded
    normal /= np.where(is_sharp, 1.0, np.linalg.norm(normal, axis=1))[:, None]
    i, j, k = len(v) + number.reshape(3, -1)
    p, q, r = cells.T
    parts = [(p, i, k), (q, j, i), (r, k, j), (i, j, k)]
    finer = np.concatenate([np.stack(part, axis=1) for part in parts]).astype(np.intp)
    return np.concatenate([v, middle + lift]), np.concatenate([n, normal]), finer


def cut(thing: Drawable, view: ViewPlane) -> DrawnSection:
    """Section of a mesh that may be a piece of a surface.

    Args:
        thing: The mesh.
        view: The plane.
    """
    found = section_outlines(thing, view)
    is_closed = [len(one) > 3 and bool((one[0] == one[-1]).all()) for one in found]
    if all(is_closed):
        return DrawnSection(found, [])
    filled = [closed and _area(one) > 0.0 for one, closed in zip(found, is_closed, strict=True)]
    return DrawnSection(
        [one for one, fills in zip(found, filled, strict=True) if fills],
        [one for one, fills in zip(found, filled, strict=True) if not fills],
    )


def _area(outline: Array) -> float:
    """Area within a closed outline, positive if the body is within [m²]."""
    x, y = outline.T
    return float(0.5 * np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]))

"""Mass, centre of mass and inertia of solids of 1 kg/m³: balls, boxes, capsules and closed meshes.

Those of balls, boxes, cylinders and ellipsoids are of any textbook of mechanics.  A hemisphere of
radius r has its centre of mass 3/8 r from its face and 83/320 m r² across its axis about that.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from pydantic_core import PydanticCustomError

from springback.contact.grids.closed_meshes import closed_mesh
from springback.contact.grids.mesh_files import Triangles
from springback.errors import InputError
from springback.scenario.masses.links import LinkMass

Array = np.ndarray[Any, np.dtype[np.float64]]


def filled_shape(kind: str, size: Sequence[float]) -> LinkMass:
    """Of a solid about its middle, whose third axis is that of capsules and cylinders.

    Args:
        kind: ``sphere``, ``capsule``, ``cylinder``, ``box`` or ``ellipsoid``.
        size: Halves, as in MuJoCo: a radius; radius and half of the length of what is straight; or
            half of the extent along each axis [m].
    """
    if kind in ("capsule", "cylinder"):
        r, h = size
        tube, ends = 2.0 * math.pi * r * r * h, 4.0 / 3.0 * math.pi * r**3
        along = tube * 0.5 * r * r
        across = tube * (r * r / 4.0 + h * h / 3.0)
        if kind == "capsule":
            along += ends * 0.4 * r * r
            across += ends * (0.4 * r * r + 0.75 * r * h + h * h)
        mass = tube + ends if kind == "capsule" else tube
        return LinkMass(mass, np.zeros(3), np.diag([across, across, along]))
    halves = np.array([size[0]] * 3 if kind == "sphere" else size, dtype=np.float64)
    box = kind == "box"
    mass = (8.0 if box else 4.0 / 3.0 * math.pi) * float(halves.prod())
    squares = halves * halves * mass / (3.0 if box else 5.0)
    return LinkMass(mass, np.zeros(3), np.diag(squares.sum() - squares))


def filled_mesh(file: str, mesh: Triangles, method: str) -> LinkMass:
    """Of what a mesh encloses, in its own frame, as MuJoCo would have it.

    ``exact`` takes its volume, ``convex`` that of its convex hull, ``shell`` an even surface of
    1 kg/m²; ``legacy``, MuJoCo's default, adds up the pyramids from each face to the middle of all
    as if each were inside: for convex meshes that is exact.

    Args:
        file: Of the mesh, for errors.
        mesh: Its triangles [m].
        method: One of the four.

    Raises:
        InputError: If it encloses nothing, or if an exact one is not closed.
    """
    if method == "convex":
        mesh = _hull_of(file, mesh)
    if method in ("exact", "convex"):
        try:
            mesh = closed_mesh(file, mesh)
        except PydanticCustomError as error:
            raise InputError(error.message()) from None
    corners = mesh.corners
    a, b, c = np.moveaxis(corners, 1, 0)
    areas = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    if not areas.sum() > 0.0:
        raise InputError(f"{file}: has no surface")
    middle = areas @ corners.mean(axis=1) / areas.sum()
    if method == "shell":
        return _gathered(corners - middle, areas, middle, 12.0)
    volumes = _volumes(corners - middle, method)
    if not volumes.sum() > 0.0:
        raise InputError(f"{file}: encloses no volume")
    centre = middle + volumes @ (corners - middle).sum(axis=1) / (4.0 * volumes.sum())
    return _gathered(corners - centre, _volumes(corners - centre, method), centre, 20.0)


def _hull_of(file: str, mesh: Triangles) -> Triangles:
    """Convex hull of a mesh, its faces anticlockwise from outside."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        hull = ConvexHull(mesh.vertices)
    except QhullError:
        raise InputError(f"{file}: is flat: it has no convex hull") from None
    faces, normals = hull.simplices.astype(np.intp), hull.equations[:, :3]
    a, b, c = np.moveaxis(mesh.vertices[faces], 1, 0)
    inward = np.einsum("ij,ij->i", np.cross(b - a, c - a), normals) < 0.0
    faces[inward] = faces[inward][:, ::-1]
    return Triangles(mesh.vertices, faces)


def _volumes(corners: Array, method: str) -> Array:
    """Of the pyramids from each face to the origin [m³]."""
    a, b, c = np.moveaxis(corners, 1, 0)
    volumes: Array = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6.0
    return np.abs(volumes) if method == "legacy" else volumes


def _gathered(corners: Array, masses: Array, centre: Array, share: float) -> LinkMass:
    """Mass and inertia about a centre from which corners are given, of triangles or pyramids."""
    total = corners.sum(axis=1)
    second = np.einsum("i,ij,ik->jk", masses, total, total)
    second += np.einsum("i,icj,ick->jk", masses, corners, corners)
    second /= share
    return LinkMass(float(masses.sum()), centre, np.trace(second) * np.eye(3) - second)

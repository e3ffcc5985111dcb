"""Files with forms of obstacles: meshes, heights and occupied cells; written once for a test run."""

from __future__ import annotations

import functools
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from springback.contact.grids.height_maps import height_file
from springback.contact.grids.mesh_files import Triangles
from springback.contact.grids.occupancy import occupancy_file
from springback.contact.scene.solids import solid_face
from springback.contact.shapes import ShapeSettings, solids_of
from springback.kernels.routines import NumberTable
from springback.kernels.vectors import Vec

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Folder of the files; it is removed when the tests end.
_FOLDER = tempfile.TemporaryDirectory(prefix="springback-forms-")


def folder() -> Path:
    """Folder of the files."""
    return Path(_FOLDER.name)


def box_triangles(*size: float) -> Triangles:
    """A box about the origin, of two triangles a face."""
    a, b, c = (0.5 * length for length in size)
    corners = np.array([[x, y, z] for x in (-a, a) for y in (-b, b) for z in (-c, c)])
    faces = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    halves = [half for p, q, r, s in faces for half in ((p, q, r), (p, r, s))]
    return Triangles(corners, np.array(halves, dtype=np.intp))


def ball_triangles(radius: float, rounds: int = 48) -> Triangles:
    """A sphere about the origin, with its vertices on it."""
    up = np.linspace(0.0, np.pi, rounds // 2 + 1)[1:-1]
    turn = 2.0 * np.pi * np.arange(rounds) / rounds
    ring = np.stack([np.cos(turn), np.sin(turn)], axis=1)
    points = [np.c_[np.sin(u) * ring, np.full(rounds, np.cos(u))] for u in up]
    vertices = radius * np.concatenate([*points, [[0, 0, 1.0], [0, 0, -1.0]]])
    number = np.arange(len(up) * rounds).reshape(-1, rounds)
    after = np.roll(number, -1, axis=1)
    a, b, c, d = number[:-1], number[1:], after[1:], after[:-1]
    top, bottom = len(vertices) - 2, len(vertices) - 1
    faces = [
        np.stack([a, b, c], -1).reshape(-1, 3), np.stack([a, c, d], -1).reshape(-1, 3),
        np.stack([np.full(rounds, top), number[0], after[0]], -1),
        np.stack([np.full(rounds, bottom), after[-1], number[-1]], -1),
    ]  # fmt: skip
    return Triangles(vertices, np.concatenate(faces))


def beside(*bodies: tuple[Triangles, tuple[float, float, float]]) -> Triangles:
    """Bodies, each at a place, as one mesh."""
    ends = np.cumsum([0, *(len(one.vertices) for one, _ in bodies)])
    vertices = np.concatenate([one.vertices + place for one, place in bodies])
    faces = np.concatenate([one.faces + k for (one, _), k in zip(bodies, ends, strict=False)])
    return Triangles(vertices, faces)


def stl_bytes(mesh: Triangles) -> bytes:
    """A binary STL."""
    kind = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("unused", "<u2")])
    rows = np.zeros(len(mesh.faces), kind)
    rows["corners"] = mesh.corners
    return bytes(80) + len(rows).to_bytes(4, "little") + rows.tobytes()


def obj_text(mesh: Triangles) -> str:
    """An OBJ."""
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in mesh.vertices.tolist()]
    lines += [f"f {a + 1}//1 {b + 1}/2 {c + 1}" for a, b, c in mesh.faces.tolist()]
    return "# a mesh\n" + "\n".join(lines) + "\n"


@functools.cache
def box_file(x: float, y: float, z: float) -> str:
    """An STL of a box."""
    path = folder() / f"box-{x:g}-{y:g}-{z:g}.stl"
    path.write_bytes(stl_bytes(box_triangles(x, y, z)))
    return str(path)


@functools.cache
def ball_file(radius: float) -> str:
    """An OBJ of a sphere."""
    path = folder() / f"ball-{radius:g}.obj"
    path.write_text(obj_text(ball_triangles(radius)))
    return str(path)


def hills(x: Array, y: Array) -> Array:
    """Heights of smooth ground [m]."""
    return np.asarray(0.08 * np.sin(2.1 * x + 0.3) * np.cos(1.7 * y) + 0.1 * x - 0.03 * x * y)


@functools.cache
def hills_file(half: float = 1.0, spacing: float = 0.1) -> str:
    """Heights of `hills` about the origin."""
    along = np.arange(-half, half + 0.5 * spacing, spacing)
    return height_file(hills(along[:, None], along[None, :]), folder() / f"hills-{spacing:g}.npy")


@functools.cache
def cells_file(count: tuple[int, int, int] = (8, 12, 12), cell: float = 0.05) -> str:
    """A full block of occupied cells with its lower corner at the origin."""
    return occupancy_file(np.ones(count, dtype=bool), cell, path=folder() / "cells.npz")


@functools.cache
def table_of(shape: ShapeSettings) -> float:
    """Table of its one solid."""
    [solid] = solids_of(shape, 0, 0)
    return NumberTable(np.array(solid.row()))


def face(shape: ShapeSettings, point: Array) -> tuple[float, Array]:
    """Distance and gradient, by the kernel."""
    found = solid_face(table_of(shape), 0, Vec(*point.tolist()))
    return found.gap, np.array(found.normal)

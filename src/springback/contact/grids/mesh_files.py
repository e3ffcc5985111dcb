"""Triangles of a mesh file: STL and OBJ read here, PLY, GLB and others by trimesh."""

from __future__ import annotations

import io
import itertools
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from springback.contact.grids.data_files import suffix_of
from springback.errors import InputError
from springback.extras import needs
from springback.settings import problem

Array = np.ndarray[Any, np.dtype[np.float64]]
Cells = np.ndarray[Any, np.dtype[np.intp]]

#: Most triangles (chosen: their distances then take some minutes).
MOST_TRIANGLES = 2_000_000
#: Triangles that the head of a damaged binary STL may tell of: more are other bytes (chosen).
MOST_TOLD = 100_000_000
#: First bytes of files of a format, where they are always the same.
_BEGINNINGS = {"ply": b"ply", "glb": b"glTF", "3mf": b"PK"}
#: Bytes of a binary STL before its triangles, and of each.
_HEAD = 84
_FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("unused", "<u2")])


class Triangles(NamedTuple):
    """Surface of a body."""

    vertices: Array  # [m], shape (vertices, 3)
    faces: Cells  # anticlockwise from outside, shape (faces, 3)

    @property
    def corners(self) -> Array:
        """Corners of each face [m], shape (faces, 3, 3)."""
        return self.vertices[self.faces]


def triangles_of(file: str, data: bytes) -> Triangles:
    """Triangles of a mesh file; vertices in one place are one.

    Args:
        file: Its name, which tells the format.
        data: Its content.

    Raises:
        The problem, if it is damaged, of no known format, empty, or too large.
    """
    read = _READERS[suffix_of(file, tuple(_READERS))]
    try:
        found = read(file, data)
    except InputError as error:
        raise problem(f"{file}: {error.problems[0]}", "file") from None
    if not len(found.faces):
        raise problem(f"{file}: has no triangles", "file")
    _check_count(file, len(found.faces))
    if not np.isfinite(found.vertices).all():
        bad = int(np.flatnonzero(~np.isfinite(found.vertices).all(axis=1))[0])
        raise problem(f"{file}: vertex {bad + 1} is not finite", "file")
    return _welded(found)


def _check_count(file: str, count: int) -> None:
    if count > MOST_TRIANGLES:
        raise problem(f"{file}: must have at most {MOST_TRIANGLES} triangles (got {count})", "file")


def _welded(mesh: Triangles) -> Triangles:
    """Vertices in exactly one place become one; faces that then have two corners are dropped."""
    vertices, back = np.unique(mesh.vertices + 0.0, axis=0, return_inverse=True)
    faces = back.reshape(-1)[mesh.faces]
    a, b, c = faces.T
    return Triangles(vertices, faces[(a != b) & (b != c) & (c != a)])


def _of_corners(corners: Array) -> Triangles:
    vertices = np.ascontiguousarray(corners, dtype=np.float64).reshape(-1, 3)
    return Triangles(vertices, np.arange(len(vertices)).reshape(-1, 3))


def _stl(file: str, data: bytes) -> Triangles:
    if len(data) >= _HEAD:
        count = int.from_bytes(data[80:84], "little")
        if len(data) == _HEAD + count * _FACET.itemsize:
            _check_count(file, count)
            return _of_corners(np.frombuffer(data, _FACET, count, _HEAD)["corners"])
    if data.lstrip()[:5].lower() != b"solid" or b"facet" not in data[:4096]:
        if len(data) >= _HEAD and count <= MOST_TOLD:
            raise problem(
                f"{file}: is damaged: a binary STL of {count} triangles has "
                f"{_HEAD + count * _FACET.itemsize} bytes (got {len(data)})",
                "file",
            )
        raise problem(f"{file}: is not STL", "file")
    words = data.split()
    if not any(word.lower() == b"endsolid" for word in words[-16:]):
        raise problem(f"{file}: is damaged: endsolid is missing", "file")
    places = np.array([k for k, word in enumerate(words) if word.lower() == b"vertex"])
    if len(places) % 3 or not len(places) or places[-1] + 3 >= len(words):
        raise problem(f"{file}: is damaged: {len(places)} vertices are no triangles", "file")
    numbers = [[words[k + j] for j in (1, 2, 3)] for k in places]
    try:
        return _of_corners(np.array(numbers, dtype=np.float64))
    except ValueError as error:
        raise problem(f"{file}: is damaged ({error})", "file") from None


def _obj(file: str, data: bytes) -> Triangles:
    vertices: list[list[float]] = []
    faces: list[tuple[int, int, int]] = []
    for number, line in enumerate(data.split(b"\n"), start=1):
        words = line.split()
        if not words or words[0] not in (b"v", b"f"):
            continue
        try:
            if words[0] == b"v":
                vertices.append([float(word) for word in words[1:4]])
                if len(vertices[-1]) != 3:
                    raise ValueError("a vertex has three coordinates")
                continue
            loop = [int(word.partition(b"/")[0]) for word in words[1:]]
            loop = [k - 1 if k > 0 else len(vertices) + k for k in loop]
            if len(loop) < 3 or min(loop) < 0 or max(loop) >= len(vertices) or b"0" in words[1:]:
                raise ValueError("a face has three vertices or more, which were given before")
            faces += [(loop[0], b, c) for b, c in itertools.pairwise(loop[1:])]
        except ValueError as error:
            raise problem(f"{file}:{number}: is not OBJ ({error})", "file") from None
    return Triangles(
        np.array(vertices, dtype=np.float64).reshape(-1, 3),
        np.array(faces, dtype=np.intp).reshape(-1, 3),
    )


def _by_trimesh(file: str, data: bytes) -> Triangles:
    library = needs("trimesh", "worlds")
    kind = suffix_of(file, tuple(_READERS)).removeprefix(".")
    if not data.startswith(_BEGINNINGS.get(kind, b"")):
        raise problem(f"{file}: is not {kind.upper()}", "file")
    try:
        found = library.load(io.BytesIO(data), file_type=kind, force="mesh", process=False)
        vertices = np.asarray(found.vertices, dtype=np.float64)
        faces = np.asarray(found.faces, dtype=np.intp)
    except Exception as error:  # whatever the library raises for a damaged file
        what = " ".join(f"{type(error).__name__}: {error}".split())[:120]
        raise problem(f"{file}: cannot be read ({what})", "file") from None
    return Triangles(vertices.reshape(-1, 3), faces.reshape(-1, 3))


_READERS: dict[str, Callable[[str, bytes], Triangles]] = {
    ".stl": _stl, ".obj": _obj, ".ply": _by_trimesh, ".glb": _by_trimesh, ".off": _by_trimesh,
    ".3mf": _by_trimesh,
}  # fmt: skip
#: Suffixes of mesh files.
MESH_FILES = tuple(_READERS)

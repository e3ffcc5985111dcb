"""Meshes of a scenario: sizes that are hardly intended, and progress while grids are made."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextvars import ContextVar
from pathlib import Path
from typing import Any

import numpy as np
from pydantic_core import PydanticCustomError

from springback.contact.grids.data_files import content_digest, file_bytes
from springback.contact.grids.distance_grids import (
    NODES,
    NODES_IF_THIN,
    least_cell,
    node_counts,
)
from springback.contact.grids.measured_shapes import MeshBody
from springback.contact.grids.mesh_files import triangles_of
from springback.contact.thin_obstacles import COARSE, SMALLER, cell_advice
from springback.contact.unions import ShapeUnion
from springback.errors import InputError, excerpt
from springback.quantities import si_number
from springback.scenario.worlds.imported import Imported, part_words
from springback.settings import problem

#: Size of a mesh from which its file may be in millimetres [m] (chosen: larger than most halls).
LARGE = 50.0
#: Cells across the thinnest parts with fewer of which forces are wrong by more (measured: boards).
FEW = 3.0
#: Suffixes of files that are y-up by definition, and often written z-up.
Y_UP = (".glb",)
#: Meshes whose sizes are remembered (chosen).
LATEST = 64
#: Most meshes that are named (chosen).
MOST_NAMED = 3
_KNOWN: dict[tuple[Any, ...], tuple[tuple[float, ...], float, float]] = {}


def check_meshes(obstacles: Sequence[Any]) -> None:
    """Reject a mesh of whose body nothing is left, as its cells are too coarse.

    Args:
        obstacles: Of a world.
    """
    for path, _, mesh in _meshes(obstacles):
        size, cell, deepest = _numbers(mesh)
        if path and deepest <= 0.0:
            least, most = least_cell(np.array(size)), 0.5 * min(size)
            needed = (
                f"must be at most {most:.3g} m"
                if least <= most
                else f"a mesh so large allows no cell below {least:.3g} m; use a box"
            )
            raise problem(
                f"leaves nothing of the mesh of {_by(size)} m: parts thinner than two cells are "
                f"lost; {needed} (got {cell:.3g} m)",
                f"{path}.cell",
            )


def mesh_warnings(obstacles: Sequence[Any]) -> list[str]:
    """Warnings for meshes that are very large, or too thin for their cells, a sentence each.

    Args:
        obstacles: Of a world.
    """
    found = []
    for path, name, mesh in _meshes(obstacles):
        size, cell, deepest = _numbers(mesh)
        if large := size_words(mesh):
            found.append(f"{name}: is a mesh{large}")
        if deepest <= 0.0:
            found.append(
                f"{name}: nothing is left of its mesh of {_by(size)} m, as cells of {cell:.3g} m "
                "are too coarse; use a box, or an obstacle of type mesh with a smaller cell"
            )
        elif cell * COARSE > (thin := mesh.form().thinnest):
            share = 40 if FEW * cell > thin else 30
            lost = ", and parts thinner than two cells are lost" if 2.0 * cell > thin else ""
            found.append(
                f"{name}: cells of {cell:.3g} m are coarse for a mesh whose thinnest parts are "
                f"{thin:.3g} m thick: forces on them are up to {share} % too weak or too strong"
                f"{lost}; "
                f"{'' if path else 'as an obstacle of type mesh '}{cell_advice(mesh)}"
            )
    return found


def axis_warnings(obstacles: Sequence[Any]) -> list[str]:
    """Sentences on meshes that are not turned and whose format has y upwards by definition.

    Args:
        obstacles: Of a world.
    """
    found = []
    for path, name, mesh in _meshes(obstacles):
        if Path(mesh.file).suffix.lower() in Y_UP and not mesh.roll and not mesh.pitch:
            what = "give" if path else "make it an obstacle of type mesh with"
            found.append(
                f"{name}: {excerpt(Path(mesh.file).name)} is read as z-up, {_by(mesh.extent())} m "
                "along its x, y and z; if it was written y-up, as glTF defines, "
                f'{what} roll = "90 deg"'
            )
    return found


def smaller_cells(mesh: MeshBody) -> str:
    """What to do for smaller cells, in words: less of a mesh, if it is too large for them.

    Args:
        mesh: Any.
    """
    least = least_cell(np.array(mesh.extent()))
    if least < SMALLER * mesh.form().cell:
        return f"give it smaller cells (cell, {least:.3g} m or more)"
    return "make its thin parts a mesh of their own, which is a further obstacle, or boxes"


def size_words(obstacle: Any) -> str:
    """Size of a mesh that is so large that its file may be in millimetres; empty for others."""
    if not isinstance(obstacle, MeshBody):
        return ""
    widest = max(obstacle.extent())
    if widest < LARGE:
        return ""
    scale = 1e-3 * obstacle.scale
    return f" {widest:.4g} m wide; with scale = {scale:g} it would be {1e-3 * widest:.4g} m"


def _meshes(obstacles: Sequence[Any]) -> Iterator[tuple[str, str, MeshBody]]:
    """Meshes of a world, each with its key, empty for one of a file, and its name."""
    for k, entry in enumerate(obstacles):
        path, called = f"world.obstacles[{k}]", f", {entry.name}" if entry.name else ""
        if isinstance(entry, MeshBody):
            yield path, f"{path}{called}", entry
        elif isinstance(entry, ShapeUnion):
            for j, shape in enumerate(entry.shapes):
                if isinstance(shape, MeshBody):
                    yield f"{path}.shapes[{j}]", f"{path}.shapes[{j}]{called}", shape
        elif isinstance(entry, Imported):
            for part in entry.parts:
                if isinstance(part.obstacle, MeshBody):
                    yield "", part_words(k, entry, part), part.obstacle


def _numbers(mesh: MeshBody) -> tuple[tuple[float, ...], float, float]:
    """Lengths along its own axes, cell and depth of the innermost node [m]."""
    key = mesh.file, mesh.content, mesh.scale, mesh.cell
    if key not in _KNOWN:
        form, size = mesh.form(), np.ptp(mesh.triangles().vertices, axis=0)
        if len(_KNOWN) >= LATEST:
            del _KNOWN[next(iter(_KNOWN))]
        _KNOWN[key] = tuple(size.tolist()), form.cell, form.deepest
    return _KNOWN[key]


def _by(size: Sequence[float]) -> str:
    return " x ".join(f"{length:.3g}" for length in size)


# -- while grids are made -------------------------------------------------------------------------

Tell = Callable[[str], None]
_TELL: ContextVar[Tell | None] = ContextVar("tell", default=None)


@contextlib.contextmanager
def telling(tell: Tell) -> Iterator[None]:
    """Have `tell_of_grids` say what it knows, within the block.

    Args:
        tell: Takes what is being done, in words.
    """
    token = _TELL.set(tell)
    try:
        yield
    finally:
        _TELL.reset(token)


def tell_of_grids(given: Mapping[str, Any]) -> None:
    """Tell which meshes a raw scenario has, and how many nodes their grids get, if told to whom."""
    tell = _TELL.get()
    if tell is None:
        return
    world = given.get("world")
    entries = world.get("obstacles") if isinstance(world, Mapping) else None
    words = [
        _words(f"world.obstacles[{k}]", mesh)
        for k, entry in enumerate(entries if isinstance(entries, list | tuple) else ())
        for mesh in _meshes_in(entry)
    ]
    if words:
        more = f" and {len(words) - MOST_NAMED} more" if len(words) > MOST_NAMED else ""
        tell(
            f"distance grids are computed unless they are cached: {'; '.join(words[:MOST_NAMED])}"
            f"{more} (a larger cell makes a grid coarser and faster)"
        )


def _meshes_in(entry: Any) -> Iterator[Mapping[str, Any]]:
    """Raw meshes of an obstacle: itself, or the shapes of a union."""
    if not isinstance(entry, Mapping):
        return
    if entry.get("type") == "mesh":
        yield entry
    shapes = entry.get("shapes")
    for shape in shapes if isinstance(shapes, list | tuple) else ():
        yield from _meshes_in(shape)


def _words(path: str, mesh: Mapping[str, Any]) -> str:
    """Name, file and number of nodes of a raw mesh."""
    name, file = mesh.get("name"), mesh.get("file")
    called = f"{path}, {excerpt(name)}" if isinstance(name, str) and name else path
    of = f" ({excerpt(Path(file).name)})" if isinstance(file, str) else ""
    nodes = _nodes(mesh)
    by_default = (
        f"{1e-6 * NODES:.2g} million nodes, up to {1e-6 * NODES_IF_THIN:.2g} million if parts are "
        "thin"
    )
    return f"{called}{of}: {by_default if nodes is None else f'{1e-6 * nodes:.2g} million nodes'}"


def _nodes(mesh: Mapping[str, Any]) -> float | None:
    """Nodes of the grid of a raw mesh by its own cell; None without one, or if it is not right."""
    if mesh.get("cell") is None or not isinstance(file := mesh.get("file"), str):
        return None
    try:
        cell = si_number(mesh["cell"], "m", above=0.0)
        scale = si_number(mesh.get("scale", 1.0), "", above=0.0)
        vertices = triangles_of(file, file_bytes(file, content_digest(file))).vertices
    except (InputError, PydanticCustomError, OSError):  # said when it is read
        return None
    return float(node_counts(scale * np.ptp(vertices, axis=0), cell).prod())

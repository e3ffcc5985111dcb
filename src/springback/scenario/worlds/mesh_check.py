"""Sizes of meshes that are seldom meant: as of millimetres, or too thin for the grid's cells."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from springback.contact.grids.distance_grids import least_cell
from springback.contact.grids.measured_shapes import MeshBody
from springback.contact.thin_obstacles import COARSE, cell_advice
from springback.contact.unions import ShapeUnion
from springback.scenario.worlds.imported import Imported, part_words
from springback.settings import problem

#: Size of a mesh from which its file may be in millimetres [m] (chosen: larger than most halls).
LARGE = 50.0
#: Cells across the thinnest parts with fewer of which forces are wrong by more (measured: boards).
FEW = 3.0
#: Meshes whose sizes are remembered (chosen).
LATEST = 64
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
            wrong = "up to 40 % wrong" if FEW * cell > thin else "up to 30 % wrong"
            lost = ", and parts thinner than two cells are lost" if 2.0 * cell > thin else ""
            found.append(
                f"{name}: cells of {cell:.3g} m are coarse for a mesh whose thinnest parts are "
                f"{thin:.3g} m thick: forces on them are {wrong}{lost}; "
                f"{'' if path else 'as an obstacle of type mesh '}{cell_advice(mesh)}"
            )
    return found


def size_words(obstacle: Any) -> str:
    """Size of a mesh that is so large that its file may be in millimetres; empty for others."""
    if not isinstance(obstacle, MeshBody):
        return ""
    widest = max(_numbers(obstacle)[0])
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

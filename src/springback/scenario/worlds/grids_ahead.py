"""What is said of distance grids of meshes before they are made, which may take a minute."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator, Mapping
from contextvars import ContextVar
from pathlib import Path
from typing import Any

import numpy as np
from pydantic_core import PydanticCustomError

from springback.contact.grids.data_files import content_digest, file_bytes
from springback.contact.grids.distance_grids import NODES, NODES_IF_THIN, node_counts
from springback.contact.grids.mesh_files import triangles_of
from springback.errors import InputError, excerpt
from springback.quantities import si_number

Tell = Callable[[str], None]
_TELL: ContextVar[Tell | None] = ContextVar("tell", default=None)
#: Most meshes that are named (chosen).
MOST_NAMED = 3


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
            f"grids of distances are made unless they are kept: {'; '.join(words[:MOST_NAMED])}"
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

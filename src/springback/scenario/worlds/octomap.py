"""Occupancy trees of OctoMap, .bt and .ot: occupied cubes, joined to boxes.

Source: the format as the library writes it (https://octomap.github.io).  A tree of 16 levels
around the origin; each node has eight children: bit 0 of their number is x, bit 1 y, bit 2 z.
"""

from __future__ import annotations

import math
import re
import struct
from pathlib import Path
from typing import Any

import numpy as np

from springback.errors import InputError
from springback.scenario.worlds.content import MOST_ELEMENTS, Collector
from springback.scenario.worlds.paths import file_bytes
from springback.scenario.worlds.poses import FramePose

#: Levels of a tree below its root.
LEVELS = 16
#: Most nodes that are read, and most cells of the box around what is occupied (chosen).
MOST_NODES, MOST_CELLS = 20_000_000, 100_000_000
#: Bytes of colour of a node of each kind of tree.
COLOUR = {"OcTree": 0, "ColorOcTree": 3}

Array = np.ndarray[Any, np.dtype[np.int64]]
Cells = np.ndarray[Any, np.dtype[np.bool_]]


def read_octomap(found: Collector) -> None:
    """Add what is occupied as boxes.

    Args:
        found: Takes them.

    Raises:
        InputError: If the file is no such tree, or damaged, or needs too many boxes.
    """
    name = str(found.path)
    cell, cubes = _read(found.path)
    for k, (low, high) in enumerate(_boxes(cubes, name)):
        pose = FramePose(np.eye(3), 0.5 * cell * (low + high))
        found.box(f"box {k}", pose, (cell * (high - low)).tolist())


def occupied_cubes(data: bytes, name: str) -> tuple[float, Array]:
    """Size of a cell [m], and the occupied cubes: x, y, z of the least corner and side, in cells.

    Args:
        data: Content of a file.
        name: Of the file, for errors.

    Raises:
        InputError: If it is no tree, or damaged.
    """
    head, sign, body = data.partition(b"\ndata\n")
    lines = head.decode("latin-1").splitlines()
    if not sign or not lines or not re.match(r"# Octomap OcTree( binary)? file", lines[0]):
        raise InputError(f"{name}: is no OctoMap file of the new format (.bt or .ot)")
    keys = {
        word: rest
        for word, _, rest in (line.strip().partition(" ") for line in lines[1:])
        if word[:1] not in ("", "#")
    }
    kind, is_binary = keys.get("id", "").strip(), "binary" in lines[0]
    try:
        cell = float(keys.get("res", ""))
    except ValueError:
        cell = math.nan
    if not 1e-6 <= cell <= 1e3:
        raise InputError(f"{name}: res: must be 1e-6 to 1000 m (got {keys.get('res', '')[:40]!r})")
    if kind not in COLOUR:
        raise InputError(f"{name}: id: must be {' or '.join(COLOUR)} (got {kind[:40]!r})")
    try:
        read = _binary_leaves if is_binary else _full_leaves
        leaves, used = read(body, COLOUR[kind])
    except (IndexError, struct.error):
        raise InputError(f"{name}: ends within the tree") from None
    except OverflowError:
        raise InputError(
            f"{name}: is deeper than {LEVELS} levels, or has more than {MOST_NODES} nodes"
        ) from None
    if used != len(body):
        more = len(body) - used
        raise InputError(f"{name}: has {more} byte{'' if more == 1 else 's'} after the tree")
    return cell, np.array(leaves, dtype=np.int64).reshape(-1, 4)


def _child(x: int, y: int, z: int, side: int, k: int) -> tuple[int, int, int, int]:
    half = side // 2
    return x + half * (k & 1), y + half * (k >> 1 & 1), z + half * (k >> 2), half


def _root() -> tuple[int, int, int, int]:
    least = -(1 << LEVELS - 1)
    return least, least, least, 1 << LEVELS


def _binary_leaves(body: bytes, colour: int) -> tuple[list[tuple[int, int, int, int]], int]:
    """Occupied leaves of a .bt: two bits a child, 01 free, 10 occupied, 11 with children."""
    found, waiting, at, count = [], [_root()] if body else [], 0, 0
    while waiting:
        cube = waiting.pop()
        word = body[at] | body[at + 1] << 8
        at, count, inner = at + 2, count + 1, []
        if cube[3] < 2 or count > MOST_NODES:
            raise OverflowError
        for k in range(8):
            state = word >> 2 * k & 3
            if state == 2:
                found.append(_child(*cube, k))
            elif state == 3:
                inner.append(_child(*cube, k))
        waiting += reversed(inner)
    return found, at


def _full_leaves(body: bytes, colour: int) -> tuple[list[tuple[int, int, int, int]], int]:
    """Occupied leaves of a .ot: each node's log-odds, colour and a byte of its children."""
    found, waiting, at, count = [], [_root()] if body else [], 0, 0
    while waiting:
        cube = waiting.pop()
        [odds] = struct.unpack_from("<f", body, at)
        children = body[at + 4 + colour]
        at, count = at + 5 + colour, count + 1
        if count > MOST_NODES:
            raise OverflowError
        if not children:
            if odds >= 0.0:
                found.append(cube)
            continue
        if cube[3] < 2:
            raise OverflowError
        waiting += [_child(*cube, k) for k in range(7, -1, -1) if children >> k & 1]
    return found, at


def occupied_cells(cubes: Array, name: str) -> tuple[Cells, Array]:
    """Cells of the box around some cubes, true if occupied, and the place of the first.

    Args:
        cubes: Of `occupied_cubes`.
        name: Of the file, for errors.

    Raises:
        InputError: If the box is too large.
    """
    least = cubes[:, :3].min(axis=0)
    shape = (cubes[:, :3] + cubes[:, 3:]).max(axis=0) - least
    if np.prod(shape.astype(float)) > MOST_CELLS:
        raise InputError(
            f"{name}: what is occupied spans {' x '.join(map(str, shape.tolist()))} cells; at most "
            f"{MOST_CELLS} are read: crop it, or use a coarser resolution"
        )
    taken = np.zeros(shape, dtype=bool)
    for x, y, z, side in (cubes - [*least, 0]).tolist():
        taken[x : x + side, y : y + side, z : z + side] = True
    return taken, least


def occupancy_arrays(path: Path) -> dict[str, Any]:
    """Occupancy grid of a tree: arrays ``occupancy``, ``cell`` [m], ``origin`` [m] of an .npz.

    Raises:
        InputError: If the file is no tree, or damaged, or has nothing occupied.
    """
    cell, cubes = _read(path)
    taken, least = occupied_cells(cubes, str(path))
    return {"occupancy": taken, "cell": cell, "origin": cell * least}


def _read(path: Path) -> tuple[float, Array]:
    """Size of a cell [m] and the occupied cubes of a file, of which there are some."""
    cell, cubes = occupied_cubes(file_bytes(path), str(path))
    if not len(cubes):
        raise InputError(f"{path}: has no occupied cell")
    return cell, cubes


def _boxes(cubes: Array, name: str) -> list[tuple[Any, Any]]:
    """Cubes joined to boxes that do not overlap: least and largest corners, in cells.

    Args:
        cubes: Of `occupied_cubes`.
        name: Of the file, for errors.
    """
    taken, least = occupied_cells(cubes, name)
    shape = taken.shape
    found: list[tuple[Any, Any]] = []
    flat, at = taken.reshape(-1), 0
    while at < len(flat):
        at += int(np.argmax(flat[at:]))  # the next that no box holds yet
        if not flat[at]:
            break
        x, y, z = (int(place) for place in np.unravel_index(at, taken.shape))
        if len(found) >= MOST_ELEMENTS:
            raise InputError(
                f"{name}: needs more than {MOST_ELEMENTS} boxes; use a coarser resolution, or make "
                f"it an occupancy grid: springback world convert {name} --out cells.npz"
            )
        row = taken[x, y, z:]
        up = z + (len(row) if row.all() else int(np.argmin(row)))
        along, far = y + 1, x + 1
        while along < shape[1] and taken[x, along, z:up].all():
            along += 1
        while far < shape[0] and taken[far, y:along, z:up].all():
            far += 1
        taken[x:far, y:along, z:up] = False
        found.append((least + np.array((x, y, z)), least + np.array((far, along, up))))
    return found

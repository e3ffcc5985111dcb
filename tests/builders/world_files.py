"""Files of other programs, small and of our own, and the obstacles that they become as poses."""

from __future__ import annotations

import struct
from collections.abc import Iterable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from springback import read_world
from springback.scenario.worlds.imported import Imported

Array = np.ndarray[Any, np.dtype[np.float64]]


class Seen(NamedTuple):
    """A shape as its corners are seen: the same whatever file it is from."""

    centre: Array  # [m]
    axis: Array  # third axis of what has one
    axes: Array  # of a box, one a row
    sizes: Array  # whole lengths of a box; radius and length of others [m]


def seen(obstacle: Any) -> Seen:
    """An imported obstacle: a box, pole, capsule, sphere or cone."""
    none, up = np.eye(3), np.array([0.0, 0.0, 1.0])
    if obstacle.type == "box":
        axes = obstacle.axes()
        return Seen(np.array(obstacle.position), axes[2], axes, np.array(obstacle.size))
    if obstacle.type == "sphere":
        return Seen(np.array(obstacle.position), up, none, np.array([obstacle.radius]))
    if obstacle.type == "capsule":
        a, b = np.array(obstacle.start), np.array(obstacle.end)
        length = float(np.linalg.norm(b - a))
        return Seen(0.5 * (a + b), (b - a) / length, none, np.array([obstacle.radius, length]))
    axis = np.array(obstacle.axis) / np.linalg.norm(obstacle.axis)
    centre = np.array(obstacle.position) + 0.5 * obstacle.height * axis
    return Seen(centre, axis, none, np.array([obstacle.radius, obstacle.height]))


def named_parts(world: Imported) -> dict[str, Any]:
    """Obstacles of a world by the name of their element."""
    return {part.name: part.obstacle for part in world.parts}


def imported(folder: Path, name: str, text: str | bytes, **options: Any) -> Imported:
    """A world of a file that is written first."""
    path = folder / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return read_world(path, **options)


def sdf(*models: str) -> str:
    """A world in SDF that holds some models."""
    return (
        f'<?xml version="1.0"?>\n<sdf version="1.9"><world name="w">{"".join(models)}</world></sdf>'
    )


def sdf_model(name: str, geometry: str, pose: str = "0 0 0 0 0 0", extra: str = "") -> str:
    """A static model of one link with one collision."""
    return (
        f'<model name="{name}"><static>true</static><pose>{pose}</pose>{extra}<link name="link">'
        f'<collision name="collision"><geometry>{geometry}</geometry></collision></link></model>'
    )


BOX = "<box><size>0.4 1 2</size></box>"


def octomap_binary(cells: Iterable[tuple[int, int, int]], resolution: float) -> bytes:
    """A tree of OctoMap (.bt) in which some cells of the finest level are occupied."""
    body = b"".join(_binary_nodes({(x + 32768, y + 32768, z + 32768) for x, y, z in cells}, 15))
    head = f"# Octomap OcTree binary file\nid OcTree\nsize 1\nres {resolution}\ndata\n"
    return head.encode() + body


def _children(cells: set[tuple[int, int, int]], bit: int) -> list[set[tuple[int, int, int]]]:
    found: list[set[tuple[int, int, int]]] = [set() for _ in range(8)]
    for x, y, z in cells:
        found[(x >> bit & 1) | (y >> bit & 1) << 1 | (z >> bit & 1) << 2].add((x, y, z))
    return found


def _binary_nodes(cells: set[tuple[int, int, int]], bit: int) -> list[bytes]:
    word, below = 0, list[bytes]()
    for k, part in enumerate(_children(cells, bit)):
        if part:
            word |= (2 if bit == 0 else 3) << 2 * k
            below += _binary_nodes(part, bit - 1) if bit else []
    return [struct.pack("<H", word), *below]


def octomap_full(
    cells: Iterable[tuple[int, int, int]], resolution: float, colour: bytes = b""
) -> bytes:
    """The same tree as .ot, with log-odds and perhaps the colour of each node."""
    kind = "ColorOcTree" if colour else "OcTree"
    shifted = {(x + 32768, y + 32768, z + 32768) for x, y, z in cells}
    head = f"# Octomap OcTree file\n# of springback\nid {kind}\nsize 1\nres {resolution}\ndata\n"
    return head.encode() + b"".join(_full_nodes(shifted, 15, colour))


def _full_nodes(cells: set[tuple[int, int, int]], bit: int, colour: bytes) -> list[bytes]:
    if bit < 0:
        return [struct.pack("<f", 0.85) + colour + b"\0"]
    mask, below = 0, list[bytes]()
    for k, part in enumerate(_children(cells, bit)):
        if part:
            mask |= 1 << k
            below += _full_nodes(part, bit - 1, colour)
    return [struct.pack("<f", 0.85) + colour + bytes([mask]), *below]

"""Worlds of RotorPy: blocks in JSON, and the bounds of the world.

Source: https://github.com/spencerfolk/rotorpy, folder rotorpy/worlds.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from springback.errors import InputError, shown_value
from springback.scenario.source_text import json_tables
from springback.scenario.worlds.content import Collector
from springback.scenario.worlds.paths import file_bytes
from springback.scenario.worlds.poses import FramePose, at_origin

#: Keys of a world, those of which nothing is read included.
KNOWN = ("bounds", "blocks", "start", "goal", "resolution", "margin", "expected_time", "margins")


def read_blocks(found: Collector, bounds: bool) -> None:
    """Add all blocks of a world.

    Args:
        found: Takes them.
        bounds: True if the bounds are walls.

    Raises:
        InputError: If the file is no such world, or wrong.
    """
    name = str(found.path)
    try:
        given = json_tables(file_bytes(found.path).decode("utf-8-sig"), name)
    except UnicodeDecodeError:
        raise InputError(f"{name}: is not text in UTF-8") from None
    blocks = given.get("blocks", [])
    if not isinstance(blocks, list) or not ({"blocks", "bounds"} & given.keys()):
        raise InputError(f"{name}: is no world of RotorPy, which has bounds and a list of blocks")
    for key in given:
        if key not in KNOWN:
            found.leave_out(str(key), "is no part of a world of RotorPy that is known")
    for k, block in enumerate(blocks):
        extents = _extents(block, f"{name}: blocks[{k}]")
        low, high = np.array(extents[::2]), np.array(extents[1::2])
        pose = FramePose(np.eye(3), 0.5 * (low + high))
        found.box(f"block {k}", pose, (high - low).tolist())
    if bounds:
        _add_bounds(found, _extents(given.get("bounds"), f"{name}: bounds"))


def _add_bounds(found: Collector, extents: list[float]) -> None:
    """Walls, ceiling and ground around a world."""
    for axis, letter in enumerate("xyz"):
        for side, sign in enumerate((1.0, -1.0)):
            normal, place = [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]
            normal[axis], place[axis] = sign, extents[2 * axis + side]
            pose = FramePose(at_origin().turn, np.array(place))
            found.plane(f"bounds {'least' if side == 0 else 'most'} {letter}", pose, normal)


def _extents(given: Any, where: str) -> list[float]:
    """Least and largest x, y and z [m]."""
    values = given.get("extents") if isinstance(given, dict) else None
    if not isinstance(values, list) or len(values) != 6:
        raise InputError(f"{where}: extents: must be six numbers (got {shown_value(values)})")
    for value in values:
        is_number = isinstance(value, int | float) and not isinstance(value, bool)
        if not is_number or not abs(value) <= 1e9 or not math.isfinite(value):
            raise InputError(f"{where}: extents: must be finite numbers (got {shown_value(value)})")
    for low, high in zip(values[::2], values[1::2], strict=True):
        if not low < high:
            raise InputError(
                f"{where}: extents: must be least, largest along x, y, z (got {low:g}, {high:g})"
            )
    return [float(value) for value in values]

"""CSV exports of Vicon's Nexus and Tracker: blocks of segments, objects and trajectories.

A rotation is a quaternion (RX RY RZ RW) or a rotation vector (RX RY RZ).  Where a file has markers
that move with a body, its rotation vectors are tried on them, and Euler angles as well.
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.errors import InputError, shown_value
from springback.logs.formats.text import (
    NumberColumns,
    metres,
    open_text,
    positive,
    table_lines,
)
from springback.logs.frame_turns import (
    BODIES,
    WORLDS,
    attitudes_in,
    conjugate,
    vector_quaternion,
    vectors_in,
    world_vectors,
)
from springback.logs.recording import (
    ATTITUDE,
    MARKERS,
    POSITION,
    Array,
    Budget,
    LogChannel,
    Recording,
    SensorChain,
    TimeSpan,
    log_channel,
    refuse_without_channels,
)

#: Titles of blocks that are read; others, such as Devices, are named in a remark.
TITLES = frozenset({"Objects", "Segments", "Trajectories"})
ALL_TITLES = TITLES | {"Joints", "Devices", "Model Outputs", "Events"}


class _Block(NamedTuple):
    title: str
    rate: float
    groups: dict[str, dict[str, int]]  # of each name, axis to place among the values
    units: dict[str, str]  # of an axis
    columns: NumberColumns


def read_vicon(path: Path, part: TimeSpan, world: str, body: str) -> Recording:
    """Recording of a CSV file of Nexus or Tracker.

    Args:
        path: The file.
        part: Instants that are wanted, from frame 1 on [s].
        world: Name of its world axes, of `springback.logs.frame_turns.WORLDS`.
        body: Name of its body axes, of `springback.logs.frame_turns.BODIES`.

    Raises:
        InputError: If it is none, or nothing of it can be used.
    """
    where, budget, remarks = str(path), Budget(str(path)), list[str]()
    channels: list[LogChannel] = []
    markers: LogChannel | None = None
    bodies: list[tuple[str, Array, Array, Array, str]] = []
    for block in _blocks(path, budget, remarks):
        values = block.columns.values()
        if not len(values):
            continue
        if np.isnan(values[:, 0]).any():
            raise InputError(f"{where}: {block.title}: a line has no number of its frame")
        times = (values[:, 0] - 1.0) / block.rate
        chosen = np.array([part.has(at) for at in times], dtype=bool)
        values, times = values[chosen], times[chosen]
        if not len(times):
            continue
        if block.title == "Trajectories":
            markers = _markers(where, block, times, values, world)
            channels.append(markers)
        else:
            bodies += _bodies(where, block, times, values)
    for name, times, position, turn, kind in bodies:
        q = _attitudes(where, name, position, turn, kind, times, markers, world, remarks)
        chain = SensorChain(note="solved of markers by Vicon")
        for what, quantity, numbers in (
            ("position", POSITION, vectors_in(WORLDS[world], position)),
            ("attitude", ATTITUDE, attitudes_in(WORLDS[world], BODIES[body], q)),
        ):
            channels.append(
                log_channel(
                    where, f"{name}.{what}", quantity, times, numbers, clock="motion capture",
                    chain=chain,
                )
            )  # fmt: skip
    refuse_without_channels(where, channels, ", ".join(sorted(TITLES)), remarks)
    return Recording(path, "Vicon CSV", tuple(channels), remarks=tuple(remarks))


def _blocks(path: Path, budget: Budget, remarks: list[str]) -> list[_Block]:
    """All blocks of a file that are read."""
    where, found = str(path), list[_Block]()
    rows: list[list[str]] | None = None  # of a block's header, until it is complete
    title, skipped = "", False
    block: _Block | None = None
    with open_text(path) as file:
        for line, cells in table_lines(file, where, ","):
            words = [cell.strip() for cell in cells]
            if words and words[0] in ALL_TITLES and not any(words[1:]):
                title, rows, block = words[0], [], None
                skipped = title not in TITLES
                if skipped:
                    remarks.append(f"{title} are not read")
                continue
            if skipped or not any(words):
                continue
            if rows is None:
                raise InputError(
                    f"{where}:{line}: must be the title of a block, such as Segments or Objects "
                    f"(got {shown_value(words[0])})"
                )
            if block is None:
                rows.append(words)
                if len(rows) == 4:
                    block = _begun(where, line, title, rows, budget)
                    found.append(block)
                continue
            block.columns.add(line, cells)
    return found


def _begun(where: str, line: int, title: str, rows: list[list[str]], budget: Budget) -> _Block:
    """A block of its header: rate, names, axes and units."""
    (rate, *_), names, axes, units = rows
    if axes[:2] != ["Frame", "Sub Frame"]:
        raise InputError(
            f"{where}:{line - 1}: must begin with Frame,Sub Frame (got {shown_value(axes[0])})"
        )
    groups: dict[str, dict[str, int]] = {}
    labels, places, name = ["Frame"], [0], ""
    known: dict[str, str] = {}
    for k, axis in enumerate(axes[2:], start=2):
        name = names[k] if k < len(names) and names[k] else name
        if not axis:
            continue
        groups.setdefault(name.rpartition(":")[2] or name, {})[axis] = len(places)
        known.setdefault(axis, units[k] if k < len(units) else "")
        labels.append(f"{name} {axis}")
        places.append(k)
    hertz = positive(rate, where, f"the rate of {title}")
    return _Block(title, hertz, groups, known, NumberColumns(where, labels, places, budget))


def _markers(where: str, block: _Block, times: Array, values: Array, world: str) -> LogChannel:
    names = [name for name, group in block.groups.items() if {"X", "Y", "Z"} <= group.keys()]
    if not names:
        raise InputError(f"{where}: Trajectories have no columns X, Y, Z")
    scale = metres(block.units["X"], where)
    parts = [values[:, [block.groups[name][axis] for axis in "XYZ"]] * scale for name in names]
    turned = [vectors_in(WORLDS[world], part) for part in parts]
    return log_channel(
        where, "markers", MARKERS, times, np.concatenate(turned, axis=1), clock="motion capture",
        labels=tuple(names),
    )  # fmt: skip


def _bodies(
    where: str, block: _Block, times: Array, values: Array
) -> list[tuple[str, Array, Array, Array, str]]:
    """Name, times, position, rotation and its kind, of each body."""
    found = []
    for name, group in block.groups.items():
        if not {"RX", "RY", "RZ", "TX", "TY", "TZ"} <= group.keys():
            continue
        position = values[:, [group[f"T{axis}"] for axis in "XYZ"]] * metres(
            block.units["TX"], where
        )
        turn = values[:, [group[f"R{axis}"] for axis in "XYZ"]]
        kind, unit = "vector", block.units["RX"]
        if "RW" in group:
            turn, kind = np.concatenate([values[:, [group["RW"]]], turn], axis=1), "quaternion"
        elif unit == "deg":
            turn = np.radians(turn)
        elif unit != "rad":
            raise InputError(f"{where}: {name}: angles are in {shown_value(unit)}, not deg or rad")
        found.append((name, times, position, turn, kind))
    return found


def _attitudes(
    where: str,
    name: str,
    position: Array,
    turn: Array,
    kind: str,
    times: Array,
    markers: LogChannel | None,
    world: str,
    remarks: list[str],
) -> Array:
    """Quaternions of a body's rotations, tried on its markers."""
    if kind == "quaternion":
        return turn
    vector = vector_quaternion(turn)
    if markers is None or len(markers.times) != len(times):
        remarks.append(
            f"{name}: RX, RY, RZ are read as a rotation vector, and no marker of the file shows "
            "whether they are"
        )
        return vector
    places = vectors_in(
        WORLDS[world].T, markers.values.reshape(len(times), -1, 3)
    )  # back in its axes
    known = ~np.isnan(turn).any(axis=1)
    euler = np.full_like(vector, np.nan)
    if known.any():
        rotation = scipy.spatial.transform.Rotation.from_euler("XYZ", turn[known])
        euler[known] = rotation.as_quat(scalar_first=True)
    spread = [_spread(position, q, places) for q in (vector, euler)]
    if spread[1] < 0.5 * spread[0]:
        remarks.append(
            f"{name}: its markers stand still in the body by Euler angles XYZ (within "
            f"{1e3 * spread[1]:.2g} mm), not by a rotation vector ({1e3 * spread[0]:.2g} mm)"
        )
        return euler
    return vector


def _spread(position: Array, q: Array, places: Array) -> float:
    """How much the steadiest four markers move in a body's axes: the median deviation [m]."""
    inside = world_vectors(conjugate(q)[:, None, :], places - position[:, None, :])
    if np.isnan(inside).all():
        return np.inf
    steady = [
        float(np.sqrt(np.nanvar(inside[:, k], axis=0).sum()))
        for k in range(inside.shape[1])
        if not np.isnan(inside[:, k]).all()
    ]
    return float(np.median(sorted(steady)[:4]))

"""All columns of a flight as signals for the plots of the replay page.

A page holds two tables: the trajectory at the drawn instants, and the telemetry on its own clock,
at every tick near impacts, alarms and changes of phase, elsewhere up to `MOST_FAR` ticks.  A column
is rounded to 1 / 65534 of its range and stored as differences of 16-bit integers; columns of small
integers, such as phases and flags, are exact.  Each table is compressed by zlib.
"""

from __future__ import annotations

import base64
import math
import re
import zlib
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from springback.frames import euler_from_attitude
from springback.interfaces.output.quantities import DisplayUnit, display_unit
from springback.interfaces.replay.scene import Scene
from springback.recovery.state_machine import PHASES
from springback.results.flight import Flight

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Every tick is kept from this time before an event to this time after it [s] ...
BEFORE, AFTER = 0.05, 0.25
#: ... for this number of events at most; beyond them, this number of ticks (chosen: 1 kHz for 3 s).
MOST_EVENTS, MOST_FAR = 16, 3000
#: Largest integer of a column: 16 bits, one value less.
LEVELS = 65534
#: Numbers beyond this are shown as this, so that the range of a column is finite.
LARGEST = 1e300
#: Groups of the chooser, by what the whole name of a column matches; the first match counts.
GROUPS = {
    "Position": "[xyz]",
    "Attitude": "q[wxyz]|roll|pitch|yaw",
    "Velocity": "v[xyz]",
    "Angular velocity, body axes": "w[xyz]",
    "Arm length": r"l\d+",
    "Arm speed": r"dl\d+",
    "Arm bend, second joint": r"bend\d+",
    "Arm bend speed": r"dbend\d+",
    "Acceleration": "a[xyz]",
    "Normal force": "fn.*",
    "Friction": "ff.*",
    "Rotor thrust, commanded": r"command\d+",
    "Rotor thrust": r"thrust\d+",
    "Inertial unit": "imu_.*",
    "Motion capture": "pose_.*",
    "Hall sensors: arm length": r"hall\d+",
    "Estimate": "est_.*",
    "Reference": "ref_.*",
    "Setpoint of attitude and thrust": "aim_.*",
    "Detection: phase and alarms": "phase|alarm|alarms_.*|pressed|jolt|push",
    "Recovery: goal, impact": "goal_.*|force_.*|moment_.*|hit_.*",
    "Others": ".*",
}
#: Groups of lengths of arms.
IN_MILLIMETRES = ("Arm length", "Arm bend, second joint", "Hall sensors: arm length")


class SignalTable(NamedTuple):
    """Signals on one clock."""

    t: Array  # instants [s], shape (n,)
    columns: Mapping[str, Array]  # by name, each of shape (n,)
    units: Mapping[str, str]
    every: int  # 1 if all ticks are held, else every so many away from events


def group_of(name: str) -> str:
    """Group of a column."""
    return next(group for group, names in GROUPS.items() if re.fullmatch(names, name))


def shown_unit(name: str, unit: str) -> DisplayUnit:
    """Unit in which a column of an SI unit is shown: lengths of arms in mm, as their compression.

    The symbol of a column without unit is empty.
    """
    if unit == "m" and group_of(name) in IN_MILLIMETRES:
        return DisplayUnit("mm", 1e3)
    return display_unit(unit) if unit else DisplayUnit("", 1.0)


def signal_tables(flight: Flight, scene: Scene) -> dict[str, SignalTable]:
    """Trajectory and, if the flight has a pilot, telemetry.

    Attitudes are also given as roll, pitch and yaw [deg], positive pitch being nose down.

    Args:
        flight: With its trajectory.
        scene: The same flight as a scene, with its instants and events.
    """
    drawn = np.searchsorted(flight.columns["t"], scene.t)
    tables = {"trajectory": _table(flight, flight.columns, drawn, 1)}
    if len(flight.telemetry.get("t", ())):
        ticks, every = _ticks(flight.telemetry["t"], scene)
        tables["telemetry"] = _table(flight, flight.telemetry, ticks, every)
    return tables


def _ticks(t: Array, scene: Scene) -> tuple[Any, int]:
    """Indices of the ticks that are held, and the spacing of those far from events."""
    events = [event.t for event in scene.events if event.kind in ("touch", "alarm", "phase")]
    near = np.zeros(len(t), dtype=bool)
    for when in events[:MOST_EVENTS]:
        near |= (t >= when - BEFORE) & (t <= when + AFTER)
    every = max(1, math.ceil(int(np.sum(~near)) / MOST_FAR))
    keep = near | (np.arange(len(t)) % every == 0)
    keep[-1] = True
    return np.flatnonzero(keep), every


def _table(flight: Flight, columns: Mapping[str, Array], at: Any, every: int) -> SignalTable:
    found = {name: values[at] for name, values in columns.items() if name != "t"}
    units = {name: flight.units.get(name, "") for name in found}
    for prefix in [name[:-2] for name in found if re.fullmatch(r"(\w+_)?qw", name)]:
        if not all(f"{prefix}q{part}" in found for part in "xyz"):  # of a foreign file
            continue
        quaternion = np.stack([found[f"{prefix}q{part}"] for part in "wxyz"], axis=1)
        quaternion[~(np.abs(quaternion).max(axis=1) > 0.0)] = [1.0, 0.0, 0.0, 0.0]  # not known yet
        angles = np.rad2deg(euler_from_attitude(quaternion))
        for name, values in zip(("roll", "pitch", "yaw"), angles.T, strict=True):
            found[prefix + name], units[prefix + name] = values, "deg"
    return SignalTable(columns["t"][at], found, units, every)


# -- as JSON --------------------------------------------------------------------------------------


def plain_signals(flight: Flight, scene: Scene) -> dict[str, Any]:
    """Signals of a flight, and of its scene, as plain data for JSON.

    By clock, ``trajectory`` or ``telemetry``: ``t`` as in the scene; ``every``; ``columns``, each
    with ``name``, ``group``, the ``unit`` in which it is shown, ``factor`` from SI to that, and
    ``low`` and ``step``, so that a value is low + step k; ``data``, base64 of zlib of the columns
    in turn, each first the lower, then the upper bytes of the differences of k from one instant to
    the next, modulo 65536. ``words`` are words for the values 0, 1, … of columns.
    """
    tables = {clock: _plain_table(table) for clock, table in signal_tables(flight, scene).items()}
    return {**tables, "words": {"phase": list(PHASES)}}


def _plain_table(table: SignalTable) -> dict[str, Any]:
    heads, parts = [], []
    for name, values, low, step, levels in _round_columns(table):
        unit = shown_unit(name, table.units[name])
        heads.append({"name": name, "unit": unit.symbol, "factor": unit.factor,
                      "group": group_of(name), "low": low, "step": step})  # fmt: skip
        steps = np.diff(levels, prepend=0).astype("<u2")  # modulo 65536
        parts.append(steps.view(np.uint8).reshape(len(values), 2).T.tobytes())
    text = base64.b64encode(zlib.compress(b"".join(parts), 9)).decode("ascii")
    t = base64.b64encode(table.t.astype("<f8").tobytes()).decode("ascii")
    return {
        "t": {"type": "f8", "shape": [len(table.t)], "data": t},
        "every": table.every,
        "columns": heads,
        "data": text,
    }


def _round_columns(table: SignalTable) -> Iterator[tuple[str, Array, float, float, Any]]:
    """Columns with offset, step and integers, all finite."""
    for name, values in table.columns.items():
        known = np.clip(np.nan_to_num(values), -LARGEST, LARGEST)
        low, span = float(known.min()), float(np.ptp(known))
        whole = span <= LEVELS and bool(np.all(known == np.round(known)))
        step = 1.0 if whole else span / LEVELS or 1.0
        yield name, known, low, step, np.round((known - low) / step).astype(np.int64)

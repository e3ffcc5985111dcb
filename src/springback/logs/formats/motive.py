"""CSV exports of OptiTrack's Motive (format versions 1.2x).

Rows of the header are found by their labels, since their number and order differ between versions.
Quaternions are XYZW; a blank cell is a lost frame.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from springback.errors import InputError, shown_value
from springback.logs.formats.text import (
    MOST_HEADER,
    NumberColumns,
    metres,
    open_text,
    positive,
    table_lines,
)
from springback.logs.frame_turns import BODIES, WORLDS, attitudes_in, vectors_in
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

#: First words of the file.
MAGIC = "Format Version"
LABELS = frozenset({"Type", "Name", "ID", "Parent"})


class _Header:
    """Rows above the data."""

    def __init__(self, where: str) -> None:
        self.where = where
        self.settings: dict[str, str] = {}
        self.rows: dict[str, list[str]] = {}
        self.axes: list[str] = []

    def take(self, cells: list[str]) -> bool:
        """Take a row; True for the last one, which names the axes."""
        if not self.settings and cells and cells[0].strip() == MAGIC:
            words = [cell.strip() for cell in cells]
            self.settings = dict(zip(words[::2], words[1::2], strict=False))
            return False
        label = next((cell.strip() for cell in cells[:3] if cell.strip()), "")
        if label in LABELS:
            self.rows[label] = [cell.strip() for cell in cells]
        elif {"Rotation", "Position"} & {cell.strip() for cell in cells}:
            self.rows["kind"] = [cell.strip() for cell in cells]
        elif label == "Frame":
            self.axes = [cell.strip() for cell in cells]
            return True
        return False

    def row(self, name: str) -> list[str]:
        """A row, filled up to the width of the axes."""
        found = self.rows.get(name, [])
        return found + [""] * (len(self.axes) - len(found))

    def check(self) -> None:
        """Refuse what cannot be read.

        Raises:
            InputError: If a row is missing, or angles or a space are not those that are known.
        """
        for name in ("Type", "Name", "kind"):
            if name not in self.rows:
                row = "Rotation and Position" if name == "kind" else name
                raise InputError(f"{self.where}: has no row of {row} above its data")
        rotation = self.settings.get("Rotation Type", "Quaternion")
        if rotation != "Quaternion":
            raise InputError(
                f"{self.where}: Rotation Type is {shown_value(rotation)}: export it as Quaternion"
            )
        space = self.settings.get("Coordinate Space", "Global")
        if space != "Global":
            raise InputError(
                f"{self.where}: Coordinate Space is {shown_value(space)}: export it as Global"
            )
        if len(self.axes) < 2 or self.axes[1].split(" (")[0] != "Time":
            raise InputError(f"{self.where}: has no column of Time beside Frame")


def read_motive(path: Path, part: TimeSpan, world: str, body: str) -> Recording:
    """Recording of a CSV file of Motive.

    Args:
        path: The file.
        part: Instants that are wanted [s].
        world: Name of its world axes, of `springback.logs.frame_turns.WORLDS`.
        body: Name of its body axes, of `springback.logs.frame_turns.BODIES`.

    Raises:
        InputError: If it is none, or nothing of it can be used.
    """
    where, budget = str(path), Budget(str(path))
    header = _Header(where)
    columns: NumberColumns | None = None
    groups: dict[tuple[str, str], dict[str, int]] = {}
    with open_text(path) as file:
        for line, cells in table_lines(file, where, ","):
            if columns is None:
                if header.take(cells):
                    header.check()
                    groups = _groups(header)
                    places = sorted({k for one in groups.values() for k in one.values()})
                    names = ["Time", *(f"{header.row('Name')[k]} {header.axes[k]}" for k in places)]
                    columns = NumberColumns(where, names, [1, *places], budget)
                elif line > MOST_HEADER:
                    break
            elif len(cells) > 1:
                try:
                    wanted = part.has(float(cells[1]))
                except ValueError:
                    wanted = True  # refused below, by name
                if wanted:
                    columns.add(line, cells)
    if columns is None:
        raise InputError(f"{where}: has no row that begins with Frame")
    values = columns.values()
    if not len(values):
        raise InputError(f"{where}: has no frames")
    scale = metres(header.settings.get("Length Units", "Meters"), where)
    at = {place: k for k, place in enumerate(columns.places)}
    channels = _channels(where, groups, at, values, scale, world, body)
    refuse_without_channels(where, channels, "rigid bodies and markers")
    remarks = ["poses are those that Motive solved of its markers, and may be smoothed"]
    if "Export Frame Rate" in header.settings and "Capture Frame Rate" in header.settings:
        rates = [
            positive(header.settings[f"{name} Frame Rate"], where, f"{name} Frame Rate")
            for name in ("Capture", "Export")
        ]
        if rates[0] != rates[1]:
            remarks.append(f"was captured at {rates[0]:g} Hz and exported at {rates[1]:g} Hz")
    return Recording(path, "Motive CSV", tuple(channels), (), dict(header.settings), tuple(remarks))


def _groups(header: _Header) -> dict[tuple[str, str], dict[str, int]]:
    """Columns by type and name of what they belong to: `Position X` and so on."""
    found: dict[tuple[str, str], dict[str, int]] = {}
    types, names, kinds = header.row("Type"), header.row("Name"), header.row("kind")
    for k, axis in enumerate(header.axes[2:], start=2):
        if axis in ("X", "Y", "Z", "W") and kinds[k] in ("Rotation", "Position"):
            found.setdefault((types[k], names[k]), {})[f"{kinds[k]} {axis}"] = k
    return found


def _channels(
    where: str,
    groups: dict[tuple[str, str], dict[str, int]],
    at: dict[int, int],
    values: Array,
    scale: float,
    world: str,
    body: str,
) -> list[LogChannel]:
    times = values[:, 0]
    if np.isnan(times).any():
        bad = int(np.flatnonzero(np.isnan(times))[0])
        raise InputError(f"{where}: frame {bad + 1} of its data has no time")
    found: list[LogChannel] = []
    solved = SensorChain(smoothed=True, note="solved of markers by Motive")
    places: dict[str, Array] = {}

    def part(group: dict[str, int], kind: str, axes: str) -> Array | None:
        keys = [f"{kind} {axis}" for axis in axes]
        if not set(keys) <= group.keys():
            return None
        return values[:, [at[group[key]] for key in keys]]

    for (kind, name), group in groups.items():
        position = part(group, "Position", "XYZ")
        if position is None:
            continue
        position = vectors_in(WORLDS[world], position * scale)
        if kind == "Marker":
            places[name] = position
        elif kind == "Rigid Body":
            found.append(
                log_channel(
                    where, f"{name}.position", POSITION, times, position, clock="motion capture",
                    chain=solved,
                )
            )  # fmt: skip
            q = part(group, "Rotation", "WXYZ")
            if q is not None:
                attitude = attitudes_in(WORLDS[world], BODIES[body], q)
                found.append(
                    log_channel(
                        where, f"{name}.attitude", ATTITUDE, times, attitude,
                        clock="motion capture", chain=solved,
                    )
                )  # fmt: skip
    if places:
        found.append(
            log_channel(
                where, "markers", MARKERS, times, np.concatenate(list(places.values()), axis=1),
                clock="motion capture", labels=tuple(places),
            )
        )  # fmt: skip
    return found

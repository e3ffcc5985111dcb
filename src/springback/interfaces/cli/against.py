"""What ``springback fly --against`` does: a replay of a recorded impact, and its table."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from springback.errors import InputError

if TYPE_CHECKING:
    from springback.identification.replays.errors import ChannelErrors, ErrorRow
    from springback.identification.replays.replay import Replay

#: Units that are shown, with their factors.
SHOWN = {"m": ("mm", 1e3), "rad": ("deg", float(np.degrees(1.0))), "s": ("ms", 1e3)}
#: Mark of an error that the uncertainty does not explain.
MARK = "*"


class ReplayTable(NamedTuple):
    """A replay with its errors."""

    flown: Replay
    channels: list[ChannelErrors]
    rows: list[ErrorRow]


def replay_against(
    scenario: Path,
    overrides: Sequence[str],
    logs: Sequence[Path],
    reading: dict[str, Any],
    wanted: dict[str, Any],
) -> ReplayTable:
    """Replay a recorded impact.

    Args:
        scenario: Its file.
        overrides: Of the scenario.
        logs: Of one flight.
        reading: Fields of `springback.logs.reading.LogOptions`, the vehicle's ``track``, and
            ``no_check``, to go on where the data contradict their axes.
        wanted: Fields of `springback.identification.replays.replay.ReplayOptions`.

    Raises:
        InputError: If a log or the scenario cannot be used, in one line.
    """
    from springback.identification.replays.errors import channel_errors, error_rows
    from springback.identification.replays.replay import ReplayOptions, replay, scenario_tables
    from springback.interfaces.cli.identify.logs import recordings_of
    from springback.logs.axes_options import refuse_wrong_axes
    from springback.logs.clock_jumps import refuse_clock_jumps
    from springback.logs.frame_check import refuse_units
    from springback.logs.overview import damages
    from springback.logs.time_units import refuse_time_units
    from springback.logs.vehicle_track import with_vehicle

    reading = dict(reading)
    ready, tables = scenario_tables(scenario, overrides)
    track, goes_on = reading.pop("track", None), bool(reading.pop("no_check", False))
    read = recordings_of(logs, **reading)
    refuse_time_units(read)
    recordings = with_vehicle(read, track)
    refuse_clock_jumps(recordings)
    for one in recordings:
        refuse_units(one)
    axes = reading.get("world"), reading.get("body")
    doubts = refuse_wrong_axes(recordings, *axes, goes_on=goes_on)
    flown = replay(ready, tables, recordings, ReplayOptions(**wanted))
    flown.warnings[:0] = [*damages(recordings), *doubts]
    channels = channel_errors(flown)
    return ReplayTable(flown, channels, error_rows(flown, channels))


def rotor_order(text: str | None) -> tuple[int, ...]:
    """Numbers of logged rotors, such as ``1,3,2,4``.

    Raises:
        InputError: If they are no whole numbers.
    """
    if text is None:
        return ()
    try:
        return tuple(int(word) for word in text.split(","))
    except ValueError:
        raise InputError(f"--rotors: must be numbers such as 1,3,2,4 (got {text!r})") from None


def against_text(told: ReplayTable) -> str:
    """A replay on the terminal: the answer, the table, and how it was flown."""
    from springback.identification.replays.errors import verdict

    impact = told.flown.impact
    lines = [f"against {impact.log} at {impact.touch:.3f} s: {verdict(told.rows)}", ""]
    instants = _instant_table(told.rows)
    lines += [*instants, ""] if instants else []
    lines += _read_off_table(told.rows)
    return "\n".join([*lines, "", *told.flown.told])


def _instant_table(rows: Sequence[ErrorRow]) -> list[str]:
    """Errors at the instants, one line for each quantity; nothing without one."""
    whole = [row for row in rows if row.part == "all" and row.wanted is not None]
    if not whole:
        return []
    instants = sorted({row.wanted for row in whole if row.wanted is not None})
    heads = ["at touch" if at == 0.0 else f"{1e3 * at:.0f} ms" for at in instants]
    table = [["error (uncertainty)", *heads]]
    for what in dict.fromkeys(row.what for row in whole):
        unit, factor = _unit(next(row.unit for row in whole if row.what == what))
        cells = [f"{what} [{unit}]"]
        for at in instants:
            found = next((row for row in whole if (row.what, row.wanted) == (what, at)), None)
            cells.append("-" if found is None else _cell(found, factor))
        table.append(cells)
    return _columns(table)


def _read_off_table(rows: Sequence[ErrorRow]) -> list[str]:
    """What is read off whole curves."""
    table = [["", "recorded", "predicted", "error (uncertainty)"]]
    for row in rows:
        if row.wanted is None and row.recorded is not None and row.predicted is not None:
            unit, factor = _unit(row.unit)
            numbers = [f"{factor * value:.4g}" for value in (row.recorded, row.predicted)]
            table.append([f"{row.what} [{unit}]", *numbers, _cell(row, factor)])
    marks = (
        f"{MARK} beyond twice the uncertainty, which is that of the samples, the start, the clocks "
        "and the biases"
    )
    return [*(_columns(table) if len(table) > 1 else []), marks]


def _unit(unit: str) -> tuple[str, float]:
    return SHOWN.get(unit, (unit, 1.0))


def _cell(row: ErrorRow, factor: float) -> str:
    mark = MARK if row.is_beyond else ""
    return f"{factor * row.error:.3g} ({factor * row.uncertainty:.2g}){mark}"


def _columns(table: Sequence[Sequence[str]]) -> list[str]:
    widths = [max(len(row[k]) for row in table) for k in range(len(table[0]))]
    return [
        "  ".join(f"{cell:<{width}}" for cell, width in zip(row, widths, strict=True)).rstrip()
        for row in table
    ]

"""Files of a replay against a recording: all numbers, a table of errors, an overlay."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from springback.files import write_csv, write_json
from springback.identification.replays.errors import (
    ChannelErrors,
    ErrorRow,
    as_data,
    row_data,
)
from springback.identification.replays.replay import Replay
from springback.interfaces.reports.flight_files import AGAINST_FILES


def write_against(
    flown: Replay,
    channels: Sequence[ChannelErrors],
    rows: Sequence[ErrorRow],
    folder: Path,
    *,
    figures: bool = True,
) -> list[Path]:
    """Write ``against.json``, ``against.csv`` (errors), and ``against.png`` with its numbers.

    Args:
        flown: Replay.
        channels: Its errors over time.
        rows: Its table.
        folder: Folder to write into.
        figures: Write the figure, too.

    Returns:
        The files written.
    """
    summary, table, figure, curves = (folder / name for name in AGAINST_FILES)
    written = [summary, table]
    write_json(summary, as_data(flown, rows))
    write_csv(table, [row_data(row) for row in rows])
    if figures:
        from springback.interfaces.figures.recordings import overlay_figure
        from springback.interfaces.figures.style import picture

        contact = flown.impact.release - flown.impact.touch
        title = f"{flown.problem.scenario.name} against {flown.problem.impact.name}"
        drawn, numbers = picture(overlay_figure, channels, flown.touch, contact, title)
        figure.write_bytes(drawn)
        curves.write_text(numbers, encoding="utf-8")
        written += [figure, curves]
    return written

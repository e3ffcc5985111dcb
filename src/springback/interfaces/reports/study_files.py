"""Files of a study: numbers as JSON and CSV, and figures."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from springback.files import write_csv, write_json

if TYPE_CHECKING:
    from springback.interfaces.figures.style import StyledFigure


def write_study(
    folder: Path,
    name: str,
    data: Mapping[str, Any],
    tables: Mapping[str, Sequence[Mapping[str, Any]]],
    figures: Mapping[str, StyledFigure],
) -> list[Path]:
    """Write a JSON file, CSV files, and figures as PNG and PDF.

    Args:
        folder: Folder to write into.
        name: Name of the JSON file, without suffix.
        data: Its content.
        tables: Rows of the CSV files, by name.
        figures: Figures by name; one without a table of its name gets a CSV file of its numbers.

    Returns:
        The files written.
    """
    written = [folder / f"{stem}.{kind}" for stem, kind in
               ((name, "json"), *((stem, "csv") for stem in tables))]  # fmt: skip
    write_json(written[0], data)
    for path, rows in zip(written[1:], tables.values(), strict=True):
        write_csv(path, rows)
    for stem, figure in figures.items():
        from springback.interfaces.figures.style import save

        written += save(figure, folder / stem, numbers=stem not in tables)
    return written

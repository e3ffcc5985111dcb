"""Output folders and files: written whole or not at all, never over results unasked."""

from __future__ import annotations

import json
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from springback.errors import InputError
from springback.experiments.parquet import write_parquet
from springback.experiments.result import Flight


def _existing_ancestor(folder: Path) -> Path:
    return next(parent for parent in (folder, *folder.parents) if parent.exists())


@contextmanager
def output_folder(folder: Path, *, force: bool = False) -> Iterator[Path]:
    """A folder to write into, which becomes ``folder`` when the block ends well.

    If the block fails, nothing is left and nothing that was there is touched.  With ``force``,
    files of the same names are replaced and all others stay.

    Raises:
        InputError: If the folder cannot be written, is a file, or has results and ``force`` is off.
    """
    folder = folder.absolute()
    if folder.exists() and not folder.is_dir():
        raise InputError(f"--out {folder}: is a file, not a folder")
    if folder.exists() and any(folder.iterdir()) and not force:
        raise InputError(
            f"--out {folder}: is not empty; give another folder, or --force to replace results"
        )
    anchor = _existing_ancestor(folder.parent)
    try:
        if folder.exists() and not os.access(folder, os.W_OK):
            raise PermissionError(13, "Permission denied")
        draft = Path(tempfile.mkdtemp(prefix=f".{folder.name}-", dir=anchor))
    except OSError as error:
        raise InputError(f"--out {folder}: cannot be written ({error.strerror})") from None
    try:
        yield draft
        _move(draft, folder)
    finally:
        shutil.rmtree(draft, ignore_errors=True)


def _move(draft: Path, folder: Path) -> None:
    for source in sorted(draft.rglob("*")):
        target = folder / source.relative_to(draft)
        if source.is_dir():
            target.mkdir(parents=True, exist_ok=True)
        else:
            target.parent.mkdir(parents=True, exist_ok=True)
            os.replace(source, target)


def write_json(path: Path, data: Any) -> None:
    """Plain data as JSON, without NaN or infinity."""
    path.write_text(
        json.dumps(data, indent=2, allow_nan=False, ensure_ascii=False) + "\n", encoding="utf-8"
    )


def write_flight(flight: Flight, folder: Path, *, figures: bool = True) -> list[Path]:
    """Write ``summary.json``, ``trajectory.parquet``, with a pilot ``diary.parquet``, and figures.

    Figures are ``flight.png`` and ``energy.png``; with a pilot ``flight.png`` shows the whole
    flight beside what was wanted, and ``impact.png`` the collision if there was one.  What each
    shows is in a CSV file of the same name.

    Args:
        flight: Any.
        folder: To write into.
        figures: Whether figures are wanted.

    Returns:
        The files written.
    """
    summary = flight.summary()
    write_json(folder / "summary.json", summary)
    written = [folder / "summary.json"]
    about = {
        "springback": summary["springback"],
        "name": flight.scenario.name,
        "frames": "world NWU, body FLU",
    }
    for stem, columns in {"trajectory": flight.columns, "diary": flight.diary}.items():
        if columns:
            path = folder / f"{stem}.parquet"
            write_parquet(path, columns, {name: flight.units[name] for name in columns}, about)
            written.append(path)
    if figures:
        for stem, (picture, numbers) in _pictures(flight).items():
            written += [folder / f"{stem}.png", folder / f"{stem}.csv"]
            written[-2].write_bytes(picture)
            written[-1].write_text(numbers, encoding="utf-8")
    return written


def _pictures(flight: Flight) -> dict[str, tuple[bytes, str]]:
    """The figures of a flight by name: PNG files, and what they show as CSV."""
    from springback.interfaces import canvas, plots

    found = {
        "flight": canvas.picture(plots.flight_figure, flight),
        "energy": canvas.picture(plots.energy_figure, flight),
    }
    if flight.diary and flight.measures["touch_time"] is not None:
        found["impact"] = canvas.picture(plots.impact_figure, flight)
    return found

"""Files of a flight: numbers and figures."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

from springback.contact.grids.form_copies import FORMS, write_forms
from springback.files import write_json
from springback.interfaces.output.folders import SUMMARY, output_folder
from springback.interfaces.output.python_wording import python_words
from springback.results.contacts.stored import CONTACTS, contact_columns
from springback.results.flight import Flight
from springback.results.parquet import write_parquet
from springback.results.saved import SECOND
from springback.results.sealed_json import file_digest, with_digest
from springback.scenario.worlds.imported import single_obstacles
from springback.version import __version__

_NAMES = (
    "trajectory.parquet", "telemetry.parquet",
    *(f"{name}.{kind}" for name in ("flight", "energy", "impact") for kind in ("png", "csv")),
)  # fmt: skip
#: Files of a replay against a recording.
AGAINST_FILES = ("against.json", "against.csv", "against.png", "against_curves.csv")
#: Files of a flight, which are removed when another one replaces it.
FLIGHT_FILES = (
    SUMMARY,
    FORMS,
    CONTACTS,
    *_NAMES,
    *(SECOND + name for name in _NAMES),
    *AGAINST_FILES,
)


def save_flight(
    flight: Flight, folder: str | Path, *, force: bool = False, figures: bool = True
) -> list[Path]:
    """Write a flight's files to a folder, completely or not at all: `springback.Flight.save`."""
    drawn = figures and find_spec("matplotlib") is not None
    with (
        python_words(),
        output_folder(Path(folder), force=force, replaces=FLIGHT_FILES) as draft,
    ):
        written = write_flight(flight, draft, figures=drawn)
    return [Path(folder) / path.name for path in written]


def write_flight(flight: Flight, folder: Path, *, figures: bool = True) -> list[Path]:
    """Write ``summary.json``, ``trajectory.parquet``, ``telemetry.parquet`` if any, and figures.

    With obstacles of the user's own ``contacts.parquet`` has the force and place of each contact.

    Figures are ``flight.png`` and ``energy.png``; with a pilot ``flight.png`` shows the whole
    flight with its reference, and ``impact.png`` the collision if there was one; so it does without
    a pilot where ``flight.png`` shows more than that.  The numbers of each are in a CSV file of the
    same name.  The summary lists all files with their digests
    (``files``) and its own (``seal``), so that files of other flights are recognised.  Those of a
    second vehicle have the same names after ``second_``; the summary has its outcome and measures.

    Args:
        flight: Any.
        folder: Folder to write into.
        figures: Write figures, too.

    Returns:
        The files written.
    """
    summary = flight.summary()
    written = _write_vehicle(flight, folder, "", figures)
    columns, units = contact_columns(flight)
    if columns:
        write_parquet(folder / CONTACTS, columns, units, _about(flight))
        written.append(folder / CONTACTS)
    if flight.second is not None:
        written += _write_vehicle(flight.second, folder, SECOND, figures)
    world = flight.scenario.world
    single = world.model_copy(update={"obstacles": single_obstacles(world.obstacles)})
    written += write_forms(single, folder)
    files = {path.name: file_digest(path) for path in written}
    write_json(folder / SUMMARY, with_digest(summary | {"files": files}))
    return [folder / SUMMARY, *written]


def _about(flight: Flight) -> dict[str, str]:
    """Metadata of the tables of a flight."""
    return {
        "springback": __version__,
        "name": flight.scenario.name,
        "frames": "world NWU, body FLU",
    }


def _write_vehicle(flight: Flight, folder: Path, prefix: str, figures: bool) -> list[Path]:
    """Write trajectory, telemetry and figures of one vehicle; returns the files."""
    written, about = [], _about(flight)
    for stem, columns in {"trajectory": flight.columns, "telemetry": flight.telemetry}.items():
        if columns:
            path = folder / f"{prefix}{stem}.parquet"
            write_parquet(path, columns, {name: flight.units[name] for name in columns}, about)
            written.append(path)
    if figures:
        for stem, (picture, numbers) in _pictures(flight).items():
            written += [folder / f"{prefix}{stem}.png", folder / f"{prefix}{stem}.csv"]
            written[-2].write_bytes(picture)
            written[-1].write_text(numbers, encoding="utf-8")
    return written


def _pictures(flight: Flight) -> dict[str, tuple[bytes, str]]:
    """Figures of a flight by name, as PNG and CSV."""
    from springback.interfaces.figures import flight as plots
    from springback.interfaces.figures import style

    found = {
        "flight": style.picture(plots.flight_figure, flight),
        "energy": style.picture(plots.energy_figure, flight),
    }
    if plots.needs_impact_figure(flight):
        found["impact"] = style.picture(plots.impact_figure, flight)
    return found

"""The files of a flight: its numbers, and figures of them."""

from __future__ import annotations

from pathlib import Path

from springback.files import write_json
from springback.interfaces.output.folders import SUMMARY
from springback.results.flight import Flight
from springback.results.parquet import write_parquet
from springback.results.sealed_json import file_digest, with_digest

#: Files that a flight leaves: those of an earlier one go when it is replaced.
FLIGHT_FILES = (
    SUMMARY, "trajectory.parquet", "telemetry.parquet",
    *(f"{name}.{kind}" for name in ("flight", "energy", "impact") for kind in ("png", "csv")),
)  # fmt: skip


def write_flight(flight: Flight, folder: Path, *, figures: bool = True) -> list[Path]:
    """Write ``summary.json``, ``trajectory.parquet``, a pilot's ``telemetry.parquet``, and figures.

    Figures are ``flight.png`` and ``energy.png``; with a pilot ``flight.png`` shows the whole
    flight beside its reference, and ``impact.png`` the collision if there was one.  The numbers of
    each are in a CSV file of the same name.  The summary names all of them with their digests
    (``files``) and has one of its own (``seal``), so that no file of another flight is taken for
    one of this.

    Args:
        flight: Any.
        folder: To write into.
        figures: Write figures, too.

    Returns:
        The files written.
    """
    summary = flight.summary()
    written = []
    about = {
        "springback": summary["springback"],
        "name": flight.scenario.name,
        "frames": "world NWU, body FLU",
    }
    for stem, columns in {"trajectory": flight.columns, "telemetry": flight.telemetry}.items():
        if columns:
            path = folder / f"{stem}.parquet"
            write_parquet(path, columns, {name: flight.units[name] for name in columns}, about)
            written.append(path)
    if figures:
        for stem, (picture, numbers) in _pictures(flight).items():
            written += [folder / f"{stem}.png", folder / f"{stem}.csv"]
            written[-2].write_bytes(picture)
            written[-1].write_text(numbers, encoding="utf-8")
    files = {path.name: file_digest(path) for path in written}
    write_json(folder / SUMMARY, with_digest(summary | {"files": files}))
    return [folder / SUMMARY, *written]


def _pictures(flight: Flight) -> dict[str, tuple[bytes, str]]:
    """The figures of a flight by name: PNG files, and what they show as CSV."""
    from springback.interfaces.figures import flight as plots
    from springback.interfaces.figures import style

    found = {
        "flight": style.picture(plots.flight_figure, flight),
        "energy": style.picture(plots.energy_figure, flight),
    }
    if flight.telemetry and flight.measures["touch_time"] is not None:
        found["impact"] = style.picture(plots.impact_figure, flight)
    return found

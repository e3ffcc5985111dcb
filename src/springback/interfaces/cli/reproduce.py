"""The command ``springback reproduce``."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import click

from springback.errors import InputError
from springback.interfaces.cli.common import Output, output_options
from springback.version import __version__


@click.command()
@click.argument("part", type=click.Choice(["all", "slider", "flight", "resilience"]), default="all")
@click.option(
    "--reading", "readings", multiple=True, metavar="'NAME: KEY=VALUE ...'",
    help="Additional reading of the printed parameters: reading B with changes.",
)  # fmt: skip
@output_options("Folder for report.html, figures, JSON and CSV.", "force", "as_json", "quiet")
def reproduce(part: str, readings: tuple[str, ...], output: Output) -> None:
    """Reproduce the paper: a report with its numbers and ours.

    slider is Table III, the deflections and contact times, and the speed sweep; flight is Table I
    (sizes, payload and hover time) and Table IV (steps and circles); resilience is collisions in
    flight: ten trials of both robots under each of seven conditions, and ten collisions in a row.
    """
    from springback.extras import needs

    if readings and part not in ("all", "slider"):
        raise InputError("--reading is for the slider tests; leave it out, or reproduce all")
    needs("matplotlib", "plot")
    needs("jinja2", "plot")
    with output.folder() as folder:
        rows = _reproduce(part, readings, folder, output)
    if output.as_json or not output.quiet:
        output.print([row.as_dict() for row in rows], _table(rows))
    output.note(f"report: {output.out}/report.html")


def _reproduce(part: str, readings: tuple[str, ...], folder: Path, output: Output) -> list[Any]:
    """Reproduce a part, write the report into a folder, and return the compared numbers."""
    from springback.interfaces.reproduction.report import Results, write_report
    from springback.paper.features import feature_rows
    from springback.paper.free_flight import flight_experiments
    from springback.paper.resilience import resilience_experiments
    from springback.paper.slider import named_reading, slider_experiments

    extra, results = [named_reading(text) for text in readings], Results()
    if part in ("all", "slider"):
        output.note("slider tests: Table III and the sweep; the first run compiles for a minute")
        with output.progress_bar("slider tests") as show:
            results = replace(results, slider=slider_experiments(extra, show))
    if part in ("all", "flight"):
        output.note("free flight: Tables I and IV; the first run compiles for a minute")
        with output.progress_bar("free flight") as show:
            flown = flight_experiments(progress=show)
        results = replace(results, features=feature_rows(), flight=flown)
    if part in ("all", "resilience"):
        output.note("collisions in flight; the first run compiles for a minute or two")
        with output.progress_bar("collisions in flight") as show:
            results = replace(results, resilience=resilience_experiments(progress=show))
    with output.spinner("writing the report"):
        write_report(results, folder, about=_about())
    return results.rows


def _about() -> dict[str, str]:
    import platform
    from importlib import metadata

    versions = {name: metadata.version(name) for name in ("numpy", "scipy", "numba")}
    return {"springback": __version__, "python": platform.python_version(), **versions}


def _table(rows: list[Any]) -> str:
    """Compared numbers as text."""
    lines = [
        f"{'':<11}{'robot':<16}{'on':<6}{'reading':<9}{'quantity':<43}{'ours':>10}{'printed':>10}"
        f"{'':>9}  mark"
    ]
    for row in rows:
        deviation = (
            "" if row.deviation is None or row.mark.word == "given" else f"{row.deviation:+.1%}"
        )
        ours = "-" if row.ours is None else f"{row.ours:.4g}"
        printed = "-" if row.printed is None else f"{row.printed:.4g}"
        slider = bool(row.dissipation_from)  # elsewhere the reading identifies the number
        reading = row.reading if slider else ""
        quantity = row.quantity if slider or not row.reading else f"{row.quantity}, {row.reading}"
        lines.append(
            f"{row.experiment:<11}{row.robot:<16}{row.surface:<6}{reading:<9}{quantity:<43}"
            f"{ours:>10}{printed:>10}{deviation:>9}  {row.mark.word}"
        )
    return "\n".join(lines)

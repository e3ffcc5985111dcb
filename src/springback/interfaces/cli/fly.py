"""The commands ``springback fly`` and ``springback check``."""

from __future__ import annotations

import json
import sys
import warnings
from pathlib import Path

import click

from springback.errors import FlightWarning
from springback.interfaces.cli.common import (
    FIRST,
    OUT,
    force_option,
    have_figures,
    json_option,
    note,
    print_result,
    progress_bar,
    quiet_option,
    spinner,
)


@click.command()
@click.argument("scenario", type=click.Path(path_type=Path))
@click.argument("overrides", nargs=-1, metavar="[KEY=VALUE]...")
@click.option(
    "--out", type=OUT, required=True, help="Folder for summary.json, trajectory.parquet, figures."
)
@click.option(
    "--pilot", metavar="FILE.py:NAME",
    help="Fly with a pilot of your own: a function, or a CompiledPilot, which is compiled.",
)  # fmt: skip
@click.option("--no-figures", is_flag=True, help="Write no figures.")
@force_option
@json_option
@quiet_option
def fly(
    scenario: Path,
    overrides: tuple[str, ...],
    out: Path,
    pilot: str | None,
    no_figures: bool,
    force: bool,
    as_json: bool,
    quiet: bool,
) -> None:
    """Fly a SCENARIO file, with any of its values overridden.

    \b
    springback fly scenario.toml --out results
    springback fly scenario.toml vehicle.arms.stiffness="6 N/mm" start.pitch="15 deg" --out results
    springback fly scenario.toml --pilot my_pilot.py:hover --out results
    """
    from springback.interfaces.output.folders import SUMMARY, output_folder
    from springback.interfaces.reports.flight_files import FLIGHT_FILES, write_flight
    from springback.results.flight import fly as fly_scenario
    from springback.scenario.avionics import scenario_warnings
    from springback.scenario.files import read_scenario
    from springback.scenario.user_pilots import read_pilot

    own = read_pilot(pilot) if pilot else None
    ready = read_scenario(scenario, overrides, pilot=own is not None)
    for sentence in scenario_warnings(ready, own=own is not None):
        note(f"warning: {sentence}", False)
    with output_folder(out, force=force, replaces=FLIGHT_FILES) as folder:
        with spinner(FIRST, quiet):
            with warnings.catch_warnings():  # said below, in this program's own way
                warnings.simplefilter("ignore", FlightWarning)
                flight = fly_scenario(ready, pilot=own)
            figures = not no_figures and have_figures(quiet)
            written = write_flight(flight, folder, figures=figures)
        names = [path.name for path in written]
        summary = (folder / SUMMARY).read_text(encoding="utf-8")
    print_result(json.loads(summary) if as_json else repr(flight), as_json)
    note(f"written to {out}: {', '.join(names)}", quiet)
    for sentence in flight.remarks.values():
        note(f"warning: {sentence}", False)
    if not flight.is_finite:
        sys.exit(1)


@click.command()
@click.argument("pilot", metavar="FILE.py:NAME")
@click.argument("scenario", type=click.Path(path_type=Path), required=False)
@json_option
@quiet_option
def check(pilot: str, scenario: Path | None, as_json: bool, quiet: bool) -> None:
    """Try a pilot of your own on what every pilot should keep to.

    At rest at the start of the SCENARIO (by default quad at [0, 0, 1] m) it must hover.

    \b
    springback check my_pilot.py:hover
    """
    from springback.studies.pilot_check import check_pilot

    with progress_bar("trying the pilot", quiet) as show:
        findings = check_pilot(pilot, scenario, progress=show)
    lines = [f"{'pass' if f.passed else 'FAIL'}  {f.name}: {f.sentence}" for f in findings]
    print_result([f._asdict() for f in findings] if as_json else "\n".join(lines), as_json)
    failed = sum(not f.passed for f in findings)
    note(f"{len(findings) - failed} of {len(findings)} passed", quiet)
    if failed:
        sys.exit(1)

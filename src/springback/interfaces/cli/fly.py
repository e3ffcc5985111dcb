"""The command ``springback fly``."""

from __future__ import annotations

import json
import sys
import warnings
from pathlib import Path

import click

from springback.errors import FlightWarning
from springback.interfaces.cli.common import FIRST, Output, output_options, say
from springback.interfaces.cli.completion import ScenarioPath, complete_code, complete_setting


@click.command()
@click.argument("scenario", type=ScenarioPath())
@click.argument("overrides", nargs=-1, metavar="[KEY=VALUE]...", shell_complete=complete_setting())
@click.option(
    "--pilot", metavar="FILE.py:NAME", shell_complete=complete_code,
    help="Fly with a pilot of your own: a function, or a CompiledPilot, which is compiled.",
)  # fmt: skip
@output_options("Folder for summary.json, trajectory.parquet, figures.")
def fly(scenario: Path, overrides: tuple[str, ...], pilot: str | None, output: Output) -> None:
    """Fly a SCENARIO file, with any of its values overridden.

    \b
    springback fly scenario.toml --out results
    springback fly scenario.toml vehicle.arms.stiffness="6 N/mm" start.pitch="15 deg" --out results
    springback fly scenario.toml --pilot my_pilot.py:hover --out results
    springback fly scenario.toml second=other.toml --out results
    """
    from springback.interfaces.output.folders import SUMMARY
    from springback.interfaces.output.no_contact import untouched_flight
    from springback.interfaces.reports.flight_files import FLIGHT_FILES, write_flight
    from springback.results.flight import fly as fly_scenario
    from springback.scenario.files import as_input, read_scenario
    from springback.scenario.user.pilots import read_pilot
    from springback.scenario.warnings import scenario_warnings

    own = read_pilot(pilot) if pilot else None
    ready = read_scenario(scenario, overrides, pilot=own is not None)
    for sentence in scenario_warnings(ready, own=own is not None or ready.pilot is not None):
        say(f"warning: {sentence}")
    with output.folder(FLIGHT_FILES) as folder:
        with output.spinner(FIRST):
            with (
                as_input(scenario, overrides),
                warnings.catch_warnings(),
            ):  # printed below, in the format of this program
                warnings.simplefilter("ignore", FlightWarning)
                flight = fly_scenario(ready, pilot=own)
            written = write_flight(flight, folder, figures=output.wants_figures())
        summary = (folder / SUMMARY).read_text(encoding="utf-8")
    flights = [one for one in (flight, flight.second) if one is not None]
    output.print(json.loads(summary), "\n".join(map(repr, flights)))
    if line := untouched_flight(flight, own is not None):
        output.note(line)
    output.note_written(written)
    for sentence in (line for one in flights for line in one.remarks.values()):
        say(f"warning: {sentence}")
    if not all(one.is_finite for one in flights):
        sys.exit(1)

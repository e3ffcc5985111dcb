"""The commands ``springback fly`` and ``springback pair``."""

from __future__ import annotations

import json
import sys
import warnings
from contextlib import ExitStack
from dataclasses import replace
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
    """
    from springback.interfaces.output.folders import SUMMARY
    from springback.interfaces.reports.flight_files import FLIGHT_FILES, write_flight
    from springback.results.flight import fly as fly_scenario
    from springback.scenario.files import read_scenario
    from springback.scenario.user.pilots import read_pilot
    from springback.scenario.warnings import scenario_warnings

    own = read_pilot(pilot) if pilot else None
    ready = read_scenario(scenario, overrides, pilot=own is not None)
    for sentence in scenario_warnings(ready, own=own is not None or ready.pilot is not None):
        say(f"warning: {sentence}")
    with output.folder(FLIGHT_FILES) as folder:
        with output.spinner(FIRST):
            with warnings.catch_warnings():  # printed below, in the format of this program
                warnings.simplefilter("ignore", FlightWarning)
                flight = fly_scenario(ready, pilot=own)
            written = write_flight(flight, folder, figures=output.wants_figures())
        summary = (folder / SUMMARY).read_text(encoding="utf-8")
    output.print(json.loads(summary), repr(flight))
    output.note_written(written)
    for sentence in flight.remarks.values():
        say(f"warning: {sentence}")
    if not flight.is_finite:
        sys.exit(1)


#: Folders of both flights.
SIDES = ("first", "second")


@click.command()
@click.argument("first", type=ScenarioPath())
@click.argument("second", type=ScenarioPath())
@output_options("Folder for both flights, in first/ and second/.")
def pair(first: Path, second: Path, output: Output) -> None:
    """Fly the vehicles of two scenario files together in one world: they can strike each other.

    \b
    springback pair pair_first.toml pair_second.toml --out results
    springback view results/first results/second

    World, clock and duration of both files must be the same.
    """
    from springback.batch.pair import fly_pair
    from springback.interfaces.output.folders import SUMMARY
    from springback.interfaces.reports.flight_files import FLIGHT_FILES, write_flight
    from springback.scenario.files import read_scenario

    ready = read_scenario(first), read_scenario(second)
    assert output.out is not None
    sides = [replace(output, out=output.out / name) for name in SIDES]
    with ExitStack() as stack:
        folders = [stack.enter_context(side.folder(FLIGHT_FILES)) for side in sides]
        with output.spinner(FIRST), warnings.catch_warnings():
            warnings.simplefilter("ignore", FlightWarning)  # printed below
            flights = fly_pair(*ready)
        figures = output.wants_figures()
        for flight, folder in zip(flights, folders, strict=True):
            write_flight(flight, folder, figures=figures)
        summaries = [(folder / SUMMARY).read_text(encoding="utf-8") for folder in folders]
    named = zip(SIDES, summaries, strict=True)
    found = {name: json.loads(summary) for name, summary in named}
    output.print(found, "\n".join(f"{n}: {f!r}" for n, f in zip(SIDES, flights, strict=True)))
    output.note_written()
    for flight in flights:
        for sentence in flight.remarks.values():
            say(f"warning: {sentence}")
    if not all(flight.is_finite for flight in flights):
        sys.exit(1)

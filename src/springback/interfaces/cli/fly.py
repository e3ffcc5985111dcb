"""The command ``springback fly``."""

from __future__ import annotations

import json
import sys
import warnings
from dataclasses import replace
from pathlib import Path
from typing import Any

import click

from springback.errors import FlightWarning, InputError
from springback.interfaces.cli.common import FIRST, PATH, Output, output_options, say
from springback.interfaces.cli.completion import ScenarioPath, complete_code, complete_setting
from springback.interfaces.cli.identify.logs import log_options, no_check_option, track_option

#: Names of options whose values are passed under others.
_OPTIONS = {"first": "from", "last": "until", "no_check": "no-check"}


@click.command()
@click.argument("scenario", type=ScenarioPath())
@click.argument("overrides", nargs=-1, metavar="[KEY=VALUE]...", shell_complete=complete_setting())
@click.option(
    "--pilot",
    metavar="FILE.py:NAME",
    shell_complete=complete_code,
    help="Fly with a pilot of your own: a function, or a CompiledPilot, which is compiled.",
)
@click.option(
    "--with",
    "overlay",
    type=ScenarioPath(),
    metavar="OVERLAY",
    help="Overlay the values of an identified.toml on the scenario.",
)
@click.option(
    "--against",
    "logs",
    type=PATH,
    multiple=True,
    metavar="LOG",
    help="Replay a recorded impact, with start and thrusts from the log. May be repeated for "
    "several logs of one flight.",
)
@click.option(
    "--impact",
    type=float,
    metavar="SECONDS",
    help="Time of the touch in the log, to within 50 ms; by default the first usable one.",
)
@click.option(
    "--before",
    type=float,
    metavar="SECONDS",
    help="How long before touch the replay begins; by default 0.1.",
)
@click.option(
    "--rotors",
    metavar="NUMBERS",
    help="For each rotor of the vehicle, its number in the log, such as 1,3,2,4.",
)
@click.option(
    "--align",
    is_flag=True,
    help="Move the start along its velocity so that touch is when the log says.",
)
@log_options  # fmt: skip
@track_option
@no_check_option
@output_options("Folder for summary.json, trajectory.parquet, figures.")
def fly(
    scenario: Path,
    overrides: tuple[str, ...],
    pilot: str | None,
    overlay: Path | None,
    logs: tuple[Path, ...],
    output: Output,
    **given: Any,
) -> None:
    """Fly a SCENARIO file, with any of its values overridden.

    \b
    springback fly scenario.toml --out results
    springback fly scenario.toml vehicle.arms.stiffness="6 N/mm" start.pitch="15 deg" --out results
    springback fly scenario.toml --pilot my_pilot.py:hover --out results
    springback fly scenario.toml second=other.toml --out results
    springback fly scenario.toml --with fitted/identified.toml --out results
    springback fly scenario.toml --against flight.ulg --against take.csv --world y-up --out replay
    """
    from springback.interfaces.output.folders import SUMMARY
    from springback.interfaces.output.no_contact import idle_suction, untouched_flight
    from springback.interfaces.reports.flight_files import FLIGHT_FILES, write_flight
    from springback.results.flight import fly as fly_scenario
    from springback.scenario.files import as_input, read_scenario
    from springback.scenario.flight_kernels import flights_compiled_early
    from springback.scenario.overrides import overlay_words
    from springback.scenario.user.pilots import read_pilot
    from springback.scenario.warnings import scenario_warnings
    from springback.scenario.worlds.mesh_check import telling

    if overlay is not None:
        overrides = (*overlay_words(overlay), *overrides)
    if logs:
        if pilot:
            raise InputError("--pilot: cannot be combined with --against, which flies open loop")
        _fly_against(scenario, overrides, logs, given, output)
        return
    for name, value in given.items():
        if value:
            raise InputError(f"--{_OPTIONS.get(name, name)}: needs --against")
    own = read_pilot(pilot) if pilot else None
    label = "reading; distances of new kinds of scene are compiled, grids of new meshes computed"
    click.get_current_context().with_resource(flights_compiled_early())
    with output.spinner(label) as tell, telling(tell):
        ready = read_scenario(scenario, overrides, pilot=own is not None)
    with output.folder(FLIGHT_FILES) as folder:
        for sentence in scenario_warnings(ready, own=own is not None or ready.pilot is not None):
            say(f"warning: {sentence}")
        with (
            output.spinner(FIRST),
            as_input(scenario, overrides),
            warnings.catch_warnings(),  # printed below, in the format of this program
        ):
            warnings.simplefilter("ignore", FlightWarning)
            flight = fly_scenario(ready, pilot=own)
        flights = [one for one in (flight, flight.second) if one is not None]
        unheard: OSError | None = None
        if not output.as_json:  # at once: files take longer than a flight
            try:
                output.print(None, "\n".join(map(repr, flights)))
            except OSError as error:  # a reader that has ended must not cost the files
                unheard = error
        with output.spinner("writing tables and figures"):
            written = write_flight(flight, folder, figures=output.wants_figures())
        summary = (folder / SUMMARY).read_text(encoding="utf-8")
    if unheard is not None:
        raise unheard
    if output.as_json:
        output.print(json.loads(summary))
    for line in filter(None, (untouched_flight(flight, own is not None), idle_suction(flight))):
        output.note(line)
    output.note_written(written)
    for sentence in (line for one in flights for line in one.remarks.values()):
        say(f"warning: {sentence}")
    if not all(one.is_finite for one in flights):
        sys.exit(1)


def _fly_against(
    scenario: Path,
    overrides: tuple[str, ...],
    logs: tuple[Path, ...],
    given: dict[str, Any],
    output: Output,
) -> None:
    """Replay a recorded impact, and write the flight and its errors."""
    from springback.identification.replays.errors import as_data, remarks
    from springback.interfaces.cli.against import against_text, replay_against, rotor_order
    from springback.interfaces.reports.against_files import write_against
    from springback.interfaces.reports.flight_files import FLIGHT_FILES, write_flight
    from springback.results.flight import fly as fly_scenario
    from springback.scenario.files import as_input
    from springback.scenario.scenario import scenario_from
    from springback.scenario.warnings import scenario_warnings

    names = ("first", "last", "world", "body", "track", "no_check")
    reading = {name: given[name] for name in names}
    before, impact = given["before"], given["impact"]
    wanted = {"rotors": rotor_order(given["rotors"]), "align": given["align"], "impact": impact}
    if before is not None:
        wanted["before"] = before
    with output.folder(FLIGHT_FILES) as folder:
        with output.spinner(FIRST), as_input(scenario, overrides), warnings.catch_warnings():
            warnings.simplefilter("ignore", FlightWarning)
            told = replay_against(scenario, overrides, logs, reading, wanted)
            flight = fly_scenario(scenario_from(told.flown.flight_tables(), False))
        flight = replace(flight, warned=(*scenario_warnings(flight.scenario, given=set()),))
        figures = output.wants_figures()
        written = write_flight(flight, folder, figures=figures)
        written += write_against(told.flown, told.channels, told.rows, folder, figures=figures)
    data = as_data(told.flown, told.rows)
    output.print(data, against_text(told))
    output.note_written(written)
    for sentence in (*told.flown.warnings, *remarks(told.flown, told.rows)):
        say(f"warning: {sentence}")
    for sentence in flight.warnings:
        say(f"warning: {sentence}")
    if not flight.is_finite:
        sys.exit(1)

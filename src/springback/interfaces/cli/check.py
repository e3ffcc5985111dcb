"""The commands ``springback check`` and ``springback trust``."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from springback.interfaces.cli.common import Terminal, say, terminal_options
from springback.interfaces.cli.completion import complete_checked, complete_setting

if TYPE_CHECKING:
    from springback.scenario.scenario import Scenario
    from springback.studies.pilot_check import Finding


@click.command()
@click.argument("file", metavar="FILE.toml|FILE.py:NAME", shell_complete=complete_checked)
@click.argument(
    "more", nargs=-1, metavar="[SCENARIO] [KEY=VALUE]...", shell_complete=complete_setting()
)
@terminal_options("as_json", "quiet")
def check(file: str, more: tuple[str, ...], terminal: Terminal) -> None:
    """Check a scenario, a plan, or code of your own before you fly it at length.

    A scenario, a plan or a vehicle file is refused for everything that a flight would refuse it
    for. Numbers that follow from it are printed: mass, share of the thrust used in hover, natural
    frequency and damping ratio of the arms, the speed that uses up their stroke, gaps between
    cages; and warnings.

    A pilot is tested for properties that every pilot should have: from rest at the start of the
    SCENARIO (by default quad at [0, 0, 1] m) it must hover. The exit code is 1 if one fails.
    KEY=VALUE are arguments of a function that returns a pilot.

    The distance and the normal of an obstacle are sampled wherever its surface is found, searching
    from the start of the SCENARIO (by default [0, 0, 1] m) and from all sides, inside and outside.
    What counts as wrong: a distance that is overstated, does not grow by 1 m per metre or is not a
    number, and a normal that does not have length 1 or is not the gradient. If both are right, they
    are compiled. NAME is a shape, or its type with KEY=VALUE for its fields.

    An estimator or a detector flies the SCENARIO within springback's pilot: by default quad hovers
    on the estimates, which must be near the truth, or flies into a wall at 2 m/s, which the
    detector must notice. KEY=VALUE are arguments of a function that returns one.

    \b
    springback check scenario.toml vehicle.arms.stiffness="2 N/mm"
    springback check plan.toml
    springback check fit.toml
    springback check my_pilot.py:hover
    springback check my_obstacle.py:Pole x=2.75 y=0 radius=0.05
    springback check my_detector.py:jolt threshold=25
    """
    from springback.scenario.files import has_vehicle_only
    from springback.scenario.source_text import source_text, toml_tables
    from springback.user_code import CODE_FORM

    if CODE_FORM.match(file):
        _check_code(file, more, terminal)
        return
    tables = toml_tables(source_text(Path(file)), file)
    if "free" in tables:
        _check_fit(Path(file), more, terminal)
    elif "scenario" in tables or "method" in tables:
        _check_plan(Path(file), more, terminal)
    elif has_vehicle_only(tables):
        _check_vehicle(Path(file), more, terminal)
    else:
        _check_scenario(Path(file), more, terminal)


# -- fits ----------------------------------------------------------------------------------------


def _check_fit(path: Path, overrides: Sequence[str], terminal: Terminal) -> None:
    """Check a plan of a fit: its fields, its logs, and the impacts in them."""
    from springback.identification.fits import read_flights, scenario_with_fields
    from springback.identification.settings import naming_places, read_fit_plan

    plan = read_fit_plan(path, overrides)
    with naming_places(path):
        fields = scenario_with_fields(plan, path.parent)[2]
        flights = read_flights(plan, path.parent) if plan.flights else []
    impacts = [window.name for flight in flights for window in flight.impacts]
    said = [text for flight in flights for text in (*flight.warnings, *flight.refused)]
    data = {
        "fields": {one.name: f"{one.role}, {one.uncertainty}" for one in fields},
        "impacts": impacts, "warnings": said,
    }  # fmt: skip
    lines = [f"{one.name}: {one.role}, {one.uncertainty}" for one in fields]
    lines += [f"impact: {name}" for name in impacts] or ["no logs yet"]
    terminal.print(data, "\n".join([*lines, *(f"warning: {text}" for text in said)]))


# -- scenarios and plans --------------------------------------------------------------------------

_CHECKING = (
    "checking; your own code is compiled first, and grids of new meshes and maps are computed"
)


def _check_scenario(path: Path, overrides: Sequence[str], terminal: Terminal) -> None:
    from springback.results.flight import ready_flight
    from springback.results.pair.flying import of_second
    from springback.scenario.files import as_input, read_scenario
    from springback.scenario.user.compiled import compile_user_code
    from springback.scenario.worlds.mesh_check import telling

    with terminal.spinner(_CHECKING) as tell:
        with telling(tell):
            scenario = read_scenario(path, overrides)
        with as_input(path, overrides):
            compile_user_code(ready_flight(scenario))
            if scenario.second is not None:
                with of_second():
                    compile_user_code(ready_flight(scenario.beside()))
        told, lines = _findings(scenario)
    terminal.print({"kind": "scenario", **told}, "\n".join(lines))
    _conclude(f"{path} can be flown", told["warnings"], terminal)


def _check_vehicle(path: Path, overrides: Sequence[str], terminal: Terminal) -> None:
    """Check a vehicle alone, in a world without obstacles."""
    from springback.scenario.files import checked_scenario
    from springback.scenario.overrides import apply_overrides

    overrides = [f"vehicle.{word}" for word in overrides]
    given = apply_overrides({"vehicle": str(path.absolute())}, overrides)
    with terminal.spinner(_CHECKING):
        told, lines = _findings(checked_scenario(given, str(path), "", overrides))
    terminal.print({"kind": "vehicle", **told}, "\n".join(lines))
    sentence = f'{path} can be flown: vehicle = "{path.name}" in a scenario'
    _conclude(sentence, told["warnings"], terminal)


def _findings(scenario: Scenario) -> tuple[dict[str, Any], list[str]]:
    """Derived numbers of a scenario, of both its vehicles, and its warnings; the numbers as text.

    Those of a second vehicle are below ``second``.
    """
    from springback.studies.scenario_check import check_warnings, derived_numbers

    first = [number._asdict() for number in derived_numbers(scenario)]
    told: dict[str, Any] = {"derived": first, "warnings": check_warnings(scenario)}
    lines = _lines(first)
    if scenario.second is not None:
        second = [number._asdict() for number in derived_numbers(scenario.beside())]
        told["second"] = {"derived": second}
        lines = [f"{scenario.vehicle.name}, the first vehicle:", *lines, ""]
        lines += [f"{scenario.second.vehicle.name}, the second vehicle:", *_lines(second)]
    return told, lines


def _lines(numbers: list[dict[str, Any]]) -> list[str]:
    width = max(len(number["name"]) for number in numbers)
    values = [f"{number['value']:.4g} {number['unit']}".strip() for number in numbers]
    return [
        f"{number['name']:<{width}}  {value:<16}  {number['about']}".rstrip()
        for number, value in zip(numbers, values, strict=True)
    ]


def _conclude(sentence: str, warnings: list[str], terminal: Terminal) -> None:
    for warning in warnings:
        say(f"warning: {warning}")
    terminal.note(sentence)


def _check_plan(path: Path, overrides: Sequence[str], terminal: Terminal) -> None:
    from springback.campaign.design.layout import lay_out
    from springback.campaign.design.plan import read_plan
    from springback.campaign.flying import try_code
    from springback.campaign.limits_check import unmet_limits, unreached_success
    from springback.campaign.plan_check import check_conditions
    from springback.interfaces.output.dimension_text import dimension_units, law_text
    from springback.scenario.scenario import scenario_from

    with terminal.spinner("reading the plan"):
        plan, source = read_plan(path, overrides)
        design = lay_out(plan, source)
        check_conditions(design, source)
        try_code(design)
    units = dimension_units(design)
    fields = [
        {
            "column": one.column, "unit": unit.symbol, "values": law_text(one, unit.factor),
            "scatter": one.scatter,
        }
        for one, unit in zip(design.dimensions, units, strict=True)
    ]  # fmt: skip
    counts = {"flights": design.flights, "samples": design.samples, "repeats": plan.repeats}
    data: dict[str, Any] = {"kind": "plan", **counts, "success": design.success, "fields": fields}
    text = [f"{name:<8}  {count}" for name, count in counts.items()]
    text += [f"success   {design.rule}", ""]
    text += [
        f"{one.column:<24}  {law_text(one, unit.factor, unit.symbol)}"
        for one, unit in zip(design.dimensions, units, strict=True)
    ]
    warnings = list[str]()
    for robot, base in zip(design.robots, design.bases, strict=True):
        told, lines = _findings(scenario_from(base))
        data.setdefault("robots", {})[robot] = told
        text += ["", f"{robot}, without what varies:", *lines]
        warnings += [f"{robot}: {warning}" for warning in told["warnings"]]
    warnings += unmet_limits(design) + unreached_success(design)
    terminal.print(data, "\n".join(text))
    _conclude(f"{path} can be flown", warnings, terminal)


# -- code of the user's own -----------------------------------------------------------------------


def _check_code(name: str, more: Sequence[str], terminal: Terminal) -> None:
    """Check code of the user's own, and exit with 1 if a property fails."""
    from springback.errors import InputError
    from springback.scenario.avionics import CompiledPilot
    from springback.scenario.code_files import read_object
    from springback.scenario.files import read_scenario
    from springback.scenario.overrides import apply_overrides
    from springback.studies.pilot_check import check_pilot
    from springback.studies.sensing_check import check_sensing, refuse_plain_sensing, sensing_kind

    scenarios = [Path(word) for word in more if "=" not in word]
    if len(scenarios) > 1:
        raise InputError(f"{str(scenarios[1])!r}: it is checked with one scenario")
    thing = read_object(name, "code of your own")
    is_type = isinstance(thing, type) and issubclass(thing, tuple)
    given = apply_overrides({}, [word for word in more if "=" in word])
    if (kind := sensing_kind(thing, given)) is not None:
        scenario = read_scenario(scenarios[0]) if scenarios else None
        with terminal.spinner("flying with it"):
            findings = check_sensing(kind, name, given, scenario)
    elif is_type or (isinstance(thing, tuple) and not isinstance(thing, CompiledPilot)):
        findings = _shape_findings(name, more, scenarios, terminal)
    else:
        refuse_plain_sensing(thing, name)
        with terminal.progress_bar("testing the pilot") as show:
            findings = check_pilot(name, *scenarios, parameters=given, progress=show)
    lines = [f"{'pass' if f.passed else 'FAIL'}  {f.name}: {f.sentence}" for f in findings]
    terminal.print([f._asdict() for f in findings], "\n".join(lines))
    failed = sum(not f.passed for f in findings)
    terminal.note(f"{len(findings) - failed} of {len(findings)} passed")
    if failed:
        sys.exit(1)


def _shape_findings(
    name: str, more: Sequence[str], scenarios: Sequence[Path], terminal: Terminal
) -> list[Finding]:
    """Findings on a shape, or on a type of shape with its parameters."""
    from pydantic import ValidationError

    from springback.contact.library import WALL
    from springback.errors import InputError
    from springback.kernels.vectors import Vec
    from springback.scenario.files import read_scenario
    from springback.scenario.overrides import apply_overrides
    from springback.scenario.tables import Start, UserShape, WorldSettings
    from springback.scenario.user.obstacles import own_obstacles
    from springback.studies.shape_check import check_shape

    given = apply_overrides({}, [word for word in more if "=" in word])
    entry = {"type": "own", "shape": name, "parameters": given, "surface": WALL}
    try:
        world = WorldSettings(obstacles=(UserShape.model_validate(entry),))
        [(shape, _)] = own_obstacles(world)
    except ValidationError as error:
        raise InputError(*UserShape.in_words(error)) from None
    except InputError as error:
        lines = (line.removeprefix("world.obstacles[0].") for line in error.problems)
        how = "" if given else f"; give its numbers after its name, as in {name} radius=0.1"
        raise InputError(
            *(line + how if line.startswith("parameters: ") else line for line in lines)
        ) from None
    start = read_scenario(scenarios[0]).start if scenarios else Start()
    with terminal.progress_bar("testing the shape") as show:
        return check_shape(shape, Vec(*start.position), progress=show)


# -- consent to code ------------------------------------------------------------------------------


@click.command()
@click.argument("folder", type=click.Path(path_type=Path), required=False)
@click.option("--remove", is_flag=True, help="Trust FOLDER no longer.")
@terminal_options("as_json", "quiet")
def trust(folder: Path | None, remove: bool, terminal: Terminal) -> None:
    """Let scenarios run Python code in FOLDER and below; without FOLDER, list the trusted ones.

    A scenario or plan that names a pilot or an obstacle of your own (FILE.py:NAME) runs that file
    with all your rights. It does so only in folders that you trust: those in this list, and those
    in the environment variable SPRINGBACK_TRUST.

    \b
    springback trust .
    springback trust --remove .
    """
    from springback.errors import InputError
    from springback.scenario.user.trust import trust as trust_folder
    from springback.scenario.user.trust import trusted_folders

    if folder is None and remove:
        raise InputError("FOLDER is missing: the folder to trust no longer")
    if folder is not None:
        trust_folder(folder, ends=remove)
    names = [str(one) for one in trusted_folders()]
    terminal.print(names, "\n".join(names) or "no folder is trusted")

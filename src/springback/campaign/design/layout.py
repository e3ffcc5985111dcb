"""Layout of a plan: validation against its scenario, and the values of every flight."""

from __future__ import annotations

import functools
import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from pydantic import ValidationError

from springback.campaign.design.dimensions import (
    SLOTS,
    Blame,
    Dimension,
    Extremes,
    VariedField,
    posterior_dimensions,
    scatter_dimensions,
    varied_dimension,
)
from springback.campaign.design.plan import (
    MOST_SAMPLES,
    Plan,
    Source,
    plan_from,
    with_scenario,
)
from springback.campaign.design.sampling import (
    POINTS,
    Numbers,
    grid_point,
    seeds,
    uniform_rows,
)
from springback.campaign.design.success import condition_in_words
from springback.campaign.design.targets import in_numbers
from springback.control.reference_parameters import ReferenceSettings
from springback.errors import InputError
from springback.problems import dotted_path, problem_paths
from springback.random_streams import Purpose
from springback.results.sealed_json import digest_of
from springback.scenario.code_files import code_digests, code_names, file_digests
from springback.scenario.presets import vehicle_table
from springback.scenario.scenario import Scenario, merge, preset, scenario_from
from springback.scenario.user.trust import check_trusted
from springback.scenario.worlds.imported import world_files
from springback.settings import Settings
from springback.simulation.measuring.measures import FAILURES, Outcome
from springback.vehicle.library import VEHICLES

Tables = dict[str, Any]
#: Upper limit of flights, to catch typing errors (chosen).
MOST_FLIGHTS = 10**9
#: Most levels of a field that are all tried; of more only the first and the last are (chosen).
MOST_TRIED = 200
#: Tables of a scenario in which robots differ.
OF_A_ROBOT = ("vehicle", "pilot")
#: Columns of all campaigns that identify the flight of a row.
HEAD = ("flight", "sample", "repeat", "robot", "seed")


class DesignSlice(NamedTuple):
    """Scenarios and values of a range of flights."""

    tables: list[Tables]
    """Complete scenario of each flight; equal tables are the same object."""
    columns: dict[str, list[Any]]
    """Columns that identify the flights, and all values that vary."""


@dataclass(frozen=True)
class Design:
    """A validated plan, ready to fly."""

    plan: Plan
    robots: tuple[str, ...]
    bases: tuple[Tables, ...]
    """Scenario of each robot without variations."""
    dimensions: tuple[Dimension, ...]
    """Dimensions in the order of the plan, scatter last."""
    placing: tuple[int, ...]
    """Indices of dimensions, in the order of their insertion into the scenario."""
    samples: int

    @property
    def flights(self) -> int:
        """Number of flights."""
        return self.samples * self.plan.repeats * len(self.robots)

    @property
    def has_second(self) -> bool:
        """True if each flight has a second vehicle."""
        return self.bases[0].get("second") is not None

    @property
    def units(self) -> dict[str, str]:
        """SI units of the columns of dimensions."""
        return {d.column: d.unit for d in self.dimensions}

    @functools.cached_property
    def full_scenarios(self) -> list[dict[str, Any]]:
        """Scenario of each robot with all presets and defaults as numbers, in SI."""
        return [scenario_from(base, False).model_dump(mode="json") for base in self.bases]

    @functools.cached_property
    def digest(self) -> str:
        """SHA-256 of `full_scenarios`."""
        return digest_of({"scenarios": self.full_scenarios})

    @functools.cached_property
    def code(self) -> dict[str, str]:
        """SHA-256 of code and worlds that the scenarios name, by path; runs the code."""
        words = list(dict.fromkeys(word for base in self.bases for word in code_names(base)))
        for word in words:
            check_trusted(word, "scenario")
        return code_digests(words) | file_digests(
            f for base in self.bases for f in world_files(base)
        )

    def condition(self, text: str, *, judged: bool = False) -> str:
        """Condition in words as SQL; see `condition_in_words`.

        Raises:
            InputError: If a name or a quantity is wrong.
        """
        return condition_in_words(text, self.condition_fields, judged=judged)

    @property
    def condition_fields(self) -> dict[str, str | None]:
        """Unit of each varied field by column, for `condition_in_words`; None for words."""
        return {one.column: None if one.text else one.unit for one in self.dimensions}

    @property
    def success(self) -> str:
        """Condition of success in SQL."""
        given = self.plan.success
        if isinstance(given, tuple):
            return " AND ".join(f"({self.condition(text)})" for text in given)
        if given is not None:
            return given
        if self.bases[0].get("recovery") is not None:
            return "outcome = 'recovered'"
        judged = (*FAILURES, Outcome.NOT_SETTLED)
        failures = ", ".join(f"'{outcome.word}'" for outcome in judged)
        return f"outcome NOT IN ({failures})"

    @property
    def keep_condition(self) -> str:
        """Condition in SQL of the flights whose trajectories are stored; none are without one."""
        keep = self.plan.keep
        if keep is None:
            return "false"
        if isinstance(keep.where, str):
            return keep.where
        return " AND ".join(f"({self.condition(text, judged=True)})" for text in keep.where)

    @property
    def rule(self) -> str:
        """Condition of success as the plan has it."""
        given = self.plan.success
        return "; ".join(given) if isinstance(given, tuple) else self.success

    def slice(self, first: int, last: int) -> DesignSlice:
        """Flights from ``first`` to before ``last``, independent of other slices."""
        per = self.plan.repeats * len(self.robots)
        begin, end = first // per, -(-last // per)
        numbers = _numbers(self, begin, end - begin)
        tables: list[Tables] = []
        columns: dict[str, list[Any]] = {name: [] for name in (*HEAD, *self.units)}
        known: dict[Any, Any] = {}
        steps: dict[str, list[int]] = {}
        for k in self.placing:
            steps.setdefault(self.dimensions[k].table, []).append(k)
        for flight in range(first, last):
            rest, robot = divmod(flight, len(self.robots))
            sample, repeat = divmod(rest, self.plan.repeats)
            seed, drawn = numbers(sample - begin, repeat)
            head = (flight, sample, repeat, self.robots[robot], seed)
            for name, value in zip(HEAD, head, strict=True):
                columns[name].append(value)
            for one, value in zip(self.dimensions, drawn, strict=True):
                columns[one.column].append(one.column_value(value, robot))
            tables.append({**self._with(robot, drawn, steps, known), "seed": seed})
        return DesignSlice(tables, columns)

    def _with(
        self,
        robot: int,
        drawn: Sequence[Any],
        steps: Mapping[str, Sequence[int]],
        known: dict[Any, Any],
    ) -> Tables:
        """A robot's scenario with values, reusing tables of the same values.

        Args:
            robot: Number of the robot.
            drawn: Values of all dimensions.
            steps: Dimensions of each table, in order of insertion.
            known: Tables built so far, which is extended.
        """
        tables = dict(self.bases[robot])
        for name, changes in steps.items():
            table = tables.get(name, {})
            # Robots with different own values have different tables.
            key = (name, id(table), *[drawn[k] for k in changes])
            if key not in known:
                for k in changes:
                    one = self.dimensions[k]
                    table = one.place(table, one.scenario_value(drawn[k], robot))
                known[key] = table
            tables[name] = known[key]
        return tables


def _numbers(
    design: Design, begin: int, count: int
) -> Callable[[int, int], tuple[int, tuple[Any, ...]]]:
    """Function from sample number, counted from ``begin``, and repeat to seed and values."""
    plan, dimensions = design.plan, design.dimensions
    grid = plan.method == "grid"
    axes = _axes(dimensions)
    gridded = [one for one in axes if dimensions[one[0]].law.levels or not grid]
    drawn = [one for one in axes if one not in gridded]
    sizes = tuple(dimensions[one[0]].law.levels for one in gridded)
    points: Numbers | None = None
    if not grid:
        points = POINTS[plan.method](plan.seed, design.samples, len(gridded), begin, count)

    given: dict[int, list[Any]] = {}
    if points is None:
        levels = [grid_point(begin + k, sizes) for k in range(count)]
        given = {k: [point[j] for point in levels] for j, [k] in enumerate(gridded)}
    else:
        given = _values(dimensions, gridded, points)

    @functools.cache
    def values(repeat: int) -> tuple[list[int], list[tuple[Any, ...]]]:
        """Seeds and values of one repeat of these samples."""
        scatter = uniform_rows(plan.seed, (Purpose.SCATTER, repeat), begin, count, SLOTS)
        more = uniform_rows(plan.seed, (Purpose.DRAWN, repeat), begin, count, len(drawn))
        found = given | _values(dimensions, drawn, more)
        for k, one in enumerate(dimensions):
            if one.scatter:
                found[k] = one.law.of(scatter[:, one.slot])
        rows = zip(*(found[k] for k in range(len(dimensions))), strict=True)
        numbers = seeds(plan.seed, repeat, begin, count).tolist()
        return numbers, list(rows) if dimensions else [()] * count

    return lambda k, repeat: (values(repeat)[0][k], values(repeat)[1][k])


def _axes(dimensions: Sequence[Dimension]) -> list[list[int]]:
    """Sampled dimensions by the random number that they take: those of a posterior take one."""
    alone = [[k] for k, one in enumerate(dimensions) if not one.scatter and not one.joint]
    joint = [k for k, one in enumerate(dimensions) if one.joint]
    return [*alone, joint] if joint else alone


def _values(
    dimensions: Sequence[Dimension], axes: Sequence[Sequence[int]], points: Numbers
) -> dict[int, list[Any]]:
    """Values of dimensions at points, shape (points, axes)."""
    return {k: dimensions[k].law.of(points[:, j]) for j, one in enumerate(axes) for k in one}


@functools.lru_cache(maxsize=4)
def design_of(text: str) -> Design:
    """Design of a plan from `Plan.canonical`, cached."""
    return lay_out(plan_from(json.loads(text)), tried=False)


def lay_out(plan: Plan, source: Source | None = None, *, tried: bool = True) -> Design:
    """Design of a plan, validated against its scenario.

    Args:
        plan: Any; a scenario that is a path is read, relative to the working directory.
        source: Origin of the plan.
        tried: Try the extremes; not needed for a plan that was laid out before.

    Raises:
        InputError: One line for each problem.
    """
    where = source or Source()
    plan = with_scenario(plan, Path(), where)
    problems: list[str] = []

    def blame(path: Sequence[str | int], what: str) -> None:
        problems.append(where.problem_line(path, what))

    bases = _bases(plan, where)
    scenarios = tuple(
        _check_base(base, robot, plan, where)
        for robot, base in zip(_robot_names(plan), bases, strict=True)
    )
    found = [
        varied_dimension(k, entry, plan, scenarios, blame) for k, entry in enumerate(plan.vary)
    ]
    joint = posterior_dimensions(plan, scenarios, blame)
    fields = [*(one for one in found if one is not None), *joint]
    noise_stream: list[Dimension] = []
    try:
        noise_stream = (
            scatter_dimensions(plan.scatter.deviations(), scenarios[0]) if plan.scatter else []
        )
    except InputError as error:
        blame(("scatter",), str(error))
    dimensions = [one.dimension for one in fields]
    _check_columns(plan, found, joint, blame, where)
    if noise_stream or any(one.table == "world" for one in dimensions):
        world = in_numbers(bases[0], scenarios[0])
        # What nothing scatters stays as it is: left out, its defaults are those of each robot.
        needed = {*bases[0], "start", *(one.table for one in noise_stream)}
        shared = {key: world[key] for key in world if key in needed and key not in OF_A_ROBOT}
        bases = tuple(
            shared | {key: base[key] for key in OF_A_ROBOT if key in base} for base in bases
        )
    if not problems and tried:
        for one in fields:
            _try_out(one.dimension, one.extremes, bases, plan, blame)
    if problems:
        raise InputError(*dict.fromkeys(problems))
    samples = plan.samples or 1
    if plan.method == "grid":
        for one in fields:
            samples *= max(1, one.dimension.law.levels)
    design = Design(
        plan,
        _robot_names(plan),
        bases,
        (*dimensions, *noise_stream),
        _in_order(fields, len(noise_stream)),
        samples,
    )
    if samples > MOST_SAMPLES or design.flights > MOST_FLIGHTS:
        what = f"{design.flights} flights of {samples} samples are too many; at most {MOST_FLIGHTS}"
        raise InputError(where.problem_line((), f"{what} of {MOST_SAMPLES}"))
    return design


def _in_order(fields: Sequence[VariedField], noise_stream: int) -> tuple[int, ...]:
    """Order of insertion: tables before their fields, fields of a wall before its changes."""
    goals = [one.goal for one in fields]
    order = sorted(range(len(goals)), key=lambda k: (goals[k].relative, len(goals[k].path)))
    return (*order, *range(len(goals), len(goals) + noise_stream))


# -- robots ---------------------------------------------------------------------------------------


def _robot_names(plan: Plan) -> tuple[str, ...]:
    """Names of the robots in rows."""
    assert isinstance(plan.scenario, dict)
    vehicle = plan.scenario.get("vehicle")
    if isinstance(vehicle, Mapping):  # the user's name takes precedence over that of the preset
        vehicle = vehicle.get("name") or vehicle.get("preset")
    vehicles = plan.robots or (vehicle if isinstance(vehicle, str) else "own",)
    if not plan.pilots:
        return vehicles
    return tuple(f"{name} with {pilot.name}" for name in vehicles for pilot in plan.pilots)


def _bases(plan: Plan, where: Source) -> tuple[Tables, ...]:
    """Scenarios of the robots: each vehicle with each pilot."""
    vehicles = _vehicle_bases(plan, where)
    if not plan.pilots:
        return vehicles
    for k, pilot in enumerate(plan.pilots):
        if pilot.code is None and vehicles[0].get("reference") is None:
            what = "springback's pilot needs a [reference] in the scenario, which it follows"
            raise InputError(where.problem_line(("pilots", k), what))
    return tuple(pilot.flown_in(base) for base in vehicles for pilot in plan.pilots)


def _vehicle_bases(plan: Plan, where: Source) -> tuple[Tables, ...]:
    """Scenarios of the vehicles."""
    assert isinstance(plan.scenario, dict)
    given: Tables = json.loads(json.dumps(plan.scenario))  # converts all sequences to lists
    if not plan.robots:
        return (given,)
    vehicle = given.get("vehicle", {})  # robots replace it; changes to a preset hold for all
    own = dict(vehicle) if isinstance(vehicle, Mapping) and "preset" in vehicle else {}
    bases = []
    for k, robot in enumerate(plan.robots):
        if robot in plan.vehicles:
            changes = {key: value for key, value in own.items() if key != "preset"}
            named = {**vehicle_table(plan.vehicles[robot]), "name": robot}
            bases.append({**given, "vehicle": merge(named, changes)})
            continue
        try:
            preset("vehicle", robot, {**VEHICLES, **plan.vehicles})
        except InputError as error:
            raise InputError(where.problem_line(("robots", k), str(error))) from None
        bases.append({**given, "vehicle": {**own, "preset": robot}})
    return tuple(bases)


def _check_base(base: Tables, robot: str, plan: Plan, where: Source) -> Scenario:
    try:
        return scenario_from(base, False)
    except InputError as error:
        of = f" with {robot}" if plan.robots or plan.pilots else ""
        lines = (f"{line}{of}" for line in error.problems)
        raise InputError(*(where.problem_line(("scenario",), line) for line in lines)) from None


# -- before anything is flown ---------------------------------------------------------------------


def _check_columns(
    plan: Plan,
    found: Sequence[VariedField | None],
    joint: Sequence[VariedField],
    blame: Blame,
    where: Source,
) -> None:
    """Reject fields given twice, and columns of the same name."""
    from springback.campaign.columns import known_columns

    taken = {name.lower(): "is reserved" for name in known_columns()}
    fields: dict[tuple[Any, ...], int] = {}
    for k, (entry, one) in enumerate(zip(plan.vary, found, strict=True)):
        if one is None:
            continue
        field, column = (
            (*one.goal.path, one.goal.relative and one.goal.column),
            one.dimension.column,
        )
        if field in fields:
            there = where.entry(fields[field]) + 1
            blame(("vary", k, "field"), f"is varied by entry {there} already")
        elif column.lower() in taken:
            what = f"{column!r} as a name of a column {taken[column.lower()]}; give another name"
            blame(("vary", k, "name" if entry.name else "field"), what)
        fields.setdefault(field, k)
        taken.setdefault(column.lower(), f"is that of entry {where.entry(k) + 1}, too")
    for one in joint:
        column = one.dimension.column
        if (*one.goal.path, False) in fields:
            there = where.entry(fields[(*one.goal.path, False)]) + 1
            blame(("posterior",), f"{column}: is varied by entry {there} of vary, too")
        elif column.lower() in taken:
            blame(("posterior",), f"{column!r} as a name of a column {taken[column.lower()]}")
        taken.setdefault(column.lower(), "is that of another field, too")


def _try_out(
    one: Dimension,
    extremes: Extremes,
    bases: Sequence[Tables],
    plan: Plan,
    blame: Blame,
) -> None:
    """Record values with which the otherwise unchanged scenario cannot be flown.

    Run-ups are not planned, which may take long; a vehicle too weak for one leads to refused rows.
    """
    few = extremes if len(extremes) <= MOST_TRIED else (extremes[0], extremes[-1])
    for path, value in few:
        for robot, base in enumerate(bases):
            shown = value_text(value)
            problem = _problem({**base, one.table: one.place(base.get(one.table, {}), value)}, one)
            if problem:
                names = _robot_names(plan)
                whose = len(names) > 1 and one.table in ("vehicle", "pilot")
                of = f" with {names[robot]}" if whose else ""
                blame(path, f"{one.column} = {shown}{of}: {problem}")
                return


def value_text(value: Any) -> str:
    """Value as text."""
    return f"{value:.6g}" if isinstance(value, float) else str(value)


class _Reference(Settings):
    """A reference alone, to be validated without planning a run-up."""

    reference: ReferenceSettings


def _problem(tables: Tables, one: Dimension) -> str:
    """Reason why a scenario cannot be flown; empty if it can, or if its run-up may be too hard."""
    reference = tables.get("reference")
    try:
        if one.table == "reference":
            _Reference.model_validate({"reference": reference})
            return ""
        hold = {"reference": {"type": "hold"}} if reference is not None else {}
        scenario_from(tables | hold, False)
    except ValidationError as error:
        [(path, what), *_] = problem_paths(error)
        return f"{dotted_path(path)}: {what}"
    except InputError as error:
        line = error.problems[0]
        weak = line.startswith("reference: ") or "each rotor's share of the true weight" in line
        return "" if weak else line
    return ""

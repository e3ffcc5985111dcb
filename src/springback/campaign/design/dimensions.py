"""Dimensions of a plan: fields, their distributions, and their targets in the scenario."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

from springback.campaign.design.distributions import (
    Distribution,
    LevelSet,
    NormalDistribution,
    NormalFactor,
    PosteriorColumn,
    UniformDistribution,
)
from springback.campaign.design.plan import FROM, MOST_LEVELS, Plan, Vary
from springback.campaign.design.targets import (
    GAINS,
    WALL_ANGLE,
    WALL_SHIFT,
    Place,
    TargetField,
    addition,
    field_path,
    multiplication,
    target,
)
from springback.errors import InputError, shown_value
from springback.scenario.fields import Parameter, Path, refuse_unread
from springback.scenario.scenario import Scenario
from springback.studies.trials import Scatter

Blame = Callable[[Path, str], None]
"""Function that records a problem by its path in the plan and its message."""

#: Names of columns (chosen): dotted paths, and words.
NAME = re.compile(r"[A-Za-z_][\w.\[\]]*\Z")
#: Suffix of columns whose values are factors of the scenario's own.
FACTOR = "_factor"


@dataclass(frozen=True)
class Dimension:
    """A quantity that varies from flight to flight."""

    column: str
    unit: str
    law: Distribution
    table: str
    """Table of the scenario that the value belongs to."""
    place: Place
    slot: int = -1
    """Index of the random number of a flight for scatter; -1 for sampled dimensions."""
    own: tuple[float, ...] = ()
    """The scenario's own value of each robot, to which the drawn one is added."""
    factor: bool = False
    """True if it is multiplied by the drawn value instead."""

    @property
    def joint(self) -> bool:
        """True for a field of a posterior, whose row is drawn as one."""
        return isinstance(self.law, PosteriorColumn)

    @property
    def scatter(self) -> bool:
        """True for a scattered dimension."""
        return self.slot >= 0

    def scenario_value(self, drawn: Any, robot: int) -> Any:
        """Value in a robot's scenario, from a drawn one."""
        if isinstance(self.law, LevelSet):
            return self.law.values[drawn]
        if not self.own:
            return drawn
        return self.own[robot] * drawn if self.factor else self.own[robot] + drawn

    @property
    def text(self) -> bool:
        """True if its column contains words."""
        return isinstance(self.law, LevelSet) and not all(map(_is_number, self.law.values))

    def column_value(self, drawn: Any, robot: int) -> Any:
        """Value in the column, from a drawn one."""
        if not isinstance(self.law, LevelSet):
            return drawn if self.factor else self.scenario_value(drawn, robot)
        value = self.law.values[drawn]
        if not self.text:
            return float(value)
        return value if isinstance(value, str) else json.dumps(value, sort_keys=True)


Extremes = tuple[tuple[Path, Any], ...]
"""Values to be tried before anything is flown, with their paths in the plan."""


class VariedField(NamedTuple):
    """A dimension, its extremes, and its field."""

    dimension: Dimension
    extremes: Extremes
    goal: TargetField


def posterior_dimensions(
    plan: Plan, scenarios: tuple[Scenario, ...], blame: Blame
) -> list[VariedField]:
    """Dimensions of a plan's posterior; problems are recorded.

    Args:
        plan: With its posterior read.
        scenarios: Scenario of each robot.
        blame: Called with problems.
    """
    if plan.posterior is None:
        return []
    found, units = list[VariedField](), plan.posterior.units
    for name, draws in sorted(plan.posterior.draws.items()):  # as stored
        try:
            goal, *_ = [target(name, scenario) for scenario in scenarios]
            for scenario in scenarios:
                refuse_unread(goal.path, scenario, [field_path(one.field) for one in plan.vary])
        except InputError as error:
            blame(("posterior",), f"{name}: {error}")
            continue
        number = goal.number
        if number is None or number.whole or goal.relative:
            blame(("posterior",), f"{name}: is no number that a posterior can have")
            continue
        if (units.get(name) or number.unit) != number.unit:
            blame(
                ("posterior",),
                f"{name}: is in {units[name]}, the scenario's in {number.unit or 'no unit'}",
            )
            continue
        law, table = PosteriorColumn(draws), str(goal.path[0])
        one = Dimension(goal.column, number.unit, law, table, goal.place)
        ends = tuple((("posterior",), end) for end in (min(draws), max(draws)))
        found.append(VariedField(one, ends, goal))
    return found


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def varied_dimension(
    k: int, entry: Vary, plan: Plan, scenarios: tuple[Scenario, ...], blame: Blame
) -> VariedField | None:
    """Dimension of an entry of ``vary``; None if it has a problem, which is recorded.

    Args:
        k: Number of the entry.
        entry: Entry as written.
        plan: Plan of the entry.
        scenarios: Scenario of each robot.
        blame: Called with problems.
    """
    at: Path = ("vary", k)
    try:
        goal, *_ = [target(entry.field, scenario) for scenario in scenarios]
        for scenario in scenarios:
            refuse_unread(goal.path, scenario, [field_path(one.field) for one in plan.vary])
    except InputError as error:
        blame((*at, "field"), str(error))
        return None
    found = _Reader(at, entry, goal, scenarios, blame)
    read = found.levels() if entry.values is not None else found.law(plan.method == "grid")
    if read is None:
        return None
    law, extremes = read
    column = entry.name or goal.column + (FACTOR if entry.factor else "")
    if not NAME.match(column):
        blame((*at, "name"), f"must be a word without blanks (got {column!r})")
        return None
    unit = goal.number.unit if goal.number and not entry.factor else ""
    of_own = entry.factor is not None or (entry.normal is not None and entry.normal.mean is None)
    own = (found.scenario_values() if of_own else None) or ()
    factor = entry.factor is not None
    table = str(goal.path[0])
    one = Dimension(column, unit, law, table, goal.place, own=own, factor=factor)
    return VariedField(one, extremes, goal)


class _Reader:
    """Reader of the values of an entry, which records problems."""

    def __init__(
        self,
        at: Path,
        entry: Vary,
        goal: TargetField,
        scenarios: tuple[Scenario, ...],
        blame: Blame,
    ) -> None:
        self.at, self.entry, self.goal = at, entry, goal
        self.scenarios, self.blame = scenarios, blame
        self.failed = False

    def number(self, key: str, value: Any, difference: bool = False) -> float:
        """Number in SI; 0 if it is invalid, which is recorded."""
        assert self.goal.number is not None
        whole = self.goal.number.whole and not difference
        plain = Parameter(self.entry.field, self.goal.path, self.goal.number.unit, whole)
        if isinstance(value, bool) or not isinstance(value, int | float | str):
            self.say(key, f"must be a number (got {shown_value(value)})")
            return 0.0
        try:
            return plain.read(value if isinstance(value, str) else repr(value))
        except InputError as error:
            self.say(key, str(error).removeprefix(f"{self.entry.field}: "))
            return 0.0

    def say(self, key: str, what: str) -> None:
        self.failed = True
        self.blame((*self.at, *([key] if key else [])), what)

    def levels(self) -> tuple[Distribution, Extremes] | None:
        """Levels from a list of values."""
        given = self.entry.values or ()
        if self.goal.number is not None:
            read = tuple(self.number("values", value) for value in given)
            given = tuple(int(v) if self.goal.number.whole else v for v in read)
        labels = [json.dumps(value, sort_keys=True, default=str) for value in given]
        if len(set(labels)) != len(labels) and not self.failed:
            self.say("values", "has one twice")
        where = (*self.at, "values")
        return None if self.failed else (LevelSet(given), tuple((where, v) for v in given))

    def law(self, grid: bool) -> tuple[Distribution, Extremes] | None:
        """Distribution from ``from`` and ``to``, ``normal`` or ``factor``."""
        if self.goal.number is None:
            self.say("field", "is not a single number; give values")
            return None
        if self.goal.number.whole and self.entry.from_ is None:
            self.say("field", "is a whole number: give values, or from, to and step")
            return None
        if self.entry.factor is not None:
            return self.factor()
        if self.entry.normal is not None:
            return self.bell()
        first, last = self.number(FROM, self.entry.from_), self.number("to", self.entry.to)
        if self.failed:
            return None
        if first == last:
            self.say("to", f"must differ from from (got {self.entry.to!r} twice)")
        if self.entry.spacing == "logarithmic" and not first * last > 0.0:
            self.say("spacing", "logarithmic needs from and to of the same sign, and no zero")
        law = None if self.failed else self.spread(first, last, grid)
        number = int if self.goal.number.whole else float
        ends = (((*self.at, FROM), number(first)), ((*self.at, "to"), number(last)))
        return None if law is None else (law, ends)

    def spread(self, first: float, last: float, grid: bool) -> Distribution | None:
        """Levels if their number or step is given, else a uniform distribution."""
        count, logarithmic = self.entry.count, self.entry.spacing == "logarithmic"
        whole = self.goal.number is not None and self.goal.number.whole
        if self.entry.step is not None:
            step = self.number("step", self.entry.step, difference=True)
            parts = (last - first) / step if step else math.nan
            if not self.failed and parts > MOST_LEVELS - 1:
                least = (last - first) / (MOST_LEVELS - 1)
                what = f"must be at least {least:.3g}, for {MOST_LEVELS} levels (got {step:g})"
                self.say("step", what)
            elif not self.failed and not (parts > 0.5 and abs(parts - round(parts)) < 1e-9):
                self.say("step", f"does not lead from {self.entry.from_!r} to {self.entry.to!r}")
            count = 0 if self.failed else round(parts) + 1
        if self.failed:
            return None
        if count is None and whole:
            self.say("field", "is a whole number: give step, count or values")
            return None
        if count is None and grid:
            self.say("", "needs count or step: a grid has levels")
            return None
        law = UniformDistribution(first, last, logarithmic)
        if count is None:
            return law
        digits = 12 - math.ceil(math.log10(max(abs(first), abs(last))))
        values = [round(law.at(k / (count - 1)), digits) + 0.0 for k in range(count)]
        if whole and any(value != round(value) for value in values):
            self.say("count", f"leads to numbers that are not whole ({values[1]:g})")
            return None
        return LevelSet(tuple(int(v) for v in values) if whole else tuple(values))

    def bell(self) -> tuple[Distribution, Extremes] | None:
        """Normal distribution."""
        given = self.entry.normal
        assert given is not None
        deviation = self.number("normal", given.deviation, difference=True)
        if not self.failed and not deviation > 0.0:
            self.say("normal", f"deviation must be more than 0 (got {given.deviation!r})")
        if given.mean is None:
            return (
                None
                if self.scenario_values() is None or self.failed
                else (NormalDistribution(0.0, deviation), ())
            )
        mean = self.number("normal", given.mean)
        middle = (((*self.at, "normal"), mean),)
        return None if self.failed else (NormalDistribution(mean, deviation), middle)

    def factor(self) -> tuple[Distribution, Extremes] | None:
        """Distribution of a factor."""
        given = self.entry.factor
        assert given is not None
        if self.goal.relative or self.scenario_values() is None:
            if self.goal.relative:
                self.say("factor", "cannot multiply a change; give from and to, or normal")
            return None
        if given.deviation is not None:
            return NormalFactor(float(given.deviation)), ()
        assert given.from_ is not None
        assert given.to is not None
        return UniformDistribution(float(given.from_), float(given.to)), ()

    def scenario_values(self) -> tuple[float, ...] | None:
        """The scenario's own value of each robot; None if one has none, which is recorded."""
        if self.goal.relative:
            return (0.0,) * len(self.scenarios)
        found = []
        for scenario in self.scenarios:
            value: Any = scenario
            for key in self.goal.path:
                if isinstance(key, str) and not isinstance(value, dict):
                    value = getattr(value, key, None)
                else:
                    value = value[key]
                if value is None:
                    break
            if not _is_number(value):
                self.say("", "the scenario has no number here to start from; give it one")
                return None
            found.append(float(value))
        return tuple(found)


def scatter_dimensions(deviations: Scatter, scenario: Scenario) -> list[Dimension]:
    """Dimensions of scatter, as in a trial (`springback.studies.trials.trial_tables`).

    Args:
        deviations: Standard deviations; quantities without one are left out.
        scenario: Scenario with a wall, if walls are scattered.

    Raises:
        InputError: If it has no wall.
    """
    rows: list[tuple[str, str, float, str, Place | None]] = []
    for name, unit, deviation in (
        ("position", "m", deviations.position), ("velocity", "m/s", deviations.velocity)
    ):  # fmt: skip
        key = "offset" if name == "position" else name  # references do not follow it
        for k, axis in enumerate("xyz"):
            rows.append((f"{name}_{axis}", unit, deviation, "start", addition((key, k))))
    rows.append(("heading", "rad", deviations.heading, "start", addition(("yaw",))))
    walls = (deviations.wall_distance, deviations.wall_yaw)
    moves = [
        target(word, scenario).place if deviation > 0.0 else None
        for word, deviation in zip((WALL_SHIFT, WALL_ANGLE), walls, strict=True)
    ]
    rows.append(("wall_distance", "m", walls[0], "world", moves[0]))
    rows.append(("wall_yaw", "rad", walls[1], "world", moves[1]))
    for name, deviation in (("mass", deviations.mass), ("inertia", deviations.inertia)):
        rows.append((f"{name}{FACTOR}", "", deviation, "model_error", multiplication((name,))))
    for name in GAINS:
        rows.append((f"{name}{FACTOR}", "", deviations.gains, "control", multiplication((name,))))
    found = []
    for slot, (word, unit, deviation, table, place) in enumerate(rows):
        if deviation > 0.0 and place is not None:
            law = (
                NormalFactor(deviation)
                if word.endswith(FACTOR)
                else NormalDistribution(0.0, deviation)
            )
            found.append(Dimension(f"scatter_{word}", unit, law, table, place, slot=slot))
    return found


#: Random numbers of a flight that scatter needs.
SLOTS = 16

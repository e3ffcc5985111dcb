"""Plan, cost and flights of a resilience envelope: how often a robot recovers, over two parameters.

It is a campaign: a grid over two fields, whose repeats are trials with the scatter of
`springback.studies.trials.Scatter`, the same for all robots.  A cell is a pair of values.  A cell
whose test the vehicle cannot fly, because the run-up asks for more than it can do, is no failure
and counts nowhere.
"""

from __future__ import annotations

import os
import re
from collections import Counter, defaultdict
from collections.abc import Sequence
from typing import Any, NamedTuple

from springback.batch.scenarios import REFUSED
from springback.campaign.analysis.envelope import Axis, CellIndex, Envelope, EnvelopeCell
from springback.campaign.cost_estimate import kinds_of
from springback.campaign.design.layout import Design, lay_out
from springback.campaign.design.plan import Plan, ScatterSettings, Source, Vary
from springback.campaign.design.targets import NAMES, field_path
from springback.campaign.flying import rows, try_code
from springback.errors import InputError, excerpt
from springback.problems import dotted_path
from springback.progress import Progress, silent
from springback.scenario.fields import degrees
from springback.scenario.overrides import apply_overrides
from springback.scenario.scenario import scenario_from
from springback.studies.run_ups import run_up_scenario
from springback.studies.trials import DURATION, HOME, Scatter

ROBOTS = ("arq", "quad")
AXES = ("speed=1:5:9", "pitch=-60deg:60deg:9")
TRIALS = 10
#: The run-up where neither axis nor setting says otherwise [m/s], [deg]: the paper's fastest.
SPEED, PITCH = 3.5, 0.0
#: Fields that cannot be given, with the alternative.
FIXED = {
    "seed": "give --seed",
    "vehicle": "give --robot, or a number of the vehicle, such as vehicle.arms.stiffness",
    "vehicle.preset": "give --robot",
    "name": "a trial has no name",
}
#: About as many flights as are in memory at once (chosen).
FLIGHTS_AT_ONCE = 320
#: Beginning of a problem with one value of a field.
VALUE = re.compile(r"^\S+ = \S+: ")
#: More values along an axis, trials of a cell, or flights in total, are a slip of the pen (chosen).
MOST_VALUES, MOST_TRIALS, MOST_FLIGHTS = 200, 1000, 1_000_000
#: Measured on two cores, compiled: a flight of 8 s, and a cell's run-up on average over the default
#: map: 0.1 s where there is one, 1 s where there is none [s].
FLIGHT_TIME, RUN_UP_TIME = 0.024, 0.5


class EnvelopePlan(NamedTuple):
    """Checked plan of an envelope."""

    design: Design
    x: Axis
    y: Axis
    settings: tuple[str, ...]
    """Settings of all trials, as given."""

    def flight(self, sample: int, robot: int) -> int:
        """Number of the first flight of a robot in a cell."""
        return (sample * self.design.plan.repeats) * len(self.design.robots) + robot

    def tables(self, flight: int) -> dict[str, Any]:
        """The scenario of a flight."""
        return self.design.slice(flight, flight + 1).tables[0]

    @property
    def corners(self) -> list[dict[str, Any]]:
        """Scenarios at the corners, each to hover: no run-up is sought, which is slow."""
        columns, rows = len(self.x.values), len(self.y.values)
        samples = (0, rows - 1, (columns - 1) * rows, columns * rows - 1)
        robots = range(len(self.design.robots))
        flights = (self.flight(sample, robot) for sample in samples for robot in robots)
        return [self.tables(flight) | {"reference": {"type": "hold"}} for flight in flights]


class _CommandSource(Source):
    """Source of a campaign from a command, whose words appear in its problems."""

    def problem_line(self, path: Sequence[str | int], what: str) -> str:
        """A problem in one line, with short names of fields."""
        for name in ("speed", "pitch"):
            what = what.replace(f"{dotted_path(NAMES[name])}:", f"{name}:")
        if path[:1] != ("vary",):
            return what
        axis = self.overrides[int(path[1])]
        return f"{axis}: {re.sub(VALUE, '', what).removeprefix(f'{axis}: ')}"


def plan_envelope(
    x: str = AXES[0],
    y: str | None = None,
    *,
    robots: Sequence[str] = ROBOTS,
    trials: int = TRIALS,
    seed: int = 0,
    settings: Sequence[str] = (),
) -> EnvelopePlan:
    """Read and check the axes and settings of an envelope.

    Args:
        x: First axis, ``name=from:to:count``.
        y: Second axis; by default pitch, or speed where the first axis is not.
        robots: Presets, and vehicle files.
        trials: Of each cell.
        seed: Of all noise.
        settings: ``key=value``, the same in all trials.

    Raises:
        InputError: If they are invalid.
    """
    if not 1 <= trials <= MOST_TRIALS:
        raise InputError(f"--trials: must be from 1 to {MOST_TRIALS} (got {trials})")
    if seed < 0:
        raise InputError(f"--seed: must be at least 0 (got {seed})")
    if not robots:
        raise InputError("--robot: name at least one")
    first = _vary(x)
    second = _vary(y or (AXES[1] if field_path(first.field) == NAMES["speed"] else AXES[0]))
    taken = [field_path(first.field), field_path(second.field)]
    tables = {
        **run_up_scenario(ROBOTS[0], PITCH, SPEED, simulation={"duration": DURATION}),
        "vehicle": {"preset": ROBOTS[0]},
        "recovery": {"home": list(HOME)},
    }
    tables["world"]["obstacles"].append({"type": "ground", "surface": "wall"})
    for word in settings:
        tables = apply_overrides(tables, [_setting(word, taken)])
    plan = Plan(
        name="map", seed=seed, scenario=tables, robots=tuple(dict.fromkeys(robots)), method="grid",
        repeats=trials, vary=(first, second), scatter=ScatterSettings(**Scatter()._asdict()),
    )  # fmt: skip
    try:
        design = lay_out(plan, _CommandSource(overrides=(first.field, second.field)))
    except InputError as error:
        raise InputError(error.problems[0]) from None
    try_code(design)
    if design.flights > MOST_FLIGHTS:
        raise InputError(f"{design.flights} flights are too many; at most {MOST_FLIGHTS}")
    return EnvelopePlan(design, _axis(design, 0), _axis(design, 1), tuple(settings))


def _vary(text: str) -> Vary:
    """Variation along an axis written as ``name=from:to:count``."""
    name, sign, span = text.partition("=")
    parts = span.split(":")
    if not sign or not name.strip() or len(parts) != 3:
        raise InputError(
            f"{excerpt(text)!r} is no axis; write name=from:to:count, such as speed=1:5:9 or "
            "pitch=-60deg:60deg:9"
        )
    name = _field_name(name)
    count = int(parts[2]) if parts[2].strip().isdecimal() else 0
    if not 2 <= count <= MOST_VALUES:
        raise InputError(
            f"{name}: count must be a whole number from 2 to {MOST_VALUES} (got {parts[2]!r})"
        )
    column = name if "." in name else None
    return Vary(field=name, name=column, from_=parts[0], to=parts[1], count=count)


def _setting(word: str, taken: Sequence[Any]) -> str:
    """A setting written as ``key=value``, as an override."""
    name, sign, text = word.partition("=")
    if not sign or not name.strip():
        raise InputError(f"{word!r} is no setting; write key=value, such as pitch=30deg")
    path = field_path(_field_name(name))
    if path in taken:
        raise InputError(f"--set {word}: is on an axis already")
    return f"{dotted_path(path)}={text}"


def _field_name(name: str) -> str:
    """A field that a map can be over: dotted where it was written so, but for speed and pitch."""
    path = field_path(name)
    if why := FIXED.get(dotted_path(path)):
        raise InputError(f"{name.strip()}: cannot be given; {why}")
    short = {NAMES[word]: word for word in ("speed", "pitch")}
    return short.get(path) or (name.strip() if len(path) == 1 else dotted_path(path))


def _axis(design: Design, k: int) -> Axis:
    """The values of a dimension in the unit in which people read them."""
    one: Any = design.dimensions[k]
    angle = one.unit == "rad"
    values = tuple(degrees(value) if angle else float(value) for value in one.law.values)
    return Axis(one.column, "deg" if angle else one.unit or "-", values)


def fly_envelope(plan: EnvelopePlan, progress: Progress = silent) -> Envelope:
    """Fly all cells.

    Args:
        plan: From `plan_envelope`.
        progress: Called with the fraction done.
    """
    design, x, y = plan.design, plan.x, plan.y
    outcomes: dict[tuple[int, str], Counter[str]] = defaultdict(Counter)
    refused: dict[tuple[int, str], int] = {}
    each = plan.flight(1, 0)
    size = each * max(1, FLIGHTS_AT_ONCE // each)
    for first in range(0, design.flights, size):
        last = min(first + size, design.flights)
        found = rows(design, (first, last), threads=os.cpu_count() or 1)
        for flight, sample, robot, ended in zip(
            *(found[name] for name in ("flight", "sample", "robot", "outcome")), strict=True
        ):
            outcomes[sample, robot][ended] += 1
            if ended == REFUSED:
                refused.setdefault((sample, robot), flight)
        progress(last / design.flights)
    cells = {}
    for robot in design.robots:
        for row in range(len(y.values)):
            for column in range(len(x.values)):
                place, key = CellIndex(robot, column, row), (column * len(y.values) + row, robot)
                why = _why(plan.tables(refused[key])) if key in refused else ""
                cells[place] = EnvelopeCell({} if why else dict(outcomes[key]), why)
    trials, seed = design.plan.repeats, design.plan.seed
    return Envelope(x, y, design.robots, trials, seed, plan.settings, cells)


def _why(tables: dict[str, Any]) -> str:
    """Reason why a trial cannot be flown, with a remedy."""
    try:
        scenario_from(tables)
    except InputError as error:
        return error.problems[0].removeprefix("reference: ")
    return "it cannot be flown"


class EnvelopeCost(NamedTuple):
    """Time that an envelope will take."""

    cells: int
    flights: int  # at most; cells that cannot be flown fall out
    duration: float  # of a flight [s]
    kinds: int  # of flight
    time: float  # of the whole, on two cores, once compiled [s]

    def sentence(self) -> str:
        """In words."""
        kinds = f"{self.kinds} kind{'s' * (self.kinds != 1)} of flight"
        return (
            f"{self.cells} cells, at most {self.flights} flights of {self.duration:g} s, {kinds}; "
            f"about {self.time:.0f} s on two cores, and a minute or two more for a kind that is "
            "not compiled yet"
        )


def envelope_cost(plan: EnvelopePlan) -> EnvelopeCost:
    """Time that an envelope will take; nothing is flown."""
    flights, corners = plan.design.flights, plan.corners
    cells = flights // plan.design.plan.repeats
    duration = float(scenario_from(corners[0], False).simulation.duration)
    time = flights * FLIGHT_TIME * duration / DURATION + cells * RUN_UP_TIME
    return EnvelopeCost(cells, flights, duration, kinds_of(corners), time)

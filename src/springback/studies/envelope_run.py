"""Flights for a resilience envelope: what is asked over, and flying it cell by cell.

Trials have the luck of `springback.studies.trials.Scatter`; all robots are dealt the same.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from pydantic import ValidationError

from springback.control.reference_parameters import RunUpSettings
from springback.errors import InputError
from springback.problems import dotted, problem_paths
from springback.scenario.scenario import scenario_from
from springback.studies.axes import (
    SHORT,
    Axis,
    Fixed,
    condition,
    example,
    read_axis,
    read_fixed,
)
from springback.studies.envelope import Envelope, EnvelopeCell, Place
from springback.studies.trials import (
    DURATION,
    NO_SCATTER,
    Condition,
    Trial,
    fly_trials,
    kind_of,
    made_ready,
    trial_tables,
)

ROBOTS = ("arq", "quad")
AXES = ("speed=1:5:9", "pitch=-60deg:60deg:9")
TRIALS = 10
#: Most cells and about as many flights as are in memory at once (chosen; fewer cells than
#: references are remembered, so that none is optimised twice).
CELLS_AT_ONCE, FLIGHTS_AT_ONCE = 32, 320
#: More trials of a cell, or flights in total, are a slip of the pen (chosen).
MOST_TRIALS, MOST_FLIGHTS = 1000, 1_000_000
#: Measured on two cores, compiled: a flight of 8 s, and a cell's run-up on average over the default
#: map: 0.1 s where there is one, 1 s where there is none [s].
FLIGHT_TIME, RUN_UP_TIME = 0.024, 0.5

Progress = Callable[[float], None]


@dataclass(frozen=True)
class EnvelopePlan:
    """What is to be flown for an envelope, read and checked."""

    x: Axis
    y: Axis
    robots: tuple[str, ...]
    trials: int
    seed: int
    fixed: tuple[Fixed, ...]

    @property
    def places(self) -> list[Place]:
        """All cells."""
        columns, rows = range(len(self.x.values)), range(len(self.y.values))
        return [Place(robot, i, j) for robot in self.robots for j in rows for i in columns]

    def condition(self, place: Place) -> Condition:
        """The test of a cell."""
        along = (self.x.parameter, self.x.values[place.column])
        across = (self.y.parameter, self.y.values[place.row])
        return condition(place.robot, self.fixed, (along, across))

    def tables(self, place: Place) -> dict[str, Any]:
        """The scenario of a cell's test without luck."""
        robot, pitch, speed, changes = self.condition(place)
        noise_stream = NO_SCATTER.drawn(robot, pitch, speed, 0, 0)
        return trial_tables(robot, pitch, speed, noise_stream, changes)

    def hindrance(self, place: Place) -> str:
        """Why the vehicle cannot fly a cell's test, even without luck; empty if it can.

        Raises:
            InputError: If it cannot be flown for any other reason than the vehicle's strength.
        """
        try:
            scenario_from(self.tables(place))
        except InputError as error:
            return _too_weak(error)
        return ""

    def kinds(self) -> int:
        """Number of kinds of flight at the corners; each kind is compiled once.

        No run-up is sought, which is slow where there is none.

        Raises:
            InputError: If a value is out of its range.
        """
        columns, rows = (0, len(self.x.values) - 1), (0, len(self.y.values) - 1)
        corners = [p for p in self.places if p.column in columns and p.row in rows]
        kinds = set()
        for tables in map(self.tables, corners):
            try:
                RunUpSettings.model_validate(tables["reference"])
                kinds.add(kind_of(made_ready(tables | {"reference": {"type": "hold"}})))
            except ValidationError as error:
                [(path, what), *_] = problem_paths(error)
                _too_weak(InputError(f"{dotted(('reference', *path))}: {what}"))
            except InputError as error:
                _too_weak(error)
        return len(kinds)


def _too_weak(error: InputError) -> str:
    """Why a vehicle cannot fly a test; any other problem is raised, in the user's words."""
    line = error.problems[0]
    if line.startswith("reference: "):
        return line.removeprefix("reference: ")
    if "each rotor's share of the true weight" in line:
        return line
    for name, path in SHORT.items():
        line = line.replace(dotted(path), name)
    raise InputError(line) from None


def plan_envelope(
    x: str = AXES[0],
    y: str | None = None,
    *,
    robots: Sequence[str] = ROBOTS,
    trials: int = TRIALS,
    seed: int = 0,
    settings: Sequence[str] = (),
) -> EnvelopePlan:
    """Read and check what an envelope is asked over.

    Args:
        x: First axis, ``name=from:to:count``.
        y: Second axis; by default pitch, or speed where the first axis is not.
        robots: Presets.
        trials: Of each cell.
        seed: Of all luck.
        settings: ``key=value``, the same in all trials.

    Raises:
        InputError: For what cannot be flown over.
    """
    if not 1 <= trials <= MOST_TRIALS:
        raise InputError(f"--trials: must be from 1 to {MOST_TRIALS} (got {trials})")
    if seed < 0:
        raise InputError(f"--seed: must be at least 0 (got {seed})")
    scenarios = {robot: example(robot) for robot in robots}
    if not scenarios:
        raise InputError("--robot: name at least one")
    known = next(iter(scenarios.values()))
    first = read_axis(x, known)
    second = read_axis(y or (AXES[1] if first.name == "speed" else AXES[0]), known)
    if first.name == second.name:
        raise InputError(f"{first.name}: is on both axes; give two parameters")
    fixed = tuple(read_fixed(word, known) for word in settings)
    for one in fixed:
        if one.path in (first.parameter.path, second.parameter.path):
            raise InputError(f"--set {one.word}: is on an axis already")
    flights = len(first.values) * len(second.values) * len(scenarios) * trials
    if flights > MOST_FLIGHTS:
        raise InputError(f"{flights} flights are too many; at most {MOST_FLIGHTS}")
    plan = EnvelopePlan(first, second, tuple(scenarios), trials, seed, fixed)
    plan.kinds()
    return plan


def fly_envelope(plan: EnvelopePlan, progress: Progress | None = None) -> Envelope:
    """Fly all cells.

    Args:
        plan: From `plan_envelope`.
        progress: Called with the share done.
    """
    places = plan.places
    cells: dict[Place, EnvelopeCell] = {}
    size = max(1, min(CELLS_AT_ONCE, FLIGHTS_AT_ONCE // plan.trials))
    for batch in _batches(places, size):
        done = len(cells)

        def share(part: float, done: int = done, count: int = len(batch)) -> None:
            if progress is not None:
                progress((done + part * count) / len(places))

        able: dict[Place, Condition] = {}
        for k, place in enumerate(batch, 1):
            reason = plan.hindrance(place)
            cells[place] = EnvelopeCell(place, {}, reason)
            if not reason:
                able[place] = plan.condition(place)
            share(0.5 * k / len(batch))
        cells |= _flown(plan, able, lambda part: share(0.5 + 0.5 * part))
        share(1.0)
    settings = tuple(one.word for one in plan.fixed)
    return Envelope(plan.x, plan.y, plan.robots, plan.trials, plan.seed, settings, cells)


def _batches(places: list[Place], size: int) -> Iterator[list[Place]]:
    """Cells of one robot, some at a time."""
    for robot in dict.fromkeys(place.robot for place in places):
        mine = [place for place in places if place.robot == robot]
        for k in range(0, len(mine), size):
            yield mine[k : k + size]


def _flown(
    plan: EnvelopePlan, able: dict[Place, Condition], progress: Progress
) -> dict[Place, EnvelopeCell]:
    """Cells that can be flown without luck, flown with it.

    Where luck, such as more weight, leaves a trial that cannot be flown, its cell counts as one
    that cannot be flown.
    """
    try:
        trials = fly_trials([*able.values()], plan.trials, seed=plan.seed, progress=progress)
        if len(trials) != len(able) * plan.trials:
            raise InputError("reference: one of the trials cannot be flown")
    except InputError as error:
        if len(able) > 1:
            parts = ({place: able[place]} for place in able)
            return {k: cell for one in parts for k, cell in _flown(plan, one, progress).items()}
        return {place: EnvelopeCell(place, {}, _too_weak(error)) for place in able}
    found = {}
    for k, place in enumerate(able):
        mine = trials[k * plan.trials : (k + 1) * plan.trials]
        found[place] = EnvelopeCell(place, _outcomes(mine))
    return found


def _outcomes(trials: Sequence[Trial]) -> dict[str, int]:
    return dict(Counter(trial.outcome.word for trial in trials))


class EnvelopeCost(NamedTuple):
    """What an envelope will take."""

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
    """What an envelope will take; nothing is flown."""
    cells = len(plan.places)
    duration = float(plan.tables(plan.places[0])["simulation"]["duration"])
    time = cells * (plan.trials * FLIGHT_TIME * duration / DURATION + RUN_UP_TIME)
    return EnvelopeCost(cells, cells * plan.trials, duration, plan.kinds(), time)

"""Trials of a recovery: one test repeated with scattered conditions, many side by side."""

from __future__ import annotations

import math
import os
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from springback.batch.scenarios import REFUSED, fly_scenarios
from springback.errors import InputError
from springback.intervals import wilson
from springback.progress import Progress, silent
from springback.random_streams import Purpose, stream
from springback.scenario.scenario import Scenario, merge, scenario_from
from springback.simulation.measuring.measures import Outcome, scalars_of
from springback.studies.run_ups import WALL_DISTANCE, run_up_scenario

#: The paper's start and return point, section Impact Resilience [m].
HOME = (0.0, 0.0, 1.0)
#: Long enough for the slowest run-up of the paper, 2.75 s, recovery and the way home [s], chosen.
DURATION = 11.0


class Scatter(NamedTuple):
    """Standard deviations of what differs from trial to trial; normal laws, all chosen.

    The first five are of the approach: the hover before it, and the pose of the wall.  The others
    are of the robot: how well its mass and inertia are known, and its gains.
    """

    position: float = 0.03  # of the start, each axis [m]
    velocity: float = 0.05  # at the start, each axis [m/s]
    heading: float = math.radians(2.0)  # yaw at the start [rad]
    wall_distance: float = 0.02  # [m]
    wall_yaw: float = math.radians(1.0)  # [rad]
    mass: float = 0.02  # true over believed
    inertia: float = 0.05  # true over believed
    gains: float = 0.05  # each of stiffness, damping ratio, time constant, rate gain

    def draw(self, robot: str, pitch: float, speed: float, trial: int, seed: int) -> TrialNoise:
        """Random numbers of one trial, which depend on these arguments alone.

        Both robots get the same (common random numbers): ``robot`` only names the trial.
        """
        key = (round(1e3 * pitch) % 2**32, round(1e3 * speed) % 2**32, trial)
        noise_stream = stream(seed, Purpose.TRIAL, *key)
        z = noise_stream.standard_normal(16).tolist()
        return TrialNoise(
            position=tuple(h + self.position * x for h, x in zip(HOME, z[:3], strict=True)),
            velocity=tuple(self.velocity * x for x in z[3:6]),
            heading=self.heading * z[6],
            wall_distance=WALL_DISTANCE + self.wall_distance * z[7],
            wall_yaw=self.wall_yaw * z[8],
            mass=math.exp(self.mass * z[9]),
            inertia=math.exp(self.inertia * z[10]),
            gains=tuple(math.exp(self.gains * x) for x in z[11:16]),
            seed=int(noise_stream.integers(2**31)),
        )


class TrialNoise(NamedTuple):
    """Random numbers of one trial."""

    position: tuple[float, ...]
    velocity: tuple[float, ...]
    heading: float
    wall_distance: float
    wall_yaw: float
    mass: float
    inertia: float
    gains: tuple[float, ...]  # factors of both stiffnesses, damping ratio, 1/τ, k_ω
    seed: int


NO_SCATTER = Scatter(*(0.0,) * len(Scatter._fields))


def trial_tables(
    robot: str,
    pitch: float,
    speed: float,
    noise_stream: TrialNoise,
    changes: Mapping[str, Any] | None = None,
) -> dict[str, Any]:
    """The scenario of one trial, as plain tables: run-up, wall, ground, recovery.

    The robot does not know the scatter: it flies the run-up that was planned for the paper's wall.

    Args:
        robot: Preset.
        pitch: At contact, positive nose down [deg].
        speed: At contact [m/s].
        noise_stream: Of the trial.
        changes: Tables merged over those of the test, the same in every trial.
    """
    base = merge(run_up_scenario(robot, pitch, speed), changes or {})
    control = dict(base.get("control", {}))
    defaults = Scenario.model_fields["control"].default
    names = ("stiffness", "vertical_stiffness", "damping_ratio", "time_constant", "rate_gain")
    for name, factor in zip(names, noise_stream.gains, strict=True):
        control[name] = float(control.get(name, getattr(defaults, name))) * factor
    normal = [math.cos(noise_stream.wall_yaw), math.sin(noise_stream.wall_yaw), 0.0]
    surface = base["world"]["obstacles"][0]["surface"]
    obstacles = [
        {
            "type": "wall",
            "normal": [-normal[0], -normal[1], 0.0],
            "position": [noise_stream.wall_distance, 0.0, 0.0],
            "surface": surface,
        },
        {"type": "ground", "surface": "wall"},
    ]
    error = dict(base.get("model_error", {}))
    return base | {
        "reference": {"start": list(HOME)} | base["reference"],
        "world": {**base["world"], "obstacles": obstacles},
        "start": {
            "position": list(noise_stream.position),
            "velocity": list(noise_stream.velocity),
            "yaw": noise_stream.heading,
        },
        "control": control,
        "model_error": {
            "mass": error.get("mass", 1.0) * noise_stream.mass,
            "inertia": error.get("inertia", 1.0) * noise_stream.inertia,
        },
        "recovery": {"home": list(HOME)} | dict(base.get("recovery", {})),
        "simulation": {"duration": DURATION} | dict((changes or {}).get("simulation", {})),
        "seed": noise_stream.seed,
    }


@dataclass(frozen=True)
class Trial:
    """One trial and how it ended."""

    robot: str
    pitch: float
    """Asked for at contact, positive nose down [deg]."""
    speed: float
    """Asked for at contact [m/s]."""
    number: int
    outcome: Outcome
    measures: dict[str, float | None]

    @property
    def condition(self) -> tuple[str, float, float]:
        """Robot, pitch [deg] and speed [m/s]."""
        return self.robot, self.pitch, self.speed

    @property
    def success(self) -> bool:
        """True if it noticed every collision, touched no ground, and came to rest at home."""
        return self.outcome is Outcome.RECOVERED

    def as_dict(self) -> dict[str, Any]:
        """One row of a table."""
        head = {"robot": self.robot, "pitch_deg": self.pitch, "speed": self.speed}
        tail = {"trial": self.number, "outcome": self.outcome.word, "success": self.success}
        return head | tail | self.measures


class Condition(NamedTuple):
    """One test that is flown several times."""

    robot: str
    pitch: float  # [deg]
    speed: float  # [m/s]
    changes: Mapping[str, Any] = {}


@dataclass(frozen=True)
class Tally:
    """Trials of one condition, counted."""

    robot: str
    pitch: float
    """[deg]"""
    speed: float
    """[m/s]"""
    trials: int
    successes: int
    outcomes: dict[str, int]
    """Number of trials by the word of their outcome."""
    medians: dict[str, float | None]
    """Median of each measure over the trials that have it, SI."""

    @property
    def condition(self) -> tuple[str, float, float]:
        """Robot, pitch [deg] and speed [m/s]."""
        return self.robot, self.pitch, self.speed

    @property
    def share(self) -> float:
        """Fraction of the trials that succeeded."""
        return self.successes / self.trials

    @property
    def interval(self) -> tuple[float, float]:
        """Wilson's interval of the same."""
        return wilson(self.successes, self.trials)


def tally(trials: Sequence[Trial]) -> Tally:
    """Counts and medians of the trials of one condition, at least one."""
    first, medians = trials[0], {}
    for name in first.measures:
        known = [value for trial in trials if (value := trial.measures[name]) is not None]
        medians[name] = float(np.median(known)) if known else None
    return Tally(
        *first.condition, len(trials), sum(trial.success for trial in trials),
        dict(Counter(trial.outcome.word for trial in trials)), medians,
    )  # fmt: skip


def fly_trials(
    conditions: Sequence[Condition],
    trials: int,
    *,
    scatter: Scatter | None = None,
    seed: int = 0,
    progress: Progress = silent,
) -> list[list[Trial]]:
    """Fly every condition several times.

    Args:
        conditions: To be flown.
        trials: Number for each.
        scatter: Standard deviations; by default those of `Scatter`.
        seed: Of all random draws.
        progress: Called with the fraction done.

    Returns:
        Trials of each condition; none if it asks for a run-up that the vehicle cannot fly.

    Raises:
        InputError: If a trial cannot be flown for any other reason.
    """
    scatter = scatter or Scatter()
    asked = [(condition, number) for condition in conditions for number in range(trials)]
    tables = [_tables(condition, scatter, number, seed) for condition, number in asked]
    ended = fly_scenarios(tables, threads=os.cpu_count() or 1, progress=progress)
    found: list[list[Trial]] = [[] for _ in conditions]
    for k, (condition, number) in enumerate(asked):
        if not number:
            is_flown = ended.outcomes[k] != REFUSED or not _too_hard(condition)
        if not is_flown:
            continue
        if ended.outcomes[k] == REFUSED:
            scenario_from(tables[k])  # for its longer message
            raise InputError(ended.problems[k])
        outcome = Outcome[ended.outcomes[k].upper()]
        measures = scalars_of({name: column[k : k + 1] for name, column in ended.measures.items()})
        found[k // trials].append(Trial(*condition[:3], number, outcome, measures))
    return found


def _tables(condition: Condition, scatter: Scatter, number: int, seed: int) -> dict[str, Any]:
    """The scenario of a trial of a condition."""
    robot, pitch, speed, changes = condition
    noise_stream = scatter.draw(robot, pitch, speed, number, seed)
    return trial_tables(robot, pitch, speed, noise_stream, changes)


def _too_hard(condition: Condition) -> bool:
    """True if a condition cannot be flown even without scatter: the run-up asks for too much."""
    try:
        scenario_from(_tables(condition, NO_SCATTER, 0, 0))
    except InputError as error:
        return all(line.startswith("reference: the run-up") for line in error.problems)
    return False

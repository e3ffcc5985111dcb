"""Free flight, Table IV: steps and circles of Quad, and of ARQ before and after collisions.

Two gains are fitted to Quad's steps (studies/gains.py); all numbers of ARQ, and both robots'
circles, follow.  What the paper leaves open is chosen here and said so: how long a circle is flown,
its centre and sense, and how often and at which tilt ARQ falls before its last column.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from itertools import product
from typing import Any, Literal

import numpy as np

from springback.paper.responses import (
    Axis,
    circle_errors,
    mean_square_error,
    rise_time,
    step_response,
)
from springback.progress import Progress, silent
from springback.results.flight import Flight, fly
from springback.studies.comparison import Mark, Row, predicted_or_contradicted

Robot = Literal["quad", "arq", "arq after drops"]
Pace = Literal["slow", "fast"]

ROBOTS: tuple[Robot, ...] = ("quad", "arq", "arq after drops")
"""Columns of Table IV: Quad, ARQ pre-col, ARQ post-col."""
TRIALS = 5
"""Section IV-C: five repeated trials of each test."""
SEEDS_APART = 1000
"""Between the first seeds of two columns: no two trials share their noise."""
DWELL = 5.0
"""[s], section IV-C, between set-points."""
STEP_BEGINS: dict[Axis, float] = {"x": 2.0 * DWELL, "y": 3.0 * DWELL, "z": 1.0 * DWELL}
"""[s], when each axis is asked to step by 1 m: [0,0,1], [0,0,2], [1,0,2], [1,1,2]."""
STEP_FROM: dict[Axis, float] = {"x": 0.0, "y": 0.0, "z": 1.0}
"""[m], before the step."""
PERIODS: dict[Pace, float] = {"slow": 2.0 * math.pi, "fast": math.pi}
"""[s], section IV-C."""
RADIUS = 1.0
"""[m], section IV-C."""
CIRCLE_TIME = 4.0 * math.pi
"""[s], chosen, for the paper prints none: two slow rounds or four fast ones."""
DROP_TILTS = ((0.0, 0.0), (10.0, 0.0), (20.0, 10.0))
"""[deg], roll and pitch of the falls before the last column; chosen, the paper prints none."""
DROP_HEIGHT = 1.0
"""[m], section IV-C, free falls at 1 m."""
DROP_TIME = 3.0
"""[s], chosen: the fall takes 0.45 s, then the robot comes to rest."""

TABLE_IV_STEPS: dict[Robot, dict[Axis, tuple[float, float]]] = {
    "quad": {"x": (0.649, 0.090), "y": (0.662, 0.094), "z": (0.625, 0.059)},
    "arq": {"x": (0.760, 0.098), "y": (0.782, 0.107), "z": (0.627, 0.064)},
    "arq after drops": {"x": (0.767, 0.108), "y": (0.779, 0.108), "z": (0.628, 0.062)},
}
"""Table IV, step response: rise time [s] and mean square error, printed as [m], which is m²."""
QUANTITIES = ("px", "py", "vx", "vy")
TABLE_IV_CIRCLES: dict[tuple[Robot, Pace], tuple[float, float, float, float]] = {
    ("quad", "slow"): (0.88e-3, 3.80e-3, 1.20e-3, 23.90e-3),
    ("arq", "slow"): (1.10e-3, 6.10e-3, 1.80e-3, 23.70e-3),
    ("arq after drops", "slow"): (2.00e-3, 6.20e-3, 1.80e-3, 24.40e-3),
    ("quad", "fast"): (9.70e-3, 13.80e-3, 46.10e-3, 100.80e-3),
    ("arq", "fast"): (15.90e-3, 17.00e-3, 74.50e-3, 99.50e-3),
    ("arq after drops", "fast"): (22.20e-3, 19.90e-3, 95.40e-3, 102.80e-3),
}
"""Table IV, planar circle: mean square errors of p_x, p_y [m²], v_x and v_y [m²/s²]."""
UNITS = {"px": "m^2", "py": "m^2", "vx": "m^2/s^2", "vy": "m^2/s^2"}
FITTED = "two gains were chosen so that Quad's steps come out"


@dataclass(frozen=True)
class Drop:
    """A fall of ARQ onto the ground with its motors off."""

    roll: float
    """At the start [rad]."""
    pitch: float
    """At the start [rad]."""
    stroke: float
    """Largest compression of an arm [m]."""
    peak_acceleration: float
    """[m/s²]"""
    lengths: tuple[float, ...]
    """Lengths of the arms at the end [m]."""
    left: float
    """Largest deviation of an arm from its free length at the end [m]."""


@dataclass(frozen=True)
class Response:
    """One trial of the steps."""

    robot: Robot
    seed: int
    rise: dict[Axis, float]
    """Rise time of each axis, 10 to 90 % of the attained steady state [s]."""
    mse: dict[Axis, float]
    """Mean over the dwell of (1 - p)² of the axis that steps [m²]."""
    flight: Flight | None = field(default=None, repr=False)
    """Kept for the first trial of each robot."""


@dataclass(frozen=True)
class CircleRun:
    """One trial of a circle."""

    robot: Robot
    pace: Pace
    seed: int
    mse: dict[str, float]
    """Of `QUANTITIES`, over `CIRCLE_TIME` from the start [m²], [m²/s²]."""
    mse_after_first_round: dict[str, float]
    """The same without the first round, that is without the start."""
    flight: Flight | None = field(default=None, repr=False)
    """Kept for the first trial of each robot and pace."""


@dataclass
class FlightResults:
    """All trials of Table IV."""

    trials: int
    drops: list[Drop] = field(default_factory=list)
    responses: list[Response] = field(default_factory=list)
    circles: list[CircleRun] = field(default_factory=list)

    def rise(self, robot: Robot, axis: Axis) -> list[float]:
        """Rise times of all trials [s]."""
        return [trial.rise[axis] for trial in self.responses if trial.robot == robot]

    def step_mse(self, robot: Robot, axis: Axis) -> list[float]:
        """Mean square errors of all trials of a step [m²]."""
        return [trial.mse[axis] for trial in self.responses if trial.robot == robot]

    def circle_mse(
        self, robot: Robot, pace: Pace, quantity: str, *, first_round: bool = True
    ) -> list[float]:
        """Mean square errors of all trials of a circle, with its first round or without."""
        runs = [run for run in self.circles if run.robot == robot and run.pace == pace]
        return [(run.mse if first_round else run.mse_after_first_round)[quantity] for run in runs]

    def response(self, robot: Robot) -> Response:
        """The trial whose flight is kept."""
        return next(trial for trial in self.responses if trial.robot == robot and trial.flight)

    def circle(self, robot: Robot, pace: Pace) -> CircleRun:
        """The trial whose flight is kept."""
        runs = (run for run in self.circles if run.robot == robot and run.pace == pace)
        return next(run for run in runs if run.flight)

    def rows(self) -> list[Row]:
        """Ours beside print, for every cell of Table IV."""
        return [*self._step_rows(), *self._circle_rows()]

    def _step_rows(self) -> list[Row]:
        rows = []
        for robot, axis in product(ROBOTS, STEP_BEGINS):
            rise, error = TABLE_IV_STEPS[robot][axis]
            fitted = FITTED if robot == "quad" else ""
            rows += [
                _row(robot, "steps", f"rise time of p_{axis}", "s", self.rise(robot, axis), rise,
                     fitted),
                _row(robot, "steps", f"mean square error of p_{axis}", "m^2",
                     self.step_mse(robot, axis), error, fitted),
            ]  # fmt: skip
        return rows

    def _circle_rows(self) -> list[Row]:
        rows = []
        for robot, pace in product(ROBOTS, PERIODS):
            for name, printed in zip(QUANTITIES, TABLE_IV_CIRCLES[robot, pace], strict=True):
                rows.append(
                    _row(
                        robot, f"{pace} circle", f"mean square error of {name[0]}_{name[1]}",
                        UNITS[name], self.circle_mse(robot, pace, name), printed,
                    )
                )  # fmt: skip
        return rows


def _row(
    robot: Robot, reading: str, quantity: str, unit: str, ours: list[float], printed: float,
    fitted: str = "",
) -> Row:  # fmt: skip
    """Mean of the trials beside print, which is a mean of physical tests; the spread is noted."""
    mean = float(np.mean(ours))
    mark = Mark.FITTED if fitted else predicted_or_contradicted(mean, printed)
    spread = f"{len(ours)} trials, standard deviation {spread_of(ours):.2g} {unit}"
    note = "; ".join(part for part in (spread, fitted) if part)
    return Row(
        "Table IV", robot, "", reading, quantity, unit, mean, printed, None, mark, 0.0, "", note
    )


def spread_of(values: list[float]) -> float:
    """Standard deviation of trials; 0 for a single one."""
    return float(np.std(values, ddof=1)) if len(values) > 1 else 0.0


def step_tables(vehicle: Any, seed: int) -> dict[str, Any]:
    """The scenario of one trial of the steps, as plain tables; ``vehicle`` as in a scenario."""
    return {
        "name": "steps",
        "vehicle": vehicle,
        "reference": {"type": "steps", "dwell": DWELL},
        "simulation": {"duration": 4.0 * DWELL},
        "seed": seed,
    }


def circle_tables(vehicle: Any, pace: Pace, seed: int) -> dict[str, Any]:
    """The scenario of one trial of a circle: at rest at [1, 0, 1], the reference in full motion."""
    return {
        "name": f"{pace} circle",
        "vehicle": vehicle,
        "start": {"position": [RADIUS, 0.0, 1.0]},
        "reference": {"type": "circle", "radius": RADIUS, "period": PERIODS[pace]},
        "simulation": {"duration": CIRCLE_TIME},
        "seed": seed,
    }


def drop_tables(vehicle: Any, roll: float, pitch: float) -> dict[str, Any]:
    """The scenario of a fall onto the ground, motors off; angles in degrees."""
    return {
        "name": "drop",
        "vehicle": vehicle,
        "world": {"obstacles": [{"type": "ground", "surface": "wall"}]},
        "start": {
            "position": [0.0, 0.0, DROP_HEIGHT],
            "roll": math.radians(roll),
            "pitch": math.radians(pitch),
        },
        "simulation": {"duration": DROP_TIME},
    }


def drop_repeatedly(vehicle: dict[str, Any]) -> list[Drop]:
    """Let a vehicle fall again and again; each fall begins with the arms as the last left them."""
    drops: list[Drop] = []
    for roll, pitch in DROP_TILTS:
        flight = fly(drop_tables(_with_arms(vehicle, drops), roll, pitch))
        free = flight.scenario.vehicle.lengths()
        lengths = tuple(float(flight.columns[f"l{j + 1}"][-1]) for j in range(len(free)))
        left = max(abs(now - before) for now, before in zip(lengths, free, strict=True))
        stroke, peak = flight.measures["arm_stroke"], flight.measures["peak_acceleration"]
        drops.append(
            Drop(math.radians(roll), math.radians(pitch), stroke or 0.0, peak or 0.0, lengths, left)
        )
    return drops


def _with_arms(vehicle: dict[str, Any], drops: list[Drop]) -> dict[str, Any]:
    """The vehicle with the arms as the last drop left them."""
    if not drops:
        return vehicle
    arms = {**vehicle.get("arms", {}), "length": list(drops[-1].lengths)}
    return {**vehicle, "arms": arms}


def fly_steps(robot: Robot, vehicle: Any, seed: int, *, keep: bool = False) -> Response:
    """Fly one trial of the steps and measure it; the flight is kept on demand."""
    flight = fly(step_tables(vehicle, seed))
    rise: dict[Axis, float] = {}
    error: dict[Axis, float] = {}
    for axis, begins in STEP_BEGINS.items():
        response = step_response(flight, axis, begins, DWELL, STEP_FROM[axis])
        rise[axis], error[axis] = rise_time(*response), mean_square_error(*response)
    return Response(robot, seed, rise, error, flight if keep else None)


def fly_circle(
    robot: Robot, vehicle: Any, pace: Pace, seed: int, *, keep: bool = False
) -> CircleRun:
    """Fly one trial of a circle and measure it; the flight is kept on demand."""
    flight, period = fly(circle_tables(vehicle, pace, seed)), PERIODS[pace]
    whole = circle_errors(flight, period, RADIUS, 0.0, CIRCLE_TIME)
    later = circle_errors(flight, period, RADIUS, period, CIRCLE_TIME)
    return CircleRun(robot, pace, seed, whole, later, flight if keep else None)


def flight_experiments(trials: int = TRIALS, progress: Progress = silent) -> FlightResults:
    """Fly all of Table IV with motion capture, inertial unit and Kalman filter.

    Every trial has noise of its own.  After the drops the arms are back at their free length, so
    the last column differs from the one before it in its noise alone.

    Args:
        trials: Of each test.
        progress: Called with the fraction done.
    """
    results = FlightResults(trials)
    results.drops = drop_repeatedly({"preset": "arq"})
    vehicles: dict[Robot, dict[str, Any]] = {
        "quad": {"preset": "quad"},
        "arq": {"preset": "arq"},
        "arq after drops": _with_arms({"preset": "arq"}, results.drops),
    }
    for done, (k, trial) in enumerate(product(range(len(ROBOTS)), range(trials)), start=1):
        robot, seed, keep = ROBOTS[k], SEEDS_APART * k + trial, trial == 0
        results.responses.append(fly_steps(robot, vehicles[robot], seed, keep=keep))
        for pace in PERIODS:
            results.circles.append(fly_circle(robot, vehicles[robot], pace, seed, keep=keep))
        progress(done / (len(ROBOTS) * trials))
    return results

"""Effect of friction on the springs: stroke and peak over its axes, coefficient and the yaw.

An arm slides along its own direction.  At 45 degrees to a wall it can give way only if its cage
slides along the wall, so that of a normal force f the arm feels f (1 - mu)/sqrt(2) where friction
opposes that slip, and f/sqrt(2) where it acts along the vertical only.  An arm straight ahead needs
no slip.  This study flies hovering robots into the paper's wall: the paper's, or the user's own.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from springback.batch.scenarios import fly_scenarios
from springback.progress import Progress, silent, stage
from springback.studies.run_ups import ROBOTS, WALL_DISTANCE, StudyVehicle, study_vehicles
from springback.studies.trials import Condition, fly_trials, tally

Array = np.ndarray[Any, np.dtype[np.float64]]

AXES = ("vertical", "both")
"""Values of `SurfaceSettings.friction_axes`."""
FRICTIONS = tuple(round(0.1 * k, 1) for k in range(11))
"""Coefficients; Table II prints 0.8."""
YAWS = (0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 7.5, *(5.0 * k for k in range(2, 10)))
"""[deg]: at 0 two arms at 45 degrees meet the wall, at 45 one arm straight ahead."""
SPEED = 2.0
"""[m/s], the slower of the paper's speeds."""
PRINTED_FRICTION = 0.8
SPEEDS = (2.0, 3.5)
"""[m/s], of the trials."""
TRIALS = 40
ROOM = 0.03
"""[m], free run before the touch."""
DURATION = 0.25
"""[s]: approach, contact, and the arms' way back."""


class HoverImpact(NamedTuple):
    """One collision of a hovering robot."""

    robot: str
    axes: str
    friction: float
    yaw: float  # [deg]
    speed: float  # [m/s]
    stroke: float  # largest compression of an arm [m]
    peak: float  # peak acceleration of the main body [m/s²]
    restitution: float
    arm_share: float  # of the energy lost, by the arms' dampers

    def as_dict(self) -> dict[str, Any]:
        """One row of a table."""
        return {
            "robot": self.robot, "friction axes": self.axes, "friction": self.friction,
            "yaw [deg]": self.yaw, "speed [m/s]": self.speed, "stroke [m]": self.stroke,
            "peak acceleration [m/s^2]": self.peak, "restitution at separation": self.restitution,
            "share of the losses in the arms": self.arm_share,
        }  # fmt: skip


class PilotedImpacts(NamedTuple):
    """The paper's straight collision, with run-up, sensors and recovery: medians of trials."""

    robot: str
    axes: str
    speed: float  # [m/s]
    trials: int
    recovered: int
    stroke: float  # [m]
    peak: float  # [m/s²]

    def as_dict(self) -> dict[str, Any]:
        """One row of a table."""
        return {
            "robot": self.robot, "friction axes": self.axes, "speed [m/s]": self.speed,
            "trials": self.trials, "recovered": self.recovered,
            "median stroke [m]": self.stroke, "median peak acceleration [m/s^2]": self.peak,
        }  # fmt: skip


@dataclass
class FrictionResults:
    """All collisions of the study."""

    impacts: list[HoverImpact] = field(default_factory=list)
    flown: list[PilotedImpacts] = field(default_factory=list)

    @property
    def robots(self) -> tuple[str, ...]:
        """Robots in order."""
        return tuple(dict.fromkeys(i.robot for i in self.impacts))

    @property
    def sprung(self) -> tuple[str, ...]:
        """Robots with an arm that slid; all if there is none."""
        slid = {i.robot for i in self.impacts if i.stroke > 0.0}
        return tuple(robot for robot in self.robots if robot in slid) or self.robots

    def grid(self, robot: str, axes: str, measure: str) -> tuple[list[float], list[float], Array]:
        """Coefficients, yaws [deg] and a measure of shape (coefficients, yaws)."""
        mine = {(i.friction, i.yaw): i for i in self.impacts if (i.robot, i.axes) == (robot, axes)}
        frictions, yaws = (sorted({key[k] for key in mine}) for k in (0, 1))
        values = [[getattr(mine[mu, yaw], measure) for yaw in yaws] for mu in frictions]
        return frictions, yaws, np.array(values, float).reshape(len(frictions), len(yaws))

    def at(self, robot: str, axes: str, friction: float, yaw: float) -> HoverImpact:
        """One collision of the grid."""
        asked = (robot, axes, friction, yaw)
        return next(i for i in self.impacts if (i.robot, i.axes, i.friction, i.yaw) == asked)


def impact_tables(
    robot: StudyVehicle, axes: str, friction: float, yaw: float, speed: float
) -> dict[str, Any]:
    """The scenario of one collision, as plain tables: level, with hover thrust, no pilot.

    Args:
        robot: Vehicle.
        axes: Along which tangents friction acts, ``vertical`` or ``both``.
        friction: Coefficient.
        yaw: Of the robot against the wall's normal [deg].
        speed: Into the wall [m/s].
    """
    psi = math.radians(yaw)
    surface = {"preset": "wall", "friction": friction, "friction_axes": axes}
    return {
        "name": f"{robot.name}, {axes}, mu {friction:g}, yaw {yaw:g} deg",
        "vehicle": robot.tables,
        "thrust": "hover",
        "world": {"obstacles": [{"type": "wall", "distance": WALL_DISTANCE, "surface": surface}]},
        "start": {
            "position": [WALL_DISTANCE - robot.reach(psi) - ROOM, 0.0, 1.0],
            "velocity": [speed, 0.0, 0.0],
            "yaw": psi,
        },
        "simulation": {"duration": DURATION},
    }


def friction_study(
    trials: int = TRIALS,
    *,
    robots: Sequence[str] = ROBOTS,
    frictions: Sequence[float] = FRICTIONS,
    yaws: Sequence[float] = YAWS,
    speed: float = SPEED,
    seed: int = 0,
    progress: Progress = silent,
) -> FrictionResults:
    """Fly the grid of collisions, and the paper's straight tests with either friction.

    Args:
        trials: Of each straight test; none are flown with 0.
        robots: Presets, and files with a vehicle.
        frictions: Coefficients.
        yaws: [deg].
        speed: Of the grid [m/s].
        seed: Of the random draws of the trials.
        progress: Called with the fraction done.

    Raises:
        InputError: If a robot is invalid.
    """
    vehicles = study_vehicles(robots)
    asked = [
        (robot, axes, friction, yaw)
        for robot in vehicles
        for axes in AXES
        for friction in frictions
        for yaw in yaws
    ]
    tables = [impact_tables(*one, speed) for one in asked]
    rows = fly_scenarios(tables, progress=stage(progress, 0.0, 0.5))
    names = "impact_arm_stroke", "impact_peak_acceleration", "restitution_at_separation"
    columns = [rows.measures[name] for name in names]
    arms = rows.measures["loss_arm"]
    lost = arms + rows.measures["loss_contact"] + rows.measures["loss_friction"]
    results = FrictionResults()
    for k, (robot, axes, friction, yaw) in enumerate(asked):
        stroke, peak, restitution = (float(column[k]) for column in columns)
        share = float(arms[k] / lost[k])
        results.impacts.append(
            HoverImpact(robot.name, axes, friction, yaw, speed, stroke, peak, restitution, share)
        )
    for k, axes in enumerate(AXES if trials else ()):
        surface = {"preset": "wall", "friction_axes": axes}
        wall = {"type": "wall", "distance": WALL_DISTANCE, "surface": surface}
        tests = [
            Condition(
                robot.name, 0.0, speed, {"vehicle": robot.tables, "world": {"obstacles": [wall]}}
            )
            for robot in vehicles
            for speed in SPEEDS
        ]
        part = stage(progress, 0.5 + 0.5 * k / len(AXES), 0.5 / len(AXES))
        for found in map(tally, fly_trials(tests, trials, seed=seed, progress=part)):
            stroke, peak = (
                found.medians[name] or 0.0
                for name in ("impact_arm_stroke", "impact_peak_acceleration")
            )
            results.flown.append(
                PilotedImpacts(
                    found.robot, axes, found.speed, trials, found.successes, stroke, peak
                )
            )
    return results


def friction_sentences(results: FrictionResults) -> list[str]:
    """Results of the study, a line each."""
    said = []
    words = {"vertical": "along e_Z, the paper's", "both": "along both tangents"}
    for robot in results.sprung:
        held = [results.at(robot, axes, PRINTED_FRICTION, 0.0) for axes in AXES]
        ahead = results.at(robot, "both", PRINTED_FRICTION, YAWS[-1])
        for one in (*held, ahead):
            said.append(
                f"{robot}, mu {one.friction:g} {words[one.axes]}, yaw {one.yaw:g} deg, "
                f"{one.speed:g} m/s: stroke {1e3 * one.stroke:.1f} mm, peak {one.peak:.0f} "
                f"m/s^2, arms take {100 * one.arm_share:.0f} % of the losses"
            )
    for row in results.flown:
        said.append(
            f"{row.robot} in flight at 0 deg, {row.speed:g} m/s, friction {words[row.axes]}: "
            f"median stroke {1e3 * row.stroke:.1f} mm, peak {row.peak:.0f} m/s^2, recovered "
            f"{row.recovered} of {row.trials}"
        )
    return said

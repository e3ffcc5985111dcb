"""Why one robot survives and another does not: one thing at a time is made otherwise.

Two at a time are in `springback.studies.ablation_pairs`.

Every variant flies the paper's tests with the same luck (`springback.studies.trials.Scatter`)
and differs from the default in one thing.  Ranges walk along one number that the paper does not
print, to see over which of its values the printed result holds.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from springback.scenario.scenario import merge
from springback.sensing.parameters import STANDARD_GRAVITY
from springback.studies.run_ups import CONDITIONS, PAPER_WALL
from springback.studies.trials import Condition, Trial, fly_trials
from springback.vehicle.library import VEHICLES

ROBOTS = ("arq", "quad")
TRIALS = 10
Changes = Callable[[str], Mapping[str, Any]]


class Ablation(NamedTuple):
    """One thing made otherwise."""

    cause: str  # what is switched
    name: str  # to what
    changes: Changes  # tables laid over a robot's test
    robots: tuple[str, ...] = ROBOTS


def same(tables: Mapping[str, Any]) -> Changes:
    """The same tables for both robots."""
    return lambda robot: tables


def vehicle_changes(tables: Mapping[str, Any]) -> Changes:
    """Each robot's preset with some of its numbers changed."""
    return lambda robot: {"vehicle": {"preset": robot, **tables}}


def thrust(factor: float) -> Changes:
    """Rotors stronger or weaker by a factor."""

    def changes(robot: str) -> Mapping[str, Any]:
        propulsion = VEHICLES[robot].vehicle.propulsion
        assert propulsion is not None  # both presets fly
        return {"vehicle": {"preset": robot, "propulsion": {
            "max_thrust": factor * propulsion.max_thrust}}}  # fmt: skip

    return changes


def surface_of(friction: float | None = None, axes: str = "vertical") -> Mapping[str, Any]:
    """The paper's wall with another friction.

    Args:
        friction: Coefficient; Table II's if none is given.
        axes: Along which tangents it acts.
    """
    surface: dict[str, Any] = {"preset": PAPER_WALL, "friction_axes": axes}
    if friction is not None:
        surface["friction"] = friction
    return {"world": {"obstacles": [{"type": "wall", "distance": 2.75, "surface": surface}]}}


def degrees(rate: float) -> Mapping[str, Any]:
    """Another limit of the rates of roll and pitch [deg/s]."""
    return {"control": {"rate_limit": math.radians(rate)}}


def _way(name: str) -> Changes:
    return same({"recovery": {"response": {"way": name}}})


#: No accelerometer of the kind reads this far [m/s²].
UNLIMITED = 2000.0
LARGE_RANGE: Mapping[str, Any] = {
    "sensors": {"imu": {"accelerometer": {"full_scale": UNLIMITED}}},
    "estimator": {"kalman": {"accelerometer_range": UNLIMITED}},
}
"""Of an accelerometer of some 200 g, which no collision here exceeds."""
#: Time over which a clipped reading loses as much as the range, such that the noise is the 4.9 m/s²
#: at steps of 10 ms that PX4's EKF2 assumes in later versions while a reading is clipped [s].
LATER_CLIPPING = 0.01 * (4.9 / (16.0 * STANDARD_GRAVITY)) ** 2


def _ekf2(**numbers: Any) -> Mapping[str, Any]:
    return {"estimator": {"preset": "px4-ekf2", "kalman": numbers}}


VARIANTS = (
    Ablation("default", "all as documented", same({})),
    Ablation("compliance", "ARQ's arms locked",
            vehicle_changes({"arms": {"compliant": False}}), ("arq",)),
    Ablation("compliance", "arms of reading D: a quarter as stiff and damped",
            vehicle_changes({"arms": {"stiffness": 1250.0, "damping": 22.5}}), ("arq",)),
    Ablation("IMU clipping", "accelerometer without limit", same(LARGE_RANGE)),
    Ablation("IMU clipping", "filter trusts clipped readings", same({
        "estimator": {"kalman": {"distrust_clipped": False}}})),
    Ablation("estimator", "true state", same({"estimator": {"type": "perfect"}})),
    Ablation("estimator", "complementary, PX4-like",
            same({"estimator": {"type": "complementary"}})),
    Ablation("PX4 EKF2", "the noise it assumes", same(_ekf2())),
    Ablation("PX4 EKF2", "and an accelerometer of 200 g", same(merge(LARGE_RANGE, _ekf2()))),
    Ablation("PX4 EKF2", "and clipped readings distrusted", same(_ekf2(distrust_clipped=True))),
    Ablation("PX4 EKF2", "and 4.9 m/s² while clipped, as later", same(
        _ekf2(distrust_clipped=True, clipping=LATER_CLIPPING))),
    Ablation("PX4 EKF2", "and friction along both tangents",
            same(merge(surface_of(axes="both"), _ekf2()))),
    Ablation("PX4 EKF2", "and ARQ's arms locked", lambda robot: merge(
        _ekf2(), {"vehicle": {"preset": robot, "arms": {"compliant": False}}}), ("arq",)),
    Ablation("rate limit", "110 deg/s", same(degrees(110.0))),
    Ablation("rate limit", "1000 deg/s", same(degrees(1000.0))),
    Ablation("thrust limit", "rotors 15 % weaker", thrust(0.85)),
    Ablation("thrust limit", "rotors twice as strong", thrust(2.0)),
    Ablation("rotor lag", "15 ms", vehicle_changes({"propulsion": {"time_constant": 0.015}})),
    Ablation("rotor lag", "60 ms", vehicle_changes({"propulsion": {"time_constant": 0.06}})),
    Ablation("attitude loop", "time constant 0.1 s", same({"control": {"time_constant": 0.1}})),
    Ablation("attitude loop", "time constant 0.25 s", same({"control": {"time_constant": 0.25}})),
    Ablation("mixer", "airmode", same({"control": {"lift_share": 1.0}})),
    Ablation("detection delay", "accelerometer on ARQ", same({
        "recovery": {"detection": {"hall": {"used": False}, "acceleration": {"used": True}}}}),
        ("arq",)),
    Ablation("detection delay", "arms read at 100 Hz, 20 ms late", same({
        "sensors": {"hall": {"rate": 100.0, "delay": 0.02}}}), ("arq",)),
    Ablation("detection delay", "looking for 50 ms first", same({
        "recovery": {"characterisation": {"window": 0.05}}})),
    Ablation("detection", "none", same({"recovery": {"detection": {
        "hall": {"used": False}, "acceleration": {"used": True, "threshold": 1e6}}}})),
    Ablation("friction", "along both tangents", same(surface_of(axes="both"))),
    Ablation("friction", "0.4", same(surface_of(0.4))),
    Ablation("friction", "0.2", same(surface_of(0.2))),
    Ablation("friction", "none", same(surface_of(0.0))),
    Ablation("contact point", "as printed, eq. (13)", same({"model": {"contact_point": "paper"}})),
    Ablation("recovery choice", "post-impact", _way("post-impact")),
    Ablation("recovery choice", "set-point", _way("set-point")),
    Ablation("recovery choice", "time-optimal", _way("time-optimal")),
    Ablation("recovery choice", "staged, McGill", _way("staged")),
)  # fmt: skip


class Range(NamedTuple):
    """Values of one number that the paper does not print."""

    name: str
    unit: str
    values: tuple[float, ...]  # in the unit
    default: float
    changes: Callable[[str, float], Mapping[str, Any]]


RANGES = (
    Range("attitude time constant", "s", (0.06, 0.08, 0.1, 0.12, 1.0 / 6.5, 0.2, 0.25), 1.0 / 6.5,
          lambda robot, x: {"control": {"time_constant": x}}),
    Range("rate limit", "deg/s", (110.0, 160.0, 220.0, 400.0, 1000.0), 220.0,
          lambda robot, x: degrees(x)),
    Range("rate gain", "1/s", (15.0, 20.0, 30.0, 40.0, 50.0), 40.0,
          lambda robot, x: {"control": {"rate_gain": x}}),
    Range("rotor time constant", "s", (0.01, 0.02, 0.025, 0.03, 0.04, 0.05, 0.06), 0.025,
          lambda robot, x: vehicle_changes({"propulsion": {"time_constant": x}})(robot)),
    Range("most thrust over default", "", (0.8, 0.9, 1.0, 1.25, 1.5), 1.0,
          lambda robot, x: thrust(x)(robot)),
    Range("friction", "", (0.0, 0.2, 0.4, 0.6, 0.8, 1.0), 0.8, lambda robot, x: surface_of(x)),
    Range("duration per speed of the quintic", "s^2/m", (0.1, 0.15, 0.19, 0.25, 0.35), 0.19,
          lambda robot, x: {"recovery": {"response": {"pace": x}}}),
    Range("lift share of the mixer", "", (0.0, 0.06, 0.12, 0.2, 0.4, 1.0), 0.12,
          lambda robot, x: {"control": {"lift_share": x}}),
)  # fmt: skip


@dataclass(frozen=True)
class AblationOutcome:
    """One test of one robot in one variant."""

    cause: str
    name: str
    robot: str
    pitch: float
    speed: float
    successes: int
    trials: int
    outcomes: dict[str, int]
    lowest: float
    """Median of the lowest height over the flight [m]."""
    nose_up: float
    """Median [rad], a negative pitch."""
    nose_down: float
    """Median [rad]."""
    recovery_time: float
    """Median of those that recovered [s]; NaN if none did."""

    def as_dict(self) -> dict[str, Any]:
        """One row of a table; angles in degrees."""
        return {
            "cause": self.cause, "variant": self.name, "robot": self.robot,
            "pitch_deg": self.pitch, "speed": self.speed, "successes": self.successes,
            "trials": self.trials, "outcomes": self.outcomes,
            "median_lowest_height": self.lowest,
            "median_nose_up_deg": math.degrees(self.nose_up),
            "median_nose_down_deg": math.degrees(self.nose_down),
            "median_recovery_time": None if math.isnan(self.recovery_time) else self.recovery_time,
        }  # fmt: skip


@dataclass
class WhyResults:
    """All cells of the ablation and of the ranges."""

    cells: list[AblationOutcome] = field(default_factory=list)
    ranges: list[AblationOutcome] = field(default_factory=list)

    def successes(
        self, variant: Ablation, robot: str
    ) -> dict[tuple[float, float], AblationOutcome]:
        """Cells of a variant by test; those that cannot be flown are missing."""
        return {
            (c.pitch, c.speed): c
            for c in self.cells
            if (c.cause, c.name, c.robot) == (variant.cause, variant.name, robot)
        }

    def moves(self, robot: str) -> list[tuple[Ablation, int, list[tuple[float, float]]]]:
        """Variants with other successes than the default: how many more, and tests unflown."""
        base, found = self.successes(VARIANTS[0], robot), []
        for variant in VARIANTS[1:]:
            cells = self.successes(variant, robot)
            more = sum(cells[test].successes - base[test].successes for test in cells)
            unflown = [test for test in base if test not in cells]
            if cells and (more or unflown):
                found.append((variant, more, unflown))
        return sorted(found, key=lambda one: one[1])

    def printed_by(self) -> list[Ablation]:
        """Variants with the printed result at 3.5 m/s: ARQ always survives, Quad never."""
        fast, found = (0.0, 3.5), []
        for variant in VARIANTS:
            cells = [self.successes(variant, robot).get(fast) for robot in ROBOTS]
            arq, quad = cells
            if arq and quad and arq.successes == arq.trials and quad.successes == 0:
                found.append(variant)
        return found

    def holds(self, one: Range, robot: str = "arq") -> tuple[float, float] | None:
        """Least and most value about the default for which a robot survives every trial."""
        good = [self._whole(one, x, robot) for x in one.values]
        at = one.values.index(one.default)
        if not good[at]:
            return None
        low = high = at
        while low > 0 and good[low - 1]:
            low -= 1
        while high + 1 < len(good) and good[high + 1]:
            high += 1
        return one.values[low], one.values[high]

    def share(self, one: Range, value: float, robot: str) -> float:
        """Share of all trials of a robot that succeed at one value; NaN if none could be flown."""
        mine = self._at(one, value, robot)
        trials = sum(c.trials for c in mine)
        return sum(c.successes for c in mine) / trials if trials else math.nan

    def _at(self, one: Range, value: float, robot: str) -> list[AblationOutcome]:
        key = (one.name, _label(value), robot)
        return [c for c in self.ranges if (c.cause, c.name, c.robot) == key]

    def _whole(self, one: Range, value: float, robot: str) -> bool:
        mine = self._at(one, value, robot)
        return bool(mine) and all(c.successes == c.trials for c in mine)


def _label(value: float) -> str:
    return f"{value:.4g}"


def _cell(cause: str, name: str, trials: Sequence[Trial]) -> AblationOutcome:
    def median(key: str) -> float:
        known = [t.measures[key] for t in trials if t.measures[key] is not None]
        return float(np.median(known)) if known else math.nan  # type: ignore[arg-type]

    first = trials[0]
    return AblationOutcome(
        cause, name, first.robot, first.pitch, first.speed,
        sum(t.success for t in trials), len(trials),
        dict(Counter(t.outcome.word for t in trials)),
        median("lowest_height"), median("nose_up"), median("nose_down"), median("recovery_time"),
    )  # fmt: skip


def _cells(cause: str, name: str, trials: Sequence[Trial]) -> list[AblationOutcome]:
    tests: dict[tuple[str, float, float], list[Trial]] = {}
    for trial in trials:
        tests.setdefault((trial.robot, trial.pitch, trial.speed), []).append(trial)
    return [_cell(cause, name, some) for some in tests.values()]


def why(
    trials: int = TRIALS,
    *,
    variants: Sequence[Ablation] = VARIANTS,
    ranges: Sequence[Range] = RANGES,
    conditions: Sequence[tuple[float, float]] = CONDITIONS,
    seed: int = 0,
    progress: Callable[[float], None] | None = None,
) -> WhyResults:
    """Fly all variants and ranges.

    Args:
        trials: Of each test.
        variants: Things made otherwise.
        ranges: Numbers that are walked along, with ARQ and Quad.
        conditions: Pitch [deg] and speed [m/s] of the tests.
        seed: Of all luck.
        progress: Called with the share done.
    """
    results = WhyResults()
    walked = [(one, value) for one in ranges for value in one.values]
    count = len(variants) + len(walked)
    for done, variant in enumerate(variants):
        tests = [
            Condition(robot, pitch, speed, variant.changes(robot))
            for robot in variant.robots
            for pitch, speed in conditions
        ]
        flown = fly_trials(tests, trials, seed=seed)
        results.cells += _cells(variant.cause, variant.name, flown)
        if progress is not None:
            progress((done + 1) / count)
    for done, (one, value) in enumerate(walked):
        tests = [
            Condition(robot, pitch, speed, merge({}, one.changes(robot, value)))
            for robot in ROBOTS
            for pitch, speed in conditions
        ]
        results.ranges += _cells(one.name, _label(value), fly_trials(tests, trials, seed=seed))
        if progress is not None:
            progress((len(variants) + done + 1) / count)
    return results

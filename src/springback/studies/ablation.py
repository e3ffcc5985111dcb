"""Ablation: one change at a time, to find why one robot survives and another does not.

Pairs of changes are in `springback.studies.ablation_pairs`.

Every variant flies the paper's tests with the same random draws
(`springback.studies.trials.Scatter`) and differs from the default in one thing.  A range varies one
number that the paper does not print, to find the values for which the printed result holds.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from springback.progress import Progress, silent
from springback.scenario.scenario import merge
from springback.sensing.parameters import STANDARD_GRAVITY
from springback.studies.run_ups import CONDITIONS, PAPER_WALL
from springback.studies.trials import Condition, Tally, fly_trials, tally
from springback.vehicle.library import VEHICLES

ROBOTS = ("arq", "quad")
TRIALS = 10
Changes = Callable[[str], Mapping[str, Any]]


class Ablation(NamedTuple):
    """One change."""

    cause: str  # what is changed
    name: str  # to what
    changes: Changes  # tables merged over a robot's test
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
"""An accelerometer of some 200 g, which no collision here exceeds."""
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
class AblationOutcome(Tally):
    """One test of one robot in one variant."""

    cause: str
    name: str

    def as_dict(self) -> dict[str, Any]:
        """One row of a table; angles in degrees."""
        medians = self.medians
        return {
            "cause": self.cause, "variant": self.name, "robot": self.robot,
            "pitch_deg": self.pitch, "speed": self.speed, "successes": self.successes,
            "trials": self.trials, "outcomes": self.outcomes,
            "median_lowest_height": medians["lowest_height"],
            "median_nose_up_deg": math.degrees(medians["nose_up"] or 0.0),
            "median_nose_down_deg": math.degrees(medians["nose_down"] or 0.0),
            "median_recovery_time": medians["recovery_time"],
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
        """Variants whose successes differ from the default: by how many, and tests unflown."""
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


def why(
    trials: int = TRIALS,
    *,
    variants: Sequence[Ablation] = VARIANTS,
    ranges: Sequence[Range] = RANGES,
    conditions: Sequence[tuple[float, float]] = CONDITIONS,
    seed: int = 0,
    progress: Progress = silent,
) -> WhyResults:
    """Fly all variants and ranges.

    Args:
        trials: Of each test.
        variants: Changes.
        ranges: Numbers that are varied, with ARQ and Quad.
        conditions: Pitch [deg] and speed [m/s] of the tests.
        seed: Of all random draws.
        progress: Called with the fraction done.
    """
    results = WhyResults()
    asked = [(v.cause, v.name, {robot: v.changes(robot) for robot in v.robots}) for v in variants]
    asked += [
        (one.name, _label(value), {robot: one.changes(robot, value) for robot in ROBOTS})
        for one in ranges for value in one.values
    ]  # fmt: skip
    for done, (cause, name, changes) in enumerate(asked, 1):
        tests = [
            Condition(r, *test, tables) for r, tables in changes.items() for test in conditions
        ]
        cells = [
            AblationOutcome(**vars(tally(some)), cause=cause, name=name)
            for some in fly_trials(tests, trials, seed=seed) if some
        ]  # fmt: skip
        (results.cells if done <= len(variants) else results.ranges).extend(cells)
        progress(done / len(asked))
    return results


def why_sentences(results: WhyResults, pairs: Sequence[str] = ()) -> list[str]:
    """Results of the study, a line each.

    Args:
        results: Of `why`.
        pairs: Sentences on pairs of changes, to be put before those on ranges.
    """
    said = []
    for robot in ROBOTS:
        cells = results.successes(VARIANTS[0], robot)
        counts = ", ".join(
            f"{p:+g} deg {v:g} m/s {c.successes}/{c.trials}" for (p, v), c in cells.items()
        )
        said.append(f"{robot}, all as documented: {counts}")
        for variant, more, unflown in results.moves(robot):
            cannot = ", ".join(f"{p:+g} deg {v:g} m/s" for p, v in unflown)
            reason = f"; run-up cannot be flown: {cannot}" if unflown else ""
            said.append(f"  {variant.cause}, {variant.name}: {more:+d} successes{reason}")
    found = results.printed_by()
    names = ", ".join(f"{v.cause} {v.name}" for v in found) or "none of these changes"
    said.append(f"ARQ always and Quad never at 3.5 m/s, as printed: {names}")
    if pairs:
        said.append("two changes at a time, 0 deg 3.5 m/s, that tell the robots apart:")
        said += [f"  {sentence}" for sentence in pairs]
    for one in RANGES if results.ranges else ():
        interval = results.holds(one)
        unit = f" {one.unit}" if one.unit else ""
        span = f"{interval[0]:.4g} to {interval[1]:.4g}{unit}" if interval else ""
        where = span or "not even at its default"
        said.append(f"ARQ survives every trial with {one.name} {where} (default {one.default:.4g})")
    return said

"""The resilience table under each set of choices that the paper leaves open.

Three things decide how many trials recover and are not settled by the print: along which tangents
friction acts, how much the robot's estimator trusts its sensors, and how long a trial lasts.  Every
combination is flown with the same random draws, and counted against the printed table.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from springback.paper.printed import SUCCESS, SUCCESS_WORDS
from springback.progress import Progress, silent, stage
from springback.studies.run_ups import CONDITIONS, PAPER_WALL, WALL_DISTANCE
from springback.studies.trials import Condition, Tally, fly_trials, tally

ROBOTS = ("arq", "quad")
TRIALS = 100
"""Trials of each condition, chosen: an interval is then at most 20 % wide."""
DURATIONS = (9.0, 11.0, 14.0)
"""Durations of a trial [s], chosen; the paper prints none.  A run-up takes up to 2.75 s of it."""
PRINTED_TRIALS = 10
"""Section Impact Resilience: ten trials of each condition."""
PLAUSIBLE = 0.05
"""Chosen: a printed count is compatible with our share if ten trials give it this often."""
GOOD = 0.8
"""Chosen: the least share that is called "fairly good", the paper's words."""


class AssumptionSet(NamedTuple):
    """Assumptions with which a set of trials is flown."""

    friction: str
    estimator: str
    surface: str
    """Preset of the wall."""
    preset: str
    """Preset of the estimator; empty for springback's own defaults."""

    @property
    def name(self) -> str:
        """In words."""
        return f"{self.friction}, {self.estimator}"

    def changes(self, duration: float) -> Mapping[str, Any]:
        """Tables to be merged over those of a trial.

        Args:
            duration: Of the trial [s].
        """
        wall = {"type": "wall", "distance": WALL_DISTANCE, "surface": self.surface}
        given: dict[str, Any] = {
            "world": {"obstacles": [wall]}, "simulation": {"duration": duration}
        }  # fmt: skip
        return given | ({"estimator": self.preset} if self.preset else {})


VERTICAL, BOTH = "friction along e_Z", "friction along both tangents"
OURS, EKF2 = "springback's estimator", "PX4 EKF2's noise"
CHOICES = (
    AssumptionSet(VERTICAL, OURS, PAPER_WALL, ""),
    AssumptionSet(VERTICAL, EKF2, PAPER_WALL, "px4-ekf2"),
    AssumptionSet(BOTH, OURS, "wall", ""),
    AssumptionSet(BOTH, EKF2, "wall", "px4-ekf2"),
)
MEDIANS = (
    "height_loss", "excursion", "recovery_time", "lowest_height", "impact_arm_stroke",
    "impact_peak_acceleration",
)  # fmt: skip
"""Measures whose medians are in tables."""


@dataclass(frozen=True)
class ConditionOutcome(Tally):
    """One condition under one choice."""

    choice: AssumptionSet
    duration: float
    """Of the trials [s]."""

    def as_dict(self) -> dict[str, Any]:
        """One row of a table, SI; pitch in degrees."""
        low, high = self.interval
        return {
            "friction": self.choice.friction, "estimator": self.choice.estimator,
            "duration": self.duration, "robot": self.robot, "pitch_deg": self.pitch,
            "speed": self.speed, "trials": self.trials, "successes": self.successes,
            "share": self.share, "low": low, "high": high,
            **{f"median_{name}": self.medians[name] for name in MEDIANS},
            **{f"ended_{word}": self.outcomes.get(word, 0) for word in ENDS},
        }  # fmt: skip


ENDS = ("recovered", "not_settled", "not_detected", "hit_ground", "not_finite")
"""Words of outcomes of a trial."""


class Agreement(NamedTuple):
    """Agreement of a set of choices with the printed table."""

    choice: AssumptionSet
    duration: float
    close: int
    """Number of printed shares met within five percentage points."""
    plausible: int
    """Number of printed shares that ten of our trials give with a chance of `PLAUSIBLE`."""
    numbers: int
    """Printed shares."""
    words: int
    """Number of printed words that hold."""
    phrases: int
    """Printed words."""

    @property
    def total(self) -> int:
        """Entries of the printed table that the choices give, words included."""
        return self.plausible + self.words


@dataclass
class ChoiceResults:
    """All conditions under all choices."""

    trials: int
    seed: int = 0
    cells: list[ConditionOutcome] = field(default_factory=list)

    def table(
        self, choice: AssumptionSet, duration: float
    ) -> dict[tuple[str, float, float], ConditionOutcome]:
        """Cells of a set of choices by robot, pitch [deg] and speed [m/s]."""
        return {c.condition: c for c in self.cells if (c.choice, c.duration) == (choice, duration)}

    @property
    def combinations(self) -> list[tuple[AssumptionSet, float]]:
        """Choices and durations that were flown, in their order."""
        return list(dict.fromkeys((c.choice, c.duration) for c in self.cells))

    def agreement(self, choice: AssumptionSet, duration: float) -> Agreement:
        """Agreement of a set of choices with the printed table."""
        table = self.table(choice, duration)
        numbers = [(table[of], printed) for of, printed in SUCCESS.items() if of in table]
        words = [(of, word) for of, word in SUCCESS_WORDS.items() if of in table]
        return Agreement(
            choice,
            duration,
            close=sum(abs(cell.share - printed) <= 0.05 for cell, printed in numbers),
            plausible=sum(is_plausible(cell.share, printed) for cell, printed in numbers),
            numbers=len(numbers),
            words=sum(_holds(word, table[of], table.get((of[0], 0.0, 2.0))) for of, word in words),
            phrases=len(words),
        )

    def best(self) -> Agreement:
        """The set of choices that gives most of the printed table; the first of equals."""
        return max(
            (self.agreement(*one) for one in self.combinations), key=lambda a: (a.total, a.close)
        )


def is_plausible(share: float, printed: float) -> bool:
    """True if ten trials of a probability of success give a printed share often enough.

    Args:
        share: The probability.
        printed: 0 or 1; the paper prints no other share.
    """
    missed = 1.0 - share if printed == 0.0 else share
    return bool(missed**PRINTED_TRIALS >= PLAUSIBLE)


def _holds(word: str, cell: ConditionOutcome, level: ConditionOutcome | None) -> bool:
    """True if a phrase of the paper holds for a condition.

    "fairly good": at least `GOOD` of the trials.  "drops": clearly fewer than the same robot
    recovers at 0 degrees and the same speed, their intervals apart.
    """
    if word == "drops":
        return level is not None and cell.interval[1] < level.interval[0]
    return cell.share >= GOOD


def fly_choices(
    trials: int = TRIALS,
    *,
    choices: Sequence[AssumptionSet] = CHOICES,
    durations: Sequence[float] = DURATIONS,
    conditions: Sequence[tuple[float, float]] = CONDITIONS,
    seed: int = 0,
    progress: Progress = silent,
) -> ChoiceResults:
    """Fly every condition of the printed table under every set of choices, with the same scatter.

    Args:
        trials: Of each condition.
        choices: Sets of assumptions.
        durations: Of a trial [s].
        conditions: Pitch [deg] and speed [m/s].
        seed: Of all random draws.
        progress: Called with the fraction done.
    """
    results = ChoiceResults(trials, seed)
    sets = [(choice, duration) for choice in choices for duration in durations]
    for done, (choice, duration) in enumerate(sets):
        asked = [
            Condition(robot, *test, choice.changes(duration))
            for robot in ROBOTS
            for test in conditions
        ]

        share = stage(progress, done / len(sets), 1.0 / len(sets))
        results.cells += [
            ConditionOutcome(**vars(tally(some)), choice=choice, duration=duration)
            for some in fly_trials(asked, trials, seed=seed, progress=share) if some
        ]  # fmt: skip
    return results


def choices_sentences(results: ChoiceResults) -> list[str]:
    """Results of the sets of choices, a line each; the best set last."""
    said = []
    for one in results.combinations:
        count, fast = results.agreement(*one), results.table(*one)
        shares = ", ".join(
            f"{robot} {fast[robot, 0.0, 3.5].successes} of {fast[robot, 0.0, 3.5].trials}"
            for robot in ROBOTS
            if (robot, 0.0, 3.5) in fast
        )
        said.append(
            f"{one[0].name}, {one[1]:g} s: {count.total} of {count.numbers + count.phrases} "
            f"printed entries; at 3.5 m/s {shares}"
        )
    best = results.best()
    said.append(
        f"most of the printed table: {best.choice.name}, {best.duration:g} s, "
        f"{best.total} of {best.numbers + best.phrases}"
    )
    return said


def choices_data(results: ChoiceResults) -> dict[str, Any]:
    """Counts and medians of every condition, and how much of the printed table each set gives."""
    sets = [results.agreement(*one) for one in results.combinations]
    return {
        "trials": results.trials,
        "seed": results.seed,
        "agreement": [{**_plain(one), "total": one.total, "name": one.choice.name} for one in sets],
        "cells": [cell.as_dict() for cell in results.cells],
    }


def _plain(one: Agreement) -> dict[str, Any]:
    """Plain data of an agreement."""
    own = {key: value for key, value in one._asdict().items() if key != "choice"}
    return {"friction": one.choice.friction, "estimator": one.choice.estimator, **own}

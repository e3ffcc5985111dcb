"""Pairs of changes: two together may do what neither does alone.

A filter that trusts its poses to a fraction of a millimetre survives any clipping, and one that
distrusts clipped readings survives any noise settings.  Changing one thing at a time, one sees
neither; so at the paper's fastest collision every two changes are made together, too.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations_with_replacement
from typing import Any, NamedTuple

from springback.progress import Progress, silent
from springback.scenario.presets import merge
from springback.studies.ablation import (
    LARGE_RANGE,
    ROBOTS,
    Ablation,
    Changes,
    degrees,
    same,
    surface_of,
    thrust,
    vehicle_changes,
)
from springback.studies.trials import Condition, fly_trials

TRIALS = 10
FASTEST = (0.0, 3.5)
"""Pitch [deg] and speed [m/s] of the test: the only one in which print has a robot fail."""
CLEAR = 0.5
"""Chosen: share of the trials by which the robots must differ to count as separated."""


def _kalman(**numbers: Any) -> Changes:
    return same({"estimator": {"kalman": numbers}})


CHANGES = (
    Ablation("pose noise", "poses believed to 0.1 m, 0.05 rad",
            _kalman(position_noise=0.1, attitude_noise=0.05)),
    Ablation("inertial noise", "inertial noise believed 24 times the data sheet's",
            _kalman(inflation=24.0)),
    Ablation("clipping", "clipped readings trusted", _kalman(distrust_clipped=False)),
    Ablation("range", "accelerometer of 200 g", same(LARGE_RANGE)),
    Ablation("friction", "friction along both tangents", same(surface_of(axes="both"))),
    Ablation("compliance", "ARQ's arms locked",
            vehicle_changes({"arms": {"compliant": False}}), ("arq",)),
    Ablation("rate limit", "rate limit 110 deg/s", same(degrees(110.0))),
    Ablation("thrust", "rotors 15 % weaker", thrust(0.85)),
    Ablation("lag", "rotors lag 60 ms",
            vehicle_changes({"propulsion": {"time_constant": 0.06}})),
    Ablation("look", "looking for 50 ms first",
            same({"recovery": {"characterisation": {"window": 0.05}}})),
)  # fmt: skip
"""Changes that are paired: parts of EKF2's settings, and others that may separate the robots."""


class Pair(NamedTuple):
    """One robot's trials under two changes; under one where both are the same."""

    first: str
    second: str
    robot: str
    successes: int
    trials: int

    @property
    def share(self) -> float:
        """Recovered of the trials."""
        return self.successes / self.trials


@dataclass
class PairResults:
    """All pairs, and the test without changes, by name ``none``."""

    pairs: list[Pair] = field(default_factory=list)

    def at(self, first: str, second: str, robot: str) -> Pair | None:
        """Trials of a robot under two changes in any order; None if it cannot be flown."""
        names = {(first, second), (second, first)}
        found = (p for p in self.pairs if p.robot == robot and (p.first, p.second) in names)
        return next(found, None)

    def splits(self) -> list[tuple[Pair, Pair]]:
        """ARQ's and Quad's trials where ARQ recovers clearly more often, the widest first."""
        found = []
        for arq in (p for p in self.pairs if p.robot == "arq"):
            quad = self.at(arq.first, arq.second, "quad")
            if quad is not None and arq.share - quad.share >= CLEAR:
                found.append((arq, quad))
        return sorted(found, key=lambda pair: pair[1].share - pair[0].share)


def fly_pairs(
    trials: int = TRIALS,
    *,
    changes: Sequence[Ablation] = CHANGES,
    seed: int = 0,
    progress: Progress = silent,
) -> PairResults:
    """Fly the paper's fastest collision under every change and every two changes.

    A change that a robot does not have, such as locking Quad's arms, leaves it as it is.

    Args:
        trials: Of each robot under each pair.
        changes: To be paired.
        seed: Of all random draws.
        progress: Called with the fraction done.
    """
    asked: list[tuple[str, str, str, Mapping[str, Any]]] = [
        ("none", "none", robot, {}) for robot in ROBOTS
    ]
    for one, other in combinations_with_replacement(changes, 2):
        for robot in ROBOTS:
            tables: Mapping[str, Any] = {}
            for change in (one, other):
                if robot in change.robots:
                    tables = merge(tables, change.changes(robot))
            asked.append((one.cause, other.cause, robot, tables))
    tests = [Condition(robot, *FASTEST, tables) for _, _, robot, tables in asked]
    flown = fly_trials(tests, trials, seed=seed, progress=progress)
    return PairResults([
        Pair(first, second, robot, sum(trial.success for trial in some), len(some))
        for (first, second, robot, _), some in zip(asked, flown, strict=True) if some
    ])  # fmt: skip


def pair_sentences(results: PairResults) -> list[str]:
    """Results of the pairs, a line each."""
    said = []
    names = {change.cause: change.name for change in CHANGES}
    for arq, quad in results.splits():
        both = dict.fromkeys((names.get(arq.first, arq.first), names.get(arq.second, arq.second)))
        said.append(
            f"{' and '.join(both)}: ARQ recovers in {arq.successes} of {arq.trials}, Quad in "
            f"{quad.successes} of {quad.trials}"
        )
    return said or ["no pair of changes tells the robots apart at 3.5 m/s"]

"""Statistics of a campaign: success rates, quantiles of measures, paired robots."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from springback.campaign.access import Campaign
from springback.campaign.columns import known_columns
from springback.errors import InputError
from springback.intervals import (
    CONFIDENCE,
    IntervalEstimate,
    Values,
    paired_difference,
    quantile,
    share,
)
from springback.results.database import identifier, literal
from springback.results.saved import LARGEST
from springback.scenario.warnings import missing_elements
from springback.simulation.measuring.measures import Outcome

#: Measures of a summary, if any flight has them.
MAIN = (
    "touch_speed", "impact_peak_acceleration", "impact_arm_stroke", "contact_time",
    "detection_delay", "recovery_time", "height_loss", "excursion", "nose_up", "nose_down",
    "direction_error",
)  # fmt: skip
#: Outcome of flights that touched nothing.
UNTOUCHED = Outcome.NO_CONTACT.word
PARTS = (0.1, 0.5, 0.9)
"""Shares of flights below the quantiles shown."""


@dataclass(frozen=True)
class RobotSummary:
    """Summary of one robot."""

    robot: str
    flights: int
    """Number of stored flights."""
    refused: int
    """Number of flights that could not be flown, which are not counted elsewhere."""
    ledger_open: int
    """Number of flights whose energy balance does not close to 1e-4."""
    successes: int
    success: IntervalEstimate
    outcomes: dict[str, int]
    measures: dict[str, tuple[int, tuple[IntervalEstimate, ...]]]
    """Number of flights that have each measure, and its quantiles."""
    touch_successes: int
    """Number of successes among the flights that touched something."""

    @property
    def misses(self) -> int:
        """Number of flights that touched nothing; those that could not be flown are not counted."""
        return self.outcomes.get(UNTOUCHED, 0)

    @property
    def touches(self) -> int:
        """Number of flights that touched something."""
        return self.flights - self.refused - self.misses

    @property
    def touch_success(self) -> IntervalEstimate:
        """Share of successes among the flights that touched something."""
        return share(self.touch_successes, self.touches)

    def as_dict(self) -> dict[str, Any]:
        """Plain data."""
        quantiles = {
            name: {
                "unit": known_columns()[name][0], "flights": count,
                **{f"{part:g}": e._asdict() for part, e in zip(PARTS, found, strict=True)},
            }
            for name, (count, found) in self.measures.items()
        }  # fmt: skip
        return {
            "robot": self.robot, "flights": self.flights, "refused": self.refused,
            "ledger_open": self.ledger_open, "successes": self.successes,
            "success": self.success._asdict(),
            "no_contact": self.misses, "touch_success": self.touch_success._asdict(),
            "outcomes": self.outcomes, "quantiles": quantiles,
        }  # fmt: skip


@dataclass(frozen=True)
class PairSummary:
    """Two robots, or two levels of a field, compared over pairs of flights."""

    names: tuple[str, str]
    pairs: int
    """Number of pairs in which both were flown."""
    both: int
    first_only: int
    """Number of pairs in which only the first succeeded."""
    second_only: int
    neither: int
    difference: IntervalEstimate
    """Difference of the success rates, the first minus the second."""
    medians: dict[str, tuple[int, IntervalEstimate]]
    """Number of pairs that have each measure, and the median of its difference."""
    common: str = "with the same noise"
    """What the flights of a pair have in common."""
    robot: str = ""
    """The robot that flew both levels of a field; empty for two robots."""

    def as_dict(self) -> dict[str, Any]:
        """Plain data."""
        medians = {
            name: {"unit": known_columns()[name][0], "pairs": count, **found._asdict()}
            for name, (count, found) in self.medians.items()
        }
        return {
            **({"robot": self.robot, "levels": list(self.names), "common": self.common}
               if self.robot else {"robots": list(self.names)}),
            "pairs": self.pairs, "both": self.both,
            "first_only": self.first_only, "second_only": self.second_only,
            "neither": self.neither, "difference": self.difference._asdict(),
            "median_differences": medians,
        }  # fmt: skip

    def sentence(self) -> str:
        """Text of one sentence."""
        first, second = self.names
        d, whose = self.difference, f"{self.robot}: " if self.robot else ""
        if d.value is None or d.low is None or d.high is None:
            return f"{whose}{first} and {second}: no pair was flown"
        return (
            f"{whose}{first} less {second}, over {self.pairs} pairs {self.common}: "
            f"{100.0 * d.value:+.2f} percentage points "
            f"({100.0 * d.low:+.2f} to {100.0 * d.high:+.2f}); "
            f"{first} alone succeeds in {self.first_only}, {second} alone in {self.second_only}"
        )


@dataclass(frozen=True)
class Summary:
    """Summary of a campaign."""

    campaign: Campaign = field(repr=False)
    robots: tuple[RobotSummary, ...]
    pairs: tuple[PairSummary, ...]
    refusal: str = ""
    """Sentence on flights that could not be flown, with an example; empty if none."""
    warnings: tuple[str, ...] = ()
    """Warnings about the scenario: elements of imported worlds that are not there."""

    def as_dict(self) -> dict[str, Any]:
        """Plain data, for JSON."""
        about = self.campaign.metadata
        return {
            "name": about["name"], "seed": about["seed"], "plan_sha256": about["plan_sha256"],
            "versions": about["versions"], "host": about["host"], "cpu": about["cpu"],
            "flights": self.campaign.done, "of": about["flights"],
            "where": list(self.campaign.conditions),
            "success_is": self.campaign.design.success,
            "confidence": CONFIDENCE,
            "intervals": "shares: Wilson; quantiles: order statistics; pairs: Agresti and Min",
            "robots": [robot.as_dict() for robot in self.robots],
            "pairs": [pair.as_dict() for pair in self.pairs], "refusal": self.refusal,
            "warnings": list(self.warnings),
        }  # fmt: skip


def summary(campaign: Campaign) -> Summary:
    """Summary of a campaign.

    Raises:
        InputError: If it has no flights yet.
    """
    if not campaign.done:
        raise InputError(f"{campaign.folder}: has no flights yet")
    names = campaign.robots
    robots = tuple(robot_summary(campaign, robot) for robot in names)
    pairs = tuple(
        pair_summary(
            campaign, (first, second), (is_robot(first), is_robot(second)), ("sample", "repeat")
        )
        for k, first in enumerate(names)
        for second in names[k + 1 :]
    )
    refusal = _refusal(campaign, sum(one.refused for one in robots))
    warnings = missing_elements(campaign.metadata.get("scenarios", {}).values())
    return Summary(campaign, robots, pairs, refusal, tuple(warnings))


def _refusal(campaign: Campaign, refused: int) -> str:
    if not refused:
        return ""
    sql = "SELECT flight, robot, problem FROM flights WHERE outcome = 'refused' ORDER BY flight"
    [(flight, robot, why)] = campaign.query(f"{sql} LIMIT 1").rows
    return f"{refused} refused, such as flight {flight} ({robot}): {why}"


def ordered_values(campaign: Campaign, found: Mapping[str, Values]) -> dict[str, Values]:
    """Known values of each column that has any, in ascending order.

    Raises:
        InputError: If a value is one that no flight has.
    """
    known = {name: np.sort(values[~np.isnan(values)]) for name, values in found.items()}
    for name, values in known.items():
        if not (np.abs(values) < LARGEST).all():
            raise InputError(
                f"{campaign.folder}: column {name}: must be finite numbers below {LARGEST:g} in "
                "magnitude"
            )
    return {name: values for name, values in known.items() if len(values)}


def robot_summary(campaign: Campaign, robot: str) -> RobotSummary:
    """Summary of one robot's flights."""
    sql = """SELECT outcome, count(*), coalesce(sum(success), 0) FROM flights WHERE robot = ?
             GROUP BY outcome ORDER BY outcome"""
    rows = campaign.query(sql, [robot]).rows
    wary = "SELECT coalesce(sum(ledger_open), 0) FROM flights WHERE robot = ?"
    [(ledger_open,)] = campaign.query(wary, [robot]).rows
    outcomes = {word: int(count) for word, count, _ in rows}
    refused = outcomes.pop("refused", 0)
    flown, won = sum(outcomes.values()), int(sum(row[2] for row in rows))
    hits = int(sum(row[2] for row in rows if row[0] != UNTOUCHED))
    columns = ", ".join(MAIN)
    found = campaign.arrays(f"SELECT {columns} FROM flights WHERE robot = ?", [robot])
    measures = {
        name: (len(known), tuple(quantile(known, part) for part in PARTS))
        for name, known in ordered_values(campaign, found).items()
    }
    return RobotSummary(
        robot, flown + refused, refused, int(ledger_open), won, share(won, flown), outcomes,
        measures, hits,
    )  # fmt: skip


def is_robot(name: str) -> str:
    """Condition in SQL on a robot's flights."""
    return f"robot = {literal(name)}"


def pair_summary(
    campaign: Campaign,
    names: tuple[str, str],
    conditions: tuple[str, str],
    using: Sequence[str],
    **about: str,
) -> PairSummary:
    """Comparison over pairs of flights.

    Args:
        campaign: Any.
        names: What is compared.
        conditions: Conditions in SQL on the first and on the second flight of a pair.
        using: Columns that are equal in a pair; each flight is in at most one.
        about: What the flights of a pair have in common, and the robot; see `PairSummary`.
    """
    first_flights, second_flights = (f"(FROM flights WHERE {text})" for text in conditions)
    equal = ", ".join(map(identifier, using))
    pairs = f"FROM {first_flights} a JOIN {second_flights} b USING ({equal})"
    sql = f"""SELECT a.success, b.success, count(*) {pairs} WHERE a.success IS NOT NULL
              AND b.success IS NOT NULL GROUP BY ALL"""
    counts = {(a, b): int(n) for a, b, n in campaign.query(sql).rows}
    both, first, second, neither = (
        counts.get(key, 0) for key in ((1, 1), (1, 0), (0, 1), (0, 0))
    )  # fmt: skip
    total = both + first + second + neither
    columns = ", ".join(f"a.{name} - b.{name} AS {name}" for name in MAIN)
    found = ordered_values(campaign, campaign.arrays(f"SELECT {columns} {pairs}"))
    medians = {name: (len(known), quantile(known, 0.5)) for name, known in found.items()}
    return PairSummary(
        names, total, both, first, second, neither, paired_difference(first, second, total),
        medians, **about,
    )  # fmt: skip

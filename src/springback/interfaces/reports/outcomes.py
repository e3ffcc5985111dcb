"""Tables of a campaign: outcomes and quantiles of measures of each robot."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from springback.campaign.analysis.intervals import IntervalEstimate
from springback.campaign.analysis.statistics import RobotSummary
from springback.campaign.columns import known_columns


def outcome_table(robots: Sequence[RobotSummary]) -> tuple[list[str], list[tuple[Any, ...]]]:
    """Table of flights, success and outcomes, a row for each robot."""
    words = sorted({word for robot in robots for word in robot.outcomes})
    rows = [
        (
            one.robot, one.flights, one.refused, one.ledger_open, share_text(one.success),
            *(one.outcomes.get(word, 0) for word in words),
        )
        for one in robots
    ]  # fmt: skip
    return ["robot", "flights", "refused", "ledger open", "success (95 %)", *words], rows


def quantile_table(robots: Sequence[RobotSummary]) -> tuple[list[str], list[tuple[Any, ...]]]:
    """Table of quantiles, a row for each measure and robot."""
    rows: list[tuple[Any, ...]] = []
    names = dict.fromkeys(name for robot in robots for name in robot.measures)
    for name in names:
        unit = known_columns()[name][0]
        factor, unit = (180.0 / math.pi, "deg") if unit == "rad" else (1.0, unit)
        for robot in robots:
            if name in robot.measures:
                count, (low, middle, high) = robot.measures[name]
                numbers = [_scale(e.value, factor) for e in (low, middle, high)]
                bounds = [_scale(middle.low, factor), _scale(middle.high, factor)]
                interval = " to ".join("?" if b is None else f"{b:.4g}" for b in bounds)
                shown = [None if n is None else float(f"{n:.4g}") for n in numbers]
                rows.append((f"{name} [{unit or '-'}]", robot.robot, count, *shown, interval))
    return ["measure", "robot", "flights", "10 %", "50 %", "90 %", "median, 95 %"], rows


def _scale(value: float | None, factor: float) -> float | None:
    return None if value is None else value * factor


def share_text(estimate: IntervalEstimate) -> str:
    """Share with its interval, in percent."""
    if estimate.value is None or estimate.low is None or estimate.high is None:
        return "-"
    value, low, high = (100.0 * x for x in (estimate.value, estimate.low, estimate.high))
    return f"{value:.2f} % ({low:.2f} to {high:.2f})"

"""Tables of a campaign: outcomes, measures, sensitivity, and flights to replay."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from springback.campaign.access import Campaign
from springback.campaign.analysis.distribution import PARTS as DISTRIBUTION
from springback.campaign.analysis.distribution import MeasureDistribution
from springback.campaign.analysis.failures import PEAK, FailureList
from springback.campaign.analysis.levels import FieldSummary
from springback.campaign.analysis.sensitivity import Sensitivity
from springback.campaign.analysis.statistics import PARTS, RobotSummary
from springback.campaign.columns import known_columns
from springback.interfaces.output.fields import cell_text
from springback.interfaces.output.quantities import (
    DisplayUnit,
    display_unit,
    estimate_text,
    interval_text,
    quantity_text,
)
from springback.intervals import IntervalEstimate

Rows = tuple[list[str], list[tuple[Any, ...]]]
"""Heads of a table, and its rows."""


def outcome_table(
    robots: Sequence[RobotSummary], outcomes: Sequence[str] = (), *, misses: bool = False
) -> Rows:
    """Table of flights, success and outcomes, a row for each robot.

    Args:
        robots: Summaries.
        outcomes: Outcomes that have a column; by default all that any robot has.
        misses: Add the share among the flights that touched something.
    """
    words = outcomes or sorted({word for robot in robots for word in robot.outcomes})
    rows = [
        (
            one.robot, one.flights, one.refused, one.ledger_open, share_text(one.success),
            *[share_text(one.touch_success)] * misses,
            *(one.outcomes.get(word, 0) for word in words),
        )
        for one in robots
    ]  # fmt: skip
    shares = ["success (95 % interval)", *["of those that touch (95 %)"] * misses]
    return ["robot", "flights", "refused", "ledger open", *shares, *words], rows


def level_table(found: FieldSummary, *, misses: bool = False) -> Rows:
    """Table of flights, success and outcomes, a row for each level of a field and robot.

    Args:
        found: The summaries by level.
        misses: As of `outcome_table`.
    """
    every = [robot for robots in found.levels.values() for robot in robots]
    head, _ = outcome_table(every, misses=misses)
    words = head[len(outcome_table([], misses=misses)[0]) :]
    rows = []
    for level, robots in found.levels.items():
        for one in outcome_table(robots, words, misses=misses)[1]:
            rows.append((cell_text(found.field, *found.field.bounds(level)), *one))
    return [found.field.name, *head], rows


def quantile_table(robots: Sequence[RobotSummary]) -> Rows:
    """Table of quantiles, a row for each measure and robot."""
    return _quantile_rows([((robot.robot,), robot) for robot in robots], ["robot"])


def level_quantile_table(found: FieldSummary) -> Rows:
    """Table of quantiles, a row for each measure, level of a field and robot."""
    named = [
        ((cell_text(found.field, *found.field.bounds(level)), one.robot), one)
        for level, robots in found.levels.items() for one in robots
    ]  # fmt: skip
    return _quantile_rows(named, [found.field.name, "robot"])


def _quantile_rows(
    named: Sequence[tuple[tuple[str, ...], RobotSummary]], of: Sequence[str]
) -> Rows:
    """Table of quantiles; ``of`` are the heads of the names of each summary."""
    rows: list[tuple[Any, ...]] = []
    for name in dict.fromkeys(name for _, one in named for name in one.measures):
        found = [(names, *one.measures[name]) for names, one in named if name in one.measures]
        values = [each.value for _, _, quantiles in found for each in quantiles]
        unit = display_unit(known_columns()[name][0], values)
        rows += [
            (f"{name} [{unit.symbol}]", *names, count, *_quantiles(quantiles, unit.factor))
            for names, count, quantiles in found
        ]
    head = ["measure", *of, "flights", *(f"{100 * part:g} %" for part in PARTS)]
    return [*head, "95 % interval of the median"], rows


def distribution_table(found: MeasureDistribution) -> Rows:
    """Table of the distribution of a measure, a row for each robot."""
    unit = measure_unit(found)
    rows: list[tuple[Any, ...]] = []
    for robot, values in found.values.items():
        ends = (
            [quantity_text(v * unit.factor) for v in values[[0, -1]]] if len(values) else ["-", "-"]
        )
        *shares, interval = _quantiles(found.quantiles(robot), unit.factor)
        rows.append((robot, len(values), found.without(robot), ends[0], *shares, ends[1], interval))
    head = ["robot", "flights", "without", "least", *(f"{100 * p:g} %" for p in DISTRIBUTION)]
    return [*head, "most", "95 % interval of the median"], rows


def measure_unit(found: MeasureDistribution) -> DisplayUnit:
    """Unit in which a measure is shown."""
    ends = (float(v) for values in found.values.values() if len(values) for v in values[[0, -1]])
    return display_unit(found.measure.unit, ends)


def sensitivity_table(found: Sensitivity) -> Rows:
    """Table of first-order indices, a row for each field and a column for each robot."""
    rows = [
        (name, *(_index_text(indices[name]) for indices in found.robots.values()))
        for name in found.ranking()
    ]
    return ["field", *found.robots], rows


def _index_text(index: IntervalEstimate) -> str:
    return f"{index.value:.2f} ({index.low:.2f} to {index.high:.2f})"


def failure_table(found: FailureList, listed: Sequence[Mapping[str, Any]]) -> Rows:
    """Table of flights to replay, with the command that does so.

    Args:
        found: With units and commands.
        listed: One of its lists of rows.
    """
    columns = (PEAK, *found.fields)
    units = {name: display_unit(found.campaign.units.get(name, "")) for name in columns}
    words = {one.column for one in found.campaign.design.dimensions if one.text}
    doubt = any(row["in_doubt"] for row in listed)
    head = ["flight", "replay", "robot", "outcome", "kept", *["to be trusted"] * doubt]
    head += [name if name in words else f"{name} [{units[name].symbol}]" for name in columns]
    rows = [
        (
            str(row["flight"]), found.command(row["flight"]), row["robot"], row["outcome"],
            "yes" if row["kept"] else "no", *["no" if row["in_doubt"] else "yes"] * doubt,
            *(_field_text(row[name], units[name]) for name in columns),
        )
        for row in listed
    ]  # fmt: skip
    return head, rows


def _field_text(value: Any, unit: DisplayUnit) -> str:
    if value is None:
        return "-"
    return four_digits(value * unit.factor) if isinstance(value, float) else str(value)


def four_digits(value: float) -> str:
    """Number of four digits, without an exponent where its digits are few."""
    text = f"{value:.4g}"
    return f"{float(text):.0f}" if "e" in text and 1e4 <= abs(value) < 1e7 else text


def _quantiles(quantiles: Sequence[IntervalEstimate], factor: float) -> list[str]:
    """Quantiles with the digits of their intervals, and the interval of the median."""
    shown = [estimate_text(found, factor) for found in quantiles]
    return [*shown, interval_text(quantiles[1], factor)]


def share_text(estimate: IntervalEstimate) -> str:
    """Share with its interval, in percent."""
    if estimate.value is None or estimate.low is None or estimate.high is None:
        return "-"
    value, low, high = (100.0 * x for x in (estimate.value, estimate.low, estimate.high))
    return f"{value:.2f} % ({low:.2f} to {high:.2f})"


def success_text(one: RobotSummary, *, misses: bool = False) -> str:
    """Share of successes with its interval, and that among flights that touch, if some miss."""
    every = share_text(one.success)
    if not misses or not one.misses or not one.touches:
        return every
    return f"{every}, of the {one.touches} that touched something {share_text(one.touch_success)}"


def drawn_ranges(campaign: Campaign) -> list[str]:
    """Ranges of a campaign that have a source, such as those of materials."""
    sourced = [one for one in campaign.design.plan.vary if one.source is not None]
    return [
        f"{one.field} {_end_text(one.from_)} to {_end_text(one.to)} ({one.source})"
        if one.from_ is not None
        else f"{one.field} ({one.source})"
        for one in sourced
    ]  # fmt: skip


def _end_text(end: object) -> str:
    """End of a range as a plan has it; of a number, such as one derived, five digits."""
    return f"{end:.5g}" if isinstance(end, float) else str(end)

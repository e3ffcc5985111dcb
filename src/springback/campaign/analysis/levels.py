"""Summary by the levels of a field, such as pilots or surfaces, or by the cells of any other."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations
from typing import Any

from springback.campaign.access import Campaign
from springback.campaign.analysis.marginals import GROUPS, Scale, scale
from springback.campaign.analysis.statistics import (
    PairSummary,
    RobotSummary,
    is_robot,
    pair_summary,
    robot_summary,
)
from springback.campaign.design.distributions import LevelSet

#: Most levels of words that a summary shows without being asked, and cells of a field without
#: levels; most levels that are compared each with each, not only with the first (chosen).
MOST_SHOWN, CELLS, MOST_COMPARED = 12, 8, 4
SAME_DRAWS = "with the same draws"
SAME_FIELDS = "with the same other fields, each with draws of its own"


@dataclass(frozen=True)
class FieldSummary:
    """Flights by the level of a field, and by robot."""

    field: Scale
    levels: dict[int, tuple[RobotSummary, ...]]
    """Summaries of the robots by the number of the level or cell, of those with flights."""
    pairs: tuple[PairSummary, ...]
    """Levels compared over flights with the same other values; empty if there are none."""

    def as_dict(self) -> dict[str, Any]:
        """Plain data."""
        return {
            "field": self.field.name, "unit": self.field.unit,
            "levels": [
                self.field.named_cell(k) | {"robots": [robot.as_dict() for robot in robots]}
                for k, robots in self.levels.items()
            ],
            "pairs": [pair.as_dict() for pair in self.pairs],
        }  # fmt: skip


def fields_of_words(campaign: Campaign) -> list[str]:
    """Names of the varied fields whose few levels are words: surfaces, pilots, yes or no."""
    return [
        one.column for one in campaign.design.dimensions
        if one.text and isinstance(one.law, LevelSet) and 1 < one.law.levels <= MOST_SHOWN
    ]  # fmt: skip


def field_summary(campaign: Campaign, name: str, cells: int = CELLS) -> FieldSummary:
    """Summary by the levels of a field.

    Levels are compared in pairs of flights of one robot: those of one sample, if levels share
    samples, or else, on a grid, those in which all other fields with levels are the same.  What
    flights did, the columns of `GROUPS`, is not compared: flights are not alike but for that.

    Args:
        campaign: Campaign that varied it.
        name: Name of its column, or one of `GROUPS`.
        cells: Number of cells if it has no levels.

    Raises:
        InputError: If it was not varied.
    """
    cut = scale(campaign, name, cells)
    levels = {}
    for k in range(cut.cells):
        chosen = campaign.selection(f"{cut.cell} = {k}")
        if robots := tuple(robot_summary(chosen, robot) for robot in chosen.robots):
            levels[k] = robots
    return FieldSummary(cut, levels, tuple(_pairs(campaign, cut, list(levels))))


def _pairs(campaign: Campaign, cut: Scale, levels: list[int]) -> Iterator[PairSummary]:
    """Comparisons of levels, each with each if there are few, else with the first."""
    if not cut.labels or cut.name in GROUPS:
        return
    couples = list(combinations(levels, 2))
    if len(levels) > MOST_COMPARED:
        couples = [(k, levels[0]) for k in levels[1:]]
    keys = {SAME_DRAWS: ["sample"]}
    if campaign.design.plan.method == "grid":
        keys[SAME_FIELDS] = [
            one.column for one in campaign.design.dimensions
            if one.law.levels and not one.scatter and one.column != cut.name
        ]  # fmt: skip
    for robot in campaign.robots:
        for first, second in couples:
            of = tuple(f"{is_robot(robot)} AND {cut.cell} = {k}" for k in (first, second))
            names = (cut.labels[first], cut.labels[second])
            for common, columns in keys.items():
                found = pair_summary(
                    campaign, names, (of[0], of[1]), ["repeat", *columns], common=common,
                    robot=robot,
                )  # fmt: skip
                if found.pairs:
                    yield found
                    break

"""Worst case of measures over one field, and the values of the field that keep limits."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.campaign.access import Campaign
from springback.campaign.analysis.marginals import (
    MeasureColumn,
    Scale,
    fields_of,
    measure_column,
    scale,
)
from springback.campaign.analysis.statistics import ordered_values
from springback.campaign.design.success import alternatives
from springback.errors import InputError
from springback.intervals import CONFIDENCE, Values
from springback.results.database import identifier

#: Flights of a cell, on average, and fewest and most cells of a field without levels, alone and of
#: two fields each (chosen: all of 40 flights within the limits mean that at least 93 % of such
#: flights are).
FLIGHTS_EACH, CELLS, CELLS_OF_TWO = 40, (4, 16), (3, 8)
#: Cells of the other fields in which limits may be kept more often, how much more often, fewest
#: flights that say so, and most of them that are listed (chosen).
PARTS, BETTER, FEWEST, MOST_LISTED = 4, 0.05, 10, 3


class WorstCaseLimit(NamedTuple):
    """A limit in words, and the measure that it bounds."""

    text: str
    """As given; empty for a measure without a limit."""
    sql: str
    measure: MeasureColumn | None
    """The one measure of its comparisons; None if there are several, or only outcomes."""
    least: bool = False
    """True if the limit is a lower one, so that the worst value is the smallest."""
    values: tuple[float, ...] = ()
    """Limits of the measure, in SI."""


class WorstCaseCell(NamedTuple):
    """Flights of a robot with nearly one value of the field."""

    number: int
    """Number of the cell or level."""
    low: float
    """Lower bound of the field's values, or the level; for words the number of the level."""
    high: float
    flights: int
    """Number of flights that were not refused."""
    kept: tuple[int, ...]
    """Number of flights that keep each limit."""
    all_kept: int
    """Number of flights that keep all of them."""
    worst: tuple[float | None, ...]
    """Worst value of each limit's measure; None if it has no measure, or no flight has it."""
    missing: tuple[int, ...]
    """Number of flights without each limit's measure."""

    @property
    def middle(self) -> float:
        """Place of the cell along the field."""
        return 0.5 * (self.low + self.high)


class FieldRange(NamedTuple):
    """Neighbouring cells in which limits are kept."""

    cells: tuple[WorstCaseCell, ...]

    @property
    def low(self) -> float:
        """Lowest value of the field."""
        return self.cells[0].low

    @property
    def high(self) -> float:
        """Highest value of the field."""
        return self.cells[-1].high


class FieldCellShare(NamedTuple):
    """A cell of another field, in which limits are kept more often."""

    field: Scale
    cell: int
    flights: int
    kept: int
    """Number of these flights that keep all limits."""

    @property
    def share(self) -> float:
        """Share of these flights that keep all limits."""
        return self.kept / self.flights


@dataclass(frozen=True)
class WorstCase:
    """Worst case of measures over a field, and where it keeps limits."""

    field: Scale
    limits: tuple[WorstCaseLimit, ...]
    share: float
    """Share of the flights of a cell that must keep the limits: 1 for all."""
    others: tuple[str, ...]
    """The other varied fields, over which the worst case is taken."""
    conditions: tuple[str, ...]
    """Conditions in words on the flights."""
    robots: dict[str, tuple[WorstCaseCell, ...]]
    """Cells with flights, by robot, in ascending order."""
    better: dict[str, tuple[FieldCellShare, ...]]
    """Cells of other fields in which a robot keeps the limits more often, the best first."""

    def keeps(self, cell: WorstCaseCell, limit: int | None = None) -> bool:
        """True if enough flights of a cell keep a limit, by number, or all limits."""
        kept = cell.all_kept if limit is None else cell.kept[limit]
        return kept >= flights_needed(self.share, cell.flights)

    def ranges(self, robot: str, limit: int | None = None) -> list[FieldRange]:
        """Ranges of the field in which a robot keeps a limit, by number, or all limits."""
        found: list[list[WorstCaseCell]] = []
        before = -2
        for cell in self.robots[robot]:
            if self.keeps(cell, limit):
                if cell.number != before + 1:
                    found.append([])
                found[-1].append(cell)
                before = cell.number
        return [FieldRange(tuple(cells)) for cells in found]

    def best(self, robot: str) -> WorstCaseCell | None:
        """The cell in which the largest share of a robot's flights keeps all limits."""
        cells = self.robots[robot]
        return max(cells, key=lambda cell: cell.all_kept / cell.flights, default=None)

    def as_dict(self) -> dict[str, Any]:
        """Plain data, in SI."""

        def ends(part: FieldRange) -> dict[str, Any]:
            names = [self.field.named_cell(cell.number) for cell in part.cells]
            if "level" in names[0]:
                return {"levels": [name["level"] for name in names]}
            return {"from": part.low, "to": part.high}

        def cells(robot: str) -> list[dict[str, Any]]:
            return [
                self.field.named_cell(cell.number) | {
                    "flights": cell.flights, "keep_all": cell.all_kept, "keep": list(cell.kept),
                    "worst": list(cell.worst), "kept": self.keeps(cell),
                }
                for cell in self.robots[robot]
            ]  # fmt: skip

        return {
            "field": self.field.name, "unit": self.field.unit, "share": self.share,
            "limits": [
                {"limit": one.text, "measure": one.measure.name if one.measure else None}
                for one in self.limits
            ],
            "others": list(self.others), "where": list(self.conditions),
            "robots": {
                robot: {"kept": [ends(part) for part in self.ranges(robot)], "cells": cells(robot)}
                for robot in self.robots
            },
        }  # fmt: skip


@dataclass(frozen=True)
class WorstCaseMap:
    """Worst case over all fields but two: over the first, for each cell of the second."""

    across: Scale
    """The second field."""
    slices: dict[int, WorstCase]
    """Worst cases over the first field by the cell of the second."""
    whole: WorstCase
    """The worst case over the second field, too."""

    def as_dict(self) -> dict[str, Any]:
        """Plain data, in SI."""
        slices = [
            self.across.named_cell(k) | {"along": one.as_dict()} for k, one in self.slices.items()
        ]
        return {"across": self.across.name, "unit": self.across.unit, "slices": slices}


def flights_needed(share: float, flights: int) -> int:
    """Smallest number of flights that is a share of them, at least one."""
    return max(1, math.ceil(share * flights - 1e-9))


def least_share(kept: int, flights: int) -> float:
    """Lower bound of the share of flights that keep limits (Clopper and Pearson 1934)."""
    return float(scipy.stats.beta.ppf(1.0 - CONFIDENCE, kept, flights - kept + 1)) if kept else 0.0


def worst_case(
    campaign: Campaign,
    by: str | Scale,
    limits: Sequence[str] = (),
    *,
    measure: str | None = None,
    share: float = 1.0,
    cells: int | None = None,
) -> WorstCase:
    """Worst case over all fields but one.

    Args:
        campaign: Campaign that varied the field; `springback.Campaign.where` holds other fields.
        by: Name of the field's column, or its division into cells.
        limits: Limits in words, as for a plan's ``success``.
        measure: A measure to be shown even if no limit is about it.
        share: Share of the flights at each value of the field that must keep the limits.
        cells: Number of cells of a field without levels; by default as many as flights allow.

    Raises:
        InputError: If the field was not varied, a limit cannot be read, there is no such measure,
            or the share is not above 0 and at most 1.
    """
    if not 0.0 < share <= 1.0:
        raise InputError(f"share: must be above 0 and at most 1 (got {share:g})")
    read = [_limit(campaign, text) for text in limits]
    if measure is not None and measure not in {one.measure.name for one in read if one.measure}:
        read.insert(0, WorstCaseLimit("", "true", measure_column(campaign, measure)))
    if not read:
        raise InputError("limits: give at least one, such as impact_peak_acceleration < 300 m/s^2")
    cut = (
        by if isinstance(by, Scale) else scale(campaign, by, cells or _cell_count(campaign, CELLS))
    )
    others = tuple(name for name in fields_of(campaign, scatter=True) if name != cut.name)
    robots = {robot: tuple(_cells(campaign, cut, read, share, robot)) for robot in campaign.robots}
    better = _better(campaign, {cut.name}, read, robots)
    return WorstCase(cut, tuple(read), share, others, campaign.conditions, robots, better)


def _cell_count(campaign: Campaign, bounds: tuple[int, int], fields: int = 1) -> int:
    """Number of cells along each of some fields that flights allow, within bounds."""
    flights = campaign.count("FROM flights WHERE outcome <> 'refused'")
    each = flights / (FLIGHTS_EACH * max(1, len(campaign.robots)))
    return min(max(int(each ** (1.0 / fields)), bounds[0]), bounds[1])


def _better(
    campaign: Campaign,
    known: Collection[str],
    limits: Sequence[WorstCaseLimit],
    robots: Mapping[str, Sequence[WorstCaseCell]],
) -> dict[str, tuple[FieldCellShare, ...]]:
    """Of each field but some the cell in which each robot keeps all limits most often.

    Nothing for a robot that keeps them somewhere, and no cell that hardly helps.
    """
    kept = " AND ".join(f"({one.sql})" for one in limits)
    names = [name for name in fields_of(campaign) if name not in known]
    found: dict[str, list[FieldCellShare]] = {robot: [] for robot in robots}
    for cut in (scale(campaign, name, PARTS) for name in names):
        sql = f"""SELECT robot, ({cut.cell})::INTEGER AS cell, count(*),
                         count(*) FILTER (WHERE {kept}) FROM flights WHERE outcome <> 'refused'
                  GROUP BY robot, cell ORDER BY robot, cell"""
        best: dict[str, FieldCellShare] = {}
        for robot, cell, flights, count in campaign.query(sql).rows:
            one = FieldCellShare(cut, cell if cell is not None else -1, flights, count)
            if robot not in robots or not 0 <= one.cell < cut.cells or flights < FEWEST:
                continue  # a foreign folder may have others
            if robot not in best or one.share > best[robot].share:
                best[robot] = one
        for robot, one in best.items():
            flights = sum(cell.flights for cell in robots[robot])
            mean = sum(cell.all_kept for cell in robots[robot]) / max(1, flights)
            found[robot] += [one] * (one.share > mean + BETTER)
    ranked = {r: sorted(cells, key=lambda one: -one.share) for r, cells in found.items()}
    return {robot: tuple(cells[:MOST_LISTED]) for robot, cells in ranked.items()}


def worst_case_map(
    campaign: Campaign,
    by: tuple[str, str],
    limits: Sequence[str],
    *,
    share: float = 1.0,
    cells: int | None = None,
) -> WorstCaseMap:
    """Worst case over all fields but two.

    Args:
        campaign: As for `worst_case`.
        by: Names of the two fields' columns.
        limits: As there.
        share: As there.
        cells: Number of cells of each field without levels.

    Raises:
        InputError: As there.
    """
    count = cells or _cell_count(campaign, CELLS_OF_TWO, 2)
    along, across = (scale(campaign, name, count) for name in by)
    if along.name == across.name:
        raise InputError(f"{by[0]},{by[1]}: give two different fields")
    whole = worst_case(campaign, along, limits, share=share)
    slices: dict[int, WorstCase] = {}
    for k in range(across.cells):
        part = campaign.selection(f"{across.cell} = {k}")
        cells_of = {
            robot: tuple(_cells(part, along, whole.limits, share, robot)) for robot in part.robots
        }
        if cells_of:
            slices[k] = replace(whole, robots=cells_of, better={})
    others = tuple(name for name in whole.others if name != across.name)
    better = _better(campaign, {along.name, across.name}, whole.limits, whole.robots)
    return WorstCaseMap(across, slices, replace(whole, others=others, better=better))


def _limit(campaign: Campaign, text: str) -> WorstCaseLimit:
    """A limit in words, and the measure that it bounds."""
    design = campaign.design
    terms = alternatives(text, design.condition_fields, judged=True)
    sql = design.condition(text, judged=True)
    numbers = [term for term in terms if not isinstance(term.value, str)]
    if (
        len({(term.column, term.sign[0]) for term in numbers}) != 1
        or numbers[0].sign[0] not in "<>"
    ):
        return WorstCaseLimit(text, sql, None)
    measure = measure_column(campaign, numbers[0].column)
    values = tuple(float(term.value) for term in numbers)
    return WorstCaseLimit(text, sql, measure, numbers[0].sign[0] == ">", values)


def _cells(
    campaign: Campaign, cut: Scale, limits: Sequence[WorstCaseLimit], share: float, robot: str
) -> Iterator[WorstCaseCell]:
    """Cells of a robot that have flights."""
    columns = [f"({cut.cell})::DOUBLE AS cell"]
    for k, one in enumerate(limits):
        value = identifier(one.measure.name) if one.measure else "NULL"
        columns += [f"({one.sql})::DOUBLE AS kept{k}", f"({value})::DOUBLE AS value{k}"]
    sql = f"""FROM (SELECT {", ".join(columns)} FROM flights WHERE robot = ? AND
              outcome <> 'refused') WHERE cell >= 0 ORDER BY cell"""
    found = campaign.arrays(f"SELECT * {sql}", [robot])
    for k, one in enumerate(limits):
        ordered_values(campaign, {one.measure.name: found[f"value{k}"]} if one.measure else {})
    kept = np.array([found[f"kept{k}"] for k in range(len(limits))]) == 1.0
    for index in np.unique(found["cell"]).astype(int).tolist():
        inside = found["cell"] == index
        flights = int(inside.sum())
        values = [found[f"value{k}"][inside] for k in range(len(limits))]
        yield WorstCaseCell(
            index, *cut.bounds(index), flights,
            tuple(int(row[inside].sum()) for row in kept), int(kept[:, inside].all(axis=0).sum()),
            tuple(
                _worst(each, share, least=one.least)
                for one, each in zip(limits, values, strict=True)
            ),
            tuple(
                int(np.isnan(each).sum()) if one.measure else 0
                for one, each in zip(limits, values, strict=True)
            ),
        )  # fmt: skip


def _worst(values: Values, share: float, *, least: bool) -> float | None:
    """The value up to which (from which, if ``least``) a share of flights is; None if none has it.

    It is one of the values, so that it keeps a limit if and only if enough flights do.
    """
    known = np.sort(values[~np.isnan(values)])
    if not len(known):
        return None
    rank = flights_needed(share, len(known))
    return float(known[-rank] if least else known[rank - 1])


def worst_cases(
    campaign: Campaign,
    limits: Sequence[str],
    fields: Sequence[str] = (),
    *,
    share: float = 1.0,
    cells: int | None = None,
) -> list[WorstCase | WorstCaseMap]:
    """Worst case over each of some fields, by default over each that the plan varies.

    Args:
        campaign: As for `worst_case`.
        limits: As there.
        fields: Names of fields, or of two with a comma.
        share: As there.
        cells: As there.

    Raises:
        InputError: As there, or if a text names more than two fields.
    """
    found: list[WorstCase | WorstCaseMap] = []
    for text in fields or fields_of(campaign):
        first, *rest = (name.strip() for name in text.split(","))
        if len(rest) > 1:
            raise InputError(f"{text}: give one field, or two such as stiffness,damping")
        if rest:
            pair = (first, rest[0])
            found.append(worst_case_map(campaign, pair, limits, share=share, cells=cells))
        else:
            found.append(worst_case(campaign, first, limits, share=share, cells=cells))
    return found

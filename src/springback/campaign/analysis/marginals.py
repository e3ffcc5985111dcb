"""Success over single fields and pairs of fields of a campaign."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from springback.campaign.access import Campaign
from springback.campaign.analysis.intervals import IntervalEstimate, Values, share
from springback.campaign.design.distributions import LevelSet, NormalFactor
from springback.errors import InputError
from springback.results.database import identifier


class Scale(NamedTuple):
    """Division of a field into cells."""

    name: str
    unit: str
    labels: tuple[str, ...]
    """Labels of its levels; empty for equal intervals."""
    edges: tuple[float, ...]
    """Edges of cells, SI, one more than there are cells."""
    logarithmic: bool
    cell: str
    """SQL expression of the number of a row's cell, from 0."""

    @property
    def cells(self) -> int:
        """Number of cells."""
        return len(self.labels) or len(self.edges) - 1


def fields_of(campaign: Campaign, *, scatter: bool = False) -> list[str]:
    """Names of the fields that the plan varies; with ``scatter`` also the scattered ones."""
    return [one.column for one in campaign.design.dimensions if scatter or not one.scatter]


#: Most levels that have a cell each (chosen).
MOST_LEVELS = 24
#: Share of flights in the outermost cell at each end of a normal distribution (chosen).
TAIL = 0.005


def scale(campaign: Campaign, name: str, cells: int) -> Scale:
    """Division of a field into cells.

    Args:
        campaign: Campaign that varied it.
        name: Name of its column.
        cells: Number of cells if it has no levels.

    Raises:
        InputError: If it was not varied.
    """
    known = {one.column: one for one in campaign.design.dimensions}
    if name not in known:
        raise InputError(f"{name}: is not varied by this campaign; varied are {', '.join(known)}")
    one, column = known[name], identifier(name)
    if isinstance(one.law, LevelSet) and (one.text or len(one.law.values) <= MOST_LEVELS):
        values = [one.column_value(k, 0) for k in range(one.law.levels)]
        labels = tuple(v if isinstance(v, str) else f"{v:.6g}" for v in values)
        texts = ", ".join(f"{v!r}" if isinstance(v, str) else f"{v!r}::DOUBLE" for v in values)
        places = () if one.text else tuple(float(v) for v in values)
        return Scale(
            name, one.unit, labels, places, False, f"list_position([{texts}], {column}) - 1"
        )
    logarithmic = getattr(one.law, "logarithmic", False) or isinstance(one.law, NormalFactor)
    bell = not hasattr(one.law, "first") and not isinstance(one.law, LevelSet)
    ends = f"quantile_cont({column}, [{TAIL}, {1.0 - TAIL}])" if bell else (
        f"[min({column}), max({column})]"
    )  # fmt: skip
    [(low, high)] = campaign.query(f"SELECT {ends} FROM flights").rows[0]
    if not high > low:
        high = low + 1.0
    sign = -1.0 if low < 0.0 else 1.0
    function = f"ln({sign!r} * {column})" if logarithmic else column
    a, b = (float(np.log(sign * v)) if logarithmic else float(v) for v in (low, high))
    edges = np.linspace(a, b, cells + 1)
    width = float(edges[1] - edges[0])
    cell = f"greatest(0, least({cells - 1}, floor(({function} - {a!r}) / {width!r})))::INTEGER"
    shown = sign * np.exp(edges) if logarithmic else edges
    return Scale(name, one.unit, (), tuple(map(float, shown)), logarithmic, cell)


class MarginalCell(NamedTuple):
    """Flights of a robot in a cell."""

    place: float
    """Their mean along the field; for levels with words, the number of the level."""
    flights: int
    successes: int
    success: IntervalEstimate


@dataclass(frozen=True)
class Marginal:
    """Success over one field, averaged over the others."""

    scale: Scale
    robots: dict[str, tuple[MarginalCell, ...]]
    """Non-empty cells of each robot."""

    def as_dict(self) -> dict[str, Any]:
        """Plain data."""
        cells = {
            robot: [{"at": c.place, "flights": c.flights, **c.success._asdict()} for c in found]
            for robot, found in self.robots.items()
        }
        s = self.scale
        return {"field": s.name, "unit": s.unit, "levels": list(s.labels), "robots": cells}


def marginal(campaign: Campaign, name: str, cells: int = 12) -> Marginal:
    """Success over a field.

    Args:
        campaign: Campaign that varied it.
        name: Name of its column.
        cells: Number of cells if it has no levels.
    """
    cut = scale(campaign, name, cells)
    text = bool(cut.labels) and not cut.edges
    place = "cell" if text else f"avg({identifier(name)})"
    sql = f"""SELECT robot, {cut.cell} AS cell, {place} AS place, count(success), sum(success)
              FROM flights WHERE success IS NOT NULL GROUP BY robot, cell ORDER BY robot, cell"""
    robots: dict[str, list[MarginalCell]] = {robot: [] for robot in campaign.about["robots"]}
    for robot, _, at, flights, won in campaign.query(sql).rows:
        robots[robot].append(
            MarginalCell(float(at), int(flights), int(won), share(int(won), int(flights)))
        )
    return Marginal(cut, {robot: tuple(found) for robot, found in robots.items()})


@dataclass(frozen=True)
class FieldMap:
    """Success over two fields."""

    x: Scale
    y: Scale
    flights: dict[str, Values]
    """Number of flights of each robot, by row and column of cells."""
    successes: dict[str, Values]

    def shares(self, robot: str) -> Values:
        """Success rates of each robot; NaN for empty cells."""
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.asarray(self.successes[robot] / self.flights[robot], np.float64)


def field_map(campaign: Campaign, x: str, y: str, cells: int = 12) -> FieldMap:
    """Success over two fields.

    Args:
        campaign: Campaign that varied them.
        x: Name of a column.
        y: Name of another.
        cells: Number of cells along each if it has no levels.
    """
    across, up = scale(campaign, x, cells), scale(campaign, y, cells)
    sql = f"""SELECT robot, {across.cell} AS i, {up.cell} AS j, count(success), sum(success)
              FROM flights WHERE success IS NOT NULL GROUP BY robot, i, j"""
    shape = (up.cells, across.cells)
    names: Sequence[str] = campaign.about["robots"]
    flights = {robot: np.zeros(shape) for robot in names}
    won = {robot: np.zeros(shape) for robot in names}
    for robot, i, j, count, successes in campaign.query(sql).rows:
        flights[robot][j, i], won[robot][j, i] = count, successes
    return FieldMap(across, up, flights, won)

"""Success, or a measure, over single fields and pairs of fields of a campaign."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from springback.campaign.access import Campaign
from springback.campaign.analysis.statistics import ordered_values
from springback.campaign.columns import FLIGHT, RESULT, SECOND_OUTCOME, known_columns
from springback.campaign.design.distributions import LevelSet, NormalFactor
from springback.campaign.design.targets import field_path
from springback.errors import InputError
from springback.intervals import IntervalEstimate, Values, quantile, share
from springback.problems import nearest_name
from springback.results.database import identifier, literal


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

    def bounds(self, cell: int) -> tuple[float, float]:
        """Bounds of a cell in SI; a level twice, of words its number."""
        if not self.labels:
            return self.edges[cell], self.edges[cell + 1]
        level = self.edges[cell] if self.edges else float(cell)
        return level, level

    def named_cell(self, cell: int) -> dict[str, Any]:
        """Plain data that name a cell: its word, or its bounds."""
        if self.labels and not self.edges:
            return {"level": self.labels[cell]}
        return dict(zip(("from", "to"), self.bounds(cell), strict=True))


def fields_of(campaign: Campaign, *, scatter: bool = False) -> list[str]:
    """Names of the fields that the plan varies; with ``scatter`` also the scattered ones."""
    return [one.column for one in campaign.design.dimensions if scatter or not one.scatter]


#: Most levels that have a cell each (chosen).
MOST_LEVELS = 24
#: Columns of results whose words group flights.
GROUPS = ("outcome", "first_obstacle", *SECOND_OUTCOME)
#: Labels of flights that touched nothing, and of those of the least frequent words.
NOTHING, OTHERS = "nothing", "others"
#: Share of flights in the outermost cell at each end of a normal distribution (chosen).
TAIL = 0.005


def scale(campaign: Campaign, name: str, cells: int) -> Scale:
    """Division of a field into cells.

    Args:
        campaign: Campaign that varied it.
        name: Name of its column, or its field spelt in another way, as in a plan; or a column of
            `GROUPS`, whose words are levels, the most frequent first.
        cells: Number of cells if it has no levels.

    Raises:
        InputError: If it was not varied.
    """
    if name in GROUPS:
        return _groups(campaign, name)
    known = {one.column: one for one in campaign.design.dimensions}
    if name not in known:
        path = field_path(name)
        name = next((column for column in known if field_path(column) == path), name)
    if name not in known:
        raise InputError(
            f"{name}: is not varied by this campaign; varied are {', '.join(known)}; what flights "
            "did is in outcome and first_obstacle"
        )
    one, column = known[name], identifier(name)
    if isinstance(one.law, LevelSet) and (one.text or len(one.law.values) <= MOST_LEVELS):
        values = [one.column_value(k, 0) for k in range(one.law.levels)]
        values = values if one.text else sorted(values)
        labels = tuple(v if isinstance(v, str) else f"{v:.6g}" for v in values)
        texts = ", ".join(literal(v) if isinstance(v, str) else f"{v!r}::DOUBLE" for v in values)
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
    if not (isinstance(low, int | float) and isinstance(high, int | float) and high > low):
        low = low if isinstance(low, int | float) and math.isfinite(low) else 0.0
        high = low + 1.0
    logarithmic = logarithmic and low * high > 0.0  # always, but in a foreign folder
    sign = -1.0 if low < 0.0 else 1.0
    function = f"ln({sign!r} * {column})" if logarithmic else column
    a, b = (float(np.log(sign * v)) if logarithmic else float(v) for v in (low, high))
    edges = np.linspace(a, b, cells + 1)
    width = float(edges[1] - edges[0])
    cell = f"greatest(0, least({cells - 1}, floor(({function} - {a!r}) / {width!r})))::INTEGER"
    shown = sign * np.exp(edges) if logarithmic else edges
    return Scale(name, one.unit, (), tuple(map(float, shown)), logarithmic, cell)


def _groups(campaign: Campaign, name: str) -> Scale:
    """Division of flights by the words of a column of results."""
    if name not in campaign.query("FROM flights LIMIT 0").columns:
        raise InputError(f"{name}: the rows of {campaign.folder} do not have this column")
    column = identifier(name)
    sql = f"""SELECT {column} FROM flights WHERE outcome <> 'refused' AND {column} IS NOT NULL
              GROUP BY {column} ORDER BY count(*) DESC, {column}"""
    words = [str(word) for (word,) in campaign.query(sql).rows]
    most = words if len(words) <= MOST_LEVELS else words[: MOST_LEVELS - 1]
    labels = tuple(word or NOTHING for word in most) + (OTHERS,) * (len(most) < len(words))
    texts = ", ".join(map(literal, most))
    place = f"coalesce(nullif(list_position([{texts}]::VARCHAR[], {column}), 0) - 1, {len(most)})"
    cell = f"CASE WHEN outcome <> 'refused' AND {column} IS NOT NULL THEN {place} END"
    return Scale(name, "", labels, (), False, f"({cell})")


#: Measure of a map or marginal unless another is named.
SUCCESS = "success"
#: Columns without a number that could be summarised.
_IDENTITIES = {*FLIGHT, *RESULT, *SECOND_OUTCOME} - {SUCCESS}
#: Condition on rows that have a measure, and a cell.
_KNOWN = "value IS NOT NULL AND NOT isnan(value) AND cell >= 0"
#: Shares of flights below the ends of a marginal's band (chosen).
BAND = (0.05, 0.95)


class MeasureColumn(NamedTuple):
    """A column that can be summarised."""

    name: str
    unit: str
    """SI unit; empty for plain numbers."""
    meaning: str


def measure_column(campaign: Campaign, name: str) -> MeasureColumn:
    """Column of a campaign whose numbers can be summarised: a measure, success, a varied field.

    Args:
        campaign: Any.
        name: Name of the column.

    Raises:
        InputError: If there is no such column, or it holds no quantity.
    """
    words = {one.column for one in campaign.design.dimensions if one.text}
    fields = {one.column: (one.unit, "varied by the plan") for one in campaign.design.dimensions}
    known = {
        column: about
        for column, about in {**known_columns(second=campaign.design.has_second), **fields}.items()
        if column not in _IDENTITIES and column not in words
    }  # fmt: skip
    if name in known:
        return MeasureColumn(name, *known[name])
    if name in _IDENTITIES or name in words:
        raise InputError(f"{name}: holds words or numbers of flights, which have no distribution")
    near = nearest_name(name, known)
    hint = f"did you mean {near}?" if near else "springback query FOLDER lists all"
    raise InputError(f"{name}: is no column of this campaign; {hint}")


class MarginalCell(NamedTuple):
    """Flights of a robot in a cell."""

    place: float
    """Their mean along the field; for levels with words, the number of the level."""
    flights: int
    """Number of flights that have the measure."""
    estimate: IntervalEstimate
    """Success rate, or median of the measure."""
    band: tuple[float, float] | None = None
    """5 % and 95 % quantiles of the flights; None for success."""


@dataclass(frozen=True)
class Marginal:
    """Success, or a measure, over one field, averaged over the others."""

    measure: MeasureColumn
    scale: Scale
    robots: dict[str, tuple[MarginalCell, ...]]
    """Non-empty cells of each robot."""

    def as_dict(self) -> dict[str, Any]:
        """Plain data."""
        cells = {
            robot: [
                {"at": c.place, "flights": c.flights, **c.estimate._asdict()}
                | ({f"{p:g}": v for p, v in zip(BAND, c.band, strict=True)} if c.band else {})
                for c in found
            ]
            for robot, found in self.robots.items()
        }
        s = self.scale
        return {"field": s.name, "unit": s.unit, "levels": list(s.labels), "robots": cells}


def marginal(campaign: Campaign, name: str, cells: int = 12, *, measure: str = SUCCESS) -> Marginal:
    """Success, or a measure, over a field.

    Args:
        campaign: Campaign that varied it.
        name: Name of the field's column.
        cells: Number of cells if it has no levels.
        measure: Name of the column to summarise.

    Raises:
        InputError: If the field was not varied, or there is no such measure.
    """
    what, cut = measure_column(campaign, measure), scale(campaign, name, cells)
    robots = {robot: tuple(_along(campaign, what, cut, robot)) for robot in campaign.robots}
    return Marginal(what, cut, robots)


def _along(
    campaign: Campaign, what: MeasureColumn, cut: Scale, robot: str
) -> Iterator[MarginalCell]:
    """Non-empty cells of a robot."""
    place = "cell" if cut.labels and not cut.edges else identifier(cut.name)
    inner = f"SELECT {cut.cell} AS cell, {place} AS place, {identifier(what.name)}::DOUBLE AS value"
    rows = (
        f"FROM (FROM ({inner} FROM flights WHERE robot = ?) WHERE {_KNOWN} AND place IS NOT NULL)"
    )
    if what.name == SUCCESS:
        sql = (
            f"SELECT cell, avg(place), count(value), sum(value) {rows} GROUP BY cell ORDER BY cell"
        )
        for _, at, flights, won in campaign.query(sql, [robot]).rows:
            yield MarginalCell(float(at), int(flights), share(int(won), int(flights)))
        return
    found = campaign.arrays(f"SELECT cell, place, value {rows} ORDER BY cell, value", [robot])
    ordered_values(campaign, {what.name: found["value"]})
    starts = np.flatnonzero(np.diff(found["cell"])) + 1
    parts = (np.split(found[name], starts) for name in ("place", "value"))
    for places, values in zip(*parts, strict=True):
        if len(values):
            low, high = (float(np.quantile(values, part)) for part in BAND)
            at = float(places.mean())
            yield MarginalCell(at, len(values), quantile(values, 0.5), (low, high))


@dataclass(frozen=True)
class FieldMap:
    """Success, or a measure, over two fields."""

    measure: MeasureColumn
    x: Scale
    y: Scale
    flights: dict[str, Values]
    """Number of flights of each robot that have the measure, by row and column of cells."""
    values: dict[str, Values]
    """Success rate, or median of the measure, in SI; NaN for empty cells."""


def field_map(
    campaign: Campaign, x: str, y: str, cells: int = 12, *, measure: str = SUCCESS
) -> FieldMap:
    """Success, or a measure, over two fields.

    Args:
        campaign: Campaign that varied them.
        x: Name of a column.
        y: Name of another.
        cells: Number of cells along each if it has no levels.
        measure: Name of the column to summarise.

    Raises:
        InputError: If a field was not varied, or there is no such measure.
    """
    what = measure_column(campaign, measure)
    across, up = scale(campaign, x, cells), scale(campaign, y, cells)
    of = "avg(value)" if what.name == SUCCESS else "median(value)"
    inner = f"""SELECT robot, {across.cell} AS cell, {up.cell} AS line,
                       {identifier(what.name)}::DOUBLE AS value FROM flights"""
    sql = f"""SELECT robot, cell, line, count(value), {of} FROM ({inner})
              WHERE {_KNOWN} AND line >= 0 GROUP BY robot, cell, line"""
    shape = (up.cells, across.cells)
    names: Sequence[str] = campaign.robots
    flights = {robot: np.zeros(shape) for robot in names}
    values = {robot: np.full(shape, np.nan) for robot in names}
    for robot, i, j, count, found in campaign.query(sql).rows:
        if robot in flights:  # a foreign folder may have rows of others
            flights[robot][j, i], values[robot][j, i] = count, found
    ordered_values(campaign, {what.name: np.concatenate([v.ravel() for v in values.values()])})
    return FieldMap(what, across, up, flights, values)

"""Figure of a worst case over a field: worst values, limits, and where these are kept."""

from __future__ import annotations

import textwrap
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from springback.campaign.analysis.marginals import SUCCESS, FieldMap, MeasureColumn
from springback.campaign.analysis.worst_case import WorstCase, WorstCaseMap
from springback.interfaces.figures.campaign import (
    display_values,
    field_map_figure,
    field_ticks,
    in_words,
    label,
)
from springback.interfaces.figures.chart import Chart
from springback.interfaces.figures.style import StyledFigure, in_style
from springback.interfaces.output.robots import INK, RobotStyle, robot_styles, with_labels
from springback.interfaces.output.worst_case import measure_unit, worst_case_lines

#: Size of a panel [in], letters of the answer in a line for each panel, and height of a line [in].
PANEL, LETTERS, LINE = (3.6, 2.7), 62, 0.16


@in_style
def worst_case_figure(found: WorstCase, *, answer: bool = True) -> Figure:
    """Worst value of each limit's measure over the field, with the limit and where all are kept.

    A limit of outcomes has the share of flights that keep it in place of a measure.

    Args:
        found: The worst case.
        answer: Write the answer below the panels.
    """
    count = len(found.limits)
    columns = min(2, count)
    lines = -(-count // columns)
    texts = worst_case_lines(found) if answer else []
    words = [w for text in texts for w in textwrap.wrap(with_labels(text), LETTERS * columns + 6)]
    room = LINE * (len(words) + 1) if words else 0.0
    height = PANEL[1] * lines + 0.35 + room
    figure = StyledFigure(figsize=(PANEL[0] * columns + 0.5, height))
    grid = figure.subplots(lines, columns, squeeze=False)
    looks = robot_styles(found.robots)
    for k, axes in enumerate(grid.flat[:count]):
        _panel(axes, found, k, looks)
    for axes in grid.flat[count:]:
        axes.set_visible(False)
    handles, names = grid[0, 0].get_legend_handles_labels()
    figure.legend(handles, names, loc="outside upper center", ncols=len(names))
    if words:
        engine: Any = figure.get_layout_engine()
        engine.set(rect=(0.0, room / height, 1.0, 1.0 - room / height))
        figure.text(0.02, 0.5 * LINE / height, "\n".join(words), va="bottom", size=7.5)
    return figure


def _panel(axes: Axes, found: WorstCase, k: int, looks: dict[str, RobotStyle]) -> None:
    """One limit: the curve of each robot, the limit, and the values of the field that keep all."""
    limit, unit = found.limits[k], measure_unit(found, k)
    how = "Worst" if found.share == 1.0 else f"Worst of {100.0 * found.share:g} % of flights:"
    if limit.measure:
        head = f"{how} {in_words(limit.measure.name)} [{unit.symbol}]"
    else:
        head = "Share of flights that keep it [-]"
    chart = Chart(axes, label(found.field), head, in_words(limit.text).replace("^2", "²"))
    names = list(found.robots)
    of_words = bool(found.field.labels) and not found.field.edges
    for robot, look in looks.items():
        cells = [c for c in found.robots[robot] if limit.measure is None or c.worst[k] is not None]
        x = display_values(found.field, [cell.middle for cell in cells])
        values = [cell.worst[k] if limit.measure else cell.kept[k] / cell.flights for cell in cells]
        y = unit.factor * np.array(values, float)
        columns: dict[str, Any] = {"flights": [cell.flights for cell in cells]}
        style: dict[str, Any] = {**look.curve, "marker": look.marker, "ms": 3.5}
        if of_words:
            columns[chart.x] = [found.field.labels[cell.number] for cell in cells]
            x = x + 0.14 * (names.index(robot) - 0.5 * (len(names) - 1))
            style["ls"] = "none"
        if found.field.logarithmic:
            ends = display_values(found.field, [(cell.low, cell.high) for cell in cells])
            x = np.sign(ends[:, 0]) * np.sqrt(ends.prod(axis=1)) if len(ends) else x
        chart.curve(look.label, x, y, columns=columns, **style)
        if any(one.text for one in found.limits) and not of_words:
            _kept(chart, found, robot, look)
    for value in limit.values:
        chart.hline(limit.text, value * unit.factor, color=INK, ls="-", lw=1.1)
    if limit.measure is None:
        chart.hline("needed", found.share, color=INK, ls="-", lw=1.1)
        axes.set_ylim(-0.03, 1.05)
    elif limit.values:
        low, high = axes.get_ylim()
        axes.set_ylim(min(low, 0.0) if low >= 0.0 else low, high)
    axes.set_ylabel(textwrap.fill(head, 30))
    field_ticks(axes, found.field)


def _kept(chart: Chart, found: WorstCase, robot: str, look: RobotStyle) -> None:
    """Shade the values of the field for which a robot keeps all limits."""
    for part in found.ranges(robot):
        low, high = display_values(found.field, sorted((part.low, part.high))).tolist()
        if high > low:
            chart.span(f"{look.label} keeps all", low, high, color=look.colour, alpha=0.12)
        else:
            chart.vline(
                f"{look.label} keeps all", low, color=look.colour, alpha=0.25, lw=6.0, ls="-"
            )


def worst_case_map_figure(found: WorstCaseMap) -> StyledFigure:
    """Share of flights that keep all limits over two fields, by robot."""
    cut, robots = found.whole.field, list(found.whole.robots)
    shape = (found.across.cells, cut.cells)
    flights = {robot: np.zeros(shape) for robot in robots}
    shares = {robot: np.full(shape, np.nan) for robot in robots}
    for k, one in found.slices.items():
        for robot, cells in one.robots.items():
            for cell in cells:
                flights[robot][k, cell.number] = cell.flights
                shares[robot][k, cell.number] = cell.all_kept / cell.flights
    measure = MeasureColumn(SUCCESS, "", "all limits are kept")
    return field_map_figure(FieldMap(measure, cut, found.across, flights, shares))

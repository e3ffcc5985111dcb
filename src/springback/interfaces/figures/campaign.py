"""Figures of campaigns: success, or a measure, over one field and over two."""

from __future__ import annotations

import math
import re
import textwrap
from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullLocator

from springback.campaign.analysis.marginals import SUCCESS, FieldMap, Marginal, MeasureColumn, Scale
from springback.interfaces.figures.chart import (
    SCALE,
    Chart,
    add_share_bar,
    draw_shares,
    ink,
)
from springback.interfaces.figures.style import StyledFigure, in_style
from springback.interfaces.output.quantities import DisplayUnit, display_unit, quantity_text
from springback.interfaces.output.robots import SHADE, RobotStyle, robot_styles

SHARE = "Success rate [-]"
FLIGHTS = "Flights [-]"
#: Panels side by side, and their size [in].
ABREAST, PANEL = 3, (2.5, 2.0)
#: Maps side by side, and their size [in]; most cells along a side that have their value written.
SIDE, MAP, WRITTEN = 2, (3.2, 2.9), 8
#: Labels of panels are wrapped if longer than this [characters].
WIDEST = 26
#: The same of labels along a side of a map [characters].
WIDEST_OF_MAP = 36
#: Labels of levels are slanted if longer than this in total [characters] (chosen).
LONG = 22
#: Numbers of ticks that are long (chosen).
MANY_DIGITS = 1e4
#: Smallest number of ticks of a logarithmic axis, and largest number of labels (chosen).
ENOUGH, MOST_TICKS = 3, 5


def display_values(scale: Scale, values: Any) -> Any:
    """Values in the displayed unit."""
    return np.asarray(values) * display_unit(scale.unit).factor


def label(scale: Scale) -> str:
    """Name of a field and its unit."""
    if scale.labels and not scale.edges:
        return in_words(scale.name)
    return f"{in_words(scale.name)} [{display_unit(scale.unit).symbol}]"


def wrapped_label(text: str, most: int = WIDEST) -> str:
    """Label in two lines if it is long: broken before a point of a field's path, else at a blank.

    Args:
        text: Such as ``world.obstacles[0].surface.restitution [-]``.
        most: Characters of a line.
    """
    if len(text) <= most:
        return text
    places = [k for k, letter in enumerate(text) if letter == "." and 0 < k <= most]
    if not places:
        return textwrap.fill(text, most)
    return f"{text[: places[-1]]}\n{text[places[-1] :]}"


def in_words(name: str) -> str:
    """Name of a column, with spaces; components by axis: ``start.velocity[0]`` is velocity x."""
    axis = re.compile(r"(?:start\.)?\b(position|velocity|offset)\[([012])\]")
    return axis.sub(lambda found: f"{found[1]} {'xyz'[int(found[2])]}", name.replace("_", " "))


def measure_label(measure: MeasureColumn, unit: DisplayUnit) -> str:
    """Name of a measure and its unit; for success what its share is."""
    return SHARE if measure.name == SUCCESS else f"{in_words(measure.name)} [{unit.symbol}]"


@in_style
def marginals_figure(found: Sequence[Marginal]) -> Figure:
    """Success rate with Wilson intervals, or quantiles of a measure, over each field.

    Args:
        found: Marginals of the same measure, one for each panel.
    """
    columns = 2 if len(found) == 4 else min(ABREAST, len(found))
    lines = math.ceil(len(found) / columns)
    figure = StyledFigure(figsize=(PANEL[0] * columns + 0.5, PANEL[1] * lines + 0.5))
    grid = figure.subplots(lines, columns, sharey=True, squeeze=False)
    keys: dict[str, Any] = {}
    measure = found[0].measure
    every = [cell for one in found for cells in one.robots.values() for cell in cells]
    unit = display_unit(measure.unit, (v for cell in every for v in cell.band or ()))
    for axes, one in zip(grid.flat, found, strict=False):
        chart = Chart(axes, label(one.scale), measure_label(measure, unit))
        for robot, look in robot_styles(one.robots).items():
            if one.robots[robot]:
                keys[look.label] = _line(chart, one, robot, look, unit.factor)
        field_ticks(axes, one.scale)
    if measure.name == SUCCESS:
        lowest = min((cell.estimate.low or 0.0 for cell in every), default=1.0)
        bottom = max(-0.04, lowest - 0.06 * (1.0 - lowest) - 0.005)
        grid[0, 0].set_ylim(bottom, 1.0 + 0.06 * (1.0 - bottom))
    for axes in grid[:, 0]:
        axes.set_ylabel(textwrap.fill(axes.get_ylabel(), WIDEST))
    for axes in list(grid.flat)[len(found) :]:
        axes.set_visible(False)
    figure.legend(list(keys.values()), list(keys), loc="outside upper center", ncols=len(keys) or 1)
    return figure


def _line(chart: Chart, one: Marginal, robot: str, look: RobotStyle, factor: float) -> Any:
    """One robot over one field: points with bars at levels, else a line in a band."""
    cells = one.robots[robot]
    x = display_values(one.scale, [cell.place for cell in cells])
    y, low, high = factor * np.array([cell.estimate for cell in cells], float).T
    bands = factor * np.array([cell.band for cell in cells if cell.band])
    style = {**look.curve, "marker": look.marker}
    if not one.scale.labels:
        if len(bands):
            faint = {"color": look.colour, "alpha": 0.1}
            chart.band(f"{look.label}, 5 to 95 % of flights", x, *bands.T, **faint)
        chart.band(f"{look.label}, 95 % interval", x, low, high, color=look.colour, alpha=0.25)
        return chart.curve(look.label, x, y, ms=3.2, **style)
    words = {}
    if not one.scale.edges:  # words, side by side
        names = list(one.robots)
        words = {chart.x: [one.scale.labels[int(place)] for place in x]}
        x = x + 0.14 * (names.index(robot) - 0.5 * (len(names) - 1))
        style["ls"] = "none"
    if len(bands):
        thin: dict[str, Any] = {"ls": "none", "elinewidth": 0.7, "color": look.colour, "alpha": 0.6}
        chart.errorbars(
            f"_{look.label}, 5 to 95 % of flights", x, y, *bands.T, columns=words, **thin
        )
    return chart.errorbars(
        look.label, x, y, low, high, columns=words, ms=4.0, capsize=2.0, elinewidth=1.2, **style
    )


def field_ticks(axes: Axes, scale: Scale) -> None:
    """Label the x axis with a field and its levels, and space it as the field is."""
    axes.set_xlabel(wrapped_label(label(scale)))  # of words, too
    if scale.logarithmic:
        axes.set_xscale("log")
        _log_ticks(axes.xaxis, scale)
    elif not scale.labels:
        _few_ticks(axes.xaxis, scale)
    if scale.labels and not scale.edges:
        long = sum(map(len, scale.labels)) > LONG
        slant: dict[str, Any] = {"rotation": 20, "ha": "right"} if long else {}
        axes.set_xticks(range(len(scale.labels)), list(scale.labels), **slant)
        axes.set_xlim(-0.6, len(scale.labels) - 0.4)
        axes.grid(visible=False, axis="x")
    elif scale.labels and len(scale.labels) <= 7:
        axes.set_xticks(display_values(scale, scale.edges))
        axes.margins(x=0.12)  # labels keep clear of the neighbour's


def round_ticks(low: float, high: float) -> list[float]:
    """A few round numbers between two of the same sign, for a logarithmic axis.

    They are powers of ten if there are enough, else also 2 and 5 times these; if there are fewer
    than two, the ends of the range.
    """
    if high < 0.0:
        return [-tick for tick in reversed(round_ticks(-high, -low))]
    powers = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    found: list[float] = []
    for digits in ((1,), (1, 2, 5)):
        found = [d * 10.0**p for p in powers for d in digits if low <= d * 10.0**p <= high]
        if len(found) >= ENOUGH:
            break
    if len(found) < 2:
        return [low, high]
    return found[:: math.ceil(len(found) / MOST_TICKS)]


def tick_label(tick: float) -> str:
    """Label of a tick: plain digits, or a power of ten if those would be many."""
    if 1e-3 <= abs(tick) < 1e5:
        return f"{tick:.3g}" if abs(tick) < 1e3 else f"{tick:.0f}"
    power = math.floor(math.log10(abs(tick)))
    digits = f"{tick / 10.0**power:.3g}"
    return f"$10^{{{power}}}$" if digits == "1" else f"${digits} \\cdot 10^{{{power}}}$"


def _few_ticks(axis: Any, scale: Scale) -> None:
    """Fewer ticks where numbers are long, so that they keep clear of each other."""
    if max(abs(float(edge)) for edge in display_values(scale, scale.edges)) >= MANY_DIGITS:
        axis.axes.locator_params(axis=axis.axis_name, nbins=4)


def _log_ticks(axis: Any, scale: Scale) -> None:
    """Set ticks at round numbers of a logarithmic field."""
    low, *_, high = (float(edge) for edge in display_values(scale, scale.edges))
    ticks = round_ticks(*sorted((low, high)))
    axis.set_ticks(ticks, [tick_label(tick) for tick in ticks])
    axis.set_minor_locator(NullLocator())


@in_style
def field_map_figure(found: FieldMap) -> Figure:
    """Success rate, or median of a measure, over two fields, by robot.

    Where there are few cells, each has its value and the number of its flights written in it.

    Args:
        found: Values.
    """
    robots, columns = list(found.flights), min(SIDE, len(found.flights))
    lines = math.ceil(len(robots) / columns)
    figure = StyledFigure(figsize=(MAP[0] * columns + 0.9, MAP[1] * lines))
    grid = figure.subplots(lines, columns, sharex=True, sharey=True, squeeze=False)
    known = np.concatenate([values.ravel() for values in found.values.values()])
    unit = display_unit(found.measure.unit, known.tolist())
    image: Any = None
    for panel, look in zip(grid.flat, robot_styles(robots).items(), strict=False):
        values, flights = unit.factor * found.values[look[0]], found.flights[look[0]]
        image = _cells(panel, found, values, unit.factor * known[np.isfinite(known)])
        _write_cells(panel, found, image, values, flights)
        panel.set_facecolor(SHADE)
        chart = Chart(panel, label(found.x), label(found.y), look[1].label)
        panel.set_xlabel(wrapped_label(label(found.x), WIDEST_OF_MAP))
        x, y = np.meshgrid(_middles(found.x), _middles(found.y))
        head = measure_label(found.measure, unit)
        numbers = {head: values.ravel(), FLIGHTS: flights.ravel()}
        chart.record("", {chart.x: x.ravel(), chart.y: y.ravel(), **numbers})
        _map_ticks(panel.xaxis, found.x)
        _map_ticks(panel.yaxis, found.y)
    for axes in grid[:, 0]:
        axes.set_ylabel(wrapped_label(label(found.y), WIDEST_OF_MAP))
    for axes in list(grid.flat)[len(robots) :]:
        axes.set_visible(False)
    bar_look: dict[str, Any] = {"shrink": 0.95, "aspect": 26}
    if found.measure.name == SUCCESS:
        add_share_bar(figure, image, grid, SHARE, **bar_look)
    else:
        bar = figure.colorbar(image, ax=grid, pad=0.02, **bar_look)
        bar.set_label(f"Median {measure_label(found.measure, unit)}")
        bar.ax.grid(visible=False)
    return figure


def _cells(panel: Axes, found: FieldMap, values: Any, known: Any) -> Any:
    """Colour the cells of a robot: shares on their scale, a measure from its least to its most."""
    x, y = _edges(found.x), _edges(found.y)
    if found.measure.name == SUCCESS:
        return draw_shares(panel, x, y, values)
    low, high = (float(known.min()), float(known.max())) if len(known) else (0.0, 1.0)
    high = high if high > low else low + 1.0
    panel.grid(visible=False)
    return panel.pcolormesh(
        x, y, np.ma.masked_invalid(values), cmap=SCALE, vmin=low, vmax=high, edgecolors="white",
        linewidth=0.4,
    )  # fmt: skip


def _write_cells(panel: Axes, found: FieldMap, image: Any, values: Any, flights: Any) -> None:
    """Write the value and the number of flights in each cell, if there is room."""
    if max(values.shape) > WRITTEN:
        few, many = int(flights.min()), int(flights.max())
        panel.set_title(f"{few} to {many} flights in a cell", loc="right", fontsize=7)
        return
    size = 6.7 if len(found.flights) > 1 else 7.7  # a single map is one column wide in print
    x, y = (_centres(one) for one in (found.x, found.y))
    for (row, column), value in np.ndenumerate(values):
        count = f"n = {int(flights[row, column])}"
        place = float(image.norm(value)) if np.isfinite(value) else 1.0
        text = f"{_written(found, value)}\n{count}" if np.isfinite(value) else "–"
        panel.text(
            x[column], y[row], text, ha="center", va="center", size=size, linespacing=1.15,
            color=ink(place), clip_on=True,
        )  # fmt: skip


def _written(found: FieldMap, value: float) -> str:
    """Value of a cell: a share that is not quite 1 never reads as 1."""
    if found.measure.name != SUCCESS:
        return quantity_text(value)
    return f"{value:.2f}" if value >= 1.0 else f"{min(value, 0.99):.2f}"


def _centres(scale: Scale) -> Any:
    """Centres of cells as they are drawn; of a logarithmic axis those in the logarithm."""
    edges = np.asarray(_edges(scale), float)
    if scale.logarithmic:
        return np.sign(edges[1:]) * np.sqrt(edges[1:] * edges[:-1])
    return 0.5 * (edges[1:] + edges[:-1])


def _edges(scale: Scale) -> Any:
    """Bounds of cells: indices of levels, else values in the displayed unit."""
    if scale.labels:
        return np.arange(len(scale.labels) + 1) - 0.5
    return display_values(scale, scale.edges)


def _middles(scale: Scale) -> Any:
    """Centres of cells; words for levels."""
    if scale.labels:
        return _level_words(scale)
    edges = display_values(scale, scale.edges)
    return 0.5 * (edges[1:] + edges[:-1])


def _level_words(scale: Scale) -> tuple[str, ...]:
    """Labels of levels: words, or numbers in the displayed unit."""
    if scale.edges:
        return tuple(f"{value:.4g}" for value in display_values(scale, scale.edges))
    return scale.labels


def _map_ticks(axis: Any, scale: Scale) -> None:
    if not scale.labels:
        if scale.logarithmic:
            axis.axes.set(**{f"{axis.axis_name}scale": "log"})
            _log_ticks(axis, scale)
        elif axis.axis_name == "x":
            _few_ticks(axis, scale)
        return
    words = _level_words(scale)
    step = math.ceil(len(words) / 9)
    axis.set_ticks(range(0, len(words), step), words[::step])

"""Figures of campaigns: success over one field and over two."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullLocator

from springback.campaign.analysis.marginals import FieldMap, Marginal, Scale
from springback.interfaces.figures.chart import Chart, add_share_bar, draw_shares
from springback.interfaces.figures.style import StyledFigure, in_style
from springback.interfaces.output.robots import SHADE, RobotStyle, robot_styles

SHARE = "Share that succeeds [-]"
#: Panels side by side, and their size [in].
ABREAST, PANEL = 3, (2.5, 2.0)
#: Labels of levels are slanted if longer than this in total [characters] (chosen).
LONG = 22
#: Smallest number of ticks of a logarithmic axis, and largest number of labels (chosen).
ENOUGH, MOST_TICKS = 3, 5


def display_unit(unit: str) -> str:
    """Unit for display: degrees for angles."""
    return {"rad": "deg", "": "-"}.get(unit, unit).replace("^2", "²")


def display_values(scale: Scale, values: Any) -> Any:
    """Values in the displayed unit."""
    return np.degrees(values) if scale.unit == "rad" else np.asarray(values)


def label(scale: Scale) -> str:
    """Name of a field and its unit."""
    name = scale.name.replace("_", " ")
    return name if scale.labels and not scale.edges else f"{name} [{display_unit(scale.unit)}]"


@in_style
def marginals_figure(found: Sequence[Marginal]) -> Figure:
    """Success rate over each field, with Wilson intervals.

    Args:
        found: Marginals, one for each panel.
    """
    columns = min(ABREAST, len(found))
    lines = math.ceil(len(found) / columns)
    figure = StyledFigure(figsize=(PANEL[0] * columns + 0.5, PANEL[1] * lines + 0.5))
    grid = figure.subplots(lines, columns, sharey=True, squeeze=False)
    keys: dict[str, Any] = {}
    lowest = 1.0
    for axes, one in zip(grid.flat, found, strict=False):
        chart = Chart(axes, label(one.scale), SHARE)
        for robot, look in robot_styles(one.robots).items():
            cells = one.robots[robot]
            if cells:
                keys[look.label] = _line(chart, one, robot, look)
                lowest = min(lowest, *(cell.success.low or 0.0 for cell in cells))
        _ticks(axes, one.scale)
    bottom = max(-0.04, lowest - 0.06 * (1.0 - lowest) - 0.005)
    for axes in grid[:, 0]:
        axes.set_ylim(bottom, 1.0 + 0.06 * (1.0 - bottom))
    for axes in list(grid.flat)[len(found) :]:
        axes.set_visible(False)
    figure.legend(list(keys.values()), list(keys), loc="outside upper center", ncols=len(keys))
    return figure


def _line(chart: Chart, one: Marginal, robot: str, look: RobotStyle) -> Any:
    """One robot over one field: points with bars at levels, else a line in a band."""
    cells = one.robots[robot]
    x = display_values(one.scale, [cell.place for cell in cells])
    y, low, high = np.array(
        [(cell.success.value, cell.success.low, cell.success.high) for cell in cells], float
    ).T
    style = {**look.curve, "marker": look.marker}
    if not one.scale.labels:
        chart.band(f"{look.label}, 95 % interval", x, low, high, color=look.colour, alpha=0.18)
        return chart.curve(look.label, x, y, ms=3.2, **style)
    words = {}
    if not one.scale.edges:  # words, side by side
        names = list(one.robots)
        words = {chart.x: [one.scale.labels[int(place)] for place in x]}
        x = x + 0.14 * (names.index(robot) - 0.5 * (len(names) - 1))
        style["ls"] = "none"
    return chart.errorbars(
        look.label, x, y, low, high, columns=words, ms=4.0, capsize=2.0, elinewidth=0.9, **style
    )


def _ticks(axes: Axes, scale: Scale) -> None:
    axes.set_xlabel(label(scale))  # of words, too
    if scale.logarithmic:
        axes.set_xscale("log")
        _log_ticks(axes.xaxis, scale)
    if scale.labels and not scale.edges:
        long = sum(map(len, scale.labels)) > LONG
        slant: dict[str, Any] = {"rotation": 20, "ha": "right"} if long else {}
        axes.set_xticks(range(len(scale.labels)), list(scale.labels), **slant)
        axes.set_xlim(-0.6, len(scale.labels) - 0.4)
        axes.grid(visible=False, axis="x")
    elif scale.labels and len(scale.labels) <= 7:
        axes.set_xticks(display_values(scale, scale.edges))


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


def _log_ticks(axis: Any, scale: Scale) -> None:
    """Set ticks at round numbers of a logarithmic field."""
    low, *_, high = (float(edge) for edge in display_values(scale, scale.edges))
    ticks = round_ticks(*sorted((low, high)))
    axis.set_ticks(ticks, [tick_label(tick) for tick in ticks])
    axis.set_minor_locator(NullLocator())


@in_style
def field_map_figure(found: FieldMap) -> Figure:
    """Success rate over two fields, by robot.

    Args:
        found: Success rates.
    """
    robots = list(found.flights)
    figure = StyledFigure(figsize=(3.0 * len(robots) + 0.9, 3.0))
    axes = figure.subplots(1, len(robots), sharex=True, sharey=True, squeeze=False)[0]
    image: Any = None
    for panel, look in zip(axes, robot_styles(robots).items(), strict=True):
        shares = found.shares(look[0])
        image = draw_shares(panel, _edges(found.x), _edges(found.y), shares)
        panel.set_facecolor(SHADE)
        panel.set_xlabel(label(found.x))
        chart = Chart(panel, label(found.x), label(found.y), look[1].label)
        x, y = np.meshgrid(_middles(found.x), _middles(found.y))
        chart.record("", {chart.x: x.ravel(), chart.y: y.ravel(), SHARE: shares.ravel()})
        _map_ticks(panel.xaxis, found.x)
        _map_ticks(panel.yaxis, found.y)
    axes[0].set_ylabel(label(found.y))
    add_share_bar(figure, image, axes, SHARE, shrink=0.95, aspect=26)
    return figure


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
        return
    words = _level_words(scale)
    step = math.ceil(len(words) / 9)
    axis.set_ticks(range(0, len(words), step), words[::step])

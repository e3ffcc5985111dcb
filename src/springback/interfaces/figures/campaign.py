"""Figures of campaigns: success along each field, and over two."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullLocator

from springback.campaign.analysis.marginals import FieldMap, Marginal, Scale
from springback.interfaces.figures.envelope import ROBOTS, SCALE
from springback.interfaces.figures.style import BLUE, GREEN, PINK, RED, SHADE, StyledFigure, styled

#: Of robots in their order, beside those that have looks of their own.
LOOKS: dict[str, dict[str, Any]] = {
    "arq": {"color": BLUE, "marker": "o", "ls": "-"},
    "quad": {"color": RED, "marker": "s", "ls": (0, (5, 1.5))},
}
OTHERS: tuple[dict[str, Any], ...] = (
    {"color": GREEN, "marker": "^", "ls": (0, (5, 1.5, 1, 1.5))},
    {"color": PINK, "marker": "v", "ls": (0, (1.2, 1))},
)
#: Panels side by side, and their size [in].
ABREAST, PANEL = 3, (2.5, 2.0)
#: Labels of levels longer than this in all are written at a slant (chosen).
LONG = 22
#: Ticks along a logarithmic axis: so many are enough, and at most so many are written (chosen).
ENOUGH, MOST_TICKS = 3, 5


def looks(robots: Sequence[str]) -> dict[str, dict[str, Any]]:
    """Colour, marker and line of each robot."""
    free = iter(OTHERS * len(robots))
    return {robot: LOOKS.get(robot) or next(free) for robot in robots}


def shown_unit(unit: str) -> str:
    """As people read it: angles in degrees."""
    return {"rad": "deg", "": "-"}.get(unit, unit).replace("^2", "²")


def shown(scale: Scale, values: Any) -> Any:
    """Values in the shown unit."""
    return np.degrees(values) if scale.unit == "rad" else np.asarray(values)


def label(scale: Scale) -> str:
    """Name of a field and its unit."""
    name = scale.name.replace("_", " ")
    return name if scale.labels and not scale.edges else f"{name} [{shown_unit(scale.unit)}]"


@styled
def marginals_figure(found: Sequence[Marginal]) -> Figure:
    """Share of flights that succeed along each field, with Wilson's intervals.

    Args:
        found: One for each panel.
    """
    columns = min(ABREAST, len(found))
    lines = math.ceil(len(found) / columns)
    figure = StyledFigure(figsize=(PANEL[0] * columns + 0.5, PANEL[1] * lines + 0.5))
    grid = figure.subplots(lines, columns, sharey=True, squeeze=False)
    keys: dict[str, Any] = {}
    lowest = 1.0
    for axes, one in zip(grid.flat, found, strict=False):
        for robot, look in looks(list(one.robots)).items():
            cells = one.robots[robot]
            if cells:
                keys[ROBOTS.get(robot, robot)] = _line(axes, one, robot, look)
                lowest = min(lowest, *(cell.success.low or 0.0 for cell in cells))
        _ticks(axes, one.scale)
    bottom = max(-0.04, lowest - 0.06 * (1.0 - lowest) - 0.005)
    for axes in grid[:, 0]:
        axes.set_ylabel("Share that succeeds [-]")
        axes.set_ylim(bottom, 1.0 + 0.06 * (1.0 - bottom))
    for axes in list(grid.flat)[len(found) :]:
        axes.set_visible(False)
    figure.legend(list(keys.values()), list(keys), loc="outside upper center", ncols=len(keys))
    return figure


def _line(axes: Axes, one: Marginal, robot: str, look: dict[str, Any]) -> Any:
    """One robot along one field: points with bars at levels, else a line in a band."""
    cells = one.robots[robot]
    x = shown(one.scale, [cell.place for cell in cells])
    y = np.array([cell.success.value for cell in cells], float)
    low = np.array([cell.success.low for cell in cells], float)
    high = np.array([cell.success.high for cell in cells], float)
    if one.scale.labels:
        names = list(one.robots)
        if not one.scale.edges:  # words, side by side
            x = x + 0.14 * (names.index(robot) - 0.5 * (len(names) - 1))
        reach = np.maximum(0.0, [y - low, high - y])
        style = {**look, "ls": "none"} if not one.scale.edges else look
        return axes.errorbar(
            x, y, yerr=reach, ms=4.0, capsize=2.0, elinewidth=0.9, label=ROBOTS.get(robot, robot),
            **style,
        )  # fmt: skip
    name = ROBOTS.get(robot, robot)
    bounds = f"_{name}, 95 % interval"
    axes.fill_between(x, low, high, color=look["color"], alpha=0.18, lw=0.0, label=bounds)
    return axes.plot(x, y, ms=3.2, label=name, **look)[0]


def _ticks(axes: Axes, scale: Scale) -> None:
    axes.set_xlabel(label(scale))
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
        axes.set_xticks(shown(scale, scale.edges))


def round_ticks(low: float, high: float) -> list[float]:
    """A few round numbers between two of the same sign, for a logarithmic axis.

    They are powers of ten where there are enough, else 1, 2 and 5 times these; if a range holds
    fewer than two of those, its ends.
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


def written(tick: float) -> str:
    """A tick in plain digits, or as a power of ten where those would be many."""
    if 1e-3 <= abs(tick) < 1e5:
        return f"{tick:.3g}" if abs(tick) < 1e3 else f"{tick:.0f}"
    power = math.floor(math.log10(abs(tick)))
    digits = f"{tick / 10.0**power:.3g}"
    return f"$10^{{{power}}}$" if digits == "1" else f"${digits} \\cdot 10^{{{power}}}$"


def _log_ticks(axis: Any, scale: Scale) -> None:
    """Round numbers along a logarithmic field."""
    low, *_, high = (float(edge) for edge in shown(scale, scale.edges))
    ticks = round_ticks(*sorted((low, high)))
    axis.set_ticks(ticks, [written(tick) for tick in ticks])
    axis.set_minor_locator(NullLocator())


@styled
def field_map_figure(found: FieldMap) -> Figure:
    """Share of flights that succeed over two fields, robot by robot.

    Args:
        found: The shares.
    """
    robots = list(found.flights)
    figure = StyledFigure(figsize=(3.0 * len(robots) + 0.9, 3.0))
    axes = figure.subplots(1, len(robots), sharex=True, sharey=True, squeeze=False)[0]
    image: Any = None
    for panel, robot in zip(axes, robots, strict=True):
        shares = np.ma.masked_invalid(found.shares(robot))
        image = panel.pcolormesh(
            _edges(found.x), _edges(found.y), shares, cmap=SCALE, vmin=0.0, vmax=1.0,
            edgecolors="white", linewidth=0.4,
        )  # fmt: skip
        panel.set_facecolor(SHADE)
        panel.grid(visible=False)
        panel.set_title(ROBOTS.get(robot, robot))
        panel.set_xlabel(label(found.x))
        _map_ticks(panel.xaxis, found.x)
        _map_ticks(panel.yaxis, found.y)
    axes[0].set_ylabel(label(found.y))
    bar = figure.colorbar(image, ax=axes, shrink=0.95, pad=0.02, aspect=26)
    bar.set_label("Share that succeeds [-]")
    bar.ax.grid(visible=False)
    return figure


def _edges(scale: Scale) -> Any:
    """Bounds of cells: of levels by their number, else in the shown unit."""
    if scale.labels:
        return np.arange(len(scale.labels) + 1) - 0.5
    return shown(scale, scale.edges)


def _map_ticks(axis: Any, scale: Scale) -> None:
    if not scale.labels:
        if scale.logarithmic:
            axis.axes.set(**{f"{axis.axis_name}scale": "log"})
            _log_ticks(axis, scale)
        return
    words = scale.labels
    if scale.edges:
        words = tuple(f"{value:.4g}" for value in shown(scale, scale.edges))
    step = math.ceil(len(words) / 9)
    axis.set_ticks(range(0, len(words), step), words[::step])

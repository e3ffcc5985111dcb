"""Figures of a campaign's measures: distribution, and sensitivity to the fields."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from springback.campaign.analysis.distribution import MeasureDistribution
from springback.campaign.analysis.sensitivity import Sensitivity
from springback.interfaces.figures.campaign import FLIGHTS, in_words, measure_label
from springback.interfaces.figures.chart import Chart
from springback.interfaces.figures.style import StyledFigure, in_style
from springback.interfaces.output.quantities import display_unit
from springback.interfaces.output.robots import robot_styles
from springback.intervals import CONFIDENCE

#: Width of a letter of a field's name [in] (chosen).
LETTER = 0.075
#: Fewest and most bins of a histogram, and most points of a curve (chosen).
BINS, POINTS = (8, 48), 400


@in_style
def distribution_figure(found: MeasureDistribution) -> Figure:
    """Histogram of a measure in numbers of flights, and its cumulative distribution, by robot.

    The band of the latter holds the whole curve at 95 %, by the inequality of Dvoretzky, Kiefer
    and Wolfowitz with Massart's constant (1990, *Annals of Probability* 18, 1269-1283).

    Args:
        found: The measure's values.
    """
    figure = StyledFigure(figsize=(7.0, 2.7))
    left, right = figure.subplots(1, 2)
    every = np.concatenate(list(found.values.values()))
    unit = display_unit(found.measure.unit, (every.min(), every.max()))
    head = measure_label(found.measure, unit)
    bars, curve = Chart(left, head, FLIGHTS), Chart(right, head, "Share of flights below [-]")
    count = int(np.clip(math.ceil(2.0 * len(every) ** (1.0 / 3.0)), *BINS))  # Rice's rule
    edges = np.histogram_bin_edges(unit.factor * every, count)
    looks = robot_styles(found.values)
    for robot, values in found.values.items():
        look = looks[robot]
        if not len(values):
            continue
        shown = unit.factor * values
        heights, _ = np.histogram(shown, edges)
        name = f"{look.label}, n = {len(values)}"
        style: dict[str, Any] = {"color": look.colour, "lw": 1.4}
        left.stairs(heights, edges, label=name, ls=look.line, **style)
        left.stairs(heights, edges, fill=True, color=look.colour, alpha=0.12)
        bars.record(look.label, {bars.x: 0.5 * (edges[1:] + edges[:-1]), FLIGHTS: heights})
        at = np.unique(np.linspace(0, len(shown) - 1, min(POINTS, len(shown))).astype(int))
        share, reach = (at + 1.0) / len(shown), _reach(len(shown))
        low, high = np.clip(share - reach, 0.0, 1.0), np.clip(share + reach, 0.0, 1.0)
        curve.band(f"{look.label}, 95 % band", shown[at], low, high, color=look.colour, alpha=0.15)
        curve.curve(look.label, shown[at], share, drawstyle="steps-post", **look.curve)
    right.set_ylim(-0.02, 1.02)
    handles, names = left.get_legend_handles_labels()
    figure.legend(handles, names, loc="outside upper center", ncols=len(names))
    return figure


def _reach(count: int) -> float:
    """Half the width of the band around a cumulative distribution."""
    return math.sqrt(math.log(2.0 / (1.0 - CONFIDENCE)) / (2.0 * count))


@in_style
def sensitivity_figure(found: Sensitivity) -> Figure:
    """First-order indices of a measure with their intervals, a row for each field.

    Args:
        found: Indices, of at least one robot.
    """
    names = found.ranking()[::-1]
    labels = [in_words(name) for name in names]
    width = max(5.3, 4.3 + LETTER * max(map(len, labels)))  # the rows' names are beside 4.3 in
    figure = StyledFigure(figsize=(width, 0.9 + 0.32 * len(names)))
    axes = figure.subplots()
    chart = Chart(axes, "Share of the variance that the field alone explains [-]", "field")
    looks = robot_styles(found.robots)
    for k, (robot, indices) in enumerate(found.robots.items()):
        look = looks[robot]
        value, low, high = np.array([indices[name] for name in names], float).T
        y = np.arange(len(names)) - 0.2 * (k - 0.5 * (len(found.robots) - 1))
        chart.errorbars(
            look.label, value, y, low, high, across=True, columns={chart.y: names}, ls="none",
            color=look.colour, marker=look.marker, ms=4.5, capsize=2.0, elinewidth=1.0,
        )  # fmt: skip
    axes.set_yticks(range(len(names)), labels)
    axes.set(xlim=(-0.02, 1.02), ylim=(-0.6, len(names) - 0.4))
    axes.grid(visible=False, axis="y")
    figure.legend(loc="outside upper center", ncols=len(found.robots))
    return figure

"""Figures of the ablation: effect of each change on each test, and ranges of parameters."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from springback.interfaces.figures.chart import Chart
from springback.interfaces.figures.style import WIDTH, StyledFigure, in_style
from springback.interfaces.output.robots import GREY, ROBOTS
from springback.studies.ablation import RANGES, VARIANTS, WhyResults
from springback.studies.ablation import ROBOTS as FLOWN
from springback.studies.ablation_pairs import CHANGES, PairResults
from springback.studies.run_ups import CONDITIONS

TESTS = "Pitch at contact [deg], speed [m/s]"
SHARE = "Share of trials that succeed [-]"


def _test(pitch: float, speed: float) -> str:
    return f"{pitch:+.0f}°\n{speed:g}" if pitch else f"0°\n{speed:g}"


def _small(ax: Axes, title: str, xlabel: str) -> None:
    """Shrink the words of a heat map."""
    ax.set_title(title, size=9)
    ax.set_xlabel(xlabel, size=8)


@in_style
def ablation_figure(results: WhyResults) -> Figure:
    """Successes of each test by robot and variant."""
    rows = [v for v in VARIANTS if any(results.successes(v, robot) for robot in FLOWN)]
    figure = StyledFigure(figsize=(WIDTH * 1.75, 0.24 * len(rows) + 1.1), layout="constrained")
    for ax, robot in zip(figure.subplots(1, 2, sharey=True), FLOWN, strict=True):
        cells = [[results.successes(v, robot).get(test) for test in CONDITIONS] for v in rows]
        shares = [[c.successes / c.trials if c else np.nan for c in row] for row in cells]
        words = [
            [str(c.successes) if c else "–" if robot in v.robots else "" for c in row]
            for v, row in zip(rows, cells, strict=True)
        ]
        chart = Chart(ax, TESTS, "variant", ROBOTS[robot].label)
        names = [f"{v.cause}: {v.name}" for v in rows]
        chart.heat_map(SHARE, shares, words, names, [_test(*test) for test in CONDITIONS])
        _small(ax, f"{chart.panel}: successes (– unflown)", TESTS)
        for i in range(1, len(rows)):
            if rows[i].cause != rows[i - 1].cause:
                ax.axhline(i - 0.5, color=GREY, lw=0.6)
    return figure


@in_style
def ranges_figure(results: WhyResults) -> Figure:
    """Success rate over each parameter that the paper does not print."""
    figure = StyledFigure(figsize=(WIDTH * 1.5, 5.6), layout="constrained")
    grid = figure.subplots(-(-len(RANGES) // 2), 2, sharey=True)
    for ax, one in zip(grid.flat, RANGES, strict=False):
        unit = one.unit.replace("^2", "²") or "-"
        chart = Chart(ax, f"{one.name} [{unit}]", "Share [-]")
        for robot in FLOWN:
            label, colour, line, marker = ROBOTS[robot]
            shares = [results.share(one, value, robot) for value in one.values]
            chart.curve(label, one.values, shares, ms=3.5, color=colour, ls=line, marker=marker)
        chart.vline("default", one.default, ls=(0, (1.2, 1.2)))
        ax.set_ylim(-0.05, 1.08)
        ax.set_yticks([0.0, 0.5, 1.0])
    for ax in list(grid.flat)[len(RANGES) :]:
        ax.set_visible(False)
    grid.flat[0].legend(loc="lower left")
    return figure


@in_style
def pairs_figure(results: PairResults) -> Figure:
    """Recovered trials by pair of changes at the paper's highest speed; single ones at the edge."""
    causes, names = [c.cause for c in CHANGES], [c.name for c in CHANGES]
    figure = StyledFigure(figsize=(WIDTH * 1.75, 0.3 * len(names) + 2.0), layout="constrained")
    for ax, robot in zip(figure.subplots(1, 2, sharey=True), FLOWN, strict=True):
        pairs = [
            [results.at(one, other, robot) if j <= i else None for j, other in enumerate(causes)]
            for i, one in enumerate(causes)
        ]
        shares = [[np.nan if p is None else p.share for p in row] for row in pairs]
        words = [["" if p is None else str(p.successes) for p in row] for row in pairs]
        chart = Chart(ax, "second change", "first change", ROBOTS[robot].label)
        chart.heat_map(SHARE, shares, words, names, causes)
        ax.set_xticks(range(len(causes)), causes, size=8, rotation=45, ha="right")
        base = results.at("none", "none", robot)
        unchanged = f"; unchanged {base.successes}/{base.trials}" if base else ""
        _small(ax, chart.panel + unchanged, "and, too")
    return figure

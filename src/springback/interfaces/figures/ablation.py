"""Figures of the ablation: which change moves which test, and how far a number may move."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure

from springback.interfaces.figures.style import BLUE, GREY, INK, RED, WIDTH, StyledFigure, styled
from springback.studies.ablation import RANGES, ROBOTS, VARIANTS, Range, WhyResults
from springback.studies.ablation_pairs import CHANGES, PairResults
from springback.studies.run_ups import CONDITIONS

TITLES = {"arq": "ARQ", "quad": "Quad"}
#: Light to dark with failures: colours of one hue, told apart in grey, too.
SHADES = ListedColormap(np.linspace((0.55, 0.16, 0.05), (0.97, 0.97, 0.97), 11).tolist())
LOOKS: dict[str, dict[str, Any]] = {
    "arq": {"color": BLUE, "marker": "o", "ls": "-"},
    "quad": {"color": RED, "marker": "s", "ls": (0, (5, 1.5))},
}


def _test(pitch: float, speed: float) -> str:
    return f"{pitch:+.0f}°\n{speed:g}" if pitch else f"0°\n{speed:g}"


@styled
def ablation_figure(results: WhyResults) -> Figure:
    """Successes of each test, robot by robot, variant by variant."""
    rows = [v for v in VARIANTS if any(results.successes(v, robot) for robot in ROBOTS)]
    figure = StyledFigure(figsize=(WIDTH * 1.75, 0.24 * len(rows) + 1.1), layout="constrained")
    panels = figure.subplots(1, 2, sharey=True)
    for axes, robot in zip(panels, ROBOTS, strict=True):
        share = np.full((len(rows), len(CONDITIONS)), np.nan)
        for i, variant in enumerate(rows):
            cells = results.successes(variant, robot)
            for j, test in enumerate(CONDITIONS):
                if test in cells:
                    share[i, j] = cells[test].successes / cells[test].trials
        image = axes.imshow(share, cmap=SHADES, vmin=0.0, vmax=1.0, aspect="auto")
        image.set_label("_Share of trials that succeed [-]")
        for (i, j), value in np.ndenumerate(share):
            cell = results.successes(rows[i], robot).get(CONDITIONS[j])
            flown = robot in rows[i].robots
            text = str(cell.successes) if cell else "–" if flown else ""
            dark = bool(cell) and value < 0.5
            axes.text(j, i, text, ha="center", va="center", size=8,
                      color="white" if dark else INK)  # fmt: skip
        axes.set_xticks(range(len(CONDITIONS)), [_test(*test) for test in CONDITIONS], size=8)
        axes.set_title(f"{TITLES[robot]}: successes (– unflown)", size=9)
        axes.set_xlabel("Pitch at contact [deg], speed [m/s]", size=8)
        axes.tick_params(length=0)
        axes.grid(visible=False)
        for edge in axes.spines.values():
            edge.set_visible(False)
        for i in range(1, len(rows)):
            if rows[i].cause != rows[i - 1].cause:
                axes.axhline(i - 0.5, color=GREY, lw=0.6)
    labels = [f"{v.cause}: {v.name}" for v in rows]
    panels[0].set_yticks(range(len(rows)), labels, size=8)
    return figure


def _values(one: Range) -> np.ndarray[Any, np.dtype[np.float64]]:
    return np.array(one.values)


@styled
def ranges_figure(results: WhyResults) -> Figure:
    """Share of all trials that succeed along each number that the paper does not print."""
    figure = StyledFigure(figsize=(WIDTH * 1.5, 5.6), layout="constrained")
    columns = 2
    grid = figure.subplots(-(-len(RANGES) // columns), columns, sharey=True)
    for axes, one in zip(grid.flat, RANGES, strict=False):
        for robot in ROBOTS:
            shares = [results.share(one, value, robot) for value in one.values]
            axes.plot(_values(one), shares, label=TITLES[robot], ms=3.5, **LOOKS[robot])
        axes.axvline(one.default, color=GREY, lw=0.9, ls=(0, (1.2, 1.2)), label="_default")
        shown = one.unit.replace("^2", "²")
        unit = f" [{shown or '-'}]"
        axes.set_xlabel(f"{one.name}{unit}")
        axes.set_ylim(-0.05, 1.08)
        axes.set_yticks([0.0, 0.5, 1.0])
    for axes in grid[:, 0]:
        axes.set_ylabel("Share [-]")
    for axes in list(grid.flat)[len(RANGES) :]:
        axes.set_visible(False)
    grid.flat[0].legend(loc="lower left")
    return figure


@styled
def pairs_figure(results: PairResults) -> Figure:
    """Recovered trials under every two changes at the paper's fastest; one change on the edge."""
    names = [change.cause for change in CHANGES]
    figure = StyledFigure(figsize=(WIDTH * 1.75, 0.3 * len(names) + 2.0), layout="constrained")
    for axes, robot in zip(figure.subplots(1, 2, sharey=True), ROBOTS, strict=True):
        share = np.full((len(names), len(names)), np.nan)
        for i, first in enumerate(names):
            for j, second in enumerate(names[: i + 1]):
                pair = results.at(first, second, robot)
                if pair is not None:
                    share[i, j] = pair.share
                    axes.text(j, i, str(pair.successes), ha="center", va="center", size=8,
                              color="white" if pair.share < 0.5 else INK)  # fmt: skip
        image = axes.imshow(share, cmap=SHADES, vmin=0.0, vmax=1.0, aspect="auto")
        image.set_label("_Share of trials that succeed [-]")
        base = results.at("none", "none", robot)
        told = f"; unchanged {base.successes}/{base.trials}" if base else ""
        axes.set_title(f"{TITLES[robot]}{told}", size=9)
        axes.set_xticks(range(len(names)), names, size=8, rotation=45, ha="right")
        axes.set_yticks(range(len(names)), [change.name for change in CHANGES], size=8)
        axes.set_xlabel("and, too", size=8)
        axes.tick_params(length=0)
        axes.grid(visible=False)
        for edge in axes.spines.values():
            edge.set_visible(False)
    return figure

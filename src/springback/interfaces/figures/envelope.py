"""Figure of the resilience envelope: maps of success of the robots, side by side."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from matplotlib import patheffects
from matplotlib.axes import Axes
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Rectangle

from springback.campaign.analysis.envelope import LEVEL, Axis, Envelope, Place
from springback.campaign.analysis.intervals import Values
from springback.interfaces.figures.style import StyledFigure, in_style
from springback.interfaces.output.robots import GREY, INK, RED, SHADE
from springback.studies.run_ups import CONDITIONS

#: Printed result of a robot's test at a pitch [deg] and a speed [m/s]: a key of `PRINTED_MARKS`,
#: or empty.
Printed = Callable[[str, float, float], str]

ROBOTS = {"quad": "Quad", "arq": "ARQ"}
#: Axis labels of parameters whose names need an explanation.
MEANINGS = {
    "speed": "Speed at contact [m/s]",
    "pitch": "Pitch at contact, nose down [deg]",
}
#: Marks of printed results.
PRINTED_MARKS = {
    "all succeed": "o", "“fairly good”": "D", "success rate “drops”": "v", "none succeed": "X",
}  # fmt: skip
#: From failure to success, dark to light, so that the order is visible in black and white.
SCALE = LinearSegmentedColormap.from_list("success", ["#3B1F4F", "#33638D", "#6FB7C4", "#F4F7E8"])
#: Largest number of cells that show their number of successes (chosen: more are too small).
NUMBERED = 200
#: Largest number of values of an axis that all have a tick (chosen).
LABELLED = 9
PANEL = (3.5, 3.5)
"""Size of a robot's panel [in]."""


@in_style
def map_figure(envelope: Envelope, printed: Printed) -> Figure:
    """Success rate over both axes, its 95 % contour, and the paper's tests.

    The contour is interpolated linearly between cell centres, and ends at cells that were not
    flown.

    Args:
        envelope: Envelope of one or more robots.
        printed: Function that returns the paper's result of a test.
    """
    count = len(envelope.robots)
    figure = StyledFigure(figsize=(PANEL[0] * count + 0.9, PANEL[1] + 0.7))
    axes = figure.subplots(1, count, sharex=True, sharey=True, squeeze=False)[0]
    image: Any = None
    keys: dict[str, Line2D | Patch] = {}
    for ax, robot in zip(axes, envelope.robots, strict=True):
        image = _cells(ax, envelope, robot)
        keys |= _line(ax, envelope, robot) | _hatch_infeasible(ax, envelope, robot)
        keys |= _tests(ax, envelope, robot, printed)
        ax.set_title(ROBOTS.get(robot, robot))
        ax.set_xlabel(_meaning(envelope.x))
        if len(envelope.x.values) <= LABELLED:
            ax.set_xticks(envelope.x.values)
        if len(envelope.y.values) <= LABELLED:
            ax.set_yticks(envelope.y.values)
    axes[0].set_ylabel(_meaning(envelope.y))
    bar = figure.colorbar(image, ax=axes, shrink=0.9, pad=0.02, aspect=28)
    bar.set_label("Share of trials that succeed [-]")
    bar.ax.axhline(LEVEL, color=RED, lw=1.8)
    bar.ax.grid(visible=False)
    order = sorted(keys, key=lambda key: key.startswith("paper"))
    figure.legend(
        [keys[key] for key in order], order, loc="outside lower center", ncols=3 if count > 1 else 2
    )
    return figure


def _meaning(axis: Axis) -> str:
    return MEANINGS.get(axis.name, axis.label)


def edges(centres: Sequence[float]) -> Values:
    """Bounds of cells halfway between their centres."""
    v = np.asarray(centres, float)
    between = 0.5 * (v[1:] + v[:-1])
    return np.array([2.0 * v[0] - between[0], *between, 2.0 * v[-1] - between[-1]])


def _cells(ax: Axes, envelope: Envelope, robot: str) -> Any:
    shares, x, y = envelope.shares(robot), envelope.x.values, envelope.y.values
    image = ax.pcolormesh(
        edges(x), edges(y), np.ma.masked_invalid(shares), cmap=SCALE, vmin=0.0, vmax=1.0,
        edgecolors="white", linewidth=0.4,
    )  # fmt: skip
    ax.grid(visible=False)
    if shares.size <= NUMBERED:
        across, up = 0.42 * (x[1] - x[0]), 0.4 * (y[1] - y[0])
        for row, column in np.argwhere(np.isfinite(shares)):
            cell = envelope.cells[Place(robot, int(column), int(row))]
            ax.text(
                x[column] - abs(across), y[row] - abs(up), str(cell.successes), fontsize=7.5,
                ha="left", va="bottom", color="white" if shares[row, column] < 0.6 else INK,
            )  # fmt: skip
    ax.set_xlim(*sorted(edges(x)[[0, -1]]))
    ax.set_ylim(*sorted(edges(y)[[0, -1]]))
    return image


def _line(ax: Axes, envelope: Envelope, robot: str) -> dict[str, Line2D | Patch]:
    """Draw the contour of the level between cell centres."""
    key = Line2D([], [], color=RED, lw=1.8)
    shares = envelope.shares(robot)
    known = shares[np.isfinite(shares)]
    if known.size and known.min() < LEVEL <= known.max():
        ax.contour(
            envelope.x.values, envelope.y.values, np.ma.masked_invalid(shares), levels=[LEVEL],
            colors=[RED], linewidths=1.8,
        ).set_path_effects([patheffects.withStroke(linewidth=3.2, foreground="white")])  # fmt: skip
    return {f"{100.0 * LEVEL:g} % succeed": key}


def _hatch_infeasible(ax: Axes, envelope: Envelope, robot: str) -> dict[str, Line2D | Patch]:
    """Hatch cells that were not flown."""
    missing = np.argwhere(np.isnan(envelope.shares(robot)))
    if not len(missing):
        return {}
    look: dict[str, Any] = {
        "facecolor": SHADE, "hatch": "////", "edgecolor": GREY, "linewidth": 0.0,
    }  # fmt: skip
    x, y = edges(envelope.x.values), edges(envelope.y.values)
    for row, column in missing:
        size = (x[column + 1] - x[column], y[row + 1] - y[row])
        ax.add_patch(Rectangle((x[column], y[row]), *size, zorder=0.5, **look))
    return {"not flown": Patch(**look)}


def _tests(ax: Axes, envelope: Envelope, robot: str, printed: Printed) -> dict[str, Line2D | Patch]:
    """Mark the paper's tests if the axes are speed and pitch."""
    names = (envelope.x.name, envelope.y.name)
    if set(names) != {"speed", "pitch"}:
        return {}
    keys: dict[str, Line2D | Patch] = {}
    for pitch, speed in CONDITIONS:
        known = printed(robot, pitch, speed)
        if not known:
            continue
        look: dict[str, Any] = {
            "marker": PRINTED_MARKS[known], "ls": "none", "ms": 6.5, "mfc": "white", "mec": INK,
            "mew": 1.1,
        }  # fmt: skip
        at = (speed, pitch) if names[0] == "speed" else (pitch, speed)
        (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
        if left <= at[0] <= right and bottom <= at[1] <= top:
            ax.plot(*at, zorder=4, **look)
            keys[f"paper: {known}"] = Line2D([], [], **look)
    return keys

"""Figure of the resilience envelope: maps of success of the robots, side by side."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from matplotlib import patheffects
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from springback.campaign.analysis.envelope import LEVEL, Axis, CellIndex, Envelope
from springback.interfaces.figures.chart import (
    Chart,
    add_share_bar,
    draw_shares,
    ink,
    share_place,
)
from springback.interfaces.figures.style import StyledFigure, in_style
from springback.interfaces.output.robots import GREY, INK, RED, SHADE, robot_label
from springback.intervals import Values
from springback.studies.run_ups import CONDITIONS

#: Printed result of a robot's test at a pitch [deg] and a speed [m/s]: a key of `PRINTED_MARKS`,
#: or empty.
Printed = Callable[[str, float, float], str]

#: Axis labels of parameters whose names need an explanation.
MEANINGS = {
    "speed": "Speed at contact [m/s]",
    "pitch": "Pitch at contact, nose down [deg]",
}
#: Marks of printed results.
PRINTED_MARKS = {
    "all succeed": "o", "“fairly good”": "D", "success rate “drops”": "v", "none succeed": "X",
}  # fmt: skip
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
    figure.table += envelope.rows()
    axes = figure.subplots(1, count, sharex=True, sharey=True, squeeze=False)[0]
    keys: dict[str, Any] = {}
    for ax, robot in zip(axes, envelope.robots, strict=True):
        chart = Chart(ax, _meaning(envelope.x), _meaning(envelope.y), robot_label(robot))
        mesh = _draw_cells(ax, envelope, robot)
        _draw_line(chart, envelope, robot)
        _hatch(ax, envelope, robot)
        _draw_tests(ax, envelope, robot, printed)
        handles, names = ax.get_legend_handles_labels()
        keys |= dict(zip(names, handles, strict=True))
        if len(envelope.x.values) <= LABELLED:
            ax.set_xticks(envelope.x.values)
        if len(envelope.y.values) <= LABELLED:
            ax.set_yticks(envelope.y.values)
    bar = add_share_bar(
        figure, mesh, axes, "Share of trials that succeed [-]", shrink=0.9, aspect=28
    )
    bar.axhline(LEVEL, color=RED, lw=1.8)
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


def _draw_cells(ax: Axes, envelope: Envelope, robot: str) -> Any:
    """Draw cells, and the successes in each if there are few."""
    shares, x, y = envelope.shares(robot), envelope.x.values, envelope.y.values
    mesh = draw_shares(ax, edges(x), edges(y), shares)
    if shares.size <= NUMBERED:
        across, up = 0.42 * (x[1] - x[0]), 0.4 * (y[1] - y[0])
        for row, column in np.argwhere(np.isfinite(shares)):
            cell = envelope.cells[CellIndex(robot, int(column), int(row))]
            ax.text(
                x[column] - abs(across), y[row] - abs(up), str(cell.successes), fontsize=7.5,
                ha="left", va="bottom", color=ink(share_place(shares[row, column])),
            )  # fmt: skip
    ax.set_xlim(*sorted(edges(x)[[0, -1]]))
    ax.set_ylim(*sorted(edges(y)[[0, -1]]))
    return mesh


def _draw_line(chart: Chart, envelope: Envelope, robot: str) -> None:
    """Draw the contour of the level between cell centres."""
    chart.key(f"{100.0 * LEVEL:g} % succeed", color=RED, lw=1.8)
    shares = envelope.shares(robot)
    known = shares[np.isfinite(shares)]
    if known.size and known.min() < LEVEL <= known.max():
        chart.ax.contour(
            envelope.x.values, envelope.y.values, np.ma.masked_invalid(shares), levels=[LEVEL],
            colors=[RED], linewidths=1.8,
        ).set_path_effects([patheffects.withStroke(linewidth=3.2, foreground="white")])  # fmt: skip


def _hatch(ax: Axes, envelope: Envelope, robot: str) -> None:
    """Hatch cells that were not flown."""
    x, y = edges(envelope.x.values), edges(envelope.y.values)
    for row, column in np.argwhere(np.isnan(envelope.shares(robot))):
        size = (x[column + 1] - x[column], y[row + 1] - y[row])
        ax.add_patch(
            Rectangle(
                (x[column], y[row]), *size, label="not flown", zorder=0.5, facecolor=SHADE,
                hatch="////", edgecolor=GREY, linewidth=0.0,
            )
        )  # fmt: skip


def _draw_tests(ax: Axes, envelope: Envelope, robot: str, printed: Printed) -> None:
    """Draw the paper's tests, where the axes are speed and pitch."""
    names = (envelope.x.name, envelope.y.name)
    (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
    for pitch, speed in CONDITIONS if set(names) == {"speed", "pitch"} else ():
        at = (speed, pitch) if names[0] == "speed" else (pitch, speed)
        known = printed(robot, pitch, speed)
        if known and left <= at[0] <= right and bottom <= at[1] <= top:
            ax.plot(
                *at, zorder=4, marker=PRINTED_MARKS[known], ls="none", ms=6.5, mfc="white",
                mec=INK, mew=1.1, label=f"paper: {known}",
            )  # fmt: skip

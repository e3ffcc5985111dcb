"""Figures of recordings beside predictions."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import cycle

import numpy as np
from matplotlib.figure import Figure

from springback.identification.replays.errors import BEYOND, ChannelErrors
from springback.interfaces.figures.chart import AREA, Chart
from springback.interfaces.figures.style import LOOKS, WIDTH, StyledFigure, in_style
from springback.interfaces.output.robots import BLUE, INK, ORANGE
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ARM_LENGTH,
    ATTITUDE,
    POSITION,
    SPECIFIC_FORCE,
    VELOCITY,
)
from springback.studies.recordings.impulse_predictions import WANTED, ImpactPredictions

#: Errors that are drawn: their names, words, colours and markers.
ERRORS = (
    ("at_contact", "normal velocity at the contact point", BLUE, "o"),
    ("spin", "spin", ORANGE, "s"),
)
#: Rows of an overlay: labels, units that are shown, and their factors.
OVERLAID = {
    POSITION: ("Position", "mm", 1e3),
    VELOCITY: ("Velocity", "m/s", 1.0),
    ATTITUDE: ("Turn", "deg", np.degrees(1.0)),
    ANGULAR_VELOCITY: ("Angular velocity", "rad/s", 1.0),
    SPECIFIC_FORCE: ("Specific force", "m/s²", 1.0),
    ARM_LENGTH: ("Arm length", "mm", 1e3),
}
#: Size of a recorded sample, and height of a row [in] (chosen).
DOT, ROW = 2.0, 1.55


@in_style
def impacts_figure(found: ImpactPredictions) -> Figure:
    """Median errors of each model over the impacts that were not fitted on."""
    figure = StyledFigure(figsize=(WIDTH, 2.9), layout="constrained")
    chart = Chart(figure.subplots(), "Median error, of what was measured [%]", "Model")
    names, places = [row.model for row in found.rest], range(len(found.rest))
    for name, words, colour, marker in ERRORS:
        medians = [100.0 * getattr(row, name)[0] for row in found.rest]
        chart.curve(words, medians, list(places), color=colour, marker=marker, ms=5, ls="none")
        chart.vline(
            f"wanted: {words}", 100.0 * WANTED[name], color=colour, ls=(0, (1.2, 1.2)), lw=1.0
        )
    chart.ax.set_yticks(list(places), names)
    chart.ax.set_ylim(len(names) - 0.5, -0.5)
    chart.ax.set_xscale("log")
    chart.ax.set_xticks([2, 5, 10, 20, 50, 100], ["2", "5", "10", "20", "50", "100"])
    chart.ax.axhline(0.5, color=INK, lw=0.5)
    chart.ax.axhline(len(names) - 1.5, color=INK, lw=0.5)
    figure.legend(*chart.ax.get_legend_handles_labels(), loc="outside upper center", ncols=2)
    return figure


@in_style
def overlay_figure(
    channels: Sequence[ChannelErrors], touch: float, contact: float, title: str
) -> Figure:
    """Recorded samples as dots, predictions as lines; beside them their difference.

    The band about a difference's zero is twice the uncertainty: of samples, start, clocks and
    biases.  Positions are from that at touch, attitudes turns since the start.

    Args:
        channels: Of a replay.
        touch: Recorded touch, from the begin of the replay [s].
        contact: Recorded duration of the contact [s].
        title: Above it.
    """
    order = list(OVERLAID)
    shown = sorted(channels, key=lambda one: order.index(one.reading.quantity))
    figure = StyledFigure(figsize=(1.7 * WIDTH, 0.6 + ROW * len(shown)), layout="constrained")
    axes = figure.subplots(len(shown), 2, sharex=True, squeeze=False)
    for (left, right), one in zip(axes, shown, strict=True):
        label, unit, factor = OVERLAID[one.reading.quantity]
        for ax in (left, right):
            ax.axvspan(0.0, 1e3 * contact, **AREA)
        over = Chart(left, "Time from touch [ms]", f"{label} [{unit}]")
        apart = Chart(right, "Time from touch [ms]", f"Difference [{unit}]")
        _overlay(over, apart, one, touch, factor)
        left.legend(
            loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=6, borderpad=0.0,
            borderaxespad=0.3, columnspacing=1.0, handletextpad=0.4, handlelength=1.2,
        )  # fmt: skip
    for ax in axes[:-1].flat:
        ax.set_xlabel("")
    axes[0, 1].set_title("predicted less recorded; band: twice the uncertainty", loc="right")
    figure.suptitle(title)
    return figure


def _overlay(over: Chart, apart: Chart, one: ChannelErrors, touch: float, factor: float) -> None:
    """Draw the numbers of a channel, and their differences."""
    t = 1e3 * (one.reading.times - touch)
    looks, many = cycle(LOOKS), len(one.parts)
    origin = np.zeros(many)
    if one.reading.quantity == POSITION:
        origin = one.recorded[int(np.nanargmin(np.where(
            np.isfinite(one.recorded).all(axis=1), np.abs(t), np.nan
        )))]  # fmt: skip
    for k, part in enumerate(one.parts):
        look = next(looks)
        dots = {"color": look["color"], "marker": "o", "ms": DOT, "mew": 0.0, "ls": "none"}
        recorded, predicted = (
            factor * (values[:, k] - origin[k]) for values in (one.recorded, one.predicted)
        )
        over.curve(f"recorded {part}", t, recorded, key=False, alpha=0.6, **dots)
        over.curve(f"predicted {part}", t, predicted, key=False, lw=1.0, **look)
        over.ax.plot([], [], label=part, **(look | {"marker": "o", "ms": DOT}))
        band, error = factor * BEYOND * one.uncertainties[:, k], factor * one.errors[:, k]
        apart.band(f"twice the uncertainty {part}", t, -band, band, color=look["color"], alpha=0.12)
        apart.curve(f"difference {part}", t, error, key=False, **dots)

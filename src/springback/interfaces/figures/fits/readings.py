"""Figure of an impact that was fitted: what was measured, what was predicted, and residuals."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from springback.identification.report.replays import ChannelReplay
from springback.interfaces.figures.chart import AREA, Chart
from springback.interfaces.figures.style import LOOKS, StyledFigure, in_style
from springback.interfaces.output.robots import BLUE, GREEN, GREY, ORANGE, PINK, RED
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ARM_LENGTH,
    ATTITUDE,
    POSITION,
    SPECIFIC_FORCE,
)

#: Width [in]: a phone shows it whole, with type that can be read.
WIDTH = 4.6
#: Height of a channel, and of the rest [in].
HEIGHT, REST = 1.5, 0.75
#: Time shown before touch and after release, in contact times, and the least [s] (chosen).
BEFORE, AFTER, LEAST = 0.5, 1.2, 0.01
#: Residuals within which 95 % of independent normal numbers are [standard deviations].
USUAL = 1.96
_COLOURS = (BLUE, RED, GREEN, PINK, ORANGE, GREY)


class ChannelLabel(NamedTuple):
    """What a channel is called in a panel, its unit, and the factor from SI."""

    title: str
    unit: str
    factor: float


SHOWN = {
    SPECIFIC_FORCE: ChannelLabel("Specific force", "m/s²", 1.0),
    ANGULAR_VELOCITY: ChannelLabel("Angular velocity", "rad/s", 1.0),
    POSITION: ChannelLabel("Position", "mm", 1e3),
    ATTITUDE: ChannelLabel("Turn", "deg", math.degrees(1.0)),
    ARM_LENGTH: ChannelLabel("Arm length", "mm", 1e3),
}


@in_style
def impact_figure(channels: Sequence[ChannelReplay], contact: float) -> Figure:
    """Measured and predicted values around the contact, and residuals over the whole window.

    Args:
        channels: Of one impact, at least one.
        contact: From touch to release [s].
    """
    size = (WIDTH, REST + HEIGHT * len(channels))
    figure = StyledFigure(figsize=size, layout="constrained")
    panels = figure.subplots(
        len(channels), 2, sharex="col", squeeze=False, gridspec_kw={"width_ratios": (1.7, 1.0)}
    )
    margin = max(contact, LEAST)
    window = (-BEFORE * margin, contact + AFTER * margin)
    for (left, right), one in zip(panels, channels, strict=True):
        _measured(left, one, window)
        _residuals(right, one)
        for ax in (left, right):
            ax.axvspan(0.0, 1e3 * contact, **AREA)
    for ax in panels[:-1].flat:
        ax.set_xlabel("")
    panels[-1, 0].set_xlim(1e3 * window[0], 1e3 * window[1])
    begin = min(float(one.times[0]) for one in channels)
    end = max(float(one.times[-1]) for one in channels)
    panels[-1, 1].set_xlim(1e3 * begin, 1e3 * end)
    _key(figure, channels)
    return figure


def _key(figure: StyledFigure, channels: Sequence[ChannelReplay]) -> None:
    """Legend of all panels: what is a mark and a line; colours are named in the panels."""
    look: dict[str, Any] = {"color": GREY}
    chart = Chart(figure.axes[0], "", "")
    chart.key("measured", ls="none", marker="o", ms=2.6, **look)
    chart.key("predicted", ls="-", lw=1.2, **look)
    if any(one.clipped.any() for one in channels):
        chart.key("clipped", ls="none", marker="^", ms=5.0, mfc="none", mec=ORANGE)
    figure.legend(loc="outside upper left", ncols=3)


def _parts(one: ChannelReplay) -> list[str]:
    if one.reading.quantity == ARM_LENGTH:
        return [str(k + 1) for k in range(one.measured.shape[1])]
    return list("xyz")[: one.measured.shape[1]]


def _measured(ax: Axes, one: ChannelReplay, window: tuple[float, float]) -> None:
    """Marks of what was measured, lines of what was predicted."""
    shown = SHOWN[one.reading.quantity]
    chart = Chart(
        ax, "Time from touch [ms]", f"[{shown.unit}]", one.reading.name, titled=False
    )  # fmt: skip
    inside = (one.times >= window[0]) & (one.times <= window[1])
    around = _with_neighbours(inside)
    t, near = 1e3 * one.times[inside], 1e3 * one.times[around]
    for k, part in enumerate(_parts(one)):
        look: dict[str, Any] = {"color": _COLOURS[k % len(_COLOURS)]}
        values = shown.factor * one.measured[inside, k]
        chart.curve(f"{part}, measured", t, values, key=False, ls="none", marker="o", ms=2.6,
                    mew=0.0, alpha=0.8, **look)  # fmt: skip
        line = {"ls": LOOKS[k % len(LOOKS)]["ls"], "lw": 1.2}
        predicted = shown.factor * one.predicted[around, k]
        chart.curve(f"{part}, predicted", near, predicted, key=False, **line, **look)
        over = one.clipped[inside, k]
        if over.any():
            chart.curve(
                f"{part}, clipped", t[over], values[over], key=False, ls="none", marker="^",
                ms=5.0, mfc="none", mec=ORANGE, zorder=4.0,
            )  # fmt: skip
        ax.text(
            1.0 - 0.09 * (len(_parts(one)) - 1 - k), 1.02, part, transform=ax.transAxes,
            ha="right", va="bottom", weight="bold", **look,
        )  # fmt: skip
    ax.set_title(f"{shown.title} [{shown.unit}]")
    ax.set_ylabel("")


def _with_neighbours(inside: Any) -> Any:
    """True for samples of a window and the nearest beside it, so that lines reach its edges."""
    wider = inside.copy()
    wider[:-1] |= inside[1:]
    wider[1:] |= inside[:-1]
    return wider


def _residuals(ax: Axes, one: ChannelReplay) -> None:
    """Whitened residuals over the whole window, with the band that holds 95 % of them."""
    chart = Chart(ax, "[ms]", "[σ]", f"{one.reading.name}, residuals", titled=False)
    lost = np.isnan(one.measured).any(axis=1)
    for k, part in enumerate(_parts(one)):
        values = np.where(lost, np.nan, one.residuals[:, k])
        chart.curve(
            part, 1e3 * one.times, values, key=False, ls="none", marker="o", ms=1.6, mew=0.0,
            alpha=0.7, color=_COLOURS[k % len(_COLOURS)],
        )  # fmt: skip
    for edge in (-USUAL, USUAL):
        ax.axhline(edge, color=GREY, lw=0.7, ls=(0, (3, 2)))
    reach = float(np.nanmax(np.abs(one.residuals), initial=0.0))
    ax.set_ylim(-max(3.5, 1.08 * reach), max(3.5, 1.08 * reach))
    ax.set_title("Residual [σ]")
    ax.set_ylabel("")

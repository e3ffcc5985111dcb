"""Figures of what a fit found: profiles, correlations, and the values of each impact."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import cycle
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure

from springback.identification.estimates import FieldEstimate
from springback.identification.report.profiles import ProfileCurve
from springback.identification.solving.profiles import PROFILE_RISE
from springback.interfaces.figures.chart import Chart
from springback.interfaces.figures.fits.readings import WIDTH
from springback.interfaces.figures.style import LOOKS, StyledFigure, in_style
from springback.interfaces.output.field_labels import short_names
from springback.interfaces.output.quantities import display_unit
from springback.interfaces.output.robots import BLUE, GREY, INK
from springback.logs.recording import Array

#: Highest 2 Δ ln L shown (chosen).
HIGHEST = 5.0
#: Panels beside each other, and height of each [in].
BESIDE, TALL = 2, 1.75
#: Impacts that are named in a legend at most (chosen).
MOST_NAMED = 6
#: Blue for -1, white for 0, red for +1: those that a colour-blind reader distinguishes.
SIGNED = LinearSegmentedColormap.from_list("signed", ["#2166AC", "#F7F7F7", "#B2182B"])
#: Width of a letter of a name, and of what is beside them [in] (chosen).
LETTER, BESIDE_NAMES = 0.066, 0.15
#: Width of a figure of many fields [in], which spans two columns in print (chosen).
WIDE = 5.0


class _Written(NamedTuple):
    """How correlations are written in cells of at least some width."""

    room: float  # [in]
    width: float  # of the figure [in]
    digits: int
    minus: str
    size: float  # of type [pt]


#: From wide cells to narrow ones; in narrower ones colours tell (chosen).
_NUMBERS = (
    _Written(0.32, WIDTH, 2, "−", 8.6), _Written(0.22, WIDE, 2, "-", 7.4),
    _Written(0.15, WIDE, 1, "-", 7.4), _Written(0.0, WIDE, 0, "", 7.4),
)  # fmt: skip
#: Magnitude from which letters are white.
_DARK = 0.6


@in_style
def profiles_figure(impacts: Sequence[Sequence[ProfileCurve]]) -> Figure:
    """2 Δ ln L over each free field: one curve an impact; by Laplace if there is but one.

    Args:
        impacts: Profiles over the same fields, of each impact.
    """
    fields = [one.unknown for one in impacts[0]]
    down = math.ceil(len(fields) / BESIDE)
    figure = StyledFigure(figsize=(WIDTH, 0.7 + TALL * down), layout="constrained")
    axes = figure.subplots(down, BESIDE, squeeze=False, sharey=True)
    names = short_names([one.name for one in fields])
    for k, ax in enumerate(axes.flat):
        if k >= len(fields):
            ax.set_visible(False)
            continue
        curves = [profiles[k] for profiles in impacts]
        _profile(ax, names[k], curves)
        if k % BESIDE:
            ax.set_ylabel("")
    handles, labels = axes.flat[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper left", ncols=3)
    return figure


def _profile(ax: Axes, name: str, curves: Sequence[ProfileCurve]) -> None:
    unknown = curves[0].unknown
    unit = display_unit(unknown.unit, [float(v) for one in curves for v in one.values])
    chart = Chart(ax, f"[{unit.symbol}]", "2 Δ ln L [-]", name)
    looks, alone = cycle(LOOKS), len(curves) == 1
    for number, one in enumerate(curves, start=1):
        known, look = np.isfinite(one.rise), next(looks)
        at, rise = one.values[known], one.rise[known]
        middle = float(at[int(np.argmin(rise))])
        word = "profile" if alone else f"impact {number}"
        fine, curve = _smooth(at, rise, middle)
        named = number <= MOST_NAMED
        chart.curve(word, unit.factor * fine, curve, key=named, **look)
        points = {"ls": "none", "marker": "o", "ms": 2.8, "color": look["color"]}
        chart.curve(f"{word}, flown", unit.factor * at, rise, key=False, **points)
        if alone:
            fine, curve = _smooth(at, one.laplace[known], middle)
            chart.curve("Laplace", unit.factor * fine, curve, color=GREY, lw=1.0, ls=(0, (4, 2)))
            before = one.before[known] - one.before.min()
            chart.curve("prior alone", unit.factor * at, before, color=INK, lw=0.9, ls=":")
    chart.hline("end of the 95 % interval", PROFILE_RISE)
    ax.set_ylim(-0.2, HIGHEST)
    ax.locator_params(axis="x", nbins=3)


def _smooth(values: Array, rise: Array, middle: float) -> tuple[Array, Array]:
    """A curve near a parabola, through the points: their signed roots are interpolated."""
    roots = np.sign(values - middle) * np.sqrt(np.clip(rise, 0.0, None))
    fine = np.unique(np.concatenate([np.linspace(values[0], values[-1], 81), values]))
    return fine, np.interp(fine, values, roots) ** 2


@in_style
def correlations_figure(names: Sequence[str], matrix: Array) -> Figure:
    """Correlations of fields and latents.

    Args:
        names: Of rows and columns.
        matrix: Correlations, shape (names, names).
    """
    count = len(names)
    short = [f"{name}  {k}" for k, name in enumerate(short_names(names), start=1)]
    beside = BESIDE_NAMES + LETTER * max(map(len, short))
    written = next(
        one for one in _NUMBERS if one.width - beside >= one.room * (count - 1) or not one.digits
    )
    figure = StyledFigure(figsize=(written.width, 0.5 + 0.3 * count), layout="constrained")
    ax = figure.subplots()
    lower = np.where(np.tri(count, k=-1, dtype=bool), matrix, np.nan)[1:, :-1]
    ax.imshow(lower, cmap=SIGNED, vmin=-1.0, vmax=1.0, aspect="auto")
    chart = Chart(ax, "Column", "Row")
    for (i, j), rho in np.ndenumerate(lower):
        if np.isfinite(rho):
            chart.record("", {"Row": names[i + 1], "Column": names[j], "correlation [-]": rho})
            ax.text(
                j, i, _number(rho, written), ha="center", va="center", size=written.size,
                color="white" if abs(rho) > _DARK else INK,
            )  # fmt: skip
    ax.set_yticks(range(count - 1), short[1:])
    columns = [f"{k}" if k > 1 else short[0] for k in range(1, count)]
    ax.set_xticks(range(count - 1), columns)
    ax.get_xticklabels()[0].set_horizontalalignment("right")
    ax.tick_params(length=0)
    ax.grid(visible=False)
    for edge in ax.spines.values():
        edge.set_visible(False)
    return figure


def _number(rho: float, written: _Written) -> str:
    """Correlation without the zero before its point, which leaves room; nothing without digits."""
    if not written.digits:
        return ""
    text = f"{abs(rho):.{written.digits}f}".replace("0.", ".")
    return f"{written.minus}{text}" if round(rho, written.digits) < 0.0 else text


@in_style
def values_figure(estimates: Sequence[FieldEstimate], impacts: Sequence[Sequence[Any]]) -> Figure:
    """Values of each impact with their intervals, and what they tell together.

    Args:
        estimates: Of the free fields, pooled.
        impacts: Of each field its value and interval in each impact, as
            `springback.intervals.IntervalEstimate`.
    """
    down, count = math.ceil(len(estimates) / BESIDE), len(impacts[0])
    size = (WIDTH, 0.4 + down * (0.75 + 0.2 * (count + 1)))
    figure = StyledFigure(figsize=size, layout="constrained")
    axes = figure.subplots(down, BESIDE, squeeze=False, sharey=True)
    labels = [str(k + 1) for k in range(count)]
    names = short_names([one.unknown.name for one in estimates])
    for k, ax in enumerate(axes.flat):
        if k >= len(estimates):
            ax.set_visible(False)
            continue
        one, found = estimates[k], impacts[k]
        unit = display_unit(one.unknown.unit, [each.value for each in found])
        chart = Chart(ax, f"[{unit.symbol}]", "Impact", names[k])
        low = [unit.factor * (v.value if v.low is None else v.low) for v in found]
        high = [unit.factor * (v.value if v.high is None else v.high) for v in found]
        middle = [unit.factor * v.value for v in found]
        look = {"ls": "none", "marker": "o", "ms": 4.0, "capsize": 2.0, "lw": 1.2}
        chart.errorbars("each impact", middle, list(range(count)), low, high, across=True,
                        color=BLUE, columns={"Impact": labels}, **look)  # fmt: skip
        ends = [np.clip(v, *ax.get_xlim()) if not np.isfinite(v) else unit.factor * v
                for v in (one.low, one.high)]  # fmt: skip
        chart.errorbars(
            "together", [unit.factor * one.value], [count], [ends[0]], [ends[1]], across=True,
            color=INK, columns={"Impact": "together"}, **{**look, "marker": "D"},
        )  # fmt: skip
        ax.axhline(count - 0.5, color=INK, lw=0.5)
        ax.locator_params(axis="x", nbins=4)
    axes[0, 0].set_yticks(range(count + 1), [*labels, "all"])
    axes[0, 0].set_ylim(count + 0.6, -0.6)
    return figure

"""Figures of collisions in flight, in the style of the paper's.

No physics is computed here: every number is a column of a trajectory, a count of trials or a
printed value.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.patches import Circle
from matplotlib.ticker import MaxNLocator

from springback.interfaces.figures.chart import Chart
from springback.interfaces.figures.panels import Array, contacts, thin_curve
from springback.interfaces.figures.style import WIDTH, Look, StyledFigure, in_style
from springback.interfaces.output.robots import BLUE, GREEN, GREY, INK, ORANGE, ROBOTS
from springback.interfaces.reproduction.figures.choices import ORDER, signed_angle
from springback.paper.printed import RECOVERY_PITCH, SUCCESS
from springback.paper.resilience import (
    FASTEST,
    REPEATED,
    ResilienceResults,
    Sample,
    motion,
)
from springback.paper.resilience import ROBOTS as FLOWN

ASKED: Look = {"color": ORANGE, "ls": (0, (5, 1.5)), "lw": 1.2}
AIMED: Look = {"color": GREEN, "ls": (0, (1.2, 1.0)), "lw": 1.2}
PRINTED: Look = {"color": INK, "ls": (0, (6, 2, 1, 2)), "lw": 0.9}
SINCE = "Time from first touch [s]"
STATES = ("Position x [m]", "Velocity x [m/s]", "Pitch [°]")
SPAN = (-0.3, 2.2)
"""Time since first touch shown for a collision [s] (chosen)."""


class TimeView(NamedTuple):
    """Time interval of a panel, and its axis."""

    span: tuple[float, float]
    """Time since first touch [s]."""
    scale: float
    head: str


VIEWS = (TimeView(SPAN, 1.0, SINCE), TimeView((-0.008, 0.045), 1e3, "From touch [ms]"))
"""The recovery, and a close-up of the contact (chosen)."""
ZOOMED = 1.0
"""Time of the repeated test's first collision shown enlarged, as in the paper [s]."""
POSES = 0.07
"""Chosen: time between two drawings of a robot seen from the side [s]."""
SEEN = 1.5
"""Chosen: time after touch shown in a side view [s]."""
BODY, ARM, AXIS = 0.035, 0.018, 0.09
"""Chosen: radii of the circles of main body and arms, length of the line along e_z [m]."""
DRAWN_WIDTH = 3.45
"""Width of a side view without colour bar and labels [in]."""
COLOURS = "viridis"


def _within(curves: dict[str, Array], span: tuple[float, float]) -> dict[str, Array]:
    inside = (curves["t"] >= span[0]) & (curves["t"] <= span[1])
    return {name: values[inside] for name, values in curves.items()}


def _states(curves: dict[str, Array], prefix: str = "") -> list[Array]:
    """Position, velocity and pitch in the order and units of `STATES`."""
    x, v, pitch = (curves[f"{prefix}{name}"] for name in ("x", "vx", "pitch"))
    return [x, v, np.degrees(pitch)]


# -- success --------------------------------------------------------------------------------------


@in_style
def success_figure(results: ResilienceResults) -> Figure:
    """Shares of recovered trials with Wilson intervals, and printed shares."""
    figure = StyledFigure(figsize=(WIDTH, 3.0))
    ax = figure.subplots()
    chart = Chart(ax, "Speed and pitch at contact", "Recovered [%]")
    names = [f"{speed:g} m/s\n{signed_angle(pitch)}°" for pitch, speed in ORDER]
    for robot, shift in zip(FLOWN, (-0.14, 0.14), strict=True):
        look = ROBOTS[robot]
        found = {ORDER.index((t.pitch, t.speed)): t for t in results.tallies() if t.robot == robot}
        rates = 100.0 * np.array([(t.share, *t.interval) for t in found.values()]).reshape(-1, 3).T
        chart.errorbars(
            f"{look.label}, ours", np.array(list(found)) + shift, *rates, fmt=look.marker, ms=5,
            columns={chart.x: [names[k] for k in found]}, lw=1.3, capsize=2.5, color=look.colour,
        )  # fmt: skip
        printed = {k: SUCCESS[robot, *ORDER[k]] for k in found if (robot, *ORDER[k]) in SUCCESS}
        chart.curve(
            f"{look.label}, printed", [k + shift for k in printed],
            [100.0 * rate for rate in printed.values()],
            columns={chart.x: [names[k] for k in printed]}, marker="D", color=look.colour,
            mfc="none", mew=1.2, ms=9, ls="none", zorder=4,
        )  # fmt: skip
    ax.set_xticks(range(len(ORDER)), names)
    ax.set_xlim(-0.5, len(ORDER) - 0.5)
    ax.set_ylim(-8.0, 108.0)
    ax.set_xlabel(chart.x)
    ax.grid(visible=False, axis="x")
    figure.legend(*ax.get_legend_handles_labels(), loc="outside upper center", ncols=2)
    return figure


def _condition(robot: str, pitch: float, speed: float) -> str:
    return f"{ROBOTS[robot].label}, {speed:g} m/s, {signed_angle(pitch)}°"


# -- states over time -----------------------------------------------------------------------------


@in_style
def fast_figure(sample: Sample) -> Figure:
    """Position, velocity and pitch of one collision, flown and reference, with a close-up."""
    figure = StyledFigure(figsize=(WIDTH, 5.0))
    axes = figure.subplots(3, 2, sharey="row", width_ratios=(2.3, 1.0))
    titles = (_condition(sample.robot, sample.pitch, sample.speed), "In contact")
    for column, title, view in zip(axes.T, titles, VIEWS, strict=True):
        for ax in column[:-1]:
            ax.sharex(column[-1])
            ax.tick_params(labelbottom=False)
        charts = [
            Chart(ax, view.head, label, title, titled=ax is column[0])
            for ax, label in zip(column, STATES, strict=True)
        ]
        _collision(charts, sample, view)
        for ax in column:
            ax.yaxis.set_major_locator(MaxNLocator(5))
        column[-1].set_xlim(view.scale * view.span[0], view.scale * view.span[1])
        if (sample.pitch, sample.speed) == FASTEST:
            for value in RECOVERY_PITCH:
                charts[2].hline("printed extremes", value, **PRINTED)
    if (sample.pitch, sample.speed) == FASTEST:
        axes[2, 0].plot([], [], label="printed extremes", **PRINTED)
    figure.align_ylabels(axes[:, 0])
    handles, names = axes[2, 0].get_legend_handles_labels()
    figure.legend(handles, names, loc="outside upper center", ncols=3, columnspacing=1.0)
    return figure


def _events(sample: Sample) -> dict[str, float]:
    """Times of first touch and alarm since first touch [s]."""
    touch, alarm = 0.0, sample.flight.measures["detection_delay"]
    return {"touch": touch} | ({} if alarm is None else {"alarm": alarm})


def _collision(charts: Sequence[Chart], sample: Sample, view: TimeView) -> None:
    """Draw states, flown and reference, with events and contacts."""
    curves, scale = _within(motion(sample.flight), view.span), view.scale
    flown, asked, t = _states(curves), _states(curves, "asked_"), scale * curves["t"]
    touch = sample.flight.measures["touch_time"] or 0.0
    spans = [(max(a - touch, view.span[0]), min(b - touch, view.span[1]))
             for a, b in contacts(sample.flight.columns)]  # fmt: skip
    for k, chart in enumerate(charts):
        chart.curve("flown", t, flown[k], color=BLUE, zorder=3)
        chart.curve("reference", t, asked[k], **ASKED)
        if k == 2:
            aimed = np.degrees(curves["aimed_pitch"])
            chart.curve("commanded, with feedback", t, aimed, **AIMED)
        for (name, when), marker in zip(_events(sample).items(), ("o", "^"), strict=False):
            chart.vline(name, scale * when, lw=0.8, zorder=1.4)
            at = float(np.interp(when, curves["t"], flown[k]))
            chart.curve(
                name, scale * when, at, marker=marker, color=INK, mec="white", mew=0.6, ms=6,
                ls="none", zorder=4,
            )  # fmt: skip
        for low, high in spans:
            if low < high:
                chart.span("contact", scale * low, scale * high)


@in_style
def comparison_figure(samples: Sequence[Sample]) -> Figure:
    """Position, velocity and pitch of both robots in the same collision."""
    figure = StyledFigure(figsize=(WIDTH, 4.4))
    axes = figure.subplots(3, 1, sharex=True)
    charts = [Chart(ax, SINCE, label) for ax, label in zip(axes, STATES, strict=True)]
    for sample in samples:
        curves, look = _within(motion(sample.flight), SPAN), ROBOTS[sample.robot]
        for chart, values in zip(charts, _states(curves), strict=True):
            chart.curve(look.label, curves["t"], values, **look.curve)
    for chart in charts:
        chart.vline("first touch", 0.0, key=True)
        chart.ax.yaxis.set_major_locator(MaxNLocator(5))
    axes[-1].set_xlim(*SPAN)
    figure.align_ylabels(axes)
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside upper center", ncols=3)
    return figure


# -- from the side --------------------------------------------------------------------------------


@in_style
def side_figure(samples: Sequence[Sample]) -> Figure:
    """Robots from the side, time as colour: away from the wall above, back to p_r below."""
    seen = [_within(motion(sample.flight), (0.0, SEEN)) for sample in samples]
    wall = max(sample.noise_stream.wall_distance for sample in samples)
    left = min(float(curves["x"].min()) for curves in seen) - 0.2
    low = min(float(curves["z"].min()) for curves in seen) - 0.15
    high = max(float(curves["z"].max()) for curves in seen) + 0.15
    rows, right = 2 * len(samples), wall + 0.06
    each = DRAWN_WIDTH * (high - low) / (right - left) + 0.32
    figure = StyledFigure(figsize=(WIDTH, 0.3 + each * rows))
    axes = figure.subplots(rows, 1, sharex=True, sharey=True)
    scale = Normalize(0.0, SEEN)
    for k, (sample, curves) in enumerate(zip(samples, seen, strict=True)):
        turn = float(curves["t"][int(np.argmin(curves["x"]))])
        parts = {"away from the wall": (0.0, turn), "and back": (turn, SEEN)}
        for ax, (name, span) in zip(axes[2 * k : 2 * k + 2], parts.items(), strict=True):
            chart = Chart(ax, "x [m]", "z [m]", f"{ROBOTS[sample.robot].label}, {name}")
            _poses(chart, sample, _within(curves, span), scale)
            ax.set_aspect("equal")
            ax.set_ylim(low, high)
    axes[-1].set_xlim(left, right)
    bar = figure.colorbar(ScalarMappable(scale, COLOURS), ax=axes, aspect=20 * len(samples))
    bar.set_label(SINCE)
    bar.outline.set_visible(False)
    return figure


def _poses(chart: Chart, sample: Sample, curves: dict[str, Array], scale: Normalize) -> None:
    """Draw main body, arms and e_z repeatedly, with arms at the paper's constant L* = L/√2."""
    reach = sample.flight.scenario.vehicle.lengths()[0] / math.sqrt(2.0)
    wall = sample.noise_stream.wall_distance
    chart.span("wall", wall, wall + 1.0, color=GREY, zorder=1)
    t, shades = curves["t"], ScalarMappable(scale, COLOURS)
    for when in np.arange(t[0], t[-1], POSES):
        x, z, pitch = (float(np.interp(when, t, curves[name])) for name in ("x", "z", "pitch"))
        along = np.array([math.cos(pitch), -math.sin(pitch)])
        up = np.array([math.sin(pitch), math.cos(pitch)])
        centre, order, colour = np.array([x, z]), 3.0 + when, shades.to_rgba(when)
        back, front = centre - reach * along, centre + reach * along
        at = f"at {when:.2f} s"
        for name, ends, ink, lw in (
            ("arms", (back, front), colour, 1.6), ("e_z", (centre, centre + AXIS * up), INK, 1.1),
        ):  # fmt: skip
            chart.curve(
                f"{name} {at}", *zip(*ends, strict=True), key=False, color=ink, lw=lw, zorder=order
            )
        for place, radius in ((centre, BODY), (back, ARM), (front, ARM)):
            chart.ax.add_patch(
                Circle(tuple(place), radius, fc=colour, ec=INK, lw=0.6, zorder=order)
            )


# -- again and again ------------------------------------------------------------------------------


@in_style
def repeat_figure(results: ResilienceResults, robot: str = "arq") -> Figure:
    """Repeated collisions without landing; on the right the first second of the first one."""
    flight = next(r.flight for r in results.repeats_of(robot) if r.flight is not None)
    curves, touch = motion(flight), flight.measures["touch_time"] or 0.0
    figure = StyledFigure(figsize=(WIDTH, 3.5))
    axes = figure.subplots(2, 2, sharex="col", sharey="row", width_ratios=(2.6, 1.0))
    close = _within(curves, (-0.1, ZOOMED))
    colour = ROBOTS[robot].colour
    rows = [("x", STATES[0], 1.0), ("pitch", STATES[2], math.degrees(1.0))]
    for k, ((name, label, scale), (left, right)) in enumerate(zip(rows, axes, strict=True)):
        whole = Chart(left, "Time [s]", label, _condition(robot, *REPEATED), titled=k == 0)
        zoom = Chart(right, "From touch [s]", label, "The first", titled=k == 0)
        t, values = thin_curve(curves["t"] + touch, scale * curves[name])
        whole.curve("flown", t, values, key=False, color=colour, lw=0.9)
        zoom.curve("flown", close["t"], scale * close[name], key=False, color=colour)
        zoom.vline("first touch", 0.0)
        whole.span("the first", touch - 0.1, touch + ZOOMED, color=ORANGE, alpha=0.45, zorder=0.2)
        left.yaxis.set_major_locator(MaxNLocator(5))
        for spine in right.spines.values():
            spine.set(visible=True, color=ORANGE, linewidth=1.0)
        right.tick_params(left=False)
        right.set_xlim(-0.1, ZOOMED)
        left.set_xlim(0.0, _over(flight))
    figure.align_ylabels(axes[:, 0])
    return figure


def _over(flight: Any) -> float:
    """Time one second after the last return ended [s]."""
    phases, t = flight.telemetry["phase"], flight.telemetry["t"]
    changes = np.flatnonzero(np.diff(phases))
    return float(min(t[-1], t[changes[-1]] + 1.0)) if len(changes) else float(t[-1])

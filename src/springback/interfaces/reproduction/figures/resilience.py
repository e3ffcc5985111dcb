"""Figures of collisions in flight, in the manner of the paper.

Nothing here computes physics: every number shown is a trajectory column, a count of trials or a
printed value.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.patches import Circle
from matplotlib.ticker import MaxNLocator

from springback.interfaces.figures.panels import Array, contacts, thinned
from springback.interfaces.figures.style import (
    BLUE,
    GREEN,
    GREY,
    INK,
    ORANGE,
    RED,
    SHADE,
    WIDTH,
    Look,
    StyledFigure,
    styled,
)
from springback.paper.printed import RECOVERY_PITCH, SUCCESS
from springback.paper.resilience import (
    FASTEST,
    REPEATED,
    ROBOTS,
    ResilienceResults,
    Sample,
    motion,
)
from springback.studies.run_ups import CONDITIONS

NAMES = {"arq": "ARQ", "quad": "Quad"}
LOOKS: dict[str, Look] = {"arq": (BLUE, "-"), "quad": (RED, (0, (5, 1.5)))}
MARKERS = {"arq": "o", "quad": "s"}
ASKED: Look = (ORANGE, (0, (5, 1.5)))
AIMED: Look = (GREEN, (0, (1.2, 1.0)))
PRINTED: Look = (INK, (0, (6, 2, 1, 2)))
STATES = ("Position x [m]", "Velocity x [m/s]", "Pitch [°]")
SPAN = (-0.3, 2.2)
"""Since first touch [s], chosen: what the figures of one collision show."""
CLOSE = (-0.008, 0.045)
"""The same of the close-up of the contact [s]."""
ZOOMED = 1.0
"""[s], as in the paper: of the repeated test's first collision, what the boxes show."""
POSES = 0.07
"""[s], chosen: between two drawings of a robot seen from the side."""
SEEN = 1.5
"""[s], chosen: after touch, what a side view shows."""
BODY, ARM, AXIS = 0.035, 0.018, 0.09
"""[m], chosen: radii of the circles of main body and arms, length of the line along e_z."""
DRAWN_WIDTH = 3.45
"""[in]: of a side view, what colour bar and labels leave of the figure."""
COLOURS = "viridis"


def _within(curves: dict[str, Array], span: tuple[float, float]) -> dict[str, Array]:
    inside = (curves["t"] >= span[0]) & (curves["t"] <= span[1])
    return {name: values[inside] for name, values in curves.items()}


def _states(curves: dict[str, Array], prefix: str = "") -> list[Array]:
    """Position, velocity and pitch, in the order and units of `STATES`."""
    x, v, pitch = (curves[f"{prefix}{name}"] for name in ("x", "vx", "pitch"))
    return [x, v, np.degrees(pitch)]


# -- success --------------------------------------------------------------------------------------


@styled
def success_figure(results: ResilienceResults) -> Figure:
    """Shares of recovered trials with Wilson's intervals, and what the paper prints."""
    figure = StyledFigure(figsize=(WIDTH, 3.0))
    ax = figure.subplots()
    order = sorted(CONDITIONS, key=lambda c: (c[1], c[0]))
    for robot, shift in zip(ROBOTS, (-0.14, 0.14), strict=True):
        colour = LOOKS[robot][0]
        found = [t for t in results.tallies() if t.robot == robot]
        places = np.array([order.index((t.pitch, t.speed)) + shift for t in found])
        rates = np.array([t.rate for t in found])
        spans = [rates - [t.low for t in found], [t.high for t in found] - rates]
        ax.errorbar(
            places, 100 * rates, yerr=100 * np.clip(spans, 0.0, None), fmt=MARKERS[robot], ms=5,
            lw=1.3, capsize=2.5, color=colour, label=f"{NAMES[robot]}, ours",
        )  # fmt: skip
        printed = [
            (order.index((pitch, speed)) + shift, 100 * rate)
            for (who, pitch, speed), rate in SUCCESS.items()
            if who == robot and any((t.pitch, t.speed) == (pitch, speed) for t in found)
        ]
        ax.plot(
            [x for x, _ in printed], [y for _, y in printed], "D", color=colour, mfc="none",
            mew=1.2, ms=9, ls="none", label=f"{NAMES[robot]}, printed", zorder=4,
        )  # fmt: skip
    names = [f"{speed:g} m/s\n{_signed(pitch)}°" for pitch, speed in order]
    ax.set_xticks(range(len(order)), names)
    ax.set_xlim(-0.5, len(order) - 0.5)
    ax.set_ylim(-8.0, 108.0)
    ax.set_xlabel("Speed and pitch at contact")
    ax.set_ylabel("Recovered [%]")
    ax.grid(visible=False, axis="x")
    figure.legend(*ax.get_legend_handles_labels(), loc="outside upper center", ncols=2)
    return figure


def _condition(robot: str, pitch: float, speed: float) -> str:
    return f"{NAMES[robot]}, {speed:g} m/s, {_signed(pitch)}°"


def _signed(degrees: float) -> str:
    return f"{degrees:+g}".replace("-", "−") if degrees else "0"


# -- states over time -----------------------------------------------------------------------------


@styled
def fast_figure(sample: Sample) -> Figure:
    """Position, velocity and pitch of one collision: flown and asked for, and a close-up."""
    figure = StyledFigure(figsize=(WIDTH, 5.0))
    axes = figure.subplots(3, 2, sharey="row", width_ratios=(2.3, 1.0))
    curves, events = motion(sample.flight), _events(sample)
    for column, span, scale in zip(axes.T, (SPAN, CLOSE), (1.0, 1e3), strict=True):
        _collision(column, _within(curves, span), events, scale)
        for start, end in contacts(sample.flight.columns):
            touch = sample.flight.measures["touch_time"] or 0.0
            low, high = max(start - touch, span[0]), min(end - touch, span[1])
            if low < high:
                for ax in column:
                    ax.axvspan(
                            scale * low, scale * high, color=SHADE, lw=0.0, zorder=0.1,
                            label="_contact",
                        )  # fmt: skip
        column[-1].set_xlim(scale * span[0], scale * span[1])
        for ax in column[:-1]:
            ax.sharex(column[-1])
            ax.tick_params(labelbottom=False)
    for ax, label in zip(axes[:, 0], STATES, strict=True):
        ax.set_ylabel(label)
        ax.yaxis.set_major_locator(MaxNLocator(5))
    if (sample.pitch, sample.speed) == FASTEST:
        for ax in axes[2]:
            for value in RECOVERY_PITCH:
                ax.axhline(
                    value, color=PRINTED[0], ls=PRINTED[1], lw=0.9, zorder=1.5,
                    label="_printed extremes",
                )  # fmt: skip
        axes[2, 0].plot([], [], color=PRINTED[0], ls=PRINTED[1], lw=0.9, label="printed extremes")
    axes[0, 0].set_title(_condition(sample.robot, sample.pitch, sample.speed))
    axes[0, 1].set_title("In contact")
    axes[-1, 0].set_xlabel("Time from first touch [s]")
    axes[-1, 1].set_xlabel("From touch [ms]")
    figure.align_ylabels(axes[:, 0])
    handles, names = axes[2, 0].get_legend_handles_labels()
    figure.legend(handles, names, loc="outside upper center", ncols=3)
    return figure


def _events(sample: Sample) -> dict[str, float]:
    """First touch and alarm since first touch [s]."""
    touch, alarm = 0.0, sample.flight.measures["detection_delay"]
    return {"touch": touch} | ({} if alarm is None else {"alarm": alarm})


def _collision(
    column: Iterable[Axes], curves: dict[str, Array], events: dict[str, float], scale: float
) -> None:
    flown, asked = _states(curves), _states(curves, "asked_")
    for k, ax in enumerate(column):
        t = scale * curves["t"]
        ax.plot(t, flown[k], color=BLUE, label="flown", zorder=3)
        ax.plot(t, asked[k], color=ASKED[0], ls=ASKED[1], lw=1.2, label="asked for")
        if k == 2:
            aimed = np.degrees(curves["aimed_pitch"])
            ax.plot(t, aimed, color=AIMED[0], ls=AIMED[1], lw=1.2, label="asked for, with feedback")
        for (name, when), marker in zip(events.items(), ("o", "^"), strict=False):
            ax.axvline(
                scale * when, color=GREY, lw=0.8, ls=(0, (3, 2)), zorder=1.4, label=f"_{name}"
            )
            at = float(np.interp(when, curves["t"], flown[k]))
            ax.plot(
                scale * when, at, marker, color=INK, mec="white", mew=0.6, ms=6, ls="none",
                zorder=4, label=name,
            )  # fmt: skip


@styled
def compared_figure(samples: Sequence[Sample]) -> Figure:
    """Position, velocity and pitch of both robots over the same collision."""
    figure = StyledFigure(figsize=(WIDTH, 4.4))
    axes = figure.subplots(3, 1, sharex=True)
    for sample in samples:
        curves, (colour, line) = _within(motion(sample.flight), SPAN), LOOKS[sample.robot]
        for ax, values in zip(axes, _states(curves), strict=True):
            ax.plot(curves["t"], values, color=colour, ls=line, label=NAMES[sample.robot])
    for ax, label in zip(axes, STATES, strict=True):
        ax.axvline(0.0, color=GREY, lw=0.9, ls=(0, (3, 2)), zorder=1.5, label="first touch")
        ax.set_ylabel(label)
        ax.yaxis.set_major_locator(MaxNLocator(5))
    axes[-1].set_xlim(*SPAN)
    axes[-1].set_xlabel("Time from first touch [s]")
    figure.align_ylabels(axes)
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside upper center", ncols=3)
    return figure


# -- from the side --------------------------------------------------------------------------------


@styled
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
            _poses(ax, sample, _within(curves, span), scale)
            ax.set_title(f"{NAMES[sample.robot]}, {name}")
            ax.set_ylabel("z [m]")
            ax.set_aspect("equal")
            ax.set_ylim(low, high)
    axes[-1].set_xlim(left, right)
    axes[-1].set_xlabel("x [m]")
    bar = figure.colorbar(ScalarMappable(scale, COLOURS), ax=axes, aspect=20 * len(samples))
    bar.set_label("Time from first touch [s]")
    bar.outline.set_visible(False)
    return figure


def _poses(ax: Axes, sample: Sample, curves: dict[str, Array], scale: Normalize) -> None:
    """Main body, arms and e_z, again and again; arms at the paper's constant L* = L/√2."""
    reach = sample.flight.scenario.vehicle.lengths()[0] / math.sqrt(2.0)
    wall = sample.noise_stream.wall_distance
    ax.axvspan(wall, wall + 1.0, color=GREY, lw=0.0, label="_wall")
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
            line = zip(*ends, strict=True)
            ax.plot(*line, color=ink, lw=lw, zorder=order, label=f"_{name} {at}")
        for place, radius in ((centre, BODY), (back, ARM), (front, ARM)):
            ax.add_patch(Circle(tuple(place), radius, fc=colour, ec=INK, lw=0.6, zorder=order))


# -- again and again ------------------------------------------------------------------------------


@styled
def repeated_figure(results: ResilienceResults, robot: str = "arq") -> Figure:
    """Collision after collision without landing; the first second of the first one on the right."""
    flight = next(r.flight for r in results.repeated(robot) if r.flight is not None)
    curves, touch = motion(flight), flight.measures["touch_time"] or 0.0
    figure = StyledFigure(figsize=(WIDTH, 3.5))
    axes = figure.subplots(2, 2, sharex="col", sharey="row", width_ratios=(2.6, 1.0))
    close = _within(curves, (-0.1, ZOOMED))
    rows = [("x", STATES[0], 1.0), ("pitch", STATES[2], math.degrees(1.0))]
    for (whole, zoom), (name, label, scale) in zip(axes, rows, strict=True):
        colour = LOOKS[robot][0]
        whole.plot(
            *thinned(curves["t"] + touch, scale * curves[name]),
            color=colour,
            lw=0.9,
            label="_flown",
        )
        zoom.plot(close["t"], scale * close[name], color=colour, label="_flown")
        zoom.axvline(0.0, color=GREY, lw=0.9, ls=(0, (3, 2)), zorder=1.5, label="_first touch")
        whole.axvspan(
            touch - 0.1, touch + ZOOMED, color=ORANGE, alpha=0.45, lw=0.0, zorder=0.2,
            label="_the first",
        )  # fmt: skip
        whole.set_ylabel(label)
        whole.yaxis.set_major_locator(MaxNLocator(5))
        for spine in zoom.spines.values():
            spine.set(visible=True, color=ORANGE, linewidth=1.0)
        zoom.tick_params(left=False)
        zoom.set_xlim(-0.1, ZOOMED)
        whole.set_xlim(0.0, _over(flight))
    for k, _ in enumerate(axes[0]):
        axes[0, k].tick_params(labelbottom=False)
    axes[-1, 0].set_xlabel("Time [s]")
    axes[-1, 1].set_xlabel("From touch [s]")
    axes[0, 0].set_title(_condition(robot, *REPEATED))
    axes[0, 1].set_title("The first")
    figure.align_ylabels(axes[:, 0])
    return figure


def _over(flight: Any) -> float:
    """A second after the last way home ended [s]."""
    phases, t = flight.telemetry["phase"], flight.telemetry["t"]
    changes = np.flatnonzero(np.diff(phases))
    return float(min(t[-1], t[changes[-1]] + 1.0)) if len(changes) else float(t[-1])

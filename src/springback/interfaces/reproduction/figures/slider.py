"""Figures of the slider tests, in the manner of the paper.

Nothing here computes physics: every number shown is a measure, a trajectory column or a printed
value.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from springback.interfaces.figures.panels import Array, arms_of, short
from springback.interfaces.figures.style import (
    BLUE,
    GREY,
    INK,
    LOOKS,
    RED,
    SHADE,
    WIDTH,
    Look,
    StyledFigure,
    styled,
)
from springback.paper.printed import SLIDER_SPEED, SWEEP_GAP, SWEEP_SPEEDS, TABLE_III
from springback.results.flight import Flight
from springback.studies.comparison import AGREEMENT

if TYPE_CHECKING:
    from springback.paper.slider import Case, SliderResults

ROBOTS = {"quad": "Quad", "arq": "ARQ"}
ROBOT_LOOKS: dict[str, Look] = {"quad": (RED, (0, (5, 1.5))), "arq": (BLUE, "-")}
SURFACES = ("wall", "mat")


def predictions(results: SliderResults, robot: str, surface: str) -> list[Case]:
    """The first case of every reading: the one flown with Quad's c_a."""
    found: dict[str, Case] = {}
    for case in results.cases:
        if (case.robot, case.surface) == (robot, surface):
            found.setdefault(case.reading.name, case)
    return list(found.values())


def _reading_looks(results: SliderResults) -> dict[str, Look]:
    """Looks of the readings; B, the default, gets the first."""
    order = (LOOKS[1], LOOKS[0], *LOOKS[2:])
    return {r.name: order[k % len(order)] for k, r in enumerate(results.readings)}


def _legend_room(readings: int) -> float:
    """More height [in] for the legend of more than three readings, three names to a line."""
    return 0.2 * max(0, -(-readings // 3) - 1)


@styled
def slider_figure(results: SliderResults, robot: str) -> Figure:
    """A robot hits wall and mat: position, velocity, acceleration, and arm length if arms slide.

    Dash-dotted lines mark what the paper prints for its simulation; a diamond its contact time.

    Args:
        results: The slider tests.
        robot: ``quad`` or ``arq``.
    """
    flown = {surface: predictions(results, robot, surface) for surface in SURFACES}
    flights = [case.flight for cases in flown.values() for case in cases]
    looks = _reading_looks(results)
    labels = ["Position [mm]", "Velocity [m/s]", "Acceleration [m/s²]"]
    if any(np.ptp(f.columns[f"l{_front(f)}"]) > 1e-9 for f in flights):
        labels.append("Arm length [mm]")
    figure = StyledFigure(figsize=(WIDTH, 0.9 + 1.3 * len(labels) + _legend_room(len(looks))))
    axes = figure.subplots(len(labels), 2, sharex="col", sharey="row", squeeze=False)
    for column, (surface, cases) in zip(axes.T, flown.items(), strict=True):
        span = _slider_times(robot, surface, cases)
        for case in cases:
            _slider_curves(column, case, looks.get(case.reading.name, LOOKS[0]), span)
        _slider_print(column, robot, surface)
        column[0].set_title(f"{ROBOTS[robot]} on the {surface}")
        column[-1].set_xlabel("Time from first touch [ms]")
        column[-1].set_xlim(*span)
    for ax, label in zip(axes[:, 0], labels, strict=True):
        ax.set_ylabel(label)
        ax.yaxis.set_major_locator(MaxNLocator(5, steps=[1, 2, 5, 10]))
    figure.align_ylabels(axes[:, 0])
    legends = [axes[row, 0].get_legend_handles_labels() for row in (0, 1)]
    handles, names = (a + b for a, b in zip(*legends, strict=True))
    figure.legend(handles, names, loc="outside upper center", ncols=3)
    return figure


def _front(flight: Flight) -> int:
    """The arm that is pressed hardest."""
    return max(arms_of(flight.columns), key=lambda j: float(np.max(flight.columns[f"fn{j}"])))


def _since_touch(flight: Flight) -> tuple[Array, float]:
    """Time from first touch [ms], and the instant of it [s]."""
    touch = flight.measures.get("touch_time") or 0.0
    return 1e3 * (flight.columns["t"] - touch), touch


def _slider_times(robot: str, surface: str, cases: Sequence[Case]) -> tuple[float, float]:
    shown = [TABLE_III[robot, surface].contact_time]
    for case in cases:
        measures = case.flight.measures
        shown += [measures.get("time_to_return") or 0.0, measures.get("contact_time") or 0.0]
    return -0.15e3 * max(shown), 1.3e3 * max(shown)


def _slider_curves(
    column: Sequence[Axes], case: Case, look: Look, span: tuple[float, float]
) -> None:
    c, (t, touch) = case.flight.columns, _since_touch(case.flight)
    past = c["x"] - np.interp(touch, c["t"], c["x"])
    curves = [1e3 * past, c["vx"], c["ax"], 1e3 * c[f"l{_front(case.flight)}"]]
    inside = (t > 1.1 * span[0]) & (t < 1.02 * span[1])  # the rest would only stretch the scales
    name = short("computed" if case.robot == "quad" else f"reading {case.reading.name}")
    for k, (ax, values) in enumerate(zip(column, curves, strict=False)):
        shown = name if k == 0 else f"_{name}"
        ax.plot(t[inside], values[inside], color=look[0], ls=look[1], label=shown)
    left = case.flight.measures.get("contact_time")
    if left is not None:
        speed = float(np.interp(touch + left, c["t"], c["vx"]))
        column[1].plot(1e3 * left, speed, "o", color=look[0], mec="white", ms=5, zorder=3,
                       label=f"_{name}, end of contact")  # fmt: skip


def _slider_print(column: Sequence[Axes], robot: str, surface: str) -> None:
    """What the paper prints, and where contact begins."""
    printed = TABLE_III[robot, surface]
    after = -printed.restitution * SLIDER_SPEED
    line: dict[str, Any] = {"color": INK, "lw": 0.9, "ls": (0, (6, 2, 1, 2))}
    for ax in column:
        ax.axvline(0.0, color=GREY, lw=0.9, ls=(0, (3, 2)), zorder=1.5, label="_contact begins")
    column[0].axhline(0.0, color=GREY, lw=0.9, ls=(0, (3, 2)), zorder=1.5, label="contact begins")
    column[0].axhline(1e3 * printed.travel, **line, label="printed value")
    column[1].axhline(after, label="_printed value", **line)
    column[1].margins(y=0.12)
    column[1].plot([], [], "o", color=GREY, mec="white", ms=5, label="end of contact")
    column[1].plot(
        1e3 * printed.contact_time, after, "D", color=INK, mfc="none", mew=1.3, ms=7, ls="none",
        zorder=4, label="the same, printed",
    )  # fmt: skip
    column[2].axhline(-printed.peak_acceleration, label="_printed value", **line)


@styled
def sweep_figure(results: SliderResults) -> Figure:
    """Peak acceleration against speed, without the sliding bar, and how much less ARQ's is."""
    names = [r.name for r in results.readings if any(p.reading == r.name for p in results.sweep)]
    looks, points = _reading_looks(results), {(p.reading, p.speed): p for p in results.sweep}
    speeds = sorted({p.speed for p in results.sweep})
    figure = StyledFigure(figsize=(WIDTH, 4.7 + 0.2 * (len(names) // 2)))
    upper, lower = figure.subplots(2, 1, sharex=True)
    bars = [("Quad", RED, [points[names[0], v].quad for v in speeds])] if names else []
    for n in names:
        bars.append((short(f"ARQ, reading {n}"), looks[n][0], [points[n, v].arq for v in speeds]))
    _bars(upper, speeds, bars)
    gaps = [
        (f"_{short(f'ARQ, reading {n}')}", looks[n][0], [points[n, v].gap for v in speeds])
        for n in names
    ]
    _bars(lower, speeds, gaps, first=1)
    last = SWEEP_SPEEDS[-1]
    lower.hlines(
        SWEEP_GAP, last - 0.5, last + 0.5, color=INK, lw=1.6,
        label=f"printed at {last:g} m/s: {SWEEP_GAP:.0f} m/s²",
    )  # fmt: skip
    upper.set_ylabel("Peak acceleration [m/s²]")
    lower.set_ylabel("Quad less ARQ [m/s²]")
    lower.set_xlabel("Speed at touch [m/s]")
    lower.set_xticks(speeds, [f"{v:g}" for v in speeds])
    figure.align_ylabels([upper, lower])
    figure.legend(*upper.get_legend_handles_labels(), loc="outside upper center", ncols=2)
    lower.legend(loc="upper left")
    return figure


def _bars(
    ax: Axes, speeds: Sequence[float], bars: list[tuple[str, str, list[float]]], first: int = 0
) -> None:
    """Groups of bars; ``first`` bars are left out on the left, to line up with the panel above."""
    hatches = ("", "//", "", "\\\\", "..", "xx", "--")
    width = 0.84 / max(len(bars) + first, 1)
    for k, (name, colour, heights) in enumerate(bars, first):
        left = [v - 0.42 + (k + 0.5) * width for v in speeds]
        ax.bar(
            left, heights, 0.92 * width, color=colour, label=name, hatch=hatches[k % len(hatches)],
            edgecolor="white", linewidth=0.0,
        )  # fmt: skip
    ax.grid(visible=False, axis="x")


@styled
def readings_figure(results: SliderResults) -> Figure:
    """Every reading against the four printed numbers of ARQ: ours over print, 1 is agreement."""
    rows = {
        (row.surface, row.reading, row.quantity): row.deviation
        for row in reversed(results.rows)  # so that the first of several, the prediction, stays
        if row.experiment == "Table III" and row.robot == "arq"
    }
    lines = [
        ("COR", "restitution_at_separation", "restitution_at_return"),
        ("peak\nacceleration", "impact_peak_acceleration", ""),
        ("travel", "travel", ""),
        ("contact\ntime", "contact_time", "time_to_return"),
    ]
    figure = StyledFigure(figsize=(WIDTH, 2.9 + _legend_room(len(results.readings))))
    axes = figure.subplots(1, 2, sharey=True, sharex=True)
    marks = ("s", "o", "^", "D", "v", "P")
    names, looks = [r.name for r in results.readings], _reading_looks(results)
    for ax, surface in zip(axes, SURFACES, strict=True):
        ax.axvspan(
            1 - AGREEMENT, 1 + AGREEMENT, color=SHADE, lw=0.0, zorder=0.1,
            label=f"within {100 * AGREEMENT:.0f} % of print",
        )  # fmt: skip
        ax.axvline(1.0, color=INK, lw=0.9, label="_agreement")
        for k, name in enumerate(names):
            shift = 0.5 * (k / max(len(names) - 1, 1) - 0.5)
            colour, look = looks[name][0], marks[k % len(marks)]
            for which, face in ((2, "white"), (1, colour)):
                found = [
                    (rows.get((surface, name, line[which])), y) for y, line in enumerate(lines)
                ]
                known = [(1.0 + share, y + shift) for share, y in found if share is not None]
                label = short(f"reading {name}")
                ax.plot(
                    [x for x, _ in known], [y for _, y in known], look, ms=6, mew=1.2, color=colour,
                    mfc=face, label=label if which == 1 else f"_{label}, at return",
                )  # fmt: skip
        ax.set_title(f"ARQ on the {surface}")
        ax.set_xlabel("ours / printed [-]")
        ax.xaxis.set_major_locator(MaxNLocator(5))
    axes[0].set_yticks(range(len(lines)), [line[0] for line in lines])
    axes[0].set_ylim(len(lines) - 0.5, -0.5)
    axes[0].plot([], [], "o", color=GREY, mfc="white", mew=1.2, ms=6, label="open: at return")
    figure.legend(
        *axes[0].get_legend_handles_labels(), loc="outside upper center", ncols=3, handlelength=1.4
    )
    return figure


@styled
def readme_figure(results: SliderResults, reading: str = "B") -> Figure:
    """ARQ and Quad hit the wall on the slider: velocity and acceleration, for a front page."""
    cases = predictions(results, "quad", "wall") + [
        case for case in predictions(results, "arq", "wall") if case.reading.name == reading
    ]
    figure = StyledFigure(figsize=(8.0, 3.0))
    left, right = figure.subplots(1, 2)
    for case in cases:
        (t, touch), (colour, line) = _since_touch(case.flight), ROBOT_LOOKS[case.robot]
        c, m, name = case.flight.columns, case.flight.measures, ROBOTS[case.robot]
        kind = f"{name}, {'rigid' if case.robot == 'quad' else 'compliant'} arms"
        for ax, column in ((left, "vx"), (right, "ax")):
            ax.plot(t, c[column], color=colour, ls=line, lw=2.4, label=kind)
        peak, when = m["impact_peak_acceleration"], m["impact_peak_acceleration_time"]
        if peak is not None and when is not None:
            at = 1e3 * (when - touch)
            right.plot(at, -peak, "o", color=colour, ms=5, label=f"_{kind}, peak")
            right.annotate(
                f"{name}: {peak:.0f} m/s²", (at, -peak), (48, 0), textcoords="offset points",
                color=colour, weight="bold", fontsize=10, va="center",
                arrowprops={"arrowstyle": "-", "color": colour, "lw": 1.0},
            )  # fmt: skip
    for ax, label in ((left, "Velocity [m/s]"), (right, "Acceleration [m/s²]")):
        ax.axvline(0.0, color=GREY, lw=0.9, ls=(0, (3, 2)), zorder=1.5, label="_first touch")
        ax.set_xlim(-8.0, 52.0)
        ax.set_xlabel("Time from first touch [ms]")
        ax.set_title(label)
    left.legend(loc="upper right", fontsize=10)
    return figure

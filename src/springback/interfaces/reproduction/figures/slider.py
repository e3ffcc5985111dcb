"""Figures of the slider tests, in the style of the paper's.

No physics is computed here: every number is a measure, a column of a trajectory or a printed value.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from springback.interfaces.figures.chart import Chart
from springback.interfaces.figures.panels import Array, arms_of, short
from springback.interfaces.figures.style import (
    LOOKS,
    WIDTH,
    Look,
    StyledFigure,
    escape,
    in_style,
)
from springback.interfaces.output.robots import GREY, INK, ROBOTS
from springback.paper.printed import SLIDER_SPEED, SWEEP_GAP, SWEEP_SPEEDS, TABLE_III
from springback.results.flight import Flight
from springback.studies.comparison import AGREEMENT

if TYPE_CHECKING:
    from springback.paper.slider import Case, SliderResults

FLOWN = ("quad", "arq")
"""Surfaces in the order of the paper."""
SURFACES = ("wall", "mat")
STATES = ("Position [mm]", "Velocity [m/s]", "Acceleration [m/s²]", "Arm length [mm]")
SPEED = "Speed at touch [m/s]"
SINCE = "Time from first touch [ms]"
END: Look = {"marker": "o", "mec": "white", "ms": 5, "ls": "none"}
"""Mark of the end of contact."""


def predictions(results: SliderResults, robot: str, surface: str) -> list[Case]:
    """First case of every reading, with Quad's c_a."""
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
    """Additional height for the legend of more than three readings, three per line [in]."""
    return 0.2 * max(0, -(-readings // 3) - 1)


@in_style
def slider_figure(results: SliderResults, robot: str) -> Figure:
    """A robot hits wall and mat: position, velocity, acceleration, and arm length if arms slide.

    Dash-dotted lines mark printed values of the paper's simulation; a diamond its contact time.

    Args:
        results: Results of the slider tests.
        robot: ``quad`` or ``arq``.
    """
    flown = {surface: predictions(results, robot, surface) for surface in SURFACES}
    flights = [case.flight for cases in flown.values() for case in cases]
    looks = _reading_looks(results)
    slides = any(np.ptp(f.columns[f"l{_front(f)}"]) > 1e-9 for f in flights)
    labels = STATES if slides else STATES[:3]
    figure = StyledFigure(figsize=(WIDTH, 0.9 + 1.3 * len(labels) + _legend_room(len(looks))))
    axes = figure.subplots(len(labels), 2, sharex="col", sharey="row", squeeze=False)
    for column, (surface, cases) in zip(axes.T, flown.items(), strict=True):
        title = f"{ROBOTS[robot].label} on the {surface}"
        charts = [
            Chart(ax, SINCE, label, title, titled=ax is column[0])
            for ax, label in zip(column, labels, strict=True)
        ]
        span = _slider_times(robot, surface, cases)
        for case in cases:
            _slider_curves(charts, case, looks.get(case.reading.name, LOOKS[0]), span)
        _slider_print(charts, robot, surface)
        column[-1].set_xlim(*span)
    for ax in axes[:, 0]:
        ax.yaxis.set_major_locator(MaxNLocator(5, steps=[1, 2, 5, 10]))
    figure.align_ylabels(axes[:, 0])
    legends = [axes[row, 0].get_legend_handles_labels() for row in (0, 1)]
    handles, names = (a + b for a, b in zip(*legends, strict=True))
    figure.legend(handles, names, loc="outside upper center", ncols=3)
    return figure


def _front(flight: Flight) -> int:
    """Index of the arm with the largest compression."""
    return max(arms_of(flight.columns), key=lambda j: float(np.max(flight.columns[f"fn{j}"])))


def _since_touch(flight: Flight) -> tuple[Array, float]:
    """Time from first touch [ms], and its instant [s]."""
    touch = flight.measures.get("touch_time") or 0.0
    return 1e3 * (flight.columns["t"] - touch), touch


def _slider_times(robot: str, surface: str, cases: Sequence[Case]) -> tuple[float, float]:
    shown = [TABLE_III[robot, surface].contact_time]
    for case in cases:
        measures = case.flight.measures
        shown += [measures.get("time_to_return") or 0.0, measures.get("contact_time") or 0.0]
    return -0.15e3 * max(shown), 1.3e3 * max(shown)


def _slider_curves(
    charts: Sequence[Chart], case: Case, look: Look, span: tuple[float, float]
) -> None:
    c, (t, touch) = case.flight.columns, _since_touch(case.flight)
    past = c["x"] - np.interp(touch, c["t"], c["x"])
    curves = [1e3 * past, c["vx"], c["ax"], 1e3 * c[f"l{_front(case.flight)}"]]
    inside = (t > 1.1 * span[0]) & (t < 1.02 * span[1])  # later times would only stretch the scales
    name = short("computed" if case.robot == "quad" else f"reading {case.reading.name}")
    for k, (chart, values) in enumerate(zip(charts, curves, strict=False)):
        chart.curve(name, t[inside], values[inside], key=k == 0, **look)
    left = case.flight.measures.get("contact_time")
    if left is not None:
        speed = float(np.interp(touch + left, c["t"], c["vx"]))
        end = END | {"color": look["color"], "zorder": 3}
        charts[1].curve(f"{name}, end of contact", 1e3 * left, speed, key=False, **end)


def _slider_print(charts: Sequence[Chart], robot: str, surface: str) -> None:
    """Draw printed values, and the beginning of contact."""
    printed = TABLE_III[robot, surface]
    after = -printed.restitution * SLIDER_SPEED
    line: Look = {"color": INK, "ls": (0, (6, 2, 1, 2)), "zorder": 2}
    for chart in charts:
        chart.vline("contact begins", 0.0)
    charts[0].hline("contact begins", 0.0, key=True)
    charts[0].hline("printed value", 1e3 * printed.travel, key=True, **line)
    charts[1].hline("printed value", after, **line)
    charts[1].ax.margins(y=0.12)
    charts[1].key("end of contact", **END, color=GREY)
    charts[1].curve(
        "the same, printed", 1e3 * printed.contact_time, after, marker="D", color=INK, mfc="none",
        mew=1.3, ms=7, ls="none", zorder=4,
    )  # fmt: skip
    charts[2].hline("printed value", -printed.peak_acceleration, **line)


@in_style
def sweep_figure(results: SliderResults) -> Figure:
    """Peak acceleration over speed, without the sliding bar, and the difference of the robots."""
    names = [r.name for r in results.readings if any(p.reading == r.name for p in results.sweep)]
    looks, points = _reading_looks(results), {(p.reading, p.speed): p for p in results.sweep}
    speeds = sorted({p.speed for p in results.sweep})
    figure = StyledFigure(figsize=(WIDTH, 4.7 + 0.2 * (len(names) // 2)))
    upper, lower = figure.subplots(2, 1, sharex=True)
    quad = ROBOTS["quad"]
    bars = [(quad.label, quad.colour, [points[names[0], v].quad for v in speeds])] if names else []
    gaps = []
    for n in names:
        label, colour = short(f"ARQ, reading {n}"), looks[n]["color"]
        bars.append((label, colour, [points[n, v].arq for v in speeds]))
        gaps.append((label, colour, [points[n, v].gap for v in speeds]))
    _bars(Chart(upper, SPEED, "Peak acceleration [m/s²]"), speeds, bars)
    below = Chart(lower, SPEED, "Quad less ARQ [m/s²]")
    _bars(below, speeds, gaps, first=1)
    last, printed = SWEEP_SPEEDS[-1], f"printed at {SWEEP_SPEEDS[-1]:g} m/s: {SWEEP_GAP:.0f} m/s²"
    below.record(printed, {SPEED: last, below.y: SWEEP_GAP})
    key = lower.hlines(SWEEP_GAP, last - 0.5, last + 0.5, color=INK, lw=1.6, label=printed)
    lower.set_xticks(speeds, [f"{v:g}" for v in speeds])
    figure.align_ylabels([upper, lower])
    figure.legend(*upper.get_legend_handles_labels(), loc="outside upper center", ncols=2)
    lower.legend(handles=[key], loc="upper left")
    return figure


def _bars(
    chart: Chart, speeds: Sequence[float], bars: list[tuple[str, str, list[float]]], first: int = 0
) -> None:
    """Draw groups of bars; ``first`` bars are left out to align with the panel above."""
    hatches = ("", "//", "", "\\\\", "..", "xx", "--")
    width = 0.84 / max(len(bars) + first, 1)
    for k, (name, colour, heights) in enumerate(bars, first):
        left = [v - 0.42 + (k + 0.5) * width for v in speeds]
        chart.record(name, {chart.x: speeds, chart.y: heights})
        chart.ax.bar(
            left, heights, 0.92 * width, color=colour, label=escape(name), edgecolor="white",
            hatch=hatches[k % len(hatches)], linewidth=0.0,
        )  # fmt: skip
    chart.ax.grid(visible=False, axis="x")


@in_style
def readings_figure(results: SliderResults) -> Figure:
    """ARQ's four numbers in every reading, divided by the printed ones."""
    rows = {
        (row.surface, row.reading, row.quantity): row.deviation
        for row in reversed(results.rows)  # the first of several, the prediction, wins
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
        chart = Chart(ax, "ours / printed [-]", "category", f"ARQ on the {surface}")
        chart.span(
            f"within {100 * AGREEMENT:.0f} % of print", 1 - AGREEMENT, 1 + AGREEMENT, key=True
        )
        chart.vline("agreement", 1.0, color=INK, ls="-")
        for k, name in enumerate(names):
            shift = 0.5 * (k / max(len(names) - 1, 1) - 0.5)
            colour, label = looks[name]["color"], short(f"reading {name}")
            for which, face in ((2, "white"), (1, colour)):
                found = [
                    (rows.get((surface, name, line[which])), y) for y, line in enumerate(lines)
                ]
                known = [(share, y) for share, y in found if share is not None]
                chart.curve(
                    label if which == 1 else f"{label}, at return",
                    [1.0 + share for share, _ in known], [y + shift for _, y in known],
                    key=which == 1, columns={chart.y: [lines[y][0] for _, y in known]},
                    marker=marks[k % len(marks)], ls="none", ms=6, mew=1.2, color=colour, mfc=face,
                )  # fmt: skip
        ax.xaxis.set_major_locator(MaxNLocator(5))
    axes[0].set_yticks(range(len(lines)), [line[0] for line in lines])
    axes[0].set_ylim(len(lines) - 0.5, -0.5)
    axes[0].plot([], [], "o", color=GREY, mfc="white", mew=1.2, ms=6, label="open: at return")
    figure.legend(
        *axes[0].get_legend_handles_labels(), loc="outside upper center", ncols=3, handlelength=1.4
    )
    return figure


@in_style
def readme_figure(results: SliderResults, reading: str = "B") -> Figure:
    """Velocity and acceleration of ARQ and Quad hitting the wall on the slider, for the README."""
    cases = predictions(results, "quad", "wall") + [
        case for case in predictions(results, "arq", "wall") if case.reading.name == reading
    ]
    figure = StyledFigure(figsize=(8.0, 3.0))
    left, right = (
        Chart(ax, SINCE, label, label)
        for ax, label in zip(figure.subplots(1, 2), STATES[1:3], strict=True)
    )
    for case in cases:
        (t, touch), look = _since_touch(case.flight), ROBOTS[case.robot]
        c, m = case.flight.columns, case.flight.measures
        kind = f"{look.label}, {'rigid' if case.robot == 'quad' else 'compliant'} arms"
        for chart, column in ((left, "vx"), (right, "ax")):
            chart.curve(kind, t, c[column], lw=2.4, **look.curve)
        peak, when = m["impact_peak_acceleration"], m["impact_peak_acceleration_time"]
        if peak is not None and when is not None:
            at, colour = 1e3 * (when - touch), look.colour
            right.curve(f"{kind}, peak", at, -peak, key=False, color=colour, marker="o", ms=5)
            right.ax.annotate(
                f"{look.label}: {peak:.0f} m/s²", (at, -peak), (48, 0), textcoords="offset points",
                color=colour, weight="bold", fontsize=10, va="center",
                arrowprops={"arrowstyle": "-", "color": colour, "lw": 1.0},
            )  # fmt: skip
    for chart in (left, right):
        chart.vline("first touch", 0.0)
        chart.ax.set_ylabel("")  # used as the title
        chart.ax.set_xlim(-8.0, 52.0)
    left.ax.legend(loc="upper right", fontsize=10)
    return figure

"""Figures of features and free flight: steps, circles, Table IV, hover time.

No physics is computed here: every number is a column of a trajectory, a compared number or a
printed value.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, FuncFormatter, MaxNLocator, NullLocator

from springback.interfaces.figures.chart import Chart
from springback.interfaces.figures.panels import Array, widen_flat_axis
from springback.interfaces.figures.style import WIDTH, StyledFigure, in_style
from springback.interfaces.output.robots import GREEN, INK, RobotStyle
from springback.interfaces.output.robots import ROBOTS as KNOWN
from springback.paper.features import TABLE_I
from springback.paper.free_flight import (
    DWELL,
    PERIODS,
    QUANTITIES,
    ROBOTS,
    STEP_BEGINS,
    STEP_FROM,
    TABLE_IV_CIRCLES,
    TABLE_IV_STEPS,
    FlightResults,
)
from springback.paper.responses import Axis
from springback.results.flight import Flight
from springback.vehicle.endurance import endurance_curve, largest_payload
from springback.vehicle.library import VEHICLES

ROBOT_STYLES = {
    "quad": KNOWN["quad"],
    "arq": KNOWN["arq"]._replace(label="ARQ pre-col"),
    "arq after drops": RobotStyle("ARQ post-col", GREEN, (0, (1.2, 2.4)), "^"),
}
"""Columns of Table IV, labelled as printed."""
WANTED: dict[str, Any] = {"color": INK, "ls": (0, (6, 2, 1, 2)), "lw": 0.9}
RATIO = "ours / printed [-]"
DOTTED = (0, (1.2, 1.2))
DIAMOND: dict[str, Any] = {
    "marker": "D",
    "mfc": "none",
    "mew": 1.3,
    "ms": 7,
    "ls": "none",
    "zorder": 4,
}
BAND = 0.10
"""Chosen: relative deviation from the printed value that is shaded as close."""
SHOWN_BEFORE, SHOWN_AFTER = 0.3, 3.0
"""Chosen: time shown before and after a new set-point [s]."""
DRAWN = 0.02
"""Chosen: spacing of the points of drawn curves, all of which are smooth [s]."""
PACES = tuple(PERIODS)
AXES: tuple[Axis, ...] = ("x", "y", "z")
ERRORS = {"x": "m", "y": "m", "vx": "m/s", "vy": "m/s"}
"""Errors on a circle, and their units."""


def first_flights(runs: Sequence[Any]) -> dict[str, Flight]:
    """First flight with a trajectory, by robot."""
    found: dict[str, Flight] = {}
    for run in runs:
        if run.flight is not None and run.flight.columns:
            found.setdefault(run.robot, run.flight)
    return found


def circle_flights(results: FlightResults, pace: str) -> dict[str, Flight]:
    """`first_flights` of the circles of one pace."""
    return first_flights([run for run in results.circles if run.pace == pace])


def step_window(flight: Flight, axis: Axis) -> tuple[Array, Array, Array]:
    """Time since the step of an axis [s], its position, and its set-point [m]."""
    c, d, begins = flight.columns, flight.telemetry, STEP_BEGINS[axis]
    inside = (c["t"] >= begins - SHOWN_BEFORE) & (c["t"] < begins + DWELL)
    t = c["t"][inside]
    wanted = d[f"ref_{axis}"][np.clip(np.searchsorted(d["t"], t, "right") - 1, 0, None)]
    return t - begins, c[axis][inside], wanted


def _drawn(t: Array, *curves: Array) -> list[Array]:
    """Samples of curves spaced by `DRAWN`."""
    at = np.arange(t[0], t[-1], DRAWN)
    return [np.interp(at, t, curve) for curve in (t, *curves)]


@in_style
def steps_figure(results: FlightResults) -> Figure:
    """Step responses to 1 m by axis, all robots in one panel."""
    figure = StyledFigure(figsize=(WIDTH, 4.6))
    axes = figure.subplots(3, 1, sharex=True)
    flown = first_flights(results.responses)
    for ax, axis in zip(axes, AXES, strict=True):
        chart = Chart(ax, "Time from the new set-point [s]", f"{axis} [m]")
        for k, (robot, flight) in enumerate(flown.items()):
            t, at, wanted = step_window(flight, axis)
            if k == 0:
                chart.curve("set-point", t, wanted, **WANTED)
            chart.curve(ROBOT_STYLES[robot].label, t, at, **ROBOT_STYLES[robot].curve)
        ax.set_ylim(STEP_FROM[axis] - 0.15, STEP_FROM[axis] + 1.25)
    axes[-1].set_xlim(-SHOWN_BEFORE, SHOWN_AFTER)
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside upper center", ncols=4)
    return figure


def circle_errors_over_time(flight: Flight) -> dict[str, Array]:
    """Tracking errors at the ticks: x, y [m], vx, vy [m/s], with t [s]."""
    c, d = flight.columns, flight.telemetry
    errors = {name: d[f"ref_{name}"] - np.interp(d["t"], c["t"], c[name]) for name in ERRORS}
    return {"t": d["t"], **errors}


@in_style
def circles_figure(results: FlightResults) -> Figure:
    """Circles from above, and below them the tracking errors of position and velocity."""
    figure = StyledFigure(figsize=(WIDTH, 6.6))
    above, below = figure.subfigures(2, 1, squeeze=False, height_ratios=(2.5, 4.1))[:, 0]
    planes = above.subplots(1, 2, sharey=True)
    panels = below.subplots(4, 2, sharex="col", sharey="row")
    for plane, column, pace in zip(planes, panels.T, PACES, strict=True):
        above_chart = Chart(plane, "x [m]", "y [m]", f"{pace} circle")
        errors = [
            Chart(
                ax, "Time [s]", f"{name} [{unit}]", f"{pace} circle, reference less flown",
                titled=False,
            )
            for ax, (name, unit) in zip(column, ERRORS.items(), strict=True)
        ]  # fmt: skip
        column[0].set_title("reference less flown")
        _circle_column(above_chart, errors, circle_flights(results, pace))
    below.align_ylabels(panels[:, 0])
    above.legend(*planes[0].get_legend_handles_labels(), loc="outside upper center", ncols=4)
    return figure


def _circle_column(plane: Chart, column: Sequence[Chart], flown: Mapping[str, Flight]) -> None:
    for k, (robot, flight) in enumerate(flown.items()):
        c, d, look = flight.columns, flight.telemetry, ROBOT_STYLES[robot]
        if k == 0:
            plane.curve("reference", d["ref_x"], d["ref_y"], zorder=2.5, **WANTED)
            start: dict[str, Any] = {"color": INK, "marker": "o", "ms": 4, "zorder": 3}
            plane.curve("start", d["ref_x"][0], d["ref_y"][0], key=False, **start)
        _, x, y = _drawn(c["t"], c["x"], c["y"])
        plane.curve(look.label, x, y, lw=1.2, **look.curve)
        t, *errors = _drawn(*circle_errors_over_time(flight).values())
        for chart, error in zip(column, errors, strict=True):
            chart.curve(look.label, t, error, key=False, lw=1.2, **look.curve)
            chart.ax.set_xlim(0.0, t[-1])
    plane.ax.set_aspect("equal")
    for chart in column:
        widen_flat_axis(chart.ax, 0.02, 0.02)
        chart.ax.yaxis.set_major_locator(MaxNLocator(4))


class Ratio(NamedTuple):
    """A number of Table IV."""

    robot: str
    test: str  # rise, mse, slow or fast
    name: str
    ours: tuple[float, ...]  # by trial
    printed: float

    @property
    def ratio(self) -> float:
        """Mean of ours divided by print."""
        return float(np.mean(self.ours)) / self.printed

    @property
    def line(self) -> str:
        """Name, the same for all robots."""
        kind = {"rise": "rise time", "mse": "MSE"}.get(self.test, self.test)
        return f"{kind}, {self.name}"


def table_iv(results: FlightResults) -> list[Ratio]:
    """Numbers of Table IV with ours by trial; trials without one are left out."""
    cells = []
    for robot in ROBOTS:
        responses = [r for r in results.responses if r.robot == robot]
        for k, test in enumerate(("rise", "mse")):
            for axis, printed in TABLE_IV_STEPS[robot].items():
                found = tuple(getattr(r, test)[axis] for r in responses)
                cells.append(Ratio(robot, test, axis, found, printed[k]))
        for pace in PERIODS:
            runs = [r for r in results.circles if (r.robot, r.pace) == (robot, pace)]
            prints = TABLE_IV_CIRCLES[robot, pace]
            for name, number in zip(QUANTITIES, prints, strict=True):
                found = tuple(run.mse[name] for run in runs)
                cells.append(Ratio(robot, pace, name, found, number))
    kept = [cell._replace(ours=tuple(v for v in cell.ours if v is not None)) for cell in cells]
    return [cell for cell in kept if cell.ours]


@in_style
def table_iv_figure(results: FlightResults) -> Figure:
    """Numbers of Table IV, ours divided by print; bars span the trials."""
    cells = table_iv(results)
    figure = StyledFigure(figsize=(WIDTH, 3.7))
    left, right = figure.subplots(1, 2)
    _ratios(
        Chart(left, RATIO, "category", "Steps"),
        [cell for cell in cells if cell.test in ("rise", "mse")],
    )
    right.set_xscale("log")
    _ratios(
        Chart(right, RATIO, "category", "Circles, MSE"),
        [cell for cell in cells if cell.test in PACES],
    )
    figure.legend(
        *left.get_legend_handles_labels(), loc="outside upper center", ncols=4, handlelength=1.4
    )
    return figure


def _ratios(chart: Chart, cells: Sequence[Ratio]) -> None:
    ax, lines = chart.ax, list(dict.fromkeys(cell.line for cell in cells))
    chart.span(f"±{100 * BAND:.0f} % of print", 1 - BAND, 1 + BAND, key=True)
    chart.vline("agreement", 1.0, color=INK, ls="-")
    for k, (robot, look) in enumerate(ROBOT_STYLES.items()):
        own = [cell for cell in cells if cell.robot == robot]
        if own:
            names = [cell.line for cell in own]
            y = np.array([lines.index(name) for name in names]) + 0.25 * (k - 1)
            ratio, least, most = np.array(
                [(c.ratio, min(c.ours) / c.printed, max(c.ours) / c.printed) for c in own]
            ).T
            chart.errorbars(
                look.label, ratio, y, least, most, across=True, columns={chart.y: names},
                fmt=look.marker, ms=5, lw=1.1, color=look.colour,
            )  # fmt: skip
    ax.set_yticks(range(len(lines)), lines)
    ax.set_ylim(len(lines) - 0.5, -0.5)
    low, high = ax.get_xlim()
    if ax.get_xscale() == "linear":
        ax.set_xlim(min(low, 1 - 1.3 * BAND), max(high, 1 + 1.3 * BAND))
    else:
        ratios = [1 - BAND, 1 + BAND, *(c.ratio for c in cells)]
        low, high = min(ratios) / 1.3, 1.3 * max(ratios)
        ax.set_xlim(low, high)
        ticks = [v for v in (0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0) if low <= v <= high]
        ax.xaxis.set_major_locator(FixedLocator(ticks))
        ax.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        ax.xaxis.set_minor_locator(NullLocator())


def endurance_points(robot: str, count: int = 60) -> tuple[Array, Array]:
    """Payloads [kg] up to the largest, and hover time with each [s]."""
    vehicle = VEHICLES[robot].vehicle
    payloads = np.linspace(0.0, largest_payload(vehicle), count)
    return payloads, endurance_curve(vehicle, payloads)


@in_style
def endurance_figure() -> Figure:
    """Hover time over payload; diamonds are printed hover times, lines printed payloads."""
    figure = StyledFigure(figsize=(WIDTH, 2.8))
    ax = figure.subplots()
    chart = Chart(ax, "Payload [kg]", "Hover time [min]")
    for robot, printed in TABLE_I.items():
        look = KNOWN[robot]
        payloads, times = endurance_points(robot)
        chart.curve(look.label, payloads, times / 60.0, **look.curve)
        largest: dict[str, Any] = {"color": look.colour, "ls": DOTTED, "lw": 1.1}
        chart.vline(f"{look.label}, largest payload, printed", printed.largest_payload, **largest)
        chart.curve(
            f"{look.label}, hover time, printed", 0.0, printed.hover_time / 60.0, key=False,
            color=look.colour, clip_on=False, **DIAMOND,
        )  # fmt: skip
    chart.key("largest payload, printed", color=INK, ls=DOTTED, lw=1.1)
    chart.key("hover time, printed", color=INK, **DIAMOND)
    ax.set_xlim(0.0, None)
    ax.set_ylim(0.0, None)
    figure.legend(*ax.get_legend_handles_labels(), loc="outside upper center", ncols=2)
    return figure

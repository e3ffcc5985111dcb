"""Figures of features and free flight: steps, circles, Table IV against print, hover time.

Nothing here computes physics: every number shown is a trajectory column, a compared number or a
printed value.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, FuncFormatter, MaxNLocator, NullLocator

from springback.interfaces.figures.panels import Array, spread
from springback.interfaces.figures.style import (
    BLUE,
    GREEN,
    INK,
    RED,
    SHADE,
    WIDTH,
    Look,
    StyledFigure,
    styled,
)
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

NAMES = {"quad": "Quad", "arq": "ARQ pre-col", "arq after drops": "ARQ post-col"}
"""Columns of Table IV, as printed."""
FLIGHT_LOOKS: dict[str, Look] = {
    "quad": (RED, (0, (5, 1.5))), "arq": (BLUE, "-"), "arq after drops": (GREEN, (0, (1.2, 2.4))),
}  # fmt: skip
MARKERS = {"quad": "s", "arq": "o", "arq after drops": "^"}
WANTED: Look = (INK, (0, (6, 2, 1, 2)))
DOTTED = (0, (1.2, 1.2))
DIAMOND: dict[str, Any] = {"mfc": "none", "mew": 1.3, "ms": 7, "ls": "none", "zorder": 4}
BAND = 0.10
"""Chosen: share of the printed value that is shaded as close to it."""
SHOWN_BEFORE, SHOWN_AFTER = 0.3, 3.0
"""[s], chosen: before and after a new set-point, as much as is shown."""
DRAWN = 0.02
"""[s], chosen: between the points of a curve that is drawn; all are smooth."""
PACES = tuple(PERIODS)
AXES: tuple[Axis, ...] = ("x", "y", "z")
ERRORS = {"x": "m", "y": "m", "vx": "m/s", "vy": "m/s"}
"""What errs on a circle, and in which unit."""


def first_flights(runs: Sequence[Any]) -> dict[str, Flight]:
    """The first flight that kept its trajectory, by robot."""
    found: dict[str, Flight] = {}
    for run in runs:
        if run.flight is not None and run.flight.columns:
            found.setdefault(run.robot, run.flight)
    return found


def circle_flights(results: FlightResults, pace: str) -> dict[str, Flight]:
    """`first_flights` of the circles of one pace."""
    return first_flights([run for run in results.circles if run.pace == pace])


def step_window(flight: Flight, axis: Axis) -> tuple[Array, Array, Array]:
    """Time since an axis was asked to step [s], where it is, and where it was asked to be [m]."""
    c, d, begins = flight.columns, flight.telemetry, STEP_BEGINS[axis]
    inside = (c["t"] >= begins - SHOWN_BEFORE) & (c["t"] < begins + DWELL)
    t = c["t"][inside]
    wanted = d[f"ref_{axis}"][np.clip(np.searchsorted(d["t"], t, "right") - 1, 0, None)]
    return t - begins, c[axis][inside], wanted


def _drawn(t: Array, *curves: Array) -> list[Array]:
    """Curves at instants `DRAWN` apart."""
    at = np.arange(t[0], t[-1], DRAWN)
    return [np.interp(at, t, curve) for curve in (t, *curves)]


@styled
def steps_figure(results: FlightResults) -> Figure:
    """Each axis from the moment it is asked to step by 1 m, all robots in one panel."""
    figure = StyledFigure(figsize=(WIDTH, 4.6))
    axes = figure.subplots(3, 1, sharex=True)
    flown = first_flights(results.responses)
    for ax, axis in zip(axes, AXES, strict=True):
        for k, (robot, flight) in enumerate(flown.items()):
            t, at, wanted = step_window(flight, axis)
            if k == 0:
                ax.plot(t, wanted, color=WANTED[0], ls=WANTED[1], lw=0.9, label="set-point")
            colour, line = FLIGHT_LOOKS[robot]
            ax.plot(t, at, color=colour, ls=line, label=NAMES[robot])
        ax.set_ylabel(f"{axis} [m]")
        ax.set_ylim(STEP_FROM[axis] - 0.15, STEP_FROM[axis] + 1.25)
    axes[-1].set_xlabel("Time from the new set-point [s]")
    axes[-1].set_xlim(-SHOWN_BEFORE, SHOWN_AFTER)
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside upper center", ncols=4)
    return figure


def circle_errors_over_time(flight: Flight) -> dict[str, Array]:
    """Wanted less flown over the ticks: x, y [m], vx, vy [m/s], beside t [s]."""
    c, d = flight.columns, flight.telemetry
    errors = {name: d[f"ref_{name}"] - np.interp(d["t"], c["t"], c[name]) for name in ERRORS}
    return {"t": d["t"], **errors}


@styled
def circles_figure(results: FlightResults) -> Figure:
    """Circles from above, and below them the errors of position and velocity over time."""
    figure = StyledFigure(figsize=(WIDTH, 6.6))
    above, below = figure.subfigures(2, 1, squeeze=False, height_ratios=(2.5, 4.1))[:, 0]
    planes = above.subplots(1, 2, sharey=True)
    panels = below.subplots(4, 2, sharex="col", sharey="row")
    for plane, column, pace in zip(planes, panels.T, PACES, strict=True):
        _circle_column(plane, column, circle_flights(results, pace))
        plane.set_title(f"{pace} circle")
        column[-1].set_xlabel("Time [s]")
    planes[0].set_ylabel("y [m]")
    for ax, (name, unit) in zip(panels[:, 0], ERRORS.items(), strict=True):
        ax.set_ylabel(f"{name} [{unit}]")
    for row in panels:
        for ax, pace in zip(row, PACES, strict=True):
            ax.set_label(f"{pace} circle, reference less flown")
    for ax in panels[0]:
        ax.set_title("reference less flown")
    below.align_ylabels(panels[:, 0])
    above.legend(*planes[0].get_legend_handles_labels(), loc="outside upper center", ncols=4)
    return figure


def _circle_column(plane: Axes, column: Sequence[Axes], flown: Mapping[str, Flight]) -> None:
    for k, (robot, flight) in enumerate(flown.items()):
        c, d, (colour, line) = flight.columns, flight.telemetry, FLIGHT_LOOKS[robot]
        if k == 0:
            look: dict[str, Any] = {"color": WANTED[0], "ls": WANTED[1], "lw": 0.9, "zorder": 2.5}
            plane.plot(d["ref_x"], d["ref_y"], label="reference", **look)
            plane.plot(d["ref_x"][0], d["ref_y"][0], "o", color=INK, ms=4, zorder=3, label="_start")
        _, x, y = _drawn(c["t"], c["x"], c["y"])
        plane.plot(x, y, color=colour, ls=line, lw=1.2, label=NAMES[robot])
        t, *errors = _drawn(*circle_errors_over_time(flight).values())
        for ax, error in zip(column, errors, strict=True):
            ax.plot(t, error, color=colour, ls=line, lw=1.2, label=f"_{NAMES[robot]}")
            ax.set_xlim(0.0, t[-1])
    plane.set_aspect("equal")
    plane.set_xlabel("x [m]")
    for ax in column:
        spread(ax, 0.02, 0.02)
        ax.yaxis.set_major_locator(MaxNLocator(4))


class Ratio(NamedTuple):
    """A number of Table IV."""

    robot: str
    test: str  # rise, mse, slow or fast
    name: str
    ours: tuple[float, ...]  # trial by trial
    printed: float

    @property
    def ratio(self) -> float:
        """Mean of ours over print."""
        return float(np.mean(self.ours)) / self.printed


def table_iv(results: FlightResults) -> list[Ratio]:
    """Every number of Table IV with ours, trial by trial; trials without one are left out."""
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


@styled
def table_iv_figure(results: FlightResults) -> Figure:
    """Every number of Table IV: ours over print, 1 is agreement; bars span the trials."""
    cells = table_iv(results)
    figure = StyledFigure(figsize=(WIDTH, 3.7))
    left, right = figure.subplots(1, 2)
    _ratios(left, [cell for cell in cells if cell.test in ("rise", "mse")], "step")
    _ratios(right, [cell for cell in cells if cell.test in PACES], "circle")
    left.set_title("Steps")
    right.set_title("Circles, MSE")
    figure.legend(
        *left.get_legend_handles_labels(), loc="outside upper center", ncols=4, handlelength=1.4
    )
    return figure


def _ratios(ax: Axes, cells: Sequence[Ratio], kind: str) -> None:
    lines = list(dict.fromkeys((cell.test, cell.name) for cell in cells))
    ax.axvspan(
        1 - BAND, 1 + BAND, color=SHADE, lw=0.0, zorder=0.1, label=f"±{100 * BAND:.0f} % of print"
    )
    ax.axvline(1.0, color=INK, lw=0.9, label="_agreement")
    for k, robot in enumerate(NAMES):
        own = [cell for cell in cells if cell.robot == robot]
        if not own:
            continue
        y = np.array([lines.index((c.test, c.name)) for c in own]) + 0.25 * (k - 1)
        ratio = np.array([c.ratio for c in own])
        least = np.array([min(c.ours) / c.printed for c in own])
        most = np.array([max(c.ours) / c.printed for c in own])
        ax.errorbar(
            ratio, y, xerr=(ratio - least, most - ratio), fmt=MARKERS[robot], ms=5, lw=1.1,
            color=FLIGHT_LOOKS[robot][0], label=NAMES[robot],
        )  # fmt: skip
    ax.set_yticks(range(len(lines)), [_line_name(*line) for line in lines])
    ax.set_ylim(len(lines) - 0.5, -0.5)
    ax.set_xlabel("ours / printed [-]")
    low, high = ax.get_xlim()
    if kind == "step":
        ax.set_xlim(min(low, 1 - 1.3 * BAND), max(high, 1 + 1.3 * BAND))
    else:
        ratios = [1 - BAND, 1 + BAND, *(c.ratio for c in cells)]
        ax.set_xscale("log")
        low, high = min(ratios) / 1.3, 1.3 * max(ratios)
        ax.set_xlim(low, high)
        ticks = [v for v in (0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0) if low <= v <= high]
        ax.xaxis.set_major_locator(FixedLocator(ticks))
        ax.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        ax.xaxis.set_minor_locator(NullLocator())


def _line_name(test: str, name: str) -> str:
    return {"rise": f"rise time, {name}", "mse": f"MSE, {name}"}.get(test, f"{test}, {name}")


def endurance_points(robot: str, count: int = 60) -> tuple[Array, Array]:
    """Payloads [kg] up to the largest, and how long a robot hovers with each [s]."""
    vehicle = VEHICLES[robot].vehicle
    payloads = np.linspace(0.0, largest_payload(vehicle), count)
    return payloads, endurance_curve(vehicle, payloads)


@styled
def endurance_figure() -> Figure:
    """Hover time against payload; diamonds are printed hover times, lines printed payloads."""
    figure = StyledFigure(figsize=(WIDTH, 2.8))
    ax = figure.subplots()
    for robot, printed in TABLE_I.items():
        colour, line = FLIGHT_LOOKS[robot]
        payloads, times = endurance_points(robot)
        ax.plot(payloads, times / 60.0, color=colour, ls=line, label=NAMES[robot].split()[0])
        name = NAMES[robot].split()[0]
        ax.axvline(
            printed.largest_payload, color=colour, ls=DOTTED, lw=1.1, zorder=1.5,
            label=f"_{name}, largest payload, printed",
        )  # fmt: skip
        ax.plot(
            0.0, printed.hover_time / 60.0, "D", color=colour, clip_on=False,
            label=f"_{name}, hover time, printed", **DIAMOND,
        )  # fmt: skip
    ax.plot([], [], color=INK, ls=DOTTED, lw=1.1, label="largest payload, printed")
    ax.plot([], [], "D", color=INK, label="hover time, printed", **DIAMOND)
    ax.set_xlim(0.0, None)
    ax.set_ylim(0.0, None)
    ax.set_xlabel("Payload [kg]")
    ax.set_ylabel("Hover time [min]")
    figure.legend(*ax.get_legend_handles_labels(), loc="outside upper center", ncols=2)
    return figure

"""Figures of the study of collision detection and characterisation."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Sequence

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, MaxNLocator, NullFormatter, StrMethodFormatter

from springback.interfaces.figures.chart import Chart
from springback.interfaces.figures.style import LOOKS, WIDTH, StyledFigure, in_style
from springback.interfaces.output.robots import GREY, INK, robot_label
from springback.studies.detection import (
    CHARACTERISED_FROM,
    IN_TIME,
    SIGNALS,
    SOURCES,
    SPEEDS,
    DetectionResults,
)
from springback.studies.detection_tables import default_threshold, sizes
from springback.studies.roc import RocPoint

WIDE = 1.55 * WIDTH
"""Width of a figure with a column for each trigger [in]."""
WIDEST = 18
"""Names of robots are wrapped if longer than this [characters]."""
TRIGGERS = {
    "hall": ("Hall", 1e3, "Compression [mm]"),
    "acceleration": ("accelerometer", 1.0, "Specific force [m/s²]"),
    "wrench": ("wrench", 1.0, "External force [N]"),
    "momentum": ("momentum", 1.0, "External force [N]"),
}
"""Title, scale, and axis label of the threshold."""
MANY = 3e3
"""Largest rate of false alarms of a receiver operating curve [1/h]: one per 1.2 s, almost as often
as the refractory time of 1 s permits."""


def _height(results: DetectionResults) -> float:
    """Height of a figure with a row for each robot [in]."""
    lines = sum(_title(robot, "").count("\n") for robot in results.robots)
    return 0.6 + 1.9 * len(results.robots) + 0.12 * lines


def _title(robot: str, what: str) -> str:
    """Title of a panel, in several lines if the robot's name is long."""
    name = robot_label(robot)
    return f"{textwrap.fill(name, WIDEST)}:\n{what}" if len(name) > 6 else f"{name}: {what}"


def _charts(
    results: DetectionResults, figure: Figure, *, x: str, y: str
) -> Iterator[tuple[str, str, Chart]]:
    """Charts by robot and trigger, empty if a robot lacks the trigger.

    Only the outer panels have axis labels and tick labels.  Without ``x`` each column has the axis
    of its trigger.
    """
    shape = (len(results.robots), len(SIGNALS))
    axes = figure.subplots(*shape, sharex="all" if x else "col", sharey=True, squeeze=False)
    for row, robot in zip(axes, results.robots, strict=True):
        has = results.triggers(robot)
        for ax, trigger in zip(row, SIGNALS, strict=True):
            name, _, threshold = TRIGGERS[trigger]
            title = _title(robot, name)
            if trigger not in has:
                ax.set_axis_off()
                ax.text(0.5, 0.5, "no arm slides", ha="center", color=GREY, transform=ax.transAxes)
                ax.set_title(title, color=GREY)
                continue
            last = results.robots[-1]
            below = robot == last or trigger not in results.triggers(last)
            ax.tick_params(labelbottom=below, labelleft=trigger == has[0])
            ax.set_xscale("log")
            yield robot, trigger, Chart(ax, x or threshold, y, title)
            ax.xaxis.set_major_locator(LogLocator(10.0))
            ax.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
            ax.xaxis.set_minor_formatter(NullFormatter())


def _curve(points: Sequence[RocPoint]) -> tuple[list[float], list[float]]:
    """False alarms per hour, descending, and probabilities; the upper bound where none occurred."""
    kept = [p for p in points if p.bound <= MANY]
    return [p.bound for p in kept], [p.probability for p in kept]


@in_style
def roc_figure(results: DetectionResults) -> Figure:
    """Receiver operating curves of each trigger by speed, with a dot at the default threshold.

    Args:
        results: Results of the study.
    """
    figure = StyledFigure(figsize=(WIDE, _height(results)))
    noticed = f"Detected within {1e3 * IN_TIME:g} ms [-]"
    for robot, trigger, chart in _charts(results, figure, x="False alarms [1/h]", y=noticed):
        for look, speed in zip(LOOKS, SPEEDS, strict=False):
            points = results.curve(robot, trigger, speed)
            chart.curve(f"{speed:g} m/s", *_curve(points), **look)
            usual = min(points, key=lambda p: abs(np.log(p.threshold / default_threshold(trigger))))
            chart.curve(
                f"{speed:g} m/s, default threshold", usual.bound, usual.probability, key=False,
                color=look["color"], marker="o", ls="none", mec="white", ms=6, zorder=3,
            )  # fmt: skip
        least = 3600.0 / results.free_time(robot) * 3.0
        chart.span("none seen", 1.0, least)
        chart.ax.set_xlim(0.5 * least, 1.2 * MANY)
        chart.ax.set_ylim(-0.04, 1.06)
    _legend(figure)
    return figure


@in_style
def delay_figure(results: DetectionResults) -> Figure:
    """Delay over threshold by speed; thresholds with false alarms are shaded.

    Args:
        results: Results of the study.
    """
    figure = StyledFigure(figsize=(WIDE, _height(results)))
    for robot, trigger, chart in _charts(results, figure, x="", y="Delay [ms]"):
        scale = TRIGGERS[trigger][1]
        for look, speed in zip(LOOKS, SPEEDS, strict=False):
            points = results.curve(robot, trigger, speed)
            sure = [p for p in points if p.delays and p.probability >= 0.5]
            if not sure:
                continue
            x = np.array([scale * p.threshold for p in sure])
            low, middle, high = (
                1e3 * np.array([np.percentile(p.delays, (0, 50, 100)) for p in sure]).T
            )
            name = f"{speed:g} m/s"
            chart.band(f"{name}, minimum to maximum", x, low, high, color=look["color"], alpha=0.15)
            chart.curve(name, x, middle, **look)
        loud = [scale * p.threshold for p in points if p.false_alarms]
        if loud:
            chart.span("false alarms", 0.5 * scale * points[0].threshold, max(loud))
        chart.vline(
            "default threshold", scale * default_threshold(trigger), color=INK,
            ls=(0, (6, 2, 1, 2)), zorder=2,
        )  # fmt: skip
        chart.ax.set_xlim(scale * points[0].threshold, scale * points[-1].threshold)
        chart.ax.set_ylim(0.0, 1e3 * IN_TIME)
        chart.ax.yaxis.set_major_locator(MaxNLocator(6))
    _legend(figure)
    return figure


def _legend(figure: Figure) -> None:
    """Add one legend for all panels, above them."""
    drawn = [ax.get_legend_handles_labels() for ax in figure.axes]
    handles, names = max(drawn, key=lambda pair: len(pair[1]))
    figure.legend(handles, names, loc="outside upper center", ncols=len(names))


SHORT = ("arms", "accel.", "wrench", "fused")
"""Labels of the sources, in order."""


@in_style
def direction_figure(results: DetectionResults) -> Figure:
    """Direction errors by source, robot and speed, a dot for each collision, with a line at 5°.

    Args:
        results: Results of the study.
    """
    figure = StyledFigure(figsize=(WIDTH, _height(results)))
    axes = figure.subplots(len(results.robots), 2, sharex=True, sharey=True, squeeze=False)
    speeds = [v for v in SPEEDS if v >= CHARACTERISED_FROM]
    for row, robot in zip(axes, results.robots, strict=True):
        for ax, to in zip(row, ("normal", "impulse"), strict=True):
            title = _title(robot, f"off the {to}")
            chart = Chart(ax, "category", "Direction error [deg]", title)
            for k, speed in enumerate(speeds):
                errors = results.characterisation_error(robot, speed)
                shift = np.linspace(-0.26, 0.26, len(speeds))[k]
                for j, source in enumerate(SOURCES):
                    _dots(chart, j, j + shift, sizes(errors, source, to), speed, LOOKS[k]["color"])
            chart.hline("5 deg", 5.0)
            ax.set_yscale("symlog", linthresh=5.0, linscale=1.4)
            ax.set_ylim(0.0, 60.0)
            ax.set_yticks([0, 1, 2, 3, 4, 5, 10, 20, 45])
            ax.yaxis.set_major_formatter("{x:g}")
            ax.yaxis.set_minor_formatter(NullFormatter())
            ax.set_xticks(range(len(SOURCES)), SHORT)
    _legend(figure)
    return figure


def _dots(
    chart: Chart, source: int, at: float, errors: Sequence[float], speed: float, colour: str
) -> None:
    """Draw the errors of one source at one speed, spread around a position, and their median."""
    name, word = f"{speed:g} m/s", {chart.x: SHORT[source]}
    if source == 0:
        chart.key(name, color=colour, marker="o", ls="none", ms=4.0)
    if not errors:
        return
    chart.curve(
        name, at + np.linspace(-0.07, 0.07, len(errors)), errors, key=False, columns=word,
        color=colour, marker=".", ls="none", ms=3.0, alpha=0.55, mew=0.0,
    )  # fmt: skip
    middle = float(np.median(errors))
    chart.record(f"{name}, median", {**word, chart.y: middle})
    chart.ax.plot([at - 0.1, at + 0.1], [middle, middle], color=colour)

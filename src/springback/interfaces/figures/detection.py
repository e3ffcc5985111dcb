"""Figures of the study of detection and characterisation."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, MaxNLocator, NullFormatter, StrMethodFormatter

from springback.interfaces.figures.style import GREY, INK, LOOKS, SHADE, WIDTH, StyledFigure, styled
from springback.studies.detection import (
    CHARACTERISED_FROM,
    IN_TIME,
    ROBOTS,
    SIGNALS,
    SOURCES,
    SPEEDS,
    DetectionResults,
)
from springback.studies.detection_tables import default_threshold, sizes
from springback.studies.roc import RocPoint

WIDE = 1.55 * WIDTH
"""Of a figure with a column for each trigger [in]."""
NAMES = {"arq": "ARQ", "quad": "Quad"}
TRIGGERS = {
    "hall": ("Hall", 1e3, "Compression [mm]"),
    "acceleration": ("accelerometer", 1.0, "Specific force [m/s²]"),
    "wrench": ("wrench", 1.0, "External force [N]"),
    "momentum": ("momentum", 1.0, "External force [N]"),
}
"""Title, scale, and what the threshold is on."""
MANY = 3e3
"""False alarms an hour up to which a receiver operating curve is drawn: one each 1.2 s, hardly more
than the refractory time of 1 s leaves room for."""


def _panels(
    results: DetectionResults, figure: Figure, *, sharex: bool
) -> Iterator[tuple[str, str, Axes]]:
    """An axes for each robot and trigger; where a robot has no such trigger it is empty."""
    shape = (len(ROBOTS), len(SIGNALS))
    axes = figure.subplots(*shape, sharex="all" if sharex else "col", sharey=True)
    for row, robot in zip(axes, ROBOTS, strict=True):
        for ax, trigger in zip(row, SIGNALS, strict=True):
            if trigger not in results.triggers(robot):
                ax.set_axis_off()
                ax.text(0.5, 0.5, "no arm slides", ha="center", color=GREY, transform=ax.transAxes)
                ax.set_title(f"{NAMES[robot]}: {TRIGGERS[trigger][0]}", color=GREY)
                continue
            ax.set_title(f"{NAMES[robot]}: {TRIGGERS[trigger][0]}")
            yield robot, trigger, ax
            _outer(results, robot, trigger, ax)


def _outer(results: DetectionResults, robot: str, trigger: str, ax: Axes) -> None:
    """Words and numbers only where no panel stands below, or to the left."""
    below = robot == ROBOTS[-1] or trigger not in results.triggers(ROBOTS[-1])
    left = trigger == results.triggers(robot)[0]
    ax.tick_params(labelbottom=below, labelleft=left)
    ax.xaxis.label.set_visible(below)
    ax.yaxis.label.set_visible(left)


def _bounded(points: Sequence[RocPoint]) -> tuple[list[float], list[float]]:
    """False alarms an hour and probabilities, falling; where none was seen, the bound."""
    kept = [p for p in points if p.bound <= MANY]
    return [p.bound for p in kept], [p.probability for p in kept]


@styled
def roc_figure(results: DetectionResults) -> Figure:
    """Receiver operating curves of every trigger, a curve for each speed; the default is a dot.

    Args:
        results: The study.
    """
    figure = StyledFigure(figsize=(WIDE, 4.4))
    for robot, trigger, ax in _panels(results, figure, sharex=True):
        for k, speed in enumerate(SPEEDS):
            points = results.curve(robot, trigger, speed)
            rates, chances = _bounded(points)
            colour, line = LOOKS[k]
            ax.plot(rates, chances, color=colour, ls=line, label=f"{speed:g} m/s")
            usual = min(points, key=lambda p: abs(np.log(p.threshold / default_threshold(trigger))))
            ax.plot(usual.bound, usual.probability, "o", color=colour, mec="white", ms=6, zorder=3,
                    label=f"_{speed:g} m/s, default threshold")  # fmt: skip
        least = 3600.0 / results.free_time(robot) * 3.0
        ax.axvspan(1.0, least, color=SHADE, lw=0.0, zorder=0.1, label="_none seen")
        ax.set_xscale("log")
        ax.set_xlim(0.5 * least, 1.2 * MANY)
        ax.xaxis.set_major_locator(LogLocator(10.0))
        ax.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
        ax.xaxis.set_minor_formatter(NullFormatter())
        ax.set_ylim(-0.04, 1.06)
        ax.set_xlabel("False alarms [1/h]")
        ax.set_ylabel(f"Noticed in {1e3 * IN_TIME:g} ms [-]")
    _legend(figure)
    return figure


@styled
def delay_figure(results: DetectionResults) -> Figure:
    """Delay against threshold, a curve for each speed; shaded are thresholds of false alarms.

    Args:
        results: The study.
    """
    figure = StyledFigure(figsize=(WIDE, 4.4))
    for robot, trigger, ax in _panels(results, figure, sharex=False):
        _, scale, label = TRIGGERS[trigger]
        for k, speed in enumerate(SPEEDS):
            points = results.curve(robot, trigger, speed)
            sure = [p for p in points if p.delays and p.probability >= 0.5]
            x = np.array([scale * p.threshold for p in sure])
            delays = [np.percentile(p.delays, (0, 50, 100)) for p in sure]
            if not delays:
                continue
            low, middle, high = 1e3 * np.array(delays).T
            colour, line = LOOKS[k]
            ax.fill_between(
                x, low, high, color=colour, alpha=0.15, lw=0.0,
                label=f"_{speed:g} m/s, least to most",
            )  # fmt: skip
            ax.plot(x, middle, color=colour, ls=line, label=f"{speed:g} m/s")
        loud = [scale * p.threshold for p in points if p.false_alarms]
        if loud:
            ax.axvspan(
                0.5 * scale * points[0].threshold,
                max(loud),
                color=SHADE,
                lw=0.0,
                zorder=0.1,
                label="_false alarms",
            )
        ax.axvline(
            scale * default_threshold(trigger), color=INK, lw=0.9, ls=(0, (6, 2, 1, 2)),
            label="_default threshold",
        )  # fmt: skip
        ax.set_xscale("log")
        ax.xaxis.set_major_locator(LogLocator(10.0))
        ax.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
        ax.xaxis.set_minor_formatter(NullFormatter())
        ax.set_xlim(scale * points[0].threshold, scale * points[-1].threshold)
        ax.set_ylim(0.0, 1e3 * IN_TIME)
        ax.set_xlabel(label)
        ax.set_ylabel("Delay [ms]")
        ax.yaxis.set_major_locator(MaxNLocator(6))
    _legend(figure)
    return figure


def _legend(figure: Figure) -> None:
    """One legend for all panels, above them."""
    drawn = [ax.get_legend_handles_labels() for ax in figure.axes]
    handles, names = max(drawn, key=lambda pair: len(pair[1]))
    figure.legend(handles, names, loc="outside upper center", ncols=len(names))


@styled
def direction_figure(results: DetectionResults) -> Figure:
    """Errors of the direction by source, robot and speed, each collision a dot; and 5 degrees.

    Args:
        results: The study.
    """
    figure = StyledFigure(figsize=(WIDTH, 4.6))
    axes = figure.subplots(len(ROBOTS), 2, sharex=True, sharey=True)
    speeds = [v for v in SPEEDS if v >= CHARACTERISED_FROM]
    shifts = np.linspace(-0.26, 0.26, len(speeds))
    for row, robot in zip(axes, ROBOTS, strict=True):
        for ax, to in zip(row, ("normal", "impulse"), strict=True):
            for k, speed in enumerate(speeds):
                found, colour = results.characterisation_error(robot, speed), LOOKS[k][0]
                for j, source in enumerate(SOURCES):
                    errors = sizes(found, source, to)
                    spread = np.linspace(-0.07, 0.07, len(errors))
                    name = f"{speed:g} m/s" if j == 0 else None
                    x = j + shifts[k] + spread
                    ax.plot(x, errors, ".", color=colour, ms=3.0, alpha=0.55, mew=0.0,
                            label=f"_{speed:g} m/s")  # fmt: skip
                    ax.plot([], [], "o", color=colour, ms=4.0, label=name)
                    if errors:
                        middle = float(np.median(errors))
                        ax.plot(j + shifts[k] + np.array([-0.1, 0.1]), [middle] * 2, color=colour,
                                label=f"_{speed:g} m/s, median")  # fmt: skip
            ax.axhline(5.0, color=GREY, lw=0.9, ls=(0, (3, 2)), zorder=1.5, label="_5 deg")
            ax.set_title(f"{NAMES[robot]}: off the {to}")
            ax.set_yscale("symlog", linthresh=5.0, linscale=1.4)
            ax.set_ylim(0.0, 60.0)
            ax.set_yticks([0, 1, 2, 3, 4, 5, 10, 20, 45])
            ax.yaxis.set_major_formatter("{x:g}")
            ax.yaxis.set_minor_formatter(NullFormatter())
            ax.set_xticks(range(len(SOURCES)), ["arms", "accel.", "wrench", "fused"])
            ax.set_ylabel("Direction error [deg]")
            ax.label_outer()
        _legend(figure)
    return figure

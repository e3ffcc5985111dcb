"""A contest as a figure: who flies how many seconds of flight in a second."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from benchmarks.rivals.report import horizon
from springback.interfaces.figures.chart import Chart
from springback.interfaces.figures.style import StyledFigure, in_style
from springback.interfaces.output.robots import BLUE, GREY, INK, ORANGE

RATE = "flight-seconds per second"
#: Height of a row, and what a panel needs besides [in].
ROW, REST = 0.24, 0.75
#: Panels, top to bottom, and the kinds of flights in each.
PANELS = {
    "With a pilot: seconds of flight per second": ("collision", "flight"),
    "Impacts at equal accuracy: flights per second": ("impact",),
}


def _dots(chart: Chart, rows: Mapping[str, Any], scale: float) -> None:
    """Medians as dots, from lowest to highest as a line, the fastest on top."""
    axes = chart.ax
    ordered = sorted(rows.items(), key=lambda item: item[1]["figures"][RATE]["median"])
    for k, (name, row) in enumerate(ordered):
        found = {key: value / scale for key, value in row["figures"][RATE].items()}
        ours = name.startswith("springback")
        colour = ORANGE if row["kind"] == "collision" else BLUE if ours else GREY
        chart.errorbars(
            "", found["median"], k, found["lowest"], found["highest"], across=True,
            columns={chart.y: name}, fmt="o" if ours else "D", color=colour, ms=6.0, elinewidth=2.0,
        )  # fmt: skip
        axes.annotate(
            _rounded(found["median"]), (found["highest"], k), xytext=(7, 0),
            textcoords="offset points", va="center", fontsize=8,
        )  # fmt: skip
    axes.set_yticks(range(len(ordered)), [name for name, _ in ordered])
    axes.set_xscale("log")
    lowest = min(row["figures"][RATE]["lowest"] for row in rows.values()) / scale
    highest = max(row["figures"][RATE]["highest"] for row in rows.values()) / scale
    axes.set_xlim(0.5 * lowest, 5.0 * highest)
    axes.xaxis.set_major_locator(LogLocator(10.0))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: _rounded(value)))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_ylim(-0.6, len(ordered) - 0.4)


def _rounded(value: float) -> str:
    """Two digits, thousands apart."""
    two = float(f"{value:.2g}")
    return f"{two:,.0f}".replace(",", " ") if two >= 10.0 else f"{two:g}"


@in_style
def contest_figure(report: Mapping[str, Any]) -> Figure:
    """Rates of all, springback in colour; the machine is named below.

    Args:
        report: As summarised.
    """
    panels = []
    for title, kinds in PANELS.items():
        rows = {n: row for n, row in report["contenders"].items() if row["kind"] in kinds}
        if rows:
            panels.append((title, kinds, rows))
    heights = [ROW * len(rows) + REST for _, _, rows in panels]
    figure = StyledFigure(figsize=(7.2, sum(heights) + 0.3))
    grid = figure.subplots(len(panels), 1, squeeze=False, height_ratios=heights)
    for axes, (title, kinds, rows) in zip(grid[:, 0], panels, strict=True):
        scale = horizon("impact") if kinds == ("impact",) else 1.0
        _dots(Chart(axes, title.partition(": ")[2], "contender", title), rows, scale)
    machine = report["machine"]["processor"]
    note = f"{machine}; medians of rounds ({report['rounds']}), lines from lowest to highest"
    if report["quick"]:
        note += "; a quick run, its figures mean nothing"
    figure.supxlabel(note, fontsize=7, color=INK)
    return figure

"""A contest as a figure: who flies how many seconds of flight in a second."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from benchmarks.rivals.report import horizon
from springback.interfaces.canvas import BLUE, GREY, INK, ORANGE, HouseFigure, styled

RATE = "flight-seconds per second"
#: Height of a bar, and what a panel needs besides [in].
BAR, REST = 0.24, 0.75
#: Panels, top to bottom, and the kinds of flights in each.
PANELS = {
    "With a pilot: seconds of flight per second": ("collision", "flight"),
    "Impacts at equal accuracy: flights per second": ("impact",),
}


def _bars(axes: Axes, rows: Mapping[str, Any], scale: float) -> None:
    """Medians as bars, from lowest to highest as a line, best on top."""
    ordered = sorted(rows.items(), key=lambda item: item[1]["figures"][RATE]["median"])
    for k, (name, row) in enumerate(ordered):
        found = {key: value / scale for key, value in row["figures"][RATE].items()}
        ours = name.startswith("springback")
        colour = ORANGE if row["kind"] == "collision" else BLUE if ours else GREY
        axes.barh(k, found["median"], height=0.62, color=colour)
        axes.plot([found["lowest"], found["highest"]], [k, k], color=INK, linewidth=1.0)
        median = found["median"]
        said = (
            f"{float(f'{median:.2g}'):,.0f}".replace(",", " ") if median >= 10 else f"{median:.2g}"
        )
        axes.annotate(
            said, (found["highest"], k), xytext=(4, 0), textcoords="offset points", va="center",
            fontsize=8,
        )  # fmt: skip
    axes.set_yticks(range(len(ordered)), [name for name, _ in ordered])
    axes.set_xscale("log")
    lowest = min(row["figures"][RATE]["lowest"] for row in rows.values()) / scale
    highest = max(row["figures"][RATE]["highest"] for row in rows.values()) / scale
    axes.set_xlim(0.4 * lowest, 4.0 * highest)
    axes.grid(axis="y", visible=False)
    axes.set_ylim(-0.6, len(ordered) - 0.4)


@styled
def contest_figure(report: Mapping[str, Any]) -> Figure:
    """Everybody's rate, springback in colour; the machine stands below.

    Args:
        report: As summarised.
    """
    panels = []
    for title, kinds in PANELS.items():
        rows = {n: row for n, row in report["contenders"].items() if row["kind"] in kinds}
        if rows:
            panels.append((title, kinds, rows))
    heights = [BAR * len(rows) + REST for _, _, rows in panels]
    figure = HouseFigure(figsize=(7.2, sum(heights) + 0.3))
    grid = figure.subplots(len(panels), 1, squeeze=False, height_ratios=heights)
    for axes, (title, kinds, rows) in zip(grid[:, 0], panels, strict=True):
        _bars(axes, rows, horizon("impact") if kinds == ("impact",) else 1.0)
        axes.set_title(title)
    machine = report["machine"]["processor"]
    note = f"{machine}; medians of {report['rounds']} rounds, lines from lowest to highest"
    if report["quick"]:
        note += "; a quick run, its figures mean nothing"
    figure.supxlabel(note, fontsize=7, color=INK)
    return figure

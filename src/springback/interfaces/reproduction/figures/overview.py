"""First figure of a report: every compared number relative to its printed value."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

from springback.interfaces.figures.chart import Chart
from springback.interfaces.figures.style import WIDTH, StyledFigure, in_style
from springback.interfaces.output.robots import BLUE, INK, RED
from springback.studies.comparison import AGREEMENT, Mark, Row

FARTHEST = 3.0
"""Ratios beyond this, or its inverse, are drawn as arrows at the edge (chosen)."""
TICKS = (0.33, 0.5, 0.7, 1.0, 1.4, 2.0, 3.0)
ROWS = 3
"""Rows over which the marks of a line are spread, to reduce overlap."""


@in_style
def overview_figure(groups: Mapping[str, Sequence[Row]]) -> Figure:
    """Ours divided by print, a mark for each compared number, a line for each group.

    Args:
        groups: Compared numbers without a fit, by the name of their group.
    """
    figure = StyledFigure(figsize=(WIDTH, 0.95 + 0.29 * max(len(groups), 1)))
    ax = figure.subplots()
    chart = Chart(ax, "ours / printed [-]", "category")
    within = f"within {100 * AGREEMENT:g} %"
    chart.span(within, 1 - AGREEMENT, 1 + AGREEMENT)
    chart.vline("agreement", 1.0, color=INK, ls="-")
    for y, (group, rows) in enumerate(groups.items()):
        for k, row in enumerate(rows):
            _mark(chart, row, group, y + 0.24 * (k % ROWS - 0.5 * (ROWS - 1)))
    chart.key(within, color=BLUE, marker="o", ls="none", ms=4.5)
    chart.key("farther off", color=RED, marker="^", ls="none", mfc="none", ms=5)
    chart.key("off the scale", color=RED, marker=">", ls="none", ms=5)
    ax.set_yticks(range(len(groups)), list(groups))
    ax.set_ylim(max(len(groups), 1) - 0.5, -0.5)
    ax.set_xscale("log")
    ax.set_xlim(0.93 / FARTHEST, FARTHEST / 0.93)
    ax.xaxis.set_major_locator(FixedLocator(list(TICKS)))
    ax.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    ax.xaxis.set_minor_locator(NullLocator())
    figure.legend(*ax.get_legend_handles_labels(), loc="outside upper center", ncols=3)
    return figure


def _mark(chart: Chart, row: Row, group: str, y: float) -> None:
    """Draw one number, as an arrow at the edge if print is zero or the ratio is off the scale."""
    ratio = FARTHEST**2 if row.deviation is None else 1.0 + row.deviation
    far = not 1 / FARTHEST <= ratio <= FARTHEST
    shown = min(max(ratio, 1 / FARTHEST), FARTHEST)
    good = row.mark is not Mark.CONTRADICTED
    marker = ("<" if ratio < 1.0 else ">") if far else "o" if good else "^"
    name = ", ".join(filter(None, (row.quantity, row.robot, row.surface, row.reading)))
    chart.curve(
        name, shown, y, key=False, columns={chart.y: group}, marker=marker, ls="none",
        ms=4.5 if good else 5, color=BLUE if good else RED, mew=1.0,
        mfc=None if good or far else "none",
    )  # fmt: skip

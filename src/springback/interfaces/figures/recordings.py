"""Figures of recordings beside predictions."""

from __future__ import annotations

from matplotlib.figure import Figure

from springback.interfaces.figures.chart import Chart
from springback.interfaces.figures.style import WIDTH, StyledFigure, in_style
from springback.interfaces.output.robots import BLUE, INK, ORANGE
from springback.studies.recordings.impulse_predictions import WANTED, ImpactPredictions

#: Errors that are drawn: their names, words, colours and markers.
ERRORS = (
    ("at_contact", "normal velocity at the contact point", BLUE, "o"),
    ("spin", "spin", ORANGE, "s"),
)


@in_style
def impacts_figure(found: ImpactPredictions) -> Figure:
    """Median errors of each model over the impacts that were not fitted on."""
    figure = StyledFigure(figsize=(WIDTH, 2.9), layout="constrained")
    chart = Chart(figure.subplots(), "Median error, of what was measured [%]", "Model")
    names, places = [row.model for row in found.rest], range(len(found.rest))
    for name, words, colour, marker in ERRORS:
        medians = [100.0 * getattr(row, name)[0] for row in found.rest]
        chart.curve(words, medians, list(places), color=colour, marker=marker, ms=5, ls="none")
        chart.vline(
            f"wanted: {words}", 100.0 * WANTED[name], color=colour, ls=(0, (1.2, 1.2)), lw=1.0
        )
    chart.ax.set_yticks(list(places), names)
    chart.ax.set_ylim(len(names) - 0.5, -0.5)
    chart.ax.set_xscale("log")
    chart.ax.set_xticks([2, 5, 10, 20, 50, 100], ["2", "5", "10", "20", "50", "100"])
    chart.ax.axhline(0.5, color=INK, lw=0.5)
    chart.ax.axhline(len(names) - 1.5, color=INK, lw=0.5)
    figure.legend(*chart.ax.get_legend_handles_labels(), loc="outside upper center", ncols=2)
    return figure

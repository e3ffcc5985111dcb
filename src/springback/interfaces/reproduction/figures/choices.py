"""Figure of the resilience table under each set of choices that the paper leaves open."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from springback.interfaces.figures.chart import Chart
from springback.interfaces.figures.style import WIDTH, StyledFigure, in_style
from springback.interfaces.output.robots import INK, ROBOTS
from springback.paper.choices import ROBOTS as FLOWN
from springback.paper.choices import ChoiceResults
from springback.paper.printed import SUCCESS, SUCCESS_WORDS
from springback.studies.run_ups import CONDITIONS

ORDER = tuple(sorted(CONDITIONS, key=lambda c: (c[1], c[0])))
SHORT = {"fairly good": "good"}
"""Short forms of the paper's words for cells."""


TESTS = "Speed [m/s] and pitch at contact [°]"


def signed_angle(degrees: float) -> str:
    """Angle with its sign, as in a text."""
    return f"{degrees:+g}".replace("-", "−") if degrees else "0"


@in_style
def choices_figure(results: ChoiceResults) -> Figure:
    """Share of recovered trials, a row for each set of choices below the printed one."""
    sets = results.combinations
    several = len({duration for _, duration in sets}) > 1
    labels = ["printed", *(
        f"{choice.name}{f', {duration:g} s' if several else ''}" for choice, duration in sets
    )]  # fmt: skip
    height = 0.27 * len(labels) + 1.15
    figure = StyledFigure(figsize=(WIDTH * 1.75, height), layout="constrained")
    tests = [f"{speed:g}\n{signed_angle(pitch)}°" for pitch, speed in ORDER]
    for ax, robot in zip(figure.subplots(1, 2, sharey=True), FLOWN, strict=True):
        cells = [[results.table(*one).get((robot, *test)) for test in ORDER] for one in sets]
        shares = [[np.nan if c is None else c.share for c in row] for row in cells]
        words = [["" if c is None else f"{100 * c.share:.0f}" for c in row] for row in cells]
        printed = [SUCCESS.get((robot, *test), np.nan) for test in ORDER]
        chart = Chart(ax, TESTS, "choices", ROBOTS[robot].label)
        words.insert(0, [_printed_text(robot, test) for test in ORDER])
        chart.heat_map("Recovered [%]", [printed, *shares], words, labels, tests)
        ax.axhline(0.5, color=INK, lw=1.0)
        ax.set_title(f"{chart.panel}: recovered [%]", size=9)
        ax.set_xlabel(TESTS, size=8)
    return figure


def _printed_text(robot: str, test: tuple[float, float]) -> str:
    """Printed result of a test, short enough for a cell."""
    if (robot, *test) in SUCCESS:
        return f"{100 * SUCCESS[robot, *test]:g}"
    word = SUCCESS_WORDS.get((robot, *test), "")
    return SHORT.get(word, word)

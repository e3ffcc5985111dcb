"""Figure of the resilience table under each set of choices that the paper leaves open."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from springback.interfaces.figures.ablation import SHADES, TITLES
from springback.interfaces.figures.style import INK, WIDTH, StyledFigure, styled
from springback.paper.choices import ROBOTS, ChoiceResults
from springback.paper.printed import SUCCESS, SUCCESS_WORDS
from springback.studies.run_ups import CONDITIONS

ORDER = tuple(sorted(CONDITIONS, key=lambda c: (c[1], c[0])))
SHORT = {"fairly good": "good"}
"""Words of the paper that a cell has no room for."""


def _signed(degrees: float) -> str:
    return f"{degrees:+g}".replace("-", "−") if degrees else "0"


@styled
def choices_figure(results: ChoiceResults) -> Figure:
    """Recovered of all trials, a row for each set of choices, and what is printed on top."""
    sets = results.flown
    several = len({duration for _, duration in sets}) > 1
    labels = ["printed", *(
        f"{choice.name}{f', {duration:g} s' if several else ''}" for choice, duration in sets
    )]  # fmt: skip
    height = 0.27 * len(labels) + 1.15
    figure = StyledFigure(figsize=(WIDTH * 1.75, height), layout="constrained")
    for ax, robot in zip(figure.subplots(1, 2, sharey=True), ROBOTS, strict=True):
        share = np.full((len(labels), len(ORDER)), np.nan)
        words = [[""] * len(ORDER) for _ in labels]
        for j, test in enumerate(ORDER):
            of = (robot, *test)
            share[0, j] = SUCCESS.get(of, np.nan)
            word = SUCCESS_WORDS.get(of, "")
            words[0][j] = f"{100 * SUCCESS[of]:g}" if of in SUCCESS else SHORT.get(word, word)
            for i, one in enumerate(sets, 1):
                cell = results.table(*one).get(of)
                if cell is not None:
                    share[i, j], words[i][j] = cell.share, f"{100 * cell.share:.0f}"
        image = ax.imshow(100.0 * share, cmap=SHADES, vmin=0.0, vmax=100.0, aspect="auto")
        image.set_label("_Recovered [%]")
        for (i, j), value in np.ndenumerate(share):
            dark = bool(np.isfinite(value) and value < 0.5)
            ax.text(j, i, words[i][j], ha="center", va="center", size=8,
                    color="white" if dark else INK)  # fmt: skip
        ax.axhline(0.5, color=INK, lw=1.0, label="_below: ours")
        ax.set_xticks(
            range(len(ORDER)), [f"{speed:g}\n{_signed(pitch)}°" for pitch, speed in ORDER],
            size=8,
        )  # fmt: skip
        ax.set_yticks(range(len(labels)), labels, size=8)
        ax.set_title(f"{TITLES[robot]}: recovered [%]", size=9)
        ax.set_xlabel("Speed [m/s] and pitch at contact [°]", size=8)
        ax.tick_params(length=0)
        ax.grid(visible=False)
        for edge in ax.spines.values():
            edge.set_visible(False)
    return figure

"""Every figure of the paper, and what stands for it here."""

from __future__ import annotations

from collections.abc import Collection
from typing import NamedTuple

from springback.interfaces.reports.page import Table, TableCell, Wording

WORDS = Wording.of("figures")


class PaperFigure(NamedTuple):
    """A figure of the paper."""

    name: str
    shows: str
    """In our words."""
    ours: tuple[str, ...]
    """Names of figures of the report; none if there is nothing to compute."""
    note: str = ""


PAPER_FIGURES = tuple(
    PaperFigure(entry["name"], entry["shows"], tuple(entry["ours"]), entry.get("note", ""))
    for entry in WORDS.text["figures"]
)


def figures_table(drawn: Collection[str]) -> Table:
    """Figures of the paper beside those of a report.

    Args:
        drawn: Names of the figures that the report holds.
    """
    rows = []
    for figure in PAPER_FIGURES:
        links = tuple((WORDS.text["ours"][n], f"figure-{n}") for n in figure.ours if n in drawn)
        missing = WORDS.say("missing") if figure.ours and not links else ""
        text = missing or ("" if links else "–")
        rows.append(
            (
                TableCell(figure.name),
                TableCell(figure.shows),
                TableCell(text, links=links),
                TableCell(figure.note),
            )
        )
    return Table(WORDS.say("caption"), WORDS.head("figures"), tuple(rows))

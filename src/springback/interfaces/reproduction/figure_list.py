"""Figures of the paper and their counterparts here."""

from __future__ import annotations

from collections.abc import Collection
from typing import NamedTuple

from springback.interfaces.reports.page import Entry, TableCell, Wording

WORDS = Wording.of("figures")


class PaperFigure(NamedTuple):
    """A figure of the paper."""

    name: str
    shows: str
    """Content, in our words."""
    ours: tuple[str, ...]
    """Names of figures of the report; empty if there is nothing to compute."""
    note: str = ""


PAPER_FIGURES = tuple(
    PaperFigure(entry["name"], entry["shows"], tuple(entry["ours"]), entry.get("note", ""))
    for entry in WORDS.text["figures"]
)


def figure_rows(drawn: Collection[str]) -> list[tuple[Entry, ...]]:
    """Table of the paper's figures and those of a report.

    Args:
        drawn: Names of the figures in the report.
    """
    rows: list[tuple[Entry, ...]] = []
    for figure in PAPER_FIGURES:
        links = tuple((WORDS.text["ours"][n], f"figure-{n}") for n in figure.ours if n in drawn)
        missing = WORDS.say("missing") if figure.ours and not links else ""
        ours = TableCell(missing or ("" if links else "–"), links=links)
        rows.append((figure.name, figure.shows, ours, figure.note))
    return rows

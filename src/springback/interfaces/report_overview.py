"""What a report begins with: the question, the answer in a sentence and a picture, part by part.

The words are in ``templates/overview.toml``.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from springback.experiments.comparison import AGREEMENT, Mark, Row
from springback.interfaces.plots_overview import overview_figure
from springback.interfaces.report_page import (
    Cell,
    Picture,
    Point,
    Points,
    Section,
    Table,
    Words,
    percent,
    plain,
)

WORDS = Words.of("overview")
WITHIN = (AGREEMENT, 0.10, 0.25)
"""Chosen: shares of the printed value within which agreement is counted."""
OWN = "ARQ's own"
"""Begins where c_a comes from in tests that ask what a fit to ARQ would take."""
Groups = dict[str, list[Row]]


def untouched(rows: Sequence[Row]) -> list[Row]:
    """Compared numbers to which nothing was fitted, directly or through c_a of their own test.

    Args:
        rows: All compared numbers.
    """
    free = (Mark.PREDICTED, Mark.CONTRADICTED)
    return [r for r in rows if r.mark in free and not r.dissipation_from.startswith(OWN)]


def groups(rows: Sequence[Row]) -> Groups:
    """`untouched` numbers by the part of the paper they belong to; readings apart.

    Args:
        rows: All compared numbers.
    """
    found: Groups = {}
    for part in WORDS.text["parts"].values():
        for row in untouched(rows):
            if _belongs(row, part):
                found.setdefault(part["name"].format(reading=row.reading), []).append(row)
    return found


def _belongs(row: Row, part: dict[str, Any]) -> bool:
    return (
        row.experiment in part["experiments"]
        and row.robot in part.get("robots", [row.robot])
        and row.reading.endswith(part.get("ends", ""))
    )


def within(rows: Sequence[Row], share: float) -> int:
    """How many numbers deviate from print by at most a share of it.

    Args:
        rows: Compared numbers.
        share: Such as 0.05.
    """
    return sum(abs(row.deviation) <= share for row in rows if row.deviation is not None)


def overview(rows: Sequence[Row], sections: Sequence[Section] = ()) -> Section:
    """The summary of a report.

    Args:
        rows: All compared numbers.
        sections: Of the report, whose answers are gathered.
    """
    parts = groups(rows)
    free = [row for group in parts.values() for row in group]
    title = WORDS.title("overview")
    if not free:
        return Section("overview", title, (WORDS.say("verdict_none"), _marks(rows)), summary=True)
    answers = [Point(s.anchor, s.title, s.answer) for s in sections if s.answer]
    if len(answers) == 1:  # no need to say it twice on one page
        answers = []
    counts = {
        name: within(free, share)
        for name, share in zip(("first", "second", "third"), WITHIN, strict=True)
    }
    shares = {f"{name}_share": plain(100 * s) for name, s in zip(counts, WITHIN, strict=True)}
    note = WORDS.say(
        "note", given=sum(row.mark is Mark.GIVEN for row in rows),
        fitted=sum(row.mark is Mark.FITTED for row in rows),
    )  # fmt: skip
    words = WORDS.say("picture", agreement=plain(100 * AGREEMENT))
    return Section(
        "overview",
        title,
        (
            WORDS.say("asked"),
            WORDS.say("verdict", count=len(free), **counts, **shares),
            Picture("overview", words, overview_figure(parts)),
            *([Points(tuple(answers))] if answers else []),
            _by_part(parts),
            note,
            _marks(rows),
        ),
        summary=True,
        answers=True,
    )


def _by_part(parts: Groups) -> Table:
    lines = []
    for name, rows in parts.items():
        counts = (within(rows, share) for share in WITHIN)
        cells = (Cell(f"{count} of {len(rows)}", count) for count in counts)
        far = max(rows, key=lambda row: abs(_deviation(row)))
        lines.append((Cell(name), Cell(str(len(rows)), len(rows)), *cells, _farthest(far)))
    shares = [plain(100 * share) for share in WITHIN]
    head = tuple(word.format(*shares) for word in WORDS.head("parts"))
    return Table(WORDS.say("caption"), head, tuple(lines))


def _deviation(row: Row) -> float:
    return float("inf") if row.deviation is None else row.deviation


def _farthest(row: Row) -> Cell:
    name = row.quantity if " " in row.quantity else row.quantity.replace("_", " ")
    return Cell(name, detail=percent(row.deviation), mark=row.mark)


def _marks(rows: Sequence[Row]) -> Table:
    counts = {mark: sum(row.mark is mark for row in rows) for mark in Mark}
    marks = tuple((Cell("", mark=m), Cell(str(n), n), Cell(m.value)) for m, n in counts.items())
    return Table(WORDS.say("marks", count=len(rows)), ("mark", "numbers", "meaning"), marks)

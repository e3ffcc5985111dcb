"""Summary of a report: the question, and the answer in a sentence, a picture and a table.

The text is in ``templates/overview.toml``.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any, NamedTuple

from springback.interfaces.reports.page import (
    Entry,
    KeyPoint,
    KeyPoints,
    Section,
    TableCell,
    Wording,
    percent,
    plain,
)
from springback.interfaces.reproduction.figures.overview import overview_figure
from springback.paper.slider import COUNTED, DEFAULT
from springback.studies.comparison import AGREEMENT, Mark, Row

WORDS = Wording.of("overview")
WITHIN = (AGREEMENT, 0.10, 0.25)
"""Chosen: relative deviations from the printed value within which agreement is counted."""
SHARES = ("share", "wider", "widest")
"""Names of these in the text."""
OWN = "ARQ's own"
"""Prefix of the source of c_a in tests with a fit to ARQ."""
Groups = dict[str, list[Row]]


def unfitted_rows(rows: Sequence[Row]) -> list[Row]:
    """Compared numbers that no parameter was fitted to, directly or through c_a of their own test.

    Args:
        rows: All compared numbers.
    """
    free = (Mark.PREDICTED, Mark.CONTRADICTED)
    return [r for r in rows if r.mark in free and not r.dissipation_from.startswith(OWN)]


def groups(rows: Sequence[Row]) -> Groups:
    """`unfitted_rows` by part of the paper and, where there are several, reading.

    Args:
        rows: All compared numbers.
    """
    found: Groups = {}
    for part in WORDS.text["parts"].values():
        for row in unfitted_rows(rows):
            if _belongs(row, part):
                found.setdefault(part["name"].format(reading=row.reading), []).append(row)
    return found


def _belongs(row: Row, part: dict[str, Any]) -> bool:
    return (
        row.experiment in part["experiments"]
        and row.robot in part.get("robots", [row.robot])
        and row.reading.endswith(part.get("ends", ""))
        and part.get("without", "\0") not in row.reading
    )


class Counts(NamedTuple):
    """Number of printed values, each counted once, and of those that agree."""

    numbers: int
    default: int
    """With the default choices: the reading used for flights, and springback's estimator."""
    best: int
    """With the best reading of the slider and the best estimator in flight."""
    somehow: int
    """With any of the readings and estimators."""
    reading: str
    """Reading of `best`; empty without slider tests."""
    estimator: str
    """Estimator of `best`; empty if no other was flown."""


def printed_numbers(rows: Sequence[Row]) -> dict[tuple[str, ...], list[Row]]:
    """Printed numbers with their counterparts, a row for each set of choices.

    Of a number with several definitions one counts: COR when the cage separates, contact time until
    the body is back, the pitch that was flown.

    Args:
        rows: All compared numbers.
    """
    found: dict[tuple[str, ...], list[Row]] = {}
    for row in unfitted_rows(rows):
        if row.experiment == "Table III" and row.quantity not in COUNTED:
            continue
        if "commanded" in row.quantity:
            continue
        alternatives = row.experiment in ("Table III", "Sweep", "Table I")
        test = "" if alternatives else row.reading.split("; ")[0]
        found.setdefault((row.experiment, row.robot, row.surface, row.quantity, test), []).append(
            row
        )
    return found


def counts(rows: Sequence[Row], share: float = AGREEMENT) -> Counts:
    """Counts of printed values that agree within a share of them, each counted once.

    Args:
        rows: All compared numbers.
        share: Relative deviation, such as 0.05.
    """
    numbers = printed_numbers(rows)

    def agreeing(slider: str, estimator: str) -> int:
        return sum(
            any(_agrees(row, share) for row in some if _of_choices(row, slider, estimator))
            for some in numbers.values()
        )

    sliders = dict.fromkeys(
        [DEFAULT, *(r.reading for r in unfitted_rows(rows) if r.robot in ("arq", "quad - arq")
                    and r.experiment in ("Table III", "Sweep"))]
    )  # fmt: skip
    others = dict.fromkeys(r.reading.split("; ")[1] for r in rows if "; " in r.reading)
    best = max(
        ((slider, other) for slider in sliders for other in ("", *others)),
        key=lambda choice: agreeing(*choice),
    )
    somehow = sum(any(_agrees(row, share) for row in some) for some in numbers.values())
    has_slider = any(row.experiment == "Table III" for row in rows)
    return Counts(
        len(numbers), agreeing(DEFAULT, ""), agreeing(*best), somehow,
        best[0] if has_slider else "", best[1],
    )  # fmt: skip


def _agrees(row: Row, share: float) -> bool:
    if row.deviation is None:
        return row.mark is Mark.PREDICTED
    return abs(row.deviation) <= share


def _of_choices(row: Row, slider: str, estimator: str) -> bool:
    """True for a row of a set of choices; one without alternatives belongs to all."""
    if row.experiment in ("Table III", "Sweep"):
        return row.reading in ("Quad", slider)
    if row.experiment == "Resilience" and row.quantity == "success rate":
        return row.reading.partition("; ")[2] == estimator
    return True


def within(rows: Sequence[Row], share: float) -> int:
    """Number of values that deviate from the printed ones by at most a share of them.

    Args:
        rows: Compared numbers.
        share: Relative deviation, such as 0.05.
    """
    return sum(abs(row.deviation) <= share for row in rows if row.deviation is not None)


def overview(rows: Sequence[Row], sections: Sequence[Section] = ()) -> list[Section]:
    """Summary section of a report.

    Args:
        rows: All compared numbers.
        sections: Sections of the report, whose answers are collected.
    """
    parts = groups(rows)
    by_mark = Counter(row.mark for row in rows)
    marks = [(TableCell("", mark=mark), by_mark[mark], mark.value) for mark in Mark]
    content: dict[str, Any] = {"marks": marks, "compared": len(rows), "nothing": not parts}
    if parts:
        answers = [KeyPoint(s.anchor, s.title, s.answer) for s in sections if s.answer]
        first, wider = (counts(rows, share) for share in WITHIN[:2])
        content |= {
            **{name: 100 * share for name, share in zip(SHARES, WITHIN, strict=True)},
            "count": first.numbers, "default": first.default, "somehow": first.somehow,
            "wider_somehow": wider.somehow, "more": _best(first) + _failures_of(rows),
            "reading": first.reading, "overview": overview_figure(parts),
            # not repeated on the same page
            "answers": (KeyPoints(tuple(answers)),) if len(answers) > 1 else (),
            "parts": _by_part(parts), "given": by_mark[Mark.GIVEN], "fitted": by_mark[Mark.FITTED],
        }  # fmt: skip
    return WORDS.sections({"overview": content})


def _best(found: Counts) -> str:
    """Sentence on the choices that give most numbers, if these are not the default ones."""
    if found.best <= found.default:
        return ""
    best = []
    if found.reading not in ("", DEFAULT):
        best.append(WORDS.say("best_slider", reading=found.reading))
    if found.estimator:
        best.append(WORDS.say("best_flight", estimator=found.estimator))
    choices = " and ".join(best)
    return " " + WORDS.say("verdict_best", best=found.best, count=found.numbers, choices=choices)


def _failures_of(rows: Sequence[Row]) -> str:
    """Sentence on the recoveries from a collision that fails in print, with each estimator."""
    found = {
        (row.robot, *row.reading.partition("; ")[::2]): row.ours
        for row in rows
        if row.quantity == "success rate"
    }
    failing = [r for r in rows if r.quantity == "success rate" and r.printed == 0.0]
    for test, estimator in (row.reading.split("; ") for row in failing if "; " in row.reading):
        values = [found.get(key) for key in (
            ("quad", test, estimator), ("arq", test, estimator), ("quad", test, "")
        )]  # fmt: skip
        if None not in values:
            quad, arq, default = (plain(round(100 * (value or 0.0), 1)) for value in values)
            return " " + WORDS.say(
                "verdict_failing", test=test.replace(" deg", "°"), estimator=estimator, quad=quad,
                arq=arq, default=default,
            )  # fmt: skip
    return ""


def _by_part(parts: Groups) -> list[Sequence[Entry]]:
    lines: list[Sequence[Entry]] = []
    for name, rows in parts.items():
        near = (within(rows, share) for share in WITHIN)
        cells = (TableCell(f"{count} of {len(rows)}", count) for count in near)
        far = max(rows, key=lambda row: abs(_deviation(row)))
        lines.append((name, len(rows), *cells, _farthest(far)))
    return lines


def _deviation(row: Row) -> float:
    return float("inf") if row.deviation is None else row.deviation


def _farthest(row: Row) -> TableCell:
    name = row.quantity if " " in row.quantity else row.quantity.replace("_", " ")
    return TableCell(name, detail=percent(row.deviation), mark=row.mark)

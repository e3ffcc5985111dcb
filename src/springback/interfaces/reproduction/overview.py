"""What a report begins with: the question, the answer in a sentence and a picture, part by part.

The words are in ``templates/overview.toml``.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from springback.interfaces.reports.page import (
    FigureBlock,
    KeyPoint,
    KeyPoints,
    Section,
    Table,
    TableCell,
    Wording,
    percent,
    plain,
)
from springback.interfaces.reproduction.figures.overview import overview_figure
from springback.paper.choices import OURS
from springback.paper.slider import COUNTED, DEFAULT
from springback.studies.comparison import AGREEMENT, Mark, Row

WORDS = Wording.of("overview")
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
        and part.get("without", "\0") not in row.reading
    )


class Counts(NamedTuple):
    """Printed numbers, each counted once, and how many agree."""

    numbers: int
    default: int
    """With the default choices: the reading that every flight has, springback's estimator."""
    best: int
    """With one other reading of the slider, and one other estimator in flight."""
    somehow: int
    """With any of the readings and estimators."""
    reading: str
    """On the slider, of `best`; empty where no slider was flown."""
    estimator: str
    """In flight, of `best`; empty where no other was flown."""


def printed_numbers(rows: Sequence[Row]) -> dict[tuple[str, ...], list[Row]]:
    """Every printed number once, with what stands for it, a row for each set of choices.

    A number that can be defined in several ways counts by one of them: COR when the cage leaves,
    contact time until the body is back, the pitch that was flown.

    Args:
        rows: All compared numbers.
    """
    found: dict[tuple[str, ...], list[Row]] = {}
    for row in untouched(rows):
        if row.experiment == "Table III" and row.quantity not in COUNTED:
            continue
        if "asked for" in row.quantity:
            continue
        alternatives = row.experiment in ("Table III", "Sweep", "Table I")
        test = "" if alternatives else row.reading.split("; ")[0]
        found.setdefault((row.experiment, row.robot, row.surface, row.quantity, test), []).append(
            row
        )
    return found


def counts(rows: Sequence[Row], share: float = AGREEMENT) -> Counts:
    """How many printed numbers agree within a share of them, each counted once.

    Args:
        rows: All compared numbers.
        share: Such as 0.05.
    """
    numbers = printed_numbers(rows)

    def agreeing(slider: str, estimator: str) -> int:
        return sum(
            any(_agrees(row, share) for row in some if _taken(row, slider, estimator))
            for some in numbers.values()
        )

    sliders = dict.fromkeys(
        [DEFAULT, *(r.reading for r in untouched(rows) if r.robot in ("arq", "quad - arq")
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


def _taken(row: Row, slider: str, estimator: str) -> bool:
    """Whether a row belongs to a set of choices; what has no alternatives belongs to all."""
    if row.experiment in ("Table III", "Sweep"):
        return row.reading in ("Quad", slider)
    if row.experiment == "Resilience" and row.quantity == "success rate":
        return row.reading.partition("; ")[2] == estimator
    return True


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
    answers = [KeyPoint(s.anchor, s.title, s.answer) for s in sections if s.answer]
    if len(answers) == 1:  # no need to say it twice on one page
        answers = []
    found = [counts(rows, share) for share in WITHIN]
    first = found[0]
    verdict = WORDS.say(
        "verdict", count=first.numbers, share=plain(100 * AGREEMENT), default=first.default,
        somehow=first.somehow, wider=plain(100 * WITHIN[1]), wider_somehow=found[1].somehow,
    )  # fmt: skip
    readings = WORDS.text["readings"] if first.reading else ""
    if first.best > first.default:
        changed = first.reading not in ("", DEFAULT)
        best = [WORDS.say("best_slider", reading=first.reading)] if changed else []
        best += [WORDS.say("best_flight", estimator=first.estimator)] if first.estimator else []
        verdict += " " + WORDS.say(
            "verdict_best", best=first.best, count=first.numbers, choices=" and ".join(best)
        )
    verdict += _failures_of(rows)
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
            verdict,
            *([WORDS.say("readings", default=DEFAULT, ours=OURS)] if readings else []),
            FigureBlock("overview", words, overview_figure(parts)),
            *([KeyPoints(tuple(answers))] if answers else []),
            _by_part(parts),
            note,
            _marks(rows),
        ),
        summary=True,
        answers=True,
    )


def _failures_of(rows: Sequence[Row]) -> str:
    """How a collision that print has failing goes with each estimator, and ARQ's beside it."""
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


def _by_part(parts: Groups) -> Table:
    lines = []
    for name, rows in parts.items():
        counts = (within(rows, share) for share in WITHIN)
        cells = (TableCell(f"{count} of {len(rows)}", count) for count in counts)
        far = max(rows, key=lambda row: abs(_deviation(row)))
        lines.append(
            (TableCell(name), TableCell(str(len(rows)), len(rows)), *cells, _farthest(far))
        )
    shares = [plain(100 * share) for share in WITHIN]
    head = tuple(word.format(*shares) for word in WORDS.head("parts"))
    return Table(WORDS.say("caption"), head, tuple(lines))


def _deviation(row: Row) -> float:
    return float("inf") if row.deviation is None else row.deviation


def _farthest(row: Row) -> TableCell:
    name = row.quantity if " " in row.quantity else row.quantity.replace("_", " ")
    return TableCell(name, detail=percent(row.deviation), mark=row.mark)


def _marks(rows: Sequence[Row]) -> Table:
    counts = {mark: sum(row.mark is mark for row in rows) for mark in Mark}
    marks = tuple(
        (TableCell("", mark=m), TableCell(str(n), n), TableCell(m.value)) for m, n in counts.items()
    )
    return Table(WORDS.say("marks", count=len(rows)), ("mark", "numbers", "meaning"), marks)

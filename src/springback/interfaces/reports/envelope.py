"""Page of a map of success: reach of each robot, the figure, and a table of all cells."""

from __future__ import annotations

from springback.campaign.analysis.envelope import LEVEL, Envelope, Place
from springback.interfaces.figures.envelope import ROBOTS, Printed, map_figure
from springback.interfaces.reports.page import (
    Blocks,
    FigureBlock,
    Section,
    Table,
    TableCell,
    Wording,
    page,
    plain,
)

WORDS = Wording.of("map")


def map_page(envelope: Envelope, printed: Printed) -> str:
    """Self-contained HTML page of a map.

    Args:
        envelope: Envelope of one or more robots.
        printed: Function that returns the paper's result of a test.
    """
    axes = {"x": envelope.x.label, "y": envelope.y.label}
    picture = WORDS.say("picture", level=plain(100 * LEVEL), **axes)
    reaches = tuple(_with_labels(envelope.sentence(robot) + ".") for robot in envelope.robots)
    asked = WORDS.say("asked", robots=_names(envelope), trials=envelope.trials, **axes)
    short: Blocks = (asked, *reaches, FigureBlock("map", picture, map_figure(envelope, printed)))
    tables = tuple(_table(envelope, robot) for robot in envelope.robots)
    sections = [
        Section("overview", WORDS.title("overview"), short, summary=True),
        Section("cells", WORDS.title("cells"), (WORDS.say("cells"), *tables)),
        Section("method", WORDS.title("method"), _method(envelope)),
    ]
    return page(WORDS.say("title", **axes), sections, lead=WORDS.say("lead"))


def _with_labels(sentence: str) -> str:
    preset, _, rest = sentence.partition(":")
    return f"{ROBOTS.get(preset, preset)}:{rest}"


def _names(envelope: Envelope) -> str:
    return " and ".join(ROBOTS.get(robot, robot) for robot in envelope.robots)


def _table(envelope: Envelope, robot: str) -> Table:
    """Table of successes, a row for each value of y, the largest on top."""
    lines = []
    for row in sorted(range(len(envelope.y.values)), key=lambda j: -envelope.y.values[j]):
        cells = [envelope.cells[Place(robot, i, row)] for i in range(len(envelope.x.values))]
        entries = (
            TableCell(f"{cell.successes} of {cell.trials}", cell.share)
            if cell.trials
            else TableCell("–")
            for cell in cells
        )
        lines.append((TableCell(f"{envelope.y.values[row]:g}"), *entries))
    head = (f"{envelope.y.label} over {envelope.x.label}", *(f"{v:g}" for v in envelope.x.values))
    return Table(WORDS.say("caption", robot=ROBOTS.get(robot, robot)), head, tuple(lines))


def _method(envelope: Envelope) -> tuple[str | Table, ...]:
    settings = "; ".join(envelope.settings) or WORDS.text["none"]
    said = WORDS.say("method", seed=envelope.seed, settings=settings)
    reasons = dict.fromkeys(
        (TableCell(ROBOTS.get(place.robot, place.robot)), TableCell(cell.reason))
        for place, cell in envelope.cells.items() if not cell.trials and cell.reason
    )  # fmt: skip
    if not reasons:
        return (said,)
    return said, Table(WORDS.say("reasons"), WORDS.head("reasons"), tuple(reasons), folded=True)

"""Page of a campaign; its text and layout are in ``templates/campaign.toml``."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from itertools import combinations
from pathlib import Path
from typing import Any

from springback.campaign.analysis.marginals import Marginal, field_map, fields_of
from springback.campaign.analysis.statistics import Summary
from springback.interfaces.figures import campaign as figures
from springback.interfaces.figures import style
from springback.interfaces.output.robots import with_labels
from springback.interfaces.reports.outcomes import outcome_table, quantile_table, share_text
from springback.interfaces.reports.page import (
    Content,
    Entry,
    FigureBlock,
    Section,
    TableCell,
    Wording,
    page,
)
from springback.studies.proportions import CONFIDENCE

WORDS = Wording.of("campaign")
#: Number of fields whose pairs are drawn by default (chosen: six maps).
MOST_PAIRED = 4
#: Most cells along a field of a map, and least mean number of flights in a cell (chosen).
MOST_CELLS, FLIGHTS_EACH = 16, 20


def write_page(
    found: Summary, marginals: Sequence[Marginal], folder: Path, pairs: Sequence[tuple[str, str]]
) -> list[Path]:
    """Write figures, and the page ``summary.html`` with them.

    Args:
        found: The summary.
        marginals: Success over each field.
        folder: Folder to write into.
        pairs: Pairs of fields to map; by default all pairs of the first four.

    Returns:
        The files written.
    """
    written = []
    pictures = _pictures(found, marginals, pairs)
    for block in pictures:
        written += style.save(block.figure, folder / block.name)
    lead, sections = _page(found, pictures)
    written.append(folder / "summary.html")
    text = page(str(found.campaign.about["name"]), sections, lead=lead)
    written[-1].write_text(text, encoding="utf-8")
    return written


def _pictures(
    found: Summary, marginals: Sequence[Marginal], pairs: Sequence[tuple[str, str]]
) -> list[FigureBlock]:
    """Figures of success over each field, and over pairs of fields."""
    campaign, blocks = found.campaign, []
    flown = sum(one.flights - one.refused for one in found.robots) / len(found.robots)
    cells = max(4, min(MOST_CELLS, math.isqrt(int(flown / FLIGHTS_EACH))))
    if marginals:
        figure = figures.marginals_figure(marginals)
        said = WORDS.say("marginals", confidence=100 * CONFIDENCE)
        blocks.append(FigureBlock("marginals", said, figure))
    for x, y in pairs or combinations(fields_of(campaign)[:MOST_PAIRED], 2):
        figure = figures.field_map_figure(field_map(campaign, x, y, cells))
        blocks.append(FigureBlock(f"map-{x}-{y}", words_of_map(x, y), figure))
    return blocks


def words_of_map(x: str, y: str) -> str:
    """Caption of a map over two fields."""
    return WORDS.say("map", x=_plain(x), y=_plain(y))


def _page(found: Summary, pictures: Sequence[FigureBlock]) -> tuple[str, list[Section]]:
    """Line below the title, and sections."""
    about = found.campaign.about
    confidence = {"confidence": 100 * CONFIDENCE}
    shares = "; ".join(f"{_plain(one.robot)} {share_text(one.success)}" for one in found.robots)
    content: dict[str, Content] = {
        "overview": {
            **confidence, "rule": found.campaign.design.success, "shares": shares,
            "refusal": f": {found.refusal}" if found.refusal else "",
            "pairs": [_plain(pair.sentence()) + "." for pair in found.pairs],
            "first": pictures[:1],
        },
        "robots": {"outcomes": _entries(*outcome_table(found.robots))},
        "measures": {**confidence, "quantiles": _entries(*quantile_table(found.robots))},
        "fields": {"maps": pictures[1:]},
    }  # fmt: skip
    lead = WORDS.say(
        "lead", **about, done=found.campaign.done, version=about["versions"]["springback"]
    )
    return lead, WORDS.sections(content)


def _entries(head: list[str], rows: list[tuple[Any, ...]]) -> list[Sequence[Entry]]:
    """Convert a table of the terminal to one of the page."""

    def entry(value: Any) -> Entry:
        if isinstance(value, float):
            return TableCell(f"{value:.4g}", value)
        return _plain(value) if isinstance(value, str) else value

    return [list(map(_plain, head)), *([entry(value) for value in row] for row in rows)]


def _plain(text: str) -> str:
    """Names for people: of robots, outcomes and units."""
    return with_labels(re.sub(r"(?<=[a-z])_(?=[a-z])", " ", text).replace("^2", "²"))

"""Page of a campaign; its text and layout are in ``templates/campaign.toml``."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from itertools import combinations
from pathlib import Path
from typing import Any

from springback.campaign.access import Campaign
from springback.campaign.analysis.failures import MOST, PEAK, FailureList, failures
from springback.campaign.analysis.levels import FieldSummary
from springback.campaign.analysis.marginals import SUCCESS, field_map
from springback.campaign.analysis.statistics import Summary
from springback.campaign.analysis.worst_case import WorstCase, WorstCaseMap
from springback.interfaces.figures import campaign as figures
from springback.interfaces.figures import measures as measure_figures
from springback.interfaces.figures import style
from springback.interfaces.figures.worst_case import worst_case_figure, worst_case_map_figure
from springback.interfaces.output.folders import file_stem
from springback.interfaces.output.no_contact import (
    doubt_lines,
    has_misses,
    missed_lines,
    pierced_lines,
    pressing_line,
    untouched_line,
    worst_doubt_lines,
)
from springback.interfaces.output.robots import robot_label, with_labels
from springback.interfaces.output.worst_case import answer_lines, answer_table
from springback.interfaces.reports.measures import MeasureReport
from springback.interfaces.reports.outcomes import (
    distribution_table,
    drawn_ranges,
    failure_table,
    four_digits,
    level_quantile_table,
    level_table,
    measure_unit,
    outcome_table,
    quantile_table,
    success_text,
)
from springback.interfaces.reports.page import (
    Blocks,
    Content,
    Entry,
    FigureBlock,
    Section,
    TableCell,
    Wording,
    page,
    table,
)
from springback.intervals import CONFIDENCE

WORDS = Wording.of("campaign")
#: Number of fields whose pairs are drawn by default: of success, and of a measure (chosen).
MOST_PAIRED, MEASURE_PAIRED = 4, 3
#: Most cells along a field of a map, so that each has room for its numbers, and least mean number
#: of flights in a cell (chosen).
MOST_CELLS, FLIGHTS_EACH = 8, 20


def write_page(
    found: Summary,
    reports: Sequence[MeasureReport],
    folder: Path,
    pairs: Sequence[tuple[str, str]] = (),
    cells: int | None = None,
    levels: Sequence[FieldSummary] = (),
    worst_cases: Sequence[WorstCase | WorstCaseMap] = (),
) -> list[Path]:
    """Write figures, and the page ``summary.html`` with them.

    Args:
        found: The summary.
        reports: Success, and measures to show in detail.
        folder: Folder to write into.
        pairs: Pairs of fields to map; by default see `springback.interfaces.reports.campaign`.
        cells: Number of cells along each field of a map; by default as many as flights allow.
        levels: Summaries by the levels of fields.
        worst_cases: Worst cases over fields.

    Returns:
        The files written.
    """
    flown = sum(one.flights - one.refused for one in found.robots) / len(found.robots)
    count = cells or max(4, min(MOST_CELLS, math.isqrt(int(flown / FLIGHTS_EACH))))
    taken, misses = set[str](), has_misses(found)
    drawn = [_pictures(found.campaign, one, pairs, count, taken, misses) for one in reports]
    limits = [_limit_blocks(found.campaign, one, taken) for one in worst_cases]
    written = []
    pictured = [block for blocks in (*drawn, *limits) for block in blocks]
    for block in (block for block in pictured if isinstance(block, FigureBlock)):
        written += style.save(block.figure, folder / block.name, image=block.image)
    more: dict[str, Content] = {
        "limits": {"answers": [block for blocks in limits for block in blocks]},
        "levels": {"fields": [block for one in levels for block in _level_blocks(one, misses)]},
    }
    sections = _sections(found, reports, drawn, more)
    lead = WORDS.say(
        "lead", **_about(found), done=found.campaign.done,
        version=found.campaign.metadata["versions"].get("springback", "?"),
    )  # fmt: skip
    written.append(folder / "summary.html")
    text = page(str(found.campaign.metadata["name"]), sections, lead=lead)
    written[-1].write_text(text, encoding="utf-8")
    return written


def _about(found: Summary) -> dict[str, Any]:
    """Facts on the campaign, with the time of its start to the minute."""
    about = dict(found.campaign.metadata)
    return about | {"started": str(about.get("started", "?"))[:16].replace("T", " ")}


def _pictures(
    campaign: Campaign,
    one: MeasureReport,
    pairs: Sequence[tuple[str, str]],
    cells: int,
    taken: set[str],
    misses: bool,
) -> list[FigureBlock]:
    """Figures of success or a measure: distribution, over each field, sensitivity, maps.

    ``taken`` are names of files, as of `file_stem`; ``misses`` tells that of `has_misses`.
    """
    whose, what = ([], "") if one.name == SUCCESS else ([one.name], _plain(one.name))
    key = "success" if one.name == SUCCESS else "measure"
    blocks = []

    def add(name: str, figure: style.StyledFigure, caption: str, *of: str, **given: Any) -> None:
        said = WORDS.say(caption, confidence=100 * CONFIDENCE, what=what, **given)
        said += f" {WORDS.say('misses')}" if misses and key == "success" else ""
        blocks.append(FigureBlock(file_stem(name, *whose, *of, taken=taken), said, figure))

    if one.distribution is not None:
        figure = measure_figures.distribution_figure(one.distribution)
        add("distribution", figure, "distribution")
    varied = [each for each in one.marginals if each.scale.cells > 1]  # others are one point
    if varied:
        add("marginals", figures.marginals_figure(varied), f"marginals_{key}")
    if one.sensitivity.robots:
        figure = measure_figures.sensitivity_figure(one.sensitivity)
        add("sensitivity", figure, f"sensitivity_{key}")
    for x, y in pairs or _usual_pairs(one):
        if one.name in (x, y):
            continue
        figure = figures.field_map_figure(field_map(campaign, x, y, cells, measure=one.name))
        add("map", figure, f"map_{key}", x, y, x=_plain(x), y=_plain(y))
    return blocks


def _usual_pairs(one: MeasureReport) -> list[tuple[str, str]]:
    """Pairs of the first fields of the plan; for a measure of those that it depends on most."""
    names = [marginal.scale.name for marginal in one.marginals if marginal.scale.cells > 1]
    if one.name == SUCCESS:
        return list(combinations(names[:MOST_PAIRED], 2))
    ranked = [name for name in one.sensitivity.ranking() if name in names] or names
    return list(combinations(sorted(ranked[:MEASURE_PAIRED], key=names.index), 2))


def words_of_map(x: str, y: str) -> str:
    """Caption of a map of success over two fields."""
    return WORDS.say("map_success", x=_plain(x), y=_plain(y))


def _limit_blocks(campaign: Campaign, found: WorstCase | WorstCaseMap, taken: set[str]) -> Blocks:
    """Answer, figure and table of a worst case; ``taken`` as of `_pictures`."""
    if isinstance(found, WorstCase):
        names, name = [found.field.name], _plain(found.field.name)
        said = WORDS.say("worst_case", field=name, share=100.0 * found.share)
        figure = worst_case_figure(found, answer=False)
    else:
        names = [found.whole.field.name, found.across.name]
        name = _plain(" and ".join(names))
        said = WORDS.say("worst_case_map", fields=name)
        figure = worst_case_map_figure(found)
    picture = FigureBlock(file_stem("limits", *names, taken=taken), said, figure)
    lines = _entries(*answer_table(found))
    caption = WORDS.say("worst_case_table", field=name)
    numbers = table(caption, [str(word) for word in lines[0]], lines[1:], folded=True)
    doubts = worst_doubt_lines(campaign, found)
    answers = [*_paragraphs(answer_lines(found)), *map(_sentence, doubts)]
    return (*answers, picture, numbers)


def _paragraphs(lines: Sequence[str]) -> list[str]:
    """Lines as sentences; indented ones continue that before them."""
    found: list[str] = []
    for line in lines:
        if line.startswith(" "):
            found[-1] += ("; " if ": " in found[-1] else ": ") + _plain(line.strip())
        else:
            found.append(_plain(line))
    return [f"{text}." for text in found]


def _level_blocks(found: FieldSummary, misses: bool) -> Blocks:
    """Outcomes by the levels of a field, and the levels compared in pairs."""
    lines = _entries(*level_table(found, misses=misses))
    caption = WORDS.say("levels", field=_plain(found.field.name))
    outcomes = table(caption, [str(word) for word in lines[0]], lines[1:])
    lines = _entries(*level_quantile_table(found))
    caption = WORDS.say("level_quantiles", field=_plain(found.field.name))
    quantiles = table(caption, [str(word) for word in lines[0]], lines[1:], folded=True)
    return (outcomes, *(f"{_plain(pair.sentence())}." for pair in found.pairs), quantiles)


def _sections(
    found: Summary,
    reports: Sequence[MeasureReport],
    drawn: Sequence[Sequence[FigureBlock]],
    more: Mapping[str, Content],
) -> list[Section]:
    """Sections of the page; ``more`` are those of limits and levels."""
    confidence = {"confidence": 100 * CONFIDENCE}
    success, replays, misses = reports[0], failures(found.campaign), has_misses(found)
    pictures = {block.name: block for block in drawn[0]}
    shares = "; ".join(
        f"{robot_label(one.robot)} {success_text(one, misses=misses)}" for one in found.robots
    )
    refusal = success.sensitivity.refusal
    content: dict[str, Content] = {
        "overview": {
            **confidence, "rule": found.campaign.design.rule, "shares": shares,
            "conditions": "; ".join(found.campaign.conditions),
            "drawn": _plain("; ".join(drawn_ranges(found.campaign))),
            "refusal": f": {found.refusal}" if found.refusal else "",
            "warned": [_with_command([f"warning: {line}"])[0] for line in found.warnings],
            "missed": _with_command(missed_lines(found)),
            "untouched": _plain(untouched_line(found.campaign)),
            "pressing": _plain(pressing_line(found.campaign)),
            "pierced": _with_command(pierced_lines(found.campaign)),
            "pairs": [_plain(pair.sentence()) + "." for pair in found.pairs],
            "first": [pictures[name] for name in ("marginals",) if name in pictures],
        },
        **more,
        "robots": {"outcomes": _entries(*outcome_table(found.robots, misses=misses))},
        "sensitivity": {
            "indices": [pictures[name] for name in ("sensitivity",) if name in pictures],
            "refusal": f"Indices are missing: {_plain(refusal)}." if refusal else "",
        },
        "failures": {
            "failed": replays.failed, "peak": _plain(PEAK), "most": MOST,
            **{name: _replays(replays, rows) if rows else [] for name, rows in (
                ("flights", replays.rows), ("hardest", replays.hardest), ("kept", replays.kept)
            )},
            "doubt": any(row["in_doubt"] for row in (*replays.rows, *replays.hardest)),
        },
        "measures": {**confidence, "quantiles": _entries(*quantile_table(found.robots))},
        "fields": {"maps": [block for name, block in pictures.items() if name.startswith("map-")]},
    }  # fmt: skip
    own = [
        _measure_section(found.campaign, one, blocks)
        for one, blocks in zip(reports[1:], drawn[1:], strict=True)
    ]
    sections = WORDS.sections({name: held for name, held in content.items() if any(held.values())})
    after = 1 + [section.anchor for section in sections].index("measures")
    return [*sections[:after], *own, *sections[after:]]


def _measure_section(
    campaign: Campaign, one: MeasureReport, blocks: Sequence[FigureBlock]
) -> Section:
    """Section of a measure."""
    assert one.distribution is not None
    measure, unit = one.distribution.measure, measure_unit(one.distribution)
    name = _plain(measure.name)
    head, rows = distribution_table(one.distribution)
    caption = f"{name} [{unit.symbol}]"
    lines = _entries(head, rows)
    said = [WORDS.say("measure", meaning=measure.meaning[:1].upper() + measure.meaning[1:])]
    said += [_sentence(line) for line in doubt_lines(campaign, measure.name)]
    refusal = one.sensitivity.refusal
    said += [WORDS.say("no_indices", why=_plain(refusal))] * bool(refusal)
    return Section(
        f"measure-{measure.name}", name[:1].upper() + name[1:],
        (said[0], table(caption, [str(word) for word in lines[0]], lines[1:]), *said[1:], *blocks),
    )  # fmt: skip


def _sentence(line: str) -> str:
    """A line of the terminal as a sentence."""
    return f"{line[:1].upper()}{_plain(line[1:])}."


def _with_command(lines: Sequence[str]) -> list[str]:
    """Sentences, but for the last line, whose command is typed as it is."""
    told = [f"{_plain(line)}." for line in lines[:-1]]
    return [*told, *(line[:1].upper() + line[1:] for line in lines[-1:])]


def _replays(found: FailureList, listed: Sequence[Mapping[str, Any]]) -> list[Sequence[Entry]]:
    """Table of flights with the commands that replay them."""
    head, rows = failure_table(found, listed)
    lines = ([row[0], TableCell(row[1], code=True), *map(_entry, row[2:])] for row in rows)
    return [list(map(_plain, head)), *lines]


def _entry(value: Any) -> Entry:
    if isinstance(value, float):
        return TableCell(four_digits(value), value)
    return _plain(value) if isinstance(value, str) else value


def _entries(head: list[str], rows: list[tuple[Any, ...]]) -> list[Sequence[Entry]]:
    """Convert a table of the terminal to one of the page."""
    return [list(map(_plain, head)), *(list(map(_entry, row)) for row in rows)]


def _plain(text: str) -> str:
    """Names for people: of robots, fields, outcomes and units."""
    words = re.sub(r"(?<=[a-z])_(?=[a-z])", " ", text).replace("^2", "²")
    return with_labels(figures.in_words(words))

"""Summary of a campaign as text and as files."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from springback.campaign.analysis.failures import failures
from springback.campaign.analysis.levels import FieldSummary
from springback.campaign.analysis.statistics import Summary
from springback.campaign.analysis.worst_case import WorstCase, WorstCaseMap
from springback.files import write_json
from springback.interfaces.output.no_contact import (
    doubt_lines,
    has_misses,
    missed_lines,
    pierced_lines,
    pressing_line,
    untouched_line,
    worst_doubt_lines,
)
from springback.interfaces.output.tables import as_text
from springback.interfaces.output.worst_case import answer_lines, answer_table
from springback.interfaces.reports.measures import MeasureReport, measure_report
from springback.interfaces.reports.outcomes import (
    distribution_table,
    drawn_ranges,
    level_quantile_table,
    level_table,
    measure_unit,
    outcome_table,
    quantile_table,
    sensitivity_table,
)


def summary_text(
    found: Summary,
    measures: Sequence[MeasureReport] = (),
    *,
    levels: Sequence[FieldSummary] = (),
    worst_cases: Sequence[WorstCase | WorstCaseMap] = (),
) -> str:
    """Summary for a terminal; see `write_summary`."""
    about = found.campaign.metadata
    done, of = found.campaign.done, about["flights"]
    known, misses = found.campaign, has_misses(found)
    said = (
        *missed_lines(found),
        untouched_line(known),
        pressing_line(known),
        *pierced_lines(known),
    )
    remarks = filter(None, said)
    state = "complete" if done == of else f"{100.0 * done / of:.1f} %, continue with --resume"
    lines = [
        f"{about['name']}: {done} of {of} flights ({state})",
        f"success: {found.campaign.design.rule}",
        *(f"only flights with: {text}" for text in found.campaign.conditions),
        *(f"drawn: {text}" for text in drawn_ranges(found.campaign)),
        "",
        as_text(*outcome_table(found.robots, misses=misses)),
        *(f"warning: {line}" for line in found.warnings),
        *([found.refusal] * bool(found.refusal)),
        *remarks,
        "",
        "10 %, 50 % and 90 % quantiles of flights",
        as_text(*quantile_table(found.robots)),
    ]
    lines += ["", *(pair.sentence() for pair in found.pairs)] * bool(found.pairs)
    for by in levels:
        lines += ["", f"by {by.field.name}", as_text(*level_table(by, misses=misses))]
        lines += [pair.sentence() for pair in by.pairs]
        lines += ["", as_text(*level_quantile_table(by))]
    for one in measures:
        lines += ["", *_measure_lines(one), *doubt_lines(known, one.name)]
    for worst in worst_cases:
        lines += ["", *answer_lines(worst), *worst_doubt_lines(known, worst)]
        lines += [as_text(*answer_table(worst))]
    replay = failures(found.campaign, 1).sentence()
    return "\n".join([*lines, *(["", replay] * bool(replay))])


def _measure_lines(one: MeasureReport) -> list[str]:
    """Distribution and sensitivity of a measure."""
    lines = []
    if one.distribution is not None:
        measure, unit = one.distribution.measure, measure_unit(one.distribution)
        lines += [f"{measure.name} [{unit.symbol}]: {measure.meaning}"]
        lines += [as_text(*distribution_table(one.distribution)), ""]
    if one.sensitivity.robots:
        lines += [f"share of the variance of {one.name} that a field alone explains (95 %)"]
        lines += [as_text(*sensitivity_table(one.sensitivity))]
    if one.sensitivity.refusal:
        lines += [f"{one.name}: no sensitivity: {one.sensitivity.refusal}"]
    return lines


def write_summary(
    found: Summary,
    folder: Path,
    *,
    measures: Sequence[MeasureReport] = (),
    levels: Sequence[FieldSummary] = (),
    worst_cases: Sequence[WorstCase | WorstCaseMap] = (),
    pairs: Sequence[tuple[str, str]] = (),
    cells: int | None = None,
    scatter: bool = False,
    figures: bool = True,
) -> list[Path]:
    """Write ``summary.json`` and, with ``figures``, figures and the page ``summary.html``.

    Args:
        found: The summary.
        folder: Folder to write into.
        measures: Measures to show in detail, beside success.
        levels: Summaries by the levels of fields.
        worst_cases: Worst cases over fields, with their limits.
        pairs: Pairs of fields to map; by default those of the first four, and for a measure of the
            three with the largest indices.
        cells: Number of cells along each field of a map; by default as many as flights allow.
        scatter: Show success over the scattered parameters, too.
        figures: Write figures and the page.

    Returns:
        The files written.
    """
    success = measure_report(found.campaign, scatter=scatter)
    data = found.as_dict() | {
        "marginals": [one.as_dict() for one in success.marginals],
        "sensitivity": success.sensitivity.as_dict(),
        "measures": {one.name: one.as_dict() for one in measures},
        "by": [one.as_dict() for one in levels],
        "worst_cases": [one.as_dict() for one in worst_cases],
        "failures": failures(found.campaign).as_dict(),
    }
    write_json(folder / "summary.json", data)
    written = [folder / "summary.json"]
    if not figures:
        return written
    from springback.interfaces.reports.campaign_page import write_page

    reports = [success, *measures]
    return written + write_page(found, reports, folder, pairs, cells, levels, worst_cases)

"""A campaign on one page: robots, outcomes, pairs, and success along its fields."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from itertools import combinations
from pathlib import Path
from typing import Any

from springback.campaign.analysis.intervals import IntervalEstimate
from springback.campaign.analysis.marginals import field_map, fields_of, marginal
from springback.campaign.analysis.statistics import RobotSummary, Summary
from springback.campaign.columns import known_columns
from springback.files import write_json
from springback.interfaces.output.tables import as_text

#: Fields of which all pairs are drawn, unless pairs are named (chosen: six maps).
MOST_PAIRED = 4
#: Cells along a field of a map, so that each holds some flights: at most, and for so many each.
MOST_CELLS, FLIGHTS_EACH = 16, 20


def summary_text(found: Summary) -> str:
    """A summary for a terminal."""
    about = found.campaign.about
    done, of = found.campaign.done, about["flights"]
    state = "complete" if done == of else f"{100.0 * done / of:.1f} %, go on by --resume"
    lines = [
        f"{about['name']}: {done} of {of} flights ({state})",
        f"success: {found.campaign.design.success}",
        "",
        as_text(*outcome_table(found.robots)),
        *([found.refusal] * bool(found.refusal)),
        "",
        "10 %, 50 %, 90 % of flights lie below",
        as_text(*quantile_table(found.robots)),
    ]
    return "\n".join(
        [*lines, *(["", *(pair.sentence() for pair in found.pairs)] * bool(found.pairs))]
    )


def outcome_table(robots: Sequence[RobotSummary]) -> tuple[list[str], list[tuple[Any, ...]]]:
    """Flights, success and outcomes, a row for each robot."""
    words = sorted({word for robot in robots for word in robot.outcomes})
    rows = [
        (
            one.robot, one.flights, one.refused, one.ledger_open, _share(one.success),
            *(one.outcomes.get(word, 0) for word in words),
        )
        for one in robots
    ]  # fmt: skip
    return ["robot", "flights", "refused", "ledger open", "success (95 %)", *words], rows


def quantile_table(robots: Sequence[RobotSummary]) -> tuple[list[str], list[tuple[Any, ...]]]:
    """Quantiles of measures, a row for each measure and robot."""
    rows: list[tuple[Any, ...]] = []
    names = dict.fromkeys(name for robot in robots for name in robot.measures)
    for name in names:
        unit = known_columns()[name][0]
        factor, unit = (180.0 / math.pi, "deg") if unit == "rad" else (1.0, unit)
        for robot in robots:
            if name in robot.measures:
                count, (low, middle, high) = robot.measures[name]
                numbers = [_scaled(e.value, factor) for e in (low, middle, high)]
                bounds = [_scaled(middle.low, factor), _scaled(middle.high, factor)]
                interval = " to ".join("?" if b is None else f"{b:.4g}" for b in bounds)
                shown = [None if n is None else float(f"{n:.4g}") for n in numbers]
                rows.append((f"{name} [{unit or '-'}]", robot.robot, count, *shown, interval))
    return ["measure", "robot", "flights", "10 %", "50 %", "90 %", "median, 95 %"], rows


def _scaled(value: float | None, factor: float) -> float | None:
    return None if value is None else value * factor


def _share(estimate: IntervalEstimate) -> str:
    if estimate.value is None or estimate.low is None or estimate.high is None:
        return "-"
    value, low, high = (100.0 * x for x in (estimate.value, estimate.low, estimate.high))
    return f"{value:.2f} % ({low:.2f} to {high:.2f})"


def write_summary(
    found: Summary,
    folder: Path,
    *,
    pairs: Sequence[tuple[str, str]] = (),
    scatter: bool = False,
    figures: bool = True,
) -> list[Path]:
    """Write ``summary.json`` and, with figures, those and the page ``summary.html``.

    Args:
        found: The summary.
        folder: To write into.
        pairs: Fields to be mapped two by two; by default all of the first four.
        scatter: Whether success along what luck deals out is shown, too.
        figures: Whether figures are wanted.

    Returns:
        The files written.
    """
    campaign = found.campaign
    fields = fields_of(campaign, scatter=scatter)
    marginals = [marginal(campaign, name) for name in fields]
    data = found.as_dict() | {"marginals": [one.as_dict() for one in marginals]}
    write_json(folder / "summary.json", data)
    written = [folder / "summary.json"]
    if not figures:
        return written
    from springback.interfaces.figures import campaign as plots_campaign
    from springback.interfaces.figures import style
    from springback.interfaces.reports import page as report_page

    flown = sum(one.flights - one.refused for one in found.robots) / len(found.robots)
    cells = max(4, min(MOST_CELLS, math.isqrt(int(flown / FLIGHTS_EACH))))
    pictures: dict[str, tuple[Any, str]] = {}
    if marginals:
        words = "Share of flights that succeed along each field, the others being what they are; "
        words += "bands and bars are Wilson's 95 % intervals."
        pictures["marginals"] = (plots_campaign.marginals_figure(marginals), words)
    for x, y in pairs or combinations(fields_of(campaign)[:MOST_PAIRED], 2):
        figure = plots_campaign.field_map_figure(field_map(campaign, x, y, cells))
        pictures[f"map-{x}-{y}"] = (figure, words_of_map(x, y))
    for name, (figure, _) in pictures.items():
        written += style.save(figure, folder / name)
    shown = [report_page.FigureBlock(name, text, fig) for name, (fig, text) in pictures.items()]
    sections = _sections(found, shown)
    page = report_page.page(str(campaign.about["name"]), sections, lead=_lead(found))
    (folder / "summary.html").write_text(page, encoding="utf-8")
    return [*written, folder / "summary.html"]


def words_of_map(x: str, y: str) -> str:
    """Caption of a map over two fields."""
    return f"Share of flights that succeed over {_said(x)} and {_said(y)}."


def _lead(found: Summary) -> str:
    about = found.campaign.about
    return (
        f"A campaign of {found.campaign.done} of {about['flights']} flights, seed {about['seed']}, "
        f"springback {about['versions']['springback']}, begun {about['started']} on "
        f"{about['host']} ({about['cpu']})"
    )


def _sections(found: Summary, pictures: Sequence[Any]) -> list[Any]:
    from springback.interfaces.reports import page as report_page

    def table(caption: str, head: list[str], rows: list[tuple[Any, ...]]) -> Any:
        cells = tuple(
            tuple(
                report_page.TableCell(f"{v:.4g}" if isinstance(v, float) else str(v), float(v))
                if isinstance(v, int | float)
                else report_page.TableCell("–" if v is None else _said(str(v)))
                for v in row
            )
            for row in rows
        )
        return report_page.Table(caption, tuple(map(_said, head)), cells)

    outcomes = table("Robots and outcomes", *outcome_table(found.robots))
    quantiles = table("Quantiles of measures", *quantile_table(found.robots))
    rule = found.campaign.design.success
    said = f"Success is: {rule}. Flights that could not be flown count nowhere"
    said += f": {found.refusal}." if found.refusal else "."
    note = (
        "Intervals are at 95 %: of shares Wilson's, of quantiles by order statistics, of "
        "differences between robots those of Agresti and Min."
    )
    sentences = tuple(_said(pair.sentence()) + "." for pair in found.pairs)
    shares = "; ".join(f"{_said(one.robot)} {_share(one.success)}" for one in found.robots)
    verdict = f"Success at 95 % confidence: {shares}."
    first, rest = pictures[:1], tuple(pictures[1:])
    short = (said, verdict, *sentences, *first)
    return [
        report_page.Section("overview", "In short", short, summary=True, answers=True),
        report_page.Section("robots", "Who succeeds", (outcomes,)),
        report_page.Section("measures", "How it goes", (note, quantiles)),
        report_page.Section("fields", "Over two fields", rest),
    ]


def _said(text: str) -> str:
    """Names as people write them: robots, outcomes and units."""
    names = {"arq": "ARQ", "quad": "Quad"}
    plain = re.sub(r"(?<=[a-z])_(?=[a-z])", " ", text).replace("^2", "²")
    return re.sub(r"\b(arq|quad)\b", lambda found: names[found[0]], plain)

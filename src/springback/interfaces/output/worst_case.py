"""Answers of a worst case in sentences, and its table."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from springback.campaign.analysis.worst_case import (
    FieldRange,
    WorstCase,
    WorstCaseLimit,
    WorstCaseMap,
    least_share,
)
from springback.interfaces.output.fields import cell_text, unit_text
from springback.interfaces.output.quantities import DisplayUnit, display_unit, quantity_text
from springback.intervals import CONFIDENCE

#: Most other fields that a sentence names (chosen).
MOST_NAMED = 6


def answer_lines(found: WorstCase | WorstCaseMap) -> list[str]:
    """Where each robot keeps the limits, in sentences; none without limits."""
    return worst_case_lines(found) if isinstance(found, WorstCase) else _map_lines(found)


def worst_case_lines(found: WorstCase) -> list[str]:
    """As `answer_lines`, over one field."""
    limits = [one for one in found.limits if one.text]
    if not limits:
        return []
    lines = []
    for robot in found.robots:
        lines.append(_answer(found, robot, limits))
        if len(limits) > 1:
            lines += [
                f"{robot}: {one.text} alone: {_ranges(found, found.ranges(robot, k)) or 'nowhere'}"
                for k, one in enumerate(found.limits) if one.text
            ]  # fmt: skip
        lines += _without_measure(found, robot)
        lines += [] if found.ranges(robot) else _better(found, robot)
    return [*lines, _taken_over(found)]


def _better(found: WorstCase, robot: str) -> list[str]:
    """What to hold so that the limits are kept more often."""
    parts = [
        f"{one.field.name} {cell_text(one.field, *one.field.bounds(one.cell))} "
        f"({100.0 * one.share:.0f} % of flights)"
        for one in found.better.get(robot, ())
    ]
    return [f"{robot}: kept more often with {', or '.join(parts)}; see --where"] if parts else []


def _map_lines(found: WorstCaseMap) -> list[str]:
    """Where each robot keeps the limits, over two fields."""
    whole, across = found.whole, found.across
    said = " and ".join(one.text for one in whole.limits)
    how = _how(whole)
    lines = []
    for robot in whole.robots:
        kept = {k: one.ranges(robot) for k, one in found.slices.items() if robot in one.robots}
        if any(kept.values()):
            lines.append(f"{robot} keeps {said} in {how} with")
            lines += [
                f"  {across.name} {cell_text(across, *across.bounds(k))}: {whole.field.name} "
                f"{_ranges(whole, parts)}, of {_fewest(parts)} flights or more in each cell"
                for k, parts in kept.items() if parts
            ]  # fmt: skip
            continue
        cells = {k: one.best(robot) for k, one in found.slices.items() if robot in one.robots}
        flown = {k: cell for k, cell in cells.items() if cell is not None}
        if not flown:
            lines.append(f"{robot}: no flight was flown")
            continue
        k = max(flown, key=lambda k: flown[k].all_kept / flown[k].flights)
        lines.append(
            f"{robot}: no {whole.field.name} and {across.name} keep {said} in {how}; closest are "
            f"{cell_text(whole.field, flown[k].low, flown[k].high)} and "
            f"{cell_text(across, *across.bounds(k))}, with {flown[k].all_kept} of "
            f"{flown[k].flights} flights"
        )
        lines += _better(whole, robot)
    return [*lines, _taken_over(whole)]


def _how(found: WorstCase) -> str:
    return "every flight" if found.share == 1.0 else f"{100.0 * found.share:g} % of flights"


def _fewest(parts: Sequence[FieldRange]) -> int:
    """Smallest number of flights of a cell."""
    return min(cell.flights for part in parts for cell in part.cells)


def _answer(found: WorstCase, robot: str, limits: Sequence[WorstCaseLimit]) -> str:
    """Sentence on where a robot keeps all limits."""
    said = " and ".join(one.text for one in limits)
    how = _how(found)
    parts, name = found.ranges(robot), found.field.name
    if not parts:
        best = found.best(robot)
        if best is None:
            return f"{robot}: no flight was flown"
        closest = cell_text(found.field, best.low, best.high)
        return (
            f"{robot}: no {name} keeps {said} in {how}; closest is {closest}, with "
            f"{best.all_kept} of {best.flights} flights"
        )
    kept = [cell for part in parts for cell in part.cells]
    weakest = min(kept, key=lambda cell: least_share(cell.all_kept, cell.flights))
    bound = 100.0 * least_share(weakest.all_kept, weakest.flights)
    count = (
        f"{len(kept)} of {len(found.robots[robot])} {'levels' if found.field.labels else 'cells'}"
    )
    return (
        f"{robot}: {name} {_ranges(found, parts)} keeps {said} in {how} "
        f"({count}, {min(cell.flights for cell in kept)} or more flights in each: at "
        f"{100 * CONFIDENCE:g} % confidence {bound:.0f} % of such flights or more)"
    )


def _ranges(found: WorstCase, parts: Sequence[FieldRange]) -> str:
    """Text of ranges, with a remark where they end with the values flown."""
    cut = found.field
    if cut.labels and not cut.edges:
        return ", ".join(cut.labels[cell.number] for part in parts for cell in part.cells)
    unit = display_unit(cut.unit)
    last = cut.cells - 1
    texts = []
    for part in parts:
        low, high = sorted((part.low, part.high))
        ends = quantity_text(low * unit.factor)
        if high > low:
            ends += f" to {quantity_text(high * unit.factor)}"
        first, final = part.cells[0].number == 0, part.cells[-1].number == last
        whole = " (all flown)" if first and final else " (from the first flown)" * first
        texts.append(f"{ends}{unit_text(unit)}{whole or ' (to the last flown)' * final}")
    return " and ".join(texts)


def _without_measure(found: WorstCase, robot: str) -> list[str]:
    """Remarks on flights that break a limit because they do not have its measure."""
    lines = []
    for k, one in enumerate(found.limits):
        count = sum(cell.missing[k] for cell in found.robots[robot])
        if one.text and one.measure and count and " or " not in one.text:
            lines.append(
                f"{robot}: {count} flights have no {one.measure.name} and so break its limit; "
                f'"{one.text} or no_contact" excuses those that touch nothing'
            )
    return lines


def _taken_over(found: WorstCase) -> str:
    """Sentence on what the worst case is taken over."""
    names = list(found.others[:MOST_NAMED])
    more = len(found.others) - len(names)
    over = ", ".join(names) + f" and {more} more" * bool(more)
    where = f"; only flights with {'; '.join(found.conditions)}" * bool(found.conditions)
    return f"The worst case is over all {over or 'repeats'}{where}"


def measure_unit(found: WorstCase, k: int) -> DisplayUnit:
    """Unit in which the measure of a limit is shown."""
    one = found.limits[k]
    values = [cell.worst[k] for cells in found.robots.values() for cell in cells]
    return display_unit(one.measure.unit if one.measure else "", [*values, *one.values])


Rows = tuple[list[str], list[tuple[Any, ...]]]
"""Heads of a table, and its rows."""


def answer_table(found: WorstCase | WorstCaseMap) -> Rows:
    """Table of a worst case, a row for each robot and value of the field, or of the two."""
    if isinstance(found, WorstCase):
        return worst_case_table(found)
    head, _ = worst_case_table(found.whole)
    rows = [
        (robot, cell_text(found.across, *found.across.bounds(k)), *rest)
        for k, one in found.slices.items() for robot, *rest in worst_case_table(one)[1]
    ]  # fmt: skip
    return [head[0], found.across.name, *head[1:]], rows


def worst_case_table(found: WorstCase) -> Rows:
    """As `answer_table`, over one field."""
    units = [measure_unit(found, k) for k in range(len(found.limits))]
    shown = [k for k, one in enumerate(found.limits) if one.measure]
    head = ["robot", found.field.name, "flights"]
    for k in shown:
        measure = found.limits[k].measure
        head.append(f"{measure.name if measure else ''} [{units[k].symbol}]")
    head += [one.text for one in found.limits if one.text]
    rows = []
    for robot, cells in found.robots.items():
        for cell in cells:
            worst = (cell.worst[k] for k in shown)
            factors = (units[k].factor for k in shown)
            kept = (n for n, one in zip(cell.kept, found.limits, strict=True) if one.text)
            rows.append(
                (
                    robot, cell_text(found.field, cell.low, cell.high), cell.flights,
                    *("-" if v is None else quantity_text(v * f)
                      for v, f in zip(worst, factors, strict=True)),
                    *(f"{100.0 * n / cell.flights:.4g} %" for n in kept),
                )
            )  # fmt: skip
    return head, rows

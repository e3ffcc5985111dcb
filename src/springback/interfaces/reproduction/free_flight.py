"""Features and free flight in the report: Table I and Table IV.

The text and its order are in ``templates/flight.toml``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, replace
from itertools import product
from typing import Any

import numpy as np

from springback.interfaces.output.robots import ROBOTS as LOOKS
from springback.interfaces.reports.page import (
    Content,
    Entry,
    Section,
    TableCell,
    Wording,
    join,
    percent,
    plain,
    words_of_power,
)
from springback.interfaces.reproduction.figures import free_flight
from springback.interfaces.reproduction.figures.free_flight import (
    BAND,
    ERRORS,
    PACES,
    ROBOT_STYLES,
    Ratio,
)
from springback.paper.features import TABLE_I
from springback.paper.free_flight import (
    CIRCLE_TIME,
    DROP_HEIGHT,
    DWELL,
    PERIODS,
    QUANTITIES,
    RADIUS,
    ROBOTS,
    TABLE_IV_CIRCLES,
    FlightResults,
)
from springback.studies.comparison import Mark, Row

WORDS = Wording.of("flight")
NAMES = {name: look.label for name, look in ROBOT_STYLES.items()}
TWICE = 2.0
"""Factor within which a mean square error on a circle counts as close."""
THOUSANDTHS = "10⁻³"
CURVE_STEP = 0.01
"""Chosen: spacing of the points of curves in CSV files [s]."""


def flight_sections(features: Sequence[Row], results: FlightResults | None) -> list[Section]:
    """Sections on features and free flight; parts without results are left out."""
    content = {"features": _features(features) if features else {}}
    if results is not None:
        rows = results.rows()
        steps = sorted((row for row in rows if row.reading == "steps"), key=_rise_first)
        circles = [row for row in rows if row.reading.endswith("circle")]
        content["flight"] = _answer(results)
        content["steps"] = _steps(results, steps) if steps else {}
        content["circles"] = _circles(results, circles) if circles else {}
        content["flight_wrong"] = _wrong(results, steps, circles) if rows else {}
    return WORDS.sections(content)


def _digits(value: float | None, digits: int = 3) -> str:
    """Computed number with about as many digits as the printed one."""
    if value is None:
        return "–"
    return f"{value:#.{digits}g}".rstrip(".").replace("-", "−")


def _ours(row: Row | None, scale: float = 1.0) -> TableCell:
    if row is None:
        return TableCell("–")
    number = None if row.ours is None else scale * row.ours
    if row.mark is Mark.GIVEN:
        return TableCell(plain(number), row.ours, "", row.mark)
    return TableCell(_digits(number), row.ours, percent(row.deviation), row.mark)


def _label(row: Row, unit: str | None = None) -> str:
    unit = row.unit if unit is None else unit
    shown = row.reading not in ("", "steps")
    name = f"{row.quantity}, {row.reading}" if shown else row.quantity
    return f"{name} [{_set(unit)}]" if unit else name


def _set(unit: str) -> str:
    """Unit as written in a text."""
    return unit.replace("^2", "²")


def _by_line(rows: Sequence[Row]) -> dict[tuple[str, str], dict[str, Row]]:
    """Rows by quantity and reading, then by robot."""
    lines: dict[tuple[str, str], dict[str, Row]] = {}
    for row in rows:
        lines.setdefault((row.quantity, row.reading), {})[row.robot] = row
    return lines


def _contradictions(rows: Sequence[Row], robots: Mapping[str, str]) -> str:
    """Contradicted numbers as text, line by line."""
    words = []
    for line in _by_line([row for row in rows if row.mark is Mark.CONTRADICTED]).values():
        first = next(iter(line.values()))
        who = join(
            f"{robots.get(robot, robot)} ({percent(row.deviation)})" for robot, row in line.items()
        )
        words.append(f"{_label(first, '')} of {who}")
    return "; ".join(words)


# --- Table I


def _features(rows: Sequence[Row]) -> Content:
    payload = next(r for r in rows if r.robot == "arq" and r.quantity == "largest payload")
    hover = [
        r for r in rows
        if r.robot == "arq" and r.quantity == "hover time" and r.mark is not Mark.FITTED
    ]  # fmt: skip
    wrong = _contradictions(rows, {name: look.label for name, look in LOOKS.items()})
    return {
        "payload": _ours(payload),
        "payload_printed": payload.printed,
        "times": _range([f"{r.ours:.0f}" for r in hover]),
        "batteries": _range(
            [r.reading.removeprefix("battery ").removesuffix(" kg") for r in hover]
        ),
        "time_printed": TABLE_I["arq"].hover_time,
        "table_i": _features_table(rows),
        "wrong": wrong,
        "right": not wrong,
        "exponent": 1.5,
        "endurance": free_flight.endurance_figure(),
    }


def _range(words: Sequence[str]) -> str:
    return " to ".join(dict.fromkeys((words[0], words[-1]))) if words else "–"


def _features_table(rows: Sequence[Row]) -> list[list[Entry]]:
    lines: list[list[Entry]] = []
    for line in _by_line(sorted(rows, key=lambda row: row.robot != "arq")).values():
        cells = [
            cell(line.get(robot)) for robot in ("quad", "arq") for cell in (_printed_cell, _ours)
        ]
        notes = dict.fromkeys(row.note for row in line.values() if row.note)
        lines.append([_label(next(iter(line.values()))), *cells, "; ".join(notes) or None])
    return lines


def _printed_cell(row: Row | None, scale: float = 1.0) -> TableCell:
    if row is None or row.printed is None:
        return TableCell("–")
    return TableCell(plain(scale * row.printed), row.printed)


# --- Table IV


def _rise_first(row: Row) -> tuple[bool, str]:
    return (not row.quantity.startswith("rise"), row.quantity)


def _answer(results: FlightResults) -> Content:
    cells = free_flight.table_iv(results)
    if not cells:
        return {"unflown": True}

    def count(name: str, kept: Callable[[Ratio], bool]) -> dict[str, int]:
        found = [cell for cell in cells if kept(cell)]
        met = sum(abs(cell.ratio - 1.0) <= BAND for cell in found)
        return {f"{name}_all": len(found), f"{name}_met": met}

    return {
        **count("quad", lambda c: c.test not in PACES and c.robot == "quad"),
        **count("arq", lambda c: c.test not in PACES and c.robot != "quad"),
        **count("circle", lambda c: c.test in PACES),
        "circle_two": sum(c.test in PACES and 1 / TWICE <= c.ratio <= TWICE for c in cells),
        "band": 100 * BAND,
        "table_iv": free_flight.table_iv_figure(results),
    }


def _steps(results: FlightResults, rows: Sequence[Row]) -> Content:
    return {
        "dwell": DWELL,
        "trials": results.trials,
        "steps": free_flight.steps_figure(results),
        "compared": _table_iv(rows),
    }


def _circles(results: FlightResults, rows: Sequence[Row]) -> Content:
    return {
        "radius": RADIUS, "slow": PERIODS["slow"], "fast": PERIODS["fast"], "time": CIRCLE_TIME,
        "trials": results.trials,
        "circles": free_flight.circles_figure(results),
        "compared": _table_iv(rows, 1e3, f"{THOUSANDTHS} "),
    }  # fmt: skip


def _table_iv(rows: Sequence[Row], scale: float = 1.0, prefix: str = "") -> list[list[Entry]]:
    """Rows of Table IV: ours and printed for each robot."""
    head = [f"{name}, {whose}" for name in NAMES.values() for whose in ("printed", "ours")]
    lines: list[list[Entry]] = [["", *head]]
    for line in _by_line(rows).values():
        first = next(iter(line.values()))
        cells: list[Entry] = []
        for robot in NAMES:
            row = line.get(robot)
            cells += [_printed_cell(row, scale), replace(_ours(row, scale), detail=_ratio(row))]
        label = _label(first, prefix + first.unit)
        lines.append([label.removeprefix(WORDS.text["implied"]) if prefix else label, *cells])
    return lines


def _ratio(row: Row | None) -> str:
    deviation = row.deviation if row is not None else None
    return "" if deviation is None else f"× {1.0 + deviation:.2f}"


def _wrong(results: FlightResults, steps: Sequence[Row], circles: Sequence[Row]) -> Content:
    names = _contradictions(steps, NAMES)
    count = sum(row.mark is Mark.CONTRADICTED for row in circles)
    content: dict[str, Any] = {
        "steps": names, "count": count, "all": len(circles), "right": not names and not count,
        "scale": THOUSANDTHS, "without_start": _without_start(results) if count else [],
    }  # fmt: skip
    if results.drops:
        stroke = 1e3 * max(drop.stroke for drop in results.drops)
        left = words_of_power(results.drops[-1].left)
        content |= {
            "drops": len(results.drops),
            "height": DROP_HEIGHT,
            "stroke": stroke,
            "left": left,
        }
    return content


def _without_start(results: FlightResults) -> list[list[Entry]]:
    """Rows of circles with and without the first round, and printed."""
    head = [f"{NAMES[robot]}, {rounds} rounds" for robot in ROBOTS for rounds in ("all", "later")]
    lines: list[list[Entry]] = [["", *head]]
    for pace, (k, name) in product(PERIODS, enumerate(QUANTITIES)):
        cells: list[Entry] = [f"{pace} circle, {name[0]}_{name[1]}"]
        for robot in ROBOTS:
            printed = TABLE_IV_CIRCLES[robot, pace][k]
            for first in (True, False):
                ours = float(np.mean(results.circle_mse(robot, pace, name, first_round=first)))
                cells.append(TableCell(_digits(1e3 * ours), ours, f"× {ours / printed:.2f}"))
        lines.append(cells)
    return lines


# --- the same as data


def flight_data(results: FlightResults) -> dict[str, Any]:
    """Trials of Table IV, as plain data."""
    return {
        "steps": [
            {"robot": r.robot, "seed": r.seed, "rise_time": dict(r.rise), "mse": dict(r.mse)}
            for r in results.responses
        ],
        "circles": [
            {
                "robot": r.robot,
                "pace": r.pace,
                "seed": r.seed,
                "mse": dict(r.mse),
                "mse_after_first_round": dict(r.mse_after_first_round),
            }
            for r in results.circles
        ],
        "drops": [asdict(drop) for drop in results.drops],
    }


def flight_tables(results: FlightResults | None) -> dict[str, list[dict[str, Any]]]:
    """Data of the figures by CSV file name."""
    tables = {"endurance.csv": _endurance_rows()}
    if results is not None:
        tables |= {"steps.csv": _step_rows(results), "circles.csv": _circle_rows(results)}
    return {name: rows for name, rows in tables.items() if rows}


def _endurance_rows() -> list[dict[str, Any]]:
    return [
        {"robot": robot, "payload [kg]": float(payload), "hover time [s]": float(time)}
        for robot in TABLE_I
        for payload, time in zip(*free_flight.endurance_points(robot), strict=True)
    ]


def _step_rows(results: FlightResults) -> list[dict[str, Any]]:
    rows = []
    for robot, flight in free_flight.first_flights(results.responses).items():
        for axis in free_flight.AXES:
            t, at, wanted = free_flight.step_window(flight, axis)
            for when in np.arange(0.0, t[-1], CURVE_STEP):
                k = int(np.searchsorted(t, when))
                rows.append(
                    {
                        "robot": robot, "axis": axis, "time [s]": round(float(when), 6),
                        "flown [m]": float(np.interp(when, t, at)), "wanted [m]": float(wanted[k]),
                    }
                )  # fmt: skip
    return rows


def _circle_rows(results: FlightResults) -> list[dict[str, Any]]:
    rows = []
    for pace in PACES:
        for robot, flight in free_flight.circle_flights(results, pace).items():
            errors, c = free_flight.circle_errors_over_time(flight), flight.columns
            for when in np.arange(0.0, errors["t"][-1], CURVE_STEP):
                row: dict[str, Any] = {"pace": pace, "robot": robot, "time [s]": round(when, 6)}
                row |= {f"{a} [m]": float(np.interp(when, c["t"], c[a])) for a in "xy"}
                row |= {
                    f"error {name} [{unit}]": float(np.interp(when, errors["t"], errors[name]))
                    for name, unit in ERRORS.items()
                }
                rows.append(row)
    return rows

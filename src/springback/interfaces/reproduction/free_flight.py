"""Features and free flight in the report: Table I and Table IV.

The words are in ``templates/flight.toml``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict
from itertools import product
from typing import Any

import numpy as np

from springback.interfaces.output.robots import ROBOTS as LOOKS
from springback.interfaces.reports.page import (
    Blocks,
    FigureBlock,
    Section,
    Table,
    TableCell,
    Wording,
    listed,
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
ANSWERS = ("features", "flight")
"""Sections that begin with a question and its answer."""
TWICE = 2.0
"""Factor within which a mean square error on a circle is counted as near."""
THOUSANDTHS = "10⁻³"
CURVE_STEP = 0.01
"""[s], chosen: between the points of curves in CSV files."""


def flight_sections(features: Sequence[Row], results: FlightResults | None) -> list[Section]:
    """The part of features and free flight, section by section; what is not there is left out."""
    rows = results.rows() if results is not None else []
    steps = sorted((row for row in rows if row.reading == "steps"), key=_rise_first)
    circles = [row for row in rows if row.reading.endswith("circle")]
    blocks: dict[str, Blocks] = {
        "features": _features(features) if features else (),
        "flight": _answer(results, rows) if results is not None else (),
        "steps": _steps(results, steps) if results is not None and steps else (),
        "circles": _circles(results, circles) if results is not None and circles else (),
        "flight_wrong": _wrong(results, steps, circles) if results is not None and rows else (),
    }
    part = WORDS.title("part")
    kept = {key: found for key, found in blocks.items() if found}
    return [
        Section(key, WORDS.title(key), found, part if k == 0 else "", answers=key in ANSWERS)
        for k, (key, found) in enumerate(kept.items())
    ]


def _digits(value: float | None, digits: int = 3) -> str:
    """A computed number with as many digits as print has, about."""
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
    """A unit as it stands in a text."""
    return unit.replace("^2", "²")


def _by_line(rows: Sequence[Row]) -> dict[tuple[str, str], dict[str, Row]]:
    """Rows by quantity and reading, and then by robot."""
    lines: dict[tuple[str, str], dict[str, Row]] = {}
    for row in rows:
        lines.setdefault((row.quantity, row.reading), {})[row.robot] = row
    return lines


def _named(rows: Sequence[Row], robots: Mapping[str, str]) -> str:
    """Contradicted numbers in words, line by line."""
    words = []
    for line in _by_line([row for row in rows if row.mark is Mark.CONTRADICTED]).values():
        first = next(iter(line.values()))
        who = listed(
            f"{robots.get(robot, robot)} ({percent(row.deviation)})" for robot, row in line.items()
        )
        words.append(f"{_label(first, '')} of {who}")
    return "; ".join(words)


# --- Table I


def _features(rows: Sequence[Row]) -> Blocks:
    wrong = _named(rows, {name: look.label for name, look in LOOKS.items()})
    disagreement = (
        WORDS.say("features_wrong", names=wrong) if wrong else WORDS.say("features_right")
    )
    exponent = plain(1.5)
    return (
        WORDS.say("features_asked"),
        _features_verdict(rows),
        WORDS.say("features_how"),
        _features_table(rows),
        disagreement,
        WORDS.say("endurance", exponent=exponent),
        FigureBlock("endurance", WORDS.say("endurance_picture"), free_flight.endurance_figure()),
    )


def _features_verdict(rows: Sequence[Row]) -> str:
    payload = next(r for r in rows if r.robot == "arq" and r.quantity == "largest payload")
    hover = [
        r for r in rows
        if r.robot == "arq" and r.quantity == "hover time" and r.mark is not Mark.FITTED
    ]  # fmt: skip
    return WORDS.say(
        "features_verdict",
        payload=_ours(payload),
        payload_printed=plain(payload.printed),
        times=_range([f"{r.ours:.0f}" for r in hover]),
        batteries=_range([r.reading.removeprefix("battery ").removesuffix(" kg") for r in hover]),
        time_printed=plain(TABLE_I["arq"].hover_time),
    )


def _range(words: Sequence[str]) -> str:
    return " to ".join(dict.fromkeys((words[0], words[-1]))) if words else "–"


def _features_table(rows: Sequence[Row]) -> Table:
    lines = []
    for line in _by_line(sorted(rows, key=lambda row: row.robot != "arq")).values():
        first = next(iter(line.values()))
        cells = []
        for robot in ("quad", "arq"):
            row = line.get(robot)
            cells += [_printed(row), _ours(row)]
        notes = dict.fromkeys(row.note for row in line.values() if row.note)
        lines.append((TableCell(_label(first)), *cells, TableCell("; ".join(notes) or "–")))
    return Table(WORDS.say("features_caption"), WORDS.head("features"), tuple(lines))


def _printed(row: Row | None, scale: float = 1.0) -> TableCell:
    if row is None or row.printed is None:
        return TableCell("–")
    return TableCell(plain(scale * row.printed), row.printed)


# --- Table IV


def _rise_first(row: Row) -> tuple[bool, str]:
    return (not row.quantity.startswith("rise"), row.quantity)


def _answer(results: FlightResults, rows: Sequence[Row]) -> Blocks:
    cells = free_flight.table_iv(results)
    if not cells:
        return (WORDS.say("flight_asked"), WORDS.say("flight_unflown"))

    def count(kept: Callable[[Ratio], bool], good: Callable[[Ratio], bool]) -> tuple[int, int]:
        found = [cell for cell in cells if kept(cell)]
        return sum(map(good, found)), len(found)

    def near(cell: Ratio) -> bool:
        return abs(cell.ratio - 1.0) <= BAND

    quad = count(lambda c: c.test not in PACES and c.robot == "quad", near)
    arq = count(lambda c: c.test not in PACES and c.robot != "quad", near)
    circle = count(lambda c: c.test in PACES, near)
    twice = count(lambda c: c.test in PACES, lambda c: 1 / TWICE <= c.ratio <= TWICE)
    verdict = WORDS.say(
        "flight_verdict", quad_met=quad[0], quad_all=quad[1], arq_met=arq[0], arq_all=arq[1],
        circle_met=circle[0], circle_all=circle[1], circle_two=twice[0], band=plain(100 * BAND),
    )  # fmt: skip
    figure = free_flight.table_iv_figure(results)
    return (
        WORDS.say("flight_asked"),
        verdict,
        FigureBlock("table_iv", WORDS.say("ratios_picture"), figure),
    )


def _steps(results: FlightResults, rows: Sequence[Row]) -> Blocks:
    picture = FigureBlock("steps", WORDS.say("steps_picture"), free_flight.steps_figure(results))
    caption = WORDS.say("steps_caption", trials=results.trials)
    return (WORDS.say("steps", dwell=plain(DWELL)), picture, _table_iv(caption, rows))


def _circles(results: FlightResults, rows: Sequence[Row]) -> Blocks:
    slow, fast = (f"{PERIODS[pace]:.2f}" for pace in ("slow", "fast"))
    words = WORDS.say(
        "circles", radius=plain(RADIUS), slow=slow, fast=fast, time=f"{CIRCLE_TIME:.1f}"
    )
    picture = FigureBlock(
        "circles", WORDS.say("circles_picture"), free_flight.circles_figure(results)
    )
    caption = WORDS.say("circles_caption", trials=results.trials)
    return (words, picture, _table_iv(caption, rows, 1e3, f"{THOUSANDTHS} "))


def _table_iv(caption: str, rows: Sequence[Row], scale: float = 1.0, prefix: str = "") -> Table:
    """Ours and print for each robot, side by side."""
    lines = []
    for line in _by_line(rows).values():
        first = next(iter(line.values()))
        cells = []
        for robot in NAMES:
            row = line.get(robot)
            ours = _ours(row, scale)
            cells += [
                _printed(row, scale),
                TableCell(ours.text, ours.value, _ratio(row), ours.mark),
            ]
        label = _label(first, prefix + first.unit)
        lines.append(
            (TableCell(label.removeprefix(WORDS.text["told"]) if prefix else label), *cells)
        )
    heads = (head for name in NAMES.values() for head in (f"{name}, printed", f"{name}, ours"))
    return Table(caption, ("", *heads), tuple(lines))


def _ratio(row: Row | None) -> str:
    deviation = row.deviation if row is not None else None
    return "" if deviation is None else f"× {1.0 + deviation:.2f}"


def _wrong(results: FlightResults, steps: Sequence[Row], circles: Sequence[Row]) -> Blocks:
    blocks: list[str | Table | FigureBlock] = []
    if names := _named(steps, NAMES):
        blocks.append(WORDS.say("wrong_steps", names=names))
    if count := sum(row.mark is Mark.CONTRADICTED for row in circles):
        words = WORDS.say("wrong_circles", count=count, all=len(circles))
        blocks += [words, _without_start(results)]
    if not blocks:
        blocks.append(WORDS.say("right"))
    if results.drops:
        last = results.drops[-1]
        words = WORDS.say(
            "drops", count=len(results.drops), height=plain(DROP_HEIGHT),
            stroke=f"{1e3 * max(drop.stroke for drop in results.drops):.1f}",
            left=words_of_power(last.left),
        )  # fmt: skip
        blocks.append(words)
    return (*blocks, WORDS.say("spread"))


def _without_start(results: FlightResults) -> Table:
    """Circles with and without the first round, beside print."""
    lines = []
    for pace, (k, name) in product(PERIODS, enumerate(QUANTITIES)):
        cells = [TableCell(f"{pace} circle, {name[0]}_{name[1]}")]
        for robot in ROBOTS:
            printed = TABLE_IV_CIRCLES[robot, pace][k]
            for first in (True, False):
                ours = float(np.mean(results.circle_mse(robot, pace, name, first_round=first)))
                cells.append(TableCell(_digits(1e3 * ours), ours, f"× {ours / printed:.2f}"))
        lines.append(tuple(cells))
    heads = (f"{NAMES[robot]}, {WORDS.text[key]}" for robot in ROBOTS for key in ("all", "later"))
    return Table(WORDS.say("start_caption", scale=THOUSANDTHS), ("", *heads), tuple(lines))


# --- the same as data


def flight_data(results: FlightResults) -> dict[str, Any]:
    """Every trial of Table IV, as plain data."""
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
    """What the figures show, by the name of a CSV file."""
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

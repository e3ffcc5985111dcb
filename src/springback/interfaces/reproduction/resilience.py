"""Collisions in flight in the report: who survives what, and how.

The words are in ``templates/resilience.toml``.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from types import MappingProxyType
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
    number,
    plain,
    words_of_power,
)
from springback.interfaces.reproduction.choices import choices_blocks, condition, map_blocks
from springback.interfaces.reproduction.figures import resilience
from springback.interfaces.reproduction.figures.choices import ORDER, signed
from springback.interfaces.reproduction.figures.resilience import POSES, SEEN
from springback.paper.choices import EKF2, choices_data
from springback.paper.choices import ConditionOutcome as Chosen
from springback.paper.printed import RECOVERY_PITCH, SUCCESS, SUCCESS_WORDS
from springback.paper.resilience import (
    CONFIDENCE,
    FAR,
    FASTEST,
    REPEATED,
    ROBOTS,
    SLOWEST,
    ResilienceResults,
    Sample,
    Tally,
    asked_extremes,
    motion,
    rate_mark,
    wilson,
)
from springback.recovery.parameters import Settling
from springback.results.recovery_measures import RECOVERY_MEASURES
from springback.studies.comparison import Mark, Row
from springback.vehicle.library import VEHICLES

WORDS = Wording.of("resilience")
SLOW = (0.0, 2.0)
"""Pitch [deg] and speed [m/s] at which the paper draws both robots."""
STEEPEST = -45.0
PLACE, ANGLE = 0.02, math.radians(5.0)
"""Chosen: errors of position [m] and direction [rad] that are called small."""
CURVE_STEP = {"collisions.csv": 0.005, "repeated.csv": 0.05}
"""[s], chosen: between the points of curves in CSV files."""
CURVE_SPAN = (-0.3, 3.0)
"""[s], chosen: since first touch, what of a collision is in a CSV file."""
CURVES = {
    "x": "x [m]", "z": "z [m]", "vx": "vx [m/s]", "pitch": "pitch [rad]",
    "asked_x": "x asked for [m]", "asked_vx": "vx asked for [m/s]",
    "asked_pitch": "pitch asked for [rad]",
    "aimed_pitch": "pitch asked for, with feedback [rad]",
}  # fmt: skip
"""What of a collision is in a CSV file, and under which head."""
LOSSES = ("loss_contact", "loss_friction", "loss_arm")


def resilience_sections(results: ResilienceResults) -> list[Section]:
    """The part of collisions in flight, section by section; what was not flown is left out."""
    if not results.flown:
        return []
    rows = results.rows()
    blocks: dict[str, Blocks] = {
        "resilience": _answer(results, rows),
        "choices": choices_blocks(results),
        "map": map_blocks(results),
        "recovery": (*_fast(results, rows), *_recovery(results), *_compared(results)),
        "detection": (*_detection(results), *_where(results)),
        "energy_of_hits": _energy(results),
        "repeated": _repeated(results) if results.repeats else (),
        "resilience_method": _method(results),
    }
    kept = {key: found for key, found in blocks.items() if found}
    return [
        Section(
            key, WORDS.title(key), found, WORDS.title("part") if k == 0 else "",
            answers=key == "resilience",
        )
        for k, (key, found) in enumerate(kept.items())
    ]  # fmt: skip


# -- numbers --------------------------------------------------------------------------------------


def _share(value: float) -> str:
    return plain(round(100 * value, 1))


def _middle(
    results: ResilienceResults, of: tuple[str, float, float], measure: str,
    scale: float = 1.0, decimals: int = 1,
) -> TableCell:  # fmt: skip
    """Median of the trials of a condition, in the unit that is shown, with least and most."""
    found = [scale * value for value in results.values(*of, measure)]
    if not found:
        return TableCell("–")
    least, most = number(min(found), decimals), number(max(found), decimals)
    median = float(np.median(found))
    return TableCell(number(median, decimals), median / scale, f"{least} to {most}")


def _median(results: ResilienceResults, of: tuple[str, float, float], measure: str) -> float:
    found = results.values(*of, measure)
    return float(np.median(found)) if found else math.nan


def _conditions(results: ResilienceResults) -> list[tuple[str, float, float]]:
    """Robot, pitch and speed of what was flown, robot by robot."""
    flown = {(t.robot, t.pitch, t.speed) for t in results.flown}
    return [(robot, *c) for robot in ROBOTS for c in ORDER if (robot, *c) in flown]


def _name(of: tuple[str, float, float]) -> TableCell:
    return TableCell(f"{LOOKS[of[0]].label}, {condition(*of[1:])}")


def _row(rows: Sequence[Row], quantity: str) -> TableCell:
    """A compared pitch as it stands in a text."""
    row = next((row for row in rows if row.quantity == quantity), None)
    if row is None or row.ours is None:
        return TableCell("–", mark=Mark.CONTRADICTED)
    return TableCell(number(row.ours, 0), row.ours, "", row.mark)


# -- who survives what ----------------------------------------------------------------------------


def _answer(results: ResilienceResults, rows: Sequence[Row]) -> Blocks:
    tallies = results.tallies()
    settled, low = Settling(), wilson(results.trials, results.trials)[0]
    words = WORDS.say(
        "counted", tolerance=plain(settled.tolerance), speed=plain(settled.speed),
        dwell=plain(settled.dwell), trials=results.trials, low=f"{100 * low:.0f}",
    )  # fmt: skip
    gentle = [pitch for (_, pitch, _), word in SUCCESS_WORDS.items() if word == "fairly good"]
    picture = WORDS.say(
        "success_picture", confidence=plain(100 * CONFIDENCE), slow=plain(SLOW[1]),
        good=SUCCESS_WORDS["quad", *SLOW], least=signed(min(gentle)), most=signed(max(gentle)),
        drops=SUCCESS_WORDS["quad", STEEPEST, SLOW[1]], steep=signed(STEEPEST),
    )  # fmt: skip
    return (
        WORDS.say(
            "asked", conditions=len({t[1:3] for t in tallies}), trials=results.trials,
            fast=plain(FASTEST[1]),
        ),
        _verdict(tallies, results.chosen()),
        FigureBlock("resilience", picture, resilience.success_figure(results)),
        words,
        _success(tallies),
        _failures(results),
    )  # fmt: skip


def _verdict(
    tallies: Sequence[Tally],
    chosen: Mapping[tuple[str, float, float], Chosen] = MappingProxyType({}),
) -> str:
    arq = [tally for tally in tallies if tally.robot == "arq"]
    words = WORDS.say(
        "verdict_arq", successes=sum(t.successes for t in arq), all=sum(t.trials for t in arq),
        printed=_share(SUCCESS["arq", *FASTEST]),
    ) if arq else ""  # fmt: skip
    for tally in tallies:
        if tally[:3] == ("quad", *FASTEST):
            right = rate_mark(tally.rate, SUCCESS[tally[:3]]) is Mark.PREDICTED
            words += " " + WORDS.say(
                "verdict_quad_agrees" if right else "verdict_quad_against",
                fast=plain(FASTEST[1]), successes=tally.successes, all=tally.trials,
            )  # fmt: skip
    cells = [chosen.get((robot, *FASTEST)) for robot in ROBOTS]
    if all(cells):
        arq_fast, quad_fast = (cell for cell in cells if cell is not None)
        words += " " + WORDS.say(
            "verdict_chosen", estimator=EKF2, fast=plain(FASTEST[1]), arq=arq_fast.successes,
            quad=quad_fast.successes, all=quad_fast.trials, duration=plain(quad_fast.duration),
        )  # fmt: skip
    return words.strip()


def _success(tallies: Sequence[Tally]) -> Table:
    found, lines = {tally[:3]: tally for tally in tallies}, []
    for test in ORDER:
        cells = []
        for robot in ROBOTS:
            of = (robot, *test)
            printed = SUCCESS.get(of)
            if printed is None:
                cells.append(TableCell(SUCCESS_WORDS.get(of, "–")))
            else:
                cells.append(TableCell(WORDS.say("printed_share", share=_share(printed)), printed))
            cells.append(_tally(found.get(of), printed))
        lines.append((TableCell(condition(*test)), *cells))
    caption = WORDS.say("success_caption", confidence=plain(100 * CONFIDENCE))
    return Table(caption, WORDS.head("success"), tuple(lines))


def _tally(tally: Tally | None, printed: float | None) -> TableCell:
    if tally is None:
        return TableCell("–")
    text = WORDS.say(
        "share", share=_share(tally.rate), successes=tally.successes, trials=tally.trials
    )
    interval = WORDS.say("interval", low=f"{100 * tally.low:.0f}", high=f"{100 * tally.high:.0f}")
    mark = None if printed is None else rate_mark(tally.rate, printed)
    return TableCell(text, tally.rate, interval, mark)


def _failures(results: ResilienceResults) -> str:
    ways = Counter(trial.outcome.value for trial in results.flown if not trial.success)
    if not ways:
        return WORDS.say("failures_none", all=len(results.flown))
    told = listed(f"{word} ({count})" for word, count in sorted(ways.items()))
    return WORDS.say("failures", lost=sum(ways.values()), all=len(results.flown), ways=told)


# -- the recovery ---------------------------------------------------------------------------------


def _fast(results: ResilienceResults, rows: Sequence[Row]) -> Blocks:
    flown = results.values("arq", *FASTEST, "nose_up")
    sample = results.sample("arq", *FASTEST)
    if not flown or sample is None:
        return ()
    up, down = (signed(value) for value in RECOVERY_PITCH)
    words = WORDS.say(
        "pitch", fast=plain(FASTEST[1]), up=up, down=down, trials=len(flown),
        ours_up=_row(rows, "pitch, nose up"), ours_down=_row(rows, "pitch, nose down"),
    )  # fmt: skip
    blocks: list[Any] = [words]
    if (aimed := asked_extremes(sample.flight, "aimed_pitch")) is not None:
        asked = WORDS.say(
            "pitch_asked", asked_up=_row(rows, "pitch asked for, nose up"),
            asked_down=_row(rows, "pitch asked for, nose down"),
            aimed_up=number(aimed[0], 0), aimed_down=number(aimed[1], 0),
        )  # fmt: skip
        blocks.append(asked)
    words = WORDS.say("fast_picture", fast=plain(FASTEST[1]))
    blocks.append(FigureBlock("collision", words, resilience.fast_figure(sample)))
    blocks.append(_side("fast_side_picture", "orientation", [sample]))
    return tuple(blocks)


def _side(key: str, name: str, samples: Sequence[Sample]) -> FigureBlock:
    words = WORDS.say(key, seen=plain(SEEN), step=plain(POSES))
    return FigureBlock(name, words, resilience.side_figure(samples))


def _recovery(results: ResilienceResults) -> Blocks:
    degrees = math.degrees(1.0)
    columns = (
        ("recovery_time", 1.0, 2), ("height_loss", 1.0, 2), ("excursion", 1.0, 2),
        ("nose_up", degrees, 0), ("nose_down", degrees, 0),
    )  # fmt: skip
    lines = tuple(
        (_name(of), *(_middle(results, of, *column) for column in columns))
        for of in _conditions(results)
    )
    flown = [trial.measures for trial in results.flown if trial.success]
    far = sum((m["excursion"] or 0.0) > FAR for m in flown)
    again = sum((m["impacts"] or 0.0) > 1.0 for m in flown)
    low = min(results.flown, key=lambda trial: trial.measures["lowest_height"] or 0.0)
    words = WORDS.say(
        "recovery", far=far, again=again, all=len(flown), who=LOOKS[low.robot].label,
        where=condition(low.pitch, low.speed),
        height=number(low.measures["lowest_height"] or 0.0, 2),
    )  # fmt: skip
    return (Table(WORDS.say("recovery_caption"), WORDS.head("recovery"), lines), words)


def _compared(results: ResilienceResults) -> Blocks:
    samples = [s for robot in ROBOTS if (s := results.sample(robot, *SLOW)) is not None]
    if len(samples) < len(ROBOTS):
        return ()
    numbers = {
        f"{robot}_{name}": number(_median(results, (robot, *SLOW), measure), 2)
        for robot in ROBOTS
        for name, measure in (("far", "excursion"), ("time", "recovery_time"))
    }
    pictured = WORDS.say("compared_picture", slow=plain(SLOW[1]), level=plain(SLOW[0]))
    return (
        WORDS.say("compared", slow=plain(SLOW[1]), **numbers),
        FigureBlock("robots", pictured, resilience.compared_figure(samples)),
        _side("compared_side_picture", "orientations", samples),
    )


# -- noticing and locating ------------------------------------------------------------------------


def _detection(results: ResilienceResults) -> Blocks:
    lines, everyone = [], [*results.flown, *results.slower]
    for robot in ROBOTS:
        for test in (SLOWEST, SLOW, FASTEST):
            of = (robot, *test)
            found = [t for t in everyone if (t.robot, t.pitch, t.speed) == of]
            if found:
                delays = (
                    _middle(results, of, f"{trigger}_delay", 1e3)
                    for trigger in ("hall", "acceleration", "wrench")
                )
                missed = sum(t.measures["detection_delay"] is None for t in found)
                wrong = sum(t.measures["false_alarms"] or 0.0 for t in found)
                name = TableCell(f"{LOOKS[robot].label}, {plain(test[1])} m/s")
                counts = (TableCell(str(missed), missed), TableCell(plain(wrong), wrong))
                lines.append((name, *delays, *counts))
    words = WORDS.say(
        "detection", slowest=plain(SLOWEST[1]),
        missed=sum(t.measures["detection_delay"] is None for t in everyone),
        false_alarms=plain(sum(t.measures["false_alarms"] or 0.0 for t in everyone)),
    )  # fmt: skip
    caption = WORDS.say("detection_caption", level=plain(SLOW[0]))
    return (words, Table(caption, WORDS.head("detection"), tuple(lines)))


def _where(results: ResilienceResults) -> Blocks:
    degrees = math.degrees(1.0)
    columns = (
        ("position_error", 1e3, 1), ("direction_error", degrees, 1),
        ("arms_direction_error", degrees, 1), ("acceleration_direction_error", degrees, 1),
    )  # fmt: skip
    lines = tuple(
        (_name(of), *(_middle(results, of, *column) for column in columns))
        for of in _conditions(results)
    )

    def small(measure: str, bound: float) -> int:
        found = [trial.measures[measure] for trial in results.flown]
        return sum(value is not None and value < bound for value in found)

    words = WORDS.say(
        "where", all=len(results.flown), near=small("position_error", PLACE),
        straight=small("direction_error", ANGLE), place=plain(1e3 * PLACE),
        angle=plain(math.degrees(ANGLE)),
    )  # fmt: skip
    return (words, Table(WORDS.say("where_caption"), WORDS.head("where"), lines))


# -- energy, repetition, method -------------------------------------------------------------------


def _energy(results: ResilienceResults) -> Blocks:
    lines = []
    for of in _conditions(results):
        speed, mass = _median(results, of, "touch_speed"), VEHICLES[of[0]].vehicle.mass
        kinetic = 0.5 * mass * speed**2
        losses = (_middle(results, of, name, 1.0, 2) for name in LOSSES)
        lines.append((_name(of), TableCell(number(kinetic, 2), kinetic), *losses))
    fast = {name: _median(results, ("arq", *FASTEST), name) for name in LOSSES}
    worst = max(abs(t.measures["ledger_residual"] or 0.0) for t in results.flown)
    words = WORDS.say(
        "energy", fast=plain(FASTEST[1]), residual=words_of_power(worst),
        arms=number(100 * fast["loss_arm"] / sum(fast.values()), 0),
    )  # fmt: skip
    return (words, Table(WORDS.say("energy_caption"), WORDS.head("energy"), tuple(lines)))


def _repeated(results: ResilienceResults) -> Blocks:
    arq, quad = results.repeated("arq"), results.repeated("quad")
    gaps = [gap for repeat in results.repeats for gap in repeat.returns]
    words = WORDS.say(
        "repeated", collisions=results.repeats[0].asked, steep=signed(REPEATED[0]),
        flights=len(arq), won=sum(r.success for r in arq), quad_flights=len(quad),
        quad_won=sum(r.success for r in quad), both=len(results.repeats),
        worst=number(1e3 * max(gaps), 0) if gaps else "–",
        swung=sum(r.alarms > r.collisions for r in results.repeats),
    )  # fmt: skip
    lines = []
    for repeat in results.repeats:
        worst = max(repeat.returns) if repeat.returns else None
        counts = (repeat.collisions, repeat.recovered, repeat.alarms)
        lines.append((
            TableCell(f"{LOOKS[repeat.robot].label}, {repeat.trial + 1}"),
            *(TableCell(str(count), count) for count in counts),
            TableCell("–") if worst is None else TableCell(number(1e3 * worst, 1), worst),
            TableCell(WORDS.say("yes" if repeat.success else "no")),
        ))  # fmt: skip
    table = Table(WORDS.say("repeated_caption"), WORDS.head("repeated"), tuple(lines))
    if not any(repeat.flight for repeat in arq):
        return (words, table)
    pictured = WORDS.say("repeated_picture", collisions=arq[0].asked)
    figure = resilience.repeated_figure(results)
    return (words, FigureBlock("repeated", pictured, figure), table)


def _method(results: ResilienceResults) -> Blocks:
    lines = []
    for name, spread in results.scatter._asdict().items():
        what, unit = WORDS.text["scatter"][name]
        shown = math.degrees(spread) if unit == "°" else spread
        lines.append((TableCell(what), TableCell(plain(round(shown, 6)), spread), TableCell(unit)))
    table = Table(WORDS.say("scatter_caption"), WORDS.head("scatter"), tuple(lines))
    return (WORDS.say("method"), table)


# -- the same as data -----------------------------------------------------------------------------


def resilience_data(results: ResilienceResults) -> dict[str, Any]:
    """Counts, every trial and the repeated tests, as plain data."""
    found: dict[str, Any] = {
        "success": [
            {**tally._asdict(), "rate": tally.rate, "printed": SUCCESS.get(tally[:3])}
            for tally in results.tallies()
        ],
        "trials": [trial.as_dict() for trial in [*results.flown, *results.slower]],
        "units": {name: unit for name, (unit, _) in RECOVERY_MEASURES.items()},
        "repeated": [repeat.as_dict() for repeat in results.repeats],
        "scatter": results.scatter._asdict(),
    }
    if results.choices is not None:
        found["choices"] = choices_data(results.choices)
    if results.envelope is not None:
        found["map"] = results.envelope.as_dict()
    return {"resilience": found}


def resilience_tables(results: ResilienceResults) -> dict[str, list[dict[str, Any]]]:
    """Every trial, and what the figures show, by the name of a CSV file."""
    tables = {
        "trials.csv": [trial.as_dict() for trial in [*results.flown, *results.slower]],
        "collisions.csv": _sample_rows(results),
        "repeated.csv": _repeated_rows(results),
        "choices.csv": [c.as_dict() for c in results.choices.cells] if results.choices else [],
        "map.csv": results.envelope.rows() if results.envelope else [],
    }
    return {name: rows for name, rows in tables.items() if rows}


def _sample_rows(results: ResilienceResults) -> list[dict[str, Any]]:
    rows = []
    for sample in results.samples:
        head = {"robot": sample.robot, "pitch [deg]": sample.pitch, "speed [m/s]": sample.speed}
        curves = motion(sample.flight)
        for when in np.arange(*CURVE_SPAN, CURVE_STEP["collisions.csv"]):
            at = {
                heading: float(np.interp(when, curves["t"], curves[name]))
                for name, heading in CURVES.items()
            }
            rows.append(head | {"time from touch [s]": round(float(when), 6)} | at)
    return rows


def _repeated_rows(results: ResilienceResults) -> list[dict[str, Any]]:
    rows = []
    for repeat in results.repeats:
        if repeat.flight is not None:
            curves = motion(repeat.flight)
            first = curves["t"][0]
            for when in np.arange(first, curves["t"][-1], CURVE_STEP["repeated.csv"]):
                row = {"robot": repeat.robot, "time [s]": round(float(when - first), 6)}
                for name, head in (("x", "x [m]"), ("pitch", "pitch [rad]")):
                    row[head] = float(np.interp(when, curves["t"], curves[name]))
                rows.append(row)
    return rows

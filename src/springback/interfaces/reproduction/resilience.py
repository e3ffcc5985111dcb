"""Collisions in flight in the report.

The text is in ``templates/resilience.toml``.
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
    Content,
    Entry,
    Section,
    TableCell,
    Wording,
    join,
    number,
    plain,
    words_of_power,
)
from springback.interfaces.reproduction.choices import choices_content, condition, map_content
from springback.interfaces.reproduction.figures import resilience
from springback.interfaces.reproduction.figures.choices import ORDER, signed_angle
from springback.interfaces.reproduction.figures.resilience import POSES, SEEN
from springback.intervals import CONFIDENCE, wilson
from springback.paper.choices import EKF2, choices_data
from springback.paper.choices import ConditionOutcome as Chosen
from springback.paper.printed import RECOVERY_PITCH, SUCCESS, SUCCESS_WORDS
from springback.paper.resilience import (
    FAR,
    FASTEST,
    REPEATED,
    ROBOTS,
    SLOWEST,
    ResilienceResults,
    command_extremes,
    motion,
    rate_mark,
)
from springback.recovery.parameters import SettlingSettings
from springback.results.recovery_measures import RECOVERY_MEASURES
from springback.simulation.measuring.measures import Outcome
from springback.studies.comparison import Mark, Row
from springback.studies.trials import Tally, Trial
from springback.vehicle.library import VEHICLES

WORDS = Wording.of("resilience")
SLOW = (0.0, 2.0)
"""Pitch [deg] and speed [m/s] at which the paper draws both robots."""
STEEPEST = -45.0
PLACE, ANGLE = 0.02, math.radians(5.0)
"""Chosen: errors of position [m] and direction [rad] that count as small."""
CURVE_STEP = {"collisions.csv": 0.005, "repeated.csv": 0.05}
"""Chosen: spacing of the points of curves in CSV files [s]."""
CURVE_SPAN = (-0.3, 3.0)
"""Chosen: time since first touch of the curves in CSV files [s]."""
CURVES = {
    "x": "x [m]", "z": "z [m]", "vx": "vx [m/s]", "pitch": "pitch [rad]",
    "asked_x": "reference x [m]", "asked_vx": "reference vx [m/s]",
    "asked_pitch": "reference pitch [rad]",
    "aimed_pitch": "commanded pitch, with feedback [rad]",
}  # fmt: skip
"""Columns of a collision in a CSV file, and their heads."""
DEGREES = math.degrees(1.0)
TRIGGERS = ("hall", "acceleration", "wrench")
LOSSES = ("loss_contact", "loss_friction", "loss_arm")


def resilience_sections(results: ResilienceResults) -> list[Section]:
    """Sections on collisions in flight; parts that were not flown are left out."""
    if not results.flown:
        return []
    rows = results.rows()
    return WORDS.sections({
        "resilience": _answer(results),
        "choices": choices_content(results),
        "map": map_content(results),
        "recovery": {**_fast(results, rows), **_recovery(results), **_comparison(results)},
        "detection": {**_detection(results), **_places(results)},
        "energy_of_hits": _energy(results),
        "repeated": _repeats(results) if results.repeats else {},
        "resilience_method": {"scatter": _scatter(results)},
    })  # fmt: skip


# -- numbers --------------------------------------------------------------------------------------


def _share(value: float) -> str:
    return plain(round(100 * value, 1))


def _middle(
    results: ResilienceResults, of: tuple[str, float, float], measure: str,
    scale: float = 1.0, decimals: int = 1,
) -> TableCell | None:  # fmt: skip
    """Median of the trials of a condition in the displayed unit, with minimum and maximum."""
    found = [scale * value for value in results.values(*of, measure)]
    if not found:
        return None
    least, most = number(min(found), decimals), number(max(found), decimals)
    median = float(np.median(found))
    return TableCell(number(median, decimals), median / scale, f"{least} to {most}")


def _middles(
    results: ResilienceResults, columns: Sequence[tuple[str, float, int]]
) -> list[Sequence[Entry]]:
    """Rows of medians by condition; ``columns`` are measure, scale and decimals."""
    return [
        (_name(of), *(_middle(results, of, *column) for column in columns))
        for of in _conditions(results)
    ]


def _median(results: ResilienceResults, of: tuple[str, float, float], measure: str) -> float:
    found = results.values(*of, measure)
    return float(np.median(found)) if found else math.nan


def _conditions(results: ResilienceResults) -> list[tuple[str, float, float]]:
    """Robot, pitch and speed of all conditions flown, by robot."""
    flown = {(t.robot, t.pitch, t.speed) for t in results.flown}
    return [(robot, *c) for robot in ROBOTS for c in ORDER if (robot, *c) in flown]


def _name(of: tuple[str, float, float]) -> str:
    return f"{LOOKS[of[0]].label}, {condition(*of[1:])}"


def _row(rows: Sequence[Row], quantity: str) -> TableCell:
    """Values of a compared pitch for a text."""
    row = next((row for row in rows if row.quantity == quantity), None)
    if row is None or row.ours is None:
        return TableCell("–", mark=Mark.CONTRADICTED)
    return TableCell(number(row.ours, 0), row.ours, "", row.mark)


# -- who survives what ----------------------------------------------------------------------------


def _answer(results: ResilienceResults) -> Content:
    tallies, settled = results.tallies(), SettlingSettings()
    gentle = [pitch for (_, pitch, _), word in SUCCESS_WORDS.items() if word == "fairly good"]
    ways = Counter(trial.outcome.value for trial in results.flown if not trial.success)
    return {
        "conditions": len({t.condition[1:] for t in tallies}), "trials": results.trials,
        "fast": FASTEST[1], "verdict": _verdict(tallies, results.ekf2_conditions()),
        "confidence": 100 * CONFIDENCE, "slow": SLOW[1], "steep": signed_angle(STEEPEST),
        "good": SUCCESS_WORDS["quad", *SLOW], "drops": SUCCESS_WORDS["quad", STEEPEST, SLOW[1]],
        "least": signed_angle(min(gentle)), "most": signed_angle(max(gentle)),
        "tolerance": settled.tolerance, "speed": settled.speed, "dwell": settled.dwell,
        "low": 100 * wilson(results.trials, results.trials)[0],
        "success": _success(tallies), "resilience": resilience.success_figure(results),
        "ways": join(f"{w} ({count})" for w, count in sorted(ways.items())) if ways else "",
        "unfailing": not ways, "lost": sum(ways.values()), "all": len(results.flown),
    }  # fmt: skip


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
        if tally.condition == ("quad", *FASTEST):
            right = rate_mark(tally.share, SUCCESS[tally.condition]) is Mark.PREDICTED
            words += " " + WORDS.say(
                "verdict_quad_agrees" if right else "verdict_quad_against",
                fast=FASTEST[1], successes=tally.successes, all=tally.trials,
            )  # fmt: skip
    cells = [chosen.get((robot, *FASTEST)) for robot in ROBOTS]
    if all(cells):
        arq_fast, quad_fast = (cell for cell in cells if cell is not None)
        words += " " + WORDS.say(
            "verdict_chosen", estimator=EKF2, fast=FASTEST[1], arq=arq_fast.successes,
            quad=quad_fast.successes, all=quad_fast.trials, duration=quad_fast.duration,
        )  # fmt: skip
    return words.strip()


def _success(tallies: Sequence[Tally]) -> list[Sequence[Entry]]:
    found = {tally.condition: tally for tally in tallies}
    lines: list[Sequence[Entry]] = []
    for test in ORDER:
        cells: list[Entry] = []
        for of in ((robot, *test) for robot in ROBOTS):
            printed = SUCCESS.get(of)
            if printed is None:
                cells.append(SUCCESS_WORDS.get(of))
            else:
                cells.append(TableCell(WORDS.say("printed_share", share=_share(printed)), printed))
            cells.append(_tally(found.get(of), printed))
        lines.append((condition(*test), *cells))
    return lines


def _tally(tally: Tally | None, printed: float | None) -> TableCell | None:
    if tally is None:
        return None
    share, (low, high) = _share(tally.share), tally.interval
    text = WORDS.say("share", share=share, successes=tally.successes, trials=tally.trials)
    interval = WORDS.say("interval", low=100 * low, high=100 * high)
    mark = None if printed is None else rate_mark(tally.share, printed)
    return TableCell(text, tally.share, interval, mark)


# -- the recovery ---------------------------------------------------------------------------------


def _fast(results: ResilienceResults, rows: Sequence[Row]) -> Content:
    """Content on ARQ at its highest speed."""
    flown = results.values("arq", *FASTEST, "nose_up")
    sample = results.sample("arq", *FASTEST)
    if not flown or sample is None:
        return {}
    content = {
        "fast": FASTEST[1], "trials": len(flown),
        "ours_up": _row(rows, "pitch, nose up"), "ours_down": _row(rows, "pitch, nose down"),
        "collision": resilience.fast_figure(sample),
        "orientation": resilience.side_figure([sample]),
    }  # fmt: skip
    content["up"], content["down"] = (signed_angle(value) for value in RECOVERY_PITCH)
    if (aimed := command_extremes(sample.flight, "aimed_pitch")) is not None:
        content["asked_up"] = _row(rows, "commanded pitch, nose up")
        content["asked_down"] = _row(rows, "commanded pitch, nose down")
        content["aimed_up"], content["aimed_down"] = aimed
    return content


def _recovery(results: ResilienceResults) -> Content:
    columns = (
        ("recovery_time", 1.0, 2), ("height_loss", 1.0, 2), ("excursion", 1.0, 2),
        ("nose_up", DEGREES, 0), ("nose_down", DEGREES, 0),
    )  # fmt: skip
    flown = [trial.measures for trial in results.flown if trial.success]
    low = min(results.flown, key=lambda trial: trial.measures["lowest_height"] or 0.0)
    return {
        "seen": SEEN, "step": POSES, "medians": _middles(results, columns), "all": len(flown),
        "far": sum((m["excursion"] or 0.0) > FAR for m in flown),
        "again": sum((m["impacts"] or 0.0) > 1.0 for m in flown),
        "who": LOOKS[low.robot].label, "where": condition(low.pitch, low.speed),
        "height": low.measures["lowest_height"] or 0.0,
    }  # fmt: skip


def _comparison(results: ResilienceResults) -> Content:
    """Content on both robots in the same collision."""
    samples = [s for robot in ROBOTS if (s := results.sample(robot, *SLOW)) is not None]
    if len(samples) < len(ROBOTS):
        return {}
    medians = {
        f"{robot}_{name}": _median(results, (robot, *SLOW), measure)
        for robot in ROBOTS
        for name, measure in (("far", "excursion"), ("time", "recovery_time"))
    }
    return medians | {
        "slow": SLOW[1], "level": SLOW[0], "robots": resilience.comparison_figure(samples),
        "orientations": resilience.side_figure(samples),
    }  # fmt: skip


# -- noticing and locating ------------------------------------------------------------------------


def _detection(results: ResilienceResults) -> Content:
    everyone = [*results.flown, *results.slower]
    lines: list[Sequence[Entry]] = []
    for of in ((robot, *test) for robot in ROBOTS for test in (SLOWEST, SLOW, FASTEST)):
        found = [t for t in everyone if (t.robot, t.pitch, t.speed) == of]
        if found:
            delays = (_middle(results, of, f"{trigger}_delay", 1e3) for trigger in TRIGGERS)
            name = f"{LOOKS[of[0]].label}, {plain(of[2])} m/s"
            lines.append((name, *delays, *_detection_counts(found)))
    missed, false_alarms = _detection_counts(everyone)
    return {
        "slowest": SLOWEST[1], "level": SLOW[0], "missed": missed, "false_alarms": false_alarms,
        "delays": lines,
    }  # fmt: skip


def _detection_counts(trials: Sequence[Trial]) -> tuple[int, float]:
    """Numbers of collisions without an alarm, and of alarms without a collision."""
    measures = [trial.measures for trial in trials]
    missed = sum(m["detection_delay"] is None for m in measures)
    return missed, sum(m["false_alarms"] or 0.0 for m in measures)


def _places(results: ResilienceResults) -> Content:
    columns = (
        ("position_error", 1e3, 1), ("direction_error", DEGREES, 1),
        ("arms_direction_error", DEGREES, 1), ("acceleration_direction_error", DEGREES, 1),
    )  # fmt: skip

    def small(measure: str, bound: float) -> int:
        found = [trial.measures[measure] for trial in results.flown]
        return sum(value is not None and value < bound for value in found)

    return {
        "all": len(results.flown), "near": small("position_error", PLACE),
        "straight": small("direction_error", ANGLE), "place": 1e3 * PLACE,
        "angle": math.degrees(ANGLE), "errors": _middles(results, columns),
    }  # fmt: skip


# -- energy, repetition, method -------------------------------------------------------------------


def _energy(results: ResilienceResults) -> Content:
    lines: list[Sequence[Entry]] = []
    for of in _conditions(results):
        speed, mass = _median(results, of, "touch_speed"), VEHICLES[of[0]].vehicle.mass
        kinetic = 0.5 * mass * speed**2
        losses = (_middle(results, of, name, 1.0, 2) for name in LOSSES)
        lines.append((_name(of), TableCell(number(kinetic, 2), kinetic), *losses))
    fast = {name: _median(results, ("arq", *FASTEST), name) for name in LOSSES}
    worst = max(abs(t.measures["ledger_residual"] or 0.0) for t in results.flown)
    return {
        "fast": FASTEST[1], "residual": words_of_power(worst), "losses": lines,
        "arms": 100 * fast["loss_arm"] / sum(fast.values()),
    }  # fmt: skip


def _repeats(results: ResilienceResults) -> Content:
    arq, quad = results.repeats_of("arq"), results.repeats_of("quad")
    gaps = [gap for repeat in results.repeats for gap in repeat.returns]
    lines: list[Sequence[Entry]] = []
    for repeat in results.repeats:
        worst = max(repeat.returns) if repeat.returns else None
        lines.append((
            f"{LOOKS[repeat.robot].label}, {repeat.trial + 1}",
            repeat.collisions, repeat.recovered, repeat.alarms,
            None if worst is None else TableCell(number(1e3 * worst, 1), worst),
            "yes" if repeat.success else "no",
        ))  # fmt: skip
    return {
        "collisions": results.repeats[0].asked, "steep": signed_angle(REPEATED[0]),
        "arq_flights": len(arq), "won": sum(r.success for r in arq), "quad_flights": len(quad),
        "quad_won": sum(r.success for r in quad), "both": len(results.repeats),
        "worst": 1e3 * max(gaps) if gaps else None,
        "swung": sum(r.alarms > r.collisions for r in results.repeats), "flights": lines,
        "repeated": resilience.repeat_figure(results) if any(r.flight for r in arq) else None,
    }  # fmt: skip


def _scatter(results: ResilienceResults) -> list[Sequence[Entry]]:
    lines: list[Sequence[Entry]] = []
    for name, deviation in results.scatter._asdict().items():
        what, unit = WORDS.text["scatter"][name]
        shown = math.degrees(deviation) if unit == "°" else deviation
        lines.append((what, TableCell(plain(round(shown, 6)), deviation), unit))
    return lines


# -- the same as data -----------------------------------------------------------------------------


def resilience_data(results: ResilienceResults) -> dict[str, Any]:
    """Counts, every trial and the repeated tests, as plain data."""
    found: dict[str, Any] = {
        "success": [_tally_data(tally) for tally in results.tallies()],
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


def _tally_data(tally: Tally) -> dict[str, Any]:
    low, high = tally.interval
    ends = {Outcome[word.upper()]: count for word, count in tally.outcomes.items()}
    return {
        "robot": tally.robot, "pitch": tally.pitch, "speed": tally.speed,
        "successes": tally.successes, "trials": tally.trials, "low": low, "high": high,
        "failures": {e.value: n for e, n in ends.items() if e is not Outcome.RECOVERED},
        "rate": tally.share, "printed": SUCCESS.get(tally.condition),
    }  # fmt: skip


def resilience_tables(results: ResilienceResults) -> dict[str, list[dict[str, Any]]]:
    """Trials and data of the figures by CSV file name."""
    tables = {
        "trials.csv": [trial.as_dict() for trial in [*results.flown, *results.slower]],
        "collisions.csv": _sample_rows(results),
        "repeated.csv": _repeat_rows(results),
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


def _repeat_rows(results: ResilienceResults) -> list[dict[str, Any]]:
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

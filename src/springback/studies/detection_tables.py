"""Results of the study of detection, as rows of tables and as sentences."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from itertools import product
from typing import Any

import numpy as np

from springback.recovery.parameters import DetectionSettings
from springback.studies.detection import (
    CHARACTERISED_FROM,
    IN_TIME,
    SOURCES,
    SPEEDS,
    UNITS,
    CharacterisationError,
    DetectionResults,
)
from springback.studies.roc import NONE_SEEN

Rows = list[dict[str, Any]]
#: Persistences that are judged [samples in a row].
PERSISTENCES = (1, 3)


def default_threshold(trigger: str) -> float:
    """Default threshold of a trigger, in its unit."""
    name = "wrench" if trigger == "momentum" else trigger
    return float(getattr(DetectionSettings(), name).threshold)


def _median(values: Iterable[float]) -> float | None:
    listed = list(values)
    return float(np.median(listed)) if listed else None


def roc_rows(results: DetectionResults) -> Rows:
    """Every point of every receiver operating curve."""
    rows = []
    for robot, persistence in product(results.robots, PERSISTENCES):
        for trigger, speed in product(results.triggers(robot), SPEEDS):
            for p in results.curve(robot, trigger, speed, persistence):
                rows.append({
                    "robot": robot, "trigger": trigger, "speed": speed,
                    "persistence": persistence, "threshold": p.threshold, "unit": UNITS[trigger],
                    "false_alarms": p.false_alarms, "free_flight_h": p.hours,
                    "false_alarms_per_h": p.rate, "false_alarms_per_h_below": p.bound,
                    "noticed": p.noticed, "collisions": p.collisions,
                    "probability": p.probability, "delay_median_s": _median(p.delays),
                })  # fmt: skip
    return rows


def delay_rows(results: DetectionResults) -> Rows:
    """Every delay of every trigger at its default threshold; empty where it missed."""
    rows = []
    for one in results.collisions:
        for name, delay in one.delays.items():
            if name in results.triggers(one.approach.robot):
                rows.append({**one.approach._asdict(), "trigger": name, "delay_s": delay})
    for one in results.on_momentum:
        delay = one.delays["wrench"]
        rows.append({**one.approach._asdict(), "trigger": "momentum", "delay_s": delay})
    return rows


def _degrees(angle: float | None) -> float | None:
    return None if angle is None else math.degrees(angle)


def characterisation_rows(results: DetectionResults) -> Rows:
    """Every characterised collision; angles are signed, in degrees."""
    rows = []
    for one in results.characterisation_error():
        errors = {
            f"{name}_to_{what}_deg": _degrees(found[name])
            for what, found in (("impulse", one.to_impulse), ("normal", one.to_normal))
            for name in SOURCES
        }
        rows.append({
            **one.approach._asdict(), "clipped": one.clipped, "arms_right": one.arms_right,
            "friction_deg": _degrees(one.friction), **errors, "position_error_m": one.position,
            "contact_point_error_m": one.contact_point, "intensity_ratio": one.intensity,
            "looked_s": one.looked,
        })  # fmt: skip
    return rows


def detection_rows(results: DetectionResults) -> dict[str, Rows]:
    """All tables of the study by name."""
    return {
        "roc": roc_rows(results), "delays": delay_rows(results),
        "characterisation": characterisation_rows(results),
    }  # fmt: skip


def sizes(found: list[CharacterisationError], source: str, to: str) -> list[float]:
    """Sizes of a source's direction errors [deg]: ``to`` the impulse or the normal."""
    angles = [(one.to_impulse if to == "impulse" else one.to_normal)[source] for one in found]
    return [math.degrees(abs(angle)) for angle in angles if angle is not None]


def _spread(values: list[float], scale: float, digits: int) -> str:
    if not values:
        return "-"
    scaled = [scale * x for x in values]
    return f"{np.median(scaled):.{digits}f} ({min(scaled):.{digits}f} to {max(scaled):.{digits}f})"


def delay_table(results: DetectionResults) -> list[str]:
    """Delays at the default thresholds, a line for each robot and trigger."""
    head = f"{'delay [ms]: median (least to most)':<36}"
    lines = [head + "".join(f"{f'{speed:g} m/s':>22}" for speed in SPEEDS)]
    for robot in results.robots:
        for trigger in results.triggers(robot):
            cells = []
            for speed in SPEEDS:
                found = results.delays(robot, trigger, speed)
                known = [x for x in found if x is not None]
                missed = f", {len(found) - len(known)} of {len(found)} missed"
                cells.append(_spread(known, 1e3, 1) if known else missed[2:])
                if known and len(known) < len(found):
                    cells[-1] = f"{1e3 * float(np.median(known)):.1f}{missed}"
            lines.append(f"  {robot + ', ' + trigger:<34}" + "".join(f"{x:>22}" for x in cells))
    return lines


def direction_table(results: DetectionResults) -> list[str]:
    """Errors of direction and place, a line for each robot and speed."""
    head = "".join(f"{name:>16}" for name in SOURCES)
    lines = []
    for to in ("normal", "impulse"):
        lines.append(f"{f'degrees off the {to}: median (most)':<36}{head}")
        for robot, speed in product(results.robots, [v for v in SPEEDS if v >= CHARACTERISED_FROM]):
            found = results.characterisation_error(robot, speed)
            cells = [sizes(found, name, to) for name in SOURCES]
            texts = [f"{np.median(c):.1f} ({max(c):.1f})" if c else "-" for c in cells]
            lines.append(f"  {f'{robot}, {speed:g} m/s':<34}" + "".join(f"{x:>16}" for x in texts))
    return lines


def place_table(results: DetectionResults) -> list[str]:
    """Errors of position, arms and intensity, a line for each robot and speed."""
    kinds: tuple[tuple[str, Callable[[CharacterisationError], float]], ...] = (
        ("p_c [mm]", lambda one: 1e3 * one.position),
        ("contact point [mm]", lambda one: 1e3 * one.contact_point),
        ("intensity ratio", lambda one: one.intensity),
    )
    lines = ["".join((f"{'median (most)':<36}", *(f"{name:>20}" for name, _ in kinds), "  arms"))]
    for robot, speed in product(results.robots, [v for v in SPEEDS if v >= CHARACTERISED_FROM]):
        found = results.characterisation_error(robot, speed)
        if not found:
            continue
        cells = [[value(one) for one in found] for _, value in kinds]
        text = "".join(f"{f'{np.median(c):.2g} ({max(c):.2g})':>20}" for c in cells)
        right = sum(one.arms_right for one in found)
        lines.append(f"  {f'{robot}, {speed:g} m/s':<34}{text}  {right} of {len(found)} right")
    return lines


def false_alarm_sentences(results: DetectionResults) -> list[str]:
    """False alarms at the default thresholds, and the largest signals of free flight."""
    lines = []
    for robot in results.robots:
        time, hours = results.free_time(robot), results.free_time(robot) / 3600.0
        for trigger in results.triggers(robot):
            kept = results.free_on_momentum if trigger == "momentum" else results.free
            name = "wrench" if trigger == "momentum" else trigger
            most = max(float(one[name].signal.max()) for one in kept[robot])
            count = results.alarms[robot][trigger]
            bound = f", so below {NONE_SEEN / hours:.3g} an hour (95 %)" if count == 0 else ""
            lines.append(
                f"{robot}, {trigger}: {count:g} false alarms in {time:g} s{bound}; largest signal "
                f"{most:.3g} {UNITS[trigger]}, threshold {default_threshold(trigger):.3g}"
            )
    return lines


def sentences(results: DetectionResults) -> list[str]:
    """Results of the study, a line each."""
    late = f"an alarm later than {1e3 * IN_TIME:g} ms counts as missed"
    return [
        *delay_table(results), f"  ({late})", *false_alarm_sentences(results),
        *direction_table(results), *place_table(results),
    ]  # fmt: skip


def detection_data(results: DetectionResults) -> dict[str, Any]:
    """Results that are not in the CSV files, as plain data."""
    return {
        "flights": results.flights,
        "seed": results.seed,
        "free_flight_s": {robot: results.free_time(robot) for robot in results.robots},
        "false_alarms": results.alarms,
        "thresholds": {name: default_threshold(name) for name in UNITS},
        "units": UNITS,
        "in_time_s": IN_TIME,
        "sentences": sentences(results),
    }

"""Outcome and measures of a recovery, from the evaluator and the pilot's memory.

A pilot of the user's own has recovered once its vehicle, after a contact, is slower than
``recovery.settling.speed`` and touches nothing for ``recovery.settling.dwell``.  Of its alarms only
the times are known; measures of triggers, and of a collision's place and direction, are undefined.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from springback.recovery.evaluator import EvaluatorMemory
from springback.recovery.pilot import RecoveryPilotMemory
from springback.simulation.guided import GuidedFlown
from springback.simulation.measuring.columns import Array, as_columns
from springback.simulation.measuring.measures import (
    Outcome,
    first_claimed,
    measures_of,
    outcome_of,
    outcomes_of,
    scalars_of,
    where,
)

#: Vectors shorter than this have no direction.
LEVEL = 1e-9
#: Unit and meaning of every measure of a recovery; if a flight has several collisions, those with
#: "last" refer to the last one.
RECOVERY_MEASURES = {
    "runs": ("", "collisions, each with its recovery"),
    "recovered_runs": ("", "recoveries that ended at rest, at p_r or at home"),
    "false_alarms": ("", "alarms without a contact"),
    "alarm_time": ("s", "time of the last alarm that belongs to a collision"),
    "planned_time": ("s", "time at which the return was planned, in the last run"),
    "rested_time": ("s", "time at which the pilot assumed rest at p_r, or timed out"),
    "home_time": ("s", "time at which the pilot assumed to be home"),
    "detection_delay": ("s", "first alarm after first touch"),
    "hall_delay": ("s", "first firing of the arms' trigger, after first touch"),
    "acceleration_delay": ("s", "the same for the accelerometer's trigger"),
    "wrench_delay": ("s", "the same for the external wrench's trigger"),
    "recovery_time": ("s", "first touch to rest at p_r, or at home if it leaned on the wall"),
    "height_loss": ("m", "below the height at touch, until rest"),
    "lowest_height": ("m", "lowest height of the main body in the whole flight"),
    "excursion": ("m", "largest horizontal distance from the point of touch, until rest"),
    "path": ("m", "path length from touch until rest"),
    "nose_up": ("rad", "largest pitch nose up after touch, as a negative pitch"),
    "nose_down": ("rad", "largest pitch nose down after touch"),
    "position_error": ("m", "error of p_c, the main body at the last alarm"),
    "direction_error": ("rad", "horizontal angle from the obstacle's normal to the f_c0 in use"),
    "arms_direction_error": ("rad", "the same, f_c0 from the arms"),
    "acceleration_direction_error": ("rad", "the same, f_c0 from the accelerometer"),
    "wrench_direction_error": ("rad", "the same, f_c0 from the external wrench"),
    "intensity": ("N", "largest estimated external force"),
}  # fmt: skip


def is_evaluated(guided: GuidedFlown) -> bool:
    """True if a flight had an evaluator."""
    return isinstance(guided.onboard.evaluator, EvaluatorMemory)


def recovery_outcomes(record: Any, seen: Any, memory: Any) -> list[Outcome]:
    """Outcomes of flights with an evaluator.

    Args:
        record: `Record` whose leaves are columns, one number for each flight.
        seen: `EvaluatorMemory` of columns.
        memory: That of the pilot, of columns.
    """
    plain = outcomes_of(record)
    worst = (Outcome.NOT_FINITE, Outcome.BROKEN, Outcome.HIT_GROUND)
    final = np.array([one in worst for one in plain])
    claims = [(Outcome.RECOVERED, seen.recovered >= seen.runs)]
    if isinstance(memory, RecoveryPilotMemory):
        claims.append((Outcome.NOT_DETECTED, seen.run.alarm < 0.0))
    after = first_claimed(claims, Outcome.NOT_SETTLED)
    stands = (final | (seen.runs == 0.0)).tolist()
    return [a if stays else b for a, b, stays in zip(plain, after, stands, strict=True)]


def recovery_outcome(guided: GuidedFlown) -> Outcome:
    """Outcome of a flight with an evaluator."""
    return recovery_outcomes(*_columns(guided))[0]


def _columns(guided: GuidedFlown) -> tuple[Any, Any, Any]:
    """Record, and memories of evaluator and pilot, as columns."""
    onboard = guided.onboard
    trees = guided.flown.record, onboard.evaluator, onboard.pilot
    record, seen, memory = (as_columns(tree) for tree in trees)
    return record, seen, memory


def _finite(time: Array) -> Array:
    return where(time >= 0.0, time)


def _since(time: Array, touch: Array) -> Array:
    return where((time >= 0.0) & (touch >= 0.0), time - touch)


def _between(a: Any, b: Any) -> Array:
    """Angles between the horizontal parts of vectors of columns [rad]; NaN where one is zero."""
    level = (a.x * a.x + a.y * a.y >= LEVEL**2) & (b.x * b.x + b.y * b.y >= LEVEL**2)
    across, along = a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y
    # By Python's own arc tangent: NumPy's may differ in the last bit with the position in an array.
    angles = map(math.atan2, across.tolist(), along.tolist())
    return where(level, np.abs(np.array(list(angles))))


def recovery_columns(record: Any, seen: Any, memory: Any) -> dict[str, Array]:
    """Measures of many recoveries, in the order of `RECOVERY_MEASURES`; NaN for None.

    Args:
        record: `Record` whose leaves are columns, one number for each flight.
        seen: `EvaluatorMemory` of columns.
        memory: `RecoveryPilotMemory` of columns, or that of a pilot of the user's own.
    """
    run, first = seen.run, record.first_impact.touch_time
    # The record knows first touch exactly; the evaluator, for later runs, to a tick.
    touch = np.where(seen.runs == 1.0, first, run.touch)
    happened = seen.runs > 0.0
    found = {
        "runs": seen.runs,
        "recovered_runs": seen.recovered,
        "recovery_time": _since(run.settled, touch),
        "height_loss": where(happened, run.place.z - run.lowest),
        "lowest_height": seen.lowest,
        "excursion": where(happened, run.excursion),
        "path": where(happened, run.path),
        "nose_up": where(happened, run.nose_up),
        "nose_down": where(happened, run.nose_down),
        "false_alarms": seen.false_alarms,
        "alarm_time": _finite(run.alarm),
        "detection_delay": _since(run.alarm, touch),
    }
    if isinstance(memory, RecoveryPilotMemory):
        found |= _collision_columns(record, seen, memory)
    unknown = np.full_like(seen.runs, math.nan)
    return {name: found.get(name, unknown) for name in RECOVERY_MEASURES}


def _collision_columns(record: Any, seen: Any, memory: Any) -> dict[str, Array]:
    """Measures of triggers, of phases, and of the collision as springback's pilot estimates it."""
    run, hit, d = seen.run, memory.collision, memory.detection
    first, log = record.first_impact.touch_time, memory.recovery_state.log
    noticed, gap = run.alarm >= 0.0, hit.position - run.alarm_place
    inward = record.first_impact.inward
    return {
        "planned_time": _finite(log.planned),
        "rested_time": _finite(log.settled),
        "home_time": _finite(log.home),
        "hall_delay": _since(d.hall.first, first),
        "acceleration_delay": _since(d.acceleration.first, first),
        "wrench_delay": _since(d.wrench.first, first),
        "position_error": where(noticed, np.sqrt(gap @ gap)),
        "direction_error": _between(hit.direction, inward),
        "arms_direction_error": _between(hit.by_arms, inward),
        "acceleration_direction_error": _between(hit.by_acceleration, inward),
        "wrench_direction_error": _between(hit.by_wrench, inward),
        "intensity": where(noticed, hit.intensity),
    }


def recovery_measures(guided: GuidedFlown) -> dict[str, float | None]:
    """Measures of a recovery, in the order of `RECOVERY_MEASURES`."""
    return scalars_of(recovery_columns(*_columns(guided)))


def guided_result(guided: GuidedFlown) -> tuple[Outcome, dict[str, float | None]]:
    """Outcome and measures of a flight with a pilot."""
    if not is_evaluated(guided):
        return outcome_of(guided.flown.record), measures_of(guided.flown)
    return recovery_outcome(guided), measures_of(guided.flown) | recovery_measures(guided)

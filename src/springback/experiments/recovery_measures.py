"""How a recovery went: outcome and measures, from what the referee saw and the pilot remembers."""

from __future__ import annotations

import math
from typing import Any

from springback.kernels.vectors import Vec
from springback.recovery.pilot import ResilientMemory
from springback.recovery.referee import RefereeMemory
from springback.simulation.guided import GuidedFlown
from springback.simulation.measures import Outcome, outcome_of

#: Unit and meaning of every measure of a recovery; of several collisions in one flight those with
#: "last" are of the last one.
RECOVERY_MEASURES = {
    "runs": ("", "collisions, each with what followed"),
    "recovered_runs": ("", "of these, those that ended at rest, at p_r or at home"),
    "false_alarms": ("", "alarms without a contact"),
    "alarm_time": ("s", "of the last alarm that belongs to a collision"),
    "planned_time": ("s", "when the way back was planned, on the last run"),
    "rested_time": ("s", "when the pilot took itself to rest at p_r, or gave up waiting"),
    "home_time": ("s", "when it took itself to be home again"),
    "detection_delay": ("s", "first alarm after first touch"),
    "hall_delay": ("s", "first time that the arms' trigger went off, after first touch"),
    "acceleration_delay": ("s", "the same for the accelerometer's trigger"),
    "wrench_delay": ("s", "the same for the external wrench's trigger"),
    "recovery_time": ("s", "first touch to rest at p_r, or at home where it leant on the wall"),
    "height_loss": ("m", "below the height at touch, until rest"),
    "lowest_height": ("m", "of the main body over the whole flight"),
    "excursion": ("m", "largest level distance from the place of touch, until rest"),
    "path": ("m", "flown from touch until rest"),
    "nose_up": ("rad", "largest pitch nose up after touch, as a negative pitch"),
    "nose_down": ("rad", "largest pitch nose down after touch"),
    "position_error": ("m", "of p_c: main body at the last alarm, believed and true"),
    "direction_error": ("rad", "between f_c0 as relied on and the obstacle's normal, level parts"),
    "arms_direction_error": ("rad", "the same, f_c0 from the arms"),
    "acceleration_direction_error": ("rad", "the same, f_c0 from the accelerometer"),
    "wrench_direction_error": ("rad", "the same, f_c0 from the external wrench"),
    "intensity": ("N", "largest external force that was felt"),
}  # fmt: skip


def judged(guided: GuidedFlown) -> bool:
    """Whether a flight had a referee."""
    return isinstance(guided.aboard.witness, RefereeMemory)


def recovery_outcome(guided: GuidedFlown) -> Outcome:
    """The outcome of a flight that a referee has judged."""
    plain, seen = outcome_of(guided.flown.record), guided.aboard.witness
    if plain in (Outcome.NOT_FINITE, Outcome.HIT_GROUND) or seen.runs == 0.0:
        return plain
    if seen.recovered >= seen.runs:
        return Outcome.RECOVERED
    return Outcome.NOT_DETECTED if seen.run.alarm < 0.0 else Outcome.NOT_SETTLED


def _known(time: float) -> float | None:
    return time if time >= 0.0 else None


def _since(time: float, touch: float) -> float | None:
    return time - touch if time >= 0.0 and touch >= 0.0 else None


def _between(a: Vec, b: Vec) -> float | None:
    """Angle between the level parts of two vectors [rad]; None where one has none."""
    if math.hypot(a.x, a.y) < 1e-9 or math.hypot(b.x, b.y) < 1e-9:
        return None
    return abs(math.atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y))


def recovery_measures(guided: GuidedFlown) -> dict[str, float | None]:
    """Every measure of a recovery, in the order of `RECOVERY_MEASURES`."""
    seen: RefereeMemory = guided.aboard.witness
    memory: ResilientMemory = guided.aboard.pilot
    record, run, hit, d = guided.flown.record, seen.run, memory.collision, memory.detection
    first, log = record.touch_time, memory.journey.log
    # The record knows first touch exactly; the referee, of later runs, to a tick.
    touch = first if seen.runs == 1.0 else run.touch
    happened, noticed = seen.runs > 0.0, run.alarm >= 0.0
    gap = hit.position - run.alarm_place
    values: dict[str, Any] = {
        "runs": seen.runs,
        "recovered_runs": seen.recovered,
        "false_alarms": seen.false_alarms,
        "alarm_time": run.alarm if noticed else None,
        "planned_time": _known(log.planned),
        "rested_time": _known(log.settled),
        "home_time": _known(log.home),
        "detection_delay": _since(run.alarm, touch),
        "hall_delay": _since(d.hall.first, first),
        "acceleration_delay": _since(d.acceleration.first, first),
        "wrench_delay": _since(d.wrench.first, first),
        "recovery_time": _since(run.settled, touch),
        "height_loss": run.place.z - run.lowest if happened else None,
        "lowest_height": seen.lowest,
        "excursion": run.excursion if happened else None,
        "path": run.path if happened else None,
        "nose_up": run.nose_up if happened else None,
        "nose_down": run.nose_down if happened else None,
        "position_error": math.sqrt(gap @ gap) if noticed else None,
        "direction_error": _between(hit.direction, record.inward),
        "arms_direction_error": _between(hit.by_arms, record.inward),
        "acceleration_direction_error": _between(hit.by_acceleration, record.inward),
        "wrench_direction_error": _between(hit.by_wrench, record.inward),
        "intensity": hit.intensity if noticed else None,
    }
    return {name: None if value is None else float(value) for name, value in values.items()}

"""Noticing collisions: three signals, each with a trigger of its own, side by side.

All three are computed in every flight, whatever a vehicle relies on, so that they can be compared
on one and the same collision; only triggers that are in use raise the alarm.
"""

from __future__ import annotations

from typing import NamedTuple

from springback.kernels.compiler import kernel
from springback.kernels.trees import maximum, select, tree_map
from springback.kernels.vectors import Vec, norm, rotation
from springback.recovery.wrench import ExternalWrench
from springback.sensing.measurement import Estimate, Measurement
from springback.vehicle.state import Arm

#: A time that has not come.
NOT_YET = -1.0


class Trigger(NamedTuple):
    """When a signal is taken for a collision."""

    used: float  # 1: it raises the alarm; 0: it is only watched
    threshold: float  # in the unit of the signal
    persistence: float  # samples in a row above the threshold; a whole number
    refractory: float  # after an alarm nothing is noticed for so long [s]
    share: float  # of a new sample in the low-pass, from 0 to 1; 1 is no filter


class TriggerMemory(NamedTuple):
    """What a trigger remembers."""

    filtered: float  # the signal
    above: float  # samples in a row above the threshold
    last: float  # time of the last alarm, `NOT_YET` before the first [s]
    first: float  # time of the first alarm [s]
    alarms: float  # so far


class Triggered(NamedTuple):
    """Whether a trigger goes off at this tick, and what it remembers."""

    alarm: float  # 1 at the tick at which it goes off
    memory: TriggerMemory


class Detection(NamedTuple):
    """The triggers."""

    hall: Trigger  # on the largest compression of an arm [m]
    acceleration: Trigger  # on the horizontal specific force [m/s²]
    wrench: Trigger  # on the external force, less what is steady of it [N]


class DetectionMemory(NamedTuple):
    """What the triggers remember."""

    hall: TriggerMemory
    acceleration: TriggerMemory
    wrench: TriggerMemory


class Detected(NamedTuple):
    """Whether a collision is noticed at this tick."""

    alarm: float  # 1 at the tick at which a trigger in use goes off
    memory: DetectionMemory


NOT_TRIGGERED = TriggerMemory(0.0, 0.0, NOT_YET, NOT_YET, 0.0)
NOT_DETECTED = DetectionMemory(NOT_TRIGGERED, NOT_TRIGGERED, NOT_TRIGGERED)


@kernel
def triggered(
    trigger: Trigger, time: float, signal: float, fresh: float, memory: TriggerMemory
) -> Triggered:
    """One trigger at one tick.

    It goes off once the filtered signal has been above the threshold for so many samples in a row,
    and not again before it has fallen below and the refractory time is over.

    Args:
        trigger: Settings.
        time: [s].
        signal: At this tick.
        fresh: 1 where the signal is a new sample.
        memory: `NOT_TRIGGERED` at the start.
    """
    filtered = memory.filtered + fresh * trigger.share * (signal - memory.filtered)
    counted = memory.above + fresh
    above = select(filtered > trigger.threshold, counted, 0.0)
    resting = (memory.last >= 0.0) & (time - memory.last < trigger.refractory)
    reached = (above >= trigger.persistence) & (memory.above < trigger.persistence)
    goes_off = reached & (not resting)
    last = select(goes_off, time, memory.last)
    first = select(goes_off & (memory.first < 0.0), time, memory.first)
    alarm = select(goes_off, 1.0, 0.0)
    return Triggered(alarm, TriggerMemory(filtered, above, last, first, memory.alarms + alarm))


@kernel
def _compression(arm: Arm, length: float) -> float:
    return arm.length - length


@kernel
def compressions(arms: tuple[Arm, ...], lengths: tuple[float, ...]) -> tuple[float, ...]:
    """L − l of every arm [m]."""
    return tree_map(_compression, (arms, lengths), ())


@kernel
def horizontal(a: Vec) -> Vec:
    """A vector without its vertical part."""
    return Vec(a.x, a.y, 0.0)


@kernel
def jolt(seen: Measurement, at: Estimate) -> Vec:
    """Horizontal part of the measured specific force, world axes [m/s²]."""
    return horizontal(rotation(at.attitude) @ seen.inertial.specific_force)


@kernel
def detected(
    detection: Detection,
    arms: tuple[Arm, ...],
    time: float,
    seen: Measurement,
    at: Estimate,
    wrench: ExternalWrench,
    memory: DetectionMemory,
) -> Detected:
    """Look at all three signals at a tick.

    The horizontal specific force is McGill's signal (Chui, Dicker and Sharf 2016; 20 m/s² in their
    flight code), the external force that of Tomić, Ott and Haddadin (T-RO 2017), whose steady part
    is wind.

    Args:
        detection: Settings.
        arms: As the pilot believes them to be.
        time: [s].
        seen: What the sensors say.
        at: What the estimator says.
        wrench: What the observer says.
        memory: `NOT_DETECTED` at the start.
    """
    pressed = maximum(compressions(arms, seen.arm_length))
    a, b, c = detection.hall, detection.acceleration, detection.wrench
    fresh = seen.inertial.fresh
    hall = triggered(a, time, pressed, seen.arm_length_fresh, memory.hall)
    acceleration = triggered(b, time, norm(jolt(seen, at)), fresh, memory.acceleration)
    force = triggered(c, time, norm(wrench.force - wrench.steady), fresh, memory.wrench)
    raised = a.used * hall.alarm + b.used * acceleration.alarm + c.used * force.alarm
    kept = DetectionMemory(hall.memory, acceleration.memory, force.memory)
    return Detected(select(raised > 0.5, 1.0, 0.0), kept)

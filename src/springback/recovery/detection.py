"""Detection of collisions: three signals, each with its own trigger.

All three are computed in every flight, whichever a vehicle uses, so that they can be compared on
the same collision; only triggers that are in use raise the alarm.
"""

from __future__ import annotations

from typing import NamedTuple

from springback.kernels.compiler import kernel
from springback.kernels.trees import maximum, select, tree_map
from springback.kernels.vectors import Vec, norm, rotation
from springback.recovery.wrench import ExternalWrench
from springback.sensing.measurement import Estimate, Measurement
from springback.vehicle.state import Airframe, Arm, compression_of

#: Time of an event that has not happened yet.
NOT_YET = -1.0


class Trigger(NamedTuple):
    """Settings of one trigger."""

    used: float  # 1: it raises the alarm; 0: it is only recorded
    threshold: float  # in the unit of the signal
    persistence: float  # consecutive samples above the threshold, a whole number
    refractory: float  # time after an alarm without another [s]
    share: float  # of a new sample in the low-pass, from 0 to 1; 1 is no filter


class TriggerMemory(NamedTuple):
    """Memory of a trigger."""

    filtered: float  # the signal
    above: float  # consecutive samples above the threshold
    last: float  # time of the last alarm, `NOT_YET` before the first [s]
    first: float  # time of the first alarm [s]
    alarms: float  # so far


class TriggerStep(NamedTuple):
    """Alarm of a trigger, and its memory."""

    alarm: float  # 1 at the tick of an alarm, else 0
    memory: TriggerMemory


class Detection(NamedTuple):
    """Settings of the triggers."""

    hall: Trigger  # on the largest compression of an arm [m]
    acceleration: Trigger  # on the horizontal specific force [m/s²]
    wrench: Trigger  # on the external force less its steady part [N]


class DetectionMemory(NamedTuple):
    """Memories of the triggers."""

    hall: TriggerMemory
    acceleration: TriggerMemory
    wrench: TriggerMemory


class DetectionStep(NamedTuple):
    """Alarm, and the memories of the triggers."""

    alarm: float  # 1 at the tick of an alarm of a trigger in use, else 0
    memory: DetectionMemory


class CollisionInputs(NamedTuple):
    """Inputs of detection and characterisation at a tick."""

    airframe: Airframe  # in the pilot's model
    measurement: Measurement
    estimate: Estimate
    wrench: ExternalWrench


NOT_TRIGGERED = TriggerMemory(0.0, 0.0, NOT_YET, NOT_YET, 0.0)
NOT_DETECTED = DetectionMemory(NOT_TRIGGERED, NOT_TRIGGERED, NOT_TRIGGERED)


@kernel
def trigger_step(
    trigger: Trigger, time: float, signal: float, fresh: float, memory: TriggerMemory
) -> TriggerStep:
    """One trigger at one tick.

    It raises its alarm once enough consecutive samples of the filtered signal have been above the
    threshold, and not again until the signal has fallen below it and the refractory time is over.

    Args:
        trigger: Settings.
        time: [s].
        signal: Signal at this tick.
        fresh: 1 if the signal is a new sample.
        memory: `NOT_TRIGGERED` at the start.
    """
    filtered = memory.filtered + fresh * trigger.share * (signal - memory.filtered)
    counted = memory.above + fresh
    above = select(filtered > trigger.threshold, counted, 0.0)
    resting = (memory.last >= 0.0) & (time - memory.last < trigger.refractory)
    reached = (above >= trigger.persistence) & (memory.above < trigger.persistence)
    fires = reached & (not resting)
    last = select(fires, time, memory.last)
    first = select(fires & (memory.first < 0.0), time, memory.first)
    alarm = select(fires, 1.0, 0.0)
    return TriggerStep(alarm, TriggerMemory(filtered, above, last, first, memory.alarms + alarm))


@kernel
def compressions(arms: tuple[Arm, ...], lengths: tuple[float, ...]) -> tuple[float, ...]:
    """L − l of each arm [m]."""
    return tree_map(compression_of, (arms, lengths), ())


@kernel
def horizontal(a: Vec) -> Vec:
    """A vector without its vertical part."""
    return Vec(a.x, a.y, 0.0)


@kernel
def jolt(measurement: Measurement, at: Estimate) -> Vec:
    """Horizontal part of the measured specific force, world axes [m/s²]."""
    return horizontal(rotation(at.attitude) @ measurement.inertial.specific_force)


@kernel
def detection_step(
    detection: Detection, time: float, inputs: CollisionInputs, memory: DetectionMemory
) -> DetectionStep:
    """All three triggers at a tick.

    The horizontal specific force is McGill's signal (Chui, Dicker and Sharf 2016; 20 m/s² in their
    flight code), the external force that of Tomić, Ott and Haddadin (T-RO 2017); its steady part
    is wind.

    Args:
        detection: Settings.
        time: [s].
        inputs: At this tick.
        memory: `NOT_DETECTED` at the start.
    """
    measurement, wrench = inputs.measurement, inputs.wrench
    pressed = maximum(compressions(inputs.airframe.arms, measurement.arm_length))
    a, b, c = detection.hall, detection.acceleration, detection.wrench
    fresh, felt = measurement.inertial.fresh, norm(jolt(measurement, inputs.estimate))
    hall = trigger_step(a, time, pressed, measurement.arm_length_fresh, memory.hall)
    acceleration = trigger_step(b, time, felt, fresh, memory.acceleration)
    force = trigger_step(c, time, norm(wrench.force - wrench.steady), fresh, memory.wrench)
    raised = a.used * hall.alarm + b.used * acceleration.alarm + c.used * force.alarm
    after = DetectionMemory(hall.memory, acceleration.memory, force.memory)
    return DetectionStep(select(raised > 0.5, 1.0, 0.0), after)

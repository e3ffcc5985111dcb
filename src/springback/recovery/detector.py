"""A detector of the user's own, beside the triggers of `springback.recovery.detection`.

It decides from what the triggers see when there is a collision and, if it can, in which direction;
characterisation and response then go on as they do after an alarm of a trigger.  It is a NamedTuple
of floats with `detector_step` registered for it::

    class Peak(NamedTuple):
        threshold: float

    @detector_step.register(Peak)
    @kernel
    def _(detector, time, inputs, memory):
        return DetectorStep(alarm, direction, memory)
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import select
from springback.kernels.vectors import Vec
from springback.recovery.detection import CollisionInputs


class DetectorStep(NamedTuple):
    """Output of a detector at a tick, and its memory."""

    alarm: float  # 1 while it reports a collision, else 0; an alarm is raised where it turns 1
    direction: Vec  # f_c⁰ from robot to obstacle, world, of any length; zero if it knows none
    memory: Any


@generic
def detector_step(detector: Any, time: float, inputs: CollisionInputs, memory: Any) -> DetectorStep:
    """Output of a detector at a tick.

    Args:
        detector: Settings of the detector, a NamedTuple.
        time: Time since the start [s].
        inputs: Measurement, estimate and external wrench at this tick.
        memory: Memory of the detector, which is never changed in place: a new one is returned.
    """
    raise TypeError(f"{type(detector).__name__} is not a detector; register detector_step for it")


class NoDetector(NamedTuple):
    """No detector besides the triggers; also its memory."""


class DetectorMemory(NamedTuple):
    """Memory of a detector, and its last output."""

    own: Any  # the detector's memory
    alarm: float  # 1 while it reports a collision
    direction: Vec  # the last that it gave since the alarm; zero if none


class DetectorAlarm(NamedTuple):
    """Alarm of a detector or a trigger, and the detector's memory."""

    alarm: float  # 1 at the tick of an alarm, else 0
    memory: DetectorMemory


def detector_memory(own: Any) -> DetectorMemory:
    """Memory before tick 0, given that of the detector."""
    return DetectorMemory(own, 0.0, Vec(0.0, 0.0, 0.0))


@kernel
def detector_alarm(
    detector: Any,
    time: float,
    inputs: CollisionInputs,
    alarm: float,
    looks: bool,
    before: DetectorMemory,
) -> DetectorAlarm:
    """One tick of a detector.

    Args:
        detector: Settings.
        time: [s].
        inputs: At this tick.
        alarm: 1 if a trigger raises its alarm at this tick.
        looks: True in the observation window of a collision, to which alarms then belong.
        before: `detector_memory` at the start.
    """
    now = detector_step(detector, time, inputs, before.own)
    rises = (now.alarm > 0.5) & (before.alarm < 0.5)
    raised = rises | (alarm > 0.5)
    known = now.direction @ now.direction > 0.0
    begins = raised & (not looks)
    direction = select(known | begins, now.direction, before.direction)
    after = DetectorMemory(now.memory, select(now.alarm > 0.5, 1.0, 0.0), direction)
    return DetectorAlarm(select(raised, 1.0, 0.0), after)


@generic
def detected_direction(memory: Any) -> Vec:
    """Direction that a detector gave since the last alarm; zero if it gave none."""
    return _last_direction(memory)


@kernel
def _last_direction(memory: DetectorMemory) -> Vec:
    return memory.direction


@detected_direction.register(NoDetector)
@kernel
def _no_direction(memory: NoDetector) -> Vec:
    return Vec(0.0, 0.0, 0.0)

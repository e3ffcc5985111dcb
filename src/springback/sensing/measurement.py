"""What sensors tell a pilot, and what an estimator makes of it.

Everything lives on a clock of equal ticks.  Devices that run slower than the clock say in `fresh`
whether they have spoken at this tick; in between their last word stands.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from springback.kernels.compiler import generic, kernel
from springback.kernels.vectors import Quat, Vec
from springback.simulation.aboard import Sensed as Sensed
from springback.simulation.aboard import Truth as Truth
from springback.simulation.aboard import sensed as sensed


class Inertial(NamedTuple):
    """One sample of accelerometer and gyroscope, body axes, at the place of the sensor."""

    specific_force: Vec  # [m/s²]; a robot at rest reads +g along body z
    angular_velocity: Vec  # [rad/s]
    fresh: float  # 1 at the tick at which it arrives, else 0


class Pose(NamedTuple):
    """One sample of a motion capture system."""

    position: Vec  # of the main body, world [m]
    attitude: Quat  # body to world
    fresh: float  # 1 at the tick at which it arrives, else 0
    age: float  # time since the pose was that of the robot [s]


class Estimate(NamedTuple):
    """What a pilot believes about its own motion."""

    position: Vec  # world [m]
    attitude: Quat  # body to world
    velocity: Vec  # world [m/s]
    angular_velocity: Vec  # body [rad/s]


class Measurement(NamedTuple):
    """All that a pilot is given at one tick."""

    inertial: Inertial
    pose: Pose
    arm_length: tuple[float, ...]  # [m]
    arm_length_fresh: float
    exact: Estimate  # the truth where sensors are asked to reveal it, else zeros


@kernel
def due(tick: float, every: float) -> bool:
    """Whether a device that speaks every so many ticks (a whole number) speaks at this one."""
    return tick - every * math.floor((tick + 0.5) / every) < 0.5


class Believed(NamedTuple):
    """An estimate, and what the estimator remembers."""

    estimate: Estimate
    memory: Any


@generic
def estimated(estimator: Any, tick: float, seen: Measurement, memory: Any) -> Believed:
    """What an estimator makes of a measurement.

    Args:
        estimator: Settings of the estimator, a NamedTuple.
        tick: Number of the tick, from 0; a whole number.
        seen: What the sensors say.
        memory: What the estimator remembers; returned anew, never changed in place.
    """
    raise TypeError(f"{type(estimator).__name__} is no estimator; register estimated for it")

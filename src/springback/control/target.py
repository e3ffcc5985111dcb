"""What references ask for, and what controllers hand on to each other."""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.kernels.compiler import generic
from springback.kernels.vectors import Quat, Vec


class Target(NamedTuple):
    """Where the robot should be at one time, and how it should move; world axes."""

    position: Vec  # [m]
    velocity: Vec  # [m/s]
    acceleration: Vec  # [m/s²]
    jerk: Vec  # [m/s³]
    yaw: float  # [rad]
    yaw_rate: float  # [rad/s]


@generic
def target(reference: Any, time: float) -> Target:
    """What a reference asks for at a time [s]."""
    raise TypeError(f"{type(reference).__name__} is no reference; register target for it")


class AttitudeTarget(NamedTuple):
    """What a position controller asks of the attitude controller."""

    attitude: Quat  # body to world
    angular_velocity: Vec  # feed-forward, axes of the desired attitude [rad/s]
    thrust: float  # collective, along body z [N]


class Wrench(NamedTuple):
    """Collective thrust and moment about the main body, body axes."""

    thrust: float  # [N]
    moment: Vec  # [N m]

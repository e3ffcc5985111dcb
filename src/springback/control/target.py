"""Targets from references, and the commands between controllers."""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.kernels.compiler import generic
from springback.kernels.vectors import Quat, Vec


class Target(NamedTuple):
    """Target position and motion of the robot at one time; world axes."""

    position: Vec  # [m]
    velocity: Vec  # [m/s]
    acceleration: Vec  # [m/s²]
    jerk: Vec  # [m/s³]
    yaw: float  # [rad]
    yaw_rate: float  # [rad/s]


@generic
def target(reference: Any, time: float) -> Target:
    """Target of a reference at a time [s]."""
    raise TypeError(f"{type(reference).__name__} is not a reference; register target for it")


class AttitudeTarget(NamedTuple):
    """Command of a position controller to the attitude controller."""

    attitude: Quat  # body to world
    angular_velocity: Vec  # feed-forward, axes of the desired attitude [rad/s]
    thrust: float  # collective, along body z [N]


class Wrench(NamedTuple):
    """Collective thrust and moment about the main body, body axes."""

    thrust: float  # [N]
    moment: Vec  # [N m]

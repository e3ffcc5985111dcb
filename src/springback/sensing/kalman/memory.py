"""Settings and memory of the Kalman filter."""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

from springback.kernels.compiler import kernel
from springback.kernels.tree_code import Rarely
from springback.kernels.vectors import ZERO, Quat, Vec, rotation
from springback.sensing.kalman.covariance import Covariance, diagonal_covariance
from springback.sensing.measurement import Estimate

#: Instants closer than this, as a fraction of a period, are the same: rounding.
ROUNDING = 1e-6


class Kalman(NamedTuple):
    """Settings of the filter; see `springback.sensing.estimation.KalmanSettings`."""

    tick: float  # [s]
    interval: float  # between inertial samples [s]
    inertial_lag: float  # delay of inertial samples [s]
    every: float  # inertial samples per prediction of the covariance
    pose_interval: float  # between exposures of motion capture [s]
    pose_phase: float  # of one exposure, since tick 0 [s]
    delays: tuple[float, ...]  # of stored poses, after the newest: 0, 1, … pose intervals [s]
    gravity: float  # g along −Z [m/s²]
    offset: Vec  # r, of the inertial sensor from the main body, body axes [m]
    accelerometer_noise: float  # one-sided density [m/s²/√Hz]
    gyroscope_noise: float  # one-sided density [rad/s/√Hz]
    accelerometer_walk: float  # of the bias [m/s³/√Hz]
    gyroscope_walk: float  # of the bias [rad/s²/√Hz]
    accelerometer_range: float  # [m/s²]
    gyroscope_range: float  # [rad/s]
    distrust: float  # duration of clipping that loses as much as the range [s]; 0 ignores it
    position_noise: float  # of motion capture, standard deviation [m]
    attitude_noise: float  # of motion capture, standard deviation about each axis [rad]


@kernel
def exposed_before(kalman: Kalman, tick: float) -> float:
    """Time from the last exposure of motion capture to the instant of an inertial sample [s].

    Args:
        kalman: Settings of the filter.
        tick: Tick at which the sample arrives.
    """
    time = tick * kalman.tick - kalman.inertial_lag - kalman.pose_phase
    return time - kalman.pose_interval * math.floor(time / kalman.pose_interval + ROUNDING)


class Nominal(NamedTuple):
    """Nominal state of the filter, for the inertial sensor."""

    position: Vec  # world [m]
    velocity: Vec  # world [m/s]
    attitude: Quat  # body to world
    accelerometer_bias: Vec  # body [m/s²]
    gyroscope_bias: Vec  # body [rad/s]


class PoseWindow(NamedTuple):
    """Inertial samples since the covariance was last predicted."""

    duration: float  # [s]
    gained: Vec  # ∫ R f dt, world [m/s]
    attitude: Quat  # at its beginning
    clipped: float  # time with an accelerometer at its range [s]
    spun: float  # time with a gyroscope at its range [s]


@kernel
def empty_window(attitude: Quat) -> PoseWindow:
    """A window that begins at an attitude."""
    return PoseWindow(0.0, Vec(0.0, 0.0, 0.0), attitude, 0.0, 0.0)


class StoredPose(NamedTuple):
    """A pose of the inertial sensor at an exposure, or a weighted sum of poses."""

    position: Vec  # world [m]
    attitude: Quat


class Innovation(NamedTuple):
    """Normalised innovations squared, zᵀ S⁻¹ z, of the last pose; each should be χ²(3)."""

    position: float
    attitude: float


class Track(NamedTuple):
    """Nominal state of the filter, and its recent history."""

    nominal: Nominal
    angular_velocity: Vec  # body, bias subtracted [rad/s]
    acceleration: Vec  # world [m/s²]
    window: PoseWindow
    stored: tuple[StoredPose, ...]  # of the last exposures, newest first
    waiting: float  # time since the last inertial sample [s]


class Known(NamedTuple):
    """Uncertainty of the filter."""

    covariance: Covariance
    innovation: Innovation


class KalmanMemory(NamedTuple):
    """Memory of the filter."""

    track: Track
    known: Rarely  # Known; it changes with poses only


class Deviations(NamedTuple):
    """Standard deviations of the errors at the start, along each axis."""

    position: float  # [m]
    velocity: float  # [m/s]
    attitude: float  # [rad]
    accelerometer_bias: float  # [m/s²]
    gyroscope_bias: float  # [rad/s]


def kalman_memory(kalman: Kalman, estimate: Estimate, deviations: Deviations) -> KalmanMemory:
    """Memory of a filter that has been at rest in a known state, with unknown biases."""
    r, since = rotation(estimate.attitude), exposed_before(kalman, 0.0)
    position = estimate.position + r @ kalman.offset
    velocity = estimate.velocity + r @ (estimate.angular_velocity ^ kalman.offset)
    track = Track(
        nominal=Nominal(position, velocity, estimate.attitude, ZERO, ZERO),
        angular_velocity=estimate.angular_velocity,
        acceleration=ZERO,
        window=empty_window(estimate.attitude),
        stored=tuple(
            StoredPose(position - (since + d) * velocity, estimate.attitude) for d in kalman.delays
        ),
        waiting=0.0,
    )
    return KalmanMemory(track, _first_known(deviations))


@functools.lru_cache(maxsize=64)  # the same for every flight of a campaign
def _first_known(deviations: Deviations) -> Rarely:
    return Rarely(0.0, Known(diagonal_covariance(*deviations), Innovation(0.0, 0.0)))

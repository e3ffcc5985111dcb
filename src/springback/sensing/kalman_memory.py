"""What the Kalman filter is told, and what it remembers."""

from __future__ import annotations

from typing import NamedTuple

from springback.kernels.compiler import kernel
from springback.kernels.vectors import Quat, Vec, rotation
from springback.sensing.covariance import Covariance, uncorrelated
from springback.sensing.measurement import Estimate


class Kalman(NamedTuple):
    """Settings of the filter; see `springback.sensing.estimation.KalmanSettings`."""

    tick: float  # [s]
    interval: float  # between inertial samples [s]
    inertial_lag: float  # by which inertial samples are late [s]
    every: float  # inertial samples to one prediction of the covariance
    delays: tuple[float, ...]  # of the kept poses: 0, 1, 2, … intervals [s]
    gravity: float  # g along −Z [m/s²]
    offset: Vec  # r, of the inertial sensor from the main body, body axes [m]
    accelerometer_noise: float  # one-sided density [m/s²/√Hz]
    gyroscope_noise: float  # one-sided density [rad/s/√Hz]
    accelerometer_walk: float  # of the bias [m/s³/√Hz]
    gyroscope_walk: float  # of the bias [rad/s²/√Hz]
    accelerometer_range: float  # [m/s²]
    gyroscope_range: float  # [rad/s]
    distrust: float  # time over which clipping loses as much as the range [s]; 0 trusts
    position_noise: float  # of motion capture, standard deviation [m]
    attitude_noise: float  # of motion capture, standard deviation about each axis [rad]


class Nominal(NamedTuple):
    """What the filter believes, of the place of the inertial sensor."""

    position: Vec  # world [m]
    velocity: Vec  # world [m/s]
    attitude: Quat  # body to world
    accelerometer_bias: Vec  # body [m/s²]
    gyroscope_bias: Vec  # body [rad/s]


class Window(NamedTuple):
    """Inertial samples since the covariance was last predicted."""

    duration: float  # [s]
    gained: Vec  # ∫ R f dt, world [m/s]
    attitude: Quat  # at its beginning
    clipped: float  # time with an accelerometer at its range [s]
    spun: float  # time with a gyroscope at its range [s]


@kernel
def empty_window(attitude: Quat) -> Window:
    """A window that begins at an attitude."""
    return Window(0.0, Vec(0.0, 0.0, 0.0), attitude, 0.0, 0.0)


class Kept(NamedTuple):
    """A pose of the inertial sensor as the filter knew it, or a weighted sum of such."""

    position: Vec  # world [m]
    attitude: Quat


class Surprise(NamedTuple):
    """Normalised innovations squared, zᵀ S⁻¹ z, of the last pose; each should be χ²(3)."""

    position: float
    attitude: float


class Track(NamedTuple):
    """Where the filter is and how it came there."""

    nominal: Nominal
    angular_velocity: Vec  # body, bias taken off [rad/s]
    acceleration: Vec  # world [m/s²]
    window: Window
    kept: tuple[Kept, ...]  # newest first
    waiting: float  # time since the last inertial sample [s]


class KalmanMemory(NamedTuple):
    """What the filter remembers."""

    track: Track
    covariance: Covariance
    surprise: Surprise


class Deviations(NamedTuple):
    """Standard deviations of the errors at the start, along each axis."""

    position: float  # [m]
    velocity: float  # [m/s]
    attitude: float  # [rad]
    accelerometer_bias: float  # [m/s²]
    gyroscope_bias: float  # [rad/s]


def kalman_memory(kalman: Kalman, estimate: Estimate, deviations: Deviations) -> KalmanMemory:
    """What a filter remembers that has stood for a while in a known state, biases unknown."""
    r = rotation(estimate.attitude)
    position = estimate.position + r @ kalman.offset
    velocity = estimate.velocity + r @ (estimate.angular_velocity ^ kalman.offset)
    zero = Vec(0.0, 0.0, 0.0)
    track = Track(
        nominal=Nominal(position, velocity, estimate.attitude, zero, zero),
        angular_velocity=estimate.angular_velocity,
        acceleration=zero,
        window=empty_window(estimate.attitude),
        kept=tuple(Kept(position - d * velocity, estimate.attitude) for d in kalman.delays),
        waiting=0.0,
    )
    return KalmanMemory(track, uncorrelated(*deviations), Surprise(0.0, 0.0))

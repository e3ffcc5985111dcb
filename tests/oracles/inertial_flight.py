"""A smooth, aggressive motion in closed form, and what ideal sensors with white noise say of it.

NumPy and SciPy only; nothing of it comes from the package's own sensors.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial.transform import Rotation

G = 9.81


@dataclass(frozen=True)
class Noise:
    """Standard deviations: one-sided densities, walks, poses, and biases at the start."""

    accelerometer: float = 0.0
    gyroscope: float = 0.0
    accelerometer_walk: float = 0.0
    gyroscope_walk: float = 0.0
    position: float = 0.0
    attitude: float = 0.0
    accelerometer_bias: float = 0.0
    gyroscope_bias: float = 0.0


@dataclass(frozen=True)
class Flight:
    """Arrays over the samples 0 … n; sample k covers the interval that ends with it."""

    dt: float
    position: np.ndarray  # of the main body
    velocity: np.ndarray
    attitude: Rotation
    rate: np.ndarray  # body axes, at the sample
    accelerometer_bias: np.ndarray
    gyroscope_bias: np.ndarray
    force: np.ndarray  # what the sensor says
    spin: np.ndarray
    fresh: np.ndarray  # 1 where a pose arrives
    pose_position: np.ndarray
    pose_attitude: Rotation
    age: float


class Path:
    """Place of the sensor: sums of sines; attitude: Euler angles ZYX that are sums of sines."""

    def __init__(self, generator, strength=1.0, drift=(0.0, 0.0, 0.0)):
        self.amplitude = strength * generator.uniform(0.1, 0.4, (3, 3))
        self.omega = generator.uniform(1.0, 5.0, (3, 3))
        self.phase = generator.uniform(0.0, 2.0 * np.pi, (3, 3))
        self.angle = strength * generator.uniform(0.1, 0.35, (3, 3))
        self.angle_omega = generator.uniform(1.0, 8.0, (3, 3))
        self.angle_phase = generator.uniform(0.0, 2.0 * np.pi, (3, 3))
        self.drift = np.array(drift)

    @staticmethod
    def _sines(t, amplitude, omega, phase, order):
        angle = omega * t[:, None, None] + phase + order * np.pi / 2.0
        return (amplitude * omega**order * np.sin(angle)).sum(axis=-1)

    def place(self, t, order):
        moved = self._sines(t, self.amplitude, self.omega, self.phase, order)
        return moved + self.drift * (t[:, None] if order == 0 else 1.0 if order == 1 else 0.0)

    def attitude(self, t):
        roll, pitch, yaw = self._sines(t, self.angle, self.angle_omega, self.angle_phase, 0).T
        return Rotation.from_euler("ZYX", np.stack([yaw, pitch, roll], axis=1))

    def rate(self, t):
        """Body rates of Euler angle rates (ZYX), any textbook."""
        roll, pitch, _ = self._sines(t, self.angle, self.angle_omega, self.angle_phase, 0).T
        droll, dpitch, dyaw = self._sines(t, self.angle, self.angle_omega, self.angle_phase, 1).T
        return np.stack(
            [
                droll - dyaw * np.sin(pitch),
                dpitch * np.cos(roll) + dyaw * np.sin(roll) * np.cos(pitch),
                -dpitch * np.sin(roll) + dyaw * np.cos(roll) * np.cos(pitch),
            ],
            axis=1,
        )

    def force(self, t):
        return self.attitude(t).inv().apply(self.place(t, 2) + np.array([0.0, 0.0, G]))


def flight(
    generator,
    duration,
    *,
    noise=None,
    offset=(0.0, 0.0, 0.0),
    age=0.0045,
    pose_every=5,
    dt=1e-3,
    strength=1.0,
):
    """One flight with its readings."""
    noise = noise or Noise()
    path, n = Path(generator, strength), round(duration / dt)
    t = dt * np.arange(n + 1)
    r = np.array(offset)

    def body(at):
        attitude = path.attitude(at)
        return path.place(at, 0) - attitude.apply(r), attitude

    position, attitude = body(t)
    rate = path.rate(t)
    velocity = path.place(t, 1) - attitude.apply(np.cross(rate, r))
    turned = (attitude[:-1].inv() * attitude[1:]).as_rotvec() / dt  # mean rate, exactly
    middle = path.force(t[:-1] + 0.5 * dt)  # mean force by Simpson's rule
    mean = (path.force(t[:-1]) + 4.0 * middle + path.force(t[1:])) / 6.0

    def wandering(start, walk):
        steps = walk * np.sqrt(dt) * generator.standard_normal((n + 1, 3))
        return start * generator.standard_normal(3) + np.cumsum(steps, axis=0)

    b_a = wandering(noise.accelerometer_bias, noise.accelerometer_walk)
    b_w = wandering(noise.gyroscope_bias, noise.gyroscope_walk)
    sigma = np.sqrt(0.5 / dt)
    force, spin = np.zeros((n + 1, 3)), np.zeros((n + 1, 3))
    force[1:] = mean + noise.accelerometer * sigma * generator.standard_normal((n, 3))
    spin[1:] = turned + noise.gyroscope * sigma * generator.standard_normal((n, 3))
    then_position, then_attitude = body(t - age)
    error = Rotation.from_rotvec(noise.attitude * generator.standard_normal((n + 1, 3)))
    return Flight(
        dt=dt,
        position=position,
        velocity=velocity,
        attitude=attitude,
        rate=rate,
        accelerometer_bias=b_a,
        gyroscope_bias=b_w,
        force=force + b_a,
        spin=spin + b_w,
        fresh=(np.arange(n + 1) % pose_every == 0).astype(float),
        pose_position=then_position + noise.position * generator.standard_normal((n + 1, 3)),
        pose_attitude=then_attitude * error,
        age=age,
    )


def at_rest(duration, *, dt=1e-3, attitude=None, pose_every=5, force=None, spin=None):
    """A robot at rest, its readings perhaps with something added, shape (3,) or (n+1, 3).

    What is added is not a motion: it is what sensors say beside the truth.
    """
    n = round(duration / dt)
    attitude = attitude or Rotation.identity()
    all_attitudes = Rotation.from_quat(np.tile(attitude.as_quat(), (n + 1, 1)))
    zero = np.zeros((n + 1, 3))
    up = attitude.inv().apply([0.0, 0.0, G])
    return Flight(
        dt=dt,
        position=zero,
        velocity=zero,
        attitude=all_attitudes,
        rate=zero,
        accelerometer_bias=zero,
        gyroscope_bias=zero,
        force=zero + up + (0.0 if force is None else force),
        spin=zero + (0.0 if spin is None else spin),
        fresh=(np.arange(n + 1) % pose_every == 0).astype(float),
        pose_position=zero,
        pose_attitude=all_attitudes,
        age=0.0,
    )


def without_poses(flown):
    """The same flight with motion capture switched off."""
    return replace(flown, fresh=np.zeros_like(flown.fresh))

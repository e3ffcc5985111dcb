"""What sensors would tell of flights whose states are known at many instants.

The order is that of the devices: mean over an interval, bias, range, low-pass, mean over the
averaging time, sample (`springback.sensing.inertial` has the same at the ticks of a flight).
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.batch.sampled import StateSamples
from springback.logs.frame_turns import product
from springback.logs.recording import Array

#: Longest interval over which specific forces are means [s] (chosen: that of a 1 kHz device).
FINEST = 1e-3


class ChannelChain(NamedTuple):
    """Range [SI], corner of the low-pass [Hz] and averaging time [s] of a channel; None: none."""

    full_scale: float | None
    low_pass: float | None
    average: float | None


def fine_grid(times: Array, until: float) -> Array:
    """Instants from 0 to an end that include some samples, with steps of `FINEST` at most."""
    knots = np.unique(np.concatenate([[0.0], times[times > 1e-9], [until]]))
    steps = np.diff(knots)
    parts = [
        np.linspace(a, b, max(1, int(np.ceil((b - a) / FINEST - 1e-6))), endpoint=False)
        for a, b, step in zip(knots[:-1], knots[1:], steps, strict=True)
        if step > 1e-9
    ]
    return np.concatenate([*parts, knots[-1:]])


class InertialMeans(NamedTuple):
    """Means over the intervals of a grid, body axes, shape (flights, intervals, 3)."""

    specific_force: Array  # [m/s²]
    angular_velocity: Array  # [rad/s]


def inertial_means(samples: StateSamples, place: Array, gravity: float) -> InertialMeans:
    """True means at an inertial unit: f = Rᵀ(Δv/Δt + g e_Z) + α × r + ω × (ω × r).

    Args:
        samples: States at the instants of the grid.
        place: r, from the main body's centre of mass, body axes [m].
        gravity: g along −Z [m/s²].
    """
    q = samples.of("attitude.w", "attitude.x", "attitude.y", "attitude.z")
    v, omega = samples.vectors("velocity"), samples.vectors("angular_velocity")
    dt = np.diff(samples.times)[:, None]
    middle = q[:, 1:] + q[:, :-1]
    middle /= np.linalg.norm(middle, axis=-1, keepdims=True)
    acceleration = np.diff(v, axis=1) / dt
    acceleration[..., 2] += gravity
    mean = 0.5 * (omega[:, 1:] + omega[:, :-1])
    force = _turned_back(middle, acceleration)
    if place.any():
        alpha = np.diff(omega, axis=1) / dt
        force += np.cross(alpha, place) + np.cross(mean, np.cross(mean, place))
    return InertialMeans(force, mean)


def _turned_back(q: Array, vectors: Array) -> Array:
    """World vectors in body axes: v − 2 w (u × v) + 2 u × (u × v)."""
    u = q[..., 1:]
    across = np.cross(u, vectors)
    turned: Array = vectors - 2.0 * q[..., :1] * across + 2.0 * np.cross(u, across)
    return turned


def channel_output(
    true: Array, bias: Array, chain: ChannelChain, grid: Array, times: Array
) -> Array:
    """Samples of an accelerometer or a gyroscope.

    Args:
        true: Means over the intervals of the grid, shape (points, intervals, 3).
        bias: Shape (points, 3).
        chain: Of the channel.
        grid: Instants [s].
        times: Of the samples, each an instant of the grid [s].
    """
    inside = true + bias[:, None, :]
    if chain.full_scale is not None:
        inside = np.clip(inside, -chain.full_scale, chain.full_scale)
    steps = np.diff(grid)
    if chain.low_pass is not None:
        inside = _low_passed(inside, -np.expm1(-2.0 * np.pi * chain.low_pass * steps))
    ends = np.searchsorted(grid, times + 1e-9, "right") - 2  # interval that ends at each sample
    if chain.average is not None and chain.average > FINEST:
        area = np.concatenate(
            [np.zeros_like(inside[:, :1]), np.cumsum(inside * steps[:, None], axis=1)], axis=1
        )
        begins = np.maximum(times - chain.average, 0.0)
        low = np.clip(np.searchsorted(grid, begins, "right") - 1, 0, len(steps) - 1)
        part = area[:, low] + inside[:, low] * (begins - grid[low])[:, None]
        span = np.maximum(times - begins, FINEST)
        means: Array = (area[:, np.maximum(ends + 1, 0)] - part) / span[:, None]
        early = times - chain.average < 0.0
        return np.where(early[:, None] & (ends < 1)[:, None], inside[:, :1], means)
    return inside[:, np.maximum(ends, 0)]


def _low_passed(values: Array, shares: Array) -> Array:
    """First-order low-pass along the intervals, settled on the first."""
    begin = values[:, 0]
    if np.ptp(shares) < 1e-9 * shares.max():
        a = float(shares[0])
        state = (1.0 - a) * begin[:, None]
        out, _ = scipy.signal.lfilter([a], [1.0, a - 1.0], values, axis=1, zi=state)
        return np.asarray(out)
    smooth, now = np.empty_like(values), begin
    for k, share in enumerate(shares):
        now = now + share * (values[:, k] - now)
        smooth[:, k] = now
    return smooth


class Interpolator:
    """Cubic Hermite interpolation of states between the instants of their grid."""

    def __init__(self, samples: StateSamples, flights: Any, times: Array) -> None:
        """Prepare instants.

        Args:
            samples: States.
            flights: Number of the flight of each point, shape (points,).
            times: Instants of each point [s], shape (points, instants).
        """
        grid = samples.times
        self.samples, self.flights = samples, np.asarray(flights)[:, None]
        at = np.clip(times, grid[0], grid[-1])
        self.k = np.clip(np.searchsorted(grid, at, "right") - 1, 0, len(grid) - 2)
        self.h = (grid[self.k + 1] - grid[self.k])[..., None]
        self.s = (at - grid[self.k])[..., None] / self.h

    def _ends(self, values: Array) -> tuple[Array, Array]:
        return values[self.flights, self.k], values[self.flights, self.k + 1]

    def positions(self, values: Array, rates: Array) -> Array:
        """Values with known rates, shapes (flights, grid, width) to (points, instants, width)."""
        (p, after), (v, later) = self._ends(values), self._ends(rates)
        s, h = self.s, self.h
        square, cube = s * s, s * s * s
        found: Array = (
            (2.0 * cube - 3.0 * square + 1.0) * p + (cube - 2.0 * square + s) * h * v
            + (3.0 * square - 2.0 * cube) * after + (cube - square) * h * later
        )  # fmt: skip
        return found

    def linear(self, values: Array) -> Array:
        """Values without known rates, shape (flights, grid, width) to (points, instants, width)."""
        a, b = self._ends(values)
        return np.asarray(a + self.s * (b - a))

    def attitudes(self) -> Array:
        """Attitudes, shape (points, instants, 4)."""
        q = self.samples.of("attitude.w", "attitude.x", "attitude.y", "attitude.z")
        a, b = self._ends(q)
        mean = a + self.s * (b - a)
        normed: Array = mean / np.linalg.norm(mean, axis=-1, keepdims=True)
        return normed


def attitude_errors(predicted: Array, measured: Array) -> Array:
    """Small rotation vectors from predicted to measured attitudes, body axes [rad]."""
    inverse = predicted * np.array([1.0, -1.0, -1.0, -1.0])
    error = product(inverse, np.broadcast_to(measured, predicted.shape))
    small: Array = 2.0 * np.sign(error[..., :1]) * error[..., 1:]
    return small


def smooth(values: Array, rate: float, corner: float) -> Array:
    """Zero-phase Butterworth filter of second order each way, along axis 1."""
    if corner >= 0.5 * rate:
        return values
    sections = scipy.signal.butter(2, corner, fs=rate, output="sos")
    pad = min(values.shape[1] - 1, 3 * int(rate / corner))
    return np.asarray(scipy.signal.sosfiltfilt(sections, values, axis=1, padlen=pad))

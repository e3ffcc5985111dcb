"""What sensors would tell of flights whose states are known at many instants.

The order is that of the devices: mean over an interval, bias, range, low-pass of the device, that
of the autopilot, mean over the averaging time, sample (`springback.sensing.inertial` has the same
at the ticks of a flight, without an autopilot's).
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
#: Samples over which noise behind a filter is remembered (chosen: with 8, intervals are the same).
LAGS = 12


class ChannelChain(NamedTuple):
    """Range [SI], corner of the low-pass [Hz] and averaging time [s] of a channel; None: none."""

    full_scale: float | None
    low_pass: float | None
    average: float | None
    order: int = 1
    """Of the low-pass: 2 is a Butterworth filter."""
    device: float | None = None
    """Corner of the device's own low-pass before it, of first order [Hz]."""


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
    mean = mean_rates(samples)
    force = _turned_back(middle, acceleration)
    if place.any():
        alpha = np.diff(omega, axis=1) / dt
        force += np.cross(alpha, place) + np.cross(mean, np.cross(mean, place))
    return InertialMeans(force, mean)


def mean_rates(samples: StateSamples) -> Array:
    """Means of the angular velocity, body axes, shape (flights, intervals, 3) [rad/s]."""
    omega = samples.vectors("angular_velocity")
    return np.asarray(0.5 * (omega[:, 1:] + omega[:, :-1]))


def _turned_back(q: Array, vectors: Array) -> Array:
    """World vectors in body axes: v − 2 w (u × v) + 2 u × (u × v)."""
    u = q[..., 1:]
    across = np.cross(u, vectors)
    turned: Array = vectors - 2.0 * q[..., :1] * across + 2.0 * np.cross(u, across)
    return turned


def channel_output(
    true: Array,
    bias: Array,
    chain: ChannelChain,
    grid: Array,
    times: Array,
    corners: Array | None = None,
) -> Array:
    """Samples of an accelerometer or a gyroscope.

    Args:
        true: Means over the intervals of the grid, shape (points, intervals, 3).
        bias: Shape (points, 3).
        chain: Of the channel.
        grid: Instants [s].
        times: Of the samples, each an instant of the grid [s].
        corners: Of the low-pass in place of the chain's [Hz], shape (points,).
    """
    inside = true + bias[:, None, :]
    if chain.full_scale is not None:
        inside = np.clip(inside, -chain.full_scale, chain.full_scale)
    steps = np.diff(grid)
    if chain.device is not None:
        inside = low_passed(inside, chain.device, 1, steps)
    if chain.low_pass is not None:
        each = np.broadcast_to(chain.low_pass if corners is None else corners, len(inside))
        passed = np.empty_like(inside)
        for corner in np.unique(each):
            passed[each == corner] = low_passed(
                inside[each == corner], float(corner), chain.order, steps
            )
        inside = passed
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


def noise_covariances(chain: ChannelChain, rate: float) -> Array | None:
    """Autocovariances of white noise of deviation 1 behind the low-passes of a channel.

    Args:
        chain: Of the channel.
        rate: Of its samples [Hz].

    Returns:
        From lag 0 on, shape (`LAGS` + 1,); None without a filter of second order.  Noise behind one
        of first order is autoregressive, and estimated as such.
    """
    if chain.low_pass is None or chain.order != 2:
        return None
    every = int(np.ceil(1.0 / (FINEST * rate) - 1e-6))
    count = every * LAGS + int(np.ceil(every * rate / chain.low_pass)) * 4
    steps = np.full(count, 1.0 / (every * rate))
    push = np.zeros((1, count, 1))
    push[0, 1] = 1.0  # filters are settled on the first
    if chain.device is not None:
        push = low_passed(push, chain.device, 1, steps)
    answer = low_passed(push, chain.low_pass, 2, steps)[0, :, 0]
    return np.array([
        float(answer[: count - k * every] @ answer[k * every :]) for k in range(LAGS + 1)
    ])  # fmt: skip


def low_passed(values: Array, corner: float, order: int, steps: Array) -> Array:
    """Values behind a low-pass along intervals, settled on the first.

    Args:
        values: Means over the intervals, shape (points, intervals, width).
        corner: [Hz].
        order: 1, or 2 for a Butterworth filter, as autopilots have it at the rate of the sensor.
        steps: Lengths of the intervals [s].
    """
    if order == 2:
        return _butterworth(values, corner, steps)
    return _first_order(values, -np.expm1(-2.0 * np.pi * corner * steps))


def _butterworth(values: Array, corner: float, steps: Array) -> Array:
    """Butterworth filter of second order: bilinear on equal steps, else by its exact response."""
    begin = values[:, 0]
    if np.ptp(steps) < 1e-6 * steps.max():
        rate = 1.0 / float(steps.mean())
        if corner >= 0.5 * rate:  # beyond what its samples can have: autopilots leave it out then
            return values
        b, a = scipy.signal.butter(2, corner, fs=rate)
        state = scipy.signal.lfilter_zi(b, a)[None, :, None] * begin[:, None]
        out, _ = scipy.signal.lfilter(b, a, values, axis=1, zi=state)
        return np.asarray(out)
    # y'' = −2 a y' − 2 a² (y − x), x the mean of neighbours, as it is of the bilinear one.
    a = np.sqrt(2.0) * np.pi * corner
    decay, cosine, sine = np.exp(-a * steps), np.cos(a * steps), np.sin(a * steps)
    smooth, place, rate_ = np.empty_like(values), begin.copy(), np.zeros_like(begin)
    before = begin
    for k in range(len(steps)):
        x, before = 0.5 * (before + values[:, k]), values[:, k]
        off = place - x
        place = x + decay[k] * (off * (cosine[k] + sine[k]) + rate_ / a * sine[k])
        rate_ = decay[k] * (rate_ * (cosine[k] - sine[k]) - 2.0 * a * off * sine[k])
        smooth[:, k] = place
    return smooth


def _first_order(values: Array, shares: Array) -> Array:
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

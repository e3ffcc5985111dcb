"""Times of channels: rates, gaps, stamps of arrival, and the offset between two clocks."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from springback.logs.frame_turns import conjugate, product, rotation_vector
from springback.logs.recording import Array, LogChannel

#: A step this many times the median is a gap (chosen).
GAP = 3.0
#: Stamps are times of arrival if so many steps are below a quarter and above twice the mean
#: (chosen: a regular clock has none of either).
SHORT, LONG = 0.10, 0.05
#: Time over which rates of turn are averaged when they are compared [s] (chosen).
WINDOW = 0.03
#: Grid on which clocks are aligned [s], and most points of it (chosen).
GRID, MOST_POINTS = 0.005, 2_000_000
#: Range and step of the fine search about a coarse offset [s] (chosen).
FINE, FINE_STEP = 0.03, 0.0005


class Gap(NamedTuple):
    """Time without samples."""

    start: float  # [s], the last sample before it
    duration: float  # [s]


class ChannelTiming(NamedTuple):
    """Times of a channel."""

    rate: float  # [Hz], between gaps
    gaps: tuple[Gap, ...]  # the longest first
    has_arrivals: bool  # stamps look like times of arrival over a link
    repeats: int  # samples with the time of the one before

    @property
    def longest(self) -> Gap | None:
        """The longest gap."""
        return self.gaps[0] if self.gaps else None


def timing(channel: LogChannel) -> ChannelTiming:
    """Rate, gaps and regularity of a channel's times."""
    steps = np.diff(channel.times)
    moving = steps[steps > 0.0]
    if not len(moving):
        return ChannelTiming(0.0, (), False, int((steps == 0.0).sum()))
    usual = float(np.median(moving))
    wide = np.flatnonzero(steps > GAP * usual)
    wide = wide[np.argsort(-steps[wide])]
    gaps = tuple(Gap(float(channel.times[k]), float(steps[k])) for k in wide)
    mean = float(steps.mean())
    short, far = float((steps < 0.25 * mean).mean()), float((steps > 2.0 * mean).mean())
    arrived = len(steps) > 50 and short > SHORT and far > LONG
    return ChannelTiming(1.0 / usual, gaps, arrived, int((steps == 0.0).sum()))


class TurnRates(NamedTuple):
    """Mean rates of turn over windows, body axes."""

    begins: Array  # [s]
    ends: Array
    values: Array  # [rad/s], shape (windows, 3)


def attitude_rates(channel: LogChannel, window: float = WINDOW) -> TurnRates:
    """Mean rates of turn of an attitude, over windows without gaps, losses and resets.

    Args:
        channel: An attitude.
        window: Length of the windows [s]; at least one step.
    """
    t, q = channel.times, channel.values
    rate = channel.rate
    jump = max(1, round(window * rate)) if rate else 1
    if len(t) <= jump:
        return TurnRates(np.empty(0), np.empty(0), np.empty((0, 3)))
    span = t[jump:] - t[:-jump]
    fine = (span > 0.0) & (span < 2.0 * jump / rate if rate else span > 0.0)
    fine &= ~channel.is_lost[jump:] & ~channel.is_lost[:-jump]
    if channel.resets is not None:
        count = np.cumsum(channel.resets)
        fine &= count[jump:] == count[:-jump]
    norm = np.linalg.norm(q, axis=1)
    fine &= (np.abs(norm[jump:] - 1.0) < 0.1) & (np.abs(norm[:-jump] - 1.0) < 0.1)
    turn = product(conjugate(q[:-jump][fine]), q[jump:][fine])
    turn /= np.linalg.norm(turn, axis=1, keepdims=True)
    values = rotation_vector(turn) / span[fine][:, None]
    return TurnRates(t[:-jump][fine], t[jump:][fine], values)


class Integral:
    """Integral of a channel over time, by trapezoids, and whether it spans gaps."""

    def __init__(self, channel: LogChannel) -> None:
        """Integrate a channel; lost samples are left out."""
        known = ~channel.is_lost
        self.times, values = channel.times[known], channel.values[known]
        steps = np.diff(self.times)
        areas = 0.5 * (values[1:] + values[:-1]) * steps[:, None]
        zero = np.zeros((1, values.shape[1]))
        self.sums = np.concatenate([zero, np.cumsum(areas, axis=0)]) if len(values) else zero[:0]
        usual = 1.0 / channel.rate if channel.rate else np.inf
        self.holes = np.concatenate([[0.0], np.cumsum(steps > GAP * usual)])

    def means(self, begins: Array, ends: Array) -> tuple[Array, Any]:
        """Means over windows, shape (windows, width), and which of them are whole."""
        if len(self.times) < 2:
            return np.full((len(begins), self.sums.shape[1]), np.nan), np.zeros(len(begins), bool)
        whole = (begins >= self.times[0]) & (ends <= self.times[-1]) & (ends > begins)
        last = len(self.holes) - 1
        at = [np.clip(np.searchsorted(self.times, t), 0, last) for t in (begins, ends)]
        whole &= self.holes[at[0]] == self.holes[at[1]]
        sums = [
            np.stack([np.interp(t, self.times, one) for one in self.sums.T], axis=1)
            for t in (begins, ends)
        ]
        with np.errstate(invalid="ignore", divide="ignore"):
            return (sums[1] - sums[0]) / (ends - begins)[:, None], whole


class Offset(NamedTuple):
    """Time that is added to one clock to get another's."""

    seconds: float
    correlation: float  # of the rates' magnitudes, 1 at best


def clock_offset(attitude: LogChannel, gyro: LogChannel, *, within: float | None = None) -> Offset:
    """Offset from the clock of an attitude to that of a gyroscope.

    The magnitudes of both rates are compared, which no mistake of axes changes.

    Args:
        attitude: On one clock.
        gyro: On another one.
        within: Largest offset that is sought [s]; None: any.
    """
    rates = attitude_rates(attitude)
    known = ~gyro.is_lost
    if len(rates.begins) < 10 or known.sum() < 10:
        return Offset(0.0, 0.0)
    middle = 0.5 * (rates.begins + rates.ends)
    slow = np.linalg.norm(rates.values, axis=1)
    times, fast = gyro.times[known], np.linalg.norm(gyro.values[known], axis=1)
    spans = (middle[-1] - middle[0], times[-1] - times[0])
    step = max(GRID, max(spans) / MOST_POINTS)
    grids = [np.arange(t[0], t[-1], step) for t in (middle, times)]
    if min(map(len, grids)) < 10:
        return Offset(0.0, 0.0)
    a = np.interp(grids[0], middle, slow)
    b = np.interp(grids[1], times, fast)
    seek = _cross_correlation(b - b.mean(), a - a.mean())
    lags = (np.arange(len(seek)) - (len(a) - 1)) * step + grids[1][0] - grids[0][0]
    if within is not None:
        seek = np.where(np.abs(lags) <= within, seek, -np.inf)
    coarse = float(lags[int(np.argmax(seek))])
    integral = Integral(gyro)
    tries = coarse + np.arange(-FINE, FINE + 0.5 * FINE_STEP, FINE_STEP)
    scores = np.array([_agreement(rates, slow, integral, lag) for lag in tries])
    best = int(np.argmax(scores))
    found = float(tries[best])
    if 0 < best < len(tries) - 1:
        low, mid, high = scores[best - 1 : best + 2]
        bend = low - 2.0 * mid + high
        found += FINE_STEP * float(0.5 * (low - high) / bend) if bend < 0.0 else 0.0
    return Offset(found, float(scores[best]))


def _cross_correlation(b: Array, a: Array) -> Array:
    """Sums of b[n + k] a[n] over n, for k from 1 - len(a) to len(b) - 1."""
    size = 1 << (len(a) + len(b) - 2).bit_length()
    whole = np.fft.irfft(np.fft.rfft(b, size) * np.fft.rfft(a[::-1], size), size)
    return np.asarray(whole[: len(a) + len(b) - 1])


def _agreement(rates: TurnRates, slow: Array, integral: Integral, lag: float) -> float:
    """Correlation of the magnitudes of rates at an offset."""
    means, whole = integral.means(rates.begins + lag, rates.ends + lag)
    if whole.sum() < 10:
        return 0.0
    return correlation(slow[whole], np.linalg.norm(means[whole], axis=1))


def correlation(a: Array, b: Array) -> float:
    """Correlation coefficient; 0 if one does not vary."""
    a, b = a - a.mean(), b - b.mean()
    norm = float(np.sqrt((a @ a) * (b @ b)))
    return float(a @ b) / norm if norm > 0.0 else 0.0

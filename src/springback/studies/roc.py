"""Alarms that a threshold would have raised on a recorded signal: receiver operating curves.

The signals of all triggers are in the telemetry of a flight, so any threshold and any
persistence can be judged afterwards, on the same flights.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

Array = np.ndarray[Any, np.dtype[np.float64]]
#: Seconds in an hour.
HOUR = 3600.0
#: No event in a time T bounds the rate of events below this over T with 95 % confidence: −ln 0.05.
NONE_SEEN = 2.9957


class TriggerSignal(NamedTuple):
    """Signal of a trigger, evaluated after the flight."""

    signal: Array  # tick by tick
    period: float  # of a tick [s]
    every: int  # ticks between samples; in between, the signal is constant


def persistent_level(trigger: TriggerSignal, persistence: int) -> Array:
    """Least of the last samples, tick by tick, from the first tick on."""
    span = (persistence - 1) * trigger.every + 1
    if span == 1:
        return trigger.signal
    padded = np.concatenate([np.full(span - 1, -np.inf), trigger.signal])
    windows = np.lib.stride_tricks.sliding_window_view(padded, span)
    least: Array = windows.min(axis=1)
    return least


def alarms(
    trigger: TriggerSignal, threshold: float, persistence: int, refractory: float
) -> list[int]:
    """Ticks at which `springback.recovery.detection.trigger_step` goes off.

    Args:
        trigger: The signal.
        threshold: In its unit.
        persistence: Samples in a row above it.
        refractory: Time after an alarm without another [s].
    """
    above = persistent_level(trigger, persistence) > threshold
    begins = np.flatnonzero(above & ~np.concatenate([[False], above[:-1]]))
    raised: list[int] = []
    for tick in begins.tolist():
        if not raised or (tick - raised[-1]) * trigger.period >= refractory - 1e-9:
            raised.append(tick)
    return raised


def delay(
    trigger: TriggerSignal, touch: float, threshold: float, persistence: int, within: float
) -> float | None:
    """From touch to the first alarm after it [s]; None if there is none in time.

    A signal that is above the threshold already when the robot touches has raised its alarm before.

    Args:
        trigger: The signal, from tick 0 at time 0.
        touch: Time of first touch [s].
        threshold: In the unit of the signal.
        persistence: Samples in a row above it.
        within: A later alarm does not count [s].
    """
    first = int(np.ceil(touch / trigger.period))
    last = int((touch + within) / trigger.period) + 1
    before = max(first - 1 - (persistence - 1) * trigger.every, 0)
    near = trigger._replace(signal=trigger.signal[before:last])
    above = persistent_level(near, persistence)[max(first - 1, 0) - before :] > threshold
    begins = np.flatnonzero(above[1:] & ~above[:-1])
    if not len(begins):
        return None
    return float((first + begins[0]) * trigger.period - touch)


class RocPoint(NamedTuple):
    """One point of a receiver operating curve."""

    threshold: float
    persistence: int
    false_alarms: int
    hours: float  # of free flight
    noticed: int
    collisions: int
    delays: tuple[float, ...]  # of those noticed [s]

    @property
    def rate(self) -> float:
        """False alarms an hour."""
        return self.false_alarms / self.hours

    @property
    def bound(self) -> float:
        """Rate [1/h], or its upper bound at 95 % confidence if there was no false alarm."""
        return self.rate if self.false_alarms else NONE_SEEN / self.hours

    @property
    def probability(self) -> float:
        """Share of collisions that were noticed in time."""
        return self.noticed / self.collisions


class FalseAlarms(NamedTuple):
    """False alarms of every threshold in free flight."""

    false_alarms: tuple[int, ...]
    hours: float


def false_alarms(
    free: Sequence[TriggerSignal],
    thresholds: Sequence[float],
    *,
    persistence: int = 1,
    refractory: float = 1.0,
) -> FalseAlarms:
    """False alarms of every threshold.

    Args:
        free: Signals of free flights.
        thresholds: In the unit of the signal.
        persistence: Samples in a row above it.
        refractory: Time after an alarm without another [s].
    """
    hours = sum(len(one.signal) * one.period for one in free) / HOUR
    most = [float(one.signal.max()) for one in free]
    counts = (
        sum(
            len(alarms(one, threshold, persistence, refractory))
            for one, highest in zip(free, most, strict=True)
            if highest > threshold
        )
        for threshold in thresholds
    )
    return FalseAlarms(tuple(counts), hours)


def curve(
    free: FalseAlarms,
    hits: Sequence[tuple[TriggerSignal, float]],
    thresholds: Sequence[float],
    *,
    persistence: int = 1,
    within: float = 0.03,
) -> list[RocPoint]:
    """A receiver operating curve over thresholds.

    Args:
        free: False alarms of the same thresholds in free flight.
        hits: Signals of collisions, each with the time of first touch [s].
        thresholds: In the unit of the signal.
        persistence: Samples in a row above it.
        within: Time after touch in which an alarm counts [s].
    """
    points = []
    for threshold, false in zip(thresholds, free.false_alarms, strict=True):
        found = [delay(one, touch, threshold, persistence, within) for one, touch in hits]
        delays = tuple(x for x in found if x is not None)
        points.append(
            RocPoint(threshold, persistence, false, free.hours, len(delays), len(hits), delays)
        )
    return points

"""Free fall in a log: nothing is felt, so gravity cannot be read, and a drop test begins."""

from __future__ import annotations

import numpy as np

from springback.logs.recording import Array, Flags, LogChannel

#: Standard gravity [m/s²].
GRAVITY = 9.80665
#: Specific force, as a share of gravity, below which a vehicle falls and above which it is held
#: (chosen: biases and the drag of a fall are less, a rotor that turns is more).
FALLING, HELD = 0.25, 0.5
#: Time before touch in which a drop falls, and distance from touch and from its begin [s] (chosen).
LAST, CLEAR = 0.05, 0.01
#: Share of a log in free fall from which its median says nothing of gravity (chosen).
MUCH = 0.1
#: A unit is read off a median that samples share: as a direction, and within 30 % (chosen).
COHERENT, ALIKE, WIDTH = 0.5, 0.25, 0.3


def falling_samples(values: Array) -> Flags:
    """True where a specific force is that of a free fall, shape (samples, 3) to (samples,)."""
    with np.errstate(invalid="ignore"):
        return np.asarray(np.linalg.norm(values, axis=1) < FALLING * GRAVITY, dtype=bool)


def falls_freely(values: Array) -> bool:
    """True if part of a log of specific forces is a free fall, and part is not."""
    with np.errstate(invalid="ignore"):
        size = np.linalg.norm(values, axis=1)
        return bool((size < FALLING * GRAVITY).mean() > MUCH and np.nanmax(size) > GRAVITY)


def has_steady_size(values: Array) -> bool:
    """True if the median magnitude is that of many samples, which share a direction.

    The median of a log that falls and hits is the magnitude of hardly any sample, or of noise.
    """
    size = np.linalg.norm(values, axis=1)
    middle = float(np.nanmedian(size))
    if not middle > 0.0:
        return False
    along = float(np.linalg.norm(np.nanmedian(values, axis=0)))
    with np.errstate(invalid="ignore"):
        alike = float((np.abs(size / middle - 1.0) < WIDTH).mean())
    return along > COHERENT * middle and alike > ALIKE


def begin_of_fall(channel: LogChannel, touch: float) -> float | None:
    """Instant from which a vehicle falls until a touch; None if it does not, by its accelerometer.

    Args:
        channel: Specific force.
        touch: On its clock [s].

    Returns:
        The first instant of the log if it begins in the fall.
    """
    before = (channel.times < touch - CLEAR) & ~channel.is_lost
    times, size = channel.times[before], np.linalg.norm(channel.values[before], axis=1)
    last = size[times >= touch - CLEAR - LAST]
    if not len(last) or np.median(last) > FALLING * GRAVITY:
        return None
    held = np.flatnonzero(size > HELD * GRAVITY)
    return float(times[held[-1]]) + CLEAR if len(held) else float(times[0])

"""State of a vehicle as it touches, by what the log measured: what an impact begins with."""

from __future__ import annotations

import numpy as np

from springback.logs.recording import LogChannel

#: Time before touch over which a speed is taken, and its distance from touch [s] (chosen).
BEFORE, CLEAR = 0.15, 5e-3
#: Fewest samples of a track in it (chosen).
FEWEST = 5
#: Time after release in which an arm may still go on [s] (chosen).
LATER = 0.02
Triple = tuple[float, float, float]


def velocity_before(track: LogChannel, touch: float) -> Triple | None:
    """Velocity at touch, world axes [m/s], by a parabola through the track before it.

    None if too few frames are there; a line if they are less than twice as many as needed.

    Args:
        track: Positions.
        touch: On its clock [s].
    """
    known = ~track.is_lost & (track.times >= touch - BEFORE) & (track.times < touch - CLEAR)
    if known.sum() < FEWEST:
        return None
    degree = 2 if known.sum() >= 2 * FEWEST else 1
    fit = np.polynomial.polynomial.polyfit(track.times[known] - touch, track.values[known], degree)
    x, y, z = (float(part) for part in fit[1])
    return x, y, z


def most_pressed(arms: LogChannel, touch: float, release: float) -> tuple[int, float] | None:
    """Column that is pressed most in a contact, counted from 1, and by how much [m].

    Args:
        arms: Lengths of all arms.
        touch: On their clock [s].
        release: Likewise.
    """
    before = (arms.times >= touch - BEFORE) & (arms.times < touch - CLEAR)
    inside = (arms.times >= touch - CLEAR) & (arms.times <= release + LATER)
    before, inside = before & ~arms.is_lost, inside & ~arms.is_lost
    if not before.any() or not inside.any():
        return None
    pressed = np.median(arms.values[before], axis=0) - arms.values[inside].min(axis=0)
    k = int(np.argmax(pressed))
    return k + 1, float(pressed[k])

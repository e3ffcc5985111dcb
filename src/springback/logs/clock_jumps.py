"""Clocks that jump ahead: a gap in the stamps of a channel in which no time has passed.

Lost samples leave a gap, too, but the motion goes on meanwhile.  After a jump a track goes on from
where it was, and its turns are those that a gyroscope had before the gap's end.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from springback.errors import InputError
from springback.logs.clocks import Gap, attitude_rates, clock_offset, timing
from springback.logs.recording import ANGULAR_VELOCITY, ATTITUDE, POSITION, LogChannel, Recording

#: Shortest jump that is sought [s], and most gaps of a channel that are looked at (chosen).
SHORTEST, MOST = 0.1, 20
#: Samples on either side of a gap from which a speed is taken, and the least that tells [m/s]
#: (chosen).
BESIDE, FEWEST, SLOWEST = 15, 5, 0.3
#: Largest change of the speed over a jump, as a share; and largest way from where it would go on,
#: in steps and in metres (chosen: a vehicle that went on would have gone many steps).
CHANGED, STEPS, APART = 0.1, 2.0, 0.005
#: Turns tell an offset from this correlation and this rate of turn [rad/s], and a jump if both
#: sides differ by the gap to this time [s] (chosen).
AGREED, TURNING, SAME = 0.9, 0.15, 0.02


class ClockJump(NamedTuple):
    """A clock that jumped ahead."""

    log: str
    channel: str
    at: float  # by its clock, before the jump [s]
    seconds: float
    sentence: str


def clock_jumps(recordings: Sequence[Recording]) -> list[ClockJump]:
    """Jumps of the clocks of tracks and gyroscopes, the first of each clock."""
    gyros = [(one, channel) for one in recordings for channel in one.of(ANGULAR_VELOCITY)]
    gyro = max(gyros, key=lambda pair: pair[1].rate, default=None)
    found: dict[tuple[str, str], ClockJump] = {}
    for one in recordings:
        for channel in (*one.of(POSITION), *one.of(ATTITUDE), *one.of(ANGULAR_VELOCITY)):
            key = (str(one.path), channel.clock)
            if key in found or channel.chain.estimated:
                continue
            usual = 1.0 / channel.rate if channel.rate else np.inf
            for gap in timing(channel).gaps[:MOST]:
                if gap.duration < SHORTEST + usual:
                    break
                why = _why(channel, gap, None if gyro is None else gyro[1], recordings)
                if why:
                    seconds = gap.duration - usual
                    said = f"its clock jumps ahead by {1e3 * seconds:.0f} ms at {gap.start:.3f} s"
                    jump = ClockJump(*key[:1], channel.name, gap.start, seconds, f"{said}: {why}")
                    found[key] = jump
                    break
    return list(found.values())


def refuse_clock_jumps(recordings: Sequence[Recording]) -> None:
    """Refuse logs of a clock that jumps: what is after it cannot be aligned with what is before.

    Args:
        recordings: Logs of one flight.

    Raises:
        InputError: In one line for each clock.
    """
    problems = [
        f"{one.log}: {one.channel}: {one.sentence}; read the part before or after it (--from, "
        "--until; first, last in a plan)"
        for one in clock_jumps(recordings)
    ]
    if problems:
        raise InputError(*problems)


def _why(
    channel: LogChannel, gap: Gap, gyro: LogChannel | None, recordings: Sequence[Recording]
) -> str:
    """Why a gap is a jump; empty if it is none, or if it cannot be told."""
    if channel.quantity == POSITION:
        return _goes_on(channel, gap)
    if channel.quantity == ATTITUDE:
        return "" if gyro is None else _turns_on(channel, gyro, gap, channel)
    attitude = next(
        (one for log in recordings for one in log.of(ATTITUDE)
         if not one.chain.estimated and one.name not in log.others and one.clock != channel.clock),
        None,
    )  # fmt: skip
    return "" if attitude is None else _turns_on(attitude, channel, gap, channel)


def _goes_on(track: LogChannel, gap: Gap) -> str:
    """That a track goes on from where it was."""
    known = ~track.is_lost
    times, values = track.times[known], track.values[known]
    k = int(np.searchsorted(times, gap.start + 1e-9))
    before, after = slice(max(k - BESIDE, 0), k), slice(k, k + BESIDE)
    usual = 1.0 / track.rate
    lines = []
    for side in (before, after):
        t = times[side]
        if len(t) < FEWEST or t[-1] - t[0] > 2.0 * BESIDE * usual:
            return ""
        lines.append(np.polynomial.polynomial.polyfit(t - t.mean(), values[side], 1)[1])
    velocity = 0.5 * (lines[0] + lines[1])
    speed = float(np.linalg.norm(velocity))
    if speed < SLOWEST or np.linalg.norm(lines[1] - lines[0]) > CHANGED * speed:
        return ""
    moved = values[k] - values[k - 1]
    apart = float(np.linalg.norm(moved - velocity * usual))
    if apart > APART + STEPS * speed * usual or np.linalg.norm(moved) > 0.25 * speed * gap.duration:
        return ""
    way = 1e3 * float(np.linalg.norm(moved))
    return f"it flies on at {speed:.2g} m/s, but only {way:.0f} mm from where it was before the gap"


def _turns_on(attitude: LogChannel, gyro: LogChannel, gap: Gap, gapped: LogChannel) -> str:
    """That turns of both sides of a gap are of clocks that differ by it."""
    offsets = []
    for side in (gapped.times <= gap.start, gapped.times > gap.start):
        clipped = None if gapped.clipped is None else gapped.clipped[side]
        part = replace(
            gapped, times=gapped.times[side], values=gapped.values[side], clipped=clipped,
            resets=None,
        )  # fmt: skip
        pair = (part, gyro) if gapped is attitude else (attitude, part)
        rates = attitude_rates(pair[0]).values
        if len(rates) < 2 * BESIDE or np.sqrt(np.nanmean((rates**2).sum(axis=1))) < TURNING:
            return ""
        found = clock_offset(*pair)
        if found.correlation < AGREED:
            return ""
        offsets.append(found.seconds)
    usual = 1.0 / gapped.rate
    step = (offsets[1] - offsets[0]) * (-1.0 if gapped is attitude else 1.0)
    if abs(step - (gap.duration - usual)) > SAME:
        return ""
    other = gyro.name if gapped is attitude else attitude.name
    return f"against the turns of {other} it is {1e3 * step:.0f} ms later than before the gap"

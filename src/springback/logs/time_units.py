"""Units of time that are mistaken: clocks that run a thousand or a million times too fast or slow.

No sensor has a sample a second, and none a million.  Where a channel's rate is beyond what sensors
have, and another unit of its times makes it usual, that unit is the true one if the data agree with
it: rates of turn with those of a gyroscope, the way of a track with its velocity, or the length of
the log with that of another channel.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from springback.errors import InputError
from springback.logs.clocks import Integral, attitude_rates
from springback.logs.frame_check import AGREED, STILL_RATE, UNIT_WIDTH, offset_of
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ARM_LENGTH,
    ATTITUDE,
    MARKERS,
    POSITION,
    SPECIFIC_FORCE,
    VELOCITY,
    LogChannel,
    Recording,
)
from springback.units import read_number

#: Rates that no sensor nor motion capture is below or above, and those that are usual [Hz] (chosen;
#: their ratio is below 1000, so that one unit of time at most makes a rate usual).
SLOWEST, FASTEST, USUAL = 10.0, 4e4, (20.0, 1e4)
#: How many times too long times are that are read in another unit.
FACTORS = (1e3, 1e6, 1e9, 1e-3, 1e-6, 1e-9)
#: Units of time by their seconds.
TIME_UNITS = {1.0: "s", 1e-3: "ms", 1e-6: "us", 1e-9: "ns"}
#: Fewest samples that tell a rate, and the ratio up to which two channels last as long (chosen).
FEWEST, AS_LONG = 10, 2.0
#: Words of the reason that counts least.
LASTS = "it lasts"
#: What has a usual rate.
_SAMPLED = (
    SPECIFIC_FORCE, ANGULAR_VELOCITY, POSITION, VELOCITY, ATTITUDE, MARKERS, ARM_LENGTH,
)  # fmt: skip
#: End of the name of a log's parameter that tells in which unit times were read.
UNIT_KEY = ".time_unit"


class _Clocked(NamedTuple):
    """A channel whose times are in another unit than they were read in, if the data agree."""

    log: int
    channel: LogChannel
    factor: float


def time_factor(channel: LogChannel) -> float:
    """How many times too long a channel's times are, by its rate alone; 1 if it is usual.

    Args:
        channel: Of any quantity.
    """
    count, (first, last) = len(channel.times), channel.span
    if channel.quantity not in _SAMPLED or count < FEWEST or not last > first:
        return 1.0
    rates = channel.rate, (count - 1) / (last - first)
    if not (max(rates) < SLOWEST or min(rates) > FASTEST):
        return 1.0
    usual = (one for one in FACTORS if USUAL[0] <= channel.rate * one <= USUAL[1])
    return next(usual, 1.0)


def refuse_time_units(recordings: Sequence[Recording]) -> None:
    """Refuse logs whose times are in another unit than they were read in.

    Args:
        recordings: Logs of one flight.

    Raises:
        InputError: In one line for each log and unit, with the unit that it seems to be.
    """
    wrong = [
        _Clocked(k, channel, factor)
        for k, one in enumerate(recordings) for channel in one.channels
        if (factor := time_factor(channel)) != 1.0
    ]  # fmt: skip
    if not wrong:
        return
    factors = {id(one.channel): one.factor for one in wrong}
    with np.errstate(all="ignore"):
        reasons = _reasons(recordings, [_in_other_units(one, factors) for one in recordings])
    groups: dict[tuple[int, float, str], list[_Clocked]] = {}
    for one in wrong:
        unit = str(recordings[one.log].parameters.get(one.channel.name + UNIT_KEY, ""))
        groups.setdefault((one.log, one.factor, unit), []).append(one)
    problems = []
    for (log, factor, unit), group in groups.items():
        names = [one.channel.name for one in group]
        known = [reasons[log, name] for name in names if (log, name) in reasons]
        # Nothing has a million samples a second; what has one may be a slow log of another kind.
        if known or factor < 1.0:
            problems.append(f"{recordings[log].path}: {_sentence(group, factor, unit, known)}")
    if problems:
        raise InputError(*problems)


def _sentence(group: Sequence[_Clocked], factor: float, unit: str, known: Sequence[str]) -> str:
    """What is said of channels with the same mistake."""
    names = ", ".join(one.channel.name for one in group)
    rates = {one.channel.rate for one in group}
    are = "their times are" if len(group) > 1 else "its times are"
    size = read_number(f"1 {unit}", "s") / factor if unit else 0.0
    near = (name for one, name in TIME_UNITS.items() if abs(size / one - 1.0) < 1e-6)
    true = next(near, "")
    way = f"{factor:g} times too long" if factor > 1.0 else f"{1.0 / factor:g} times too short"
    said = f"{are} probably in {true}, not in {unit}" if true else f"{are} probably {way}"
    reason = f"; so {min(known, key=lambda text: LASTS in text)}" if known else ""
    return (
        f"{names}: {said}: {_rates_text(rates)} would be "
        f"{_rates_text({one * factor for one in rates})}{reason}"
    )


def _rates_text(rates: set[float]) -> str:
    """Rates of channels, such as ``0.2 and 1 Hz``."""
    texts = (f"{one:.3g}" if one < 999.0 else f"{one:.0f}" for one in sorted(rates))
    return f"{' and '.join(dict.fromkeys(texts))} Hz"


def _in_other_units(one: Recording, factors: Mapping[int, float]) -> Recording:
    """A recording with the times that the usual rates would have."""
    return replace(one, channels=tuple(
        replace(channel, times=channel.times / factors.get(id(channel), 1.0))
        for channel in one.channels
    ))  # fmt: skip


def _reasons(read: Sequence[Recording], mended: Sequence[Recording]) -> dict[tuple[int, str], str]:
    """What agrees once times are in other units, by the log and name of each channel that shows it.

    Args:
        read: Logs as they were read.
        mended: With other units.
    """
    found: dict[tuple[int, str], str] = {}
    gyros = [(k, one, channel) for k, one in enumerate(mended)
             for channel in one.of(ANGULAR_VELOCITY)]  # fmt: skip
    for k, one in enumerate(mended):
        for attitude in one.of(ATTITUDE):
            for log, home, gyro in gyros:
                if said := _turns_agree(one, attitude, home, gyro):
                    found.setdefault((k, attitude.name), said)
                    found.setdefault((log, gyro.name), said)
        for position in one.of(POSITION):
            for velocity in one.of(VELOCITY):
                if said := _way_agrees(position, velocity):
                    found.setdefault((k, position.name), said)
                    found.setdefault((k, velocity.name), said)
    usual = [channel for one in read for channel in one.channels
             if channel.quantity in _SAMPLED and len(channel.times) >= FEWEST
             and SLOWEST <= channel.rate <= FASTEST]  # fmt: skip
    for k, one in enumerate(mended):
        for channel in one.channels:
            for other in usual:
                long, as_long = (np.ptp(each.times) for each in (channel, other))
                if 1.0 / AS_LONG < long / max(as_long, 1e-12) < AS_LONG:
                    said = f"{LASTS} {long:.3g} s, as {other.name} does"
                    found.setdefault((k, channel.name), said)
    return found


def _turns_agree(one: Recording, attitude: LogChannel, home: Recording, gyro: LogChannel) -> str:
    """That rates of turn agree in their magnitudes, which no mistake of axes changes."""
    offset = offset_of(one, attitude, (home, gyro))
    if offset.correlation < AGREED:
        return ""
    rates = attitude_rates(attitude)
    at = offset.seconds
    means, whole = Integral(gyro).means(rates.begins + at, rates.ends + at)
    turned, felt = (
        np.sqrt((each[whole] ** 2).sum(axis=1).mean()) for each in (rates.values, means)
    )
    if not felt > STILL_RATE or not 1.0 / UNIT_WIDTH < turned / felt < UNIT_WIDTH:
        return ""
    return f"rates of turn of {attitude.name} and {gyro.name} agree ({offset.correlation:.3f})"


def _way_agrees(position: LogChannel, velocity: LogChannel) -> str:
    """That a track goes as fast as a velocity on its clock says."""
    if position.clock != velocity.clock:
        return ""
    way = np.diff(position.values, axis=0) / np.diff(position.times)[:, None]
    went, told = (
        float(np.nanmedian(np.linalg.norm(each, axis=1))) for each in (way, velocity.values)
    )
    if not told > 0.0 or not 1.0 / UNIT_WIDTH < went / told < UNIT_WIDTH:
        return ""
    return f"{position.name} moves at {went:.3g} m/s, as {velocity.name} says"

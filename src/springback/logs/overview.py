"""What is in logs, and what is missing for an impact to be seen and fitted."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.logs.clock_jumps import clock_jumps
from springback.logs.clocks import timing
from springback.logs.filter_check import untold_filter
from springback.logs.frame_check import FrameFinding, check_frames, refuse_units
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ATTITUDE,
    POSITION,
    QUANTITIES,
    ROTOR_COMMAND,
    ROTOR_SPEED,
    SPECIFIC_FORCE,
    VELOCITY,
    LogChannel,
    Recording,
)
from springback.logs.segments import CONTACT, NEEDED, LogImpact, find_impacts, has_drops
from springback.logs.time_units import refuse_time_units, time_factor

#: TurnRates that are wanted [Hz] (chosen): of poses, rates of turn and rotors.
POSE_RATE, GYRO_RATE, ROTOR_RATE = 100.0, 100.0, 50.0
#: A vehicle that never turns faster nor deviates more from its median never moved (chosen).
STILL_RATE, STILL_FORCE = 0.3, 2.0
#: The same of a measured track [m], and of a velocity, which an autopilot may estimate [m/s].
STILL_WAY, STILL_SPEED = 0.1, 0.5
#: A low-pass below this hides a contact [Hz] (chosen).
SLOWEST_FILTER = 100.0
#: Profile of PX4's logger with high rates, vision and all samples of the accelerometer.
PROFILE = "SDLOG_PROFILE = 665"


class ChannelLine(NamedTuple):
    """What a channel has."""

    log: str
    name: str
    quantity: str
    unit: str
    clock: str
    samples: int
    first: float  # [s]
    last: float  # [s]
    rate: float  # [Hz], between gaps
    gaps: int
    longest_gap: float  # [s]; 0 without gaps
    gap_start: float | None  # [s]
    clipped: int | None  # samples; None: the log does not tell
    lost: int  # samples
    resets: int
    chain: str  # of the sensor, in words


class Overview(NamedTuple):
    """What is in logs."""

    logs: tuple[str, ...]  # path, format, span, in words
    channels: tuple[ChannelLine, ...]
    findings: tuple[FrameFinding, ...]
    missing: tuple[str, ...]
    remarks: tuple[str, ...]
    impacts: tuple[LogImpact, ...]
    verdict: str


def overview(recordings: Sequence[Recording]) -> Overview:
    """Overview of logs of the same flight.

    Raises:
        InputError: If the unit of a channel is plainly another one.
    """
    with np.errstate(all="ignore"):
        return _overview(recordings)


def _overview(recordings: Sequence[Recording]) -> Overview:
    refuse_time_units(recordings)
    for one in recordings:
        refuse_units(one)
    impacts = find_impacts(recordings)
    lines = [_line(one, channel) for one in recordings for channel in one.channels]
    remarks = damages(recordings)
    remarks += [f"{one.path.name}: {text}" for one in recordings for text in one.remarks]
    remarks += [text for one in recordings for text in (*_losses(one), *_disorder(one))]
    remarks += [
        f"{channel.name}: its times are those of arrival over a link, not of the samples"
        for one in recordings for channel in one.channels if timing(channel).has_arrivals
    ]  # fmt: skip
    return Overview(
        tuple(_log_words(one) for one in recordings),
        tuple(lines),
        (*check_frames(recordings), *_jump_findings(recordings)),
        tuple(missing_for_impact(recordings)),
        tuple(remarks),
        tuple(impacts),
        verdict(recordings, impacts),
    )


def damages(recordings: Sequence[Recording]) -> list[str]:
    """What of logs is cut off or damaged, a sentence each."""
    return [f"{one.path.name}: {text}" for one in recordings for text in one.damage]


def _jump_findings(recordings: Sequence[Recording]) -> list[FrameFinding]:
    return [FrameFinding(one.channel, False, one.sentence) for one in clock_jumps(recordings)]


def _log_words(one: Recording) -> str:
    spans = [channel.span for channel in one.channels if len(channel.times) > 1]
    first = min((span[0] for span in spans), default=0.0)
    last = max((span[1] for span in spans), default=0.0)
    return f"{one.path}: {one.format}, {last - first:.2f} s, from {first:.3f} to {last:.3f} s"


def _losses(one: Recording) -> list[str]:
    """What a logger noted of its own losses, in a sentence."""
    if not one.dropouts:
        return []
    at, longest = max(one.dropouts, key=lambda entry: entry[1])
    many = f"{len(one.dropouts)} losses, the longest" if len(one.dropouts) > 1 else "a loss"
    return [f"{one.path.name}: its logger noted {many} of {1e3 * longest:.0f} ms at {at:.3f} s"]


def _disorder(one: Recording) -> list[str]:
    """Samples that were not in the order of their times, in a sentence for each channel."""
    found = []
    for channel in one.channels:
        count, latest = channel.disorder
        if count:
            what = "1 sample comes" if count == 1 else f"{count} samples come"
            found.append(
                f"{one.path.name}: {channel.name}: {what} after a later one, by up to "
                f"{1e3 * latest:.3g} ms; sorted by their times"
            )
    return found


def _line(one: Recording, channel: LogChannel) -> ChannelLine:
    told, gap = timing(channel), None
    gap = told.longest
    return ChannelLine(
        str(one.path), channel.name, channel.quantity, QUANTITIES[channel.quantity].unit,
        channel.clock, len(channel.times), *channel.span, told.rate, len(told.gaps),
        gap.duration if gap else 0.0, gap.start if gap else None,
        None if channel.clipped is None else int(channel.clipped.any(axis=1).sum()),
        int(channel.is_lost.sum()),
        0 if channel.resets is None else int(channel.resets.sum()),
        chain_words(channel),
    )  # fmt: skip


def chain_words(channel: LogChannel) -> str:
    """What stands between the motion and the numbers, in words."""
    chain, unit = channel.chain, QUANTITIES[channel.quantity].unit
    words = []
    if chain.estimated:
        words.append("an estimate")
    if chain.smoothed:
        words.append("may be smoothed")
    if chain.average is not None:
        words.append(f"mean over {1e3 * chain.average:.2f} ms")
    if chain.low_pass is not None:
        words.append(f"low-pass {chain.low_pass:g} Hz")
    if chain.full_scale is not None:
        words.append(f"range {chain.full_scale:.4g} {unit}".rstrip())
    if chain.note:
        words.append(chain.note)
    return ", ".join(words)


# -- what is missing ------------------------------------------------------------------------------


def _measured(recordings: Sequence[Recording], quantity: str) -> list[LogChannel]:
    found = [c for one in recordings for c in one.of(quantity) if not c.chain.estimated]
    return sorted(found, key=lambda c: -c.rate)


def resolution(channel: LogChannel) -> int:
    """Samples of a channel in the shortest contact that is meant."""
    return int(CONTACT * channel.rate)


def missing_for_impact(recordings: Sequence[Recording]) -> list[str]:
    """What logs lack for an impact to be fitted, a sentence each."""
    found = []
    is_px = any(one.format == "ULog" for one in recordings)
    hint = f" ({PROFILE} logs all samples)" if is_px else ""
    forces = _measured(recordings, SPECIFIC_FORCE)
    if not forces:
        found.append(f"no accelerometer{hint}")
    else:
        best = forces[0]
        count = resolution(best)
        if count < NEEDED:
            factor = time_factor(best)
            other = (
                f" (or its times are in another unit: {factor:g} times shorter they have "
                f"{factor * best.rate:.4g} Hz)" if factor != 1.0 else ""
            )  # fmt: skip
            found.append(
                f"the fastest acceleration, {best.name}, has {best.rate:.3g} Hz: {count} samples "
                f"in a contact of {1e3 * CONTACT:.0f} ms; {NEEDED} are needed{hint}{other}"
            )
        if best.chain.average is not None and best.chain.average > CONTACT / NEEDED:
            found.append(
                f"{best.name} is a mean over {1e3 * best.chain.average:.2f} ms, which flattens "
                f"the peak{hint}"
            )
        if best.chain.low_pass is not None and best.chain.low_pass < SLOWEST_FILTER:
            found.append(f"{best.name} is behind a low-pass of {best.chain.low_pass:g} Hz")
        found += [hint for hint in [untold_filter(best)] if hint]
        if best.clipped is None and best.chain.full_scale is None:
            found.append(f"{best.name} tells neither its range nor its clipping")
    for quantity, rate, what in (
        (ANGULAR_VELOCITY, GYRO_RATE, "rates of turn"),
        (POSITION, POSE_RATE, "measured positions, such as those of a motion capture"),
        (ATTITUDE, POSE_RATE, "measured attitudes, such as those of a motion capture"),
    ):
        channels = _measured(recordings, quantity)
        if not channels:
            found.append(f"no {what}")
        elif channels[0].rate < rate:
            found.append(f"{channels[0].name} has {channels[0].rate:.0f} Hz; {rate:g} are wanted")
    rotors = [*_measured(recordings, ROTOR_SPEED), *_measured(recordings, ROTOR_COMMAND)]
    rotors.sort(key=lambda c: -c.rate)
    if not rotors:
        found.append("no speeds nor commands of the rotors")
    elif rotors[0].rate < ROTOR_RATE:
        found.append(f"{rotors[0].name} has {rotors[0].rate:.0f} Hz; {ROTOR_RATE:g} are wanted")
    return found


def blind_spots(recordings: Sequence[Recording]) -> list[str]:
    """Why an impact could be in no part, or in some part, of the logs without being seen."""
    found = []
    forces = _measured(recordings, SPECIFIC_FORCE)
    tracks = [c for c in _measured(recordings, POSITION) if c.rate >= POSE_RATE]
    moving = [*forces[:1], *tracks[:1]]
    if not moving:
        found.append("it has neither an accelerometer nor a measured track of 100 Hz")
    elif not tracks and resolution(forces[0]) < NEEDED:
        best = forces[0]
        mean = best.chain.average
        found.append(
            f"{best.name} has {best.rate:.0f} Hz"
            + (f", each sample a mean over {1e3 * mean:.2f} ms" if mean else "")
            + f": {resolution(best)} samples in a contact of {1e3 * CONTACT:.0f} ms"
        )
    for channel in forces[:1]:
        gap = timing(channel).longest
        if gap is not None and gap.duration > CONTACT:
            times = int(gap.duration / CONTACT)
            often = {1: "once", 2: "twice"}.get(times, f"{times} times")
            found.append(
                f"{channel.name} has a gap of {1e3 * gap.duration:.0f} ms at {gap.start:.3f} s, "
                f"into which a contact of {1e3 * CONTACT:.0f} ms fits {often}"
            )
    if never_moved(recordings):
        found.append("the vehicle rests from begin to end")
    return found


def never_moved(recordings: Sequence[Recording]) -> bool:
    """True if no sensor ever left its median by much, and no track nor velocity tells of motion."""
    seen = False
    for one in recordings:
        for channel in (*one.of(POSITION), *one.of(VELOCITY)):
            if channel.is_lost.all() or channel.name in one.others:
                continue
            speeds = channel.quantity == VELOCITY
            if speeds and np.nanmax(np.linalg.norm(channel.values, axis=1)) > STILL_SPEED:
                return False
            is_measured = not speeds and not channel.chain.estimated
            if is_measured and np.nanmax(np.ptp(channel.values[~channel.is_lost], 0)) > STILL_WAY:
                return False
    for quantity, limit in ((SPECIFIC_FORCE, STILL_FORCE), (ANGULAR_VELOCITY, STILL_RATE)):
        for channel in _measured(recordings, quantity):
            if len(channel.times) < 20:
                continue
            seen = True
            off = np.abs(channel.values - np.nanmedian(channel.values, axis=0))
            if not np.nanmax(off) < limit:
                return False
    return seen


def verdict(recordings: Sequence[Recording], impacts: Sequence[LogImpact]) -> str:
    """The answer in one sentence."""
    usable = [one for one in impacts if not one.refused]
    if usable:
        more = len(impacts) - len(usable)
        also = f", and {more} that {'are' if more > 1 else 'is'} refused" if more else ""
        return f"{len(usable)} impact{'s' if len(usable) > 1 else ''}{also}"
    drop = ""
    if has_drops(impacts, recordings):
        drop = '; if this is a drop test, experiment = "drop" in a plan takes it'
    if impacts:
        why = impacts[0].refused
        many = f"{len(impacts)} impacts, all refused" if len(impacts) > 1 else "one impact, refused"
        return f"{many}: {why}{drop}"
    if drop:
        return f"no impact from the side, but from above{drop}"
    lost = "".join(f"; {text}" for text in damages(recordings))
    if blind := blind_spots(recordings):
        return f"no impact, and this log could not have shown one: {'; '.join(blind)}{lost}"
    return f"no impact{lost}"


def as_data(found: Overview) -> dict[str, Any]:
    """An overview as plain data; numbers that are not known are None."""

    def plain(value: Any) -> Any:
        if isinstance(value, float) and not np.isfinite(value):
            return None
        return list(value) if isinstance(value, tuple) else value

    def rows(entries: Sequence[Any]) -> list[dict[str, Any]]:
        return [{k: plain(v) for k, v in one._asdict().items()} for one in entries]

    return {
        "verdict": found.verdict,
        "logs": list(found.logs),
        "channels": rows(found.channels),
        "findings": rows(found.findings),
        "missing": list(found.missing),
        "remarks": list(found.remarks),
        "impacts": rows(found.impacts),
    }

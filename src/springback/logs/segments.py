"""Impacts in recordings: found, or refused with the reason."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.frames import euler_from_attitude
from springback.logs.clocks import Offset, timing
from springback.logs.frame_check import (
    bends,
    interpolated_attitudes,
    offset_of,
    world_force,
)
from springback.logs.frame_turns import world_vectors
from springback.logs.free_fall import GRAVITY, begin_of_fall
from springback.logs.impact_state import most_pressed, velocity_before
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ARM_LENGTH,
    ATTITUDE,
    POSITION,
    ROTOR_COMMAND,
    ROTOR_SPEED,
    SPECIFIC_FORCE,
    Array,
    LogChannel,
    Recording,
    refuse_several_flights,
)

#: Contact of the paper's rigid vehicle at a wall [s] (its Table III): the shortest that is meant.
CONTACT = 0.031
#: Samples of the accelerometer in a contact that a fit needs (chosen).
NEEDED = 10
#: Horizontal specific force [m/s²], its multiple of the median deviation, compression of an arm
#: [m]: what is taken for an impact (chosen).
FORCE, DEVIATIONS, COMPRESSION = 15.0, 8.0, 5e-4
#: The contact lasts while the horizontal specific force is above this share of its peak (chosen).
SHARE = 0.05
#: Evidence closer together than this is one impact [s] (chosen).
DWELL = 0.08
#: Drops: the vehicle falls below this specific force [m/s²], contacts further apart than this [s]
#: are two, and a touch within this time [s] of an impact is its bounce unless its peak is so many
#: times as high (chosen; the last leaves the jerk of a release alone).
AIRBORNE, APART, BOUNCE, HIGHER = 3.0, 0.02, 1.0, 3.0
#: Specific force of a vehicle that lies on the ground, at most [m/s²] (chosen).
LYING = 12.0
#: Part of a log that belongs to an impact: before touch, after it, and in contact times (chosen).
BEFORE, AFTER, TIMES_AFTER = 0.3, 0.25, 3.0
#: Correlation from which two clocks count as aligned, and slowest track that is used [Hz].
ALIGNED, SLOWEST_TRACK = 0.9, 30.0
#: Share of lost frames around an impact that is too much, and distance of another body [m].
MOST_LOST, NEAR = 0.3, 0.5
#: Vertical part of a normal from which it is a landing (chosen).
LANDING = 0.8


#: Evidence that is the most precise of touch and release.
FELT = "specific force"
#: Why an impact from above is no impact of a flight.
LANDING_WORDS = "its normal points up: a landing"


class LogImpact(NamedTuple):
    """An impact found in recordings; times are those of its channel's clock."""

    log: str
    channel: str
    touch: float  # [s]
    release: float  # [s]
    window: tuple[float, float]  # [s], what belongs to it
    evidence: tuple[str, ...]
    peak: float  # largest horizontal specific force [m/s²]; NaN without accelerometer
    clipped: int  # samples of the accelerometer at the end of its range
    samples: int  # of its channel in the contact
    velocity_change: tuple[float, float, float] | None  # world [m/s]
    normal: tuple[float, float, float] | None  # of the obstacle, world, towards the vehicle
    refused: str  # why it cannot be used; empty if it can
    velocity: tuple[float, float, float] | None = None  # just before touch, world [m/s]
    attitude: tuple[float, float, float] | None = None  # at touch: roll, pitch, yaw [rad]
    pressed: tuple[int, float] | None = None  # column of the arm pressed most, and by what [m]
    is_drop: bool = False  # found as that of a drop test
    following: float | None = None  # touch of the bounce after that of a drop [s]


class _Candidate(NamedTuple):
    touch: float  # on the clock of the accelerometer, if there is one
    release: float
    source: str


class _Sources(NamedTuple):
    """Channels that tell of impacts, and the offsets to the accelerometer's clock."""

    accelerometer: tuple[Recording, LogChannel] | None
    attitude: LogChannel | None
    attitude_offset: float
    tracks: list[tuple[Recording, LogChannel, float]]
    arms: list[tuple[Recording, LogChannel]]
    drops: bool  # impacts from above count, too


def find_impacts(recordings: Sequence[Recording], *, drops: bool = False) -> list[LogImpact]:
    """Impacts in logs of the same flight, in order of their times.

    Evidence: a horizontal specific force above 15 m/s² and 8 median deviations, samples at the end
    of the accelerometer's range, an arm pressed by 0.5 mm, a bend of a measured track.

    Args:
        recordings: Logs of one flight.
        drops: True for drop tests: the whole specific force counts, and normals that point up;
            bounces are refused.
    """
    refuse_several_flights(recordings)
    sources = _sources(recordings)._replace(drops=drops)
    candidates: list[_Candidate] = []
    if sources.accelerometer is not None:
        candidates += _by_force(sources)
    for _, channel in sources.arms:
        candidates += _by_arms(channel)
    for log, channel, offset in sources.tracks:
        if channel.name in log.others:
            continue
        candidates += _by_track(channel, offset, drops)
    merged = _merged_drops(candidates) if drops else _merged(candidates)
    found = [_described(one, names, sources, recordings) for one, names in merged]
    return _without_bounces(found) if drops else found


def has_drops(found: Sequence[LogImpact], recordings: Sequence[Recording]) -> bool:
    """True if the impacts in logs are landings to a flight, and one is that of a drop test.

    Without any, one from above counts if the vehicle fell freely before it.

    Args:
        found: Impacts in them, as those of a flight.
        recordings: The logs.
    """
    if any(one.refused != LANDING_WORDS for one in found):
        return False
    drops = [one for one in find_impacts(recordings, drops=True) if not one.refused]
    felt = _sources(recordings).accelerometer
    if found or felt is None:
        return bool(found and drops)
    return any(begin_of_fall(felt[1], one.touch) is not None for one in drops)


def _without_bounces(found: Sequence[LogImpact]) -> list[LogImpact]:
    """Impacts of drops: those soon after another are refused, and end what belongs to it."""
    kept: list[LogImpact] = []
    first = 0.0
    for one in found:
        drop = one._replace(is_drop=True)
        last = kept[-1] if kept else None
        if last is not None and one.touch - last.release < BOUNCE:
            kept[-1] = last._replace(following=one.touch)
            if not one.peak > HIGHER * last.peak:
                said = f"a bounce of the impact at {first:.3f} s: a drop's first touch is fitted"
                drop = drop._replace(refused=said)
        first = first if drop.refused else one.touch
        kept.append(drop)
    return kept


def _sources(recordings: Sequence[Recording]) -> _Sources:
    found = [
        (one, channel) for one in recordings for channel in one.of(SPECIFIC_FORCE)
        if len(channel.times) > 20
    ]  # fmt: skip
    best = max(found, key=lambda pair: pair[1].rate, default=None)
    gyros = [(one, channel) for one in recordings for channel in one.of(ANGULAR_VELOCITY)]
    gyro = max(
        (pair for pair in gyros if best is None or pair[0] is best[0]),
        key=lambda pair: pair[1].rate, default=None,
    )  # fmt: skip
    offsets: dict[tuple[int, str], float] = {}
    attitudes: list[tuple[bool, LogChannel, float]] = []
    for one in recordings:
        for channel in one.of(ATTITUDE):
            known = best is not None and one is best[0] and channel.clock == best[1].clock
            offset = 0.0
            if best is not None and not known:
                told = Offset(0.0, 0.0) if gyro is None else offset_of(one, channel, gyro)
                if told.correlation < ALIGNED:
                    continue
                offset = told.seconds
            offsets.setdefault((id(one), channel.clock), offset)
            if channel.name not in one.others:
                attitudes.append((not channel.chain.estimated, channel, offset))
    attitudes.sort(key=lambda entry: -entry[0])
    if best is not None:
        offsets.setdefault((id(best[0]), best[1].clock), 0.0)
    tracks = [
        (one, channel, offsets.get((id(one), channel.clock), 0.0))
        for one in recordings for channel in one.of(POSITION)
        if not channel.chain.estimated and channel.rate > SLOWEST_TRACK
        and (best is None or (id(one), channel.clock) in offsets)
    ]  # fmt: skip
    tracks.sort(key=lambda entry: entry[1].name in entry[0].others)
    arms = [
        (one, channel) for one in recordings for channel in one.of(ARM_LENGTH)
        if best is None or (id(one), channel.clock) in offsets
    ]  # fmt: skip
    _, attitude, offset = attitudes[0] if attitudes else (False, None, 0.0)
    return _Sources(best, attitude, offset, tracks, arms, False)


def _horizontal(sources: _Sources) -> tuple[Array, Array]:
    """Instants and horizontal specific force [m/s²], of drops all of it; or in body axes."""
    assert sources.accelerometer is not None
    channel = sources.accelerometer[1]
    if sources.drops:
        known = ~channel.is_lost
        return channel.times[known], np.linalg.norm(channel.values[known], axis=1)
    if sources.attitude is not None:
        times, force = world_force(sources.attitude, channel, sources.attitude_offset)
        if len(times) > 0.5 * len(channel.times):
            return times, np.linalg.norm(force[:, :2], axis=1)
    known = ~channel.is_lost
    return channel.times[known], np.linalg.norm(channel.values[known, :2], axis=1)


def _runs(times: Array, marked: Any, source: str, dwell: float = DWELL) -> list[_Candidate]:
    """Stretches of marked samples, those within the dwell time as one."""
    places = np.flatnonzero(marked)
    if not len(places):
        return []
    apart = np.flatnonzero(np.diff(times[places]) > dwell)
    firsts = places[np.concatenate([[0], apart + 1])]
    lasts = places[np.concatenate([apart, [len(places) - 1]])]
    return [
        _Candidate(float(times[a]), float(times[b]), source)
        for a, b in zip(firsts, lasts, strict=True)
    ]


def _by_force(sources: _Sources) -> list[_Candidate]:
    assert sources.accelerometer is not None
    channel = sources.accelerometer[1]
    times, size = _horizontal(sources)
    if len(times) < 20:
        return []
    middle = float(np.median(size))
    spread = float(np.median(np.abs(size - middle)))
    limit = max(FORCE, DEVIATIONS * spread)
    found = list[_Candidate]()
    for one in _runs(times, size > limit, FELT, APART if sources.drops else DWELL):
        first, last = np.searchsorted(times, [one.touch, one.release])
        share = SHARE * float(size[first : last + 1].max())
        begin = end = max(share, middle + 3.0 * spread)
        if sources.drops:  # from a fall, onto a ground that it may then lie on
            begin, end = max(share, AIRBORNE), max(share, LYING)
        while first > 0 and size[first - 1] > begin:
            first -= 1
        while last < len(times) - 1 and size[last + 1] > end:
            last += 1
        if found and float(times[first]) <= found[-1].release:  # one grew into the next
            found[-1] = found[-1]._replace(release=float(times[last]))
            continue
        found.append(_Candidate(float(times[first]), float(times[last]), one.source))
    if channel.clipped is not None:
        found += _runs(channel.times, channel.clipped.any(axis=1), "clipping")
    return found


def _by_arms(channel: LogChannel) -> list[_Candidate]:
    free = np.nanmedian(channel.values, axis=0)
    with np.errstate(invalid="ignore"):
        pressed = free - channel.values
        spread = np.nanmedian(np.abs(channel.values - free), axis=0)
        marked = (pressed > np.maximum(COMPRESSION, DEVIATIONS * spread)).any(axis=1)
    return _runs(channel.times, marked, "arm length")


def _by_track(channel: LogChannel, offset: float, drops: bool) -> list[_Candidate]:
    at, _, told = bends(channel)
    if len(at) < 20:
        return []
    size = np.linalg.norm(told if drops else told[:, :2], axis=1)
    spread = float(np.median(np.abs(size - np.median(size))))
    limit = max(FORCE, DEVIATIONS * spread)
    found = []
    for one in _runs(at, size > limit, "bend of the track"):
        inside = (at >= one.touch) & (at <= one.release)
        peak = float(at[inside][int(np.argmax(size[inside]))])
        found.append(_Candidate(peak + offset, peak + offset, one.source))
    return found


def _merged(candidates: list[_Candidate]) -> list[tuple[_Candidate, tuple[str, ...]]]:
    """Candidates within the dwell time as one, with all their evidence."""
    found: list[tuple[_Candidate, list[str], float]] = []
    for one in sorted(candidates):
        if found and one.touch - found[-1][2] <= DWELL:
            before, names, end = found[-1]
            precise = FELT in (before.source, one.source)
            if one.source == FELT and before.source != FELT:
                kept = one
            elif precise and before.source == FELT != one.source:
                kept = before
            else:
                kept = before._replace(release=max(before.release, one.release))
            more = names if one.source in names else [*names, one.source]
            found[-1] = (kept, more, max(end, one.release))
        else:
            found.append((one, [one.source], one.release))
    return [(one, tuple(names)) for one, names, _ in found]


def _merged_drops(
    candidates: list[_Candidate],
) -> list[tuple[_Candidate, tuple[str, ...]]]:
    """Candidates of drops: each contact that is felt is one, and all else is evidence of these."""
    felt = sorted(one for one in candidates if one.source == FELT)
    names = [[FELT] for _ in felt]
    apart = list[_Candidate]()
    for one in candidates:
        if one.source == FELT:
            continue
        near = [
            k for k, each in enumerate(felt)
            if one.touch < each.release + DWELL and one.release > each.touch - DWELL
        ]  # fmt: skip
        if not near:
            apart.append(one)
        elif one.source not in names[near[0]]:
            names[near[0]].append(one.source)
    known = [(one, tuple(words)) for one, words in zip(felt, names, strict=True)]
    return sorted([*known, *_merged(apart)])


def _described(
    one: _Candidate, evidence: tuple[str, ...], sources: _Sources, recordings: Sequence[Recording]
) -> LogImpact:
    """An impact with its numbers, or with the reason why it is refused."""
    contact = max(one.release - one.touch, 1e-3)
    window = (one.touch - BEFORE, one.release + max(TIMES_AFTER * contact, AFTER))
    peak, clipped, samples, change, normal = np.nan, 0, 0, None, None
    if sources.accelerometer is not None:
        log, channel = sources.accelerometer
        times, size = _horizontal(sources)
        inside = (times >= one.touch) & (times <= one.release)
        peak = float(size[inside].max()) if inside.any() else np.nan
        within = (channel.times >= one.touch) & (channel.times <= one.release)
        samples = int(within.sum())
        if channel.clipped is not None:
            clipped = int(channel.clipped[within].any(axis=1).sum())
        change, normal = _velocity_change(one, sources)
    elif sources.tracks:
        log, channel, _ = sources.tracks[0]
        samples = int(((channel.times >= one.touch) & (channel.times <= one.release)).sum())
    else:
        log, channel = sources.arms[0]
        samples = int(((channel.times >= one.touch) & (channel.times <= one.release)).sum())
    refused = _refusal(one, window, samples, normal, channel, sources, recordings)
    return LogImpact(
        str(log.path), channel.name, one.touch, one.release, window, evidence, peak, clipped,
        samples, change, normal, refused, *_state_at_touch(one, sources),
    )  # fmt: skip


def _state_at_touch(
    one: _Candidate, sources: _Sources
) -> tuple[Triple | None, Triple | None, tuple[int, float] | None]:
    """Velocity before touch, attitude at it, and the arm that is pressed most, as far as known."""
    velocity, attitude, pressed = None, None, None
    if sources.tracks:
        _, track, offset = sources.tracks[0]
        velocity = velocity_before(track, one.touch - offset)
    if (turned := sources.attitude) is not None:
        at = one.touch - sources.attitude_offset
        known = turned.times[~turned.is_lost]
        if len(known) and known[0] <= at <= known[-1]:
            angles = euler_from_attitude(interpolated_attitudes(turned, np.array([at]))[0])
            attitude = (float(angles[0]), float(angles[1]), float(angles[2]))
    if sources.arms:
        pressed = most_pressed(sources.arms[0][1], one.touch, one.release)
    return velocity, attitude, pressed


Triple = tuple[float, float, float]


def _velocity_change(one: _Candidate, sources: _Sources) -> tuple[Triple | None, Triple | None]:
    """Change of velocity in the contact, and the normal: the same less thrust and weight."""
    if sources.attitude is None or sources.accelerometer is None:
        return None, None
    channel, offset = sources.accelerometer[1], sources.attitude_offset
    times, force = world_force(sources.attitude, channel, offset)
    step = 1.0 / channel.rate if channel.rate else 0.0
    inside = (times >= one.touch - step) & (times <= one.release + step)
    if inside.sum() < 2:
        return None, None
    at, values = times[inside], force[inside]
    whole = _integral(values - [0.0, 0.0, GRAVITY], at)
    before = (channel.times >= one.touch - 0.06) & (channel.times < one.touch - 0.01)
    thrust = channel.values[before & ~channel.is_lost]
    pushed = whole
    if len(thrust):
        mean = np.asarray(np.median(thrust, axis=0))
        lift = world_vectors(interpolated_attitudes(sources.attitude, at - offset), mean)
        pushed = _integral(values - lift, at)
    size = float(np.linalg.norm(pushed))
    a, b, c = (float(part) for part in whole)
    if size < 1e-6:
        return (a, b, c), None
    x, y, z = (float(part) for part in pushed / size)
    return (a, b, c), (x, y, z)


def _integral(values: Array, at: Array) -> Array:
    """Integral over time by trapezoids, shape (samples, 3) to (3,)."""
    return np.asarray(np.trapezoid(values, at, axis=0))


def _refusal(
    one: _Candidate,
    window: tuple[float, float],
    samples: int,
    normal: Triple | None,
    channel: LogChannel,
    sources: _Sources,
    recordings: Sequence[Recording],
) -> str:
    """Why an impact cannot be used; empty if it can."""
    for gap in timing(channel).gaps:
        if gap.start < one.release + 0.01 and gap.start + gap.duration > one.touch - 0.01:
            return f"a gap of {1e3 * gap.duration:.0f} ms of {channel.name} is in its contact"
    first, last = channel.span
    if window[0] + 0.5 * BEFORE < first or one.release > last - 0.5 * AFTER:
        return (
            f"{channel.name} has {max(one.touch - first, 0.0):.3f} s before it and "
            f"{max(last - one.release, 0.0):.3f} s after it; {0.5 * BEFORE:.3f} s and "
            f"{0.5 * AFTER:.3f} s are needed"
        )
    if sources.accelerometer is not None and samples < NEEDED:
        return (
            f"{channel.name} has {samples} samples in a contact of "
            f"{1e3 * (one.release - one.touch):.0f} ms; {NEEDED} are needed"
        )
    for _, track, offset in sources.tracks:
        near = (track.times >= one.touch - offset - 0.15) & (
            track.times <= one.release - offset + AFTER
        )
        if near.any() and (share := float(track.is_lost[near].mean())) > MOST_LOST:
            return f"{100.0 * share:.0f} % of the frames of {track.name} around it are lost"
    if normal is not None and normal[2] > LANDING and not sources.drops:
        return LANDING_WORDS
    for (_, track, offset), (_, other, _) in _pairs(sources):
        close = _distance(track, other, one.touch - offset)
        if close < NEAR:
            return f"{other.name} is {close:.2f} m away: two bodies"
    return _stopped(one, recordings, sources)


def _pairs(sources: _Sources) -> list[tuple[Any, Any]]:
    """The first track, with every other of the same log."""
    if len(sources.tracks) < 2:
        return []
    first = sources.tracks[0]
    return [
        (first, other) for other in sources.tracks[1:]
        if other[0] is first[0] and other[1].clock == first[1].clock
    ]  # fmt: skip


def _distance(track: LogChannel, other: LogChannel, at: float) -> float:
    """Distance of two bodies at an instant; infinite if one is lost."""
    places = list[Array]()
    for channel in (track, other):
        known = ~channel.is_lost
        t = channel.times[known]
        if len(t) < 2 or not t[0] <= at <= t[-1]:
            return np.inf
        values = channel.values[known].T
        places.append(np.array([np.interp(at, t, one) for one in values]))
    return float(np.linalg.norm(places[0] - places[1]))


def _stopped(one: _Candidate, recordings: Sequence[Recording], sources: _Sources) -> str:
    """That propellers stopped in an impact, if a log tells."""
    home = sources.accelerometer[0] if sources.accelerometer else None
    for recording in recordings:
        if home is not None and recording is not home:
            continue
        for channel in (*recording.of(ROTOR_SPEED), *recording.of(ROTOR_COMMAND)):
            before = (channel.times > one.touch - BEFORE) & (channel.times < one.touch)
            after = (channel.times > one.release) & (channel.times < one.release + AFTER)
            if not before.any() or not after.any():
                continue
            turned = np.nanmedian(np.abs(channel.values[before]), axis=0) > 0.0
            still = (np.nan_to_num(channel.values[after]) == 0.0).all(axis=0)
            if (turned & still).any():
                return f"propellers stopped by it ({channel.name})"
    return ""

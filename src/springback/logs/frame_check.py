"""What the data themselves say of frames and units.

Attitudes must have unit length; at rest and in hover the specific force is +9.8 m/s² along the
body's z, and along the world's once it is turned by the attitude; the rates of an attitude must be
those of the gyroscope, and the bend of a track the specific force.  Of the 24 turns of axes the
identity must fit best, else the one that does is named; so is the other order of quaternions, if
all of that holds with it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from springback.errors import InputError
from springback.logs.clocks import (
    WINDOW,
    Integral,
    Offset,
    attitude_rates,
    clock_offset,
)
from springback.logs.frame_turns import (
    BODIES,
    WORLDS,
    axis_turns,
    other_order,
    turn_words,
    world_vectors,
)
from springback.logs.free_fall import (
    GRAVITY,
    falling_samples,
    falls_freely,
    has_steady_size,
)
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ARM_LENGTH,
    ATTITUDE,
    POSITION,
    SPECIFIC_FORCE,
    Array,
    Flags,
    LogChannel,
    Recording,
)

#: Errors above which a finding says so (chosen): of a quaternion's length, of the magnitude of
#: gravity as a share, at rest and over a whole flight, of its direction [rad].
UNIT_ERROR, GRAVITY_ERROR, MEDIAN_ERROR, TILT = 1e-3, 0.05, 0.2, np.radians(10.0)
#: Lean of a vehicle in flight, at most, of which a wrong axis is twice as much [rad] (chosen).
LEAN = np.radians(45.0)
#: Stretches of rest [s], and the deviation of the specific force in them [m/s²] (chosen).
QUIET, STILL = 0.5, 0.3
#: Ratios to gravity of units that are mistaken for m/s².
UNITS = ((1e3, "mm/s^2"), (1.0 / GRAVITY, "g"), (1e-3, "km/s^2"), (1e3 / GRAVITY, "mg"))
#: Ratios of units that are mistaken for rad/s.
RATE_UNITS = ((180.0 / np.pi, "deg/s"), (1e3, "mrad/s"), (1e-3, "krad/s"))
#: A ratio of a unit is met within this factor (chosen).
UNIT_WIDTH = 1.5
#: Factor beyond which a specific force of steady size is no gravity (chosen).
FAR_OFF = 30.0
#: TurnRates and accelerations below which axes cannot be told apart, rms [rad/s], [m/s²] (chosen).
STILL_RATE, STILL_ACCELERATION = 0.05, 0.5
#: Time over which rates are compared, at least [s] (chosen: of less, some turn always agrees).
COMPARED = 10 * WINDOW
#: Correlation that axes must reach, and by how much another turn must be better (chosen).
AGREED, BETTER = 0.9, 0.02
#: End of the name of a finding on the order of quaternions, and their two orders.
ORDER, ORDERS = ", order", {"wxyz": "xyzw", "xyzw": "wxyz"}
#: End of the name of a log's parameter that tells in which order they were read.
ORDER_KEY = ".order"
#: Half the time over which the bend of a track is taken [s] (chosen).
BEND = 0.06
#: Fastest that a vehicle flies [m/s], longest arm [m], and the same as a multiple of a known
#: vehicle's longest at rest (chosen: arms that swing open do not reach it).
FASTEST, LONGEST_ARM, TIMES_AS_LONG = 100.0, 3.0, 3.0


class FrameFinding(NamedTuple):
    """What the data say of one channel."""

    name: str
    passed: bool
    sentence: str
    is_mistake: bool = False
    """True if nothing but wrong axes, or a wrong order of quaternions, explains it."""


def refuse_units(recording: Recording, arm_length: float | None = None) -> None:
    """Refuse channels whose unit is plainly another one.

    Args:
        recording: A log.
        arm_length: The vehicle's longest arm at rest [m], if the vehicle is known.

    Raises:
        InputError: In one line for each.
    """
    problems = []
    for channel in recording.of(SPECIFIC_FORCE):
        if not has_steady_size(channel.values):
            continue
        middle = float(np.nanmedian(np.linalg.norm(channel.values, axis=1)))
        said = f"{recording.path}: {channel.name}: |specific force| is {middle:.4g} m/s^2 at the "
        near = [unit for ratio, unit in UNITS if _is_near(middle / GRAVITY / ratio, UNIT_WIDTH)]
        if near:
            problems.append(f"{said}median and gravity 9.81: its unit is probably {near[0]}")
        elif not _is_near(middle / GRAVITY, FAR_OFF):
            problems.append(f"{said}median and gravity 9.81: its unit, or its scale, is wrong")
    for channel in recording.of(POSITION):
        speed = _usual_speed(channel)
        if speed > FASTEST:
            problems.append(
                f"{recording.path}: {channel.name}: moves at {speed:.3g} m/s at the median: its "
                "unit is probably mm"
            )
    for channel in recording.of(ATTITUDE):
        length = float(np.nanmedian(np.linalg.norm(channel.values, axis=1)))
        if not 0.9 < length < 1.1:
            problems.append(
                f"{recording.path}: {channel.name}: |q| is {length:.4g} at the median, not 1: "
                "these are no quaternions"
            )
    for channel in recording.of(ARM_LENGTH):
        if said := _length_problem(channel, arm_length):
            problems.append(f"{recording.path}: {channel.name}: {said}")
    if problems:
        raise InputError(*problems)


def _length_problem(channel: LogChannel, known: float | None) -> str:
    """Why values cannot be lengths of arms, nor changes of them; empty if they can."""
    usual = np.nanmedian(np.abs(channel.values), axis=0)
    longest, shortest = float(np.nanmax(usual)), float(np.nanmin(usual))
    if known is None:
        if longest <= LONGEST_ARM:
            return ""
        than = f"no arm is longer than {LONGEST_ARM:g} m"
    else:
        than = f"the scenario's longest arm is {known:.4g} m"
        if longest <= TIMES_AS_LONG * known:
            is_less = known / UNIT_WIDTH < 1e3 * shortest and 1e3 * longest < known * UNIT_WIDTH
            return (
                f"lengths are {longest:.4g} m at the median, and {than}: the numbers are probably "
                "metres already" if is_less else ""
            )  # fmt: skip
    units = {"mm": 1e-3, "cm": 1e-2, "um": 1e-6}
    aim = 0.2 if known is None else known
    unit = min(units, key=lambda name: abs(np.log(longest * units[name] / aim)))
    return f"lengths are {longest:.4g} m at the median, and {than}: its unit is probably {unit}"


def _usual_speed(channel: LogChannel) -> float:
    """Median speed over whole steps of a track [m/s]; 0 for one that is too short."""
    steps = np.diff(channel.times)
    with np.errstate(invalid="ignore", divide="ignore"):
        speeds = np.linalg.norm(np.diff(channel.values, axis=0), axis=1) / steps
    speeds = speeds[np.isfinite(speeds)]
    moving = speeds[speeds > 0.0]
    return float(np.median(moving)) if len(moving) > 10 else 0.0


def check_frames(recordings: Sequence[Recording]) -> list[FrameFinding]:
    """Findings on the channels of logs of the same flight."""
    found: list[FrameFinding] = []
    for one in recordings:
        found += [_unit_length(channel) for channel in one.of(ATTITUDE)]
        found += [_resting(channel) for channel in one.of(SPECIFIC_FORCE) if len(channel.times) > 5]
    gyro, accelerometer = _best(recordings, ANGULAR_VELOCITY), _best(recordings, SPECIFIC_FORCE)
    for home, attitude in _attitudes(recordings):
        about = _attitude_findings(home, attitude, gyro, accelerometer)
        if not all(one.passed for one in about):
            about = _order_findings(home, attitude, gyro, accelerometer) or about
        found += about
    return list({one.name: one for one in reversed(found)}.values())[::-1]


Home = tuple[Recording, LogChannel]


def _attitude_findings(
    home: Recording, attitude: LogChannel, gyro: Home | None, accelerometer: Home | None
) -> list[FrameFinding]:
    """What gyroscope, accelerometer and track say of an attitude."""
    found, offset = list[FrameFinding](), Offset(0.0, 1.0)
    if gyro is not None:
        offset = offset_of(home, attitude, gyro)
        found.append(_gyro_finding(attitude, gyro[1], offset))
    if accelerometer is not None and offset.correlation >= AGREED:
        position = _beside(home, attitude)
        found.append(_up_finding(attitude, position, accelerometer[1], offset.seconds))
        if position is not None:
            found.append(_bend_finding(attitude, position, accelerometer[1], offset.seconds))
    return found


def _order_findings(
    home: Recording, attitude: LogChannel, gyro: Home | None, accelerometer: Home | None
) -> list[FrameFinding]:
    """That the other order of quaternions is the true one; empty if it is not, or not known."""
    told = home.parameters
    order = str(told.get(f"{attitude.name}{ORDER_KEY}", ""))
    if order not in ORDERS:
        return []
    turns = WORLDS[str(told["world"])], BODIES[str(told["body"])]
    other = replace(attitude, values=other_order(*turns, attitude.values, order))
    again = _attitude_findings(home, other, gyro, accelerometer)
    if not again or not all(one.passed for one in again):
        return []
    said = (
        f"its quaternions are {ORDERS[order]}, not {order} as they were read: so "
        f"{'; '.join(one.sentence for one in again)}"
    )
    return [FrameFinding(f"{attitude.name}{ORDER}", False, said, is_mistake=True)]


def _best(recordings: Sequence[Recording], quantity: str) -> Home | None:
    """The fastest measured channel of all logs, with its log."""
    found = [(one, channel) for one in recordings if (channel := one.best(quantity)) is not None]
    return max(found, key=lambda pair: (not pair[1].chain.estimated, pair[1].rate), default=None)


def _attitudes(recordings: Sequence[Recording]) -> list[Home]:
    return [
        (one, channel) for one in recordings for channel in one.of(ATTITUDE)
        if channel.name not in one.others
    ]  # fmt: skip


def _beside(home: Recording, attitude: LogChannel) -> LogChannel | None:
    """The position that was measured with an attitude, at the same instants."""
    for one in home.of(POSITION):
        if one.clock == attitude.clock and np.array_equal(one.times, attitude.times):
            return one
    return None


def offset_of(home: Recording, attitude: LogChannel, gyro: Home) -> Offset:
    """Offset between the clocks of an attitude and a gyroscope; small if they share one."""
    same = home is gyro[0] and attitude.clock == gyro[1].clock
    return clock_offset(attitude, gyro[1], within=0.2 if same else None)


def _unit_length(channel: LogChannel) -> FrameFinding:
    error = np.abs(np.linalg.norm(channel.values, axis=1) - 1.0)
    worst = float(np.nanmax(error)) if not np.isnan(error).all() else np.nan
    passed = worst <= UNIT_ERROR
    return FrameFinding(channel.name, passed, f"|q| = 1 within {worst:.1g}")


def quiet_samples(channel: LogChannel) -> Flags:
    """Samples in stretches of half a second in which a channel hardly changes, shape (samples,)."""
    found = np.zeros(len(channel.times), dtype=bool)
    size = max(10, round(QUIET * channel.rate))
    count = len(found) // size
    if not count:
        return found
    parts = channel.values[: count * size].reshape(count, size, -1)
    span = channel.times[size - 1 : count * size : size] - channel.times[: count * size : size]
    still = (parts.std(axis=1) < STILL).all(axis=1) & (span < 3.0 * QUIET)
    found[: count * size] = np.repeat(still, size)
    return found


def _resting(channel: LogChannel) -> FrameFinding:
    """Median specific force at rest, else of the whole flight: it is along +z."""
    quiet, falls = quiet_samples(channel), falls_freely(channel.values)
    if falls:
        quiet &= ~falling_samples(channel.values)
    at_rest = bool(quiet.any())
    if falls and not at_rest:
        text = "falls freely, and rests nowhere: gravity cannot be compared"
        return FrameFinding(channel.name, True, text)
    mean = np.nanmedian(channel.values[quiet] if at_rest else channel.values, axis=0)
    size, tilt = float(np.linalg.norm(mean)), _tilt(mean)
    error = size / GRAVITY - 1.0
    when = "at rest" if at_rest else "at the median"
    text = f"{mean[2]:+.2f} m/s^2 along z {when} ({100.0 * error:+.1f} % of gravity)"
    if tilt > np.pi / 4.0:
        k = int(np.argmax(np.abs(mean)))
        side = f"{'+' if mean[k] > 0.0 else '-'}{'xyz'[k]}"
        text = f"{size:.2f} m/s^2 along {side} {when}, not along +z: its axes are not FLU"
    most = GRAVITY_ERROR if at_rest else MEDIAN_ERROR
    passed = tilt < np.pi / 4.0 and abs(error) < most
    # A vehicle that lies on its side after an impact stood upright before it.
    first = np.nanmedian(channel.values[channel.times < channel.times[0] + QUIET], axis=0)
    is_mistake = not falls and min(tilt, _tilt(first)) > np.pi / 4.0
    return FrameFinding(channel.name, passed, text, is_mistake)


def _tilt(vector: Array) -> float:
    """Angle of a vector from +z [rad]; π without a direction."""
    size = float(np.linalg.norm(vector))
    return float(np.arccos(np.clip(vector[2] / size, -1.0, 1.0))) if size else np.pi


def _gyro_finding(attitude: LogChannel, gyro: LogChannel, offset: Offset) -> FrameFinding:
    """TurnRates of an attitude against a gyroscope, by each turn of axes."""
    names = f"{attitude.name} and {gyro.name}"
    rates = attitude_rates(attitude)
    means, whole = Integral(gyro).means(rates.begins + offset.seconds, rates.ends + offset.seconds)
    a, b = rates.values[whole], means[whole]
    span = np.ptp(rates.begins[whole]) if len(a) else 0.0
    if span < COMPARED or np.sqrt((b * b).sum(axis=1).mean()) < STILL_RATE:
        return FrameFinding(names, True, "turn too little together to compare their axes")
    at = f"clocks {1e3 * offset.seconds:+.1f} ms apart" if abs(offset.seconds) < 1.0 else (
        f"clocks {offset.seconds:+.4f} s apart"
    )  # fmt: skip
    found = _turn_finding(names, a, b, at, "rates of turn")
    size = float(np.sqrt((b * b).sum() / (a * a).sum())) if a.any() else 1.0
    for ratio, unit in RATE_UNITS:
        if found.passed and 1.0 / UNIT_WIDTH < size / ratio < UNIT_WIDTH:
            raise InputError(
                f"{names}: the second turns {size:.4g} times as fast as the first: the unit of "
                f"{gyro.name} is probably {unit}"
            )
    return found


def _turn_finding(names: str, a: Array, b: Array, at: str, what: str) -> FrameFinding:
    """Which turn of b is a."""
    norm = float(np.sqrt((a * a).sum() * (b * b).sum()))
    scores = [float((a * (b @ turn.T)).sum()) / norm if norm else 0.0 for turn in axis_turns()]
    best = int(np.argmax(scores))
    if scores[best] < AGREED:
        return FrameFinding(
            names, False,
            f"no turn of axes makes their {what} agree (at best {scores[best]:.2f}); {at}",
        )  # fmt: skip
    if scores[0] >= scores[best] - BETTER:
        return FrameFinding(names, True, f"{what} agree ({scores[0]:.3f}); {at}")
    return FrameFinding(
        names, False,
        f"{what} agree if the axes of the second are turned: {turn_words(axis_turns()[best])} "
        f"({scores[best]:.3f}; as they are {scores[0]:.2f}); {at}", True,
    )  # fmt: skip


def interpolated_attitudes(attitude: LogChannel, at: Array) -> Array:
    """Attitudes at instants of their own clock, shape (n, 4), linear and normalised."""
    known = ~attitude.is_lost
    t, q = attitude.times[known], attitude.values[known]
    mixed = np.stack([np.interp(at, t, part) for part in q.T], axis=1)
    size = np.linalg.norm(mixed, axis=1, keepdims=True)
    return np.asarray(mixed / np.where(size > 0.0, size, 1.0))


def world_force(
    attitude: LogChannel, accelerometer: LogChannel, offset: float
) -> tuple[Array, Array]:
    """Instants of the accelerometer within an attitude, and its specific force in the world."""
    at = accelerometer.times - offset
    known = ~attitude.is_lost
    inside = ~accelerometer.is_lost
    if known.any():
        first, last = attitude.times[known][[0, -1]]
        inside &= (at >= first) & (at <= last)
    else:
        inside &= False
    q = interpolated_attitudes(attitude, at[inside]) if inside.any() else np.empty((0, 4))
    return accelerometer.times[inside], world_vectors(q, accelerometer.values[inside])


def _is_near(ratio: float, factor: float) -> bool:
    """True if a ratio is within a factor of 1."""
    return 1.0 / factor < ratio < factor


def _up_finding(
    attitude: LogChannel, position: LogChannel | None, accelerometer: LogChannel, offset: float
) -> FrameFinding:
    """Specific force in the world's axes, less the bend of the track: up.

    Without a track, a vehicle that leans also accelerates: its specific force is along its own z.
    """
    names = f"{attitude.name} and {accelerometer.name}"
    times, force = world_force(attitude, accelerometer, offset)
    if len(force) < 10:
        return FrameFinding(names, True, "overlap too little to compare")
    mean, most = np.median(force, axis=0), LEAN
    if position is not None:
        at, width, told = bends(position)
        felt, whole = _triangle_means(accelerometer, times, force, at + offset, width)
        if whole.sum() >= 10:
            mean, most = np.median(felt[whole] - told[whole], axis=0), TILT
    tilt = _tilt(mean)
    if tilt < most:
        return FrameFinding(names, True, f"gravity is {np.degrees(tilt):.1f} deg off the vertical")
    k = int(np.argmax(np.abs(mean)))
    side = f"{'+' if mean[k] > 0.0 else '-'}{'xyz'[k]}"
    why = "its world axes are not NWU, or its body axes are not those of the accelerometer"
    if tilt < LEAN:
        why = "the accelerometer is mounted askew, or the body's axes are"
    # Without a track, what falls has no direction that tells.
    is_mistake = tilt >= LEAN and (most == TILT or not falls_freely(force))
    return FrameFinding(
        names, False,
        f"the specific force is along the world's {side}, {np.degrees(tilt):.0f} deg off +z: {why}",
        is_mistake,
    )  # fmt: skip


def bends(position: LogChannel, half: float = BEND) -> tuple[Array, Array, Array]:
    """Mean accelerations of a track: instants, half widths [s], accelerations [m/s²].

    The second difference of positions over T is the mean acceleration with triangular weights over
    2 T; nothing is differentiated at the step of the samples.
    """
    known = ~position.is_lost
    t, p = position.times[known], position.values[known]
    rate = position.rate
    jump = max(1, round(half * rate)) if rate else 1
    if len(t) <= 2 * jump:
        return np.empty(0), np.empty(0), np.empty((0, 3))
    before, after = t[jump:-jump] - t[: -2 * jump], t[2 * jump :] - t[jump:-jump]
    fine = (before > 0.0) & (np.abs(after / np.where(before > 0.0, before, 1.0) - 1.0) < 0.05)
    fine &= before < 1.5 * jump / rate
    width = 0.5 * (before + after)[fine]
    second = (p[2 * jump :] - 2.0 * p[jump:-jump] + p[: -2 * jump])[fine]
    return t[jump:-jump][fine], width, second / (width * width)[:, None]


def _bend_finding(
    attitude: LogChannel, position: LogChannel, accelerometer: LogChannel, offset: float
) -> FrameFinding:
    """Bend of a track against the specific force, by each turn of the accelerometer's axes."""
    names = f"{position.name} and {accelerometer.name}"
    at, width, told = bends(position)
    if len(at) < 10:
        return FrameFinding(names, True, "the track is too short to compare")
    scores, sizes, used = [], [], 0
    for turn in axis_turns():
        turned = LogChannel(
            accelerometer.name, SPECIFIC_FORCE, accelerometer.times,
            accelerometer.values @ turn.T, accelerometer.clock,
        )  # fmt: skip
        times, force = world_force(attitude, turned, offset)
        mean, whole = _triangle_means(turned, times, force, at + offset, width)
        used = int(whole.sum())
        if used < 10:
            return FrameFinding(names, True, "overlap too little to compare")
        a, b = told[whole], mean[whole] - [0.0, 0.0, GRAVITY]
        norm = float(np.sqrt((a * a).sum() * (b * b).sum()))
        scores.append(float((a * b).sum()) / norm if norm else 0.0)
        sizes.append(float(np.sqrt((a * a).sum() / max((b * b).sum(), 1e-30))))
        if len(scores) == 1 and np.sqrt((a * a).sum(axis=1).mean()) < STILL_ACCELERATION / 1e3:
            return FrameFinding(names, True, "the track bends too little to compare")
    best = int(np.argmax(scores))
    for factor, unit in ((1e3, "mm"), (1e-3, "km")):
        if scores[0] > AGREED / 2.0 and factor / 2.0 < sizes[0] < 2.0 * factor:
            raise InputError(
                f"{names}: the track bends {sizes[0]:.3g} times as much as the specific force "
                f"says: the unit of the position is probably {unit}"
            )
    if np.sqrt((told * told).sum(axis=1).mean()) < STILL_ACCELERATION:
        return FrameFinding(names, True, "the track bends too little to compare")
    if scores[best] < AGREED - 0.2:
        return FrameFinding(
            names,
            False,
            f"no turn of axes makes track and specific force agree ({scores[best]:.2f})",
        )
    if scores[0] >= scores[best] - BETTER:
        return FrameFinding(
            names, True, f"the track bends as the specific force says ({scores[0]:.3f})"
        )
    return FrameFinding(
        names, False,
        "the track bends as the specific force says if the accelerometer's axes are turned: "
        f"{turn_words(axis_turns()[best])} ({scores[best]:.3f}; as they are {scores[0]:.2f})",
        scores[best] >= AGREED,
    )  # fmt: skip


def _triangle_means(
    channel: LogChannel, times: Array, force: Array, at: Array, width: Array
) -> tuple[Array, Array]:
    """Means of a force with triangular weights over ± a width, and which are whole."""
    known = LogChannel(channel.name, SPECIFIC_FORCE, times, force, channel.clock)
    first = Integral(known)
    whole = (at - width >= times[0]) & (at + width <= times[-1]) if len(times) > 1 else at < -np.inf
    if not np.any(whole):
        return np.empty((len(at), 3)), np.asarray(whole)
    # twice integrated: the same second difference as of the track
    sums = first.sums
    steps = np.diff(times)
    twice = np.concatenate(
        [np.zeros((1, 3)), np.cumsum(0.5 * (sums[1:] + sums[:-1]) * steps[:, None], axis=0)]
    )

    def value(t: Array) -> Array:
        return np.stack([np.interp(t, times, one) for one in twice.T], axis=1)

    means = (value(at + width) - 2.0 * value(at) + value(at - width)) / (width * width)[:, None]
    return means, np.asarray(whole)

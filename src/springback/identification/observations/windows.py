"""Readings of an impact: the parts of logs that belong to it, on one clock, with their noise."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple, Protocol

import numpy as np

from springback.errors import InputError
from springback.identification.observations.channel_window import ChannelWindow
from springback.identification.observations.drop_start import Fall, fall_of
from springback.identification.observations.initial_state import InitialState, initial_state
from springback.identification.observations.noise import estimated_noise, white_noise
from springback.identification.observations.sensor_chain import ChannelChain, noise_covariances
from springback.identification.settings import (
    ClockFit,
    FitSensors,
    InertialChannel,
    StartFit,
    WindowFit,
)
from springback.logs.clocks import GAP, Offset
from springback.logs.frame_check import bends, offset_of
from springback.logs.frame_turns import conjugate, continuous, product, rotation_vector
from springback.logs.free_fall import CLEAR as FALL_CLEAR
from springback.logs.free_fall import begin_of_fall
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ARM_LENGTH,
    ATTITUDE,
    POSITION,
    SPECIFIC_FORCE,
    VELOCITY,
    LogChannel,
    Recording,
    SensorChain,
)
from springback.logs.segments import ALIGNED, LogImpact
from springback.logs.thrusts import logged_thrusts
from springback.scenario.scenario import Scenario

#: Least standard deviations of a sample: what common devices resolve (chosen).
FLOORS = {
    SPECIFIC_FORCE: 5e-3, ANGULAR_VELOCITY: 5e-4, POSITION: 5e-5, ATTITUDE: 2e-4, ARM_LENGTH: 2e-5,
    VELOCITY: 2e-2,
}  # fmt: skip
#: Time before touch from which noise is estimated, and its distance from touch [s] (chosen).
QUIET, CLEAR = 0.5, 0.01
#: End of a window before the bounce that follows, and shortest fall before a drop [s] (chosen).
BEFORE_BOUNCE, SHORTEST_FALL = 3e-3, 0.02
#: Share by which the time of a fall may differ from that of the known height (chosen).
DIFFERENT_FALL = 0.1
#: Uncertainty of a clock that only the impact itself aligns [s] (chosen: a frame at 200 Hz).
COARSE = 5e-3


class WindowPlan(Protocol):
    """What of a plan tells how logs are read, as `FitPlan` has it."""

    @property
    def sensors(self) -> FitSensors:
        """What stands between the motion and the logs."""

    @property
    def clocks(self) -> ClockFit:
        """Clocks of other devices."""

    @property
    def start(self) -> StartFit:
        """Uncertainty of the state before touch."""

    @property
    def thrust(self) -> float:
        """Standard deviation of the factor of all thrusts."""

    @property
    def window(self) -> WindowFit:
        """Part that is read."""


class ImpactWindow(NamedTuple):
    """All readings of an impact."""

    name: str
    touch: float  # [s] from the start of the window, as found in the log
    release: float
    until: float  # end of the window [s]
    start: InitialState
    readings: tuple[ChannelWindow, ...]
    clock_uncertainty: float  # of other devices [s]
    thrust: dict[str, Any] | None  # ``thrust`` of a scenario, if speeds or commands were logged

    def of(self, quantity: str) -> ChannelWindow | None:
        """ChannelWindow of a quantity, if there is one."""
        return next((one for one in self.readings if one.quantity == quantity), None)


class _Found(NamedTuple):
    recording: Recording
    channel: LogChannel
    shift: float  # added to its times


def impact_window(
    plan: WindowPlan,
    scenario: Scenario,
    recordings: Sequence[Recording],
    impact: LogImpact,
    *,
    estimates: bool = False,
) -> ImpactWindow:
    """Readings of an impact that was found in the logs of a flight.

    Args:
        plan: Of the fit.
        scenario: Of this flight.
        recordings: Logs of the flight.
        impact: Found in them.
        estimates: Read velocities, too, and tracks that an autopilot estimated where none is
            measured.

    Raises:
        InputError: If there is neither an accelerometer nor a track, or neither a track nor a
            velocity, nor a height of a drop, of the scenario before touch.
    """
    inertial = _inertial(recordings)
    tracks, uncertainty = _tracks(plan, recordings, inertial, impact, estimated=False)
    if estimates and not tracks:
        tracks, uncertainty = _tracks(plan, recordings, inertial, impact, estimated=True)
    arms = [
        _Found(one, channel, 0.0)
        for one in recordings for channel in one.of(ARM_LENGTH)
        if not inertial or one is inertial[0].recording
    ][:1]  # fmt: skip
    used = [*inertial, *tracks, *arms]
    if estimates:
        used += _velocities(recordings, used)
    if not any(one.channel.quantity in (SPECIFIC_FORCE, POSITION) for one in used):
        raise InputError(f"{impact.log}: has neither an accelerometer nor a track to fit")
    fall = None
    if impact.is_drop and not tracks:
        fall = fall_of(scenario)
    begin, end = _window(plan, used, impact, fall)
    readings = tuple(
        reading for one in used
        if (reading := _reading(plan, one, begin, end, impact, inertial)) is not None
    )  # fmt: skip
    is_told = fall is not None or any(scenario.start.velocity)
    if not is_told and not any(one.quantity == POSITION for one in readings):
        raise InputError(
            f"{impact.log}: has no track before touch, and the scenario has no start.velocity to "
            "begin with"
        )
    touch, release = impact.touch - begin, impact.release - begin
    guess = initial_state(scenario, readings, touch, fall)
    told = logged_thrusts(scenario, recordings, (begin, end), impact.touch)
    thrust = None if told is None else told.table
    name = f"{impact.log} at {impact.touch:.3f} s"
    return ImpactWindow(name, touch, release, end - begin, guess, readings, uncertainty, thrust)


def _inertial(recordings: Sequence[Recording]) -> list[_Found]:
    """The fastest accelerometer, and the gyroscope beside it."""
    found = [
        _Found(one, channel, 0.0) for one in recordings for channel in one.of(SPECIFIC_FORCE)
        if not channel.chain.estimated
    ]  # fmt: skip
    if not found:
        return []
    best = max(found, key=lambda one: one.channel.rate)
    beside = [
        _Found(best.recording, channel, 0.0) for channel in best.recording.of(ANGULAR_VELOCITY)
        if channel.clock == best.channel.clock
    ]  # fmt: skip
    return [best, *sorted(beside, key=lambda one: -one.channel.rate)[:1]]


def _velocities(recordings: Sequence[Recording], used: Sequence[_Found]) -> list[_Found]:
    """The first velocity on a clock that is known."""
    shifts = {(id(one.recording), one.channel.clock): one.shift for one in reversed(used)}
    return [
        _Found(one, channel, shifts[id(one), channel.clock])
        for one in recordings for channel in one.of(VELOCITY)
        if (id(one), channel.clock) in shifts
    ][:1]  # fmt: skip


def _tracks(
    plan: WindowPlan,
    recordings: Sequence[Recording],
    inertial: Sequence[_Found],
    impact: LogImpact,
    *,
    estimated: bool,
) -> tuple[list[_Found], float]:
    """Measured positions and attitudes of the body, with the uncertainty of their clock [s]."""
    home = inertial[0].recording if inertial else None
    # The motion capture's own file rather than what a link brought on board.
    for recording in sorted(recordings, key=lambda one: one is home):
        for position in recording.of(POSITION):
            if position.chain.estimated != estimated:
                continue
            attitude = next(
                (one for one in recording.of(ATTITUDE)
                 if one.clock == position.clock and one.chain.estimated == estimated), None,
            )  # fmt: skip
            shift, uncertainty = _shift(plan, recording, position, attitude, inertial, impact)
            pair = [position] if attitude is None else [position, attitude]
            return [_Found(recording, one, shift) for one in pair], uncertainty
    return [], 0.0


def _shift(
    plan: WindowPlan,
    recording: Recording,
    position: LogChannel,
    attitude: LogChannel | None,
    inertial: Sequence[_Found],
    impact: LogImpact,
) -> tuple[float, float]:
    """What is added to a track's clock to get the inertial unit's, and its uncertainty [s]."""
    if not inertial:
        return 0.0, 0.0
    home = inertial[0]
    if home.recording is recording and home.channel.clock == position.clock:
        return 0.0, 0.0
    if plan.clocks.offset is not None:
        return plan.clocks.offset, plan.clocks.uncertainty
    gyro = next((one for one in inertial if one.channel.quantity == ANGULAR_VELOCITY), None)
    if attitude is not None and gyro is not None:
        found: Offset = offset_of(recording, attitude, (gyro.recording, gyro.channel))
        if found.correlation >= ALIGNED:
            return found.seconds, plan.clocks.uncertainty
    if home.recording is recording:  # one program wrote both
        return 0.0, plan.clocks.uncertainty
    at, _, bend = bends(position)
    if not len(at):
        return 0.0, plan.clocks.uncertainty
    size = np.linalg.norm(bend, axis=1)
    strongest = float(at[int(np.nanargmax(size))])
    return 0.5 * (impact.touch + impact.release) - strongest, COARSE


def _window(
    plan: WindowPlan, used: Sequence[_Found], impact: LogImpact, fall: Fall | None
) -> tuple[float, float]:
    """Start and end of the part that is fitted [s], the start at a sample of the first channel."""
    contact = max(impact.release - impact.touch, 1e-3)
    after = plan.window.after
    end = impact.release + (max(3.0 * contact, 0.15) if after is None else after)
    if impact.following is not None:
        end = min(end, max(impact.following - BEFORE_BOUNCE, impact.release))
    first = used[0].channel.times + used[0].shift
    begin = max(impact.touch - plan.window.before, *(
        float(one.channel.times[0] + one.shift) for one in used
    ))  # fmt: skip
    if impact.is_drop:
        begin = max(begin, *_begins_of_fall(used[0], impact, fall))
    place = min(int(np.searchsorted(first, begin - 1e-9)), len(first) - 1)
    return float(first[place]), min(end, float(first[-1]))


def _begins_of_fall(first: _Found, impact: LogImpact, fall: Fall | None) -> list[float]:
    """Instants before which a vehicle was held [s], by its accelerometer and by the known height.

    Raises:
        InputError: If both are known and plainly differ.
    """
    latest, found = impact.touch - SHORTEST_FALL, list[float]()
    felt = None
    if first.channel.quantity == SPECIFIC_FORCE:
        felt = begin_of_fall(first.channel, impact.touch)
    if felt is not None:
        found.append(felt)
    if fall is not None:
        found.append(impact.touch - fall.duration)
        if felt is not None and felt > first.channel.times[0]:
            fell = impact.touch - felt + FALL_CLEAR
            if abs(fell - fall.duration) > FALL_CLEAR + DIFFERENT_FALL * fall.duration:
                raise InputError(
                    f"{impact.log}: {first.channel.name}: falls for {fell:.3f} s before the impact "
                    f"at {impact.touch:.3f} s, but {fall.duration:.3f} s from the scenario's start "
                    f"{fall.height:.4g} m above touch: start.position or start.velocity is wrong"
                )
    return [min(one, latest) for one in found] or [latest]


def _reading(
    plan: WindowPlan,
    one: _Found,
    begin: float,
    end: float,
    impact: LogImpact,
    inertial: Sequence[_Found],
) -> ChannelWindow | None:
    """Part of a channel in the window; None if it has too few samples there."""
    channel, quantity = one.channel, one.channel.quantity
    times = channel.times + one.shift
    values = channel.values
    before = (times >= impact.touch - QUIET) & (times < impact.touch - CLEAR)
    if quantity == ATTITUDE:
        values = continuous(values)
    clipped = None
    if quantity == ARM_LENGTH:
        clipped = _arms_at_ends(plan, channel)
        values = values - np.nanmedian(values[before], axis=0) if before.any() else values
        values = _by_arm(values, plan.sensors.arm_length.order)
    given = _given_noise(plan, quantity)
    if given is not None:
        noise = white_noise(given, 3 if quantity == ATTITUDE else values.shape[1])
    else:
        quiet = values[before]
        if quantity == ATTITUDE and len(quiet):
            known = quiet[~np.isnan(quiet).any(axis=1)]
            quiet = rotation_vector(product(conjugate(known[0]), quiet)) if len(known) else quiet
        filtered = noise_covariances(known_filter(plan.sensors, channel), channel.rate)
        noise = estimated_noise(times[before], quiet, FLOORS[quantity], filtered)
    inside = (times >= begin - 1e-9) & (times <= end + 1e-9)
    if inside.sum() < 3:
        return None
    at = times[inside] - begin
    usual = 1.0 / channel.rate if channel.rate else np.inf
    starts = np.concatenate([[True], np.diff(at) > GAP * usual])
    home = inertial[0] if inertial else one
    other = not (one.recording is home.recording and channel.clock == home.channel.clock)
    chain = _with_range(channel)
    flags = None if clipped is None else clipped[inside]
    return ChannelWindow(
        quantity, channel.name, at, values[inside], noise, starts, chain, other, flags
    )


def known_filter(sensors: FitSensors, channel: LogChannel) -> ChannelChain:
    """Low-pass of an inertial channel as plan or log tell it; what a scenario tells is left out.

    Args:
        sensors: Of the plan.
        channel: Of the log.
    """
    told = channel.chain
    if channel.quantity not in (SPECIFIC_FORCE, ANGULAR_VELOCITY):
        return ChannelChain(None, None, None)
    is_force = channel.quantity == SPECIFIC_FORCE
    given: InertialChannel = sensors.accelerometer if is_force else sensors.gyroscope
    low = told.low_pass if given.low_pass is None else given.low_pass
    order = given.low_pass_order or told.low_pass_order or 1
    return ChannelChain(None, low, None, order, given.device_low_pass)


def _arms_at_ends(plan: WindowPlan, channel: LogChannel) -> Any:
    """Lengths at the end of a sensor's range, of plan or log, by arm; None if neither tells."""
    told, flags = plan.sensors.arm_length, channel.clipped
    if told.shortest is not None or told.longest is not None:
        low = -np.inf if told.shortest is None else told.shortest
        high = np.inf if told.longest is None else told.longest
        with np.errstate(invalid="ignore"):
            flags = (channel.values <= low) | (channel.values >= high)
    if flags is None or not flags.any():
        return None
    return _by_arm(flags, told.order)


def _by_arm(values: Any, order: tuple[int, ...]) -> Any:
    """Columns in the order of the arms.

    Raises:
        InputError: If the order does not name each column once.
    """
    if not order:
        return values
    if sorted(order) != list(range(1, values.shape[1] + 1)):
        raise InputError(
            f"sensors.arm_length.order: must name each of 1 to {values.shape[1]} once (got "
            f"{list(order)})"
        )
    return values[:, np.argsort(order)]


def _with_range(channel: LogChannel) -> SensorChain:
    """Chain of a channel; a range that is not told is that of the samples marked as clipped."""
    chain, clipped = channel.chain, channel.clipped
    if channel.quantity == ARM_LENGTH:
        return chain
    if chain.full_scale is not None or clipped is None or not clipped.any():
        return chain
    return replace(chain, full_scale=float(np.nanmax(np.abs(channel.values[clipped]))))


def _given_noise(plan: WindowPlan, quantity: str) -> float | None:
    sensors = plan.sensors
    return {
        SPECIFIC_FORCE: sensors.accelerometer.noise,
        ANGULAR_VELOCITY: sensors.gyroscope.noise,
        POSITION: sensors.motion_capture.noise,
        ATTITUDE: sensors.motion_capture.attitude_noise,
        ARM_LENGTH: sensors.arm_length.noise,
    }.get(quantity)

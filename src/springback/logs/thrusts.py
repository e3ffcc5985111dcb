"""Thrusts of the rotors over time, as a log tells them: by their speeds or their commands."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError
from springback.logs.recording import (
    ROTOR_COMMAND,
    ROTOR_SPEED,
    SPECIFIC_FORCE,
    Array,
    LogChannel,
    Recording,
)
from springback.scenario.scenario import Scenario

#: Speeds slower than this are not used where commands are logged, too [Hz] (chosen).
SLOWEST_SPEEDS = 50.0
#: Largest command that still is a share of the largest thrust (chosen: 1 and some rounding).
LARGEST_SHARE = 1.05
#: Part before touch over which thrusts are compared with the accelerometer [s] (chosen).
QUIET, CLEAR = 0.5, 0.01


class LoggedThrusts(NamedTuple):
    """Thrusts of all rotors over a part of a log."""

    table: dict[str, Any]
    """``thrust`` of a scenario: instants from the begin of the part [s], and rows [N]."""
    sentence: str
    """Where they are from."""
    carried: float
    """Along body z, mean before touch, over what the accelerometer says; NaN without one."""


def logged_thrusts(
    scenario: Scenario,
    recordings: Sequence[Recording],
    part: tuple[float, float],
    touch: float,
    order: Sequence[int] = (),
) -> LoggedThrusts | None:
    """Thrusts by logged speeds of the rotors, else by their commands; None if neither tells.

    Speeds ω give k ω², with the one k at which the mean before touch is what the accelerometer
    says of the weight.  Commands are shares of the largest thrust, which rotors follow by their
    lag of first order.

    Args:
        scenario: Of the flight.
        recordings: Logs of the flight, rotors on the clock of the inertial unit.
        part: Begin and end, by that clock [s].
        touch: By that clock [s].
        order: For each rotor of the vehicle the number of the logged one, from 1; by default the
            same.

    Raises:
        InputError: If a number of the order is not that of a logged rotor.
    """
    vehicle = scenario.vehicle
    if scenario.model.slider is not None:
        return None
    needed = max((vehicle.rotor_count, *order))
    channel = _rotor_channel(scenario, recordings, needed)
    if channel is None:
        if order and (most := _most_rotors(recordings)) < needed:
            raise InputError(f"--rotors: names rotor {needed}, but the log has {most} rotors")
        return None
    which = [k - 1 for k in order] or list(range(vehicle.rotor_count))
    values = channel.values[:, which]
    before = (channel.times >= touch - QUIET) & (channel.times < touch - CLEAR)
    lift = np.array([one.direction().z for one in vehicle.rotors] or [1.0] * vehicle.rotor_count)
    weight = vehicle.mass * _specific_force(recordings, touch, scenario.world.gravity)
    has_force = any(one.of(SPECIFIC_FORCE) for one in recordings)
    known = ~np.isnan(values).any(axis=1)
    if channel.quantity == ROTOR_SPEED:
        squares = values**2
        mean = float((squares @ lift)[before & known].mean()) if (before & known).any() else 0.0
        if not mean > 0.0:
            return None
        factor = weight / mean
        times, thrusts = channel.times[known], factor * squares[known]
        said = "as the accelerometer says" if has_force else "which is assumed to hover"
        sentence = (
            f"thrusts are {factor:.3g} N s^2/rad^2 times the squares of {channel.name}: at this "
            f"their mean before touch carries the weight, {said}"
        )
    else:
        propulsion = vehicle.propulsion
        assert propulsion is not None  # channels of commands are used only with it
        wanted = np.nan_to_num(values) * propulsion.max_thrust
        times = channel.times
        thrusts = lagged_thrusts(
            times, np.clip(wanted, propulsion.min_thrust, propulsion.max_thrust),
            propulsion.time_constant,
        )  # fmt: skip
        sentence = (
            f"thrusts are {channel.name} times {propulsion.max_thrust:.4g} N, through a lag of "
            f"{1e3 * propulsion.time_constant:.3g} ms"
        )
    if vehicle.propulsion is not None:
        thrusts = np.clip(thrusts, 0.0, vehicle.propulsion.max_thrust)
    early = (times >= touch - QUIET) & (times < touch - CLEAR)
    carried = np.nan
    if has_force and early.any():
        carried = float((thrusts @ lift)[early].mean()) / weight
    if not len(times) or times[-1] < part[0] or times[0] > part[1]:
        return None
    begin, end = part
    inside = np.unique(times[(times > begin) & (times < end)])
    at = np.concatenate([[begin], inside, [end]])
    rows = np.stack([np.interp(at, times, one) for one in thrusts.T], axis=1)
    table = {"time": (at - begin).tolist(), "values": rows.tolist()}
    return LoggedThrusts(table, sentence, carried)


def _rotor_channel(
    scenario: Scenario, recordings: Sequence[Recording], needed: int
) -> LogChannel | None:
    """Measured speeds that are fast enough, else commands that are shares, else any speeds."""
    speeds = [
        one for recording in recordings for one in recording.of(ROTOR_SPEED)
        if one.values.shape[1] >= needed
    ]  # fmt: skip
    fast = [one for one in speeds if one.rate >= SLOWEST_SPEEDS]
    commands = list[LogChannel]()
    if scenario.vehicle.propulsion is not None:
        commands = [
            one for recording in recordings for one in recording.of(ROTOR_COMMAND)
            if one.values.shape[1] >= needed and is_share(one)
        ]  # fmt: skip
    return next(iter([*fast, *commands, *speeds]), None)


def is_share(channel: LogChannel) -> bool:
    """True for commands that are shares of the largest thrust, not pulses of a driver."""
    known = channel.values[~np.isnan(channel.values)]
    return bool(len(known)) and float(known.max()) <= LARGEST_SHARE


def _most_rotors(recordings: Sequence[Recording]) -> int:
    return max((
        one.values.shape[1] for recording in recordings
        for one in (*recording.of(ROTOR_SPEED), *recording.of(ROTOR_COMMAND))
    ), default=0)  # fmt: skip


def _specific_force(recordings: Sequence[Recording], touch: float, gravity: float) -> float:
    """Mean specific force along body z before touch [m/s²]; that of hover if none is measured."""
    found = [one for recording in recordings for one in recording.of(SPECIFIC_FORCE)]
    for channel in sorted(found, key=lambda one: (one.chain.estimated, -one.rate)):
        near = (channel.times >= touch - QUIET) & (channel.times < touch - CLEAR)
        values = channel.values[near, 2]
        if len(values) and not np.isnan(values).all():
            return float(np.nanmean(values))
    return gravity


def lagged_thrusts(times: Array, wanted: Array, constant: float) -> Array:
    """Thrusts that follow commands, each held to the next one, by a first-order lag [N]."""
    if constant <= 0.0:
        return wanted
    thrusts = wanted.copy()
    for k in range(1, len(times)):
        share = -np.expm1(-(times[k] - times[k - 1]) / constant)
        thrusts[k] = thrusts[k - 1] + share * (wanted[k - 1] - thrusts[k - 1])
    return thrusts

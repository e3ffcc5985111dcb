"""State of a vehicle at an instant before touch, as its log tells it, with its uncertainty."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.identification.observations.channel_window import ChannelWindow
from springback.identification.observations.initial_state import InitialState
from springback.identification.observations.noise import ChannelNoise
from springback.identification.settings import FitSensors, StartFit
from springback.logs.frame_turns import (
    conjugate,
    product,
    rotation_vector,
    vector_quaternion,
    world_vectors,
)
from springback.logs.free_fall import GRAVITY
from springback.logs.recording import ANGULAR_VELOCITY, ATTITUDE, POSITION, SPECIFIC_FORCE, Array

#: Fewest samples of a track, and distance from touch [s] (chosen).
FEWEST, CLEAR = 5, 5e-3
#: Samples from which their own scatter about the polynomial is their noise (chosen).
ENOUGH = 20
#: Half of the part of a track about the instant, at least, and of the gyroscope [s] (chosen).
AROUND, AROUND_GYRO = 0.1, 0.03
#: Largest sum of the coefficients of correlated noise that counts (chosen).
MOST_CORRELATED = 0.95


class MeasuredStart(NamedTuple):
    """State at an instant; its changes are of position, velocity, turn (body) and rate (body)."""

    guess: InitialState
    changes: Array
    """Independent changes of one standard deviation each, shape (changes, 12)."""
    by_clock: Array
    """Change for each second by which the clock of the tracks is off, shape (12,)."""
    by_bias: Array
    """Change for a bias of the gyroscope of 1 rad/s about each axis, shape (3, 12)."""
    sentence: str


class _Line(NamedTuple):
    """Value and rate at an instant, by a polynomial."""

    value: Array  # shape (width,)
    rate: Array
    roots: Array  # of the covariance of both, shape (width, 2, 2)

    @property
    def deviations(self) -> Array:
        """Standard deviations of value and rate, shape (2, width)."""
        return np.asarray(np.linalg.norm(self.roots, axis=2).T)


class _Turn(NamedTuple):
    """Attitude at an instant, and the line of small turns about it, body axes."""

    attitude: Array
    line: _Line


def measured_start(
    readings: Sequence[ChannelWindow],
    at: float,
    touch: float,
    otherwise: InitialState,
    plan: StartFit,
    sensors: FitSensors,
) -> MeasuredStart:
    """State at an instant, by polynomials through the tracks about it, all before touch.

    What an inertial unit tells of turns and of changes of the acceleration is taken out before, so
    that the polynomials hold in flights that a pilot steers, too.

    Args:
        readings: Of the impact.
        at: The instant, in their window [s].
        touch: In their window [s].
        otherwise: For what no track tells.
        plan: Uncertainty of that.
        sensors: Uncertainty of the gyroscope's bias, which a track of attitudes may tell better.
    """
    found = {one.quantity: _in_time(one) for one in readings}
    changes, by_clock, by_bias = list[Array](), np.zeros(12), np.zeros((3, 12))
    guess, told, around = otherwise._replace(tracked=False), list[str](), max(AROUND, touch - at)
    spin = _line(found.get(ANGULAR_VELOCITY), at, touch, AROUND_GYRO, degree=1)
    gyro = None if spin is None else found[ANGULAR_VELOCITY]
    turn = _turn(found.get(ATTITUDE), gyro, at, touch, around)
    bias, known = np.zeros(3), False
    force = found.get(SPECIFIC_FORCE)
    way = None
    if turn is not None and gyro is not None and force is not None:
        way = _Way(force, gyro, turn.attitude, at)
    if (line := _line(found.get(POSITION), at, touch, around, way=way)) is not None:
        guess = guess._replace(position=line.value, velocity=line.rate, tracked=True)
        changes += _changes(line, 0, 3)
        told.append(found[POSITION].name)
        if found[POSITION].other_clock:
            by_clock[0:3] = -line.rate
    else:
        changes += _apart(0, plan.position) + _apart(3, plan.velocity)
        if otherwise.fallen:
            changes[5] = _change(5, GRAVITY * plan.height / otherwise.fallen)
    if turn is not None:
        guess = guess._replace(attitude=turn.attitude)
        drift = float(turn.line.deviations[1].max())
        known = spin is not None and drift < sensors.gyroscope.bias
        bias = -turn.line.rate if known else bias
        changes += _changes(turn.line, 6, 9 if known or spin is None else None)
        told.append(found[ATTITUDE].name)
        if found[ATTITUDE].other_clock:
            by_clock[6:9] = -turn.line.rate
    else:
        changes += _apart(6, plan.attitude)
    if spin is not None:
        guess = guess._replace(angular_velocity=spin.value - bias)
        size = spin.deviations[0]
        changes += [_change(9 + k, float(size[k])) for k in range(3)]
        if not known:
            by_bias[:, 9:12] = -np.eye(3)
        told.append(found[ANGULAR_VELOCITY].name)
    elif turn is not None:
        guess = guess._replace(angular_velocity=turn.line.rate)
    else:
        changes += _apart(9, plan.angular_velocity)
    words = ", ".join([*told, *([] if guess.tracked else ["the scenario"])])
    return MeasuredStart(guess, np.array(changes), by_clock, by_bias, words)


def _in_time(one: ChannelWindow) -> ChannelWindow:
    """A channel at the instants that its samples are of: delays of filter and mean taken out."""
    chain, late = one.chain, 0.0
    if chain.low_pass is not None:
        late += (2.0**0.5 if chain.low_pass_order == 2 else 1.0) / (2.0 * np.pi * chain.low_pass)
    if chain.average is not None:
        late += 0.5 * chain.average
    return one._replace(times=one.times - late) if late > 0.0 else one


def _change(place: int, size: float) -> Array:
    found = np.zeros(12)
    found[place] = size
    return found


def _apart(first: int, size: float) -> list[Array]:
    """Changes along each axis by itself."""
    return [_change(first + k, size) for k in range(3)]


def _changes(line: _Line, value: int, rate: int | None) -> list[Array]:
    """Changes of a value and its rate along each axis."""
    found = []
    for k, root in enumerate(line.roots):
        for column in root.T:
            change = _change(value + k, float(column[0]))
            if rate is not None:
                change[rate + k] = column[1]
            if change.any():
                found.append(change)
    return found


def _slow_deviation(noise: ChannelNoise) -> Array:
    """Deviation of white noise that has the slow parts of this noise."""
    rest = 1.0 - min(float(noise.coefficients.sum()), MOST_CORRELATED)
    return np.asarray(np.maximum(noise.innovation / rest, 0.0))


def _inside(track: ChannelWindow, at: float, touch: float, around: float) -> Any:
    """Rows of a track about an instant, before touch."""
    known = ~np.isnan(track.values).any(axis=1) & (track.times < touch - CLEAR)
    near = known & (np.abs(track.times - at) <= around + 1e-9)
    return np.flatnonzero(near)


def is_tracked(readings: Sequence[ChannelWindow], at: float, touch: float) -> bool:
    """True if a track tells the position at an instant [s] before touch [s]."""
    track = next((one for one in readings if one.quantity == POSITION), None)
    return _line(track, at, touch, max(AROUND, touch - at)) is not None


class _Way(NamedTuple):
    """What an inertial unit tells of the motion about an instant."""

    force: ChannelWindow
    gyro: ChannelWindow
    attitude: Array  # at the instant
    at: float

    def displacement(self, times: Array) -> tuple[Array, Array]:
        """Way by the changes of the acceleration alone, zero with its rate at the instant [m].

        The acceleration is taken as a cubic in time, which leaves most of its noise out.

        Args:
            times: Of a track [s].

        Returns:
            The way, shape (samples, 3), and its independent uncertainties along each axis, shape
            (samples, 3).
        """
        known = ~np.isnan(self.force.values).any(axis=1)
        known &= (self.force.times >= times[0]) & (self.force.times <= times[-1])
        if known.sum() < ENOUGH:
            return np.zeros((len(times), 3)), np.zeros((len(times), 3))
        t = self.force.times[known]
        turned = product(self.attitude, _turned(self.gyro, self.at, t))
        acceleration = world_vectors(turned, self.force.values[known])
        scale = times[-1] - times[0]
        basis = np.vander((t - self.at) / scale, 4, increasing=True)
        found, *_ = np.linalg.lstsq(basis, acceleration, rcond=None)
        powers = np.arange(1, 4)
        far = ((times - self.at) / scale)[:, None] ** (powers + 2)
        ways = scale**2 * (far / ((powers + 1) * (powers + 2)))
        root = np.linalg.cholesky(np.linalg.inv(basis.T @ basis)[1:, 1:])
        return ways @ found[1:], float(_slow_deviation(self.force.noise).max()) * ways @ root


def _line(
    track: ChannelWindow | None,
    at: float,
    touch: float,
    around: float,
    degree: int = 2,
    way: _Way | None = None,
) -> _Line | None:
    if track is None:
        return None
    rows = _inside(track, at, touch, around)
    if len(rows) < FEWEST:
        return None
    times, values = track.times[rows], track.values[rows]
    if way is None:
        return _polynomial(times - at, values, track.noise, degree)
    gone, uncertainties = way.displacement(times)
    line = _polynomial(times - at, values - gone, track.noise, degree)
    moved = _polynomial(times - at, uncertainties, track.noise, degree)
    slopes = np.stack([moved.value, moved.rate])
    whole = line.roots @ line.roots.transpose(0, 2, 1) + slopes @ slopes.T
    return line._replace(roots=np.asarray(np.linalg.cholesky(whole), dtype=np.float64))


def _polynomial(t: Array, values: Array, noise: ChannelNoise, degree: int) -> _Line:
    used = degree if len(t) > 2 * FEWEST else 1
    basis = np.vander(t, used + 1, increasing=True)
    fitted, *_ = np.linalg.lstsq(basis, values, rcond=None)
    root = np.linalg.cholesky(np.linalg.inv(basis.T @ basis)[:2, :2])
    deviation = _slow_deviation(noise)
    if len(t) >= ENOUGH:  # a fast motion may have passed for noise
        rest = (values - basis @ fitted).std(axis=0, ddof=used + 1)
        deviation = np.minimum(deviation, deviation / noise.stationary * rest)
    return _Line(fitted[0], fitted[1], deviation[:, None, None] * root)


def _turn(
    track: ChannelWindow | None, gyro: ChannelWindow | None, at: float, touch: float, around: float
) -> _Turn | None:
    """Attitude at an instant: turns that the gyroscope tells are taken out of the track."""
    if track is None:
        return None
    rows = _inside(track, at, touch, around)
    if len(rows) < FEWEST:
        return None
    t, q = track.times[rows] - at, track.values[rows]
    degree = 2
    if gyro is not None:
        q, degree = product(q, conjugate(_turned(gyro, at, track.times[rows]))), 1
    near = q[int(np.argmin(np.abs(t)))]
    line = _polynomial(t, rotation_vector(product(conjugate(near), q)), track.noise, degree)
    attitude = product(near, vector_quaternion(line.value))
    return _Turn(attitude / np.linalg.norm(attitude), line)


def _turned(gyro: ChannelWindow, at: float, times: Array) -> Array:
    """Turn of the body from an instant to others, by its gyroscope, shape (instants, 4)."""
    known = ~np.isnan(gyro.values).any(axis=1)
    knots = np.unique(np.concatenate([gyro.times[known], [at], times]))
    rates = np.stack([np.interp(knots, gyro.times[known], one) for one in gyro.values[known].T], 1)
    steps = vector_quaternion(0.5 * np.diff(knots)[:, None] * (rates[1:] + rates[:-1]))
    whole = np.zeros((len(knots), 4))
    whole[0, 0] = 1.0
    for k, step in enumerate(steps):
        whole[k + 1] = product(whole[k], step)
    here = whole[int(np.searchsorted(knots, at))]
    return np.asarray(product(conjugate(here), whole[np.searchsorted(knots, times)]))

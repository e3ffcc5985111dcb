"""A tick of the clock aboard: sensors look, pilots decide, witnesses judge, rotors follow.

Each is done for all flights of a group, lane by lane.  Sensors, pilots and witnesses of a user's
own are asked one flight at a time, by the functions of `springback.simulation.onboard`.  Types that
register a `look`, `decide` or `judge` of their own do better: they go over the lanes several times,
each time with something short and without branches, which the compiler lays abreast in vector
registers, and attend to single lanes only where something rare has happened.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from springback.dynamics.air import in_wind
from springback.dynamics.gusts import gust
from springback.kernels.compiler import executor, generic, guard, kernel
from springback.kernels.layout import Buffer, Like, got, put, read, row_of, rows, write
from springback.kernels.trees import leaves, pick, square
from springback.simulation.lanes import places
from springback.simulation.onboard import (
    NoWitness,
    Piloted,
    Touch,
    Truth,
    piloted,
    sensed,
    told,
    witnessed,
)
from springback.simulation.record import FINISHED, FLYING, NOT_FINITE
from springback.vehicle.rotors import all_lagged
from springback.vehicle.state import State

#: Normal numbers that gusts take at each tick, after those of the sensors.
GUST_NOISE = 3
#: Squares of finite commands [N] add up to less than this (chosen: far beyond any).
ABSURD = 1e30


@kernel
def motion_of(shape: Like, b: Buffer, w: int, i: int) -> State:
    """State of one lane."""
    state: State = got(shape.motion.state, b, w, i)
    return state


@kernel
def truth_of(shape: Like, cabin: Like, b: Buffer, g: Buffer, w: int, i: int) -> Truth:
    """The motion of one lane over the last tick."""
    period = got(cabin.guidance.period, g, w, i)
    before = got(cabin.aboard.before, g, w, i)
    gravity = got(shape.model.world.gravity, b, w, i)
    return Truth(before, motion_of(shape, b, w, i), period, gravity)


@kernel
def touch_of(shape: Like, b: Buffer, w: int, i: int) -> Touch:
    """What the record of one lane says of contacts."""
    m, record = shape.record, places(shape, w).record
    return Touch(
        read(m.touching, b, record + row_of(m, "touching"), w, i),
        read(m.contacts, b, record + row_of(m, "contacts"), w, i),
        read(m.last_touch_time, b, record + row_of(m, "last_touch_time"), w, i),
        read(m.ground_time, b, record + row_of(m, "ground_time"), w, i),
    )


@generic
def look(
    sensors: Like, shape: Like, cabin: Like, b: Buffer, g: Buffer, w: int, once: int, tick: float,
    channels: Like, noise: Buffer,
) -> None:  # fmt: skip
    """The sensors of all lanes look.

    Args:
        sensors: Like their settings, by whose type they are chosen.
        shape: What lies in ``b``.
        cabin: What lies in ``g``.
        b: Buffer of the motion.
        g: Buffer of what is aboard: the measurement and the sensors' memory are changed.
        w: Lanes.
        once: It is 1, which the compiler does not know: loops of known length it would unroll, and
            not pack.
        tick: Number of the tick.
        channels: Like the noise of one lane.
        noise: Normal numbers of this tick, channel by channel, lane by lane.
    """
    _look_one_by_one(sensors, shape, cabin, b, g, w, once, tick, channels, noise)


@kernel
def _look_one_by_one(
    sensors: Like, shape: Like, cabin: Like, b: Buffer, g: Buffer, w: int, once: int, tick: float,
    channels: Like, noise: Buffer,
) -> None:  # fmt: skip
    memory = cabin.aboard
    for i in range(w):
        truth = truth_of(shape, cabin, b, g, w, i)
        drawn, remembered = got(channels, noise, w, i), got(memory.sensors, g, w, i)
        seen = sensed(got(sensors, g, w, i), tick, truth, drawn, remembered)
        put(seen.measurement, memory.measurement, g, w, i)
        put(seen.memory, memory.sensors, g, w, i)


@generic
def decide(pilot: Like, cabin: Like, g: Buffer, w: int, once: int, tick: float) -> None:
    """The pilots of all lanes decide.

    Args:
        pilot: Like its settings, by whose type it is chosen.
        cabin: What lies in ``g``.
        g: Buffer of what is aboard: the command and the pilot's memory are changed.
        w: Lanes.
        once: As for `look`.
        tick: Number of the tick.
    """
    _decide_one_by_one(pilot, cabin, g, w, once, tick)


@kernel
def _decide_one_by_one(pilot: Like, cabin: Like, g: Buffer, w: int, once: int, tick: float) -> None:
    memory = cabin.aboard
    for i in range(w):
        time = tick * got(cabin.guidance.period, g, w, i)
        seen, thought = got(memory.measurement, g, w, i), got(memory.pilot, g, w, i)
        said = piloted(got(pilot, g, w, i), time, seen, thought)
        put(said.memory, memory.pilot, g, w, i)
        put(said.thrust, memory.command, g, w, i)


class _Settings(NamedTuple):
    pilot: Any
    period: float


class _Memory(NamedTuple):
    measurement: Any
    pilot: Any
    command: tuple[float, ...]


class _Cockpit(NamedTuple):
    """A cabin with nothing but a pilot in it."""

    guidance: _Settings
    aboard: _Memory


def decided(
    pilot: Any, period: float, tick: int, measurement: Any, memory: Any, rotors: int
) -> Piloted:
    """What a pilot that registers a `decide` does at a tick, in plain Python.

    Args:
        pilot: Settings.
        period: Of the clock [s].
        tick: Number of the tick.
        measurement: What the sensors say.
        memory: What the pilot remembers.
        rotors: Number of rotors.
    """
    command = (0.0,) * rotors
    cabin = _Cockpit(_Settings(pilot, period), _Memory(measurement, memory, command))
    g, like = np.array(leaves(cabin)), Like(cabin)
    decide(like.guidance.pilot, like, g, 1, 1, float(tick))
    after = got(like.aboard, g, 1, 0)
    return Piloted(after.command, after.pilot)


@generic
def judge(
    witness: Like, shape: Like, cabin: Like, b: Buffer, g: Buffer, w: int, once: int, tick: float
) -> None:
    """The witnesses of all lanes judge, after the pilots.

    Args:
        witness: Like its settings, by whose type it is chosen.
        shape: What lies in ``b``.
        cabin: What lies in ``g``.
        b: Buffer of the motion.
        g: Buffer of what is aboard: the witness's memory is changed.
        w: Lanes.
        once: As for `look`.
        tick: Number of the tick.
    """
    judge_lanes(witness, shape, cabin, b, g, w, once, tick)


@kernel
def judge_lanes(
    witness: Like, shape: Like, cabin: Like, b: Buffer, g: Buffer, w: int, once: int, tick: float
) -> None:
    """`witnessed` for all lanes, abreast where it has no branches; arguments as for `judge`."""
    memory = cabin.aboard
    for i in range(w * once):
        time, thought = tick * got(cabin.guidance.period, g, w, i), got(memory.pilot, g, w, i)
        state, touch = motion_of(shape, b, w, i), touch_of(shape, b, w, i)
        known = got(memory.witness, g, w, i)
        kept = witnessed(got(witness, g, w, i), time, state, touch, thought, known)
        put(kept, memory.witness, g, w, i)


@judge.register(NoWitness)
@kernel
def _nobody_judges(
    witness: Like, shape: Like, cabin: Like, b: Buffer, g: Buffer, w: int, once: int, tick: float
) -> None:
    return


@guard
def _status_after(thrust: tuple[float, ...], status: float) -> float:
    """Status of a flight after its pilot has commanded: not finite where a command is not."""
    return status if square(thrust) < ABSURD else NOT_FINITE


@kernel
def written(cabin: Like, g: Buffer, tick: float, page: Buffer) -> None:
    """A page of the diary of a single flight: time, command, thrust, measurement, words."""
    memory = cabin.aboard
    page[0] = tick * got(cabin.guidance.period, g, 1, 0)
    command, thrust = got(memory.command, g, 1, 0), got(memory.thrust, g, 1, 0)
    n, seen = rows(memory.command), rows(memory.measurement)
    write(command, page, 1, 1, 0)
    write(thrust, page, 1 + n, 1, 0)
    write(got(memory.measurement, g, 1, 0), page, 1 + 2 * n, 1, 0)
    words = told(got(cabin.guidance.pilot, g, 1, 0), got(memory.pilot, g, 1, 0))
    write(words, page, 1 + 2 * n + seen, 1, 0)


@executor(nogil=True)
def ticked(
    shape: Like,
    cabin: Like,
    b: Buffer,
    g: Buffer,
    lanes: tuple[int, ...],
    ones: Any,
    tick: float,
    channels: Like,
    noise: Buffer,
    diary: Buffer,
    line: int,
) -> None:
    """At a tick the sensors of every lane look and the pilots decide.

    Args:
        shape: What lies in the buffer of the motion.
        cabin: What lies in the buffer of what is aboard.
        b: Buffer of the motion.
        g: Buffer of what is aboard.
        lanes: A tuple as long as a group is wide.
        ones: Of shape (1,), see `look`.
        tick: Number of the tick.
        channels: Noise of the sensors at a tick.
        noise: Normal numbers of this tick, channel by channel, lane by lane.
        diary: Of a single flight, one tick a row; empty for none.
        line: Row of the diary.
    """
    w, settings, memory, at = len(lanes), cabin.guidance, cabin.aboard, places(shape, len(lanes))
    once = ones.shape[0]  # so that the compiler knows that it is not below zero
    look(settings.sensors, shape, cabin, b, g, w, once, tick, channels, noise)
    for i in range(w * once):
        put(motion_of(shape, b, w, i), memory.before, g, w, i)
    decide(settings.pilot, cabin, g, w, once, tick)
    judge(settings.witness, shape, cabin, b, g, w, once, tick)
    for i in range(w * once):
        status = read(shape.record.status, b, at.status, w, i)
        write(_status_after(got(memory.command, g, w, i), status), b, at.status, w, i)
    if w == 1 and diary.shape[0] > 0:
        written(cabin, g, tick, diary[line])


@executor(nogil=True)
def powered(
    shape: Like, cabin: Like, b: Buffer, g: Buffer, lanes: tuple[int, ...], ones: Any, tick: float,
    last: float, gusts: Like, noise: Buffer, channel: int,
) -> None:  # fmt: skip
    """The rotors of every lane follow their commands, the wind blows, until the next tick.

    Args:
        shape: What lies in the buffer of the motion.
        cabin: What lies in the buffer of what is aboard.
        b: Buffer of the motion.
        g: Buffer of what is aboard.
        lanes: A tuple as long as a group is wide.
        ones: Of shape (1,), see `look`.
        tick: Number of the tick that begins.
        last: End of the flight [s].
        gusts: Noise of the gusts at a tick.
        noise: Normal numbers of this tick, channel by channel, lane by lane.
        channel: The first of those that are the gusts'.
    """
    w, settings, memory, model = len(lanes), cabin.guidance, cabin.aboard, shape.model
    status, once = places(shape, w).status, ones.shape[0]
    for i in range(w * once):
        thrust, command = got(memory.thrust, g, w, i), got(memory.command, g, w, i)
        period = got(settings.period, g, w, i)
        rotors, lag = got(settings.rotors, g, w, i), got(settings.lag, g, w, i)
        spun = all_lagged(rotors, thrust, command, lag)
        put(spun.thrust, memory.thrust, g, w, i)
        put(spun.mean, model.thrust, b, w, i)
        put(min((tick + 1.0) * period, last), model.timing.until, b, w, i)
        # Where it came to this tick before its neighbours it flies on.
        so_far = read(shape.record.status, b, status, w, i)
        write(pick(so_far == FINISHED, FLYING, so_far), b, status, w, i)
    for i in range(w * once):
        drawn, weather = read(gusts, noise, channel, w, i), got(settings.weather, g, w, i)
        blown = gust(weather, drawn, got(memory.weather, g, w, i))
        wind = got(settings.mean_wind, g, w, i) + blown.velocity
        put(blown.memory, memory.weather, g, w, i)
        put(in_wind(got(model.air, b, w, i), wind), model.air, b, w, i)

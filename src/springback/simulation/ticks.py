"""A tick of the onboard clock: sensors look, pilots decide, evaluators judge, rotors follow.

Each is done for all flights of a group, lane by lane.  Sensors, pilots and evaluators of a user's
own are asked one flight at a time, by the functions of `springback.simulation.onboard`.  Types that
register a `look`, `decide` or `evaluate` of their own do better: they go over the lanes several
times, each time with something short and without branches, which the compiler lays abreast in
vector registers, and attend to single lanes only where something rare has happened.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from springback.dynamics.air import in_wind
from springback.dynamics.gusts import gust
from springback.kernels.compiler import executor, generic, guard, kernel
from springback.kernels.layout import Buffer, TreeLayout, load, read, row_of, rows, store, write
from springback.kernels.trees import leaves, select, square
from springback.simulation.lanes import places
from springback.simulation.onboard import (
    ContactReport,
    NoEvaluator,
    PilotOutput,
    Truth,
    evaluated,
    pilot_step,
    sensed,
    telemetry_of,
)
from springback.simulation.record import FINISHED, FLYING, NOT_FINITE
from springback.vehicle.rotors import lagged_thrusts
from springback.vehicle.state import State

#: Normal numbers that gusts take at each tick, after those of the sensors.
GUST_NOISE = 3
#: Squares of finite commands [N] add up to less than this (chosen: far beyond any).
ABSURD = 1e30


@kernel
def motion_of(shape: TreeLayout, b: Buffer, w: int, i: int) -> State:
    """State of one lane."""
    state: State = load(shape.motion.state, b, w, i)
    return state


@kernel
def truth_of(
    shape: TreeLayout, avionics: TreeLayout, b: Buffer, g: Buffer, w: int, i: int
) -> Truth:
    """The motion of one lane over the last tick."""
    period = load(avionics.systems.period, g, w, i)
    before = load(avionics.onboard.before, g, w, i)
    gravity = load(shape.model.world.gravity, b, w, i)
    return Truth(before, motion_of(shape, b, w, i), period, gravity)


@kernel
def touch_of(shape: TreeLayout, b: Buffer, w: int, i: int) -> ContactReport:
    """What the record of one lane says of contacts."""
    m, record = shape.record, places(shape, w).record
    return ContactReport(
        read(m.touching, b, record + row_of(m, "touching"), w, i),
        read(m.contacts, b, record + row_of(m, "contacts"), w, i),
        read(m.last_touch_time, b, record + row_of(m, "last_touch_time"), w, i),
        read(m.ground_time, b, record + row_of(m, "ground_time"), w, i),
    )


@generic
def look(
    sensors: TreeLayout, shape: TreeLayout, avionics: TreeLayout, b: Buffer, g: Buffer, w: int,
    once: int, tick: float,
    channels: TreeLayout, noise: Buffer,
) -> None:  # fmt: skip
    """The sensors of all lanes look.

    Args:
        sensors: Like their settings, by whose type they are chosen.
        shape: What lies in ``b``.
        avionics: What lies in ``g``.
        b: Buffer of the motion.
        g: Buffer of what is aboard: the measurement and the sensors' memory are changed.
        w: Lanes.
        once: It is 1, which the compiler does not know: loops of known length it would unroll, and
            not pack.
        tick: Number of the tick.
        channels: Like the noise of one lane.
        noise: Normal numbers of this tick, channel by channel, lane by lane.
    """
    _look_one_by_one(sensors, shape, avionics, b, g, w, once, tick, channels, noise)


@kernel
def _look_one_by_one(
    sensors: TreeLayout, shape: TreeLayout, avionics: TreeLayout, b: Buffer, g: Buffer, w: int,
    once: int, tick: float,
    channels: TreeLayout, noise: Buffer,
) -> None:  # fmt: skip
    memory = avionics.onboard
    for i in range(w):
        truth = truth_of(shape, avionics, b, g, w, i)
        drawn, remembered = load(channels, noise, w, i), load(memory.sensors, g, w, i)
        seen = sensed(load(sensors, g, w, i), tick, truth, drawn, remembered)
        store(seen.measurement, memory.measurement, g, w, i)
        store(seen.memory, memory.sensors, g, w, i)


@generic
def decide(
    pilot: TreeLayout, avionics: TreeLayout, g: Buffer, w: int, once: int, tick: float
) -> None:
    """The pilots of all lanes decide.

    Args:
        pilot: Like its settings, by whose type it is chosen.
        avionics: What lies in ``g``.
        g: Buffer of what is aboard: the command and the pilot's memory are changed.
        w: Lanes.
        once: As for `look`.
        tick: Number of the tick.
    """
    _decide_one_by_one(pilot, avionics, g, w, once, tick)


@kernel
def _decide_one_by_one(
    pilot: TreeLayout, avionics: TreeLayout, g: Buffer, w: int, once: int, tick: float
) -> None:
    memory = avionics.onboard
    for i in range(w):
        time = tick * load(avionics.systems.period, g, w, i)
        seen, thought = load(memory.measurement, g, w, i), load(memory.pilot, g, w, i)
        said = pilot_step(load(pilot, g, w, i), time, seen, thought)
        store(said.memory, memory.pilot, g, w, i)
        store(said.thrust, memory.command, g, w, i)


class _Settings(NamedTuple):
    pilot: Any
    period: float


class _Memory(NamedTuple):
    measurement: Any
    pilot: Any
    command: tuple[float, ...]


class _Cockpit(NamedTuple):
    """A cabin with nothing but a pilot in it."""

    systems: _Settings
    onboard: _Memory


def decided(
    pilot: Any, period: float, tick: int, measurement: Any, memory: Any, rotors: int
) -> PilotOutput:
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
    avionics = _Cockpit(_Settings(pilot, period), _Memory(measurement, memory, command))
    g, like = np.array(leaves(avionics)), TreeLayout(avionics)
    decide(like.systems.pilot, like, g, 1, 1, float(tick))
    after = load(like.onboard, g, 1, 0)
    return PilotOutput(after.command, after.pilot)


@generic
def evaluate(
    evaluator: TreeLayout,
    shape: TreeLayout,
    avionics: TreeLayout,
    b: Buffer,
    g: Buffer,
    w: int,
    once: int,
    tick: float,
) -> None:
    """The witnesses of all lanes judge, after the pilots.

    Args:
        evaluator: Like its settings, by whose type it is chosen.
        shape: What lies in ``b``.
        avionics: What lies in ``g``.
        b: Buffer of the motion.
        g: Buffer of what is aboard: the witness's memory is changed.
        w: Lanes.
        once: As for `look`.
        tick: Number of the tick.
    """
    evaluate_lanes(evaluator, shape, avionics, b, g, w, once, tick)


@kernel
def evaluate_lanes(
    evaluator: TreeLayout,
    shape: TreeLayout,
    avionics: TreeLayout,
    b: Buffer,
    g: Buffer,
    w: int,
    once: int,
    tick: float,
) -> None:
    """`evaluated` for all lanes, abreast where it has no branches; arguments as for `evaluate`."""
    memory = avionics.onboard
    for i in range(w * once):
        time, thought = tick * load(avionics.systems.period, g, w, i), load(memory.pilot, g, w, i)
        state, touch = motion_of(shape, b, w, i), touch_of(shape, b, w, i)
        known = load(memory.evaluator, g, w, i)
        kept = evaluated(load(evaluator, g, w, i), time, state, touch, thought, known)
        store(kept, memory.evaluator, g, w, i)


@evaluate.register(NoEvaluator)
@kernel
def _nobody_judges(
    evaluator: TreeLayout,
    shape: TreeLayout,
    avionics: TreeLayout,
    b: Buffer,
    g: Buffer,
    w: int,
    once: int,
    tick: float,
) -> None:
    return


@guard
def _status_after(thrust: tuple[float, ...], status: float) -> float:
    """Status of a flight after its pilot has commanded: not finite where a command is not."""
    return status if square(thrust) < ABSURD else NOT_FINITE


@kernel
def written(avionics: TreeLayout, g: Buffer, tick: float, page: Buffer) -> None:
    """A page of the telemetry of a single flight: time, command, thrust, measurement, words."""
    memory = avionics.onboard
    page[0] = tick * load(avionics.systems.period, g, 1, 0)
    command, thrust = load(memory.command, g, 1, 0), load(memory.thrust, g, 1, 0)
    n, seen = rows(memory.command), rows(memory.measurement)
    write(command, page, 1, 1, 0)
    write(thrust, page, 1 + n, 1, 0)
    write(load(memory.measurement, g, 1, 0), page, 1 + 2 * n, 1, 0)
    words = telemetry_of(load(avionics.systems.pilot, g, 1, 0), load(memory.pilot, g, 1, 0))
    write(words, page, 1 + 2 * n + seen, 1, 0)


@executor(nogil=True)
def ticked(
    shape: TreeLayout,
    avionics: TreeLayout,
    b: Buffer,
    g: Buffer,
    lanes: tuple[int, ...],
    ones: Any,
    tick: float,
    channels: TreeLayout,
    noise: Buffer,
    telemetry: Buffer,
    line: int,
) -> None:
    """At a tick the sensors of every lane look and the pilots decide.

    Args:
        shape: What lies in the buffer of the motion.
        avionics: What lies in the buffer of what is aboard.
        b: Buffer of the motion.
        g: Buffer of what is aboard.
        lanes: A tuple as long as a group is wide.
        ones: Of shape (1,), see `look`.
        tick: Number of the tick.
        channels: Noise of the sensors at a tick.
        noise: Normal numbers of this tick, channel by channel, lane by lane.
        telemetry: Of a single flight, one tick a row; empty for none.
        line: Row of the telemetry.
    """
    w, settings, memory, at = (
        len(lanes),
        avionics.systems,
        avionics.onboard,
        places(shape, len(lanes)),
    )
    once = ones.shape[0]  # so that the compiler knows that it is not below zero
    look(settings.sensors, shape, avionics, b, g, w, once, tick, channels, noise)
    for i in range(w * once):
        store(motion_of(shape, b, w, i), memory.before, g, w, i)
    decide(settings.pilot, avionics, g, w, once, tick)
    evaluate(settings.evaluator, shape, avionics, b, g, w, once, tick)
    for i in range(w * once):
        status = read(shape.record.status, b, at.status, w, i)
        write(_status_after(load(memory.command, g, w, i), status), b, at.status, w, i)
    if w == 1 and telemetry.shape[0] > 0:
        written(avionics, g, tick, telemetry[line])


@executor(nogil=True)
def powered(
    shape: TreeLayout, avionics: TreeLayout, b: Buffer, g: Buffer, lanes: tuple[int, ...],
    ones: Any, tick: float,
    last: float, gusts: TreeLayout, noise: Buffer, channel: int,
) -> None:  # fmt: skip
    """The rotors of every lane follow their commands, the wind blows, until the next tick.

    Args:
        shape: What lies in the buffer of the motion.
        avionics: What lies in the buffer of what is aboard.
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
    w, settings, memory, model = len(lanes), avionics.systems, avionics.onboard, shape.model
    status, once = places(shape, w).status, ones.shape[0]
    for i in range(w * once):
        thrust, command = load(memory.thrust, g, w, i), load(memory.command, g, w, i)
        period = load(settings.period, g, w, i)
        rotors, lag = load(settings.rotors, g, w, i), load(settings.lag, g, w, i)
        spun = lagged_thrusts(rotors, thrust, command, lag)
        store(spun.thrust, memory.thrust, g, w, i)
        store(spun.mean, model.thrust, b, w, i)
        store(min((tick + 1.0) * period, last), model.timing.until, b, w, i)
        # Where it came to this tick before its neighbours it flies on.
        so_far = read(shape.record.status, b, status, w, i)
        write(select(so_far == FINISHED, FLYING, so_far), b, status, w, i)
    for i in range(w * once):
        drawn, weather = read(gusts, noise, channel, w, i), load(settings.weather, g, w, i)
        blown = gust(weather, drawn, load(memory.weather, g, w, i))
        wind = load(settings.mean_wind, g, w, i) + blown.velocity
        store(blown.memory, memory.weather, g, w, i)
        store(in_wind(load(model.air, b, w, i), wind), model.air, b, w, i)

"""A tick of the on-board clock: sensors measure, pilots decide, evaluators judge, rotors follow.

Each stage is done for all flights of a group, lane by lane.  A user's own sensors, pilots and
evaluators are called for one flight at a time, through the functions of
`springback.simulation.onboard`.  Types that register a `look`, `decide` or `evaluate` of their own
are faster: they go over the lanes several times, each time with something short and without
branches, which the compiler packs into vector registers, and treat single lanes only where
something rare has happened.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from springback.dynamics.air import in_wind
from springback.dynamics.gusts import gust
from springback.kernels.compiler import executor, generic, guard, kernel
from springback.kernels.layout import (
    Buffer,
    SplitBuffer,
    TreeLayout,
    load,
    read,
    row_of,
    rows,
    store,
    write,
)
from springback.kernels.trees import (
    field_of,
    leaves,
    maximum,
    select,
    square,
    tree_map,
)
from springback.simulation.executor import TrajectoryLog
from springback.simulation.lanes import places
from springback.simulation.measuring.record import FINISHED, FLYING, NOT_FINITE, Contacts
from springback.simulation.onboard import (
    NoEvaluator,
    PilotOutput,
    Relay,
    Truth,
    alarm_of,
    evaluator_step,
    own_memory,
    pilot_step,
    report_after,
    report_of,
    sensor_step,
    telemetry_of,
)
from springback.vehicle.rotor_stop import (
    Hits,
    NoStop,
    RotorStop,
    forgotten,
    is_hit,
    is_stopped,
    reactions_of,
    rotor_step,
    stopped_since,
)
from springback.vehicle.rotors import lagged_thrusts
from springback.vehicle.state import State

#: Normal numbers that gusts take at each tick, after those of the sensors.
GUST_NOISE = 3
#: Limit of the sum of squares of finite commands [N²] (chosen: far beyond any).
ABSURD = 1e30


class Layouts(NamedTuple):
    """Layouts of the buffers of guided flights, and of the noise at a tick."""

    shape: TreeLayout  # of the motion's buffers
    avionics: TreeLayout  # of the on-board buffers
    channels: TreeLayout  # noise of the sensors of one flight
    gusts: TreeLayout  # noise of the gusts of one flight


class FlightBuffers(NamedTuple):
    """Buffers of guided flights: of some groups, or of one."""

    motion: Buffer  # shape ([groups,] rows x lanes)
    onboard: Any  # the same; a `SplitBuffer` on a GPU
    lanes: tuple[int, ...]  # as long as a group is wide


class FlightLog(NamedTuple):
    """Trajectory and telemetry of a single flight; empty if they are not recorded."""

    trajectory: TrajectoryLog
    telemetry: Buffer  # one tick a row


class Lanes(NamedTuple):
    """On-board systems of a group at a tick: all that a pilot can reach."""

    avionics: TreeLayout  # layout of ``onboard``
    onboard: Buffer | SplitBuffer
    width: int
    once: int
    """1, which the compiler does not know: it would unroll a loop of known length, not pack it."""
    tick: float  # number of the tick


class Group(NamedTuple):
    """A group of flights at a tick: all that sensors and evaluators can reach.

    Executors make it: a kernel counts no references, so it must not return arrays.
    """

    lanes: Lanes
    shape: TreeLayout  # layout of ``motion``
    motion: Buffer


class TickNoise(NamedTuple):
    """Normal numbers of a group at a tick."""

    channels: TreeLayout  # like those of one lane
    drawn: Buffer  # channel by channel, lane by lane
    first: int  # first channel of ``channels``


def layouts_of(shape: Any, avionics: Any, channels: int) -> Layouts:
    """Layouts of guided flights whose sensors take some channels of noise."""
    sensors, gusts = (0.0,) * channels, (0.0,) * GUST_NOISE
    return Layouts(*map(TreeLayout, (shape, avionics, sensors, gusts)))


@kernel
def state_of(group: Group, i: int) -> State:
    """State of one lane."""
    state: State = load(group.shape.motion.state, group.motion, group.lanes.width, i)
    return state


@kernel
def truth_of(group: Group, i: int) -> Truth:
    """Motion of one lane over the last tick."""
    avionics, g, w = group.lanes.avionics, group.lanes.onboard, group.lanes.width
    period = load(avionics.systems.period, g, w, i)
    before = load(avionics.onboard.before, g, w, i)
    gravity = load(group.shape.model.world.gravity, group.motion, w, i)
    return Truth(before, state_of(group, i), period, gravity)


@kernel
def contacts_of(group: Group, i: int) -> Contacts:
    """Contacts of one lane so far."""
    record, w = group.shape.record, group.lanes.width
    row = places(group.shape, w).record + row_of(record, "contacts")
    contacts: Contacts = read(record.contacts, group.motion, row, w, i)
    return contacts


@generic
def look(sensors: TreeLayout, group: Group, noise: TickNoise) -> None:
    """Run the sensors of all lanes.

    Args:
        sensors: Layout of their settings, on whose type it dispatches.
        group: Measurement and memory of the sensors are changed.
        noise: For all sensors.
    """
    _look_one_by_one(sensors, group, noise)


@kernel
def _look_one_by_one(sensors: TreeLayout, group: Group, noise: TickNoise) -> None:
    avionics, g, w, _, tick = group.lanes
    memory = avionics.onboard
    for i in range(w):
        drawn, before = load(noise.channels, noise.drawn, w, i), load(memory.sensors, g, w, i)
        after = sensor_step(load(sensors, g, w, i), tick, truth_of(group, i), drawn, before)
        store(after.measurement, memory.measurement, g, w, i)
        store(after.memory, memory.sensors, g, w, i)


@generic
def decide(pilot: TreeLayout, lanes: Lanes) -> None:
    """Run the pilots of all lanes.

    Args:
        pilot: Layout of its settings, on whose type it dispatches.
        lanes: Command and memory of the pilot are changed.
    """
    _decide_one_by_one(pilot, lanes)


@kernel
def _decide_one_by_one(pilot: TreeLayout, lanes: Lanes) -> None:
    avionics, g, w, _, tick = lanes
    memory = avionics.onboard
    for i in range(w):
        time = tick * load(avionics.systems.period, g, w, i)
        measurement, before = load(memory.measurement, g, w, i), load(memory.pilot, g, w, i)
        output = pilot_step(load(pilot, g, w, i), time, measurement, before.own)
        store(output.memory, memory.pilot.own, g, w, i)
        store(report_after(alarm_of(output), time, before.report), memory.pilot.report, g, w, i)
        store(output.thrust, memory.command, g, w, i)


@decide.register(Relay)
@kernel
def _decide_outside(pilot: TreeLayout, lanes: Lanes) -> None:
    return


def decides_alone(pilot: Any) -> bool:
    """True for a pilot that is called for one flight at a time, as the user's own are."""
    return decide.dispatch(type(pilot)) in (decide.dispatch(object), _decide_outside)


class _Settings(NamedTuple):
    pilot: Any
    period: float


class _Memory(NamedTuple):
    measurement: Any
    pilot: Any
    command: tuple[float, ...]


class _Cockpit(NamedTuple):
    """Avionics that consist of a pilot only."""

    systems: _Settings
    onboard: _Memory


def pilot_output(
    pilot: Any, period: float, tick: int, measurement: Any, memory: Any, rotors: int
) -> PilotOutput:
    """Output at one tick of a pilot that registers a `decide`; plain Python.

    Args:
        pilot: Settings.
        period: Of the clock [s].
        tick: Number of the tick.
        measurement: Output of the sensors.
        memory: Memory of the pilot.
        rotors: Number of rotors.
    """
    command = (0.0,) * rotors
    avionics = _Cockpit(_Settings(pilot, period), _Memory(measurement, memory, command))
    g, like = np.array(leaves(avionics)), TreeLayout(avionics)
    decide(like.systems.pilot, Lanes(like, g, 1, 1, float(tick)))
    after = load(like.onboard, g, 1, 0)
    return PilotOutput(after.command, after.pilot)


@generic
def evaluate(evaluator: TreeLayout, group: Group) -> None:
    """Run the evaluators of all lanes, after the pilots.

    Args:
        evaluator: Layout of its settings, on whose type it dispatches.
        group: Memory of the evaluator is changed.
    """
    evaluate_lanes(evaluator, group)


@kernel
def evaluate_lanes(evaluator: TreeLayout, group: Group) -> None:
    """`evaluator_step` for all lanes, packed where it has no branches."""
    avionics, g, w, once, tick = group.lanes
    memory = avionics.onboard
    for i in range(w * once):
        time, pilot = tick * load(avionics.systems.period, g, w, i), load(memory.pilot, g, w, i)
        state, contacts = state_of(group, i), contacts_of(group, i)
        before = load(memory.evaluator, g, w, i)
        after = evaluator_step(load(evaluator, g, w, i), time, state, contacts, pilot, before)
        store(after, memory.evaluator, g, w, i)


@evaluate.register(NoEvaluator)
@kernel
def _evaluate_nothing(evaluator: TreeLayout, group: Group) -> None:
    return


@generic
def turn_rotors(stop: TreeLayout, group: Group) -> None:
    """Turn the rotors of all lanes over a tick, after the pilots: they follow their commands.

    Args:
        stop: Layout of what stops them, on whose type it dispatches.
        group: Thrust in the memory of the avionics and in the model of the motion is changed.
    """
    raise TypeError(f"{type(stop).__name__} stops no rotor; register turn_rotors for it")


@turn_rotors.register(NoStop)
@kernel
def _turn_on(stop: TreeLayout, group: Group) -> None:
    avionics, g, w, once, _ = group.lanes
    settings, memory = avionics.systems, avionics.onboard
    for i in range(w * once):
        thrust, command = load(memory.thrust, g, w, i), load(memory.command, g, w, i)
        rotors, lag = load(settings.rotors, g, w, i), load(settings.lag, g, w, i)
        spun = lagged_thrusts(rotors, thrust, command, lag)
        store(spun.thrust, memory.thrust, g, w, i)
        store(spun.mean, group.shape.model.thrust, group.motion, w, i)


@turn_rotors.register(RotorStop)
@kernel
def _turn_until_hit(stop: TreeLayout, group: Group) -> None:
    avionics, g, w, _, tick = group.lanes
    settings, memory, b, shape = avionics.systems, avionics.onboard, group.motion, group.shape
    row = places(shape, w).record + row_of(shape.record, "hits")
    for i in range(w):
        thrust, command = load(memory.thrust, g, w, i), load(memory.command, g, w, i)
        rotors, lag, limits = (
            load(settings.rotors, g, w, i), load(settings.lag, g, w, i), load(stop, g, w, i),
        )  # fmt: skip
        now, seen = tick * limits.period, read(shape.record.hits, b, row, w, i).rotors
        any_hit = maximum(tree_map(is_hit, (seen,), (limits,)))
        since = tree_map(
            stopped_since, (load(memory.stopped, g, w, i), seen), (any_hit, limits, now)
        )
        stopped = tree_map(is_stopped, (since,), (now,))
        spun = tree_map(rotor_step, (thrust, command, stopped), (rotors, lag, limits))
        after = field_of(spun, "thrust")
        craft = load(shape.model.airframe, b, w, i)
        store(since, memory.stopped, g, w, i)
        store(after, memory.thrust, g, w, i)
        store(field_of(spun, "mean"), shape.model.thrust, b, w, i)
        turning = reactions_of(craft.rotors, craft.arms, thrust, after, limits)
        store(turning, shape.model.reaction, b, w, i)
        write(Hits(tree_map(forgotten, (seen, stopped), (now,))), b, row, w, i)


@guard
def _status_after(thrust: tuple[float, ...], status: float) -> float:
    """Status of a flight after a command: `NOT_FINITE` if the command is."""
    return status if square(thrust) < ABSURD else NOT_FINITE


@kernel
def write_telemetry(lanes: Lanes, row: Buffer) -> None:
    """Write a row of the telemetry of a single flight.

    Its columns are time, command, thrust, measurement, the pilot's telemetry, its report, and since
    when each rotor stands, where hits stop them.
    """
    avionics, g, _, _, tick = lanes
    memory = avionics.onboard
    row[0] = tick * load(avionics.systems.period, g, 1, 0)
    command, thrust = load(memory.command, g, 1, 0), load(memory.thrust, g, 1, 0)
    n, measured = rows(memory.command), rows(memory.measurement)
    write(command, row, 1, 1, 0)
    write(thrust, row, 1 + n, 1, 0)
    write(load(memory.measurement, g, 1, 0), row, 1 + 2 * n, 1, 0)
    remembered = load(memory.pilot, g, 1, 0)
    telemetry = telemetry_of(load(avionics.systems.pilot, g, 1, 0), own_memory(remembered))
    write(telemetry, row, 1 + 2 * n + measured, 1, 0)
    report, after = report_of(remembered), 1 + 2 * n + measured + rows(telemetry)
    write(report, row, after, 1, 0)
    write(load(memory.stopped, g, 1, 0), row, after + rows(report), 1, 0)


@executor(nogil=True)
def sense_and_decide(
    layouts: Layouts, buffers: FlightBuffers, tick: int, drawn: Buffer, log: FlightLog
) -> None:
    """Run sensors and pilots of a group at a tick.

    Args:
        layouts: Of the buffers.
        buffers: Of one group.
        tick: Number of the tick.
        drawn: Normal numbers of this tick, channel by channel, lane by lane.
        log: Of a single flight.
    """
    # From the shape of an array the compiler knows that ``once`` is not below zero.
    w, once, avionics = len(buffers.lanes), log.trajectory.used.shape[0], layouts.avionics
    g, b, shape = buffers.onboard, buffers.motion, layouts.shape
    group = Group(Lanes(avionics, g, w, once, float(tick)), shape, b)
    settings, memory = avionics.systems, avionics.onboard
    look(settings.sensors, group, TickNoise(layouts.channels, drawn, 0))
    for i in range(w * once):
        store(state_of(group, i), memory.before, g, w, i)
    decide(settings.pilot, group.lanes)
    row = places(shape, w).status
    for i in range(w * once):
        status = read(shape.record.stepping.status, b, row, w, i)
        write(_status_after(load(memory.command, g, w, i), status), b, row, w, i)
    if w == 1 and log.telemetry.shape[0] > 0:
        write_telemetry(group.lanes, log.telemetry[tick])


@executor(nogil=True)
def drive_rotors(
    layouts: Layouts,
    buffers: FlightBuffers,
    tick: int,
    drawn: Buffer,
    log: FlightLog,
    duration: float,
) -> None:
    """Run the evaluators; set thrust and wind until the next tick: rotors follow their commands.

    Evaluators come after pilots in plain Python, which are called between the two executors.

    Args:
        layouts: Of the buffers.
        buffers: Of one group.
        tick: Number of the tick that begins.
        drawn: Normal numbers of this tick, channel by channel, lane by lane.
        log: Of a single flight.
        duration: Of the flight [s].
    """
    w, once, now = len(buffers.lanes), log.trajectory.used.shape[0], float(tick)
    g, b, shape = buffers.onboard, buffers.motion, layouts.shape
    settings, memory = layouts.avionics.systems, layouts.avionics.onboard
    model, row, first = shape.model, places(shape, w).status, rows(layouts.channels)
    group = Group(Lanes(layouts.avionics, g, w, once, now), shape, b)
    evaluate(settings.evaluator, group)
    turn_rotors(settings.stop, group)
    for i in range(w * once):
        period = load(settings.period, g, w, i)
        store(min((now + 1.0) * period, duration), model.timing.until, b, w, i)
        # A flight that reached this tick before its neighbours flies on.
        status = read(shape.record.stepping.status, b, row, w, i)
        write(select(status == FINISHED, FLYING, status), b, row, w, i)
    for i in range(w * once):
        numbers, weather = read(layouts.gusts, drawn, first, w, i), load(settings.weather, g, w, i)
        blown = gust(weather, numbers, load(memory.weather, g, w, i))
        wind = load(settings.mean_wind, g, w, i) + blown.velocity
        store(blown.memory, memory.weather, g, w, i)
        store(in_wind(load(model.air, b, w, i), wind), model.air, b, w, i)

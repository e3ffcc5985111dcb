"""Flights with sensors, a pilot and rotors: the loop over the ticks of the on-board clock.

The equations of motion are those of `springback.simulation.executor`, called from tick to tick; the
pilot is compiled separately, so that for a new pilot the physics is not compiled again.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.kernels.compiler import Origin, executor, user_executor, with_globals
from springback.kernels.concurrent.compilation import compile_with_help
from springback.kernels.layout import Buffer, TreeLayout, row_of, rows, zeros
from springback.kernels.trees import leaves, names, rebuilt
from springback.simulation.executor import TrajectoryLog, advance, has_space, to_tick
from springback.simulation.flight import (
    LOG_ROWS,
    SLICE,
    Executor,
    FlightRecord,
    Trace,
    empty_log,
    flight_buffers,
    flight_records,
    is_split,
    own_types,
    shape_of,
    sources,
    trace_columns,
)
from springback.simulation.lanes import SplitFlight, lanes_of
from springback.simulation.measuring.record import Model
from springback.simulation.noise import (
    NoiseSource,
    NoiseStream,
    generate,
    stored_stream,
)
from springback.simulation.onboard import (
    AlarmReport,
    Avionics,
    OnboardState,
    OnboardSystems,
    PilotOutput,
    Truth,
    own_memory,
    report_after,
    report_of,
    sensor_step,
    telemetry_of,
    user_pilot_memory,
)
from springback.simulation.stages import rates_apart, split_flight
from springback.simulation.ticks import (
    GUST_NOISE,
    FlightBuffers,
    FlightLog,
    Layouts,
    decides_alone,
    drive_rotors,
    layouts_of,
    sense_and_decide,
)
from springback.simulation.trajectory import StoredRows, check_instants
from springback.vehicle.rotor_stop import TURNING, NoStop
from springback.vehicle.state import State

#: Memory of an evaluator if there is none.
NO_EVALUATION = (0.0,)
#: Next part of a tick.
LOOK, DRIVE, FLY = 0, 1, 2
#: Ticks between two checks for an interrupt and updates of the progress bar.
TICKS = 2_000

Command = tuple[float, ...]
#: A pilot in plain Python: time [s], measurement, memory → thrust of each rotor [N], memory and, if
#: it detects collisions, its alarm, 1 or 0.
PlainPilot = Callable[[float, Any, Any], tuple[Command, Any] | tuple[Command, Any, float]]


class TickRange(NamedTuple):
    """Ticks to be flown."""

    position: Any
    """Tick, next part of it, and the first tick in memory of the noise, shape (3,); advanced."""
    end: int  # tick before which to stop
    last: int  # last tick of the flight
    duration: float  # of the flight [s]
    pause: bool  # return after the pilots have decided


@executor(nogil=True)
def guide(
    layouts: Layouts,
    buffers: FlightBuffers,
    noise: NoiseStream,
    ticks: TickRange,
    log: FlightLog,
) -> None:
    """Fly some groups from tick to tick, all together.

    It returns when the ticks are done, when the log is full, and, if asked to pause, as soon as the
    pilots have decided; called again, it continues from there.

    Args:
        layouts: Of the buffers.
        buffers: Of the groups.
        noise: Normal numbers of the groups.
        ticks: Ticks to be flown; their position is advanced.
        log: Of a single flight.
    """
    groups, stretch, at = buffers.motion.shape[0], noise.noise.shape[1], ticks.position
    while at[0] < ticks.end:
        k = at[0]
        if k - at[2] == stretch:
            at[2] = k
            keys, flights, plan = noise.source
            for n in range(groups):
                source = NoiseSource(keys[n], flights[n], plan)
                generate(source, k, noise.noise[n], noise.words, noise.drawn)
        for n in range(groups):
            group = FlightBuffers(buffers.motion[n], buffers.onboard[n], buffers.lanes)
            drawn = noise.noise[n, k - at[2]]
            if at[1] == LOOK:
                sense_and_decide(layouts, group, k, drawn, log)
            if at[1] == DRIVE or (at[1] == LOOK and not ticks.pause):
                drive_rotors(layouts, group, k, drawn, log, ticks.duration)
        if at[1] == LOOK and ticks.pause:
            at[1] = DRIVE
            return
        at[1] = FLY
        early = 0.0 if k == ticks.last else 1.0
        flying = 1
        while flying > 0:
            motion, lanes = buffers.motion, buffers.lanes
            flying = to_tick(layouts.shape, motion, lanes, log.trajectory, SLICE, early)
            if not has_space(log.trajectory):
                break
        if flying > 0:
            return
        at[0], at[1] = k + 1, LOOK


def fly_to_tick(
    layouts: Layouts,
    buffers: FlightBuffers,
    noise: NoiseStream,
    ticks: TickRange,
    log: FlightLog,
) -> None:
    """The physics of `guide`, without sensors and pilot: what can be compiled beside these."""
    motion, lanes, early = buffers.motion, buffers.lanes, ticks.duration
    to_tick(layouts.shape, motion, lanes, log.trajectory, SLICE, early)


def fly_split_to_tick(
    layouts: Layouts,
    buffers: FlightBuffers,
    noise: NoiseStream,
    ticks: TickRange,
    log: FlightLog,
) -> None:
    """`fly_to_tick` of a `SplitFlight`, its physics, and its rotors."""
    motion, lanes, early = buffers.motion, buffers.lanes, ticks.duration
    to_tick(layouts.shape, motion, lanes, log.trajectory, SLICE, early)
    rates_apart(layouts.shape, motion[0], early, early > 0.0)
    group = FlightBuffers(motion[0], buffers.onboard[0], lanes)
    drive_rotors(layouts, group, ticks.position[0], noise.noise[0, 0], log, early)


def fly_between_ticks(
    shape: TreeLayout,
    buffers: Buffer,
    lanes: tuple[int, ...],
    log: TrajectoryLog,
    budget: int,
    early: float,
) -> None:
    """`fly_to_tick` where the avionics are not known yet: arguments of `fly_to_end`."""
    to_tick(shape, buffers, lanes, log, SLICE, early)
    rates_apart(shape, buffers[0], early, early > 0.0)


def compile_guide(run: Any, arguments: tuple[Any, ...]) -> None:
    """Compile `guide`, if it is what will be run with these arguments, by two processes."""
    if run is guide:
        split = isinstance(arguments[1].lanes, SplitFlight)
        part = fly_split_to_tick if split else fly_to_tick
        compile_with_help([(guide, arguments)], (part, arguments))


class GuidedFlight(NamedTuple):
    """A flight with avionics before its first tick."""

    model: Model
    start: State  # at time 0
    avionics: Avionics  # from `avionics_at_start`


class GuidedFlown(NamedTuple):
    """Result of a guided flight."""

    flown: FlightRecord
    onboard: OnboardState
    telemetry: Trace | None


def ticks_of(duration: float, period: float) -> int:
    """Ticks of a flight; the last may be cut short."""
    return max(1, math.ceil(duration / period - 1e-9))


class AvionicsMemory(NamedTuple):
    """Memories of the avionics before tick 0."""

    sensors: Any
    pilot: Any
    evaluator: Any
    weather: Any


#: Zeros for a measurement before tick 0, by types of the sensors; what is not revealed stays zero.
_UNREAD: dict[Any, Any] = {}


def avionics_at_start(
    systems: OnboardSystems,
    memory: AvionicsMemory,
    model: Model,
    start: State,
    channels: int,
) -> Avionics:
    """Avionics before tick 0, with the rotors at the thrust that the model starts with.

    Args:
        systems: Settings.
        memory: Of sensors, pilot, evaluator and weather.
        model: Of the flight.
        start: State at time 0.
        channels: Normal numbers that the sensors take at each tick.
    """
    kind = (type(systems.sensors), *map(type, systems.sensors), len(start.arm_length))
    if kind not in _UNREAD:
        truth, noise = Truth(start, start, systems.period, model.world.gravity), (0.0,) * channels
        first = sensor_step(systems.sensors, 0.0, truth, noise, memory.sensors)
        _UNREAD[kind] = rebuilt(first.measurement, [0.0] * len(leaves(first.measurement)))
    pilot = user_pilot_memory(memory.pilot) if decides_alone(systems.pilot) else memory.pilot
    onboard = OnboardState(
        start, _UNREAD[kind], memory.sensors, pilot, model.thrust, model.thrust,
        (TURNING,) * (0 if isinstance(systems.stop, NoStop) else len(model.thrust)),
        memory.evaluator, memory.weather,
    )  # fmt: skip
    return Avionics(systems, onboard)


def avionics_buffers(avionics_list: Sequence[Any], width: int) -> Buffer:
    """Buffers of avionics, lane by lane; spare lanes repeat the last flight."""
    groups, columns = -(-len(avionics_list) // width), [leaves(one) for one in avionics_list]
    buffers = zeros(groups, len(columns[0]), width)
    for k in range(groups * width):
        group, lane = divmod(k, width)
        buffers[group, :, lane] = columns[min(k, len(columns) - 1)]
    return buffers.reshape(groups, -1)


def guide_for(model: Model, avionics: Avionics, executor: Executor = "compiled") -> Any:
    """`guide` for a model and avionics: compiled, or the same in plain Python."""
    plain = {name: _plain(entry) for name, entry in _PARTS.items()}
    if executor == "python":
        plain["to_tick"] = with_globals(plain["to_tick"], **plain)
        return with_globals(plain["guide"], **plain)
    own_model, own_avionics = own_types(model), own_types(avionics)
    if not own_model | own_avionics:
        return guide
    files = sources(own_model | own_avionics)
    return _own_guide(frozenset(own_model), frozenset(own_avionics), files)


@functools.cache
def _own_guide(
    own_model: frozenset[type], own_avionics: frozenset[type], files: Origin | None
) -> Any:
    """`guide` for a user's own types; without any in the model, the package's physics is used."""
    plain, parts = {name: _plain(entry) for name, entry in _PARTS.items()}, dict(_PARTS)
    for name in ("sense_and_decide", "drive_rotors"):
        parts[name] = user_executor(plain[name], files, nogil=True)
    if own_model:
        parts["advance"] = user_executor(plain["advance"], files, nogil=True)
        between = with_globals(plain["to_tick"], advance=parts["advance"])
        parts["to_tick"] = user_executor(between, files, nogil=True)
    return user_executor(with_globals(plain["guide"], **parts), files, nogil=True)


_PARTS: dict[str, Any] = {
    "advance": advance, "to_tick": to_tick, "sense_and_decide": sense_and_decide,
    "drive_rotors": drive_rotors, "guide": guide,
}  # fmt: skip


def _plain(entry: Any) -> Any:
    return getattr(entry, "py_func", entry)


def fly_guided(
    flight: GuidedFlight,
    noise: Buffer,
    *,
    pilot: PlainPilot | None = None,
    trace: bool = True,
    interval: float = 0.0,
    executor: Executor = "compiled",
    progress: Callable[[float], None] | None = None,
) -> GuidedFlown:
    """Fly one flight with avionics to its end.

    Args:
        flight: Before its first tick.
        noise: Normal numbers of the flight, shape (ticks, channels), from `noise_table`.
        pilot: In plain Python, in place of the one of the avionics, which is then a `Relay`; its
            memory is None at first.
        trace: Record trajectory and telemetry.
        interval: Of which the trajectory keeps the first step [s]; 0: it keeps each.
        executor: ``compiled``, or ``python`` for the same source run by the interpreter (slow).
        progress: Called from time to time with the simulated time [s].

    Raises:
        InputError: If the trajectory would have too many instants to be recorded.
    """
    model, start, avionics = flight
    shape, duration, count = shape_of(model, start), model.timing.until, len(noise)
    check_instants(count if trace else 0, duration, duration)
    motion, onboard = flight_buffers(shape, [model], [start], 1), avionics_buffers([avionics], 1)
    run, split = guide_for(model, avionics, executor), is_split(model, executor)
    buffers = FlightBuffers(motion, onboard, SplitFlight(0) if split else lanes_of(1))
    layouts = layouts_of(shape, avionics, noise.shape[1] - GUST_NOISE)
    numbers, at = stored_stream(noise), np.zeros(3, dtype=np.int64)
    head = (*telemetry_head(avionics),) if trace else ()
    mailbox = _mailbox(avionics, onboard[0]) if pilot is not None else None
    telemetry = np.zeros((count if trace else 0, len(head)))
    stored = StoredRows(len(trace_columns(shape)), interval)
    record_row, memory = -rows(shape.record), None
    while at[0] < count:
        size = (LOG_ROWS, len(trace_columns(shape))) if trace else (0, 1)
        log = FlightLog(empty_log(*size), telemetry)
        end = min(count, int(at[0]) + TICKS)
        ticks = TickRange(at, end, count - 1, duration, pilot is not None)
        while at[0] < end and has_space(log.trajectory):
            before = tuple(at)
            if not any(before):
                compile_guide(run, (layouts, buffers, numbers, ticks, log))
                if split:
                    buffers = buffers._replace(lanes=split_flight(layouts.shape, motion))
            run(layouts, buffers, numbers, ticks, log)
            if pilot and mailbox and at[1] == DRIVE and tuple(at) != before:
                memory = _call(pilot, avionics, mailbox, float(at[0]), memory)
                if trace:  # the row of this tick was written before the pilot's call
                    telemetry[at[0], 1 : 1 + len(mailbox.command)] = mailbox.command
                    first = len(head) - len(mailbox.report) - len(avionics.onboard.stopped)
                    telemetry[at[0], first : first + len(mailbox.report)] = mailbox.report
        stored.add(log.trajectory.rows[: log.trajectory.used[0]])
        time_now = float(motion[0, record_row])
        check_instants(stored.count, time_now, duration)
        if progress is not None:
            progress(time_now)
    after = rebuilt(avionics.onboard, onboard[0, rows(avionics.systems) :])
    flown = flight_records(shape, [model], [start], motion, 1)[0]
    if not trace:
        return GuidedFlown(flown, after, None)
    flown = flown._replace(trace=Trace(trace_columns(shape), stored.all()))
    return GuidedFlown(flown, after, Trace(head, telemetry))


class _Mailbox(NamedTuple):
    """Parts of an on-board buffer through which a plain pilot is called."""

    measurement: Buffer
    command: Buffer
    report: Buffer  # `AlarmReport` in the memory of the `Relay`


def _mailbox(avionics: Avionics, buffer: Buffer) -> _Mailbox:
    onboard, after = avionics.onboard, rows(avionics.systems)

    def part(tree: Any, name: str, before: int) -> Buffer:
        first = before + row_of(tree, name)
        return buffer[first : first + rows(getattr(tree, name))]

    report = part(onboard.pilot, "report", after + row_of(onboard, "pilot"))
    return _Mailbox(part(onboard, "measurement", after), part(onboard, "command", after), report)


def _call(
    pilot: PlainPilot, avionics: Avionics, mailbox: _Mailbox, tick: float, memory: Any
) -> Any:
    """Call a plain pilot and write its command and report; returns its memory."""
    measurement = rebuilt(avionics.onboard.measurement, mailbox.measurement.tolist())
    time = tick * avionics.systems.period
    said = PilotOutput(*pilot(time, measurement, memory))
    thrusts, rotors = [float(thrust) for thrust in said.thrust], len(mailbox.command)
    if len(thrusts) != rotors:
        raise ValueError(f"the pilot commands {len(thrusts)} rotors, the vehicle has {rotors}")
    mailbox.command[:] = thrusts
    mailbox.report[:] = report_after(said.alarm, time, AlarmReport(*mailbox.report.tolist()))
    return said.memory


def telemetry_head(avionics: Avionics) -> list[str]:
    """Names of the columns of the telemetry."""
    memory = avionics.onboard.pilot
    parts = {
        "command": avionics.onboard.command, "thrust": avionics.onboard.thrust,
        "measurement": avionics.onboard.measurement,
        "pilot": telemetry_of(avionics.systems.pilot, own_memory(memory)),
        "report": report_of(memory), "stopped": avionics.onboard.stopped,
    }  # fmt: skip
    return ["time", *(name for stem, tree in parts.items() for name in names(tree, stem))]

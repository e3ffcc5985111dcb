"""Flights with sensors, a pilot and rotors aboard: the loop over the ticks of their clock.

The equations of motion are those of `springback.simulation.executor`, called from tick to tick; the
pilot is compiled apart from them, so that a new pilot does not compile the physics again.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from springback.dynamics.gusts import NoGusts, first_gust
from springback.kernels.compiler import Origin, executor, rebound, user_executor
from springback.kernels.layout import Buffer, TreeLayout, row_of, rows, zeros
from springback.kernels.trees import leaves, names, rebuilt
from springback.simulation.executor import advance, to_tick
from springback.simulation.flight import (
    LOG_ROWS,
    SLICE,
    Executor,
    FlightRecord,
    Trace,
    check_instants,
    loaded,
    own_types,
    shape_of,
    sources,
    trace_columns,
    unloaded,
)
from springback.simulation.noise import NoiseStream, Purpose, generate, pregenerated, stream
from springback.simulation.noise import noise_table as noise_table
from springback.simulation.onboard import (
    Avionics,
    OnboardState,
    OnboardSystems,
    Truth,
    sensed,
    telemetry_of,
)
from springback.simulation.record import Model
from springback.simulation.ticks import GUST_NOISE, powered, ticked
from springback.vehicle.state import State

#: Normal numbers that gusts take before the first tick.
FIRST_GUST_NOISE = 5
#: Memory of a witness that is not there.
NO_EVALUATION = (0.0,)
#: What comes next within a tick.
LOOK, DRIVE, FLY = 0, 1, 2
#: Ticks between two looks at the keyboard and the progress bar.
TICKS = 2_000

Command = tuple[float, ...]
#: A pilot in plain Python: time [s], measurement, memory → thrust of each rotor [N], memory.
PlainPilot = Callable[[float, Any, Any], tuple[Command, Any]]


@executor(nogil=True)
def guide(
    shape: TreeLayout,
    avionics: TreeLayout,
    buffers: Buffer,
    onboard: Buffer,
    lanes: tuple[int, ...],
    channels: TreeLayout,
    gusts: TreeLayout,
    noise_stream: NoiseStream,
    next_up: Any,
    end: int,
    ticks: int,
    duration: float,
    pause: bool,
    log: Buffer,
    logged: Any,
    telemetry: Buffer,
) -> None:
    """Fly some groups on from tick to tick, all together.

    It comes back when the ticks are done, when the log is full, and, if asked to pause, as soon as
    the pilots have decided; called again, it goes on from there.

    Args:
        shape: What lies in the buffers of the motion.
        avionics: What lies in the buffers of what is aboard.
        buffers: Of the motion, shape (groups, rows x lanes).
        onboard: Of what is aboard, shape (groups, rows x lanes).
        lanes: A tuple as long as a group is wide.
        channels: Noise of the sensors at a tick.
        gusts: Noise of the gusts at a tick.
        noise_stream: Normal numbers, those of all ticks or of a stretch after the other.
        next_up: Tick, what comes next within it, and the tick with which the numbers at hand begin,
            shape (3,); advanced.
        end: Tick to stop before.
        ticks: Of the whole flight.
        duration: Of the flight [s].
        pause: Come back after the pilots have decided.
        log: Trajectory of a single flight, as in `springback.simulation.executor.advance`.
        logged: Rows of the log in use, shape (1,); advanced.
        telemetry: Of a single flight, one tick a row; empty for none.
    """
    groups, stretch = buffers.shape[0], noise_stream.noise.shape[1]
    while next_up[0] < end:
        k = next_up[0]
        if k - next_up[2] == stretch:
            next_up[2] = k
            for group in range(groups):
                keys, flights = noise_stream.keys[group], noise_stream.flights[group]
                generate(
                    keys,
                    flights,
                    noise_stream.plan,
                    k,
                    noise_stream.noise[group],
                    noise_stream.words,
                    noise_stream.drawn,
                )
        for group in range(groups):
            b, g, drawn = buffers[group], onboard[group], noise_stream.noise[group, k - next_up[2]]
            if next_up[1] == LOOK:
                ticked(
                    shape, avionics, b, g, lanes, logged, float(k), channels, drawn, telemetry, k
                )
            if next_up[1] == DRIVE or (next_up[1] == LOOK and not pause):
                n = rows(channels)
                powered(shape, avionics, b, g, lanes, logged, float(k), duration, gusts, drawn, n)
        if next_up[1] == LOOK and pause:
            next_up[1] = DRIVE
            return
        next_up[1] = FLY
        early = 0.0 if k + 1 == ticks else 1.0
        under_way = 1
        while under_way > 0:
            under_way = to_tick(shape, buffers, lanes, log, logged, SLICE, early)
            if log.shape[0] > 0 and logged[0] >= log.shape[0]:
                break
        if under_way > 0:
            return
        next_up[0], next_up[1] = k + 1, LOOK


class GuidedFlown(NamedTuple):
    """What a guided flight leaves."""

    flown: FlightRecord
    onboard: OnboardState
    telemetry: Trace | None


class Entries(NamedTuple):
    """The functions of this module and the executor, for some types of models and pilots."""

    guide: Any
    ticked: Any


def ticks_of(duration: float, period: float) -> int:
    """Ticks of a flight; the last may be cut short."""
    return max(1, math.ceil(duration / period - 1e-9))


#: Measurements by kind of sensors, to hold a place until tick 0; no pilot reads them.
_UNREAD: dict[Any, Any] = {}


def avionics_at_start(
    systems: OnboardSystems,
    sensors: Any,
    pilot: Any,
    model: Model,
    start: State,
    channels: int,
    seed: int,
    evaluator: Any = NO_EVALUATION,
) -> Avionics:
    """What is aboard before the first tick, the rotors at the thrust that the model starts with.

    Args:
        systems: Settings.
        sensors: Memory of the sensors.
        pilot: Memory of the pilot.
        model: Of the flight.
        start: State at time 0.
        channels: Normal numbers that the sensors take at each tick.
        seed: Of the wind before the first tick.
        evaluator: Memory of the witness.
    """
    gusts: Any = 0.0
    if not isinstance(systems.weather, NoGusts):
        before = tuple(stream(seed, Purpose.GUST).standard_normal(FIRST_GUST_NOISE).tolist())
        gusts = first_gust(systems.weather, before).memory
    kind = (type(systems.sensors), *map(type, systems.sensors), len(start.arm_length))
    if kind not in _UNREAD:
        truth = Truth(start, start, systems.period, model.world.gravity)
        seen = sensed(systems.sensors, 0.0, truth, (0.0,) * channels, sensors)
        _UNREAD[kind] = seen.measurement
    first = _UNREAD[kind]
    onboard = OnboardState(
        start, first, sensors, pilot, model.thrust, model.thrust, evaluator, gusts
    )
    return Avionics(systems, onboard)


def loaded_avionics(avionics_list: list[Avionics], width: int) -> Buffer:
    """Buffers of what is aboard, lane by lane; spare lanes repeat the last flight."""
    groups, columns = (
        -(-len(avionics_list) // width),
        [leaves(avionics) for avionics in avionics_list],
    )
    buffers = zeros(groups, len(columns[0]), width)
    for k in range(groups * width):
        group, lane = divmod(k, width)
        buffers[group, :, lane] = columns[min(k, len(columns) - 1)]
    return buffers.reshape(groups, -1)


def entries_for(model: Model, avionics: Avionics, executor: Executor = "compiled") -> Entries:
    """The loop over the ticks for a model and a cabin: compiled, or the same as plain Python."""
    plain = {name: _plain(entry) for name, entry in _PARTS.items()}
    if executor == "python":
        plain["to_tick"] = rebound(plain["to_tick"], **plain)
        return Entries(rebound(plain["guide"], **plain), plain["ticked"])
    own_model, own_cabin = own_types(model), own_types(avionics)
    if not own_model | own_cabin:
        return Entries(guide, ticked)
    files = sources(own_model | own_cabin)
    return _own_entries(frozenset(own_model), frozenset(own_cabin), files)


@functools.cache
def _own_entries(
    own_model: frozenset[type], own_cabin: frozenset[type], files: Origin | None
) -> Entries:
    """The functions for types of the user's, of some origin."""
    plain, parts = {name: _plain(entry) for name, entry in _PARTS.items()}, dict(_PARTS)
    parts["ticked"] = user_executor(plain["ticked"], files, nogil=True)
    parts["powered"] = user_executor(plain["powered"], files, nogil=True)
    if own_model:
        parts["advance"] = user_executor(plain["advance"], files, nogil=True)
        between = rebound(plain["to_tick"], advance=parts["advance"])
        parts["to_tick"] = user_executor(between, files, nogil=True)
    loop = user_executor(rebound(plain["guide"], **parts), files, nogil=True)
    return Entries(loop, parts["ticked"])


_PARTS: dict[str, Any] = {
    "advance": advance, "to_tick": to_tick, "ticked": ticked, "powered": powered, "guide": guide,
}  # fmt: skip


def _plain(entry: Any) -> Any:
    return getattr(entry, "py_func", entry)


def fly_guided(
    model: Model,
    start: State,
    avionics: Avionics,
    noise: Buffer,
    *,
    pilot: PlainPilot | None = None,
    memory: Any = None,
    trace: bool = True,
    executor: Executor = "compiled",
    progress: Callable[[float], None] | None = None,
) -> GuidedFlown:
    """Fly one flight with a pilot aboard to its end.

    Args:
        model: The flight's numbers.
        start: State at time 0.
        avionics: What is aboard, from `avionics_at_start`.
        noise: Normal numbers of the flight, shape (ticks, channels), from `noise_table`.
        pilot: In plain Python, in place of the one aboard, which is then a `Relay`.
        memory: What the plain pilot remembers at first.
        trace: Keep the trajectory and the telemetry.
        executor: ``compiled``, or ``python`` for the same source run by the interpreter (slow).
        progress: Called now and then with the simulated time [s].

    Raises:
        InputError: If the trajectory has more instants than can be kept.
    """
    shape, duration = shape_of(model, start), model.timing.until
    check_instants(len(noise) if trace else 0, duration, duration)
    buffers, avionics_list = loaded(shape, [model], [start], 1), loaded_avionics([avionics], 1)
    entries, ticks = entries_for(model, avionics, executor), len(noise)
    channels, gusts = (
        TreeLayout((0.0,) * (noise.shape[1] - GUST_NOISE)),
        TreeLayout((0.0,) * GUST_NOISE),
    )
    noise_stream = pregenerated(noise)
    like, like_cabin = TreeLayout(shape), TreeLayout(avionics)
    head = (*_telemetry_columns(avionics),) if trace else ()
    seat = _seat(avionics, avionics_list[0]) if pilot is not None else None
    telemetry = np.zeros((ticks if trace else 0, len(head)))
    next_up = np.zeros(3, dtype=np.int64)
    logs, record_row = [], -rows(shape.record)
    while next_up[0] < ticks:
        log = np.zeros((LOG_ROWS if trace else 0, len(trace_columns(shape)) if trace else 1))
        logged = np.zeros(1, dtype=np.int64)
        end = min(ticks, int(next_up[0]) + TICKS)
        while next_up[0] < end and (not trace or logged[0] < len(log)):
            before = tuple(next_up)
            entries.guide(
                like, like_cabin, buffers, avionics_list, (0,), channels, gusts, noise_stream,
                next_up, end, ticks, duration, pilot is not None, log, logged, telemetry,
            )  # fmt: skip
            if pilot and seat and next_up[1] == DRIVE and tuple(next_up) != before:
                memory = _asked(pilot, avionics, seat, float(next_up[0]), memory)
                if trace:  # the page of this tick has been written before the pilot spoke
                    telemetry[next_up[0], 1 : 1 + len(seat[1])] = seat[1]
        logs.append(log[: logged[0]])
        time_now = float(buffers[0, record_row])
        check_instants(sum(map(len, logs)), time_now, duration)
        if progress is not None:
            progress(time_now)
    onboard = rebuilt(avionics.onboard, avionics_list[0, rows(avionics.systems) :])
    flown = unloaded(shape, [model], [start], buffers, 1)[0]
    if not trace:
        return GuidedFlown(flown, onboard, None)
    flown = flown._replace(trace=Trace(trace_columns(shape), np.concatenate(logs)))
    return GuidedFlown(flown, onboard, Trace(head, telemetry))


def _seat(avionics: Avionics, buffer: Buffer) -> tuple[Buffer, Buffer, Buffer]:
    """Where measurement, command and the relay's memory lie in a buffer."""
    onboard, after = avionics.onboard, rows(avionics.systems)
    firsts = {name: after + row_of(onboard, name) for name in ("measurement", "command", "pilot")}
    seen, said, relayed = (buffer[k : k + rows(getattr(onboard, n))] for n, k in firsts.items())
    return seen, said, relayed


def _asked(
    pilot: PlainPilot,
    avionics: Avionics,
    seat: tuple[Buffer, Buffer, Buffer],
    tick: float,
    memory: Any,
) -> Any:
    """Ask a plain pilot, and put its command aboard."""
    seen, said, relayed = seat
    measurement = rebuilt(avionics.onboard.measurement, seen.tolist())
    command, memory = pilot(tick * avionics.systems.period, measurement, memory)
    thrusts = [float(thrust) for thrust in command]
    if len(thrusts) != len(said):
        raise ValueError(f"the pilot commands {len(thrusts)} rotors of {len(said)}")
    said[:] = relayed[:] = thrusts
    return memory


def _telemetry_columns(avionics: Avionics) -> list[str]:
    """Names of the columns of the telemetry."""
    words = telemetry_of(avionics.systems.pilot, avionics.onboard.pilot)
    parts = {
        "command": avionics.onboard.command, "thrust": avionics.onboard.thrust,
        "measurement": avionics.onboard.measurement, "told": words,
    }  # fmt: skip
    return ["time", *(name for stem, tree in parts.items() for name in names(tree, stem))]

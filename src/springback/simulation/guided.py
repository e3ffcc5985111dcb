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

from springback.dynamics.air import in_wind
from springback.dynamics.gusts import first_gust, gust
from springback.kernels.compiler import executor, guard, kernel, own_executor, rebound
from springback.kernels.layout import Buffer, Like, read, row_of, rows, write
from springback.kernels.trees import leaves, names, rebuilt, square
from springback.simulation.aboard import (
    Aboard,
    Cabin,
    Draw,
    Guidance,
    Touch,
    Truth,
    piloted,
    sensed,
    told,
    witnessed,
)
from springback.simulation.executor import advance
from springback.simulation.flight import (
    LOG_ROWS,
    SLICE,
    Executor,
    Flown,
    Trace,
    loaded,
    own_types,
    shape_of,
    sources,
    trace_columns,
    unloaded,
)
from springback.simulation.lanes import places
from springback.simulation.record import FINISHED, FLYING, NOT_FINITE, Model
from springback.vehicle.rotors import all_lagged
from springback.vehicle.state import State

#: Normal numbers that gusts take at each tick, after those of the sensors ...
GUST_NOISE = 3
#: ... and before the first.
FIRST_GUST_NOISE = 5
#: Memory of a witness that is not there.
NOBODY = (0.0,)
#: What comes next within a tick.
LOOK, DRIVE, FLY = 0, 1, 2
#: Squares of finite commands [N] add up to less than this (chosen: far beyond any).
ABSURD = 1e30
#: Ticks between two looks at the keyboard and the progress bar.
TICKS = 2_000

Command = tuple[float, ...]
#: A pilot in plain Python: time [s], measurement, memory → thrust of each rotor [N], memory.
PlainPilot = Callable[[float, Any, Any], tuple[Command, Any]]


@guard
def _status_after(thrust: Command, status: float) -> float:
    """Status of a flight after its pilot has commanded: not finite where a command is not."""
    return status if square(thrust) < ABSURD else NOT_FINITE


@kernel
def _touch(shape: Like, b: Buffer, record: int, w: int, i: int) -> Touch:
    """What the record of one lane says of contacts."""
    m = shape.record
    return Touch(
        float(b[(record + row_of(m, "touching")) * w + i]),
        float(b[(record + row_of(m, "contacts")) * w + i]),
        float(b[(record + row_of(m, "last_touch_time")) * w + i]),
        float(b[(record + row_of(m, "ground_time")) * w + i]),
    )


@kernel
def looked(
    shape: Like, cabin: Like, b: Buffer, g: Buffer, w: int, i: int, tick: float, channels: Like,
    noise: Buffer,
) -> None:  # fmt: skip
    """One lane: the sensors look, the pilot decides."""
    settings, after = cabin.guidance, rows(cabin.guidance)
    at, memory = places(shape, w), cabin.aboard
    gravity_row = row_of(shape.model, "world") + row_of(shape.model.world, "gravity")
    measured_row = after + row_of(memory, "measurement")
    sensors_row, pilot_row = after + row_of(memory, "sensors"), after + row_of(memory, "pilot")
    period = float(g[row_of(settings, "period") * w + i])
    state = read(shape.motion.state, b, at.motion, w, i)
    before = read(memory.before, g, after + row_of(memory, "before"), w, i)
    truth = Truth(before, state, period, float(b[gravity_row * w + i]))
    sensors = read(settings.sensors, g, row_of(settings, "sensors"), w, i)
    remembered = read(memory.sensors, g, sensors_row, w, i)
    seen = sensed(sensors, tick, truth, read(channels, noise, 0, w, i), remembered)
    write(state, g, after + row_of(memory, "before"), w, i)
    write(seen.measurement, g, measured_row, w, i)
    write(seen.memory, g, sensors_row, w, i)

    pilot = read(settings.pilot, g, row_of(settings, "pilot"), w, i)
    thought = read(memory.pilot, g, pilot_row, w, i)
    said = piloted(pilot, tick * period, seen.measurement, thought)
    write(said.memory, g, pilot_row, w, i)
    write(said.thrust, g, after + row_of(memory, "command"), w, i)
    witness = read(settings.witness, g, row_of(settings, "witness"), w, i)
    witness_row = after + row_of(memory, "witness")
    known = read(memory.witness, g, witness_row, w, i)
    touch = _touch(shape, b, at.record, w, i)
    kept = witnessed(witness, tick * period, state, touch, said.memory, known)
    write(kept, g, witness_row, w, i)
    b[at.status * w + i] = _status_after(said.thrust, b[at.status * w + i])


@kernel
def written(cabin: Like, g: Buffer, tick: float, page: Buffer) -> None:
    """A page of the diary of a single flight: time, command, thrust, measurement, words."""
    settings, memory, after = cabin.guidance, cabin.aboard, rows(cabin.guidance)
    n, seen = rows(memory.command), rows(memory.measurement)
    page[0] = tick * g[row_of(settings, "period")]
    for k in range(n):
        page[1 + k] = g[after + row_of(memory, "command") + k]
        page[1 + n + k] = g[after + row_of(memory, "thrust") + k]
    for k in range(seen):
        page[1 + 2 * n + k] = g[after + row_of(memory, "measurement") + k]
    pilot = read(settings.pilot, g, row_of(settings, "pilot"), 1, 0)
    thought = read(memory.pilot, g, after + row_of(memory, "pilot"), 1, 0)
    write(told(pilot, thought), page, 1 + 2 * n + seen, 1, 0)


@executor(nogil=True)
def ticked(
    shape: Like,
    cabin: Like,
    b: Buffer,
    g: Buffer,
    lanes: tuple[int, ...],
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
        tick: Number of the tick.
        channels: Noise of the sensors at a tick.
        noise: Normal numbers of this tick, channel by channel, lane by lane.
        diary: Of a single flight, one tick a row; empty for none.
        line: Row of the diary.
    """
    w = len(lanes)
    for i in range(w):
        looked(shape, cabin, b, g, w, i, tick, channels, noise)
        if w == 1 and diary.shape[0] > 0:
            written(cabin, g, tick, diary[line])


@kernel
def driven(
    shape: Like, cabin: Like, b: Buffer, g: Buffer, w: int, i: int, tick: float, last: float,
    drawn: tuple[float, ...],
) -> None:  # fmt: skip
    """One lane: the rotors follow their commands, the wind blows, until the next tick."""
    settings, memory, after = cabin.guidance, cabin.aboard, rows(cabin.guidance)
    at, model = places(shape, w), shape.model
    thrust_row, weather_row = after + row_of(memory, "thrust"), after + row_of(memory, "weather")
    air_row = row_of(model, "air")
    period = float(g[row_of(settings, "period") * w + i])
    rotors = read(settings.rotors, g, row_of(settings, "rotors"), w, i)
    thrust = read(memory.thrust, g, thrust_row, w, i)
    command = read(memory.command, g, after + row_of(memory, "command"), w, i)
    spun = all_lagged(rotors, thrust, command, period)
    write(spun.thrust, g, thrust_row, w, i)
    write(spun.mean, b, row_of(model, "thrust"), w, i)

    weather = read(settings.weather, g, row_of(settings, "weather"), w, i)
    blown = gust(weather, drawn, read(memory.weather, g, weather_row, w, i))
    wind = read(settings.mean_wind, g, row_of(settings, "mean_wind"), w, i) + blown.velocity
    write(blown.memory, g, weather_row, w, i)
    write(in_wind(read(model.air, b, air_row, w, i), wind), b, air_row, w, i)

    b[row_of(model, "timing") * w + i] = min((tick + 1.0) * period, last)
    if b[at.status * w + i] == FINISHED:  # it came to this tick before its neighbours
        b[at.status * w + i] = FLYING


@executor(nogil=True)
def powered(
    shape: Like, cabin: Like, b: Buffer, g: Buffer, lanes: tuple[int, ...], tick: float,
    last: float, gusts: Like, noise: Buffer, channel: int,
) -> None:  # fmt: skip
    """The rotors of every lane follow their commands, the wind blows, until the next tick.

    Args:
        shape: What lies in the buffer of the motion.
        cabin: What lies in the buffer of what is aboard.
        b: Buffer of the motion.
        g: Buffer of what is aboard.
        lanes: A tuple as long as a group is wide.
        tick: Number of the tick that begins.
        last: End of the flight [s].
        gusts: Noise of the gusts at a tick.
        noise: Normal numbers of this tick, channel by channel, lane by lane.
        channel: The first of those that are the gusts'.
    """
    w = len(lanes)
    for i in range(w):
        driven(shape, cabin, b, g, w, i, tick, last, read(gusts, noise, channel, w, i))


@executor(nogil=True)
def guide(
    shape: Like,
    cabin: Like,
    b: Buffer,
    g: Buffer,
    lanes: tuple[int, ...],
    channels: Like,
    gusts: Like,
    noise: Buffer,
    next_up: Any,
    end: int,
    duration: float,
    pause: bool,
    log: Buffer,
    logged: Any,
    diary: Buffer,
) -> None:
    """Fly one group on from tick to tick.

    It comes back when the ticks are done, when the log is full, and, if asked to pause, as soon as
    the pilots have decided; called again, it goes on from there.

    Args:
        shape: What lies in the buffer of the motion.
        cabin: What lies in the buffer of what is aboard.
        b: Buffer of the motion, shape (1, rows x lanes).
        g: Buffer of what is aboard, shape (rows x lanes,).
        lanes: A tuple as long as a group is wide.
        channels: Noise of the sensors at a tick.
        gusts: Noise of the gusts at a tick.
        noise: Normal numbers, shape (ticks, channels x lanes).
        next_up: Tick and what comes next within it, shape (2,); advanced.
        end: Tick to stop before.
        duration: Of the flight [s].
        pause: Come back after the pilots have decided.
        log: Trajectory of a single flight, as in `springback.simulation.executor.advance`.
        logged: Rows of the log in use, shape (1,); advanced.
        diary: Of a single flight, one tick a row; empty for none.
    """
    while next_up[0] < end:
        k = next_up[0]
        drawn = noise[k]
        if next_up[1] == LOOK:
            next_up[1] = DRIVE
            ticked(shape, cabin, b[0], g, lanes, float(k), channels, drawn, diary, k)
            if pause:
                return
        if next_up[1] == DRIVE:
            next_up[1] = FLY
            powered(shape, cabin, b[0], g, lanes, float(k), duration, gusts, drawn, rows(channels))
        early = 0.0 if k + 1 == noise.shape[0] else 1.0
        under_way = 1
        while under_way > 0:
            under_way = advance(shape, b, 0, 1, lanes, log, logged, SLICE, early)
            if log.shape[0] > 0 and logged[0] >= log.shape[0]:
                break
        if under_way > 0:
            return
        next_up[0], next_up[1] = k + 1, LOOK


class GuidedFlown(NamedTuple):
    """What a guided flight leaves."""

    flown: Flown
    aboard: Aboard
    diary: Trace | None


class Entries(NamedTuple):
    """The functions of this module and the executor, for some types of models and pilots."""

    guide: Any
    ticked: Any


def ticks_of(duration: float, period: float) -> int:
    """Ticks of a flight; the last may be cut short."""
    return max(1, math.ceil(duration / period - 1e-9))


def noise_table(seed: int, flight: int, ticks: int, draws: tuple[Draw, ...]) -> Buffer:
    """Standard normal numbers of one flight, shape (ticks, channels); zeros where none are taken.

    They depend on the seed, the number of the flight and the pace of each device alone.  So flight
    17 of a campaign meets the same luck when flown by itself, and a device the same when another
    one is exchanged.

    Args:
        seed: Of a campaign, or of a flight flown alone.
        flight: Its number in the campaign.
        ticks: Of the clock.
        draws: Of every device, in the order of their channels.
    """
    table = np.zeros((ticks, sum(draw.channels for draw in draws)))
    first = 0
    for channels, every in draws:
        if every > 0:
            luck = np.random.SeedSequence(seed, spawn_key=(flight, 0, first))
            table[::every, first : first + channels] = np.random.Generator(
                np.random.SFC64(luck)  # seven digits of luck are enough, and twice as fast
            ).standard_normal((-(-ticks // every), channels), dtype=np.float32)
        first += channels
    return table


def cabin_of(
    guidance: Guidance,
    sensors: Any,
    pilot: Any,
    model: Model,
    start: State,
    channels: int,
    seed: int,
    witness: Any = NOBODY,
) -> Cabin:
    """What is aboard before the first tick, the rotors at the thrust that the model starts with.

    Args:
        guidance: Settings.
        sensors: Memory of the sensors.
        pilot: Memory of the pilot.
        model: Of the flight.
        start: State at time 0.
        channels: Normal numbers that the sensors take at each tick.
        seed: Of the wind before the first tick.
        witness: Memory of the witness.
    """
    luck = np.random.Generator(np.random.SFC64(np.random.SeedSequence(seed, spawn_key=(0, 1))))
    before = tuple(float(x) for x in luck.standard_normal(FIRST_GUST_NOISE))
    gusts = first_gust(guidance.weather, before).memory
    truth = Truth(start, start, guidance.period, model.world.gravity)
    quiet = (0.0,) * channels
    first = sensed(guidance.sensors, 0.0, truth, quiet, sensors).measurement
    aboard = Aboard(start, first, sensors, pilot, model.thrust, model.thrust, witness, gusts)
    return Cabin(guidance, aboard)


def cabins_loaded(cabins: list[Cabin], width: int) -> Buffer:
    """Buffers of what is aboard, lane by lane; spare lanes repeat the last flight."""
    groups, columns = -(-len(cabins) // width), [leaves(cabin) for cabin in cabins]
    buffers = np.zeros((groups, len(columns[0]), width))
    for k in range(groups * width):
        group, lane = divmod(k, width)
        buffers[group, :, lane] = columns[min(k, len(columns) - 1)]
    return buffers.reshape(groups, -1)


def entries_for(model: Model, cabin: Cabin, executor: Executor = "compiled") -> Entries:
    """The loop over the ticks for a model and a cabin: compiled, or the same as plain Python."""
    plain = {name: _plain(entry) for name, entry in _PARTS.items()}
    if executor == "python":
        return Entries(rebound(plain["guide"], **plain), plain["ticked"])
    own_model, own_cabin = own_types(model), own_types(cabin)
    if not own_model | own_cabin:
        return Entries(guide, ticked)
    files = sources(own_model | own_cabin)
    return _own_entries(frozenset(own_model), frozenset(own_cabin), files)


@functools.cache
def _own_entries(
    own_model: frozenset[type], own_cabin: frozenset[type], files: tuple[str, ...] | None
) -> Entries:
    """The functions for types of the user's, from some files."""
    plain, parts = {name: _plain(entry) for name, entry in _PARTS.items()}, dict(_PARTS)
    parts["ticked"] = own_executor(plain["ticked"], files, nogil=True)
    parts["powered"] = own_executor(plain["powered"], files, nogil=True)
    if own_model:
        parts["advance"] = own_executor(plain["advance"], files, nogil=True)
    loop = own_executor(rebound(plain["guide"], **parts), files, nogil=True)
    return Entries(loop, parts["ticked"])


_PARTS: dict[str, Any] = {
    "advance": advance, "ticked": ticked, "powered": powered, "guide": guide,
}  # fmt: skip


def _plain(entry: Any) -> Any:
    return getattr(entry, "py_func", entry)


def fly_guided(
    model: Model,
    start: State,
    cabin: Cabin,
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
        cabin: What is aboard, from `cabin_of`.
        noise: Normal numbers of the flight, shape (ticks, channels), from `noise_table`.
        pilot: In plain Python, in place of the one aboard, which is then a `Relay`.
        memory: What the plain pilot remembers at first.
        trace: Keep the trajectory and the diary.
        executor: ``compiled``, or ``python`` for the same source run by the interpreter (slow).
        progress: Called now and then with the simulated time [s].
    """
    shape, duration = shape_of(model, start), model.timing.until
    buffers, cabins = loaded(shape, [model], [start], 1), cabins_loaded([cabin], 1)
    entries, ticks = entries_for(model, cabin, executor), len(noise)
    channels, gusts = Like((0.0,) * (noise.shape[1] - GUST_NOISE)), Like((0.0,) * GUST_NOISE)
    like, like_cabin = Like(shape), Like(cabin)
    head = (*_diary_columns(cabin),) if trace else ()
    seat = _seat(cabin, cabins[0]) if pilot is not None else None
    diary = np.zeros((ticks if trace else 0, len(head)))
    next_up = np.zeros(2, dtype=np.int64)
    logs, record_row = [], -rows(shape.record)
    while next_up[0] < ticks:
        log = np.zeros((LOG_ROWS if trace else 0, len(trace_columns(shape)) if trace else 1))
        logged = np.zeros(1, dtype=np.int64)
        end = min(ticks, int(next_up[0]) + TICKS)
        while next_up[0] < end and (not trace or logged[0] < len(log)):
            before = tuple(next_up)
            entries.guide(
                like, like_cabin, buffers, cabins[0], (0,), channels, gusts, noise,
                next_up, end, duration, pilot is not None, log, logged, diary,
            )  # fmt: skip
            if pilot and seat and next_up[1] == DRIVE and tuple(next_up) != before:
                memory = _asked(pilot, cabin, seat, float(next_up[0]), memory)
                if trace:  # the page of this tick has been written before the pilot spoke
                    diary[next_up[0], 1 : 1 + len(seat[1])] = seat[1]
        logs.append(log[: logged[0]])
        if progress is not None:
            progress(float(buffers[0, record_row]))
    aboard = rebuilt(cabin.aboard, cabins[0, rows(cabin.guidance) :])
    flown = unloaded(shape, [model], [start], buffers, 1)[0]
    if not trace:
        return GuidedFlown(flown, aboard, None)
    flown = flown._replace(trace=Trace(trace_columns(shape), np.concatenate(logs)))
    return GuidedFlown(flown, aboard, Trace(head, diary))


def _seat(cabin: Cabin, buffer: Buffer) -> tuple[Buffer, Buffer, Buffer]:
    """Where measurement, command and the relay's memory lie in a buffer."""
    aboard, after = cabin.aboard, rows(cabin.guidance)
    firsts = {name: after + row_of(aboard, name) for name in ("measurement", "command", "pilot")}
    seen, said, relayed = (buffer[k : k + rows(getattr(aboard, n))] for n, k in firsts.items())
    return seen, said, relayed


def _asked(
    pilot: PlainPilot, cabin: Cabin, seat: tuple[Buffer, Buffer, Buffer], tick: float, memory: Any
) -> Any:
    """Ask a plain pilot, and put its command aboard."""
    seen, said, relayed = seat
    measurement = rebuilt(cabin.aboard.measurement, seen.tolist())
    command, memory = pilot(tick * cabin.guidance.period, measurement, memory)
    thrusts = [float(thrust) for thrust in command]
    if len(thrusts) != len(said):
        raise ValueError(f"the pilot commands {len(thrusts)} rotors of {len(said)}")
    said[:] = relayed[:] = thrusts
    return memory


def _diary_columns(cabin: Cabin) -> list[str]:
    """Names of the columns of the diary."""
    words = told(cabin.guidance.pilot, cabin.aboard.pilot)
    parts = {
        "command": cabin.aboard.command, "thrust": cabin.aboard.thrust,
        "measurement": cabin.aboard.measurement, "told": words,
    }  # fmt: skip
    return ["time", *(name for stem, tree in parts.items() for name in names(tree, stem))]

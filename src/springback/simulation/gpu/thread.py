"""Entry points of a GPU, where each thread flies one flight.

A thread copies its flight out of the shared buffers, flies it with the same functions that fly a
single flight on the processor, and copies it back.  In Python, these entry points fly the flight of
one thread.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.kernels.compiler import kernel
from springback.kernels.gpu.private_memory import (
    array_view,
    opaque,
    private,
    private_counters,
    private_floats,
    private_words,
)
from springback.kernels.layout import Buffer, SplitBuffer, TreeLayout, read, rows, write
from springback.simulation.executor import TrajectoryLog, advance, to_tick
from springback.simulation.flight import SLICE
from springback.simulation.lanes import places
from springback.simulation.noise import NoiseSource, generate
from springback.simulation.ticks import (
    FlightBuffers,
    FlightLog,
    Layouts,
    drive_rotors,
    sense_and_decide,
)


class SharedFlights(NamedTuple):
    """Flights in the memory that all threads share."""

    moving: Any  # motion and record, shape (rows x flights,)
    number: int


class SharedGuidedFlights(NamedTuple):
    """Guided flights in the memory that all threads share."""

    flights: SharedFlights
    onboard: Any  # on-board state, shape (rows x flights,)


class SharedNoise(NamedTuple):
    """Source of the noise of all flights, as `springback.simulation.noise.NoiseSource`."""

    keys: Any  # shape (flights,)
    flights: Any  # shape (flights,)
    plan: Any  # shape (devices x 3,)
    devices: int


class GuidedConstants(NamedTuple):
    """Constants of the thread's flight."""

    model: Any
    systems: Any


class ThreadLayouts(NamedTuple):
    """Layouts of a guided flight, and of its thread's memory."""

    guided: Layouts
    motion: TreeLayout  # as many floats as the motion's buffer of a single flight
    noise: TreeLayout  # as many floats as channels of sensors and gusts


class TickSpan(NamedTuple):
    """Ticks to be flown."""

    first: int
    end: int  # tick before which to stop
    last: int  # last tick of the flight
    duration: float  # of the flight [s]


@kernel
def take_flight(shape: TreeLayout, flights: Buffer, count: int, lane: int, b: Buffer) -> None:
    """Copy motion and record of a flight from shared memory to the buffer of a single flight."""
    here, moving = places(shape, 1), rows(shape.motion)
    write(read(shape.motion, flights, 0, count, lane), b, here.motion, 1, 0)
    write(read(shape.record, flights, moving, count, lane), b, here.record, 1, 0)


@kernel
def put_flight(shape: TreeLayout, b: Buffer, flights: Buffer, count: int, lane: int) -> None:
    """Copy motion and record of a flight back."""
    here, moving = places(shape, 1), rows(shape.motion)
    write(read(shape.motion, b, here.motion, 1, 0), flights, 0, count, lane)
    write(read(shape.record, b, here.record, 1, 0), flights, moving, count, lane)


def fly_impact(
    shape: TreeLayout,
    memory: TreeLayout,
    model: Any,
    flights: SharedFlights,
    budget: int,
    lane: int,
) -> None:
    """Advance the flight of one thread.

    Args:
        shape: Layout of the flight.
        memory: As many floats as the buffer of a single flight.
        model: Of the flight.
        flights: All flights.
        budget: Most steps to take.
        lane: Number of the thread.
    """
    if lane < flights.number:
        size = flights.number * (rows(shape.motion) + rows(shape.record))
        shared, alone = array_view(flights.moving, 1, size)[0], private(memory)
        write(model, alone[0], 0, 1, 0)
        take_flight(shape, shared, flights.number, lane, alone[0])
        logged = private_counters(1, 1)[0]
        logged[0] = 0
        log = TrajectoryLog(array_view(flights.moving, 0, 1), logged)
        advance(shape, alone, (0,), log, budget, 0.0)
        put_flight(shape, alone[0], shared, flights.number, lane)


def fly_ticks(
    layouts: ThreadLayouts,
    constants: GuidedConstants,
    guided: SharedGuidedFlights,
    source: SharedNoise,
    span: TickSpan,
    lane: int,
) -> None:
    """Fly the flight of one thread from tick to tick.

    Args:
        layouts: Of the flight and of the thread's memory.
        constants: Of the flight.
        guided: All flights.
        source: Of their noise.
        span: Ticks to be flown.
        lane: Number of the thread.
    """
    flights, count = guided.flights, guided.flights.number
    if lane < count:
        shape, avionics = layouts.guided.shape, layouts.guided.avionics
        size = count * (rows(shape.motion) + rows(shape.record))
        shared, alone = array_view(flights.moving, 1, size)[0], private(layouts.motion)
        write(constants.model, alone[0], 0, 1, 0)
        take_flight(shape, shared, count, lane, alone[0])
        onboard = array_view(guided.onboard, 1, count * rows(avionics.onboard))[0]
        settings, mine = private(avionics.systems), private(avionics.onboard)
        write(constants.systems, settings[0], 0, 1, 0)
        for row in range(rows(avionics.onboard)):  # `write` would leave out parts that are not new
            mine[0, row] = onboard[row * count + lane]
        key, number = private_words(1, 1)[0], private_words(1, 1)[0]
        key[0] = array_view(source.keys, 1, count)[0, lane]
        number[0] = array_view(source.flights, 1, count)[0, lane]
        own = NoiseSource(key, number, array_view(source.plan, source.devices, 3))
        noise = private(layouts.noise)
        for channel in range(rows(layouts.noise)):
            noise[0, channel] = 0.0
        words, pairs = private_words(7, 1), private_floats(2, 1)
        logged, nothing = private_counters(1, 1)[0], array_view(flights.moving, 0, 1)
        logged[0] = 0
        log = FlightLog(TrajectoryLog(nothing, logged), nothing)
        for k in range(span.first, span.end):
            g: Any = SplitBuffer(avionics.systems, settings[0], opaque(mine[0]))
            buffers = FlightBuffers(alone[0], g, (0,))
            generate(own, k, noise, words, pairs)
            sense_and_decide(layouts.guided, buffers, k, noise[0], log)
            drive_rotors(layouts.guided, buffers, k, noise[0], log, span.duration)
            early = 0.0 if k == span.last else 1.0
            while to_tick(shape, alone, (0,), log.trajectory, SLICE, early) > 0:
                pass
        put_flight(shape, alone[0], shared, count, lane)
        after = opaque(mine[0])
        for row in range(rows(avionics.onboard)):
            onboard[row * count + lane] = after[row]

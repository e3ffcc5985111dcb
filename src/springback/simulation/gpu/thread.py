"""Flights on a GPU, one in every thread: what a thread does.

A thread takes its flight out of the buffers that all share, flies it alone with the very functions
that fly a single flight on the processor, and puts it back.  In Python, these entry points fly the
flight of one thread.
"""

from __future__ import annotations

from typing import Any

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
from springback.simulation.executor import advance, to_tick
from springback.simulation.flight import SLICE
from springback.simulation.lanes import places
from springback.simulation.noise import generate
from springback.simulation.ticks import powered, ticked


@kernel
def take_flight(shape: TreeLayout, flights: Buffer, count: int, lane: int, b: Buffer) -> None:
    """Take motion and record of a flight out of shared buffers into those of a single one."""
    here, moving = places(shape, 1), rows(shape.motion)
    write(read(shape.motion, flights, 0, count, lane), b, here.motion, 1, 0)
    write(read(shape.record, flights, moving, count, lane), b, here.record, 1, 0)


@kernel
def put_flight(shape: TreeLayout, b: Buffer, flights: Buffer, count: int, lane: int) -> None:
    """Put motion and record of a flight back."""
    here, moving = places(shape, 1), rows(shape.motion)
    write(read(shape.motion, b, here.motion, 1, 0), flights, 0, count, lane)
    write(read(shape.record, b, here.record, 1, 0), flights, moving, count, lane)


def fly_impact(
    shape: TreeLayout,
    memory: TreeLayout,
    model: Any,
    flights: Any,
    count: int,
    budget: int,
    lane: int,
) -> None:
    """Advance the flight of one thread.

    Args:
        shape: What lies in the buffers.
        memory: As many floats as a single flight takes.
        model: Of the flight.
        flights: Motion and record of all flights, shape (rows x flights,).
        count: Number of flights.
        budget: Most steps to take.
        lane: The thread's number.
    """
    if lane < count:
        size = count * (rows(shape.motion) + rows(shape.record))
        shared, alone = array_view(flights, 1, size)[0], private(memory)
        write(model, alone[0], 0, 1, 0)
        take_flight(shape, shared, count, lane, alone[0])
        logged, log = private_counters(1, 1)[0], array_view(flights, 0, 1)
        logged[0] = 0
        advance(shape, alone, 0, 1, (0,), log, logged, budget, 0.0)
        put_flight(shape, alone[0], shared, count, lane)


def fly_ticks(
    shape: TreeLayout,
    avionics: TreeLayout,
    memory: TreeLayout,
    channels: TreeLayout,
    gusts: TreeLayout,
    drawn: TreeLayout,
    model: Any,
    systems: Any,
    flights: Any,
    onboard: Any,
    count: int,
    keys: Any,
    numbers: Any,
    plan: Any,
    device_count: int,
    first: int,
    end: int,
    ticks: int,
    duration: float,
    lane: int,
) -> None:
    """Fly the flight of one thread on from tick to tick.

    Args:
        shape: What lies in the buffers of the motion.
        avionics: What is aboard.
        memory: As many floats as the motion of a single flight takes.
        channels: Noise of the sensors at a tick.
        gusts: Noise of the gusts at a tick.
        drawn: Both, one after the other.
        model: Of the flight.
        systems: Of the flight.
        flights: Motion and record of all flights, shape (rows x flights,).
        onboard: What changes aboard, of all flights, shape (rows x flights,).
        count: Number of flights.
        keys: Seed of each flight, shape (flights,).
        numbers: Number of each flight, for its luck, shape (flights,).
        plan: Of `springback.simulation.noise.plan_of`.
        device_count: Number of its rows.
        first: Tick to begin with.
        end: Tick to stop before.
        ticks: Of the whole flight.
        duration: Of the flight [s].
        lane: The thread's number.
    """
    if lane < count:
        size = count * (rows(shape.motion) + rows(shape.record))
        shared, alone = array_view(flights, 1, size)[0], private(memory)
        write(model, alone[0], 0, 1, 0)
        take_flight(shape, shared, count, lane, alone[0])
        kept = array_view(onboard, 1, count * rows(avionics.onboard))[0]
        settings, mine = private(avionics.systems), private(avionics.onboard)
        write(systems, settings[0], 0, 1, 0)
        for row in range(rows(avionics.onboard)):  # `write` would leave out parts that are not new
            mine[0, row] = kept[row * count + lane]
        key, number = private_words(1, 1)[0], private_words(1, 1)[0]
        key[0] = array_view(keys, 1, count)[0, lane]
        number[0] = array_view(numbers, 1, count)[0, lane]
        noise = private(drawn)
        for channel in range(rows(drawn)):
            noise[0, channel] = 0.0
        words, pairs = private_words(7, 1), private_floats(2, 1)
        logged = private_counters(1, 1)[0]
        logged[0] = 0
        log, devices = array_view(flights, 0, 1), array_view(plan, device_count, 3)
        for k in range(first, end):
            g: Any = SplitBuffer(avionics.systems, settings[0], opaque(mine[0]))
            generate(key, number, devices, k, noise, words, pairs)
            ticked(shape, avionics, alone[0], g, (0,), logged, float(k), channels, noise[0], log, k)
            powered(
                shape, avionics, alone[0], g, (0,), logged, float(k), duration, gusts, noise[0],
                rows(channels),
            )  # fmt: skip
            early = 0.0 if k + 1 == ticks else 1.0
            while to_tick(shape, alone, (0,), log, logged, SLICE, early) > 0:
                pass
        put_flight(shape, alone[0], shared, count, lane)
        after = opaque(mine[0])
        for row in range(rows(avionics.onboard)):
            kept[row * count + lane] = after[row]

"""Entry points of a GPU, where each thread flies one flight.

A thread copies its flight out of the shared buffers, flies it with the same functions that fly a
single flight on the processor, and copies it back.  In Python, these entry points fly the flight of
one thread.

The threads of a warp execute the same instructions: where they differ, they wait for each other.
So one entry point flies from tick to tick as long as a flight cruises, another takes the steps of
those that do not, of which there are few at a time.
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
from springback.kernels.layout import (
    Buffer,
    SplitBuffer,
    TreeLayout,
    load,
    read,
    rows,
    store,
    write,
)
from springback.simulation.executor import TrajectoryLog, advance, cruise_to_tick
from springback.simulation.lanes import places
from springback.simulation.noise import NoiseSource, generate
from springback.simulation.ticks import (
    FlightBuffers,
    FlightLog,
    Layouts,
    drive_rotors,
    sense_and_decide,
)

#: Rows of the clocks: number of the tick, and 1 if the flight must take full steps to reach the
#: next one, else 0.
TICK, STEPS = 0, 1
#: Rows of all clocks.
CLOCK = 2


class SharedFlights(NamedTuple):
    """Flights in the memory that all threads share."""

    moving: Any  # motion and record, of guided flights `TickSettings` too, shape (rows x flights,)
    number: int


class SharedClocks(NamedTuple):
    """Where guided flights are, in the memory that all threads share."""

    clocks: Any  # integers, shape (CLOCK x flights,)
    last: int
    """Last tick of the flights."""


class SharedGuidedFlights(NamedTuple):
    """Guided flights in the memory that all threads share."""

    flights: SharedFlights
    clocks: SharedClocks
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


class TickSettings(NamedTuple):
    """What the systems on board set in the model at each tick."""

    thrust: Any
    reaction: Any
    air: Any
    until: Any


class StepLayouts(NamedTuple):
    """Layouts of the steps between two ticks, and of a thread's memory."""

    shape: TreeLayout
    settings: TreeLayout  # a `TickSettings`
    motion: TreeLayout  # as many floats as the motion's buffer of a single flight


class TickLayouts(NamedTuple):
    """Layouts of a guided flight at its ticks, and of its thread's memory."""

    guided: Layouts
    steps: StepLayouts
    noise: TreeLayout  # as many floats as channels of sensors and gusts


class TickSpan(NamedTuple):
    """What each thread does before it stops."""

    ticks: int
    """Ticks to fly."""
    duration: float
    """Of the flight [s]."""


@kernel
def take_flight(shape: TreeLayout, flights: Buffer, count: int, lane: int, b: Buffer) -> None:
    """Copy motion and record of a flight from shared memory to the buffer of a single flight."""
    here, moving = places(shape, 1), rows(shape.motion)
    write(read(shape.motion, flights, 0, count, lane), b, here.motion, 1, 0)
    write(read(shape.record, flights, moving, count, lane), b, here.record, 1, 0)


@kernel
def take_settings(layouts: StepLayouts, flights: Buffer, count: int, lane: int, b: Buffer) -> None:
    """Copy what the last tick has set from shared memory to the model of a single flight."""
    first = rows(layouts.shape.motion) + rows(layouts.shape.record)
    found, model = read(layouts.settings, flights, first, count, lane), layouts.shape.model
    store(found.thrust, model.thrust, b, 1, 0)
    store(found.reaction, model.reaction, b, 1, 0)
    store(found.air, model.air, b, 1, 0)
    store(found.until, model.timing.until, b, 1, 0)


@kernel
def put_settings(layouts: StepLayouts, b: Buffer, flights: Buffer, count: int, lane: int) -> None:
    """Copy what a tick has set back."""
    first, model = rows(layouts.shape.motion) + rows(layouts.shape.record), layouts.shape.model
    settings = TickSettings(
        load(model.thrust, b, 1, 0),
        load(model.reaction, b, 1, 0),
        load(model.air, b, 1, 0),
        load(model.timing.until, b, 1, 0),
    )
    write(settings, flights, first, count, lane)


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
        lane: Number of the flight.
    """
    size = flights.number * (rows(shape.motion) + rows(shape.record))
    shared, alone = array_view(flights.moving, 1, size)[0], private(memory)
    write(model, alone[0], 0, 1, 0)
    take_flight(shape, shared, flights.number, lane, alone[0])
    logged = private_counters(1, 1)[0]
    logged[0] = 0
    log = TrajectoryLog(array_view(flights.moving, 0, 1), logged)
    advance(shape, alone, (0,), log, budget, 0.0)
    put_flight(shape, alone[0], shared, flights.number, lane)


def fly_to_tick(
    layouts: StepLayouts,
    model: Any,
    flights: SharedFlights,
    clocks: SharedClocks,
    budget: int,
    lane: int,
) -> None:
    """Advance the flight of one thread to its next tick.

    Args:
        layouts: Of the flight.
        model: Of the flight, but for what its last tick has set.
        flights: All flights.
        clocks: Of all flights.
        budget: Most steps to take.
        lane: Number of the flight.
    """
    shape, count = layouts.shape, flights.number
    size = count * (rows(shape.motion) + rows(shape.record) + rows(layouts.settings))
    shared, alone = array_view(flights.moving, 1, size)[0], private(layouts.motion)
    write(model, alone[0], 0, 1, 0)
    take_settings(layouts, shared, count, lane, alone[0])
    take_flight(shape, shared, count, lane, alone[0])
    logged = private_counters(1, 1)[0]
    logged[0] = 0
    log = TrajectoryLog(array_view(flights.moving, 0, 1), logged)
    clock = array_view(clocks.clocks, CLOCK, count)
    early = 0.0 if clock[TICK, lane] == clocks.last else 1.0
    if advance(shape, alone, (0,), log, budget, early) == 0:
        clock[TICK, lane] += 1
        clock[STEPS, lane] = 0
    put_flight(shape, alone[0], shared, count, lane)


def fly_ticks(
    layouts: TickLayouts,
    constants: GuidedConstants,
    guided: SharedGuidedFlights,
    source: SharedNoise,
    span: TickSpan,
    lane: int,
) -> None:
    """Fly the flight of one thread from tick to tick, until it must take full steps.

    Args:
        layouts: Of the flight and of the thread's memory.
        constants: Of the flight.
        guided: All flights.
        source: Of their noise.
        span: Ticks to be flown.
        lane: Number of the flight.
    """
    flights, count = guided.flights, guided.flights.number
    shape, avionics = layouts.guided.shape, layouts.guided.avionics
    size = count * (rows(shape.motion) + rows(shape.record) + rows(layouts.steps.settings))
    shared, alone = array_view(flights.moving, 1, size)[0], private(layouts.steps.motion)
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
    clock = array_view(guided.clocks.clocks, CLOCK, count)
    tick, behind, left = clock[TICK, lane], clock[STEPS, lane], span.ticks
    while tick <= guided.clocks.last and behind == 0 and left > 0:
        g: Any = SplitBuffer(avionics.systems, settings[0], opaque(mine[0]))
        buffers = FlightBuffers(alone[0], g, (0,))
        generate(own, tick, noise, words, pairs)
        sense_and_decide(layouts.guided, buffers, tick, noise[0], log)
        drive_rotors(layouts.guided, buffers, tick, noise[0], log, span.duration)
        put_settings(layouts.steps, alone[0], shared, count, lane)
        early = 0.0 if tick == guided.clocks.last else 1.0
        behind = cruise_to_tick(shape, alone[0], 1, log.trajectory, early)
        tick += 1 if behind == 0 else 0
        left -= 1
    put_flight(shape, alone[0], shared, count, lane)
    after = opaque(mine[0])
    for row in range(rows(avionics.onboard)):
        onboard[row * count + lane] = after[row]
    clock[TICK, lane], clock[STEPS, lane] = tick, behind

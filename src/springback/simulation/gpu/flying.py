"""Flights on a GPU: their buffers are copied there, flown, and copied back.

The results are those of the processor, bit for bit: the same source is compiled with the same
rounding, see `springback.kernels.gpu.ptx`.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

import numpy as np

from springback.contact.obstacles import World
from springback.contact.parameters import PLANES
from springback.contact.scene.faces import SolidScene
from springback.errors import InputError
from springback.kernels.compiler import Origin
from springback.kernels.gpu.cuda import LoadedKernel, Memory
from springback.kernels.gpu.nvptx import Precision, device_function
from springback.kernels.gpu.ptx import (
    Constants,
    kernel_of,
    one_at_a_time,
    parameter,
    program,
)
from springback.kernels.layout import Buffer, TreeLayout, rows, structure
from springback.simulation.executor import advance
from springback.simulation.flight import SLICE, fly_buffers, own_types, shape_of, sources
from springback.simulation.gpu.thread import (
    CLOCK,
    STEPS,
    TICK,
    GuidedConstants,
    SharedClocks,
    SharedFlights,
    SharedGuidedFlights,
    SharedNoise,
    StepLayouts,
    TickLayouts,
    TickSettings,
    TickSpan,
    fly_impact,
    fly_ticks,
    fly_to_tick,
)
from springback.simulation.guided import GuidedFlight, ticks_of
from springback.simulation.lanes import Shape, buffer_rows, places
from springback.simulation.measuring.record import FLYING
from springback.simulation.noise import FlightNoise, generate
from springback.simulation.onboard import Avionics
from springback.simulation.thrusts import ThrustTable
from springback.simulation.ticks import (
    GUST_NOISE,
    FlightBuffers,
    drive_rotors,
    layouts_of,
    sense_and_decide,
)

#: Most ticks of a launch, between which interrupts are seen and progress is told; and fewer while
#: some flights take full steps, for which the others do not wait (chosen on an H200).
TICKS, FEW_TICKS = 100, 10

Progress = Callable[[float], None]


def _columns(lanes: Buffer, first: int, end: int) -> Buffer:
    """Rows of buffers of shape (groups, rows, width), as (rows, flights)."""
    chosen = lanes[:, first:end].transpose(1, 0, 2)
    return np.ascontiguousarray(chosen.reshape(end - first, -1))


def _put_back(columns: Buffer, lanes: Buffer, first: int) -> None:
    groups, _, width = lanes.shape
    count = len(columns)
    lanes[:, first : first + count] = columns.reshape(count, groups, width).transpose(1, 0, 2)


Mask = tuple[bool, ...]
"""For each leaf of a tree: True if it differs from flight to flight."""


def _varying(columns: Buffer) -> Mask:
    bits = columns.view(np.uint64 if columns.dtype == np.float64 else np.uint32)
    return tuple((bits != bits[:, :1]).any(axis=1).tolist())


def _constants(columns: Buffer, mask: Mask) -> list[Any]:
    """Arguments of a launch for a tree of every flight."""
    varies = np.array(mask, dtype=bool)
    return [*columns[~varies, 0].tolist(), Memory(columns[varies]), columns.shape[1]]


class _KernelKind:
    """Kernels for flights of one structure, by the leaves that vary among them."""

    def __init__(
        self, entry: Any, parameters: Any, parts: Any, files: Any, precision: Precision = "double"
    ) -> None:
        """Kernels of an entry point; none is compiled yet."""
        self._entry, self._parameters, self._parts, self._files = entry, parameters, parts, files
        self._precision = precision
        self._loaded: dict[tuple[Mask, ...], LoadedKernel] = {}

    def masks(self, *trees: Buffer) -> tuple[Mask, ...]:
        """Leaves that vary, or those of a kernel that is already loaded, which may be more."""
        wanted = tuple(map(_varying, trees))
        flat = np.concatenate(wanted)
        fits = (m for m in self._loaded if not (flat & ~np.concatenate(m)).any())
        return min(fits, key=lambda masks: sum(map(sum, masks)), default=wanted)

    def kernel(self, *masks: Mask) -> LoadedKernel:
        """Kernel for flights among which these leaves vary."""
        if masks not in self._loaded:
            types = [parameter(p) for p in self._parameters(*masks)]
            with one_at_a_time():
                lowered = program(self._entry, types, self._parts, self._files, self._precision)
                self._loaded[masks] = LoadedKernel(kernel_of(lowered, types))
        return self._loaded[masks]


_FLOATS, _WORDS, _NUMBERS = (np.zeros(1, dtype=kind) for kind in ("f8", "u8", "i8"))


@functools.cache
def _kinds() -> dict[Any, _KernelKind]:
    return {}


def _impacts(shape: Shape, precision: Precision) -> _KernelKind:
    key = fly_impact, structure(shape), precision
    if key not in _kinds():
        like, memory = TreeLayout(shape), TreeLayout((0.0,) * buffer_rows(shape, 1))

        def parameters(model: Mask) -> list[Any]:
            constants = Constants(like.model, model)
            return [like, memory, constants, SharedFlights(_FLOATS, 1), 1]

        def parts() -> dict[str, Any]:
            return {"advance": device_function(advance, precision)}

        files = _files(shape.model)
        _kinds()[key] = _KernelKind(fly_impact, parameters, parts, files, precision)
    return _kinds()[key]


def tick_settings(shape: Shape) -> TickSettings:
    """What a tick sets in the model of a flight."""
    model = shape.model
    return TickSettings(model.thrust, model.reaction, model.air, model.timing.until)


def _step_layouts(shape: Shape) -> StepLayouts:
    layouts = map(TreeLayout, (shape, tick_settings(shape), (0.0,) * buffer_rows(shape, 1)))
    return StepLayouts(*layouts)


_NO_FLIGHTS, _NO_CLOCKS = SharedFlights(_FLOATS, 1), SharedClocks(_NUMBERS, 1)


def _steps(shape: Shape) -> _KernelKind:
    """Kernels for the full steps of guided flights."""
    key = fly_to_tick, structure(shape)
    if key not in _kinds():
        layouts = _step_layouts(shape)

        def parameters(model: Mask) -> list[Any]:
            constants = Constants(layouts.shape.model, model)
            return [layouts, constants, _NO_FLIGHTS, _NO_CLOCKS, 1]

        def parts() -> dict[str, Any]:
            return {"advance": device_function(advance)}

        _kinds()[key] = _KernelKind(fly_to_tick, parameters, parts, _files(shape.model))
    return _kinds()[key]


def _ticks(shape: Shape, avionics: Avionics, channels: int) -> _KernelKind:
    """Kernels for the ticks of guided flights."""
    key = fly_ticks, structure(shape), structure(avionics), channels
    if key not in _kinds():
        guided = layouts_of(shape, avionics, channels)
        noise = TreeLayout((0.0,) * (channels + GUST_NOISE))
        layouts = TickLayouts(guided, _step_layouts(shape), noise)

        def parameters(model: Mask, systems: Mask) -> list[Any]:
            varying = guided.shape.model, model, guided.avionics.systems, systems
            return [
                layouts,
                GuidedConstants(Constants(*varying[:2]), Constants(*varying[2:])),
                SharedGuidedFlights(_NO_FLIGHTS, _NO_CLOCKS, _FLOATS),
                SharedNoise(_WORDS, _WORDS, _NUMBERS, 1),
                TickSpan(1, 1.0),
            ]

        def parts() -> dict[str, Any]:
            entries = sense_and_decide, drive_rotors, generate
            return {each.__name__: device_function(each) for each in entries}

        _kinds()[key] = _KernelKind(fly_ticks, parameters, parts, _files(shape.model, avionics))
    return _kinds()[key]


def _files(*trees: Any) -> Origin | None:
    """Origin of a user's code among the types of trees; None if it is not reliable."""
    own: set[type] = set().union(*map(own_types, trees))
    return sources(own) if own else Origin((), (), "")


def _check_world(world: World) -> None:
    """Reject obstacles that a routine of the processor looks for; some planes are among these.

    Raises:
        InputError: If there is a scene.
    """
    if isinstance(world.obstacles, SolidScene):
        raise InputError(
            f"a GPU flies into one or two faces of {', '.join(PLANES)} only, of force laws with "
            "exponent 1.5; use the processor"
        )


def fly_buffers_on_gpu(
    shape: Shape,
    buffers: Buffer,
    width: int,
    *,
    precision: Precision = "double",
    thrusts: ThrustTable | None = None,
    progress: Progress | None = None,
) -> None:
    """Fly all flights to their end on a GPU, in their buffers.

    Args:
        shape: Layout of the buffers.
        buffers: Shape (groups, rows x width).
        width: Lanes in a group.
        precision: In which the GPU computes. In single precision results are not the processor's:
            restitution and peaks keep three to five digits, see docs/benchmarks.md.
        thrusts: Thrusts over time of all flights, which are then flown on the processor.
        progress: Called from time to time with the share of flights done.

    Raises:
        InputError: If there is no GPU, or for obstacles that are not planes.
        PtxError: If the flights need a function that a GPU does not have.
    """
    _check_world(shape.model.world)
    if thrusts is not None:
        fly_buffers(shape, buffers, width, thrusts=thrusts, progress=progress)
        return
    lanes, at = buffers.reshape(len(buffers), -1, width), places(shape, width)
    moving, status = rows(shape.motion), at.status - at.record
    kind, model = _impacts(shape, precision), _columns(lanes, 0, at.motion)
    flights = np.vstack((_columns(lanes, at.motion, at.total), _columns(lanes, at.record, at.end)))
    if precision == "single":
        model, flights = model.astype(np.float32), flights.astype(np.float32)
    masks = kind.masks(model)
    kernel, constants = kind.kernel(*masks), _constants(model, *masks)
    there, count = Memory(flights), flights.shape[1]
    flying = np.arange(count)
    while len(flying):
        kernel.launch(Memory(flying), *constants, there, count, SLICE)
        flying = np.flatnonzero(there.row(moving + status) == FLYING)
        if progress is not None:
            progress(1.0 - len(flying) / count)
    there.read_into(flights)
    _put_back(flights[:moving], lanes, at.motion)
    _put_back(flights[moving:], lanes, at.record)


def fly_groups_on_gpu(
    flight: GuidedFlight,
    buffers: FlightBuffers,
    noise: FlightNoise,
    *,
    progress: Progress | None = None,
) -> None:
    """Fly guided flights to their end on a GPU, in their buffers.

    Args:
        flight: Of the same structure, duration and clock as all flights.
        buffers: Of all flights.
        noise: Of all flights.
        progress: Called from time to time with the share of flights done.

    Raises:
        InputError: If there is no GPU, or for obstacles that are not planes.
        PtxError: If the flights need a function that a GPU does not have.
    """
    model, start, avionics = flight
    _check_world(model.world)
    width, duration, shape = len(buffers.lanes), model.timing.until, shape_of(model, start)
    ticks, at = ticks_of(duration, avionics.systems.period), places(shape, width)
    channels = sum(draw.channels for draw in noise.draws) - GUST_NOISE
    lanes, inside = (b.reshape(len(b), -1, width) for b in (buffers.motion, buffers.onboard))
    after, end = rows(avionics.systems), rows(avionics)
    models, systems = _columns(lanes, 0, at.motion), _columns(inside, 0, after)
    moved = np.vstack((_columns(lanes, at.motion, at.total), _columns(lanes, at.record, at.end)))
    kept, count = len(moved), moved.shape[1]
    moved = np.vstack((moved, np.zeros((rows(tick_settings(shape)), count))))
    changed, clock = _columns(inside, after, end), np.zeros((CLOCK, count), dtype=np.int64)
    between, at_ticks = _steps(shape), _ticks(shape, avionics, channels)
    of_model, of_both = between.masks(models), at_ticks.masks(models, systems)
    step, tick = between.kernel(*of_model), at_ticks.kernel(*of_both)
    there, memories, clocks = map(Memory, (moved, changed, clock))
    source = noise.source(count)
    shared = there, count, clocks, ticks - 1
    for_steps = *_constants(models, *of_model), *shared, SLICE
    for_ticks = [
        *_constants(models, of_both[0]), *_constants(systems, of_both[1]), *shared, memories,
        *map(Memory, source), len(source.plan),
    ]  # fmt: skip
    flying, behind = np.arange(count), np.arange(0)
    while len(flying):
        if len(behind):
            step.launch(Memory(behind), *for_steps)
        tick.launch(Memory(flying), *for_ticks, FEW_TICKS if len(behind) else TICKS, duration)
        clocks.read_into(clock)
        flying, behind = np.flatnonzero(clock[TICK] < ticks), np.flatnonzero(clock[STEPS])
        if progress is not None:
            progress(float(clock[TICK].mean()) / ticks)
    there.read_into(moved)
    memories.read_into(changed)
    _put_back(moved[: rows(shape.motion)], lanes, at.motion)
    _put_back(moved[rows(shape.motion) : kept], lanes, at.record)
    _put_back(changed, inside, after)

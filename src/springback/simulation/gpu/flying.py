"""Flights on a GPU: what lies in their buffers goes there, is flown, and comes back.

The rows that come back are those of the processor, bit for bit: the same source is compiled with
the same rounding, see `springback.kernels.gpu.ptx`.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.kernels.compiler import Origin
from springback.kernels.gpu.cuda import Loaded, Memory
from springback.kernels.gpu.nvptx import device_function
from springback.kernels.gpu.ptx import (
    Constants,
    kernel_of,
    one_at_a_time,
    parameter,
    program,
)
from springback.kernels.layout import Buffer, TreeLayout, rows, structure
from springback.simulation.executor import advance, to_tick
from springback.simulation.flight import SLICE, own_types, shape_of, sources
from springback.simulation.gpu.thread import fly_impact, fly_ticks
from springback.simulation.guided import ticks_of
from springback.simulation.lanes import Shape, buffer_rows, places
from springback.simulation.noise import generate, key_of, plan_of
from springback.simulation.onboard import Avionics, Draw
from springback.simulation.record import FLYING, Model
from springback.simulation.ticks import GUST_NOISE, powered, ticked
from springback.vehicle.state import State

#: Ticks between two looks at the keyboard and the progress bar.
TICKS = 250

Progress = Callable[[float], None]


class _Columns(NamedTuple):
    """What lies in the buffers of many flights, one column a flight."""

    model: Buffer
    motion: Buffer
    record: Buffer


def _columns(lanes: Buffer, first: int, end: int) -> Buffer:
    """Rows of buffers of shape (groups, rows, width), as (rows, flights)."""
    chosen = lanes[:, first:end].transpose(1, 0, 2)
    return np.ascontiguousarray(chosen.reshape(end - first, -1))


def _put_back(columns: Buffer, lanes: Buffer, first: int) -> None:
    groups, _, width = lanes.shape
    count = len(columns)
    lanes[:, first : first + count] = columns.reshape(count, groups, width).transpose(1, 0, 2)


Mask = tuple[bool, ...]
"""Of each leaf of a tree: whether it varies from flight to flight."""


def _varying(columns: Buffer) -> Mask:
    bits = columns.view(np.uint64)
    return tuple((bits != bits[:, :1]).any(axis=1).tolist())


def _constants(columns: Buffer, mask: Mask) -> list[Any]:
    """Arguments of a launch for a tree of every flight."""
    varies = np.array(mask, dtype=bool)
    return [*columns[~varies, 0].tolist(), Memory(columns[varies]), columns.shape[1]]


class _KernelKind:
    """Kernels for flights of one structure, by what varies among them."""

    def __init__(self, entry: Any, parameters: Any, parts: Any, files: Any) -> None:
        """Nothing is compiled yet."""
        self._entry, self._parameters, self._parts, self._files = entry, parameters, parts, files
        self._loaded: dict[tuple[Mask, ...], Loaded] = {}

    def masks(self, *trees: Buffer) -> tuple[Mask, ...]:
        """What varies, or what a kernel that is there takes for varying, which may be more."""
        wanted = tuple(map(_varying, trees))
        flat = np.concatenate(wanted)
        fits = (m for m in self._loaded if not (flat & ~np.concatenate(m)).any())
        return min(fits, key=lambda masks: sum(map(sum, masks)), default=wanted)

    def kernel(self, *masks: Mask) -> Loaded:
        """The kernel for flights among which these leaves vary."""
        if masks not in self._loaded:
            types = [parameter(p) for p in self._parameters(*masks)]
            with one_at_a_time():
                lowered = program(self._entry, types, self._parts, self._files)
                self._loaded[masks] = Loaded(kernel_of(lowered, types))
        return self._loaded[masks]


_FLOATS, _WORDS = np.zeros(1), np.zeros(1, dtype=np.uint64)


@functools.cache
def _kinds() -> dict[Any, _KernelKind]:
    return {}


def _impacts(shape: Shape) -> _KernelKind:
    key = fly_impact, structure(shape)
    if key not in _kinds():
        like, memory = TreeLayout(shape), TreeLayout((0.0,) * buffer_rows(shape, 1))

        def parameters(model: Mask) -> list[Any]:
            return [like, memory, Constants(like.model, model), _FLOATS, 1, 1]

        def parts() -> dict[str, Any]:
            return {"advance": device_function(advance)}

        _kinds()[key] = _KernelKind(fly_impact, parameters, parts, _files(shape.model))
    return _kinds()[key]


def _guided(shape: Shape, avionics: Avionics, channels: int) -> _KernelKind:
    key = fly_ticks, structure(shape), structure(avionics), channels
    if key not in _kinds():
        like, onboard = TreeLayout(shape), TreeLayout(avionics)
        noise = [TreeLayout((0.0,) * n) for n in (channels, GUST_NOISE, channels + GUST_NOISE)]
        memory = TreeLayout((0.0,) * buffer_rows(shape, 1))

        def parameters(model: Mask, systems: Mask) -> list[Any]:
            constants = Constants(like.model, model), Constants(onboard.systems, systems)
            plan = np.zeros(1, dtype=np.int64)
            return [
                like, onboard, memory, *noise, *constants, _FLOATS, _FLOATS, 1, _WORDS, _WORDS,
                plan, 1, 1, 1, 1, 1.0,
            ]  # fmt: skip

        def parts() -> dict[str, Any]:
            between = device_function(to_tick, advance=device_function(advance))
            alone = {each.__name__: device_function(each) for each in (ticked, powered, generate)}
            return {**alone, "to_tick": between}

        _kinds()[key] = _KernelKind(fly_ticks, parameters, parts, _files(shape.model, avionics))
    return _kinds()[key]


def _files(*trees: Any) -> Origin | None:
    """Where a user's code among the types of trees comes from; None if that cannot be relied on."""
    own: set[type] = set().union(*map(own_types, trees))
    return sources(own) if own else Origin((), (), "")


def fly_buffers_on_gpu(
    shape: Shape, buffers: Buffer, width: int, *, progress: Progress | None = None
) -> None:
    """Fly every group of some buffers to the end, in place, on a GPU.

    Args:
        shape: What lies in the buffers.
        buffers: Shape (groups, rows x width).
        width: Lanes in a group.
        progress: Called now and then with the share of flights done.

    Raises:
        InputError: If there is no GPU.
        PtxError: If the flights need what is not there on one.
    """
    lanes, at = buffers.reshape(len(buffers), -1, width), places(shape, width)
    moving, status = rows(shape.motion), at.status - at.record
    kind, model = _impacts(shape), _columns(lanes, 0, at.motion)
    flights = np.vstack((_columns(lanes, at.motion, at.total), _columns(lanes, at.record, at.end)))
    masks = kind.masks(model)
    kernel, constants = kind.kernel(*masks), _constants(model, *masks)
    there, count = Memory(flights), flights.shape[1]
    flying = count
    while flying:
        kernel.launch(count, *constants, there, count, SLICE)
        there.read_into(flights)
        flying = int((flights[moving + status] == FLYING).sum())
        if progress is not None:
            progress(1.0 - flying / count)
    _put_back(flights[:moving], lanes, at.motion)
    _put_back(flights[moving:], lanes, at.record)


def fly_groups_on_gpu(
    model: Model,
    start: State,
    avionics: Avionics,
    buffers: Buffer,
    onboard: Buffer,
    draws: Sequence[Draw],
    seeds: Sequence[int],
    *,
    width: int,
    flights: Sequence[int] | None = None,
    progress: Progress | None = None,
) -> None:
    """Fly guided flights that lie ready in buffers to their end, in place, on a GPU.

    Args:
        model: Like those of the flights, of their duration.
        start: Like their states.
        avionics: Like what is aboard, with their clock.
        buffers: Of the motion, shape (groups, rows x width).
        onboard: Of what is aboard, shape (groups, rows x width).
        draws: When which normal numbers are drawn.
        seeds: One for each flight.
        width: Lanes in a group.
        flights: Their numbers, for their luck; 0 by default.
        progress: Called now and then with the share done.

    Raises:
        InputError: If there is no GPU.
        PtxError: If the flights need what is not there on one.
    """
    duration, shape = model.timing.until, shape_of(model, start)
    ticks, at = ticks_of(duration, avionics.systems.period), places(shape, width)
    channels = sum(draw.channels for draw in draws) - GUST_NOISE
    lanes, inside = (b.reshape(len(b), -1, width) for b in (buffers, onboard))
    after, end = rows(avionics.systems), rows(avionics)
    kind = _guided(shape, avionics, channels)
    models, systems = _columns(lanes, 0, at.motion), _columns(inside, 0, after)
    masks = kind.masks(models, systems)
    kernel = kind.kernel(*masks)
    moved = np.vstack((_columns(lanes, at.motion, at.total), _columns(lanes, at.record, at.end)))
    changed, count = _columns(inside, after, end), moved.shape[1]
    numbers = list(flights) if flights is not None else [0] * len(seeds)
    keys = [key_of(seed) for seed in seeds]
    spare = count - len(keys)
    there, memories, plan = Memory(moved), Memory(changed), plan_of(draws)
    arguments = [
        *_constants(models, masks[0]), *_constants(systems, masks[1]), there, memories, count,
        Memory(np.array(keys + keys[-1:] * spare, dtype=np.uint64)),
        Memory(np.array(numbers + numbers[-1:] * spare, dtype=np.uint64)),
        Memory(plan), len(plan),
    ]  # fmt: skip
    for first in range(0, ticks, TICKS):
        last = min(first + TICKS, ticks)
        kernel.launch(count, *arguments, first, last, ticks, duration)
        if progress is not None:
            progress(last / ticks)
    there.read_into(moved)
    memories.read_into(changed)
    _put_back(moved[: rows(shape.motion)], lanes, at.motion)
    _put_back(moved[rows(shape.motion) :], lanes, at.record)
    _put_back(changed, inside, after)

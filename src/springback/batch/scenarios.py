"""Batch flights: outcomes and measures of many scenarios, flown together.

Building a flight and reading its results alone would take longer than flying it.  Here flights
share what their tables share, are stored in buffers by their differences, and are read column by
column; every number is that of the flight flown alone.
"""

from __future__ import annotations

import gc
import math
from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import partial
from typing import Any, Literal, NamedTuple

import numpy as np

from springback.batch.templates import BuiltGroup, ScenarioGroup, build_group, pace_of
from springback.batch.validation import UNCHECKED, flight_from_tables, settings_of
from springback.errors import InputError
from springback.kernels.layout import Buffer, row_of, rows, structure
from springback.kernels.memo import Memo
from springback.progress import Progress, silent, stage
from springback.recovery.evaluator import EvaluatorMemory
from springback.results.recovery_measures import (
    RECOVERY_MEASURES,
    recovery_columns,
    recovery_outcomes,
)
from springback.scenario.avionics import turn_on_normals
from springback.scenario.build import ReadyFlight
from springback.simulation.columns import Array, columns_of, energies
from springback.simulation.flight import LANES, fly_buffers
from springback.simulation.guided import GuidedFlight
from springback.simulation.guided_batch import GUIDED_LANES, fly_groups
from springback.simulation.loading import DifferentStructure, LoadedFlights, Loader
from springback.simulation.measures import MEASURES, measure_columns, outcomes_of
from springback.simulation.noise import FlightNoise
from springback.simulation.onboard import Avionics
from springback.simulation.ticks import FlightBuffers

#: Outcome of a flight whose scenario cannot be flown.
REFUSED = "refused"
#: Flights built together (chosen: their buffers then take some 100 MB).
BLOCK = 4096
#: The same for a GPU: the number in flight at a time on one with 132 processors (measured).
GPU_BLOCK = 33_792

Device = Literal["cpu", "gpu"]
"""Device for flights: lanes of the processor, or one flight per thread of an NVIDIA GPU."""
#: Number of recent groups with which a flight is compared (chosen).
MOST_TRIED = 8
#: Tables by which flights are sorted, so that those that share much are adjacent.
ORDER = ("vehicle", "recovery", "estimator", "sensors", "reference")


class Rows(NamedTuple):
    """Results of many flights, in their order."""

    outcomes: list[str]
    """Words of `springback.simulation.measures.Outcome`, or `REFUSED`."""
    measures: dict[str, Array]
    """Measures of each flight, all of `MEASURES` and `RECOVERY_MEASURES`; NaN if undefined."""
    problems: list[str]
    """Reason for the refusal of each flight; empty if it was flown."""


class _Fly(NamedTuple):
    """Functions that fly buffers to their end."""

    impacts: Callable[..., None]
    guided: Callable[..., None]


class _Kind(NamedTuple):
    """Flights of one batch, while they are collected."""

    loader: Loader
    first: ReadyFlight
    numbers: list[int]
    seeds: list[int]


def fly_scenarios(
    tables: Sequence[Mapping[str, Any]],
    *,
    threads: int = 1,
    device: Device = "cpu",
    progress: Progress = silent,
) -> Rows:
    """Fly many scenarios; each flight's numbers depend on its own tables alone.

    It is fast where flights share tables: the same objects, at any depth.

    Args:
        tables: Whole scenarios, as plain tables.
        threads: Number of threads, on the processor.
        device: Device that flies them; the numbers are the same.
        progress: Called from time to time with the fraction done.

    Raises:
        InputError: If there is no such device.
    """
    count, build = len(tables), Memo()
    out = Rows(
        [REFUSED] * count,
        {name: np.full(count, math.nan) for name in MEASURES | RECOVERY_MEASURES},
        [""] * count,
    )
    order, most = _order(tables), BLOCK if device == "cpu" else GPU_BLOCK
    fly = _on_processor(threads) if device == "cpu" else _on_gpu()
    for first in range(0, count, most):
        block = order[first : first + most]
        share = stage(progress, first / count, len(block) / count)
        with no_collection():
            _fly_block(tables, block, build, fly, share, out)
            build.forget()
        share(1.0)
    return out


@contextmanager
def no_collection() -> Iterator[None]:
    """Context without the garbage collector, which would repeatedly walk all trees for nothing."""
    running = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if running:
            gc.enable()


def _order(tables: Sequence[Mapping[str, Any]]) -> list[int]:
    """Order in which flights that share tables are adjacent."""
    known: dict[Hashable, int] = {}

    def number(value: Any) -> int:
        return known.setdefault(value if isinstance(value, str) else id(value), len(known))

    keys = [tuple(number(table.get(name)) for name in ORDER) for table in tables]
    return sorted(range(len(tables)), key=keys.__getitem__)


def _fly_block(
    tables: Sequence[Mapping[str, Any]],
    block: list[int],
    build: Memo,
    fly: _Fly,
    progress: Progress,
    out: Rows,
) -> None:
    """Build some flights, fly them batch by batch, and read their results."""
    biases = dict(zip(block, _biases([tables[k] for k in block]), strict=True))

    def one(number: int) -> ReadyFlight:
        return flight_from_tables(tables[number], build, biases[number])

    kinds: dict[Any, _Kind] = {}
    alike, alone = _group(tables, block, build)
    for group in alike:
        many = build_group(group, [biases[k] or [] for k in group.flights], one)
        if many is None:
            alone += group.flights
        else:
            _add_many(many, [tables[k].get("seed", 0) for k in many.flights], kinds)
            alone += set(group.flights).difference(many.flights)
    last: _Kind | None = None
    for number in filter({*alone}.__contains__, block):
        try:
            ready = one(number)
        except InputError as error:
            out.problems[number] = "; ".join(error.problems)
            continue
        last = _add_to_kind(ready, last, kinds)
        last.numbers.append(number)
        last.seeds.append(ready.seed)
    done, all_ready = 0, sum(len(kind.numbers) for kind in kinds.values())
    for kind in kinds.values():
        size = len(kind.numbers)
        _fly_kind(kind, fly, stage(progress, done / all_ready, size / all_ready), out)
        done += size


def _biases(tables: Sequence[Mapping[str, Any]]) -> list[list[float] | None]:
    """Biases of all flights by `turn_on_normals`, drawn together; None for an invalid seed."""
    seeds = [table.get("seed", 0) for table in tables]
    different = list({seed for seed in seeds if type(seed) is int and seed >= 0})
    drawn = dict(zip(different, turn_on_normals(different), strict=True))
    return [drawn.get(seed) if type(seed) is int else None for seed in seeds]


def _group(
    tables: Sequence[Mapping[str, Any]], block: Sequence[int], build: Memo
) -> tuple[list[ScenarioGroup], list[int]]:
    """Groups of flights that differ in numbers only, and the flights that have errors."""
    alike: list[ScenarioGroup] = []
    wrong: list[int] = []
    before: tuple[Mapping[str, Any], Mapping[str, Any]] = {}, {}
    for number in block:
        try:
            settings = settings_of(tables[number], build, before)
        except UNCHECKED:
            wrong.append(number)
            continue
        del settings["seed"]
        before = tables[number], settings
        for k, group in enumerate(alike[:MOST_TRIED]):
            if group.takes(number, settings):
                alike.insert(0, alike.pop(k))  # the next one is likely to match it
                break
        else:
            alike.insert(0, ScenarioGroup(number, settings, build))
    return alike, wrong


def _add_many(many: BuiltGroup, seeds: Sequence[int], kinds: dict[Any, _Kind]) -> None:
    """Add flights that were built together to those of their kind."""
    kind = _kind_of(many.first, kinds)
    avionics = many.first.built_avionics.avionics if many.first.built_avionics else None
    kind.loader.add_alike(many.first.model, many.first.start, avionics, many.flown, many.onboard)
    kind.numbers.extend(many.flights)
    kind.seeds.extend(seeds)


def _add_to_kind(one: ReadyFlight, last: _Kind | None, kinds: dict[Any, _Kind]) -> _Kind:
    """Add a flight to its kind, first trying that of the flight before it; returns the kind."""
    avionics = one.built_avionics.avionics if one.built_avionics else None
    if last is not None and pace_of(one) == pace_of(last.first):
        try:
            last.loader.add(one.model, one.start, avionics)
        except DifferentStructure:
            pass
        else:
            return last
    kind = _kind_of(one, kinds)
    kind.loader.add(one.model, one.start, avionics)
    return kind


def _kind_of(one: ReadyFlight, kinds: dict[Any, _Kind]) -> _Kind:
    """Kind of a flight, created for the first of it."""
    avionics = one.built_avionics.avionics if one.built_avionics else None
    key = structure(one.model), structure(avionics), pace_of(one)
    if key not in kinds:
        width = LANES if avionics is None else GUIDED_LANES
        kinds[key] = _Kind(Loader(one.model, one.start, avionics, width), one, [], [])
    return kinds[key]


def _on_processor(threads: int) -> _Fly:
    """Functions that fly buffers in lanes, on so many threads."""
    return _Fly(partial(fly_buffers, threads=threads), partial(fly_groups, threads=threads))


def _on_gpu() -> _Fly:
    """Functions that fly buffers on a GPU, if there is one."""
    from springback.kernels.gpu.cuda import device
    from springback.simulation.gpu.flying import fly_buffers_on_gpu, fly_groups_on_gpu

    device()
    return _Fly(fly_buffers_on_gpu, fly_groups_on_gpu)


def _fly_kind(kind: _Kind, fly: _Fly, progress: Progress, out: Rows) -> None:
    """Fly all flights of one kind, and store their results."""
    laid, width, count = kind.loader.flights(), kind.loader.width, len(kind.numbers)
    before = energies(laid.shape, laid.buffers, width, count)
    built_avionics = kind.first.built_avionics
    if built_avionics is None or laid.avionics is None or laid.onboard is None:
        fly.impacts(laid.shape, laid.buffers, width, progress=progress)
    else:
        flight = GuidedFlight(laid.model, laid.start, laid.avionics)
        buffers = FlightBuffers(laid.buffers, laid.onboard, (0,) * width)
        noise = FlightNoise(built_avionics.noise, kind.seeds, [0] * count)
        fly.guided(flight, buffers, noise, progress=progress)
    words, columns = _read(laid, before, width, count)
    numbers = np.array(kind.numbers)
    for number, word in zip(kind.numbers, words, strict=True):
        out.outcomes[number] = word
    for name, column in columns.items():
        out.measures[name][numbers] = column


def _read(
    laid: LoadedFlights, before: Any, width: int, count: int
) -> tuple[list[str], dict[str, Array]]:
    """Outcomes and measures of all flights of one kind."""
    shape, buffers = laid.shape, laid.buffers
    work_row = rows(shape.model) + row_of(shape.motion, "work")
    record = columns_of(shape.record, buffers, -rows(shape.record), width, count)
    work = columns_of(shape.motion.work, buffers, work_row, width, count)
    after = energies(shape, buffers, width, count)
    columns = measure_columns(record, work, before, after)
    if laid.avionics is None or laid.onboard is None:
        return [one.word for one in outcomes_of(record)], columns
    if not isinstance(laid.avionics.onboard.evaluator, EvaluatorMemory):
        return [one.word for one in outcomes_of(record)], columns
    seen = _onboard_columns(laid.avionics, laid.onboard, width, count, "evaluator")
    memory = _onboard_columns(laid.avionics, laid.onboard, width, count, "pilot")
    words = [one.word for one in recovery_outcomes(record, seen)]
    return words, columns | recovery_columns(record, seen, memory)


def _onboard_columns(avionics: Avionics, buffers: Buffer, width: int, count: int, name: str) -> Any:
    """One part of the on-board state, in columns."""
    row = rows(avionics.systems) + row_of(avionics.onboard, name)
    return columns_of(getattr(avionics.onboard, name), buffers, row, width, count)

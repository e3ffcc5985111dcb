"""Batch flights: outcomes and measures of many scenarios, flown together.

Building a flight and reading its results alone would take longer than flying it.  Here flights that
differ in numbers only are built together, and read column by column; every number is that of the
flight flown alone.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from functools import cache, partial
from typing import Any, Literal, NamedTuple

import numpy as np

from springback.batch.templates import BuiltGroup, ScenarioGroup, built_groups, pace_of
from springback.errors import InputError
from springback.kernels.compiler import no_collection
from springback.kernels.layout import Buffer, row_of, rows, structure
from springback.kernels.routines import routines_compiled, tables_held
from springback.kernels.trees import leaves
from springback.progress import Progress, silent, stage
from springback.recovery.evaluator import EvaluatorMemory
from springback.results.contacts.places import NamedObstacles, names_in
from springback.results.flight import fly_built, pair_flight
from springback.results.recovery_measures import (
    RECOVERY_MEASURES,
    guided_result,
    recovery_columns,
    recovery_outcomes,
)
from springback.results.saved import SECOND
from springback.scenario.avionics import normals_at_start
from springback.scenario.build import ReadyFlight
from springback.scenario.scenario import scenario_from
from springback.scenario.user.compiled import compiling
from springback.simulation.flight import LANES, fly_buffers
from springback.simulation.guided import GuidedFlight
from springback.simulation.guided_batch import GUIDED_LANES, fly_groups
from springback.simulation.lanes import lanes_of
from springback.simulation.loading import LoadedFlights, Loader
from springback.simulation.measuring.columns import Array, columns_of, energies, tree_from
from springback.simulation.measuring.measures import MEASURES, measure_columns, outcomes_of
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


class Rows(NamedTuple):
    """Results of many flights, in their order."""

    outcomes: list[str]
    """Words of `springback.simulation.measuring.measures.Outcome`, or `REFUSED`."""
    measures: dict[str, Array]
    """Measures of each flight, all of `MEASURES` and `RECOVERY_MEASURES`; NaN if undefined."""
    problems: list[str]
    """Reason for the refusal of each flight; empty if it was flown."""
    first_obstacles: list[str]
    """What each flight touched first; empty if nothing."""
    seconds: list[str]
    """Outcomes of the second vehicles; empty for a flight of one.  Where any has two, `measures`
    has those of the second, after ``second_``."""

    @property
    def columns(self) -> dict[str, Any]:
        """All of it by column, that of the second vehicles last, if there are any."""
        words = {"outcome": self.outcomes, "problem": self.problems}
        given = {**words, "first_obstacle": self.first_obstacles, **self.measures}
        return given | ({SECOND + "outcome": self.seconds} if SECOND_NAMES[0] in given else {})


#: Measures of a vehicle, and those of a second one.
NAMES = (*MEASURES, *RECOVERY_MEASURES)
SECOND_NAMES = tuple(SECOND + name for name in NAMES)


class _Fly(NamedTuple):
    """Functions that fly buffers to their end."""

    impacts: Callable[..., None]
    guided: Callable[..., None]
    threads: int  # for flights one by one


class _Kind(NamedTuple):
    """Flights of one batch, while they are collected."""

    loader: Loader
    first: ReadyFlight
    numbers: list[int]
    seeds: list[int]
    names: list[NamedObstacles]


def fly_scenarios(
    tables: Sequence[Mapping[str, Any]],
    *,
    threads: int = 1,
    device: Device = "cpu",
    progress: Progress = silent,
) -> Rows:
    """Fly many scenarios; each flight's numbers depend on its own tables alone.

    It is fast where eight or more differ in numbers only.

    Args:
        tables: Whole scenarios, as plain tables.
        threads: Number of threads, on the processor.
        device: Device that flies them; the numbers are the same.
        progress: Called from time to time with the fraction done.

    Raises:
        InputError: If there is no such device.
    """
    count = len(tables)
    names = (*NAMES, *SECOND_NAMES) if any(map(has_second, tables)) else NAMES
    measures = {name: np.full(count, math.nan) for name in names}
    out = Rows([REFUSED] * count, measures, [""] * count, [""] * count, [""] * count)
    most = BLOCK if device == "cpu" else GPU_BLOCK
    fly = _on_processor(threads) if device == "cpu" else _on_gpu()
    for first in range(0, count, most):
        block = range(first, min(first + most, count))
        share = stage(progress, first / count, len(block) / count)
        with no_collection(), tables_held():
            _fly_block(tables, block, fly, share, out)
        share(1.0)
    return out


def _fly_block(
    tables: Sequence[Mapping[str, Any]],
    block: Sequence[int],
    fly: _Fly,
    progress: Progress,
    out: Rows,
) -> None:
    """Build some flights, fly them batch by batch, and read their results."""

    def one(number: int) -> ReadyFlight:
        try:
            return scenario_from(tables[number], False, advises=False).build(advises=False)
        except InputError as error:
            out.problems[number] = "; ".join(error.problems)
            raise

    drawn = cache(normals_at_start)  # robots share seeds

    def normals(number: int) -> list[float]:
        air = tables[number].get("air")
        gusts = air.get("gusts") if isinstance(air, Mapping) else None
        return drawn(_seed(tables[number]), gusts is not None)

    kinds: dict[Any, _Kind] = {}
    pairs = [number for number in block if has_second(tables[number])]
    for group in _groups(tables, sorted(set(block).difference(pairs))):
        flights = group.flights
        for built in built_groups(group, normals, one):
            _collect(built, tables, kinds)
            flights = sorted(set(flights).difference(built.flights))
        for number in flights:
            if not out.problems[number]:
                with suppress(InputError):
                    ready = one(number)
                    if ready.plain is not None:
                        _fly_alone(ready, tables[number], number, out)
                    else:
                        _collect(BuiltGroup([number], ready), tables, kinds)
    done, all_ready = 0, sum(len(kind.numbers) for kind in kinds.values()) + len(pairs)
    for kind in kinds.values():
        size = len(kind.numbers)
        _fly_kind(kind, fly, stage(progress, done / all_ready, size / all_ready), out)
        done += size
    with ThreadPoolExecutor(fly.threads) as pool:
        for _ in pool.map(lambda number: _fly_pair(tables[number], number, out), pairs):
            done += 1
            progress(done / all_ready)


def has_second(tables: Mapping[str, Any]) -> bool:
    """True for a scenario with two vehicles, as plain tables."""
    return tables.get("second") is not None


def _fly_pair(tables: Mapping[str, Any], number: int, out: Rows) -> None:
    """Fly one flight of two vehicles, and store its results, or the reason why it failed."""
    try:
        scenario = scenario_from(tables, False, advises=False)
        flight = pair_flight(scenario, scenario.build(advises=False), trace=False)
    except InputError as error:
        out.problems[number] = "; ".join(error.problems)
        return
    assert flight.second is not None
    out.outcomes[number], out.seconds[number] = flight.outcome.word, flight.second.outcome.word
    out.first_obstacles[number] = flight.first_obstacle
    measures = {SECOND + name: value for name, value in flight.second.measures.items()}
    for name, value in (flight.measures | measures).items():
        out.measures[name][number] = math.nan if value is None else value


def _groups(tables: Sequence[Mapping[str, Any]], block: Sequence[int]) -> list[ScenarioGroup]:
    """Groups of flights that differ in numbers only; those of invalid seeds by themselves."""
    groups: list[ScenarioGroup] = []
    refused: list[ScenarioGroup] = []
    for number in block:
        if type(seed := _seed(tables[number])) is not int or seed < 0:
            refused.append(ScenarioGroup(number, tables[number]))
            continue
        for k, group in enumerate(groups[:MOST_TRIED]):
            if group.takes(number, tables[number]):
                groups.insert(0, groups.pop(k))  # the next one is likely to match it
                break
        else:
            groups.insert(0, ScenarioGroup(number, tables[number]))
    return groups + refused


def _seed(tables: Mapping[str, Any]) -> Any:
    return tables.get("seed", 0)


def _collect(
    built: BuiltGroup, tables: Sequence[Mapping[str, Any]], kinds: dict[Any, _Kind]
) -> None:
    """Add flights to those of their kind, which is created for the first of it."""
    one = built.first
    avionics = one.built_avionics.avionics if one.built_avionics else None
    key = structure(one.model), structure(avionics), pace_of(one)
    if key not in kinds:
        width = LANES if avionics is None else GUIDED_LANES
        kinds[key] = _Kind(Loader(one.model, one.start, avionics, width), one, [], [], [])
    kind = kinds[key]
    kind.loader.add(one.model, one.start, avionics, built.flown, built.onboard)
    kind.numbers.extend(built.flights)
    kind.seeds.extend(_seed(tables[k]) for k in built.flights)
    names = names_in(scenario_from(tables[built.flights[0]], False, advises=False), one.model)
    kind.names.extend([names] * len(built.flights))


def _fly_alone(ready: ReadyFlight, tables: Mapping[str, Any], number: int, out: Rows) -> None:
    """Fly one flight with a plain pilot, and store its results, or the reason why it failed."""
    try:
        guided = fly_built(ready)
    except InputError as error:
        out.problems[number] = "; ".join(error.problems)
        return
    outcome, measures = guided_result(guided)
    out.outcomes[number] = outcome.word
    names = names_in(scenario_from(tables, False, advises=False), ready.model)
    with routines_compiled():
        first = names.of_first(ready.model.world.obstacles, guided.flown.record.first_impact)
    out.first_obstacles[number] = first
    for name, value in measures.items():
        out.measures[name][number] = math.nan if value is None else value


def _on_processor(threads: int) -> _Fly:
    """Functions that fly buffers in lanes, on so many threads."""
    return _Fly(
        partial(fly_buffers, threads=threads),
        partial(fly_groups, threads=threads),
        threads,
    )


def _on_gpu() -> _Fly:
    """Functions that fly buffers on a GPU, if there is one."""
    from springback.kernels.gpu.cuda import device
    from springback.simulation.gpu.flying import fly_buffers_on_gpu, fly_groups_on_gpu

    device()
    return _Fly(fly_buffers_on_gpu, fly_groups_on_gpu, 1)


def _fly_kind(kind: _Kind, fly: _Fly, progress: Progress, out: Rows) -> None:
    """Fly all flights of one kind, and store their results."""
    laid, width, count = kind.loader.flights(), kind.loader.width, len(kind.numbers)
    with compiling(kind.first):
        before = energies(laid.shape, laid.buffers, width, count)
        _fly_laid(kind, laid, fly, progress)
    words, columns = _read(laid, before, width, count)
    numbers = np.array(kind.numbers)
    touched = _first_obstacles(laid, kind.names, width)
    for number, word, first in zip(kind.numbers, words, touched, strict=True):
        out.outcomes[number], out.first_obstacles[number] = word, first
    for name, column in columns.items():
        out.measures[name][numbers] = column


def _fly_laid(kind: _Kind, laid: LoadedFlights, fly: _Fly, progress: Progress) -> None:
    """Fly the buffers of all flights of one kind."""
    width, count = kind.loader.width, len(kind.numbers)
    built_avionics = kind.first.built_avionics
    if built_avionics is None or laid.avionics is None or laid.onboard is None:
        thrusts = kind.first.thrusts
        fly.impacts(laid.shape, laid.buffers, width, thrusts=thrusts, progress=progress)
        return
    flight = GuidedFlight(laid.model, laid.start, laid.avionics)
    buffers = FlightBuffers(laid.buffers, laid.onboard, lanes_of(width))
    noise = FlightNoise(built_avionics.noise, kind.seeds, [0] * count)
    fly.guided(flight, buffers, noise, progress=progress)


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
    words = [one.word for one in recovery_outcomes(record, seen, memory)]
    return words, columns | recovery_columns(record, seen, memory)


def _first_obstacles(laid: LoadedFlights, names: list[NamedObstacles], width: int) -> Iterator[str]:
    """What each flight of one kind touched first."""
    shape, buffers, count = laid.shape, laid.buffers, len(names)
    record = columns_of(shape.record, buffers, -rows(shape.record), width, count)
    alone = [one.only for one in names]
    if all(alone):
        touched = record.first_impact.touch_time >= 0.0
        yield from (name if there else "" for name, there in zip(alone, touched, strict=True))
        return
    obstacles = columns_of(shape.model, buffers, 0, width, count).world.obstacles
    of_worlds, of_touches = (np.array(leaves(tree)).T for tree in (obstacles, record.first_impact))
    with routines_compiled():
        for each, world, touch in zip(names, of_worlds, of_touches, strict=True):
            first = tree_from(record.first_impact, touch.tolist())
            yield each.of_first(tree_from(obstacles, world.tolist()), first)


def _onboard_columns(avionics: Avionics, buffers: Buffer, width: int, count: int, name: str) -> Any:
    """One part of the on-board state, in columns."""
    row = rows(avionics.systems) + row_of(avionics.onboard, name)
    return columns_of(getattr(avionics.onboard, name), buffers, row, width, count)

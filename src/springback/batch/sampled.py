"""States of many flights without avionics, at given instants.

Flights that differ in numbers only are built together and flown in lanes.  A step ends at each
instant, as at a tick of sensors, so that nothing is interpolated.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from typing import Any, NamedTuple

import numpy as np

from springback.batch.templates import BuiltGroup, KnownFormulas, built_groups
from springback.errors import InputError
from springback.kernels.compiler import no_collection
from springback.kernels.layout import Buffer, TreeLayout, row_of, rows, structure
from springback.kernels.trees import names
from springback.scenario.build import ReadyFlight
from springback.scenario.scenario import scenario_from
from springback.simulation.flight import LANES, SLICE, empty_log
from springback.simulation.lanes import lanes_of, places
from springback.simulation.loading import Loader
from springback.simulation.sampling import Instants, StateRows, sampler_for
from springback.simulation.thrusts import ThrustTable

Array = np.ndarray[Any, np.dtype[np.float64]]


class StateSamples(NamedTuple):
    """States of some flights at the same instants; NaN where a flight was refused or diverged."""

    times: Array  # [s], shape (instants,)
    columns: tuple[str, ...]  # leaves of `springback.vehicle.state.State`
    values: Array  # shape (flights, instants, columns)

    def of(self, *stems: str) -> Array:
        """Columns by name, shape (flights, instants, names); a view where they are neighbours."""
        places = [self.columns.index(stem) for stem in stems]
        first, last = places[0], places[-1] + 1
        if places == [*range(first, last)]:
            return self.values[:, :, first:last]
        return self.values[:, :, places]

    def vectors(self, name: str) -> Array:
        """A vector of the state, shape (flights, instants, 3)."""
        return self.of(*(f"{name}.{axis}" for axis in "xyz"))


def sampled_flights(
    tables: Sequence[Mapping[str, Any]],
    times: Any,
    *,
    thrust_factors: Any = None,
    threads: int = 1,
    known: KnownFormulas | None = None,
) -> StateSamples:
    """Fly scenarios without avionics, and read their states at some instants.

    Args:
        tables: Whole scenarios without a reference and a pilot, as plain tables, which differ in
            numbers only; with thrusts over time, all with the same.
        times: Instants [s], increasing, from 0; ``simulation.duration`` is not used.
        thrust_factors: Factor of all thrusts of each flight, shape (flights,); None: 1.
        threads: At most so many fly, each some groups.
        known: Formulas of earlier flights that differ in numbers only, for which they are built in
            a fraction of the time; those of these flights are added.

    Raises:
        InputError: If all of them are refused, with the first problem.
    """
    at = np.asarray(times, dtype=np.float64)
    factors = np.ones(len(tables)) if thrust_factors is None else np.asarray(thrust_factors, float)
    problems: list[InputError] = []
    with no_collection():
        built = _built(tables, problems, known or KnownFormulas())
        if not built:
            raise problems[0]
        kinds = _kinds(built)
        laid = [_laid(kind) for kind in kinds]
    columns = tuple(names(laid[0].shape.motion.state))
    values = np.full((len(tables), len(at), len(columns)), np.nan)
    for kind, flights in zip(kinds, laid, strict=True):
        numbers = [number for group in kind for number in group.flights]
        flown = _flown(flights, at, kind[0].first.thrusts, factors[numbers], threads)
        values[numbers] = flown[: len(numbers)]
    return StateSamples(at, columns, values)


def _kinds(built: Sequence[BuiltGroup]) -> list[list[BuiltGroup]]:
    """Groups by the types of their models: an exponent of 3/2 is another type than any other."""
    found: list[tuple[Any, list[BuiltGroup]]] = []
    for group in built:
        form = structure(group.first.model)
        same = next((groups for other, groups in found if other == form), None)
        if same is None:
            found.append((form, [group]))
        else:
            same.append(group)
    return [groups for _, groups in found]


def _laid(groups: Sequence[BuiltGroup]) -> Any:
    """Flights of one kind in lanes."""
    first = groups[0].first
    loader = Loader(first.model, first.start, None, LANES)
    for group in groups:
        loader.add(group.first.model, group.first.start, None, group.flown)
    return loader.flights()


def _flown(
    laid: Any, at: Array, thrusts: ThrustTable | None, factors: Array, threads: int
) -> Array:
    """States of the flights of one kind, and of those that fill the lanes."""
    spare = -len(factors) % LANES
    scale = np.concatenate([factors, np.ones(spare)]).reshape(-1, LANES)
    seen = np.empty((len(laid.buffers), len(at), rows(laid.shape.motion.state), LANES))
    workers = min(threads, len(laid.buffers))
    parts = np.array_split(np.arange(len(laid.buffers)), workers)
    given = at, thrusts, scale, seen
    with ThreadPoolExecutor(max(1, workers - 1)) as pool:  # without work it starts no thread
        flying = [pool.submit(_fly_part, laid, part, *given) for part in parts[1:]]
        _fly_part(laid, parts[0], *given)
        for one in flying:
            one.result()
    return np.asarray(seen.transpose(0, 3, 1, 2).reshape(-1, len(at), seen.shape[2]))


def _built(
    tables: Sequence[Mapping[str, Any]], problems: list[InputError], known: KnownFormulas
) -> list[BuiltGroup]:
    """Flights built together, or one by one where they cannot be."""

    def one(number: int) -> ReadyFlight:
        try:
            return scenario_from(tables[number], False, advises=False).build(advises=False)
        except InputError as error:
            problems.append(error)
            raise

    group = known.group(0, tables[0])
    for number in range(1, len(tables)):
        group.takes(number, tables[number])
    found = list(known.build(group))
    for built in built_groups(group, lambda number: [], one):
        known.add(built.formulas)
        found.append(built)
    done = {number for built in found for number in built.flights}
    for number in sorted({*range(len(tables))} - done):
        with suppress(InputError):
            found.append(BuiltGroup([number], one(number)))
    return found


def _fly_part(
    laid: Any,
    part: Any,
    at: Array,
    thrusts: ThrustTable | None,
    scale: Array,
    seen: Array,
) -> None:
    """Fly some groups from instant to instant."""
    first, last = int(part[0]), int(part[-1]) + 1
    buffers: Buffer = laid.buffers[first:last]
    shape, where = laid.shape, places(laid.shape, LANES)
    thrust, factors = row_of(shape.model, "thrust"), scale[first:last]
    count = len(laid.model.thrust)
    if thrusts is None:
        lanes: Any = buffers.reshape(len(buffers), -1, LANES)
        lanes[:, thrust : thrust + count] *= factors[:, None]
    given = np.zeros((0, count)) if thrusts is None else np.ascontiguousarray(thrusts.at(at))
    rows_read = StateRows(
        until=row_of(shape.model, "timing"), thrust=thrust, ramp=row_of(shape.model, "ramp"),
        state=where.motion, width=rows(shape.motion.state), status=where.status, step=where.step,
    )  # fmt: skip
    sampler_for(laid.model)(
        TreeLayout(shape), buffers, lanes_of(LANES), empty_log(), SLICE,
        Instants(at, given, factors), rows_read, seen[first:last],
    )  # fmt: skip

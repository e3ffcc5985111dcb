"""Compilation ahead: kernels of the common kinds of flight, or of scenarios of one's own.

A world of built-in shapes at rest is one structure to the compiler, whatever they are and however
many; one or two planes, and what moves, are others.  So few kinds of flight serve nearly all
scenarios, and they can be compiled before the first is flown.
"""

from __future__ import annotations

import itertools
import os
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from multiprocessing import get_context
from typing import Any, NamedTuple

from springback.batch.workers import end_with_parent
from springback.campaign.compiler_times import (
    FlightKind,
    compile_kind,
    compiler_time,
    flight_kinds,
)

_WALL: dict[str, Any] = {"type": "wall", "distance": "2.75 m", "surface": "wall"}
_GROUND: dict[str, Any] = {"type": "ground", "surface": "wall"}
_POLE: dict[str, Any] = {
    "type": "pole", "position": ["2.85 m", 0, 0], "radius": "10 cm", "surface": "wall",
}  # fmt: skip
_SLIDING: dict[str, Any] = {**_POLE, "motion": {"type": "constant", "velocity": ["1 m/s", 0, 0]}}
_HOLDING: dict[str, Any] = {**_POLE, "surface": {"preset": "wall", "friction_law": "bristle"}}
_THROWN: dict[str, Any] = {
    "vehicle": "arq", "thrust": "hover",
    "start": {"position": ["2.3 m", 0, "1 m"], "velocity": ["2 m/s", 0, 0]},
    "simulation": {"duration": "0.1 s"},
}  # fmt: skip
_FLOWN: dict[str, Any] = {
    "vehicle": "arq",
    "reference": {"type": "run-up", "speed": "2 m/s"},
    "simulation": {"duration": "0.1 s"},
}
_FLIGHTS: dict[str, dict[str, Any]] = {
    "a throw": _THROWN,
    "a pilot's flight": _FLOWN,
    "a recovery": {**_FLOWN, "recovery": {}},
}
_WORLDS: dict[str, list[dict[str, Any]]] = {
    "among shapes": [_POLE],
    "at a wall above the ground": [_WALL, _GROUND],
    "among shapes of which two move": [_POLE, _SLIDING],
    "at a wall": [_WALL],
    "among shapes of which many move": [_HOLDING, _SLIDING],
    "among shapes with bristles": [_HOLDING],
}
_ALL, _GUIDED, _THROWN_ONLY = tuple(_FLIGHTS), tuple(_FLIGHTS)[1:], tuple(_FLIGHTS)[:1]
#: In this order two processes compile them soonest: the second comes to shapes that move when the
#: first has the search of scenes, and both at last to what is rarest, in equal shares.
_ORDER = (
    *((where, _ALL) for where in tuple(_WORLDS)[:4]),
    *((where, flights) for flights in (_GUIDED, _THROWN_ONLY) for where in tuple(_WORLDS)[4:]),
)
#: Scenarios of the common kinds, by what they are.
COMMON: dict[str, dict[str, Any]] = {
    f"{flight} {where}": {**_FLIGHTS[flight], "world": {"obstacles": _WORLDS[where]}}
    for where, flights in _ORDER
    for flight in flights
}


def flights_of(vehicle: str) -> dict[str, dict[str, Any]]:
    """Scenarios of the common kinds of a vehicle, among shapes at rest, by what they are.

    Args:
        vehicle: Name of a preset.
    """
    return {
        f"{flight} of {vehicle} among shapes": {**tables, "vehicle": vehicle,
                                                "world": {"obstacles": _WORLDS["among shapes"]}}
        for flight, tables in _FLIGHTS.items()
    }  # fmt: skip


class NamedKind(NamedTuple):
    """A kind of flight, and what it is called."""

    name: str
    kind: FlightKind


#: Time between two looks at what has been compiled [s].
OFTEN = 0.2


class CompiledKind(NamedTuple):
    """A kind of flight whose kernels are in the cache."""

    name: str
    seconds: float
    """Processor time that it took [s]; 0 if it had been compiled before."""


def kinds_of(scenarios: Mapping[str, Mapping[str, Any]]) -> list[NamedKind]:
    """Kinds of flight of some scenarios, by name: each alone, and in lanes as in campaigns."""
    found: dict[str, NamedKind] = {}
    for name, tables in scenarios.items():
        for alone, how in ((True, "alone"), (False, "in campaigns")):
            for kind in flight_kinds([tables], alone=alone):
                found.setdefault(kind.key, NamedKind(f"{name}, {how}", kind))
    return list(found.values())


def compile_ahead(scenarios: Mapping[str, Mapping[str, Any]]) -> Iterator[CompiledKind]:
    """Compile the kinds of flight of some scenarios, side by side on all processors.

    What flies in the same world shares most of what is compiled: one process takes scenarios that
    follow each other there.

    Args:
        scenarios: By name.

    Yields:
        Each kind when it is in the cache.
    """
    context, running = get_context("spawn"), set[Future[None]]()
    compiled = context.Queue()
    with ProcessPoolExecutor(os.cpu_count() or 1, context, _report_to, (compiled,)) as pool:
        for together in _by_world(scenarios):
            kinds = kinds_of(together)
            missing = [one for one in kinds if not compiler_time(one.kind, {}).cached]
            yield from (CompiledKind(one.name, 0.0) for one in kinds if one not in missing)
            if missing:
                running.add(pool.submit(_compile_all, missing))
        while running:
            finished, running = wait(running, OFTEN, FIRST_COMPLETED)
            for one in finished:
                one.result()  # raises what it raised
            while not compiled.empty():
                yield compiled.get()
    while not compiled.empty():
        yield compiled.get()


def _by_world(scenarios: Mapping[str, Mapping[str, Any]]) -> list[dict[str, Mapping[str, Any]]]:
    """Neighbours of the same world, in groups."""
    groups = itertools.groupby(scenarios.items(), lambda item: repr(item[1].get("world")))
    return [dict(members) for _, members in groups]


def _report_to(compiled: Any) -> None:
    end_with_parent()
    _REPORTS.append(compiled)


def _compile_all(kinds: Sequence[NamedKind]) -> None:
    """Compile some kinds of flight in a worker process, and report each."""
    for one in kinds:
        _REPORTS[-1].put(CompiledKind(one.name, compile_kind(one.kind, {})))


#: Queue of a worker process, for what it has compiled.
_REPORTS: list[Any] = []

"""Compilation ahead: kernels of the common kinds of flight, or of scenarios of one's own.

A world of built-in shapes at rest is one structure to the compiler, whatever they are and however
many.  So few kinds of flight serve nearly all scenarios, and they can be compiled before the first
is flown.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Future, ProcessPoolExecutor, as_completed
from multiprocessing import get_context
from typing import Any, NamedTuple

from springback.campaign.compiler_times import (
    FlightKind,
    compile_kind,
    compiler_time,
    flight_kinds,
)

_WALL: dict[str, Any] = {"type": "wall", "distance": "2.75 m", "surface": "wall"}
_POLE: dict[str, Any] = {
    "type": "pole", "position": ["2.85 m", 0, 0], "radius": "10 cm", "surface": "wall",
}  # fmt: skip
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
#: Scenarios of the common kinds, by what they are.
COMMON: dict[str, dict[str, Any]] = {
    "a throw at a wall": {**_THROWN, "world": {"obstacles": [_WALL]}},
    "a throw among shapes": {**_THROWN, "world": {"obstacles": [_POLE]}},
    "a pilot's flight at a wall": {**_FLOWN, "world": {"obstacles": [_WALL]}},
    "a pilot's flight among shapes": {**_FLOWN, "world": {"obstacles": [_POLE]}},
    "a recovery among shapes": {**_FLOWN, "recovery": {}, "world": {"obstacles": [_POLE]}},
}


class NamedKind(NamedTuple):
    """A kind of flight, and what it is called."""

    name: str
    kind: FlightKind


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


class CompilerPlan(NamedTuple):
    """What is to be compiled, and how long it takes."""

    missing: tuple[NamedKind, ...]
    cached: tuple[NamedKind, ...]
    seconds: float
    """Estimate of the processor time [s]."""


def plan_of(kinds: Sequence[NamedKind]) -> CompilerPlan:
    """What of some kinds is not in the cache, as far as the record says."""
    times = [(one, compiler_time(one.kind, {})) for one in kinds]
    missing = tuple(one for one, time in times if not time.cached)
    cached = tuple(one for one, time in times if time.cached)
    return CompilerPlan(missing, cached, sum(t.seconds for _, t in times if not t.cached))


def compile_ahead(plan: CompilerPlan) -> Iterator[CompiledKind]:
    """Compile what is missing, side by side on all processors; each kind is yielded when done."""
    if not plan.missing:
        return
    workers = min(len(plan.missing), os.cpu_count() or 1)
    with ProcessPoolExecutor(workers, mp_context=get_context("spawn")) as pool:
        running: dict[Future[float], str] = {
            pool.submit(compile_kind, one.kind, {}): one.name for one in plan.missing
        }
        for done in as_completed(running):
            yield CompiledKind(running[done], done.result())

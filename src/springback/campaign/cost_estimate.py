"""Estimated cost of a campaign, from a few of its flights."""

from __future__ import annotations

import contextlib
import os
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from springback.batch.scenarios import fly_scenarios
from springback.campaign.compiler_times import (
    FlightKind,
    compile_kind,
    compiler_time,
    flight_kinds,
    is_packaged,
    kernel_files,
)
from springback.campaign.design.layout import Design
from springback.campaign.flying import try_code
from springback.campaign.running import duration_text
from springback.campaign.store import write_rows
from springback.errors import InputError
from springback.kernels.compiler import cache_folder, is_writable
from springback.kernels.layout import structure
from springback.scenario.scenario import scenario_from

#: Flights flown to measure their time (chosen).
TRIED = 64
#: Ratio of times from which the load is worth a line (chosen).
NOTICED = 1.2


@dataclass(frozen=True)
class CostEstimate:
    """Estimated cost of a campaign."""

    flights: int
    samples: int
    repeats: int
    robots: tuple[str, ...]
    dimensions: int
    tried: int
    """Number of flights tried."""
    refused: int
    """Number of those that could not be flown."""
    problem: str
    """Problem of the first of them."""
    kinds: int
    """Number of kinds of flight among those tried; each is compiled once."""
    compiled: bool
    """True if kernels had to be compiled for these flights, which are cached from now on."""
    cached: bool
    """True if kernels can be cached on this machine, or came with the package; else every worker
    compiles them."""
    setup: float
    """Time to compile the kernels or, if they were cached, to load them [s]."""
    compiling: float
    """Processor time to compile them: just now, the last time, or typically [s]."""
    recorded: bool
    """False if that is a typical time."""
    rate: float
    """Flights per second on one core, once compiled."""
    workers: int
    cores: int
    load: float
    """Mean number of processes that ran on this machine in the last minute."""
    time: float
    """Time of the whole campaign on this machine, if otherwise idle [s]."""
    loaded_time: float
    """The same if the present load goes on, shared evenly among processes [s]."""
    bytes: int
    """Size of the whole campaign on the disk."""

    def as_dict(self) -> dict[str, Any]:
        """Plain data."""
        return asdict(self)

    def sentence(self) -> str:
        """Text of several lines."""
        names = " and ".join(self.robots)
        lines = [
            f"{self.flights} flights: {self.samples} samples of {self.dimensions} dimensions, "
            f"{self.repeats} {'repeat' if self.repeats == 1 else 'repeats'}, {names}",
            f"{self.kinds} {'kind' if self.kinds == 1 else 'kinds'} of flight; "
            f"{self.rate:.3g} flights/s on one core, measured on {self.tried} flights just flown",
            self._kernels(),
            f"about {duration_text(self.time)} with {self.workers} "
            f"{'worker' if self.workers == 1 else 'workers'} on an idle machine of {self.cores} "
            f"{'core' if self.cores == 1 else 'cores'}, {_size(self.bytes)} on the disk",
            f"load: {self.load:.1f} other {'process' if self.load == 1.0 else 'processes'} now"
            + (
                f"; if they go on, about {duration_text(self.loaded_time)}"
                if self.loaded_time > NOTICED * self.time
                else ", which hardly matters"
            ),
        ]
        if self.refused:
            lines.append(f"{self.refused} of {self.tried} cannot be flown, such as: {self.problem}")
        return "\n".join(lines)

    def _kernels(self) -> str:
        """Sentence on the kernels of these kinds of flight."""
        took, work = duration_text(self.setup), duration_text(self.compiling)
        if not self.compiled:
            last = f", in {work} of processor time" if self.recorded else ""
            return f"kernels: compiled before{last}; each worker loads them, in about {took}"
        if self.cached:
            return (
                f"kernels: were new, and have just been compiled in {took} ({work} of processor "
                "time); they are cached now"
            )
        return f"kernels: cannot be cached here, so each worker compiles them, in about {took}"


def compiling_text(kinds: Sequence[FlightKind], code: Mapping[str, str]) -> str:
    """Sentence on the kernels of some kinds of flight, before they are compiled or loaded."""
    known = [compiler_time(kind, code) for kind in kinds]
    new = [one for one in known if not one.cached]
    if not new:
        return "kernels: in the cache"
    work, load, cores = sum(one.seconds for one in new), _load(), os.cpu_count() or 1
    last = "the last time" if all(one.recorded for one in new) else "typically"
    slower = (load + 1.0) / cores
    loaded = f"; at the present load of {load:.1f} processes about {duration_text(work * slower)}"
    loaded = loaded if slower > NOTICED else ""
    count = f"those of {len(new)} of {len(known)} kinds" if len(known) > 1 else "those of this kind"
    alone = " (flights to be kept are flown alone, a kind of their own)"
    kept = alone if any(kind.alone for kind in kinds) else ""
    return (
        f"kernels: {count} of flight{kept} are not in the cache, as far as is known; compiling "
        f"takes {duration_text(work)} of processor time ({last}){loaded}"
    )


def cost_estimate(
    design: Design, workers: int | None = None, remark: Callable[[str], None] | None = None
) -> CostEstimate:
    """Fly a few flights, spread over the campaign, twice: once to compile, once to measure.

    Args:
        design: Design of the campaign.
        workers: Number of processes; by default that of the cores.
        remark: Called with what compiling will take, before it begins.
    """
    try_code(design)
    workers = workers or os.cpu_count() or 1
    numbers = np.unique(np.linspace(0, design.flights - 1, TRIED).astype(int)).tolist()
    drawn = [design.slice(k, k + 1) for k in numbers]
    tables = [one.tables[0] for one in drawn]
    kinds = flight_kinds(tables)
    if design.plan.keep is not None:  # which are flown again, one by one
        kinds += flight_kinds(tables[: len(design.robots)], alone=True)
    if remark is not None:
        remark(compiling_text(kinds, design.code))
    load, known = _load(), kernel_files()
    before = [compiler_time(kind, design.code) for kind in kinds]
    begun = time.perf_counter()
    took = [compile_kind(kind, design.code) for kind in kinds]
    fly_scenarios(tables, threads=1)
    first = time.perf_counter() - begun
    compiled = bool(kernel_files() - known)
    cached = is_writable(cache_folder()) or all(is_packaged(kind) for kind in kinds)
    begun, used = time.perf_counter(), time.process_time()
    ended = fly_scenarios(tables, threads=1)
    # Time of the processor, as other work would have slowed down the clock's.
    rate = len(tables) / max(time.process_time() - used, 1e-9)
    setup = max(0.0, first - (time.perf_counter() - begun))
    columns = {name: [one.columns[name][0] for one in drawn] for name in drawn[0].columns}
    rows = {**columns, **ended.columns}
    problems = [problem for problem in ended.problems if problem]
    cores = os.cpu_count() or 1
    busy = min(workers, cores)
    alone, start = design.flights / (rate * busy), 0.0 if compiled and cached else setup
    slower = max(1.0, (load + workers) / cores)
    return CostEstimate(
        design.flights, design.samples, design.plan.repeats, design.robots,
        sum(not one.scatter for one in design.dimensions), len(tables), len(problems),
        problems[0] if problems else "", kinds_of(tables), compiled or not cached, cached, setup,
        sum(now or one.seconds for now, one in zip(took, before, strict=True)),
        all(now or one.recorded for now, one in zip(took, before, strict=True)),
        rate, workers, cores, load, start + alone, start + alone * slower,
        round(_bytes_each(rows, design) * design.flights),
    )  # fmt: skip


def _load() -> float:
    """Mean number of running processes in the last minute; 0 where the system does not say."""
    try:
        return os.getloadavg()[0]
    except (AttributeError, OSError):
        return 0.0


def kinds_of(tables: Sequence[dict[str, Any]]) -> int:
    """Number of kinds of flight, which differ in types, duration or clock."""
    kinds = set()
    for given in tables:
        with contextlib.suppress(InputError):
            scenario = scenario_from(given, False)
            model, avionics = scenario.build().model, scenario.build().built_avionics
            parts = (*model, avionics.avionics if avionics else ())
            kinds.add((structure(parts), model.timing.until, scenario.clock))
    return len(kinds)


def _bytes_each(rows: dict[str, Any], design: Design) -> float:
    """Bytes of a row on the disk, without the fixed part of a file."""
    few, count = {name: values[:1] for name, values in rows.items()}, len(rows["flight"])
    with tempfile.TemporaryDirectory() as folder:
        sizes = list[int]()
        for columns in (rows, few):
            path = Path(folder) / f"{len(sizes)}.parquet"
            write_rows(path, columns, design)
            sizes.append(path.stat().st_size)
    return (sizes[0] - sizes[1]) / max(1, count - 1)


def _size(count: float) -> str:
    for unit in ("B", "kB", "MB"):
        if count < 1000.0:
            return f"{count:.3g} {unit}"
        count /= 1000.0
    return f"{count:.3g} GB"

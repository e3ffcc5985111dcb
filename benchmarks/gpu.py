"""A GPU beside the processor, in one run: ``python -m benchmarks.gpu``.

Impacts are those of `benchmarks.job`; guided flights those of a plan such as README's million. Each
is timed from the memory of the GPU to its memory, and held against the processor bit by bit; the
campaign is timed whole, with start-up, set-up and writing.
"""

from __future__ import annotations

import argparse
import json
import os
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from benchmarks.job import reference_model, starts
from springback.campaign.design.layout import lay_out
from springback.campaign.design.plan import read_plan
from springback.campaign.running import run_campaign
from springback.kernels.gpu.cuda import LoadedKernel, device
from springback.kernels.gpu.nvptx import Precision
from springback.kernels.layout import Buffer, row_of, rows
from springback.scenario.scenario import scenario_from
from springback.simulation.flight import LANES, flight_buffers, fly_buffers, shape_of
from springback.simulation.gpu.flying import fly_buffers_on_gpu, fly_groups_on_gpu
from springback.simulation.guided import GuidedFlight
from springback.simulation.guided_batch import GUIDED_LANES, fly_groups
from springback.simulation.loading import Loader
from springback.simulation.noise import FlightNoise
from springback.simulation.ticks import FlightBuffers

#: Flights of each job that are flown on the processor, too; more are copies of them.
DIFFERENT = 1024
SCENARIO = """
vehicle = "arq"
[reference]
type = "run-up"
speed = "2 m/s"
[recovery]
[estimator]
type = "complementary"
[[world.obstacles]]
type = "wall"
distance = "2.75 m"
surface = "wall"
[[world.obstacles]]
type = "ground"
surface = "wall"
[simulation]
duration = "6 s"
"""
PLAN = """
name = "million"
seed = 1
scenario = "collision.toml"
robots = ["arq", "quad"]
method = "random"
samples = {samples}
scatter = "trials"
"""


def _copied(buffers: Buffer, times: int) -> Buffer:
    return np.tile(buffers, (times, 1))


class _Seconds(NamedTuple):
    """The best of several rounds."""

    whole: float
    """With copying to the GPU and back [s]."""
    kernels: float
    """On the GPU alone [s]."""


def _timed(fly: Callable[[], None], reset: Callable[[], None], rounds: int) -> _Seconds:
    launched: list[float] = []
    launch = LoadedKernel.launch

    def timed_launch(*arguments: Any) -> None:
        start = time.perf_counter()
        launch(*arguments)
        launched.append(time.perf_counter() - start)

    best = _Seconds(float("inf"), float("inf"))
    LoadedKernel.launch = timed_launch  # type: ignore[assignment,method-assign]
    try:
        for _ in range(rounds + 1):  # the first compiles
            reset()
            launched.clear()
            start = time.perf_counter()
            fly()
            took = time.perf_counter() - start
            best = _Seconds(min(best.whole, took), min(best.kernels, sum(launched)))
    finally:
        LoadedKernel.launch = launch  # type: ignore[method-assign]
    return best


def impacts(flights: int, rounds: int) -> dict[str, Any]:
    """Steps a second of free impacts, on both; in single precision with the error of measures."""
    model = reference_model()
    states = starts(model, DIFFERENT)
    shape = shape_of(model, states[0])
    ready = flight_buffers(shape, [model], states, LANES)
    there = _copied(ready, flights // DIFFERENT)
    work = there.copy()

    def reset() -> None:
        work[:] = there

    def fly(precision: Precision) -> None:
        fly_buffers_on_gpu(shape, work, LANES, precision=precision)

    single = _timed(lambda: fly("single"), reset, rounds)
    roughly = work.reshape(len(work), -1, LANES).copy()
    on_gpu = _timed(lambda: fly("double"), reset, rounds)
    here = ready.copy()
    begun = time.perf_counter()
    fly_buffers(shape, here.copy(), LANES)  # compiles
    first = time.perf_counter() - begun
    begun = time.perf_counter()
    fly_buffers(shape, here, LANES)
    on_cpu = time.perf_counter() - begun
    steps = -rows(shape.record) + row_of(shape.record.stepping, "steps")
    lanes = work.reshape(len(work), -1, LANES)
    taken, roughly_taken = (float(each[:, steps].sum()) for each in (lanes, roughly))
    return {
        "impacts": flights,
        "steps/s, gpu": taken / on_gpu.kernels,
        "steps/s, gpu, with copying": taken / on_gpu.whole,
        "steps/s, gpu, single": roughly_taken / single.kernels,
        "steps/s, gpu, single, with copying": roughly_taken / single.whole,
        "steps/s, cpu": float(here.reshape(len(here), -1, LANES)[:, steps].sum()) / on_cpu,
        "first on the cpu, seconds": first,
        "equal": _equal(shape, work, here, LANES),
        "errors, single": _errors(shape.record, roughly, lanes),
    }


def _errors(record: Any, some: Buffer, others: Buffer) -> dict[str, dict[str, float]]:
    """Relative differences of measures in flights that touch: median, 99 in 100, and largest."""
    wanted = {
        "peak acceleration": ("impact_peaks", "acceleration"),
        "speed at separation": ("first_impact", "separation_speed"),
        "time in contact": ("contacts", "duration"),
    }
    found = {}
    for name, (group, field) in wanted.items():
        row = row_of(record, group) + row_of(getattr(record, group), field) - rows(record)
        one, other = some[:, row].ravel(), others[:, row].ravel()
        touched = other > 0.0
        relative = np.abs(one[touched] / other[touched] - 1.0)
        median, most = np.quantile(relative, (0.5, 0.99))
        found[name] = {"median": median, "99 %": most, "largest": relative.max()}
    return found


def _bits(numbers: Buffer) -> Any:
    """Bits of numbers, with zeros of one sign: the flags of our arithmetic leave it open."""
    return (numbers + 0.0).view(np.uint64)


def _equal(shape: Any, some: Buffer, others: Buffer, width: int) -> bool:
    """Whether motion and record are the same to the bit in all flights and their copies."""
    a = _bits(some).reshape(-1, len(others), some.shape[1] // width, width)
    b = _bits(others).reshape(len(others), -1, width)
    model, motion, record = rows(shape.model), rows(shape.motion), rows(shape.record)
    parts = slice(model, model + motion), slice(-record, None)
    return all(bool((a[:, :, part] == b[None, :, part]).all()) for part in parts)


def guided(flights: int, rounds: int) -> dict[str, Any]:
    """Guided flights a second, on both."""
    tables = _tables(DIFFERENT)
    ready = [scenario_from(table, False).build() for table in tables]
    first, seeds = ready[0], [one.seed for one in ready]
    assert first.built_avionics is not None
    avionics, draws = first.built_avionics.avionics, first.built_avionics.noise
    alone = FlightNoise(draws, seeds, [0] * DIFFERENT)
    loader = Loader(first.model, first.start, avionics, GUIDED_LANES)
    for one in ready:
        assert one.built_avionics is not None
        loader.add(one.model, one.start, one.built_avionics.avionics)
    laid = loader.flights()
    assert laid.avionics is not None
    assert laid.onboard is not None
    times = flights // DIFFERENT
    buffers, onboard = _copied(laid.buffers, times), _copied(laid.onboard, times)
    work, inside = buffers.copy(), onboard.copy()
    kind, lanes = GuidedFlight(laid.model, laid.start, laid.avionics), (0,) * GUIDED_LANES
    together = FlightNoise(draws, seeds * times, [0] * flights)

    def reset() -> None:
        work[:], inside[:] = buffers, onboard

    def fly() -> None:
        fly_groups_on_gpu(kind, FlightBuffers(work, inside, lanes), together)

    on_gpu = _timed(fly, reset, rounds)
    here, beside = laid.buffers.copy(), laid.onboard.copy()
    few = FlightBuffers(here[:8], beside[:8], lanes)
    fly_groups(kind, few, alone.part(slice(0, 64)))  # compiles
    here, beside = laid.buffers.copy(), laid.onboard.copy()
    begun = time.perf_counter()
    fly_groups(kind, FlightBuffers(here, beside, lanes), alone)
    on_cpu = time.perf_counter() - begun
    remembered = _bits(inside).reshape(times, *beside.shape)
    return {
        "guided flights": flights,
        "flights/s, gpu": flights / on_gpu.kernels,
        "flights/s, gpu, with copying": flights / on_gpu.whole,
        "flights/s, cpu": DIFFERENT / on_cpu,
        "equal": _equal(laid.shape, work, here, GUIDED_LANES)
        and bool((remembered == _bits(beside)).all()),
    }


def _plan(folder: Path, flights: int) -> Any:
    (folder / "collision.toml").write_text(SCENARIO)
    (folder / "plan.toml").write_text(PLAN.format(samples=flights // 2))
    return lay_out(*read_plan(folder / "plan.toml"))


def _tables(flights: int) -> list[Any]:
    with tempfile.TemporaryDirectory() as folder:
        return list(_plan(Path(folder), flights).slice(0, flights).tables)


def campaign(flights: int, workers: int) -> dict[str, Any]:
    """A whole campaign on the GPU, and every column of its first rows on the processor."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        begun = time.perf_counter()
        flown = run_campaign(_plan(folder, flights), folder / "gpu", workers=workers, device="gpu")
        took = time.perf_counter() - begun
        few = min(flights, 2000)
        (folder / "few").mkdir()
        other = run_campaign(_plan(folder / "few", few), folder / "cpu", workers=workers)
        sql = f"SELECT * FROM flights WHERE flight < {few} ORDER BY flight"
        some, others = (
            [[repr(value) for value in row] for row in one.query(sql).rows]
            for one in (flown, other)
        )
        return {
            "campaign": flights, "workers": workers, "seconds": took, "flights/s": flights / took,
            "rows equal": f"{sum(a == b for a, b in zip(some, others, strict=True))} of {few}",
        }  # fmt: skip


def main() -> None:
    """Print one line a job."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--impacts", type=int, default=131_072, help="flights; 0 for none")
    parser.add_argument("--guided", type=int, default=33_792, help="flights; 0 for none")
    parser.add_argument("--campaign", type=int, default=0, help="flights; 0 for none")
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--rounds", type=int, default=3)
    given = parser.parse_args()
    print(device().name, flush=True)
    if given.impacts:
        print(json.dumps(impacts(given.impacts, given.rounds)), flush=True)
    if given.guided:
        print(json.dumps(guided(given.guided, given.rounds)), flush=True)
    if given.campaign:
        print(json.dumps(campaign(given.campaign, given.workers)), flush=True)


if __name__ == "__main__":
    main()

"""Guided flights abreast: lanes of flights through the loop over the ticks, groups on threads."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from springback.kernels.layout import Buffer, Like, rows
from springback.kernels.trees import rebuilt
from springback.simulation.flight import loaded, shape_of, unloaded
from springback.simulation.guided import (
    TICKS,
    GuidedFlown,
    cabins_loaded,
    entries_for,
    ticks_of,
)
from springback.simulation.noise import yet_to_be_dealt
from springback.simulation.onboard import Cabin, Draw
from springback.simulation.record import Model
from springback.simulation.ticks import GUST_NOISE
from springback.vehicle.state import State

#: Guided flights abreast in one group: those that fill a vector register of 512 bits.
GUIDED_LANES = 8
#: Groups that fly together, so that flights in contact can change into one (chosen: what is aboard
#: of so many fills a cache of 1 MB).
TOGETHER = 8
#: Ticks for which normal numbers are dealt at once (chosen).
STRETCH = 25


def fly_groups(
    model: Model,
    start: State,
    cabin: Cabin,
    buffers: Buffer,
    aboard: Buffer,
    draws: Sequence[Draw],
    seeds: Sequence[int],
    *,
    flights: Sequence[int] | None = None,
    width: int = GUIDED_LANES,
    threads: int | None = None,
    progress: Callable[[float], None] | None = None,
) -> None:
    """Fly groups that lie ready in buffers to their end, in place.

    Args:
        model: Like those of the flights, of their duration.
        start: Like their states.
        cabin: Like what is aboard, with their clock.
        buffers: Of the motion, shape (groups, rows x width), see `springback.simulation.flight`.
        aboard: Of what is aboard, shape (groups, rows x width), leaf by leaf, lane by lane.
        draws: When which normal numbers are drawn.
        seeds: One for each flight.
        flights: Their numbers, for their luck; 0 by default.
        width: Lanes in a group.
        threads: Defaults to the number of processors.
        progress: Called now and then with the share done.
    """
    duration, numbers = model.timing.until, flights or [0] * len(seeds)
    ticks, shape = ticks_of(duration, cabin.guidance.period), shape_of(model, start)
    guide, lanes, nothing = entries_for(model, cabin).guide, (0,) * width, np.zeros((0, 1))
    channels = sum(draw.channels for draw in draws) - GUST_NOISE
    sensing, gusts = Like((0.0,) * channels), Like((0.0,) * GUST_NOISE)

    def fly(first: int) -> None:
        last = min(first + TOGETHER, len(buffers))
        mine = slice(first * width, last * width)
        luck = yet_to_be_dealt(seeds[mine], numbers[mine], draws, width, min(STRETCH, ticks))
        next_up = np.array([0, 0, -luck.noise.shape[1]], dtype=np.int64)
        logged = np.zeros(1, dtype=np.int64)
        while next_up[0] < ticks:
            guide(
                Like(shape), Like(cabin), buffers[first:last], aboard[first:last], lanes, sensing,
                gusts, luck, next_up, min(ticks, int(next_up[0]) + TICKS), ticks, duration, False,
                nothing, logged, nothing,
            )  # fmt: skip

    batches = range(0, len(buffers), TOGETHER)
    with ThreadPoolExecutor(threads or os.cpu_count() or 1) as pool:
        for done, _ in enumerate(pool.map(fly, batches), start=1):
            if progress is not None:
                progress(done / len(batches))


def fly_guided_many(
    models: Sequence[Model],
    starts: Sequence[State],
    cabins: Sequence[Cabin],
    draws: Sequence[Draw],
    seeds: Sequence[int],
    *,
    flights: Sequence[int] | None = None,
    width: int = GUIDED_LANES,
    threads: int | None = None,
    progress: Callable[[float], None] | None = None,
) -> list[GuidedFlown]:
    """Fly many guided flights of equal shape and duration, abreast in lanes, on several threads.

    Each is, bit for bit, the flight that `springback.simulation.guided.fly_guided` flies alone, in
    whatever order and company.  No trajectories and no diaries are kept.

    Args:
        models: One for each flight, or a single one for all.
        starts: One state for each flight.
        cabins: What is aboard each.
        draws: When which normal numbers are drawn.
        seeds: One for each flight.
        flights: Their numbers, for their luck; 0 by default.
        width: Lanes in a group.
        threads: Defaults to the number of processors.
        progress: Called now and then with the share done.

    Raises:
        ValueError: If the flights end, or their clocks tick, at different times.
    """
    every = [models[min(k, len(models) - 1)] for k in range(len(starts))]
    paces = {(m.timing.until, c.guidance.period) for m, c in zip(every, cabins, strict=True)}
    if len(paces) != 1:
        raise ValueError("flights abreast must have one duration and one clock")
    shape, cabin = shape_of(every[0], starts[0]), cabins[0]
    buffers, aboard = loaded(shape, every, starts, width), cabins_loaded([*cabins], width)
    fly_groups(
        every[0], starts[0], cabin, buffers, aboard, draws, seeds,
        flights=flights, width=width, threads=threads, progress=progress,
    )  # fmt: skip
    flown, after = unloaded(shape, every, starts, buffers, width), rows(cabin.guidance)
    memories = aboard.reshape(len(buffers), -1, width)
    return [
        GuidedFlown(one, rebuilt(cabin.aboard, memories[k // width, after:, k % width]), None)
        for k, one in enumerate(flown)
    ]

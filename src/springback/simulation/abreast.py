"""Guided flights abreast: lanes of flights through the loop over the ticks, groups on threads."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from springback.kernels.layout import Buffer, Like, rows
from springback.kernels.trees import rebuilt
from springback.simulation.aboard import Cabin, Draw
from springback.simulation.flight import loaded, shape_of, unloaded
from springback.simulation.guided import (
    GUST_NOISE,
    TICKS,
    GuidedFlown,
    cabins_loaded,
    entries_for,
    noise_table,
    ticks_of,
)
from springback.simulation.record import Model
from springback.vehicle.state import State

#: Guided flights abreast in one group (chosen: what is aboard fills the cache sooner than what
#: flies, so fewer than without a pilot).
GUIDED_LANES = 4


def noise_abreast(noises: Sequence[Buffer], group: int, width: int) -> Buffer:
    """Noise of one group, shape (ticks, channels x lanes): channel by channel, lane by lane.

    Args:
        noises: Of every flight, each of shape (ticks, channels).
        group: Its number; spare lanes repeat the last flight.
        width: Lanes in a group.
    """
    last = len(noises) - 1
    lanes = [noises[min(k, last)] for k in range(group * width, (group + 1) * width)]
    ticks, channels = lanes[0].shape
    return np.ascontiguousarray(np.stack(lanes, axis=2)).reshape(ticks, channels * width)


def fly_groups(
    model: Model,
    start: State,
    cabin: Cabin,
    buffers: Buffer,
    aboard: Buffer,
    draws: tuple[Draw, ...],
    seeds: Sequence[int],
    *,
    width: int = GUIDED_LANES,
    threads: int | None = None,
    progress: Callable[[float], None] | None = None,
) -> None:
    """Fly groups that lie ready in buffers to their end, in place."""
    duration = model.timing.until
    ticks = ticks_of(duration, cabin.guidance.period)
    shape = shape_of(model, start)
    guide, lanes = entries_for(model, cabin).guide, (0,) * width
    nothing = np.zeros((0, 1))

    def fly_group(group: int) -> None:
        mine = [seeds[min(k, len(seeds) - 1)] for k in range(group * width, (group + 1) * width)]
        noise = noise_abreast([noise_table(seed, 0, ticks, draws) for seed in mine], 0, width)
        sensing = Like((0.0,) * (noise.shape[1] // width - GUST_NOISE))
        gusts, next_up = Like((0.0,) * GUST_NOISE), np.zeros(2, dtype=np.int64)
        logged = np.zeros(1, dtype=np.int64)
        while next_up[0] < ticks:
            guide(
                Like(shape), Like(cabin), buffers[group : group + 1], aboard[group], lanes, sensing,
                gusts, noise, next_up, min(ticks, int(next_up[0]) + TICKS), duration, False,
                nothing, logged, nothing,
            )  # fmt: skip

    with ThreadPoolExecutor(threads or os.cpu_count() or 1) as pool:
        for done, _ in enumerate(pool.map(fly_group, range(len(buffers))), start=1):
            if progress is not None:
                progress(done / len(buffers))


def fly_guided_many(
    models: Sequence[Model],
    starts: Sequence[State],
    cabins: Sequence[Cabin],
    noises: Sequence[Buffer],
    *,
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
        noises: Normal numbers of each, shape (ticks, channels).  They are taken a group at a time,
            so a sequence may draw them when asked.
        width: Lanes in a group.
        threads: Defaults to the number of processors.
        progress: Called now and then with the share of groups done.

    Raises:
        ValueError: If the flights end, or their clocks tick, at different times.
    """
    every = [models[min(k, len(models) - 1)] for k in range(len(starts))]
    paces = {(m.timing.until, c.guidance.period) for m, c in zip(every, cabins, strict=True)}
    if len(paces) != 1:
        raise ValueError("flights abreast must have one duration and one clock")
    duration = every[0].timing.until
    shape, cabin = shape_of(every[0], starts[0]), cabins[0]
    buffers, aboard = loaded(shape, every, starts, width), cabins_loaded([*cabins], width)
    guide, lanes = entries_for(every[0], cabin).guide, (0,) * width
    nothing = np.zeros((0, 1))

    def fly_group(group: int) -> None:
        noise = noise_abreast(noises, group, width)
        sensing = Like((0.0,) * (noise.shape[1] // width - GUST_NOISE))
        gusts, next_up = Like((0.0,) * GUST_NOISE), np.zeros(2, dtype=np.int64)
        logged, ticks = np.zeros(1, dtype=np.int64), len(noise)
        while next_up[0] < ticks:
            guide(
                Like(shape), Like(cabin), buffers[group : group + 1], aboard[group], lanes, sensing,
                gusts, noise, next_up, min(ticks, int(next_up[0]) + TICKS), duration, False,
                nothing, logged, nothing,
            )  # fmt: skip

    with ThreadPoolExecutor(threads or os.cpu_count() or 1) as pool:
        for done, _ in enumerate(pool.map(fly_group, range(len(buffers))), start=1):
            if progress is not None:
                progress(done / len(buffers))
    flown, after = unloaded(shape, every, starts, buffers, width), rows(cabin.guidance)
    memories = aboard.reshape(len(buffers), -1, width)
    return [
        GuidedFlown(one, rebuilt(cabin.aboard, memories[k // width, after:, k % width]), None)
        for k, one in enumerate(flown)
    ]

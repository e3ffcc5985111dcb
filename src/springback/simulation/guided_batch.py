"""Guided flights abreast: lanes of flights through the loop over the ticks, groups on threads."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from springback.kernels.layout import Buffer, TreeLayout
from springback.simulation.flight import shape_of
from springback.simulation.guided import (
    TICKS,
    entries_for,
    ticks_of,
)
from springback.simulation.noise import on_the_fly
from springback.simulation.onboard import Avionics, Draw
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
    avionics: Avionics,
    buffers: Buffer,
    onboard: Buffer,
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
        avionics: Like what is aboard, with their clock.
        buffers: Of the motion, shape (groups, rows x width), see `springback.simulation.flight`.
        onboard: Of what is aboard, shape (groups, rows x width), leaf by leaf, lane by lane.
        draws: When which normal numbers are drawn.
        seeds: One for each flight.
        flights: Their numbers, for their luck; 0 by default.
        width: Lanes in a group.
        threads: Defaults to the number of processors.
        progress: Called now and then with the share done.
    """
    duration, numbers = model.timing.until, flights or [0] * len(seeds)
    ticks, shape = ticks_of(duration, avionics.systems.period), shape_of(model, start)
    guide, lanes, nothing = entries_for(model, avionics).guide, (0,) * width, np.zeros((0, 1))
    channels = sum(draw.channels for draw in draws) - GUST_NOISE
    sensing, gusts = TreeLayout((0.0,) * channels), TreeLayout((0.0,) * GUST_NOISE)

    def fly(first: int) -> None:
        last = min(first + TOGETHER, len(buffers))
        mine = slice(first * width, last * width)
        noise_stream = on_the_fly(seeds[mine], numbers[mine], draws, width, min(STRETCH, ticks))
        next_up = np.array([0, 0, -noise_stream.noise.shape[1]], dtype=np.int64)
        logged = np.zeros(1, dtype=np.int64)
        while next_up[0] < ticks:
            guide(
                TreeLayout(shape), TreeLayout(avionics), buffers[first:last], onboard[first:last],
                lanes, sensing,
                gusts, noise_stream, next_up, min(ticks, int(next_up[0]) + TICKS), ticks,
                duration, False,
                nothing, logged, nothing,
            )  # fmt: skip

    batches = range(0, len(buffers), TOGETHER)
    with ThreadPoolExecutor(threads or os.cpu_count() or 1) as pool:
        for done, _ in enumerate(pool.map(fly, batches), start=1):
            if progress is not None:
                progress(done / len(batches))

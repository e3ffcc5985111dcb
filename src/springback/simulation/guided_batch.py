"""Many guided flights at once: groups of lanes through the loop over the ticks, on threads."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from springback.simulation.flight import empty_log, shape_of
from springback.simulation.guided import (
    TICKS,
    GuidedFlight,
    TickRange,
    compile_guide,
    guide_for,
    ticks_of,
)
from springback.simulation.noise import FlightNoise, drawn_stream
from springback.simulation.ticks import GUST_NOISE, FlightBuffers, FlightLog, layouts_of

#: Lanes of a group of guided flights: those that fill a vector register of 512 bits.
GUIDED_LANES = 8
#: Groups that fly together, so that flights in contact can be gathered in one of them (chosen: the
#: avionics of so many fit a cache of 1 MB).
TOGETHER = 8
#: Ticks for which normal numbers are drawn at once (chosen).
STRETCH = 25


def fly_groups(
    flight: GuidedFlight,
    buffers: FlightBuffers,
    noise: FlightNoise,
    *,
    threads: int | None = None,
    progress: Callable[[float], None] | None = None,
) -> None:
    """Fly groups of guided flights to their end, in their buffers.

    Args:
        flight: Of the same structure, duration and clock as all flights.
        buffers: Of all flights.
        noise: Of all flights.
        threads: Defaults to the number of processors.
        progress: Called from time to time with the share of flights done.
    """
    model, start, avionics = flight
    duration, width = model.timing.until, len(buffers.lanes)
    ticks, guide = ticks_of(duration, avionics.systems.period), guide_for(model, avionics)
    channels = sum(draw.channels for draw in noise.draws) - GUST_NOISE
    layouts = layouts_of(shape_of(model, start), avionics, channels)

    def fly(first: int) -> None:
        groups = slice(first, first + TOGETHER)
        part = noise.part(slice(first * width, (first + TOGETHER) * width))
        numbers = drawn_stream(part, width, min(STRETCH, ticks))
        mine = FlightBuffers(buffers.motion[groups], buffers.onboard[groups], buffers.lanes)
        at = np.array([0, 0, -numbers.noise.shape[1]], dtype=np.int64)
        log = FlightLog(empty_log(), np.zeros((0, 1)))
        while at[0] < ticks:
            end = min(ticks, int(at[0]) + TICKS)
            stretch = TickRange(at, end, ticks - 1, duration, False)
            if at[0] == 0:
                compile_guide(guide, (layouts, mine, numbers, stretch, log))
            guide(layouts, mine, numbers, stretch, log)

    batches = range(0, len(buffers.motion), TOGETHER)
    with ThreadPoolExecutor(threads or os.cpu_count() or 1) as pool:
        for done, _ in enumerate(pool.map(fly, batches), start=1):
            if progress is not None:
                progress(done / len(batches))

"""Streams of random numbers that are drawn once: for a flight, a trial, a plan or a world.

Noise, which is drawn at every tick, is a function of its own (`springback.simulation.noise`).
"""

from __future__ import annotations

from enum import IntEnum
from typing import Any

import numpy as np


class Purpose(IntEnum):
    """Purpose of random numbers that are drawn once; part of the key of each stream."""

    POINTS = 0
    """Points of a random design."""
    JITTER = 1
    """Positions of the points of a Latin hypercube within their layers."""
    SCRAMBLE = 2
    """Scrambling of a Sobol' sequence."""
    SEEDS = 3
    """Seeds of a campaign's flights."""
    SCATTER = 4
    """Scatter of a campaign's flights."""
    DRAWN = 5
    """Values of fields for which a grid has no levels."""
    SHUFFLE = 6
    """Order of the layers of a Latin hypercube."""
    TURN_ON = 7
    """Biases of a flight's sensors."""
    GUST = 8
    """Wind before a flight's first tick."""
    TRIAL = 9
    """Scatter and seed of a trial."""
    FOREST = 10
    """Places and radii of trunks."""
    SECOND = 11
    """Seed of the second vehicle of a scenario."""
    NULL = 12
    """Numbers of which nothing is true but chance: what a test's statistic is then."""


def stream(seed: int, purpose: Purpose, *which: int) -> np.random.Generator:
    """Random numbers for one purpose, independent of all others.

    Generator and key of each purpose are those with which published results were flown.

    Args:
        seed: Of a flight, of trials or of a plan.
        purpose: Their purpose.
        *which: Number of a flight, a repeat or a dimension, if the purpose has several streams.
    """
    kind: Any = np.random.Philox
    key: tuple[int, ...] = (purpose, *which)
    if purpose is Purpose.TURN_ON:
        kind, key = np.random.SFC64, (*which, 2)
    elif purpose is Purpose.GUST:
        kind, key = np.random.SFC64, (0, 1)
    elif purpose is Purpose.TRIAL:
        kind, key = np.random.PCG64, which
    elif purpose in (Purpose.SCRAMBLE, Purpose.SHUFFLE):
        kind = np.random.PCG64
    return np.random.Generator(kind(np.random.SeedSequence(seed, spawn_key=key)))

"""Points of a design, row by row: any stretch of rows alone, as if all had been made.

Every number is uniform in [0, 1) and follows from the plan's seed and the row alone.  Random rows
come from counters (Philox; Salmon et al. 2011), so that row 900 000 costs no more than row 0.
"""

from __future__ import annotations

import functools
import warnings
from typing import Any

import numpy as np
import numpy.typing as npt
import scipy  # its parts are loaded when first used

Numbers = npt.NDArray[np.float64]

#: What a stream of random numbers is for; part of the key of each.
RANDOM, JITTER, SCRAMBLE, SEEDS, SCATTER, DRAWN, SHUFFLE = range(7)
#: Sobol' numbers have so many bits, and so a sequence at most this many points.
SOBOL_BITS = 30


def raw_rows(
    seed: int, stream: tuple[int, ...], first: int, count: int, width: int
) -> npt.NDArray[np.uint64]:
    """Rows of random 64-bit words, shape (count, width).

    Args:
        seed: Of the plan.
        stream: What they are for.
        first: Row.
        count: Number of rows.
        width: Words of a row.
    """
    key = np.random.SeedSequence(seed, spawn_key=stream).generate_state(2, np.uint64)
    blocks = -(-width // 4)  # a counter gives four words
    words = np.random.Philox(key=key, counter=first * blocks).random_raw(count * blocks * 4)
    return np.asarray(words, np.uint64).reshape(count, blocks * 4)[:, :width]


def uniform_rows(seed: int, stream: tuple[int, ...], first: int, count: int, width: int) -> Numbers:
    """The same as numbers in [0, 1)."""
    words = raw_rows(seed, stream, first, count, width) >> np.uint64(11)
    return words.astype(np.float64) * 2.0**-53


def seeds(seed: int, repeat: int, first: int, count: int) -> npt.NDArray[np.int64]:
    """Seeds of flights, below 2^53, so that JSON keeps them: of one repeat of some samples."""
    words = raw_rows(seed, (SEEDS, repeat), first, count, 1)[:, 0]
    return (words >> np.uint64(11)).astype(np.int64)


def random_points(seed: int, samples: int, width: int, first: int, count: int) -> Numbers:
    """Independent points; ``samples`` does not matter."""
    return uniform_rows(seed, (RANDOM,), first, count, width)


def latin_points(seed: int, samples: int, width: int, first: int, count: int) -> Numbers:
    """Points of a Latin hypercube (McKay, Beckman, Conover 1979).

    Each of as many equal layers as there are samples holds one point, in every dimension.  The
    permutations are kept: 4 bytes for each sample and dimension, 80 MB for 10⁶ samples of 20.
    """
    jitter = uniform_rows(seed, (JITTER,), first, count, width)
    layers = [_permutation(seed, samples, k)[first : first + count] for k in range(width)]
    return (np.stack(layers, axis=1) + jitter) / samples if width else jitter


@functools.lru_cache(maxsize=256)
def _permutation(seed: int, samples: int, dimension: int) -> npt.NDArray[np.uint32]:
    source = np.random.SeedSequence(seed, spawn_key=(SHUFFLE, dimension))
    order = np.arange(samples, dtype=np.uint32)
    np.random.Generator(np.random.PCG64(source)).shuffle(order)
    return order


def sobol_points(seed: int, samples: int, width: int, first: int, count: int) -> Numbers:
    """Points of a scrambled Sobol' sequence (Owen 1998); ``samples`` does not matter."""
    if not width:
        return np.zeros((count, 0))
    source = np.random.SeedSequence(seed, spawn_key=(SCRAMBLE,))
    generator = np.random.Generator(np.random.PCG64(source))
    qmc: Any = scipy.stats.qmc
    sequence = qmc.Sobol(width, scramble=True, bits=SOBOL_BITS, rng=generator)
    if first:
        sequence.fast_forward(first)
    with warnings.catch_warnings():  # that a stretch is no power of two
        warnings.simplefilter("ignore", UserWarning)
        return np.asarray(sequence.random(count), np.float64)


POINTS = {"random": random_points, "latin-hypercube": latin_points, "sobol": sobol_points}


def grid_point(sample: int, sizes: tuple[int, ...]) -> tuple[int, ...]:
    """Levels of a point of a grid; the last dimension changes fastest."""
    levels = []
    for size in reversed(sizes):
        sample, level = divmod(sample, size)
        levels.append(level)
    return tuple(reversed(levels))


def normal_quantiles(us: Numbers) -> list[float]:
    """Of the standard normal law; the outermost numbers of [0, 1) stand for their neighbours."""
    inside = np.clip(us, 2.0**-54, 1.0 - 2.0**-53)
    found: list[float] = scipy.special.ndtri(inside).tolist()
    return found

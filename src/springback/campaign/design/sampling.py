"""Points of a design; any range of rows can be computed alone.

All numbers are uniform in [0, 1) and depend on the plan's seed and the row alone.  Random rows are
counter-based (Philox; Salmon et al. 2011), so that row 900 000 costs no more than row 0.
"""

from __future__ import annotations

import functools
import warnings
from typing import Any

import numpy as np
import numpy.typing as npt
import scipy  # submodules are loaded on first use

from springback.random_streams import Purpose, stream

Numbers = npt.NDArray[np.float64]

#: Bits of Sobol' numbers, which limit the length of a sequence.
SOBOL_BITS = 30


def raw_rows(
    seed: int, key: tuple[Purpose, *tuple[int, ...]], first: int, count: int, width: int
) -> npt.NDArray[np.uint64]:
    """Rows of random 64-bit words, shape (count, width).

    Args:
        seed: Seed of the plan.
        key: Purpose and numbers of the stream.
        first: First row.
        count: Number of rows.
        width: Words per row.
    """
    blocks = -(-width // 4)  # a counter gives four words
    source: Any = stream(seed, *key).bit_generator
    words = source.advance(first * blocks).random_raw(count * blocks * 4)
    return np.asarray(words, np.uint64).reshape(count, blocks * 4)[:, :width]


def uniform_rows(
    seed: int, key: tuple[Purpose, *tuple[int, ...]], first: int, count: int, width: int
) -> Numbers:
    """Rows of random numbers in [0, 1), shape (count, width); arguments as for `raw_rows`."""
    words = raw_rows(seed, key, first, count, width) >> np.uint64(11)
    return words.astype(np.float64) * 2.0**-53


def seeds(seed: int, repeat: int, first: int, count: int) -> npt.NDArray[np.int64]:
    """Seeds of the flights of one repeat, below 2^53, which JSON represents exactly."""
    words = raw_rows(seed, (Purpose.SEEDS, repeat), first, count, 1)[:, 0]
    return (words >> np.uint64(11)).astype(np.int64)


def random_points(seed: int, samples: int, width: int, first: int, count: int) -> Numbers:
    """Independent points; ``samples`` does not matter."""
    return uniform_rows(seed, (Purpose.POINTS,), first, count, width)


def latin_points(seed: int, samples: int, width: int, first: int, count: int) -> Numbers:
    """Points of a Latin hypercube (McKay, Beckman, Conover 1979).

    In every dimension each of ``samples`` equal layers contains one point.  The permutations are
    held in memory: 4 bytes per sample and dimension, 80 MB for 10⁶ samples of 20.
    """
    jitter = uniform_rows(seed, (Purpose.JITTER,), first, count, width)
    layers = [_permutation(seed, samples, k)[first : first + count] for k in range(width)]
    return (np.stack(layers, axis=1) + jitter) / samples if width else jitter


@functools.lru_cache(maxsize=256)
def _permutation(seed: int, samples: int, dimension: int) -> npt.NDArray[np.uint32]:
    order = np.arange(samples, dtype=np.uint32)
    stream(seed, Purpose.SHUFFLE, dimension).shuffle(order)
    return order


def sobol_points(seed: int, samples: int, width: int, first: int, count: int) -> Numbers:
    """Points of a scrambled Sobol' sequence (Owen 1998); ``samples`` does not matter."""
    if not width:
        return np.zeros((count, 0))
    qmc: Any = scipy.stats.qmc
    source = stream(seed, Purpose.SCRAMBLE)
    sequence = qmc.Sobol(width, scramble=True, bits=SOBOL_BITS, rng=source)
    if first:
        sequence.fast_forward(first)
    with warnings.catch_warnings():  # that the number of points is not a power of two
        warnings.simplefilter("ignore", UserWarning)
        return np.asarray(sequence.random(count), np.float64)


POINTS = {"random": random_points, "latin-hypercube": latin_points, "sobol": sobol_points}


def grid_point(sample: int, sizes: tuple[int, ...]) -> tuple[int, ...]:
    """Levels of a grid point; the last dimension changes fastest."""
    levels = []
    for size in reversed(sizes):
        sample, level = divmod(sample, size)
        levels.append(level)
    return tuple(reversed(levels))


def normal_quantiles(us: Numbers) -> list[float]:
    """Quantiles of the standard normal distribution; 0 is moved to 2⁻⁵⁴."""
    inside = np.clip(us, 2.0**-54, 1.0 - 2.0**-53)
    found: list[float] = scipy.special.ndtri(inside).tolist()
    return found

"""95 % confidence intervals of shares, quantiles and differences.

They assume independent flights.  Sobol' and Latin hypercube designs have a smaller variance, so
their intervals are too wide rather than too narrow; repeats of one sample are correlated, so with
few samples and many repeats intervals are valid for those samples only.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
import scipy  # submodules are loaded on first use

from springback.errors import InputError

Values = npt.NDArray[np.float64]

CONFIDENCE = 0.95
"""Confidence level of all intervals."""


class IntervalEstimate(NamedTuple):
    """A number and its interval; None if there are too few flights."""

    value: float | None
    low: float | None
    high: float | None


def wilson(successes: int, trials: int) -> tuple[float, float]:
    """Wilson's interval of a share, at `CONFIDENCE` (Wilson 1927)."""
    test = scipy.stats.binomtest(successes, trials)
    interval = test.proportion_ci(confidence_level=CONFIDENCE, method="wilson")
    return float(interval.low), float(interval.high)


def share(successes: int, flights: int) -> IntervalEstimate:
    """Share of successes, with its Wilson interval.

    Raises:
        InputError: If it is not from 0 to 1, as in a folder that was tampered with.
    """
    if not flights:
        return IntervalEstimate(None, None, None)
    if not 0 <= successes <= flights:
        raise InputError(f"success: must be 0 or 1 (got {successes} in {flights} flights)")
    return IntervalEstimate(successes / flights, *wilson(successes, flights))


def ranks(count: int, part: float) -> tuple[int, int]:
    """Ranks, from 1, of the ordered values that enclose a quantile.

    They hold for any continuous distribution, with at least the confidence (Conover 1999, section
    3.2).  Ranks 0 and ``count + 1`` mean that there is no bound.

    Args:
        count: Number of values.
        part: Share of the distribution below the quantile.
    """
    tail = 0.5 * (1.0 - CONFIDENCE)
    law = scipy.stats.binom(count, part)
    return int(law.ppf(tail)), int(law.ppf(1.0 - tail)) + 1


def quantile(ordered: Values, part: float) -> IntervalEstimate:
    """A quantile of a distribution, from ordered samples."""
    if not len(ordered):
        return IntervalEstimate(None, None, None)
    low, high = ranks(len(ordered), part)
    return IntervalEstimate(
        float(np.quantile(ordered, part)),
        float(ordered[low - 1]) if low >= 1 else None,
        float(ordered[high - 1]) if high <= len(ordered) else None,
    )


def paired_difference(first_only: int, second_only: int, pairs: int) -> IntervalEstimate:
    """Difference of two shares over the same pairs, the first minus the second.

    Agresti and Min (2005): Wald's interval after half a pair is added to each of four cells.

    Args:
        first_only: Number of pairs in which only the first succeeds.
        second_only: Number of pairs in which only the second succeeds.
        pairs: Number of all pairs.
    """
    if not pairs:
        return IntervalEstimate(None, None, None)
    total = pairs + 2.0
    b, c = (first_only + 0.5) / total, (second_only + 0.5) / total
    z = float(scipy.stats.norm.ppf(0.5 * (1.0 + CONFIDENCE)))
    reach = z * math.sqrt((b + c - (b - c) ** 2) / total)
    difference = (first_only - second_only) / pairs
    return IntervalEstimate(difference, max(-1.0, b - c - reach), min(1.0, b - c + reach))

"""Shares of trials, and their confidence intervals."""

from __future__ import annotations

import scipy  # its parts are loaded when first used

CONFIDENCE = 0.95
"""Confidence level of the intervals of success rates."""


def wilson(successes: int, trials: int) -> tuple[float, float]:
    """Wilson's interval of a share, at `CONFIDENCE` (Wilson 1927)."""
    test = scipy.stats.binomtest(successes, trials)
    interval = test.proportion_ci(confidence_level=CONFIDENCE, method="wilson")
    return float(interval.low), float(interval.high)

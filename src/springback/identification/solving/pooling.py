"""Several impacts: what they say together, with scatter from impact to impact.

Each impact is fitted alone; the values are then drawn from a normal distribution about a common
one, whose variance is estimated (random effects, by restricted maximum likelihood), with the
interval of Knapp and Hartung (Statistics in Medicine 22, 2003).  Pooling as if nothing differed is
kept beside it.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

Array = np.ndarray[Any, np.dtype[np.float64]]
#: Quantile of a 95 % interval.
_HIGH = 0.975
#: Probability below which impacts are said to differ (chosen).
DIFFERENT = 0.05


class PooledValue(NamedTuple):
    """A value that several impacts tell, in the coordinate in which it was fitted."""

    value: float
    low: float
    high: float
    scatter: float
    """Standard deviation from impact to impact, τ."""
    scatter_high: float
    """Upper end of its 95 % interval, by the profile of the likelihood."""
    heterogeneity: float
    """Probability of Cochran's Q if nothing differed."""
    common: float
    """Value as if nothing differed ..."""
    common_deviation: float
    """... and its standard deviation."""
    without: tuple[float, ...]
    """Value without each impact in turn."""


def pool(values: Array, deviations: Array, *, scatter: bool = True) -> PooledValue:
    """Value that several impacts tell.

    Args:
        values: Of each, at least two, shape (impacts,).
        deviations: Standard deviation of each.
        scatter: False: nothing differs from impact to impact.
    """
    count = len(values)
    variances = deviations**2
    fixed = 1.0 / variances
    common = float((fixed * values).sum() / fixed.sum())
    common_deviation = float(fixed.sum() ** -0.5)
    q = float((fixed * (values - common) ** 2).sum())
    heterogeneity = float(scipy.stats.chi2.sf(q, count - 1))
    tau, high = _scatter(values, variances)
    if not scatter:
        half = float(scipy.stats.norm.ppf(_HIGH)) * common_deviation
        without = tuple(_mean(np.delete(values, k), np.delete(fixed, k)) for k in range(count))
        return PooledValue(
            common, common - half, common + half, tau, high, heterogeneity, common,
            common_deviation, without,
        )  # fmt: skip
    weights = 1.0 / (variances + tau**2)
    value = _mean(values, weights)
    spread = float((weights * (values - value) ** 2).sum()) / (count - 1)
    error = float(np.sqrt(max(spread, 1.0 if tau == 0.0 else 0.0) / weights.sum()))
    half = float(scipy.stats.t.ppf(_HIGH, count - 1)) * error
    left_out = list[float]()
    for k in range(count):
        rest, theirs = np.delete(values, k), np.delete(variances, k)
        left = _scatter(rest, theirs)[0] if len(rest) > 1 else tau
        left_out.append(_mean(rest, 1.0 / (theirs + left**2)))
    return PooledValue(
        value, value - half, value + half, tau, high, heterogeneity, common, common_deviation,
        tuple(left_out),
    )  # fmt: skip


def _mean(values: Array, weights: Array) -> float:
    return float((weights * values).sum() / weights.sum())


def _scatter(values: Array, variances: Array) -> tuple[float, float]:
    """Restricted maximum likelihood of the scatter, and the upper end of its interval."""

    def negative(tau: float) -> float:
        weights = 1.0 / (variances + tau * tau)
        mean = _mean(values, weights)
        return float(
            0.5 * np.log(variances + tau * tau).sum() + 0.5 * np.log(weights.sum())
            + 0.5 * (weights * (values - mean) ** 2).sum()
        )  # fmt: skip

    wide = 10.0 * float(np.ptp(values) + np.sqrt(variances.max()))
    found = scipy.optimize.minimize_scalar(negative, bounds=(0.0, wide), method="bounded")
    tau, least = float(found.x), float(found.fun)
    if negative(0.0) <= least + 1e-9:
        tau, least = 0.0, negative(0.0)
    rise = 0.5 * float(scipy.stats.chi2.ppf(0.95, 1))

    def above(x: float) -> float:
        return negative(x) - least - rise

    top = wide
    while above(top) < 0.0 and top < 1e6 * wide:
        top *= 4.0
    high = float(scipy.optimize.brentq(above, tau, top)) if above(top) > 0.0 else float("inf")
    return tau, high

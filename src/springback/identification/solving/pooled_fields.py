"""Fields of several impacts pooled: each for itself, and all together with their correlations.

What is known to some uncertainty, or belongs to a device, is one number of all impacts.  Free
fields may differ from impact to impact.  An impact tells of both at once, θᵢ ~ N(ûᵢ, Cᵢ) with the
prior in it; without the prior, and with scatter T of the free fields, it tells of what is common by
the precision (1 + Λᵢ T)⁻¹ Λᵢ, Λᵢ = Cᵢ⁻¹ − 1 (van Houwelingen, Arends and Stijnen, Statistics in
Medicine 21, 2002).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.identification.solving.fitting import ImpactFit
from springback.identification.solving.pooling import PooledValue, pool

Array = np.ndarray[Any, np.dtype[np.float64]]
_HALF = float(scipy.stats.norm.ppf(0.975))
#: Least precision of what impacts tell of a field, against that of its prior.
_LEAST = 1e-6


class SharedNumbers(NamedTuple):
    """Numbers that all impacts share, and what all of them tell of these."""

    names: list[str]
    mean: Array  # u, shape (numbers,)
    covariance: Array


class PooledResult(NamedTuple):
    """What impacts tell of a sum of their fields."""

    value: PooledValue
    """With the uncertainty of what all share in its interval."""
    widening: float
    """Of the interval of Knapp and Hartung, against the normal one of the same weights."""


class PooledPosterior(NamedTuple):
    """What several impacts tell of their fields together, in u."""

    names: list[str]
    """Of free fields, then of the numbers that all impacts share."""
    mean: Array
    covariance: Array
    """Of the common values, shape (names, names)."""
    scatter: Array
    """Covariance from impact to impact; zero for what is shared."""


def shared_numbers(fits: Sequence[ImpactFit], *, scatter: bool) -> SharedNumbers:
    """Known fields and numbers of devices, by the priors once and all impacts' data.

    Args:
        fits: Of all impacts.
        scatter: False: the free fields are the same in all, too, and what they agree on tells of
            what is shared.
    """
    names = [one.name for one in fits[0].problem.unknowns if one.is_shared]
    kept = names if scatter else [*_free(fits[0]), *names]
    precision, weighted = np.eye(len(kept)), np.zeros(len(kept))
    for fit in fits:
        told = _told(fit, kept)
        precision += told.precision
        weighted += told.weighted_point
    covariance = np.asarray(np.linalg.inv(precision), dtype=float)
    mean, first = covariance @ weighted, len(kept) - len(names)
    return SharedNumbers(names, mean[first:], covariance[first:, first:])


def pooled_sum(
    weights: Array,
    fits: Sequence[ImpactFit],
    shared: SharedNumbers,
    *,
    scatter: bool,
    profiled: Array,
) -> PooledResult:
    """What impacts tell of a sum of their fields' numbers u.

    Args:
        weights: Of the fields in the sum.
        fits: Of all impacts.
        shared: What they share.
        scatter: True: it may differ from impact to impact.
        profiled: Variance of each by its profile, over that by Laplace.
    """
    points, variances, slopes = [], [], []
    for fit, factor in zip(fits, profiled, strict=True):
        which = [fit.problem.place[name] for name in shared.names]
        row = weights @ fit.covariance[: len(weights)]
        variance = float(row[: len(weights)] @ weights)
        # How the value follows the shared numbers, and what is left were they known.
        slope = np.linalg.solve(fit.covariance[np.ix_(which, which)], row[which])
        moved = float(slope @ (shared.mean - fit.point[which]))
        points.append(float(weights @ fit.point[: len(weights)]) + moved)
        variances.append(factor * max(variance - float(slope @ row[which]), 1e-6 * variance))
        slopes.append(slope)
    each, before = np.array(variances), float(weights @ weights)
    # The prior is in every fit: it is taken out of all but one before they are pooled.
    told = np.maximum(1.0 / each - 1.0 / before, _LEAST / before)
    together = pool(np.array(points) / each / told, told**-0.5, scatter=scatter)
    shares = 1.0 / (1.0 / told + (together.scatter**2 if scatter else 0.0))
    common = (shares / each / told / shares.sum()) @ np.array(slopes)
    wide = _HALF * float(np.sqrt(common @ shared.covariance @ common))
    widening = (together.high - together.value) / _HALF * float(shares.sum()) ** 0.5
    value = together._replace(
        low=together.value - float(np.hypot(together.value - together.low, wide)),
        high=together.value + float(np.hypot(together.high - together.value, wide)),
    )
    return PooledResult(value, widening)


def pooled_field(
    name: str, fits: Sequence[ImpactFit], shared: SharedNumbers, *, scatter: bool
) -> PooledResult:
    """What impacts tell of one free field.

    Args:
        name: Of the field.
        fits: Of all impacts.
        shared: What they share.
        scatter: True: it may differ from impact to impact.
    """
    weights = np.array([float(one.name == name) for one in fits[0].problem.fields])
    profiled = np.array([_profiled(name, fit) for fit in fits])
    return pooled_sum(weights, fits, shared, scatter=scatter, profiled=profiled)


def pooled_posterior(fits: Sequence[ImpactFit], *, scatter: bool) -> PooledPosterior:
    """What impacts tell of all fields together, with their correlations.

    Standard deviations of the scatter are those of each field (`pooled_field`), and so is the
    widening of its uncertainty by Knapp and Hartung; priors count once.

    Args:
        fits: Of all impacts, at least two.
        scatter: True: free fields may differ from impact to impact.
    """
    shared = shared_numbers(fits, scatter=scatter)
    free = _free(fits[0])
    names, count = [*free, *shared.names], len(free)
    pooled = [pooled_field(name, fits, shared, scatter=scatter) for name in free]
    told = [_told(fit, names) for fit in fits]
    tau = np.array([one.value.scatter if scatter else 0.0 for one in pooled])
    between = np.diag(tau**2)
    precision, mean = _common(told, between)
    if tau.any():
        between = _scatter_matrix(tau, told, mean)
        precision, mean = _common(told, between)
    # Free fields given the shared numbers, widened; their prior counts once.
    inner = precision[:count, :count] + _LEAST * np.eye(count)
    slope = -np.linalg.solve(inner, precision[:count, count:])
    wide = np.array([one.widening for one in pooled])
    inner = inner / np.outer(wide, wide)
    covariance = np.linalg.inv(inner + np.eye(count))
    shrunk = covariance @ inner  # pulls towards the prior's middle
    follow = shrunk @ slope
    at = shrunk @ (mean[:count] + slope @ (shared.mean - mean[count:]))
    across = follow @ shared.covariance
    whole = np.block([[covariance + across @ follow.T, across], [across.T, shared.covariance]])
    scattered = np.zeros_like(whole)
    scattered[:count, :count] = between
    return PooledPosterior(names, np.concatenate([at, shared.mean]), whole, scattered)


def _free(fit: ImpactFit) -> list[str]:
    return [one.name for one in fit.problem.fields if one.role == "free"]


def _profiled(name: str, fit: ImpactFit) -> float:
    """Variance of a field by its profile, over that by Laplace."""
    if name not in fit.profiles:
        return 1.0
    k = fit.problem.place[name]
    return fit.deviation(name) ** 2 / float(fit.covariance[k, k])


class _ImpactData(NamedTuple):
    """What an impact tells of some numbers u."""

    precision: Array  # of its data alone
    point: Array  # with the prior
    covariance: Array  # with the prior

    @property
    def weighted_point(self) -> Array:
        """Precision times the centre of the data alone: Λ m = C⁻¹ û."""
        return np.asarray(self.precision @ self.point + self.point)


def _told(fit: ImpactFit, names: Sequence[str]) -> _ImpactData:
    """What an impact tells of some numbers, the free ones as wide as their profiles."""
    which = [fit.problem.place[name] for name in names]
    free = set(_free(fit))
    scale = np.array([_profiled(name, fit) ** 0.5 if name in free else 1.0 for name in names])
    covariance = fit.covariance[np.ix_(which, which)] * np.outer(scale, scale)
    inverse = np.linalg.inv(covariance)
    values, vectors = np.linalg.eigh(0.5 * (inverse + inverse.T) - np.eye(len(which)))
    precision = (vectors * np.maximum(values, 0.0)) @ vectors.T
    return _ImpactData(precision, fit.point[which], covariance)


def _common(told: Sequence[_ImpactData], between: Array) -> tuple[Array, Array]:
    """Precision and mean of what is common, for a scatter of the free fields; without priors."""
    size = len(told[0].point)
    scatter = np.zeros((size, size))
    scatter[: len(between), : len(between)] = between
    precision, weighted = np.zeros((size, size)), np.zeros(size)
    for one in told:
        left = np.eye(size) + one.precision @ scatter
        precision += np.linalg.solve(left, one.precision)
        weighted += np.linalg.solve(left, one.weighted_point)
    mean = np.asarray(np.linalg.solve(precision + _LEAST * np.eye(size), weighted), dtype=float)
    return precision, mean


def _scatter_matrix(tau: Array, told: Sequence[_ImpactData], mean: Array) -> Array:
    """Covariance of the scatter, of standard deviations that are known.

    Correlations are of the impacts' differences from the mean, their own uncertainty taken out,
    and drawn towards none: those of few impacts tell little (posterior mean by an inverse Wishart
    prior about independence, with one degree of freedom more than fields).
    """
    count, some = len(tau), np.flatnonzero(tau > 0.0)
    squares = np.zeros((count, count))
    for one in told:
        inner, across = one.covariance[:count, :count], one.covariance[:count, count:]
        slope = np.linalg.solve(one.covariance[count:, count:], across.T).T
        rest = one.point - mean
        rest = rest[:count] - slope @ rest[count:]
        squares += np.outer(rest, rest) - (inner - slope @ across.T)
    scaled = squares[np.ix_(some, some)] / np.outer(tau[some], tau[some])
    values, vectors = np.linalg.eigh(scaled)
    scaled = (vectors * np.maximum(values, 0.0)) @ vectors.T
    scaled += (len(some) + 1.0) * np.eye(len(some))
    scale = tau[some] / np.sqrt(np.diag(scaled))
    found = np.zeros((count, count))
    found[np.ix_(some, some)] = scaled * np.outer(scale, scale)
    return found

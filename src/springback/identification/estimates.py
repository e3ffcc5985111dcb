"""What a fit found: values with intervals, of one impact or of several."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.identification.solving.fitting import ImpactFit
from springback.identification.solving.pooling import PooledValue, pool
from springback.identification.unknowns import Unknown
from springback.logs.recording import Array

_HALF = float(scipy.stats.norm.ppf(0.975))
#: Share of the prior's width from which a value counts as not learned, and below which as learned.
NOT_LEARNED, LEARNED = 0.7, 0.3


class FieldEstimate(NamedTuple):
    """A field of the scenario, fitted or known to some uncertainty."""

    unknown: Unknown
    value: float  # SI
    low: float  # 95 %; −infinite or infinite if the data set no bound within the prior's reach
    high: float
    deviation: float  # standard, of u: the posterior's share of the prior
    pooled: PooledValue | None  # of several impacts, in u

    @property
    def prior(self) -> tuple[float, float]:
        """95 % interval before the data [SI]."""
        return float(self.unknown.value(-_HALF)), float(self.unknown.value(_HALF))

    @property
    def verdict(self) -> str:
        """``learned``, ``partly learned``, ``not learned``, ``at least`` or ``at most``."""
        below, above = np.isfinite(self.low), np.isfinite(self.high)
        if below and not above and self.deviation < NOT_LEARNED:
            return "at least"
        if above and not below and self.deviation < NOT_LEARNED:
            return "at most"
        if self.deviation >= NOT_LEARNED:
            return "not learned"
        return "learned" if self.deviation < LEARNED else "partly learned"

    @property
    def percent(self) -> tuple[float, float]:
        """Ends of the interval against the value [%]; infinite where there is none."""
        scale = 100.0 / abs(self.value) if self.value else np.inf
        return (self.low - self.value) * scale, (self.high - self.value) * scale


def field_estimates(fits: Sequence[ImpactFit], *, scatter: bool) -> list[FieldEstimate]:
    """Estimates of all fields, free ones first.

    Args:
        fits: Of all impacts, with the same fields.
        scatter: True: values may differ from impact to impact.
    """
    first = fits[0].problem
    return [
        _estimate(unknown, fits, scatter) for unknown in first.fields if unknown.role == "free"
    ] + [_estimate(unknown, fits, scatter) for unknown in first.fields if unknown.role == "known"]


def _estimate(unknown: Unknown, fits: Sequence[ImpactFit], scatter: bool) -> FieldEstimate:
    places = [fit.problem.place[unknown.name] for fit in fits]
    points = np.array([fit.point[k] for fit, k in zip(fits, places, strict=True)])
    deviations = np.array([fit.deviation(unknown.name) for fit in fits])
    if len(fits) == 1:
        deviation = float(deviations[0])
        profile = fits[0].profiles.get(unknown.name)
        reach = _HALF * deviation
        low, high = float(points[0]) - reach, float(points[0]) + reach
        if profile is not None:
            low, high = profile.low, profile.high
        value = float(unknown.value(points[0]))
        return FieldEstimate(unknown, value, *_ends(unknown, low, high), deviation, None)
    if unknown.role == "known":  # the same uncertainty in every impact, not an independent one
        mean, deviation = float(points.mean()), float(deviations.min())
        reach = _HALF * deviation
        return FieldEstimate(
            unknown, float(unknown.value(mean)), *_ends(unknown, mean - reach, mean + reach),
            deviation, None,
        )  # fmt: skip
    # The prior is in every fit: it is taken out of all but one before they are pooled.
    told = np.maximum(1.0 / deviations**2 - 1.0, 1e-6)
    alone = points / deviations**2 / told
    together = pool(alone, told**-0.5, scatter=scatter)
    deviation = (together.high - together.low) / (2.0 * _HALF)
    ends = _ends(unknown, together.low, together.high)
    return FieldEstimate(unknown, float(unknown.value(together.value)), *ends, deviation, together)


def _ends(unknown: Unknown, low: float, high: float) -> tuple[float, float]:
    below = float(unknown.value(low)) if np.isfinite(low) else -np.inf
    return below, float(unknown.value(high)) if np.isfinite(high) else np.inf


def correlations(fit: ImpactFit) -> tuple[list[str], Array]:
    """Correlations of the fields of an impact, by Laplace: names and matrix."""
    names = [one.name for one in fit.problem.fields]
    part = fit.covariance[: len(names), : len(names)]
    scale = 1.0 / np.sqrt(np.diag(part))
    return names, part * scale[:, None] * scale[None]

"""What a fit found: values with intervals, of one impact or of several."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.identification.solving.fitting import ImpactFit
from springback.identification.solving.pooled_fields import (
    SharedNumbers,
    pooled_field,
    pooled_sum,
    shared_numbers,
)
from springback.identification.solving.pooling import PooledValue
from springback.identification.unknowns import Unknown
from springback.logs.recording import Array

_HALF = float(scipy.stats.norm.ppf(0.975))
#: Share of the prior's width from which a value counts as not learned, and below which as learned.
NOT_LEARNED, LEARNED = 0.7, 0.3
#: Depth at which forces are told [m] (chosen: of the contacts here; k and n hang together there
#: least, while at 1 m they do by 0.99).
DEPTH = 0.01


class FieldEstimate(NamedTuple):
    """A field of the scenario, fitted or known to some uncertainty."""

    unknown: Unknown
    value: float  # SI
    low: float  # 95 %; −infinite or infinite if the data set no bound within the prior's reach
    high: float
    deviation: float  # standard, of u: the posterior's share of the prior
    pooled: PooledValue | None  # of several impacts, in u
    settled: bool = True  # False: the optimum is not, nor is the interval

    @property
    def prior(self) -> tuple[float, float]:
        """95 % interval before the data [SI]."""
        return float(self.unknown.value(-_HALF)), float(self.unknown.value(_HALF))

    @property
    def verdict(self) -> str:
        """``learned``, ``partly learned``, ``not learned``, ``at least``, ``at most``.

        Or ``not settled``, if the search found better values on its way: then no interval holds.
        """
        if not self.settled:
            return "not settled"
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

    What is known to some uncertainty, or belongs to a device, is the same in every impact: its
    error does not average out.  Each impact's value is pooled as it would be were that known
    exactly, and the interval is then widened by it.

    Args:
        fits: Of all impacts, with the same fields.
        scatter: True: values may differ from impact to impact.
    """
    first = fits[0].problem
    free = [one for one in first.fields if one.role == "free"]
    known = [one for one in first.fields if one.role == "known"]
    if len(fits) == 1:
        found = [_alone(unknown, fits[0]) for unknown in (*free, *known)]
    else:
        shared = shared_numbers(fits, scatter=scatter)
        found = [
            *(_pooled(unknown, fits, shared, scatter) for unknown in free),
            *(_known(unknown, shared) for unknown in known),
        ]
    settled = all(fit.settled for fit in fits)
    return [one._replace(settled=settled) for one in found]


def _alone(unknown: Unknown, fit: ImpactFit) -> FieldEstimate:
    point, deviation = (
        float(fit.point[fit.problem.place[unknown.name]]),
        fit.deviation(unknown.name),
    )
    profile, reach = fit.profiles.get(unknown.name), _HALF * deviation
    low, high = point - reach, point + reach
    if profile is not None:
        low, high = profile.low, profile.high
    value = float(unknown.value(point))
    return FieldEstimate(unknown, value, *_ends(unknown, low, high), deviation, None)


def _known(unknown: Unknown, shared: SharedNumbers) -> FieldEstimate:
    k = shared.names.index(unknown.name)
    mean, deviation = float(shared.mean[k]), float(np.sqrt(shared.covariance[k, k]))
    reach = _HALF * deviation
    value = float(unknown.value(mean))
    ends = _ends(unknown, mean - reach, mean + reach)
    return FieldEstimate(unknown, value, *ends, deviation, None)


def _pooled(
    unknown: Unknown, fits: Sequence[ImpactFit], shared: SharedNumbers, scatter: bool
) -> FieldEstimate:
    together = pooled_field(unknown.name, fits, shared, scatter=scatter).value
    deviation = (together.high - together.low) / (2.0 * _HALF)
    ends = _ends(unknown, together.low, together.high)
    return FieldEstimate(unknown, float(unknown.value(together.value)), *ends, deviation, together)


class PressedForce(NamedTuple):
    """Force of a surface at one depth, which data tell better than stiffness and exponent apart."""

    name: str  # path of the surface
    value: float  # [N]
    low: float  # 95 %, by Laplace
    high: float


def depth_forces(fits: Sequence[ImpactFit], *, scatter: bool) -> list[PressedForce]:
    """Forces k δⁿ at `DEPTH` of surfaces of which stiffness and exponent are both free.

    Args:
        fits: Of all impacts.
        scatter: True: values may differ from impact to impact.
    """
    fields, found = fits[0].problem.fields, list[PressedForce]()
    place = {one.name: k for k, one in enumerate(fields) if one.role == "free"}
    for name, k in place.items():
        surface = name.removesuffix(".stiffness")
        n = place.get(f"{surface}.exponent")
        if surface == name or n is None or not fields[k].logarithmic:
            continue
        exponent, middle = fields[n], float(np.mean([fit.point[n] for fit in fits]))
        slope = exponent.deviation * (
            float(exponent.value(middle)) if exponent.logarithmic else 1.0
        )
        weights = np.zeros(len(fields))
        weights[k], weights[n] = fields[k].deviation, slope * np.log(DEPTH)
        # ln F = ln k + n ln δ, to first order about the mean exponent.
        rest = fields[k].centre + float(exponent.value(middle)) * np.log(DEPTH)
        rest -= weights[n] * middle
        if len(fits) == 1:
            size = len(weights)
            value = float(weights @ fits[0].point[:size])
            half = _HALF * float(np.sqrt(weights @ fits[0].covariance[:size, :size] @ weights))
            ends = value, value - half, value + half
        else:
            shared = shared_numbers(fits, scatter=scatter)
            together = pooled_sum(
                weights, fits, shared, scatter=scatter, profiled=np.ones(len(fits))
            ).value
            ends = together.value, together.low, together.high
        found.append(PressedForce(surface, *(float(np.exp(rest + end)) for end in ends)))
    return found


def _ends(unknown: Unknown, low: float, high: float) -> tuple[float, float]:
    below = float(unknown.value(low)) if np.isfinite(low) else -np.inf
    return below, float(unknown.value(high)) if np.isfinite(high) else np.inf


def correlations(fit: ImpactFit) -> tuple[list[str], Array]:
    """Correlations of the fields of an impact, by Laplace: names and matrix."""
    names = [one.name for one in fit.problem.fields]
    part = fit.covariance[: len(names), : len(names)]
    scale = 1.0 / np.sqrt(np.diag(part))
    return names, part * scale[:, None] * scale[None]

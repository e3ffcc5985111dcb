"""Tests of a fit: χ² of each channel, inside the contact too, and of Ljung and Box."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.identification.observations.channel_window import ChannelWindow
from springback.identification.observations.likelihood import CORNER, OUTLIER
from springback.identification.solving.fitting import ImpactFit
from springback.identification.solving.least_squares import solve
from springback.identification.unknowns import FARTHEST
from springback.logs.recording import ANGULAR_VELOCITY, SPECIFIC_FORCE, Array
from springback.random_streams import Purpose, stream

#: Probability below which a misfit is said (chosen; `springback identify check` tells how often
#: that is wrong).
UNLIKELY = 2e-3
#: Lags of the test of Ljung and Box, and draws of its statistic for as many independent numbers
#: (chosen: of contacts of 20 to 60 samples, χ² calls six to ten times as many unlikely as are).
LAGS, DRAWS = 8, 30_000
#: Probability by χ² below which the statistic is drawn, and numbers drawn at once (chosen).
DOUBTED, AT_ONCE = 0.05, 1_000_000
#: Rounds in which the samples themselves are fitted (chosen).
SAMPLE_ROUNDS = 12
#: Share of the range from which a sample counts as clipped (chosen: a low-pass behind the range
#: takes some samples to get there).
CLIPPED = 0.99


class ChannelMisfit(NamedTuple):
    """How well a channel is predicted."""

    impact: str
    channel: str
    part: str  # "all" or "contact"
    samples: int
    ratio: float  # mean square of whitened residuals, 1 at best
    probability: float  # two-sided, of a ratio so far from 1
    correlated: float  # probability of residuals that hang together so much; NaN if not tested
    outliers: int

    @property
    def is_misfit(self) -> bool:
        """True if it is unlikely."""
        hangs = np.isfinite(self.correlated) and self.correlated < UNLIKELY
        return bool(self.probability < UNLIKELY or hangs)


def misfits(fit: ImpactFit) -> list[ChannelMisfit]:
    """Misfits of all channels of an impact at its optimum.

    A fit compares means of some samples, which a steep rise that comes too early by a part of one
    leaves as they are: what is said is no better where the samples themselves are fitted.
    """
    found = _misfits_at(fit, fit.point)
    if not any(one.is_misfit for one in found):
        return found
    by_samples = solve(
        fit.problem.of_samples(), fit.point[None], farthest=FARTHEST, rounds=SAMPLE_ROUNDS
    )
    if not np.isfinite(by_samples.costs[0]):
        return found
    return _misfits_at(fit, by_samples.points[0])


def _misfits_at(fit: ImpactFit, point: Array) -> list[ChannelMisfit]:
    """Misfits of all channels of an impact at a point."""
    impact, found = fit.problem.impact, []
    errors = fit.problem.errors(point)
    numbers = effective_numbers(fit)
    share = numbers / max(sum(white.size for white in errors.values()), 1)
    contact = (impact.touch - 0.002, impact.release + 0.005)
    for reading in fit.problem.readings:
        white = errors[reading.name]
        inside = (reading.times >= contact[0]) & (reading.times <= contact[1])
        free = _unclipped(fit, reading) & np.isfinite(reading.values).all(axis=1)
        white, inside = white[free], inside[free]
        found.append(_tested(impact.name, reading, "all", white, share))
        if inside.sum() >= LAGS:
            found.append(_tested(impact.name, reading, "contact", white[inside], share))
    return found


def filter_sentences(fits: Sequence[ImpactFit], tested: Sequence[ChannelMisfit]) -> list[str]:
    """Filters of inertial channels that do not fit, as what may be wrong.

    Args:
        fits: Of all impacts.
        tested: Their channels.
    """
    bad = {one.channel for one in tested if one.is_misfit}
    found = list[str]()
    for one in fits[0].problem.readings:
        if one.name not in bad or one.quantity not in CORNER:
            continue
        word = "accelerometer" if one.quantity == SPECIFIC_FORCE else "gyroscope"
        chain = fits[0].problem.chain(one)
        if chain.low_pass is None:
            found.append(
                f"the misfit of {one.name} may be a low-pass that was not told: give sensors."
                f'{word}.low_pass = "30 Hz +- 20 %", with low_pass_order = 2 of an autopilot'
            )
        elif CORNER[one.quantity] not in fits[0].problem.place:
            order = "second" if chain.order == 2 else "first"
            found.append(
                f"the misfit of {one.name} may be its low-pass, taken for one of {order} order at "
                f'{chain.low_pass:g} Hz exactly: "{chain.low_pass:g} Hz +- 20 %" fits the corner, '
                f"sensors.{word}.low_pass_order is 1 or 2"
            )
    return found


def _unclipped(fit: ImpactFit, reading: ChannelWindow) -> Any:
    """True for samples that are not at the end of the range, where there is no noise."""
    full: float | None = None
    if reading.clipped is not None:
        return ~np.asarray(reading.clipped).any(axis=1)
    if reading.quantity in (SPECIFIC_FORCE, ANGULAR_VELOCITY):
        full = fit.problem.chain(reading).full_scale
    if full is None:
        return np.ones(len(reading.times), dtype=bool)
    return ~(np.abs(np.nan_to_num(reading.values)) >= CLIPPED * full).any(axis=1)


def effective_numbers(fit: ImpactFit) -> float:
    """Numbers that the data determine, those that the priors do left out."""
    return float((1.0 - np.diag(fit.covariance)).sum())


def _tested(
    impact: str, reading: ChannelWindow, part: str, white: Array, share: float
) -> ChannelMisfit:
    size = np.abs(white)
    outliers = int((size > OUTLIER).any(axis=1).sum())
    kept = white[(size <= OUTLIER).all(axis=1)] if reading.other_clock else white
    count = max(kept.size * (1.0 - share), 1.0)
    ratio = float((kept**2).sum()) / count
    law = (
        scipy.stats.f(count, reading.noise.freedom)
        if np.isfinite(reading.noise.freedom) else scipy.stats.chi2(count, scale=1.0 / count)
    )  # fmt: skip
    above = float(law.sf(ratio))
    is_guess = not np.isfinite(reading.noise.freedom)  # of what devices resolve: an upper bound
    probability = above if is_guess else 2.0 * min(float(law.cdf(ratio)), above)
    correlated = np.nan
    if part == "contact" and len(kept) > 2 * LAGS and not is_guess:
        correlated = _ljung_box(kept)
    return ChannelMisfit(
        impact, reading.name, part, len(kept), ratio, min(probability, 1.0), correlated, outliers
    )


def _ljung_box(white: Array) -> float:
    """Probability that independent numbers hang together so much, least of all axes, corrected."""
    largest = float(_correlation(white.T).max())
    single = float(scipy.stats.chi2.sf(largest, LAGS))
    if single < DOUBTED:
        single = _drawn_probability(largest, len(white))
    return float(min(1.0, single * white.shape[1]))


def _correlation(series: Array) -> Array:
    """Statistic of Ljung and Box (Biometrika 65, 1978), shape (series, numbers) to (series,)."""
    count = series.shape[-1]
    centred = series - series.mean(axis=-1, keepdims=True)
    power = np.maximum((centred**2).sum(axis=-1), np.finfo(float).tiny)
    found = np.zeros(len(series))
    for k in range(1, LAGS + 1):
        r = (centred[:, k:] * centred[:, :-k]).sum(axis=-1) / power
        found += count * (count + 2.0) * r**2 / (count - k)
    return found


@lru_cache(maxsize=64)
def _drawn(count: int) -> Array:
    """Statistics of as many independent normal numbers, in order."""
    drawing, rows = stream(0, Purpose.NULL, count), max(AT_ONCE // count, 1)
    sizes = [min(rows, DRAWS - k) for k in range(0, DRAWS, rows)]
    drawn = [_correlation(drawing.standard_normal((size, count))) for size in sizes]
    return np.sort(np.concatenate(drawn))


def _drawn_probability(statistic: float, count: int) -> float:
    """Share of draws of the null hypothesis that reach a statistic, which is counted as one."""
    above = DRAWS - int(np.searchsorted(_drawn(count), statistic))
    return (1.0 + above) / (1.0 + DRAWS)

"""What a fit says in sentences: learned, not learned and why, assumed, and what does not fit."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from springback.identification.estimates import (
    DEPTH,
    FieldEstimate,
    correlations,
    depth_forces,
)
from springback.identification.misfit import ChannelMisfit
from springback.identification.sensitivity import HARDLY, field_sensitivities, reason_untold
from springback.identification.solving.fitting import ImpactFit
from springback.identification.solving.pooling import DIFFERENT
from springback.logs.recording import ARM_LENGTH, POSITION, SPECIFIC_FORCE, Array

#: Correlation from which two fields cannot be told apart, and the share of a variance that one
#: known field has (chosen).
BOUND_TOGETHER, INHERITED = 0.9, 0.05
#: What the shares of known fields are.
SHARES = (
    "a share of the variance is what the squared width of an interval would lose if that number "
    "alone were known exactly; numbers that are told together share what each would take away, so "
    "that shares may add up to more than 100 %"
)
#: Share of the variance of a stiffness from which it is one over mass (chosen).
MOSTLY = 0.5
#: Samples in a contact below which they are said to be few (chosen).
FEW_SAMPLES = 15
#: Standard deviations of a prior beyond which its field is a surprise (chosen).
SURPRISING = 4.0
#: Change that one impact alone makes, in deviations of the pooled value (chosen).
WEIGHTY = 2.0


def number_text(value: float, unit: str) -> str:
    """Value with its unit, to five digits."""
    return f"{value:.5g} {unit}".strip()


def estimate_sentence(one: FieldEstimate) -> str:
    """Value, interval and verdict of a field."""
    unknown, unit = one.unknown, one.unknown.unit
    low, high = one.percent
    said = f"{unknown.name} = {number_text(one.value, unit)}"
    if np.isfinite(low) and np.isfinite(high):
        if max(-low, high) < 300.0:
            said += f", {low:+.2g} % to {high:+.2g} %"
        else:
            said += f", from {number_text(one.low, unit)} to {number_text(one.high, unit)}"
    elif one.verdict == "at least":
        said = f"{unknown.name} is at least {number_text(one.low, unit)}"
    elif one.verdict == "at most":
        said = f"{unknown.name} is at most {number_text(one.high, unit)}"
    percent = float(f"{100.0 * one.deviation:.2g}")
    return f"{said}: {one.verdict} ({percent:g} % of the uncertainty before)"


def force_sentences(fits: Sequence[ImpactFit], *, scatter: bool) -> list[str]:
    """Forces at one depth of surfaces whose stiffness and exponent are both free.

    Args:
        fits: Of all impacts.
        scatter: True: values may differ from impact to impact.
    """
    return [
        f"force at {1e3 * DEPTH:g} mm of {one.name} = {number_text(one.value, 'N')}, "
        f"{100.0 * (one.low / one.value - 1.0):+.2g} % to "
        f"{100.0 * (one.high / one.value - 1.0):+.2g} %: stiffness and exponent together"
        for one in depth_forces(fits, scatter=scatter)
    ]


def sentences(
    fits: Sequence[ImpactFit], estimates: Sequence[FieldEstimate], tested: Sequence[ChannelMisfit]
) -> list[str]:
    """Warnings and reasons, most important first."""
    return [
        *_misfit_sentences(tested, several=len(fits) > 1),
        *(text for fit in fits for text in fit.bounds),
        *_search_sentences(fits),
        *_far_from_priors(estimates),
        *(text for one in estimates if one.unknown.role == "free"
          for text in _not_learned(one, fits)),
        *_bound_together(fits, estimates),
        *_scatter_sentences(fits, estimates),
        *_inherited(fits, estimates),
    ]  # fmt: skip


def _misfit_sentences(tested: Sequence[ChannelMisfit], *, several: bool) -> list[str]:
    found = []
    for one in tested:
        if not one.is_misfit:
            continue
        where = "in the contact" if one.part == "contact" else "over the whole window"
        where += f" of {one.impact}" if several else ""
        if one.probability < 1e-3:
            size, result = "smaller", "intervals are then too wide"
            if one.ratio > 1.0:
                size, result = "larger", "intervals are too narrow, and values may be wrong"
            found.append(
                f"misfit: residuals of {one.channel} {where} are {np.sqrt(one.ratio):.2g} times "
                f"their noise, {size} than chance allows (p = {one.probability:.1g}); {result}"
            )
        else:
            found.append(
                f"misfit: residuals of {one.channel} {where} hang together (p = "
                f"{one.correlated:.1g}): the law or the sensor's chain is not the true one"
            )
    for one in tested:
        if one.outliers and one.part == "all":
            of = f" of {one.impact}" if several else ""
            found.append(f"{one.outliers} samples of {one.channel}{of} are outliers")
    return found


def _search_sentences(fits: Sequence[ImpactFit]) -> list[str]:
    return [
        f"only 1 of {fit.starts} starts ended at this optimum of {fit.name}: give more starts"
        for fit in fits if fit.starts > 1 and fit.agreeing == 1
    ]  # fmt: skip


def _far_from_priors(estimates: Sequence[FieldEstimate]) -> list[str]:
    found = []
    for one in estimates:
        far = abs(one.unknown.coordinate(one.value))
        if far > SURPRISING:
            found.append(
                f"{one.unknown.name} is {far:.1f} standard deviations of its prior away from it: "
                "scenario, frames, order of arms or units may be wrong"
            )
    return found


def _not_learned(one: FieldEstimate, fits: Sequence[ImpactFit]) -> list[str]:
    if one.verdict in ("learned", "not settled"):  # the latter is said of the impact
        return []
    reasons = []
    fit = fits[0]
    names, matrix = correlations(fit)
    place = names.index(one.unknown.name)
    row = np.abs(matrix[place].copy())
    row[place] = 0.0
    if row.max() > BOUND_TOGETHER:
        other = names[int(row.argmax())]
        reasons.append(f"it cannot be told apart from {other} (correlation {row.max():.2f})")
    impact = fit.problem.impact
    force, track = impact.of(SPECIFIC_FORCE), impact.of(POSITION)
    contact = 1e3 * (impact.release - impact.touch)
    if force is None:
        reasons.append("no accelerometer was given")
        if track is not None:
            seen = int(((track.times >= impact.touch) & (track.times <= impact.release)).sum())
            if not impact.release > impact.touch:
                rate = 1.0 / float(np.median(np.diff(track.times)))
                reasons.append(f"a track of {rate:.0f} Hz does not show the contact itself")
            elif seen < FEW_SAMPLES:
                many = "1 sample" if seen == 1 else f"{seen} samples"
                reasons.append(f"the track saw {many} of a contact of {contact:.0f} ms")
    if impact.of(ARM_LENGTH) is None and ".arms." in one.unknown.name:
        reasons.append("no sensors of arm lengths were given")
    if not reasons:
        reasons.append("this impact hardly depends on it; springback identify plan finds others")
    problem = fit.problem
    told = [
        field_sensitivities(problem.unknowns, one.jacobian, problem.count)[place] for one in fits
    ]
    most = max(told, key=lambda each: each.told)
    if most.told < HARDLY:
        reasons = [reason_untold(one.unknown, most, problem.scenario)]
    return [f"{one.unknown.name} {one.verdict}: {'; '.join(reasons)}"]


def _bound_together(fits: Sequence[ImpactFit], estimates: Sequence[FieldEstimate]) -> list[str]:
    free = [one.unknown.name for one in estimates if one.unknown.role == "free"]
    names, matrix = correlations(fits[0])
    found = []
    for a, first in enumerate(free):
        for second in free[a + 1 :]:
            rho = float(matrix[names.index(first), names.index(second)])
            if abs(rho) > BOUND_TOGETHER:
                found.append(
                    f"{first} and {second} are told together only (correlation {rho:+.2f})"
                )
    return found


def _scatter_sentences(fits: Sequence[ImpactFit], estimates: Sequence[FieldEstimate]) -> list[str]:
    found = []
    for one in estimates:
        if one.pooled is None:
            continue
        told, scale = one.pooled, one.unknown.deviation
        name, percent = one.unknown.name, one.unknown.logarithmic
        size = 100.0 * told.scatter * scale if percent else told.scatter * scale
        unit = "%" if percent else one.unknown.unit
        if told.heterogeneity < DIFFERENT:
            found.append(
                f"{name} differs from impact to impact, by {size:.2g} {unit} (p = "
                f"{told.heterogeneity:.1g}): pooling as if it did not would give an interval of "
                f"{196.0 * told.common_deviation * scale:.2g}{' %' if percent else ''}, wrongly"
            )
        width = max(told.high - told.low, 1e-12) / 4.0
        shifts = [abs(value - told.value) / width for value in told.without]
        if max(shifts) > WEIGHTY:
            which = fits[int(np.argmax(shifts))].name
            found.append(
                f"{name} depends on one impact, {which}: see the table of values without each"
            )
    if len(fits) == 1:
        found.append(
            "one impact says nothing about the scatter from impact to impact: fit three or more"
        )
    return found


def _inherited(fits: Sequence[ImpactFit], estimates: Sequence[FieldEstimate]) -> list[str]:
    """Known fields that the data do not tell, and their share of the variance of each result.

    The square of a correlation is what the variance of a result would lose, were the other known
    exactly: Var(x | k) = Var(x) (1 − ρ²).
    """
    names, matrix = correlations(fits[0])
    found, has_shares = list[str](), False
    for one in estimates:
        if one.unknown.role != "known":
            continue
        row = matrix[names.index(one.unknown.name)]
        heirs = [
            f"{100.0 * float(row[names.index(other.unknown.name)]) ** 2:.0f} % of that of "
            f"{other.unknown.name}"
            for other in estimates
            if other.unknown.role == "free"
            and row[names.index(other.unknown.name)] ** 2 > INHERITED
        ]
        said = f"{one.unknown.name} was assumed ({one.unknown.uncertainty}), not measured"
        found.append(f"{said}: its share of the variance is {', '.join(heirs)}" if heirs else said)
        has_shares = has_shares or bool(heirs)
    if has_shares:
        found.append(SHARES)
    heirs = _of_mass(estimates, names, matrix)
    if heirs:
        found.append(
            f"of {', '.join(heirs)} only the ratio to mass is measured: each contains the "
            "uncertainty of mass"
        )
    return found


def _of_mass(estimates: Sequence[FieldEstimate], names: list[str], matrix: Array) -> list[str]:
    """Free stiffnesses and dampings of which known masses have most of the variance."""
    masses = [
        names.index(one.unknown.name) for one in estimates
        if one.unknown.role == "known" and one.unknown.name.endswith("mass")
    ]  # fmt: skip
    found = []
    for one in estimates:
        forces = one.unknown.unit.startswith("N") or one.unknown.name.endswith(".stiffness")
        if masses and one.unknown.role == "free" and forces:
            row = matrix[names.index(one.unknown.name)]
            if max(float(row[k]) ** 2 for k in masses) > MOSTLY:
                found.append(one.unknown.name)
    return found

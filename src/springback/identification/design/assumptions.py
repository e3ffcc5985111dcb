"""What a choice of tests takes for granted: exact fields, and how far each would move the result.

The tests that are chosen, and the impacts flown already, are taken together: the fields follow by
δu = −Λ⁻¹ Σ (gradients of all impacts, their latents taken out), Λ the information of all of them.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.identification.estimates import FieldEstimate
from springback.identification.observations.likelihood import ImpactProblem
from springback.identification.report.assumptions import (
    MATTERS,
    Assumption,
    assumed_fields,
    assumed_gradients,
    assumption_sentences,
    untried_field,
)
from springback.logs.recording import Array

_HALF = float(scipy.stats.norm.ppf(0.975))


class ImpactPoint(NamedTuple):
    """An impact that is flown, or will be."""

    problem: ImpactProblem
    point: Array
    jacobian: Array  # with the rows of the priors


def planned_assumptions(impacts: Sequence[ImpactPoint], total: Array) -> list[str]:
    """Fields that are taken as exact, those that move the result most first, and what to do.

    Args:
        impacts: Taken together.
        total: Information of all of them, and of the priors, about the fields.
    """
    first = impacts[0].problem
    tried, fixed = assumed_fields(first)
    count = first.count
    names = {one.name for one in tried}
    for impact in impacts[1:]:  # tests may have other obstacles
        names &= {one.name for one in assumed_fields(impact.problem)[0]}
    tried = [one for one in tried if one.name in names]
    gradient = np.zeros((count, len(tried)))
    for problem, point, jacobian in impacts:
        told = assumed_gradients(problem, point, jacobian, tried)
        square = jacobian.T @ jacobian
        across = np.linalg.solve(square[count:, count:], told[count:])
        gradient += told[:count] - square[:count, count:] @ across
    covariance = np.linalg.inv(total)
    moved, deviations = -covariance @ gradient, np.sqrt(np.diag(covariance))
    free = [k for k, one in enumerate(first.fields) if one.role == "free"]
    found = [untried_field(one) for one in fixed]
    for j, one in enumerate(tried):
        shifts = {first.fields[k].name: float(moved[k, j]) for k in free}
        weight = max(abs(float(moved[k, j])) / float(deviations[k]) for k in free)
        found.append(Assumption(
            one.name, one.centre, one.unit, one.uncertainty, shifts, weight
        ))  # fmt: skip
    found.sort(key=lambda one: -one.weight)
    estimates = []
    for k in free:
        one, reach = first.fields[k], _HALF * float(deviations[k])
        low, value, high = (float(one.value(u)) for u in (-reach, 0.0, reach))
        estimates.append(FieldEstimate(one, value, low, high, float(deviations[k]), None))
    said = assumption_sentences(found, estimates)
    most = next((one for one in found if one.change and one.weight > MATTERS), None)
    if most is not None:
        said.append(
            f'what is not exact belongs in [known], as "{most.name}" = "+- {most.change}": the '
            "tests are then chosen without relying on it"
        )
    return said

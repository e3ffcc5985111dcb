"""Profiles of the likelihood as curves: how much worse a fit gets along one field."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from springback.identification.solving.fitting import ImpactFit
from springback.identification.unknowns import Unknown
from springback.logs.recording import Array


class ProfileCurve(NamedTuple):
    """Profile of the likelihood of one impact over one field, all other numbers fitted anew."""

    unknown: Unknown
    values: Array
    """Of the field [SI], increasing."""
    rise: Array
    """2 Δ ln L with the prior, 0 at the optimum."""
    before: Array
    """The same of the prior alone, 0 in its middle."""
    laplace: Array
    """The same by Laplace, a parabola."""


def profile_curves(fit: ImpactFit) -> list[ProfileCurve]:
    """Profiles over the free fields of an impact, by what was flown on the way to their ends.

    Args:
        fit: With its profiles.
    """
    problem, found = fit.problem, []
    for name, profile in fit.profiles.items():
        k = problem.place[name]
        u, rise = np.array(profile.points).T
        laplace = (u - fit.point[k]) ** 2 / fit.covariance[k, k]
        values = np.asarray(problem.unknowns[k].value(u))
        found.append(ProfileCurve(problem.unknowns[k], values, rise, u**2, laplace))
    return found

"""Fit of one impact: several starts, the best optimum, and profiles of what is free."""

from __future__ import annotations

import time
from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.errors import InputError
from springback.identification.least_squares import jacobians, solved
from springback.identification.likelihood import ImpactProblem
from springback.identification.unknowns import FARTHEST
from springback.logs.recording import Array

#: Half the width of starts, in deviations of the prior (chosen).
SPREAD = 2.0
#: 2 Δ ln L at the ends of a 95 % interval: χ² of one degree of freedom.
PROFILE_RISE = float(scipy.stats.chi2.ppf(0.95, 1))
#: Rounds of the search for an end, and corrections of the other numbers in each (chosen).
ROUNDS, CORRECTIONS = 5, 3
#: Relative precision of an end (chosen).
PRECISE = 0.02
#: Costs of optima that count as one (chosen), and the rise of a better one found on the way.
SAME, BETTER = 0.1, 0.05


class ProfileEnds(NamedTuple):
    """Ends of a 95 % profile interval of one unknown, as numbers u; infinite if there is none."""

    low: float
    high: float


class ImpactFit(NamedTuple):
    """Fit of one impact."""

    problem: ImpactProblem
    point: Array  # û, shape (unknowns,)
    cost: float  # sum of squares with the priors
    jacobian: Array  # at û, shape (rows, unknowns)
    covariance: Array  # of u, by Laplace, shape (unknowns, unknowns)
    profiles: dict[str, ProfileEnds]  # of the free fields
    agreeing: int  # starts that ended at this optimum
    starts: int
    seconds: float

    @property
    def name(self) -> str:
        """Name of the impact."""
        return self.problem.impact.name

    def deviation(self, name: str) -> float:
        """Laplace's standard deviation of a number u."""
        k = self.problem.place[name]
        return float(np.sqrt(self.covariance[k, k]))


def fit_impact(
    problem: ImpactProblem, *, starts: int, seed: int, profiles: bool = True
) -> ImpactFit:
    """Fit an impact.

    Args:
        problem: Its likelihood.
        starts: Number of starts: the middle of the prior, then points of a Sobol' sequence.
        seed: Of its scrambling.
        profiles: Profile the free fields, too.

    Raises:
        InputError: If no start could be evaluated.
    """
    begun = time.perf_counter()
    free = np.array([one.role == "free" for one in problem.unknowns])
    first = np.zeros((starts, len(free)))
    if starts > 1:
        sobol = scipy.stats.qmc.Sobol(int(free.sum()), seed=seed)
        spread = SPREAD * (2.0 * sobol.random(1 << (starts - 1).bit_length()) - 1.0)
        first[1:, free] = spread[: starts - 1]
    rough = solved(problem, first, farthest=FARTHEST)
    if not np.isfinite(rough.costs).any():
        raise InputError(
            f"{problem.impact.name}: no flight of the scenario can be flown from the logged start; "
            "check obstacle, frames and units"
        )
    best = int(np.argmin(rough.costs))
    point, cost = rough.points[best], float(rough.costs[best])
    agreeing = int((rough.costs < cost + max(SAME, 1e-3 * cost)).sum())
    ends: dict[str, ProfileEnds] = {}
    for _ in range(3):
        _, [slopes] = jacobians(problem, point[None], np.ones(len(free), dtype=bool))
        covariance = _inverse(slopes)
        if not profiles:
            break
        ends, better = _profiles(problem, point, cost, slopes, covariance, free)
        if better is None:
            break
        again = solved(problem, better[None], farthest=FARTHEST)
        point, cost = again.points[0], float(again.costs[0])
    seconds = time.perf_counter() - begun
    return ImpactFit(
        problem, point, cost, slopes, covariance, ends, agreeing, starts, seconds
    )  # fmt: skip


def _inverse(slopes: Array) -> Array:
    square = slopes.T @ slopes
    return np.asarray(np.linalg.inv(square + 1e-12 * np.eye(len(square))))


def _profiles(
    problem: ImpactProblem, point: Array, cost: float, slopes: Array, covariance: Array, free: Any
) -> tuple[dict[str, ProfileEnds], Array | None]:
    """Ends of the profile intervals; and a better point, if one was found on the way.

    All ends are sought side by side.  The other numbers follow by the Jacobian at the optimum,
    corrected a few times, which is exact where the residuals are linear.
    """
    which = np.repeat(np.flatnonzero(free), 2)
    signs = np.tile([-1.0, 1.0], len(which) // 2)
    deviations = np.sqrt(np.diag(covariance))
    reach = np.minimum(np.sqrt(PROFILE_RISE) * deviations[which], FARTHEST - signs * point[which])
    solvers = []
    for k in which:
        others = np.delete(np.arange(len(point)), k)
        part = slopes[:, others]
        solvers.append((others, np.linalg.pinv(part.T @ part + 1e-12 * np.eye(len(others))), part))
    follow = covariance[:, which] / covariance[which, which]  # shape (unknowns, ends)
    low = np.zeros(len(which))  # reach below the rise, and the square root of its rise
    low_root = np.zeros(len(which))
    open_ended = np.zeros(len(which), dtype=bool)
    settled = np.zeros(len(which), dtype=bool)
    better: Array | None = None
    for _ in range(ROUNDS):
        busy = np.flatnonzero(~settled)
        if not len(busy):
            break
        points = np.clip(
            point + (signs * reach)[busy, None] * follow[:, busy].T, -FARTHEST, FARTHEST
        )
        points[np.arange(len(busy)), which[busy]] = point[which[busy]] + (signs * reach)[busy]
        costs = np.full(len(busy), np.inf)
        for _ in range(CORRECTIONS):
            residuals = problem(points)
            now = (residuals**2).sum(axis=1)
            costs = np.fmin(costs, np.where(np.isfinite(now), now, np.inf))
            for row, end in enumerate(busy):
                others, inverse, part = solvers[end]
                if np.isfinite(now[row]):
                    step = inverse @ (part.T @ residuals[row])
                    points[row, others] = np.clip(points[row, others] - step, -FARTHEST, FARTHEST)
        if costs.min() < cost - BETTER:
            better = points[int(np.argmin(costs))]
            break
        roots = np.sqrt(np.maximum(costs - cost, 1e-12))
        target = np.sqrt(PROFILE_RISE)
        for row, end in enumerate(busy):
            if abs(roots[row] / target - 1.0) < PRECISE:
                settled[end] = True
                reach[end] *= target / roots[row]
                continue
            limit = FARTHEST - signs[end] * point[which[end]]
            if roots[row] < target and reach[end] >= limit * (1.0 - 1e-9):
                open_ended[end] = settled[end] = True
                continue
            if not np.isfinite(roots[row]):
                reach[end] = 0.5 * (low[end] + reach[end])
                continue
            slope = (roots[row] - low_root[end]) / (reach[end] - low[end])
            new = reach[end] + (target - roots[row]) / max(slope, 1e-9)
            if roots[row] < target:
                low[end], low_root[end] = reach[end], roots[row]
            reach[end] = np.clip(new, 0.3 * reach[end], min(3.0 * reach[end], limit))
    ends = point[which] + signs * np.where(open_ended, np.inf, reach)
    names = [problem.unknowns[k].name for k in which[::2]]
    found = {
        name: ProfileEnds(float(ends[2 * k]), float(ends[2 * k + 1]))
        for k, name in enumerate(names)
    }
    return found, better

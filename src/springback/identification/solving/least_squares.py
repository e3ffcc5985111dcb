"""Nonlinear least squares of many problems side by side (Levenberg and Marquardt).

SciPy's solvers take one problem at a time and ask for one point at a time.  Here the points of all
problems, and those of their central differences, are asked for together, as flights in lanes: some
hundred at once take hardly longer than a dozen.  Tests compare results with SciPy's.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

Array = np.ndarray[Any, np.dtype[np.float64]]
Residuals = Callable[[Array], Array]
"""Residuals of points, shape (points, numbers) to (points, rows); NaN where a point is refused."""

#: Half the distance of central differences, in deviations of the prior (chosen: measures are smooth
#: to 1e-10 and more, and errors of second order are then below 1e-6).
DIFFERENCE = 3e-4
#: First damping, its factors, and the most that is tried (chosen).
DAMPING, RAISED, MOST_DAMPING = 1e-3, 8.0, 1e10
FACTORS = (0.2, 1.0, RAISED, RAISED**3)
#: Rounds at most; a problem is solved once twice its cost falls by less than this (chosen).
MOST_ROUNDS, ENOUGH = 40, 1e-4
#: A problem is given up while its cost is above the best by this after some rounds (chosen).
HOPELESS, PATIENT_ROUNDS = 2e3, 6


class Solution(NamedTuple):
    """Solutions of problems."""

    points: Array  # shape (problems, numbers)
    costs: Array  # sum of squares, shape (problems,); infinite where nothing could be evaluated
    residuals: Array  # shape (problems, rows)
    jacobians: Array  # at the last point from which a step was taken, (problems, rows, numbers)
    converged: Any  # shape (problems,)


def jacobians(evaluate: Residuals, points: Array, active: Any) -> tuple[Array, Array]:
    """Residuals and their derivatives at some points.

    Args:
        evaluate: The residuals.
        points: Shape (points, numbers).
        active: Numbers that move, shape (numbers,); derivatives by others are zero.

    Returns:
        Residuals, shape (points, rows), and Jacobians, shape (points, rows, numbers).
    """
    count, numbers = points.shape
    moving = np.flatnonzero(active)
    steps = np.zeros((2 * len(moving), numbers))
    steps[np.arange(len(moving)), moving] = DIFFERENCE
    steps[len(moving) + np.arange(len(moving)), moving] = -DIFFERENCE
    asked = np.concatenate([points[:, None], points[:, None] + steps[None]], axis=1)
    found = evaluate(asked.reshape(-1, numbers)).reshape(count, 1 + 2 * len(moving), -1)
    slopes = np.zeros((count, found.shape[2], numbers))
    ahead, behind = found[:, 1 : 1 + len(moving)], found[:, 1 + len(moving) :]
    slopes[:, :, moving] = ((ahead - behind) / (2.0 * DIFFERENCE)).transpose(0, 2, 1)
    return found[:, 0], slopes


def solve(
    evaluate: Residuals,
    starts: Array,
    *,
    farthest: float,
    held: Any = None,
    rounds: int = MOST_ROUNDS,
    enough: float = ENOUGH,
    damping: float = DAMPING,
    together: bool = True,
) -> Solution:
    """Solve problems that differ in where they start and in what is held.

    Args:
        evaluate: The residuals.
        starts: Shape (problems, numbers).
        farthest: Bound of the magnitude of each number.
        held: True for numbers that do not move, shape (numbers,) or (problems, numbers); None: all
            move.
        rounds: Most rounds.
        enough: A problem is solved once its cost falls by less than this in a round.
        damping: First damping.
        together: True if all seek the same optimum: those far above the best are given up.
    """
    points = np.clip(np.array(starts, dtype=float), -farthest, farthest)
    problems, numbers = points.shape
    kept = np.zeros(numbers, dtype=bool) if held is None else np.asarray(held, dtype=bool)
    active = np.broadcast_to(~kept, points.shape)
    dampings = np.full(problems, damping)
    residuals, slopes = jacobians(evaluate, points, active.any(axis=0))
    costs = _costs(residuals)
    done = ~np.isfinite(costs)
    for turn in range(rounds):
        if together and turn >= PATIENT_ROUNDS:
            done |= costs > costs.min() + HOPELESS
        open_ones = np.flatnonzero(~done)
        if not len(open_ones):
            break
        tries = dampings[open_ones, None] * np.array(FACTORS)
        asked = np.array([
            [_step(points[k], residuals[k], slopes[k], one, active[k], farthest) for one in row]
            for k, row in zip(open_ones, tries, strict=True)
        ])  # fmt: skip
        found = evaluate(asked.reshape(-1, numbers)).reshape(*asked.shape[:2], -1)
        there = _costs(found)
        moved = []
        for row, k in enumerate(open_ones):
            best = int(np.argmin(there[row]))
            gain = costs[k] - there[row, best]
            if gain > 0.0:
                points[k], costs[k] = asked[row, best], there[row, best]
                residuals[k], dampings[k] = found[row, best], max(tries[row, best], 1e-12)
                moved.append(k)
            else:
                dampings[k] = tries[row, -1] * RAISED
            done[k] = (0.0 <= gain < enough) or dampings[k] > MOST_DAMPING
        again = [k for k in moved if not done[k]]
        if again and turn + 1 < rounds:
            residuals[again], slopes[again] = jacobians(
                evaluate, points[again], active[again].any(axis=0)
            )
    return Solution(points, costs, residuals, slopes, done & np.isfinite(costs))


def _costs(residuals: Array) -> Array:
    total = (residuals**2).sum(axis=-1)
    return np.where(np.isfinite(total), total, np.inf)


def _step(
    point: Array, residuals: Array, slopes: Array, damping: float, active: Any, farthest: float
) -> Array:
    """The point after a damped step, within the bounds."""
    free = np.asarray(active).copy()
    step = np.zeros_like(point)
    for _ in range(2):  # once more without those that a bound stops
        j = slopes[:, free]
        square = j.T @ j
        scale = np.diag(square) + 1e-12
        gradient = j.T @ residuals
        step[:] = 0.0
        step[free] = -np.linalg.solve(square + damping * np.diag(scale), gradient)
        stopped = free & (
            ((point >= farthest) & (step > 0.0)) | ((point <= -farthest) & (step < 0.0))
        )
        if not stopped.any():
            break
        free &= ~stopped
    return np.clip(point + step, -farthest, farthest)

"""Nonlinear least squares of many problems side by side (Levenberg and Marquardt).

SciPy's solvers take one problem at a time and ask for one point at a time.  Here the points of all
problems, and those of their central differences, are asked for together, as flights in lanes: some
hundred at once take hardly longer than a dozen.  Tests compare results with SciPy's.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from springback.identification.solving.search_progress import Watch, ignore_round

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
#: Rounds of small gain in which a problem seeks along the edge of what can be evaluated (chosen).
EDGE_ROUNDS = 8
#: A problem is given up while its cost is above the best by this after some rounds (chosen); in
#: haste, before, too, if it is above so many times the best and not one of the two best (chosen: of
#: 8 starts, in 16 sets of examples/fit.toml, 1.8 then end at the optimum on average, else 2.1).
HOPELESS, PATIENT_ROUNDS = 2e3, 6
FAR_ABOVE, SPARED = {2: 100.0, 3: 30.0, 4: 10.0, 5: 5.0}, 2
#: Fall of the cost in a round from which derivatives are taken anew (chosen): secants follow no
#: faster change.
COARSE = 1e3


class Solution(NamedTuple):
    """Solutions of problems."""

    points: Array  # shape (problems, numbers)
    costs: Array  # sum of squares, shape (problems,); infinite where nothing could be evaluated
    residuals: Array  # shape (problems, rows)
    jacobians: Array  # at the last point from which a step was taken, (problems, rows, numbers)
    converged: Any  # shape (problems,)


def jacobians(
    evaluate: Residuals, points: Array, active: Any, *, central: bool = True
) -> tuple[Array, Array]:
    """Residuals and their derivatives at some points.

    Args:
        evaluate: The residuals.
        points: Shape (points, numbers).
        active: Numbers that move, shape (numbers,); derivatives by others are zero.
        central: False takes differences to one side where that can be evaluated.

    Returns:
        Residuals, shape (points, rows), and Jacobians, shape (points, rows, numbers): of the side
        that can be evaluated if the other cannot, NaN if neither can.
    """
    found = _differences(evaluate, points, active, central=central)
    return found.residuals, found.slopes


class _Differences(NamedTuple):
    residuals: Array
    slopes: Array
    refused: Any  # numbers that cannot be larger, and smaller, shape (2, points, numbers)


def _differences(
    evaluate: Residuals, points: Array, active: Any, *, central: bool = True
) -> _Differences:
    """Residuals, slopes and edges; slopes to one side where both are not wanted or cannot be."""
    count, numbers = points.shape
    moving = np.flatnonzero(active)
    steps = np.zeros((1 + 2 * len(moving), numbers))
    steps[1 + np.arange(len(moving)), moving] = DIFFERENCE
    steps[1 + len(moving) + np.arange(len(moving)), moving] = -DIFFERENCE

    def at(chosen: Array) -> Array:
        asked = points[:, None] + chosen[None]
        return evaluate(asked.reshape(-1, numbers)).reshape(count, len(chosen), -1)

    found = at(steps if central else steps[: 1 + len(moving)])
    if not (central or np.isfinite(found[:, 1:]).all()):
        found = np.concatenate([found, at(steps[1 + len(moving) :])], axis=1)
    slopes = np.zeros((count, found.shape[2], numbers))
    here, ahead, behind = found[:, :1], found[:, 1 : 1 + len(moving)], found[:, 1 + len(moving) :]
    refused = np.zeros((2, count, numbers), dtype=bool)
    told = (ahead - here) / DIFFERENCE
    if behind.shape[1]:
        bad: Any = ~np.isfinite(np.stack([ahead, behind])).all(axis=3)
        one_sided = np.where(bad[0][:, :, None], (here - behind) / DIFFERENCE, told)
        either = (bad[0] | bad[1])[:, :, None]
        told = np.where(either, one_sided, (ahead - behind) / (2.0 * DIFFERENCE))
        refused[:, :, moving] = bad
    slopes[:, :, moving] = told.transpose(0, 2, 1)
    return _Differences(found[:, 0], slopes, refused)


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
    hasty: bool = False,
    central: bool = True,
    secants: int = 0,
    slopes: Array | None = None,
    checked: bool = True,
    watch: Watch = ignore_round,
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
        hasty: True gives up those many times above the best earlier, all but the two best.
        central: False takes differences to one side, at half the flights: what is found is then as
            near to an optimum as its cost tells, but not as its gradient does.
        secants: Most rounds in which a problem keeps its derivatives, corrected by what the last
            step tells of them (Broyden, Mathematics of Computation 19, 1965).
        slopes: Derivatives to begin with, shape (problems, rows, numbers); None: they are taken.
        checked: Derivatives are taken anew where secants do not help, and before a problem counts
            as solved.
        watch: Called after each round with its number, from 1, and the problems not yet solved.
    """
    points = np.clip(np.array(starts, dtype=float), -farthest, farthest)
    problems, numbers = points.shape
    kept = np.zeros(numbers, dtype=bool) if held is None else np.asarray(held, dtype=bool)
    active = np.broadcast_to(~kept, points.shape)
    dampings, ages = np.full(problems, damping), np.zeros(problems, dtype=int)
    if slopes is None:
        residuals, slopes, edges = _differences(
            evaluate, points, active.any(axis=0), central=central
        )
    else:
        residuals, slopes = evaluate(points), slopes.copy()
        edges = np.zeros((2, *points.shape), dtype=bool)
        ages += 1
    costs, along_edge = _costs(residuals), np.zeros(problems, dtype=int)
    done = ~np.isfinite(costs)
    for turn in range(rounds):
        if together:
            done |= _given_up(costs, turn, hasty)
        open_ones = np.flatnonzero(~done)
        if not len(open_ones):
            break
        tries = dampings[open_ones, None] * np.array(FACTORS)
        asked = np.array(
            [
                _steps(points[k], residuals[k], slopes[k], row, active[k], edges[:, k], farthest)
                for k, row in zip(open_ones, tries, strict=True)
            ]
        )
        found = evaluate(asked.reshape(-1, numbers)).reshape(*asked.shape[:2], -1)
        there = _costs(found)
        again = []
        for row, k in enumerate(open_ones):
            best = int(np.argmin(there[row]))
            gain, is_trusted = costs[k] - there[row, best], not (checked and ages[k])
            if gain > 0.0:
                _learn(slopes[k], asked[row, best] - points[k], found[row, best] - residuals[k])
                points[k], costs[k] = asked[row, best], there[row, best]
                residuals[k], dampings[k] = found[row, best], max(tries[row, best], 1e-12)
            elif is_trusted:
                dampings[k] = tries[row, -1] * RAISED
            at_edge = not np.isfinite(there[row]).all()
            is_small = 0.0 <= gain < enough
            if is_small and is_trusted and at_edge:
                along_edge[k] += 1
                is_small = along_edge[k] > EDGE_ROUNDS
            done[k] = (is_small and is_trusted) or dampings[k] > MOST_DAMPING
            if done[k]:
                continue
            is_slow = enough <= gain < COARSE and not (at_edge or edges[:, k].any())
            if is_slow and ages[k] < secants:
                ages[k] += 1
            elif gain > 0.0 or not is_trusted:
                again.append(k)
        if again and turn + 1 < rounds:
            residuals[again], slopes[again], now = _differences(
                evaluate, points[again], active[again].any(axis=0), central=central
            )
            ages[again] = 0
            for place, k in enumerate(again):
                if (now[:, place] & ~edges[:, k]).any():  # what stops it no longer damps the rest
                    dampings[k] = damping
            edges[:, again] = now
        watch(turn + 1, int((~done).sum()))
    return Solution(points, costs, residuals, slopes, done & np.isfinite(costs))


def _given_up(costs: Array, turn: int, hasty: bool) -> Any:
    """Problems that are too far above the best after some rounds, shape (problems,)."""
    if turn >= PATIENT_ROUNDS:
        return costs > costs.min() + HOPELESS
    far = FAR_ABOVE.get(turn, np.inf) if hasty else np.inf
    found = costs > far * costs.min() + HOPELESS
    found[np.argsort(costs)[:SPARED]] = False
    return found


def _learn(slopes: Array, step: Array, change: Array) -> None:
    """Correct derivatives along a step by the change of the residuals."""
    if (length := float(step @ step)) > 0.0:
        slopes += np.outer((change - slopes @ step) / length, step)


def _costs(residuals: Array) -> Array:
    total = (residuals**2).sum(axis=-1)
    return np.where(np.isfinite(total), total, np.inf)


def _steps(
    point: Array,
    residuals: Array,
    slopes: Array,
    dampings: Array,
    active: Any,
    edges: Any,
    farthest: float,
) -> list[Array]:
    """The points after steps of some dampings, within the bounds."""
    free = np.asarray(active) & ~edges.all(axis=0)
    j = np.ascontiguousarray(slopes[:, free])
    square, gradient = np.zeros((len(point), len(point))), np.zeros_like(point)
    square[np.ix_(free, free)], gradient[free] = j.T @ j, j.T @ residuals
    return [_step(point, square, gradient, one, free, edges, farthest) for one in dampings]


def _step(
    point: Array,
    square: Array,
    gradient: Array,
    damping: float,
    moving: Any,
    edges: Any,
    farthest: float,
) -> Array:
    """The point after a damped step, by JᵀJ and Jᵀr."""
    free, step = moving.copy(), np.zeros_like(point)
    for _ in range(2):  # once more without those that a bound stops
        whole = square[np.ix_(free, free)]
        damped = whole + damping * np.diag(np.diag(whole) + 1e-12)
        step[:] = 0.0
        step[free] = -np.linalg.solve(damped, gradient[free])
        up, down = (point >= farthest) | edges[0], (point <= -farthest) | edges[1]
        stopped = free & ((up & (step > 0.0)) | (down & (step < 0.0)))
        if not stopped.any():
            break
        free &= ~stopped
    return np.clip(point + step, -farthest, farthest)

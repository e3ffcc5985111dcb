"""Profile likelihood: how far each free field can go before the data object.

Along a profile one field is held and all other numbers are fitted anew (Venzon and Moolgavkar,
Applied Statistics 37, 1988; Raue et al., Bioinformatics 25, 2009).  All ends are sought side by
side.
"""

from __future__ import annotations

import functools
from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.identification.solving.least_squares import Residuals, solve
from springback.identification.solving.search_progress import ProfileWatch, ignore_profile_step
from springback.identification.unknowns import FARTHEST
from springback.logs.recording import Array

#: 2 Δ ln L at the ends of a 95 % interval: χ² of one degree of freedom.
PROFILE_RISE = float(scipy.stats.chi2.ppf(0.95, 1))
#: Rounds of the search for an end, and of the other numbers' fit in each (chosen).
ROUNDS, FITTING = 5, 4
#: Fall of the cost in a round below which the others are fitted, and relative precision of an end
#: (chosen: an interval is then right to 2 %).
FITTED, PRECISE = 0.02, 0.02
#: Rise of a better optimum that is found on the way (chosen), and bounds of a change of reach.
BETTER, SMALLEST_CHANGE, LARGEST_CHANGE = 0.05, 0.3, 3.0


class Profile(NamedTuple):
    """Profile of one unknown, in its number u."""

    low: float
    """Lower end of the 95 % interval; −infinite if the prior's reach has none."""
    high: float
    points: tuple[tuple[float, float], ...]
    """u and 2 Δ ln L of all that was evaluated, from the lowest u."""


class _End:
    """Search for one end of an interval."""

    def __init__(self, place: int, sign: float, reach: float, limit: float) -> None:
        self.place, self.sign, self.reach, self.limit = place, sign, min(reach, limit), limit
        self.below = (0.0, 0.0)  # reach, and root of the rise, below the target
        self.above: tuple[float, float] | None = None
        self.settled, self.is_open = False, False

    def learn(self, root: float) -> None:
        """Take the root of a rise at the present reach, and choose the next."""
        target = float(np.sqrt(PROFILE_RISE))
        if not np.isfinite(root):
            self.reach = 0.5 * (self.below[0] + self.reach)
            return
        if abs(root / target - 1.0) < PRECISE:
            self.settled = True
            self.reach *= target / root
            return
        if root < target:
            if self.reach >= self.limit * (1.0 - 1e-9):
                self.settled = self.is_open = True
                return
            self.below = max(self.below, (self.reach, root))
        elif self.above is None or self.reach < self.above[0]:
            self.above = (self.reach, root)
        other = self.above if self.above is not None else (self.reach, root)
        slope = (other[1] - self.below[1]) / max(other[0] - self.below[0], 1e-12)
        if self.above is None:  # the line from the optimum
            slope = root / self.reach
            new = self.reach * target / max(root, 1e-3)
        else:
            new = self.below[0] + (target - self.below[1]) / max(slope, 1e-12)
        new = np.clip(new, SMALLEST_CHANGE * self.reach, LARGEST_CHANGE * self.reach)
        self.reach = float(min(new, self.limit))


def profile_likelihoods(
    evaluate: Residuals,
    point: Array,
    cost: float,
    covariance: Array,
    free: Any,
    *,
    watch: ProfileWatch = ignore_profile_step,
) -> tuple[dict[str, Profile], Array | None]:
    """Profiles of the free numbers; and a better optimum, if one was found on the way.

    Args:
        evaluate: The residuals, with ``unknowns`` that have names.
        point: The optimum, shape (numbers,).
        cost: There.
        covariance: By Laplace, shape (numbers, numbers).
        free: True for numbers whose profile is sought, shape (numbers,).
        watch: Called after each step of each round, and after the round as its step 0.
    """
    deviations, numbers = np.sqrt(np.diag(covariance)), len(point)
    ends = [
        _End(int(k), sign, float(np.sqrt(PROFILE_RISE) * deviations[k]), FARTHEST - sign * point[k])
        for k in np.flatnonzero(free) for sign in (-1.0, 1.0)
    ]  # fmt: skip
    told: dict[int, list[tuple[float, float]]] = {
        int(k): [(float(point[k]), 0.0)] for k in np.flatnonzero(free)
    }
    # Where the others go when one moves, first as Laplace has it, then as they went.
    ways = [covariance[:, end.place] / covariance[end.place, end.place] for end in ends]
    bent: Array | None = None  # derivatives of all ends: later rounds are near to the first
    for turn in range(1, ROUNDS + 1):
        busy = [k for k, end in enumerate(ends) if not end.settled]
        if not busy:
            break
        watched = functools.partial(_watch_step, watch, turn, ends)
        starts, held = np.empty((len(busy), numbers)), np.zeros((len(busy), numbers), dtype=bool)
        for row, k in enumerate(busy):
            end = ends[k]
            starts[row] = np.clip(point + end.sign * end.reach * ways[k], -FARTHEST, FARTHEST)
            starts[row, end.place] = point[end.place] + end.sign * end.reach
            held[row, end.place] = True
        found = solve(
            evaluate, starts, farthest=FARTHEST, held=held, rounds=FITTING, enough=FITTED,
            damping=1e-6, together=False, central=False, secants=0 if bent is None else FITTING,
            slopes=None if bent is None else bent[busy], checked=bent is None, watch=watched,
        )  # fmt: skip
        if bent is None:
            bent = found.jacobians
        bent[busy] = found.jacobians
        if found.costs.min() < cost - BETTER:
            return _profiles(evaluate, point, ends, told), found.points[int(found.costs.argmin())]
        for row, k in enumerate(busy):
            end = ends[k]
            rise = max(float(found.costs[row]) - cost, 0.0)
            if np.isfinite(rise):
                told[end.place].append((float(starts[row, end.place]), rise))
                ways[k] = end.sign * (found.points[row] - point) / max(end.reach, 1e-12)
            end.learn(float(np.sqrt(max(rise, 1e-12))))
        _watch_step(watch, turn, ends, 0, 0)
    return _profiles(evaluate, point, ends, told), None


def _watch_step(watch: ProfileWatch, turn: int, ends: list[_End], step: int, left: int) -> None:
    """Tell of a step of a round, of whose fits some are left."""
    pairs = zip(ends[::2], ends[1::2], strict=True)
    watch(turn, sum(below.settled and above.settled for below, above in pairs), step)


def _profiles(
    evaluate: Any, point: Array, ends: list[_End], told: dict[int, list[tuple[float, float]]]
) -> dict[str, Profile]:
    found = {}
    for below, above in zip(ends[::2], ends[1::2], strict=True):
        low, high = (
            float(point[end.place] + end.sign * (np.inf if end.is_open else end.reach))
            for end in (below, above)
        )
        name = evaluate.unknowns[below.place].name
        found[name] = Profile(low, high, tuple(sorted(told[below.place])))
    return found

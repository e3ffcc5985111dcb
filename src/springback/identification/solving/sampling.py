"""Draws of the posterior of an impact by Monte Carlo, where it is not normal.

An ensemble of points walks by differences of its own members (ter Braak and Vrugt, Statistics and
Computing 18, 2008), by the package emcee; the logarithm of the density is −½ of the sum of squares
that a fit makes least, with all priors.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError
from springback.extras import needs
from springback.identification.solving.fitting import ImpactFit
from springback.identification.unknowns import FARTHEST
from springback.progress import Progress, silent
from springback.random_streams import Purpose, stream

Array = np.ndarray[Any, np.dtype[np.float64]]
#: Points of the ensemble for each unknown, and fewest (chosen: emcee wants two at least).
EACH, FEWEST = 2, 32
#: Words of the state of emcee's generator.
WORDS = 624
#: Steps between two looks, and most (chosen).
BLOCK, MOST = 100, 6000
#: Rounds in which points are drawn anew that cannot be flown (chosen: of one in two, 1e-10 stay).
TRIES = 32
#: Times of autocorrelation that a chain has at least, and of which the first are left out (chosen).
LONG, BURN = 20.0, 3.0


class PosteriorSample(NamedTuple):
    """Draws of all unknowns of an impact."""

    draws: Array  # u, shape (draws, unknowns)
    autocorrelation: float  # longest of all unknowns [steps]
    steps: int
    points: int  # of the ensemble
    accepted: float  # share of the steps

    @property
    def independent(self) -> float:
        """Draws that are worth as much if they were independent."""
        return self.points * (self.steps - BURN * self.autocorrelation) / self.autocorrelation


def posterior_sample(
    fit: ImpactFit, *, seed: int, count: int, progress: Progress = silent
) -> PosteriorSample:
    """Draws of the posterior of an impact.

    Args:
        fit: Of the impact; the ensemble begins as its normal approximation.
        seed: Of the draws.
        count: Draws wanted, and as many independent ones at least.
        progress: Called from time to time with the share done.

    Raises:
        InputError: If emcee is not installed, or the chain is too short after `MOST` steps.
    """
    emcee = needs("emcee", "mcmc")
    generator, numbers = stream(seed, Purpose.SCATTER), len(fit.point)
    points = max(EACH * numbers + EACH * numbers % 2, FEWEST)

    def density(u: Array) -> Array:
        squares = (fit.problem(np.clip(u, -FARTHEST, FARTHEST)) ** 2).sum(axis=1)
        outside: Any = (np.abs(u) > FARTHEST).any(axis=1) | ~np.isfinite(squares)
        return np.where(outside, -np.inf, -0.5 * squares)

    half = np.linalg.cholesky(fit.covariance)
    begin, bad = np.empty((points, numbers)), np.ones(points, dtype=bool)
    for _ in range(TRIES):
        begin[bad] = fit.point + generator.standard_normal((int(bad.sum()), numbers)) @ half.T
        bad = ~np.isfinite(density(begin))
        if not bad.any():
            break
    else:
        raise InputError(f'method: "emcee" finds too few points of {fit.name} that can be flown')
    # Differences alone, at times a whole one, from mode to mode; emcee 3.1.6's snooker move draws
    # variances of 0.6 of a normal distribution's.
    moves = [(emcee.moves.DEMove(), 0.9), (emcee.moves.DEMove(gamma0=1.0), 0.1)]
    sampler = emcee.EnsembleSampler(points, numbers, density, vectorize=True, moves=moves)
    words = generator.integers(0, 2**32, WORDS, dtype=np.uint32)
    sampler.random_state = ("MT19937", words, WORDS, 0, 0.0)  # it takes no other generator
    state: Any = begin
    for steps in range(BLOCK, MOST + 1, BLOCK):
        state = sampler.run_mcmc(state, BLOCK, skip_initial_state_check=True)
        time = float(np.max(sampler.get_autocorr_time(tol=0)))
        found = PosteriorSample(
            begin, time, steps, points, float(np.mean(sampler.acceptance_fraction))
        )
        progress(min(steps / (LONG * time), 0.99) if np.isfinite(time) else 0.0)
        if np.isfinite(time) and steps >= LONG * time and found.independent >= count:
            break
    else:
        raise InputError(
            f'method: "emcee" needs longer than {MOST} steps for {fit.name}: the longest time of '
            f"autocorrelation is {time:.0f} steps, accepted {found.accepted:.0%}; fewer unknowns, "
            'or "laplace", take less'
        )
    chain = sampler.get_chain(discard=int(BURN * time), flat=True)
    drawn = np.asarray(chain[np.linspace(0, len(chain) - 1, count).astype(int)], dtype=float)
    return found._replace(draws=drawn)

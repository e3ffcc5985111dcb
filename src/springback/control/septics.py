"""Polynomials of degree 7: many along a line with their demands, and several in turn.

A polynomial is linear in its values and derivatives at both ends, so those of all candidates of a
search follow from one small matrix.
"""

from __future__ import annotations

import functools
import math
from typing import Any, NamedTuple

import numpy as np
from numpy.polynomial.polynomial import polyder, polyval

from springback.control.demands import Array, Limits, Times

#: Position, velocity, acceleration and jerk along the path [m, m/s, m/s², m/s³].
Row = tuple[float, float, float, float]


class LineMotions(NamedTuple):
    """Motions along a line, one per column, at equally spaced samples from first to last."""

    velocity: Array  # [m/s], shape (samples, courses)
    acceleration: Array  # [m/s²]
    jerk: Array  # [m/s³]


@functools.cache
def _basis() -> Array:
    """Coefficients in ascending powers per value and derivative at either end, shape (8, 8).

    The time is normalised to one.  Divided by k!, the derivatives of order k at the end are
    binomial coefficients, a matrix whose inverse is of integers: rounded, it is exact.
    """
    powers, orders = np.arange(8), np.arange(4)
    at_end = np.array([[math.comb(n, k) for n in powers] for k in orders], dtype=float)
    inverse = np.round(np.linalg.inv(np.concatenate([np.eye(8)[:4], at_end])))
    factorials = np.array([math.factorial(k) for k in orders], dtype=float)
    return np.asarray(inverse / np.tile(factorials, 2))


@functools.cache
def _responses(samples: int) -> Array:
    """Derivatives 1 to 3 per value and derivative at either end, shape (3, samples, 8).

    The time is normalised to one.
    """
    at = np.linspace(0.0, 1.0, samples)
    return np.stack([polyval(at, polyder(_basis(), order)).T for order in (1, 2, 3)])


class SplineCurve:
    """Polynomials of degree 7 in turn, with three continuous derivatives.

    A `springback.control.demands.DifferentiableCurve`.

    Args:
        breaks: Times at which one ends and the next begins [s], increasing.
        rows: Position and derivatives 1 to 3 at each, shape (breaks, 4, 3).
    """

    def __init__(self, breaks: Times, rows: Array) -> None:
        """Divide at ``breaks``."""
        self._breaks = np.asarray(breaks, dtype=float)
        durations = np.diff(self._breaks)
        unit = durations[:, None, None] ** np.arange(8.0)[:, None]  # powers of each duration
        ends = np.concatenate([rows[:-1] * unit[:, :4], rows[1:] * unit[:, :4]], axis=1)
        self._coefficients = np.moveaxis(_basis() @ ends / unit, 1, 0)  # (8, durations, 3)

    def __call__(self, x: Any, nu: int = 0) -> Array:
        """Derivative of order ``nu`` at times ``x`` [s], shape (..., 3)."""
        t = np.asarray(x, dtype=float)
        k = np.searchsorted(self._breaks[1:-1], t, side="right")
        since = (t - self._breaks[k])[..., None]
        found = polyval(since, polyder(self._coefficients, nu)[:, k], tensor=False)
        return np.asarray(found)


def septics(first: Array, last: Array, durations: Array, samples: int) -> LineMotions:
    """The polynomials of degree 7 between rows.

    Args:
        first: Rows, shape (4, n) or (4, 1).
        last: Rows, as above.
        durations: Duration of each, shape (n,) [s].
        samples: Number of samples.
    """
    powers = durations ** np.arange(4.0)[:, None]
    ends = np.concatenate([first * powers, last * powers])
    v, a, j = _responses(samples) @ ends
    return LineMotions(v / powers[1], a / powers[2], j / powers[3])


def shares(courses: LineMotions, limits: Limits) -> Array:
    """Largest share of a limit in level flight along each course, shape (courses,).

    The limits are those of `springback.control.demands.level_demands`.
    """
    a, g, weight = courses.acceleration, limits.gravity, limits.mass * limits.gravity
    tilt = np.arctan2(np.abs(a).max(axis=0), g)
    rate = np.abs(g * courses.jerk / (g * g + np.square(a))).max(axis=0)
    thrust = weight / np.cos(tilt) / limits.max_thrust
    least = limits.min_thrust / max(weight, 1e-12)
    used = np.maximum(np.maximum(thrust, least), tilt / limits.max_tilt)
    return np.asarray(np.maximum(used, rate / limits.max_body_rate))

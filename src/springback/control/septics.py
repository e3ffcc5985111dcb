"""Many polynomials of degree 7 along a line, and the demands of level flight along them.

A polynomial is linear in its values and derivatives at both ends, so those of all candidates of a
search follow from one small matrix.
"""

from __future__ import annotations

import functools
from typing import NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.control.demands import Array, Limits

#: Position, velocity, acceleration and jerk along the path [m, m/s, m/s², m/s³].
Row = tuple[float, float, float, float]


class LineMotions(NamedTuple):
    """Motions along a line, one per column, at equally spaced samples from first to last."""

    velocity: Array  # [m/s], shape (samples, courses)
    acceleration: Array  # [m/s²]
    jerk: Array  # [m/s³]


@functools.cache
def _responses(samples: int) -> Array:
    """Derivatives 1 to 3 per value and derivative at either end, shape (3, samples, 8).

    The time is normalised to one.
    """
    ends = np.eye(8).reshape(2, 4, 8)
    curve = scipy.interpolate.BPoly.from_derivatives([0.0, 1.0], [ends[0], ends[1]])
    at = np.linspace(0.0, 1.0, samples)
    return np.stack([curve(at, order) for order in (1, 2, 3)])


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

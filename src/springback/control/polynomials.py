"""Polynomials through given points: the quintic and minimum snap.

The curve of least ∫ |d⁴x/dt⁴|² through way-points at given times is the spline of degree 7 with
knots there and six continuous derivatives (the natural Euler–Lagrange and corner conditions of that
integral), its first three derivatives clamped at both ends.  SciPy solves for splines as a banded
system in the B-spline basis, so no quadratic programme is needed.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.control.demands import (
    ROOM,
    Array,
    DifferentiableCurve,
    Limits,
    Times,
    demands,
    shortfalls,
)
from springback.control.references import Polynomials, Segment
from springback.control.target import target
from springback.errors import InputError
from springback.kernels.compiler import kernel
from springback.kernels.vectors import Vec

#: Degree of minimum-snap segments: the Euler–Lagrange equation of snap is d⁸x/dt⁸ = 0.
DEGREE = 7
#: Range of total durations [s] in which the shortest within limits is searched, chosen.
SHORTEST, LONGEST = 1e-2, 1e3
#: Numbers of segments of references: one that has fewer is filled up, as each number is compiled.
#: The first is enough for every run-up (`springback.control.approach.KNOTS`).
LENGTHS = (12, 24, 48, 100)


class BoundaryCondition(NamedTuple):
    """A boundary condition."""

    position: Vec  # [m]
    velocity: Vec  # [m/s]
    acceleration: Vec  # [m/s²]


@kernel
def quintic(
    start: BoundaryCondition, end: BoundaryCondition, duration: float, begins: float, yaw: float
) -> Polynomials:
    """Polynomial of degree five between two motions, with the least ∫ |jerk|².

    Closed form of the 6 × 6 system of its boundary conditions (Flash and Hogan, J. Neurosci. 5,
    1985, for rest to rest).  A kernel, so that it can be computed in flight.

    Args:
        start: Motion at ``begins``, world axes.
        end: Motion ``duration`` later.
        duration: T > 0 [s].
        begins: Start time [s].
        yaw: Constant [rad].
    """
    T = duration
    x = end.position - start.position - T * start.velocity - (0.5 * T * T) * start.acceleration
    v = T * (end.velocity - start.velocity) - (T * T) * start.acceleration
    a = (T * T) * (end.acceleration - start.acceleration)
    cube = 1.0 / (T * T * T)
    c3 = cube * (10.0 * x - 4.0 * v + 0.5 * a)
    c4 = (cube / T) * (7.0 * v - 15.0 * x - a)
    c5 = (cube / (T * T)) * (6.0 * x - 3.0 * v + 0.5 * a)
    coefficients = (c5, c4, c3, 0.5 * start.acceleration, start.velocity, start.position)
    return Polynomials((Segment(0.0, coefficients),), begins, T, yaw)


def as_reference(
    curve: DifferentiableCurve, breaks: Times, yaw: float = 0.0, begins: float = 0.0
) -> Polynomials:
    """A piecewise polynomial of degree 7 or less as a reference, by its Taylor coefficients.

    Args:
        curve: The curve, from ``breaks[0]`` to ``breaks[-1]``.
        breaks: Times between which it is a polynomial [s], increasing.
        yaw: Constant [rad].
        begins: Start time of the reference [s].
    """
    at = np.asarray(breaks[:-1], dtype=float)
    orders = range(DEGREE, -1, -1)
    rows = np.stack([curve(at, k) / math.factorial(k) for k in orders], axis=1)
    segments = tuple(
        Segment(float(t - breaks[0]), tuple(Vec(*map(float, c)) for c in row))
        for t, row in zip(at, rows, strict=True)
    )
    return Polynomials(segments, begins, float(breaks[-1] - breaks[0]), yaw)


def padded_reference(reference: Polynomials) -> Polynomials:
    """The same reference with one of `LENGTHS` of segments; those added are at rest at its end.

    References of one length are of one type: flights that follow them are compiled once, and form
    a batch.
    """
    given = len(reference.segments)
    short = next((length for length in LENGTHS if length >= given), given) - given
    end, still = target(reference, reference.begins + reference.duration), Vec(0.0, 0.0, 0.0)
    resting = (*(still for _ in reference.segments[0].coefficients[1:]), end.position)
    more = (Segment(reference.duration, resting),) * short
    return reference._replace(segments=(*reference.segments, *more))


def set_points(positions: Sequence[Vec], dwell: float = 0.0, yaw: float = 0.0) -> Polynomials:
    """Set-points in sequence, with jumps between them: polynomials that are constant.

    Few are of the type of a run-up; many, of one coefficient each, would be needlessly large so.

    Args:
        positions: At least one, world [m]; the first applies from the beginning.
        dwell: Time at each but the last [s].
        yaw: Constant [rad].
    """
    none = Vec(0.0, 0.0, 0.0)
    powers = (none,) * (DEGREE if len(positions) <= LENGTHS[0] else 0)
    segments = tuple(Segment(k * dwell, (*powers, Vec(*p))) for k, p in enumerate(positions))
    return padded_reference(Polynomials(segments, 0.0, segments[-1].begins, yaw))


# -- minimum snap ---------------------------------------------------------------------------------


def snap_spline(times: Times, points: Array, ends: Array | None = None) -> DifferentiableCurve:
    """Curve of least ∫ |snap|² through points at given times.

    Mellinger and Kumar, "Minimum snap trajectory generation and control for quadrotors", ICRA 2011,
    state the problem as a quadratic programme; this is its solution.

    Args:
        times: Increasing, one for each point [s].
        points: Shape (n,) or (n, 3), n ≥ 2 [m].
        ends: Velocity, acceleration and jerk at start and end, shape (2, 3) or (2, 3, 3); at rest
            by default.
    """
    ends = np.zeros((2, 3, *points.shape[1:])) if ends is None else ends
    clamped: Any = [[(k + 1, end[k]) for k in range(3)] for end in ends]
    spline = scipy.interpolate.make_interp_spline
    curve: DifferentiableCurve = spline(np.asarray(times), points, k=DEGREE, bc_type=clamped)
    return curve


def snap_cost(curve: DifferentiableCurve, breaks: Times) -> float:
    """Cost ∫ |snap|² dt of a piecewise polynomial of degree 7 [m²/s⁷], exact by Gauss's rule."""
    nodes, weights = np.polynomial.legendre.leggauss(DEGREE - 3)
    t, h = np.asarray(breaks[:-1], dtype=float), np.diff(breaks)
    at = t[:, None] + 0.5 * h[:, None] * (nodes + 1.0)
    squares = np.sum(np.square(curve(at, 4)), axis=-1)
    return float(np.sum(0.5 * h[:, None] * weights * squares))


def waypoint_times(points: Array, duration: float) -> Array:
    """Times at the way-points that minimise snap, for a flight from rest to rest.

    The total is fixed and its parts are optimised, as Mellinger and Kumar 2011 do, starting in
    proportion to the distances.

    Args:
        points: Shape (n, 3), neighbours distinct [m].
        duration: Total [s].

    Returns:
        n times from 0 to ``duration`` [s].
    """
    lengths = np.linalg.norm(np.diff(points, axis=0), axis=1)

    def times(logarithms: Array) -> Array:
        parts = np.exp(logarithms - logarithms.max())
        return np.concatenate([[0.0], np.cumsum(parts / parts.sum())])

    def cost(logarithms: Array) -> float:  # snap scales with total⁻⁷, so a total of 1 s suffices
        breaks = times(logarithms)
        return math.log(snap_cost(snap_spline(breaks, points), breaks))

    # Parts below 1/e³ or above e³ of the first guess would make the spline ill-conditioned.
    first = np.log(lengths)
    best = scipy.optimize.minimize(cost, first, bounds=[(x - 3.0, x + 3.0) for x in first]).x
    return np.asarray(times(best) * duration)


def through(
    points: Sequence[Sequence[float]],
    limits: Limits,
    times: Sequence[float] | None = None,
    duration: float | None = None,
    yaw: float = 0.0,
    begins: float = 0.0,
) -> Polynomials:
    """Minimum-snap reference through way-points, from rest to rest.

    Args:
        points: At least two, neighbours distinct, world [m].
        limits: Limits of the vehicle.
        times: At each point, from 0 [s]; optimised by default.
        duration: Total, if no times are given [s]; by default the shortest that leaves
            `ROOM` below the limits.
        yaw: Constant [rad].
        begins: Start time [s].

    Raises:
        InputError: If the points or times are invalid, or a limit is exceeded, and by how much.
    """
    corners = np.asarray(points, dtype=float)
    if len(corners) < 2 or np.any(np.linalg.norm(np.diff(corners, axis=0), axis=1) == 0.0):
        raise InputError("way-points must be at least two, and neighbours distinct")
    if times is not None:
        breaks = np.asarray(times, dtype=float)
        if len(breaks) != len(corners) or breaks[0] != 0.0 or np.any(np.diff(breaks) <= 0.0):
            raise InputError("times of way-points must increase from 0 s, one for each point")
    elif duration is not None:
        breaks = waypoint_times(corners, duration)
    else:
        breaks = _shortest(corners, limits)
    curve = snap_spline(breaks, corners)
    asked = demands(curve, breaks, limits)
    if beyond := shortfalls(asked, limits, "the flight through way-points"):
        raise InputError(*beyond)
    return padded_reference(as_reference(curve, breaks, yaw, begins))


def _shortest(corners: Array, limits: Limits) -> Array:
    """Times at the way-points of the shortest flight that leaves `ROOM`, with optimal parts."""
    parts = waypoint_times(corners, 1.0)

    def share(duration: float) -> float:
        breaks = parts * duration
        asked = demands(snap_spline(breaks, corners), breaks, limits)
        return max(asked.uses(limits).values())

    at_hover = share(LONGEST)
    if at_hover >= 1.0:
        raise InputError("the flight through way-points exceeds the limits at any duration")
    room = max(ROOM, 0.5 * (1.0 + at_hover))
    logarithms = (math.log(SHORTEST), math.log(LONGEST))
    found = scipy.optimize.brentq(lambda x: share(math.exp(x)) - room, *logarithms, xtol=1e-10)
    return np.asarray(parts * math.exp(found))

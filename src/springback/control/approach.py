"""Search for the motion of a run-up from rest to the start of its steady phase."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.control.demands import (
    ROOM,
    Array,
    Demands,
    Limits,
    level_demands,
    shortfalls,
)
from springback.control.polynomials import snap_spline
from springback.control.septics import LineMotions, Row, septics, shares
from springback.errors import InputError

#: Free knots where the simplest run-up exceeds the limits.  Chosen: the hardest run-up of the paper
#: (-45°, 2 m/s) turns at 223, 206, 198, 195 deg/s with 4, 6, 8, 12.
KNOTS = 8
#: Samples over a run-up at which limits hold while its knots are moved, and at which it is
#: evaluated.
FEW, SAMPLES = 60, 640
#: Linear programmes per duration.  Chosen: the same run-up turns at 209, 198 deg/s with 2, 3.
ROUNDS = 3
#: Backward velocity, as a fraction of the final speed, that counts as rounding.
BACKWARDS = 1e-4
#: Largest distance tried when one is too short [m], chosen.
FARTHEST = 30.0

#: Shares that differ by less are equal: rounding.
ALIKE = 1.0 + 1e-9
REST: Row = (0.0, 0.0, 0.0, 0.0)


#: Demands of a plan that does not exist.
NONE = Demands(0.0, 0.0, 0.0, 0.0)


class RunUpPlan(NamedTuple):
    """Motion from rest to a row."""

    breaks: list[float]  # [s]
    rows: list[Row]  # one at each break
    asked: Demands
    share: float  # largest share of a limit; infinite for a motion that moves back


def _plan(course: LineMotions, breaks: list[float], rows: list[Row], limits: Limits) -> RunUpPlan:
    """A plan with its demands, from its only course."""
    asked = level_demands(course.acceleration, course.jerk, limits)
    share = max(asked.uses(limits).values())
    behind = float(course.velocity.min()) < -BACKWARDS * rows[-1][1]
    return RunUpPlan(breaks, rows, asked, math.inf if behind else share)


def approach(
    distance: float,
    speed: float,
    a: float,
    steady: float,
    limits: Limits,
    who: str,
    advises: bool = True,
) -> tuple[list[float], list[Row]]:
    """Breaks and rows from rest to contact, within the limits.

    Args:
        distance: From rest to contact [m].
        speed: At contact [m/s].
        a: Acceleration at contact [m/s²].
        steady: Time before contact in which the acceleration is a [s].
        limits: Limits of the vehicle.
        who: Subject of error messages.
        advises: If there is no such motion, find the distance from which on there is one; slow.

    Raises:
        InputError: If there is no such motion, with the reason.
    """
    at_contact = level_demands(a, 0.0, limits)
    if beyond := shortfalls(at_contact, limits, who):
        raise InputError(*beyond)
    if speed - a * steady <= 0.0:
        raise InputError(f"{who} can be steady for less than {speed / a:.3g} s (got {steady:g} s)")
    room = max(ROOM, *at_contact.uses(limits).values())

    def planned(length: float) -> RunUpPlan | None:
        place = length - speed * steady + 0.5 * a * steady**2  # start of the steady phase
        row = (place, speed - a * steady, a, 0.0)
        return _gentlest(row, limits, room) if place > 0.0 else None

    plan = planned(distance)
    if plan is None or plan.share > ALIKE:
        wanted = _advice(planned, distance) if advises else "more than"
        reason = _reason(plan, limits, f"within {distance:.3g} m it")
        raise InputError(f"{who} needs {wanted} the {distance:.3g} m it has; {reason}")
    if steady == 0.0:
        return [*plan.breaks], [*plan.rows]
    return [*plan.breaks, plan.breaks[-1] + steady], [*plan.rows, (distance, speed, a, 0.0)]


def _advice(planned: Callable[[float], RunUpPlan | None], distance: float) -> str:
    """Sufficient distance, in words."""
    needed = _least_distance(planned, distance)
    if needed == math.inf:
        return f"more than {max(FARTHEST, 2.0 * distance):.3g} m, if any suffices, instead of"
    return f"a distance of {needed:.3g} m, {needed - distance:.2g} m more than"


def _reason(plan: RunUpPlan | None, limits: Limits, who: str) -> str:
    """The worst shortfall of a plan."""
    if plan is None:
        return f"{who} has no room for the steady phase"
    if plan.share == math.inf:
        return f"{who} has to move back first"
    shares = plan.asked.uses(limits)
    worst = max(shares, key=lambda name: shares[name])
    return next(text for text in shortfalls(plan.asked, limits, who) if f"a {worst} of" in text)


def _least_distance(planned: Callable[[float], RunUpPlan | None], distance: float) -> float:
    """Distance [m] from which on a run-up is possible, to within 5 % above."""

    def fits(length: float) -> bool:
        plan = planned(length)
        return plan is not None and plan.share <= ALIKE

    low, high = distance, 1.6 * distance
    while not fits(high):
        low, high = high, 1.6 * high
        if high > max(FARTHEST, 2.0 * distance):
            return math.inf
    while high > 1.05 * low:
        middle = math.sqrt(low * high)
        low, high = (low, middle) if fits(middle) else (middle, high)
    return high


def _gentlest(end: Row, limits: Limits, room: float) -> RunUpPlan:
    """The simplest plan from rest to a row if it leaves room, else one with moved knots."""
    plan = _simplest(end, limits)
    return plan if plan.share <= room else _least([plan, _with_free_knots(end, plan, limits)])


def _simplest(end: Row, limits: Limits) -> RunUpPlan:
    """The single polynomial of degree 7 that uses the limits least and never moves back.

    Durations from 0.02 to 8 d/v are tried, d = end[0] and v = end[1], a wide range around the 2 d/v
    of constant acceleration; of several with equal shares, as where the pitch at the end dominates,
    it is the shortest.  If all move back, it is the one that moves back slowest.
    """
    durations = np.geomspace(0.02, 8.0, 150) * end[0] / end[1]
    first, last = np.zeros((4, 1)), np.array(end)[:, None]
    courses = septics(first, last, durations, FEW)
    back = np.maximum(0.0, -courses.velocity.min(axis=0) - BACKWARDS * end[1])
    share = np.where(back == back.min(), shares(courses, limits), np.inf)
    best = durations[np.argmax(share <= ALIKE * share.min())]
    chosen = septics(first, last, np.array([best]), SAMPLES)
    return _plan(chosen, [0.0, float(best)], [REST, end], limits)


@functools.cache
def _responses(samples: int) -> Array:
    """Derivatives 0 to 3 at samples per position at the knots, and per final v and a.

    The spline is linear in these, here over unit time; shape (4, samples, KNOTS + 4).
    """
    unit = np.eye(KNOTS + 4)
    points, ends = unit[: KNOTS + 2], np.zeros((2, 3, KNOTS + 4))
    ends[1, :2] = unit[KNOTS + 2 :]
    knots = np.linspace(0.0, 1.0, KNOTS + 2)
    spline = snap_spline(knots, points, ends)
    return np.stack([spline(np.linspace(0.0, 1.0, samples), k) for k in range(4)])


def _least(plans: Iterable[RunUpPlan]) -> RunUpPlan:
    """The plan that uses the limits least, and of several with equal shares the first."""
    known = [*plans]
    most = ALIKE * min(plan.share for plan in known)
    return next(plan for plan in known if plan.share <= most)


def _with_free_knots(end: Row, simplest: RunUpPlan, limits: Limits) -> RunUpPlan:
    """The spline of degree 7 from rest that uses the limits least, with knots free to move.

    Durations around that of the simplest plan are tried, and then a finer grid around the best.
    """

    def best(stretches: Array, centre: float) -> RunUpPlan:
        durations = [float(centre * stretch) for stretch in stretches]
        return _least(_spline_plan(end, T, limits) for T in durations)

    coarse = best(np.geomspace(0.5, 2.5, 10), simplest.breaks[-1])
    return _least([coarse, best(np.geomspace(0.92, 1.08, 4), coarse.breaks[-1])])


def _spline_plan(end: Row, duration: float, limits: Limits) -> RunUpPlan:
    """Best positions at the knots for one duration, by linear programmes.

    Minimise the share s with |a| ≤ s a_max, |ȧ| ≤ s ω_max (g² + a²)/g and v ≥ 0 at all samples.
    The a² on the right is from the previous solution, initially zero, which is conservative.
    """
    T, g = duration, limits.gravity
    _, v, a, j = _responses(FEW) / T ** np.arange(4.0)[:, None, None]
    fixed = np.zeros(KNOTS + 4)
    fixed[KNOTS + 1 :] = end[0], end[1] * T, end[2] * T**2
    free = slice(1, KNOTS + 1)
    strongest = math.acos(min(1.0, limits.mass * g / limits.max_thrust))
    most = np.full(FEW, g * math.tan(min(limits.max_tilt, strongest)))
    square, plans = np.zeros(FEW), []
    for _ in range(ROUNDS):
        turning = limits.max_body_rate * (g * g + square) / g
        sides = ((j, 1.0, turning), (j, -1.0, turning), (a, 1.0, most), (a, -1.0, most))
        bounds = [(sign * m[:, free], -share, -sign * m @ fixed) for m, sign, share in sides]
        bounds.append((-v[:, free], np.zeros(FEW), v @ fixed))
        left = np.concatenate([np.column_stack([m, share]) for m, share, _ in bounds])
        right = np.concatenate([right for _, _, right in bounds])
        cost = np.append(np.zeros(KNOTS), 1.0)
        found = scipy.optimize.linprog(cost, A_ub=left, b_ub=right, bounds=(None, None)).x
        if found is None:
            break
        plans.append(_plan_of_spline(T, found[:-1], end, limits))
        square = np.square(a[:, free] @ found[:-1] + a @ fixed)
    return _least(plans) if plans else RunUpPlan([0.0, T], [REST, end], NONE, math.inf)


def _plan_of_spline(duration: float, places: Array, end: Row, limits: Limits) -> RunUpPlan:
    """The plan of a spline from rest with given positions at inner knots [m]."""
    T = duration
    given = np.concatenate([[0.0], places, [end[0], end[1] * T, end[2] * T**2]])
    units = T ** np.arange(4.0)[:, None]
    at_knots = (_responses(KNOTS + 2) @ given / units)[:, 1:-1]
    inner: list[Any] = [tuple(row) for row in at_knots.T.tolist()]
    _, v, a, j = _responses(SAMPLES) @ given / units
    breaks = np.linspace(0.0, T, KNOTS + 2).tolist()
    return _plan(LineMotions(v, a, j), breaks, [REST, *inner, end], limits)

"""The response to a collision: a reference away from the obstacle, or stages before it.

Its goal is p_r = p_c − δ f_c⁰, eq. (17) of the paper, with δ = L_c.  The way there is a type:
`Quintic`, `TimeOptimal` or `Staged`; a new one is a NamedTuple with `recovery_plan` registered.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from springback.control.polynomials import BoundaryCondition, quintic
from springback.control.references import Polynomials
from springback.control.target import Target, target
from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import select
from springback.kernels.vectors import Vec, norm
from springback.recovery.characterisation import Collision
from springback.sensing.measurement import Estimate


class Quintic(NamedTuple):
    """A quintic to rest at p_r.

    With the velocity before the collision it begins at p_c, as if there were no wall; with the
    velocity after it, at the present position.  With neither and no duration it is a set-point.
    """

    before: float  # weight of the velocity before the collision, 1 or 0
    after: float  # weight of the present estimated velocity, 1 or 0
    pace: float  # duration per speed before the collision [s²/m]
    shortest: float  # least duration [s]


class TimeOptimal(NamedTuple):
    """The fastest motion from any state to rest at p_r with bounded acceleration."""

    across: float  # bound along X and along Y [m/s²]
    upwards: float  # bound along Z [m/s²]


class Staged(NamedTuple):
    """Tilt away, level out, stop climbing or falling, and only then hold a position.

    Source: Chui, Dicker and Sharf 2016, flight code: a reference acceleration of 0.75 g away from
    the obstacle in place of the fuzzy rules; a stage is over when its bounds hold.  The stages are
    theirs; attitude and rate loops are those of the robot.
    """

    away: float  # acceleration of the first stage [m/s²]
    damping: float  # of the vertical speed in the third [1/s]
    tilt: float  # tilt error below which the first stage is over [rad]
    level: float  # tilt below which the second is over [rad]
    rate: float  # angular rate below which either is over [rad/s]
    climb: float  # vertical speed below which the third is over [m/s]


class Rush(NamedTuple):
    """The fastest motion of one coordinate: full acceleration, then full braking."""

    start: float  # [m]
    speed: float  # at the start [m/s]
    push: float  # acceleration of the first part, with its sign [m/s²]
    switch: float  # its duration [s]
    brake: float  # duration of the second part [s]
    goal: float  # [m]


class Dash(NamedTuple):
    """A reference of three rushes, at rest at its goal afterwards."""

    x: Rush
    y: Rush
    z: Rush
    begins: float  # [s]
    yaw: float  # [rad]


class DashCoordinate(NamedTuple):
    """One coordinate at one time."""

    value: float
    rate: float
    second: float


# -- the fastest motion ---------------------------------------------------------------------------


@kernel
def rush(start: float, speed: float, goal: float, most: float) -> Rush:
    """Time-optimal motion from any speed to rest with an acceleration of at most a: bang-bang.

    The textbook solution of the double integrator (Pontryagin et al. 1962): the sign σ of the first
    part is that of the distance that is left after braking at once, d − v|v|/(2a); it ends at the
    speed w with w² = σ a d + v²/2.
    """
    a = most
    missing = goal - start - speed * math.fabs(speed) / (2.0 * a)
    sign = select(missing > 0.0, 1.0, -1.0)
    square = sign * a * (goal - start) + 0.5 * speed * speed
    top = sign * math.sqrt(select(square > 0.0, square, 0.0))
    raw = (top - speed) / (sign * a)
    return Rush(start, speed, sign * a, select(raw > 0.0, raw, 0.0), math.fabs(top) / a, goal)


@kernel
def _coordinate(way: Rush, elapsed: float) -> DashCoordinate:
    first = select(elapsed < way.switch, elapsed, way.switch)
    p = way.start + first * (way.speed + 0.5 * way.push * first)
    v = way.speed + way.push * first
    second = select(elapsed > way.switch, elapsed - way.switch, 0.0)
    over = second >= way.brake
    ends = DashCoordinate(way.goal, 0.0, 0.0)
    braking = select(elapsed > way.switch, -way.push, way.push)
    under_way = DashCoordinate(
        p + second * (v - 0.5 * way.push * second), v - way.push * second, braking
    )
    return select(over, ends, under_way)


@target.register(Dash)
@kernel
def _dash(reference: Dash, time: float) -> Target:
    since = time - reference.begins
    elapsed = select(since > 0.0, since, 0.0)
    x, y = _coordinate(reference.x, elapsed), _coordinate(reference.y, elapsed)
    z = _coordinate(reference.z, elapsed)
    return Target(
        Vec(x.value, y.value, z.value),
        Vec(x.rate, y.rate, z.rate),
        Vec(x.second, y.second, z.second),
        Vec(0.0, 0.0, 0.0),
        reference.yaw,
        0.0,
    )


@kernel
def _length(way: Rush) -> float:
    return way.switch + way.brake


# -- plans ----------------------------------------------------------------------------------------


class RecoveryPlan(NamedTuple):
    """A reference, and its end."""

    reference: Any
    ends: float  # [s]


@generic
def recovery_plan(
    response: Any, hit: Collision, goal: Vec, at: Estimate, time: float, yaw: float
) -> RecoveryPlan:
    """Reference from a collision to a goal.

    Args:
        response: Settings, on whose type it dispatches.
        hit: The collision.
        goal: p_r, world [m].
        at: Present estimate.
        time: [s].
        yaw: Yaw to hold [rad].
    """
    raise TypeError(f"{type(response).__name__} is not a response; register recovery_plan for it")


@recovery_plan.register(Quintic)
@kernel
def _quintic(
    response: Quintic, hit: Collision, goal: Vec, at: Estimate, time: float, yaw: float
) -> RecoveryPlan:
    still = Vec(0.0, 0.0, 0.0)
    late = response.after > 0.5
    velocity = hit.velocity * response.before + at.velocity * response.after
    start = BoundaryCondition(select(late, at.position, hit.position), velocity, still)
    wanted = response.pace * norm(hit.velocity)
    duration = select(wanted > response.shortest, wanted, response.shortest)
    return RecoveryPlan(
        quintic(start, BoundaryCondition(goal, still, still), duration, time, yaw), time + duration
    )


@recovery_plan.register(TimeOptimal)
@kernel
def _time_optimal(
    response: TimeOptimal, hit: Collision, goal: Vec, at: Estimate, time: float, yaw: float
) -> RecoveryPlan:
    p, v = at.position, at.velocity
    x = rush(p.x, v.x, goal.x, response.across)
    y = rush(p.y, v.y, goal.y, response.across)
    z = rush(p.z, v.z, goal.z, response.upwards)
    last = select(_length(x) > _length(y), _length(x), _length(y))
    last = select(_length(z) > last, _length(z), last)
    return RecoveryPlan(Dash(x, y, z, time, yaw), time + last)


@recovery_plan.register(Staged)
@kernel
def _staged(
    response: Staged, hit: Collision, goal: Vec, at: Estimate, time: float, yaw: float
) -> RecoveryPlan:
    """Hold the present position; the stages come first (`springback.recovery.stages`)."""
    still = Vec(0.0, 0.0, 0.0)
    here = BoundaryCondition(at.position, still, still)
    return RecoveryPlan(quintic(here, here, SHORTEST, time, yaw), time)


#: Duration of a motion without a distance [s], chosen: one tick.
SHORTEST = 1e-3


@kernel
def homeward(here: Vec, home: Vec, speed: float, time: float, yaw: float) -> RecoveryPlan:
    """A quintic from rest to rest with a given largest speed, which is 15/8 of the mean.

    Args:
        here: Start [m].
        home: End [m].
        speed: Largest speed [m/s].
        time: Start time [s].
        yaw: Yaw to hold [rad].
    """
    still = Vec(0.0, 0.0, 0.0)
    wanted = 1.875 * norm(home - here) / speed
    duration = select(wanted > SHORTEST, wanted, SHORTEST)
    way: Polynomials = quintic(
        BoundaryCondition(here, still, still),
        BoundaryCondition(home, still, still),
        duration,
        time,
        yaw,
    )
    return RecoveryPlan(way, time + duration)

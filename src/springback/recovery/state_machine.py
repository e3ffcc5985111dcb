"""Where a robot stands between one run-up and the next: its legs, and what ends each.

CRUISE until the alarm, LOOK until the collision is made out, then STAGES (where a response has
them), RECOVER until the robot has come to rest at p_r, RETURN to the start, HOVER there; and
again, as often as runs are asked for.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.control.references import Polynomials
from springback.control.target import Target, target
from springback.kernels.compiler import generic, kernel
from springback.kernels.memo import Make, afresh
from springback.kernels.trees import pick
from springback.kernels.vectors import Quat, Vec
from springback.recovery.characterisation import Collision
from springback.recovery.response import Plan, Staged, homeward, planned
from springback.recovery.stages import OVER, TILTING
from springback.sensing.measurement import Estimate

CRUISE, LOOK, STAGES, RECOVER, RETURN, HOVER = 0.0, 1.0, 2.0, 3.0, 4.0, 5.0
LEGS = ("cruise", "look", "stages", "recover", "return", "hover")
NEVER = -1.0


class Route(NamedTuple):
    """Settings of a journey."""

    response: Any  # Quintic, TimeOptimal, Staged
    distance: float  # δ = L_c, from p_c to p_r [m]
    tolerance: float  # it has settled this near its goal [m], ...
    slow: float  # this slow [m/s], ...
    dwell: float  # for so long [s]
    patience: float  # and is taken to have settled after so long anyway [s]
    returns: float  # 1: fly back to the start; 0: stay at p_r
    home: Vec  # where the runs begin [m]
    speed: float  # largest on the way home [m/s]
    runs: float  # collisions to make


class Log(NamedTuple):
    """When things happened on the last run, by the robot's own belief [s]; `NEVER` if not yet."""

    alarm: float
    planned: float
    settled: float
    home: float
    runs: float  # that have come home, all in all


class Journey(NamedTuple):
    """Where the robot stands."""

    leg: float
    since: float  # [s]
    stage: float  # of a staged response
    away: float  # the run-up began then [s]
    recovery: Any
    homeward: Polynomials
    ends: float  # of the way of this leg [s]
    goal: Vec  # of this leg [m]
    near: float  # the goal is near since then [s], `NEVER` if it is not
    log: Log


class Departed(NamedTuple):
    """A run-up that began at some time."""

    cruise: Any
    away: float  # [s]


class Calm(NamedTuple):
    """A way after a collision, without jerk.

    The paper's controller is given p, v, a and yaw, and the robot is then too far from its way for
    the way's angular velocities to be of use.
    """

    way: Any


@target.register(Departed)
@kernel
def _departed(reference: Departed, time: float) -> Target:
    return target(reference.cruise, time - reference.away)


@target.register(Calm)
@kernel
def _calm(reference: Calm, time: float) -> Target:
    now, still = target(reference.way, time), Vec(0.0, 0.0, 0.0)
    return Target(now.position, now.velocity, now.acceleration, still, now.yaw, 0.0)


def journey_at_start(route: Route, nothing: Collision, make: Make = afresh) -> Journey:
    """Before the first run-up.

    Args:
        route: Settings.
        nothing: A collision that has not happened.
        make: How parts are made.
    """
    away, homewards = make(_no_ways, route.response, route.speed, nothing)
    log = Log(NEVER, NEVER, NEVER, NEVER, 0.0)
    return Journey(CRUISE, 0.0, TILTING, 0.0, away, homewards, 0.0, route.home, NEVER, log)


def _no_ways(response: Any, speed: float, nothing: Collision) -> tuple[Any, Polynomials]:
    """What stands for the ways that are not planned yet: nobody flies them, from here to here."""
    here = Vec(0.0, 0.0, 0.0)
    still = Estimate(here, Quat(1.0, 0.0, 0.0, 0.0), here, here)
    plan = planned(response, nothing, here, still, 0.0, 0.0)
    return plan.reference, homeward(here, here, speed, 0.0, 0.0).reference


@generic
def _first_leg(response: Any) -> float:
    """The leg after looking."""
    return RECOVER


@_first_leg.register(object)
@kernel
def _(response: Any) -> float:
    return RECOVER


@_first_leg.register(Staged)
@kernel
def _stages_first(response: Staged) -> float:
    return STAGES


@kernel
def struck(journey: Journey, time: float) -> Journey:
    """The alarm: look."""
    j = journey
    log = Log(time, NEVER, NEVER, NEVER, j.log.runs)
    return Journey(LOOK, time, TILTING, j.away, j.recovery, j.homeward, time, j.goal, NEVER, log)


@kernel
def leaving(
    route: Route, journey: Journey, hit: Collision, at: Estimate, time: float, yaw: float
) -> Journey:
    """The collision is made out: p_r = p_c − δ f_c⁰, and a way there."""
    j = journey
    goal = hit.position - hit.direction * route.distance
    plan: Plan = planned(route.response, hit, goal, at, time, yaw)
    log = Log(j.log.alarm, time, NEVER, NEVER, j.log.runs)
    leg = _first_leg(route.response)
    return Journey(
        leg, time, TILTING, j.away, plan.reference, j.homeward, plan.ends, goal, NEVER, log
    )


@kernel
def _levelled(
    route: Route, journey: Journey, hit: Collision, at: Estimate, time: float, yaw: float
) -> Journey:
    """The stages are over: stay here."""
    j = journey
    plan: Plan = planned(route.response, hit, at.position, at, time, yaw)
    return Journey(
        RECOVER, time, OVER, j.away, plan.reference, j.homeward, time, at.position, NEVER, j.log
    )


@kernel
def _homewards(route: Route, journey: Journey, time: float, yaw: float) -> Journey:
    """Settled at p_r: fly home, or stay."""
    j = journey
    goal = pick(route.returns > 0.5, route.home, j.goal)
    plan = homeward(j.goal, goal, route.speed, time, yaw)
    log = Log(j.log.alarm, j.log.planned, time, NEVER, j.log.runs)
    return Journey(
        RETURN, time, j.stage, j.away, j.recovery, plan.reference, plan.ends, goal, NEVER, log
    )


@kernel
def _at_home(route: Route, journey: Journey, time: float) -> Journey:
    """Settled at home: hover, or set out again."""
    j = journey
    runs = j.log.runs + 1.0
    again = runs < route.runs
    log = Log(j.log.alarm, j.log.planned, j.log.settled, time, runs)
    leg, away = pick(again, CRUISE, HOVER), pick(again, time, j.away)
    return Journey(leg, time, j.stage, away, j.recovery, j.homeward, j.ends, j.goal, NEVER, log)


@kernel
def _near_since(route: Route, journey: Journey, at: Estimate, time: float) -> float:
    """Since when the robot has been near its goal, and slow."""
    gap = at.position - journey.goal
    near = gap @ gap < route.tolerance * route.tolerance
    near &= at.velocity @ at.velocity < route.slow * route.slow
    began = pick(journey.near < 0.0, time, journey.near)
    return pick(near & (time >= journey.ends), began, NEVER)


class Passed(NamedTuple):
    """What a tick without an alarm does to a journey."""

    near: float  # the goal is near since then [s], `NEVER` if it is not
    turns: float  # 1 where the leg is over


@kernel
def passes(route: Route, journey: Journey, at: Estimate, time: float) -> Passed:
    """A tick without an alarm: is the robot near its goal, and is the leg over?"""
    j, since = journey, _near_since(route, journey, at, time)
    rested = (since >= 0.0) & (time - since >= route.dwell)
    weary = time - j.ends > route.patience
    levelled = (j.leg == STAGES) & (j.stage >= OVER)
    arrives = ((j.leg == RECOVER) | (j.leg == RETURN)) & (rested | weary)
    return Passed(since, pick(levelled | arrives, 1.0, 0.0))


@kernel
def turned(
    route: Route, journey: Journey, hit: Collision, at: Estimate, time: float, yaw: float
) -> Journey:
    """The journey where a leg is over (`passes`)."""
    if journey.leg == STAGES:
        return _levelled(route, journey, hit, at, time, yaw)
    if journey.leg == RECOVER:
        return _homewards(route, journey, time, yaw)
    return _at_home(route, journey, time)

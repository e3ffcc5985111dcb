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
from springback.kernels.memo import Build, plain_build
from springback.kernels.trees import replace, select
from springback.kernels.vectors import Quat, Vec
from springback.recovery.characterisation import Collision
from springback.recovery.response import RecoveryPlan, Staged, homeward, planned
from springback.recovery.stages import OVER, TILTING
from springback.sensing.measurement import Estimate

CRUISE, LOOK, STAGES, RECOVER, RETURN, HOVER = 0.0, 1.0, 2.0, 3.0, 4.0, 5.0
PHASES = ("cruise", "look", "stages", "recover", "return", "hover")
NOT_YET = -1.0


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
    """When things happened on the last run, by the robot's own belief [s]; `NOT_YET` if not yet."""

    alarm: float
    planned: float
    settled: float
    home: float
    runs: float  # that have come home, all in all


class RecoveryState(NamedTuple):
    """Where the robot stands."""

    phase: float
    since: float  # [s]
    stage: float  # of a staged response
    away: float  # the run-up began then [s]
    recovery: Any
    homeward: Polynomials
    ends: float  # of the way of this leg [s]
    goal: Vec  # of this leg [m]
    near: float  # the goal is near since then [s], `NOT_YET` if it is not
    log: Log


class Departed(NamedTuple):
    """A run-up that began at some time."""

    cruise: Any
    away: float  # [s]


class SmoothReturn(NamedTuple):
    """A way after a collision, without jerk.

    The paper's controller is given p, v, a and yaw, and the robot is then too far from its way for
    the way's angular velocities to be of use.
    """

    way: Any


@target.register(Departed)
@kernel
def _departed(reference: Departed, time: float) -> Target:
    return target(reference.cruise, time - reference.away)


@target.register(SmoothReturn)
@kernel
def _calm(reference: SmoothReturn, time: float) -> Target:
    now, still = target(reference.way, time), Vec(0.0, 0.0, 0.0)
    return Target(now.position, now.velocity, now.acceleration, still, now.yaw, 0.0)


def recovery_at_start(
    route: Route, nothing: Collision, build: Build = plain_build
) -> RecoveryState:
    """Before the first run-up.

    Args:
        route: Settings.
        nothing: A collision that has not happened.
        build: How parts are made.
    """
    away, homewards = build(_no_ways, route.response, route.speed, nothing)
    log = Log(NOT_YET, NOT_YET, NOT_YET, NOT_YET, 0.0)
    return RecoveryState(CRUISE, 0.0, TILTING, 0.0, away, homewards, 0.0, route.home, NOT_YET, log)


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
def on_alarm(recovery_state: RecoveryState, time: float) -> RecoveryState:
    """The alarm: look."""
    log = Log(time, NOT_YET, NOT_YET, NOT_YET, recovery_state.log.runs)
    return replace(
        recovery_state, phase=LOOK, since=time, stage=TILTING, ends=time, near=NOT_YET, log=log
    )


@kernel
def on_characterised(
    route: Route,
    recovery_state: RecoveryState,
    hit: Collision,
    at: Estimate,
    time: float,
    yaw: float,
) -> RecoveryState:
    """The collision is made out: p_r = p_c − δ f_c⁰, and a way there."""
    goal = hit.position - hit.direction * route.distance
    plan: RecoveryPlan = planned(route.response, hit, goal, at, time, yaw)
    log = replace(recovery_state.log, planned=time, settled=NOT_YET, home=NOT_YET)
    return replace(
        recovery_state, phase=_first_leg(route.response), since=time, stage=TILTING,
        recovery=plan.reference, ends=plan.ends, goal=goal, near=NOT_YET, log=log,
    )  # fmt: skip


@kernel
def _levelled(
    route: Route,
    recovery_state: RecoveryState,
    hit: Collision,
    at: Estimate,
    time: float,
    yaw: float,
) -> RecoveryState:
    """The stages are over: stay here."""
    plan: RecoveryPlan = planned(route.response, hit, at.position, at, time, yaw)
    return replace(
        recovery_state, phase=RECOVER, since=time, stage=OVER, recovery=plan.reference,
        ends=time, goal=at.position, near=NOT_YET,
    )  # fmt: skip


@kernel
def _homewards(
    route: Route, recovery_state: RecoveryState, time: float, yaw: float
) -> RecoveryState:
    """Settled at p_r: fly home, or stay."""
    j = recovery_state
    goal = select(route.returns > 0.5, route.home, j.goal)
    plan = homeward(j.goal, goal, route.speed, time, yaw)
    return replace(
        j, phase=RETURN, since=time, homeward=plan.reference, ends=plan.ends, goal=goal,
        near=NOT_YET, log=replace(j.log, settled=time, home=NOT_YET),
    )  # fmt: skip


@kernel
def _at_home(route: Route, recovery_state: RecoveryState, time: float) -> RecoveryState:
    """Settled at home: hover, or set out again."""
    runs = recovery_state.log.runs + 1.0
    again = runs < route.runs
    return replace(
        recovery_state,
        phase=select(again, CRUISE, HOVER),
        since=time,
        away=select(again, time, recovery_state.away),
        near=NOT_YET,
        log=replace(recovery_state.log, home=time, runs=runs),
    )


@kernel
def _near_since(route: Route, recovery_state: RecoveryState, at: Estimate, time: float) -> float:
    """Since when the robot has been near its goal, and slow."""
    gap = at.position - recovery_state.goal
    near = gap @ gap < route.tolerance * route.tolerance
    near &= at.velocity @ at.velocity < route.slow * route.slow
    began = select(recovery_state.near < 0.0, time, recovery_state.near)
    return select(near & (time >= recovery_state.ends), began, NOT_YET)


class PhaseEnd(NamedTuple):
    """What a tick without an alarm does to a journey."""

    near: float  # the goal is near since then [s], `NOT_YET` if it is not
    turns: float  # 1 where the leg is over


@kernel
def phase_end(route: Route, recovery_state: RecoveryState, at: Estimate, time: float) -> PhaseEnd:
    """A tick without an alarm: is the robot near its goal, and is the leg over?"""
    j, since = recovery_state, _near_since(route, recovery_state, at, time)
    rested = (since >= 0.0) & (time - since >= route.dwell)
    weary = time - j.ends > route.patience
    levelled = (j.phase == STAGES) & (j.stage >= OVER)
    arrives = ((j.phase == RECOVER) | (j.phase == RETURN)) & (rested | weary)
    return PhaseEnd(since, select(levelled | arrives, 1.0, 0.0))


@kernel
def on_phase_end(
    route: Route,
    recovery_state: RecoveryState,
    hit: Collision,
    at: Estimate,
    time: float,
    yaw: float,
) -> RecoveryState:
    """The journey where a leg is over (`phase_end`)."""
    if recovery_state.phase == STAGES:
        return _levelled(route, recovery_state, hit, at, time, yaw)
    if recovery_state.phase == RECOVER:
        return _homewards(route, recovery_state, time, yaw)
    return _at_home(route, recovery_state, time)

"""The state of a recovery: its phases, and the events that end them.

CRUISE until the alarm, LOOK until the collision is characterised, then STAGES (if the response has
them), RECOVER until the robot has come to rest at p_r, RETURN to the start, and from there the next
run, or HOVER after the last.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.control.references import Polynomials
from springback.control.target import Target, target
from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import replace, select
from springback.kernels.vectors import Quat, Vec
from springback.recovery.characterisation import Collision
from springback.recovery.response import RecoveryPlan, Staged, homeward, recovery_plan
from springback.recovery.stages import OVER, TILTING
from springback.sensing.measurement import Estimate

CRUISE, LOOK, STAGES, RECOVER, RETURN, HOVER = 0.0, 1.0, 2.0, 3.0, 4.0, 5.0
PHASES = ("cruise", "look", "stages", "recover", "return", "hover")
NOT_YET = -1.0


class Route(NamedTuple):
    """Settings of the recovery's phases."""

    response: Any  # Quintic, TimeOptimal, Staged
    distance: float  # δ = L_c, from p_c to p_r [m]
    tolerance: float  # a robot that has settled is within this distance of its goal [m] ...
    slow: float  # ... and slower than this [m/s] ...
    dwell: float  # ... for this time [s]
    patience: float  # time after the end of a reference when a phase ends anyway [s]
    returns: float  # 1: fly back to the start; 0: stay at p_r
    home: Vec  # start of the runs [m]
    speed: float  # largest speed of the return [m/s]
    runs: float  # number of collisions


class Log(NamedTuple):
    """Times of the last run's events by the robot's estimates [s]; `NOT_YET` before them."""

    alarm: float
    planned: float
    settled: float
    home: float
    runs: float  # number of runs that have returned


class RecoveryState(NamedTuple):
    """State of the recovery."""

    phase: float
    followed: float  # phase whose reference is flown: `phase`, or while LOOK that of the alarm
    phase_start: float  # [s]
    stage: float  # of a staged response
    run_start: float  # start of the run-up [s]
    recovery_reference: Any  # to p_r
    return_reference: Polynomials  # to the start
    reference_end: float  # [s]
    goal: Vec  # of this phase [m]
    near_since: float  # time since which the robot is near the goal and slow [s], or `NOT_YET`
    log: Log


class DelayedReference(NamedTuple):
    """A reference that begins at some time."""

    reference: Any
    start: float  # [s]


class JerkFreeReference(NamedTuple):
    """A reference after a collision, without its jerk.

    The paper's controller takes p, v, a and yaw, and after a collision the robot is too far from
    the reference for its angular velocity to be useful.
    """

    reference: Any


@target.register(DelayedReference)
@kernel
def _delayed(reference: DelayedReference, time: float) -> Target:
    return target(reference.reference, time - reference.start)


@target.register(JerkFreeReference)
@kernel
def _without_jerk(reference: JerkFreeReference, time: float) -> Target:
    now, still = target(reference.reference, time), Vec(0.0, 0.0, 0.0)
    return Target(now.position, now.velocity, now.acceleration, still, now.yaw, 0.0)


def recovery_at_start(route: Route, nothing: Collision) -> RecoveryState:
    """State before the first run-up.

    Args:
        route: Settings.
        nothing: A collision that has not happened.
    """
    back, home = _placeholder_references(route.response, route.speed, nothing)
    log = Log(NOT_YET, NOT_YET, NOT_YET, NOT_YET, 0.0)
    return RecoveryState(
        CRUISE, CRUISE, 0.0, TILTING, 0.0, back, home, 0.0, route.home, NOT_YET, log
    )


def _placeholder_references(
    response: Any, speed: float, nothing: Collision
) -> tuple[Any, Polynomials]:
    """Placeholders for the two references until they are planned; they stay at the origin."""
    here = Vec(0.0, 0.0, 0.0)
    still = Estimate(here, Quat(1.0, 0.0, 0.0, 0.0), here, here)
    plan = recovery_plan(response, nothing, here, still, 0.0, 0.0)
    return plan.reference, homeward(here, here, speed, 0.0, 0.0).reference


@generic
def _first_phase(response: Any) -> float:
    """The phase after LOOK."""
    return RECOVER


@_first_phase.register(object)
@kernel
def _(response: Any) -> float:
    return RECOVER


@_first_phase.register(Staged)
@kernel
def _stages_first(response: Staged) -> float:
    return STAGES


@kernel
def on_alarm(recovery_state: RecoveryState, time: float) -> RecoveryState:
    """State after an alarm: LOOK, on the reference of the phase before it."""
    log = Log(time, NOT_YET, NOT_YET, NOT_YET, recovery_state.log.runs)
    return replace(
        recovery_state,
        phase=LOOK,
        followed=recovery_state.phase,
        phase_start=time,
        stage=TILTING,
        reference_end=time,
        near_since=NOT_YET,
        log=log,
    )


@kernel
def on_characterisation(
    route: Route,
    recovery_state: RecoveryState,
    hit: Collision,
    at: Estimate,
    time: float,
    yaw: float,
) -> RecoveryState:
    """State after the characterisation: p_r = p_c − δ f_c⁰, and a reference to it."""
    goal = hit.position - hit.direction * route.distance
    plan: RecoveryPlan = recovery_plan(route.response, hit, goal, at, time, yaw)
    log = replace(recovery_state.log, planned=time, settled=NOT_YET, home=NOT_YET)
    return replace(
        recovery_state, phase=_first_phase(route.response), followed=_first_phase(route.response),
        phase_start=time, stage=TILTING, recovery_reference=plan.reference,
        reference_end=plan.ends, goal=goal, near_since=NOT_YET, log=log,
    )  # fmt: skip


@kernel
def _after_stages(
    route: Route,
    recovery_state: RecoveryState,
    hit: Collision,
    at: Estimate,
    time: float,
    yaw: float,
) -> RecoveryState:
    """State after the stages: stay here."""
    plan: RecoveryPlan = recovery_plan(route.response, hit, at.position, at, time, yaw)
    return replace(
        recovery_state, phase=RECOVER, followed=RECOVER, phase_start=time, stage=OVER,
        recovery_reference=plan.reference, reference_end=time, goal=at.position,
        near_since=NOT_YET,
    )  # fmt: skip


@kernel
def _after_recovery(
    route: Route, recovery_state: RecoveryState, time: float, yaw: float
) -> RecoveryState:
    """State after settling at p_r: fly home, or stay."""
    goal = select(route.returns > 0.5, route.home, recovery_state.goal)
    plan = homeward(recovery_state.goal, goal, route.speed, time, yaw)
    return replace(
        recovery_state, phase=RETURN, followed=RETURN, phase_start=time,
        return_reference=plan.reference, reference_end=plan.ends, goal=goal, near_since=NOT_YET,
        log=replace(recovery_state.log, settled=time, home=NOT_YET),
    )  # fmt: skip


@kernel
def _after_return(route: Route, recovery_state: RecoveryState, time: float) -> RecoveryState:
    """State after settling at home: the next run, or hover."""
    runs = recovery_state.log.runs + 1.0
    again = runs < route.runs
    return replace(
        recovery_state,
        phase=select(again, CRUISE, HOVER),
        followed=select(again, CRUISE, HOVER),
        phase_start=time,
        run_start=select(again, time, recovery_state.run_start),
        near_since=NOT_YET,
        log=replace(recovery_state.log, home=time, runs=runs),
    )


@kernel
def _near_since(route: Route, recovery_state: RecoveryState, at: Estimate, time: float) -> float:
    """Time since which the robot has been near its goal, and slow."""
    gap = at.position - recovery_state.goal
    near = gap @ gap < route.tolerance * route.tolerance
    near &= at.velocity @ at.velocity < route.slow * route.slow
    began = select(recovery_state.near_since < 0.0, time, recovery_state.near_since)
    return select(near & (time >= recovery_state.reference_end), began, NOT_YET)


class PhaseEnd(NamedTuple):
    """Effect of a tick without an alarm."""

    near_since: float  # as in `RecoveryState`
    is_over: float  # 1 if the phase is over


@kernel
def phase_end(route: Route, recovery_state: RecoveryState, at: Estimate, time: float) -> PhaseEnd:
    """Effect of a tick without an alarm: time near the goal, and end of the phase."""
    phase, since = recovery_state.phase, _near_since(route, recovery_state, at, time)
    rested = (since >= 0.0) & (time - since >= route.dwell)
    late = time - recovery_state.reference_end > route.patience
    staged = (phase == STAGES) & (recovery_state.stage >= OVER)
    arrives = ((phase == RECOVER) | (phase == RETURN)) & (rested | late)
    return PhaseEnd(since, select(staged | arrives, 1.0, 0.0))


@kernel
def on_phase_end(
    route: Route,
    recovery_state: RecoveryState,
    hit: Collision,
    at: Estimate,
    time: float,
    yaw: float,
) -> RecoveryState:
    """State at the end of a phase (`phase_end`)."""
    if recovery_state.phase == STAGES:
        return _after_stages(route, recovery_state, hit, at, time, yaw)
    if recovery_state.phase == RECOVER:
        return _after_recovery(route, recovery_state, time, yaw)
    return _after_return(route, recovery_state, time)

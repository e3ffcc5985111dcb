"""Legs of a journey: what ends each, and what it leaves behind."""

import math

import pytest

from springback.control.target import target
from springback.kernels.vectors import Quat, Vec
from springback.recovery.characterisation import Collision
from springback.recovery.parameters import RecoverySettings
from springback.recovery.stages import OVER
from springback.recovery.state_machine import (
    CRUISE,
    HOVER,
    LOOK,
    RECOVER,
    RETURN,
    STAGES,
    DelayedReference,
    JerkFreeReference,
    RecoveryState,
    on_alarm,
    on_characterisation,
    on_phase_end,
    phase_end,
    recovery_at_start,
)
from springback.sensing.measurement import Estimate

STILL, HOME = Vec(0.0, 0.0, 0.0), Vec(0.0, 0.0, 1.0)
SETTINGS = RecoverySettings()
ROUTE = SETTINGS.route(HOME)
WALL = Vec(math.cos(0.3), math.sin(0.3), 0.0)
HIT = Collision(
    Vec(2.5, 0.0, 1.0),
    Vec(2.0, 0.0, 0.0),
    WALL,
    STILL,
    STILL,
    STILL,
    STILL,
    STILL,
    (1.0, 0.0, 0.0, 0.0),
    60.0,
)


def at(position: Vec, velocity: Vec = STILL) -> Estimate:
    return Estimate(position, Quat(1.0, 0.0, 0.0, 0.0), velocity, STILL)


def begun() -> RecoveryState:
    return recovery_at_start(ROUTE, HIT)


def travelled(
    route, recovery_state: RecoveryState, hit, here: Estimate, time: float, yaw: float
) -> RecoveryState:
    """A tick without an alarm."""
    passed = phase_end(route, recovery_state, here, time)
    recovery_state = recovery_state._replace(near_since=passed.near_since)
    return (
        on_phase_end(route, recovery_state, hit, here, time, yaw)
        if passed.is_over
        else recovery_state
    )


def rested(
    recovery_state: RecoveryState, place: Vec, begins: float, ends: float, route=ROUTE
) -> RecoveryState:
    """Stay at a place, tick by tick."""
    ticks = round((ends - begins) / 0.01)
    for k in range(ticks + 1):
        recovery_state = travelled(route, recovery_state, HIT, at(place), begins + 0.01 * k, 0.0)
    return recovery_state


def test_it_cruises_until_the_alarm_whatever_time_it_is() -> None:
    assert rested(begun(), HOME, 0.0, 20.0).phase == CRUISE


def test_the_way_leads_to_a_point_before_the_obstacle() -> None:
    """p_r = p_c − δ f_c⁰, eq. (17), with δ = L_c = 0.1 m."""
    looking = on_alarm(begun(), 3.0)
    assert (looking.phase, looking.log.alarm) == (LOOK, 3.0)
    gone = on_characterisation(ROUTE, looking, HIT, at(HIT.position), 3.01, 0.0)
    assert gone.phase == RECOVER
    assert gone.goal == pytest.approx(HIT.position - WALL * 0.1)
    assert gone.log.planned == 3.01


def test_it_goes_home_once_it_has_rested_and_not_before() -> None:
    gone = on_characterisation(ROUTE, on_alarm(begun(), 3.0), HIT, at(HIT.position), 3.01, 0.0)
    near = gone.goal + Vec(0.05, 0.0, 0.0)
    stay = SETTINGS.settling.stay
    waiting = rested(gone, near, 3.01, gone.reference_end + stay - 0.05)
    assert waiting.phase == RECOVER
    homing = rested(gone, near, 3.01, gone.reference_end + stay + 0.05)
    assert (homing.phase, homing.goal) == (RETURN, HOME)
    hovering = rested(homing, HOME, homing.phase_start, homing.reference_end + stay + 0.05)
    assert hovering.phase == HOVER
    assert hovering.log.runs == 1.0


def test_moving_or_far_is_no_rest() -> None:
    gone = on_characterisation(ROUTE, on_alarm(begun(), 3.0), HIT, at(HIT.position), 3.01, 0.0)
    far = gone.goal + Vec(0.11, 0.0, 0.0)
    assert (
        rested(gone, far, 3.01, gone.reference_end + SETTINGS.settling.patience - 0.1).phase
        == RECOVER
    )
    fast = gone
    for k in range(200):
        fast = travelled(ROUTE, fast, HIT, at(gone.goal, Vec(0.31, 0.0, 0.0)), 3.01 + 0.01 * k, 0.0)
    assert fast.phase == RECOVER
    assert (
        rested(gone, far, 3.01, gone.reference_end + SETTINGS.settling.patience + 0.1).phase
        == RETURN
    )


def test_it_sets_out_again_as_often_as_asked() -> None:
    route = RecoverySettings(runs=2).route(HOME)
    recovery_state = on_alarm(begun(), 3.0)
    recovery_state = on_characterisation(route, recovery_state, HIT, at(HIT.position), 3.01, 0.0)
    recovery_state = rested(recovery_state, recovery_state.goal, 3.01, 5.0, route)
    recovery_state = rested(recovery_state, HOME, 5.0, 12.0, route)
    assert (recovery_state.phase, recovery_state.log.runs) == (CRUISE, 1.0)
    assert recovery_state.run_start == pytest.approx(recovery_state.log.home)
    again = on_characterisation(
        route, on_alarm(recovery_state, 20.0), HIT, at(HIT.position), 20.01, 0.0
    )
    again = rested(again, again.goal, 20.01, 22.0, route)
    assert rested(again, HOME, 22.0, 30.0, route).phase == HOVER


def test_an_alarm_keeps_the_reference_of_its_phase() -> None:
    """The reference of the run-up is that of the first alarm alone; each later phase has its own."""
    first = on_alarm(begun(), 3.0)
    assert (first.phase, first.followed) == (LOOK, CRUISE)
    gone = on_characterisation(ROUTE, first, HIT, at(HIT.position), 3.01, 0.0)
    again = on_alarm(gone, 3.5)
    assert (gone.followed, again.phase, again.followed) == (RECOVER, LOOK, RECOVER)
    homing = rested(gone, gone.goal, 3.01, gone.reference_end + SETTINGS.settling.dwell + 0.5)
    assert (homing.phase, on_alarm(homing, 6.0).followed) == (RETURN, RETURN)
    hovering = rested(homing, HOME, homing.phase_start, homing.reference_end + 2.0)
    assert (hovering.phase, on_alarm(hovering, 30.0).followed) == (HOVER, HOVER)


def test_without_return_it_stays() -> None:
    route = RecoverySettings(returns=False).route(HOME)
    gone = on_characterisation(route, on_alarm(begun(), 3.0), HIT, at(HIT.position), 3.01, 0.0)
    assert rested(gone, gone.goal, 3.01, 5.0, route).goal == gone.goal


def test_stages_come_first_where_a_response_has_them() -> None:
    route = RecoverySettings(response={"way": "staged"}).route(HOME)
    recovery_state = on_characterisation(
        route, on_alarm(recovery_at_start(route, HIT), 3.0), HIT, at(HOME), 3.01, 0.0
    )
    assert recovery_state.phase == STAGES
    here = Vec(2.0, 0.2, 0.7)
    over = travelled(route, recovery_state._replace(stage=OVER), HIT, at(here), 4.0, 0.0)
    assert (over.phase, over.goal) == (RECOVER, here)


def test_ways_of_legs() -> None:
    """The run-up of a later run begins when that run does; no jerk is handed on after a hit."""
    cruise = begun().return_reference  # any polynomial will do
    recovery_state = on_characterisation(
        ROUTE, on_alarm(begun(), 3.0), HIT, at(HIT.position), 3.01, 0.0
    )
    assert target(DelayedReference(cruise, 7.0), 7.5) == target(cruise, 0.5)
    after = target(JerkFreeReference(recovery_state.recovery_reference), 3.05)
    plain = target(recovery_state.recovery_reference, 3.05)
    assert (after.position, after.acceleration) == (plain.position, plain.acceleration)
    assert after.jerk == STILL != plain.jerk

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
    Calm,
    Departed,
    Journey,
    journey_at_start,
    leaving,
    passes,
    struck,
    turned,
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


def begun() -> Journey:
    return journey_at_start(ROUTE, HIT)


def travelled(route, journey: Journey, hit, here: Estimate, time: float, yaw: float) -> Journey:
    """A tick without an alarm."""
    passed = passes(route, journey, here, time)
    journey = journey._replace(near=passed.near)
    return turned(route, journey, hit, here, time, yaw) if passed.turns else journey


def rested(journey: Journey, place: Vec, begins: float, ends: float, route=ROUTE) -> Journey:
    """Stay at a place, tick by tick."""
    ticks = round((ends - begins) / 0.01)
    for k in range(ticks + 1):
        journey = travelled(route, journey, HIT, at(place), begins + 0.01 * k, 0.0)
    return journey


def test_it_cruises_until_the_alarm_whatever_time_it_is() -> None:
    assert rested(begun(), HOME, 0.0, 20.0).leg == CRUISE


def test_the_way_leads_to_a_point_before_the_obstacle() -> None:
    """p_r = p_c − δ f_c⁰, eq. (17), with δ = L_c = 0.1 m."""
    looking = struck(begun(), 3.0)
    assert (looking.leg, looking.log.alarm) == (LOOK, 3.0)
    gone = leaving(ROUTE, looking, HIT, at(HIT.position), 3.01, 0.0)
    assert gone.leg == RECOVER
    assert gone.goal == pytest.approx(HIT.position - WALL * 0.1)
    assert gone.log.planned == 3.01


def test_it_goes_home_once_it_has_rested_and_not_before() -> None:
    gone = leaving(ROUTE, struck(begun(), 3.0), HIT, at(HIT.position), 3.01, 0.0)
    near = gone.goal + Vec(0.05, 0.0, 0.0)
    stay = SETTINGS.settling.stay
    waiting = rested(gone, near, 3.01, gone.ends + stay - 0.05)
    assert waiting.leg == RECOVER
    homing = rested(gone, near, 3.01, gone.ends + stay + 0.05)
    assert (homing.leg, homing.goal) == (RETURN, HOME)
    hovering = rested(homing, HOME, homing.since, homing.ends + stay + 0.05)
    assert hovering.leg == HOVER
    assert hovering.log.runs == 1.0


def test_moving_or_far_is_no_rest() -> None:
    gone = leaving(ROUTE, struck(begun(), 3.0), HIT, at(HIT.position), 3.01, 0.0)
    far = gone.goal + Vec(0.11, 0.0, 0.0)
    assert rested(gone, far, 3.01, gone.ends + SETTINGS.settling.patience - 0.1).leg == RECOVER
    fast = gone
    for k in range(200):
        fast = travelled(ROUTE, fast, HIT, at(gone.goal, Vec(0.31, 0.0, 0.0)), 3.01 + 0.01 * k, 0.0)
    assert fast.leg == RECOVER
    assert rested(gone, far, 3.01, gone.ends + SETTINGS.settling.patience + 0.1).leg == RETURN


def test_it_sets_out_again_as_often_as_asked() -> None:
    route = RecoverySettings(runs=2).route(HOME)
    journey = struck(begun(), 3.0)
    journey = leaving(route, journey, HIT, at(HIT.position), 3.01, 0.0)
    journey = rested(journey, journey.goal, 3.01, 5.0, route)
    journey = rested(journey, HOME, 5.0, 12.0, route)
    assert (journey.leg, journey.log.runs) == (CRUISE, 1.0)
    assert journey.away == pytest.approx(journey.log.home)
    again = leaving(route, struck(journey, 20.0), HIT, at(HIT.position), 20.01, 0.0)
    again = rested(again, again.goal, 20.01, 22.0, route)
    assert rested(again, HOME, 22.0, 30.0, route).leg == HOVER


def test_without_return_it_stays() -> None:
    route = RecoverySettings(returns=False).route(HOME)
    gone = leaving(route, struck(begun(), 3.0), HIT, at(HIT.position), 3.01, 0.0)
    assert rested(gone, gone.goal, 3.01, 5.0, route).goal == gone.goal


def test_stages_come_first_where_a_response_has_them() -> None:
    route = RecoverySettings(response={"way": "staged"}).route(HOME)
    journey = leaving(route, struck(journey_at_start(route, HIT), 3.0), HIT, at(HOME), 3.01, 0.0)
    assert journey.leg == STAGES
    here = Vec(2.0, 0.2, 0.7)
    over = travelled(route, journey._replace(stage=OVER), HIT, at(here), 4.0, 0.0)
    assert (over.leg, over.goal) == (RECOVER, here)


def test_ways_of_legs() -> None:
    """The run-up of a later run begins when that run does; no jerk is handed on after a hit."""
    cruise = begun().homeward  # any polynomial will do
    journey = leaving(ROUTE, struck(begun(), 3.0), HIT, at(HIT.position), 3.01, 0.0)
    assert target(Departed(cruise, 7.0), 7.5) == target(cruise, 0.5)
    after = target(Calm(journey.recovery), 3.05)
    plain = target(journey.recovery, 3.05)
    assert (after.position, after.acceleration) == (plain.position, plain.acceleration)
    assert after.jerk == STILL != plain.jerk

"""When a rotor that is hit stops, and when it turns again: rule by rule, in plain Python."""

from __future__ import annotations

import math
from typing import Any

import pytest

import springback
from springback.errors import InputError
from springback.vehicle.library import VEHICLES
from springback.vehicle.rotor_stop import (
    BROKEN,
    TURNING,
    UNHIT,
    RotorHits,
    RotorStop,
    StopSettings,
    forgotten,
    is_hit,
    is_stopped,
    reaction,
    rotor_step,
    stopped_since,
)
from springback.vehicle.rotors import Rotors, lag_over

TICK = 1e-3
PUSHED, IN_DISC = RotorHits(50.0, 0.0, -1.0), RotorHits(0.0, 1.0, -1.0)


def stop_of(*, disc_known: bool = True, **given: Any) -> RotorStop:
    return StopSettings(**given).stop(TICK, disc_known)


def test_only_a_force_beyond_the_limit_hits() -> None:
    """At the limit it does; without a limit no force does, an impulse (of no limit) included."""
    stop = stop_of(guard_force="50 N")
    assert is_hit(PUSHED, stop) == 1.0
    assert is_hit(RotorHits(49.9, 0.0, -1.0), stop) == 0.0
    assert is_hit(RotorHits(1e30, 0.0, -1.0), stop_of()) == 0.0
    assert is_hit(RotorHits(1e30, 0.0, -1.0), stop) == 1.0


def test_what_is_in_a_disc_hits_by_default_if_its_size_is_known() -> None:
    assert is_hit(IN_DISC, stop_of()) == 1.0
    assert is_hit(IN_DISC, stop_of(disc="ignore", guard_force=1.0)) == 0.0
    assert is_hit(IN_DISC, stop_of(guard_force=1.0, disc_known=False)) == 0.0


def test_a_hit_stops_after_the_delay_and_a_second_one_before_it_is_due_does_not_put_it_off() -> (
    None
):
    stop = stop_of(guard_force=50.0, delay="5 ms")
    since = stopped_since(TURNING, PUSHED, 1.0, stop, 1.0)
    assert since == pytest.approx(1.005)
    assert is_stopped(since, 1.004) == 0.0
    assert is_stopped(since, 1.005) == 1.0
    assert stopped_since(since, PUSHED, 1.0, stop, 1.003) == since


def test_others_follow_only_where_asked() -> None:
    alone, together = stop_of(guard_force=50.0), stop_of(guard_force=50.0, others_after="40 ms")
    assert stopped_since(TURNING, UNHIT, 1.0, alone, 2.0) == TURNING
    assert stopped_since(TURNING, UNHIT, 1.0, together, 2.0) == pytest.approx(2.04)
    assert stopped_since(TURNING, UNHIT, 0.0, together, 2.0) == TURNING


def test_a_rotor_turns_again_some_time_after_the_last_hit_or_never() -> None:
    stop, never = stop_of(guard_force=50.0, restart_after="0.3 s"), stop_of(guard_force=50.0)
    assert stopped_since(1.0, UNHIT, 0.0, stop, 1.299) == 1.0
    assert stopped_since(1.0, UNHIT, 0.0, stop, 1.3) == TURNING
    assert stopped_since(1.0, PUSHED, 1.0, stop, 1.2) == 1.2
    assert stopped_since(1.0, UNHIT, 0.0, never, 1e6) == 1.0


def test_a_broken_propeller_gives_no_thrust_ever_after() -> None:
    stop = stop_of(disc="break", restart_after="0.1 s", delay="1 s")
    since = stopped_since(TURNING, IN_DISC, 1.0, stop, 2.0)
    assert since == BROKEN
    assert is_stopped(since, 2.0) == 1.0  # at once: the delay is that of what switches a motor off
    assert stopped_since(BROKEN, UNHIT, 0.0, stop, 99.0) == BROKEN


def test_the_first_stop_is_kept_and_hits_are_forgotten() -> None:
    first = forgotten(PUSHED, 1.0, 0.5)
    assert first == RotorHits(0.0, 0.0, 0.5)
    assert forgotten(first._replace(force=9.0), 1.0, 0.7) == first
    assert forgotten(PUSHED, 0.0, 0.5).stop_time == -1.0


def test_thrust_of_a_stopped_rotor_decays_whatever_it_is_told() -> None:
    """T(h) = T_0 e^(−h/τ); below the least thrust, too; its mean is the integral over the tick."""
    stop, rotors = stop_of(spin_down="4 ms"), Rotors(0.5, 7.0, 0.025)
    lag = lag_over(rotors.time_constant, TICK)
    step = rotor_step(3.0, 7.0, 1.0, rotors, lag, stop)
    assert step.thrust == pytest.approx(3.0 * math.exp(-0.25), rel=1e-12)
    assert step.mean == pytest.approx(3.0 * (1.0 - math.exp(-0.25)) / 0.25, rel=1e-12)
    assert rotor_step(3.0, 7.0, 0.0, rotors, lag, stop).thrust > 3.0


def test_the_body_receives_the_angular_momentum_that_a_rotor_loses() -> None:
    """Along the rotor's own rotation, against the torque of its drag; reversed as it speeds up."""
    arms = VEHICLES["arq"].vehicle.airframe().arms
    stop = stop_of(rotor_inertia=2e-5, thrust_coefficient=8e-6)
    for arm in arms[:2]:
        lost = TICK * reaction(arm, 2.0, 0.0, stop)
        assert lost == pytest.approx(-math.copysign(2e-5 * 500.0, arm.torque_ratio), rel=1e-12)
        assert reaction(arm, 0.0, 2.0, stop) == -lost / TICK
    assert arms[0].torque_ratio * arms[1].torque_ratio < 0.0
    assert reaction(arms[0]._replace(torque_ratio=0.0), 2.0, 0.0, stop) == 0.0


@pytest.mark.parametrize(
    ("propulsion", "words"),
    [
        ({"stop": {}}, ("vehicle.propulsion.stop.guard_force", "nothing stops a rotor")),
        ({"stop": {"disc": "break"}}, ("vehicle.propulsion.stop.disc", "disk_radius")),
        (
            {"disk_radius": 0.08, "stop": {"disc": "ignore"}},
            ("vehicle.propulsion.stop.guard_force", "is missing"),
        ),
        (
            {"stop": {"guard_force": 9.0, "rotor_inertia": 1e-5}},
            ("vehicle.propulsion.stop.thrust_coefficient", "rotor_inertia needs it"),
        ),
        ({"stop": {"guard_force": "9 m"}}, ("vehicle.propulsion.stop.guard_force", "N")),
        ({"stop": {"guard_force": 9.0}}, ("vehicle.propulsion.stop", "only where a pilot flies")),
    ],
)  # fmt: skip
def test_what_cannot_act_is_refused(propulsion: dict[str, Any], words: tuple[str, ...]) -> None:
    tables = {
        "vehicle": {"preset": "arq", "propulsion": {"disk_radius": None, **propulsion}},
        "thrust": "hover",
    }
    with pytest.raises(InputError) as caught:
        springback.fly(tables)
    assert all(word in str(caught.value) for word in words)

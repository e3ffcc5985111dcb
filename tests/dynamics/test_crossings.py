"""Crossings that steps land on, and end stops as steps see them: rule by rule, in plain Python."""

from __future__ import annotations

import math

import pytest

from springback.contact.cage import LANDED
from springback.dynamics.crossing import NO_CROSSING, crossing, sooner, soonest, time_to
from springback.dynamics.stops import AHEAD, APPROACH, GRAZED, SUDDEN, end_stop, next_stop
from springback.vehicle.library import VEHICLES
from springback.vehicle.state import Arm


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_only_what_approaches_zero_crosses_it(sign: float) -> None:
    """After distance over speed; nothing that recedes, stands still or is there already."""
    assert time_to(crossing(sign * 0.1, -sign * 2.0)) == pytest.approx(0.05)
    for value, rate in ((sign * 0.1, sign * 2.0), (sign * 0.1, 0.0), (sign * 0.5 * LANDED, -sign)):
        assert time_to(crossing(value, rate)) == NO_CROSSING


def test_the_earlier_of_two_is_taken_whatever_their_distances() -> None:
    """Near and slow against far and fast."""
    slow, fast = crossing(0.1, -0.5), crossing(-1.0, 10.0)
    assert sooner(slow, fast) == sooner(fast, slow) == fast
    assert time_to(soonest((slow, crossing(1.0, 1.0), fast))) == pytest.approx(0.1)
    assert time_to(soonest(())) == NO_CROSSING


@pytest.fixture
def arm() -> Arm:
    """An arm with stops of some dissipation."""
    first = VEHICLES["arq"].vehicle.airframe().arms[0]
    return first._replace(stop_stiffness=1e5, stop_dissipation=0.3)


def test_an_arm_reaches_the_stop_that_it_moves_to(arm: Arm) -> None:
    """Between its stops the one ahead; beyond one of them, that one again on its way back.

    In two steps: what begins there is stiff, and must not begin within one.
    """
    shortest, free = arm.shortest, arm.length
    middle = 0.5 * (shortest + free)
    for length, rate, at in (
        (middle, 2.0, free), (middle, -2.0, shortest),
        (free + 1e-3, -2.0, free), (shortest - 1e-3, 2.0, shortest),
    ):  # fmt: skip
        expected = APPROACH * abs(at - length) / 2.0
        assert time_to(next_stop(arm, length, rate)) == pytest.approx(expected)
        near = at + math.copysign(GRAZED, length - at)
        assert time_to(next_stop(arm, near, rate)) == pytest.approx(GRAZED / 2.0, rel=1e-6)
    for length, rate in ((free + 1e-3, 2.0), (shortest - 1e-3, -2.0)):
        assert time_to(next_stop(arm, length, rate)) == NO_CROSSING


@pytest.mark.parametrize("rate", [-0.5, 0.0, 0.5])
@pytest.mark.parametrize("upper", [True, False])
def test_a_stop_pushes_back_and_its_stiffness_and_damper_are_the_forces_slopes(
    arm: Arm, upper: bool, rate: float
) -> None:
    """By finite differences, its damper where the arm will be; its heat is what damping takes."""
    length = arm.length + 1e-3 if upper else arm.shortest - 1e-3
    stop = end_stop(arm, length, rate)
    assert math.copysign(1.0, stop.force) == (-1.0 if upper else 1.0)
    assert stop.loss >= 0.0
    h, ahead = 1e-6, math.copysign(AHEAD * rate, 1.0 if upper else -1.0)

    def damper(at: float) -> float:
        slower, faster = end_stop(arm, at, rate - h).force, end_stop(arm, at, rate + h).force
        return (slower - faster) / (2 * h)

    assert stop.damper == pytest.approx(damper(length + ahead), rel=1e-6)
    pressing = rate if (rate > 0.0) == upper else 0.0  # coming out it is softer
    back, on = (end_stop(arm, length + by, pressing).force for by in (-h, h))
    assert stop.stiffness == pytest.approx(SUDDEN * (back - on) / (2 * h), rel=1e-6)
    assert stop.loss == pytest.approx(damper(length) * rate * rate, rel=1e-6)


def test_a_stop_is_stiff_a_moment_before_it_is_reached(arm: Arm) -> None:
    """Steps look ahead; an arm that will only graze its stop, or leaves it, is not slowed down."""
    for at, towards in ((arm.length, 1.0), (arm.shortest, -1.0)):
        before = at - towards * 1e-5
        soon = towards * (1e-5 + 10.0 * GRAZED) / AHEAD
        slope = arm.stop_stiffness * (1.0 + arm.stop_dissipation * abs(soon))
        assert end_stop(arm, before, soon).stiffness == pytest.approx(SUDDEN * slope)
        assert end_stop(arm, before, soon).force == 0.0
        grazing = towards * (1e-5 + 0.1 * GRAZED) / AHEAD
        for rate in (grazing, 0.0, -soon):
            assert end_stop(arm, before, rate).stiffness == 0.0

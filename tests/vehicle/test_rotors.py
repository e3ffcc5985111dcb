"""Rotors lag and saturate: the exact law against its differential equation, its limits, and compiled."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numba import njit
from scipy.integrate import solve_ivp

from springback.errors import InputError
from springback.kernels.trees import leaves
from springback.vehicle.library import VEHICLES
from springback.vehicle.propulsion import Propulsion
from springback.vehicle.rotors import (
    INSTANT,
    SHORT,
    LagStep,
    Rotors,
    Thrusts,
    lag_over,
    lagged_thrust,
    lagged_thrusts,
    limited_command,
)

ROTORS = Rotors(least=0.2, most=7.0, time_constant=0.03)
thrusts = st.floats(0.2, 7.0)
durations = st.floats(0.0, 1.0)
constants = st.sampled_from([0.0, 1e-12, 1e-6, 0.01, 0.03, 0.3, 50.0])


@njit  # type: ignore[untyped-decorator]
def compiled_lag(
    rotors: Rotors, now: tuple[float, ...], command: tuple[float, ...], h: float
) -> Any:
    return lagged_thrusts(rotors, now, command, lag_over(rotors.time_constant, h))


def after_time(rotors: Rotors, start: float, command: float, duration: float) -> LagStep:
    return lagged_thrust(start, command, rotors, lag_over(rotors.time_constant, duration))


def test_after_one_time_constant_a_step_has_63_percent() -> None:
    """The textbook number, 1 − 1/e, and 95 % after three."""
    for count, share in ((1.0, 1.0 - math.exp(-1.0)), (3.0, 1.0 - math.exp(-3.0))):
        after = after_time(ROTORS, 1.0, 5.0, count * 0.03)
        assert (after.thrust - 1.0) / 4.0 == pytest.approx(share, rel=1e-14)


@pytest.mark.parametrize(("start", "command"), [(1.0, 5.0), (6.0, 2.0), (0.5, 90.0), (3.0, -4.0)])
@pytest.mark.parametrize("duration", [1e-4, 0.01, 0.2])
def test_law_solves_its_differential_equation(
    start: float, command: float, duration: float
) -> None:
    """τ Ṫ = u − T integrated numerically, with its mean as a second state, as an independent way."""
    u = min(max(command, 0.2), 7.0)
    solved = solve_ivp(
        lambda _, y: [(u - y[0]) / 0.03, y[0]], (0.0, duration), [start, 0.0],
        rtol=1e-11, atol=1e-13, method="DOP853",
    )  # fmt: skip
    after = after_time(ROTORS, start, command, duration)
    assert after.thrust == pytest.approx(solved.y[0, -1], rel=1e-9)
    assert after.mean == pytest.approx(solved.y[1, -1] / duration, rel=1e-8)


@given(thrusts, thrusts, durations, durations, constants)
def test_two_halves_are_one_whole(
    start: float, command: float, first: float, second: float, constant: float
) -> None:
    """The flow of a law composes, and impulses (mean times time) add, whatever the ticks."""
    rotors = ROTORS._replace(time_constant=constant)
    a = after_time(rotors, start, command, first)
    b = after_time(rotors, a.thrust, command, second)
    whole = after_time(rotors, start, command, first + second)
    assert b.thrust == pytest.approx(whole.thrust, abs=1e-12)
    impulse = a.mean * first + b.mean * second
    assert impulse == pytest.approx(whole.mean * (first + second), abs=1e-12)


@given(thrusts, st.floats(-20.0, 20.0), durations, constants)
def test_thrust_stays_between_its_bounds_and_on_its_way(
    start: float, command: float, duration: float, constant: float
) -> None:
    """No overshoot: end and mean lie between start and kept command, the mean nearer the start."""
    rotors = ROTORS._replace(time_constant=constant)
    u = limited_command(rotors, command)
    assert rotors.least <= u <= rotors.most
    after = after_time(rotors, start, command, duration)
    low, high = min(start, u) - 1e-12, max(start, u) + 1e-12
    assert low <= after.thrust <= high
    assert low <= after.mean <= high
    assert abs(after.mean - start) <= abs(after.thrust - start) + 1e-12


def test_limits() -> None:
    """No lag: the command at once.  No time: nothing changes.  Much time: the command.  Slow: −ḣ/2τ."""
    for constant in (0.0, INSTANT / 2.0):
        for duration in (0.0, 1e-3, 10.0):
            assert after_time(Rotors(0.0, 7.0, constant), 1.0, 5.0, duration) == (5.0, 5.0)
    assert after_time(ROTORS, 1.0, 5.0, 0.0) == (1.0, 1.0)
    assert after_time(ROTORS, 1.0, 5.0, 1e3).thrust == 5.0
    slow = after_time(Rotors(0.0, 7.0, 1e6), 1.0, 5.0, 1.0)
    assert slow.thrust - 1.0 == pytest.approx(4e-6, rel=1e-5)
    assert slow.mean - 1.0 == pytest.approx(2e-6, rel=1e-5)


def test_series_meets_the_closed_form() -> None:
    """On both sides of the switch the mean's share is (1 − e^(−x))/x, to 1e-12 of it."""
    for x in (0.3 * SHORT, 0.999 * SHORT, 1.001 * SHORT, 3.0 * SHORT):
        share = after_time(Rotors(0.0, 7.0, 1.0), 1.0, 0.0, x).mean
        assert share == pytest.approx(-math.expm1(-x) / x, rel=1e-12)


def test_saturated_command_is_the_bound() -> None:
    """Beyond the bounds the command does not matter, and a hold at the bound is exact."""
    assert after_time(ROTORS, 2.0, 7.0, 0.01) == after_time(ROTORS, 2.0, 700.0, 0.01)
    assert after_time(ROTORS, 2.0, 0.2, 0.01) == after_time(ROTORS, 2.0, -700.0, 0.01)
    assert after_time(ROTORS, 7.0, 9.0, 0.01) == (7.0, 7.0)


@pytest.mark.parametrize("count", [1, 4, 6])
def test_rotors_keep_their_order_and_do_not_mix(count: int) -> None:
    now = tuple(1.0 + 0.5 * j for j in range(count))
    command = tuple(6.0 - 0.7 * j for j in range(count))
    lag = lag_over(ROTORS.time_constant, 0.01)
    after = lagged_thrusts(ROTORS, now, command, lag)
    single = [lagged_thrust(*pair, ROTORS, lag) for pair in zip(now, command, strict=True)]
    assert after == Thrusts(tuple(s.thrust for s in single), tuple(s.mean for s in single))


@pytest.mark.parametrize("constant", [0.0, 0.01, 0.03, 1e3])
def test_plain_python_is_compiled(constant: float) -> None:
    """Twins, to the last bit: instant, in the closed form and in the series, saturated or not."""
    rotors, random = ROTORS._replace(time_constant=constant), np.random.default_rng(1)
    for duration in (0.0, 1e-6, 1e-3, 0.1, 60.0):
        now, command = (tuple(map(float, random.uniform(-2.0, 9.0, 4))) for _ in range(2))
        plain = lagged_thrusts(rotors, now, command, lag_over(rotors.time_constant, duration))
        assert leaves(compiled_lag(rotors, now, command, duration)) == leaves(plain)


def test_settings_become_the_kernels_numbers() -> None:
    settings = Propulsion(max_thrust="7 N", min_thrust=0.2, time_constant="30 ms")
    assert settings.rotors() == ROTORS
    assert Propulsion(max_thrust=1.0, battery_energy="1 Wh").battery_energy == pytest.approx(3600)


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"max_thrust": 0.0}, "more than 0 N"),
        ({"max_thrust": 1.0, "min_thrust": 1.0}, "less than max_thrust, 1 N"),
        ({"max_thrust": 1.0, "time_constant": -0.1}, "at least 0 s"),
        ({"max_thrust": 1.0, "figure_of_merit": 1.1}, "at most 1"),
        ({"max_thrust": 1.0, "usable_share": 0.0}, "more than 0"),
        ({"max_thrust": 1.0, "battery_energy": "3 V"}, "wrong unit"),
        ({"max_thrust": 1.0, "batery_energy": 3.0}, "did you mean battery_energy"),
    ],
)
def test_wrong_settings_say_what_is_allowed(wrong: dict[str, Any], said: str) -> None:
    with pytest.raises(InputError, match=said):
        Propulsion(**wrong)


def test_robots_as_flown_have_one_propulsion_and_those_on_the_slider_none() -> None:
    """In the slider tests motors are not actuated; every number of the propulsion has a source."""
    arq, quad = VEHICLES["arq"], VEHICLES["quad"]
    assert arq.vehicle.propulsion == quad.vehicle.propulsion
    for name in ("arq-slider", "quad-slider", "arq-lumped"):
        assert VEHICLES[name].vehicle.propulsion is None
    for field in Propulsion.model_fields:
        assert f"propulsion.{field}" in arq.sources

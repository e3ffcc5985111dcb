"""Rotors in the loop: command, delay, and thrust on the vehicle."""

import math
from contextlib import nullcontext
from typing import Any

import numpy as np
import pytest

import springback
from springback.errors import CommandWarning
from springback.vehicle.library import VEHICLES

LAG, TICK = 0.025, 1e-3  # [s] of the presets, and of the clock
QUAD = VEHICLES["quad"].vehicle
HOVER = QUAD.mass * 9.81 / 4.0  # [N]


def flown(pilot: Any, duration: float = 0.2, **tables: Any) -> springback.Flight:
    """A flight with a plain pilot."""
    given = {"vehicle": "quad", "thrust": "hover", "simulation": {"duration": duration}} | tables
    return springback.fly(given, pilot=pilot)


def constant(thrust: float) -> Any:
    return lambda time, measurement, memory: ((thrust,) * 4, None)


def test_a_step_is_answered_by_the_exact_exponential_at_every_tick() -> None:
    """T = u + (T_0 − u) e^(−t/τ): no error of the step, however coarse the clock."""
    assert QUAD.propulsion is not None
    assert pytest.approx(LAG) == QUAD.propulsion.time_constant
    for clock in (1000.0, 2000.0):
        telemetry = flown(constant(4.0), clock=clock).telemetry
        expected = 4.0 + (HOVER - 4.0) * np.exp(-telemetry["t"] / LAG)
        for rotor in range(1, 5):
            assert telemetry[f"thrust{rotor}"] == pytest.approx(expected, rel=1e-12)


def test_the_vehicle_climbs_by_the_integral_of_the_lagged_thrust() -> None:
    """m v = ∫ (4 T − m g) dt in closed form, at the end of every tick: the mean of a tick acts."""
    flight = flown(constant(4.0))
    t = flight.columns["t"]
    at_ticks = np.abs(t / TICK - np.round(t / TICK)) < 1e-9
    gained = 4.0 * (HOVER - 4.0) * (LAG * -np.expm1(-t / LAG)) + 4.0 * (4.0 - HOVER) * t
    assert at_ticks.sum() > 150
    assert flight.columns["vz"][at_ticks] == pytest.approx(gained[at_ticks] / QUAD.mass, abs=1e-9)


def test_commands_beyond_the_bounds_saturate() -> None:
    """More than max_thrust, and less than nothing."""
    assert QUAD.propulsion is not None
    most = float(QUAD.propulsion.max_thrust)
    for command, bound in ((1e3, most), (-5.0, 0.0)):
        said = pytest.warns(CommandWarning) if command < 0.0 else nullcontext()
        with said:
            telemetry = flown(constant(command), 0.4).telemetry
        assert telemetry["command1"][-1] == command
        assert telemetry["thrust1"][-1] == pytest.approx(bound, abs=2e-5 * most)
        assert telemetry["thrust1"].max() <= most
        assert telemetry["thrust1"].min() >= 0.0


def test_a_command_acts_from_its_own_tick_on() -> None:
    """A pulse at tick 10 is in the thrust of tick 11, no earlier and no later, and then fades."""

    def pulse(time: float, measurement: Any, memory: Any) -> Any:
        return ((HOVER + (1.0 if round(time / TICK) == 10 else 0.0),) * 4, None)

    thrust = flown(pulse, 0.05).telemetry["thrust1"] - HOVER
    assert thrust[:11] == pytest.approx(0.0, abs=1e-15)
    jump = -math.expm1(-TICK / LAG)
    assert thrust[11] == pytest.approx(jump, rel=1e-12)
    assert thrust[12:] == pytest.approx(jump * np.exp(-TICK / LAG * np.arange(1, 39)), rel=1e-9)


def test_rotors_without_lag_follow_at_once() -> None:
    vehicle = {"preset": "quad", "propulsion": {"time_constant": 0.0}}
    telemetry = flown(constant(4.0), 0.01, vehicle=vehicle).telemetry
    assert telemetry["thrust1"][0] == pytest.approx(HOVER)
    assert telemetry["thrust1"][1:] == pytest.approx(4.0)


def test_spinning_rotors_turn_the_vehicle_about_z_by_their_reaction() -> None:
    """J_zz dω_z/dt = Σ s_j c_τ T_j with the lagged thrusts: yaw rate in closed form."""
    arms = QUAD.airframe().arms

    def twist(time: float, measurement: Any, memory: Any) -> Any:
        return (tuple(HOVER + math.copysign(0.5, arm.torque_ratio) for arm in arms), None)

    flight = flown(twist)
    t = flight.columns["t"]
    share = t - LAG * -np.expm1(-t / LAG)  # ∫ (1 − e^(−t/τ)) dt
    torque = 0.5 * sum(abs(arm.torque_ratio) for arm in arms)
    inertia = QUAD.inertia()[2][2]
    ticks = np.abs(t / TICK - np.round(t / TICK)) < 1e-9
    assert flight.columns["wz"][ticks] == pytest.approx(
        torque / inertia * share[ticks], rel=1e-6, abs=1e-9
    )

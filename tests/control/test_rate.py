"""The rate loop: what it makes of a body, the filter, the integral, and the inertia it believes in."""

from __future__ import annotations

import math

import numba
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from builders.random_turns import random_vec
from springback.control.parameters import ControlSettings
from springback.control.rate import RateLaw, inertia_at, rate_memory, turn
from springback.kernels.trees import leaves
from springback.kernels.vectors import Mat3, Vec
from springback.vehicle.library import VEHICLES

ZERO = Vec(0.0, 0.0, 0.0)
ARQ = VEHICLES["arq"].vehicle


def law(**changes: object) -> RateLaw:
    return ControlSettings(**{"gyro_cutoff": 0.0, "rate_integral": 0.0, **changes}).rate_law()


def full_inertia() -> Mat3:
    r = Rotation.from_rotvec([0.3, -0.5, 0.2]).as_matrix()
    return Mat3(*(Vec(*map(float, row)) for row in r @ np.diag([0.01, 0.012, 0.02]) @ r.T))


def test_angular_acceleration_is_gain_times_error_for_any_inertia() -> None:
    """The moment cancels ω × J ω: J ω̇ = τ − ω × J ω leaves ω̇ = k_ω (ω_sp − ω)."""
    rng, j, rate_law = np.random.default_rng(1), full_inertia(), law()
    for _ in range(50):
        setpoint, omega = random_vec(rng, 4.0), random_vec(rng, 4.0)
        moment = np.array(turn(rate_law, j, setpoint, omega, ZERO, rate_memory(omega)).moment)
        w, m = np.array(omega), np.array(j)
        rate = np.linalg.solve(m, moment - np.cross(w, m @ w))
        np.testing.assert_allclose(rate, rate_law.gain.x * (np.array(setpoint) - w), atol=1e-11)


def test_gyroscopic_term_can_be_left_out() -> None:
    omega, j = Vec(1.0, -2.0, 3.0), full_inertia()
    still = turn(law(gyroscopic=False), j, omega, omega, ZERO, rate_memory(omega)).moment
    assert leaves(still) == [0.0] * 3
    spun = turn(law(), j, omega, omega, ZERO, rate_memory(omega)).moment
    w, m = np.array(omega), np.array(j)
    np.testing.assert_allclose(leaves(spun), np.cross(w, m @ w), rtol=1e-12)


@pytest.mark.parametrize("lengths", [(0.19,) * 4, (0.15, 0.17, 0.19, 0.18)])
def test_inertia_follows_the_arms(lengths: tuple[float, ...]) -> None:
    np.testing.assert_allclose(
        np.array(inertia_at(ARQ.airframe(), lengths)), ARQ.inertia(lengths), rtol=1e-12, atol=1e-18
    )


def test_filter_rises_by_one_minus_one_over_e_in_its_time_constant() -> None:
    """And tends to it at fine steps: 1/(2π f)."""
    cutoff = 5.0
    rate_law = law(gyro_cutoff=cutoff)
    memory, steps = rate_memory(ZERO), round(rate_law.period**-1 / (2.0 * math.pi * cutoff))
    for _ in range(steps):
        memory = turn(rate_law, full_inertia(), ZERO, Vec(1.0, 0.0, 0.0), ZERO, memory).memory
    assert memory.filtered.x == pytest.approx(1.0 - math.exp(-1.0), abs=0.01)


def test_derivative_acts_against_angular_acceleration() -> None:
    rate_law, j = law(rate_derivative=0.5, rate_gain=1e-9), full_inertia()
    memory = rate_memory(ZERO)
    speeding = Vec(0.0, 0.3 * rate_law.period, 0.0)
    moment = turn(rate_law, j, ZERO, speeding, ZERO, memory).moment
    np.testing.assert_allclose(leaves(moment), -0.5 * 0.3 * np.array(j)[:, 1], rtol=1e-4)


def test_integral_holds_against_a_steady_torque() -> None:
    """About one axis with unit inertia and a torque of −2 N m: the rate returns to its set-point."""
    rate_law = law(rate_integral=60.0)
    unit = Mat3(Vec(1.0, 0.0, 0.0), Vec(0.0, 1.0, 0.0), Vec(0.0, 0.0, 1.0))
    for given, left in ((rate_law, 0.0), (law(), -2.0 / ControlSettings().rate_gain)):
        omega, memory = ZERO, rate_memory(ZERO)
        for _ in range(4000):
            done = turn(given, unit, ZERO, omega, ZERO, memory)
            memory = done.memory
            omega = omega + (done.moment - Vec(2.0, 0.0, 0.0)) * given.period
        assert omega.x == pytest.approx(left, abs=1e-3)


def test_integral_does_not_wind_up() -> None:
    """Not into saturation, not beyond its limit, hardly in a tumble; but always back out."""
    rate_law = law(rate_integral=60.0)
    j, up = full_inertia(), Vec(1.0, 1.0, 1.0)

    def after(setpoint: Vec, unmet: Vec, steps: int = 1) -> Vec:
        memory = rate_memory(ZERO)
        for _ in range(steps):
            memory = turn(rate_law, j, setpoint, ZERO, unmet, memory).memory
        return memory.integral

    assert leaves(after(up, up)) == [0.0] * 3
    assert after(up, up * 1e-15) == after(up, ZERO)  # rounding is no saturation
    assert min(after(up, -up)) > 0.0
    assert leaves(after(up, ZERO, 3000)) == [rate_law.integral_limit] * 3
    assert leaves(after(up * math.radians(401.0), ZERO)) == [0.0] * 3
    assert after(up * math.radians(200.0), ZERO).x == pytest.approx(
        0.75 * 60.0 * math.radians(200.0) * rate_law.period, rel=1e-12
    )


def test_plain_python_is_the_compiled_loop() -> None:
    @numba.njit
    def compiled(law, airframe, lengths, setpoint, omega, unmet, memory):  # type: ignore[no-untyped-def]
        return turn(law, inertia_at(airframe, lengths), setpoint, omega, unmet, memory)

    rng, airframe = np.random.default_rng(2), ARQ.airframe()
    rate_law = ControlSettings(rate_integral=10.0, rate_derivative=0.1).rate_law()
    for _ in range(200):
        lengths = tuple(float(l) for l in rng.uniform(0.14, 0.19, 4))
        setpoint, omega, unmet, before = (random_vec(rng, 5.0) for _ in range(4))
        plain = turn(
            rate_law, inertia_at(airframe, lengths), setpoint, omega, unmet, rate_memory(before)
        )
        assert (
            compiled(rate_law, airframe, lengths, setpoint, omega, unmet, rate_memory(before))
            == plain
        )

"""Attitude laws: small angles, half turns, convergence, tilt before yaw, Lee's own moment."""

from __future__ import annotations

import math
from typing import Any

import numba
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from builders.random_turns import as_quat, as_rotation, random_attitudes, random_vec
from springback.control.attitude import (
    FullQuaternion,
    LeeSO3,
    Reduced,
    attitude_error,
    correction,
    rate_setpoint,
)
from springback.control.parameters import ControlSettings
from springback.control.rate import inertia_at, rate_memory, turn
from springback.control.target import AttitudeTarget
from springback.kernels.trees import leaves
from springback.kernels.vectors import (
    Quat,
    Vec,
    inverse_symmetric,
    normalise,
    quaternion_rate,
)
from springback.vehicle.library import VEHICLES

LEVEL, ZERO = Quat(1.0, 0.0, 0.0, 0.0), Vec(0.0, 0.0, 0.0)
TAU, WIDE = 0.15, Vec(100.0, 100.0, 100.0)
GAIN = Vec(1.0 / TAU, 1.0 / TAU, 1.0 / TAU)
WEIGHT = 0.4
FULL, LEE = FullQuaternion(GAIN, WIDE), LeeSO3(GAIN, WIDE)
REDUCED = Reduced(GAIN._replace(z=1.0 / TAU / WEIGHT), WEIGHT, WIDE)
LAWS = {"full": FULL, "reduced": REDUCED, "lee": LEE}
VEHICLE = VEHICLES["arq"].vehicle
INERTIA = inertia_at(VEHICLE.airframe(), VEHICLE.lengths())


def turned(axis: tuple[float, float, float], angle: float) -> Quat:
    return as_quat(Rotation.from_rotvec(np.array(axis) / np.linalg.norm(axis) * angle))


def goal(attitude: Quat, omega: Vec = ZERO) -> AttitudeTarget:
    return AttitudeTarget(attitude, omega, 0.0)


@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS.keys())
@pytest.mark.parametrize("axis", [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, -2, 0.5)])
def test_small_angles_decay_with_the_time_constant(law: Any, axis: Any) -> None:
    """Ω = α/τ about the axis from here to there, whatever the law and wherever here is."""
    angle, unit = 1e-5, np.array(axis) / np.linalg.norm(axis)
    for q in random_attitudes(20, 1):
        desired = as_quat(as_rotation(q) * Rotation.from_rotvec(unit * angle))
        rates = rate_setpoint(law, goal(desired), q)
        np.testing.assert_allclose(leaves(rates), unit * angle / TAU, atol=1e-9)


@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS.keys())
def test_both_signs_of_a_quaternion_are_one_attitude(law: Any) -> None:
    """No unwinding."""
    for q, desired in zip(random_attitudes(50, 2), random_attitudes(50, 3), strict=True):
        flipped = Quat(*(-c for c in desired))
        assert rate_setpoint(law, goal(desired), q) == rate_setpoint(law, goal(flipped), q)


def test_half_turn_has_a_way_out() -> None:
    """sgn(0) = +1: at q_e0 = 0 the quaternion laws turn at full speed; Lee's not at all."""
    error = attitude_error(LEVEL, Quat(0.0, 1.0, 0.0, 0.0))
    assert error == Quat(0.0, 1.0, 0.0, 0.0)
    for law in (FULL, REDUCED):
        np.testing.assert_allclose(leaves(correction(law, error)), [2.0 / TAU, 0.0, 0.0])
    np.testing.assert_allclose(leaves(correction(LEE, error)), 0.0)
    beyond = attitude_error(LEVEL, turned((1, 0, 0), math.radians(190.0)))
    assert correction(FULL, beyond).x < 0.0


@pytest.mark.parametrize("law", [FULL, LEE], ids=["full", "lee"])
def test_size_of_the_correction(law: Any) -> None:
    """2 sin(α/2)/τ of Brescianini's, sin(α)/τ of Lee's error."""
    for angle in np.linspace(0.0, 3.1, 20):
        got = correction(law, attitude_error(LEVEL, turned((1, 2, 3), angle)))
        size = 2.0 * math.sin(angle / 2.0) if law is FULL else math.sin(angle)
        assert np.linalg.norm(got) == pytest.approx(size / TAU, abs=1e-12)


def test_lee_error_from_matrices() -> None:
    """−½ (R_dᵀ R − Rᵀ R_d)^∨/τ."""
    for q, desired in zip(random_attitudes(100, 4), random_attitudes(100, 5), strict=True):
        r, r_d = as_rotation(q).as_matrix(), as_rotation(desired).as_matrix()
        e = 0.5 * (r_d.T @ r - r.T @ r_d)
        vee = np.array([e[2, 1], e[0, 2], e[1, 0]])
        np.testing.assert_allclose(
            leaves(rate_setpoint(LEE, goal(desired), q)), -vee / TAU, atol=1e-12
        )


def tilt_and_twist(q: Quat, desired: Quat) -> tuple[np.ndarray, float]:
    """Shortest turn of body z to the desired z, by arc cosine, and what is left about it."""
    error = as_rotation(q).inv() * as_rotation(desired)
    z = error.apply([0.0, 0.0, 1.0])
    axis = np.cross([0.0, 0.0, 1.0], z)
    tilt = axis / np.linalg.norm(axis) * math.acos(z[2])
    rest = (Rotation.from_rotvec(tilt).inv() * error).as_rotvec()
    np.testing.assert_allclose(rest[:2], 0.0, atol=1e-6)
    return tilt, float(rest[2])


def test_reduced_law_takes_the_tilt_its_shortest_way() -> None:
    """Brescianini's mixing built from arc cosines, as printed, against the closed form."""
    for q, desired in zip(random_attitudes(200, 6), random_attitudes(200, 7), strict=True):
        tilt, twist = tilt_and_twist(q, desired)
        mixed = Rotation.from_rotvec(tilt) * Rotation.from_rotvec([0.0, 0.0, WEIGHT * twist])
        x, y, z, w = mixed.as_quat()
        expected = 2.0 * math.copysign(1.0, w) * np.array([x, y, z / WEIGHT]) / TAU
        np.testing.assert_allclose(
            leaves(rate_setpoint(REDUCED, goal(desired), q)), expected, atol=1e-6
        )


def test_yaw_weight_zero_frees_the_tilt_from_yaw() -> None:
    """At p = 0 roll and pitch do not depend on the desired yaw, and yaw is left alone."""
    law = ControlSettings(yaw_weight=0.0, rate_limit=99.0, yaw_rate_limit=99.0).attitude_law()
    for q in random_attitudes(50, 8):
        lean = Rotation.from_rotvec([0.4, -0.7, 0.0])
        rates = [
            rate_setpoint(law, goal(as_quat(lean * Rotation.from_rotvec([0.0, 0.0, yaw]))), q)
            for yaw in (-2.0, 0.0, 1.0, 3.0)
        ]
        for rate in rates:
            np.testing.assert_allclose(leaves(rate), leaves(rates[0]), atol=1e-9)
            assert rate.z == 0.0


def test_feed_forward_is_turned_into_the_body_and_rates_are_limited() -> None:
    limit = Vec(3.0, 2.0, 1.0)
    rng = np.random.default_rng(9)
    for q, desired in zip(random_attitudes(50, 10), random_attitudes(50, 11), strict=True):
        ahead = random_vec(rng, 3.0)
        body = as_rotation(q).inv().apply(as_rotation(desired).apply(ahead))
        without = rate_setpoint(FULL, goal(desired), q)
        got = rate_setpoint(FULL, goal(desired, ahead), q)
        np.testing.assert_allclose(leaves(got - without), body, atol=1e-12)
        cut = rate_setpoint(FULL._replace(limit=limit), goal(desired, ahead), q)
        np.testing.assert_allclose(leaves(cut), np.clip(leaves(got), -np.array(limit), limit))


@numba.njit
def closed_loop(law, rate_law, inertia, start, omega, desired, steps, h):  # type: ignore[no-untyped-def]
    """Attitude, rate loop and rigid body in free space; the largest error of the last tenth."""
    q, memory = start, rate_memory(omega)
    target = AttitudeTarget(desired, Vec(0.0, 0.0, 0.0), 0.0)
    worst = 0.0
    inverse = inverse_symmetric(inertia)
    for k in range(steps):
        setpoint = rate_setpoint(law, target, q)
        done = turn(rate_law, inertia, setpoint, omega, Vec(0.0, 0.0, 0.0), memory)
        memory = done.memory
        omega = omega + (inverse @ (done.moment - (omega ^ (inertia @ omega)))) * h
        dq = quaternion_rate(q, omega)
        q = normalise(Quat(q.w + h * dq.w, q.x + h * dq.x, q.y + h * dq.y, q.z + h * dq.z))
        e = attitude_error(q, desired)
        error = math.sqrt(e.x * e.x + e.y * e.y + e.z * e.z)
        if k > 0.9 * steps and error > worst:
            worst = error
    return worst


@pytest.mark.parametrize("kind", ["reduced", "full", "lee"])
def test_converges_from_a_thousand_attitudes(kind: Any) -> None:
    """With default gains and limits, inertia and rate loop, and spinning at up to 5 rad/s.

    Lee's error fades towards half a turn: it starts within 120° and at rest.
    """
    settings = ControlSettings(attitude=kind)
    law, rate_law = settings.attitude_law(), settings.rate_law()
    rng, counted = np.random.default_rng(12), 0
    for q, desired in zip(random_attitudes(1000, 13), random_attitudes(1000, 14), strict=True):
        omega = ZERO if kind == "lee" else random_vec(rng, 5.0)
        if kind == "lee" and attitude_error(q, desired).w < math.cos(math.radians(60.0)):
            continue
        counted += 1
        assert closed_loop(law, rate_law, INERTIA, q, omega, desired, 3000, 1e-3) < 1e-2
    assert counted > 300


def test_lee_with_the_rate_loop_is_lees_moment() -> None:
    """−k_R e_R − k_Ω e_Ω + ω × J ω with k_Ω = k_ω J, k_R = k_ω J/τ."""
    rate_law = ControlSettings(gyro_cutoff=0.0, rate_integral=0.0).rate_law()
    j, k = np.array(INERTIA), rate_law.gain.x
    rng = np.random.default_rng(15)
    for q, desired in zip(random_attitudes(100, 16), random_attitudes(100, 17), strict=True):
        omega, omega_d = random_vec(rng, 3.0), random_vec(rng, 3.0)
        setpoint = rate_setpoint(LEE, goal(desired, omega_d), q)
        got = turn(rate_law, INERTIA, setpoint, omega, ZERO, rate_memory(omega)).moment
        r, r_d = as_rotation(q).as_matrix(), as_rotation(desired).as_matrix()
        e = 0.5 * (r_d.T @ r - r.T @ r_d)
        e_r, w = np.array([e[2, 1], e[0, 2], e[1, 0]]), np.array(omega)
        e_w = w - r.T @ r_d @ np.array(omega_d)
        expected = -k * j @ e_r / TAU - k * j @ e_w + np.cross(w, j @ w)
        np.testing.assert_allclose(leaves(got), expected, atol=1e-11)


@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS.keys())
def test_plain_python_is_the_compiled_law(law: Any) -> None:
    """To the last bit, sines and arc tangents included."""

    @numba.njit
    def compiled(law, target, q):  # type: ignore[no-untyped-def]
        return rate_setpoint(law, target, q)

    for q, desired in zip(random_attitudes(200, 18), random_attitudes(200, 19), strict=True):
        target = goal(desired, Vec(0.1, 0.2, 0.3))
        assert compiled(law, target, q) == rate_setpoint(law, target, q)

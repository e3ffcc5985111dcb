"""Complementary filter: closed forms of its linearised loop, what it trusts, what a shock leaves."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from oracles.estimating import estimate_at, run
from oracles.inertial_flight import G, at_rest, flight, without_poses
from springback.kernels.trees import leaves
from springback.sensing.complementary import (
    LEAST_FORCE,
    MOST_FORCE,
    Complementary,
    complementary_memory,
)

TICK = 1e-3
BANDWIDTH = 20.0  # [1/s]
FILTER = Complementary(
    tick=TICK,
    interval=TICK,
    gravity=G,
    accelerometer_weight=0.2,
    heading_weight=0.1,
    bias_weight=0.1,
    largest_bias=0.05,
    decay=math.exp(-BANDWIDTH * TICK),
    whole=0.0,
)


def started(flown, error=None):
    start = estimate_at(flown)
    if error is not None:
        q = (flown.attitude[0] * Rotation.from_rotvec(error)).as_quat(scalar_first=True)
        start = start._replace(attitude=type(start.attitude)(*q.tolist()))
    return complementary_memory(FILTER, start)


def test_perfect_readings_leave_no_error():
    flown = flight(np.random.default_rng(1), 1.0, age=0.0)
    without = FILTER._replace(accelerometer_weight=0.0)
    result = run(without, started(flown), flown)
    assert np.abs(result.tilt_and_turn(flown)).max() < 1e-5
    assert np.abs(result.position - flown.position)[1:].max() < 1e-5
    assert np.abs(result.velocity - flown.velocity)[1:].max() < 1e-4


def test_plain_python_and_compiled_code_agree_to_the_last_bit():
    flown = flight(np.random.default_rng(2), 0.2)
    both = [run(FILTER, started(flown), flown, plain=plain) for plain in (True, False)]
    assert leaves(both[0].last) == leaves(both[1].last)


@pytest.mark.parametrize(
    "error", [[20.0, 0.0, 0.0], [0.0, -20.0, 0.0], [0.0, 0.0, 20.0], [12.0, -9.0, 13.0]]
)
def test_twenty_degrees_of_error_die_out(error):
    flown = at_rest(120.0)
    result = run(FILTER, started(flown, np.radians(error)), flown)
    left = np.degrees(np.linalg.norm(result.tilt_and_turn(flown), axis=1))
    assert left[0] > 19.8
    assert left[-1] < 0.05


@pytest.mark.parametrize(("axis", "weight"), [(0, 0.2), (1, 0.2), (2, 0.1)])
def test_small_errors_follow_the_linear_loop(axis, weight):
    # ė = −W e + b_err, ḃ_err = −W W_b e: s² + W s + W W_b = 0
    error = np.zeros(3)
    error[axis] = math.radians(0.5)
    flown = at_rest(20.0)
    result = run(FILTER, started(flown, error), flown)
    t = TICK * np.arange(1, 20001)
    real, root = -0.5 * weight, np.sqrt(complex(weight**2 / 4.0 - weight * FILTER.bias_weight))
    # e(0) = e0, ė(0) = −W e0
    wave = np.cosh(root * t) + (-weight - real) / root * np.sinh(root * t)
    expected = -error[axis] * np.exp(real * t) * wave.real
    # A heading's error is held from pose to pose, 5 ms: of 20 s, that is little.
    assert np.abs(result.tilt_and_turn(flown)[:, axis] - expected).max() < 2e-3 * error[axis]


def test_steady_gyroscope_bias_is_learnt():
    bias = np.array([0.01, -0.02, 0.005])
    flown = at_rest(120.0, spin=bias)
    result = run(FILTER, started(flown), flown)
    assert result.last.gyroscope_bias == pytest.approx(bias, abs=2e-5)
    assert np.abs(result.rate[-1]).max() < 2e-5


def test_bias_is_bounded_and_left_alone_in_fast_spin():
    flown = at_rest(60.0, spin=[0.09, 0.0, 0.0])
    assert run(FILTER, started(flown), flown).last.gyroscope_bias.x == FILTER.largest_bias
    flown = at_rest(5.0, spin=[0.2, 0.0, 0.0])
    assert run(FILTER, started(flown), flown).last.gyroscope_bias.x == 0.0


@pytest.mark.parametrize(
    ("sideways", "believed"), [(0.2, True), (0.44, True), (0.5, False), (2.0, False)]
)
def test_the_force_is_believed_near_g_only(sideways, believed):
    """A force along x beside gravity: 0.44 g makes 1.093 g, 0.5 g makes 1.118 g."""
    assert (LEAST_FORCE < math.hypot(1.0, sideways) < MOST_FORCE) == believed
    flown = without_poses(at_rest(2.0, force=[sideways * G, 0.0, 0.0]))
    tilt = run(FILTER, started(flown), flown).tilt_and_turn(flown)[-1]
    # It pulls "up" towards +x: the believed attitude pitches nose up, W sin(angle) per second.
    apparent = math.atan(sideways)
    expected = FILTER.accelerometer_weight * math.sin(apparent) * 2.0 if believed else 0.0
    assert tilt == pytest.approx([0.0, expected, 0.0], rel=0.25, abs=1e-12)
    flown = without_poses(at_rest(2.0, force=[0.0, 0.0, -0.15 * G]))
    assert np.abs(run(FILTER, started(flown), flown).tilt_and_turn(flown)).max() < 1e-12


def test_a_heading_half_a_second_old_no_longer_counts():
    flown = at_rest(3.0)
    only = replace(flown, fresh=np.where(np.arange(3001) == 5, 1.0, 0.0))
    result = run(FILTER._replace(bias_weight=0.0), started(flown, [0.0, 0.0, 0.2]), only)
    turn = result.tilt_and_turn(flown)[:, 2]
    assert turn[-1] == pytest.approx(-0.2 + FILTER.heading_weight * 0.2 * 0.5, abs=1e-4)
    assert turn[600] == pytest.approx(turn[-1], abs=1e-12)


def test_rotation_lost_by_clipping_stays_in_the_tilt():
    """A shock spins the robot by 60 rad/s for 10 ms; the gyroscope reads 35 of them."""
    kick = np.zeros((1001, 3))
    kick[100:110, 1] = 60.0
    angle = np.cumsum(TICK * kick, axis=0)
    attitude = Rotation.from_rotvec(angle)
    still = at_rest(1.0)
    up = attitude.inv().apply([0.0, 0.0, G])
    flown = replace(still, attitude=attitude, pose_attitude=attitude, spin=kick, force=up)
    result = run(FILTER, started(still), flown, clip=(157.0, 35.0))
    tilt = result.tilt_and_turn(flown)
    assert tilt[110] == pytest.approx([0.0, 0.010 * 25.0, 0.0], abs=1e-3)
    assert tilt[-1][1] > 0.8 * 0.010 * 25.0  # nearly a second later: 1/W is five


# -- position -------------------------------------------------------------------------------------


@pytest.mark.parametrize("age", [0.0, 0.0042])
def test_delay_leaves_no_bias_in_steady_motion(age):
    t, along, spin = TICK * np.arange(1001), np.array([3.0, -1.0, 0.5]), np.array([0.0, 0.0, 4.0])
    flown = replace(
        at_rest(1.0),
        position=np.outer(t, along),
        velocity=np.tile(along, (1001, 1)),
        attitude=Rotation.from_rotvec(np.outer(t, spin)),
        rate=np.tile(spin, (1001, 1)),
        spin=np.tile(spin, (1001, 1)),
        pose_position=np.outer(t - age, along),
        pose_attitude=Rotation.from_rotvec(np.outer(t - age, spin)),
        age=age,
    )
    result = run(FILTER, started(flown), flown)
    assert np.abs(result.position - flown.position)[1:].max() < 1e-10
    assert np.abs(result.velocity - flown.velocity)[1:].max() < 1e-10
    assert np.abs(result.tilt_and_turn(flown)).max() < 1e-10


def test_an_accelerometer_bias_leaves_the_error_of_the_closed_form():
    # In steady state each pose takes back the velocity b T that it gained: e (1 − z)²/T = b T
    bias, period = 0.3, 5e-3
    flown = at_rest(3.0, force=[bias, 0.0, 0.0])
    result = run(FILTER._replace(accelerometer_weight=0.0), started(flown), flown)
    z = math.exp(-BANDWIDTH * period)
    missed = bias * period**2 / (1.0 - z) ** 2
    assert result.position[3000] == pytest.approx([missed * z * z, 0.0, 0.0], rel=1e-9, abs=1e-15)


def test_a_wrong_velocity_fades_as_fast_as_told():
    # ė_p = e_v − 2ω e_p, ė_v = −ω² e_p for poses close together: e_v = (1 + ω t) e^{−ω t}.
    flown = at_rest(1.0, pose_every=1)
    memory = started(flown)
    memory = memory._replace(velocity=memory.velocity._replace(x=1.0))
    result = run(FILTER, memory, flown)
    t = TICK * np.arange(1, 1001)
    expected = (1.0 + BANDWIDTH * t) * np.exp(-BANDWIDTH * t)
    assert np.abs(result.velocity[1:, 0] - expected).max() < 0.02


def test_poses_take_back_a_wrong_tilt_as_fast_as_told():
    # Poses close together take back a share 2ωΔt each: the error fades as e^{−2ωt}.
    flown = at_rest(0.5, pose_every=1)
    error = np.array([0.02, -0.01, 0.005])
    memory = started(flown, error=error)
    alone = FILTER._replace(accelerometer_weight=0.0, heading_weight=0.0, whole=1.0)
    result = run(alone, memory, flown)
    left = np.linalg.norm(result.tilt_and_turn(flown), axis=1)
    t = TICK * np.arange(1, len(left))
    expected = np.linalg.norm(error) * np.exp(-2.0 * BANDWIDTH * t)
    assert left[1:] == pytest.approx(expected, rel=0.05, abs=1e-6)

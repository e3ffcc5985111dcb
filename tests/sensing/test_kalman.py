"""Error-state Kalman filter: consistent with its own covariance, blind to delay, equal to a dense one."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from builders.cases import nonempty
from oracles.dense_kalman import DenseKalman
from oracles.estimating import estimate_at, readings, run
from oracles.inertial_flight import G, Noise, at_rest, flight, without_poses
from springback.kernels.trees import leaves
from springback.kernels.vectors import Vec
from springback.sensing.kalman.filter import Deviations, Kalman, kalman_memory

TICK = 1e-3
RANGE = 16.0 * 9.80665
NOISE = Noise(
    accelerometer=5e-3,
    gyroscope=5e-4,
    accelerometer_walk=3e-3,
    gyroscope_walk=1e-4,
    position=3e-4,
    attitude=2e-3,
    accelerometer_bias=0.05,
    gyroscope_bias=2e-3,
)
START = Deviations(1e-3, 0.01, 0.01, NOISE.accelerometer_bias, NOISE.gyroscope_bias)
#: Register of three poses: every test uses this length, so that the filter is compiled once.
FILTER = Kalman(
    tick=TICK,
    interval=TICK,
    inertial_lag=0.0,
    every=4.0,
    pose_interval=5.0 * TICK,
    pose_phase=0.0,
    delays=(0.0, 5.0 * TICK, 10.0 * TICK),
    gravity=G,
    offset=Vec(0.0, 0.0, 0.0),
    accelerometer_noise=NOISE.accelerometer,
    gyroscope_noise=NOISE.gyroscope,
    accelerometer_walk=NOISE.accelerometer_walk,
    gyroscope_walk=NOISE.gyroscope_walk,
    accelerometer_range=RANGE,
    gyroscope_range=35.0,
    distrust=0.0,
    position_noise=NOISE.position,
    attitude_noise=NOISE.attitude,
)
OFFSET = (0.02, -0.01, 0.03)


def started(kalman, flown, deviations=START, generator=None):
    return kalman_memory(
        kalman, estimate_at(flown, 0, generator and deviations, generator), deviations
    )


def aware(kalman, flown, every=5):
    """The filter, which knows when the cameras of a flight expose: at an age before every so many ticks."""
    delays = tuple(k * every * TICK for k in range(3))
    return kalman._replace(pose_interval=every * TICK, pose_phase=-flown.age, delays=delays)


def dense(c):
    """The full covariance of its upper triangle."""
    upper, full = iter(np.array(leaves(c)).reshape(15, 3, 3)), np.zeros((15, 15))
    for i in range(5):
        for j in range(i, 5):
            block = next(upper)
            full[3 * i : 3 * i + 3, 3 * j : 3 * j + 3] = block
            full[3 * j : 3 * j + 3, 3 * i : 3 * i + 3] = block.T
    return full


# -- against an independent formulation -----------------------------------------------------------


def clipped_flight(duration):
    """Noise, an offset, a lag, a moment of clipped readings, and two poses under way at a time."""
    generator = np.random.default_rng(7)
    flown = flight(generator, duration, noise=NOISE, offset=OFFSET, age=0.0042, pose_every=2)
    flown.force[100:110, 1] += 300.0
    flown.spin[104:108, 2] -= 60.0
    kalman = FILTER._replace(offset=Vec(*OFFSET), distrust=0.01, inertial_lag=2e-4)
    return flown, aware(kalman, flown, 2), (RANGE, 35.0)


def test_agrees_with_dense_matrices():
    flown, kalman, clip = clipped_flight(0.4)
    mine = run(kalman, started(kalman, flown), flown, clip=clip)
    other, table = DenseKalman(kalman, estimate_at(flown), START), readings(flown, clip)
    for k in nonempty(range(1, len(table))):
        row = table[k]
        surprise = other.tick(
            row[0:3], row[3:6], row[14] > 0.5, row[7:10], flown.pose_attitude[k], row[15]
        )
        position, attitude, velocity, rate = other.spoken()
        assert np.allclose(mine.position[k], position, rtol=0.0, atol=1e-9)
        assert np.allclose(mine.velocity[k], velocity, rtol=0.0, atol=1e-9)
        assert np.allclose(mine.rate[k], rate, rtol=0.0, atol=1e-9)
        assert (mine.attitude[k - 1].inv() * attitude).magnitude() < 1e-9
        if surprise and k % mine.every == 0:
            memory = mine.memory(k)
            scale = np.sqrt(np.diag(other.cov))
            assert (
                np.abs(
                    (dense(memory.known.tree.covariance) - other.cov) / np.outer(scale, scale)
                ).max()
                < 1e-9
            )
            assert np.allclose(memory.known.tree.innovation, surprise, rtol=1e-6)


def both(kalman, flown):
    """Last positions of the filter and of the one with dense matrices."""
    mine = run(kalman, started(kalman, flown), flown)
    other, table = DenseKalman(kalman, estimate_at(flown), START), readings(flown)
    for k in range(1, len(table)):
        row = table[k]
        other.tick(row[0:3], row[3:6], row[14] > 0.5, row[7:10], flown.pose_attitude[k], row[15])
    return mine.position[-1], other.spoken()[0]


@pytest.mark.parametrize(("age", "lag"), [(0.0, 0.0), (0.0037, 0.0), (0.009, 5e-4), (0.013, -3e-4)])
def test_poses_are_kept_as_of_their_exposure(age, lag):
    # Between two inertial samples, and up to three periods ago.
    flown = flight(np.random.default_rng(8), 0.2, noise=NOISE, age=age)
    mine, other = both(aware(FILTER._replace(inertial_lag=lag), flown), flown)
    assert np.allclose(mine, other, rtol=0.0, atol=1e-10)


def test_poses_between_those_kept_are_interpolated():
    # Every sample's pose is kept here, not that of any exposure: a pose is then between two that are
    # kept, 1 ms apart, and a straight line misses the way between them by a T²/8 < 5e-6 m.
    flown = flight(np.random.default_rng(8), 0.2, noise=NOISE, age=0.0017)
    kalman = FILTER._replace(pose_interval=TICK, pose_phase=-0.003, delays=(0.0, TICK, 2.0 * TICK))
    mine, other = both(kalman, flown)
    assert np.allclose(mine, other, rtol=0.0, atol=1e-6)


def test_plain_python_and_compiled_code_agree_to_the_last_bit():
    flown, kalman, clip = clipped_flight(0.13)
    twins = [run(kalman, started(kalman, flown), flown, clip=clip, plain=p) for p in (True, False)]
    assert leaves(twins[0].last) == leaves(twins[1].last)
    assert np.array_equal(twins[0].position, twins[1].position)


def test_covariance_stays_symmetric_and_positive():
    flown, kalman, clip = clipped_flight(2.0)
    covariance = dense(
        run(kalman, started(kalman, flown), flown, clip=clip).last.known.tree.covariance
    )
    scale = np.sqrt(np.diag(covariance))
    assert np.linalg.eigvalsh(covariance / np.outer(scale, scale)).min() > 1e-6
    assert np.array_equal(covariance, covariance.T)


# -- statistics -----------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def many():
    """Two hundred flights with everything drawn as the filter assumes: surprises and last errors."""
    surprises, errors, flights = [], [], 200
    kalman = FILTER._replace(offset=Vec(*OFFSET))
    for seed in range(flights):
        generator = np.random.default_rng(seed)
        flown = flight(generator, 1.0, noise=NOISE, offset=OFFSET, age=0.004)
        kalman = aware(kalman, flown)
        result = run(kalman, started(kalman, flown, START, generator), flown)
        surprises.append(result.column(-2, None))  # the last two leaves
        n, r = result.last.track.nominal, flown.attitude[-1].apply(OFFSET)
        spin = flown.attitude[-1].apply(np.cross(flown.rate[-1], OFFSET))
        believed = Rotation.from_quat(n.attitude, scalar_first=True)
        error = [
            flown.position[-1] + r - n.position,
            flown.velocity[-1] + spin - n.velocity,
            (believed.inv() * flown.attitude[-1]).as_rotvec(),
            flown.accelerometer_bias[-1] - n.accelerometer_bias,
            flown.gyroscope_bias[-1] - n.gyroscope_bias,
        ]
        errors.append((np.concatenate(error), dense(result.last.known.tree.covariance)))
    return np.concatenate(surprises), errors


def test_innovations_are_as_large_as_expected(many):
    surprises, _ = many
    spread = math.sqrt(2.0 * 3.0 / len(surprises))  # of the mean of χ²(3)
    assert len(surprises) == 40000
    assert abs(surprises[:, 0].mean() - 3.0) < 4.0 * spread
    assert abs(surprises[:, 1].mean() - 3.0) < 4.0 * spread
    # and distributed so: χ²(3) exceeds 7.815 in one case of twenty
    assert np.mean(surprises > 7.815) == pytest.approx(0.05, abs=0.005)


def test_errors_are_as_large_as_the_covariance_says(many):
    _, errors = many
    count = len(errors)
    whole = [e @ np.linalg.solve(c, e) for e, c in errors]
    assert np.mean(whole) == pytest.approx(15.0, abs=4.0 * math.sqrt(30.0 / count))
    for k in range(0, 15, 3):
        block = slice(k, k + 3)
        part = [e[block] @ np.linalg.solve(c[block, block], e[block]) for e, c in errors]
        assert np.mean(part) == pytest.approx(3.0, abs=4.0 * math.sqrt(6.0 / count))
    white = np.array([np.linalg.solve(np.linalg.cholesky(c), e) for e, c in errors])
    sample = white.T @ white / count
    assert np.abs(sample - np.eye(15)).max() < 5.0 * math.sqrt(2.0 / count)


# -- delay ----------------------------------------------------------------------------------------


def steady(age, speed=5.0, spin=4.0):
    """Straight flight while spinning about the vertical, both steady, no noise."""
    base = at_rest(1.0)
    t = TICK * np.arange(1001)

    def turned(at):
        return Rotation.from_rotvec(np.outer(spin * at, [0.0, 0.0, 1.0]))

    along = np.array([speed, -0.4 * speed, 0.0])
    return replace(
        base,
        position=np.outer(t, along),
        velocity=np.tile(along, (1001, 1)),
        attitude=turned(t),
        rate=np.tile([0.0, 0.0, spin], (1001, 1)),
        spin=np.tile([0.0, 0.0, spin], (1001, 1)),
        pose_position=np.outer(t - age, along),
        pose_attitude=turned(t - age),
        age=age,
    )


@pytest.mark.parametrize("age", [0.0, 0.0033, 0.005])
def test_delay_leaves_no_bias_in_steady_motion(age):
    flown = steady(age)
    kalman = aware(FILTER, flown)
    result = run(kalman, started(kalman, flown), flown)
    assert np.abs(result.position - flown.position)[1:].max() < 1e-10
    assert np.abs(result.velocity - flown.velocity)[1:].max() < 1e-10
    assert np.abs(result.tilt_and_turn(flown)).max() < 1e-9  # interpolation by normalised means


def test_a_delay_not_told_is_a_bias_of_speed_times_delay():
    flown = replace(steady(0.005), age=0.0)
    result = run(FILTER, started(FILTER, flown), flown)
    assert result.position[-1] - flown.position[-1] == pytest.approx([-0.025, 0.01, 0.0], abs=3e-3)
    assert result.tilt_and_turn(flown)[-1][2] == pytest.approx(0.02, rel=0.1)


def test_delay_leaves_no_bias_in_an_impact_within_range():
    pulse = np.zeros((1001, 3))
    pulse[300:312, 0] = -140.0  # 14 g for 12 ms
    velocity = np.cumsum(TICK * pulse, axis=0)
    position = np.cumsum(TICK * velocity - 0.5 * TICK**2 * pulse, axis=0)
    late = np.vstack([np.zeros((4, 3)), position[:-4]])
    flown = replace(
        at_rest(1.0, force=pulse),
        position=position,
        velocity=velocity,
        pose_position=late,
        age=0.004,
    )
    kalman = aware(FILTER, flown)
    result = run(kalman, started(kalman, flown), flown)
    assert np.abs(result.position - position)[1:].max() < 1e-10
    assert np.abs(result.velocity - velocity)[1:].max() < 1e-9


def test_late_inertial_samples_are_made_up_for_in_steady_motion():
    # Readings of a steady motion do not change with a lag, so its estimate must not either.
    flown = steady(0.004)
    kalman = aware(FILTER._replace(inertial_lag=1e-3), flown)
    start = estimate_at(flown)
    shifted = start._replace(
        position=start.position - kalman.inertial_lag * start.velocity,
        attitude=estimate_at(
            replace(flown, attitude=flown.attitude * Rotation.from_rotvec([0, 0, -4e-3]))
        ).attitude,
    )
    result = run(kalman, kalman_memory(kalman, shifted, START), flown)
    assert np.abs(result.position - flown.position)[1:].max() < 1e-9
    assert np.abs(result.tilt_and_turn(flown)).max() < 1e-9


# -- biases and clipping --------------------------------------------------------------------------


def test_biases_are_found():
    noise = replace(NOISE, accelerometer_walk=0.0, gyroscope_walk=0.0)
    flown = flight(np.random.default_rng(3), 8.0, noise=noise)
    kalman = aware(FILTER._replace(accelerometer_walk=0.0, gyroscope_walk=0.0), flown)
    last = run(kalman, started(kalman, flown), flown).last
    sigma = np.sqrt(np.diag(dense(last.known.tree.covariance)))
    found = [
        np.array(last.track.nominal.accelerometer_bias),
        np.array(last.track.nominal.gyroscope_bias),
    ]
    assert np.linalg.norm(flown.gyroscope_bias[-1]) > 1e-3
    assert np.abs(found[0] - flown.accelerometer_bias[-1]).max() < 4.0 * sigma[9:12].max()
    assert np.abs(found[1] - flown.gyroscope_bias[-1]).max() < 4.0 * sigma[12:].max()
    assert sigma[12:].max() < 0.2 * NOISE.gyroscope_bias
    assert sigma[9:12].max() < 0.2 * NOISE.accelerometer_bias


def struck(duration=0.3):
    """A pulse of 60 g along −x for 10 ms; motion capture sees where it leads."""
    pulse = np.zeros((round(duration / TICK) + 1, 3))
    pulse[100:110, 0] = -60.0 * 9.80665
    velocity = np.cumsum(TICK * pulse, axis=0)
    position = np.cumsum(TICK * velocity - 0.5 * TICK**2 * pulse, axis=0)
    return replace(
        at_rest(duration, force=pulse), position=position, velocity=velocity, pose_position=position
    )


def test_velocity_lost_by_clipping_is_the_area_clipped():
    flown = without_poses(struck())
    result = run(FILTER, started(FILTER, flown), flown, clip=(RANGE, 35.0))
    lost = 0.010 * (60.0 - 16.0) * 9.80665
    error = result.velocity - flown.velocity
    assert error[99] == pytest.approx([0.0, 0.0, 0.0], abs=1e-12)
    assert error[109:] == pytest.approx(np.tile([lost, 0.0, 0.0], (len(error) - 109, 1)), abs=1e-9)


def test_distrust_of_clipped_readings_lets_poses_correct_them():
    flown, lost = struck(), 0.010 * 44.0 * 9.80665
    error = {}
    for distrust in (0.0, 0.01):
        kalman = FILTER._replace(distrust=distrust)
        result = run(kalman, started(kalman, flown), flown, clip=(RANGE, 35.0))
        error[distrust] = np.linalg.norm(result.velocity - flown.velocity, axis=1)
    assert error[0.01][104] > 0.2 * lost  # seen either way while it lasts
    assert error[0.01][125] < 0.05 * lost
    assert error[0.0][125] > 0.5 * lost
    assert error[0.0][300] > 10.0 * error[0.01][300]

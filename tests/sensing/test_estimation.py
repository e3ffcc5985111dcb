"""Estimators as a user writes them down."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
import pytest

from builders.cases import nonempty
from oracles.estimating import NOTHING, ZERO
from springback.errors import InputError
from springback.kernels.layout import TreeLayout, load
from springback.kernels.trees import leaves
from springback.kernels.vectors import Quat, Vec
from springback.sensing.complementary import Complementary
from springback.sensing.estimation import EstimatorSettings, KalmanSettings, Rhythm
from springback.sensing.kalman.filter import Kalman
from springback.sensing.measurement import (
    Estimate,
    Inertial,
    Measurement,
    Pose,
    believe,
    estimator_step,
)
from springback.sensing.parameters import SensorSettings
from springback.sensing.perfect import PerfectState
from springback.simulation.ticks import Lanes

RHYTHM = Rhythm(tick=1e-3, interval=1e-3, pose_age=0.0042)
TRUTH = Estimate(
    Vec(1.0, 2.0, 3.0), Quat(0.6, 0.8, 0.0, 0.0), Vec(4.0, 5.0, 6.0), Vec(7.0, 8.0, 9.0)
)


class Lane(NamedTuple):
    """The on-board systems as an estimator needs them."""

    estimator: Any
    seen: Measurement
    memory: Any
    estimate: Estimate
    tick: float


def seen(inertial_fresh=1.0, pose_fresh=0.0, exact=NOTHING):
    return Measurement(
        Inertial(Vec(0.0, 0.0, 9.81), ZERO, inertial_fresh),
        Pose(ZERO, Quat(1.0, 0.0, 0.0, 0.0), pose_fresh, 0.0),
        (0.1,),
        0.0,
        exact,
    )


@pytest.mark.parametrize(
    ("name", "kind"),
    [("kalman", Kalman), ("complementary", Complementary), ("perfect", PerfectState)],
)
def test_every_estimator_starts_from_what_it_is_told(name, kind):
    settings = EstimatorSettings(type=name)
    estimator = settings.estimator(RHYTHM, 9.81)
    assert isinstance(estimator, kind)
    start = NOTHING._replace(position=Vec(1.0, -2.0, 3.0))
    believed = estimator_step(estimator, 1.0, seen(exact=start), settings.memory(estimator, start))
    assert believed.estimate.position == pytest.approx(start.position, abs=1e-15)
    assert believed.estimate.velocity == pytest.approx(ZERO, abs=1e-15)


def test_perfect_state_is_what_is_revealed():
    settings = EstimatorSettings(type="perfect")
    estimator = settings.estimator(RHYTHM, 9.81)
    assert (
        estimator_step(
            estimator, 3.0, seen(exact=TRUTH), settings.memory(estimator, NOTHING)
        ).estimate
        == TRUTH
    )


def test_between_inertial_samples_the_estimate_goes_on_at_constant_rates():
    start = Estimate(ZERO, Quat(1.0, 0.0, 0.0, 0.0), Vec(2.0, 0.0, 0.0), Vec(0.0, 0.0, 3.0))
    for name in ("kalman", "complementary"):
        settings = EstimatorSettings(type=name, kalman={"inertial_lag": 0.0})
        estimator = settings.estimator(Rhythm(tick=1e-3, interval=4e-3), 9.81)
        memory = settings.memory(estimator, start)
        for tick in (1.0, 2.0):
            estimate, memory = estimator_step(estimator, tick, seen(inertial_fresh=0.0), memory)
        assert estimate.position == pytest.approx(Vec(4e-3, 0.0, 0.0), abs=1e-15)
        assert 2.0 * math.asin(estimate.attitude.z) == pytest.approx(6e-3)


@pytest.mark.parametrize("name", ["kalman", "complementary"])
@pytest.mark.parametrize("fresh", [(1.0, 1.0, 1.0), (0.0, 0.0, 0.0), (1.0, 0.0, 1.0)])
def test_lanes_believe_what_each_would_alone(name, fresh):
    """Lanes that have a sample, and lanes that wait for one."""
    settings = EstimatorSettings(type=name)
    estimator = settings.estimator(RHYTHM, 9.81)
    memory = settings.memory(estimator, TRUTH)
    avionics_list = [
        Lane(estimator, seen(has, pose_fresh=1.0 - k % 2), memory, NOTHING, 7.0)
        for k, has in enumerate(fresh)
    ]
    like, width = TreeLayout(avionics_list[0]), len(avionics_list)
    g = np.array([leaves(avionics) for avionics in avionics_list]).T.ravel()
    lanes = Lanes(like, g, width, 1, 7.0)
    believe(like.estimator, like.seen, like.memory, like.estimate, like.tick, lanes)
    for k, avionics in nonempty(enumerate(avionics_list)):
        alone = estimator_step(estimator, 7.0, avionics.seen, memory)
        for part, expected in ((like.estimate, alone.estimate), (like.memory, alone.memory)):
            assert leaves(load(part, g, width, k)) == pytest.approx(leaves(expected), abs=1e-15)


def test_slow_inertial_samples_cover_their_whole_interval():
    for name in ("kalman", "complementary"):
        settings = EstimatorSettings(type=name, kalman={"inertial_lag": 0.0})
        estimator = settings.estimator(Rhythm(tick=1e-3, interval=4e-3), 9.81)
        memory = settings.memory(estimator, NOTHING)
        falling = seen()._replace(inertial=Inertial(ZERO, ZERO, 1.0))
        for tick in range(1, 101):
            said = falling if tick % 4 == 0 else seen(inertial_fresh=0.0)
            estimate, memory = estimator_step(estimator, float(tick), said, memory)
        assert estimate.velocity.z == pytest.approx(-9.81 * 0.1)
        assert estimate.position.z == pytest.approx(-0.5 * 9.81 * 0.1**2)


def test_the_filter_speaks_for_the_main_body():
    offset = (0.1, -0.2, 0.05)
    settings = EstimatorSettings(kalman={"offset": offset, "inertial_lag": 0.0})
    estimator = settings.estimator(RHYTHM, 9.81)
    memory = settings.memory(estimator, TRUTH)
    assert memory.track.nominal.position != pytest.approx(TRUTH.position)
    quiet = seen(inertial_fresh=0.0)
    estimate, _ = estimator_step(estimator._replace(tick=0.0), 1.0, quiet, memory)
    for part, expected in zip(estimate, TRUTH, strict=True):
        assert part == pytest.approx(expected, abs=1e-12)


def test_the_register_reaches_back_to_the_oldest_pose():
    kalman = EstimatorSettings(kalman={"inertial_lag": 0.0}).estimator(RHYTHM, 9.81)
    assert kalman.delays == pytest.approx((0.0, 1e-3, 2e-3, 3e-3, 4e-3, 5e-3))
    told = {"tick": 1e-3, "interval": 1e-3, "pose_age": 0.01}
    assert EstimatorSettings().estimator(Rhythm(**told), 9.81).delays[-1] == pytest.approx(0.01)
    # At its arrival the pose of 10 ms ago is the last but one that is kept: the one of now comes
    # with the next sample, which is half a tick late.  Without that lag it is there already.
    known = Rhythm(**told, pose_interval=5e-3)
    assert EstimatorSettings().estimator(known, 9.81).delays == pytest.approx((0.0, 5e-3))
    kalman = EstimatorSettings(kalman={"inertial_lag": 0.0}).estimator(known, 9.81)
    assert kalman.delays == pytest.approx((0.0, 5e-3, 10e-3))
    assert EstimatorSettings().estimator(Rhythm(tick=1e-3, interval=1e-3), 9.81).delays == (0.0,)


@pytest.mark.parametrize("lag", [0.0, 5e-4, -5e-4])
@pytest.mark.parametrize(
    ("inertial", "cameras", "delay"),
    [(1, 5, 10), (1, 5, 7), (1, 5, 0), (3, 5, 7), (4, 10, 33), (5, 5, 10), (7, 5, 10), (5, 1, 6)],
)
def test_whatever_the_pace_a_delay_leaves_no_bias(
    inertial: int, cameras: int, delay: int, lag: float
) -> None:
    """Steady flight at 5 m/s, turning at 0.5 rad/s; periods and delay in ticks of 1 ms.

    A pose taken for one of another tick would be 5 mm away.
    """
    speed, spin, tick = Vec(5.0, -2.0, 0.0), Vec(0.0, 0.0, 0.5), 1e-3

    def at(time: float) -> Estimate:
        q = Quat(math.cos(0.25 * time), 0.0, 0.0, math.sin(0.25 * time))
        return Estimate(speed * time, q, speed, spin)

    rhythm = Rhythm(
        tick=tick, interval=inertial * tick, pose_age=delay * tick, pose_interval=cameras * tick
    )
    settings = EstimatorSettings(kalman={"inertial_lag": lag})
    estimator = settings.estimator(rhythm, 9.81)
    memory, worst = settings.memory(estimator, at(-lag)), 0.0
    for k in range(1, 200):
        then = at((k - delay) * tick)
        fresh = 1.0 if k >= delay and (k - delay) % cameras == 0 else 0.0
        felt = Inertial(Vec(0.0, 0.0, 9.81), spin, 1.0 if k % inertial == 0 else 0.0)
        pose = Pose(then.position, then.attitude, fresh, delay * tick)
        told = seen()._replace(inertial=felt, pose=pose)
        estimate, memory = estimator_step(estimator, float(k), told, memory)
        wrong = estimate.position - at(k * tick).position
        worst = max(worst, math.sqrt(wrong @ wrong))
    # A pose of the very tick comes before a sample that is late: that one is not made up for.
    assert worst < (1e-8 if delay * tick >= lag else 3e-3)


def test_defaults_are_those_of_the_sensors():
    held, real = KalmanSettings(), SensorSettings()
    a, g, m = real.imu.accelerometer, real.imu.gyroscope, real.motion_capture
    assert held.accelerometer_noise == a.noise
    assert held.accelerometer_walk == a.walk
    assert held.accelerometer_range == a.full_scale
    assert held.gyroscope_noise == g.noise
    assert held.gyroscope_walk == g.walk
    assert held.gyroscope_range == g.full_scale
    assert held.offset == real.imu.offset
    assert held.position_noise == m.position_noise
    assert held.attitude_noise == m.attitude_noise
    assert held.initial_accelerometer_bias == a.bias
    assert held.initial_gyroscope_bias == g.bias
    share = -math.expm1(-2.0 * math.pi * g.bandwidth * 1e-3)
    assert held.inertial_lag == pytest.approx(1e-3 * (1.0 - share) / share, rel=0.02)


def test_noise_is_inflated_and_clipping_distrusted_as_told():
    kalman = EstimatorSettings(kalman={"inflation": 3.0}).estimator(RHYTHM, 9.81)
    assert kalman.accelerometer_noise == pytest.approx(3.0 * 150e-6 * 9.80665)
    assert kalman.distrust == 0.01
    trusting = EstimatorSettings(kalman={"distrust_clipped": False}).estimator(RHYTHM, 9.81)
    assert trusting.distrust == 0.0


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"type": "magic"}, "kalman"),
        ({"kalman": {"position_noise": "-1 mm"}}, "more than 0 m"),
        ({"kalman": {"gyroscope_noise": "1 m"}}, "wrong unit"),
        ({"kalman": {"postion_noise": 1.0}}, "did you mean position_noise"),
        ({"kalman": {"every": 0}}, "greater than or equal to 1"),
        ({"complementary": {"bandwidth": 0.0}}, "more than 0 1/s"),
    ],
)
def test_bad_input_is_named(given, words):
    with pytest.raises(InputError, match=words):
        EstimatorSettings(**given)


def test_densities_take_units():
    kalman = KalmanSettings(
        gyroscope_noise="0.006 deg/s/Hz^0.5", accelerometer_noise="150e-6 g_0/Hz^0.5"
    )
    default = KalmanSettings()  # the presets were converted by another program: the last bit
    assert kalman.gyroscope_noise == pytest.approx(default.gyroscope_noise, rel=1e-15)
    assert kalman.accelerometer_noise == pytest.approx(default.accelerometer_noise, rel=1e-15)

"""Inertial unit: rigid-body kinematics, clipping before the filter, noise of the data sheet."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.signal import welch
from scipy.spatial.transform import Rotation

from springback.kernels.vectors import Quat, Vec
from springback.sensing.inertial import (
    WALK_EVERY,
    Channel,
    ChannelMemory,
    InertialNoise,
    InertialUnit,
    PerfectInertial,
    conversion,
    digital_word,
    inertial_at_start,
    inertial_sample,
    mean_specific_force,
    per_tick,
)
from springback.sensing.measurement import Truth, task_pace
from springback.sensing.parameters import STANDARD_GRAVITY, InertialSettings
from springback.vehicle.state import State

TICK, G = 1e-3, 9.81
ZERO = Vec(0.0, 0.0, 0.0)
LEVEL = Quat(1.0, 0.0, 0.0, 0.0)
QUIET = InertialNoise(ZERO, ZERO, ZERO, ZERO)


def quat(rotation: Rotation) -> Quat:
    return Quat(*rotation.as_quat(scalar_first=True).tolist())


def state(
    velocity: Vec = ZERO, attitude: Quat = LEVEL, omega: Vec = ZERO, position: Vec = ZERO
) -> State:
    return State(position, attitude, velocity, omega, (0.19,), (0.0,))


def silent(**changes: Any) -> InertialUnit:
    """The default unit without noise and bias."""
    device = InertialSettings().device(TICK, (ZERO, ZERO))
    assert isinstance(device, InertialUnit)
    a = device.accelerometer._replace(noise=0.0, drift=0.0)
    g = device.gyroscope._replace(noise=0.0, drift=0.0)
    return device._replace(accelerometer=a, gyroscope=g)._replace(**changes)


# -- what it feels --------------------------------------------------------------------------------


def test_at_rest_it_reads_gravity_upwards_and_in_free_fall_nothing() -> None:
    tilt = Rotation.from_euler("y", 30, degrees=True)  # nose down
    still = state(attitude=quat(tilt))
    at_rest = mean_specific_force(Truth(still, still, TICK, G), Vec(0.1, 0.2, 0.3))
    # Nose down: forward is below the horizon, so the upward push has a part backwards.
    np.testing.assert_allclose(at_rest, [-G / 2, 0.0, G * math.sqrt(0.75)], atol=1e-14)
    falling = Truth(state(), state(Vec(0.0, 0.0, -G * TICK)), TICK, G)
    np.testing.assert_allclose(mean_specific_force(falling, ZERO), 0.0, atol=1e-12)


def test_off_centre_it_feels_a_spin_as_the_closed_form_says() -> None:
    """Steady spin Ω about body z, angular acceleration about x: −Ω² (x, y) and (0, −α z, α y)."""
    spin, r = 30.0, Vec(0.03, -0.02, 0.05)
    omega = Vec(0.0, 0.0, spin)
    now = state(attitude=quat(Rotation.from_rotvec([0.0, 0.0, spin * TICK])), omega=omega)
    steady = mean_specific_force(Truth(state(omega=omega), now, TICK, G), r)
    np.testing.assert_allclose(steady, [-(spin**2) * r.x, -(spin**2) * r.y, G], rtol=1e-12)

    alpha = 500.0
    half = Vec(0.5 * alpha * TICK, 0.0, 0.0)
    begun = Truth(state(omega=-half), state(omega=half), TICK, 0.0)  # mean ω is zero
    np.testing.assert_allclose(
        mean_specific_force(begun, r), [0.0, -alpha * r.z, alpha * r.y], rtol=1e-12
    )


@given(st.integers(0, 10_000))
def test_it_is_the_acceleration_of_the_place_where_it_sits(seed: int) -> None:
    """Second formulation: difference of the sensor's own velocity v + R (ω × r), rotated back.

    Both take means over a tick in different ways; they differ by the square of the turn in it.
    """
    rng = np.random.default_rng(seed)
    omega, alpha, r = rng.normal(0, 3, 3), rng.normal(0, 20, 3), rng.normal(0, 0.05, 3)
    velocity, push = rng.normal(0, 2, 3), rng.normal(0, 50, 3)
    start, dt = Rotation.random(rng=rng), 1e-4
    middle = omega + 0.5 * alpha * dt
    end = start * Rotation.from_rotvec(middle * dt)
    before = state(Vec(*velocity), quat(start), Vec(*omega))
    now = state(Vec(*(velocity + push * dt)), quat(end), Vec(*(omega + alpha * dt)))
    ours = mean_specific_force(Truth(before, now, dt, G), Vec(*r))

    first = velocity + start.apply(np.cross(omega, r))
    last = velocity + push * dt + end.apply(np.cross(omega + alpha * dt, r))
    half = start * Rotation.from_rotvec(0.5 * middle * dt)
    other = half.inv().apply((last - first) / dt + [0.0, 0.0, G])
    np.testing.assert_allclose(ours, other, atol=1e-4)


def test_the_attitude_half_way_does_not_mind_the_sign_of_a_quaternion() -> None:
    q = quat(Rotation.from_rotvec([0.4, 0.1, -0.2]))
    turned = quat(Rotation.from_quat(q, scalar_first=True) * Rotation.from_rotvec([0, 0, 0.01]))
    flipped = Quat(*(-x for x in turned))
    one = mean_specific_force(Truth(state(attitude=q), state(attitude=turned), TICK, G), ZERO)
    two = mean_specific_force(Truth(state(attitude=q), state(attitude=flipped), TICK, G), ZERO)
    np.testing.assert_allclose(one, two, atol=1e-14)


def test_perfect_readings_add_up_to_the_change_of_velocity() -> None:
    rng, device = np.random.default_rng(1), PerfectInertial(ZERO)
    before, total, start = state(), np.zeros(3), Rotation.identity()
    for tick in range(50):
        turn = Rotation.from_rotvec(rng.normal(0, 0.02, 3))
        now = state(before.velocity + Vec(*rng.normal(0, 0.5, 3)), quat(start * turn))
        told_now = inertial_sample(device, float(tick), Truth(before, now, TICK, G), QUIET, None)
        half = start * turn**0.5
        total += (half.apply(told_now.inertial.specific_force) - [0, 0, G]) * TICK
        assert told_now.inertial.angular_velocity == now.angular_velocity
        assert told_now.inertial.fresh == 1.0
        before, start = now, start * turn
    np.testing.assert_allclose(total, before.velocity, atol=1e-12)


# -- what comes out -------------------------------------------------------------------------------


def readings(device: InertialUnit, accelerations: list[float]) -> np.ndarray[Any, Any]:
    """Readings along x while the main body is pushed along X [m/s²], tick by tick."""
    memory, before, out = inertial_at_start(device, state(), G), state(), []
    for tick, a in enumerate(accelerations):
        now = state(before.velocity + Vec(a * TICK, 0.0, 0.0))
        spoken = inertial_sample(device, float(tick), Truth(before, now, TICK, G), QUIET, memory)
        memory, before = spoken.memory, now
        out.append(spoken.inertial.specific_force.x)
    return np.array(out)


def test_an_impact_of_sixty_g_reads_sixteen() -> None:
    g = STANDARD_GRAVITY
    x = readings(silent(), [0.0] * 5 + [-60.0 * g] * 20 + [0.0] * 30)
    assert np.all(x[:5] == 0.0)
    assert x.min() == pytest.approx(-16.0 * g, rel=1e-9)
    assert x[-1] == 0.0
    # On the positive side the last word of a 16 bit converter is one short.
    y = readings(silent(), [60.0 * g] * 30)
    assert y.max() == pytest.approx(16.0 * g * (1.0 - 2.0**-15), rel=1e-9)


def test_it_clips_before_it_smooths() -> None:
    """A pulse of one tick: the filter goes its share of the way to 16 g, not to 60 g."""
    device, g = silent(), STANDARD_GRAVITY
    x = readings(device, [0.0, -60.0 * g, 0.0, 0.0])
    share = device.accelerometer.smoothing
    step = device.accelerometer.step
    assert x[1] == pytest.approx(-share * 16.0 * g, abs=step)
    assert x[2] == pytest.approx(-share * (1 - share) * 16.0 * g, abs=step)


def test_the_low_pass_answers_a_step_as_one_over_e_says() -> None:
    device = silent()
    a = 100.0
    x = readings(device, [a] * 10)
    times = TICK * np.arange(1, 11)
    expected = a * -np.expm1(-2 * math.pi * 218.1 * times)
    np.testing.assert_allclose(x, expected, atol=device.accelerometer.step)


def test_readings_are_whole_steps() -> None:
    """Data sheet: 2048 LSB/g at ±16 g and 16.4 LSB/(°/s) at ±2000 °/s."""
    device = silent()
    step = device.accelerometer.step
    assert STANDARD_GRAVITY / step == 2048.0
    assert math.radians(1.0) / device.gyroscope.step == pytest.approx(16.4, abs=0.02)
    x = readings(device, np.random.default_rng(2).normal(0.0, 20.0, 200).tolist())
    np.testing.assert_allclose(x / step, np.round(x / step), atol=1e-9)
    assert len(np.unique(np.round(x / step))) > 150


def run(channel: Channel, count: int, seed: int) -> np.ndarray[Any, Any]:
    """Output of a channel that feels nothing, shape (count, 3)."""
    rng = np.random.default_rng(seed)
    numbers = rng.standard_normal((count, 6)).tolist()
    memory, out = ChannelMemory(ZERO, ZERO), []
    for n in numbers:
        memory = conversion(channel, ZERO, Vec(*n[:3]), Vec(*n[3:]), memory)
        out.append(digital_word(channel, memory))
    return np.array(out)


@pytest.mark.parametrize(
    ("kind", "density"),
    [("accelerometer", 150e-6 * STANDARD_GRAVITY), ("gyroscope", math.radians(0.006))],
)
def test_noise_has_the_density_of_the_data_sheet(kind: str, density: float) -> None:
    unit = InertialSettings().device(TICK, (ZERO, ZERO))
    channel = getattr(unit, kind)._replace(drift=0.0)
    out = run(channel, 2**15, 7)
    f, power = welch(out, fs=1.0 / TICK, nperseg=1024, axis=0)
    low = (f > 2) & (f < 20)  # well below the corner, above the window's leakage
    # About 1700 independent periodogram values: 2.4 % of power, 1.2 % of density; band of 4 sigma.
    assert math.sqrt(power[low].mean()) == pytest.approx(density, rel=0.05)
    # The whole power: a first-order lag of white noise keeps a/(2 − a) of it; the quantum adds 1/12.
    a = channel.smoothing
    variance = channel.noise**2 * a / (2 - a) + channel.step**2 / 12
    assert out.var() == pytest.approx(variance, rel=0.03)


def test_noise_keeps_its_density_whatever_the_clock() -> None:
    for tick in (1e-3, 2.5e-4):
        numbers = per_tick(0.01, 0.2, 100.0, tick)
        assert numbers.noise**2 * 2 * tick == pytest.approx(0.01**2)
        assert numbers.drift**2 / (WALK_EVERY * tick) == pytest.approx(0.2**2)
        assert (1 - numbers.smoothing) ** (1 / tick) == pytest.approx(math.exp(-200 * math.pi))


def test_the_bias_walks_as_the_root_of_time() -> None:
    channel = Channel(
        0.0, Vec(0.1, -0.2, 0.3), per_tick(0.0, 0.02, 100.0, TICK).drift, 1e3, 1.0, 1e-9
    )
    one = conversion(
        channel, ZERO, ZERO, Vec(1.0, -1.0, 0.0), ChannelMemory(ZERO, Vec(1.0, 1.0, 1.0))
    )
    np.testing.assert_allclose(
        np.array(one.drift) - 1.0,
        np.array([1.0, -1.0, 0.0]) * 0.02 * math.sqrt(10 * TICK),
        atol=1e-15,
    )
    ends = np.array([run(channel, 250, seed)[-1] for seed in range(100)]) - [0.1, -0.2, 0.3]
    expected = 0.02 * math.sqrt(250 * 10 * TICK)  # each call is a step of the walk here
    assert ends.std() == pytest.approx(expected, rel=4.0 / math.sqrt(2 * 300))
    assert abs(ends.mean()) < 4 * expected / math.sqrt(300)


def test_the_bias_takes_a_step_every_ten_ticks() -> None:
    device, pushed = silent(), QUIET._replace(rotation_drift=Vec(1.0, 0.0, 0.0))
    device = device._replace(gyroscope=device.gyroscope._replace(drift=0.5))
    memory, drifts = inertial_at_start(device, state(), G), []
    for tick in range(25):
        memory = inertial_sample(
            device, float(tick), Truth(state(), state(), TICK, G), pushed, memory
        ).memory
        drifts.append(memory.gyroscope.drift.x)
    assert drifts == [0.5] * 10 + [1.0] * 10 + [1.5] * 5


def test_between_its_samples_the_last_word_stands() -> None:
    device = silent(every=task_pace(4.0))
    memory, before, words, fresh = inertial_at_start(device, state(), G), state(), [], []
    for tick in range(13):
        now = state(before.velocity + Vec(0.01 * tick, 0.0, 0.0), omega=Vec(tick * 0.1, 0.0, 0.0))
        spoken = inertial_sample(device, float(tick), Truth(before, now, TICK, G), QUIET, memory)
        memory, before = spoken.memory, now
        words.append(spoken.inertial.specific_force.x)
        fresh.append(spoken.inertial.fresh)
    assert fresh == [1.0 if tick % 4 == 0 else 0.0 for tick in range(13)]
    assert words[4] == words[5] == words[6] == words[7] != words[8]


def test_it_starts_settled() -> None:
    device = silent(offset=Vec(0.02, 0.0, 0.0))
    spinning = state(omega=Vec(0.0, 0.0, 20.0), attitude=quat(Rotation.from_euler("x", 0.3)))
    memory = inertial_at_start(device, spinning, G)
    after = state(
        omega=spinning.angular_velocity,
        attitude=quat(Rotation.from_euler("x", 0.3) * Rotation.from_rotvec([0, 0, 20.0 * TICK])),
    )
    first = inertial_sample(device, 0.0, Truth(spinning, after, TICK, G), QUIET, memory).inertial
    np.testing.assert_allclose(first.specific_force, memory.specific_force, atol=0.05)
    np.testing.assert_allclose(first.angular_velocity, [0, 0, 20.0], atol=1e-3)
    assert first.specific_force.x == pytest.approx(-400 * 0.02, abs=0.05)

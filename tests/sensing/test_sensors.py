"""The set of sensors: what it reveals, its noise, its settings, and plain Python against compiled."""

from __future__ import annotations

from typing import Any

import numba
import numpy as np
import pytest
from pydantic_core import PydanticCustomError

from builders.cases import nonempty
from springback.errors import InputError
from springback.frames import attitude_from_euler
from springback.kernels.trees import leaves
from springback.kernels.vectors import Quat, Vec
from springback.sensing.measurement import (
    Estimate,
    Measurement,
    SensorStep,
    Truth,
    due,
    sensor_step,
    task_pace,
)
from springback.sensing.parameters import HallSettings, SensorSettings
from springback.sensing.sensors import NOISE, Sensors, noise_count, sensors_at_start
from springback.vehicle.library import VEHICLES
from springback.vehicle.parameters import Vehicle
from springback.vehicle.state import State

TICK, G = 1e-3, 9.81
ARQ = VEHICLES["arq"].vehicle
PERFECT = {
    "motion_capture": {"perfect": True},
    "imu": {"perfect": True},
    "hall": {"perfect": True},
    "reveal": True,
}
ZERO = Estimate(
    Vec(0.0, 0.0, 0.0), Quat(0.0, 0.0, 0.0, 0.0), Vec(0.0, 0.0, 0.0), Vec(0.0, 0.0, 0.0)
)


def built(settings: SensorSettings, vehicle: Vehicle = ARQ, seed: int = 0) -> Sensors:
    return settings.sensors(TICK, vehicle, np.random.default_rng(seed))


def flight(count: int, arms: int, seed: int) -> list[State]:
    """A made-up flight with an impact in the middle: not a solution of anything, but it moves."""
    rng, states = np.random.default_rng(seed), []
    v, omega, x = np.zeros(3), np.zeros(3), np.zeros(3)
    for tick in range(count):
        hit = abs(tick - count // 2) < 8
        v = v + TICK * (rng.normal(0, 10, 3) - (900.0 if hit else 0.0) * np.array([1.0, 0.2, 0.0]))
        omega = omega + TICK * rng.normal(0, 200, 3)
        x = x + TICK * v
        attitude = attitude_from_euler(0.02 * tick, 0.2 * np.sin(0.01 * tick), 1.0)
        lengths = tuple((0.19 - (0.03 if hit else 0.001) * rng.random(arms)).tolist())
        states.append(
            State(
                Vec(*x.tolist()),
                Quat(*attitude),
                Vec(*v.tolist()),
                Vec(*omega.tolist()),
                lengths,
                (0.0,) * arms,
            )
        )
    return states


def one_tick(
    sensors: Any, tick: float, truth: Truth, noise: tuple[float, ...], memory: Any
) -> SensorStep:
    return sensor_step(sensors, tick, truth, noise, memory)


def told(
    sensors: Sensors, states: list[State], seed: int, step: Any = one_tick
) -> list[SensorStep]:
    rng, memory, result = np.random.default_rng(seed), sensors_at_start(sensors, states[0], G), []
    count = noise_count(len(states[0].arm_length))
    before = states[0]
    for tick, now in enumerate(states):
        noise = tuple(rng.standard_normal(count).tolist())
        answer = step(sensors, float(tick), Truth(before, now, TICK, G), noise, memory)
        memory, before = answer.memory, now
        result.append(answer)
    return result


GAPS = {"motion_capture": {"loss_probability": 0.1, "loss_length": 3.0}, "imu": {"rate": 500.0}}


@pytest.mark.parametrize(
    ("settings", "vehicle"),
    [(GAPS, "arq"), (PERFECT, "arq"), (GAPS, "arq-lumped"), (GAPS, "xplorer")],
)
def test_plain_python_and_compiled_are_twins(settings: dict[str, Any], vehicle: str) -> None:
    sensors = built(SensorSettings(**settings), VEHICLES[vehicle].vehicle, 3)
    states = flight(300, VEHICLES[vehicle].vehicle.arm_count, 4)
    plain = told(sensors, states, 5)
    compiled = told(sensors, states, 5, numba.njit(one_tick))
    for tick, (a, b) in nonempty(enumerate(zip(plain, compiled, strict=True))):
        assert leaves(a) == leaves(b), f"tick {tick}"


def test_perfect_sensors_tell_the_truth() -> None:
    states = flight(40, 4, 6)
    for now, answer in nonempty(
        zip(states, told(built(SensorSettings(**PERFECT)), states, 7), strict=True)
    ):
        m = answer.measurement
        assert (m.pose.position, m.pose.attitude) == (now.position, now.attitude)
        assert (m.pose.fresh, m.pose.age) == (1.0, 0.0)
        assert m.inertial.angular_velocity == now.angular_velocity
        assert m.arm_length == now.arm_length
        assert m.arm_length_fresh == m.inertial.fresh == 1.0
        assert m.exact == Estimate(now.position, now.attitude, now.velocity, now.angular_velocity)


def test_the_truth_stays_hidden_unless_asked_for() -> None:
    for answer in nonempty(told(built(SensorSettings()), flight(20, 4, 8), 9)):
        assert answer.measurement.exact == ZERO


def test_devices_do_not_share_noise() -> None:
    """Each of the normal numbers moves its own reading, and none moves a second device's."""
    settings = SensorSettings(
        motion_capture={"rate": 1000.0, "delay": 0.0, "loss_probability": 0.5, "loss_length": 2.0},
        hall={"rate": 1000.0, "delay": 0.0, "noise": 0.1},
    )
    sensors, start = built(settings), flight(1, 4, 1)[0]
    memory = sensors_at_start(sensors, start, G)
    truth = Truth(start, start, TICK, G)

    def answer(index: int | None) -> Measurement:
        noise = [0.5] * noise_count(4)
        if index is not None:
            noise[index] = -60.0
        return sensor_step(sensors, 0.0, truth, tuple(noise), memory).measurement

    still = answer(None)

    def moved(index: int) -> set[str]:
        now = answer(index)
        parts = {"position": lambda m: m.pose.position, "attitude": lambda m: m.pose.attitude,
                 "gap": lambda m: m.pose.fresh, "force": lambda m: m.inertial.specific_force,
                 "turn": lambda m: m.inertial.angular_velocity}  # fmt: skip
        parts |= {f"arm {j}": lambda m, j=j: m.arm_length[j] for j in range(4)}
        return {name for name, part in parts.items() if part(now) != part(still)}

    assert noise_count(4) == NOISE + 4
    assert [moved(k) for k in range(3)] == [{"position"}] * 3
    assert [moved(k) for k in range(3, 6)] == [{"attitude"}] * 3
    assert "gap" in moved(6)
    assert [moved(k) for k in (7, 8, 9, 13, 14, 15)] == [{"force"}] * 6
    assert [moved(k) for k in (10, 11, 12)] == [{"turn"}] * 3
    assert [moved(NOISE + j) for j in range(4)] == [{f"arm {j}"} for j in range(4)]


def test_memory_is_returned_and_never_changed() -> None:
    sensors, states = built(SensorSettings()), flight(3, 4, 2)
    memory = sensors_at_start(sensors, states[0], G)
    kept = leaves(memory)
    truth = Truth(states[0], states[1], TICK, G)
    first = sensor_step(sensors, 0.0, truth, (0.7,) * noise_count(4), memory)
    again = sensor_step(sensors, 0.0, truth, (0.7,) * noise_count(4), memory)
    assert first == again
    assert leaves(memory) == kept


# -- settings -------------------------------------------------------------------------------------


def test_biases_differ_from_flight_to_flight_as_asked_for() -> None:
    settings = SensorSettings()
    flights = [built(settings, seed=seed).inertial for seed in range(400)]
    a = np.array([unit.accelerometer.bias for unit in flights])
    g = np.array([unit.gyroscope.bias for unit in flights])
    band = 4.0 / np.sqrt(2 * 1200)
    assert a.std() == pytest.approx(0.05, rel=band)
    assert g.std() == pytest.approx(np.radians(0.1), rel=band)
    assert abs(np.corrcoef(a.ravel(), g.ravel())[0, 1]) < 4 / np.sqrt(1200)
    assert built(settings, seed=1) == built(settings, seed=1)


@pytest.mark.parametrize(
    ("given", "field", "words"),
    [
        ({"imu": {"rate": 300}}, "imu.rate", ("1000 Hz", "got 300 Hz", "333.333 Hz", "250 Hz")),
        ({"motion_capture": {"rate": 2000}}, "motion_capture.rate", ("got 2000 Hz", "1000 Hz")),
        ({"hall": {"rate": 1e10}}, "hall.rate", ("got 1e+10 Hz", "nearest: 1000 Hz")),
        ({"hall": {"delay": 0.0123456}}, "hall.delay", ("whole number of ticks", "0.0123456 s")),
        ({"motion_capture": {"delay": 0.025}}, "motion_capture.delay", ("at most 4", "0.02 s")),
    ],
)
def test_what_does_not_fit_the_clock_is_refused(
    given: dict[str, Any], field: str, words: tuple[str, ...]
) -> None:
    with pytest.raises(PydanticCustomError) as caught:
        built(SensorSettings(**given))
    assert caught.value.context is not None
    assert caught.value.context["field"] == field
    for word in words:
        assert word in caught.value.message()


def test_units_are_read_and_checked() -> None:
    settings = SensorSettings(
        imu={"accelerometer": {"full_scale": "30 g_0", "noise": "75e-6 g_0/Hz^0.5"}},
        motion_capture={"rate": "0.1 kHz", "delay": "20 ms", "attitude_noise": "1 deg"},
    )
    device = built(settings)
    assert device.inertial.accelerometer.full_scale == pytest.approx(30 * 9.80665)
    assert (device.motion_capture.every.ticks, device.motion_capture.delay) == (10.0, 20.0)
    with pytest.raises(InputError, match=r"must be at most 1 \(got 1.5\)"):
        SensorSettings(motion_capture={"loss_probability": 1.5})
    with pytest.raises(InputError, match="did you mean remanence"):
        HallSettings(remanance=1.3)


@pytest.mark.parametrize("every", [1, 2, 3, 4, 5, 7, 10, 49, 50, 1000])
def test_what_is_due_every_few_ticks_is_due_then_and_only_then(every: int) -> None:
    pace = task_pace(float(every))
    ticks = [*range(5 * every), *range(10**9, 10**9 + 5 * every)]
    assert [due(float(k), pace) for k in ticks] == [k % every == 0 for k in ticks]


def test_a_clock_of_another_rate_gives_the_same_devices() -> None:
    fast = SensorSettings().sensors(2.5e-4, ARQ, np.random.default_rng(0))
    devices = fast.motion_capture, fast.inertial, fast.arm_length
    assert [device.every.ticks for device in devices] == [20, 4, 20]

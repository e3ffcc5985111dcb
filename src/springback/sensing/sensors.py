"""A robot's set of sensors: motion capture, an inertial unit, and arm lengths."""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.kernels.compiler import kernel
from springback.kernels.layout import TreeLayout, load, rows, store
from springback.kernels.vectors import Quat, Vec
from springback.sensing.clock import draws
from springback.sensing.hall import arms_at_start, arms_read, read_arms
from springback.sensing.inertial import InertialNoise, inertial_at_start, inertial_sample
from springback.sensing.measurement import Estimate, Measurement, SensorStep, Truth, sensor_step
from springback.sensing.motion_capture import capture, motion_capture_at_start, noise_of, pose_of
from springback.simulation.onboard import Draw
from springback.simulation.ticks import Group, TickNoise, look, state_of, truth_of
from springback.vehicle.state import State

#: Channels of standard normal numbers of motion capture: 0-2 position, 3-5 attitude, 6 gaps ...
MOTION_CAPTURE_NOISE = 7
#: ... and of the inertial unit: 7-9 accelerometer, 10-12 gyroscope, 13-15 and 16-18 their biases.
INERTIAL_NOISE = 12
#: Channels at each tick, before one for each arm.
NOISE = MOTION_CAPTURE_NOISE + INERTIAL_NOISE


class Sensors(NamedTuple):
    """Settings of a set of sensors.

    Every choice is a type, so that the others cost nothing.
    """

    motion_capture: Any  # MotionCapture, PerfectMotionCapture, or a type registered with captured
    inertial: Any  # InertialUnit, PerfectInertial, or a type registered with inertial_sample
    arm_length: Any  # HallSensors, PerfectArmLengths, or a type registered with arms_read
    reveal: float  # 1: the exact state is added; 0: it is zeros


class SensorsMemory(NamedTuple):
    """Memory of each device."""

    motion_capture: Any
    inertial: Any
    arm_length: Any


def noise_count(arm_count: int) -> int:
    """Number of standard normal numbers that `sensor_step` uses at each tick.

    It does not depend on the chosen devices.
    """
    return NOISE + arm_count


def draws_of(sensors: Sensors, arm_count: int) -> tuple[Draw, ...]:
    """Schedule of the noise of all devices; plain Python.

    Every device has its own noise, so that two sets of sensors can be compared on the same noise.
    """
    return (
        *draws(sensors.motion_capture, MOTION_CAPTURE_NOISE),
        *draws(sensors.inertial, INERTIAL_NOISE),
        *draws(sensors.arm_length, arm_count),
    )


def sensors_at_start(sensors: Sensors, start: State, gravity: float) -> SensorsMemory:
    """Memory of all sensors before tick 0; plain Python.

    Args:
        sensors: Settings.
        start: State at tick 0.
        gravity: g along −Z [m/s²].
    """
    return SensorsMemory(
        motion_capture_at_start(sensors.motion_capture, start),
        inertial_at_start(sensors.inertial, start, gravity),
        arms_at_start(sensors.arm_length, start),
    )


@kernel
def exact_estimate(state: State, reveal: float) -> Estimate:
    """Exact motion, or zeros if ``reveal`` is 0."""
    q, s = state.attitude, reveal
    attitude = Quat(s * q.w, s * q.x, s * q.y, s * q.z)
    return Estimate(s * state.position, attitude, s * state.velocity, s * state.angular_velocity)


@kernel
def _inertial_noise(noise: tuple[float, ...]) -> InertialNoise:
    n = noise
    white_a, white_g = Vec(n[7], n[8], n[9]), Vec(n[10], n[11], n[12])
    walk_a, walk_g = Vec(n[13], n[14], n[15]), Vec(n[16], n[17], n[18])
    return InertialNoise(white_a, white_g, walk_a, walk_g)


@sensor_step.register(Sensors)
@kernel
def _sensor_step(
    sensors: Sensors, tick: float, truth: Truth, noise: tuple[float, ...], memory: SensorsMemory
) -> SensorStep:
    posed = pose_of(sensors.motion_capture, tick, truth, noise_of(noise), memory.motion_capture)
    moved = inertial_sample(sensors.inertial, tick, truth, _inertial_noise(noise), memory.inertial)
    arms = arms_read(sensors.arm_length, tick, truth, noise[19:], memory.arm_length)

    exact = exact_estimate(truth.now, sensors.reveal)
    measurement = Measurement(moved.inertial, posed.pose, arms.length, arms.fresh, exact)
    return SensorStep(measurement, SensorsMemory(posed.memory, moved.memory, arms.memory))


@look.register(Sensors)
@kernel
def _look(sensors: TreeLayout, group: Group, noise: TickNoise) -> None:
    """Batch version of `sensor_step`, one device after the other for all lanes."""
    avionics, g, w, once, tick = group.lanes
    capture(sensors.motion_capture, group, noise)
    memory, seen, revealing = avionics.onboard.sensors.inertial, avionics.onboard.measurement, 0
    for i in range(w * once):
        drawn = _inertial_noise(load(noise.channels, noise.drawn, w, i))
        truth, before = truth_of(group, i), load(memory, g, w, i)
        moved = inertial_sample(load(sensors.inertial, g, w, i), tick, truth, drawn, before)
        store(moved.inertial, seen.inertial, g, w, i)
        store(moved.memory, memory, g, w, i)
        revealing += 1 if load(sensors.reveal, g, w, i) > 0.0 else 0
    for i in range(w * once if revealing > 0 else 0):  # otherwise zeros are there
        state, reveal = state_of(group, i), load(sensors.reveal, g, w, i)
        store(exact_estimate(state, reveal), seen.exact, g, w, i)
    arms = seen.arm_length
    own = TickNoise(arms, noise.drawn, rows(noise.channels) - rows(arms))
    read_arms(sensors.arm_length, group, own)

"""Motion capture: poses at a fixed rate, late, a little wrong, and at times not at all."""

from __future__ import annotations

import functools
from typing import Any, NamedTuple

from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import Seldom, pick
from springback.kernels.vectors import Quat, Vec, normalised, quaternion_rate
from springback.sensing.clock import draws
from springback.sensing.measurement import Pose, Truth, due
from springback.sensing.memory import Line, Nothing, arriving, entered, filled
from springback.simulation.aboard import Draw
from springback.vehicle.state import State


class PerfectMotionCapture(NamedTuple):
    """The exact pose at every tick, without delay."""

    unused: float


class MotionCapture(NamedTuple):
    """Cameras that see markers on the main body.

    Samples are lost in gaps (Gilbert's two-state channel, Bell System Technical Journal 39, 1960):
    in sight, the next sample is lost with a probability p; lost, the next is back with a
    probability r.  Both are kept as quantiles of the normal law: z < Φ⁻¹(p) has probability p.
    """

    every: float  # sampling period [ticks]
    delay: float  # from exposure to arrival [ticks], at most four periods
    position_noise: float  # standard deviation, each axis [m]
    attitude_noise: float  # standard deviation of the rotation vector, each axis [rad]
    loss: float  # Φ⁻¹(p)
    recovery: float  # Φ⁻¹(r)


class MotionCaptureNoise(NamedTuple):
    """Standard normal numbers for one tick."""

    position: Vec
    attitude: Vec
    loss: float


class Exposure(NamedTuple):
    """One sample as the cameras took it."""

    position: Vec  # [m]
    attitude: Quat
    seen: float  # 1, or 0 where the markers were not in sight


class MotionCaptureMemory(NamedTuple):
    """Samples under way, and the last that arrived."""

    line: Line  # of Exposure
    lost: float  # 1 while the markers are out of sight
    last: Exposure
    taken_at: float  # tick of exposure of the last that arrived


class Captured(NamedTuple):
    """A pose, and what the device remembers."""

    pose: Pose
    memory: Any


@generic
def captured(
    device: Any, tick: float, truth: Truth, noise: MotionCaptureNoise, memory: Any
) -> Captured:
    """What motion capture says at a tick.

    Args:
        device: `MotionCapture` or `PerfectMotionCapture`.
        tick: Number of the tick, from 0.
        truth: The motion over the last tick.
        noise: Independent standard normal numbers.
        memory: Of the device.
    """
    raise TypeError(f"{type(device).__name__} is no motion capture; register captured for it")


@captured.register(PerfectMotionCapture)
@kernel
def _perfect(
    device: PerfectMotionCapture,
    tick: float,
    truth: Truth,
    noise: MotionCaptureNoise,
    memory: Nothing,
) -> Captured:
    return Captured(Pose(truth.now.position, truth.now.attitude, 1.0, 0.0), memory)


@kernel
def turned(attitude: Quat, angles: Vec) -> Quat:
    """An attitude turned by a small rotation vector in body axes [rad].

    q + ½ q ⊗ (0, θ), normalised, is a turn by 2 atan(|θ|/2), short of |θ| by |θ|³/12.
    """
    rate = quaternion_rate(attitude, angles)
    w, x, y, z = attitude.w + rate.w, attitude.x + rate.x, attitude.y + rate.y, attitude.z + rate.z
    return normalised(Quat(w, x, y, z))


@kernel
def _lost(device: MotionCapture, lost: float, normal: float) -> float:
    """Whether the next sample is lost, 1 or 0, after whether the last one was."""
    stays = 0.0 if normal < device.recovery else 1.0
    begins = 1.0 if normal < device.loss else 0.0
    return stays if lost > 0.5 else begins


@kernel
def _exposed(
    device: MotionCapture, state: State, noise: MotionCaptureNoise, m: MotionCaptureMemory
) -> MotionCaptureMemory:
    """The cameras take a sample."""
    lost = _lost(device, m.lost, noise.loss)
    position = state.position + device.position_noise * noise.position
    attitude = turned(state.attitude, device.attitude_noise * noise.attitude)
    line = entered(m.line, Exposure(position, attitude, 1.0 - lost))
    return MotionCaptureMemory(line, lost, m.last, m.taken_at)


@captured.register(MotionCapture)
@kernel
def _captured(
    device: MotionCapture,
    tick: float,
    truth: Truth,
    noise: MotionCaptureNoise,
    memory: Seldom,
) -> Captured:
    since, m, fresh = tick - device.delay, memory.tree, 0.0
    exposing = due(tick, device.every)
    delivering = (since > -0.5) & due(since, device.every)
    if exposing:
        m = _exposed(device, truth.now, noise, m)
    if delivering:
        arrived = arriving(m.line, device.delay, device.every)
        fresh = arrived.seen
        m = pick(fresh > 0.5, MotionCaptureMemory(m.line, m.lost, arrived, since), m)
    pose = Pose(m.last.position, m.last.attitude, fresh, (tick - m.taken_at) * truth.duration)
    return Captured(pose, Seldom(1.0 if exposing | delivering else 0.0, m))


@draws.register
def _(device: PerfectMotionCapture, channels: int) -> tuple[Draw, ...]:
    return (Draw(channels, 0),)


@draws.register
def _(device: MotionCapture, channels: int) -> tuple[Draw, ...]:
    return (Draw(channels, round(device.every)),)


@functools.singledispatch
def motion_capture_at_start(device: Any, start: State) -> Any:
    """Memory of a motion capture before its first tick; until a pose arrives, the start's stands.

    Plain Python.

    Args:
        device: `MotionCapture` or `PerfectMotionCapture`.
        start: State at tick 0.
    """
    return Nothing(0.0)


@motion_capture_at_start.register
def _(device: MotionCapture, start: State) -> Seldom:
    exposure = Exposure(start.position, start.attitude, 1.0)
    return Seldom(0.0, MotionCaptureMemory(filled(exposure), 0.0, exposure, 0.0))

"""Motion capture: poses at a fixed rate, with delay, noise and gaps."""

from __future__ import annotations

import functools
from typing import Any, NamedTuple

from springback.kernels.compiler import generic, kernel
from springback.kernels.layout import TreeLayout, load, store
from springback.kernels.tree_code import Rarely
from springback.kernels.trees import select
from springback.kernels.vectors import Quat, Vec, normalise, quaternion_rate
from springback.sensing.clock import draws
from springback.sensing.measurement import Pace, Pose, Truth, due
from springback.sensing.memory import Line, Nothing, arrival, constant_line, push
from springback.simulation.onboard import Draw
from springback.simulation.ticks import Group, TickNoise, state_of, truth_of
from springback.vehicle.state import State


class PerfectMotionCapture(NamedTuple):
    """The exact pose at every tick, without delay."""

    unused: float


class MotionCapture(NamedTuple):
    """Cameras that track markers on the main body.

    Samples are lost in gaps (Gilbert's two-state channel, Bell System Technical Journal 39, 1960):
    in sight, the next sample is lost with probability p; in a gap, the next is back with
    probability r.  Both are stored as quantiles of the normal distribution: z < Φ⁻¹(p) has
    probability p.
    """

    every: Pace  # of its samples
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
    """One sample at its exposure."""

    position: Vec  # [m]
    attitude: Quat
    seen: float  # 1, or 0 if the markers were out of sight


class MotionCaptureMemory(NamedTuple):
    """Samples in transit, and the last that arrived."""

    line: Line  # of Exposure
    lost: float  # 1 while the markers are out of sight
    last: Exposure
    taken_at: float  # tick of exposure of the last that arrived


class CaptureStep(NamedTuple):
    """A pose, and the memory of the device."""

    pose: Pose
    memory: Any


@generic
def pose_of(
    device: Any, tick: float, truth: Truth, noise: MotionCaptureNoise, memory: Any
) -> CaptureStep:
    """Output of motion capture at a tick.

    Args:
        device: `MotionCapture` or `PerfectMotionCapture`.
        tick: Number of the tick, from 0.
        truth: The motion over the last tick.
        noise: Independent standard normal numbers.
        memory: Memory of the device.
    """
    raise TypeError(f"{type(device).__name__} is not motion capture; register pose_of for it")


@pose_of.register(PerfectMotionCapture)
@kernel
def _perfect(
    device: PerfectMotionCapture,
    tick: float,
    truth: Truth,
    noise: MotionCaptureNoise,
    memory: Nothing,
) -> CaptureStep:
    return CaptureStep(Pose(truth.now.position, truth.now.attitude, 1.0, 0.0), memory)


@kernel
def rotate_by(attitude: Quat, angles: Vec) -> Quat:
    """Attitude rotated by a small rotation vector in body axes [rad].

    q + ½ q ⊗ (0, θ), normalised, is a rotation by 2 atan(|θ|/2), less than |θ| by |θ|³/12.
    """
    rate = quaternion_rate(attitude, angles)
    w, x, y, z = attitude.w + rate.w, attitude.x + rate.x, attitude.y + rate.y, attitude.z + rate.z
    return normalise(Quat(w, x, y, z))


@kernel
def _lost(device: MotionCapture, lost: float, normal: float) -> float:
    """Loss of the next sample, 1 or 0, given that of the last."""
    stays = 0.0 if normal < device.recovery else 1.0
    begins = 1.0 if normal < device.loss else 0.0
    return stays if lost > 0.5 else begins


@kernel
def _expose(
    device: MotionCapture, state: State, noise: MotionCaptureNoise, lost: float
) -> Exposure:
    """Exposure at a state; ``lost`` is 1 if the last sample was lost."""
    position = state.position + device.position_noise * noise.position
    attitude = rotate_by(state.attitude, device.attitude_noise * noise.attitude)
    return Exposure(position, attitude, 1.0 - _lost(device, lost, noise.loss))


@kernel
def _is_exposure_due(device: MotionCapture, tick: float) -> bool:
    return due(tick, device.every)


@kernel
def _is_delivery_due(device: MotionCapture, tick: float) -> bool:
    since = tick - device.delay
    return (since > -0.5) & due(since, device.every)


@kernel
def _deliver(
    device: MotionCapture, tick: float, period: float, m: MotionCaptureMemory
) -> CaptureStep:
    """Pose at a tick, after its exposure, with a sample that may arrive."""
    arrived = arrival(m.line, device.delay, device.every.ticks)
    fresh = select(_is_delivery_due(device, tick), arrived.seen, 0.0)
    last = select(fresh > 0.5, arrived, m.last)
    taken_at = select(fresh > 0.5, tick - device.delay, m.taken_at)
    pose = Pose(last.position, last.attitude, fresh, (tick - taken_at) * period)
    return CaptureStep(pose, MotionCaptureMemory(m.line, m.lost, last, taken_at))


@pose_of.register(MotionCapture)
@kernel
def _capture(
    device: MotionCapture,
    tick: float,
    truth: Truth,
    noise: MotionCaptureNoise,
    memory: Rarely,
) -> CaptureStep:
    m, exposing = memory.tree, _is_exposure_due(device, tick)
    sample = _expose(device, truth.now, noise, m.lost)
    line = select(exposing, push(m.line, sample), m.line)
    lost = select(exposing, 1.0 - sample.seen, m.lost)
    after = MotionCaptureMemory(line, lost, m.last, m.taken_at)
    got_now = _deliver(device, tick, truth.duration, after)
    new = select(exposing | _is_delivery_due(device, tick), 1.0, 0.0)
    return CaptureStep(got_now.pose, Rarely(new, got_now.memory))


@generic
def capture(device: TreeLayout, group: Group, noise: TickNoise) -> None:
    """Motion capture of all lanes; arguments as for `springback.simulation.ticks.look`."""
    _capture_lanes(device, group, noise)


@kernel
def noise_of(drawn: tuple[float, ...]) -> MotionCaptureNoise:
    """Noise of motion capture, from its channels."""
    n = drawn
    return MotionCaptureNoise(Vec(n[0], n[1], n[2]), Vec(n[3], n[4], n[5]), n[6])


@kernel
def _capture_lanes(device: TreeLayout, group: Group, noise: TickNoise) -> None:
    avionics, g, w, once, tick = group.lanes
    memory, pose = avionics.onboard.sensors.motion_capture, avionics.onboard.measurement.pose
    for i in range(w * once):
        drawn = noise_of(load(noise.channels, noise.drawn, w, i))
        truth, before = truth_of(group, i), load(memory, g, w, i)
        posed = pose_of(load(device, g, w, i), tick, truth, drawn, before)
        store(posed.pose, pose, g, w, i)
        store(posed.memory, memory, g, w, i)


@capture.register(MotionCapture)
@kernel
def _capture_at_times(device: TreeLayout, group: Group, noise: TickNoise) -> None:
    """Batch version of `pose_of`; between exposures and arrivals the last pose only ages."""
    avionics, g, w, once, tick = group.lanes
    memory, pose = avionics.onboard.sensors.motion_capture.tree, avionics.onboard.measurement.pose
    exposing, delivering, line = 0, 0, memory.line
    for i in range(w * once):
        camera, period = load(device, g, w, i), load(avionics.systems.period, g, w, i)
        exposing += 1 if _is_exposure_due(camera, tick) else 0
        delivering += 1 if _is_delivery_due(camera, tick) | (tick < 0.5) else 0
        store(0.0, pose.fresh, g, w, i)
        store((tick - load(memory.taken_at, g, w, i)) * period, pose.age, g, w, i)
    for i in range(w * once if exposing > 0 else 0):
        now, before = _is_exposure_due(load(device, g, w, i), tick), load(line, g, w, i)
        store(select(now, push(before, before.newest), before), line, g, w, i)
    for i in range(w * once if exposing > 0 else 0):
        camera, drawn = load(device, g, w, i), noise_of(load(noise.channels, noise.drawn, w, i))
        lost, before = load(memory.lost, g, w, i), load(line.newest, g, w, i)
        sample, now = (
            _expose(camera, state_of(group, i), drawn, lost),
            _is_exposure_due(camera, tick),
        )
        store(select(now, sample, before), line.newest, g, w, i)
        store(select(now, 1.0 - sample.seen, lost), memory.lost, g, w, i)
    for i in range(w * once if delivering > 0 else 0):
        m, period = load(memory, g, w, i), load(avionics.systems.period, g, w, i)
        arrived = _deliver(load(device, g, w, i), tick, period, m)
        store(arrived.pose, pose, g, w, i)
        store(arrived.memory.last, memory.last, g, w, i)
        store(arrived.memory.taken_at, memory.taken_at, g, w, i)


@draws.register
def _(device: PerfectMotionCapture, channels: int) -> tuple[Draw, ...]:
    return (Draw(channels, 0),)


@draws.register
def _(device: MotionCapture, channels: int) -> tuple[Draw, ...]:
    return (Draw(channels, round(device.every.ticks)),)


@functools.singledispatch
def motion_capture_at_start(device: Any, start: State) -> Any:
    """Memory of motion capture before its first tick; the start's pose holds until one arrives.

    Plain Python.

    Args:
        device: `MotionCapture` or `PerfectMotionCapture`.
        start: State at tick 0.
    """
    return Nothing(0.0)


@motion_capture_at_start.register
def _(device: MotionCapture, start: State) -> Rarely:
    exposure = Exposure(start.position, start.attitude, 1.0)
    return Rarely(0.0, MotionCaptureMemory(constant_line(exposure), 0.0, exposure, 0.0))

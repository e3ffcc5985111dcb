"""Accelerometer and gyroscope: true quantities at the sensor, and the digital output.

The order is that of the chip: bias and noise enter before the converter, the converter clips, and
the low-pass after it smooths the clipped signal.  A pulse of 60 g therefore never reads more than
the range, and its clipped part is lost.
"""

from __future__ import annotations

import functools
import math
from typing import Any, NamedTuple

from springback.kernels.angles import nearest_integer
from springback.kernels.compiler import generic, kernel
from springback.kernels.vectors import ZERO, Quat, Vec, renormalise, rotation
from springback.sensing.clock import draws
from springback.sensing.measurement import Inertial, Pace, Truth, due, task_pace
from springback.sensing.memory import Nothing
from springback.simulation.onboard import Draw
from springback.vehicle.state import State

#: Ticks between steps of a random-walk bias (chosen): at 1 kHz the accelerometer of EuRoC has then
#: moved 3e-4 m/s², a sixteenth of a count of 16 bits for ± 16 g.
WALK_EVERY = 10.0
_WALK = task_pace(WALK_EVERY)


class PerfectInertial(NamedTuple):
    """Exact mean specific force over the tick and exact angular velocity at its end."""

    offset: Vec  # r, from the main body's centre of mass to the sensor, body axes [m]


class Channel(NamedTuple):
    """Three axes of one kind, [m/s²] or [rad/s]."""

    noise: float  # standard deviation at each tick, see `per_tick`
    bias: Vec  # constant over a flight, drawn at turn-on
    drift: float  # standard deviation of a step of the bias, see `per_tick`
    full_scale: float  # the output is from −full_scale to full_scale − step
    smoothing: float  # coefficient of the low-pass per tick, see `per_tick`
    step: float  # quantisation


class InertialUnit(NamedTuple):
    """An accelerometer and a gyroscope."""

    offset: Vec  # r, from the main body's centre of mass to the sensor, body axes [m]
    every: Pace  # of its output; conversion and filter run at every tick
    accelerometer: Channel
    gyroscope: Channel


class InertialNoise(NamedTuple):
    """Standard normal numbers for one tick; those of the drift apply where a bias takes a step."""

    acceleration: Vec
    rotation: Vec
    acceleration_drift: Vec
    rotation_drift: Vec


class ChannelMemory(NamedTuple):
    """State of the low-pass and of the random-walk bias."""

    smooth: Vec
    drift: Vec


class InertialMemory(NamedTuple):
    """State of both channels, and the last output."""

    accelerometer: ChannelMemory
    gyroscope: ChannelMemory
    specific_force: Vec  # [m/s²]
    angular_velocity: Vec  # [rad/s]


class InertialSample(NamedTuple):
    """A sample, and the memory of the device."""

    inertial: Inertial
    memory: Any


# -- true motion --------------------------------------------------------------------------------


@kernel
def middle_attitude(a: Quat, b: Quat) -> Quat:
    """Midpoint of two attitudes: their normalised mean, exact for a steady rotation."""
    half = 0.5 if a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z >= 0.0 else -0.5
    w, x, y, z = 0.5 * a.w, 0.5 * a.x, 0.5 * a.y, 0.5 * a.z
    return renormalise(Quat(w + half * b.w, x + half * b.x, y + half * b.y, z + half * b.z))


@kernel
def mean_angular_velocity(truth: Truth) -> Vec:
    """Mean of ω before and now, body axes [rad/s]."""
    return 0.5 * (truth.before.angular_velocity + truth.now.angular_velocity)


@kernel
def mean_specific_force(truth: Truth, offset: Vec) -> Vec:
    """Mean specific force over the last tick at a point fixed to the main body [m/s²].

    f = Rᵀ(Δv/Δt + g e_Z) + α × r + ω × (ω × r), α = Δω/Δt: rigid-body kinematics (any textbook).  R
    is the midpoint attitude and ω the mean.  Forces within the tick, impacts included, contribute
    by their mean.

    Args:
        truth: The motion over the last tick; its duration is above zero.
        offset: r, from the main body's centre of mass, body axes [m].
    """
    before, now, rate = truth.before, truth.now, 1.0 / truth.duration
    r = rotation(middle_attitude(before.attitude, now.attitude))
    acceleration = rate * (now.velocity - before.velocity) + Vec(0.0, 0.0, truth.gravity)
    alpha = rate * (now.angular_velocity - before.angular_velocity)
    omega = mean_angular_velocity(truth)
    return acceleration @ r + (alpha ^ offset) + (omega ^ (omega ^ offset))


# -- output ---------------------------------------------------------------------------------------


class PerTick(NamedTuple):
    """Noise and smoothing of a channel at each tick, and drift at each step of its bias."""

    noise: float
    drift: float
    smoothing: float


def per_tick(density: float, walk: float, bandwidth: float, duration: float) -> PerTick:
    """Parameters of a channel per tick, from those in continuous time; plain Python.

    White noise of one-sided density N, sampled at the rate f, has σ = N √(f/2): its power is spread
    evenly up to f/2.  The low-pass then preserves the density N at low frequencies.  A random walk
    of density K takes a step of σ = K √(n Δt) every n = 10 ticks (`WALK_EVERY`).  A first-order
    low-pass with corner f_c covers a fraction 1 − exp(−2π f_c Δt) of its response in a tick, which
    is exact for a constant input.

    Args:
        density: N, of the white noise, one-sided [unit/√Hz].
        walk: K, of the bias [unit/s/√Hz].
        bandwidth: f_c, 3 dB [Hz].
        duration: Δt of a tick [s].
    """
    smoothing = -math.expm1(-2.0 * math.pi * bandwidth * duration)
    return PerTick(
        density * math.sqrt(0.5 / duration), walk * math.sqrt(WALK_EVERY * duration), smoothing
    )


@kernel
def clip(x: float, channel: Channel) -> float:
    """Clamp a component to the range."""
    top = channel.full_scale - channel.step
    low = x if x > -channel.full_scale else -channel.full_scale
    return low if low < top else top


@kernel
def quantise(x: float, step: float) -> float:
    """Multiple of ``step`` nearest to a component."""
    return step * nearest_integer(x * (1.0 / step))


@kernel
def conversion(
    channel: Channel, true: Vec, white: Vec, walk: Vec, memory: ChannelMemory
) -> ChannelMemory:
    """One conversion: bias, noise, clipping, low-pass.

    Args:
        channel: Accelerometer or gyroscope.
        true: True value at the sensor.
        white: Standard normal numbers of the noise.
        walk: Standard normal numbers of the bias.
        memory: Memory of the channel.
    """
    drift = memory.drift + channel.drift * walk
    raw = true + channel.bias + drift + channel.noise * white
    inside = Vec(clip(raw.x, channel), clip(raw.y, channel), clip(raw.z, channel))
    return ChannelMemory(memory.smooth + channel.smoothing * (inside - memory.smooth), drift)


@kernel
def digital_word(channel: Channel, memory: ChannelMemory) -> Vec:
    """Digital output of each axis, in its unit."""
    v, step = memory.smooth, channel.step
    return Vec(quantise(v.x, step), quantise(v.y, step), quantise(v.z, step))


@generic
def inertial_sample(
    device: Any, tick: float, truth: Truth, noise: InertialNoise, memory: Any
) -> InertialSample:
    """Sample of an inertial unit at a tick.

    Args:
        device: `InertialUnit` or `PerfectInertial`.
        tick: Number of the tick, from 0.
        truth: The motion over the last tick.
        noise: Independent standard normal numbers.
        memory: Memory of the device.
    """
    raise TypeError(
        f"{type(device).__name__} is not an inertial unit; register inertial_sample for it"
    )


@inertial_sample.register(PerfectInertial)
@kernel
def _perfect(
    device: PerfectInertial, tick: float, truth: Truth, noise: InertialNoise, memory: Nothing
) -> InertialSample:
    force = mean_specific_force(truth, device.offset)
    return InertialSample(Inertial(force, truth.now.angular_velocity, 1.0), memory)


@inertial_sample.register(InertialUnit)
@kernel
def _converted_sample(
    device: InertialUnit, tick: float, truth: Truth, noise: InertialNoise, memory: InertialMemory
) -> InertialSample:
    force, omega = mean_specific_force(truth, device.offset), mean_angular_velocity(truth)
    a, g = device.accelerometer, device.gyroscope
    steps = 1.0 if due(tick, _WALK) else 0.0
    walk_a, walk_g = steps * noise.acceleration_drift, steps * noise.rotation_drift
    inner_a = conversion(a, force, noise.acceleration, walk_a, memory.accelerometer)
    inner_g = conversion(g, omega, noise.rotation, walk_g, memory.gyroscope)

    speaks = due(tick, device.every)
    said_a = digital_word(a, inner_a) if speaks else memory.specific_force
    said_g = digital_word(g, inner_g) if speaks else memory.angular_velocity
    flag = 1.0 if speaks else 0.0
    return InertialSample(
        Inertial(said_a, said_g, flag), InertialMemory(inner_a, inner_g, said_a, said_g)
    )


@draws.register
def _(device: PerfectInertial, channels: int) -> tuple[Draw, ...]:
    return (Draw(channels, 0),)


@draws.register
def _(device: InertialUnit, channels: int) -> tuple[Draw, ...]:
    white, walks = channels // 2, channels - channels // 2
    return Draw(white, 1), Draw(walks, round(WALK_EVERY))


@functools.singledispatch
def inertial_at_start(device: Any, start: State, gravity: float) -> Any:
    """Memory of an inertial unit before its first tick, settled on an unaccelerated start.

    Plain Python.

    Args:
        device: `InertialUnit` or `PerfectInertial`.
        start: State at tick 0.
        gravity: g along −Z [m/s²].
    """
    return Nothing(0.0)


@inertial_at_start.register
def _(device: InertialUnit, start: State, gravity: float) -> InertialMemory:
    omega = start.angular_velocity
    force = gravity * rotation(start.attitude).z  # at rest, Rᵀ g e_Z ...
    if any(omega):
        force = force + (omega ^ (omega ^ device.offset))  # ... and in steady rotation
    a, g = _steady_channel(device.accelerometer, force), _steady_channel(device.gyroscope, omega)
    return InertialMemory(
        a, g, digital_word(device.accelerometer, a), digital_word(device.gyroscope, g)
    )


def _steady_channel(channel: Channel, true: Vec) -> ChannelMemory:
    """Memory of a channel that has settled at a constant input, without noise."""
    raw = true + channel.bias
    inside = Vec(clip(raw.x, channel), clip(raw.y, channel), clip(raw.z, channel))
    return ChannelMemory(inside, ZERO)

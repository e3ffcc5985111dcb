"""References: the commanded motion of a robot as a function of time.

Positions are those of the main body, world axes (NWU), SI and radians.  Every reference is defined
for all times and stays bounded: before its start it waits at its first point, after its end at its
last.  Another reference is a NamedTuple of floats and a function registered with `target`.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.control.target import Target, target
from springback.kernels.angles import sine_cosine
from springback.kernels.compiler import kernel
from springback.kernels.trees import axpy, fold, select
from springback.kernels.vectors import Vec


class Circle(NamedTuple):
    """A level circle at constant speed, for ever."""

    centre: Vec  # world [m]; its height is the circle's
    radius: float  # [m]
    rate: float  # 2π/period, positive counter-clockwise seen from above [rad/s]
    phase: float  # angle at which it starts, from world X towards Y [rad]
    begins: float  # [s]
    ramp: float  # time to full speed [s]; 0 starts at full speed
    yaw: float  # [rad]


class Segment(NamedTuple):
    """A polynomial in the time since its start."""

    begins: float  # after the start of the whole [s]
    coefficients: tuple[Vec, ...]  # of falling powers, the last is the position at `begins`


class Polynomials(NamedTuple):
    """Polynomials in sequence, any number and any (but one) order."""

    segments: tuple[Segment, ...]  # in order of time, the first begins at 0
    begins: float  # [s]
    duration: float  # of all segments [s]
    yaw: float  # [rad]


class Switch(NamedTuple):
    """One reference until some time, and another from then on."""

    first: Any
    until: float  # [s]
    second: Any


@kernel
def _come(current: Any, later: Any, time: float) -> Any:
    """The later one if its time has come, else the current one."""
    return select(time >= later.begins, later, current)


class Taylor(NamedTuple):
    """A polynomial and its derivatives, each over the factorial of its order."""

    value: Vec
    first: Vec
    second: Vec
    third: Vec


@kernel
def _horner(so_far: Taylor, coefficient: Vec, t: float) -> Taylor:
    """One step of Horner's scheme."""
    s = so_far
    return Taylor(
        axpy(coefficient, s.value, t), axpy(s.value, s.first, t), axpy(s.first, s.second, t),
        axpy(s.second, s.third, t),
    )  # fmt: skip


class PathTime(NamedTuple):
    """A path time s(t) and its derivatives."""

    value: float  # s [s]
    rate: float  # ṡ
    second: float  # s̈ [1/s]
    third: float  # d³s/dt³ [1/s²]


@kernel
def progress(elapsed: float, ramp: float) -> PathTime:
    """Path time that starts at rest and runs at full rate after a ramp.

    ṡ = 10 u³ − 15 u⁴ + 6 u⁵ with u = t/ramp, the quintic whose first two derivatives vanish at both
    ends, so that jerk along the path is continuous; its integral over the ramp is ramp/2.

    Args:
        elapsed: t ≥ 0 [s].
        ramp: Duration of the ramp [s]; at 0 the full rate applies from the start.
    """
    ramping = elapsed < ramp
    u = elapsed / select(ramping, ramp, 1.0)
    v, per = 1.0 - u, 1.0 / select(ramping, ramp, 1.0)
    slow = PathTime(
        value=ramp * u * u * u * u * (2.5 + u * (u - 3.0)),
        rate=u * u * u * (10.0 + u * (6.0 * u - 15.0)),
        second=30.0 * u * u * v * v * per,
        third=60.0 * u * v * (v - u) * per * per,
    )
    return select(ramping, slow, PathTime(elapsed - 0.5 * ramp, 1.0, 0.0, 0.0))


@target.register(Circle)
@kernel
def _circle(reference: Circle, time: float) -> Target:
    """Circle R (cos φ, sin φ), φ = phase + rate · s(t), and three derivatives by the chain rule."""
    r, w = reference.radius, reference.rate
    started = 1.0 if time >= reference.begins else 0.0
    s = progress(started * (time - reference.begins), reference.ramp)
    angle = reference.phase + w * s.value
    first, second, third = w * s.rate * started, w * s.second, w * s.third  # of the angle
    on_circle = sine_cosine(angle)
    out = Vec(on_circle.cosine, on_circle.sine, 0.0)
    on = Vec(-out.y, out.x, 0.0)
    return Target(
        reference.centre + r * out,
        (r * first) * on,
        (r * second) * on - (r * first * first) * out,
        (r * (third - first * first * first)) * on - (3.0 * r * first * second) * out,
        reference.yaw,
        0.0,
    )


@target.register(Polynomials)
@kernel
def _polynomials(reference: Polynomials, time: float) -> Target:
    """Horner's scheme for the value and three derivatives at once; at rest outside its duration."""
    elapsed = time - reference.begins
    begun, ended = elapsed >= 0.0, elapsed > reference.duration
    moving = select(ended, 0.0, select(begun, 1.0, 0.0))
    inside = select(ended, reference.duration, select(begun, elapsed, 0.0))
    segment = fold(_come, reference.segments[0], reference.segments, (inside,))
    none = Vec(0.0, 0.0, 0.0)
    start = Taylor(none, none, none, none)
    at = fold(_horner, start, segment.coefficients, (inside - segment.begins,))
    v, a, j = moving * at.first, (2.0 * moving) * at.second, (6.0 * moving) * at.third
    return Target(at.value, v, a, j, reference.yaw, 0.0)


@target.register(Switch)
@kernel
def _switch(reference: Switch, time: float) -> Target:
    first, second = target(reference.first, time), target(reference.second, time)
    return select(time >= reference.until, second, first)

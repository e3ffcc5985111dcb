"""Geometric position control: from a target position to attitude and thrust.

The law is that of Lee, Leok and McClamroch (CDC 2010) and of Mellinger and Kumar (ICRA 2011), with
gains that are forces: a heavier robot with the same gains is slower, as Table IV of the paper shows
for ARQ against Quad.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from springback.control.target import AttitudeTarget, Target
from springback.kernels.angles import sine_cosine
from springback.kernels.compiler import kernel
from springback.kernels.vectors import (
    Mat3,
    Vec,
    axiswise,
    norm,
    positive_part,
    quaternion_of,
    rotation,
    within,
)
from springback.sensing.measurement import Estimate

#: Squared sine of the angle to the heading below which the heading is undefined (chosen).
PARALLEL = 1e-12


class PositionLaw(NamedTuple):
    """Settings of the position loop."""

    stiffness: Vec  # K_p, world axes [N/m]
    damping: Vec  # K_v [N s/m]
    integral: Vec  # K_i [N/(m s)]; 0 switches it off
    integral_limit: float  # of the force of the integral, per axis [N]
    feedback_limit: float  # of the length of the force of K_p and K_v [N]
    mass: float  # m of the controller's model [kg]
    gravity: float  # g [m/s²]
    slope: float  # tangent of the largest tilt
    min_lift: float  # lower bound on the vertical force [N]
    max_thrust: float  # collective [N]
    margin: float  # fraction of a limited force reserved for its horizontal part
    feed_forward: float  # 1: angular velocity from jerk and yaw rate; 0: none
    tilt_lead: float  # the reference's acceleration is taken this much later [s]
    rate_lead: float  # its jerk and yaw rate are taken this much later [s]
    period: float  # of the loop [s]


class PositionMemory(NamedTuple):
    """Memory of the position loop."""

    integral: Vec  # force of the integral [N]


class Aim(NamedTuple):
    """Output of the position loop, and its memory."""

    target: AttitudeTarget
    memory: PositionMemory


class Feedback(NamedTuple):
    """Force of the position and velocity errors, and the integral."""

    force: Vec  # world [N]
    integral: Vec  # world [N]


class Heading(NamedTuple):
    """Axes of an attitude, and the heading from which it is built."""

    axes: Mat3  # body to world: columns b_1, b_2, b_3
    forward: Vec  # x_C, horizontal
    left: Vec  # y_C, horizontal


NO_MEMORY = PositionMemory(Vec(0.0, 0.0, 0.0))


@kernel
def limited_force(force: Vec, limit: float, vertical: float, margin: float) -> Vec:
    """A force with a given vertical part, and its horizontal part limited to what a length leaves.

    Args:
        force: World [N].
        limit: Maximum length [N].
        vertical: New vertical part, at most ``limit`` [N].
        margin: Fraction of the limit reserved for the horizontal part.
    """
    left, least = limit * limit - vertical * vertical, margin * limit
    room = math.sqrt(left if left > least * least else least * least)
    across = math.sqrt(force.x * force.x + force.y * force.y)
    factor = room / across if across > room else 1.0
    return Vec(force.x * factor, force.y * factor, vertical)


@kernel
def feedback(law: PositionLaw, wanted: Target, at: Estimate, memory: PositionMemory) -> Feedback:
    """−K_p e_p − K_v e_v, limited in length, and −K_i ∫ e_p, which is frozen while limited.

    Height has priority: the horizontal gets what the vertical part leaves of the length.

    Source: Lee, Leok, McClamroch, CDC 2010, position controller; the limit is that of the open
    controller mavros_controllers (its max_fb_acc), where it bounds an acceleration; the priority of
    height, except for a margin, is PX4's PositionControl.
    """
    e_p, e_v = at.position - wanted.position, at.velocity - wanted.velocity
    raw = -(axiswise(law.stiffness, e_p) + axiswise(law.damping, e_v))
    limit = law.feedback_limit
    force = limited_force(raw, limit, within(raw.z, -limit, limit), law.margin)
    lost = raw - force
    running = 0.0 if lost @ lost > 0.0 else law.period
    grown = memory.integral - axiswise(law.integral, e_p) * running
    most = law.integral_limit
    integral = Vec(
        within(grown.x, -most, most), within(grown.y, -most, most), within(grown.z, -most, most)
    )
    return Feedback(force + integral, integral)


@kernel
def upward(law: PositionLaw, force: Vec) -> Vec:
    """Nearest force that the robot can produce [N].

    It points up, tilts by no more than the largest tilt, and does not exceed the rotors' maximum.
    The vertical part has priority: it is preserved, or raised to a small lift if it would vanish or
    point down; then the horizontal part is limited.  The direction is therefore always defined, and
    the attitude built on it never singular.
    """
    lift = within(force.z, law.min_lift, law.max_thrust)
    held = limited_force(force, law.max_thrust, lift, law.margin)
    across = math.sqrt(held.x * held.x + held.y * held.y)
    most = lift * law.slope
    factor = most / across if across > most else 1.0
    return Vec(held.x * factor, held.y * factor, lift)


@kernel
def heading(axis: Vec, yaw: float) -> Heading:
    """Attitude with b_3 along a unit vector, and b_2 normal to the horizontal heading x_C.

    b_2 = b_3 × x_C / ‖·‖, b_1 = b_2 × b_3 with x_C = (cos ψ, sin ψ, 0).  Source: Mellinger and
    Kumar, ICRA 2011, differential flatness.  If b_3 is parallel to x_C, b_2 is y_C.
    """
    ahead = sine_cosine(yaw)
    x_c = Vec(ahead.cosine, ahead.sine, 0.0)
    y_c = Vec(-x_c.y, x_c.x, 0.0)
    raw = axis ^ x_c
    square = raw @ raw
    is_parallel = square < PARALLEL
    inverse = 1.0 / math.sqrt(1.0 if is_parallel else square)
    b_2 = y_c if is_parallel else raw * inverse
    b_1 = b_2 ^ axis
    return Heading(
        Mat3(Vec(b_1.x, b_2.x, axis.x), Vec(b_1.y, b_2.y, axis.y), Vec(b_1.z, b_2.z, axis.z)),
        x_c,
        y_c,
    )


@kernel
def flat_rates(built: Heading, jerk: Vec, acceleration: float, yaw_rate: float) -> Vec:
    """Angular velocity of the attitude of `heading`, in its own axes [rad/s].

    h = (j − (b_3·j) b_3)/a, p = −h·b_2, q = h·b_1 with a the thrust per mass: Mellinger and Kumar,
    ICRA 2011.  b_2 remains normal to x_C, so r (b_1·x_C) = p (b_3·x_C) + ψ̇ (b_2·y_C).

    Args:
        built: The attitude.
        jerk: World axes [m/s³].
        acceleration: Force per mass along b_3, not zero [m/s²].
        yaw_rate: ψ̇ [rad/s].
    """
    h = (jerk @ built.axes) * (1.0 / acceleration)
    forward, left = built.forward @ built.axes, built.left @ built.axes
    p, q = -h.y, h.x
    along = forward.x if forward.x > 1e-6 else 1e-6
    return Vec(p, q, (p * forward.z + yaw_rate * left.y) / along)


@kernel
def aim(law: PositionLaw, wanted: Target, at: Estimate, memory: PositionMemory) -> Aim:
    """Attitude, its angular velocity and collective thrust that bring the robot to its target.

    F = −K_p e_p − K_v e_v + m (g e_Z + a_ref); the thrust is F·(R e_z), along the present body
    axis, so that the robot does not push while it points elsewhere; the attitude has its z axis
    along F.  Where the tilt is limited, the feed-forward of the tilt is off.

    Args:
        law: Settings.
        wanted: Target of the reference.
        at: Estimated state of the robot.
        memory: `NO_MEMORY` at the start; a new one is returned.
    """
    fed = feedback(law, wanted, at, memory)
    asked = fed.force + (wanted.acceleration + Vec(0.0, 0.0, law.gravity)) * law.mass
    force = upward(law, asked)
    size = norm(force)
    built = heading(force * (1.0 / size), wanted.yaw)
    missing = asked - force
    tilting = law.feed_forward if missing @ missing < PARALLEL * size * size else 0.0
    rates = flat_rates(
        built, wanted.jerk * tilting, size / law.mass, wanted.yaw_rate * law.feed_forward
    )
    r = rotation(at.attitude)
    thrust = positive_part(force @ Vec(r.x.z, r.y.z, r.z.z))
    return Aim(
        AttitudeTarget(quaternion_of(built.axes), rates, thrust), PositionMemory(fed.integral)
    )

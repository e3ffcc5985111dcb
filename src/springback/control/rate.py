"""Rate loop: from a rate set-point to a moment."""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import tree_map, tree_sum
from springback.kernels.vectors import Mat3, Vec, axiswise, positive_part, within
from springback.vehicle.arms.bent import BentArm, bent_pose
from springback.vehicle.arms.joints import JointedArm, joint_pose, point_inertia
from springback.vehicle.state import Airframe, Arm, arms_inertia

#: A moment short by less than this counts as met: rounding [N m].
ROUNDING = 1e-9


class RateLaw(NamedTuple):
    """Settings of the rate loop; gains act on angular accelerations."""

    gain: Vec  # k_ω [1/s]
    integral: Vec  # [1/s²]; 0 switches it off
    derivative: Vec  # on the filtered angular acceleration; 0 switches it off
    integral_limit: float  # of the angular acceleration of the integral, per axis [rad/s²]
    integral_fade: float  # rate error at which the integral stops growing [rad/s]
    filter_share: float  # weight of a new sample in the filtered rate, from 0 to 1; 1 is no filter
    gyroscopic: float  # 1 adds ω × J ω, 0 does not
    period: float  # of the loop [s]


class RateMemory(NamedTuple):
    """Memory of the rate loop."""

    filtered: Vec  # angular velocity [rad/s]
    integral: Vec  # angular acceleration of the integral [rad/s²]


class Turn(NamedTuple):
    """Moment commanded by the rate loop, body axes [N m], and its memory."""

    moment: Vec
    memory: RateMemory


@kernel
def rate_memory(angular_velocity: Vec) -> RateMemory:
    """Memory of a loop that starts at an angular velocity [rad/s]."""
    return RateMemory(angular_velocity, angular_velocity * 0.0)


@generic
def second_moment(arm: Any, length: float) -> Any:
    """Second moment of mass of an arm at a length [m], for `arms_inertia` [kg m²]."""
    raise TypeError(f"{type(arm).__name__} is not an arm")


@second_moment.register(JointedArm)
@kernel
def _of_joint(arm: JointedArm, length: float) -> Mat3:
    return point_inertia(arm.mass, joint_pose(arm, length, 0.0).end)


@second_moment.register(BentArm)
@kernel
def _of_two_joints(arm: BentArm, length: Any) -> Mat3:
    return point_inertia(arm.mass, bent_pose(arm, length, 0.0).end)


@second_moment.register(Arm)
@kernel
def _of_slide(arm: Arm, length: float) -> Vec:
    """Second moment m_j l_j² (e_x², e_y², e_x e_y) [kg m²]."""
    square = arm.mass * length * length
    return Vec(
        square * arm.cosine * arm.cosine,
        square * arm.sine * arm.sine,
        square * arm.cosine * arm.sine,
    )


@kernel
def inertia_at(airframe: Airframe, lengths: tuple[float, ...]) -> Mat3:
    """Inertia J(l) of body and arms about the main body at given arm lengths, body axes [kg m²]."""
    return airframe.inertia + arms_inertia(
        tree_sum(tree_map(second_moment, (airframe.arms, lengths), ()))
    )


@kernel
def _integral(
    value: float, gain: float, error: float, unmet: float, most: float, faint: float, period: float
) -> float:
    """Integral of one axis after a period [rad/s²].

    It does not grow further into saturation, and large errors, as in flips and impacts, have little
    weight: 1 − (e/fade)².  Source: both are in PX4's RateControl.
    """
    share = positive_part(1.0 - (error * faint) * (error * faint))
    saturated = (unmet * error > 0.0) & (unmet * unmet > ROUNDING * ROUNDING)
    running = 0.0 if saturated else period
    return within(value + gain * share * error * running, -most, most)


@kernel
def turn(
    law: RateLaw, inertia: Mat3, setpoint: Vec, measured: Vec, unmet: Vec, memory: RateMemory
) -> Turn:
    """Moment J (k_ω (ω_sp − ω) + i − d ω̇) + ω × J ω.

    With a true J the robot then follows ω̇ = k_ω (ω_sp − ω), whatever its arms do.
    Source: Brescianini et al. 2013, inner loop; integral and derivative as in PX4's RateControl.

    Args:
        law: Settings.
        inertia: J of the controller's model, body axes [kg m²].
        setpoint: ω_sp, body axes [rad/s].
        measured: ω of the gyroscope, body axes [rad/s].
        unmet: Moment that the rotors could not give at the last period, asked minus given [N m].
        memory: From `rate_memory` at the start; a new one is returned.
    """
    omega = memory.filtered + (measured - memory.filtered) * law.filter_share
    error = setpoint - omega
    most, faint, period = law.integral_limit, 1.0 / law.integral_fade, law.period
    integral = Vec(
        _integral(memory.integral.x, law.integral.x, error.x, unmet.x, most, faint, period),
        _integral(memory.integral.y, law.integral.y, error.y, unmet.y, most, faint, period),
        _integral(memory.integral.z, law.integral.z, error.z, unmet.z, most, faint, period),
    )
    rate = (omega - memory.filtered) * (1.0 / period)
    wanted = axiswise(law.gain, error) + integral - axiswise(law.derivative, rate)
    spin = (omega ^ (inertia @ omega)) * law.gyroscopic
    return Turn(inertia @ wanted + spin, RateMemory(omega, integral))

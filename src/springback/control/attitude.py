"""Attitude control: from a desired attitude to a rate set-point.

All laws give a set-point for the same rate loop (`springback.control.rate`).  They use the error
q_e = q⁻¹ ⊗ q_d, the desired attitude relative to the body.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from springback.control.target import AttitudeTarget
from springback.kernels.angles import angle_of, sine_cosine
from springback.kernels.compiler import generic, kernel
from springback.kernels.vectors import (
    Quat,
    Vec,
    axiswise,
    conjugate,
    quaternion_product,
    rotation,
    within,
)

#: cos(tilt error / 2) below which the tilt error is half a turn and its swing is undefined
#: (chosen).
HALF_TURN = 1e-6


class FullQuaternion(NamedTuple):
    """Brescianini's law on the whole attitude, equal for all three axes."""

    gain: Vec  # 1/τ [1/s]
    limit: Vec  # of the rates, per body axis [rad/s]


class Reduced(NamedTuple):
    """Brescianini's law with tilt before yaw: the tilt is corrected by the shortest rotation."""

    gain: Vec  # 1/τ; about z that of yaw over the yaw weight [1/s]
    yaw_weight: float  # p, from 0 to 1: fraction of the yaw error that is corrected at once
    limit: Vec  # of the rates, per body axis [rad/s]


class LeeSO3(NamedTuple):
    """Lee's error on SO(3), which vanishes towards half a turn."""

    gain: Vec  # 1/τ [1/s]
    limit: Vec  # of the rates, per body axis [rad/s]


@kernel
def attitude_error(attitude: Quat, desired: Quat) -> Quat:
    """Error q_e = q⁻¹ ⊗ q_d with the sign of sgn(q_e0), sgn(0) = 1: the shorter rotation.

    Both signs of a quaternion are one attitude; the shorter rotation avoids unwinding.
    """
    error = quaternion_product(conjugate(attitude), desired)
    sign = 1.0 if error.w >= 0.0 else -1.0
    return Quat(error.w * sign, error.x * sign, error.y * sign, error.z * sign)


@kernel
def limited_rates(rates: Vec, limit: Vec) -> Vec:
    """Rates [rad/s], each clamped to its limit."""
    return Vec(
        within(rates.x, -limit.x, limit.x),
        within(rates.y, -limit.y, limit.y),
        within(rates.z, -limit.z, limit.z),
    )


@generic
def correction(law: Any, error: Quat) -> Vec:
    """Angular velocity that removes an attitude error, body axes [rad/s].

    Args:
        law: `FullQuaternion`, `Reduced`, `LeeSO3`, or a type that is registered.
        error: q_e of `attitude_error`, with q_e0 ≥ 0.
    """
    raise TypeError(f"{type(law).__name__} is not an attitude law; register correction for it")


@correction.register(FullQuaternion)
@kernel
def _full(law: FullQuaternion, error: Quat) -> Vec:
    """Correction Ω = (2/τ) sgn(q_e0) q_e,1:3.

    Source: Brescianini, Hehn, D'Andrea, Nonlinear quadrocopter attitude control, ETH Zurich, 2013.
    """
    return axiswise(law.gain, Vec(2.0 * error.x, 2.0 * error.y, 2.0 * error.z))


@kernel
def weighted_error(error: Quat, yaw_weight: float) -> Quat:
    """The error with its rotation about the body's z axis reduced to a fraction p.

    q_e = q_swing ⊗ (cos β/2, 0, 0, sin β/2), where the swing rotates z to the desired z by the
    shortest rotation; β is replaced by p β.  Source: Brescianini et al. 2013, mixing of reduced and
    full attitude; PX4's AttitudeControl does the same since 2019 (pull request 12175).  The twist
    of a swing by half a turn is undefined: the error is then used whole.
    """
    n = math.sqrt(error.w * error.w + error.z * error.z)
    is_half_turn = n < HALF_TURN
    size = 1.0 if is_half_turn else n
    a = 1.0 if is_half_turn else error.w / size
    b = 0.0 if is_half_turn else error.z / size
    swing = quaternion_product(error, Quat(a, 0.0, 0.0, -b))
    part = sine_cosine(yaw_weight * angle_of(b, a))
    return quaternion_product(swing, Quat(part.cosine, 0.0, 0.0, part.sine))


@correction.register(Reduced)
@kernel
def _tilt_first(law: Reduced, error: Quat) -> Vec:
    """Correction Ω = (2/τ) q_mix,1:3 with a weighted yaw error."""
    mixed = weighted_error(error, law.yaw_weight)
    return axiswise(law.gain, Vec(2.0 * mixed.x, 2.0 * mixed.y, 2.0 * mixed.z))


@correction.register(LeeSO3)
@kernel
def _lee(law: LeeSO3, error: Quat) -> Vec:
    """Correction Ω = −e_R/τ, e_R = ½ (R_dᵀ R − Rᵀ R_d)^∨ = −2 q_e0 q_e,1:3 of length sin(angle).

    With the rate loop's moment J k_ω (Ω − ω) this is Lee's moment −k_R e_R − k_Ω e_Ω + ω × J ω for
    k_Ω = k_ω J and k_R = k_ω J/τ.  Exponentially stable below 90°, zero at 180°.
    Source: Lee, Leok, McClamroch, Geometric tracking control of a quadrotor UAV on SE(3), CDC 2010.
    """
    sine = 2.0 * error.w
    return axiswise(law.gain, Vec(sine * error.x, sine * error.y, sine * error.z))


@kernel
def rate_setpoint(law: Any, wanted: AttitudeTarget, attitude: Quat) -> Vec:
    """Desired angular velocity, body axes [rad/s]: correction and feed-forward, within limits.

    Args:
        law: Settings, a NamedTuple with the field ``limit``.
        wanted: From the position controller; its angular velocity is rotated to body axes.
        attitude: Estimated attitude, body to world.
    """
    error = attitude_error(attitude, wanted.attitude)
    ahead = rotation(error) @ wanted.angular_velocity
    return limited_rates(correction(law, error) + ahead, law.limit)

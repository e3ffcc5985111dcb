"""From how the robot should lean to how fast it should turn: attitude control.

All laws give a set-point for one and the same rate loop (`springback.control.rate`).  They work on
the error q_e = q⁻¹ ⊗ q_d, the desired attitude seen from the body.
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

#: cos(tilt error / 2) below which the tilt error is half a turn and has no swing of its own
#: (chosen).
HALF_TURN = 1e-6


class FullQuaternion(NamedTuple):
    """Brescianini's law on the whole attitude: all three axes alike."""

    gain: Vec  # 1/τ [1/s]
    limit: Vec  # of the rates, per body axis [rad/s]


class Reduced(NamedTuple):
    """Brescianini's law with tilt before yaw: the tilt takes its shortest way."""

    gain: Vec  # 1/τ; about z that of yaw divided by the yaw weight [1/s]
    yaw_weight: float  # p, from 0 to 1: how much of the yaw error is asked for at once
    limit: Vec  # of the rates, per body axis [rad/s]


class LeeSO3(NamedTuple):
    """Lee's error on SO(3), which fades towards half a turn."""

    gain: Vec  # 1/τ [1/s]
    limit: Vec  # of the rates, per body axis [rad/s]


@kernel
def attitude_error(attitude: Quat, desired: Quat) -> Quat:
    """q_e = q⁻¹ ⊗ q_d with the sign of sgn(q_e0), sgn(0) = 1: the shorter way round.

    Both signs of a quaternion are one attitude; taking the shorter way avoids unwinding.
    """
    error = quaternion_product(conjugate(attitude), desired)
    sign = 1.0 if error.w >= 0.0 else -1.0
    return Quat(error.w * sign, error.x * sign, error.y * sign, error.z * sign)


@kernel
def limited(rates: Vec, limit: Vec) -> Vec:
    """Rates [rad/s], each cut to its limit."""
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
    raise TypeError(f"{type(law).__name__} is no attitude law; register correction for it")


@correction.register(FullQuaternion)
@kernel
def _full(law: FullQuaternion, error: Quat) -> Vec:
    """Ω = (2/τ) sgn(q_e0) q_e,1:3.

    Source: Brescianini, Hehn, D'Andrea, Nonlinear quadrocopter attitude control, ETH Zurich, 2013.
    """
    return axiswise(law.gain, Vec(2.0 * error.x, 2.0 * error.y, 2.0 * error.z))


@kernel
def weighted(error: Quat, yaw_weight: float) -> Quat:
    """The error with its turn about the body's z axis taken for a part p only.

    q_e = q_swing ⊗ (cos β/2, 0, 0, sin β/2), where the swing brings z onto the desired z by the
    shortest way; β is replaced by p β.  Source: Brescianini et al. 2013, mixing of reduced and
    full attitude; PX4's AttitudeControl does the same since 2019 (pull request 12175).  A swing by
    half a turn has no twist of its own: the error is then taken whole.
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
def _reduced(law: Reduced, error: Quat) -> Vec:
    """Ω = (2/τ) q_mix,1:3 with the yaw part of the error weighted."""
    mixed = weighted(error, law.yaw_weight)
    return axiswise(law.gain, Vec(2.0 * mixed.x, 2.0 * mixed.y, 2.0 * mixed.z))


@correction.register(LeeSO3)
@kernel
def _lee(law: LeeSO3, error: Quat) -> Vec:
    """Ω = −e_R/τ, e_R = ½ (R_dᵀ R − Rᵀ R_d)^∨ = −2 q_e0 q_e,1:3, of length sin of the angle.

    With the rate loop's moment J k_ω (Ω − ω) this is Lee's moment −k_R e_R − k_Ω e_Ω + ω × J ω for
    k_Ω = k_ω J and k_R = k_ω J/τ.  Exponentially stable below 90°, without force at 180°.
    Source: Lee, Leok, McClamroch, Geometric tracking control of a quadrotor UAV on SE(3), CDC 2010.
    """
    sine = 2.0 * error.w
    return axiswise(law.gain, Vec(sine * error.x, sine * error.y, sine * error.z))


@kernel
def rate_setpoint(law: Any, wanted: AttitudeTarget, attitude: Quat) -> Vec:
    """Angular velocity to turn with, body axes [rad/s]: correction and feed-forward, cut to limits.

    Args:
        law: Settings, a NamedTuple with the field ``limit``.
        wanted: Of the position controller; its angular velocity is turned into body axes.
        attitude: As believed, body to world.
    """
    error = attitude_error(attitude, wanted.attitude)
    ahead = rotation(error) @ wanted.angular_velocity
    return limited(correction(law, error) + ahead, law.limit)

"""Covariance of fifteen errors in blocks of three, and its propagation and correction.

The errors are, in this order, those of position p and velocity v (world axes), a small rotation θ
(body axes; truth = estimate ⊗ exp θ), the accelerometer's bias a and the gyroscope's bias w (body
axes).  Only the upper triangle is stored: 15 of the 25 blocks.

Source of the filter: J. Solà, Quaternion kinematics for the error-state Kalman filter, arXiv
1711.02508, sections 5.4 (transition) and 6.1 (correction).
"""

from __future__ import annotations

from typing import NamedTuple

from springback.kernels.compiler import kernel
from springback.kernels.vectors import (
    Mat3,
    Vec,
    isotropic,
    symmetric_part,
    transpose,
)


class Covariance(NamedTuple):
    """Covariance P, its upper triangle: ``pv`` is that of position and velocity errors, and so on.

    Units are products of those of the errors: m, m/s, rad, m/s², rad/s.
    """

    pp: Mat3
    pv: Mat3
    pt: Mat3
    pa: Mat3
    pw: Mat3
    vv: Mat3
    vt: Mat3
    va: Mat3
    vw: Mat3
    tt: Mat3
    ta: Mat3
    tw: Mat3
    aa: Mat3
    aw: Mat3
    ww: Mat3


class Column(NamedTuple):
    """A column of five blocks: the covariance of all errors with three numbers."""

    p: Mat3
    v: Mat3
    t: Mat3
    a: Mat3
    w: Mat3


class Transition(NamedTuple):
    """Transition F over a time T: δp += T δv, δv += F_vt δθ + F_va δa, δθ ← F_tt δθ − T δw.

    Section 5.4.3 of the source, with the rotation and the velocity gain over the whole time T.
    """

    duration: float  # T [s]
    vt: Mat3  # −[Δv]× R at the beginning, of the specific force's Δv in world axes [m/s]
    va: Mat3  # −∫ R dt [s]
    tt: Mat3  # from body axes at the beginning to body axes at the end


class Noise(NamedTuple):
    """Variances added over some time, equal along all axes."""

    velocity: float  # [m²/s²]
    rotation: float  # [rad²]
    accelerometer_bias: float  # [m²/s⁴]
    gyroscope_bias: float  # [rad²/s²]


def diagonal_covariance(p: float, v: float, t: float, a: float, w: float) -> Covariance:
    """Covariance of independent errors with given standard deviations."""
    o = isotropic(0.0)
    return Covariance(
        *(isotropic(p * p), o, o, o, o),
        *(isotropic(v * v), o, o, o),
        *(isotropic(t * t), o, o),
        *(isotropic(a * a), o),
        isotropic(w * w),
    )


@kernel
def with_position(c: Covariance) -> Column:
    """Covariance of all errors with the position's."""
    return Column(c.pp, transpose(c.pv), transpose(c.pt), transpose(c.pa), transpose(c.pw))


@kernel
def with_velocity(c: Covariance) -> Column:
    """Covariance of all errors with the velocity's."""
    return Column(c.pv, c.vv, transpose(c.vt), transpose(c.va), transpose(c.vw))


@kernel
def with_rotation(c: Covariance) -> Column:
    """Covariance of all errors with the rotation's."""
    return Column(c.pt, c.vt, c.tt, transpose(c.ta), transpose(c.tw))


@kernel
def with_gyroscope_bias(c: Covariance) -> Column:
    """Covariance of all errors with the gyroscope bias's."""
    return Column(c.pw, c.vw, c.tw, c.aw, c.ww)


@kernel
def _across(p: Mat3, v: Mat3, t: Mat3, a: Mat3, w: Mat3) -> Column:
    """A row of blocks, as a column."""
    return Column(transpose(p), transpose(v), transpose(t), transpose(a), transpose(w))


@kernel
def _advance(f: Transition, c: Column) -> Column:
    """Product of F and a column."""
    return Column(
        c.p + f.duration * c.v,
        c.v + f.vt @ c.t + f.va @ c.a,
        f.tt @ c.t - f.duration * c.w,
        c.a,
        c.w,
    )


@kernel
def propagate(c: Covariance, f: Transition, noise: Noise) -> Covariance:
    """Propagation P ← F P Fᵀ + Q: first F P column by column, then F (F P)ᵀ."""
    p, v, t = with_position(c), with_velocity(c), with_rotation(c)
    a = Column(c.pa, c.va, c.ta, c.aa, transpose(c.aw))
    w = with_gyroscope_bias(c)
    p, v, t, a, w = _advance(f, p), _advance(f, v), _advance(f, t), _advance(f, a), _advance(f, w)
    along_p = _advance(f, _across(p.p, v.p, t.p, a.p, w.p))
    along_v = _advance(f, _across(p.v, v.v, t.v, a.v, w.v))
    along_t = _advance(f, _across(p.t, v.t, t.t, a.t, w.t))
    return Covariance(
        pp=symmetric_part(along_p.p),
        pv=transpose(along_p.v),
        pt=transpose(along_p.t),
        pa=a.p,
        pw=w.p,
        vv=symmetric_part(along_v.v) + isotropic(noise.velocity),
        vt=transpose(along_v.t),
        va=a.v,
        vw=w.v,
        tt=symmetric_part(along_t.t) + isotropic(noise.rotation),
        ta=a.t,
        tw=w.t,
        aa=c.aa + isotropic(noise.accelerometer_bias),
        aw=c.aw,
        ww=c.ww + isotropic(noise.gyroscope_bias),
    )


@kernel
def times(c: Column, m: Mat3) -> Column:
    """Product of every block of a column and a matrix."""
    return Column(c.p @ m, c.v @ m, c.t @ m, c.a @ m, c.w @ m)


class Correction(NamedTuple):
    """Correction δx = K z, block by block."""

    p: Vec
    v: Vec
    t: Vec
    a: Vec
    w: Vec


@kernel
def correction(seen: Column, weighed: Vec) -> Correction:
    """Correction K z = P Hᵀ (S⁻¹ z).

    Args:
        seen: P Hᵀ, the covariance of all errors with the measured quantity.
        weighed: S⁻¹ z of the innovation z and its covariance S.
    """
    return Correction(
        seen.p @ weighed, seen.v @ weighed, seen.t @ weighed, seen.a @ weighed, seen.w @ weighed
    )


@kernel
def correct(c: Covariance, seen: Column, inverse: Mat3) -> Covariance:
    """Covariance after a correction, P ← P − K S Kᵀ = P − (P Hᵀ) S⁻¹ (P Hᵀ)ᵀ.

    Args:
        c: P.
        seen: P Hᵀ.
        inverse: S⁻¹.
    """
    k = times(seen, inverse)
    p, v, t = transpose(seen.p), transpose(seen.v), transpose(seen.t)
    a, w = transpose(seen.a), transpose(seen.w)
    return Covariance(
        pp=symmetric_part(c.pp - k.p @ p),
        pv=c.pv - k.p @ v,
        pt=c.pt - k.p @ t,
        pa=c.pa - k.p @ a,
        pw=c.pw - k.p @ w,
        vv=symmetric_part(c.vv - k.v @ v),
        vt=c.vt - k.v @ t,
        va=c.va - k.v @ a,
        vw=c.vw - k.v @ w,
        tt=symmetric_part(c.tt - k.t @ t),
        ta=c.ta - k.t @ a,
        tw=c.tw - k.t @ w,
        aa=symmetric_part(c.aa - k.a @ a),
        aw=c.aw - k.a @ w,
        ww=symmetric_part(c.ww - k.w @ w),
    )

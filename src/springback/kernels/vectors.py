"""Vectors, matrices and quaternions with operators, in Python and in compiled code.

``a + b``, ``a - b``, ``-a``, ``a * s`` and ``s * a`` have their usual meaning; ``a @ b`` is the
scalar product, ``a ^ b`` the vector product, ``M @ a`` a matrix times a vector and ``a @ M`` the
transposed matrix times a vector (so ``R @ v`` rotates body axes to world axes and ``v @ R`` back).
Matrices add, subtract, scale and multiply (``A @ B``) likewise.  Mind Python's precedence: ``^``
binds weaker than ``+``, so vector products need parentheses.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable
from typing import Any, NamedTuple, overload

from numba import types

from springback.kernels.angles import angle_of, sine_cosine
from springback.kernels.compiler import compiler_rule, is_named, kernel


class Vec(NamedTuple):
    """Three components along x, y, z; unit and frame are those of the quantity."""

    x: float
    y: float
    z: float

    def __add__(self, other: Vec) -> Vec:  # type: ignore[override]  # a tuple would concatenate
        return _add(self, other)

    def __sub__(self, other: Vec) -> Vec:
        return _subtract(self, other)

    def __neg__(self) -> Vec:
        return _negate(self)

    def __mul__(self, factor: float) -> Vec:  # type: ignore[override]  # a tuple would repeat
        return _scale(self, factor)

    def __rmul__(self, factor: float) -> Vec:  # type: ignore[override]
        return _scale(self, factor)

    @overload
    def __matmul__(self, other: Vec) -> float: ...
    @overload
    def __matmul__(self, other: Mat3) -> Vec: ...
    def __matmul__(self, other: Vec | Mat3) -> float | Vec:
        return _transform_back(self, other) if isinstance(other, Mat3) else _dot(self, other)

    def __xor__(self, other: Vec) -> Vec:
        return _cross(self, other)


#: One object, shared by all flights that lack a part (`springback.kernels.memo`).
ZERO = Vec(0.0, 0.0, 0.0)


class Mat3(NamedTuple):
    """A 3 x 3 matrix by its rows."""

    x: Vec
    y: Vec
    z: Vec

    def __add__(self, other: Mat3) -> Mat3:  # type: ignore[override]
        return _add_matrices(self, other)

    def __sub__(self, other: Mat3) -> Mat3:
        return _subtract_matrices(self, other)

    def __mul__(self, factor: float) -> Mat3:  # type: ignore[override]
        return _scale_matrix(self, factor)

    def __rmul__(self, factor: float) -> Mat3:  # type: ignore[override]
        return _scale_matrix(self, factor)

    @overload
    def __matmul__(self, other: Vec) -> Vec: ...
    @overload
    def __matmul__(self, other: Mat3) -> Mat3: ...
    def __matmul__(self, other: Vec | Mat3) -> Vec | Mat3:
        return _product(self, other) if isinstance(other, Mat3) else _transform(self, other)


class Quat(NamedTuple):
    """Hamilton quaternion, scalar first; as an attitude, from body (FLU) to world (NWU) axes."""

    w: float
    x: float
    y: float
    z: float


def _add(a: Vec, b: Vec) -> Vec:
    return Vec(a.x + b.x, a.y + b.y, a.z + b.z)


def _subtract(a: Vec, b: Vec) -> Vec:
    return Vec(a.x - b.x, a.y - b.y, a.z - b.z)


def _negate(a: Vec) -> Vec:
    return Vec(-a.x, -a.y, -a.z)


def _scale(a: Vec, s: float) -> Vec:
    return Vec(a.x * s, a.y * s, a.z * s)


def _scale_from_left(s: float, a: Vec) -> Vec:
    return Vec(a.x * s, a.y * s, a.z * s)


def _dot(a: Vec, b: Vec) -> float:
    return a.x * b.x + a.y * b.y + a.z * b.z


def _cross(a: Vec, b: Vec) -> Vec:
    return Vec(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)


def _add_matrices(a: Mat3, b: Mat3) -> Mat3:
    return Mat3(a.x + b.x, a.y + b.y, a.z + b.z)


def _subtract_matrices(a: Mat3, b: Mat3) -> Mat3:
    return Mat3(a.x - b.x, a.y - b.y, a.z - b.z)


def _scale_matrix(a: Mat3, s: float) -> Mat3:
    return Mat3(a.x * s, a.y * s, a.z * s)


def _scale_matrix_from_left(s: float, a: Mat3) -> Mat3:
    return Mat3(a.x * s, a.y * s, a.z * s)


def _product(a: Mat3, b: Mat3) -> Mat3:
    return Mat3(a.x @ b, a.y @ b, a.z @ b)


def _transform(m: Mat3, a: Vec) -> Vec:
    return Vec(m.x @ a, m.y @ a, m.z @ a)


def _transform_back(a: Vec, m: Mat3) -> Vec:
    return Vec(
        m.x.x * a.x + m.y.x * a.y + m.z.x * a.z,
        m.x.y * a.x + m.y.y * a.y + m.z.y * a.z,
        m.x.z * a.x + m.y.z * a.y + m.z.z * a.z,
    )


def _teach(
    symbol: Callable[..., Any], cases: list[tuple[tuple[Any, ...], Callable[..., Any]]]
) -> None:
    """Register the operators above with the compiler."""

    def fits(numba_type: Any, wanted: Any) -> bool:
        if wanted is float:
            return isinstance(numba_type, types.Float)
        return is_named(numba_type, wanted)

    if symbol is operator.neg:

        def typed_unary(a: Any) -> Any:
            return next((f for (k,), f in cases if fits(a, k)), None)

        compiler_rule(symbol)(typed_unary)
        return

    def typed(a: Any, b: Any) -> Any:
        return next((f for (k, m), f in cases if fits(a, k) and fits(b, m)), None)

    compiler_rule(symbol)(typed)


_teach(operator.add, [((Vec, Vec), _add), ((Mat3, Mat3), _add_matrices)])
_teach(operator.sub, [((Vec, Vec), _subtract), ((Mat3, Mat3), _subtract_matrices)])
_teach(operator.neg, [((Vec,), _negate)])
_teach(
    operator.mul,
    [
        ((Vec, float), _scale),
        ((float, Vec), _scale_from_left),
        ((Mat3, float), _scale_matrix),
        ((float, Mat3), _scale_matrix_from_left),
    ],
)
_teach(
    operator.matmul,
    [
        ((Vec, Vec), _dot),
        ((Mat3, Vec), _transform),
        ((Vec, Mat3), _transform_back),
        ((Mat3, Mat3), _product),
    ],
)
_teach(operator.xor, [((Vec, Vec), _cross)])


@kernel
def larger(a: float, b: float) -> float:
    """The larger of two floats."""
    return a if a > b else b


@kernel
def smaller(a: float, b: float) -> float:
    """The smaller of two floats."""
    return a if a < b else b


@kernel
def positive_part(x: float) -> float:
    """The positive part of x: max(x, 0)."""
    return x if x > 0.0 else 0.0


@kernel
def norm(a: Vec) -> float:
    """Length of a vector."""
    return math.sqrt(a @ a)


@kernel
def rotation(q: Quat) -> Mat3:
    """Rotation matrix of a unit quaternion: columns are the body axes in the world."""
    x, y, z = q.x + q.x, q.y + q.y, q.z + q.z  # doubling is exact
    xx, yy, zz = q.x * x, q.y * y, q.z * z
    xy, xz, yz = q.x * y, q.x * z, q.y * z
    wx, wy, wz = q.w * x, q.w * y, q.w * z
    return Mat3(
        Vec(1.0 - (yy + zz), xy - wz, xz + wy),
        Vec(xy + wz, 1.0 - (xx + zz), yz - wx),
        Vec(xz - wy, yz + wx, 1.0 - (xx + yy)),
    )


@kernel
def quaternion_rate(q: Quat, omega: Vec) -> Quat:
    """Rate q̇ = ½ q ⊗ (0, ω) for ω in body axes [rad/s]."""
    x, y, z = 0.5 * omega.x, 0.5 * omega.y, 0.5 * omega.z
    return Quat(
        -q.x * x - q.y * y - q.z * z,
        q.w * x + q.y * z - q.z * y,
        q.w * y + q.z * x - q.x * z,
        q.w * z + q.x * y - q.y * x,
    )


@kernel
def normalise(q: Quat) -> Quat:
    """Unit quaternion in the direction of q."""
    scale = 1.0 / math.sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z)
    return Quat(q.w * scale, q.x * scale, q.y * scale, q.z * scale)


@kernel
def renormalise(q: Quat) -> Quat:
    """Unit quaternion from a q of nearly unit length, without root and division.

    With e = 1 − q·q the remaining length is 1 − 5 e³/16: exact to the last bit for e < 1e-5.
    """
    e = 1.0 - (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z)
    scale = 1.0 + e * (0.5 + 0.375 * e)
    return Quat(q.w * scale, q.x * scale, q.y * scale, q.z * scale)


class Adjugate(NamedTuple):
    """Adjugate and determinant of a symmetric matrix; their quotient is the inverse."""

    matrix: Mat3
    determinant: float


@kernel
def _adjugate(m: Mat3) -> Adjugate:
    """Adjugate of a symmetric matrix, of which only the upper half is read."""
    a, d, f = m.x.x, m.y.y, m.z.z
    p, q, r = m.x.y, m.x.z, m.y.z
    c00, c01, c02 = d * f - r * r, q * r - p * f, p * r - q * d
    c11, c12, c22 = a * f - q * q, p * q - a * r, a * d - p * p
    rows = Mat3(Vec(c00, c01, c02), Vec(c01, c11, c12), Vec(c02, c12, c22))
    return Adjugate(rows, a * c00 + p * c01 + q * c02)


@kernel
def solve_symmetric(m: Mat3, b: Vec) -> Vec:
    """Solution x of m x = b for a symmetric positive definite m; only its upper half is read."""
    turned = _adjugate(m)
    return (turned.matrix @ b) * (1.0 / turned.determinant)


@kernel
def inverse_symmetric(m: Mat3) -> Mat3:
    """Inverse of a symmetric positive definite matrix; only its upper half is read."""
    turned = _adjugate(m)
    return turned.matrix * (1.0 / turned.determinant)


@kernel
def transpose(m: Mat3) -> Mat3:
    """The transposed matrix."""
    return Mat3(
        Vec(m.x.x, m.y.x, m.z.x),
        Vec(m.x.y, m.y.y, m.z.y),
        Vec(m.x.z, m.y.z, m.z.z),
    )


@kernel
def symmetric_part(m: Mat3) -> Mat3:
    """Symmetric part ½ (m + mᵀ)."""
    return 0.5 * (m + transpose(m))


@kernel
def isotropic(s: float) -> Mat3:
    """Identity matrix times s."""
    return Mat3(Vec(s, 0.0, 0.0), Vec(0.0, s, 0.0), Vec(0.0, 0.0, s))


@kernel
def outer(a: Vec, b: Vec) -> Mat3:
    """Matrix a bᵀ."""
    return Mat3(a.x * b, a.y * b, a.z * b)


@kernel
def skew(a: Vec) -> Mat3:
    """Matrix [a]× with [a]× b = a × b."""
    return Mat3(Vec(0.0, -a.z, a.y), Vec(a.z, 0.0, -a.x), Vec(-a.y, a.x, 0.0))


@kernel
def quaternion_product(a: Quat, b: Quat) -> Quat:
    """Hamilton product a ⊗ b; as attitudes, first b, then a."""
    return Quat(
        a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
        a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
        a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
        a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
    )


@kernel
def conjugate(q: Quat) -> Quat:
    """Inverse of a unit quaternion."""
    return Quat(q.w, -q.x, -q.y, -q.z)


#: Added to squared angles, so that the axis of a zero rotation needs no special case.
_NO_ANGLE = 1e-300


@kernel
def exponential_map(angle: Vec) -> Quat:
    """Exponential map: the rotation by a rotation vector [rad]."""
    half = math.sqrt(0.25 * (angle @ angle) + _NO_ANGLE)
    of = sine_cosine(half)
    s = 0.5 * of.sine / half
    return Quat(of.cosine, s * angle.x, s * angle.y, s * angle.z)


@kernel
def small_angle_map(angle: Vec) -> Quat:
    """Small-angle `exponential_map`, by four terms of cosine and sine.

    It is exact to the last bit below 0.1 rad, to 1e-9 at 0.6 rad, and takes a third of the time.
    """
    z = 0.25 * (angle @ angle)
    w = 1.0 - z * (1.0 / 2.0 - z * (1.0 / 24.0 - z * (1.0 / 720.0)))
    s = 0.5 - z * (1.0 / 12.0 - z * (1.0 / 240.0 - z * (1.0 / 10080.0)))
    return Quat(w, s * angle.x, s * angle.y, s * angle.z)


@kernel
def rotation_vector(q: Quat) -> Vec:
    """Logarithm map: the rotation vector [rad] of a unit quaternion, at most π long."""
    axis = Vec(q.x, q.y, q.z)
    length = math.sqrt(axis @ axis + _NO_ANGLE)
    sign = 1.0 if q.w >= 0.0 else -1.0
    return axis * (2.0 * sign * angle_of(length, sign * q.w) / length)


@kernel
def axiswise(a: Vec, b: Vec) -> Vec:
    """Products of corresponding components."""
    return Vec(a.x * b.x, a.y * b.y, a.z * b.z)


@kernel
def within(x: float, lowest: float, highest: float) -> float:
    """Clamp x between two bounds; the lower one wins if they cross."""
    below = x if x < highest else highest
    return below if below > lowest else lowest


@kernel
def quaternion_of(r: Mat3) -> Quat:
    """Unit quaternion with w ≥ 0 of a rotation matrix.

    The entries of R give the rows of 4 q qᵀ; the row of the largest component of q is q up to
    scale, and free of cancellation (Shepperd, J. Guidance and Control 1(3), 1978).
    """
    ww = 1.0 + r.x.x + r.y.y + r.z.z
    xx = 1.0 + r.x.x - r.y.y - r.z.z
    yy = 1.0 - r.x.x + r.y.y - r.z.z
    zz = 1.0 - r.x.x - r.y.y + r.z.z
    wx, wy, wz = r.z.y - r.y.z, r.x.z - r.z.x, r.y.x - r.x.y
    xy, xz, yz = r.x.y + r.y.x, r.x.z + r.z.x, r.y.z + r.z.y
    by_w, by_x = Quat(ww, wx, wy, wz), Quat(wx, xx, xy, xz)
    by_y, by_z = Quat(wy, xy, yy, yz), Quat(wz, xz, yz, zz)
    first = by_w if ww > xx else by_x
    second = by_y if yy > zz else by_z
    row = first if (ww if ww > xx else xx) > (yy if yy > zz else zz) else second
    q = normalise(row)
    return q if q.w >= 0.0 else Quat(-q.w, -q.x, -q.y, -q.z)

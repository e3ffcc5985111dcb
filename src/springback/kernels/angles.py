"""Sine, cosine and arc tangent from additions and products alone.

The compiler can vectorise these over lanes, which it cannot do with calls to a library, and they
return the same bits on every machine.  Range reductions and polynomials are those of Sun's fdlibm
1993 (k_sin, k_cos, s_atan); results are within about 1 ulp.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from springback.kernels.bits import bits_of, float_of
from springback.kernels.compiler import kernel

#: π/2 in three parts of 33 bits: products with integers up to 2²⁰ are exact (fdlibm).
_FIRST, _SECOND, _THIRD = (
    1.57079632673412561417,
    6.07710050630396597660e-11,
    2.02226624879595063154e-21,
)
_TWO_OVER_PI = 0.636619772367581343076
_QUARTER = 0.785398163397448309616
#: tan(π/8), the upper limit of the arc tangent's polynomial.
_EIGHTH = 0.414213562373095048802
#: Avoids division by zero.
_TINY = 1e-300
#: 3 · 2⁵¹: floats near it are integers.
_WHOLE = 6755399441055744.0
#: The last two bits of an integer, and the shift that takes the second to a float's sign bit.
_ONE, _TWO, _TO_SIGN = np.uint64(1), np.uint64(2), np.uint64(62)


class SineCosine(NamedTuple):
    """Sine and cosine of one angle."""

    sine: float
    cosine: float


@kernel
def nearest_integer(x: float) -> float:
    """The integer nearest to x, ties to even; for |x| < 2⁵¹."""
    return (x + _WHOLE) - _WHOLE


@kernel
def floor(x: float) -> float:
    """The largest integer not above x, for |x| < 2⁵¹; a float, unlike math.floor."""
    nearest = nearest_integer(x)
    return nearest - 1.0 if nearest > x else nearest


@kernel
def _sine(r: float, z: float) -> float:
    """Sine for |r| ≤ π/4, with z = r²."""
    tail = z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)
    tail = z * (-1.98412698298579493134e-04 + z * (2.75573137070700676789e-06 + tail))
    return r + r * z * (-1.66666666666666324348e-01 + z * (8.33333333332248946124e-03 + tail))


@kernel
def _cosine(z: float) -> float:
    """Cosine of an angle of at most π/4, from its square z."""
    tail = z * (2.08757232129817482790e-09 - z * 1.13596475577881948265e-11)
    tail = z * (2.48015872894767294178e-05 + z * (-2.75573143513906633035e-07 + tail))
    tail = z * (4.16666666666666019037e-02 + z * (-1.38888888888741095749e-03 + tail))
    half = 0.5 * z
    head = 1.0 - half
    return head + ((1.0 - head - half) + z * tail)


@kernel
def sine_cosine(angle: float) -> SineCosine:
    """Sine and cosine of an angle of less than a million turns [rad]."""
    counted = angle * _TWO_OVER_PI + _WHOLE  # quarter turns: an integer, in the last bits
    quarters, last = counted - _WHOLE, bits_of(counted)
    r = ((angle - quarters * _FIRST) - quarters * _SECOND) - quarters * _THIRD
    z = r * r
    s, c = _sine(r, z), _cosine(z)
    swapped = (last & _ONE) == _ONE
    sine, cosine = c if swapped else s, s if swapped else c
    sign, other = (last & _TWO) << _TO_SIGN, ((last + _ONE) & _TWO) << _TO_SIGN
    return SineCosine(float_of(bits_of(sine) ^ sign), float_of(bits_of(cosine) ^ other))


@kernel
def _arc_tangent(t: float) -> float:
    """Arc tangent for |t| ≤ tan(π/8)."""
    z = t * t
    w = z * z
    even = 4.97687799461593236017e-02 + w * 1.62858201153657823623e-02
    even = 6.66107313738753120669e-02 + w * even
    even = 1.42857142725034663711e-01 + w * (9.09088713343650656196e-02 + w * even)
    even = z * (3.33333333333329318027e-01 + w * even)
    odd = -5.83357013379057348645e-02 + w * -3.65315727442169155270e-02
    odd = -1.11111104054623557880e-01 + w * (-7.69187620504482999495e-02 + w * odd)
    odd = w * (-1.99999999998764832476e-01 + w * odd)
    return t - t * (even + odd)


@kernel
def angle_of(sine: float, cosine: float) -> float:
    """Angle of a direction of any length, from −π to π [rad]; 0 for length zero.

    Args:
        sine: The sine times any positive factor.
        cosine: The cosine times the same factor.
    """
    y, x = math.fabs(sine), math.fabs(cosine)
    steep = y > x
    less, more = x if steep else y, y if steep else x
    t = less / (more + _TINY)
    far = t > _EIGHTH
    over, under = t - 1.0 if far else t, t + 1.0 if far else 1.0
    base = _QUARTER if far else 0.0
    first = base + _arc_tangent(over / under)
    second = 2.0 * _QUARTER - first if steep else first
    third = 4.0 * _QUARTER - second if cosine < 0.0 else second
    return -third if sine < 0.0 else third

"""Exponential and logarithm from additions, products and the bits of floats alone.

As in `springback.kernels.angles`: they vectorise, and return the same bits on every machine.
The reductions and the logarithm's polynomial are those of Sun's fdlibm 1993 (e_exp, e_log).
"""

from __future__ import annotations

import math

import numpy as np

from springback.kernels.angles import nearest_integer
from springback.kernels.bits import bits_of, float_of
from springback.kernels.compiler import kernel

#: Layout of a float: bits of its fraction, those of 1.0, and shift of the exponent.
_FRACTION, _ONE = np.uint64(0x000FFFFFFFFFFFFF), np.uint64(0x3FF0000000000000)
_PLACE = np.uint64(52)
_BIAS = 1023.0
#: 2⁵²: integers added to it appear in the fraction's bits.
_WHOLE = 4503599627370496.0
#: ln 2 in two parts, and 1/ln 2.
_LN2_HIGH, _LN2_LOW = 6.93147180369123816490e-01, 1.90821492927058770002e-10
_PER_LN2 = 1.44269504088896338700
_ROOT_2 = math.sqrt(2.0)
#: Smallest exponent whose exponential is a normal float; arguments below are replaced by it.
LEAST = -708.0


@kernel
def logarithm(x: float) -> float:
    """Natural logarithm of a positive normal float."""
    bits = bits_of(x)
    exponent: float = 1.0 * (bits >> _PLACE) - _BIAS
    m = float_of((bits & _FRACTION) | _ONE)
    large = m > _ROOT_2
    e, part = exponent + 1.0 if large else exponent, 0.5 * m if large else m
    f = part - 1.0
    s = f / (2.0 + f)
    z = s * s
    w = z * z
    odd = 2.222219843214978396e-01 + w * 1.531383769920937332e-01
    odd = w * (3.999999999940941908e-01 + w * odd)
    even = 1.818357216161805012e-01 + w * 1.479819860511658591e-01
    even = z * (6.666666666666735130e-01 + w * (2.857142874366239149e-01 + w * even))
    half = 0.5 * f * f
    return e * _LN2_HIGH - ((half - (s * (half + odd + even) + e * _LN2_LOW)) - f)


@kernel
def exponential(x: float) -> float:
    """Exponential for −708 to 709; e⁻⁷⁰⁸ below.

    e^x = 2^n e^r with |r| ≤ ln 2 / 2, and e^r by its series to r¹³/13!, with a remainder below
    2⁻⁵⁷.
    """
    inside = x if x > LEAST else LEAST
    n = nearest_integer(inside * _PER_LN2)
    r = (inside - n * _LN2_HIGH) - n * _LN2_LOW
    s = 1.0 / 39916800.0 + r * (1.0 / 479001600.0 + r * (1.0 / 6227020800.0))
    s = 1.0 / 40320.0 + r * (1.0 / 362880.0 + r * (1.0 / 3628800.0 + r * s))
    s = 1.0 / 120.0 + r * (1.0 / 720.0 + r * (1.0 / 5040.0 + r * s))
    s = 0.5 + r * (1.0 / 6.0 + r * (1.0 / 24.0 + r * s))
    power = float_of(bits_of(n + (_WHOLE + _BIAS)) << _PLACE)
    return power * (1.0 + (r + r * r * s))

"""Restitution of a Hunt–Crossley contact, exactly.

For one mass against a fixed surface, with d = 1.5 c_a and v_0 the speed at touch, the restitution e
obeys  ln[(1 + d v_0)/(1 − e d v_0)] = d v_0 (1 + e)  for any mass, stiffness and exponent
(derivation: docs/decisions/0004).  The textbook e = 1 − c_a v_0 is far off at the restitutions of
real surfaces.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable

from springback.errors import InputError


def _excess(h: float, x: float) -> float:
    """Left minus right side of the relation for h = d v_0 and x = −ln(1 − e h).

    In x, because under strong damping e h comes closer to 1 than floats can tell.
    """
    return math.log1p(h) + x - h + math.expm1(-x)


def _root(function: Callable[[float], float], lowest: float, highest: float) -> float:
    """Where an increasing function is zero: bisection, to the last bit.

    By hand, because importing SciPy's would cost every start of the program a quarter of a second.
    """
    while lowest < (middle := 0.5 * (lowest + highest)) < highest:
        if function(middle) < 0.0:
            lowest = middle
        else:
            highest = middle
    return middle


def restitution(dissipation: float, speed: float) -> float:
    """Restitution e of a contact with c_a [s/m] touched at some speed [m/s].

    Raises:
        InputError: If one of them is negative or no number.
    """
    if not dissipation >= 0.0:
        raise InputError(f"dissipation must be at least 0 s/m (got {dissipation:g} s/m)")
    if not speed >= 0.0:
        raise InputError(f"speed must be at least 0 m/s (got {speed:g} m/s)")
    h = 1.5 * dissipation * speed
    if h < 1e-8:
        return 1.0 - h / 1.5
    x = _root(lambda x: _excess(h, x), 0.0, h + 1.0)
    return -math.expm1(-x) / h


@functools.lru_cache(maxsize=256)  # a campaign asks for the same surfaces again and again
def dissipation_for(target: float, speed: float) -> float:
    """The c_a [s/m] that gives a restitution at some speed [m/s].

    Raises:
        InputError: If the restitution is not within 0.01 and 1 or the speed is not positive.
    """
    if not 0.01 <= target <= 1.0:
        raise InputError(f"restitution must be from 0.01 to 1 (got {target:g})")
    if not speed > 0.0:
        raise InputError(f"restitution_speed must be more than 0 m/s (got {speed:g} m/s)")
    if target == 1.0:
        return 0.0
    lowest, highest = 1e-8, 2.0 / target  # x < h (1 + e) < 2/e, as e h < 1
    if _excess(-math.expm1(-lowest) / target, lowest) >= 0.0:
        return (1.0 - target) / speed  # next to no damping: e = 1 − c_a v_0
    x = _root(lambda x: _excess(-math.expm1(-x) / target, x), lowest, highest)
    return -math.expm1(-x) / target / (1.5 * speed)

"""Exact restitution of a Hunt–Crossley contact.

For one mass against a fixed surface, with d = 1.5 c_a and impact speed v_0, the restitution e
obeys  ln[(1 + d v_0)/(1 − e d v_0)] = d v_0 (1 + e)  for any mass, stiffness and exponent
(derivation: docs/decisions/0004).  The textbook e = 1 − c_a v_0 is far off at the restitutions of
real surfaces.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable

from springback.errors import InputError
from springback.kernels.tracing import traceable  # for batch set-up


def _excess(h: float, x: float) -> float:
    """Left minus right side of the relation for h = d v_0 and x = −ln(1 − e h).

    The unknown is x, because under strong damping e h comes closer to 1 than floats resolve.
    """
    return math.log1p(h) + x - h + math.expm1(-x)


def _root(function: Callable[[float], float], lowest: float, highest: float) -> float:
    """Root of an increasing function: bisection, to the last bit.

    SciPy's root finder would do, but importing it delays every start by a quarter of a second.
    """
    while lowest < (middle := 0.5 * (lowest + highest)) < highest:
        if function(middle) < 0.0:
            lowest = middle
        else:
            highest = middle
    return middle


def restitution(dissipation: float, speed: float) -> float:
    """Restitution e of a contact with c_a [s/m] at some impact speed [m/s].

    Raises:
        InputError: If one of them is negative or not a number.
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


@traceable
@functools.lru_cache(maxsize=256)  # a campaign uses the same surfaces repeatedly
def dissipation_for(target: float, speed: float) -> float:
    """Dissipation c_a [s/m] that gives a restitution at some impact speed [m/s].

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
        return (1.0 - target) / speed  # almost no damping: e = 1 − c_a v_0
    x = _root(lambda x: _excess(-math.expm1(-x) / target, x), lowest, highest)
    return -math.expm1(-x) / target / (1.5 * speed)

"""Restitution of a Hunt–Crossley contact, exactly.

For one mass against a fixed surface, with d = 1.5 c_a and v_0 the speed at touch, the restitution e
obeys  ln[(1 + d v_0)/(1 − e d v_0)] = d v_0 (1 + e)  for any mass, stiffness and exponent
(derivation: docs/decisions/0004).  The textbook e = 1 − c_a v_0 is far off at the restitutions of
real surfaces.
"""

from __future__ import annotations

import math

from scipy.optimize import brentq

from springback.errors import InputError


def _excess(e: float, h: float) -> float:
    """Left minus right side of the relation for h = d v_0; grows with e."""
    return math.log1p(h) - math.log1p(-e * h) - h * (1.0 + e)


def restitution(dissipation: float, speed: float) -> float:
    """Restitution e of a contact with c_a [s/m] touched at some speed [m/s]."""
    h = 1.5 * dissipation * speed
    if h == 0.0:
        return 1.0
    highest = min(1.0, 1.0 / h) * (1.0 - 1e-15)
    return float(brentq(_excess, 0.0, highest, args=(h,), xtol=1e-15, rtol=1e-14))


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
    highest = (1.0 - 1e-12) / target  # e h < 1
    lowest = 1e-9
    if _excess(target, lowest) * _excess(target, highest) > 0.0:
        return 0.0
    h = brentq(lambda value: _excess(target, value), lowest, highest, xtol=1e-15, rtol=1e-14)
    return float(h) / (1.5 * speed)

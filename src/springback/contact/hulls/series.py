"""Two surfaces in series: that of an obstacle and that of a hull.

Both carry the same force F = k δⁿ, so their depths add: δ = F^(1/n) (k₁^(−1/n) + k₂^(−1/n)).  Each
takes the share s_i = k_i^(−1/n) / Σ of the depth and of its rate.  Dampers lose d_i F δ̇_i² or
b_i δ̇_i², so d = Σ s_i² d_i and b = Σ s_i² b_i lose the same power, as long as they are weak beside
the springs.  Two equal bodies thus rebound as each does from a rigid plane at half the speed.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from springback.contact.surfaces import AnyExponent, Surface, power
from springback.kernels.compiler import kernel
from springback.kernels.vectors import larger


class HullLaw(NamedTuple):
    """Numbers of a hull's own surface."""

    compliance: float  # k^(−1/n); 0: rigid
    dissipation: float  # d = 1.5 c_a [s/m]
    viscosity: float  # b [N s/m]
    friction: float  # μ; −1: the obstacle's alone
    slip_speed: float  # [m/s]; −1: the obstacle's
    exponent: float  # n


@kernel
def in_series(surface: Surface, law: HullLaw) -> Surface:
    """Surface of an obstacle with that of a hull in series.

    A surface of the impulse law has no springs: only its friction is combined.
    """
    friction = surface.friction
    if law.friction >= 0.0:
        friction = math.sqrt(friction * law.friction)
    slip_speed = larger(surface.slip_speed, law.slip_speed)
    k, d, b = surface.stiffness, surface.dissipation, surface.viscosity
    if (law.compliance > 0.0) & (k > 0.0):
        n = law.exponent
        own = _compliance(k, n)
        both = own + law.compliance
        here, there = own / both, law.compliance / both
        k = 1.0 / power(AnyExponent(n), both)
        d = here * here * d + there * there * law.dissipation
        b = here * here * b + there * there * law.viscosity
    return Surface(
        k, d, b, surface.exponent, friction, surface.friction_axes, slip_speed, surface.restitution,
        surface.presliding, surface.rolling,
    )  # fmt: skip


@kernel
def _compliance(stiffness: float, exponent: float) -> float:
    """k^(−1/n)."""
    if exponent == 1.0:
        return 1.0 / stiffness
    found: float = stiffness ** (-1.0 / exponent)
    return found

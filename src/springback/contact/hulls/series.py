"""Two surfaces in series: that of an obstacle and that of a hull.

Both carry the same force F = k δⁿ, so their depths add: δ = F^(1/n) (k₁^(−1/n) + k₂^(−1/n)).  Each
takes the share s_i = k_i^(−1/n) / Σ of the depth and of its rate.  Dampers lose d_i F δ̇_i² or
b_i δ̇_i², so d = Σ s_i² d_i and b = Σ s_i² b_i lose the same power, as long as they are weak beside
the springs.  Two equal bodies thus rebound as each does from a rigid plane at half the speed.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from springback.contact.surfaces import AnyExponent, Hysteresis, Surface, power
from springback.kernels.compiler import kernel
from springback.kernels.trees import replace, tree_map
from springback.kernels.vectors import larger


class HullLaw(NamedTuple):
    """Numbers of a hull's own surface."""

    compliance: float  # k^(−1/n); 0: rigid
    dissipation: float  # d = 1.5 c_a [s/m]
    viscosity: float  # b [N s/m]
    friction: float  # μ; −1: the obstacle's alone
    slip_speed: float  # [m/s]; −1: the obstacle's
    exponent: float  # n
    hysteresis: Hysteresis = Hysteresis(0.0, 0.0, 0.0)
    alone: float = 0.0  # 1: obstacles are as if rigid


def hull_law(numbers: Sequence[float]) -> HullLaw:
    """Law of the numbers of a hull's surface (`springback.vehicle.force_laws.HullSurface`)."""
    compliance, d, b, friction, slip_speed, exponent, shape, curve, stays, alone = numbers
    memory = Hysteresis(shape, curve, stays)
    return HullLaw(compliance, d, b, friction, slip_speed, exponent, memory, alone)


@kernel
def _both(theirs: Hysteresis, law: HullLaw, share: float) -> Hysteresis:
    """Memory of both springs, of which the hull's takes a share of the depth.

    At the deepest depth each holds its share of the energy, and returns 1/(1 + s) of that.
    """
    ours = law.hysteresis
    if share == 0.0:
        return theirs
    if law.alone > 0.0:
        return ours
    returned = share / (1.0 + ours.shape) + (1.0 - share) / (1.0 + theirs.shape)
    return Hysteresis(1.0 / returned - 1.0, theirs.curve, larger(ours.stays, theirs.stays))


class _Springs(NamedTuple):
    """Spring and damper of both surfaces."""

    stiffness: float
    dissipation: float
    viscosity: float
    exponent: float
    own_share: float  # of the depth, that of the hull


@kernel
def _springs(surface: Surface, law: HullLaw) -> _Springs:
    k, d, b = surface.stiffness, surface.dissipation, surface.viscosity
    n = law.exponent
    if (law.alone > 0.0) & (k > 0.0):
        own = _stiffness(law.compliance, n) if law.compliance > 0.0 else k
        return _Springs(own, law.dissipation, law.viscosity, n, 1.0)
    if (law.compliance > 0.0) & (k > 0.0):
        own = _compliance(k, n)
        both = own + law.compliance
        here, there = own / both, law.compliance / both
        d = here * here * d + there * there * law.dissipation
        b = here * here * b + there * there * law.viscosity
        return _Springs(_stiffness(both, n), d, b, n, there)
    return _Springs(k, d, b, surface.exponent.value, 0.0)


@kernel
def in_series(surface: Surface, law: HullLaw) -> Surface:
    """Surface of an obstacle with that of a hull in series.

    A surface of the impulse law has no springs: only its friction is combined.  A hull whose law is
    alone meets everything by that; of the obstacle's surface only friction counts.
    """
    friction = surface.friction
    if law.friction >= 0.0:
        friction = math.sqrt(friction * law.friction)
    slip_speed = larger(surface.slip_speed, law.slip_speed)
    found = _springs(surface, law)
    return replace(
        surface, stiffness=found.stiffness, dissipation=found.dissipation,
        viscosity=found.viscosity, exponent=AnyExponent(found.exponent), friction=friction,
        slip_speed=slip_speed,
        hysteresis=tree_map(_both, (surface.hysteresis,), (law, found.own_share)),
    )  # fmt: skip


@kernel
def _compliance(stiffness: float, exponent: float) -> float:
    """k^(−1/n)."""
    if exponent == 1.0:
        return 1.0 / stiffness
    found: float = stiffness ** (-1.0 / exponent)
    return found


@kernel
def _stiffness(compliance: float, exponent: float) -> float:
    """K of its `_compliance`."""
    if exponent < 1.0:  # a power whose slope is bounded is for depths only
        found: float = compliance**-exponent
        return found
    return 1.0 / power(AnyExponent(exponent), compliance)

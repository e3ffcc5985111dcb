"""Surfaces: the laws of normal force and friction.

One set of numbers covers all laws: the normal force is  k δⁿ (1 + d δ̇) + b δ̇  while δ > 0, and
never adhesive.  Hunt–Crossley has d > 0, Hertz b = d = 0, Kelvin–Voigt n = 1 and d = 0.  The
impulse law has no force; its velocity jump is computed in `springback.dynamics.impulse`.  Laws that
remember the deepest depth have others (`springback.contact.laws.hysteresis`).

For n < 1 the slope of δⁿ has no bound at 0.  There δⁿ is δ (δ² + ε²)^((n−1)/2), with ε = 0.1 mm.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import select
from springback.kernels.vectors import Vec, positive_part


class ThreeHalves(NamedTuple):
    """Exponent 3/2, by a square root: the Hertzian sphere, and the paper's choice."""

    value: float


class AnyExponent(NamedTuple):
    """Any exponent, by the power function: a step takes about twice as long."""

    value: float


Exponent = ThreeHalves | AnyExponent


class Hysteresis(NamedTuple):
    """Memory of a surface; see `springback.contact.laws.hysteresis`."""

    shape: float  # s of φ = wˢ coming out; 0: as going in
    curve: float  # address of a curve in place of k δⁿ; 0: there is none
    stays: float  # 1: what is pressed in does not recover


class Surface(NamedTuple):
    """Numbers of a contact surface for one cage."""

    stiffness: float  # k [N/mⁿ]
    dissipation: float  # d = 1.5 c_a [s/m]
    viscosity: float  # b, Kelvin-Voigt only [N s/m]
    exponent: Exponent  # n
    friction: float  # μ
    vertical: float  # 1: friction opposes only the vertical part of the slip, eq. (14)
    slip_speed: float  # below which friction is regularised [m/s]
    restitution: float  # e of the impulse law; negative for a force law
    presliding: float = 0.0  # slip at which bristles let go [m]; 0: it has none
    rolling: float = 0.0  # lever of rolling resistance [m], with bristles
    hysteresis: tuple[Hysteresis, ...] = ()  # in a scene


def remembers(surface: Surface) -> bool:
    """True for a surface whose force depends on the deepest depth, or on a curve."""
    return any(one.shape > 0.0 or one.curve > 0.0 for one in surface.hysteresis)


#: Avoids division by zero [m].
TINY = 1e-12
#: ε, depth below which a law of an exponent below 1 is linear [m] (chosen: its force at 1 mm is
#: then 0.5 (1 − n) % lower).
TOE = 1e-4
#: Below this (δ/ε)², energies are those of a series.
NEAR_TOUCH = 1e-3


@generic
def power(exponent: Exponent, depth: float) -> float:
    """Power δⁿ for δ ≥ 0; regularised for n < 1."""
    if exponent.value == 1.5:  # in a world of several exponents, too
        return power(ThreeHalves(1.5), depth)
    if exponent.value < 1.0:
        return depth * _softening(exponent.value, depth)
    raised: float = depth**exponent.value
    return raised


@kernel
def _softening(n: float, depth: float) -> float:
    """(δ² + ε²)^((n−1)/2), at least the derivative of the regularised δⁿ for n < 1."""
    found: float = (depth * depth + TOE * TOE) ** (0.5 * (n - 1.0))
    return found


@power.register(ThreeHalves)
@kernel
def _three_halves(exponent: ThreeHalves, depth: float) -> float:
    return depth * math.sqrt(depth)


@generic
def steepest(exponent: Exponent, depth: float, ahead: float) -> float:
    """Upper bound on the derivative n xⁿ⁻¹ for depths x from δ to a little more, or less if n < 1.

    Args:
        exponent: n.
        depth: δ ≥ 0 [m].
        ahead: Additional depth, the same for all contacts of a vehicle [m].
    """
    if exponent.value < 1.0:
        return _softening(exponent.value, positive_part(depth - ahead))
    deepest = depth + ahead
    derivative: float = exponent.value * power(exponent, deepest) / (deepest + TINY)
    return derivative


@steepest.register(ThreeHalves)
@kernel
def _steepest_three_halves(exponent: ThreeHalves, depth: float, ahead: float) -> float:
    # √(δ + Δ) ≤ √δ + √Δ: the force takes the first root anyway and all cages share the other.
    return 1.5 * (math.sqrt(depth) + math.sqrt(ahead))


class NormalForce(NamedTuple):
    """Normal force of one contact, its heat, stiffness and damping."""

    force: float  # f_n ≥ 0 [N]
    loss: float  # power turned into heat [W]
    stiffness: float  # ∂f_n/∂δ, up to a little more depth [N/m]
    damper: float  # ∂f_n/∂δ̇, likewise [N s/m]


@kernel
def normal_force(surface: Surface, depth: float, rate: float, ahead: float) -> NormalForce:
    """Hunt–Crossley, Hertz or Kelvin–Voigt force, never adhesive [N].

    Eq. (15) with the sign of Hunt & Crossley (1975): with δ̇ > 0 in compression, the printed minus
    would add energy (docs/paper/errata.md).  Where the sum would pull, the force is zero and the
    remaining elastic energy is lost.

    Args:
        surface: Stiffness k [N/mⁿ], dissipation d [s/m], viscosity b [N s/m], exponent n.
        depth: Penetration δ [m]; not negative.
        rate: δ̇ [m/s]; positive in compression.
        ahead: Stiffness and damper hold for depths up to this much larger [m].
    """
    k, d, b = surface.stiffness, surface.dissipation, surface.viscosity
    elastic = k * power(surface.exponent, depth)
    pressed = positive_part(elastic + (d * elastic + b) * rate)
    force = pressed if depth > 0.0 else 0.0
    steep = k * steepest(surface.exponent, depth, ahead)
    stiffness = steep * (1.0 + d * positive_part(rate)) if depth > 0.0 else 0.0
    damper = d * (elastic + steep * ahead) + b if depth > 0.0 else 0.0
    return NormalForce(force, (force - elastic) * rate, stiffness, damper)


@kernel
def share_of_force(whole: NormalForce, share: float) -> NormalForce:
    """Normal force at the same depth and rate of what has a share of its stiffness left.

    Springs and dampers of all laws are proportional to the stiffness, so all of it is.
    """
    return NormalForce(
        share * whole.force, share * whole.loss, share * whole.stiffness, share * whole.damper
    )


@kernel
def slip_velocity(surface: Surface, velocity: Vec, normal: Vec, vertical: Vec) -> Vec:
    """Part of a velocity along the surface that friction opposes [m/s].

    All of it, or its vertical part, as in the paper's eq. (14).

    Args:
        surface: Which of the two.
        velocity: Of the contact point [m/s].
        normal: Unit normal of the surface.
        vertical: e_Z, in the same axes as the others.
    """
    slip = velocity - (velocity @ normal) * normal
    up = vertical - (vertical @ normal) * normal  # e_Z along the surface; zero on a floor
    upright = up * ((slip @ up) / (up @ up + 1e-12))
    opposed: Vec = select(surface.vertical > 0.0, upright, slip)
    return opposed


class Friction(NamedTuple):
    """Friction of one contact and its heat."""

    force: Vec  # f_f [N]
    loss: float  # power turned into heat [W]
    grip: float  # −f_f / v, friction as a damper [N s/m]
    per_speed: float  # 1/√(v² + v_s²); 0 without normal force or friction [s/m]


@kernel
def friction_force(surface: Surface, normal_force: float, slip: Vec) -> Friction:
    """Coulomb friction against the slip velocity, regularised near zero slip [N].

    f = −μ f_n v / √(v² + v_s²).  The paper's v/‖v‖ is undefined at rest, which is where its own
    slider tests operate.

    Args:
        surface: Friction coefficient μ, slip speed v_s [m/s].
        normal_force: f_n [N].
        slip: Tangential velocity of the contact point [m/s].
    """
    v_s, square = surface.slip_speed, slip @ slip
    most = surface.friction * normal_force
    per_speed = 1.0 / math.sqrt(square + v_s * v_s)
    grip = most * per_speed
    return Friction(slip * -grip, grip * square, grip, per_speed if most > 0.0 else 0.0)


@kernel
def elastic_energy(surface: Surface, depth: float) -> float:
    """Energy stored in a contact, k δⁿ⁺¹/(n+1) [J]; without memory."""
    n = surface.exponent.value
    if n < 1.0:
        p, x = 0.5 * (n + 1.0), depth * depth / (TOE * TOE)
        # Near the touch, (1 + x)ᵖ − 1 is lost to rounding, but not the force: they are compared.
        series = 1.0 + (p - 1.0) * x * (0.5 + (p - 2.0) * x * (1.0 / 6.0 + (p - 3.0) * x / 24.0))
        grown = p * x * series if x < NEAR_TOUCH else (1.0 + x) ** p - 1.0
        stored: float = surface.stiffness * (TOE * TOE) ** p * grown / (n + 1.0)
        return stored
    return surface.stiffness * power(surface.exponent, depth) * depth / (n + 1.0)

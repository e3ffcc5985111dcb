"""Stiffness of guards, pads and rods from their material and shape, for contact laws.

Contact with something hard is governed by the guard: its stiffness is derived here, and goes into
the ``surface`` of a hull or an obstacle.  All are small deflections of linear elastic bodies.
"""

from __future__ import annotations

import math

from springback.errors import InputError


def _positive(**given: float) -> None:
    for name, value in given.items():
        if not value > 0.0 or not math.isfinite(value):
            raise InputError(f"{name} must be more than 0 and finite (got {value:g})")


def _poisson(**given: float) -> None:
    for name, value in given.items():
        if not -1.0 < value <= 0.5:
            raise InputError(f"{name} must be more than -1 and at most 0.5 (got {value:g})")


def contact_modulus(
    young: float, poisson: float, other_young: float = math.inf, other_poisson: float = 0.0
) -> float:
    """Modulus E* of a contact of two bodies, 1/E* = Σ (1 − ν²)/E [Pa] (Hertz 1882).

    Args:
        young: E of one body [Pa].
        poisson: Its ν.
        other_young: Of the other body; rigid by default [Pa].
        other_poisson: Its ν.

    Raises:
        InputError: If a modulus is not positive, or a ν that of no body.
    """
    _positive(young=young)
    if not other_young > 0.0:
        raise InputError(f"other_young must be more than 0 (got {other_young:g})")
    _poisson(poisson=poisson, other_poisson=other_poisson)
    return 1.0 / ((1.0 - poisson**2) / young + (1.0 - other_poisson**2) / other_young)


def hertz_stiffness(modulus: float, radius: float) -> float:
    """Stiffness k of a sphere on a plane, k = (4/3) E* √R, of F = k δ^1.5 [N/m^1.5] (Hertz 1882).

    Args:
        modulus: E*, by `contact_modulus` [Pa].
        radius: R of the sphere, or 1/R the sum of two curvatures [m].

    Raises:
        InputError: If one of them is not positive.
    """
    _positive(modulus=modulus, radius=radius)
    return 4.0 / 3.0 * modulus * math.sqrt(radius)


def rod_second_moment(diameter: float, inner: float = 0.0) -> float:
    """Second moment of area I of a rod or tube, π (D⁴ − d⁴)/64 [m⁴].

    Args:
        diameter: D [m].
        inner: d of a tube [m].

    Raises:
        InputError: If D is not positive, or d not from 0 to less than D.
    """
    _positive(diameter=diameter)
    if not 0.0 <= inner < diameter:
        raise InputError(f"inner must be at least 0 and less than {diameter:g} m (got {inner:g} m)")
    return math.pi * (diameter**4 - inner**4) / 64.0


def ring_stiffness(young: float, second_moment: float, radius: float) -> float:
    """Stiffness of a thin ring pressed across a diameter, EI/(r³ (π/4 − 2/π)) [N/m].

    The two forces are opposite: a guard that its arm holds opposite the wall.  One that is held on
    both sides is stiffer.  Bending alone, in the plane of the ring (Timoshenko, Strength of
    Materials II, thin rings).

    Args:
        young: E [Pa].
        second_moment: I of its cross section, bent in its plane [m⁴].
        radius: r, to the middle of the cross section [m].

    Raises:
        InputError: If one of them is not positive.
    """
    _positive(young=young, second_moment=second_moment, radius=radius)
    return young * second_moment / radius**3 / (0.25 * math.pi - 2.0 / math.pi)


def shell_stiffness(young: float, poisson: float, thickness: float, radius: float) -> float:
    """Stiffness of a thin spherical shell under a point load, 4 E t²/(R √(3 (1 − ν²))) [N/m].

    For deflections below the thickness (Reissner, Journal of Mathematics and Physics 25, 1946); a
    lattice counts with the thickness of an equivalent shell.

    Args:
        young: E [Pa].
        poisson: ν.
        thickness: t [m].
        radius: R [m].

    Raises:
        InputError: If one of them is not positive, or ν that of no body.
    """
    _positive(young=young, thickness=thickness, radius=radius)
    _poisson(poisson=poisson)
    return 4.0 * young * thickness**2 / (radius * math.sqrt(3.0 * (1.0 - poisson**2)))


def pad_stiffness(young: float, area: float, thickness: float) -> float:
    """Stiffness of a pad that is pressed on its whole face, E A/h [N/m].

    Args:
        young: E of the foam before it yields [Pa].
        area: A [m²].
        thickness: h [m].

    Raises:
        InputError: If one of them is not positive.
    """
    _positive(young=young, area=area, thickness=thickness)
    return young * area / thickness


def cantilever_stiffness(young: float, second_moment: float, length: float) -> float:
    """Stiffness at the free end of a rod that is clamped at the other, 3 E I/l³ [N/m].

    Args:
        young: E [Pa].
        second_moment: I [m⁴].
        length: l [m].

    Raises:
        InputError: If one of them is not positive.
    """
    _positive(young=young, second_moment=second_moment, length=length)
    return 3.0 * young * second_moment / length**3


def series_stiffness(*stiffness: float, exponent: float = 1.0) -> float:
    """Stiffness of springs F = k δⁿ in series, whose k^(−1/n) add [N/mⁿ].

    Args:
        stiffness: k of each [N/mⁿ].
        exponent: n, of all.

    Raises:
        InputError: If there is none, or one of them is not positive.
    """
    if not stiffness:
        raise InputError("stiffness must be given of one spring at least")
    _positive(exponent=exponent, **{f"stiffness {k}": one for k, one in enumerate(stiffness, 1)})
    return float(sum(one ** (-1.0 / exponent) for one in stiffness) ** -exponent)

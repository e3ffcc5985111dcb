"""Stiffness of guards, pads and rods from their material and shape, for contact laws.

Contact with something hard is governed by the guard: its stiffness is derived here, and goes into
the ``surface`` of a hull or an obstacle.  All are small deflections of linear elastic bodies.
Arguments are numbers in SI, or text with a unit, such as ``"120 GPa"`` or ``"4 mm"``.
"""

from __future__ import annotations

import math

from springback.errors import InputError, shown_value
from springback.units import UnitError, read_number

#: A number in SI, or text with a unit.
Amount = float | str
_UNITS = {
    "young": "Pa", "other_young": "Pa", "modulus": "Pa", "radius": "m", "diameter": "m",
    "inner": "m", "second_moment": "m^4", "thickness": "m", "area": "m^2", "length": "m",
}  # fmt: skip


def _si(name: str, value: Amount, unit: str = "") -> float:
    """A number in SI, from text with a unit if it is that."""
    unit = unit or _UNITS[name]
    if not isinstance(value, str):
        return float(value)
    try:
        return read_number(value, unit)
    except UnitError as error:
        told = f"{name} {error} (got {shown_value(value)}); expected {unit}"
        raise InputError(told) from None


def _positive(**given: Amount) -> list[float]:
    """Numbers in SI, all of them more than 0 and finite."""
    return [_checked(name, _si(name, value)) for name, value in given.items()]


def _checked(name: str, value: float) -> float:
    if not value > 0.0 or not math.isfinite(value):
        raise InputError(f"{name} must be more than 0 and finite (got {value:g})")
    return value


def _poisson(**given: float) -> None:
    for name, value in given.items():
        if not -1.0 < value <= 0.5:
            raise InputError(f"{name} must be more than -1 and at most 0.5 (got {value:g})")


def contact_modulus(
    young: Amount, poisson: float, other_young: Amount = math.inf, other_poisson: float = 0.0
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
    (e,) = _positive(young=young)
    other = _si("other_young", other_young)
    if not other > 0.0:
        raise InputError(f"other_young must be more than 0 (got {other:g})")
    _poisson(poisson=poisson, other_poisson=other_poisson)
    return 1.0 / ((1.0 - poisson**2) / e + (1.0 - other_poisson**2) / other)


def hertz_stiffness(modulus: Amount, radius: Amount) -> float:
    """Stiffness k of a sphere on a plane, k = (4/3) E* √R, of F = k δ^1.5 [N/m^1.5] (Hertz 1882).

    Args:
        modulus: E*, by `contact_modulus` [Pa].
        radius: R of the sphere, or 1/R the sum of two curvatures [m].

    Raises:
        InputError: If one of them is not positive.
    """
    e, r = _positive(modulus=modulus, radius=radius)
    return 4.0 / 3.0 * e * math.sqrt(r)


def rod_second_moment(diameter: Amount, inner: Amount = 0.0) -> float:
    """Second moment of area I of a rod or tube, π (D⁴ − d⁴)/64 [m⁴].

    Args:
        diameter: D [m].
        inner: d of a tube [m].

    Raises:
        InputError: If D is not positive, or d not from 0 to less than D.
    """
    (outer,), hole = _positive(diameter=diameter), _si("inner", inner)
    if not 0.0 <= hole < outer:
        raise InputError(f"inner must be at least 0 and less than {outer:g} m (got {hole:g} m)")
    return math.pi * (outer**4 - hole**4) / 64.0


def ring_stiffness(young: Amount, second_moment: Amount, radius: Amount) -> float:
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
    e, i, r = _positive(young=young, second_moment=second_moment, radius=radius)
    return e * i / r**3 / (0.25 * math.pi - 2.0 / math.pi)


def shell_stiffness(young: Amount, poisson: float, thickness: Amount, radius: Amount) -> float:
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
    e, t, r = _positive(young=young, thickness=thickness, radius=radius)
    _poisson(poisson=poisson)
    return 4.0 * e * t**2 / (r * math.sqrt(3.0 * (1.0 - poisson**2)))


def pad_stiffness(young: Amount, area: Amount, thickness: Amount) -> float:
    """Stiffness of a pad that is pressed on its whole face, E A/h [N/m].

    Args:
        young: E of the foam before it yields [Pa].
        area: A [m²].
        thickness: h [m].

    Raises:
        InputError: If one of them is not positive.
    """
    e, a, h = _positive(young=young, area=area, thickness=thickness)
    return e * a / h


def cantilever_stiffness(young: Amount, second_moment: Amount, length: Amount) -> float:
    """Stiffness at the free end of a rod that is clamped at the other, 3 E I/l³ [N/m].

    Args:
        young: E [Pa].
        second_moment: I [m⁴].
        length: l [m].

    Raises:
        InputError: If one of them is not positive.
    """
    e, i, x = _positive(young=young, second_moment=second_moment, length=length)
    return 3.0 * e * i / x**3


def series_stiffness(*stiffness: Amount, exponent: float = 1.0) -> float:
    """Stiffness of springs F = k δⁿ in series, whose k^(−1/n) add [N/mⁿ].

    Args:
        stiffness: k of each [N/mⁿ].
        exponent: n, of all.

    Raises:
        InputError: If there is none, or one of them is not positive.
    """
    if not stiffness:
        raise InputError("stiffness must be given for at least one spring")
    _checked("exponent", exponent)
    unit = "N/m" if exponent == 1.0 else f"N/m^{exponent:g}"
    names = [f"stiffness {k}" for k in range(1, len(stiffness) + 1)]
    each = [
        _checked(name, _si(name, one, unit)) for name, one in zip(names, stiffness, strict=True)
    ]
    return float(sum(one ** (-1.0 / exponent) for one in each) ** -exponent)

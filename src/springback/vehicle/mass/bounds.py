"""Bounds of a main body's moments of inertia, from its mass and the size of the vehicle.

No moment exceeds m (3 r)², as of a body whose whole mass is three times as far as the farthest
point of the vehicle that touches anything: generous, as those of the library have 0.07 to 0.3 m r².
What touches nothing, such as a boom or a leg without a hull, may thus stick out.

A solid ball has the least moments of all bodies of one mass and density, 2/5 m a² of radius a each.
Those of a body, whatever its shape, add up to at least 6/5 m a².
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from springback.kernels.tracing import traceable
from springback.settings import problem

#: How far mass may be, in reaches of the vehicle (chosen).
BEYOND = 3.0
#: Densest matter, osmium at 20 °C [kg/m³].
DENSEST = 22_590.0
#: The sum of moments, cubed, is at least this times the fifth power of the mass.
_LEAST = 1.2**3 * (3.0 / (4.0 * math.pi * DENSEST)) ** 2


def check_inertia(
    mass: float,
    inertia: tuple[tuple[float, ...], ...],
    reach: float,
    weighed_by: str = "inertia",
) -> None:
    """Reject moments that no body of a mass and size has.

    Args:
        mass: Of the main body [kg].
        inertia: About its centre of mass [kg m²].
        reach: Of the vehicle, from there [m].
        weighed_by: Field that they follow from: ``parts``, which may be points, or ``model``.

    Raises:
        The problem of that field, with the allowed range.
    """
    moments = _moments(inertia)
    within = BEYOND * reach
    most = mass * within * within
    for moment in moments:
        if moment > most:
            size = f"{mass:g} kg within {within:.4g} m, three times the vehicle's reach"
            raise problem(
                f"must have no principal moment above {most:.4g} kg m², the most of {size} "
                f"(got {moment:.4g} kg m²)",
                weighed_by,
            )
    total = moments[0] + moments[1] + moments[2]
    if total * total * total < _LEAST * mass * mass * mass * mass * mass and weighed_by != "parts":
        least = (_LEAST * mass**5) ** (1.0 / 3.0)
        raise problem(
            f"must have principal moments that add up to {least:.4g} kg m² at least, as of a ball "
            f"of osmium of {mass:g} kg: no matter is denser (got {total:.4g} kg m²)",
            weighed_by,
        )


def _moments(inertia: tuple[tuple[float, ...], ...]) -> tuple[Any, Any, Any]:
    """Principal moments [kg m²], in any order; of numbers of a campaign, too."""
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = inertia
    if xy == 0.0 and xz == 0.0 and yz == 0.0:
        return xx, yy, zz
    return _principal(inertia)


@traceable
def _principal(inertia: tuple[tuple[float, ...], ...]) -> tuple[float, float, float]:
    """Principal moments of a full matrix [kg m²]."""
    first, second, third = np.linalg.eigvalsh(np.array(inertia)).tolist()
    return first, second, third

"""Bearings in which a part of a vehicle turns about the main body, and the mass of that part."""

from __future__ import annotations

from typing import Annotated, ClassVar

import numpy as np

from springback.quantities import Mass, Unit
from springback.settings import Settings, problem
from springback.vehicle.state import Shell


class Bearings(Settings):
    """What all bearings have."""

    field: ClassVar[str]
    """Field of the hull that turns."""
    mass_field: ClassVar[str]
    """Field of its mass."""

    damping: Annotated[float, Unit("N m s/rad", least=0.0)] = 0.0
    """Damping of the bearings."""
    friction: Annotated[float, Unit("N m", least=0.0)] = 0.0
    """Dry friction of the bearings, the same at any speed."""

    @property
    def turning_mass(self) -> float:
        """Mass of what turns [kg]."""
        mass: float = getattr(self, self.mass_field)
        return mass


class Gimbal(Bearings):
    """Bearings in which a sphere turns about the main body, in any direction."""

    field = "gimbal"
    mass_field = "shell_mass"

    shell_mass: Mass
    """Mass of a thin shell, I_s = 2/3 m r²: part of ``body.mass``, but not of ``body.inertia``."""


class AxisBearing(Bearings):
    """Bearing in which a ring turns about its axis."""

    field = "bearing"
    mass_field = "ring_mass"

    ring_mass: Mass
    """Mass of a thin ring, I_s = m r²: part of ``body.mass`` and, as if held, of
    ``body.inertia``."""


def check_rest(
    inertia: tuple[tuple[float, ...], ...], shell: Shell, of: Bearings, field: str
) -> None:
    """Reject a ring that leaves the rest of the body no inertia about the ring's axis.

    Args:
        inertia: Of the main body, the ring held, body axes [kg m²].
        shell: The ring; a sphere leaves all.
        of: Its bearing.
        field: Of the ring's mass.

    Raises:
        The problem of that field, with the allowed range.
    """
    for axis in shell.axis:
        share = shell.inertia * float(np.dot(axis, np.linalg.solve(inertia, axis)))
        if not share < 1.0:
            raise problem(
                f"must be less than {of.turning_mass / share:.4g} kg: a ring of {shell.radius:g} m "
                f"of that mass has all of body.inertia about its axis (got {of.turning_mass:g} kg)",
                field,
            )

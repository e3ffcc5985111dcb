"""Parts of a main body: what is weighed and measured, and the mass and inertia that follow.

Each part is a homogeneous solid.  Inertias add up by Steiner's theorem; those of solids are of any
textbook of mechanics: of a hollow cylinder of radii a < b and length l, m (a² + b²)/2 about its
axis and m (3 (a² + b²) + l²)/12 across it.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal, NamedTuple

import numpy as np
from pydantic import Field, TypeAdapter, ValidationError, model_validator

from springback.frames import attitude_from_euler
from springback.kernels.vectors import Quat, rotation
from springback.quantities import Angle, Length, Mass, Triple, Unit
from springback.settings import Name, Settings, problem

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Most parts (chosen).
MOST_PARTS = 256
#: Largest distance of the parts' centre of mass from the origin of their places [m] (chosen: what a
#: scale and a ruler tell).
CENTRED = 1e-3


class _MassivePart(Settings):
    """Something of a main body that has mass."""

    name: Name = ""
    """Name, for your own reference."""
    mass: Mass
    position: Annotated[Triple, Unit("m")] = (0.0, 0.0, 0.0)
    """Position of its middle, from the centre of mass of the main body, body axes."""

    def own_inertia(self) -> Array:
        """About its own centre, body axes [kg m²], shape (3, 3)."""
        raise NotImplementedError

    def centre(self) -> Array:
        """Its middle, body axes [m]."""
        return np.array(self.position)


class PointMass(_MassivePart):
    """A small part."""

    type: Literal["point"]

    def own_inertia(self) -> Array:
        """None."""
        return np.zeros((3, 3))


class BallMass(_MassivePart):
    """A solid sphere."""

    type: Literal["ball"]
    radius: Length
    """Radius of the ball."""

    def own_inertia(self) -> Array:
        """2/5 m r² about each axis."""
        inertia: Array = 0.4 * self.mass * self.radius**2 * np.eye(3)
        return inertia


class BoxMass(_MassivePart):
    """A solid box, such as a battery or a board."""

    type: Literal["box"]
    size: Annotated[Triple, Unit("m", above=0.0)]
    """Lengths along its own axes, which are those of the body unless it is turned."""
    roll: Angle = 0.0
    pitch: Angle = 0.0
    yaw: Angle = 0.0

    def own_inertia(self) -> Array:
        """About its own centre, body axes [kg m²]."""
        squares = np.array(self.size) ** 2
        own = np.diag(self.mass / 12.0 * (squares.sum() - squares))
        turn = np.array(rotation(Quat(*attitude_from_euler(self.roll, self.pitch, self.yaw))))
        inertia: Array = turn @ own @ turn.T
        return inertia


class TubeMass(_MassivePart):
    """A tube, or a rod, between two points."""

    type: Literal["tube"]
    start: Annotated[Triple, Unit("m")]
    """One end, instead of ``position``."""
    end: Annotated[Triple, Unit("m")]
    """The other end."""
    radius: Annotated[float, Unit("m", least=0.0)] = 0.0
    """Outer radius."""
    inner_radius: Annotated[float, Unit("m", least=0.0)] = 0.0
    """Radius of the hollow inside; 0 for a rod."""

    @model_validator(mode="after")
    def _is_a_tube(self) -> TubeMass:
        if self.start == self.end:
            raise problem("must not be that of start", "end")
        if self.inner_radius > self.radius:
            raise problem(
                f"must be at most the outer radius, {self.radius:g} m "
                f"(got {self.inner_radius:g} m)",
                "inner_radius",
            )
        if self.position != (0.0, 0.0, 0.0):
            raise problem("cannot be combined with start and end", "position")
        return self

    def centre(self) -> Array:
        """Between its ends."""
        middle: Array = 0.5 * (np.array(self.start) + np.array(self.end))
        return middle

    def own_inertia(self) -> Array:
        """Of a hollow cylinder."""
        along = np.array(self.end) - np.array(self.start)
        square = float(along @ along)
        radii = self.radius**2 + self.inner_radius**2
        axial, across = self.mass * radii / 2.0, self.mass * (3.0 * radii + square) / 12.0
        inertia: Array = across * np.eye(3) + (axial - across) / square * np.outer(along, along)
        return inertia


MassPart = Annotated[PointMass | BallMass | BoxMass | TubeMass, Field(discriminator="type")]
MassParts = Annotated[tuple[MassPart, ...], Field(max_length=MOST_PARTS)]
_PARTS: TypeAdapter[Any] = TypeAdapter(MassParts)
#: Stands for mass and inertia of parts that are refused, so that nothing else is said of them.
_UNKNOWN = {"mass": 1.0, "inertia": (1.0, 1.0, 1.0)}


class MassOfParts(NamedTuple):
    """Mass and inertia of some parts together."""

    mass: float  # [kg]
    centre: tuple[float, ...]  # of mass, from the origin of their places [m]
    inertia: tuple[tuple[float, ...], ...]  # about that centre, body axes [kg m²]


def properties_of(parts: tuple[Any, ...]) -> MassOfParts:
    """Mass, centre of mass and inertia of parts; at least one."""
    mass = sum(part.mass for part in parts)
    centre = sum(part.mass * part.centre() for part in parts) / mass
    inertia = np.zeros((3, 3))
    for part in parts:
        away = part.centre() - centre
        shifted = part.mass * (away @ away * np.eye(3) - np.outer(away, away))
        inertia += part.own_inertia() + shifted
    symmetric = 0.5 * (inertia + inertia.T)
    rows = tuple(tuple(float(x) for x in row) for row in symmetric)
    return MassOfParts(float(mass), tuple(float(x) for x in centre), rows)


def with_mass_of_parts(given: Any) -> Any:
    """A raw main body, its mass and inertia those of its parts, if it has any.

    Raises:
        The problem of a part, or that of their centre of mass, or of a mass beside them.
    """
    if not isinstance(given, dict) or not given.get("parts"):
        return given
    try:
        parts = _PARTS.validate_python(given["parts"])
    except ValidationError:  # reported with its place, once the field is read
        return {**given, **_UNKNOWN}
    known = properties_of(parts)
    if max(map(abs, known.centre)) > CENTRED:
        x, y, z = (1e3 * part for part in known.centre)
        raise problem(
            f"have their centre of mass at [{x:.4g}, {y:.4g}, {z:.4g}] mm, and places on a vehicle "
            "are from there: take that from all positions, and from the heights of arms and hulls",
            "parts",
        )
    whole = {"mass": known.mass, "inertia": known.inertia}
    for name, value in whole.items():
        stored = given.get(name)
        if stored is not None and not _agree(stored, value):
            raise problem("follows from parts; leave it out", name)
    return {**given, **whole, "parts": parts}


def _agree(stored: Any, value: Any) -> bool:
    """Whether a stored number or matrix is that of the parts."""
    try:
        found = np.asarray(stored, dtype=float)
    except (TypeError, ValueError):
        return False
    return found.shape == np.shape(value) and bool(np.allclose(found, value, rtol=1e-9, atol=0.0))

"""Surfaces and obstacles: validated user input, converted to the numbers of the equations."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from springback.contact.laws.restitution import dissipation_for
from springback.contact.moving.parameters import GivenMotions
from springback.contact.obstacles import Plane
from springback.contact.surfaces import (
    Exponent,
    Hysteresis,
    Surface,
)
from springback.errors import shown_value
from springback.kernels.tracing import hypot, sqrt  # for batch set-up
from springback.kernels.vectors import Vec
from springback.quantities import Factor, Length, Speed, Triple, Unit
from springback.settings import Name, Settings, problem
from springback.vehicle.force_laws import REMEMBERING, HystereticSettings, shape_of

#: Types of obstacles that are planes.
PLANES = ("wall", "mat", "ground")

#: Slip at which bristles let go, unless it is given [m] (chosen: of hard plastic; a robot at rest
#: then swings along the surface with 50 Hz).
PRESLIDING = 1e-4

Law = Literal[
    "hunt-crossley", "hertz", "kelvin-voigt", "constant-restitution", "foam", "table", "impulse"
]

#: Numbers of a surface that a law does not read.
_DAMPING = ("dissipation", "restitution", "restitution_speed")
_UNREAD: dict[str, tuple[str, ...]] = {
    "hertz": _DAMPING, "kelvin-voigt": (*_DAMPING, "exponent"),
    "impulse": ("stiffness", "exponent", "dissipation", "restitution_speed", "viscosity"),
    "foam": ("exponent",), "table": ("exponent",),
}  # fmt: skip


class SurfaceSettings(HystereticSettings):
    """Parameters of a surface.

    `hunt-crossley` needs ``dissipation``, or ``restitution`` with ``restitution_speed``; `hertz`
    has no damping; `kelvin-voigt` has ``viscosity``; `constant-restitution` has the same
    ``restitution`` at any speed, as do `foam` and `table`, whose forces do not follow a power law;
    `impulse` has ``restitution`` and no force.  Any law with a force can also have ``viscosity``.
    """

    law: Law = "hunt-crossley"
    stiffness: Annotated[float, Unit("", above=0.0)] = 2e5
    """k_c [N/mⁿ] of the whole front, see ``shared_by``; or text such as ``"10 N/mm"`` if n is 1, or
    ``"200 kN/m^1.5"``."""
    shared_by: Annotated[int, Field(ge=1)] = 1
    """Number of cages that share the stiffness (2: a front of two cages, k_c/2 each)."""
    exponent: Annotated[float, Unit("", least=0.4, most=4.0)] = 1.5
    dissipation: Annotated[float, Unit("s/m", least=0.0)] | None = None
    """c_a in b_c = 1.5 c_a k_c."""
    restitution: Annotated[float, Unit("", least=0.0, most=1.0)] | None = None
    restitution_speed: Speed | None = None
    viscosity: Annotated[float, Unit("N s/m", least=0.0)] = 0.0
    """b of a damper beside the spring, for the whole front."""
    friction: Factor = 0.0
    friction_axes: Literal["both", "vertical"] = "both"
    """`vertical` is the paper's friction, along the vertical tangent only."""
    slip_speed: Speed = 0.03
    """Slip speed below which friction fades to zero (studies/convergence.py)."""
    friction_law: Literal["regularised", "bristle"] = "regularised"
    """`bristle` holds what lies or leans still; `regularised` lets it creep, and costs less."""
    presliding: Annotated[float, Unit("m", above=0.0)] = PRESLIDING
    """Largest elastic slip of bristles, beyond which a contact slides."""
    rolling_resistance: Annotated[float, Unit("m", least=0.0)] = 0.0
    """Lever arm of the moment against rolling and spinning in contact, for `bristle`: moment per
    normal force.  A sphere begins to roll on a slope whose tangent is this over its radius."""

    @model_validator(mode="after")
    def _consistent(self) -> SurfaceSettings:
        if self.friction_law == "bristle" and self.law == "impulse":
            raise problem("cannot be bristle with law impulse, which has no force", "friction_law")
        if self.friction_law != "bristle" and self.rolling_resistance > 0.0:
            raise problem("needs friction_law bristle", "rolling_resistance")
        if self.friction_law != "bristle" and self.presliding != PRESLIDING:
            raise problem("needs friction_law bristle", "presliding")
        if self.law == "impulse" and self.restitution is None:
            raise problem("is missing; law impulse needs it", "restitution")
        self.check_memory(self.law, self.restitution)
        if self.law in REMEMBERING:
            self._check_remembering()
        if self.law == "hunt-crossley":
            self._check_hunt_crossley()
        return self

    def _check_remembering(self) -> None:
        if self.restitution_speed is not None:
            raise problem(
                f"cannot be combined with law {self.law}: its restitution is the same at any speed",
                "restitution_speed",
            )
        if self.law == "constant-restitution" and self.dissipation is not None:
            raise problem(f"cannot be combined with law {self.law}", "dissipation")
        if self.law == "foam" and "stiffness" not in self.model_fields_set:
            raise problem("is missing; law foam needs it, in N/m", "stiffness")
        self.curve(self.law, self.stiffness)

    def _check_hunt_crossley(self) -> None:
        if self.restitution is None and self.dissipation is None:
            raise problem(
                "is missing; law hunt-crossley needs it, or restitution with restitution_speed "
                "(law hertz has no damping)",
                "dissipation",
            )
        if self.restitution is None:
            return
        if self.dissipation is not None:
            raise problem("cannot be combined with restitution; give only one", "dissipation")
        if self.restitution_speed is None:
            raise problem("is missing; restitution falls with speed", "restitution_speed")
        if self.restitution < 0.01:
            raise problem(
                f"of a Hunt–Crossley law must be at least 0.01 (got {self.restitution:g})",
                "restitution",
            )

    def unread(self) -> tuple[str, ...]:
        """Numbers that its law does not use, so that varying them is a mistake."""
        found = _UNREAD.get(self.law, ())
        if self.law == "hunt-crossley" and self.restitution is None:
            return ("restitution_speed",)
        return found

    def dissipation_value(self) -> float:
        """Coefficient c_a [s/m], given or computed from the restitution."""
        if self.law not in ("hunt-crossley", *REMEMBERING):
            return 0.0
        if self.law == "hunt-crossley" and self.restitution is not None:
            assert self.restitution_speed is not None
            return dissipation_for(self.restitution, self.restitution_speed)
        return self.dissipation or 0.0

    def exponent_value(self) -> float:
        """Exponent n of the law."""
        return 1.0 if self.law == "kelvin-voigt" else self.exponent

    def surface(self, exponent: type[Exponent], in_scene: bool = False) -> Surface:
        """Numbers for one cage; types are chosen for the whole world.

        Args:
            exponent: Type of the exponent.
            in_scene: True if it is one of many in a scene, whose contacts may have memory.
        """
        impulse = self.law == "impulse"
        n: Exponent = exponent(self.exponent_value())
        return Surface(
            stiffness=0.0 if impulse else self.stiffness / self.shared_by,
            dissipation=1.5 * self.dissipation_value(),
            viscosity=0.0 if impulse else self.viscosity / self.shared_by,
            exponent=n,
            friction=self.friction,
            vertical=1.0 if self.friction_axes == "vertical" else 0.0,
            slip_speed=self.slip_speed,
            restitution=(self.restitution or 0.0) if impulse else -1.0,
            presliding=self.presliding if self.friction_law == "bristle" else 0.0,
            rolling=self.rolling_resistance,
            hysteresis=(self._hysteresis(),) if in_scene else (),
        )

    def _hysteresis(self) -> Hysteresis:
        return Hysteresis(
            shape_of(self.law, self.restitution),
            self.curve(self.law, self.stiffness, self.shared_by),
            0.0 if self.recovers else 1.0,
        )


#: Most of a normal that may point up for an upright face (chosen: 0.06°, a rounded normal).
UPRIGHT = 1e-3


class PlaneSettings(Settings):
    """A plane obstacle: a point of its face and the direction it faces."""

    name: Name = ""
    """Name for messages and drawings."""
    distance: Annotated[float, Unit("m")] | None = None
    """Short for a wall across the X axis at this distance from the origin, facing the origin."""
    position: Annotated[Triple, Unit("m")] | None = None
    normal: Annotated[Triple, Unit("")] | None = None
    """Direction out of the obstacle, towards the vehicle; of any length."""
    surface: SurfaceSettings

    @model_validator(mode="after")
    def _check_place(self) -> PlaneSettings:
        parts = (self.position is not None, self.normal is not None)
        if any(parts) if self.distance is not None else not all(parts):
            raise problem("needs either distance, or position and normal")
        if self.normal is not None and not hypot(*self.normal) > 0.0:
            raise problem(f"must not be zero (got {shown_value(list(self.normal))})", "normal")
        return self

    def is_upright(self) -> bool:
        """True if the face is vertical, to a rounded normal."""
        n = (0.0, 0.0, 0.0) if self.normal is None else self.normal
        return abs(n[2]) <= UPRIGHT * hypot(*n)

    def plane(self, raised: float = 0.0) -> Plane:
        """The face, moved outwards by a thickness [m]."""
        if self.distance is not None:
            return Plane(Vec(-1.0, 0.0, 0.0), -self.distance + raised)
        assert self.position is not None
        assert self.normal is not None
        n = Vec(*self.normal)
        n = n * (1.0 / sqrt(n @ n))
        return Plane(n, n @ Vec(*self.position) + raised)


class Wall(PlaneSettings):
    """A wall of any position and orientation."""

    type: Literal["wall"]
    motion: GivenMotions | None = None
    """How it moves: prescribed motions only, as it is infinite; by default it is at rest."""


class Ground(Settings):
    """The ground, level at some height; touching it is an outcome."""

    type: Literal["ground"]
    name: Name = ""
    """Name for messages and drawings."""
    height: Annotated[float, Unit("m")] = 0.0
    surface: SurfaceSettings


class Mat(PlaneSettings):
    """A mat on a wall: its own surface in front, the wall behind once it is fully compressed."""

    type: Literal["mat"]
    thickness: Length = 0.05
    backing: SurfaceSettings
    """Surface of the wall behind the mat; `distance` and `position` are those of the wall."""


def faces(obstacle: Wall | Ground | Mat) -> list[tuple[Plane, SurfaceSettings, float]]:
    """Planes, surfaces and ground flags, front to back."""
    if isinstance(obstacle, Ground):
        return [(Plane(Vec(0.0, 0.0, 1.0), obstacle.height), obstacle.surface, 1.0)]
    if isinstance(obstacle, Mat):
        front = (obstacle.plane(obstacle.thickness), obstacle.surface, 0.0)
        return [front, (obstacle.plane(), obstacle.backing, 0.0)]
    return [(obstacle.plane(), obstacle.surface, 0.0)]

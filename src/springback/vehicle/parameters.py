"""Parameters of a vehicle: validated user input, converted to the numbers of the equations."""

from __future__ import annotations

import math
from typing import Annotated, Any

import numpy as np
from pydantic import BeforeValidator, GetCoreSchemaHandler, model_validator
from pydantic_core import CoreSchema
from pydantic_core.core_schema import no_info_plain_validator_function

from springback.errors import shown_value
from springback.kernels.tracing import cos, hypot, sqrt, traceable  # for batch set-up
from springback.kernels.vectors import Mat3, Vec
from springback.quantities import Mass, PerArm, Triple, Unit, si_number
from springback.settings import Name, Settings, naming, problem
from springback.vehicle.hulls import HullSettings, SphereHull, compound_hull, no_hull
from springback.vehicle.rotors import Propulsion
from springback.vehicle.state import Airframe, Arm, Propeller, Sphere, build_airframe

#: Upper limit, to catch typing errors (chosen): a flight is compiled for each number of arms.
MOST_ARMS = 32
#: Relative rounding error allowed in moments and distances (chosen).
ROUNDING = 1e-9


@traceable
def _inertia(value: Any) -> tuple[tuple[float, ...], ...]:
    """Three principal moments or a full matrix [kg m²], validated as an inertia."""
    unit = "kg m^2"
    if not isinstance(value, list | tuple) or len(value) != 3:
        raise problem(
            f"must be three moments or a 3 x 3 matrix in kg m² (got {shown_value(value)})"
        )
    if not any(isinstance(row, list | tuple) for row in value):
        moments = [si_number(entry, unit, above=0.0) for entry in value]
        check_moments(moments)
        return tuple(tuple(m if i == j else 0.0 for j in range(3)) for i, m in enumerate(moments))
    if not all(isinstance(row, list | tuple) and len(row) == 3 for row in value):
        raise problem(f"must be a 3 x 3 matrix in kg m² (got {shown_value(value)})")
    rows = [[si_number(entry, unit) for entry in row] for row in value]
    matrix = np.array(rows)
    if not np.allclose(matrix, matrix.T, rtol=1e-9, atol=0.0):
        raise problem(f"must be symmetric (got {shown_value(rows)} kg m²)")
    principal = np.linalg.eigvalsh(matrix)
    if principal[0] <= 0.0:
        raise problem(f"must have positive principal moments (got {shown_value(rows)} kg m²)")
    check_moments(principal)
    return tuple(tuple(row) for row in rows)


class _Inertia:
    """Field that `_inertia` reads in place of pydantic."""

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        return no_info_plain_validator_function(_inertia)


@traceable
def check_moments(principal: Any) -> None:
    """Reject principal moments of inertia that no mass distribution has.

    Each is a sum of two second moments of mass, so none exceeds the sum of the other two; for a
    plate they are equal.

    Args:
        principal: Moments [kg m²], in any order, shape (3,).
    """
    first, second, largest = sorted(principal)
    if largest > (first + second) * (1.0 + ROUNDING):
        raise problem(
            f"is that of no body: the largest principal moment, {largest:g} kg m², must be at most "
            f"the sum of the others, {first + second:g} kg m²"
        )


def _flags(value: Any) -> bool | tuple[bool, ...]:
    """One boolean, or one for each arm."""
    if isinstance(value, bool):
        return value
    if isinstance(value, list | tuple) and all(isinstance(entry, bool) for entry in value):
        return tuple(value)
    raise problem(
        f"must be true or false, or a list of them, one for each arm (got {shown_value(value)})"
    )


def _signs(value: Any) -> tuple[int, ...] | None:
    """A sign, −1 or +1, for each rotor."""
    if value is None:
        return None
    if isinstance(value, list | tuple) and all(entry in (-1, 1) for entry in value):
        return tuple(int(entry) for entry in value)
    raise problem(f"must be a list of -1 and 1, one for each rotor (got {shown_value(value)})")


class Body(Settings):
    """The main body: everything but the arms."""

    mass: Mass
    inertia: Annotated[tuple[tuple[float, ...], ...], _Inertia()]
    """About the centre of mass of the main body, body axes [kg m²]; three moments or a matrix."""


class Arms(Settings):
    """Parameters of the arms.  Each is one number for all arms, or a list with one for each.

    An arm is a point mass at the end of a slide in the body plane, with its cage and rotor.
    """

    directions: tuple[Any, ...]
    """Angle of each arm from body x towards body y [rad]; their number is the number of arms."""
    length: Annotated[PerArm, Unit("m", above=0.0)]
    """Free length L, from the centre of the main body to the arm's end."""
    mass: Annotated[PerArm, Unit("kg", least=0.0)]
    cage_radius: Annotated[PerArm, Unit("m", above=0.0)]
    compliant: Annotated[bool | tuple[bool, ...], BeforeValidator(_flags)] = True
    """True: the arm slides against its spring.  False: it is locked, the vehicle rigid there."""
    stiffness: Annotated[PerArm, Unit("N/m", above=0.0)] = 5e3
    damping: Annotated[PerArm, Unit("N s/m", least=0.0)] = 0.0
    stroke: Annotated[PerArm, Unit("m", above=0.0)] = 0.05
    """Largest compression of an arm, at which it bottoms out."""
    end_stops: bool = True
    """Stops at the free length and at the end of the stroke; without them travel is unlimited."""
    stop_stiffness: Annotated[PerArm, Unit("N/m", above=0.0)] = 2e5
    stop_dissipation: Annotated[PerArm, Unit("s/m", least=0.0)] = 0.5
    """Coefficient d of the stops' force k δ (1 + d δ̇)."""
    torque_ratio: Annotated[PerArm, Unit("m", least=0.0)] = 0.0
    """c_τ, rotor torque per unit thrust."""
    spin: Annotated[tuple[int, ...] | None, BeforeValidator(_signs)] = None
    """Sign of each rotor's torque about body z; alternating −, + by default, as in eq. (2)."""

    @model_validator(mode="after")
    def _consistent(self) -> Arms:
        count = len(self.directions)
        if not 1 <= count <= MOST_ARMS:
            raise problem(
                f"must name at least one arm and at most {MOST_ARMS} (got {count})", "directions"
            )
        for name in type(self).model_fields:
            value = getattr(self, name)
            if isinstance(value, tuple) and len(value) != count:
                raise problem(f"has {len(value)} entries for {count} arms", name)
        for j in range(count):
            mass, stroke, length = self.at("mass", j), self.at("stroke", j), self.at("length", j)
            if self.at("compliant", j) and not mass > 0.0:
                raise problem(
                    f"of compliant arm {j + 1} must be more than 0 kg (got {mass:g} kg)", "mass"
                )
            if self.at("compliant", j) and not stroke < length:
                raise problem(
                    f"must be less than the length of arm {j + 1}, {length:g} m (got {stroke:g} m)",
                    "stroke",
                )
        for second in range(count):
            for first in range(second):
                self._check_apart(first, second)
        return self

    def _check_apart(self, first: int, second: int) -> None:
        """Reject two arms that point the same way, and cages that overlap.

        Uncompressed cages must not overlap, nor may they while either arm is compressed to the end
        of its stroke.  Two arms compressed at once are not checked: those of the paper's own robot
        would touch at 34 mm, which its springs do not reach.
        """
        names = f"arms {first + 1} and {second + 1}"
        cosine = cos(self.directions[first] - self.directions[second])
        if cosine > 1.0 - ROUNDING:
            raise problem(f"of {names} must differ", "directions")
        pair = (first, second)
        room = sum(self.at("cage_radius", j) for j in pair)
        for moving, still in (pair, pair[::-1]):
            here, there = self.at("length", moving), self.at("length", still)
            apart = _distance(here, there, cosine)
            if apart < room * (1.0 - ROUNDING):
                raise problem(
                    f"of {names} lets their cages overlap: radii of {room:g} m together need the "
                    f"ends of the arms as far apart, and they are {apart:.6g} m",
                    "cage_radius",
                )
            if not (self.at("compliant", moving) and self.end_stops):
                continue
            shortest = here - self.at("stroke", moving)
            nearest = _distance(min(max(there * cosine, shortest), here), there, cosine)
            if nearest < room * (1.0 - ROUNDING):
                raise problem(
                    f"of arm {moving + 1} lets its cage meet that of arm {still + 1}, which is not "
                    f"pressed in: the ends come as near as {nearest:.6g} m, the cages need "
                    f"{room:g} m (got {self.at('stroke', moving):g} m)",
                    "stroke",
                )

    @model_validator(mode="before")
    @classmethod
    def _angles(cls, given: Any) -> Any:
        if isinstance(given, dict) and isinstance(given.get("directions"), list | tuple):
            with naming("directions"):
                angles = tuple(si_number(angle, "rad") for angle in given["directions"])
            return {**given, "directions": angles}
        return given

    def at(self, name: str, j: int) -> Any:
        """The value of a field for arm ``j``, counted from 0."""
        value = getattr(self, name)
        return value[j] if isinstance(value, tuple) else value


class Hull(Settings):
    """Contact geometry of the main body: a sphere that is fixed to it, and adds no mass.

    It touches the same surfaces as the cages, by the same laws.
    """

    radius: Annotated[float, Unit("m", above=0.0)]
    """Radius of the sphere."""
    offset: Annotated[Triple, Unit("m")] = (0.0, 0.0, 0.0)
    """Position of its centre from the centre of the main body, body axes."""


def _hull(value: Any) -> Any:
    """Validate a hull; False removes that of a preset."""
    return None if value is False else value


class Vehicle(Settings):
    """A vehicle: a main body and arms.  Rigid and compliant differ in ``arms.compliant`` only."""

    name: Name = "vehicle"
    body: Body
    hull: Annotated[Hull | None, BeforeValidator(_hull)] = None
    """Without one, or with false in place of a preset's, the main body has no contact."""
    hulls: tuple[HullSettings, ...] = ()
    """More hulls, on the main body or on arms, besides ``hull`` and the cages."""
    arms: Arms
    propulsion: Propulsion | None = None
    """Rotors and battery; without it, thrusts are given from outside and have no bounds."""

    @model_validator(mode="after")
    def _hull_is_near(self) -> Vehicle:
        if self.hull is not None:
            longest = max(self.arms.at("length", j) for j in range(self.arm_count))
            away = hypot(*self.hull.offset)
            if away > longest:
                raise problem(
                    f"must be within the length of the longest arm, {longest:g} m, of the main "
                    f"body's centre (got {away:g} m)",
                    "hull.offset",
                )
        return self

    @model_validator(mode="after")
    def _hulls_are_near(self) -> Vehicle:
        longest = max(self.arms.at("length", j) for j in range(self.arm_count))
        reach = longest + max(self.arms.at("cage_radius", j) for j in range(self.arm_count))
        for k, one in enumerate(self.hulls):
            if one.on != "body" and int(one.on) > self.arm_count:
                raise problem(
                    f"must be body, or an arm from 1 to {self.arm_count} (got {one.on})",
                    f"hulls[{k}].on",
                )
            form = one.form()
            away = hypot(*form.middle())
            if away > reach:
                raise problem(
                    f"must be within {reach:g} m, the reach of the longest arm with its cage, of "
                    f"what it is fixed to (its middle is {away:.6g} m away)",
                    f"hulls[{k}]",
                )
        for part in ("body", *range(1, self.arm_count + 1)):
            self._hull_of(part)
        return self

    def hulls_on(self, part: str | int) -> tuple[HullSettings, ...]:
        """Those of ``hulls`` that are on the main body, "body", or on an arm, from 1."""
        return tuple(one for one in self.hulls if one.on == part)

    def _hull_of(self, part: str | int) -> tuple[Any, ...]:
        """Hull of the main body, "body", or of an arm, from 1, as numbers; empty without one."""
        given, found = self.hull if part == "body" else None, self.hulls_on(part)
        if not found:
            return () if given is None else (Sphere(Vec(*given.offset), given.radius),)
        if given is not None:
            ball = SphereHull(type="sphere", position=given.offset, radius=given.radius)
            found = (ball, *found)
        return (compound_hull(found),)

    @property
    def has_body_hull(self) -> bool:
        """True if the main body can touch anything."""
        return self.hull is not None or bool(self.hulls_on("body"))

    @property
    def arm_count(self) -> int:
        """Number of arms."""
        return len(self.arms.directions)

    @property
    def mass(self) -> float:
        """Total mass m [kg]."""
        mass: float = self.body.mass + sum(self.arms.at("mass", j) for j in range(self.arm_count))
        return mass

    @property
    def is_compliant(self) -> bool:
        """True if any arm slides."""
        return any(self.arms.at("compliant", j) for j in range(self.arm_count))

    def inertia(
        self, lengths: tuple[float, ...] | None = None
    ) -> np.ndarray[Any, np.dtype[np.float64]]:
        """Inertia about the main body's centre of mass for given arm lengths [kg m²], shape (3, 3).

        The arms count as point masses; the default is their free lengths.
        """
        matrix = np.array(self.body.inertia)
        for j, angle in enumerate(self.arms.directions):
            l_j = self.arms.at("length", j) if lengths is None else lengths[j]
            e = np.array([math.cos(angle), math.sin(angle), 0.0])
            matrix += self.arms.at("mass", j) * l_j**2 * (np.eye(3) - np.outer(e, e))
        return matrix

    def fastest_arm_rate(self) -> float:
        """Fastest rate of a free arm, its damper and stops [1/s], which steps must resolve."""
        rates = [0.0]
        for j in range(self.arm_count):
            if self.arms.at("compliant", j):
                m, b = self.arms.at("mass", j), self.arms.at("damping", j)
                k = self.arms.at("stiffness", j)
                root = sqrt(max(b * b - 4.0 * k * m, 0.0))
                rates.append(max((b + root) / (2.0 * m), sqrt(k / m)))
                if self.arms.end_stops:
                    rates.append(sqrt(self.arms.at("stop_stiffness", j) / m))
        return max(rates)

    @traceable
    def airframe(self) -> Airframe:
        """Numbers for the equations of motion."""
        arms, propulsion = self.arms, self.propulsion
        disc: tuple[Propeller, ...] = ()
        if propulsion is not None and propulsion.disk_radius is not None:
            disc = (Propeller(propulsion.disk_radius, propulsion.disk_height),)
        built = []
        for j, angle in enumerate(arms.directions):
            slides = bool(arms.at("compliant", j))
            spin = arms.spin[j] if arms.spin else (-1 if j % 2 == 0 else 1)
            mass, length = arms.at("mass", j), arms.at("length", j)
            built.append(
                Arm(
                    cosine=_exact(math.cos(angle)),
                    sine=_exact(math.sin(angle)),
                    mass=mass,
                    inverse_mass=1.0 / mass if slides else 0.0,
                    stiffness=arms.at("stiffness", j),
                    damping=arms.at("damping", j),
                    length=length,
                    shortest=length - arms.at("stroke", j),
                    stop_stiffness=arms.at("stop_stiffness", j) if arms.end_stops else 0.0,
                    stop_dissipation=arms.at("stop_dissipation", j),
                    compliance=1.0 if slides else 0.0,
                    cage_radius=arms.at("cage_radius", j),
                    torque_ratio=spin * arms.at("torque_ratio", j),
                    hull=self._hull_of(j + 1),
                    propeller=disc,
                )
            )
        if any(arm.hull for arm in built):  # arms of one structure: those without hulls get none
            built = [arm if arm.hull else arm._replace(hull=(no_hull(),)) for arm in built]
        inertia = Mat3(*(Vec(*row) for row in self.body.inertia))
        return build_airframe(self.mass, inertia, tuple(built), self._hull_of("body"))

    def lengths(self) -> tuple[float, ...]:
        """Free arm lengths [m]."""
        return tuple(self.arms.at("length", j) for j in range(self.arm_count))


def _distance(here: float, there: float, cosine: float) -> float:
    """Distance between the ends of two arms [m] of given lengths, from the cosine between them."""
    square = here * here + there * there - 2.0 * here * there * cosine
    distance: float = sqrt(max(square, 0.0))
    return distance


def _exact(x: float) -> float:
    """Round to zero the cosines of right angles, which come out as 6e-17."""
    return 0.0 if abs(x) < 1e-15 else x


Thrust = Annotated[float, Unit("N", least=0.0)]

"""Parameters of a vehicle: validated user input, converted to the numbers of the equations."""

from __future__ import annotations

import math
from typing import Annotated, Any

import numpy as np
from pydantic import BeforeValidator, GetCoreSchemaHandler, model_validator
from pydantic_core import CoreSchema
from pydantic_core.core_schema import no_info_plain_validator_function

from springback.errors import shown_value
from springback.kernels.tracing import cos, hypot, sin, sqrt, traceable  # for batch set-up
from springback.kernels.vectors import Mat3, Vec
from springback.quantities import Mass, PerArm, Triple, Unit, si_number
from springback.settings import Name, Settings, naming, none_for_false, problem
from springback.vehicle.arms.bent import BentArm
from springback.vehicle.arms.joints import JointedArm, preload_strain
from springback.vehicle.arms.settings import Arms as Arms
from springback.vehicle.arms.settings import exact
from springback.vehicle.hulls import HullSettings, SphereHull, compound_hull, no_hull
from springback.vehicle.limits import LimitSettings, LoadLimits
from springback.vehicle.mass.bearings import check_rest
from springback.vehicle.mass.bounds import check_inertia
from springback.vehicle.mass.parts import MassParts, with_mass_of_parts
from springback.vehicle.placed.settings import RotorSettings, check_rotors, placed_rotors
from springback.vehicle.propulsion import Propulsion
from springback.vehicle.state import (
    Airframe,
    Arm,
    Propeller,
    Sphere,
    arm_pose,
    build_airframe,
)

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
    check_matrix(rows)
    return tuple(tuple(row) for row in rows)


def check_matrix(rows: Any) -> None:
    """Reject a matrix that is the inertia of no mass distribution.

    Args:
        rows: The matrix [kg m²], shape (3, 3).
    """
    apart = (rows[i][j] for i in range(3) for j in range(3) if i != j)
    if all(type(entry) is float and entry == 0.0 for entry in apart):  # also of traced numbers
        principal = [rows[k][k] for k in range(3)]
    else:
        matrix = np.array(rows)
        if not np.allclose(matrix, matrix.T, rtol=1e-9, atol=0.0):
            raise problem(f"must be symmetric (got {shown_value(rows)} kg m²)")
        principal = np.linalg.eigvalsh(matrix).tolist()
    if any(moment <= 0.0 for moment in principal):
        raise problem(f"must have positive principal moments (got {shown_value(rows)} kg m²)")
    check_moments(principal)


class _Inertia:
    """Field that `_inertia` reads in place of pydantic."""

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        return no_info_plain_validator_function(_inertia)


@traceable
def check_moments(principal: Any) -> None:
    """Reject principal moments of inertia that no mass distribution has.

    Each is a sum of two second moments of mass: none exceeds that of the others; a plate's equals.

    Args:
        principal: Moments [kg m²], in any order, shape (3,).
    """
    a, b, c = principal
    for largest, others in ((a, b + c), (b, a + c), (c, a + b)):  # without an order: also traced
        if largest > others * (1.0 + ROUNDING):
            raise problem(
                f"is that of no body: the largest principal moment, {largest:g} kg m², must be at "
                f"most the sum of the others, {others:g} kg m²"
            )


def _one_or_more(value: Any) -> Any:
    """A list; a text alone is one of one entry."""
    return (value,) if isinstance(value, str) else value


#: What is wrong with a model outside of a scenario.
_UNREAD = "is read with the vehicle of a scenario; here give mass and inertia"


class MeasuredModel(Settings):
    """A model that mass and inertia were read from."""

    model: str
    """Path of the model, as in `Body`."""
    links: tuple[Name, ...] = ()
    """Its links, as in `Body`."""
    centre: Annotated[Triple, Unit("m")]
    """Its centre of mass, from the origin of the first of these links, in that link's axes."""


class Body(Settings):
    """The main body: everything but the arms."""

    mass: Mass
    inertia: Annotated[tuple[tuple[float, ...], ...], _Inertia()]
    """Inertia about its centre of mass, body axes [kg m²]; three moments or a matrix."""
    parts: MassParts = ()
    """Points, balls, boxes and tubes from which mass and inertia follow, instead of both."""
    model: str = ""
    """A file in SDF, URDF or MJCF, relative to this one, from which mass and inertia follow."""
    links: Annotated[tuple[Name, ...], BeforeValidator(_one_or_more)] = ()
    """Links of that model that make up the main body, by names or patterns such as ``"rotor_*"``;
    none: its first link and all links that joints fix to it."""
    measured: MeasuredModel | None = None
    """That model as it was read; if this is given, the file is not read again."""

    @model_validator(mode="before")
    @classmethod
    def _of_parts(cls, given: Any) -> Any:
        has_model = isinstance(given, dict) and bool(given.get("model"))
        if has_model and given.get("parts"):
            raise problem("cannot be combined with parts", "model")
        if has_model and "mass" not in given:
            raise problem(_UNREAD, "model")
        return with_mass_of_parts(given)

    @model_validator(mode="after")
    def _as_measured(self) -> Body:
        known = self.measured
        for name in ("links", "measured"):
            if getattr(self, name) and not self.model:
                raise problem("needs a model", name)
        if self.model and (known is None or (known.model, known.links) != (self.model, self.links)):
            raise problem(_UNREAD, "model")
        return self

    @property
    def weighed_by(self) -> str:
        """Field from which mass and inertia follow; with inertia given, that itself."""
        return "parts" if self.parts else "model" if self.model else "inertia"


class Hull(Settings):
    """Contact geometry of the main body: a sphere that is fixed to it, and adds no mass.

    It touches the same surfaces as the cages, by the same laws.
    """

    radius: Annotated[float, Unit("m", above=0.0)]
    """Radius of the sphere."""
    offset: Annotated[Triple, Unit("m")] = (0.0, 0.0, 0.0)
    """Position of its centre from the centre of the main body, body axes."""


class Vehicle(Settings):
    """A vehicle: a main body and arms.  Rigid and compliant differ only in ``arms.compliant``."""

    name: Name = "vehicle"
    body: Body
    hull: Annotated[Hull | None, BeforeValidator(none_for_false)] = None
    """Contact sphere of the main body; without it, or with false in place of a preset's, none."""
    hulls: tuple[HullSettings, ...] = ()
    """More hulls, on the main body or on arms, besides ``hull`` and the cages."""
    arms: Arms
    rotors: tuple[RotorSettings, ...] = ()
    """Rotors, each on the main body or at the end of an arm; without a list, one for each arm."""
    propulsion: Propulsion | None = None
    """Rotors and battery; without it, thrusts are given from outside and have no bounds."""
    limits: Annotated[LimitSettings | None, BeforeValidator(none_for_false)] = None
    """Limits of its parts; without it, or with false in place of a preset's, nothing breaks."""

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
                    f"must be within {reach:g} m, the reach of the longest arm with its "
                    f"{self.guard_word}, of what it is fixed to (its middle is {away:.6g} m away)",
                    f"hulls[{k}]",
                )
        for part in ("body", *range(1, self.arm_count + 1)):
            self._hull_of(part)
        if self.has_shell:
            self._check_shell()
        return self

    @model_validator(mode="after")
    def _rotors_fit(self) -> Vehicle:
        if self.rotors:
            check_rotors(self.rotors, self.arms, self.reach())
            if self.propulsion is not None:
                guarded = any(one.on != "body" for one in self.rotors)
                with naming("propulsion"):
                    self.propulsion.check_guards(guarded)
        return self

    @model_validator(mode="after")
    def _inertia_is_possible(self) -> Vehicle:
        body, reach = self.body, self.reach()
        with naming("body"):
            check_inertia(body.mass, body.inertia, reach, body.weighed_by)
        return self

    def _check_shell(self) -> None:
        """Reject a shell that is not the only hull of the main body, or heavier than that."""
        for k, one in enumerate(self.hulls):
            if (of := one.bearings) is None:
                continue
            field = f"hulls[{k}].{of.field}"
            if one.on != "body":
                raise problem(f"needs a {one.type} on the body (it is on arm {one.on})", field)
            if self.hull is not None or len(self.hulls_on("body")) > 1:
                raise problem(f"needs a {one.type} that is the only hull of the main body", field)
            if of.turning_mass >= self.body.mass:
                raise problem(
                    f"must be less than the mass of the body, {self.body.mass:g} kg, of which it "
                    f"is a part (got {of.turning_mass:g} kg)",
                    f"{field}.{of.mass_field}",
                )
            [shell] = self._hull_of("body")
            check_rest(self.body.inertia, shell, of, f"{field}.{of.mass_field}")

    @model_validator(mode="after")
    def _touches_something(self) -> Vehicle:
        if not self.arms.cages and not self.hulls:
            raise problem(
                "must not be false without hulls: nothing of the vehicle would touch anything",
                "arms.cages",
            )
        return self

    @model_validator(mode="after")
    def _limits_fit(self) -> Vehicle:
        if self.limits is not None:
            with naming("limits"):
                self.limits.check(self._compliant, self.arms.hinges)
        return self

    @property
    def _compliant(self) -> tuple[bool, ...]:
        """Of each arm, True if it can slide."""
        return tuple(bool(self.arms.at("compliant", j)) for j in range(self.arm_count))

    def load_limits(self) -> LoadLimits | tuple[()]:
        """Numbers of its limits; empty if there are none."""
        if self.limits is None:
            return ()
        return self.limits.limits(
            self._compliant, tuple(map(self.arms.radii, range(self.arm_count)))
        )

    def hulls_on(self, part: str | int) -> tuple[HullSettings, ...]:
        """The ``hulls`` that are on the main body, "body", or on an arm, counted from 1."""
        return tuple(one for one in self.hulls if one.on == part)

    def _hull_of(self, part: str | int) -> tuple[Any, ...]:
        """Hull of the main body, "body", or of an arm, from 1, as numbers; empty without one."""
        given, found = self.hull if part == "body" else None, self.hulls_on(part)
        if not found:
            return () if given is None else (Sphere(Vec(*given.offset), given.radius),)
        if given is not None:
            ball = SphereHull(type="sphere", position=given.offset, radius=given.radius)
            found = (ball, *found)
        return (found[0].in_bearings(compound_hull(found)),)

    @property
    def has_shell(self) -> bool:
        """True if a hull turns by itself about the main body."""
        return any(one.bearings is not None for one in self.hulls)

    @property
    def guard_word(self) -> str:
        """What an arm touches with, in words: its cage, or a guard that hulls describe."""
        return "cage" if self.arms.cages else "guard"

    def reach(self) -> float:
        """Distance of its farthest cage or hull from the main body's centre, arms free [m].

        Circles around rotors that touch nothing count as cages.
        """
        found: list[Any] = [hypot(*one.centre) + one.radius for one in self._hull_of("body")]
        for j in range(self.arm_count):
            end = hypot(self.arms.at("length", j), self.arms.at("height", j))
            found.append(end + self.arms.at("cage_radius", j))
            found += [end + hypot(*one.centre) + one.radius for one in self._hull_of(j + 1)]
        farthest: float = max(found)
        return farthest

    @property
    def has_body_hull(self) -> bool:
        """True if the main body can touch anything."""
        return self.hull is not None or bool(self.hulls_on("body"))

    @property
    def arm_count(self) -> int:
        """Number of arms."""
        return len(self.arms.directions)

    @property
    def rotor_count(self) -> int:
        """Number of rotors: those listed, or one for each arm."""
        return len(self.rotors) or self.arm_count

    @property
    def lift(self) -> float:
        """Thrust along body z of all rotors that lift, for each newton of one of them [1].

        Without a list it is the number of arms.
        """
        if not self.rotors:
            return self.arm_count
        total: float = sum(one.direction().z for one in self.rotors if one.lifts)
        return total

    def hover_thrusts(self, weight: float) -> tuple[float, ...]:
        """Thrusts that share a weight [N] among all rotors that lift; the others give nothing [N].

        Raises:
            The problem, if no rotor lifts.
        """
        if not self.rotors:
            count = self.arm_count
            return (weight / count,) * count
        if not any(one.lifts for one in self.rotors):
            raise problem(
                "cannot hover: no rotor blows within 60 deg of body z (see axis)", "vehicle.rotors"
            )
        share = weight / self.lift
        return tuple(share if one.lifts else 0.0 for one in self.rotors)

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
            if not self.arms.is_planar:
                end = np.array(arm_pose(self._arm(j, ()), l_j, 0.0, Vec(0.0, 0.0, 0.0)).lever)
                of_point = end @ end * np.eye(3) - np.outer(end, end)
                matrix += self.arms.at("mass", j) * of_point
                continue
            e = np.array([math.cos(angle), math.sin(angle), 0.0])
            matrix += self.arms.at("mass", j) * l_j**2 * (np.eye(3) - np.outer(e, e))
        return matrix

    def fastest_arm_rate(self) -> float:
        """Fastest rate of a free arm, its damper and stops [1/s], which steps must resolve."""
        rates = [0.0]
        for j in range(self.arm_count):
            if self.arms.at("compliant", j):
                more_k, more_b = self.arms.most_between
                for own_k, own_b, m in self.arms.stiffest(j):
                    k, b = own_k + more_k, own_b + more_b
                    root = sqrt(max(b * b - 4.0 * k * m, 0.0))
                    rates.append(max((b + root) / (2.0 * m), sqrt(k / m)))
                    if self.arms.end_stops:
                        rates.append(sqrt(self.arms.at("stop_stiffness", j) / m))
        return max(rates)

    @traceable
    def airframe(self) -> Airframe:
        """Numbers for the equations of motion."""
        propulsion = self.propulsion
        found: tuple[Propeller, ...] = ()
        if propulsion is not None and propulsion.disk_radius is not None:
            found = (Propeller(propulsion.disk_radius, propulsion.disk_height),)
        disc = () if self.rotors else found
        built: list[Any] = [self._arm(j, disc) for j in range(self.arm_count)]
        if any(arm.hull for arm in built):  # arms of one structure: those without hulls get none
            built = [arm if arm.hull else arm._replace(hull=(no_hull(),)) for arm in built]
        inertia = Mat3(*(Vec(*row) for row in self.body.inertia))
        neighbours = self.arms.neighbour_springs()
        placed = placed_rotors(self.rotors, self.arms, found)
        return build_airframe(
            self.mass, inertia, tuple(built), self._hull_of("body"), neighbours, placed
        )  # fmt: skip

    def _arm(self, j: int, disc: tuple[Propeller, ...]) -> Arm | JointedArm | BentArm:
        """Numbers of arm ``j``, from 0."""
        arms, angle = self.arms, self.arms.directions[j]
        slides = bool(arms.at("compliant", j))
        spin = arms.spin[j] if arms.spin else (-1 if j % 2 == 0 else 1)
        mass, length = arms.at("mass", j), arms.at("length", j)
        common = {
            "mass": mass,
            "inverse_mass": 1.0 / mass if slides else 0.0,
            "damping": arms.at("damping", j),
            "length": length,
            "stop_stiffness": arms.at("stop_stiffness", j) if arms.end_stops else 0.0,
            "stop_dissipation": arms.at("stop_dissipation", j),
            "compliance": 1.0 if slides else 0.0,
            "cage_radius": arms.at("cage_radius", j),
            "torque_ratio": spin * arms.at("torque_ratio", j),
            "hull": self._hull_of(j + 1),
            "propeller": disc,
            "caged": 1.0 if arms.cages else 0.0,
        }
        if arms.is_planar:
            return Arm(
                cosine=exact(cos(angle)), sine=exact(sin(angle)),
                stiffness=arms.at("stiffness", j), shortest=length - arms.at("stroke", j), **common,
            )  # fmt: skip
        spring, (low, high) = arms.spring(j), arms.travel(j)
        common |= {
            "joint": arms.joint_of(j), "spring": spring,
            "stiffness": arms.linear(j), "resting_stiffness": arms.at("stiffness", j),
            "shortest": length - high, "longest": length - low,
        }  # fmt: skip
        second = arms.second_joint(j)
        return JointedArm(**common) if second is None else BentArm(second=second, **common)

    def _strain(self, j: int) -> float:
        """How far a preload presses arm ``j``, from 0, into its stop at rest [m]."""
        arms, spring = self.arms, self.arms.spring(j)
        if not arms.at("compliant", j) or spring.preload == 0.0:
            return 0.0
        return preload_strain(spring, arms.linear(j), arms.at("stop_stiffness", j))

    def lengths(self, compression: PerArm = 0.0) -> tuple[float, ...]:
        """Arm lengths at rest [m]: free, unless a preload presses an arm against its stop.

        Args:
            compression: Compression of the arms, one for all or one for each [m].
        """
        if not (isinstance(compression, float) and compression == 0.0):
            count = self.arm_count
            each = compression if isinstance(compression, tuple) else (compression,) * count
            at_rest = self.lengths()
            return tuple(length - by for length, by in zip(at_rest, each, strict=True))
        free = [self.arms.at("length", j) for j in range(self.arm_count)]
        if self.arms.is_planar:
            return tuple(free)
        pressed = [self._strain(j) for j in range(self.arm_count)]
        return tuple(length + more for length, more in zip(free, pressed, strict=True))


Thrust = Annotated[float, Unit("N", least=0.0)]

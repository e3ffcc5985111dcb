"""Joints of arms: validated user input, converted to the numbers of the equations.

Vectors are in the axes of each arm: x along its direction in the body plane, z along body z, y to
complete them; the origin is the centre of the main body.  One vector thus serves all arms of a
symmetric vehicle.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from pydantic import BeforeValidator, Field
from pydantic_core import PydanticCustomError

from springback.errors import shown_value
from springback.kernels.tracing import sqrt, traceable
from springback.kernels.vectors import Vec
from springback.quantities import PairPerArm, PerArm, Triple, TriplePerArm, Unit, with_unit
from springback.settings import Settings, naming, problem
from springback.vehicle.arms.joints import Joint, JointSpring, Latch, latch_force
from springback.vehicle.arms.latch_settings import HingeLatch, SlideLatch
from springback.vehicle.force_curves import force_table

#: Most points of a table (chosen).
MOST_POINTS = 64
#: Least length of a vector that tells a direction (chosen).
SHORTEST = 1e-6
#: x to the power n, of traced numbers, too.
power = traceable(math.pow)
#: Arc of a hinge's travel to either side, at most (chosen: beyond it arms meet the main body).
MOST_ANGLE = math.pi


def flags(value: Any) -> bool | tuple[bool, ...]:
    """Validate one boolean, or one for each arm."""
    if isinstance(value, bool):
        return value
    if isinstance(value, list | tuple) and all(isinstance(entry, bool) for entry in value):
        return tuple(value)
    raise problem(
        f"must be true or false, or a list of them, one for each arm (got {shown_value(value)})"
    )


def _points(way: str, force: str) -> Any:
    """Reader of pairs of a travel and a force, or of an angle and a torque; or such of each arm."""

    def read(value: Any) -> Any:
        if value is None:
            return None
        if isinstance(value, list | tuple) and any(map(_is_of_an_arm, value)):
            found = []
            for k, one in enumerate(value):
                with naming(f"[{k}]"):
                    found.append(() if one in ([], ()) else of_one(one))
            return tuple(found)
        return of_one(value)

    def of_one(value: Any) -> Any:
        if not isinstance(value, list | tuple) or not 2 <= len(value) <= MOST_POINTS:
            raise problem(
                f"must be 2 to {MOST_POINTS} pairs in {way} and {force} (got {shown_value(value)})"
            )
        ways, forces, found = Unit(way, least=0.0), Unit(force, least=0.0), []
        for k, pair in enumerate(value):
            with naming(f"[{k}]"):
                if not isinstance(pair, list | tuple) or len(pair) != 2:
                    raise problem(f"must be a pair in {way} and {force} (got {shown_value(pair)})")
                found.append((ways.read(pair[0]), forces.read(pair[1])))
        if found[0] != (0.0, 0.0):
            x, y = found[0]
            raise problem(f"must be 0 {way}, 0 {force} (got {x:g} {way}, {y:g} {force})", "[0]")
        for k, ((x, y), (further, more)) in enumerate(pairwise(found), start=1):
            if not further > x:
                raise problem(f"must be more than {x:g} {way}, the one before (got {further:g})",
                              f"[{k}]")  # fmt: skip
            if more < y:
                raise problem(
                    f"must be at least {y:g} {force}, the one before: a spring that gets weaker as "
                    f"it is pressed in snaps through (got {more:g} {force})",
                    f"[{k}]",
                )
        return tuple(found)

    return read


def _is_of_an_arm(entry: Any) -> bool:
    """True for an entry that is no pair, but the pairs of an arm, or none."""
    return isinstance(entry, list | tuple) and (not entry or isinstance(entry[0], list | tuple))


Points = tuple[tuple[float, float], ...]
#: Table of an arm that has none beside others that have one: no force.
_NO_FORCE = ((0.0, 0.0), (1.0, 0.0))


class _WaySettings(Settings):
    """What slides and hinges have in common."""

    one_sided: Annotated[bool | tuple[bool, ...], BeforeValidator(flags)] = False
    """True: the spring acts only while the arm is pressed in, not beyond its free length."""

    @property
    def follows(self) -> float:
        """1 if the axis of a rotor turns with the arm, else 0."""
        return 1.0

    def spring(self, radius: float, j: int) -> JointSpring:
        """Numbers of the spring of arm ``j``, from 0, along the path of its end.

        Args:
            radius: Of the path [m]; 1 for a slide.
            j: The arm.
        """
        given: Any = self
        curve: tuple[float, ...] = ()
        if given.table is not None:  # arms are of one structure: all have one
            points = self.table_of(j) or _NO_FORCE
            curve = (force_table(tuple((x * radius, y / radius) for x, y in points)),)
        return JointSpring(
            quadratic=self._at("quadratic", j) / power(radius, 3),
            preload=self._at("preload", j) / radius,
            play=self._at("play", j) * radius,
            both_sides=0.0 if self._at("one_sided", j) else 1.0,
            curve=curve,
            latch=self._latch(radius, j),
        )

    def travel_of(self, j: int) -> tuple[float, float]:
        """Travel of arm ``j``, from that at which it is longest to that at which it is pressed in.

        In metres, or radians of a hinge.
        """
        found: tuple[float, float] = self._entry("travel", j)
        return found

    def table_of(self, j: int) -> Points:
        """Points of the table of arm ``j``; empty if it has none."""
        found: Points = self._entry("table", j)
        return found or ()

    def _entry(self, name: str, j: int) -> Any:
        value = getattr(self, name)
        return value[j] if self._is_for_each(name) else value

    def _of_no_length(self, name: str, j: int) -> str:
        """What is wrong with a vector of arm ``j`` that tells no direction."""
        of = f"of arm {j + 1} " if self._is_for_each(name) else ""
        return f"{of}must be of some length (got {_numbers(_of_arm(getattr(self, name), j))})"

    def _latch(self, radius: float, j: int) -> tuple[Latch, ...]:
        """Numbers of the latch along the path of arm ``j``'s end; of no force if it has none."""
        given: Any = self
        if given.latch is None:
            return ()
        return (Latch(given.latch.holds(j) / radius, given.latch.opens(j) * radius),)

    def _is_for_each(self, name: str) -> bool:
        """Whether a field has a value for each arm."""
        value = getattr(self, name)
        if name in _LISTS:
            return isinstance(value[0], tuple)
        if name == "table":
            return value is not None and any(map(_is_of_an_arm, value))
        return name in PER_ARM and isinstance(value, tuple)

    @property
    def differs(self) -> bool:
        """True if anything is given for each arm."""
        given: Any = self
        second = getattr(self, "second", None)
        own = any(self._is_for_each(name) for name in type(self).model_fields)
        own = own or (given.latch is not None and given.latch.differs)
        return own or (second is not None and second.differs)

    def _at(self, name: str, j: int) -> float:
        value = getattr(self, name)
        one: float = value[j] if isinstance(value, tuple) else value
        return one

    def linear_of(self, radius: float, j: int) -> float:
        """Stiffness of arm ``j`` along the path of its end, besides a table [N/m]."""
        return 0.0 if self.table_of(j) else self.stiffness_of(radius, j)

    def stiffness_of(self, radius: float, j: int) -> float:
        """Stiffness of arm ``j`` along the path of its end [N/m]; of a table, at its beginning."""
        if table := self.table_of(j):
            x, y = next((point for point in table if point[1] > 0.0), table[1])
            slope: float = y / x / power(radius, 2)
            return slope
        return self._at("stiffness", j) / power(radius, 2)

    def secant_of(self, radius: float, j: int) -> float:
        """Stiffness of arm ``j`` from its free position to the end of its travel [N/m]."""
        _, most = self.travel_of(j)
        if table := self.table_of(j):
            xs, ys = zip(*table, strict=True)
            force = float(np.interp(most, xs, ys))
        else:
            force = (self._at("stiffness", j) + self._at("quadratic", j) * most) * most
        own: float = (force + self._at("preload", j)) / (most * power(radius, 2))
        for latch in self._latch(radius, j):
            own += latch_force(latch, most * radius).force / (most * radius)
        return own

    def damping_of(self, radius: float, j: int) -> float:
        """Damping of arm ``j`` along the path of its end [N s/m]."""
        return self._at("damping", j) / power(radius, 2)

    def steepest(self, radius: float, j: int) -> float:
        """The largest stiffness of arm ``j`` in its travel, along the path of its end [N/m]."""
        most = max(abs(x) for x in self.travel_of(j)) * radius
        own: float = (
            self.linear_of(radius, j) + 2.0 * self._at("quadratic", j) / power(radius, 3) * most
        )
        slopes = [
            (more - y) / (further - x) / power(radius, 2)
            for (x, y), (further, more) in pairwise(self.table_of(j))
        ]
        held = [16.0 / 9.0 * latch.force / latch.travel for latch in self._latch(radius, j)]
        # A cubic between points may be steeper than they are.
        return own + 1.5 * max(slopes, default=0.0) + sum(held)

    def check(self, count: int, compliant: tuple[bool, ...], end_stops: bool) -> None:
        """Reject numbers of another number of arms, and those that do not go together."""
        for name in type(self).model_fields:
            value = getattr(self, name)
            if self._is_for_each(name) and len(value) != count:
                raise problem(f"has {len(value)} entries for {count} arms", name)
        for j in range(count):
            self._check_travel(j)
        self._check_latch(count, end_stops)
        strained = [j for j in range(count) if self._at("preload", j) > 0.0]
        if any(self.travel_of(j)[0] < 0.0 or not end_stops for j in strained):
            raise problem(self._needs_stop, "preload")
        for j in range(count):
            stiffness, table = self._at("stiffness", j), self.table_of(j)
            if table and stiffness > 0.0:
                raise problem("cannot be combined with table; give only one", "stiffness")
            springs = stiffness > 0.0 or self._at("quadratic", j) > 0.0 or bool(table)
            if compliant[j] and not springs:
                raise problem(
                    f"of arm {j + 1} is missing: nothing would bring it back; give a stiffness, "
                    "quadratic or table",
                    "stiffness",
                )

    @property
    def _needs_stop(self) -> str:
        given: Any = self
        return f"needs the end stop at the free position: travel from 0 {given.way}, and end_stops"

    def _check_travel(self, j: int) -> None:
        """Reject a travel of arm ``j`` without its free position, and what does not fit in it."""
        given: Any = self
        (low, high), unit = self.travel_of(j), given.way
        of = f"of arm {j + 1} " if self._is_for_each("travel") else ""
        if not low <= 0.0 < high:
            raise problem(
                f"{of}must be from at most 0 to more than 0 {unit}, the free position being 0 "
                f"(got {with_unit(low, unit)} to {with_unit(high, unit)})",
                "travel",
            )
        if unit == "rad" and max(-low, high) > MOST_ANGLE:
            got = f"got {with_unit(low, unit)} to {with_unit(high, unit)}"
            raise problem(f"{of}must be within half a turn ({got})", "travel")
        if self._at("play", j) >= max(-low, high):
            raise problem(
                f"must be less than the travel, {with_unit(max(-low, high), unit)}: the spring "
                f"would never act (got {with_unit(self._at('play', j), unit)})",
                "play",
            )
        if self._at("one_sided", j) and low < 0.0:
            raise problem(
                f"{of}must begin at 0 {unit} with one_sided: nothing would bring the arm back "
                f"(got {with_unit(low, unit)})",
                "travel",
            )

    def _check_latch(self, count: int, end_stops: bool) -> None:
        given: Any = self
        latch, unit = given.latch, given.way
        if latch is None:
            return
        with naming("latch"):
            latch.check(count)
        for j in range(count):
            low, high = self.travel_of(j)
            if not latch.holds(j) > 0.0:
                continue
            if low < 0.0 or not end_stops:
                raise problem(self._needs_stop, "latch")
            if not latch.opens(j) < high:
                raise problem(
                    f"must be less than the travel of the arm, {with_unit(high, unit)}: it would "
                    f"meet its stop before the latch opens (got {with_unit(latch.opens(j), unit)})",
                    "latch.travel",
                )


#: Fields with one value for each arm.
PER_ARM = ("stiffness", "damping", "quadratic", "preload", "play", "one_sided")
#: Fields with one vector or pair for all arms, or one for each.
_LISTS = ("direction", "position", "axis", "travel")


class SlideJoint(_WaySettings):
    """A slide in any direction."""

    way: ClassVar[str] = "m"
    type: Literal["slide"]
    direction: Annotated[TriplePerArm, Unit("")] = (-1.0, 0.0, 0.0)
    """Direction in which the arm's end moves as it is pressed in, arm axes; of any length."""
    travel: Annotated[PairPerArm, Unit("m")]
    """Positions of its stops: first, at most 0, with the arm longest, then with it pressed in."""
    stiffness: Annotated[PerArm, Unit("N/m", least=0.0)] = 0.0
    quadratic: Annotated[PerArm, Unit("N/m^2", least=0.0)] = 0.0
    """k₂ of an additional force k₂ x |x|."""
    damping: Annotated[PerArm, Unit("N s/m", least=0.0)] = 0.0
    preload: Annotated[PerArm, Unit("N", least=0.0)] = 0.0
    """Force that holds the arm at its stop until a larger one presses it in."""
    play: Annotated[PerArm, Unit("m", least=0.0)] = 0.0
    """Distance to either side before the spring acts."""
    table: Annotated[Points | tuple[Points, ...] | None, BeforeValidator(_points("m", "N"))] = None
    """Displacements and forces instead of the stiffness, from (0, 0); the same to either side.  A
    list of tables has one for each arm, an empty one for an arm that has a stiffness."""
    latch: SlideLatch | None = None
    """What holds the arm stiffly at its free length until a force opens it."""

    def path(self, end: Vec, axes: tuple[Vec, Vec, Vec], j: int) -> Joint:
        """Path of the end of arm ``j``.

        Args:
            end: Its place, body axes [m].
            axes: Of the arm, in body axes.
            j: The arm, from 0.
        """
        towards = _in_body(_of_arm(self.direction, j), axes)
        size = length_of(towards)
        if size < SHORTEST:
            raise problem(self._of_no_length("direction", j), "direction")
        along = towards * (-1.0 / size)
        return Joint(end, along, _normal_to(along), 0.0, self.follows)


class HingeJoint(_WaySettings):
    """A hinge about any axis."""

    way: ClassVar[str] = "rad"
    type: Literal["hinge"]
    position: Annotated[TriplePerArm, Unit("m")] = (0.0, 0.0, 0.0)
    """A point on the hinge's axis, in the axes of the arm."""
    axis: Annotated[TriplePerArm, Unit("")]
    """Axis about which the arm turns as it is pressed in, right-handed; of any length."""
    travel: Annotated[PairPerArm, Unit("rad")]
    """Angles of its stops: first, at most 0, with the arm longest, then with it pressed in."""
    stiffness: Annotated[PerArm, Unit("N m/rad", least=0.0)] = 0.0
    quadratic: Annotated[PerArm, Unit("N m/rad^2", least=0.0)] = 0.0
    """κ₂ of an additional torque κ₂ φ |φ|."""
    damping: Annotated[PerArm, Unit("N m s/rad", least=0.0)] = 0.0
    preload: Annotated[PerArm, Unit("N m", least=0.0)] = 0.0
    """Torque that holds the arm at its stop until a larger one presses it in."""
    play: Annotated[PerArm, Unit("rad", least=0.0)] = 0.0
    """Angle to either side before the spring acts."""
    table: Annotated[Points | tuple[Points, ...] | None, BeforeValidator(_points("rad", "N m"))] = (
        None
    )
    """Angles and torques instead of the stiffness, from (0, 0); the same to either side.  A list of
    tables has one for each arm, an empty one for an arm that has a stiffness."""
    latch: HingeLatch | None = None
    """What holds the arm stiffly at its free position until a torque opens it."""

    def path(self, end: Vec, axes: tuple[Vec, Vec, Vec], j: int) -> Joint:
        """Path of the end of arm ``j``; arguments as for `SlideJoint.path`."""
        about = _in_body(_of_arm(self.axis, j), axes)
        size = length_of(about)
        if size < SHORTEST:
            raise problem(self._of_no_length("axis", j), "axis")
        about = about * (1.0 / size)
        lever = end - _in_body(_of_arm(self.position, j), axes)
        radial = lever - about * (lever @ about)
        radius = length_of(radial)
        if radius < SHORTEST:
            raise self._without_lever(lever, axes[0], j)
        outward = radial * (1.0 / radius)
        return Joint(end, outward ^ about, -outward, 1.0 / radius, self.follows)

    def _without_lever(self, lever: Vec, along: Vec, j: int) -> PydanticCustomError:
        """Problem of a hinge whose axis goes through the end of arm ``j``, which cannot move.

        Args:
            lever: Of the end, from the position of the hinge [m].
            along: Direction of the arm.
            j: The arm, from 0.
        """
        size = length_of(lever)
        if size >= SHORTEST and abs(lever @ along) > (1.0 - SHORTEST) * size:
            return problem(
                f"must not be along arm {j + 1}, through its end: the arm would turn about itself "
                f"(got {_numbers(_of_arm(self.axis, j))})",
                "axis",
            )
        return problem(
            f"must not lie on the end of arm {j + 1}, nor its axis go through it "
            f"(got {_numbers(_of_arm(self.position, j))} m)",
            "position",
        )


class SecondSlide(SlideJoint):
    """A slide that the first joint carries: of an arm that slides along a hinged one, say."""


class SecondHinge(HingeJoint):
    """A hinge that the first joint carries: of an arm that bends two ways."""


SecondSettings = Annotated[SecondSlide | SecondHinge, Field(discriminator="type")]


class _FirstSettings(Settings):
    """What a joint has that is on the main body."""

    rotors: Literal["arm", "body"] = "arm"
    """`arm`: a rotor's axis turns with its arm.  `body`: it keeps its direction in the body."""
    second: SecondSettings | None = None
    """Another joint that this one carries, with its own spring and travel; its vectors are those of
    the free arm.  None: the arm has this joint only."""

    @property
    def follows(self) -> float:
        """1 if the axis of a rotor turns with the arm, else 0."""
        return 1.0 if self.rotors == "arm" else 0.0


class SlideSettings(_FirstSettings, SlideJoint):
    """A slide in any direction."""


class HingeSettings(_FirstSettings, HingeJoint):
    """A hinge about any axis."""


JointSettings = Annotated[SlideSettings | HingeSettings, Field(discriminator="type")]


def _of_arm(given: Any, j: int) -> Triple:
    """Vector of arm ``j``, from 0: its own, or that of all."""
    vector: Triple = given[j] if isinstance(given[0], tuple) else given
    return vector


def _numbers(vector: Triple) -> str:
    """A vector as it is written."""
    return shown_value([float(part) for part in vector])


def length_of(vector: Vec) -> float:
    """Length of a vector, whose numbers may be traced."""
    length: float = sqrt(vector @ vector)
    return length


def _in_body(vector: tuple[float, float, float], axes: tuple[Vec, Vec, Vec]) -> Vec:
    x, y, z = axes
    return x * vector[0] + y * vector[1] + z * vector[2]


def _normal_to(along: Vec) -> Vec:
    """A unit vector that is normal to another."""
    other = Vec(0.0, 0.0, 1.0) if abs(along.z) < 0.9 else Vec(1.0, 0.0, 0.0)
    aside = along ^ other
    unit: Vec = aside * (1.0 / sqrt(aside @ aside))
    return unit

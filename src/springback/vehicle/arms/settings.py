"""Arms of a vehicle: validated user input, converted to the numbers of the equations."""

from __future__ import annotations

import math
from typing import Annotated, Any

from pydantic import BeforeValidator, model_validator

from springback.errors import shown_value
from springback.kernels.tracing import cos, sin, sqrt, traceable
from springback.kernels.vectors import Vec, norm
from springback.quantities import PerArm, Unit, si_number
from springback.settings import Settings, naming, none_for_false, problem
from springback.vehicle.arms.bent import SecondJoint
from springback.vehicle.arms.joint_settings import (
    HingeSettings,
    JointSettings,
    SecondHinge,
    SecondSlide,
    SlideSettings,
    flags,
    length_of,
)
from springback.vehicle.arms.joints import (
    STRAIGHT,
    Joint,
    JointSpring,
    path_point,
)
from springback.vehicle.arms.neighbours import (
    NeighbourSettings,
    NeighbourSpring,
    NeighbourSprings,
    next_of,
)

#: Upper limit, to catch typing errors (chosen): a flight is compiled for each number of arms.
MOST_ARMS = 32
#: Relative rounding error allowed in distances (chosen).
ROUNDING = 1e-9
#: Cages whose centres are at heights that differ by less can meet side by side [m] (chosen).
LEVEL = 1e-3
#: The least area between the directions in which two joints move an end of an arm (chosen: below
#: 6 deg, little mass resists moving both ways at once, and steps get short).
LEAST_INDEPENDENCE = 0.1
#: Places in the travel of a second joint at which that is looked at (chosen).
WAYS = 9
#: Fields that a joint has in place of those of an arm.
OF_SLIDES = ("stiffness", "damping", "stroke")


def _signs(value: Any) -> tuple[int, ...] | None:
    """A sign, −1 or +1, for each rotor."""
    if value is None:
        return None
    if isinstance(value, list | tuple) and all(entry in (-1, 1) for entry in value):
        return tuple(int(entry) for entry in value)
    raise problem(f"must be a list of -1 and 1, one for each rotor (got {shown_value(value)})")


class Arms(Settings):
    """Parameters of the arms.  Each is one number for all arms, or a list with one for each.

    An arm is a point mass at the end of a slide in the body plane, with its cage and rotor.
    """

    directions: tuple[Any, ...]
    """Angle of each arm from body x towards body y [rad]; their number is the number of arms."""
    length: Annotated[PerArm, Unit("m", above=0.0)]
    """Free length L, from the centre of the main body to the arm's end."""
    mass: Annotated[PerArm, Unit("kg", least=0.0)]
    height: Annotated[PerArm, Unit("m")] = 0.0
    """Height of the arm's end above the main body's centre."""
    joint: JointSettings | None = None
    """A slide in any direction or a hinge, with its own spring and travel; none: a slide along
    the arm, with ``stiffness``, ``damping`` and ``stroke``."""
    cage_radius: Annotated[PerArm, Unit("m", above=0.0)]
    """Radius of the circle around each rotor: of its cage, or of the guard that hulls describe."""
    cages: bool = True
    """False: these circles touch nothing, only hulls do; pilots still locate contacts by them."""
    compliant: Annotated[bool | tuple[bool, ...], BeforeValidator(flags)] = True
    """True: the arm slides against its spring.  False: it is locked and rigid."""
    stiffness: Annotated[PerArm, Unit("N/m", above=0.0)] = 5e3
    damping: Annotated[PerArm, Unit("N s/m", least=0.0)] = 0.0
    stroke: Annotated[PerArm, Unit("m", above=0.0)] = 0.05
    """Largest compression of an arm, at which it bottoms out."""
    end_stops: bool = True
    """Stops at the free length and at the end of the stroke; without them travel is unlimited."""
    stop_stiffness: Annotated[PerArm, Unit("N/m", above=0.0)] = 2e5
    stop_dissipation: Annotated[PerArm, Unit("s/m", least=0.0)] = 0.5
    """Coefficient d of the stops' force k δ (1 + d δ̇)."""
    neighbours: Annotated[NeighbourSettings | None, BeforeValidator(none_for_false)] = None
    """Springs between the ends of neighbouring arms; without it, or with false in place of a
    preset's, arms move independently."""
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
        if self.joint is not None:
            self._check_joint(self.joint)
        for j in range(count):
            mass, stroke, length = self.at("mass", j), self.at("stroke", j), self.at("length", j)
            if self.at("compliant", j) and not mass > 0.0:
                raise problem(
                    f"of compliant arm {j + 1} must be more than 0 kg (got {mass:g} kg)", "mass"
                )
            if self.at("compliant", j) and self.joint is None and not stroke < length:
                raise problem(
                    f"must be less than the length of arm {j + 1}, {length:g} m (got {stroke:g} m)",
                    "stroke",
                )
        for second in range(count):
            for first in range(second):
                self._check_apart(first, second)
        if self.neighbours is not None:
            self._check_neighbours()
        return self

    def _check_neighbours(self) -> None:
        """Reject springs between arms that are not listed in their order around the body."""
        count = len(self.directions)
        if count < 2:
            raise problem("needs two arms or more", "neighbours")
        full, pairs = 2.0 * math.pi, zip(self.directions, next_of(self.directions), strict=True)
        rounds = sum((there - here) % full for here, there in pairs) / full
        if count > 2 and min(abs(rounds - 1.0), abs(rounds - count + 1.0)) > ROUNDING:
            raise problem(
                "needs arms in their order around the body, so that each is next to its neighbours",
                "directions",
            )
        if not any(self.at("compliant", j) for j in range(count)):
            raise problem("needs an arm that is compliant: no other end moves", "neighbours")

    def neighbour_springs(self) -> NeighbourSprings | tuple[()]:
        """Numbers of the springs between arms; empty without any."""
        if self.neighbours is None:
            return ()
        k, b, count = self.neighbours.stiffness, self.neighbours.damping, len(self.directions)
        ends = tuple(self.end(j) for j in range(count))
        pairs = zip(ends, next_of(ends), strict=True)
        springs = [NeighbourSpring(k, b, norm(there - here)) for here, there in pairs]
        if count == 2:  # the last and the first are these two once more
            springs[1] = NeighbourSpring(0.0, 0.0, springs[1].distance)
        return NeighbourSprings(tuple(springs))

    @property
    def most_between(self) -> tuple[float, float]:
        """Bounds on stiffness and damping of an arm by the springs to its neighbours [N/m, N s/m].

        By Gershgorin's circles: two springs on its own, and their share in the two neighbours.
        """
        if self.neighbours is None:
            return 0.0, 0.0
        return 4.0 * self.neighbours.stiffness, 4.0 * self.neighbours.damping

    def _check_joint(self, joint: SlideSettings | HingeSettings) -> None:
        for name in OF_SLIDES:
            if getattr(self, name) != type(self).model_fields[name].default:
                raise problem("cannot be combined with a joint, which has its own", name)
        count = len(self.directions)
        with naming("joint"):
            joint.check(count, tuple(self.at("compliant", j) for j in range(count)), self.end_stops)
            for j in range(count):
                self.joint_of(j)
            if joint.second is not None:
                with naming("second"):
                    self._check_second(joint.second)

    def _check_second(self, second: SecondSlide | SecondHinge) -> None:
        """Reject a second joint that does not move the ends of arms another way."""
        count = len(self.directions)
        second.check(count, tuple(self.at("compliant", j) for j in range(count)), self.end_stops)
        for j in range(count):
            share = smallest([independence(way) for way in self._both_ways(j)])
            if share < LEAST_INDEPENDENCE:
                raise problem(
                    f"moves the end of arm {j + 1} along itself or in nearly the same direction as "
                    "the first does, somewhere in its travel: the sine of the angle between both, "
                    f"times their lengths, must be at least {LEAST_INDEPENDENCE:g} (it is "
                    f"{share:.3g})",
                    "axis" if isinstance(second, SecondHinge) else "direction",
                )

    def _both_ways(self, j: int) -> list[tuple[Vec, Vec]]:
        """In which directions both joints move the end of arm ``j``, through the second's travel.

        By the first joint, and by both ends of the second's travel, other such pairs are turned
        only.
        """
        first, second = self.joint_of(j), self._second_of(j)
        if second is None:
            return []
        path, (low, high) = second
        about = first.curvature * (first.direction ^ first.inward)
        found, k = [], path.curvature
        for place in range(WAYS):
            way = -(low + (high - low) * place / (WAYS - 1))
            ahead, aside, turned, across = way, 0.0, 1.0, 0.0
            if k > STRAIGHT:
                turned, across = cos(k * way), sin(k * way)
                ahead, aside = across / k, (1.0 - turned) / k
            along = first.direction + (about ^ (path.direction * ahead + path.inward * aside))
            found.append((along, path.direction * turned + path.inward * across))
        return found

    def _second_of(self, j: int) -> tuple[Joint, tuple[float, float]] | None:
        """Path of the end of arm ``j`` on its second joint, and its travel [m], if it has one."""
        if self.joint is None or self.joint.second is None:
            return None
        path = self.joint.second.path(self.end(j), self._axes(j), j)
        radius, (low, high) = radius_of(path), self.joint.second.travel_of(j)
        return path, (low * radius, high * radius)

    def second_travel(self, j: int) -> float:
        """The most by which the second joint of arm ``j`` moves its end, to either side [m]."""
        second = self._second_of(j)
        return 0.0 if second is None else max(abs(way) for way in second[1])

    def second_joint(self, j: int) -> SecondJoint | None:
        """Numbers of the second joint of arm ``j``, if it has one."""
        known = self._second_of(j)
        if self.joint is None or self.joint.second is None or known is None:
            return None
        second, (path, (low, high)), moves = self.joint.second, known, self.at("compliant", j)
        radius = radius_of(path)
        return SecondJoint(
            joint=path, spring=second.spring(radius, j),
            stiffness=second.linear_of(radius, j),
            resting_stiffness=second.secant_of(radius, j), damping=second.damping_of(radius, j),
            length=0.0, shortest=-high, longest=-low,
            stop_stiffness=self.at("stop_stiffness", j) if self.end_stops else 0.0,
            stop_dissipation=self.at("stop_dissipation", j), compliance=1.0 if moves else 0.0,
        )  # fmt: skip

    def stiffest(self, j: int) -> list[tuple[float, float, float]]:
        """Of each joint of arm ``j`` bounds for steps: stiffness, damping, mass [N/m, N s/m, kg].

        With two joints either moves a mass that is at least that over the trace of G⁻¹.
        """
        mass = self.at("mass", j)
        found = [(self.steepest(j), self.at("damping", j), mass)]
        second = self._second_of(j)
        if second is None or self.joint is None or self.joint.second is None:
            return found
        shares = []
        for first, along in self._both_ways(j):
            square = first @ first
            determinant = square * (along @ along) - (first @ along) * (first @ along)
            shares.append(determinant / (square + along @ along))
        mass = mass * smallest(shares)
        radius, other = radius_of(second[0]), self.joint.second
        more = other.steepest(radius, j), other.damping_of(radius, j), mass
        return [(*found[0][:2], mass), more]

    def end(self, j: int) -> Vec:
        """Free end of arm ``j``, counted from 0, from the main body's centre, body axes [m]."""
        x, _, z = self._axes(j)
        end: Vec = x * self.at("length", j) + z * self.at("height", j)
        return end

    def _axes(self, j: int) -> tuple[Vec, Vec, Vec]:
        """Axes of arm ``j``: along its direction, to its left, and up; body axes."""
        c, s = exact(math.cos(self.directions[j])), exact(math.sin(self.directions[j]))
        return Vec(c, s, 0.0), Vec(-s, c, 0.0), Vec(0.0, 0.0, 1.0)

    @property
    def is_planar(self) -> bool:
        """True if all arms slide in the body plane, along their directions."""
        flat = all(self.at("height", j) == 0.0 for j in range(len(self.directions)))
        return self.joint is None and flat

    @property
    def hinges(self) -> tuple[bool, ...]:
        """Of each joint of an arm, True if it is a hinge."""
        second = None if self.joint is None else self.joint.second
        joints = (self.joint,) if second is None else (self.joint, second)
        return tuple(isinstance(one, HingeSettings | SecondHinge) for one in joints)

    def radii(self, j: int) -> tuple[float, ...]:
        """Radii of the paths of the end of arm ``j`` on each joint [m]; 0 for a slide."""
        second = self._second_of(j)
        paths = [self.joint_of(j)] + ([] if second is None else [second[0]])
        radii = map(radius_of, paths)
        return tuple(r if hinge else 0.0 for r, hinge in zip(radii, self.hinges, strict=True))

    def joint_of(self, j: int) -> Joint:
        """Path of the end of arm ``j``; without a joint it slides along the arm's direction."""
        end, axes = self.end(j), self._axes(j)
        if self.joint is not None:
            return self.joint.path(end, axes, j)
        x, y, _ = axes
        return Joint(end, x, y, 0.0, 0.0)

    def radius(self, j: int) -> float:
        """Radius of the path of the end of arm ``j`` [m]; 1 for a slide."""
        return radius_of(self.joint_of(j))

    def travel(self, j: int) -> tuple[float, float]:
        """Travel of the end of arm ``j``, from its longest to pressed in, along its path [m]."""
        if self.joint is None:
            return 0.0, self.at("stroke", j)
        low, high = self.joint.travel_of(j)
        radius = self.radius(j)
        return low * radius, high * radius

    def place(self, j: int, pressed: float) -> Vec:
        """End of arm ``j``, pressed in by a way along its path [m]."""
        return path_point(self.joint_of(j), -pressed).end

    def linear(self, j: int) -> float:
        """Stiffness of arm ``j`` along the path of its end, besides a table [N/m]."""
        if self.joint is None:
            own: float = self.at("stiffness", j)
            return own
        return self.joint.linear_of(self.radius(j), j)

    def spring(self, j: int) -> JointSpring:
        """What the spring of arm ``j`` has besides its stiffness."""
        if self.joint is None:
            return JointSpring(0.0, 0.0, 0.0, 1.0)
        return self.joint.spring(self.radius(j), j)

    def steepest(self, j: int) -> float:
        """The largest stiffness of arm ``j`` in its travel [N/m]."""
        if self.joint is None:
            own: float = self.at("stiffness", j)
            return own
        return self.joint.steepest(self.radius(j), j)

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
        if not self.cages:
            return
        if not self.is_planar:
            self._check_ends(first, second)
            return
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

    def _check_ends(self, first: int, second: int) -> None:
        """Reject cages at one height that overlap while the arms are free.

        Arms out of the plane, or on hinges, are not checked while they are pressed in.
        """
        here, there = self.end(first), self.end(second)
        room = self.at("cage_radius", first) + self.at("cage_radius", second)
        apart = norm(here - there)
        if abs(here.z - there.z) < LEVEL and apart < room * (1.0 - ROUNDING):
            raise problem(
                f"of arms {first + 1} and {second + 1} lets their cages overlap: radii of "
                f"{room:g} m together need the ends of the arms as far apart, and they are "
                f"{apart:.6g} m",
                "cage_radius",
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
        """The value of a field for arm ``j``, counted from 0.

        Of an arm on a joint, damping and stroke are those along the path of its end, and stiffness
        is that of the spring from its free position to the end of its travel.
        """
        if self.joint is not None and name in OF_SLIDES:
            radius = self.radius(j)
            return {
                "stiffness": lambda: self.joint.secant_of(radius, j),
                "damping": lambda: self.joint.damping_of(radius, j),
                "stroke": lambda: self.joint.travel_of(j)[1] * radius,
            }[name]()
        value = getattr(self, name)
        return value[j] if isinstance(value, tuple) else value


def radius_of(path: Joint) -> float:
    """Radius of the path of the end of an arm [m]; 1 for a slide."""
    return 1.0 / path.curvature if path.curvature > STRAIGHT else 1.0


@traceable
def smallest(values: Any) -> float:
    """The least of several numbers, also of traced ones, whose order may differ."""
    return float(min(values))


def independence(ways: tuple[Vec, Vec]) -> float:
    """Area between two directions of motion, which are of about unit length."""
    return length_of(ways[0] ^ ways[1])


def _distance(here: float, there: float, cosine: float) -> float:
    """Distance between the ends of two arms [m] of given lengths, from the cosine between them."""
    square = here * here + there * there - 2.0 * here * there * cosine
    distance: float = sqrt(max(square, 0.0))
    return distance


def exact(x: float) -> float:
    """Round to zero the cosines of right angles, which come out as 6e-17."""
    return 0.0 if abs(x) < 1e-15 else x

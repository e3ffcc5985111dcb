"""Sizes and springs of a vehicle that are far from those of others, a sentence each."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from springback.quantities import with_unit
from springback.units import DEGREE
from springback.vehicle.arms.settings import Arms
from springback.vehicle.endurance import GRAVITY
from springback.vehicle.hulls import RingHull
from springback.vehicle.parameters import Vehicle

#: Length of an arm that no micro aerial vehicle has [m] (chosen: those of the library have 0.04 to
#: 0.19 m, large hexarotors some 0.6 m).
LONGEST_ARM = 2.0
#: Force of an arm's spring at the end of its travel, in weights of the vehicle, that is seldom
#: meant below and above (chosen: the library has 0.33 to 20; N m/deg is 57 N m/rad).
SPRING_RANGE = (0.1, 50.0)
#: Steps in one period of an arm on its spring below which it is hardly resolved (chosen).
LEAST_STEPS = 20.0
#: Speed at which a spring is looked at [m/s] (chosen: the paper's tests have some 2 m/s).
SPEED = 2.0
#: Least share of a ring's axis along body z for it to be around a rotor (chosen: tilts below 45°).
UPRIGHT = 0.7


def size_warnings(vehicle: Vehicle, impact_step: float) -> list[str]:
    """Sentences on arms, guards and springs that can be flown and are seldom meant.

    Args:
        vehicle: Any.
        impact_step: Step while something touches [s].
    """
    return [
        *_long_arms(vehicle.arms),
        *_propellers_beyond_guards(vehicle),
        *_springs_out_of_range(vehicle, impact_step),
        *_locked_arms(vehicle),
    ]


def _long_arms(arms: Arms) -> Iterator[str]:
    lengths = [float(arms.at("length", j)) for j in range(len(arms.directions))]
    longest = max(lengths)
    if longest > LONGEST_ARM:
        yield (
            f"vehicle.arms.length: {longest:g} m of arm {lengths.index(longest) + 1} is more than "
            "that of any micro aerial vehicle; 0.04 to 0.6 m are usual: is it in the unit that it "
            "says?"
        )


class _GuardRoom(NamedTuple):
    """Room that a guard leaves around the axis of a rotor."""

    radius: float  # [m]
    arm: int  # from 1
    field: str
    given: float  # radius of the guard [m]


def _propellers_beyond_guards(vehicle: Vehicle) -> Iterator[str]:
    """Propellers that reach beyond the guards around them; the farthest is told."""
    propulsion = vehicle.propulsion
    if propulsion is None or propulsion.disk_radius is None:
        return
    disc = propulsion.disk_radius
    rooms = [room for j in range(vehicle.arm_count) for room in _rooms(vehicle, j)]
    least = min(rooms, default=None)
    if least is None or disc <= least.radius * (1.0 + 1e-9):
        return
    yield (
        f"vehicle.propulsion.disk_radius: propellers of {disc:g} m reach "
        f"{1e3 * (disc - least.radius):.3g} mm beyond the guard of arm {least.arm} "
        f"({least.field}, {least.given:g} m), and are hit before it; guards are usually 1.1 to 1.8 "
        "times as large"
    )


def _rooms(vehicle: Vehicle, j: int) -> Iterator[_GuardRoom]:
    """Room around the rotor of arm ``j``, from 0, by its circle, or by rings in place of a cage."""
    places = [(0.0, 0.0)]
    if vehicle.rotors:
        places = [
            (0.0, 0.0) if one.position is None else one.position[:2]
            for one in vehicle.rotors
            if one.on == j + 1
        ]
    rings = [
        (f"vehicle.hulls[{k}].radius", hull)
        for k, hull in enumerate(vehicle.hulls)
        if hull.on == j + 1 and isinstance(hull, RingHull)
    ]
    circle = float(vehicle.arms.at("cage_radius", j))
    for x, y in places:
        around = []
        for field, ring in rings:
            upright = abs(ring.axis[2]) / math.hypot(*ring.axis)
            apart = math.hypot(ring.position[0] - x, ring.position[1] - y)
            if upright > UPRIGHT and apart < ring.radius:
                room = ring.radius * upright - apart
                around.append(_GuardRoom(room, j + 1, field, ring.radius))
        if vehicle.arms.cages or not around:
            room = circle - math.hypot(x, y)
            yield _GuardRoom(room, j + 1, "vehicle.arms.cage_radius", circle)
        yield from around


# -- springs --------------------------------------------------------------------------------------


class _ArmSpring(NamedTuple):
    """Spring of a compliant arm as it is written."""

    field: str
    stiffness: float  # as written [N/m] or [N m/rad]; of a table, to the end of the travel
    units: tuple[str, str]  # its own, and the one that is mistaken for it
    ratio: float  # of the latter to the former
    travel: str  # in words


def _spring(arms: Arms, j: int) -> _ArmSpring:
    """Spring of arm ``j``, from 0, on its first joint."""
    joint, stroke, radius = arms.joint, float(arms.at("stroke", j)), arms.radius(j)
    secant = float(arms.at("stiffness", j))
    slide = ("N/m", "N/mm")
    if joint is None:
        return _ArmSpring("vehicle.arms.stiffness", secant, slide, 1e3, f"{1e3 * stroke:.3g} mm")
    field = "table" if joint.table_of(j) else "stiffness"
    path = f"vehicle.arms.joint.{field}"
    if arms.hinges[0]:
        travel = with_unit(stroke / radius, "rad")
        torsion = ("N m/rad", "N m/deg")
        return _ArmSpring(path, secant * radius * radius, torsion, 1.0 / DEGREE, travel)
    return _ArmSpring(path, secant, slide, 1e3, f"{1e3 * stroke:.3g} mm")


def _springs_out_of_range(vehicle: Vehicle, impact_step: float) -> Iterator[str]:
    """The first arm whose spring is much stiffer or softer than others, or too quick for steps."""
    arms, weight = vehicle.arms, vehicle.mass * GRAVITY
    least, most = SPRING_RANGE
    for j in range(vehicle.arm_count):
        if not arms.at("compliant", j):
            continue
        k, stroke = float(arms.at("stiffness", j)), float(arms.at("stroke", j))
        share, of = k * stroke / weight, _spring(arms, j)
        given, other = of.stiffness, of.stiffness / of.ratio
        asks = f"is it meant in {of.units[0]} ({given:.4g}) or in {of.units[1]} ({other:.4g})?"
        spring = (
            f"{of.field}: the spring of arm {j + 1}, {given:.4g} {of.units[0]} to the end of its "
            f"travel of {of.travel}, gives {share:.3g} times the vehicle's weight there; 0.3 to 20 "
            "times are usual"
        )
        if share > most:
            moves = SPEED * math.sqrt((vehicle.mass - float(arms.at("mass", j))) / k)
            yield (
                f"{spring}: the arm is as good as rigid, an impact at {SPEED:g} m/s presses it in "
                f"by {100.0 * min(moves / stroke, 1.0):.2g} % of its travel; {asks}"
            )
            return
        if share < least:
            yield f"{spring}: the arm gives way as if without a spring; {asks}"
            return
        period = math.tau * math.sqrt(float(arms.at("mass", j)) / k)
        if period < LEAST_STEPS * impact_step:
            yield (
                f"{of.field}: arm {j + 1} swings on its spring, {given:.4g} {of.units[0]}, with a "
                f"period of {1e3 * period:.3g} ms, {period / impact_step:.3g} of "
                f"simulation.impact_step; {LEAST_STEPS:g} or more are usual: smaller steps, or "
                "compliant = false for an arm that is as good as rigid"
            )
            return


# -- arms that do not move ------------------------------------------------------------------------


def opening_load(arms: Arms, j: int) -> float:
    """Load below which arm ``j``, from 0, does not leave its free position; 0 for any load.

    That of its preload and its latch on the first joint: a force along its path [N], or of a hinge
    a torque [N m].
    """
    if arms.joint is None or not arms.at("compliant", j):
        return 0.0
    radius = arms.radius(j)
    spring = arms.spring(j)
    held = spring.preload
    for latch in spring.latch:
        if latch.force > 0.0:
            held += latch.force + arms.linear(j) * latch.travel
    return float(held * (radius if arms.hinges[0] else 1.0))


def _locked_arms(vehicle: Vehicle) -> Iterator[str]:
    """The first arm that breaks before its preload and its latch let it move."""
    arms, limits = vehicle.arms, vehicle.limits
    if limits is None or arms.joint is None:
        return
    name, unit = ("hinge_torque", "N m") if arms.hinges[0] else ("arm_force", "N")
    given = getattr(limits, name)
    for j in range(vehicle.arm_count if given is not None else 0):
        most = float(given[j] if isinstance(given, tuple) else given)
        if (load := opening_load(arms, j)) >= most:
            yield (
                f"vehicle.limits.{name}: arm {j + 1} does not move below {load:.3g} {unit}, by its "
                f"preload and latch, and breaks at {most:g} {unit}: it never folds without breaking"
            )
            return

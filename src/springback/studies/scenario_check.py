"""Check of a scenario before it is flown: numbers derived from it, and what to look out for."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np

from springback.contact.shapes import Ball, Box, Capsule, Hoop, Pole
from springback.contact.unions import ShapeUnion
from springback.control.reference_parameters import RunUpSettings
from springback.results.joints.overlap import cage_tilts, level_gap
from springback.scenario.fields import degrees
from springback.scenario.scenario import Scenario
from springback.scenario.tables import ScenarioTables
from springback.scenario.vehicles.range_check import opening_load
from springback.scenario.warnings import scenario_warnings
from springback.scenario.worlds.imported import named_obstacles
from springback.scenario.worlds.mesh_check import axis_warnings
from springback.studies.approach import ObstacleApproach, approach_ahead
from springback.vehicle.arms.settings import LEVEL
from springback.vehicle.endurance import hover_time
from springback.vehicle.parameters import Arms, Vehicle
from springback.vehicle.placed.balance import hover_balance

#: Share of the thrust in hover above which little is left to manoeuvre (chosen).
MOST_HOVER = 0.7
#: Share of the weight that pushes sideways in hover, worth a warning (chosen: a lean of 1.1°).
MOST_ASIDE = 0.02
#: Share of the mass times the square of the reach that the largest moment of inertia seldom leaves
#: (chosen: 0.07 to 0.30 in the library, 0.02 of a hexarotor with its battery in the middle).
INERTIA_SHARES = (0.01, 0.5)
#: Distance of a component from the middle, in reaches of its vehicle, seldom meant (chosen).
FAR = 2.0
#: Places in the travel of an arm at which its cage is looked at (chosen).
PLACES = 41
#: Share of a wall's force along an arm below which its spring hardly works (chosen).
LEAST_ALONG = 0.5
#: Obstacles that a warning names at most (chosen).
MOST_NAMED = 3
#: Distance between an obstacle and the wall that a run-up is planned to, which is worth a warning
#: (chosen: five standard deviations of the trials' walls) [m].
WALL_OFFSET = 0.1
#: Parts of a vehicle whose ways to an obstacle differ by less meet it together [m] (chosen).
TOGETHER = 1e-4


class ScenarioQuantity(NamedTuple):
    """A number that follows from a scenario."""

    name: str
    value: float
    """SI."""
    unit: str
    about: str


def derived_numbers(scenario: Scenario) -> list[ScenarioQuantity]:
    """Numbers that follow from a scenario's vehicle, and from its approach to an obstacle."""
    vehicle, found = scenario.vehicle, [*_masses(scenario)]
    for group in _alike(vehicle.arms):
        found += _of_arms(vehicle, group)
    found += _gaps(vehicle)
    if (approach := approach_ahead(scenario)) is not None:
        when = "at the end of the run-up" if _runs_up(scenario) else "at the start"
        found.append(ScenarioQuantity(
            "approach speed", approach.speed, "m/s", f"of the main body {when}, along the normal "
            f"of {approach.words}: met first, {approach.way:.3g} m straight on",
        ))  # fmt: skip
        if not vehicle.arms.is_planar or not _meets_an_arm(scenario, approach):
            return found  # paths of joints are not told
        found.append(ScenarioQuantity(
            "force along the foremost arm", approach.along, "",
            "share of that obstacle's normal force, cos θ − μ sin θ; "
            f"arm {approach.arm + 1} at θ = {degrees(approach.angle):.3g} deg to the normal",
        ))  # fmt: skip
        least = least_deceleration(scenario, approach)
        if least > 0.0:
            found.append(ScenarioQuantity(
                "least peak deceleration", least, "m/s^2", "v²/(2 s): to stop from this speed "
                "within the stroke, at a constant force; a spring alone peaks at twice that",
            ))  # fmt: skip
    return found


def least_deceleration(scenario: ScenarioTables, approach: ObstacleApproach | None) -> float:
    """Least peak deceleration with which the foremost arm can stop the body [m/s²].

    v²/(2 s), that of a constant force over the whole stroke s; the surface is taken as hard.  0 if
    no compliant arm meets an obstacle ahead.

    Args:
        scenario: Any.
        approach: Of its vehicle, as `springback.studies.approach.approach_ahead` finds it.
    """
    arms = scenario.vehicle.arms
    if approach is None or not approach.is_level or not arms.is_planar:
        return 0.0
    if not arms.at("compliant", approach.arm) or not _meets_an_arm(scenario, approach):
        return 0.0
    return float(approach.speed**2 / (2.0 * arms.at("stroke", approach.arm)))


def _meets_an_arm(scenario: ScenarioTables, approach: ObstacleApproach) -> bool:
    """True if the cage of an arm, or a hull on it, is what meets the obstacle ahead first."""
    vehicle, world = scenario.vehicle, scenario.world
    on_arms = tuple(one for one in vehicle.hulls if one.on != "body")
    if not approach.is_level or not (vehicle.arms.cages or on_arms):
        return False
    if not vehicle.has_body_hull:
        return True
    alone = approach_ahead(scenario.with_checked(
        vehicle=vehicle.with_checked(hull=None, hulls=on_arms),
        world=world.with_checked(obstacles=world.obstacles[approach.obstacle :][:1]),
    ))  # fmt: skip
    return alone is not None and alone.way < approach.way + TOGETHER


def _runs_up(scenario: ScenarioTables) -> bool:
    return isinstance(scenario.reference, RunUpSettings)


def check_warnings(scenario: Scenario) -> list[str]:
    """Warnings for a scenario, one sentence each: those of a flight, and more."""
    own = scenario.pilot is not None
    found = [*scenario_warnings(scenario, own=own), *axis_warnings(scenario.world.obstacles)]
    found += _vehicle_warnings(scenario)
    if scenario.second is not None:
        found += [f"second: {sentence}" for sentence in _vehicle_warnings(scenario.beside())]
    return found


# -- numbers --------------------------------------------------------------------------------------


def _masses(scenario: Scenario) -> Iterator[ScenarioQuantity]:
    vehicle = scenario.vehicle
    yield ScenarioQuantity("mass", vehicle.mass, "kg", "body and arms")
    for axis, moment in zip("xyz", vehicle.inertia().diagonal(), strict=True):
        about = "about the body's centre, arms at their free length"
        yield ScenarioQuantity(f"inertia about {axis}", float(moment), "kg m^2", about)
    yield ScenarioQuantity(
        "inertia share", inertia_share(vehicle), "", "largest moment of the main body over its "
        f"mass and the square of the distance to the farthest {vehicle.guard_word} or hull",
    )  # fmt: skip
    if vehicle.body.measured is not None:  # as read from a file
        for axis, place in zip("xyz", vehicle.body.measured.centre, strict=True):
            yield ScenarioQuantity(
                f"centre of mass along {axis}", place, "m", "in the model, from the origin of its "
                "first link; places of arms and hulls are from the centre of mass",
            )  # fmt: skip
    propulsion = vehicle.propulsion
    if vehicle.rotors:
        yield from _of_listed_rotors(vehicle)
    if propulsion is None or not vehicle.lift > 0.0:
        return
    yield ScenarioQuantity(
        "hover thrust share", hover_share(scenario), "", "of the rotors' maximum"
    )
    if None not in (propulsion.figure_of_merit, propulsion.disk_radius, propulsion.battery_energy):
        yield ScenarioQuantity("hover time", hover_time(vehicle), "s", "with the full battery")


def _of_listed_rotors(vehicle: Vehicle) -> Iterator[ScenarioQuantity]:
    lifting = sum(one.lifts for one in vehicle.rotors)
    yield ScenarioQuantity(
        "rotors that lift", float(lifting), "", f"of {vehicle.rotor_count}: their axes are within "
        "60 deg of body z; pilots of springback's use no others",
    )  # fmt: skip
    if not lifting:
        return
    yield ScenarioQuantity(
        "lift per thrust", vehicle.lift / lifting, "", "of a rotor that lifts: how upright it is"
    )
    found, about = hover_balance(vehicle), "at equal thrusts of those that lift"
    yield ScenarioQuantity("hover side force", found.sideways, "", f"share of the weight, {about}")
    yield ScenarioQuantity(
        "hover lever", max(found.tilting, found.turning), "m", f"of the weight, {about}: 0 if they "
        "turn the vehicle about no axis",
    )  # fmt: skip


def inertia_share(vehicle: Vehicle) -> float:
    """Largest moment of inertia of the main body over its mass times its reach squared."""
    largest = np.linalg.eigvalsh(np.array(vehicle.body.inertia))[-1]
    return float(largest / (vehicle.body.mass * vehicle.reach() ** 2))


def hover_share(scenario: Scenario) -> float:
    """Share of the rotors' maximum thrust that carries the true weight.

    0 without propulsion, infinite without rotors that lift.
    """
    vehicle = scenario.vehicle
    if vehicle.propulsion is None:
        return 0.0
    if not vehicle.lift > 0.0:
        return math.inf
    weight = scenario.true_vehicle().mass * scenario.world.gravity
    return float(weight / (vehicle.lift * vehicle.propulsion.max_thrust))


def _alike(arms: Arms) -> list[list[int]]:
    """Indices of compliant arms, those with the same numbers together."""
    groups: dict[tuple[float, ...], list[int]] = {}
    for j in range(len(arms.directions)):
        if arms.at("compliant", j):
            names = ("mass", "stiffness", "damping", "stroke")
            key = tuple(float(f"{arms.at(name, j):.12g}") for name in names)
            groups.setdefault(key, []).append(j)
    return list(groups.values())


def _of_arms(vehicle: Vehicle, group: list[int]) -> Iterator[ScenarioQuantity]:
    arms, j = vehicle.arms, group[0]
    of = (
        "" if len(group) == vehicle.arm_count else f" of arm {', '.join(str(k + 1) for k in group)}"
    )
    m, k, b = (arms.at(name, j) for name in ("mass", "stiffness", "damping"))
    left = "" if arms.neighbours is None else "; springs to neighbouring arms are left out"
    free = f"of one arm on its spring, the body held: not of the vehicle at an obstacle{left}"
    yield ScenarioQuantity(f"natural frequency{of}", math.sqrt(k / m) / math.tau, "Hz", free)
    yield ScenarioQuantity(f"damping ratio{of}", b / (2.0 * math.sqrt(k * m)), "", free)
    if (load := opening_load(arms, j)) > 0.0:
        kind, unit = ("torque", "N m") if arms.hinges[0] else ("force", "N")
        about = "of preload and latch: below it the arm does not move"
        yield ScenarioQuantity(f"opening {kind}{of}", load, unit, about)
    if arms.end_stops and arms.is_planar:
        about = f"estimate: the body on this one spring, its cage held by the wall ahead{left}"
        yield ScenarioQuantity(
            f"speed that uses up the stroke{of}", stop_speed(vehicle, j), "m/s", about
        )


def stop_speed(vehicle: Vehicle, arm: int) -> float:
    """Estimated speed at which an arm that is straight ahead reaches its stop [m/s].

    The wall holds the cage, and the rest of the vehicle runs on against the spring and damper of
    this arm alone: x″ + 2 ζ ω x′ + ω² x = 0, x(0) = 0, x′(0) = v.  Its largest x is proportional
    to v: v/ω times exp(−ζ arccos ζ/√(1 − ζ²)), and the same with hyperbolic functions for ζ > 1.
    Flights with full contact, bisected over the speed, agree to 7 %.

    Args:
        vehicle: With a compliant arm.
        arm: Index of the arm.
    """
    arms = vehicle.arms
    rest = vehicle.mass - arms.at("mass", arm)
    omega = math.sqrt(arms.at("stiffness", arm) / rest)
    zeta = arms.at("damping", arm) / (2.0 * omega * rest)
    if abs(zeta - 1.0) < 1e-6:
        decay = 1.0
    elif zeta < 1.0:
        decay = zeta * math.acos(zeta) / math.sqrt(1.0 - zeta**2)
    else:
        decay = zeta * math.acosh(zeta) / math.sqrt(zeta**2 - 1.0)
    return float(arms.at("stroke", arm) * omega * math.exp(decay))


def _gaps(vehicle: Vehicle) -> Iterator[ScenarioQuantity]:
    """Smallest gap between two cages or guards: arms free, and pressed in together."""
    arms, guards = vehicle.arms, f"{vehicle.guard_word}s"
    pairs = [(i, j) for j in range(len(arms.directions)) for i in range(j)]
    if not pairs:
        return
    free = min(_gap(arms, i, j, 0.0) for i, j in pairs)
    yield ScenarioQuantity(
        f"gap between {guards}", free, "m", "the smallest, arms at their free length"
    )
    if not arms.is_planar and arms.cages:
        about = "the smallest within their travel, one way or the other; less than 0: they meet"
        yield ScenarioQuantity("gap between cages that move", _smallest_gap(arms), "m", about)
        return
    soft = [pair for pair in pairs if all(arms.at("compliant", k) for k in pair)]
    touching = [share for i, j in soft if (share := _touching_share(arms, i, j)) is not None]
    if touching:
        about = "share of it, two neighbouring arms pressed in together"
        yield ScenarioQuantity(f"stroke until {guards} touch", min(touching), "", about)


def _gap(arms: Arms, i: int, j: int, pressed: float) -> float:
    """Gap between two cages [m], both arms pressed in by a share of their stroke."""
    ends = []
    for k in (i, j):
        stroke = arms.at("stroke", k) if arms.at("compliant", k) else 0.0
        ends.append(np.array(arms.place(k, pressed * stroke)))
    room = float(arms.at("cage_radius", i) + arms.at("cage_radius", j))
    return float(level_gap(ends[0] - ends[1], room, LEVEL))


def _smallest_gap(arms: Arms) -> float:
    """Smallest gap between two cages [m], each arm anywhere in the travel of its first joint.

    Cages that tilt as their arms fold are taken as balls.
    """
    places, steps, tilts = [], [], []
    for k in range(len(arms.directions)):
        ways = np.linspace(*arms.travel(k), PLACES) if arms.at("compliant", k) else np.zeros(1)
        places.append(np.array([arms.place(k, float(way)) for way in ways]))
        steps.append(float(np.abs(np.diff(places[-1][:, 2])).max(initial=0.0)))
        tilts.append(cage_tilts(arms, k) and len(ways) > 1)
    found = math.inf
    for i, j in combinations(range(len(places)), 2):
        room = float(arms.at("cage_radius", i) + arms.at("cage_radius", j))
        apart = places[i][:, None] - places[j][None]
        gaps = level_gap(apart, room, max(LEVEL, steps[i], steps[j]))
        if tilts[i] or tilts[j]:
            gaps = np.linalg.norm(apart, axis=2) - room
        found = min(found, float(gaps.min()))
    return found


def _touching_share(arms: Arms, i: int, j: int) -> float | None:
    """Share of the stroke at which two cages touch, both arms pressed in; None if they do not."""
    if _gap(arms, i, j, 1.0) >= 0.0:
        return None
    low, high = 0.0, 1.0
    for _ in range(40):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _gap(arms, i, j, middle) >= 0.0 else (low, middle)
    return high


# -- warnings -------------------------------------------------------------------------------------


def _vehicle_warnings(scenario: Scenario) -> Iterator[str]:
    """Sentences on numbers that can be flown and are seldom meant."""
    vehicle, share = scenario.vehicle, hover_share(scenario)
    if not vehicle.lift > 0.0:
        yield "no rotor blows within 60 deg of body z (vehicle.rotors): the vehicle cannot hover"
    elif share > 1.0:
        yield f"hover takes {100.0 * share:.3g} % of the maximum thrust: the vehicle cannot hover"
    elif share > MOST_HOVER:
        yield f"hover takes {100.0 * share:.3g} % of the maximum thrust: little is left to steer"
    if vehicle.rotors and vehicle.lift > 0.0:
        aside = hover_balance(vehicle).sideways
        if aside > MOST_ASIDE:
            yield (
                f"rotors push sideways with {100.0 * aside:.3g} % of the weight in hover: to stay "
                f"it must lean by {degrees(math.atan(aside)):.3g} deg, and pilots of springback's "
                "hold it level, off its place"
            )
    if not vehicle.arms.is_planar and vehicle.arms.cages and vehicle.is_compliant:
        gap = _smallest_gap(vehicle.arms)
        if gap < 0.0:
            yield (
                f"arms can fold until their cages are {-1e3 * gap:.3g} mm in each other, and parts "
                "of one vehicle do not touch here: a shorter travel (vehicle.arms.joint.travel) "
                "keeps them apart"
            )
    limits = vehicle.limits
    for k, component in enumerate(() if limits is None else limits.components):
        if (far := math.hypot(*component.position)) > FAR * vehicle.reach():
            yield (
                f"vehicle.limits.components[{k}] is {far:.3g} m from the middle of a vehicle that "
                f"reaches {vehicle.reach():.3g} m: is its position in the unit that it says?"
            )
    least, most = INERTIA_SHARES
    if not least <= (found := inertia_share(vehicle)) <= most:
        yield (
            f"the largest moment of inertia is {found:.3g} times the mass and the square of the "
            f"distance to the farthest {vehicle.guard_word} or hull, {vehicle.reach():.3g} m; "
            f"most robots have "
            f"{least:g} to {most:g}: are mass, inertia and size in the units that they say?"
        )
    yield from _passing_warnings(scenario)
    yield from _approach_warnings(scenario)


def _passing_warnings(scenario: Scenario) -> Iterator[str]:
    """A sentence on the thinnest obstacles that fit between the main hull and a cage.

    Only spheres about the main body and cages are looked at: further hulls may close the gap.
    """
    vehicle = scenario.vehicle
    if vehicle.hulls or vehicle.hull is None or not vehicle.arms.cages:
        return
    arms, hull = vehicle.arms, vehicle.hull
    ends = [math.dist(arms.place(j, 0.0), hull.offset) for j in range(vehicle.arm_count)]
    gaps = [far - hull.radius - arms.at("cage_radius", j) for j, far in enumerate(ends)]
    gap = max(gaps)
    thin = sorted(one for one in _thicknesses(scenario.world.obstacles) if one[0] < gap)
    if not thin:
        return
    named = [f"{name} ({thickness:.3g} m thick)" for thickness, name in thin[:MOST_NAMED]]
    if len(thin) > MOST_NAMED:
        named.append(f"{len(thin) - MOST_NAMED} more")
    passed = ", ".join(str(j + 1) for j, one in enumerate(gaps) if thin[0][0] < one)
    yield (
        f"{' and '.join(named)} can pass between the hull and the cage of arm {passed}, "
        f"{gap:.3g} m apart along the arm: of an arm nothing but its cage touches; give its rod "
        "as a capsule of vehicle.hulls"
    )


def _thicknesses(entries: Sequence[Any]) -> Iterator[tuple[float, str]]:
    """Least thickness of each obstacle with rods, balls or boards [m], and its name."""
    for name, one in named_obstacles(entries):
        parts = one.shapes if isinstance(one, ShapeUnion) else (one,)
        rods = [part for part in parts if isinstance(part, Ball | Box | Capsule | Hoop | Pole)]
        if rods:
            yield 2.0 * min(part.middle_depth() for part in rods), name


def _approach_warnings(scenario: Scenario) -> Iterator[str]:
    """Sentences on what is met first, straight on."""
    vehicle, reference = scenario.vehicle, scenario.reference
    if (approach := approach_ahead(scenario)) is None:
        return
    if isinstance(reference, RunUpSettings):
        off = approach.place.x - reference.wall_distance
        if abs(off) > WALL_OFFSET:
            yield (
                f"reference.wall_distance is {reference.wall_distance:g} m, and "
                f"{approach.words}, is met first, {abs(off):.3g} m "
                f"{'behind' if off > 0.0 else 'before'} that: the run-up's speed "
                "and pitch are those planned at wall_distance"
            )
    if not vehicle.arms.is_planar or not vehicle.arms.at("compliant", approach.arm):
        return
    if not _meets_an_arm(scenario, approach):
        return
    if approach.along < LEAST_ALONG:
        yield (
            f"arm {approach.arm + 1} meets {approach.words}, at {degrees(approach.angle):.3g} deg, "
            f"and with its friction {100.0 * max(approach.along, 0.0):.2g} % of the force presses "
            "the arm: it hardly slides; yaw it to have one cage straight ahead"
        )
    elif vehicle.arms.end_stops and approach.speed > (most := stop_speed(vehicle, approach.arm)):
        yield (
            f"at {approach.speed:.3g} m/s into {approach.words}, the stroke of arm "
            f"{approach.arm + 1} is used up, by an estimate from {most:.3g} m/s on; v²/(2 s) is "
            f"{least_deceleration(scenario, approach):.4g} m/s²"
        )

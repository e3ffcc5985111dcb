"""Warnings about what can be flown but is hardly intended."""

from __future__ import annotations

import math
import shlex
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from pathlib import Path
from typing import Any

import numpy as np

from springback.contact.parameters import PLANES, Ground, SurfaceSettings
from springback.contact.worlds import laws_by_key, surfaces_of
from springback.control.demands import Demands, Limits, shortfalls
from springback.control.linear import warnings_for
from springback.control.reference_parameters import CircleSettings, RunUpSettings
from springback.control.runup import reach
from springback.errors import InputError
from springback.scenario.avionics import NominalVehicle, limits_of, nominal_vehicle, propulsion_of
from springback.scenario.model import contact_point_of
from springback.scenario.scenario import Scenario
from springback.scenario.tables import ScenarioTables
from springback.scenario.vehicles.hover_balance import balance_warnings
from springback.scenario.vehicles.hover_rest import hover_warnings
from springback.scenario.vehicles.overlap import overlap_warnings
from springback.scenario.vehicles.range_check import size_warnings
from springback.scenario.vehicles.slides import slide_warnings
from springback.scenario.vehicles.spring_tables import spring_table_warnings
from springback.scenario.worlds.imported import Imported, named_obstacles, single_obstacles
from springback.scenario.worlds.mesh_check import mesh_warnings
from springback.vehicle.force_laws import HullSurface
from springback.vehicle.parameters import Vehicle

#: Distance from start.position to reference.start that is worth a warning [m] (chosen: more than
#: five standard deviations of the trials' positions).
APART = 0.2
#: Yaw at the start of a run-up that is worth a warning [rad] (chosen: likewise).
TURNED = 0.2
#: Time in which a recovery settles after the touch [s] (measured: the paper's and ours).
SETTLES = 1.5
#: Damping ratio of a contact that is worth a warning (chosen: that of materials is below 1).
MOST_DAMPED = 3.0
#: Share of the strongest moment below which there is none.
NO_MOMENT = 1e-6
#: Obstacles with plane faces only.
FLAT = (*PLANES, "box", "edge", "slope", "stairs", "net", "own")
#: Tables that only the pilot of the paper reads.
_PAPERS = ("reference", "control", "estimator", "recovery")


def scenario_warnings(
    scenario: Scenario, *, own: bool = False, given: Set[str] | None = None
) -> list[str]:
    """Warnings for this scenario, one sentence each.

    Args:
        scenario: Scenario to be flown.
        own: True if a pilot of the user's own flies it.
        given: Tables that the user wrote; None: those that the scenario was made of, but none where
            it was made of all, as it is saved.
    """
    if given is None:
        saved = scenario.model_fields_set >= type(scenario).model_fields.keys()
        given = frozenset() if saved else scenario.model_fields_set
    found = _unrepresented(scenario) + _curved(scenario)
    found += mesh_warnings(scenario.world.obstacles) + _overdamped(scenario)
    found += _unused_exponents(scenario)
    found += _nothing_beside(scenario) + _of_vehicle(scenario, own)
    found += _warnings_of_the_pilot(scenario, own, given)
    if scenario.second is not None:
        other = scenario.beside()
        written = scenario.second.model_fields_set
        piloted = _warnings_of_the_pilot(other, other.pilot is not None, written)
        found += [f"second: {sentence}" for sentence in _of_vehicle(other, False) + piloted]
    return found


def _of_vehicle(scenario: ScenarioTables, own: bool) -> list[str]:
    """Guards in each other, sizes, springs and slides seldom meant, what hover bends and turns."""
    vehicle = scenario.vehicle
    sizes = size_warnings(vehicle, scenario.simulation.impact_step)
    piloted = own or scenario.pilot is not None or scenario.reference is not None
    hovers = piloted or scenario.thrust != 0.0
    rests = hover_warnings(vehicle, scenario.world.gravity) if hovers else []
    alone = scenario.thrust == "hover" and not piloted and scenario.model.slider is None
    turns = balance_warnings(vehicle, scenario.world.gravity) if alone else []
    joints = slide_warnings(vehicle) + spring_table_warnings(vehicle)
    return overlap_warnings(vehicle) + sizes + joints + rests + turns


def _curved(scenario: ScenarioTables) -> list[str]:
    """The paper's contact point on shapes that are not plane."""
    if scenario.model.contact_point != "paper":
        return []
    for name, one in named_obstacles(scenario.world.obstacles):
        if one.type not in FLAT:
            return [
                "model.contact_point: the paper's contact point is made for planes; its work is "
                f"not exact on {name}"
            ]
    return []


def _overdamped(scenario: ScenarioTables) -> list[str]:
    """A viscous damper of a contact that is far stronger than its spring."""
    mass, known = scenario.vehicle.mass, dict[str, tuple[float, float]]()
    for k, entry in enumerate(scenario.world.obstacles):
        for one in single_obstacles([entry]):
            for law in () if one.type == "own" else surfaces_of(one):
                if law.exponent_value() == 1.0:
                    known.setdefault(f"world.obstacles[{k}]", (law.stiffness, law.viscosity))
    for k, hull in enumerate(scenario.vehicle.hulls):
        if hull.surface is not None and hull.surface.stiffness is not None:
            known[f"vehicle.hulls[{k}]"] = hull.surface.stiffness, hull.surface.viscosity
    for path, (stiffness, viscosity) in known.items():
        ratio = viscosity / (2.0 * math.sqrt(stiffness * mass))
        if ratio > MOST_DAMPED:
            return [
                f"{path}.surface: a viscosity of {viscosity:g} N s/m is {ratio:.3g} times what is "
                f"critical for its stiffness and the vehicle's mass: the force jumps at the touch, "
                f"by some {viscosity / mass:.3g} m/s² for each m/s; do not use peak accelerations "
                f"and forces of this contact, or give it a viscosity of at most "
                f"{2.0 * MOST_DAMPED * math.sqrt(stiffness * mass):.3g} N s/m"
            ]
    return []


def _laws(scenario: Scenario) -> Iterator[tuple[str, SurfaceSettings | HullSurface]]:
    """Surfaces of obstacles, of hulls and of the contact of two vehicles, each with its path."""
    for k, entry in enumerate(scenario.world.obstacles):
        for one in single_obstacles([entry]):
            laws = [("surface", one.surface)] if one.type == "own" else laws_by_key(one)
            yield from ((f"world.obstacles[{k}].{key}", law) for key, law in laws)
    vehicles = {"vehicle": scenario.vehicle}
    if scenario.second is not None:
        vehicles["second.vehicle"] = scenario.second.vehicle
        if scenario.second.surface is not None:
            yield "second.surface", scenario.second.surface
    for path, vehicle in vehicles.items():
        for k, hull in enumerate(vehicle.hulls):
            if hull.surface is not None:
                yield f"{path}.hulls[{k}].surface", hull.surface


def _unused_exponents(scenario: Scenario) -> list[str]:
    """The first exponent of a law that has none, but 1 and that which it has by default."""
    for path, law in _laws(scenario):
        readers = "hertz and hunt-crossley do"
        unread = isinstance(law, SurfaceSettings) and "exponent" in law.unread()
        if isinstance(law, HullSurface):
            readers, unread = "power does", law.law in ("foam", "table")
        if unread and law.exponent not in (1.0, type(law).model_fields["exponent"].default):
            return [
                f"{path}.exponent is not used: law {law.law} has none, and {law.exponent:g} "
                f"changes nothing; leave it out, or give a law that reads it ({readers})"
            ]
    return []


def _nothing_beside(scenario: ScenarioTables) -> list[str]:
    """Suction by walls where nothing is upright."""
    propulsion, world = scenario.vehicle.propulsion, scenario.world
    effects = () if propulsion is None else propulsion.effect()
    if not any(effect.suction > 0.0 for effect in effects) or scenario.second is not None:
        return []
    if not all(isinstance(entry, Ground) for entry in world.obstacles):
        return []
    there = "no obstacle but level ground" if world.obstacles else "no obstacles"
    return [
        "vehicle.propulsion.surface_effect.wall_suction: there is no wall that could draw a rotor, "
        f"as the scenario has {there}"
    ]


def _unrepresented(scenario: ScenarioTables) -> list[str]:
    """Elements of imported worlds that are not there."""
    return [
        _missing(k, entry.file, entry.unrepresented, len(entry.elements))
        for k, entry in enumerate(scenario.world.obstacles)
        if isinstance(entry, Imported) and entry.unrepresented
    ]


def missing_elements(scenarios: Iterable[Mapping[str, Any]]) -> list[str]:
    """Warnings about elements of imported worlds that are not there, one sentence each.

    Args:
        scenarios: Scenarios as tables, with the content of their worlds, as they are saved.
    """
    lines = [
        _missing(k, entry["file"], entry["unrepresented"], len(entry["elements"]))
        for tables in scenarios
        for k, entry in enumerate(tables["world"]["obstacles"])
        if entry["type"] == "import" and entry.get("unrepresented")
    ]
    return list(dict.fromkeys(lines))


def _missing(number: int, file: str, missing: Sequence[str], others: int) -> str:
    """Warning about the elements of one world that are not there, beside others that are."""
    count, more = len(missing), ", ..." if len(missing) > 1 else ""
    return (
        f"world.obstacles[{number}]: {count} of {count + others} elements of {Path(file).name} "
        f"cannot be represented and are not there: {missing[0]}{more}; all are listed by: "
        f"springback world show {shlex.quote(file)}"
    )


def _warnings_of_the_pilot(scenario: ScenarioTables, own: bool, given: Set[str]) -> list[str]:
    """Warnings about who flies; ``given`` are the tables that were written."""
    if own:
        recovery = scenario.recovery
        judges = recovery is not None and recovery.model_fields_set == {"settling"}
        unread = [name for name in _PAPERS if name in given and not (judges and name == "recovery")]
        return _unread(unread, "a pilot of your own flies, which does not read it")
    if scenario.reference is None or scenario.vehicle.propulsion is None:
        devices = () if "sensors" in given else ("clock", "seed")  # sensors need no pilot
        unread = [name for name in (*_PAPERS[1:], *devices) if name in given]
        return _unread(unread, "no pilot flies without a [reference]")
    lag = scenario.vehicle.propulsion.time_constant
    gains = warnings_for(scenario.control, scenario.vehicle.mass, lag)
    start = _two_starts(scenario) + _turned_away(scenario) + _arrives_late(scenario)
    more = _circle_shortfalls(scenario) + _unfelt_jumps(scenario) + _unsteered(scenario.vehicle)
    return gains + start + more


def _unsteered(vehicle: Vehicle) -> list[str]:
    """Rotors at the ends of arms that cannot turn the vehicle about each axis by itself."""
    arms = () if vehicle.rotors else vehicle.airframe().arms
    ends = [vehicle.arms.end(j) for j in range(len(arms))]
    turning = [arm.torque_ratio for arm in arms]
    if not any(turning):
        return []
    rows = np.array([[1.0] * len(arms), [e.y for e in ends], [-e.x for e in ends], turning])
    most = np.abs(rows).max(axis=1, keepdims=True)
    rows /= np.where(most > 0.0, most, 1.0)
    if np.linalg.matrix_rank(rows, tol=NO_MOMENT) == len(rows):
        return []
    if np.linalg.matrix_rank(rows[:3], tol=NO_MOMENT) < 3:
        return [
            f"rotors at the ends of arms cannot give lift, roll and pitch independently (arms: "
            f"{len(arms)}): the vehicle falls over; give it three or more that are not in line"
        ]
    return [
        f"the {len(arms)} rotors cannot give lift, roll, pitch and yaw independently: "
        "yaw is not controlled, and their torques make the vehicle spin; give it more "
        "rotors, or rotors other than upright ones at the ends of arms (vehicle.rotors)"
    ]


def _unread(names: list[str], why: str) -> list[str]:
    return [f"{name} is not used: {why}" for name in names]


def _two_starts(scenario: ScenarioTables) -> list[str]:
    """A run-up that begins far from the vehicle."""
    run_up, start = scenario.reference, scenario.start
    apart = math.dist(run_up.start, start.position) if isinstance(run_up, RunUpSettings) else 0.0
    if apart <= APART:
        return []
    return [
        f"reference.start is {apart:.3g} m from start.position: the vehicle flies there first, "
        "while the run-up begins; without reference.start it begins at start.position"
    ]


def _turned_away(scenario: ScenarioTables) -> list[str]:
    """A yaw at the start that the run-up does not keep."""
    run_up, yaw = scenario.reference, scenario.start.angles()[2]
    if not isinstance(run_up, RunUpSettings):
        return []
    if abs(math.remainder(yaw - run_up.yaw, math.tau)) <= TURNED:
        return []
    held = math.degrees(run_up.yaw)
    return [
        f"start.yaw is {math.degrees(yaw):.3g} deg, and the run-up turns the vehicle to {held:.3g} "
        "deg on its way: set reference.yaw to the same angle to meet the wall at it"
    ]


def _arrives_late(scenario: ScenarioTables) -> list[str]:
    """A run-up that the flight's end cuts short, or the recovery after it."""
    run_up, end = scenario.reference, scenario.simulation.duration
    if not isinstance(run_up, RunUpSettings):
        return []
    believed, limits = _believed(scenario)
    point = contact_point_of(scenario.model)
    ahead = reach(believed.airframe, point, run_up.pitch, run_up.yaw)
    try:
        arrives = run_up.run_up(limits, lambda pitch: ahead, False).contact_time
    except InputError:  # said where it is built
        return []
    when = f"the run-up reaches the wall at {arrives:.3g} s and the flight ends at {end:.3g} s"
    if arrives >= end:
        return [f"simulation.duration: {when}, so that nothing is hit"]
    if scenario.recovery is not None and end - arrives < SETTLES:
        return [
            f"simulation.duration: {when}; a recovery settles in some {SETTLES:g} s, and counts as "
            "not settled before"
        ]
    return []


def _unfelt_jumps(scenario: ScenarioTables) -> list[str]:
    """Surfaces of the impulse law before a recovery whose trigger reads the arms."""
    if scenario.recovery is None:
        return []
    for k, entry in enumerate(scenario.world.obstacles):
        for one in single_obstacles([entry]):
            if any(surface.law == "impulse" for surface in surfaces_of(one)):
                called = f", {entry.name}" if entry.name else ""
                return [
                    f"world.obstacles[{k}]{called}: its impulse law changes velocities at once and "
                    "moves no arm, so that sensors of arms see nothing: a recovery begins late or "
                    "never"
                ]
    return []


def _believed(scenario: ScenarioTables) -> tuple[NominalVehicle, Limits]:
    """The pilot's model of the vehicle, and its limits."""
    believed = nominal_vehicle(scenario.vehicle, propulsion_of(scenario), scenario.world.gravity)
    return believed, limits_of(believed, scenario.control.rate_limit)


def _circle_shortfalls(scenario: ScenarioTables) -> list[str]:
    """Demands of a circle at full speed beyond the limits.

    The thrust tilts inwards by atan(R ω²/g) and turns about the vertical with ω.
    """
    circle = scenario.reference
    if not isinstance(circle, CircleSettings):
        return []
    _, limits = _believed(scenario)
    rate = 2.0 * math.pi / circle.period
    inwards = circle.radius * rate**2
    thrust, tilt = math.hypot(inwards, limits.gravity), math.atan2(inwards, limits.gravity)
    asked = Demands(limits.mass * thrust, limits.mass * thrust, tilt, rate * math.sin(tilt))
    return shortfalls(asked, limits, "the circle")

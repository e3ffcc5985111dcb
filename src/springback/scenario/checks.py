"""Checks across the tables of a scenario: each raises the problem, with the key at fault."""

from __future__ import annotations

import contextlib
import itertools
import math
from collections.abc import Iterable, Iterator
from typing import Any

from pydantic_core import PydanticCustomError

from springback.contact.cage import LANDED, moving_bodies
from springback.contact.hull_contact import BodySight, arm_gap, arm_sight, body_sight, hull_gap
from springback.contact.library import WALL
from springback.contact.moving.hulls import with_hulls
from springback.contact.moving.scene import MovingScene, scene_with
from springback.contact.obstacles import Plane, signed_distance
from springback.contact.parameters import SurfaceSettings, faces
from springback.contact.scene.faces import SolidScene
from springback.contact.scene.nearest import distance_of
from springback.contact.shapes import Box, ShapeSettings
from springback.contact.surfaces import AnyExponent
from springback.contact.worlds import Own, obstacles
from springback.errors import shown_value
from springback.kernels.memo import Build, plain_build
from springback.kernels.routines import routines_compiled
from springback.kernels.tracing import sqrt, traceable  # for batch set-up
from springback.kernels.vectors import Vec, norm
from springback.scenario.avionics import devices_of
from springback.scenario.fields import check_magnitudes
from springback.scenario.model import (
    RING_ROUNDING,
    check_parts_at_start,
    settle_step,
    true_body,
    unit,
)
from springback.scenario.tables import (
    ScenarioTables,
    SimulationSettings,
    ThrustSettings,
    UserShape,
)
from springback.scenario.vehicles.slides import check_slides
from springback.scenario.vehicles.thrusts import thrusts_of
from springback.scenario.worlds.free_starts import check_free_starts
from springback.scenario.worlds.imported import (
    check_imported,
    named_obstacles,
    single_obstacles,
)
from springback.scenario.worlds.mesh_check import check_meshes, size_words
from springback.sensing.parameters import SensorSettings
from springback.settings import problem
from springback.simulation.measuring.record import Model
from springback.simulation.pair.parts import carried_bodies
from springback.simulation.pair.solids import solids_of
from springback.vehicle.force_laws import HullSurface
from springback.vehicle.hulls import HullSettings
from springback.vehicle.parameters import Vehicle
from springback.vehicle.state import Airframe, Arm, State

#: Classical Runge–Kutta is stable up to 2.78 on the real axis; steps stay below this.
STABLE = 2.5
#: Maximum number of steps, if all were as fine as the finest (chosen): about 2 min of a processor.
MOST_STEPS = 1e8
#: Maximum number of ticks of a flight with a pilot (chosen): its noise takes 1 GB.  Trajectories
#: have a separate limit, `springback.simulation.trajectory.MOST_INSTANTS`.
MOST_TICKS = 5e6
#: Upper bound on the distance of a point from the main body, relative to the reach (chosen: the
#: rounding of a ring adds 1e-5).
AMPLE = 1.01


def check_tables(scenario: ScenarioTables, build: Build = plain_build) -> None:
    """Reject what no pilot can fly; `check_start` is the last of these checks."""
    s = scenario
    check_imported(s.world.obstacles)
    check_magnitudes(s)
    check_reference(s)
    check_hulls(s)
    check_joints(s)
    check_meshes(s.world.obstacles)
    thrust = build(thrusts_of, s.vehicle, s.world.gravity, s.thrust, s.reference is not None)
    check_slider(s)
    check_parts_at_start(s.start, s.vehicle)
    body = build(true_body, s.vehicle, s.model_error, s.payload, build)
    build(check_steps, s.simulation, s.vehicle)
    rows = s.thrust.values if isinstance(s.thrust, ThrustSettings) else (thrust,)
    check_drag(s, body.mass if body else s.vehicle.body.mass, max(map(sum, rows)))


def check_joints(scenario: ScenarioTables) -> None:
    """Reject slides through the vehicle, and what is defined for arms in the body plane alone."""
    check_slides(scenario.vehicle.arms)
    if not scenario.vehicle.arms.is_planar and scenario.model.contact_point == "paper":
        raise problem(
            "must be ring for arms on joints, or whose ends are raised: the paper's contact point "
            "is defined in the plane of the arms (got paper)",
            "model.contact_point",
        )


def check_hulls(scenario: ScenarioTables) -> None:
    """Reject springs of hulls and obstacles in series whose exponents differ."""
    for k, hull in enumerate(scenario.vehicle.hulls):
        numbered = [
            (number, one)
            for number, entry in enumerate(scenario.world.obstacles)
            for one in single_obstacles([entry])
        ]
        for (number, entry), name in itertools.product(numbered, ("surface", "backing")):
            law = getattr(entry, name, None)
            if not isinstance(law, SurfaceSettings):
                continue
            if law.law == "impulse" or hull.surface is None:
                continue
            _check_springs(
                hull.surface, law, f"vehicle.hulls[{k}].surface",
                f"world.obstacles[{number}].{name}",
            )  # fmt: skip


def _check_springs(hull: HullSurface, law: SurfaceSettings, field: str, there: str) -> None:
    """Reject a spring of a hull that cannot be in series with that of a surface.

    Args:
        hull: Surface of the hull.
        law: The other surface.
        field: Path of the former.
        there: Path of the latter.
    """
    if hull.is_alone:
        return
    if law.law in ("foam", "table"):
        raise problem(
            f"cannot be in series with {there}, whose law is {law.law}: give it in_series = false, "
            "or leave it out",
            field,
        )
    n, theirs = hull.exponent, law.exponent_value()
    if n != theirs:
        raise problem(
            f"must be {theirs:g}, that of {there}: springs in series have the same exponent "
            f"(got {n:g}); or give the hull's surface in_series = false",
            f"{field}.exponent",
        )


def check_reference(scenario: ScenarioTables) -> None:
    """Reject settings that conflict with a reference."""
    if scenario.reference is None:
        return
    if scenario.thrust not in (0.0, "hover"):
        raise problem(
            "cannot be combined with a reference, whose pilot commands it "
            f"(got {_words(scenario.thrust)})",
            "thrust",
        )
    if scenario.world.gravity == 0.0:
        raise problem(
            "must be more than 0 m/s^2 with a reference, whose pilot steers by tilting its lift "
            "(got 0 m/s^2)",
            "world.gravity",
        )
    if scenario.model.slider is not None:
        raise problem(
            "cannot be combined with a reference: no pilot flies on a slider", "model.slider"
        )
    if scenario.start.touch_distance is not None:
        raise problem(
            "cannot be combined with a reference, which begins at start.position",
            "start.touch_distance",
        )


def _words(thrust: Any) -> str:
    return "a table" if isinstance(thrust, ThrustSettings) else str(thrust)


def check_without_pilot(scenario: ScenarioTables) -> None:
    """Reject settings that require a pilot, where neither scenario nor caller has one."""
    check_sensors(scenario)
    if scenario.reference is None and scenario.air.gusts is not None:
        raise problem(
            "blow only where a pilot flies: give a [reference], or a pilot of your own",
            "air.gusts",
        )
    propulsion = scenario.vehicle.propulsion
    if propulsion is not None and propulsion.stop is not None and scenario.thrust != 0.0:
        raise problem(
            "acts only where a pilot flies: give a [reference], or a pilot of your own; or false "
            "for rotors that keep turning, or thrust = 0",
            "vehicle.propulsion.stop",
        )


def check_sensors(scenario: ScenarioTables) -> None:
    """Reject sensors that do not fit the clock; they need no pilot."""
    s = scenario
    if s.sensors != SensorSettings():
        check_clock(s)
        with blaming_the_clock(s):
            devices_of(s.sensors, s.estimator, 1.0 / s.clock, s.vehicle)


def check_clock(scenario: ScenarioTables) -> None:
    """Reject more ticks than can be stored; the duration is at fault if no clock was given."""
    duration, clock = scenario.simulation.duration, scenario.clock
    if clock * duration <= MOST_TICKS:
        return
    if "clock" not in scenario.model_fields_set:
        raise problem(
            f"must be at most {MOST_TICKS / clock:.6g} s with a pilot and a clock of {clock:g} 1/s "
            f"(got {duration:g} s)",
            "simulation.duration",
        )
    raise problem(
        f"must be at most {MOST_TICKS / duration:.6g} 1/s for a flight of {duration:g} s "
        f"(got {clock:g} 1/s)",
        "clock",
    )


@contextlib.contextmanager
def blaming_the_clock(scenario: ScenarioTables) -> Iterator[None]:
    """Attribute problems of rates to the clock, if the clock was given and the rate was not."""
    try:
        yield
    except PydanticCustomError as error:
        field, given = str((error.context or {}).get("field", "")), scenario.model_fields_set
        innocent = "clock" in given and field.partition(".")[0] not in given
        if innocent and "clock" in error.message():
            raise problem(f"does not suit {field}, which {error.message()}", "clock") from None
        raise


def check_slider(scenario: ScenarioTables) -> None:
    """Reject a start that a slider does not allow."""
    axis = scenario.model.slider
    if axis is None:
        return
    if not math.hypot(*axis) > 0.0:
        raise problem(f"must not be zero (got {shown_value(list(axis))})", "model.slider")
    along, velocity = unit(Vec(*axis)), Vec(*scenario.start.velocity)
    across = velocity - (velocity @ along) * along
    if sqrt(across @ across) > 1e-9:
        raise problem("must lie along model.slider", "start.velocity")
    if any(scenario.start.angular_velocity):
        raise problem("must be zero on a slider", "start.angular_velocity")


def check_steps(simulation: SimulationSettings, vehicle: Vehicle) -> None:
    """Reject too many steps, and steps too long for the arms."""
    shortest = simulation.duration / MOST_STEPS
    for name in ("impact_step", "settle_step", "free_step"):
        step = getattr(simulation, name)
        if step is None or step >= shortest:
            continue
        if name not in simulation.model_fields_set:
            raise problem(
                f"must be at most {MOST_STEPS * step:.3g} s with {name} of {step:g} s "
                f"(got {simulation.duration:g} s)",
                "simulation.duration",
            )
        raise problem(
            f"must be at least {shortest:.3g} s for a flight of {simulation.duration:g} s "
            f"(got {step:g} s)",
            f"simulation.{name}",
        )
    rate = vehicle.fastest_arm_rate()
    settling = settle_step(simulation, vehicle)
    steps = {"impact_step": simulation.impact_step, "settle_step": settling}
    for name, step in steps.items():
        if step * rate > STABLE:
            raise problem(
                f"must be at most {STABLE / rate:.3g} s for arms this stiff, damped and light "
                f"(got {step:g} s)",
                f"simulation.{name}",
            )


def check_drag(scenario: ScenarioTables, mass: float, thrust: float) -> None:
    """Reject steps too long for the drag of a main body of some mass [kg] and thrust [N]."""
    if not scenario.air.has_drag:
        return
    start, wind = Vec(*scenario.start.velocity), Vec(*scenario.air.wind)
    through = start - wind
    rate = scenario.air.drag_rate(mass, thrust, sqrt(through @ through))
    step = scenario.simulation.free_step
    if step * rate > STABLE:
        raise problem(
            f"must be at most {STABLE / rate:.3g} s for this much drag (got {step:g} s)",
            "simulation.free_step",
        )


def check_start(scenario: ScenarioTables, model: Model, state: State) -> None:
    """Reject a start inside an obstacle, and that of one which moves freely."""
    whole = model.world.obstacles
    if isinstance(whole, MovingScene):
        check_free_starts(whole)
    if is_clear(model, state) or (
        isinstance(whole, SolidScene | MovingScene)
        and min(_gaps_of(whole, model, state)) >= -LANDED
    ):
        return  # else look for the one
    for name, one in _one_by_one(scenario, model, state):
        _refuse_inside(name, one, scenario, model, state)


def check_start_beside(
    scenario: ScenarioTables, model: Model, state: State, own: Iterable[tuple[str, Own]]
) -> None:
    """Reject a start inside one of the user's own obstacles, each with its name."""
    hulled = bool(scenario.vehicle.hulls)
    for name, one in own:
        alone = obstacles((), (one,), as_scene=hulled)
        what = f"{name.removesuffix('.shape')}, a {type(one[0]).__name__}"
        whole = with_hulls(alone, RING_ROUNDING) if hulled else alone
        _refuse_inside(what, whole, scenario, model, state)


def _refuse_inside(
    name: str, one: Any, scenario: ScenarioTables, model: Model, state: State
) -> None:
    """Reject a start inside some obstacles, with their name."""
    guard = scenario.vehicle.guard_word
    parts = [f"{guard} of arm {j}" for j in range(1, len(model.airframe.arms) + 1)] + ["main body"]
    for part, gap in zip(parts, _gaps_of(one, model, state), strict=False):
        if gap < -LANDED:
            raise problem(
                f"puts the {part} {-gap:.3g} m inside {name} "
                f"(got {list(scenario.start.position)} m)",
                "start.position",
            )


def _one_by_one(scenario: ScenarioTables, model: Model, state: State) -> Iterator[tuple[str, Any]]:
    """Every built-in obstacle that may be in reach, and what it is, as in `World.obstacles`."""
    known = [(name, one) for name, one in _named(scenario) if not isinstance(one, UserShape)]
    if isinstance(model.world.obstacles, SolidScene | MovingScene):
        reach, hulled = reach_of(model.airframe), bool(scenario.vehicle.hulls)
        for name, one in known:
            if not _is_far(one, state.position, reach):
                alone = obstacles((one,), as_scene=hulled)
                yield name, with_hulls(alone, RING_ROUNDING) if hulled else alone
        return
    names = [name for name, one in known if not isinstance(one, ShapeSettings) for _ in faces(one)]
    yield from zip(names, ((one,) for one in model.world.obstacles), strict=False)


def _named(scenario: ScenarioTables) -> Iterator[tuple[str, Any]]:
    """Obstacles one by one, each in words: its place in the scenario, its name and type."""
    for name, one in named_obstacles(scenario.world.obstacles):
        yield f"{name}{size_words(one)}", one


def _is_far(one: Any, place: Vec, reach: float) -> bool:
    """True if an obstacle of one box at rest is farther than the reach of a vehicle [m]."""
    if not isinstance(one, Box) or one.motion is not None:
        return False
    radius = 0.5 * math.hypot(*one.size) + reach
    return bool(math.dist(one.position, (place.x, place.y, place.z)) > radius)


def _gaps_of(obstacles: Any, model: Model, state: State) -> tuple[float, ...]:
    """Gaps of cages and hull to some obstacles at the start [m]."""
    starts = tuple(body.start for body in moving_bodies(obstacles))
    with routines_compiled():
        around = body_sight(obstacles, state._replace(bodies=starts), 0.0)
        return _gaps(around, model.airframe, state.arm_length, model.contact_point)


@traceable
def _gaps(
    around: BodySight, airframe: Airframe, lengths: tuple[float, ...], contact_point: Any
) -> tuple[float, ...]:
    """Gaps of cages and hull to obstacles [m], at given lengths of the arms [m]."""
    posed = zip(airframe.arms, lengths, strict=True)
    seen = [(arm, arm_sight(arm, length, 0.0, around)) for arm, length in posed]
    cages = [arm_gap(arm, sight.obstacles, contact_point, sight.pose) for arm, sight in seen]
    return (*cages, *(hull_gap(hull, around.obstacles) for hull in airframe.hull))


@traceable
def reach_of(airframe: Airframe) -> float:
    """Upper bound on the distance of a point from the main body [m], arms uncompressed."""
    found: list[float] = [norm(hull.centre) + hull.radius for hull in airframe.hull]
    for arm in airframe.arms:
        end = arm.length if isinstance(arm, Arm) else norm(arm.joint.end)
        found += [end + arm.cage_radius, *(end + norm(h.centre) + h.radius for h in arm.hull)]
    return AMPLE * max(found)


# -- a second vehicle -----------------------------------------------------------------------------


def check_second(first: ScenarioTables, second: ScenarioTables) -> None:
    """Reject what two vehicles in one world cannot do, and a start in each other.

    Args:
        first: Scenario of both.
        second: That of the second vehicle alone.
    """
    for k, entry in enumerate(first.world.obstacles):
        for single in single_obstacles([entry]):
            _check_beside(f"world.obstacles[{k}]", single)
    for path, one in (("", first), ("second.", second)):
        for k, hull in enumerate(one.vehicle.hulls):
            if path and hull.type == "points":
                raise problem(
                    "must not be points on a second vehicle, whose hulls are met as solids: use "
                    "spheres, capsules, boxes or rings",
                    f"{path}vehicle.hulls[{k}].type",
                )
            _check_in_series(first, hull, f"{path}vehicle.hulls[{k}].surface")
        if isinstance(one.thrust, ThrustSettings):
            raise problem("must be constant beside another vehicle, not a table", f"{path}thrust")
        if one.vehicle.limits is not None and one.vehicle.limits.broken_stiffness is not None:
            what = "cannot be combined with a second vehicle: guards keep all of it there"
            raise problem(what, f"{path}vehicle.limits.broken_stiffness")
    ours = [hull.surface is not None and hull.surface.is_alone for hull in first.vehicle.hulls]
    for k, hull in enumerate(second.vehicle.hulls):
        if any(ours) and hull.surface is not None and hull.surface.is_alone:
            raise problem(
                "must be in series with others: a hull of the first vehicle meets everything by "
                f"its own law, too, and which of both yields is not known (got law "
                f"{hull.surface.law})",
                f"second.vehicle.hulls[{k}].surface",
            )
    assert first.second is not None
    law = first.second.surface
    if law is not None and law.law == "impulse":
        raise problem("must not be impulse between two vehicles", "second.surface.law")
    if law is not None and law.friction_law == "bristle":
        raise problem("must not be bristle between two vehicles", "second.surface.friction_law")


def _check_in_series(first: ScenarioTables, hull: HullSettings, field: str) -> None:
    """Reject springs of a hull and of the contact between two vehicles that cannot be in series."""
    assert first.second is not None
    law = WALL if first.second.surface is None else first.second.surface
    if hull.surface is not None:
        _check_springs(hull.surface, law, field, "second.surface")


def check_apart(
    first: ScenarioTables, model: Model, at: State, second: Vehicle, there: State
) -> None:
    """Reject a second vehicle whose parts start inside the first one, as that one meets them.

    Args:
        first: Scenario of the first vehicle.
        model: Its flight.
        at: Its state at time 0.
        second: The second vehicle.
        there: Its state at time 0.
    """
    nothing, surface = obstacles((), as_scene=True), WALL.surface(AnyExponent, in_scene=True)
    assert isinstance(nothing, SolidScene)
    still = with_hulls(nothing, RING_ROUNDING) if first.vehicle.hulls else nothing
    solids = solids_of(second)
    scene = scene_with(still, carried_bodies(second.airframe(), solids, there, surface))
    deep = -min(_gaps_of(scene, model, at))
    if deep > LANDED:
        place = [round(x, 6) for x in there.position]
        raise problem(
            f"puts a part of it {deep:.3g} m inside the first vehicle (got {place} m)",
            "second.start.position",
        )


def _check_beside(path: str, entry: Any) -> None:
    """Reject an obstacle that cannot be met by two vehicles."""
    if isinstance(entry, UserShape) or getattr(entry, "motion", None) is not None:
        what = "is a shape of your own" if isinstance(entry, UserShape) else "moves"
        raise problem(f"cannot be combined with a second vehicle: it {what}", path)
    if isinstance(entry, ShapeSettings):
        laws = [(".surface", part.surface) for part in entry.parts()]
    else:
        laws = [(f".{n}", getattr(entry, n)) for n in ("surface", "backing") if hasattr(entry, n)]
    for name, law in laws:
        if law.law == "impulse":
            raise problem("must not be impulse beside a second vehicle", f"{path}{name}.law")


def is_clear(model: Model, state: State) -> bool:
    """True if all planes, or all solids of a scene, are out of reach at any attitude."""
    reach = reach_of(model.airframe)
    if isinstance(model.world.obstacles, MovingScene):
        return False
    if isinstance(model.world.obstacles, SolidScene):
        return distance_of(model.world.obstacles, state.position) >= reach
    for obstacle in model.world.obstacles:
        shape = obstacle.shape
        if not isinstance(shape, Plane) or signed_distance(shape, state.position) < reach:
            return False
    return True

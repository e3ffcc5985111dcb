"""Model of a flight: a scenario's tables, converted to the numbers of the equations of motion."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use
from pydantic_core import PydanticCustomError

from springback.contact.cage import ArmTip, Ring, moving_bodies
from springback.contact.moving.hulls import with_hulls
from springback.contact.moving.scene import MovingScene
from springback.contact.obstacles import (
    Forces,
    Impulses,
    Plane,
    SecondContact,
    World,
)
from springback.contact.scene.faces import SolidScene
from springback.contact.worlds import Own, obstacles
from springback.dynamics.clearance import clearance
from springback.dynamics.motion import Free, Slider
from springback.dynamics.moving_obstacles import flown_scene
from springback.dynamics.solution import SliderFriction
from springback.kernels.memo import Build, plain_build
from springback.kernels.routines import routines_compiled
from springback.kernels.tracing import sqrt, traceable  # for batch set-up
from springback.kernels.trees import leaves
from springback.kernels.vectors import Mat3, Vec, rotation
from springback.scenario.tables import (
    ModelError,
    ModelSettings,
    Payload,
    ScenarioTables,
    SimulationSettings,
    Start,
    UserShape,
    WorldSettings,
)
from springback.scenario.vehicles.thrusts import thrust_table, thrusts_of
from springback.scenario.worlds.imported import single_obstacles
from springback.settings import naming, problem
from springback.simulation.flight import memory_at_start, with_spin
from springback.simulation.measuring.record import Model, Timing
from springback.vehicle.arms.at_start import bends_at_start, check_compression
from springback.vehicle.hulls import HullSettings
from springback.vehicle.mass.bounds import check_inertia
from springback.vehicle.parameters import Vehicle
from springback.vehicle.state import Airframe, BodyState, Shell, State, build_airframe

#: Tilt within which a cage that lies flat on a surface is assumed to touch at its centre [rad].
RING_ROUNDING = 5e-3

#: Obstacles farther than this are not met by a start at touch [m] (chosen).
FARTHEST = 1e4
#: A motion that closes in on a plane by less than this share of its way is parallel to it (chosen).
PARALLEL = 1e-9
#: Sine of the angle between a spin and the axis of its ring, at most (chosen: four decimals).
ALONG = 1e-3
#: Search for the touch of a shape: factor by which distances may be wrong
#: (`springback.scenario.user.obstacles`), shortest step [m] and largest number of them (chosen).
INEXACT, SHORTEST_LOOK, MOST_LOOKS = 1.05, 1e-6, 20_000

Matrix = np.ndarray[Any, np.dtype[np.float64]]
Moments = tuple[tuple[float, ...], ...]


# -- the true vehicle -----------------------------------------------------------------------------


class Masses(NamedTuple):
    """Nominal mass and inertia of a vehicle."""

    body: float  # [kg]
    arms: float  # all together [kg]
    whole: float  # [kg]
    body_inertia: Moments  # about its centre of mass, body axes [kg m²]
    whole_inertia: Moments  # about the main body's, arms at their free length [kg m²]


class TrueBody(NamedTuple):
    """The true main body."""

    mass: float  # [kg]
    inertia: Moments  # about its centre of mass, body axes [kg m²]


@traceable
def masses_of(vehicle: Vehicle) -> Masses:
    """Nominal masses and inertias."""
    arms = sum(vehicle.arms.at("mass", j) for j in range(vehicle.arm_count))
    body = vehicle.body
    whole = tuple(map(tuple, vehicle.inertia().tolist()))
    return Masses(body.mass, arms, vehicle.mass, body.inertia, whole)


def check_payload(vehicle: Vehicle, load: Payload) -> None:
    """Reject moments that no payload of its mass has on a vehicle of that size.

    Raises:
        The problem of its inertia, with the allowed range; a point mass has none, and is possible.
    """
    a, b, c = load.inertia
    if a == 0.0 and b == 0.0 and c == 0.0:
        return
    if not load.mass > 0.0:
        raise problem(
            f"must be 0 kg m^2 each of a payload without mass (got {[a, b, c]} kg m^2)",
            "payload.inertia",
        )
    with naming("payload"):
        rows = ((a, 0.0, 0.0), (0.0, b, 0.0), (0.0, 0.0, c))
        check_inertia(load.mass, rows, vehicle.reach())


def thrust_problem(
    scenario: ScenarioTables, mass: float, bound: str, side: str
) -> PydanticCustomError:
    """Problem of rotors that cannot hold the true weight; a payload is at fault if it is too heavy.

    Args:
        scenario: Of a vehicle with rotors that lift.
        mass: The true one, with payload [kg].
        bound: ``max_thrust`` or ``min_thrust``.
        side: Of the share of the weight on which that bound must be: more or less.
    """
    s, propulsion = scenario, scenario.vehicle.propulsion
    given = getattr(propulsion, bound)
    most = given * s.vehicle.lift / s.world.gravity - (mass - s.payload.mass)
    if bound == "max_thrust" and 0.0 < most <= s.payload.mass:
        return problem(
            f"must be less than {most:.4g} kg, what the rotors hold besides the vehicle at their "
            f"max_thrust, {given:g} N each (got {s.payload.mass:g} kg)",
            "payload.mass",
        )
    share = mass * s.world.gravity / s.vehicle.lift
    return problem(
        f"must be {side} than {share:.4g} N, each rotor's share of the true weight, payload and "
        f"model_error included (got {given:g} N)",
        f"vehicle.propulsion.{bound}",
    )


def true_body(
    vehicle: Vehicle, error: ModelError, load: Payload, build: Build = plain_build
) -> TrueBody | None:
    """True main body, with model errors and payload; None if it is the nominal one.

    Raises:
        The problem of an error that leaves nothing to the main body besides the arms, or of a
        payload that cannot be.
    """
    if error.mass == 1.0 and error.inertia == 1.0 and load == Payload():
        return None
    check_payload(vehicle, load)
    believed = build(masses_of, vehicle)
    mass = believed.body + (error.mass - 1.0) * believed.whole
    inertia = np.array(believed.body_inertia)
    inertia = inertia + (error.inertia - 1.0) * np.array(believed.whole_inertia)
    if not mass > 0.0:
        raise problem(
            f"must be more than {1.0 - believed.body / believed.whole:.3g}, the share of "
            f"the arms (got {error.mass:g})",
            "model_error.mass",
        )
    if not _is_positive(inertia):
        raise problem(
            f"must leave the main body an inertia besides the arms' (got {error.inertia:g})",
            "model_error.inertia",
        )
    rows = (inertia + np.diag(load.inertia)).tolist()
    return TrueBody(mass + load.mass, tuple(tuple(row) for row in rows))


def _is_positive(matrix: Matrix) -> bool:
    """True if a symmetric matrix is positive definite; a dominant diagonal decides at once."""
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = matrix.tolist()
    xy, xz, yz = abs(xy), abs(xz), abs(yz)
    if xx > xy + xz and yy > xy + yz and zz > xz + yz:
        return True
    return bool(np.linalg.eigvalsh(matrix)[0] > 0.0)


def true_vehicle(vehicle: Vehicle, error: ModelError, load: Payload) -> Vehicle:
    """The true vehicle, as parameters."""
    body = true_body(vehicle, error, load)
    if body is None:
        return vehicle
    return vehicle.with_checked(body=vehicle.body.with_checked(**body._asdict()))


def true_airframe(
    vehicle: Vehicle, error: ModelError, load: Payload, build: Build = plain_build
) -> Airframe:
    """Airframe of the true vehicle, for the equations of motion."""
    airframe = build(Vehicle.airframe, vehicle)
    body = build(true_body, vehicle, error, load, build)
    if body is None:
        return airframe
    inertia = Mat3(*(Vec(*row) for row in body.inertia))
    mass = body.mass + build(masses_of, vehicle).arms
    a = airframe
    return build_airframe(mass, inertia, a.arms, a.hull, a.neighbours, a.rotors)


# -- the rest -------------------------------------------------------------------------------------


def world_numbers(
    world: WorldSettings, own: Sequence[Own] = (), *, hulls: Sequence[HullSettings] = ()
) -> World:
    """Obstacles and gravity.

    Args:
        world: The settings.
        own: The user's own shapes, those that the world names, too.
        hulls: Of the vehicle, which need a scene (`Vehicle.hulls`).
    """
    entries = [(k, one) for k, one in enumerate(world.obstacles) if not isinstance(one, UserShape)]
    known = [(k, one) for k, entry in entries for one in single_obstacles([entry])]
    given, numbers = [one for _, one in known], [k for k, _ in known]
    remember = any(hull.remembers for hull in hulls)
    built = obstacles(given, own, as_scene=bool(hulls), numbers=numbers, hull_memory=remember)
    if hulls:
        built = with_hulls(built, RING_ROUNDING)
    if isinstance(built, MovingScene):
        return World(flown_scene(built), Forces(0.0), world.gravity)
    impulsive = isinstance(built, SolidScene) or any(
        one.surface.restitution >= 0.0 for one in built
    )
    return World(built, Impulses(0.0) if impulsive else Forces(0.0), world.gravity)


def settle_step(simulation: SimulationSettings, vehicle: Vehicle) -> float:
    """Step while the arms settle [s]."""
    s = simulation
    if s.settle_step is not None:
        return s.settle_step
    rate = vehicle.fastest_arm_rate()
    if rate == 0.0:
        return s.free_step
    return max(s.impact_step, min(8.0 * s.impact_step, 1.0 / rate))


def timing_of(simulation: SimulationSettings, model: ModelSettings, vehicle: Vehicle) -> Timing:
    """Duration and step sizes."""
    s = simulation
    return Timing(
        until=s.duration,
        free_step=s.free_step,
        impact_step=s.impact_step,
        settle_step=settle_step(s, vehicle),
        arm_tolerance=s.arm_tolerance,
        rate_tolerance=s.rate_tolerance,
        dwell=s.dwell,
        hybrid=1.0 if model.arms == "hybrid" and not vehicle.has_shell else 0.0,
    )


def unit(v: Vec) -> Vec:
    """Unit vector along a vector."""
    one: Vec = v * (1.0 / sqrt(v @ v))
    return one


def guide_of(model: ModelSettings) -> Free | Slider:
    """Constraint of the vehicle."""
    if model.slider is None:
        return Free(0.0)
    axis = unit(Vec(*model.slider))
    if not model.slider_friction > 0.0:
        return Slider(axis)
    return Slider(axis, (SliderFriction(axis, model.slider_friction, model.slider_slip_speed),))


def contact_point_of(model: ModelSettings) -> Ring | ArmTip:
    """Contact point model of a cage."""
    return Ring(RING_ROUNDING) if model.contact_point == "ring" else ArmTip(0.0)


def flight_model(
    scenario: ScenarioTables, own: Sequence[Own] = (), build: Build = plain_build
) -> Model:
    """Model of a flight; ``own`` are the user's own shapes, with their surfaces."""
    s = scenario
    airframe = true_airframe(s.vehicle, s.model_error, s.payload, build)
    world = world_numbers(s.world, own, hulls=s.vehicle.hulls)
    thrust = build(thrusts_of, s.vehicle, s.world.gravity, s.thrust, s.reference is not None)
    point, guide = contact_point_of(s.model), guide_of(s.model)
    timing = timing_of(s.simulation, s.model, s.vehicle)
    table = thrust_table(s.thrust)
    ramp = () if table is None else (table.stretches()[0].ramp,)
    stops = s.vehicle.propulsion is not None and s.vehicle.propulsion.stop is not None
    reaction: tuple[Any, ...] = () if not stops else (0.0,)
    if stops and airframe.rotors:
        reaction = ((0.0,) * len(thrust),)
    return Model(
        airframe, world, point, guide, s.air.air(), thrust, timing, ramp, reaction=reaction,
        limits=build(Vehicle.load_limits, s.vehicle),
        surface_effect=() if s.vehicle.propulsion is None else s.vehicle.propulsion.effect(),
    )  # fmt: skip


# -- the start ------------------------------------------------------------------------------------


def start_state(start: Start, vehicle: Vehicle, model: Model, build: Build = plain_build) -> State:
    """State at time 0, arms at their free length.

    Args:
        start: The table.
        vehicle: Vehicle with these arms.
        model: Model of the flight; a `Start.touch_distance` is taken from its obstacles.
        build: Builder of the parts.

    Raises:
        The problem, if there is a touch distance and the straight motion meets no obstacle.
    """
    state: State = build(_state_at_place, start, vehicle)
    memory = memory_at_start(model)
    for hull in model.airframe.hull if vehicle.has_shell else ():
        memory = with_spin(memory, build(_shell_spin, start, hull))
    state = state._replace(bodies=bodies_at_start(model.world), memory=memory)
    if start.touch_distance is None:
        return state
    moved = build(way_to_touch, model, state) - start.touch_distance
    direction = unit(state.velocity)
    return state._replace(position=state.position + moved * direction)


def bodies_at_start(world: World) -> tuple[BodyState, ...]:
    """States of the moving obstacles at time 0; mostly there are none."""
    return tuple(body.start for body in moving_bodies(world.obstacles))


def _shell_spin(start: Start, hull: Shell) -> Vec:
    """`Start.shell_spin` in world axes; of a ring what it has about its axis [rad/s].

    Raises:
        The problem, if a ring is to turn about another axis.
    """
    given = Vec(*start.shell_spin)
    for axis in hull.axis:
        across = given ^ axis
        if across @ across > ALONG * ALONG * (given @ given):
            raise problem(
                f"must be along the ring's axis, {_text(axis)}, about which alone it turns by "
                f"itself (got {_text(given)} rad/s)",
                "start.shell_spin",
            )
    return rotation(start.attitude()) @ given


def check_parts_at_start(start: Start, vehicle: Vehicle) -> None:
    """Reject arms out of their travel, and a spin of what does not turn by itself."""
    check_compression(vehicle.arms, start.compression, start.second_compression)
    if not vehicle.has_shell and any(part != 0.0 for part in start.shell_spin):
        raise problem(
            "needs a hull that turns by itself: a sphere with a gimbal, or a ring with a bearing",
            "start.shell_spin",
        )


def _state_at_place(start: Start, vehicle: Vehicle) -> State:
    """State at `Start.place`."""
    s, lengths = start, vehicle.lengths(start.compression)
    velocity, spin, rates = Vec(*s.velocity), Vec(*s.angular_velocity), (0.0,) * len(lengths)
    place, attitude = s.place(), s.attitude()
    bends = bends_at_start(vehicle.arms, s.second_compression)
    return State(place, attitude, velocity, spin, lengths, rates, bends=bends)


@traceable
def way_to_touch(model: Model, state: State) -> float:
    """Distance along the velocity to the first touch, straight on and without turning [m].

    Negative for a state inside an obstacle: the way back out of it.

    Raises:
        The problem, if there is no touch within `FARTHEST`.
    """
    math.fsum(leaves((model, state)))  # no formula of traced numbers, which this refuses
    if not state.velocity @ state.velocity > 0.0:
        raise problem("must not be zero: start.touch_distance is along it", "start.velocity")
    direction = unit(state.velocity)
    with routines_compiled():
        ways = [_way_to(model, one, state, direction) for one in _one_by_one(model.world)]
    way = min(ways, default=math.inf)
    if way == math.inf:
        raise problem(
            f"cannot be kept: straight on from start.position, {_text(state.position)} m, along "
            f"start.velocity, {_text(state.velocity)} m/s, the vehicle meets no obstacle",
            "start.touch_distance",
        )
    return way


def _text(v: Vec) -> str:
    return f"[{', '.join(f'{part:.4g}' for part in v)}]"


def _one_by_one(world: World) -> list[World]:
    """Worlds of one obstacle each: the same together; a scene is one."""
    if isinstance(world.obstacles, SolidScene | MovingScene):
        return [world]
    shapes = [one for one in world.obstacles if not isinstance(one.shape, SecondContact)]
    return [world._replace(obstacles=(one,)) for one in shapes]


def _way_to(model: Model, world: World, state: State, direction: Vec) -> float:
    """Distance along a direction to the touch of a world [m]; infinite without one."""

    def gap(way: float) -> float:
        there = state._replace(position=state.position + way * direction)
        return clearance(model.airframe, world, model.contact_point, there)

    here = gap(0.0)
    is_scene = isinstance(world.obstacles, SolidScene | MovingScene)
    shape = None if is_scene else world.obstacles[0].shape
    if isinstance(shape, Plane):
        closing = -(shape.normal @ direction)
        return here / closing if closing > PARALLEL else math.inf
    # A gap changes by no more than the way: steps as long as it is pass no obstacle by.
    sign, before, way, now = math.copysign(1.0, here), 0.0, 0.0, here
    for _ in range(MOST_LOOKS):
        if sign * now <= 0.0:
            low, high = sorted((before, way))
            return float(scipy.optimize.brentq(gap, low, high, xtol=1e-15)) if now else way
        before, way = way, way + sign * max(sign * now / INEXACT, SHORTEST_LOOK)
        if abs(way) > FARTHEST:
            break
        now = gap(way)
    return math.inf

"""Scenes in plain numbers, and the one place that turns them into the package's own types.

The oracles read a `Scene` and a `Start`; they never see a type of the package.  When the package's
NamedTuples change, this file is what has to follow.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from springback.contact.cage import ArmTip, Ring
from springback.contact.moving.scene import MovingScene
from springback.contact.obstacles import Forces, Impulses, Obstacle, Plane, World
from springback.contact.surfaces import Surface, ThreeHalves
from springback.contact.worlds import obstacles
from springback.dynamics.air import Still
from springback.dynamics.energy import Energy, energy
from springback.dynamics.motion import Free, Rates, Slider, rates
from springback.dynamics.moving_obstacles import flown_scene
from springback.kernels.vectors import Mat3, Quat, Vec
from springback.scenario.model import bodies_at_start
from springback.simulation.flight import FlightRecord, fly_one
from springback.simulation.measuring.record import Model, Timing
from springback.vehicle.state import Airframe, Arm, Sphere, State, build_airframe

Array = NDArray[np.float64]

#: Wall that nothing reaches [m].
FAR = 1e3


# -- plain numbers ---------------------------------------------------------------------------------


@dataclass(frozen=True)
class ArmSpec:
    """One arm in SI units."""

    azimuth: float  # of e_j from body x [rad]
    mass: float = 0.05
    stiffness: float = 5e3
    damping: float = 90.0
    length: float = 0.19
    shortest: float = 0.15
    stop_stiffness: float = 0.0
    stop_dissipation: float = 0.0
    slides: bool = True
    cage_radius: float = 0.11
    torque_ratio: float = 0.016  # with its sign


@dataclass(frozen=True)
class Ball:
    """A sphere that is fixed to the main body."""

    centre: Array  # body axes, shape (3,)
    radius: float  # [m]


@dataclass(frozen=True)
class Craft:
    """A main body and its arms."""

    body_mass: float
    inertia: Array  # of the main body alone, shape (3, 3)
    arms: tuple[ArmSpec, ...]
    hull: Ball | None = None

    @property
    def mass(self) -> float:
        """Everything [kg]."""
        return self.body_mass + sum(arm.mass for arm in self.arms)


@dataclass(frozen=True)
class Wall:
    """A plane with the Hunt-Crossley law, exponent 3/2, and Coulomb friction."""

    normal: Array  # out of the wall, shape (3,)
    offset: float  # normal · x on the face [m]
    stiffness: float = 1e5
    dissipation: float = 0.65
    friction: float = 0.8
    slip_speed: float = 0.1
    restitution: float = -1.0  # not negative: the impulse law


class Placed(NamedTuple):
    """Where a body is that moves, and how, at one instant; world axes."""

    position: Array  # of its own origin [m]
    turn: Array  # its axes to those at the beginning, shape (3, 3)
    velocity: Array  # of that origin [m/s]
    omega: Array  # [rad/s]


@dataclass(frozen=True)
class Solid:
    """A built-in shape with its surface, by its settings; perhaps it moves."""

    shape: Any
    motion: Callable[[float], Placed] | None = None
    """Where it has moved to from its place in the settings, by time [s]; None stays."""


@dataclass(frozen=True)
class Scene:
    """Everything but the state."""

    craft: Craft
    wall: Wall
    thrust: tuple[float, ...]
    contact: Literal["ring", "tip"] = "ring"
    rounding: float = 0.0
    friction_axes: Literal["both", "vertical"] = "both"
    gravity: float = 9.81
    solids: tuple[Solid, ...] = ()
    """Beside the wall; with any, the package's world is a scene without the wall."""


@dataclass(frozen=True)
class Start:
    """Where it is and how it moves."""

    position: Array  # world
    attitude: Array  # (w, x, y, z), body to world
    velocity: Array  # world
    omega: Array  # body
    lengths: Array
    rates: Array

    @property
    def rotation(self) -> Array:
        """Rotation matrix, body to world."""
        return np.asarray(Rotation.from_quat(self.attitude, scalar_first=True).as_matrix())


# -- the package's types ---------------------------------------------------------------------------


def vec(a: Any) -> Vec:
    """A `Vec` of three numbers."""
    return Vec(*(float(x) for x in a))


def airframe_of(craft: Craft) -> Airframe:
    """The package's constants of a craft."""
    arms = tuple(
        Arm(
            cosine=math.cos(arm.azimuth),
            sine=math.sin(arm.azimuth),
            mass=float(arm.mass),
            inverse_mass=1.0 / float(arm.mass) if arm.slides else 0.0,
            stiffness=float(arm.stiffness),
            damping=float(arm.damping),
            length=float(arm.length),
            shortest=float(arm.shortest),
            stop_stiffness=float(arm.stop_stiffness),
            stop_dissipation=float(arm.stop_dissipation),
            compliance=1.0 if arm.slides else 0.0,
            cage_radius=float(arm.cage_radius),
            torque_ratio=float(arm.torque_ratio),
        )
        for arm in craft.arms
    )
    inertia = Mat3(*(vec(row) for row in craft.inertia))
    hull = () if craft.hull is None else (Sphere(vec(craft.hull.centre), craft.hull.radius),)
    return build_airframe(float(craft.mass), inertia, arms, hull)


def craft_of(airframe: Airframe) -> Craft:
    """Plain numbers of the package's constants."""
    arms = tuple(
        ArmSpec(
            azimuth=math.atan2(arm.sine, arm.cosine), mass=arm.mass, stiffness=arm.stiffness,
            damping=arm.damping, length=arm.length, shortest=arm.shortest,
            stop_stiffness=arm.stop_stiffness, stop_dissipation=arm.stop_dissipation,
            slides=arm.compliance > 0.0, cage_radius=arm.cage_radius, torque_ratio=arm.torque_ratio,
        )
        for arm in airframe.arms
    )  # fmt: skip
    body_mass = airframe.mass - sum(arm.mass for arm in arms)
    hull = next((Ball(np.array(one.centre), one.radius) for one in airframe.hull), None)
    return Craft(body_mass, np.array(airframe.inertia), arms, hull)


def world_of(scene: Scene) -> World:
    """The package's world of a scene."""
    if scene.solids:
        settings = [solid.shape for solid in scene.solids]
        built = obstacles(settings)
        built = flown_scene(built) if isinstance(built, MovingScene) else built
        return World(built, Forces(0.0), scene.gravity)
    wall = scene.wall
    surface = Surface(
        stiffness=wall.stiffness,
        dissipation=wall.dissipation,
        viscosity=0.0,
        exponent=ThreeHalves(1.5),
        friction=wall.friction,
        vertical=1.0 if scene.friction_axes == "vertical" else 0.0,
        slip_speed=wall.slip_speed,
        restitution=wall.restitution,
    )
    obstacle = Obstacle(Plane(vec(wall.normal), float(wall.offset)), surface, 0.0)
    laws = Impulses(0.0) if wall.restitution >= 0.0 else Forces(0.0)
    return World((obstacle,), laws, scene.gravity)


def contact_point_of(scene: Scene) -> Ring | ArmTip:
    """The package's contact point model of a scene."""
    return Ring(scene.rounding) if scene.contact == "ring" else ArmTip(0.0)


def thrust_of(scene: Scene) -> tuple[float, ...]:
    """The package's thrusts."""
    return tuple(float(thrust) for thrust in scene.thrust)


def state_of(start: Start) -> State:
    """The package's state."""
    return State(
        position=vec(start.position),
        attitude=Quat(*(float(x) for x in start.attitude)),
        velocity=vec(start.velocity),
        angular_velocity=vec(start.omega),
        arm_length=tuple(float(x) for x in start.lengths),
        arm_rate=tuple(float(x) for x in start.rates),
    )


def start_of(state: State) -> Start:
    """Plain numbers of a state of the package."""
    return Start(
        position=np.array(state.position),
        attitude=np.array(state.attitude),
        velocity=np.array(state.velocity),
        omega=np.array(state.angular_velocity),
        lengths=np.array(state.arm_length),
        rates=np.array(state.arm_rate),
    )


def model_of(
    scene: Scene,
    *,
    until: float,
    impact_step: float = 1e-4,
    free_step: float | None = None,
    hybrid: bool = False,
) -> Model:
    """The package's model of a flight; without ``free_step`` all steps are ``impact_step``."""
    timing = Timing(
        until=until,
        free_step=impact_step if free_step is None else free_step,
        impact_step=impact_step,
        settle_step=impact_step,
        arm_tolerance=1e-5,
        rate_tolerance=1e-3,
        dwell=0.02,
        hybrid=1.0 if hybrid else 0.0,
    )
    return Model(
        airframe_of(scene.craft),
        world_of(scene),
        contact_point_of(scene),
        Free(0.0),
        Still(0.0),
        thrust_of(scene),
        timing,
    )


# -- what the package says -------------------------------------------------------------------------


class Accelerations(NamedTuple):
    """Second derivatives of all coordinates."""

    linear: Array  # v̇, world [m/s²]
    angular: Array  # ω̇, body [rad/s²]
    arms: Array  # l̈ [m/s²]


def rates_of(
    scene: Scene, start: Start, *, released: bool = True, slider: Array | None = None
) -> Rates:
    """The package's rate of change of everything, run by Python; on a slider along some axis."""
    guide = Free(0.0) if slider is None else Slider(vec(slider))
    return rates(
        model_of(scene, until=1.0)._replace(guide=guide), state_of(start), 1.0 if released else 0.0
    )


def accelerations_of(
    scene: Scene, start: Start, *, released: bool = True, slider: Array | None = None
) -> Accelerations:
    """The package's accelerations, run by Python; on a slider along some axis."""
    state = rates_of(scene, start, released=released, slider=slider).motion.state
    return Accelerations(
        np.array(state.velocity), np.array(state.angular_velocity), np.array(state.arm_rate)
    )


def energy_of(scene: Scene, start: Start) -> Energy:
    """The package's mechanical energy, run by Python."""
    return energy(
        airframe_of(scene.craft), world_of(scene), contact_point_of(scene), state_of(start)
    )


def fly(
    scene: Scene,
    start: Start,
    *,
    until: float,
    impact_step: float = 1e-4,
    free_step: float | None = None,
    hybrid: bool = False,
    trace: bool = False,
) -> FlightRecord:
    """A whole flight by the package's compiled executor."""
    model = model_of(
        scene, until=until, impact_step=impact_step, free_step=free_step, hybrid=hybrid
    )
    state = state_of(start)._replace(bodies=bodies_at_start(model.world))
    return fly_one(model, state, trace=trace)


# -- scenes ----------------------------------------------------------------------------------------


def quaternion(roll: float, pitch: float, yaw: float) -> Array:
    """(w, x, y, z) of ZYX Euler angles [rad]."""
    return np.asarray(
        Rotation.from_euler("ZYX", [yaw, pitch, roll]).as_quat(scalar_first=True), dtype=float
    )


def compliant_craft(**arm: Any) -> Craft:
    """The paper's compliant vehicle: four equal arms in X, spin signs alternating.

    Args:
        **arm: Fields of every `ArmSpec` to set.
    """
    quarter = math.pi / 4
    azimuths = (quarter, -quarter, -3 * quarter, 3 * quarter)
    signs = (-1.0, 1.0, -1.0, 1.0)
    arms = tuple(
        replace(ArmSpec(azimuth, torque_ratio=0.016 * sign), **arm)
        for azimuth, sign in zip(azimuths, signs, strict=True)
    )
    return Craft(1.882, np.diag([0.00639, 0.00799, 0.01248]), arms)


def random_inertia(rng: np.random.Generator) -> Array:
    """A full inertia tensor that some body can have: a cloud of point masses."""
    points = rng.normal(size=(6, 3)) * [0.05, 0.06, 0.03]
    masses = rng.uniform(0.1, 0.4, size=6)
    squares = (masses * (points**2).sum(axis=1)).sum()
    return np.asarray(squares * np.eye(3) - np.einsum("k,ki,kj->ij", masses, points, points))


def random_arm(rng: np.random.Generator, azimuth: float, *, stops: bool, slides: bool) -> ArmSpec:
    """An arm unlike the others; it bottoms out after some 10 mm, so that random states reach it."""
    length = rng.uniform(0.15, 0.25)
    return ArmSpec(
        azimuth=azimuth,
        mass=rng.uniform(0.02, 0.15),
        stiffness=rng.uniform(2e3, 2e4),
        damping=rng.uniform(20.0, 200.0),
        length=length,
        shortest=length - rng.uniform(0.005, 0.015),
        stop_stiffness=rng.uniform(1e4, 1e5) if stops else 0.0,
        stop_dissipation=rng.uniform(0.1, 1.0) if stops else 0.0,
        slides=slides,
        cage_radius=rng.uniform(0.07, 0.13),
        torque_ratio=rng.uniform(-0.03, 0.03),
    )


def random_craft(rng: np.random.Generator, *, stops: bool = False, slides: bool = True) -> Craft:
    """Four different arms in any directions of the body plane, and products of inertia."""
    turn = rng.uniform(-math.pi, math.pi)
    azimuths = turn + 0.5 * math.pi * np.arange(4) + rng.uniform(-0.6, 0.6, size=4)
    arms = tuple(random_arm(rng, float(a), stops=stops, slides=slides) for a in azimuths)
    return Craft(rng.uniform(0.8, 2.0), random_inertia(rng), arms)


def unit_vector(rng: np.random.Generator) -> Array:
    """A direction, all equally likely."""
    a = rng.normal(size=3)
    return np.asarray(a / np.linalg.norm(a))


def random_start(rng: np.random.Generator, craft: Craft, *, still_arms: bool = False) -> Start:
    """A vigorous state: 3 m/s, 10 rad/s, arms 20 mm off either way and moving; pitch within 70°."""
    free = np.array([arm.length for arm in craft.arms])
    count = len(free)
    roll, pitch, yaw = rng.uniform(-1, 1, size=3) * [math.pi, 1.2, math.pi]
    return Start(
        position=rng.uniform(-2.0, 2.0, size=3),
        attitude=quaternion(roll, pitch, yaw),
        velocity=rng.uniform(-3.0, 3.0, size=3),
        omega=rng.uniform(-10.0, 10.0, size=3),
        lengths=free + (0.0 if still_arms else rng.uniform(-0.02, 0.02, size=count)),
        rates=np.zeros(count) if still_arms else rng.uniform(-2.0, 2.0, size=count),
    )


def cage_reach(scene: Scene, start: Start) -> Array:
    """How far each cage reaches into the direction of the wall, along −normal [m], shape (arms,)."""
    inward, r = -scene.wall.normal, start.rotation
    reach = []
    for arm, length in zip(scene.craft.arms, start.lengths, strict=True):
        e = r @ np.array([math.cos(arm.azimuth), math.sin(arm.azimuth), 0.0])
        circle = math.sqrt(1.0 - (inward @ r[:, 2]) ** 2 + scene.rounding**2)
        own = circle if scene.contact == "ring" else inward @ e
        reach.append(inward @ (start.position + length * e) + arm.cage_radius * own)
    return np.array(reach)


def touching(scene: Scene, start: Start, count: int, depth: float) -> Scene:
    """The scene with its wall moved so that ``count`` cages touch, the last of them by ``depth`` [m]."""
    reach = np.sort(cage_reach(scene, start))[::-1]
    if count == 0:
        face = reach[0] + depth
    else:
        room = reach[count - 1] - reach[count] if count < len(reach) else math.inf
        face = reach[count - 1] - min(depth, 0.5 * room)
    return replace(scene, wall=replace(scene.wall, offset=float(-face)))


def with_hull(scene: Scene, start: Start, rng: np.random.Generator) -> Scene:
    """The scene with a hull about some point near the main body, 1 to 15 mm inside the wall."""
    centre = rng.uniform(-0.03, 0.03, size=3)
    away = scene.wall.normal @ (start.position + start.rotation @ centre) - scene.wall.offset
    hull = Ball(centre, max(float(away), 0.0) + rng.uniform(1e-3, 15e-3))
    return replace(scene, craft=replace(scene.craft, hull=hull))


def path(flown: FlightRecord, name: str) -> Array:
    """One trajectory: ``time``, ``position``, ``velocity``, ``attitude``, ``omega``, ``acceleration``
    or ``lengths``, with shape (instants,) or (instants, components)."""
    assert flown.trace is not None
    if name == "time":
        return np.asarray(flown.trace["time"])
    count = len(flown.start.arm_length)
    columns = {
        "position": [f"state.position.{c}" for c in "xyz"],
        "velocity": [f"state.velocity.{c}" for c in "xyz"],
        "attitude": [f"state.attitude.{c}" for c in "wxyz"],
        "omega": [f"state.angular_velocity.{c}" for c in "xyz"],
        "lengths": [f"state.arm_length.{j + 1}" for j in range(count)],
        "acceleration": [f"acceleration.{c}" for c in "xyz"],
    }
    return np.stack([flown.trace[column] for column in columns[name]], axis=-1)

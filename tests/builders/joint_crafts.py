"""Crafts whose arms are on joints, as plain numbers and as the package's own types.

The oracles read a `Craft` and a `Pose`; user input is made of them here, and what comes of it.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from oracles import models
from oracles.joint_lagrangian import (
    Between,
    Craft,
    Limb,
    Pose,
    about_z,
    random_limb,
    random_pose,
)
from springback.kernels.vectors import Mat3
from springback.results.flight import Flight, fly
from springback.simulation.measuring.record import Model
from springback.vehicle.arms.joints import JointedArm
from springback.vehicle.arms.neighbours import NeighbourSpring, NeighbourSprings
from springback.vehicle.parameters import Vehicle
from springback.vehicle.state import Airframe, State, build_airframe

#: Of joints, their vectors in the axes of an arm; without, both are drawn for each arm.
JOINTS: dict[str, tuple[Any, Any]] = {
    "oblique slides": ("slide", [-1.0, 0.4, 0.7]),
    "hinges about z": ("hinge", [0.0, 0.0, 1.0]),
    "hinges about a horizontal axis": ("hinge", [0.0, -1.0, 0.0]),
    "hinges about an odd axis": ("hinge", [0.3, -0.5, 0.8]),
    "any joints": (None, None),
    "latched joints": (None, None),
    "joints with springs between": (None, None),
}
NO_WALL = models.Scene(
    models.compliant_craft(), models.Wall(np.array([-1.0, 0.0, 0.0]), -models.FAR), ()
)
BODY = {"mass": 1.0, "inertia": [0.008, 0.009, 0.016]}


# -- the package's types ---------------------------------------------------------------------------


def settings_of(limb: Limb, **changes: Any) -> dict[str, Any]:
    """User input of one arm, its joint changed: vectors are in its own axes."""
    azimuth = math.atan2(limb.end[1], limb.end[0])
    own, hinged = about_z(azimuth).T, limb.kind == "hinge"
    travel = 2.0 if hinged else 0.1
    vectors = {"axis": own @ limb.axis, "position": own @ limb.point}
    chosen = vectors if hinged else {"direction": own @ limb.axis}
    latch = {"torque" if hinged else "force": limb.latch[0], "travel": limb.latch[1]}
    joint = {
        "type": limb.kind,
        **{key: value.tolist() for key, value in chosen.items()},
        "travel": [0.0 if limb.preload > 0.0 or limb.latch[0] > 0.0 else -travel, travel],
        "latch": latch if limb.latch[0] > 0.0 else None,
        "stiffness": limb.stiffness,
        "quadratic": limb.quadratic,
        "preload": limb.preload,
        "damping": limb.damping,
        "rotors": "arm" if limb.follows else "body",
        **changes,
    }
    return {
        "directions": [azimuth],
        "length": math.hypot(limb.end[0], limb.end[1]),
        "height": float(limb.end[2]),
        "mass": limb.mass,
        "cage_radius": limb.cage_radius,
        "torque_ratio": abs(limb.torque_ratio),
        "spin": [1 if limb.torque_ratio > 0.0 else -1],
        "joint": {key: value for key, value in joint.items() if value is not None},
    }


def arm_of(limb: Limb, **changes: Any) -> JointedArm:
    """The package's constants of an arm, from user input, its joint changed."""
    vehicle = {"name": "one", "body": BODY, "arms": settings_of(limb, **changes)}
    arm = Vehicle.model_validate(vehicle).airframe().arms[0]
    assert isinstance(arm, JointedArm)
    return arm


def airframe_of(craft: Craft) -> Airframe:
    """The package's constants of a craft; latched arms, too, move either way."""
    arms = []
    for limb in craft.limbs:
        arm = arm_of(limb)
        if limb.latch[0] > 0.0 and limb.preload == 0.0:
            arm = arm._replace(longest=2.0 * arm.length - arm.shortest)
        arms.append(arm)
    inertia, between = Mat3(*(models.vec(row) for row in craft.inertia)), craft.between
    springs: Any = ()
    if between is not None:
        k, b = between.stiffness, between.damping
        each = tuple(NeighbourSpring(k, b, distance) for distance in between.distances)
        springs = NeighbourSprings(each)
    return build_airframe(float(craft.mass), inertia, tuple(arms), (), springs)


def model_of(
    craft: Craft, scene: models.Scene | None = None, *, until: float = 1.0, step: float = 1e-4
) -> Model:
    """The package's model of a flight with arms that always move; without a scene, of no wall."""
    there = replace(scene or NO_WALL, gravity=craft.gravity)
    return models.model_of(there, until=until, impact_step=step)._replace(
        airframe=airframe_of(craft), thrust=tuple(limb.thrust for limb in craft.limbs)
    )


def state_of(craft: Craft, pose: Pose) -> State:
    """The package's state: an arm is as much shorter as the way that its end has gone."""
    radii = np.array([limb.radius for limb in craft.limbs])
    free = np.array([math.hypot(limb.end[0], limb.end[1]) for limb in craft.limbs])
    start = models.Start(
        pose.position, pose.attitude, pose.velocity, pose.omega,
        free - radii * pose.bends, -radii * pose.rates,
    )  # fmt: skip
    return models.state_of(start)


def pose_of(craft: Craft, state: State) -> Pose:
    """Plain numbers of a state of the package."""
    now = models.start_of(state)
    radii = np.array([limb.radius for limb in craft.limbs])
    free = np.array([math.hypot(limb.end[0], limb.end[1]) for limb in craft.limbs])
    bends, turning = (free - now.lengths) / radii, -now.rates / radii
    return Pose(now.position, now.attitude, now.velocity, now.omega, bends, turning)


# -- vehicles and states ---------------------------------------------------------------------------


def drawn(name: str, seed: int) -> tuple[Craft, Pose]:
    """Unequal arms, three or four, at a random state, rotors on."""
    rng = np.random.default_rng([31, list(JOINTS).index(name), seed])
    count = 3 + seed % 2
    limbs = []
    for j in range(count):
        kind, axis = JOINTS[name]
        kind = kind or str(rng.choice(["slide", "hinge"]))
        axis = rng.normal(size=3) if axis is None else axis
        azimuth = 2.0 * math.pi / count * j + rng.uniform(-0.5, 0.5)
        limbs.append(random_limb(rng, azimuth, kind, axis))
    craft = Craft(rng.uniform(0.8, 2.0), models.random_inertia(rng), tuple(limbs))
    if name == "latched joints":
        craft = replace(craft, limbs=tuple(latched(limb, rng) for limb in limbs))
    elif name == "joints with springs between":
        free = tuple(rng.uniform(0.15, 0.3) for _ in limbs)
        between = Between(rng.uniform(300.0, 3000.0), rng.uniform(1.0, 20.0), free)
        craft = replace(craft, between=between)
    return craft, random_pose(rng, craft)


def latched(limb: Limb, rng: np.random.Generator) -> Limb:
    """An arm that a latch holds, which random states open."""
    force, travel = (1.5, 0.1) if limb.kind == "hinge" else (40.0, 0.004)
    return replace(limb, latch=(force * rng.uniform(0.5, 1.5), travel * rng.uniform(0.5, 1.5)))


def at_wall(craft: Craft, pose: Pose, seed: int) -> models.Scene:
    """A wall of any orientation with friction, one or two cages some millimetres in it."""
    rng = np.random.default_rng([32, seed])
    into, r = models.unit_vector(rng), pose.rotation
    rounding = 0.2 * (seed % 2)
    reach = []
    for limb, c in zip(craft.limbs, pose.bends, strict=True):
        height = (r @ limb.turn(c)).T @ into
        circle = limb.cage_radius * math.hypot(height[0], height[1], rounding)
        reach.append(into @ (pose.position + r @ limb.place(c)) + circle)
    reach.sort()
    count = 1 + seed // 2 % 2
    room = reach[-count] - reach[-count - 1]
    face = reach[-count] - min(rng.uniform(1e-3, 10e-3), 0.5 * room)
    wall = models.Wall(-into, -face, stiffness=3e4)
    return models.Scene(models.compliant_craft(), wall, (), rounding=rounding)


def with_springs(limb: Limb, seed: int) -> JointedArm:
    """An arm with stops that random states reach, and with one of all sorts of springs."""
    size, force = (0.4, 5.0) if limb.kind == "hinge" else (0.02, 100.0)
    low = 0.0 if limb.preload > 0.0 or limb.latch[0] > 0.0 else -size
    points = [[0.0, 0.0], [0.2 * size, 0.1 * force], [0.7 * size, force]]
    sorts: list[dict[str, Any]] = [
        {},
        {"play": 0.2 * size},
        {"table": points, "stiffness": None, "quadratic": 0.0},
        {"table": points, "stiffness": None, "play": 0.1 * size},
        {"one_sided": True, "travel": [0.0, size]},
    ]
    return arm_of(limb, **{"travel": [low, size], **sorts[seed % len(sorts)]})


def vehicle(name: str, seed: int) -> tuple[Craft, Pose]:
    """As `drawn`, but of usual inertia, without preload, arms lightly bent and at rest."""
    craft, pose = drawn(name, seed)
    limbs = tuple(replace(limb, preload=0.0) for limb in craft.limbs)
    products = np.array([[0.0, 3e-4, -5e-4], [3e-4, 0.0, 4e-4], [-5e-4, 4e-4, 0.0]])
    craft = replace(craft, inertia=np.diag([0.0064, 0.008, 0.0125]) + products, limbs=limbs)
    still = replace(pose, bends=0.5 * pose.bends, rates=0.0 * pose.rates)
    return craft, replace(still, attitude=models.quaternion(0.2, -0.3, 0.5))


def impact(name: str, seed: int) -> tuple[Craft, Pose, models.Scene]:
    """A vehicle 10 µm from a tilted wall, which it meets at some 2 m/s."""
    return before_a_wall(*vehicle(name, seed))


def before_a_wall(craft: Craft, start: Pose) -> tuple[Craft, Pose, models.Scene]:
    """A vehicle 10 µm from a tilted wall, which it meets at some 2 m/s.

    Args:
        craft: With arms of one joint or of two.
        start: Its attitude and position count.
    """
    into = np.array([0.9, 0.3, 0.2]) / math.sqrt(0.94)
    start = replace(start, velocity=2.0 * into + [0.1, 0.5, -0.4], omega=np.array([1.5, -3.0, 4.0]))
    start = replace(start, bends=0.0 * start.bends)
    reach = []
    for limb in craft.limbs:
        flat = start.rotation.T @ into
        circle = limb.cage_radius * math.hypot(flat[0], flat[1])
        reach.append(into @ (start.position + start.rotation @ limb.end) + circle)
    wall = models.Wall(-into, -max(reach) - 1e-5)
    return craft, start, models.Scene(models.compliant_craft(), wall, ())


# -- as users write them ---------------------------------------------------------------------------

#: Joints with stops that are near, preload, play and a table.
USERS: dict[str, dict[str, Any]] = {
    "slide": {"type": "slide", "travel": ["0 mm", "1.9 mm"], "stiffness": "5 N/mm", "damping": 20},
    "legs": {
        "type": "slide", "direction": [-1, 0, 1], "travel": ["0 mm", "50 mm"],
        "stiffness": "2 N/mm", "damping": 10, "preload": 2.0,
    },
    "folding": {
        "type": "hinge", "position": [0.06, 0, 0], "axis": [0, 0, 1], "rotors": "body",
        "travel": ["-60 deg", "60 deg"], "stiffness": "10 N m/rad", "damping": 0.02,
        "play": "0.02 deg",
    },
    "odd": {
        "type": "hinge", "position": [0.06, 0.01, 0.01], "axis": [-0.3, -0.5, -0.8],
        "travel": ["0 deg", "0.2 deg"], "damping": 0.02, "quadratic": 5.0,
        "table": [[0, 0], ["10 deg", 3.0], ["20 deg", 8.0]],
    },
}  # fmt: skip


def user_flight(arms: dict[str, Any]) -> Flight:
    """A pitched and rolled impact at 2 m/s, as users fly it."""
    common = {"directions": ["45 deg", "135 deg", "225 deg", "315 deg"], "length": 0.19}
    scenario = {
        "vehicle": {"body": BODY, "arms": {**common, "mass": 0.05, "cage_radius": 0.11, **arms}},
        "world": {"obstacles": [{"type": "wall", "distance": 1.0, "surface": {"preset": "wall"}}]},
        "start": {
            "velocity": [2.0, 0.3, -0.1], "pitch": 0.2, "roll": 0.3, "yaw": 0.6,
            "touch_distance": 1e-5,
        },
        "thrust": 3.0,
        "simulation": {"duration": 0.003},
    }  # fmt: skip
    return fly(scenario, executor="python")


# -- results ----------------------------------------------------------------------------------------


def relative_error(a: Any, b: Any) -> float:
    """Largest difference, relative to the largest component (at least 1)."""
    return float(np.abs(np.asarray(a) - b).max() / max(1.0, np.abs(b).max()))

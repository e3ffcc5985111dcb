"""Crafts whose arms are on two joints, as the package's own types and as users write them."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from builders import joint_crafts
from builders.joint_crafts import BODY, NO_WALL, before_a_wall
from oracles import models
from oracles.bent_limbs import drawn
from oracles.joint_lagrangian import Craft, Limb, Pose
from springback.kernels.vectors import Mat3
from springback.simulation.measuring.record import Model
from springback.vehicle.arms.bent import BentArm
from springback.vehicle.arms.neighbours import NeighbourSpring, NeighbourSprings
from springback.vehicle.parameters import Vehicle
from springback.vehicle.state import Airframe, Bend, State, build_airframe


def second_settings(limb: Limb, **changes: Any) -> dict[str, Any]:
    """User input of the second joint of an arm."""
    joint = joint_crafts.settings_of(replace(limb.chain[1], end=limb.end), **changes)["joint"]
    return {key: value for key, value in joint.items() if key != "rotors"}


def arm_of(limb: Limb, second: dict[str, Any] | None = None, **changes: Any) -> BentArm:
    """The package's constants of an arm, from user input, its joints changed."""
    settings = joint_crafts.settings_of(limb, **changes)
    travel = 0.9 if limb.chain[1].kind == "hinge" else 0.05
    low = 0.0 if limb.chain[1].preload > 0.0 or limb.chain[1].latch[0] > 0.0 else -travel
    given = {"travel": [low, travel], **(second or {})}
    settings["joint"]["second"] = second_settings(limb, **given)
    vehicle = {"name": "one", "body": BODY, "arms": settings}
    arm = Vehicle.model_validate(vehicle).airframe().arms[0]
    assert isinstance(arm, BentArm)
    return arm


def airframe_of(craft: Craft) -> Airframe:
    """The package's constants of a craft; latched arms, too, move either way."""
    arms = [arm_of(limb) for limb in craft.limbs]
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


def radii(craft: Craft) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Radii of the paths of both joints, shape (arms, 2) [m]; 1 for a slide."""
    return np.array([[one.radius for one in limb.chain] for limb in craft.limbs])


def _free(craft: Craft) -> np.ndarray[Any, np.dtype[np.float64]]:
    return np.array([math.hypot(limb.end[0], limb.end[1]) for limb in craft.limbs])


def state_of(craft: Craft, pose: Pose) -> State:
    """The package's state."""
    ways, rates = -radii(craft) * pose.bends, -radii(craft) * pose.rates
    start = models.Start(
        pose.position, pose.attitude, pose.velocity, pose.omega, _free(craft) + ways[:, 0],
        rates[:, 0],
    )  # fmt: skip
    bends = tuple(Bend(float(a), float(b)) for a, b in zip(ways[:, 1], rates[:, 1], strict=True))
    return models.state_of(start)._replace(bends=bends)


def pose_of(craft: Craft, state: State) -> Pose:
    """Plain numbers of a state of the package."""
    now = models.start_of(state)
    bends = np.array(state.bends)
    ways = np.stack([now.lengths - _free(craft), bends[:, 0]], axis=1)
    rates = np.stack([now.rates, bends[:, 1]], axis=1)
    around = radii(craft)
    return Pose(
        now.position, now.attitude, now.velocity, now.omega, -ways / around, -rates / around
    )


def with_springs(limb: Limb, seed: int) -> BentArm:
    """An arm with stops that random states reach, and with all sorts of springs at both joints."""
    kinds = []
    for k, one in enumerate(limb.chain):
        size, force = (0.4, 5.0) if one.kind == "hinge" else (0.02, 100.0)
        low = 0.0 if one.preload > 0.0 or one.latch[0] > 0.0 else -size
        points = [[0.0, 0.0], [0.2 * size, 0.1 * force], [0.7 * size, force]]
        sorts: list[dict[str, Any]] = [
            {},
            {"play": 0.2 * size},
            {"table": points, "stiffness": None, "quadratic": 0.0},
            {"one_sided": True, "travel": [0.0, size]},
        ]
        kinds.append({"travel": [low, size], **sorts[(seed + (k + 1) * (seed // 4)) % 4]})
    return arm_of(limb, second=kinds[1], **kinds[0])


def vehicle(name: str, seed: int) -> tuple[Craft, Pose]:
    """As `oracles.bent_limbs.drawn`, but of usual inertia, lightly bent and at rest, unlatched."""
    craft, pose = drawn(name, seed)
    limbs = []
    for limb in craft.limbs:
        second = replace(limb.chain[1], preload=0.0, latch=(0.0, 1.0))
        limbs.append(replace(limb, preload=0.0, second=second))  # type: ignore[call-arg]
    products = np.array([[0.0, 3e-4, -5e-4], [3e-4, 0.0, 4e-4], [-5e-4, 4e-4, 0.0]])
    inertia = np.diag([0.0064, 0.008, 0.0125]) + products
    craft = replace(craft, inertia=inertia, limbs=tuple(limbs))
    still = replace(pose, bends=0.4 * pose.bends, rates=0.0 * pose.rates)
    return craft, replace(still, attitude=models.quaternion(0.2, -0.3, 0.5))


def impact(name: str, seed: int) -> tuple[Craft, Pose, models.Scene]:
    """A vehicle 10 µm from a tilted wall, which it meets at some 2 m/s."""
    return before_a_wall(*vehicle(name, seed))

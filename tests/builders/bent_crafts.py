"""Crafts whose arms are on two joints, as the package's own types and as users write them."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from builders import joint_crafts
from builders.joint_crafts import BODY, NO_WALL
from oracles import models
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


def _radii(craft: Craft) -> np.ndarray[Any, np.dtype[np.float64]]:
    return np.array([[one.radius for one in limb.chain] for limb in craft.limbs])


def _free(craft: Craft) -> np.ndarray[Any, np.dtype[np.float64]]:
    return np.array([math.hypot(limb.end[0], limb.end[1]) for limb in craft.limbs])


def state_of(craft: Craft, pose: Pose) -> State:
    """The package's state."""
    ways, rates = -_radii(craft) * pose.bends, -_radii(craft) * pose.rates
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
    radii = _radii(craft)
    return Pose(now.position, now.attitude, now.velocity, now.omega, -ways / radii, -rates / radii)

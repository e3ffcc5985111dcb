"""Clearance: distance between a vehicle and the nearest obstacle."""

from __future__ import annotations

from typing import Any

from springback.contact.cage import cage_gap
from springback.contact.hull_contact import hull_apart
from springback.contact.obstacles import Obstacle, World, obstacle_in_body_frame
from springback.kernels.compiler import kernel
from springback.kernels.trees import minimum, tree_map
from springback.kernels.vectors import rotation
from springback.vehicle.state import Airframe, Arm, Sphere, State, arm_pose


@kernel
def _of_arm(
    arm: Arm, length: float, rate: float, obstacles: tuple[Obstacle, ...], point: Any, state: State
) -> float:
    pose = arm_pose(arm, length, rate, state.velocity)  # only its position is used
    return minimum(tree_map(cage_gap, (obstacles,), (point, arm.cage_radius, pose)))


@kernel
def _of_hull(hull: Sphere, obstacles: tuple[Obstacle, ...]) -> float:
    return minimum(tree_map(hull_apart, (obstacles,), (hull,)))


@kernel
def clearance(airframe: Airframe, world: World, contact_point: Any, state: State) -> float:
    """The smallest gap between a cage, or the hull, and an obstacle [m]; negative in penetration.

    Args:
        airframe: Constants of the vehicle.
        world: The obstacles.
        contact_point: `springback.contact.cage.Ring` or `ArmTip`.
        state: State of the vehicle.
    """
    r = rotation(state.attitude)
    obstacles = tree_map(obstacle_in_body_frame, (world.obstacles,), (state.position, r))
    arms = (airframe.arms, state.arm_length, state.arm_rate)
    cages = tree_map(_of_arm, arms, (obstacles, contact_point, state))
    return minimum(cages + tree_map(_of_hull, (airframe.hull,), (obstacles,)))

"""Clearance: distance between a vehicle and the nearest obstacle."""

from __future__ import annotations

from typing import Any

from springback.contact.cage import obstacles_in_body_frame, obstacles_now
from springback.contact.hull_contact import arm_gap, hull_gap
from springback.contact.obstacles import World
from springback.kernels.compiler import kernel
from springback.kernels.trees import minimum, tree_map
from springback.kernels.vectors import rotation
from springback.vehicle.state import Airframe, Arm, State, arm_pose


@kernel
def _of_arm(
    arm: Arm, length: float, rate: float, obstacles: Any, point: Any, state: State
) -> float:
    pose = arm_pose(arm, length, rate, state.velocity)  # only its position is used
    return arm_gap(arm, obstacles, point, pose)


@kernel
def clearance(airframe: Airframe, world: World, contact_point: Any, state: State) -> float:
    """The smallest gap between a cage, or the hull, and an obstacle [m]; negative in penetration.

    Far from all obstacles of a scene it may be less.

    Args:
        airframe: Constants of the vehicle.
        world: The obstacles.
        contact_point: `springback.contact.cage.Ring` or `ArmTip`.
        state: State of the vehicle.
    """
    r = rotation(state.attitude)
    there = obstacles_now(world.obstacles, state.bodies)
    obstacles = obstacles_in_body_frame(there, state.position, r)
    arms = (airframe.arms, state.arm_length, state.arm_rate)
    cages = tree_map(_of_arm, arms, (obstacles, contact_point, state))
    return minimum(cages + tree_map(hull_gap, (airframe.hull,), (obstacles,)))

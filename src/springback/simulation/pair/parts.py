"""Parts of a vehicle as moving obstacles of another one: `springback.simulation.pair.solids`."""

from __future__ import annotations

from typing import Any

import numpy as np

from springback.contact.moving.bodies import CARRIED, BodyAccelerations, MovingBody
from springback.contact.moving.building import bodies_of
from springback.contact.surfaces import Surface
from springback.kernels.compiler import kernel
from springback.kernels.trees import tree_map
from springback.kernels.vectors import Mat3, rotation
from springback.simulation.pair.solids import PartSolid, reach_of_part, scene_of_part
from springback.vehicle.state import Airframe, Arm, BodyState, State, arm_direction


@kernel
def _arm_part(arm: Arm, length: float, rate: float, state: State, r: Mat3) -> BodyState:
    lever = length * arm_direction(arm)
    moving = (state.angular_velocity ^ lever) + rate * arm_direction(arm)
    return BodyState(
        state.position + r @ lever, state.attitude, state.velocity + r @ moving,
        state.angular_velocity,
    )  # fmt: skip


@kernel
def _hull_part(hull: Any, state: State) -> BodyState:
    return BodyState(state.position, state.attitude, state.velocity, state.angular_velocity)


@kernel
def parts_of(airframe: Airframe, state: State) -> tuple[BodyState, ...]:
    """Where the parts of a vehicle are, and how they move: its cages, then its hull."""
    r = rotation(state.attitude)
    arms = (airframe.arms, state.arm_length, state.arm_rate)
    return tree_map(_arm_part, arms, (state, r)) + tree_map(_hull_part, (airframe.hull,), (state,))


@kernel
def _arm_accelerations(
    arm: Arm, length: float, rate: float, changes: float, state: State, now: State, r: Mat3
) -> BodyAccelerations:
    along, w = arm_direction(arm), state.angular_velocity
    lever, moving = length * along, (w ^ (length * along)) + rate * along
    turned = (now.angular_velocity ^ lever) + (w ^ moving) + (w ^ (rate * along))
    linear = now.velocity + r @ (turned + changes * along)
    return BodyAccelerations(linear, now.angular_velocity)


@kernel
def _hull_accelerations(hull: Any, now: State) -> BodyAccelerations:
    return BodyAccelerations(now.velocity, now.angular_velocity)


@kernel
def part_accelerations(
    airframe: Airframe, state: State, now: State
) -> tuple[BodyAccelerations, ...]:
    """Accelerations of the parts of a vehicle: of its cages, then of its hull.

    Args:
        airframe: Of the vehicle.
        state: Its state.
        now: The rate of that.
    """
    arms = (airframe.arms, state.arm_length, state.arm_rate, now.arm_rate)
    cages = tree_map(_arm_accelerations, arms, (state, now, rotation(state.attitude)))
    return cages + tree_map(_hull_accelerations, (airframe.hull,), (now,))


def carried_bodies(
    airframe: Airframe,
    solids: tuple[tuple[PartSolid, ...], ...],
    state: State,
    surface: Surface | None,
) -> tuple[MovingBody, ...]:
    """The parts of a vehicle as moving obstacles.

    Args:
        airframe: Of the vehicle.
        solids: Of its parts, by `springback.simulation.pair.solids.solids_of`; of a vehicle that
            nothing is to touch any will do.
        state: At time 0.
        surface: Of the contact between both vehicles; None if nothing is to touch these.
    """
    give = [_mobility(airframe, arm) for arm in airframe.arms]
    give += [_mobility(airframe, None) for _ in airframe.hull]
    scenes = [scene_of_part(part, surface) if surface else None for part in solids]
    reach = [reach_of_part(part) for part in solids]
    return bodies_of(CARRIED, scenes, reach, give, parts_of(airframe, state))


def _mobility(airframe: Airframe, arm: Arm | None) -> float:
    """Upper bound of the speed of a part per impulse on it [1/kg]."""
    slides = 0.0 if arm is None else arm.compliance * arm.inverse_mass
    inertia = np.array(airframe.inertia)
    far = max(one.length + one.cage_radius for one in airframe.arms)
    return airframe.inverse_mass + slides + far**2 / float(np.linalg.eigvalsh(inertia)[0])

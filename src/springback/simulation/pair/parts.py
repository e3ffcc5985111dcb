"""Parts of a vehicle as moving obstacles of another one.

A cage is a disc as large as its circle, with rounded edges: between its rim and its propeller
nothing passes.  The hull of the main body is the sphere that it is.
"""

from __future__ import annotations

import numpy as np

from springback.contact.moving.bodies import CARRIED, BodyAccelerations, MovingBody
from springback.contact.moving.building import bodies_of
from springback.contact.scene.solids import CAPSULE, FRUSTUM
from springback.contact.scene.table import Solid, scene_of
from springback.contact.surfaces import Surface
from springback.kernels.compiler import kernel
from springback.kernels.trees import tree_map
from springback.kernels.vectors import Mat3, rotation
from springback.vehicle.state import Airframe, Arm, BodyState, Sphere, State, arm_direction

#: Height of a cage as a disc, and radius of its edges [m] (chosen: a guard with its motor); pressed
#: in deeper than half the height, it gives way across its plane.
HEIGHT, EDGE = 0.04, 0.012


@kernel
def _arm_part(arm: Arm, length: float, rate: float, state: State, r: Mat3) -> BodyState:
    lever = length * arm_direction(arm)
    moving = (state.angular_velocity ^ lever) + rate * arm_direction(arm)
    return BodyState(
        state.position + r @ lever, state.attitude, state.velocity + r @ moving,
        state.angular_velocity,
    )  # fmt: skip


@kernel
def _hull_part(hull: Sphere, state: State) -> BodyState:
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
def _hull_accelerations(hull: Sphere, now: State) -> BodyAccelerations:
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
    airframe: Airframe, state: State, surface: Surface | None
) -> tuple[MovingBody, ...]:
    """The parts of a vehicle as moving obstacles.

    Args:
        airframe: Of the vehicle.
        state: At time 0.
        surface: Of the contact between both vehicles; None if nothing is to touch these.
    """
    solids = [_disc(arm.cage_radius) for arm in airframe.arms]
    solids += [_ball(hull) for hull in airframe.hull]
    give = [_mobility(airframe, arm) for arm in airframe.arms]
    give += [_mobility(airframe, None) for _ in airframe.hull]
    scenes = [scene_of([solid], [surface]) if surface else None for solid in solids]
    reach = [float(np.linalg.norm(solid.centre)) + max(solid.half_lengths()) for solid in solids]
    return bodies_of(CARRIED, scenes, reach, give, parts_of(airframe, state))


def _disc(radius: float) -> Solid:
    edge, half = EDGE, 0.5 * HEIGHT - EDGE
    return Solid(
        FRUSTUM, np.zeros(3), np.eye(3), (radius - edge, radius - edge, half), edge, 0, 0.0, 0
    )


def _ball(hull: Sphere) -> Solid:
    return Solid(CAPSULE, np.array(hull.centre), np.eye(3), (0.0, hull.radius), 0.0, 0, 0.0, 0)


def _mobility(airframe: Airframe, arm: Arm | None) -> float:
    """Upper bound of the speed of a part per impulse on it [1/kg]."""
    slides = 0.0 if arm is None else arm.compliance * arm.inverse_mass
    inertia = np.array(airframe.inertia)
    far = max(one.length + one.cage_radius for one in airframe.arms)
    return airframe.inverse_mass + slides + far**2 / float(np.linalg.eigvalsh(inertia)[0])

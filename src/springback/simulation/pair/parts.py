"""Parts of a vehicle as moving obstacles of another one: `springback.simulation.pair.solids`."""

from __future__ import annotations

from typing import Any

import numpy as np

from springback.contact.laws.memory import hull_memory
from springback.contact.moving.bodies import CARRIED, BodyAccelerations, MovingBody
from springback.contact.moving.building import bodies_of
from springback.contact.surfaces import Surface
from springback.dynamics.limbs.shell import whole_spin, whole_turning
from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import replace, tree_map
from springback.kernels.vectors import Mat3, exponential_map, quaternion_product, rotation
from springback.simulation.pair.solids import PartSolid, reach_of_part, scene_of_part
from springback.vehicle.arms.bent import (
    ON_JOINTS,
    BentArm,
    bent_mobility,
    bent_pose,
    coordinates_on,
)
from springback.vehicle.arms.joints import JointedArm, farthest_from_end, joint_pose
from springback.vehicle.state import (
    Airframe,
    Arm,
    BodyState,
    PartMemory,
    Shell,
    State,
    arm_direction,
    coordinates_of_arms,
    farthest_of_arm,
    rates_of_arms,
)


@generic
def arm_part(arm: Any, length: float, rate: float, body: BodyState, r: Mat3) -> BodyState:
    """Where the end of an arm is, with what it carries, and how it moves.

    Args:
        arm: Constants of the arm.
        length: Along its path [m].
        rate: Of that [m/s].
        body: The main body.
        r: Its axes to those of the world.
    """
    raise TypeError(f"{type(arm).__name__} is not an arm")


@arm_part.register(Arm)
@kernel
def _on_slide(arm: Arm, length: float, rate: float, body: BodyState, r: Mat3) -> BodyState:
    lever = length * arm_direction(arm)
    moving = (body.angular_velocity ^ lever) + rate * arm_direction(arm)
    return BodyState(
        body.position + r @ lever, body.attitude, body.velocity + r @ moving, body.angular_velocity
    )


@arm_part.register(JointedArm)
@kernel
def _on_joint(arm: JointedArm, length: float, rate: float, body: BodyState, r: Mat3) -> BodyState:
    there = joint_pose(arm, length, rate)
    moving = (body.angular_velocity ^ there.end) + rate * there.direction
    turned = exponential_map((arm.joint.curvature * (length - arm.length)) * there.axis)
    spin = body.angular_velocity + there.turning * there.axis
    return BodyState(
        body.position + r @ there.end, quaternion_product(body.attitude, turned),
        body.velocity + r @ moving, spin @ there.turn,
    )  # fmt: skip


@arm_part.register(BentArm)
@kernel
def _on_two_joints(arm: BentArm, length: Any, rate: Any, body: BodyState, r: Mat3) -> BodyState:
    there, at = bent_pose(arm, length, rate), coordinates_on(length)
    moving = (body.angular_velocity ^ there.end) + there.velocity
    inner, outer = arm.joint, arm.second.joint
    axis, other = inner.direction ^ inner.inward, outer.direction ^ outer.inward
    first = exponential_map((inner.curvature * (at.first - arm.length)) * axis)
    second = exponential_map((outer.curvature * (at.second - arm.second.length)) * other)
    turned = quaternion_product(first, second)
    return BodyState(
        body.position + r @ there.end, quaternion_product(body.attitude, turned),
        body.velocity + r @ moving, (body.angular_velocity + there.spin) @ there.turn,
    )  # fmt: skip


@generic
def hull_part(hull: Any, memory: PartMemory, body: BodyState, r: Mat3) -> BodyState:
    """How a hull of the main body moves: with that, but for a shell that turns by itself.

    Args:
        hull: Of the main body.
        memory: Of the hull.
        body: The main body.
        r: Its axes to those of the world.
    """
    return body


@hull_part.register(Shell)
@kernel
def _shell_part(hull: Shell, memory: PartMemory, body: BodyState, r: Mat3) -> BodyState:
    """As if the main body turned with it about its centre."""
    omega = body.angular_velocity
    spin = whole_spin(hull, memory.spin[0] @ r, omega)
    velocity = body.velocity + r @ ((omega - spin) ^ hull.centre)
    return replace(body, velocity=velocity, angular_velocity=spin)


@kernel
def parts_of(airframe: Airframe, state: State) -> tuple[BodyState, ...]:
    """Where the parts of a vehicle are, and how they move: its cages, then its hull."""
    r = rotation(state.attitude)
    body = BodyState(state.position, state.attitude, state.velocity, state.angular_velocity)
    arm = airframe.arms[0]
    arms = (airframe.arms, coordinates_of_arms(arm, state), rates_of_arms(arm, state))
    hulls = (airframe.hull, hull_memory(state.memory, airframe.hull))
    return tree_map(arm_part, arms, (body, r)) + tree_map(hull_part, hulls, (body, r))


@generic
def arm_accelerations(
    arm: Any, length: float, rate: float, changes: float, state: State, now: State, r: Mat3
) -> BodyAccelerations:
    """Accelerations of the end of an arm.

    Args:
        arm: Constants of the arm.
        length: Along its path [m].
        rate: Of that [m/s].
        changes: Of that [m/s²].
        state: Of the vehicle.
        now: The rate of that.
        r: Axes of the main body to those of the world.
    """
    raise TypeError(f"{type(arm).__name__} is not an arm")


@arm_accelerations.register(Arm)
@kernel
def _of_slide(
    arm: Arm, length: float, rate: float, changes: float, state: State, now: State, r: Mat3
) -> BodyAccelerations:
    along, w = arm_direction(arm), state.angular_velocity
    lever, moving = length * along, (w ^ (length * along)) + rate * along
    turned = (now.angular_velocity ^ lever) + (w ^ moving) + (w ^ (rate * along))
    linear = now.velocity + r @ (turned + changes * along)
    return BodyAccelerations(linear, now.angular_velocity)


@arm_accelerations.register(JointedArm)
@kernel
def _of_joint(
    arm: JointedArm, length: float, rate: float, changes: float, state: State, now: State, r: Mat3
) -> BodyAccelerations:
    there, w, k = joint_pose(arm, length, rate), state.angular_velocity, arm.joint.curvature
    slides, spin = rate * there.direction, there.turning * there.axis
    moving = (w ^ there.end) + slides
    turned = (now.angular_velocity ^ there.end) + (w ^ moving) + (w ^ slides)
    bent = changes * there.direction + (rate * rate) * there.bend
    angular = now.angular_velocity + (k * changes) * there.axis + (w ^ spin)
    return BodyAccelerations(now.velocity + r @ (turned + bent), angular @ there.turn)


@arm_accelerations.register(BentArm)
@kernel
def _of_two_joints(
    arm: BentArm, length: Any, rate: Any, changes: Any, state: State, now: State, r: Mat3
) -> BodyAccelerations:
    there, w = bent_pose(arm, length, rate), state.angular_velocity
    speed, more = coordinates_on(rate), coordinates_on(changes)
    moving = (w ^ there.end) + there.velocity
    turned = (now.angular_velocity ^ there.end) + (w ^ moving) + (w ^ there.velocity)
    bent = more.first * there.first + more.second * there.second + there.bias
    turning = more.first * there.about_first + more.second * there.about_second
    turning = turning + (speed.first * speed.second) * (there.about_first ^ there.about_second)
    angular = now.angular_velocity + turning + (w ^ there.spin)
    return BodyAccelerations(now.velocity + r @ (turned + bent), angular @ there.turn)


@generic
def hull_accelerations(
    hull: Any, memory: PartMemory, change: PartMemory, state: State, now: State, r: Mat3
) -> BodyAccelerations:
    """Accelerations of a hull of the main body.

    Args:
        hull: Of the main body.
        memory: Of the hull.
        change: The rate of that.
        state: Of the vehicle.
        now: The rate of that.
        r: Axes of the main body to those of the world.
    """
    return BodyAccelerations(now.velocity, now.angular_velocity)


@hull_accelerations.register(Shell)
@kernel
def _of_shell(
    hull: Shell, memory: PartMemory, change: PartMemory, state: State, now: State, r: Mat3
) -> BodyAccelerations:
    """The centre is that of the main body; about it the shell turns."""
    omega, angular, c = state.angular_velocity, now.angular_velocity, hull.centre
    spin = whole_spin(hull, memory.spin[0] @ r, omega)
    turning = whole_turning(hull, change.spin[0] @ r, angular, omega, spin - omega)
    centre = ((angular - turning) ^ c) + (omega ^ (omega ^ c)) - (spin ^ (spin ^ c))
    return BodyAccelerations(now.velocity + r @ centre, turning)


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
    arm = airframe.arms[0]
    along, speeds = coordinates_of_arms(arm, state), rates_of_arms(arm, state)
    arms = (airframe.arms, along, speeds, rates_of_arms(arm, now))
    r, hull = rotation(state.attitude), airframe.hull
    cages = tree_map(arm_accelerations, arms, (state, now, r))
    hulls = (hull, hull_memory(state.memory, hull), hull_memory(now.memory, hull))
    return cages + tree_map(hull_accelerations, hulls, (state, now, r))


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
    give += [_mobility(airframe, one) for one in airframe.hull]
    scenes = [scene_of_part(part, surface) if surface and part else None for part in solids]
    reach = [reach_of_part(part) for part in solids]
    return bodies_of(CARRIED, scenes, reach, give, parts_of(airframe, state))


def _rim_mobility(arm: BentArm) -> float:
    """Bound of the mobility of the rim of an arm times its mass, where it is free, by traces."""
    far = farthest_from_end(arm)
    inverse = bent_mobility(bent_pose(arm, arm.length, 0.0))
    curved = arm.joint.curvature, arm.second.joint.curvature
    return float((inverse.xx + inverse.yy) * sum((1.0 + k * far) ** 2 for k in curved))


def _mobility(airframe: Airframe, part: Any) -> float:
    """Upper bound of the speed of a part, an arm or a hull, per impulse on it [1/kg]."""
    slides = 0.0
    if isinstance(part, Arm | JointedArm | BentArm):
        slides = part.compliance * part.inverse_mass
    if isinstance(part, BentArm):
        slides *= _rim_mobility(part)
    if isinstance(part, JointedArm):  # the rim of what is on a hinge moves by e + κ a × d
        slides *= (1.0 + part.joint.curvature * farthest_from_end(part)) ** 2
    if isinstance(part, Shell):
        slides = part.radius * part.radius / part.inertia
    inertia = np.array(airframe.inertia)
    far = max(
        farthest_of_arm(one) if isinstance(one, ON_JOINTS) else one.length + one.cage_radius
        for one in airframe.arms
    )
    return airframe.inverse_mass + slides + float(far) ** 2 / float(np.linalg.eigvalsh(inertia)[0])

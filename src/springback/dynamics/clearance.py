"""Clearance: distance between a vehicle and the nearest obstacle, and for how long it lasts.

Propellers feel no force, but are known to be hit.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.cage import lowest_gap, obstacles_in_body_frame
from springback.contact.hull_contact import BodySight, arm_gap, arm_sight, body_sight, hull_gap
from springback.contact.obstacles import World
from springback.contact.rings import FAR
from springback.contact.scene.faces import SolidScene
from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import minimum, one_tuple, tree_map
from springback.kernels.vectors import Vec
from springback.vehicle.placed.rotors import PlacedRotor, PlacedRotors, RotorPose, poses_at
from springback.vehicle.rotor_stop import AT_HIT
from springback.vehicle.state import (
    Airframe,
    ArmPose,
    Propeller,
    State,
    coordinates_of_arms,
    rates_of_arms,
)


@kernel
def _of_disc(disc: Propeller, obstacles: Any, pose: ArmPose, looks: float) -> float:
    above = ArmPose(pose.direction, pose.lever + Vec(0.0, 0.0, disc.height), pose.sliding)
    return lowest_gap(obstacles, disc, disc.radius, above) if looks > 0.0 else FAR


@kernel
def _of_propeller(
    arm: Any, length: float, rate: float, around: BodySight, looks: float
) -> tuple[float, ...]:
    pose, obstacles, _ = arm_sight(arm, length, rate, around)  # only its position is used
    return tree_map(_of_disc, (arm.propeller,), (obstacles, pose, looks))


@kernel
def disc_gaps(
    airframe: Airframe, world: World, state: State, looks: float
) -> tuple[tuple[float, ...], ...]:
    """For each rotor, the gap between its propeller and the nearest obstacle, or less if far [m].

    There is none for propellers of unknown size.

    Args:
        airframe: Constants of the vehicle.
        world: The obstacles.
        state: State of the vehicle.
        looks: 0 where no part can touch: nothing is then looked for.
    """
    return gaps_of_discs(airframe.rotors, airframe, world, state, looks)


@generic
def gaps_of_discs(
    rotors: Any, airframe: Airframe, world: World, state: State, looks: float
) -> tuple[tuple[float, ...], ...]:
    """As `disc_gaps`, by the list of rotors; without one those at the ends of arms."""
    around = body_sight(world.obstacles, state, 0.0)
    lengths = coordinates_of_arms(airframe.arms[0], state)
    arms = (airframe.arms, lengths, rates_of_arms(airframe.arms[0], state))
    return tree_map(_of_propeller, arms, (around, looks))


@kernel
def _of_listed(
    rotor: PlacedRotor, pose: RotorPose, around: BodySight, looks: float
) -> tuple[float, ...]:
    """Obstacles are seen from the axes of the disc, about the main body, as by a hinged arm."""
    turn = pose.mount.aim @ rotor.axes
    obstacles = obstacles_in_body_frame(around.there, around.body.position, around.body.r @ turn)
    lever, none = (pose.mount.end + pose.lever) @ turn, Vec(0.0, 0.0, 0.0)
    return tree_map(_of_disc, (rotor.propeller,), (obstacles, ArmPose(none, lever, none), looks))


@gaps_of_discs.register(PlacedRotors)
@kernel
def _of_all_listed(
    rotors: PlacedRotors, airframe: Airframe, world: World, state: State, looks: float
) -> tuple[tuple[float, ...], ...]:
    around = body_sight(world.obstacles, state, 0.0)
    poses = poses_at(rotors, airframe.arms, coordinates_of_arms(airframe.arms[0], state))
    return tree_map(_of_listed, (rotors.each, poses), (around, looks))


@kernel
def propeller_gaps(
    airframe: Airframe, world: World, state: State, looks: float
) -> tuple[float, ...]:
    """As `disc_gaps`, for all propellers of known size."""
    return one_tuple(disc_gaps(airframe, world, state, looks))


@kernel
def _hit_time(before: float, gap: float, time: float) -> float:
    return time if (gap < AT_HIT) & (before < 0.0) else before


@kernel
def first_hits(
    before: tuple[float, ...], gaps: tuple[float, ...], time: float
) -> tuple[float, ...]:
    """When each propeller was first hit [s]; −1 if it was not.

    Args:
        before: As known before.
        gaps: By `propeller_gaps`.
        time: Now [s].
    """
    return tree_map(_hit_time, (before, gaps), (time,))


@kernel
def _of_arm(arm: Any, length: float, rate: float, point: Any, around: BodySight) -> float:
    pose, obstacles, _ = arm_sight(arm, length, rate, around)  # only its position is used
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
    around = body_sight(world.obstacles, state, 0.0)
    lengths = coordinates_of_arms(airframe.arms[0], state)
    arms = (airframe.arms, lengths, rates_of_arms(airframe.arms[0], state))
    cages = tree_map(_of_arm, arms, (contact_point, around))
    return minimum(cages + tree_map(hull_gap, (airframe.hull,), (around.obstacles,)))


@kernel
def room_around(airframe: Airframe, world: World, contact_point: Any, state: State) -> float:
    """As `clearance`, of the propellers, too."""
    near = clearance(airframe, world, contact_point, state)
    return minimum((near,) + propeller_gaps(airframe, world, state, 1.0))  # noqa: RUF005


#: Nothing can touch for some time if it cannot within this many steps ...
ROOMY_STEPS = 8.0
#: ... and this distance [m].
ROOM = 1e-3
#: Factor on the speed of the fastest point at the beginning of a step.
HASTE = 2.0


@kernel
def has_room(room: float, fastest: float, step: float) -> bool:
    """True if nothing can touch for several steps.

    Args:
        room: Lower bound of the distance of every part from every obstacle [m].
        fastest: Upper bound of the speed of every part [m/s].
        step: Longest step [s].
    """
    return room > ROOMY_STEPS * HASTE * fastest * step + ROOM


class Search(NamedTuple):
    """Whether faces are looked for at the beginning of a step."""

    looks: float  # 0 where nothing can touch
    room: float  # lower bound of the distance of every part from every obstacle [m]


@generic
def search_at(obstacles: Any, room: float, fastest: float, gone: float, step: float) -> Search:
    """Whether to look for faces: always, but for a scene at rest that is out of reach.

    Args:
        obstacles: The world's.
        room: Lower bound of the distance when the step before began [m].
        fastest: Upper bound of the speed of every part [m/s].
        gone: Length of the step before [s].
        step: Longest next step [s].
    """
    return Search(1.0, room)


@search_at.register(SolidScene)
@kernel
def _in_scene(scene: SolidScene, room: float, fastest: float, gone: float, step: float) -> Search:
    left = room - HASTE * fastest * gone
    return Search(0.0 if has_room(left, fastest, step) else 1.0, left)

"""A world in which some obstacles move, and the faces that a part of a vehicle meets there.

Whatever is at rest is one scene (`springback.contact.scene.faces`), and each moving obstacle is a
scene of its own, in its own axes.  A part of a vehicle is viewed from each in turn, and meets the
nearest faces of all of them together, as many as in a scene at rest.
"""

from __future__ import annotations

import functools
from typing import Any, NamedTuple

from springback.contact.cage import (
    BodyMotion,
    ContactFace,
    FaceMotion,
    cage_gap,
    contact_faces,
    face_of,
    lowest_gap,
    moving_bodies,
    obstacles_in_body_frame,
    obstacles_now,
    per_face,
    touching_radius,
)
from springback.contact.loads import CageContact, contacts_with
from springback.contact.moving.bodies import ABSENT, BodyPose, MovingBody, body_pose
from springback.contact.obstacles import Obstacle, obstacle_in_body_frame
from springback.contact.scene.contacts import contacts_in_scene
from springback.contact.scene.faces import (
    EXACT_BELOW,
    SceneInBodyFrame,
    SolidScene,
    ThreeFaces,
    VehiclePart,
    blank_part,
    no_faces,
    part_of,
    radius_in_scene,
    scene_faces,
)
from springback.kernels.compiler import kernel
from springback.kernels.routines import Routine, call_routine
from springback.kernels.trees import fold, minimum, tree_map
from springback.kernels.vectors import Mat3, Vec, norm
from springback.vehicle.state import ArmPose, BodyState, PartMemory

#: Number of what is at rest, as a body.
AT_REST = -1.0


class MovingScene(NamedTuple):
    """A world in which some obstacles move."""

    still: SolidScene  # all others
    bodies: tuple[MovingBody, ...]
    search: float  # address of `faces_of_all` for as many bodies
    one: float  # address of `faces_of_body`
    rates: float  # address of `springback.dynamics.moving_obstacles.body_rates`; 0 in no flight


class PlacedScene(NamedTuple):
    """A world in which some obstacles move, at an instant."""

    still: SolidScene
    bodies: tuple[MovingBody, ...]
    poses: tuple[BodyPose, ...]
    search: float
    one: float


class BodyInBodyFrame(NamedTuple):
    """A moving obstacle, viewed from a vehicle."""

    scene: float  # address of the table of its solids
    kind: float  # of motion
    reach: float  # [m]
    position: Vec  # of the vehicle, in the obstacle's axes [m]
    r: Mat3  # body axes of the vehicle to the obstacle's axes
    motion: FaceMotion


class MovingInBodyFrame(NamedTuple):
    """A world in which some obstacles move, viewed from a vehicle."""

    still: SceneInBodyFrame
    bodies: tuple[BodyInBodyFrame, ...]
    own: tuple[Obstacle, ...]
    search: float
    one: float


class BodySearch(NamedTuple):
    """A part of a vehicle beside one obstacle, and the faces found so far."""

    part: VehiclePart
    motion: FaceMotion
    found: ThreeFaces


class WorldSearch(NamedTuple):
    """A part of a vehicle in a world in which some obstacles move."""

    part: VehiclePart
    bodies: tuple[BodyInBodyFrame, ...]
    one: float


@kernel
def at_rest() -> FaceMotion:
    """No motion."""
    none = Vec(0.0, 0.0, 0.0)
    return FaceMotion(none, none, AT_REST)


@kernel
def with_motion(face: ContactFace, motion: FaceMotion) -> ContactFace:
    """A face of an obstacle with its motion."""
    return ContactFace(face.nearest, face.surface, face.is_ground, (motion,))


@kernel
def _inserted(found: ThreeFaces, new: ContactFace) -> ThreeFaces:
    """Faces with one more, if it is nearer than the farthest of them."""
    gap = new.nearest.gap
    if gap >= found.third.nearest.gap:
        return found
    if gap < found.first.nearest.gap:
        return ThreeFaces(new, found.first, found.second)
    if gap < found.second.nearest.gap:
        return ThreeFaces(found.first, new, found.second)
    return ThreeFaces(found.first, found.second, new)


@kernel
def no_moving_faces() -> ThreeFaces:
    """No face within reach, in a world in which obstacles move."""
    none, rest = no_faces(), at_rest()
    return ThreeFaces(
        with_motion(none.first, rest), with_motion(none.second, rest), with_motion(none.third, rest)
    )


@kernel
def faces_of_body(s: BodySearch) -> ThreeFaces:
    """The faces found so far, and those of one more obstacle that are nearer."""
    there = scene_faces(s.part)
    found = _inserted(s.found, with_motion(there.first, s.motion))
    found = _inserted(found, with_motion(there.second, s.motion))
    return _inserted(found, with_motion(there.third, s.motion))


@kernel
def _with_body(found: ThreeFaces, one: BodyInBodyFrame, s: WorldSearch) -> ThreeFaces:
    """Faces with those of a moving obstacle; one that is far gives a lower bound of its gap."""
    if (one.kind == ABSENT) | (one.scene == 0.0):  # absent, or without solids
        return found
    part = s.part
    away = norm(one.position + one.r @ part.pose.lever) - one.reach - part.radius
    if (away > EXACT_BELOW) & (part.exact == 0.0) & (away > found.first.nearest.gap):
        return found
    there = VehiclePart(
        one.scene, part.kind, part.rounding, part.radius, part.pose, one.position, one.r, part.exact
    )
    return call_routine(s.one, BodySearch(there, one.motion, found), found)


@kernel
def faces_of_all(s: WorldSearch) -> ThreeFaces:
    """The faces nearest to a part of a vehicle, of obstacles at rest and of those that move."""
    none = no_moving_faces()
    found = call_routine(s.one, BodySearch(s.part, at_rest(), none), none)
    return fold(_with_body, found, s.bodies, (s,))


#: `faces_of_body`, compiled once for all vehicles and worlds.
BODY_FACES = Routine(faces_of_body, BodySearch(blank_part(), at_rest(), no_moving_faces()))


@functools.cache
def search_among(bodies: int) -> Routine:
    """`faces_of_all` for a number of moving obstacles, compiled once for all flights."""
    none = Vec(0.0, 0.0, 0.0)
    one = BodyInBodyFrame(0.0, 0.0, 0.0, none, Mat3(none, none, none), at_rest())
    return Routine(faces_of_all, WorldSearch(blank_part(), (one,) * bodies, 0.0))


def scene_with(still: SolidScene, bodies: tuple[MovingBody, ...]) -> MovingScene:
    """World of a scene at rest and some moving obstacles."""
    return MovingScene(still, bodies, search_among(len(bodies)).address, BODY_FACES.address, 0.0)


def exactly(scene: SolidScene | MovingScene) -> SolidScene | MovingScene:
    """A world of which gaps are exact at any distance."""
    if isinstance(scene, MovingScene):
        return scene._replace(still=scene.still._replace(exact=1.0))
    return scene._replace(exact=1.0)


@obstacles_now.register(MovingScene)
@kernel
def _moving_now(scene: MovingScene, bodies: tuple[BodyState, ...]) -> PlacedScene:
    poses = tree_map(body_pose, (scene.bodies, bodies), ())
    return PlacedScene(scene.still, scene.bodies, poses, scene.search, scene.one)


@kernel
def _body_in_body_frame(body: MovingBody, pose: BodyPose, position: Vec, r: Mat3) -> Any:
    if body.kind == ABSENT:
        return BodyInBodyFrame(0.0, ABSENT, 0.0, position, r, at_rest())
    away, turn = position - pose.position, pose.r
    columns = Mat3(
        Vec(turn.x.x, turn.y.x, turn.z.x),
        Vec(turn.x.y, turn.y.y, turn.z.y),
        Vec(turn.x.z, turn.y.z, turn.z.z),
    )
    # Velocity of the obstacle, were it so large, at the main body.
    velocity = (pose.velocity + (pose.spin ^ away)) @ r
    motion = FaceMotion(velocity, pose.spin @ r, body.number)
    return BodyInBodyFrame(body.scene, body.kind, body.reach, away @ turn, columns @ r, motion)


@obstacles_in_body_frame.register(PlacedScene)
@kernel
def _placed_in_body_frame(scene: PlacedScene, position: Vec, r: Mat3) -> MovingInBodyFrame:
    still = scene.still
    own = tree_map(obstacle_in_body_frame, (still.own,), (position, r))
    rest = SceneInBodyFrame(
        still.table, still.query, (), position, r, still.exact, still.hull_query, still.rounding
    )
    bodies = tree_map(_body_in_body_frame, (scene.bodies, scene.poses), (position, r))
    return MovingInBodyFrame(rest, bodies, own, scene.search, scene.one)


@kernel
def _all_faces(
    world: MovingInBodyFrame, contact_point: Any, radius: float, arm: ArmPose
) -> ThreeFaces:
    part = part_of(world.still, contact_point, radius, arm)
    asked = WorldSearch(part, world.bodies, world.one)
    return call_routine(world.search, asked, no_moving_faces())


@kernel
def _own_face(obstacle: Obstacle, contact_point: Any, radius: float, arm: ArmPose) -> ContactFace:
    return with_motion(face_of(obstacle, contact_point, radius, arm), at_rest())


@contact_faces.register(MovingInBodyFrame)
@kernel
def _moving_contact_faces(
    world: MovingInBodyFrame, contact_point: Any, radius: float, arm: ArmPose, engaged: float
) -> tuple[ContactFace, ...]:
    found = no_moving_faces()
    if engaged > 0.0:
        found = _all_faces(world, contact_point, radius, arm)
    own = tree_map(_own_face, (world.own,), (contact_point, radius, arm))
    return (found.first, found.second, found.third) + own  # noqa: RUF005


@contacts_with.register(MovingInBodyFrame)
@kernel
def _moving_contacts(
    world: MovingInBodyFrame,
    faces: tuple[ContactFace, ...],
    engaged: tuple[float, ...],
    memory: PartMemory,
    arm: ArmPose,
    body: BodyMotion,
) -> tuple[CageContact, ...]:
    return contacts_in_scene(world.still, faces, engaged, memory, arm, body)


@touching_radius.register(MovingInBodyFrame)
@kernel
def _radius_among_moving(world: MovingInBodyFrame, radius: float, caged: float) -> float:
    return radius_in_scene(world, radius, caged)


@lowest_gap.register(MovingInBodyFrame)
@kernel
def _moving_gap(world: MovingInBodyFrame, contact_point: Any, radius: float, arm: ArmPose) -> float:
    found = _all_faces(world, contact_point, radius, arm)
    own = tree_map(cage_gap, (world.own,), (contact_point, radius, arm))
    return minimum((found.first.nearest.gap,) + own)  # noqa: RUF005


@per_face.register(MovingScene)
@kernel
def _per_face_of_scene(scene: MovingScene, value: float) -> tuple[float, ...]:
    return per_face(scene.still, value)


@per_face.register(MovingInBodyFrame)
@kernel
def _per_face_in_body_frame(world: MovingInBodyFrame, value: float) -> tuple[float, ...]:
    return (value, value, value) + per_face(world.own, value)  # noqa: RUF005


@moving_bodies.register(MovingScene)
@kernel
def _bodies_of_scene(scene: MovingScene) -> tuple[MovingBody, ...]:
    return scene.bodies


@kernel
def _motion_of(one: BodyInBodyFrame) -> FaceMotion:
    return one.motion


@moving_bodies.register(MovingInBodyFrame)
@kernel
def _motions_of_bodies(world: MovingInBodyFrame) -> tuple[FaceMotion, ...]:
    return tree_map(_motion_of, (world.bodies,), ())

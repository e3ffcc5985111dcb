"""A world in which some obstacles move, and the faces that a part of a vehicle meets there.

Whatever is at rest is one scene (`springback.contact.scene.faces`), and each moving obstacle is a
scene of its own, in its own axes.  A part of a vehicle is viewed from each in turn, and meets the
nearest faces of all of them together, as many as in a scene at rest.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.cage import (
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
)
from springback.contact.moving.bodies import ABSENT, BodyPose, MovingBody, body_pose
from springback.contact.obstacles import Obstacle, obstacle_in_body_frame
from springback.contact.scene.faces import (
    EXACT_BELOW,
    SceneInBodyFrame,
    SolidScene,
    ThreeFaces,
    VehiclePart,
    blank_part,
    no_faces,
    part_of,
    scene_faces,
)
from springback.kernels.compiler import kernel
from springback.kernels.routines import Routine, call_routine
from springback.kernels.trees import fold, minimum, tree_map
from springback.kernels.vectors import Mat3, Vec, norm
from springback.vehicle.state import ArmPose, BodyState

#: Number of what is at rest, as a body.
AT_REST = -1.0


class MovingScene(NamedTuple):
    """A world in which some obstacles move."""

    still: SolidScene  # all others
    bodies: tuple[MovingBody, ...]
    search: float  # address of `faces_of_body`


class PlacedScene(NamedTuple):
    """A world in which some obstacles move, at an instant."""

    still: SolidScene
    bodies: tuple[MovingBody, ...]
    poses: tuple[BodyPose, ...]
    search: float


class BodyInBodyFrame(NamedTuple):
    """A moving obstacle, viewed from a vehicle."""

    body: MovingBody
    position: Vec  # of the vehicle, in the obstacle's axes [m]
    r: Mat3  # body axes of the vehicle to the obstacle's axes
    motion: FaceMotion


class MovingInBodyFrame(NamedTuple):
    """A world in which some obstacles move, viewed from a vehicle."""

    still: SceneInBodyFrame
    bodies: tuple[BodyInBodyFrame, ...]
    own: tuple[Obstacle, ...]
    search: float


class Search(NamedTuple):
    """A part of a vehicle beside one obstacle, and the faces found so far."""

    part: VehiclePart
    motion: FaceMotion
    found: ThreeFaces


@kernel
def _at_rest() -> FaceMotion:
    none = Vec(0.0, 0.0, 0.0)
    return FaceMotion(none, none, AT_REST)


@kernel
def _moved(face: ContactFace, motion: FaceMotion) -> ContactFace:
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
    none, rest = no_faces(), _at_rest()
    return ThreeFaces(_moved(none.first, rest), _moved(none.second, rest), _moved(none.third, rest))


@kernel
def faces_of_body(s: Search) -> ThreeFaces:
    """The faces found so far, and those of one more obstacle that are nearer."""
    there = scene_faces(s.part)
    found = _inserted(s.found, _moved(there.first, s.motion))
    found = _inserted(found, _moved(there.second, s.motion))
    return _inserted(found, _moved(there.third, s.motion))


#: `faces_of_body`, compiled once for all vehicles and worlds.
MOVING_FACES = Routine(faces_of_body, Search(blank_part(), _at_rest(), no_moving_faces()))


def exactly(scene: SolidScene | MovingScene) -> SolidScene | MovingScene:
    """A world of which gaps are exact at any distance."""
    if isinstance(scene, MovingScene):
        return scene._replace(still=scene.still._replace(exact=1.0))
    return scene._replace(exact=1.0)


@obstacles_now.register(MovingScene)
@kernel
def _moving_now(scene: MovingScene, bodies: tuple[BodyState, ...]) -> PlacedScene:
    poses = tree_map(body_pose, (scene.bodies, bodies), ())
    return PlacedScene(scene.still, scene.bodies, poses, scene.search)


@kernel
def _body_in_body_frame(body: MovingBody, pose: BodyPose, position: Vec, r: Mat3) -> Any:
    away, turn = position - pose.position, pose.r
    columns = Mat3(
        Vec(turn.x.x, turn.y.x, turn.z.x),
        Vec(turn.x.y, turn.y.y, turn.z.y),
        Vec(turn.x.z, turn.y.z, turn.z.z),
    )
    # Velocity of the obstacle, were it so large, at the main body.
    velocity = (pose.velocity + (pose.spin ^ away)) @ r
    motion = FaceMotion(velocity, pose.spin @ r, body.number)
    return BodyInBodyFrame(body, away @ turn, columns @ r, motion)


@obstacles_in_body_frame.register(PlacedScene)
@kernel
def _placed_in_body_frame(scene: PlacedScene, position: Vec, r: Mat3) -> MovingInBodyFrame:
    still = scene.still
    own = tree_map(obstacle_in_body_frame, (still.own,), (position, r))
    rest = SceneInBodyFrame(still.table, still.query, (), position, r, still.exact)
    bodies = tree_map(_body_in_body_frame, (scene.bodies, scene.poses), (position, r))
    return MovingInBodyFrame(rest, bodies, own, scene.search)


@kernel
def _with_body(
    found: ThreeFaces,
    one: BodyInBodyFrame,
    world: MovingInBodyFrame,
    contact_point: Any,
    radius: float,
    arm: ArmPose,
) -> ThreeFaces:
    """Faces with those of a moving obstacle; one that is far gives a lower bound of its gap."""
    if one.body.kind == ABSENT:
        return found
    centre = one.position + one.r @ arm.lever
    away = norm(centre) - one.body.reach - radius
    if (away > EXACT_BELOW) & (world.still.exact == 0.0) & (away > found.first.nearest.gap):
        return found
    view = SceneInBodyFrame(
        one.body.scene, world.search, (), one.position, one.r, world.still.exact
    )
    part = part_of(view, contact_point, radius, arm)
    return call_routine(world.search, Search(part, one.motion, found), found)


@kernel
def _all_faces(
    world: MovingInBodyFrame, contact_point: Any, radius: float, arm: ArmPose
) -> ThreeFaces:
    part = part_of(world.still, contact_point, radius, arm)
    rest = Search(part, _at_rest(), no_moving_faces())
    found = call_routine(world.search, rest, no_moving_faces())
    return fold(_with_body, found, world.bodies, (world, contact_point, radius, arm))


@kernel
def _own_face(obstacle: Obstacle, contact_point: Any, radius: float, arm: ArmPose) -> ContactFace:
    return _moved(face_of(obstacle, contact_point, radius, arm), _at_rest())


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

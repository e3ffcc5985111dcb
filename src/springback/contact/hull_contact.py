"""Contact of hulls with obstacles: of the main body's, and of those at the ends of arms.

A sphere is the one body whose contact with any obstacle is exact: its gap is the signed distance of
its centre less its radius, and it touches on the normal through its centre.  It obeys the same laws
as a cage (`springback.contact.loads.face_contact`).  All other hulls, and several, are a
`CompoundHull`, which meets scenes (`springback.contact.hulls`).
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.cage import (
    BodyMotion,
    ContactFace,
    body_motion,
    contact_faces,
    lowest_gap,
    obstacles_in_body_frame,
    obstacles_now,
    per_face,
    touching_radius,
)
from springback.contact.hulls.faces import compound_faces, compound_flags, compound_gaps
from springback.contact.loads import CageContact, face_contact
from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import fold, minimum, one_tuple, tree_map
from springback.kernels.vectors import Vec
from springback.vehicle.arms.bent import BentArm, bent_pose
from springback.vehicle.arms.joints import JointedArm, joint_pose
from springback.vehicle.state import (
    Arm,
    ArmPose,
    CompoundHull,
    PartMemory,
    Shell,
    Sphere,
    State,
    arm_pose,
)


@generic
def hull_pose(hull: Any, velocity: Vec) -> ArmPose:
    """Pose of what a hull's levers begin at, as the end of an arm that does not slide.

    Args:
        hull: Of the main body.
        velocity: Rᵀ v, of the main body, body axes [m/s].
    """
    raise TypeError(f"{type(hull).__name__} is not a hull")


@hull_pose.register(Sphere)
@kernel
def _sphere_pose(hull: Sphere, velocity: Vec) -> ArmPose:
    return ArmPose(Vec(0.0, 0.0, 0.0), hull.centre, velocity)


@hull_pose.register(CompoundHull)
@kernel
def _compound_pose(hull: CompoundHull, velocity: Vec) -> ArmPose:
    none = Vec(0.0, 0.0, 0.0)
    return ArmPose(none, none, velocity)


@hull_pose.register(Shell)
@kernel
def _shell_pose(hull: Shell, velocity: Vec) -> ArmPose:
    return hull_pose(hull.touching, velocity)


@generic
def hull_gap(hull: Any, obstacles: Any) -> float:
    """Gap between the hull and the nearest obstacle in the body frame, or less if it is far [m]."""
    raise TypeError(f"{type(hull).__name__} is not a hull")


@hull_gap.register(Sphere)
@kernel
def _sphere_gap(hull: Sphere, obstacles: Any) -> float:
    return lowest_gap(obstacles, hull, hull.radius, hull_pose(hull, Vec(0.0, 0.0, 0.0)))


@hull_gap.register(CompoundHull)
@kernel
def _compound_gap(hull: CompoundHull, obstacles: Any) -> float:
    return minimum(compound_gaps(obstacles, hull, Vec(0.0, 0.0, 0.0)))


@hull_gap.register(Shell)
@kernel
def _shell_gap(hull: Shell, obstacles: Any) -> float:
    return hull_gap(hull.touching, obstacles)


@generic
def hull_faces(hull: Any, obstacles: Any, engaged: float) -> tuple[ContactFace, ...]:
    """The faces that the hull can meet, of obstacles in the body frame; see `contact_faces`."""
    raise TypeError(f"{type(hull).__name__} is not a hull")


@hull_faces.register(Sphere)
@kernel
def _sphere_faces(hull: Sphere, obstacles: Any, engaged: float) -> tuple[ContactFace, ...]:
    pose = hull_pose(hull, Vec(0.0, 0.0, 0.0))
    return contact_faces(obstacles, hull, hull.radius, pose, engaged)


@hull_faces.register(CompoundHull)
@kernel
def _compound_faces(hull: CompoundHull, obstacles: Any, engaged: float) -> tuple[ContactFace, ...]:
    return compound_faces(obstacles, hull, Vec(0.0, 0.0, 0.0), engaged)


@hull_faces.register(Shell)
@kernel
def _shell_faces(hull: Shell, obstacles: Any, engaged: float) -> tuple[ContactFace, ...]:
    return hull_faces(hull.touching, obstacles, engaged)


@generic
def hull_flags(hull: Any, obstacles: Any, value: float) -> tuple[float, ...]:
    """The same number for every face of `hull_faces`."""
    return per_face(obstacles, value)


@hull_flags.register(CompoundHull)
@kernel
def _compound_flags(hull: CompoundHull, obstacles: Any, value: float) -> tuple[float, ...]:
    return compound_flags(obstacles, value)


@hull_flags.register(Shell)
@kernel
def _shell_flags(hull: Shell, obstacles: Any, value: float) -> tuple[float, ...]:
    return hull_flags(hull.touching, obstacles, value)


@generic
def hull_gaps(hull: Any, obstacles: Any) -> tuple[float, ...]:
    """Gaps of a hull, as many as a cage has faces: the least for each shape of the user's own."""
    raise TypeError(f"{type(hull).__name__} is not a hull")


@kernel
def _gap_of(face: ContactFace) -> float:
    return face.nearest.gap


@hull_gaps.register(Sphere)
@kernel
def _sphere_gaps(hull: Sphere, obstacles: Any) -> tuple[float, ...]:
    return tree_map(_gap_of, (hull_faces(hull, obstacles, 1.0),), ())


@hull_gaps.register(CompoundHull)
@kernel
def _compound_gaps(hull: CompoundHull, obstacles: Any) -> tuple[float, ...]:
    return compound_gaps(obstacles, hull, Vec(0.0, 0.0, 0.0))


@hull_gaps.register(Shell)
@kernel
def _shell_gaps(hull: Shell, obstacles: Any) -> tuple[float, ...]:
    return hull_gaps(hull.touching, obstacles)


@kernel
def hull_contact(
    face: ContactFace,
    engaged: float,
    memory: PartMemory,
    hull: Any,
    body: BodyMotion,
) -> CageContact:
    """Contact of the hull with a face that it meets, eqs. (13)-(15).

    Args:
        face: In the body frame.
        engaged: As for `springback.contact.loads.face_contact`.
        memory: Of the hull.
        hull: Hull of the main body.
        body: Motion of the main body.
    """
    return face_contact(face, engaged, memory, hull_pose(hull, body.velocity), body)


# -- what an arm sees ------------------------------------------------------------------------------


class BodySight(NamedTuple):
    """A vehicle among obstacles at one instant."""

    there: Any  # the obstacles, in the world, where they are now
    obstacles: Any  # the same in the body frame
    body: BodyMotion


class ArmSight(NamedTuple):
    """An arm among obstacles, in the axes of what is at its end; points from the main body."""

    pose: ArmPose
    obstacles: Any
    body: BodyMotion  # as if the main body turned with it


@kernel
def body_sight(obstacles: Any, state: State, ahead: float) -> BodySight:
    """A vehicle among obstacles of the world; contacts look ``ahead`` [m]."""
    body = body_motion(state, ahead)
    there = obstacles_now(obstacles, state.bodies)
    return BodySight(there, obstacles_in_body_frame(there, state.position, body.r), body)


@generic
def arm_sight(arm: Any, length: Any, rate: Any, around: BodySight) -> ArmSight:
    """What an arm sees at a length [m] that changes at a rate [m/s]."""
    raise TypeError(f"{type(arm).__name__} is not an arm")


@arm_sight.register(Arm)
@kernel
def _of_slide(arm: Arm, length: float, rate: float, around: BodySight) -> ArmSight:
    """The axes at its end are those of the body."""
    pose = arm_pose(arm, length, rate, around.body.velocity)
    return ArmSight(pose, around.obstacles, around.body)


@arm_sight.register(JointedArm)
@kernel
def _of_joint(arm: JointedArm, length: float, rate: float, around: BodySight) -> ArmSight:
    """What is at the end of a hinged arm turns with it, by ω + κ l̇ a, about the main body.

    The velocity of the end without that of rotation is thus v + l̇ e − κ l̇ a × r.
    """
    there, body = joint_pose(arm, length, rate), around.body
    turn, spin = there.turn, there.turning * there.axis
    r = body.r @ turn
    slides = body.velocity + rate * there.direction - (spin ^ there.end)
    pose = ArmPose(there.direction @ turn, there.end @ turn, slides @ turn)
    turned = BodyMotion(
        body.position, r, body.velocity @ turn, (body.omega + spin) @ turn, body.vertical @ turn,
        body.ahead,
    )  # fmt: skip
    return ArmSight(pose, obstacles_in_body_frame(around.there, body.position, r), turned)


@arm_sight.register(BentArm)
@kernel
def _of_two_joints(arm: BentArm, length: Any, rate: Any, around: BodySight) -> ArmSight:
    """As of a hinged arm: what is at the end turns by the angular velocities of both joints."""
    there, body = bent_pose(arm, length, rate), around.body
    turn, spin = there.turn, there.spin
    r = body.r @ turn
    slides = body.velocity + there.velocity - (spin ^ there.end)
    pose = ArmPose(there.first @ turn, there.end @ turn, slides @ turn)
    turned = BodyMotion(
        body.position, r, body.velocity @ turn, (body.omega + spin) @ turn, body.vertical @ turn,
        body.ahead,
    )  # fmt: skip
    return ArmSight(pose, obstacles_in_body_frame(around.there, body.position, r), turned)


# -- arms ------------------------------------------------------------------------------------------


@kernel
def _faces_at_end(
    hull: CompoundHull, obstacles: Any, lever: Vec, engaged: float
) -> tuple[ContactFace, ...]:
    return compound_faces(obstacles, hull, lever, engaged)


@kernel
def arm_faces(
    arm: Arm, obstacles: Any, contact_point: Any, pose: ArmPose, engaged: float
) -> tuple[ContactFace, ...]:
    """The faces that an arm can meet: its cage, then its hulls; see `contact_faces`.

    Args:
        arm: Constants of the arm.
        obstacles: In the body frame.
        contact_point: `Ring` or `ArmTip`.
        pose: Pose of the arm.
        engaged: 0 where no force of theirs will act.
    """
    radius = touching_radius(obstacles, arm.cage_radius, arm.caged)
    cage = contact_faces(obstacles, contact_point, radius, pose, engaged)
    return cage + one_tuple(tree_map(_faces_at_end, (arm.hull,), (obstacles, pose.lever, engaged)))


@kernel
def _flags_at_end(hull: CompoundHull, obstacles: Any, value: float) -> tuple[float, ...]:
    return compound_flags(obstacles, value)


@kernel
def arm_flags(arm: Arm, obstacles: Any, value: float) -> tuple[float, ...]:
    """The same number for every face of `arm_faces`."""
    return per_face(obstacles, value) + one_tuple(
        tree_map(_flags_at_end, (arm.hull,), (obstacles, value))
    )


@kernel
def _nearer(so_far: float, hull: CompoundHull, obstacles: Any, lever: Vec) -> float:
    there = minimum(compound_gaps(obstacles, hull, lever))
    return there if there < so_far else so_far


@kernel
def arm_gap(arm: Arm, obstacles: Any, contact_point: Any, pose: ArmPose) -> float:
    """Gap between an arm and the nearest obstacle, or less if it is far [m].

    Arguments are as for `arm_faces`.
    """
    radius = touching_radius(obstacles, arm.cage_radius, arm.caged)
    cage = lowest_gap(obstacles, contact_point, radius, pose)
    return fold(_nearer, cage, arm.hull, (obstacles, pose.lever))


@kernel
def _lesser(a: float, b: float) -> float:
    return a if a < b else b


@kernel
def _with_gaps(
    so_far: tuple[float, ...], hull: CompoundHull, obstacles: Any, lever: Vec
) -> tuple[float, ...]:
    return tree_map(_lesser, (so_far, compound_gaps(obstacles, hull, lever)), ())


@kernel
def arm_gaps(arm: Arm, obstacles: Any, contact_point: Any, pose: ArmPose) -> tuple[float, ...]:
    """Gaps of an arm, as many as its cage has faces; see `hull_gaps`."""
    radius = touching_radius(obstacles, arm.cage_radius, arm.caged)
    faces = contact_faces(obstacles, contact_point, radius, pose, 1.0)
    gaps = tree_map(_gap_of, (faces,), ())
    return fold(_with_gaps, gaps, arm.hull, (obstacles, pose.lever))

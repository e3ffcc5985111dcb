"""Cages against obstacles: contact points, forces and their effect on the vehicle.

All vectors here are in body axes and all points are relative to the main body: a cage circle then
lies in the plane z = 0, and most products with its zeros drop out.  Obstacles are given in the same
frame (`springback.contact.obstacles.in_body_frame`).
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from springback.contact.obstacles import (
    Obstacle,
    Plane,
    SecondContact,
    obstacle_in_body_frame,
    outward_normal,
    signed_distance,
)
from springback.contact.rings import FAR, LowPoint, LowPoints, lowest_in_disc, lowest_on_ring
from springback.contact.surfaces import Surface
from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import minimum, tree_map
from springback.kernels.vectors import Mat3, Vec, norm, rotation
from springback.vehicle.state import ArmPose, BodyState, Propeller, Sphere, State

#: A gap closer to zero than this counts as zero [m].
LANDED = 1e-9
#: Radius of a circle that is no cage: nothing touches it [m].
NO_CAGE = -1.0
#: Depth of a cage that just touches: too small for any elastic force [m].
AT_TOUCH = 1e-30


class Ring(NamedTuple):
    """Contact at the support point of the tilted cage circle.

    The rounding acts on planes only: a cage that lies flat on one touches all around.
    """

    rounding: float  # tilt below which the support point moves to the centre of a flat cage [rad]


class ArmTip(NamedTuple):
    """The paper's contact point, eq. (13): the cage tip, projected on the normal."""

    unused: float


class Support(NamedTuple):
    """Contact point of a cage, relative to the end of its arm [m]."""

    point: Vec  # where the distance to the obstacle is measured
    normal_lever: Vec  # where the normal force acts
    friction_lever: Vec  # where friction acts
    inset: float  # added to the gap


@generic
def support(model: Any, inward: Vec, arm_direction: Vec, radius: float) -> Support:
    """Contact point of a cage circle of some radius [m] against a surface.

    Args:
        model: `Ring` or `ArmTip`.
        inward: Unit normal into the obstacle.
        arm_direction: e_j.
        radius: r_0 [m].
    """
    raise TypeError(f"{type(model).__name__} is not a contact point model")


@support.register(Ring)
@kernel
def _ring(ring: Ring, inward: Vec, arm_direction: Vec, radius: float) -> Support:
    """Support point r_0 t/√(t² + ε²) with t = n − (n·e_z) e_z.

    At ε = 0 this is the exact support point of the circle; ε only rounds the corner where a cage
    lies flat on the surface and touches all around.  With the inset, the penetration is
    n·p_j + r_0 √(t² + ε²); its rate is exactly the velocity of that point along n, so contact work
    is exact.
    """
    t, eps = Vec(inward.x, inward.y, 0.0), ring.rounding
    inverse = 1.0 / math.sqrt(t @ t + eps * eps)
    lever = t * inverse * radius
    return Support(lever, lever, lever, -eps * eps * inverse * radius)


@support.register(ArmTip)
@kernel
def _arm_tip(tip: ArmTip, inward: Vec, arm_direction: Vec, radius: float) -> Support:
    """Contact point of eq. (13), p_c = p_j + (r_0 e_j · n) n, generalised from e_X to any normal.

    Its generalised force is a normal force at the cage tip and friction at the arm's end.
    """
    lever = radius * arm_direction
    return Support((lever @ inward) * inward, lever, lever * 0.0, 0.0)


class BodyMotion(NamedTuple):
    """Motion of the main body at one instant, the same for all contacts; vectors in body axes."""

    position: Vec  # world axes [m]
    r: Mat3  # body axes to world axes
    velocity: Vec  # Rᵀ v [m/s]
    omega: Vec  # ω [rad/s]
    vertical: Vec  # Rᵀ e_Z
    ahead: float  # stiffness and damping hold for depths up to this much larger [m]


@kernel
def body_motion(state: State, ahead: float) -> BodyMotion:
    """Motion of the main body; contacts look ``ahead`` [m]."""
    r = rotation(state.attitude)
    return BodyMotion(
        position=state.position,
        r=r,
        velocity=state.velocity @ r,
        omega=state.angular_velocity,
        vertical=Vec(r.z.x, r.z.y, r.z.z),
        ahead=ahead,
    )


class FaceMotion(NamedTuple):
    """Motion of an obstacle, as a rigid body; vectors in body axes of the vehicle."""

    velocity: Vec  # of its point at the main body, were it as large [m/s]
    spin: Vec  # angular velocity [rad/s]
    body: float  # number of the moving obstacle, from 0; −1 for one at rest


class NearestFace(NamedTuple):
    """Point of a cage nearest to an obstacle."""

    gap: float  # positive apart, negative in penetration [m]
    inward: Vec  # unit normal into the obstacle
    at: Support
    steepness: float  # of the gap: its change by a motion of the point along the normal, up to 1
    saddle_inward: Vec  # into the obstacle at the saddle from which the gap counts; else zero
    saddle_lever: Vec  # where that is, from the end of the arm [m]


@kernel
def simple_face(gap: float, inward: Vec, at: Support) -> NearestFace:
    """Point of a cage nearest to an obstacle that is smooth there."""
    none = Vec(0.0, 0.0, 0.0)
    return NearestFace(gap, inward, at, 1.0, none, none)


@generic
def nearest_face(shape: Any, contact_point: Any, radius: float, arm: ArmPose) -> NearestFace:
    """Point of a cage nearest to a shape.

    Args:
        shape: In the body frame.
        contact_point: `Ring` or `ArmTip`.
        radius: r_0 [m].
        arm: Pose of the arm.
    """
    return nearest_faces(contact_point, shape, radius, arm).first


@nearest_face.register(Plane)
@kernel
def _plane_face(shape: Plane, contact_point: Any, radius: float, arm: ArmPose) -> NearestFace:
    return face_along_normal(shape, contact_point, radius, arm)


@nearest_face.register(SecondContact)
@kernel
def _second_face(
    shape: SecondContact, contact_point: Any, radius: float, arm: ArmPose
) -> NearestFace:
    return nearest_faces(contact_point, shape.shape, radius, arm).second


class NearestFaces(NamedTuple):
    """The two points of a cage nearest to a shape; `FAR` away if there is no second."""

    first: NearestFace
    second: NearestFace


@generic
def nearest_faces(contact_point: Any, shape: Any, radius: float, arm: ArmPose) -> NearestFaces:
    """The two points of a cage nearest to a shape that is not plane; see `nearest_face`."""
    raise TypeError(f"{type(contact_point).__name__} is not a contact point model")


@nearest_faces.register(Ring)
@kernel
def _ring_faces(model: Ring, shape: Any, radius: float, arm: ArmPose) -> NearestFaces:
    """The two lowest points of the ring, found by search; no rounding is needed."""
    found = lowest_on_ring(shape, arm.lever, radius, arm.direction)
    return NearestFaces(
        at_low_point(radius, found.first),
        at_second_point(radius, found),
    )


@kernel
def at_low_point(radius: float, low: LowPoint) -> NearestFace:
    """Face that a ring meets at one of its lowest points."""
    lever = Vec(radius * low.towards.x, radius * low.towards.y, 0.0)
    steepness = norm(low.normal)
    inward = low.normal * (-1.0 / steepness)
    none = Vec(0.0, 0.0, 0.0)
    return NearestFace(low.gap, inward, Support(lever, lever, lever, 0.0), steepness, none, none)


@kernel
def at_second_point(radius: float, low: LowPoints) -> NearestFace:
    """Face that a ring meets at its second lowest point, as deep as that is below the saddle."""
    face, saddle = at_low_point(radius, low.second), low.saddle
    if saddle.gap < 0.0:
        lever = Vec(radius * saddle.towards.x, radius * saddle.towards.y, 0.0)
        return NearestFace(
            min(face.gap - saddle.gap, 0.0), face.inward, face.at, face.steepness,
            -saddle.normal, lever,
        )  # fmt: skip
    return face


@nearest_faces.register(ArmTip)
@kernel
def _tip_faces(model: ArmTip, shape: Any, radius: float, arm: ArmPose) -> NearestFaces:
    """The single contact point of the paper."""
    there = face_along_normal(shape, model, radius, arm)
    return NearestFaces(there, simple_face(FAR, there.inward, there.at))


@support.register(Sphere)
@kernel
def _sphere(hull: Sphere, inward: Vec, arm_direction: Vec, radius: float) -> Support:
    lever = radius * inward
    return Support(lever, lever, lever, 0.0)


@nearest_faces.register(Sphere)
@kernel
def _sphere_faces(model: Sphere, shape: Any, radius: float, arm: ArmPose) -> NearestFaces:
    """The single point at which a sphere touches a shape."""
    inward = -outward_normal(shape, arm.lever)
    gap, at = signed_distance(shape, arm.lever) - radius, support(model, inward, inward, radius)
    return NearestFaces(simple_face(gap, inward, at), simple_face(FAR, inward, at))


@support.register(Propeller)
@kernel
def _disc(disc: Propeller, inward: Vec, arm_direction: Vec, radius: float) -> Support:
    """The point of the rim that is deepest in a plane."""
    aside = math.sqrt(inward.x * inward.x + inward.y * inward.y)
    scale = radius / aside if aside > 0.0 else 0.0
    at = Vec(scale * inward.x, scale * inward.y, 0.0)
    return Support(at, at, at, 0.0)


@nearest_faces.register(Propeller)
@kernel
def _disc_faces(model: Propeller, shape: Any, radius: float, arm: ArmPose) -> NearestFaces:
    """The least distance within a disc, which tells whether it is hit; no force is there."""
    inward, none = -outward_normal(shape, arm.lever), Vec(0.0, 0.0, 0.0)
    at = Support(none, none, none, 0.0)
    there = simple_face(lowest_in_disc(shape, arm.lever, radius), inward, at)
    return NearestFaces(there, there)


@kernel
def face_along_normal(shape: Any, contact_point: Any, radius: float, arm: ArmPose) -> NearestFace:
    """Gap by eq. (13), along the normal at the end of the arm.

    The normal of a plane is the same everywhere.  That of a signed distance is constant along
    itself, so the paper's contact point, which lies on it, needs no other.
    """
    n = -outward_normal(shape, arm.lever)
    at = support(contact_point, n, arm.direction, radius)
    return simple_face(signed_distance(shape, arm.lever + at.point) + at.inset, n, at)


@kernel
def cage_gap(obstacle: Obstacle, contact_point: Any, radius: float, arm: ArmPose) -> float:
    """Gap between a cage and an obstacle [m]; arguments as for `contact_faces`."""
    return nearest_face(obstacle.shape, contact_point, radius, arm).gap


class ContactFace(NamedTuple):
    """What a cage meets, or is next to: one obstacle, or one face of a scene."""

    nearest: NearestFace
    surface: Surface
    is_ground: float  # 1 if touching it counts as hitting the ground
    moving: tuple[FaceMotion, ...] = ()  # its motion; empty where no obstacle moves


@kernel
def face_of(obstacle: Obstacle, contact_point: Any, radius: float, arm: ArmPose) -> ContactFace:
    """The face of an obstacle that a cage meets; arguments as for `contact_faces`."""
    nearest = nearest_face(obstacle.shape, contact_point, radius, arm)
    return ContactFace(nearest, obstacle.surface, obstacle.is_ground, ())


@generic
def contact_faces(
    obstacles: Any, contact_point: Any, radius: float, arm: ArmPose, engaged: float
) -> tuple[ContactFace, ...]:
    """The faces that a cage can meet, as many at every instant.

    Args:
        obstacles: In the body frame, of any shape and orientation: a tuple of `Obstacle`, each of
            which is one face, or a scene (`springback.contact.scene.faces`).
        contact_point: `Ring` or `ArmTip`; a `Sphere` for a hull, a `Propeller` for its disc.
        radius: r_0 [m].
        arm: Pose of the arm.
        engaged: 0 where no force of theirs will act: a scene is then not looked through.
    """
    return tree_map(face_of, (obstacles,), (contact_point, radius, arm))


@generic
def touching_radius(obstacles: Any, radius: float, caged: float) -> float:
    """Radius of the circle that touches obstacles: of a cage; `NO_CAGE` of what is none [m].

    Only vehicles in a scene can be without cages.

    Args:
        obstacles: In the body frame.
        radius: r_0 [m].
        caged: 0 for a circle that is no cage.
    """
    return radius


@generic
def lowest_gap(obstacles: Any, contact_point: Any, radius: float, arm: ArmPose) -> float:
    """Gap between a cage and the nearest obstacle, or less if it is far from all [m].

    Arguments are as for `contact_faces`.
    """
    return minimum(tree_map(cage_gap, (obstacles,), (contact_point, radius, arm)))


@generic
def obstacles_now(obstacles: Any, bodies: tuple[BodyState, ...]) -> Any:
    """All obstacles at an instant: those that move are where the states of their bodies say."""
    return obstacles


@generic
def moving_bodies(obstacles: Any) -> tuple[Any, ...]:
    """The obstacles that move, of a world or of one in the body frame; mostly none."""
    return ()


@generic
def obstacles_in_body_frame(obstacles: Any, position: Vec, r: Mat3) -> Any:
    """All obstacles in the frame of a body; see `springback.contact.obstacles.in_body_frame`."""
    return tree_map(obstacle_in_body_frame, (obstacles,), (position, r))


@kernel
def _value_at(obstacle: Obstacle, value: float) -> float:
    return value


@generic
def per_face(obstacles: Any, value: float) -> tuple[float, ...]:
    """The same number for every face of `contact_faces`."""
    return tree_map(_value_at, (obstacles,), (value,))

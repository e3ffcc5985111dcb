"""Contact of the main body's hull with obstacles.

A sphere is the one body whose contact with any obstacle is exact: its gap is the signed distance of
its centre less its radius, and it touches on the normal through its centre.  It obeys the same laws
as a cage (`springback.contact.cage.cage_contact_while`).
"""

from __future__ import annotations

from typing import Any

from springback.contact.cage import (
    BodyMotion,
    CageContact,
    NearestFace,
    NearestFaces,
    Support,
    cage_contact_while,
    cage_gap,
    nearest_faces,
    support,
)
from springback.contact.obstacles import Obstacle, outward_normal, signed_distance
from springback.contact.rings import FAR
from springback.kernels.compiler import kernel
from springback.kernels.vectors import Vec
from springback.vehicle.state import ArmPose, Sphere


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
    return NearestFaces(NearestFace(gap, inward, at), NearestFace(FAR, inward, at))


@kernel
def _pose(hull: Sphere, velocity: Vec) -> ArmPose:
    """Pose of a sphere as the end of an arm that does not slide."""
    return ArmPose(Vec(0.0, 0.0, 0.0), hull.centre, velocity)


@kernel
def hull_apart(obstacle: Obstacle, hull: Sphere) -> float:
    """Gap between the hull and an obstacle in the body frame [m]."""
    return cage_gap(obstacle, hull, hull.radius, _pose(hull, Vec(0.0, 0.0, 0.0)))


@kernel
def hull_contact(
    obstacle: Obstacle,
    engaged: float,
    hull: Sphere,
    body: BodyMotion,
) -> CageContact:
    """Contact of the hull with one obstacle, eqs. (13)-(15).

    Args:
        obstacle: In the body frame.
        engaged: As for `springback.contact.cage.cage_contact_while`.
        hull: Hull of the main body.
        body: Motion of the main body.
    """
    pose = _pose(hull, body.velocity)
    return cage_contact_while(obstacle, engaged, hull, hull.radius, pose, body)

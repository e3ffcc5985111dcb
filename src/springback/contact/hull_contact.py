"""Contact of the main body's hull with obstacles.

A sphere is the one body whose contact with any obstacle is exact: its gap is the signed distance of
its centre less its radius, and it touches on the normal through its centre.  It obeys the same laws
as a cage (`springback.contact.cage.face_contact`).
"""

from __future__ import annotations

from typing import Any

from springback.contact.cage import (
    BodyMotion,
    CageContact,
    ContactFace,
    contact_faces,
    face_contact,
    lowest_gap,
)
from springback.kernels.compiler import kernel
from springback.kernels.vectors import Vec
from springback.vehicle.state import ArmPose, Sphere


@kernel
def _pose(hull: Sphere, velocity: Vec) -> ArmPose:
    """Pose of a sphere as the end of an arm that does not slide."""
    return ArmPose(Vec(0.0, 0.0, 0.0), hull.centre, velocity)


@kernel
def hull_gap(hull: Sphere, obstacles: Any) -> float:
    """Gap between the hull and the nearest obstacle in the body frame, or less if it is far [m]."""
    return lowest_gap(obstacles, hull, hull.radius, _pose(hull, Vec(0.0, 0.0, 0.0)))


@kernel
def hull_faces(hull: Sphere, obstacles: Any, engaged: float) -> tuple[ContactFace, ...]:
    """The faces that the hull can meet, of obstacles in the body frame; see `contact_faces`."""
    pose = _pose(hull, Vec(0.0, 0.0, 0.0))
    return contact_faces(obstacles, hull, hull.radius, pose, engaged)


@kernel
def hull_contact(face: ContactFace, engaged: float, hull: Sphere, body: BodyMotion) -> CageContact:
    """Contact of the hull with a face that it meets, eqs. (13)-(15).

    Args:
        face: In the body frame.
        engaged: As for `springback.contact.cage.face_contact`.
        hull: Hull of the main body.
        body: Motion of the main body.
    """
    return face_contact(face, engaged, _pose(hull, body.velocity), body)

"""Hulls of one part of a vehicle against a shape of the user's own, given by a kernel."""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.cage import (
    ContactFace,
    NearestFaces,
    Ring,
    face_along_normal,
    nearest_faces,
    simple_face,
)
from springback.contact.hulls.compound import in_body
from springback.contact.hulls.contacts import (
    HullContacts,
    HullFaces,
    HullPart,
    among,
    block_at,
    law_at,
    no_hull_faces,
    none_near,
    ring_axes,
    rounded_at,
    with_faces,
)
from springback.contact.hulls.edges import near_face
from springback.contact.hulls.rounded import with_rounded
from springback.contact.obstacles import (
    Obstacle,
    Plane,
    in_body_frame,
    outward_normal,
    signed_distance,
)
from springback.contact.rings import FAR
from springback.contact.scene.sections import Face, vector_at
from springback.kernels.compiler import generic, kernel, rare_kernel
from springback.kernels.routines import number_at
from springback.kernels.vectors import Mat3, Vec, transpose
from springback.vehicle.hulls import BLOCKS, CENTRE, CIRCLE, KIND, RADIUS, ROUNDED
from springback.vehicle.state import ArmPose, CompoundHull, Sphere


class ShapeView(NamedTuple):
    """A shape in the body frame, viewed from what hulls are fixed to."""

    shape: Any
    lever: Vec  # to there, from the main body [m]


@near_face.register(ShapeView)
@kernel
def _face_from_end(view: ShapeView, point: Vec) -> Face:
    there = view.lever + point
    return Face(signed_distance(view.shape, there), outward_normal(view.shape, there))


@generic
def round_faces(shape: Any, contact_point: Any, radius: float, arm: ArmPose) -> NearestFaces:
    """The points at which a ring or a sphere meets a shape, viewed from its centre.

    Arguments are as for `springback.contact.cage.nearest_face`.
    """
    return nearest_faces(contact_point, shape, radius, arm)


@round_faces.register(Plane)
@kernel
def _on_plane(shape: Plane, contact_point: Any, radius: float, arm: ArmPose) -> NearestFaces:
    first = face_along_normal(shape, contact_point, radius, arm)
    return NearestFaces(first, simple_face(FAR, first.inward, first.at))


@kernel
def _round_on_shape(
    shape: Any, hull: CompoundHull, block: int, lever: Vec, rounding: float
) -> NearestFaces:
    axes, centre = ring_axes(hull.table, block), vector_at(hull.table, block + CENTRE)
    view = in_body_frame(shape, lever + centre, transpose(axes))
    none, radius = Vec(0.0, 0.0, 0.0), number_at(hull.table, block + RADIUS)
    pose = ArmPose(Vec(1.0, 0.0, 0.0), none, none)
    if number_at(hull.table, block + KIND) == CIRCLE:
        return round_faces(view, Ring(rounding), radius, pose)
    return round_faces(view, Sphere(none, radius), radius, pose)


@rare_kernel
def own_hull_faces(
    obstacle: Obstacle, hull: CompoundHull, lever: Vec, rounding: float
) -> HullFaces:
    """The faces of a shape of the user's own that the hulls of a part meet.

    Args:
        obstacle: In the body frame.
        hull: All hulls of the part.
        lever: To what they are fixed to, from the main body, body axes [m].
        rounding: Of rings on planes [rad].
    """
    none, shape = Vec(0.0, 0.0, 0.0), obstacle.shape
    frame = Mat3(none, none, none)
    part = HullPart(0.0, hull.table, none, 0.0, lever, none, frame, 1.0, rounding, 0.0)
    found = HullContacts(
        no_hull_faces(), part, none_near(0.0), 0, obstacle.surface, obstacle.is_ground
    )  # fmt: skip
    for k in range(int(number_at(hull.table, BLOCKS))):
        block = block_at(hull.table, k)
        if number_at(hull.table, block + KIND) == ROUNDED:
            view = ShapeView(shape, lever)
            found = with_rounded(found, view, rounded_at(hull.table, block), False)
        else:
            met = _round_on_shape(shape, hull, block, lever, rounding)
            centre, axes = vector_at(hull.table, block + CENTRE), ring_axes(hull.table, block)
            law, faces = law_at(hull.table, block), found.faces
            first = ContactFace(met.first, obstacle.surface, obstacle.is_ground, ())
            faces = among(faces, in_body(first, centre, axes, law))
            if met.second.gap < FAR:
                second = ContactFace(met.second, obstacle.surface, obstacle.is_ground, ())
                faces = among(faces, in_body(second, centre, axes, law))
            found = with_faces(found, faces)
    return found.faces

"""The faces that all hulls of one part of a vehicle meet, found by a routine.

A rounded hull meets a shape as far as the shape is less than its radius away from what it is
around: corners, edges and faces.  Every corner is a contact.  An edge has one where the distance
from the shape is lowest inside it, a face likewise, and so the contacts of a hull on a solid that
is convex are:

* each corner, as deep as it is;
* the lowest point inside an edge, in place of the edge's deeper corner, if it is deeper;
* the lowest point inside a face, in place of the lowest point of its boundary, if it is deeper.

Who is replaced and who replaces share the force while their depths differ by about `SHARED`, so
that it does not jump from one to the other where a hull lies flat across an outward edge.  What is
replaced already, as a corner at which two edges are deeper inside, is not replaced again: the
second then counts from there.  Each depth is a function of the pose alone, whose force is nowhere
adhesive but in that last case.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from springback.contact.cage import LANDED, ContactFace, NearestFace, Support
from springback.contact.hulls.chords import corner_at
from springback.contact.hulls.contacts import (
    HullContacts,
    RoundedHull,
    among,
    holds,
    with_faces,
    without,
)
from springback.contact.hulls.edges import (
    EdgePoint,
    FlatFace,
    face_reach,
    is_parted,
    lowest_inside,
    lowest_on_face,
    near_face,
    no_point,
)
from springback.contact.hulls.series import HullLaw, in_series
from springback.contact.rings import FAR
from springback.contact.scene.faces import (
    is_exposed,
)
from springback.contact.scene.nearest import (
    MOST_NEAR,
    nearest_of,
)
from springback.contact.scene.sections import vector_at
from springback.contact.scene.solids import solid_face
from springback.kernels.compiler import kernel, rare_kernel
from springback.kernels.routines import number_at
from springback.kernels.vectors import Vec, larger, norm
from springback.vehicle.hulls import (
    FACE,
    FACES_AT,
    FACES_OF_HULL,
    POINT,
    POINTS,
    POINTS_AT,
)

#: Depths that differ by less share their force [m] (chosen: far below a depth of any contact, and
#: such that a robot that rests across an edge sways at less than 10 000 rad/s).
SHARED = 1e-7
#: Against division by zero where opposite faces are equally far.
LEAST_STEEP = 1e-12


@kernel
def at_point(low: EdgePoint, radius: float) -> NearestFace:
    """Face that a hull meets with a corner, or with the lowest point of an edge or a face."""
    steepness = larger(norm(low.normal), LEAST_STEEP)
    inward = low.normal * (-1.0 / steepness)
    lever = low.point + radius * inward
    none = Vec(0.0, 0.0, 0.0)
    at = Support(lever, lever, lever, 0.0)
    return NearestFace(low.gap - radius, inward, at, steepness, none, none)


@kernel
def deeper_than(low: EdgePoint, corner: EdgePoint, radius: float) -> NearestFace:
    """Face that a hull meets with a lowest point, as deep as it is below another one inside."""
    face = at_point(low, radius)
    above = corner.gap - radius
    if above < 0.0:
        return NearestFace(
            min(face.gap - above, 0.0), face.inward, face.at, face.steepness,
            -corner.normal, corner.point,
        )  # fmt: skip
    return face


@kernel
def in_place_of(low: EdgePoint, corner: EdgePoint, given: float, radius: float) -> NearestFace:
    """Face that a hull meets with the lowest point of an edge, in place of its deeper corner.

    With d, by how much the point is deeper, the depth is that of the corner and √(d² + ε²) − ε: the
    derivatives by both depths are positive and add up to 1.

    Args:
        low: The lowest point of an edge, or of a face.
        corner: The corner, or the lowest point of the face's boundary.
        given: Gap of the contact there [m].
        radius: Of the hull [m].
    """
    face = at_point(low, radius)
    more = corner.gap - low.gap
    root = math.sqrt(more * more + SHARED * SHARED)
    share = more / root
    gap = given - (root - SHARED)
    away = corner.normal * (1.0 - share)
    return NearestFace(gap, face.inward, face.at, face.steepness * share, away, corner.point)


@kernel
def _counts(found: HullContacts, point: Vec, gap: float) -> bool:
    """True unless a point is inside a solid that is nearer, and what it touches is hidden there."""
    near, row, part = found.near, found.row, found.part
    if (gap >= 0.0) | (near.number < 2) | (near.number > MOST_NEAR):
        return True
    there = part.position + part.r @ (part.lever + point)
    if nearest_of(near, there).row == row:
        return True
    face = solid_face(near.table, row, there)
    return is_exposed(near, row, there - face.gap * face.normal)


@kernel
def with_contact(
    found: HullContacts, law: HullLaw, nearest: NearestFace, point: Vec
) -> HullContacts:
    """Contacts with one more."""
    if nearest.gap >= found.faces.sixth.nearest.gap or not _counts(found, point, nearest.gap):
        return found
    new = ContactFace(nearest, in_series(found.surface, law), found.is_ground, ())
    return with_faces(found, among(found.faces, new))


@rare_kernel
def _corner(shape: Any, hull: RoundedHull, k: int) -> EdgePoint:
    point = corner_at(hull.table, hull.block, k)
    there = near_face(shape, point)
    return EdgePoint(point, there.gap, there.normal)


@kernel
def may_touch(found: HullContacts, gap: float) -> bool:
    """True if a gap is that of a contact, or less than all that were found."""
    lowest = found.faces.first.nearest.gap
    return gap < (lowest if lowest > 0.0 else 0.0)


@kernel
def _edges_at(
    found: HullContacts, shape: Any, hull: RoundedHull, k: int, corner: EdgePoint, is_convex: bool
) -> HullContacts:
    """Contacts with those of a corner, and of the edges of which it is the deeper end."""
    row = int(number_at(hull.table, hull.block + POINTS_AT)) + POINT * k
    listed, count = int(number_at(hull.table, row + 3)), int(number_at(hull.table, row + 4))
    best = no_point(corner.point)
    for j in range(count):
        other = int(number_at(hull.table, listed + j))
        end = _corner(shape, hull, other)
        is_deeper = (corner.gap < end.gap) | ((corner.gap == end.gap) & (k < other))
        bound = 0.5 * (corner.gap + end.gap - norm(end.point - corner.point)) - hull.radius
        if is_deeper and may_touch(found, bound):
            inside = lowest_inside(
                shape, corner.point, end.point, corner.normal, end.normal, is_convex
            )
            low = inside.first
            if inside.second.gap < FAR and is_parted(
                shape, low.point, inside.second.point, hull.radius
            ):
                found = with_contact(
                    found, hull.law, at_point(inside.second, hull.radius), inside.second.point
                )
            if low.gap < FAR:
                if not is_convex and is_parted(shape, low.point, corner.point, hull.radius):
                    found = with_contact(found, hull.law, at_point(low, hull.radius), low.point)
                elif low.gap < corner.gap:
                    lesser = low
                    if low.gap < best.gap:
                        lesser, best = best, low
                    if lesser.gap < FAR:
                        nearest = deeper_than(lesser, corner, hull.radius)
                        found = with_contact(found, hull.law, nearest, lesser.point)
    if best.gap < FAR:
        nearest = in_place_of(best, corner, corner.gap - hull.radius, hull.radius)
        return with_contact(found, hull.law, nearest, best.point)
    return with_contact(found, hull.law, at_point(corner, hull.radius), corner.point)


class BoundaryPoint(NamedTuple):
    """Lowest point of the boundary of a face, and the contact of a hull there."""

    low: EdgePoint
    contact: NearestFace


@kernel
def _lowest_on_boundary(
    shape: Any, hull: RoundedHull, listed: int, count: int, is_convex: bool
) -> BoundaryPoint:
    """Lowest point of the boundary of a face, by the same arithmetic as in `_edges_at`."""
    last = int(number_at(hull.table, listed + count - 1))
    before = _corner(shape, hull, last)
    best, deeper = before, before
    for k in range(count):
        number = int(number_at(hull.table, listed + k))
        here = _corner(shape, hull, number)
        if here.gap < best.gap:
            best, deeper = here, here
        bound = 0.5 * (before.gap + here.gap - norm(here.point - before.point))
        if bound < best.gap:
            first, second = before, here
            if (here.gap < before.gap) | ((here.gap == before.gap) & (number < last)):
                first, second = here, before
            low = lowest_inside(
                shape, first.point, second.point, first.normal, second.normal, is_convex
            ).first
            if low.gap < best.gap:
                best, deeper = low, first
        before, last = here, number
    if best.gap < deeper.gap and (
        is_convex or not is_parted(shape, best.point, deeper.point, hull.radius)
    ):
        given = deeper.gap - hull.radius
        return BoundaryPoint(best, in_place_of(best, deeper, given, hull.radius))
    return BoundaryPoint(best, at_point(best, hull.radius))


@kernel
def _face_of_hull(
    found: HullContacts, shape: Any, hull: RoundedHull, k: int, is_convex: bool
) -> HullContacts:
    """Contacts with that inside a flat face."""
    row = int(number_at(hull.table, hull.block + FACES_AT)) + FACE * k
    middle = vector_at(hull.table, row + 9)
    there = near_face(shape, middle).gap - hull.radius
    if not may_touch(found, there - face_reach(hull.table, row)):
        return found
    listed, count = (
        int(number_at(hull.table, row + FACE - 2)),
        int(number_at(hull.table, row + FACE - 1)),
    )
    boundary = _lowest_on_boundary(shape, hull, listed, count, is_convex)
    best = boundary.low
    inwards = middle - best.point
    if (best.normal @ inwards >= 0.0) & is_convex:
        return found
    x, y = vector_at(hull.table, row + 3), vector_at(hull.table, row + 6)
    flat = FlatFace(hull.table, row, x, y, middle)
    low = lowest_on_face(shape, flat, is_convex, no_point(middle))
    if not is_convex and low.gap < FAR and may_touch(found, low.gap - hull.radius):
        other = lowest_on_face(shape, flat, is_convex, low)
        if other.gap < low.gap:
            low, other = other, low
        from_first = other.gap < FAR and is_parted(shape, other.point, low.point, hull.radius)
        if from_first and is_parted(shape, other.point, best.point, hull.radius):
            found = with_contact(found, hull.law, at_point(other, hull.radius), other.point)
    if low.gap < best.gap - LANDED:
        if not is_convex and is_parted(shape, low.point, best.point, hull.radius):
            return with_contact(found, hull.law, at_point(low, hull.radius), low.point)
        if holds(found.faces, boundary.contact):
            found = with_faces(found, without(found.faces, boundary.contact))
            nearest = in_place_of(low, best, boundary.contact.gap, hull.radius)
            return with_contact(found, hull.law, nearest, low.point)
        return with_contact(found, hull.law, deeper_than(low, best, hull.radius), low.point)
    return found


@kernel
def with_rounded(
    found: HullContacts, shape: Any, hull: RoundedHull, is_convex: bool
) -> HullContacts:
    """Contacts with those of a rounded hull and a shape.

    Args:
        found: Contacts so far.
        shape: In the axes of the hull's points.
        hull: The hull.
        is_convex: True if the shape is.
    """
    for k in range(int(number_at(hull.table, hull.block + POINTS))):
        found = _edges_at(found, shape, hull, k, _corner(shape, hull, k), is_convex)
    for k in range(int(number_at(hull.table, hull.block + FACES_OF_HULL))):
        found = _face_of_hull(found, shape, hull, k, is_convex)
    return found

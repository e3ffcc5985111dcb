"""The faces that all hulls of one part of a vehicle meet in a scene, found by a routine."""

from __future__ import annotations

from typing import NamedTuple

from springback.contact.cage import ContactFace, NearestFace, Support, simple_face
from springback.contact.hulls.chords import corner_at
from springback.contact.hulls.contacts import (
    HullContacts,
    HullFaces,
    HullPart,
    RoundedHull,
    among,
    block_at,
    law_at,
    no_hull_faces,
    none_near,
    on_row,
    ring_axes,
    rounded_at,
    with_faces,
)
from springback.contact.hulls.edges import (
    EdgePoint,
    near_face,
)
from springback.contact.hulls.rounded import at_point, may_touch, with_contact, with_rounded
from springback.contact.hulls.series import HullLaw, in_series
from springback.contact.rings import FAR
from springback.contact.scene.faces import (
    EXACT_BELOW,
    RING,
    SPHERE,
    VehiclePart,
    no_face,
    no_faces,
    surface_at,
)
from springback.contact.scene.nearest import (
    HALF_SPACES,
    HEADER,
    MOST_NEAR,
    SOLIDS,
    NearestSolids,
    nearest_solid,
    row_of_near,
    solid_row,
    solids_within,
)
from springback.contact.scene.sections import FARTHEST, Face, vector_at
from springback.contact.scene.solids import (
    AXES,
    BOX,
    CAPSULE,
    CENTRE,
    FRUSTUM,
    GROUND,
    WIDTH,
    WINDOW,
    SolidForm,
    form_at,
    form_face,
    solid_face_within,
)
from springback.kernels.compiler import kernel, rare_kernel
from springback.kernels.routines import Routine, call_routine, number_at
from springback.kernels.vectors import Mat3, Vec
from springback.vehicle.hulls import (
    AROUND,
    CIRCLE,
    MIDDLE,
    POINTS,
    RADIUS,
    ROUNDED,
)
from springback.vehicle.hulls import CENTRE as HULL_CENTRE
from springback.vehicle.hulls import KIND as HULL_KIND
from springback.vehicle.state import ArmPose

#: Length by which pieces of a window's frame overlap [m] (chosen: deeper than contacts are).
OVERLAP = 0.01


class SolidView(NamedTuple):
    """A solid, viewed from what hulls are fixed to: points and normals in body axes."""

    form: SolidForm
    origin: Vec  # what they are fixed to, in the solid's axes [m]
    x: Vec  # body axes in the solid's axes
    y: Vec
    z: Vec


@near_face.register(SolidView)
@rare_kernel
def _seen_face(view: SolidView, point: Vec) -> Face:
    there = view.origin + view.x * point.x + view.y * point.y + view.z * point.z
    found = form_face(view.form, there, FARTHEST)
    n = found.normal
    return Face(found.gap, Vec(view.x @ n, view.y @ n, view.z @ n))


@kernel
def _seen_solid(part: HullPart, row: int) -> SolidView:
    table, r = part.table, part.r
    relative = part.position + r @ part.lever - vector_at(table, row + CENTRE)
    ex, ey = vector_at(table, row + AXES), vector_at(table, row + AXES + 3)
    ez = vector_at(table, row + AXES + 6)
    ax, ay, az = ex @ r, ey @ r, ez @ r  # the solid's axes in body axes
    return SolidView(
        form_at(table, row),
        Vec(ex @ relative, ey @ relative, ez @ relative),
        Vec(ax.x, ay.x, az.x),
        Vec(ax.y, ay.y, az.y),
        Vec(ax.z, ay.z, az.z),
    )


@kernel
def shape_is_convex(kind: float) -> bool:
    """True for kinds of solids with one lowest point along any straight edge."""
    return (kind == BOX) | (kind == CAPSULE) | (kind == FRUSTUM)


@kernel
def _on_half_spaces(found: HullContacts, hull: RoundedHull) -> HullContacts:
    """Contacts with those of all corners and half-spaces."""
    part = found.part
    table, r = part.table, part.r
    for j in range(int(number_at(table, HALF_SPACES))):
        row = HEADER + WIDTH * j
        normal = vector_at(table, row + AXES + 6)
        n = normal @ r
        away = part.position - vector_at(table, row + CENTRE)
        height = normal @ away + n @ part.lever
        found = on_row(found, none_near(table), row)
        for k in range(int(number_at(hull.table, hull.block + POINTS))):
            point = corner_at(hull.table, hull.block, k)
            low = EdgePoint(point, height + n @ point, n)
            found = with_contact(found, hull.law, at_point(low, hull.radius), point)
    return found


@kernel
def along_axes(axes: Mat3, v: Vec) -> Vec:
    """A vector along a ring's axes, which are rows, in body axes."""
    return axes.x * v.x + axes.y * v.y + axes.z * v.z


@kernel
def _round_part(part: HullPart, block: int, axes: Mat3) -> VehiclePart:
    """A sphere or a ring as a part of its own, viewed from its centre along its axes."""
    kind = RING if number_at(part.hulls, block + HULL_KIND) == CIRCLE else SPHERE
    centre = part.lever + vector_at(part.hulls, block + HULL_CENTRE)
    r = part.r
    x, y, z = r @ axes.x, r @ axes.y, r @ axes.z
    turned = Mat3(Vec(x.x, y.x, z.x), Vec(x.y, y.y, z.y), Vec(x.z, y.z, z.z))
    none = Vec(0.0, 0.0, 0.0)
    pose = ArmPose(Vec(1.0, 0.0, 0.0), none, none)
    return VehiclePart(
        part.table, kind, part.rounding, number_at(part.hulls, block + RADIUS), pose,
        part.position + r @ centre, turned, part.exact,
    )  # fmt: skip


@kernel
def in_body(face: ContactFace, centre: Vec, axes: Mat3, law: HullLaw) -> ContactFace:
    """A face that a sphere or a ring meets, viewed from what it is fixed to, in body axes."""
    seen, at = face.nearest, face.nearest.at
    nearest = NearestFace(
        seen.gap,
        along_axes(axes, seen.inward),
        Support(
            centre + along_axes(axes, at.point),
            centre + along_axes(axes, at.normal_lever),
            centre + along_axes(axes, at.friction_lever),
            at.inset,
        ),
        seen.steepness,
        along_axes(axes, seen.saddle_inward),
        centre + along_axes(axes, seen.saddle_lever),
    )
    return ContactFace(nearest, in_series(face.surface, law), face.is_ground, ())


@kernel
def _with_round(found: HullContacts, block: int) -> HullContacts:
    """Contacts with those of a sphere or a ring with all solids and half-spaces."""
    part, hulls = found.part, found.part.hulls
    axes = ring_axes(hulls, block)
    met = call_routine(part.query, _round_part(part, block, axes), no_faces())
    centre, law, faces = vector_at(hulls, block + HULL_CENTRE), law_at(hulls, block), found.faces
    if met.first.nearest.gap < FAR:
        faces = among(faces, in_body(met.first, centre, axes, law))
    if met.second.nearest.gap < FAR:
        faces = among(faces, in_body(met.second, centre, axes, law))
    if met.third.nearest.gap < FAR:
        faces = among(faces, in_body(met.third, centre, axes, law))
    return with_faces(found, faces)


@kernel
def _pieces(kind: float) -> int:
    """Number of convex pieces of a solid: four of a window's frame; others are whole."""
    return 4 if kind == WINDOW else 1


@kernel
def _piece(whole: SolidView, k: int) -> SolidView:
    """One piece of a window's frame, a box: the jambs, then what is below and above the opening.

    The latter reach a little into the jambs.  It has no height where the opening ends the frame.
    """
    s = whole.form
    if s.kind != WINDOW:
        return whole
    x, y, half_x, half_y = 0.0, 0.0, 0.5 * (s.a - s.d), s.b
    if k < 2:
        x = (0.5 if k == 0 else -0.5) * (s.a + s.d)
    else:
        half_x = s.d + (OVERLAP if s.a - s.d > OVERLAP else s.a - s.d)
        low, high = (-s.b, s.f - s.e) if k == 2 else (s.f + s.e, s.b)
        y, half_y = 0.5 * (low + high), 0.5 * (high - low)
    form = SolidForm(BOX, half_x, half_y, s.c, 0.0, 0.0, 0.0, s.rounding)
    return SolidView(form, whole.origin - Vec(x, y, 0.0), whole.x, whole.y, whole.z)


@kernel
def _on_solid(found: HullContacts, near: NearestSolids, row: int) -> HullContacts:
    """Contacts with those of all rounded hulls and one solid."""
    part, found = found.part, on_row(found, near, row)
    whole = _seen_solid(part, row)
    for i in range(_pieces(whole.form.kind)):
        view = _piece(whole, i)
        is_there = (whole.form.kind != WINDOW) | (view.form.b > 0.0)
        for k in range(int(number_at(part.hulls, 0)) if is_there else 0):
            block = block_at(part.hulls, k)
            if number_at(part.hulls, block + HULL_KIND) == ROUNDED:
                there = near_face(view, vector_at(part.hulls, block + MIDDLE)).gap
                if may_touch(found, there - number_at(part.hulls, block + AROUND)):
                    is_convex = shape_is_convex(view.form.kind)
                    found = with_rounded(found, view, rounded_at(part.hulls, block), is_convex)
    return found


@kernel
def _far_face(part: HullPart, row: int, gap: float, normal: Vec) -> ContactFace:
    """Face that a sphere around all hulls would meet."""
    n = normal @ part.r
    lever = part.middle - part.radius * n
    nearest = simple_face(gap, -n, Support(lever, lever, lever, 0.0))
    ground = number_at(part.table, row + GROUND)
    return ContactFace(nearest, surface_at(part.table, row), ground, ())


@kernel
def scene_hull_faces(part: HullPart) -> HullFaces:
    """The faces that the hulls of a part meet, or are next to, in body axes."""
    table = part.table
    none = no_face()
    found = HullContacts(no_hull_faces(), part, none_near(table), 0, none.surface, 0.0)
    has_rounded = False
    for k in range(int(number_at(part.hulls, 0))):
        block = block_at(part.hulls, k)
        if number_at(part.hulls, block + HULL_KIND) == ROUNDED:
            found = _on_half_spaces(found, rounded_at(part.hulls, block))
            has_rounded = True
        else:
            found = _with_round(found, block)
    if has_rounded and number_at(table, SOLIDS) > 0.0:
        middle = part.position + part.r @ (part.lever + part.middle)
        within = part.radius + EXACT_BELOW if part.exact == 0.0 else FARTHEST
        nearest = nearest_solid(table, middle, within)
        if (part.exact == 0.0) & (nearest.gap >= within):
            normal = solid_face_within(table, nearest.row, middle, within).normal
            return among(
                found.faces, _far_face(part, nearest.row, nearest.gap - part.radius, normal)
            )
        near = solids_within(table, middle, nearest, 2.0 * part.radius)
        many = near.number > MOST_NEAR
        for k in range(int(number_at(table, SOLIDS)) if many else near.number):
            row = solid_row(table, k) if many else row_of_near(near, k)
            found = _on_solid(found, near, row)
    return found.faces


def _blank_part() -> HullPart:
    none = Vec(0.0, 0.0, 0.0)
    frame = Mat3(none, none, none)
    return HullPart(0.0, 0.0, none, 0.0, none, none, frame, 0.0, 0.0, 0.0)


#: `scene_hull_faces`, compiled once for all vehicles and worlds.
SCENE_HULL_FACES = Routine(scene_hull_faces, _blank_part())

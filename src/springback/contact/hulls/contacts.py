"""The deepest faces of several hulls, and what is read from the table of hulls."""

from __future__ import annotations

from typing import NamedTuple

from springback.contact.cage import ContactFace, NearestFace
from springback.contact.hulls.series import HullLaw
from springback.contact.scene.faces import (
    no_face,
    surface_at,
)
from springback.contact.scene.nearest import (
    NearestSolids,
)
from springback.contact.scene.sections import vector_at
from springback.contact.scene.solids import GROUND
from springback.contact.surfaces import Hysteresis, Surface
from springback.kernels.compiler import kernel
from springback.kernels.routines import number_at
from springback.kernels.vectors import Mat3, Vec
from springback.vehicle.hulls import AXES as HULL_AXES
from springback.vehicle.hulls import (
    RADIUS,
)
from springback.vehicle.hulls import SURFACE as HULL_SURFACE


class HullPart(NamedTuple):
    """The hulls of the main body, or of an arm, for which faces are looked for."""

    table: float  # of the scene
    hulls: float  # their table
    middle: Vec  # of a sphere around them, from what they are fixed to, body axes [m]
    radius: float  # of that sphere [m]
    lever: Vec  # to what they are fixed to, from the main body, body axes [m]
    position: Vec  # of the main body, world [m]
    r: Mat3  # body axes to world axes
    exact: float  # 0: gaps above `EXACT_BELOW` may be lower bounds
    rounding: float  # of a ring [rad]
    query: float  # address of `springback.contact.scene.faces.scene_faces`


class HullFaces(NamedTuple):
    """The faces that all hulls of one part meet at the same time, the deepest first.

    A box that lies on its side has four (chosen: two more than that).
    """

    first: ContactFace
    second: ContactFace
    third: ContactFace
    fourth: ContactFace
    fifth: ContactFace
    sixth: ContactFace


@kernel
def no_hull_faces() -> HullFaces:
    """No face within reach."""
    none = no_face()
    return HullFaces(none, none, none, none, none, none)


@kernel
def among(f: HullFaces, new: ContactFace) -> HullFaces:
    """Faces with one more, if it is deeper than the last of them."""
    gap = new.nearest.gap
    if gap >= f.sixth.nearest.gap:
        return f
    if gap >= f.fifth.nearest.gap:
        return HullFaces(f.first, f.second, f.third, f.fourth, f.fifth, new)
    if gap >= f.fourth.nearest.gap:
        return HullFaces(f.first, f.second, f.third, f.fourth, new, f.fifth)
    if gap >= f.third.nearest.gap:
        return HullFaces(f.first, f.second, f.third, new, f.fourth, f.fifth)
    if gap >= f.second.nearest.gap:
        return HullFaces(f.first, f.second, new, f.third, f.fourth, f.fifth)
    if gap >= f.first.nearest.gap:
        return HullFaces(f.first, new, f.second, f.third, f.fourth, f.fifth)
    return HullFaces(new, f.first, f.second, f.third, f.fourth, f.fifth)


@kernel
def _is_same(one: NearestFace, other: NearestFace) -> bool:
    """True for one contact, twice."""
    a, b = one.at.point, other.at.point
    return (one.gap == other.gap) & (a.x == b.x) & (a.y == b.y) & (a.z == b.z)


@kernel
def holds(f: HullFaces, contact: NearestFace) -> bool:
    """True if a contact is among the faces."""
    return (
        _is_same(f.first.nearest, contact)
        | _is_same(f.second.nearest, contact)
        | _is_same(f.third.nearest, contact)
        | _is_same(f.fourth.nearest, contact)
        | _is_same(f.fifth.nearest, contact)
        | _is_same(f.sixth.nearest, contact)
    )


@kernel
def without(f: HullFaces, contact: NearestFace) -> HullFaces:
    """Faces without one that is among them."""
    none = no_face()
    if _is_same(f.first.nearest, contact):
        return HullFaces(f.second, f.third, f.fourth, f.fifth, f.sixth, none)
    if _is_same(f.second.nearest, contact):
        return HullFaces(f.first, f.third, f.fourth, f.fifth, f.sixth, none)
    if _is_same(f.third.nearest, contact):
        return HullFaces(f.first, f.second, f.fourth, f.fifth, f.sixth, none)
    if _is_same(f.fourth.nearest, contact):
        return HullFaces(f.first, f.second, f.third, f.fifth, f.sixth, none)
    if _is_same(f.fifth.nearest, contact):
        return HullFaces(f.first, f.second, f.third, f.fourth, f.sixth, none)
    return HullFaces(f.first, f.second, f.third, f.fourth, f.fifth, none)


class RoundedHull(NamedTuple):
    """A hull around some points."""

    table: float  # of the hulls
    block: int  # position of its numbers
    radius: float  # [m]
    law: HullLaw


@kernel
def block_at(hulls: float, k: int) -> int:
    """Position of the numbers of a hull in a table."""
    return int(number_at(hulls, 1 + k))


@kernel
def law_at(hulls: float, block: int) -> HullLaw:
    """Surface of the hull whose numbers begin at a position of a table."""
    k = block + HULL_SURFACE
    return HullLaw(
        number_at(hulls, k), number_at(hulls, k + 1), number_at(hulls, k + 2),
        number_at(hulls, k + 3), number_at(hulls, k + 4), number_at(hulls, k + 5),
        Hysteresis(number_at(hulls, k + 6), number_at(hulls, k + 7), number_at(hulls, k + 8)),
        number_at(hulls, k + 9),
    )  # fmt: skip


@kernel
def ring_axes(hulls: float, block: int) -> Mat3:
    """Axes of a ring, one a row, in body axes."""
    k = block + HULL_AXES
    return Mat3(vector_at(hulls, k), vector_at(hulls, k + 3), vector_at(hulls, k + 6))


@kernel
def rounded_at(hulls: float, block: int) -> RoundedHull:
    """The rounded hull whose numbers begin at a position of a table."""
    radius = number_at(hulls, block + RADIUS)
    return RoundedHull(hulls, block, radius, law_at(hulls, block))


class HullContacts(NamedTuple):
    """Contacts of a hull with one shape, on their way into the faces of its part."""

    faces: HullFaces
    part: HullPart
    near: NearestSolids  # those around; none for a shape that is not among them
    row: int  # of the solid
    surface: Surface  # of the shape
    is_ground: float


@kernel
def with_faces(found: HullContacts, faces: HullFaces) -> HullContacts:
    """The same with other faces."""
    return HullContacts(
        faces, found.part, found.near, found.row, found.surface, found.is_ground
    )  # fmt: skip


@kernel
def on_row(found: HullContacts, near: NearestSolids, row: int) -> HullContacts:
    """The same for the solid whose numbers begin at a position of the scene's table."""
    table = found.part.table
    return HullContacts(
        found.faces, found.part, near, row, surface_at(table, row), number_at(table, row + GROUND)
    )


@kernel
def none_near(table: float) -> NearestSolids:
    """No solids near."""
    return NearestSolids(table, 0, 0, 0)

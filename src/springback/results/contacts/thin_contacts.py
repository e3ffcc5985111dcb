"""Contacts that came deeper than forces hold where they were, or met an edge of a mesh."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple, cast

import numpy as np

from springback.contact.grids.distance_grids import ROUNDED
from springback.contact.grids.measured_shapes import GridShape, MeshBody
from springback.contact.moving.scene import MovingScene
from springback.contact.scene.nearest import nearest_solid
from springback.contact.scene.sections import FARTHEST, Face
from springback.contact.scene.solids import solid_face
from springback.contact.thin_obstacles import PIERCED, SHALLOW, ThinObstacle
from springback.contact.worlds import BuiltIn, alone
from springback.kernels.routines import routines_compiled
from springback.kernels.vectors import Vec
from springback.results.contacts.places import ContactPlace, contact_places
from springback.results.contacts.spans import ContactSpan, contact_spans
from springback.results.result import FlightResult

#: Hardest contacts that are looked at; instants of each, as shares of the time from the largest
#: force to its end: the deepest comes after that (chosen).
MOST, LATER = 30, (0.0, 0.2, 0.4, 0.6)
#: Length of the gradient of a mesh's distance below which forces are told to be too weak (chosen).
WEAK = 0.9
#: Least step through a body, as a share of the depth of the contact (chosen).
STEP = 0.05


class _Inside(NamedTuple):
    """A point of a contact within an obstacle."""

    table: float  # of the obstacle alone
    point: Vec  # world [m]
    face: Face  # of the nearest solid there

    @property
    def depth(self) -> float:
        """Below the surface [m]."""
        return -self.face.gap

    @property
    def steepness(self) -> float:
        """Length of the gradient of the distance: 1, if it is exact."""
        return float(np.linalg.norm(self.face.normal))

    def is_thinner(self, thickness: float) -> bool:
        """True if the other side is nearer, straight in, than a thickness [m]."""
        inward = self.face.normal * (-1.0 / self.steepness)
        gone, gap = self.depth, self.face.gap
        while gone < thickness and gap < 0.0:
            gone += max(-gap, STEP * self.depth)
            gap = nearest_solid(self.table, self.point + inward * (gone - self.depth), FARTHEST).gap
        return gap >= 0.0 and gone < thickness


def _met(
    one: ThinObstacle, spans: Iterable[tuple[ContactSpan, ContactPlace]]
) -> Iterator[tuple[ContactSpan, _Inside]]:
    """Contacts within an obstacle at rest."""
    scene = alone(cast(BuiltIn, one.shape), 0)
    assert not isinstance(scene, MovingScene)
    for span, place in spans:
        if place.point is None:
            continue
        point = Vec(*place.point)
        nearest = nearest_solid(scene.table, point, FARTHEST)
        if nearest.row >= 0 and nearest.gap < 0.0:
            yield span, _Inside(scene.table, point, solid_face(scene.table, nearest.row, point))


def _is_pierced(one: ThinObstacle, there: _Inside) -> bool:
    """True if a contact may reach the other side where it is, or no force there holds."""
    if not one.is_pierced(there.depth):
        return False
    beyond = ROUNDED * one.part.form().cell if isinstance(one.part, GridShape) else 0.0
    return there.is_thinner(2.0 * (there.depth / PIERCED + beyond))


def _weak(one: ThinObstacle, met: Iterable[tuple[ContactSpan, _Inside]]) -> str:
    """Warning of contacts near an edge of a mesh, where its forces are too weak; else empty."""
    if not isinstance(one.part, MeshBody):
        return ""
    cell = one.part.form().cell
    for span, there in met:
        if there.depth > SHALLOW * cell and there.steepness < WEAK:
            short = 100.0 * (1.0 - there.steepness)
            return (
                f"the contact of {span.name} at {span.hardest_time:.4g} s came "
                f"{1e3 * there.depth:.3g} mm deep where two sides of {one.name} with cells of "
                f"{1e3 * cell:.3g} mm, are about as near, at an edge or in its middle: forces "
                f"there are some {short:.0f} % or more too weak; make it of boxes, or give it "
                "smaller cells (cell)"
            )
    return ""


def deep_contact(flight: FlightResult, thin: Iterable[ThinObstacle]) -> str:
    """Warning of the first obstacle whose forces do not hold where it was touched; else empty.

    Args:
        flight: With its trajectory, and `ShapeSettings` that may be too thin for its depths.
        thin: Those, each with the depth to which forces on it hold.
    """
    hardest = sorted(contact_spans(flight), key=lambda one: -one.force)[:MOST]
    spans = [one for span in hardest for one in _later(span)]
    known = [
        (span, place)
        for span, place in zip(spans, contact_places(flight, spans), strict=True)
        if place is not None
    ]
    deepest = flight.measures.get("penetration") or 0.0
    for one in thin:
        path = one.name.partition("]")[0] + "]"
        if not known or one.shape.motion is not None:
            touched = [place for _, place in known if place.obstacle.startswith(path)]
            if one.is_pierced(deepest) and (touched or not known):
                return one.warning(deepest)
            continue
        with routines_compiled():
            met = list(_met(one, known))
            for _, there in met:
                if _is_pierced(one, there):
                    return one.warning(there.depth)
        if weak := _weak(one, met):
            return weak
    return ""


def _later(span: ContactSpan) -> Iterator[ContactSpan]:
    """A contact at its largest force and at some instants after it."""
    for row in sorted({span.hardest + int(x * (span.last - span.hardest)) for x in LATER}):
        yield span._replace(hardest=row)

"""Contacts that came deeper than forces hold where they were, or met an edge of a mesh."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from springback.contact.grids.distance_grids import ROUNDED
from springback.contact.grids.measured_shapes import GridShape, MeshBody
from springback.contact.thin_obstacles import PIERCED, SHALLOW, ThinObstacle
from springback.kernels.routines import routines_compiled
from springback.results.contacts.edge_crossings import edge_crossing
from springback.results.contacts.places import ContactPlace, contact_places
from springback.results.contacts.solid_points import (
    SolidPoint,
    is_ball,
    solid_point,
    table_of,
)
from springback.results.contacts.spans import ContactSpan, contact_spans
from springback.results.result import FlightResult
from springback.scenario.worlds.mesh_check import smaller_cells

#: Hardest contacts that are looked at; instants of each, as shares of the time from the largest
#: force to its end: the deepest comes after that (chosen).
MOST, LATER = 30, (0.0, 0.2, 0.4, 0.6)
#: Difference from 1 of the length of the gradient of a mesh's distance from which forces are told
#: to be wrong (chosen).
WRONG = 0.1


def _met(
    one: ThinObstacle, spans: Iterable[tuple[ContactSpan, ContactPlace]]
) -> Iterator[tuple[ContactSpan, SolidPoint]]:
    """Contacts within an obstacle at rest."""
    table = table_of(one.shape)
    for span, place in spans:
        if place.point is not None and (there := solid_point(table, place.point)) is not None:
            yield span, there


def _is_pierced(one: ThinObstacle, there: SolidPoint, *, aside: bool) -> bool:
    """True if a contact may reach another side where it is, or no force there holds."""
    if not one.is_pierced(there.depth):
        return False
    beyond = ROUNDED * one.part.form().cell if isinstance(one.part, GridShape) else 0.0
    return there.is_thinner(2.0 * (there.depth / PIERCED + beyond), aside=aside)


def _too_deep(one: ThinObstacle, depth: float) -> str:
    """Sentence on a contact that came too deep [m]: of a mesh at more length."""
    if not isinstance(one.part, MeshBody) or not one.depth > 0.0:
        return one.warning(depth)
    return (
        f"a contact came {1e3 * depth:.3g} mm deep, and forces on the thinnest parts of {one.name} "
        f"with cells of {1e3 * one.part.form().cell:.3g} mm, hold to some {1e3 * one.depth:.3g} "
        "mm: beyond that they are wrong, mostly too weak, and deeper still it is pushed out on "
        f"another side; make it thicker or stiffer, or {smaller_cells(one.part)}; what follows is "
        "not to be trusted"
    )


def _wrong(one: ThinObstacle, met: Iterable[tuple[ContactSpan, SolidPoint]]) -> str:
    """Warning of contacts near an edge of a mesh, where its forces are wrong; else empty."""
    if not isinstance(one.part, MeshBody):
        return ""
    cell = one.part.form().cell
    for span, there in met:
        wrong = there.steepness - 1.0
        if there.depth > SHALLOW * cell and abs(wrong) > WRONG:
            return (
                f"the contact of {span.name} at {span.hardest_time:.4g} s came "
                f"{1e3 * there.depth:.3g} mm deep where two sides of {one.name} with cells of "
                f"{1e3 * cell:.3g} mm, are about as near, at an edge or in its middle: forces "
                f"there are some {100.0 * abs(wrong):.0f} % too {'strong' if wrong > 0 else 'weak'}"
                f", by the slope of its distance; make it of boxes, or {smaller_cells(one.part)}"
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
            for span, there in sorted(met, key=lambda pair: -pair[1].depth):
                if _is_pierced(one, there, aside=not is_ball(flight, span)):
                    return _too_deep(one, there.depth)
        if wrong := _wrong(one, met):
            return wrong
    return edge_crossing(flight, hardest)


def _later(span: ContactSpan) -> Iterator[ContactSpan]:
    """A contact at its largest force and at some instants after it."""
    for row in sorted({span.hardest + int(x * (span.last - span.hardest)) for x in LATER}):
        yield span._replace(hardest=row)

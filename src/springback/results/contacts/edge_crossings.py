"""Contacts that left the face that they met over an edge of it, instead of back.

A solid pushes out what is in it through its nearest face.  What comes as deep as it is beside an
edge is as near to the next face: the force turns there, from one step to the next.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from springback.contact.shapes import ShapeSettings
from springback.contact.unions import ShapeUnion
from springback.kernels.routines import routines_compiled
from springback.results.contacts.places import contact_places
from springback.results.contacts.solid_points import (
    SolidPoint,
    is_ball,
    solid_point,
    table_of,
)
from springback.results.contacts.spans import ContactSpan, parts_of
from springback.results.result import FlightResult
from springback.scenario.worlds.imported import Imported, obstacle_words, part_words

#: Hardest contacts that are looked at, and instants of each (chosen).
MOST, ROWS = 6, 16
#: Share of the largest force from which a face is held to be the one that was met (chosen).
MET = 0.5
#: Angle between the forces of two faces [rad] (chosen: at a corner both turn gradually).
TURNED = math.radians(60.0)
#: Distance of the next face, in depths, from which a contact is one with a face, and not with the
#: edge (chosen).
BESIDE = 1.2
#: The same up to which it left over the edge of that face (chosen).
NEAR = 2.0
#: Difference of the length of a normal from 1 by rounding: forms in files have no faces.
EXACT = 1e-6


class _Pressed(NamedTuple):
    """A contact at a row of the trajectory."""

    row: int
    force: float  # normal force [N]
    there: SolidPoint

    def is_turned(self, other: _Pressed) -> bool:
        """True if the force points elsewhere than that of another one."""
        return self.there.face.normal @ other.there.face.normal < math.cos(TURNED)

    def as_near(self, other: _Pressed, share: float) -> bool:
        """True if the face of another one is nearer than some depths of this."""
        most = share * self.there.depth
        return self.there.way(other.there.face.normal, most) < most


class _Contact(NamedTuple):
    """A contact with an obstacle at rest."""

    flight: FlightResult
    span: ContactSpan
    name: str
    table: float

    def at_rows(self, rows: Sequence[int]) -> Iterator[_Pressed]:
        """It at some rows, where its point is within the obstacle and has a face."""
        column = "fn" + parts_of(self.flight.columns)[self.span.part]
        places = contact_places(self.flight, [self.span._replace(hardest=row) for row in rows])
        for row, place in zip(rows, places, strict=True):
            if place is None or place.point is None or place.obstacle != self.name:
                continue
            with routines_compiled():
                there = solid_point(self.table, place.point)
                if there is not None and abs(there.steepness - 1.0) < EXACT:
                    yield _Pressed(row, float(self.flight.columns[column][row]), there)

    def crossing(self) -> tuple[_Pressed, _Pressed] | None:
        """It before and after its force turned at an edge, if it did."""
        first, last, hardest = self.span.first, self.span.last, self.span.hardest
        rows = sorted({hardest, *np.linspace(first, last, ROWS).astype(int).tolist()})
        each = list(self.at_rows(rows))
        with routines_compiled():
            pairs = [
                (one, other)
                for k, one in enumerate(each)
                if one.force >= MET * self.span.force
                for other in each[k + 1 :]
                if other.is_turned(one) and not one.as_near(other, BESIDE)
            ]
        return self._between(*pairs[0]) if pairs else None

    def _between(self, one: _Pressed, other: _Pressed) -> tuple[_Pressed, _Pressed] | None:
        """The last row before the force turned and the first after it, if it did so at once."""
        before, after = one, other
        while after.row - before.row > 1:
            found = list(self.at_rows([(before.row + after.row) // 2]))
            if not found:
                return None
            before, after = (before, found[0]) if found[0].is_turned(one) else (found[0], after)
        with routines_compiled():
            at_once = after.is_turned(before) and after.as_near(before, NEAR)
        return (before, after) if at_once else None


def _at_rest(flight: FlightResult) -> Iterator[tuple[str, ShapeSettings]]:
    """Shapes at rest with their names, as of the places of contacts."""
    for k, entry in enumerate(flight.scenario.world.obstacles):
        if isinstance(entry, Imported):
            for part in entry.parts:
                if isinstance(part.obstacle, ShapeSettings):
                    yield part_words(k, entry, part), part.obstacle
        elif isinstance(entry, ShapeSettings) and entry.motion is None:
            yield obstacle_words(k, entry), entry


def _rounding(shape: ShapeSettings) -> float:
    """Largest radius of edges [m]."""
    parts = shape.shapes if isinstance(shape, ShapeUnion) else (shape,)
    return max(float(getattr(one, "edge_radius", 0.0)) for one in parts)


def edge_crossing(flight: FlightResult, hardest: Sequence[ContactSpan]) -> str:
    """Warning of the hardest contact that was pushed out over an edge; else empty.

    Args:
        flight: With its trajectory.
        hardest: Its contacts, the hardest first; balls, whose middle counts, go round edges.
    """
    spans = [one for one in hardest if not is_ball(flight, one)][:MOST]
    shapes = dict(_at_rest(flight)) if spans else {}
    for span, place in zip(spans, contact_places(flight, spans), strict=True):
        shape = shapes.get(place.obstacle) if place is not None else None
        if place is None or shape is None:
            continue
        turned = _Contact(flight, span, place.obstacle, table_of(shape)).crossing()
        if turned is None or turned[0].there.depth <= _rounding(shape):
            continue
        before, after = turned
        return (
            f"the contact of {span.name} at {flight.t[after.row]:.4g} s came "
            f"{1e3 * before.there.depth:.3g} mm deep into {place.obstacle}, where its next side "
            "is as near: from there on it was pushed out over the edge, not back, and what follows "
            "is not to be trusted; hit it farther from its edges, or make it stiffer"
        )
    return ""

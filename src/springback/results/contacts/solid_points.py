"""Points of contacts within obstacles at rest: how far it is from there to the sides."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple, cast

import numpy as np

from springback.contact.moving.scene import MovingScene
from springback.contact.scene.nearest import nearest_solid
from springback.contact.scene.sections import FARTHEST, Face
from springback.contact.scene.solids import solid_face
from springback.contact.shapes import ShapeSettings
from springback.contact.worlds import BuiltIn, alone
from springback.kernels.vectors import Vec
from springback.results.contacts.spans import ContactSpan
from springback.results.result import FlightResult

#: Least step through a body, as a share of the depth of the contact (chosen).
STEP = 0.05
#: Directions in which the sides of a part are looked for beside a contact (chosen).
ASIDE = 4


class SolidPoint(NamedTuple):
    """A point of a contact within an obstacle at rest."""

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

    def is_thinner(self, thickness: float, *, aside: bool) -> bool:
        """True if the part is thinner there than a thickness [m].

        Args:
            thickness: [m].
            aside: True to look from side to side, too: into the rim of a board it is far.
        """
        inward = self.face.normal * (-1.0 / self.steepness)
        if self.depth + self.way(inward, thickness) < thickness:
            return True
        if not aside:
            return False
        _, one, two = np.linalg.svd(np.array([inward]))[2]
        for turn in np.linspace(0.0, math.pi, ASIDE, endpoint=False):
            along = Vec(*(one * math.cos(turn) + two * math.sin(turn)).tolist())
            near = self.way(along, thickness)
            if near < thickness and near + self.way(along * -1.0, thickness) < thickness:
                return True
        return False

    def way(self, along: Vec, most: float) -> float:
        """Way until outside [m]; infinite if that is longer than a given one.

        Args:
            along: Direction, of length 1.
            most: The longest [m].
        """
        gone, gap = 0.0, self.face.gap
        while gone < most and gap < 0.0:
            gone += max(-gap, STEP * self.depth)
            gap = nearest_solid(self.table, self.point + along * gone, FARTHEST).gap
        return gone if gap >= 0.0 else math.inf


def table_of(shape: ShapeSettings) -> float:
    """Numbers of an obstacle at rest, alone.

    Args:
        shape: A built-in one.
    """
    scene = alone(cast(BuiltIn, shape), 0)
    assert not isinstance(scene, MovingScene)
    return scene.table


def solid_point(table: float, place: Sequence[float]) -> SolidPoint | None:
    """A point within an obstacle; None if it is outside.

    Args:
        table: Of the obstacle alone, as of `table_of`; with routines compiled.
        place: World [m].
    """
    point = Vec(*place)
    nearest = nearest_solid(table, point, FARTHEST)
    if nearest.row < 0 or nearest.gap >= 0.0:
        return None
    return SolidPoint(table, point, solid_face(table, nearest.row, point))


def is_ball(flight: FlightResult, span: ContactSpan) -> bool:
    """True if what touches is a ball, of which the middle counts: it stays outside of a rim.

    Args:
        flight: Any.
        span: A contact of it.
    """
    return span.arm is None and not flight.scenario.vehicle.hulls

"""Obstacles whose other side a deep contact may reach."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

from springback.contact.grids.measured_shapes import GridShape
from springback.contact.shapes import ShapeSettings

#: Share of the depth to which forces hold from which a contact is taken as pierced (chosen).
PIERCED = 0.95


class ThinObstacle(NamedTuple):
    """An obstacle, or one of a group, and the depth to which forces on it hold."""

    shape: ShapeSettings
    depth: float  # at its thinnest part [m]
    name: str  # in a sentence

    def is_pierced(self, depth: float) -> bool:
        """True if a contact so deep [m] may reach the other side."""
        return depth > PIERCED * self.depth

    @property
    def sentence(self) -> str:
        """What is known of it, and what follows."""
        far = f"{1e3 * self.depth:.3g} mm"
        if isinstance(self.shape, GridShape):
            cell = 1e3 * self.shape.form().cell
            return (
                f"forces on the thinnest parts of {self.name} with cells of {cell:.3g} mm, hold to "
                f"some {far}: beyond that they are too weak, and it is pushed out on the other "
                "side; make its cells smaller, or it thicker or stiffer"
            )
        return (
            f"the middle of {self.name}, is some {far} below its surface: beyond that it is pushed "
            "out on the other side; make it thicker or stiffer"
        )


def thin_obstacles(named: Iterable[tuple[str, Any]]) -> Iterator[ThinObstacle]:
    """Built-in obstacles that have another side.

    Args:
        named: Obstacles, each with its name in a sentence.
    """
    for name, one in named:
        if isinstance(one, ShapeSettings) and (depth := one.middle_depth()) < math.inf:
            yield ThinObstacle(one, depth, name)

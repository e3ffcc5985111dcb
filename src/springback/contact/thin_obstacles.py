"""Obstacles whose other side a deep contact may reach, and what to do about them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

import numpy as np

from springback.contact.grids.distance_grids import ACROSS, least_cell
from springback.contact.grids.measured_shapes import GridShape, MeshBody
from springback.contact.shapes import ShapeSettings
from springback.contact.unions import ShapeUnion

#: Share of the depth to which forces hold from which a contact is taken as pierced (chosen).
PIERCED = 0.95
#: Fewest cells across the thinnest parts of a mesh without a warning (chosen).
COARSE = 6.0
#: Depth from which contacts with edges of a mesh are looked at, as a share of a cell (chosen).
SHALLOW = 0.5
#: Smallest cells, as a share of those there are, that are worth asking for (chosen).
SMALLER = 0.8


class ThinObstacle(NamedTuple):
    """An obstacle, or one of a group, and the depth to which forces on it hold."""

    shape: ShapeSettings
    depth: float  # at its thinnest part [m]; 0 if forces on that are wrong at any depth
    name: str  # in a sentence
    part: ShapeSettings  # the thinnest shape of a union, else itself

    def is_pierced(self, depth: float) -> bool:
        """True if a contact so deep [m] may reach the other side, or no force on it holds."""
        return depth > PIERCED * self.depth

    def is_doubtful(self, depth: float) -> bool:
        """True if forces at that depth [m] hold at some places only."""
        part = self.part
        return self.is_pierced(depth) or (
            isinstance(part, MeshBody) and depth > SHALLOW * part.form().cell
        )

    def warning(self, depth: float) -> str:
        """Sentence on a contact that came too deep [m]."""
        return (
            f"a contact came {1e3 * depth:.3g} mm deep, and {self.sentence}; what follows "
            "is not to be trusted"
        )

    @property
    def sentence(self) -> str:
        """What is known of it, and what follows."""
        far = f"{1e3 * self.depth:.3g} mm"
        if not isinstance(self.part, GridShape):
            return (
                f"the middle of {self.name}, is some {far} below its surface: beyond that it is "
                "pushed out on the other side; make it thicker or stiffer"
            )
        form = self.part.form()
        where = (
            f"forces on the thinnest parts of {self.name} with cells of {1e3 * form.cell:.3g} mm"
        )
        if isinstance(self.part, MeshBody) and not self.depth > 0.0:
            return (
                f"{where}, are wrong at any depth, as they are {1e3 * form.thinnest:.3g} mm thick: "
                f"fewer than three cells; {cell_advice(self.part)}"
            )
        smaller = "make its cells smaller, or it thicker or stiffer"
        if isinstance(self.part, MeshBody):
            least = least_cell(np.array(self.part.extent()))
            smaller = (
                f"make its cells smaller (cell, {least:.3g} m or more), or it thicker or stiffer"
                if least < SMALLER * form.cell
                else f"make it thicker or stiffer, or {_APART}"
            )
        return (
            f"{where}, hold to some {far}: beyond that they are mostly too weak, and it is pushed "
            f"out on the other side; {smaller}"
        )


_APART = "make its thin parts a mesh of their own, which is a further obstacle, or boxes"


def cell_advice(mesh: MeshBody) -> str:
    """What to do about a mesh whose cells are coarse for its thinnest parts, in words.

    Args:
        mesh: Any; cells that are asked for are accepted.
    """
    least, thin = least_cell(np.array(mesh.extent())), mesh.form().thinnest
    if least <= thin / ACROSS:
        return f"give a cell of at most {thin / ACROSS:.3g} m"
    if least <= thin / COARSE:
        return f"give a cell of {least:.3g} m, the smallest for a mesh so large"
    lengths = " x ".join(f"{length:.3g}" for length in mesh.extent())
    return f"its box of {lengths} m allows no cell below {least:.3g} m: {_APART}"


def thin_obstacles(named: Iterable[tuple[str, Any]]) -> Iterator[ThinObstacle]:
    """Built-in obstacles that have another side.

    Args:
        named: Obstacles, each with its name in a sentence.
    """
    for name, one in named:
        if isinstance(one, ShapeSettings) and (depth := one.middle_depth()) < math.inf:
            whole = name
            part: ShapeSettings = one
            if isinstance(one, ShapeUnion):
                k = min(range(len(one.shapes)), key=lambda k: one.shapes[k].middle_depth())
                part = one.shapes[k]
                whole = f"{name.partition(',')[0]}.shapes[{k}], a {part.type}"
            yield ThinObstacle(one, depth, whole, part)

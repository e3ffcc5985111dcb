"""Table of a scene: the numbers of solids, surfaces and of the tree that finds them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.contact.obstacles import Obstacle
from springback.contact.scene.faces import (
    SCENE_FACES,
    SURFACE_CURVE,
    SURFACE_WIDTH,
    SolidScene,
)
from springback.contact.scene.nearest import (
    HALF_SPACES,
    HEADER,
    LEAVES,
    NODE,
    NODES,
    SOLID_ROWS,
    SOLIDS,
    SURFACES,
)
from springback.contact.scene.solids import (
    AXES,
    CAPSULE,
    CENTRE,
    FRUSTUM,
    GRID,
    GROUND,
    HALF_SPACE,
    HEIGHTS,
    KIND,
    OWNER,
    ROUNDING,
    SIZES,
    SURFACE,
    TORUS,
    WIDTH,
)
from springback.contact.surfaces import Surface, remembers
from springback.kernels.routines import NumberTable

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Solids of one world: their numbers have 16 bits.
MOST_SOLIDS = 65_535
#: Half length of what has no end, and coordinate of a box that is not there [m].
ENDLESS, NOWHERE = 1e6, 1e9
#: Kinds of solids whose form is in a table of its own, and where among their sizes its address is.
WITH_TABLE, TABLE = (GRID, HEIGHTS), 3
#: Boxes in the tree are larger than their solids by this, for rounding [m].
MARGIN = 1e-9


class Solid(NamedTuple):
    """A solid: its kind, place and sizes, as in `springback.contact.scene.solids`."""

    kind: float
    centre: Array  # world [m], shape (3,)
    axes: Array  # its own axes, one a row, in world axes, shape (3, 3)
    sizes: tuple[float, ...]  # before the edges are rounded [m]
    rounding: float  # radius of its edges [m]
    surface: int  # number of its surface
    is_ground: float
    owner: int  # number of the obstacle that it is a part of

    def half_lengths(self) -> tuple[float, float, float]:
        """Half lengths of a box around it along its own axes [m]."""
        s, edge = self.sizes, self.rounding
        if self.kind == CAPSULE:
            return s[1], s[1], s[0] + s[1]
        if self.kind == FRUSTUM:
            widest = max(s[0], s[1]) + edge
            return widest, widest, s[2] + edge
        if self.kind == TORUS:
            return s[0] + s[1], s[0] + s[1], s[1]
        return s[0] + edge, s[1] + edge, s[2] + edge

    def row(self) -> list[float]:
        """Its numbers in a table."""
        row = [0.0] * WIDTH
        row[KIND], row[ROUNDING], row[SURFACE] = self.kind, self.rounding, float(self.surface)
        row[CENTRE : CENTRE + 3] = self.centre.tolist()
        row[AXES : AXES + 9] = self.axes.ravel().tolist()
        row[SIZES : SIZES + len(self.sizes)] = self.sizes
        row[GROUND], row[OWNER] = self.is_ground, float(self.owner)
        return row


def scene_of(
    solids: Sequence[Solid], surfaces: Sequence[Surface], own: tuple[Obstacle, ...] = ()
) -> SolidScene:
    """Scene of some solids.

    Args:
        solids: At most `MOST_SOLIDS`, half-spaces among them.
        surfaces: Those that the solids name by number.
        own: The user's own shapes beside them.
    """
    numbers, order = _numbers(solids, surfaces)
    parts = {
        HEADER + WIDTH * row + SIZES + TABLE: solids[k].sizes[TABLE]
        for row, k in enumerate(order)
        if solids[k].kind in WITH_TABLE
    }
    for k, surface in enumerate(surfaces):
        place = int(numbers[SURFACES]) + SURFACE_WIDTH * k + SURFACE_CURVE
        parts[place] = surface.hysteresis[0].curve
    shared = {place: table for place, table in parts.items() if isinstance(table, NumberTable)}
    return SolidScene(
        NumberTable(numbers, shared), SCENE_FACES.address, own, 0.0,
        bristles=1.0 if any(one.presliding > 0.0 for one in surfaces) else 0.0,
        remembers=1.0 if any(map(remembers, surfaces)) else 0.0,
    )  # fmt: skip


def _numbers(solids: Sequence[Solid], surfaces: Sequence[Surface]) -> tuple[Array, list[int]]:
    """Numbers of a scene, and the solids in the order of their rows."""
    flat = [k for k, solid in enumerate(solids) if solid.kind == HALF_SPACE]
    others = [k for k, solid in enumerate(solids) if solid.kind != HALF_SPACE]
    lows, highs = _corners([solids[k] for k in others])
    order = _tree_order(0.5 * (lows + highs))
    others = [others[k] for k in order]
    leaves = 1 << max(len(others) - 1, 0).bit_length()
    head = np.zeros(HEADER)
    head[HALF_SPACES], head[SOLIDS], head[LEAVES] = len(flat), len(others), leaves
    head[SOLID_ROWS] = HEADER + WIDTH * len(flat)
    head[NODES] = head[SOLID_ROWS] + WIDTH * len(others)
    nodes = _nodes(lows[order], highs[order], leaves)
    head[SURFACES] = head[NODES] + nodes.size
    rows = [number for k in (*flat, *others) for number in solids[k].row()]
    laws = [number for surface in surfaces for number in _surface_numbers(surface)]
    return np.concatenate([head, rows, nodes.ravel(), laws]), [*flat, *others]


def _surface_numbers(s: Surface) -> list[float]:
    [memory] = s.hysteresis
    numbers = [
        s.stiffness, s.dissipation, s.viscosity, s.exponent.value, s.friction, s.vertical,
        s.slip_speed, s.restitution, s.presliding, s.rolling,
        memory.shape, memory.curve, memory.stays,
    ]  # fmt: skip
    assert len(numbers) == SURFACE_WIDTH
    return numbers


def _corners(solids: Sequence[Solid]) -> tuple[Array, Array]:
    """Lowest and highest corners of boxes around solids, along the world's axes [m]."""
    if not solids:
        return np.zeros((0, 3)), np.zeros((0, 3))
    centres = np.array([solid.centre for solid in solids])
    halves = np.array([solid.half_lengths() for solid in solids])
    axes = np.array([solid.axes for solid in solids])
    reach = np.einsum("kij,ki->kj", np.abs(axes), halves) + MARGIN
    return centres - reach, centres + reach


def _tree_order(centres: Array) -> Any:
    """Order of solids as leaves: halved again and again along the longest side of their centres.

    A tree of 2ⁿ leaves is filled from the left, so the left half of each node is filled first.
    """
    order = np.arange(len(centres))
    parts = [(0, len(order))]
    while parts:
        first, last = parts.pop()
        count = last - first
        if count < 2:
            continue
        left = 1 << ((count - 1).bit_length() - 1)
        part = order[first:last]
        places = centres[part]
        axis = int(np.argmax(places.max(axis=0) - places.min(axis=0)))
        order[first:last] = part[np.argsort(places[:, axis], kind="stable")]
        parts += [(first, first + left), (first + left, last)]
    return order


def _nodes(lows: Array, highs: Array, leaves: int) -> Array:
    """Boxes of all nodes, as in a heap from 1, shape (2 leaves, 6); empty ones nowhere."""
    nodes = np.empty((2 * leaves, NODE))
    nodes[:, :3], nodes[:, 3:] = NOWHERE, NOWHERE
    nodes[leaves : leaves + len(lows), :3] = lows
    nodes[leaves : leaves + len(highs), 3:] = highs
    first = leaves
    while first > 1:
        children = nodes[first : 2 * first]
        pairs = children.reshape(-1, 2, NODE)
        empty = (pairs[:, :, 0] >= NOWHERE)[:, :, None]
        first //= 2
        nodes[first : 2 * first, :3] = pairs[:, :, :3].min(axis=1)
        highest = np.where(empty, -NOWHERE, pairs[:, :, 3:]).max(axis=1)
        nodes[first : 2 * first, 3:] = np.where(empty.all(axis=1), NOWHERE, highest)
    return nodes

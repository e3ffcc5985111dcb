"""The solids nearest to a point, by a binary tree of boxes around them.

Nodes are numbered as in a heap: node k has the children 2k and 2k + 1, and leaves hold the solids.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.obstacles import outward_normal, signed_distance
from springback.contact.rings import FAR, has_ridges
from springback.contact.scene.sections import FARTHEST
from springback.contact.scene.solids import WIDTH, solid_face, solid_face_within
from springback.kernels.compiler import called_kernel, kernel
from springback.kernels.routines import number_at
from springback.kernels.vectors import Vec

#: Solids that can be nearest to a part before all are looked through for each of its points.
MOST_NEAR = 8

#: Numbers at the beginning of a table: half-spaces, solids, leaves of the tree (a power of two),
#: and the positions of the rows of solids, of the nodes, and of the surfaces.
HALF_SPACES, SOLIDS, LEAVES, SOLID_ROWS, NODES, SURFACES, HEADER = 0, 1, 2, 3, 4, 5, 8
#: Numbers of a node: the corners of its box.
NODE = 6


class Nearest(NamedTuple):
    """The solid nearest to a point."""

    gap: float  # [m]
    row: int  # of the solid; −1 if there is none


@kernel
def _outside(x: float, low: float, high: float) -> float:
    return low - x if x < low else (x - high if x > high else 0.0)


@kernel
def _square_to(table: float, node: int, point: Vec) -> float:
    """Square of the distance to the box of a node [m²]; −1 inside."""
    k = int(number_at(table, NODES)) + NODE * node
    x = _outside(point.x, number_at(table, k), number_at(table, k + 3))
    y = _outside(point.y, number_at(table, k + 1), number_at(table, k + 4))
    z = _outside(point.z, number_at(table, k + 2), number_at(table, k + 5))
    square = x * x + y * y + z * z
    return square if square > 0.0 else -1.0


@kernel
def solid_row(table: float, k: int) -> int:
    """Position of the numbers of solid ``k``."""
    return int(number_at(table, SOLID_ROWS)) + WIDTH * k


@kernel
def _is_nearer(square: float, gap: float) -> bool:
    """True if a box at a distance of this square can hold something nearer than a gap."""
    return (square < 0.0) | ((gap > 0.0) & (square < gap * gap))


@kernel
def nearest_solid(table: float, point: Vec, within: float) -> Nearest:
    """The solid nearest to a point of the world; half-spaces are none.

    A gap may be a lower bound where it is not less than ``within`` [m].
    """
    leaves, solids = int(number_at(table, LEAVES)), int(number_at(table, SOLIDS))
    best, row, node, previous = FAR, -1, 1 if solids > 0 else 0, 0
    while node > 0:
        above = node >> 1
        if node >= leaves:
            if node - leaves < solids:
                there = solid_row(table, node - leaves)
                gap = solid_face_within(table, there, point, within).gap
                if gap < best:
                    best, row = gap, there
            previous, node = node, above
        else:
            left = _square_to(table, 2 * node, point)
            right = _square_to(table, 2 * node + 1, point)
            near = 2 * node if left <= right else 2 * node + 1
            far = 4 * node + 1 - near
            to_near, to_far = (left, right) if left <= right else (right, left)
            chosen = above
            if previous == above and _is_nearer(to_near, best):
                chosen = near
            elif previous != far and _is_nearer(to_far, best):
                chosen = far
            previous, node = node, chosen
    return Nearest(best, row)


class NearestSolids(NamedTuple):
    """Those solids of a world that can be nearest to any point of a part of a vehicle."""

    table: float
    number: int  # above `MOST_NEAR`: all solids of the world
    first: int  # numbers of four solids, 16 bits each
    second: int


@kernel
def solids_within(table: float, point: Vec, nearest: Nearest, more: float) -> NearestSolids:
    """The solid nearest to a point of the world, and those farther by up to some distance [m]."""
    leaves, solids = int(number_at(table, LEAVES)), int(number_at(table, SOLIDS))
    count, first, second, node = 0, 0, 0, 1 if solids > 0 else 0
    reach = nearest.gap + more
    square = reach * reach
    while node > 0:
        if _square_to(table, node, point) <= square:
            if node < leaves:
                node = 2 * node
                continue
            k = node - leaves
            row = solid_row(table, k)
            if k < solids and (
                row == nearest.row or solid_face_within(table, row, point, reach).gap <= reach
            ):
                if count < 4:
                    first |= k << (16 * count)
                elif count < MOST_NEAR:
                    second |= k << (16 * (count - 4))
                count += 1
        while node & 1:
            node >>= 1
        node = node + 1 if node > 0 else 0
    return NearestSolids(table, count, first, second)


@kernel
def row_of_near(near: NearestSolids, k: int) -> int:
    """Position of the numbers of one of some solids, of which there are at most `MOST_NEAR`."""
    packed = near.first >> (16 * k) if k < 4 else near.second >> (16 * (k - 4))
    return solid_row(near.table, packed & 0xFFFF)


@called_kernel
def nearest_of(near: NearestSolids, point: Vec) -> Nearest:
    """The nearest of some solids."""
    if near.number > MOST_NEAR:
        return nearest_solid(near.table, point, FARTHEST)
    best, row = FAR, -1
    for k in range(near.number):
        there = row_of_near(near, k)
        gap = solid_face(near.table, there, point).gap
        if gap < best:
            best, row = gap, there
    return Nearest(best, row)


@kernel
def nearest_row(near: NearestSolids, point: Vec) -> int:
    """Position of the numbers of the nearest of some solids."""
    return row_of_near(near, 0) if near.number == 1 else nearest_of(near, point).row


@signed_distance.register(NearestSolids)
@kernel
def _near_distance(near: NearestSolids, point: Vec) -> float:
    return nearest_of(near, point).gap


@outward_normal.register(NearestSolids)
@kernel
def _near_normal(near: NearestSolids, point: Vec) -> Vec:
    return solid_face(near.table, nearest_row(near, point), point).normal


@has_ridges.register(NearestSolids)
@kernel
def _near_has_ridges(near: NearestSolids) -> bool:
    return near.number > 1


def distance_of(scene: Any, point: Vec) -> float:
    """Distance of a point from the nearest obstacle of a scene [m]."""
    table = scene.table
    rows = (HEADER + WIDTH * k for k in range(int(number_at(table, HALF_SPACES))))
    gaps = [solid_face(table, row, point).gap for row in rows]
    gaps += [signed_distance(one.shape, point) for one in scene.own]
    return min([nearest_solid(table, point, FARTHEST).gap, *gaps])

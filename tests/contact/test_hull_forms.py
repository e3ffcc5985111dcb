"""Hulls of every kind against grids, by the routine and by dense samples of the distance of points.

The distance of a point from a mesh, height map or block of cells is tested in `test_forms`; here it
is the search for the lowest point of a hull.
"""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from builders.forms import ball_file, box_file, cells_file, hills_file
from builders.hull_oracle import DEEP, HULLS, is_corner, is_within, lowest_in, normals, poses_near
from springback.contact.grids.measured_shapes import HeightMap, MeshBody, OccupancyGrid
from springback.contact.hulls.compound import SCENE_HULL_FACES
from springback.contact.hulls.contacts import HullPart, no_hull_faces
from springback.contact.library import WALL
from springback.contact.nets import Net
from springback.contact.scene.faces import SCENE_FACES, SolidScene
from springback.contact.scene.solids import solid_face
from springback.contact.shapes import ShapeSettings, solids_of
from springback.contact.worlds import obstacles
from springback.kernels.compiler import executor
from springback.kernels.layout import Buffer, TreeLayout, read, write
from springback.kernels.routines import NumberTable, call_routine
from springback.kernels.trees import leaves, rebuilt
from springback.kernels.vectors import Mat3, Vec
from springback.vehicle.hulls import compound_hull

Array = np.ndarray[Any, np.dtype[np.float64]]
TURNED: dict[str, Any] = {"roll": 0.4, "pitch": -0.3, "yaw": 1.1}
HERE = (0.3, -0.2, 1.1)
#: Poses of each hull at each form.
POSES = int(os.environ.get("POSES", "30"))


def forms() -> dict[str, ShapeSettings]:
    """One of every measured shape, and a net."""
    s: dict[str, Any] = {**TURNED, "position": HERE}
    ball = ball_file(0.25)
    return {
        "heightmap": HeightMap(type="heightmap", file=hills_file(), spacing=0.1, surface=WALL, **s),
        "box": MeshBody(type="mesh", file=box_file(0.5, 0.4, 0.3), surface=WALL, **s),
        "ball": MeshBody(type="mesh", file=ball, cell=0.01, surface=WALL, **s),
        "cells": OccupancyGrid(type="occupancy", file=cells_file(), surface=WALL, **s),
        "net": Net(type="net", tension=100.0, **s),
    }


FORMS = forms()


@executor(nogil=True)
def gaps_of_points(table: float, points: Buffer, out: Buffer) -> None:
    """Distances of points from the one solid of a table."""
    for i in range(points.shape[0]):
        out[i] = solid_face(table, 0, Vec(points[i, 0], points[i, 1], points[i, 2])).gap


@executor(nogil=True)
def search(like: TreeLayout, asked: Buffer, out: Buffer, address: float) -> None:
    """Faces of hulls at some poses; rows of the buffers hold the leaves."""
    for i in range(asked.shape[0]):
        part = read(like, asked[i], 0, 1, 0)
        write(call_routine(address, part, no_hull_faces()), out[i], 0, 1, 0)


#: Distance up to which the gaps of rings are exact beside all grids here [m].
HELD = 0.005


class PointDistance:
    """Distance of points from a form, shape (..., 3) to (...)."""

    def __init__(self, shape: ShapeSettings) -> None:
        """Make the table of its one solid."""
        [solid] = solids_of(shape, 0, 0)
        self.table = NumberTable(np.array(solid.row()))

    def __call__(self, points: Array) -> Array:
        """Distances [m]."""
        flat = np.ascontiguousarray(points.reshape(-1, 3))
        out = np.zeros(len(flat))
        gaps_of_points(float(self.table), flat, out)
        return out.reshape(points.shape[:-1])


def part_at(world: SolidScene, hull: str, at: Array, turn: Array) -> HullPart:
    """A hull as the routine knows it."""
    compound = compound_hull([HULLS[hull]])
    return HullPart(
        world.table, compound.table, compound.centre, compound.radius, Vec(0.0, 0.0, 0.0),
        Vec(*at.tolist()), Mat3(*(Vec(*row) for row in turn.tolist())), 1.0, 0.0,
        SCENE_FACES.address,
    )  # fmt: skip


def errors(name: str, hull: str, count: int) -> tuple[Array, Array, Array]:
    """Gap of samples, by how much the routine's is more [m], and angle of normals [deg]."""
    shape, form = FORMS[name], HULLS[hull].form()
    world = obstacles((shape,), as_scene=True)
    assert isinstance(world, SolidScene)
    chance = np.random.default_rng([list(FORMS).index(name), list(HULLS).index(hull)])
    field = PointDistance(shape)
    positions, turns = poses_near(form, field, np.array(HERE), chance, count)
    # These keep the hull's table.
    parts = [part_at(world, hull, *pose) for pose in zip(positions, turns, strict=True)]
    asked = np.array([leaves(part) for part in parts])
    out = np.zeros((count, len(leaves(no_hull_faces()))))
    search(TreeLayout(parts[0]), asked, out, SCENE_HULL_FACES.address)
    seen = [rebuilt(no_hull_faces(), row).first.nearest for row in out.tolist()]
    found, steepness = np.array([[face.gap, face.steepness] for face in seen]).T
    inward = np.einsum("nij,nj->ni", turns, [face.inward for face in seen])
    lever = np.einsum("nij,nj->ni", turns, [face.at.point for face in seen])
    solid = form.radius * (hull != "ring")
    core = positions + lever - solid * inward
    gap, where = lowest_in(form, field, positions, turns)
    there = field(core) - solid
    for k in np.flatnonzero(there < gap):
        if is_within(form, (core[k] - positions[k]) @ turns[k]):
            gap[k], where[k] = there[k], core[k]  # samples may miss it
    slope = normals(field, where)
    length = np.linalg.norm(slope, axis=1)
    smooth = ~is_corner(field, where) & (np.abs(length - 1.0) < 0.1) & (steepness > 1.0 - 1e-6)
    same = np.linalg.norm(core - where, axis=1) < 1e-5
    across = np.linalg.norm(np.cross(inward, slope), axis=1)
    turned = np.degrees(np.arctan2(across, -np.sum(inward * slope, axis=1)))
    turned[~(smooth & same)] = 0.0
    if hull == "ring" and shape.type in ("mesh", "occupancy"):
        # Rings are thin: beyond the grid's box, which is four cells wide, a bound is enough for them.
        bounded = (found < gap) & (gap > HELD)
        found = np.where(bounded, gap, found)
        turned[bounded] = 0.0
    kept = gap > -2.0 * DEEP  # of the others a corner that was not near went through
    if name == "net":  # the distance ends where a hull reaches around its rim: nothing is behind it
        kept &= length < 2.0
    return gap[kept], (found - gap)[kept], turned[kept]


@pytest.mark.parametrize("hull", HULLS)
@pytest.mark.parametrize("name", FORMS)
def test_a_hull_meets_the_lowest_point_of_a_form(name: str, hull: str) -> None:
    """Gap to 1e-6 m and the normal of the distance there."""
    _, over, turned = errors(name, hull, POSES)
    nonempty(over.tolist())
    assert np.abs(over).max() < 1e-6
    assert turned.max() < 0.1

"""Hulls of every kind against grids, by the routine and by dense samples of the distance of points.

The distance of a point from a mesh, height map or block of cells is tested in `test_forms`; here it
is the search for the lowest point of a hull.
"""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from builders.cases import nonempty
from builders.forms import ball_file, box_file, cells_file, hills_file
from builders.hull_oracle import HULLS, is_within, lowest_in
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
#: Depth of the deepest poses, and distance of the farthest [m].
DEEP, FAR = 0.004, 0.04


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


def poses(field: PointDistance, hull: str, chance: Any, count: int) -> list[tuple[Array, Array]]:
    """Random poses of a hull near a form, some of them pressed in a little."""
    form, found = HULLS[hull].form(), []
    points = form.points if len(form.points) else form.centre + form.radius * np.eye(3)
    while len(found) < count:
        turn = Rotation.random(random_state=chance).as_matrix()
        at = np.array(HERE) + chance.uniform(-0.5, 0.5, size=3)
        away = chance.normal(size=3)
        away /= np.linalg.norm(away)
        for _ in range(12):  # along a line, until it is near
            gap = float(field(at + points @ turn.T).min()) - form.radius
            if -DEEP < gap < FAR:
                found.append((at, turn))
                break
            at = at + away * (0.5 * (DEEP + FAR) - gap) * 0.7
    return found


def errors(name: str, hull: str, count: int) -> list[tuple[float, float]]:
    """Gap of the routine less that of samples [m], and the angle of normals [rad], at some poses."""
    shape, form = FORMS[name], HULLS[hull].form()
    world = obstacles((shape,), as_scene=True)
    assert isinstance(world, SolidScene)
    chance = np.random.default_rng([list(FORMS).index(name), list(HULLS).index(hull)])
    field, found = PointDistance(shape), []
    given = poses(field, hull, chance, count)
    parts = [part_at(world, hull, *pose) for pose in given]  # which keep the hull's table
    asked = np.array([leaves(part) for part in parts])
    out = np.zeros((len(given), len(leaves(no_hull_faces()))))
    search(TreeLayout(parts[0]), asked, out, SCENE_HULL_FACES.address)
    for (at, turn), row in zip(given, out.tolist(), strict=True):
        first = rebuilt(no_hull_faces(), row).first
        gap, where = lowest_in(form, field, at, turn)
        if gap < -2.0 * DEEP:
            continue  # a corner that was not near went through
        inward = turn @ np.array(first.nearest.inward)
        solid = form.radius * (hull != "ring")
        core = at + turn @ np.array(first.nearest.at.point) - solid * inward
        there = float(field(core[None])[0]) - solid
        if there < gap and is_within(form, (core - at) @ turn):
            gap, where = there, core  # samples may miss it
        steps = 1e-6 * np.eye(3)
        slope = (field(where + steps) - field(where - steps)) / 2e-6
        turned = 0.0
        smooth = abs(np.linalg.norm(slope) - 1.0) < 0.1 and first.nearest.steepness > 1.0 - 1e-6
        if smooth and np.linalg.norm(core - where) < 1e-5:
            cosine = float(-inward @ slope / np.linalg.norm(slope))
            turned = float(np.arccos(min(cosine, 1.0)))
        found.append((first.nearest.gap - gap, turned))
    return found


@pytest.mark.parametrize("hull", HULLS)
@pytest.mark.parametrize("name", FORMS)
def test_a_hull_meets_the_lowest_point_of_a_form(name: str, hull: str) -> None:
    """Gap to 1e-6 m and the normal of the distance there.

    Nothing is behind a net: where a ring reaches around its rim the distance ends, and the lowest
    point of samples is beside that.
    """
    found = np.array(nonempty(errors(name, hull, POSES)))
    close = 4e-3 if (name, hull) == ("net", "ring") else 1e-6
    assert np.abs(found[:, 0]).max() < close
    assert found[:, 1].max() < np.radians(0.1)

"""Distances beyond the box of a grid, and farther from a form than a part may touch."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from builders.forms import box_file, cells_file, face, hills_file, table_of
from springback.contact.grids.measured_shapes import HeightMap, MeshBody, OccupancyGrid
from springback.contact.library import WALL
from springback.contact.scene.sections import vector_at
from springback.contact.scene.solids import SIZES, solid_face, solid_face_within
from springback.contact.shapes import ShapeSettings
from springback.kernels.vectors import Vec

HERE: dict[str, Any] = {"position": (0.0, 0.0, 0.0), "surface": WALL}
FORMS: dict[str, ShapeSettings] = {
    "heightmap": HeightMap(type="heightmap", file=hills_file(), spacing=0.1, **HERE),
    "box": MeshBody(type="mesh", file=box_file(0.5, 0.4, 0.3), **HERE),
    "cells": OccupancyGrid(type="occupancy", file=cells_file(), **HERE),
}  # fmt: skip


@pytest.mark.parametrize("name", ["heightmap", "box", "cells"])
def test_beyond_what_may_touch_the_distance_is_a_bound(name: str) -> None:
    """Less than a given distance it has the same bits; else it is neither less than that nor too high."""
    shape, chance, seen = FORMS[name], np.random.default_rng(12), [0, 0, 0]
    for _ in range(300):
        point = Vec(*chance.uniform(-0.7, 0.7, size=3).tolist())
        within = chance.uniform(0.02, 0.4)
        exact = solid_face(table_of(shape), 0, point)
        found = solid_face_within(table_of(shape), 0, point, within)
        if exact.gap < within:
            assert found == exact
            seen[0] += 1
        else:
            assert within <= found.gap <= exact.gap + 1e-9
            seen[1 if found.gap == exact.gap else 2] += 1
    assert seen[0] > 50
    assert seen[2] > (0 if name == "heightmap" else 20)  # of smooth hills it is mostly exact


def test_beside_corners_of_a_grid_normals_are_gradients() -> None:
    """Ways to the surface enter there by an edge of the grid's box, or close to one."""
    shape, chance = FORMS["box"], np.random.default_rng(3)
    half = np.array(vector_at(table_of(shape), SIZES))
    for _ in range(300):
        q = chance.choice([-1.0, 1.0], 3) * (half + chance.uniform(0.0, 0.03, 3))
        steps = 1e-6 * np.eye(3)
        slope = [(face(shape, q + d)[0] - face(shape, q - d)[0]) / 2e-6 for d in steps]
        assert face(shape, q)[1] == pytest.approx(np.array(slope), abs=1e-7)

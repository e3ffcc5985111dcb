"""Height maps with sharp hollows, ridges and steps: exact distances, against dense searches."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import scipy.optimize
import scipy.spatial

from builders.cases import nonempty
from builders.forms import face, folder, table_of
from springback.contact.grids.distance_grids import spline_values
from springback.contact.grids.height_maps import height_file
from springback.contact.grids.measured_shapes import HeightMap
from springback.contact.library import WALL
from springback.contact.scene.solids import solid_face_within
from springback.kernels.vectors import Vec

Array = np.ndarray[Any, np.dtype[np.float64]]
#: Corners of a triangle.
SIMPLEX = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])


def stairs_and_stones(kind: str) -> HeightMap:
    """Ground with hollows and ridges of millimetres: random heights, or steps of half a metre."""
    if kind == "stones":
        heights = 0.05 * np.random.default_rng(4).standard_normal((21, 21))
    else:
        heights = 0.5 * np.floor(0.25 * np.arange(21.0))[:, None] + np.zeros(21)
    file = height_file(heights, folder() / f"{kind}.npy")
    return HeightMap(type="heightmap", file=file, spacing=0.05, position=(0, 0, 0), surface=WALL)


@pytest.mark.parametrize("kind", ["stones", "stairs"])
def test_ground_with_sharp_hollows_and_ridges_is_as_far_as_the_nearest_of_its_points(
    kind: str,
) -> None:
    """To 1e-6 m above it and below, within half a metre; farther away never more."""
    shape, chance = stairs_and_stones(kind), np.random.default_rng(4)
    assert shape.form().reach < 0.02
    along = np.linspace(-0.5, 0.5, 801)

    def ground(x: Any, y: Any) -> Any:
        at = [20.0 * (np.atleast_1d(u) + 0.5) for u in (x, y)]
        return np.squeeze(spline_values(shape.form().spline, at))

    z = ground(*np.meshgrid(along, along, indexing="ij"))
    dense = np.stack([*np.meshgrid(along, along, indexing="ij"), z], axis=-1).reshape(-1, 3)
    tree, seen = scipy.spatial.cKDTree(dense), [0, 0, 0]
    for _ in range(150):
        q = chance.uniform(-0.5, 0.5, size=3)
        q[2] = float(ground(*q[:2])) + chance.uniform(-0.06, 1.4)

        def square(at: Array, q: Array = q) -> float:
            x, y = np.clip(at, -0.5, 0.5)
            return float((x - q[0]) ** 2 + (y - q[1]) ** 2 + (ground(x, y) - q[2]) ** 2)

        best = tree.query(q)[0] ** 2
        for place in dense[tree.query(q, 40)[1][::8], :2]:
            found = scipy.optimize.minimize(
                square, place, method="Nelder-Mead",
                options={"xatol": 1e-9, "fatol": 1e-16, "initial_simplex": place + 1e-3 * SIMPLEX},
            )  # fmt: skip
            best = min(best, found.fun)
        true, (gap, normal) = math.sqrt(best), face(shape, q)
        above = q[2] > float(ground(*q[:2]))
        if above and true > 0.5:
            seen[0] += 1
            assert 0.5 - 1e-9 <= gap <= true + 1e-9
        else:
            seen[1 if above else 2] += 1
            assert gap == pytest.approx(true if above else -true, abs=1e-6)
            assert np.linalg.norm(normal) == pytest.approx(1.0, abs=1e-9)
        # Where nothing may touch, a bound suffices.
        bound = solid_face_within(table_of(shape), 0, Vec(*q.tolist()), 0.1).gap
        assert bound == gap if gap < 0.1 else 0.1 <= bound <= max(gap, 0.1)
    assert min(seen) > 3


def test_a_ball_rests_on_level_ground_as_high_as_it_is_thick_however_steep_a_step_is_elsewhere() -> (
    None
):
    """The distance is not scaled by the steepest slope anywhere."""
    heights = np.zeros((21, 21))
    heights[16:] = 1.0
    file = height_file(heights, folder() / "step.npy")
    shape = HeightMap(type="heightmap", file=file, spacing=0.05, position=(0, 0, 0), surface=WALL)
    assert shape.form().share < 0.05
    gap, normal = face(shape, np.array([-0.4, 0.0, 0.1]))
    assert gap == pytest.approx(0.1, abs=1e-3)  # the spline's waves beside the step
    assert normal[2] == pytest.approx(1.0, abs=1e-2)


def test_the_normal_of_a_steep_step_is_its_own_at_the_very_touch() -> None:
    """Where the gap ends, the way to the nearest point has no direction of its own."""
    heights = np.zeros((21, 21))
    heights[16:] = 1.0
    file = height_file(heights, folder() / "step.npy")
    shape = HeightMap(type="heightmap", file=file, spacing=0.05, position=(0, 0, 0), surface=WALL)

    for y, z in nonempty([(0.03, 0.5), (-0.31, 0.2), (0.2, 0.77), (0.0, 0.9), (0.11, 0.35)]):

        def gap(x: float, y: float = y, z: float = z) -> float:
            return face(shape, np.array([x, y, z]))[0]

        touch = scipy.optimize.brentq(gap, 0.2, 0.31, xtol=1e-16, rtol=1e-15)
        for step in nonempty(
            np.outer([-1.0, 1.0], 10.0 ** np.arange(-16.0, -7.0)).ravel().tolist()
        ):
            _, normal = face(shape, np.array([touch + step, y, z]))
            assert normal[0] < -0.99

"""Bodies of one mesh that overlap, touch or are in each other count as their union."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.spatial import cKDTree

from builders.cases import nonempty
from builders.forms import ball_triangles, beside, box_triangles, stl_bytes
from springback.contact.grids.closed_meshes import closed_mesh, inside, winding_numbers
from springback.contact.grids.distance_grids import cell_of, fitting_cell, grid_of_mesh
from springback.contact.grids.mesh_files import Triangles, triangles_of
from springback.contact.grids.thickness import thinnest_part
from springback.contact.grids.union_surfaces import union_surface

Array = np.ndarray[Any, np.dtype[np.float64]]
CUBE = box_triangles(0.5, 0.5, 0.5)
PLACES = {
    "a skin": (0.01, 0.003, 0.003),
    "a corner": (0.2, 0.15, 0.1),
    "a side": (0.5, 0.0, 0.0),
    "a part of a side": (0.5, 0.2, -0.1),
}


def two_cubes(place: tuple[float, float, float]) -> Triangles:
    """A cube and a copy, as a file has them: in single precision, their vertices joined."""
    both = beside((CUBE, (0.0, 0.0, 0.0)), (CUBE, place))
    return closed_mesh("two", triangles_of("two.stl", stl_bytes(both)))


def turned(mesh: Triangles) -> Triangles:
    return Triangles(mesh.vertices, mesh.faces[:, ::-1])


def area(mesh: Triangles) -> float:
    a, b, c = np.moveaxis(mesh.corners, 1, 0)
    return float(0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum())


def box_distance(points: Array, place: Array) -> Array:
    """Distance from the cube at a place, negative inside [m]."""
    beyond = np.abs(points - place) - 0.25
    outside = np.linalg.norm(np.maximum(beyond, 0.0), axis=1)
    return np.asarray(outside + np.minimum(beyond.max(axis=1), 0.0))


def union_distance(points: Array, place: Array) -> Array:
    """Distance from both cubes, to 2 mm: inside from points of their sides outside the other."""
    line = np.linspace(-0.25, 0.25, 201)
    u, v = (one.ravel() for one in np.meshgrid(line, line))
    sides = [
        np.insert(np.stack([u, v], axis=1), axis, end, axis=1)
        for axis in range(3) for end in (-0.25, 0.25)
    ]  # fmt: skip
    here = np.concatenate(sides)
    bare = np.concatenate(
        [
            here[box_distance(here, place) > 1e-6],
            (here + place)[box_distance(here + place, 0 * place) > 1e-6],
        ]
    )
    least = np.minimum(box_distance(points, 0 * place), box_distance(points, place))
    within = cKDTree(bare).query(points)[0]
    return np.where(least > 0.0, least, -within)


@pytest.mark.parametrize("name", PLACES)
def test_two_cubes_have_the_distance_of_their_union(name: str) -> None:
    """To a sixth of a cell; beside faces within the other it was nearly 0.

    Farther than three cells outside, between the cubes, it is more by less than a cell.
    """
    mesh, place = two_cubes(PLACES[name]), np.array(PLACES[name])
    cell = cell_of(mesh, 40_000)
    grid = grid_of_mesh(mesh, cell)
    nodes = grid.low + cell * np.indices(grid.values.shape).reshape(3, -1).T
    expected = union_distance(nodes, place)
    found = grid.values.ravel()
    clear = np.abs(expected) > 0.01 * cell  # a node on a face is on either side
    assert ((found < 0.0) == (expected < 0.0))[clear].all()
    known = expected < 3.0 * cell
    assert np.abs(found - expected)[known].max() < cell / 6.0
    assert (found - expected)[~known].min() > -1e-3
    assert (found - expected)[~known].max() < cell
    assert grid.error[0] < 0.2 * cell
    assert found.min() < -0.235


@pytest.mark.parametrize("name", PLACES)
def test_their_surface_is_that_of_the_union(name: str) -> None:
    mesh, place = two_cubes(PLACES[name]), PLACES[name]
    x, y, z = (0.5 - abs(shift) for shift in place)
    shared = 2.0 * (x * y + y * z + z * x)
    assert area(union_surface(mesh, 0.02)) == pytest.approx(3.0 - shared, abs=0.01)


def test_bodies_apart_and_hollow_ones_are_left_as_they_are() -> None:
    """Bit for bit: whatever is covered nowhere keeps its triangles."""
    hollow = beside(
        (CUBE, (0.0, 0.0, 0.0)), (turned(box_triangles(0.3, 0.3, 0.3)), (0.0, 0.0, 0.0))
    )
    apart = beside((CUBE, (0.0, 0.0, 0.0)), (CUBE, (0.8, 0.0, 0.0)))
    near = beside((ball_triangles(0.2), (0.0, 0.0, 0.0)), (ball_triangles(0.2), (0.3, 0.3, 0.0)))
    for mesh in nonempty((CUBE, hollow, apart, near)):
        assert union_surface(mesh, 0.02) is mesh
    cell = cell_of(hollow, 30_000)
    grid = grid_of_mesh(closed_mesh("hollow", hollow), cell)
    middle = np.round(-grid.low / cell).astype(int)
    assert grid.values[tuple(middle)] == pytest.approx(0.15, abs=cell)


def test_a_body_wholly_in_another_bounds_nothing() -> None:
    nested = beside((CUBE, (0.0, 0.0, 0.0)), (box_triangles(0.3, 0.3, 0.3), (0.0, 0.0, 0.0)))
    assert area(union_surface(nested, 0.02)) == pytest.approx(1.5)
    assert grid_of_mesh(nested, cell_of(nested, 30_000)).values.min() < -0.24


def test_what_two_bodies_share_is_no_thin_part() -> None:
    """A rod of two halves that overlap by 4 mm is 0.2 m thick, and so are its cells."""
    half = box_triangles(0.2, 0.2, 0.2)
    rod = beside((half, (0.0, 0.0, 0.0)), (half, (0.196, 0.0, 0.0)))
    assert thinnest_part(union_surface(rod, 0.01), 0.005) == pytest.approx(0.2, rel=0.05)
    assert thinnest_part(rod, 0.002) < 0.01
    assert fitting_cell(rod) == cell_of(rod)


def test_winding_numbers_are_those_of_a_grid() -> None:
    """Of points anywhere, against the lines of a grid; 2 where bodies overlap."""
    mesh = two_cubes(PLACES["a corner"])
    axes = tuple(np.linspace(-0.4, 0.6, n) + 1e-4 for n in (23, 27, 31))
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    found = winding_numbers(mesh, points)
    assert ((found != 0) == inside(mesh, (axes[0], axes[1], axes[2])).ravel()).all()
    both = (box_distance(points, np.zeros(3)) < 0.0) & (
        box_distance(points, np.array(PLACES["a corner"])) < 0.0
    )
    assert ((found == 2) == both).all()

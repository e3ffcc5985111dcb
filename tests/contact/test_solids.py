"""Solids: distances against dense points of the same bodies, normals against differences."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from pydantic_core import PydanticCustomError

from builders.cases import nonempty
from builders.shapes import SHAPES
from springback.contact.forest import Forest
from springback.contact.library import WALL
from springback.contact.openings import Doorway, Window
from springback.contact.scene.nearest import HEADER, SOLID_ROWS
from springback.contact.scene.solids import OWNER, WIDTH, solid_face
from springback.contact.scene.table import Solid, scene_of
from springback.contact.shapes import (
    Ball,
    Box,
    Capsule,
    Cone,
    Edge,
    Hoop,
    Pole,
    ShapeSettings,
    Slope,
    Stairs,
    solids_of,
)
from springback.errors import InputError
from springback.kernels.routines import NumberTable, number_at
from springback.kernels.vectors import Vec

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Spacing of the dense points [m]; a distance to them is too long by about its square.
FINE = 0.004


def face_of(solid: Solid) -> Callable[[Array], tuple[float, Array]]:
    """Distance and normal of one solid, by the kernel."""
    table = NumberTable(np.array(solid.row()))

    def face(point: Array) -> tuple[float, Array]:
        found = solid_face(table, 0, Vec(*point.tolist()))
        return found.gap, np.array(found.normal)

    return face


# -- dense points of the bodies, from their descriptions and not from the solids --------------------


def mesh(*axes: Array) -> Array:
    """Points of a grid, shape (points, axes)."""
    return np.stack([a.ravel() for a in np.meshgrid(*axes, indexing="ij")], axis=1)


def span(low: float, high: float) -> Array:
    """Points from low to high, both included."""
    return np.linspace(low, high, max(2, math.ceil((high - low) / FINE) + 1))


def lathe(section: Array) -> Array:
    """Points (ρ, z), turned about z."""
    turns = [
        np.stack([r * np.cos(a), r * np.sin(a), np.full_like(a, z)], axis=1)
        for r, z in section
        for a in [
            np.linspace(0, 2 * np.pi, max(1, math.ceil(2 * np.pi * r / FINE)), endpoint=False)
        ]
    ]
    return np.concatenate(turns)


def inset(shape: ShapeSettings) -> tuple[Array, float]:
    """Points that fill the surface of a body in its own axes, and the radius to round it by."""
    edge = getattr(shape, "edge_radius", 0.0)
    if isinstance(shape, Box):
        x, y, z = (0.5 * length - edge for length in shape.size)
        points = mesh(span(-x, x), span(-y, y), span(-z, z))
        outer = (np.abs(points) > np.array([x, y, z]) - 1e-12).any(axis=1)
        return points[outer], edge
    if isinstance(shape, Hoop):
        return lathe(np.array([[shape.radius, 0.0]])), shape.tube_radius
    if isinstance(shape, Window):
        w, h = (0.5 * length - edge for length in shape.size)
        t = 0.5 * shape.thickness - edge
        points = mesh(span(-w, w), span(-h, h))
        if shape.opening is None:
            radius = (shape.opening_radius or 0.0) + edge
            solid = points[np.hypot(*points.T) >= radius]
            a = np.arange(0, 2 * np.pi, FINE / radius)
            rim = radius * np.stack([np.cos(a), np.sin(a)], axis=1)
        else:
            a, b = (0.5 * length + edge for length in shape.opening)
            u, v = np.abs(points[:, 0]), np.abs(points[:, 1] - shape.opening_height)
            solid = points[(u >= a) | (v >= b)]
            rim = np.concatenate(
                [mesh(span(-a, a), np.array([-b, b])), mesh(np.array([-a, a]), span(-b, b))]
            )
            rim += np.array([0.0, shape.opening_height])
        outline = np.concatenate(
            [mesh(span(-w, w), np.array([-h, h])), mesh(np.array([-w, w]), span(-h, h)), rim]
        )
        faces = [np.c_[solid, np.full(len(solid), z)] for z in (-t, t)]
        sides = [np.c_[outline, np.full(len(outline), z)] for z in span(-t, t)]
        return np.concatenate([*faces, *sides]), edge
    if isinstance(shape, Pole):
        assert shape.height is not None
        r, h = shape.radius - edge, 0.5 * shape.height - edge
        section = [[r, z] for z in span(-h, h)] + [[x, z] for x in span(0.0, r) for z in (-h, h)]
        return lathe(np.array(section)), edge
    raise AssertionError(shape)


FILLED = ("box", "hoop", "window", "round", "pole")


@pytest.mark.parametrize("name", FILLED)
def test_distances_are_those_to_the_nearest_of_many_points(name: str) -> None:
    """Outside; the points are spaced so that the nearest is too far by less than 0.1 mm."""
    shape = SHAPES[name]
    body = shape.bodies()[0]
    points, rounding = inset(shape)
    face = face_of(solids_of(shape, 0, 0)[0])
    chance = np.random.default_rng(1)
    seen = 0
    for _ in range(400):
        local = chance.uniform(-0.7, 0.7, size=3)
        true = float(np.sqrt(((points - local) ** 2).sum(axis=1)).min()) - rounding
        gap, _ = face(body.centre + local @ body.axes)
        if gap > 0.02:
            seen += 1
            assert gap == pytest.approx(true, abs=FINE**2 / 0.04)
            assert gap <= true + 1e-12  # never overstated
    assert seen > 200


@pytest.mark.parametrize("name", SHAPES)
def test_normals_are_gradients_of_length_one(name: str) -> None:
    """Inside and outside; beside an edge or the middle the difference straddles two faces."""
    chance, tiny, straddling = np.random.default_rng(2), 1e-6, 0
    for solid in nonempty(solids_of(SHAPES[name], 0, 0)):
        face = face_of(solid)
        for _ in range(200):
            point = np.array([0.3, -0.2, 1.1]) + chance.uniform(-0.6, 0.6, size=3)
            _, normal = face(point)
            assert np.linalg.norm(normal) == pytest.approx(1.0, abs=1e-12)
            steps = tiny * np.eye(3)
            slope = np.array(
                [(face(point + d)[0] - face(point - d)[0]) / (2 * tiny) for d in steps]
            )
            straddling += bool(np.abs(slope - normal).max() > 1e-6)
    assert straddling <= 4


@pytest.mark.parametrize("name", SHAPES)
def test_the_surface_is_reached_along_the_normal(name: str) -> None:
    """The foot of every point lies on the surface, and has the same normal: an exact distance."""
    chance = np.random.default_rng(3)
    for solid in nonempty(solids_of(SHAPES[name], 0, 0)):
        face, seen = face_of(solid), 0
        for _ in range(200):
            point = np.array([0.3, -0.2, 1.1]) + chance.uniform(-0.6, 0.6, size=3)
            gap, normal = face(point)
            below = name == "doorway" and point[2] < 1.1  # the opening goes on below the floor
            if gap > 1e-6 and not below:
                foot, there = face(point - gap * normal)
                assert abs(foot) < 1e-9
                assert np.allclose(there, normal, atol=1e-6)
                seen += 1
        assert seen > 20


def test_formulas_of_round_bodies() -> None:
    """Spheres, endless poles, capsules and cones, by other formulas."""
    chance = np.random.default_rng(4)
    ball, rod = SHAPES["sphere"], SHAPES["capsule"]
    assert isinstance(ball, Ball)
    assert isinstance(rod, Capsule)
    endless = SHAPES["endless"]
    assert isinstance(endless, Pole)
    faces = [face_of(solids_of(one, 0, 0)[0]) for one in (ball, rod, endless)]
    a, b = np.array(rod.start), np.array(rod.end)
    axis = np.array(endless.axis) / np.linalg.norm(endless.axis)
    for _ in range(200):
        p = chance.uniform(-1.0, 2.0, size=3)
        assert faces[0](p)[0] == pytest.approx(np.linalg.norm(p - ball.position) - 0.2, abs=1e-12)
        along = np.clip(np.dot(p - a, b - a) / np.dot(b - a, b - a), 0.0, 1.0)
        assert faces[1](p)[0] == pytest.approx(
            np.linalg.norm(p - a - along * (b - a)) - 0.05, abs=1e-9
        )
        across = np.linalg.norm(np.cross(p - np.array(endless.position), axis))
        assert faces[2](p)[0] == pytest.approx(across - 0.1, abs=1e-9)


def test_rounded_shapes_keep_their_sizes() -> None:
    """Faces, rims and tips of rounded bodies lie where those of the sharp ones do, but at edges."""
    cone = SHAPES["cone"]
    assert isinstance(cone, Cone)
    base = np.array(cone.position)
    face = face_of(solids_of(cone, 0, 0)[0])
    assert face(base)[0] == pytest.approx(0.0, abs=1e-12)
    middle = base + np.array([0.1, 0.0, 0.2])  # on the sharp cone's side
    assert face(middle)[0] == pytest.approx(0.0, abs=1e-12)
    tip = base + np.array([0.0, 0.0, 0.4])
    assert 0.0 < face(tip)[0] < 0.02  # rounded off
    box = SHAPES["box"]
    assert isinstance(box, Box)
    body = box.bodies()[0]
    for k, length in enumerate(box.size):
        outside = body.centre + 0.5 * length * body.axes[k]
        assert face_of(solids_of(box, 0, 0)[0])(outside)[0] == pytest.approx(0.0, abs=1e-12)
    corner = SHAPES["edge"]
    assert isinstance(corner, Edge)
    there = np.array(corner.position)
    face = face_of(solids_of(corner, 0, 0)[0])
    assert face(there)[0] == pytest.approx((math.sqrt(2.0) - 1.0) * 0.01, abs=1e-12)


def test_a_doorway_has_no_sill_and_a_window_has_one() -> None:
    """Through the door at the floor nothing is near; below the window there is wall."""
    s: dict[str, Any] = {"surface": WALL}
    door = Doorway(type="doorway", position=(0, 0, 0), size=(3.0, 2.5), opening=(0.9, 2.0), **s)
    face = face_of(solids_of(door, 0, 0)[0])
    assert face(np.array([0.0, 0.0, 0.05]))[0] == pytest.approx(0.45, abs=1e-9)
    assert face(np.array([0.0, 0.0, 1.9]))[0] == pytest.approx(0.1, abs=1e-9)
    assert face(np.array([0.0, 0.6, 1.0]))[0] < 0.0
    # Below the threshold the nearest are the feet of the jambs, however far below.
    for depth in (0.1, 1.0, 3.0):
        gap, normal = face(np.array([0.0, 0.05, -depth]))
        assert gap == pytest.approx(math.hypot(depth + 1e-3, 0.401) - 1e-3, abs=1e-12)
        assert normal == pytest.approx([0.0, -0.401 / (gap + 1e-3), -(depth + 1e-3) / (gap + 1e-3)])
    window = Window(type="window", position=(0, 0, 1.25), size=(3.0, 2.5), opening=(0.9, 1.0), **s)
    face = face_of(solids_of(window, 0, 0)[0])
    assert face(np.array([0.0, 0.0, 0.05]))[0] < 0.0
    assert face(np.array([0.0, 0.0, 1.25]))[0] == pytest.approx(0.45, abs=1e-9)


def test_stairs_have_no_seams() -> None:
    """Just below a tread the nearest surface is the tread, beside the next riser, too."""
    stairs = Stairs(type="stairs", position=(0, 0, 0), steps=4, rise=0.2, tread=0.3, surface=WALL)
    faces = [face_of(solid) for solid in solids_of(stairs, 0, 0)]
    assert len(faces) == 4
    for k in range(3):
        for x in (0.3 * k + 0.02, 0.3 * k + 0.15, 0.3 * (k + 1) - 1e-4):
            point = np.array([x, 0.1, 0.2 * (k + 1) - 0.005])
            assert min(face(point)[0] for face in faces) == pytest.approx(-0.005, abs=1e-9)


def test_trunks_of_a_forest_keep_their_distance() -> None:
    """As many as asked for where there is room, apart, within the area, the same for a seed."""
    forest = Forest(
        type="forest", density=0.1, size=(20.0, 30.0), radius=0.15, radius_spread=0.3,
        spacing=0.6, seed=7, surface=WALL,
    )  # fmt: skip
    bodies = forest.bodies()
    assert len(bodies) == 60
    places = np.array([body.centre for body in bodies])
    radii = np.array([body.sizes[1] for body in bodies])
    apart = np.linalg.norm(places[:, None] - places[None], axis=2) - radii[:, None] - radii[None]
    assert apart[~np.eye(60, dtype=bool)].min() >= 0.6
    assert places[:, 0].min() >= 0.0
    assert places[:, 0].max() <= 20.0
    assert np.abs(places[:, 1]).max() <= 15.0
    assert np.array_equal(places, [body.centre for body in forest.bodies()])
    other = Forest(**{**forest.model_dump(), "surface": WALL, "seed": 8}).bodies()
    assert not np.array_equal(places, [body.centre for body in other])


def test_the_table_holds_every_solid() -> None:
    """Rows of solids are in the table at the place that its head says."""
    solids = [one for k, name in enumerate(SHAPES) for one in solids_of(SHAPES[name], 0, k)]
    scene = scene_of(solids, [])
    table = scene.table
    count = int(number_at(table, 1))
    assert count + int(number_at(table, 0)) == len(solids)
    first = int(number_at(table, SOLID_ROWS))
    owners = [number_at(table, first + WIDTH * k + OWNER) for k in range(count)]
    owners += [
        number_at(table, HEADER + WIDTH * k + OWNER) for k in range(int(number_at(table, 0)))
    ]
    assert sorted(owners) == sorted(float(solid.owner) for solid in solids)


@pytest.mark.parametrize(
    ("shape", "changes", "words"),
    [
        (Box, {"size": (0.0, 1.0, 1.0)}, "more than 0 m"),
        (Box, {"edge_radius": 0.2}, "at most 0.1 m, half of the thinnest part"),
        (Pole, {"axis": (0.0, 0.0, 0.0)}, "must not be zero"),
        (Pole, {"radius": float("nan")}, "finite"),
        (Hoop, {"tube_radius": 0.3}, "less than radius, 0.3 m"),
        (Window, {"opening_radius": 0.2}, "either opening, width and height, or opening_radius"),
        (Window, {"opening": (1.2, 0.3)}, "must lie within the wall"),
        (Window, {"opening": (0.99, 0.3)}, "at most 0.0025 m, half of the thinnest part"),
        (Doorway, {"opening": (0.3, 0.9)}, "must be smaller than the wall"),
        (Slope, {"angle": 2.0}, "at most 90 deg"),
        (Stairs, {"steps": 0}, "greater than or equal to 1"),
        (Cone, {"edge_radius": 0.19}, "too large for this cone"),
    ],
)
def test_shapes_that_cannot_be_are_refused(
    shape: type[ShapeSettings], changes: dict[str, Any], words: str
) -> None:
    """In one line, with the value and what is allowed."""
    good = next(one for one in SHAPES.values() if type(one) is shape)
    given = {name: getattr(good, name) for name in good.model_fields_set}
    with pytest.raises((InputError, PydanticCustomError), match=words):
        shape(**{**given, **changes}).bodies()

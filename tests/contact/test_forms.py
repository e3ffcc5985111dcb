"""Grids and height maps: distances, normals and what rings meet, against slow independent searches."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import scipy.interpolate
import scipy.optimize
import scipy.spatial

from builders.cases import nonempty
from builders.forms import (
    ball_file,
    box_file,
    box_triangles,
    cells_file,
    face,
    folder,
    hills,
    hills_file,
    stl_bytes,
)
from springback.contact.cage import Ring, contact_faces, obstacles_in_body_frame
from springback.contact.grids.height_maps import height_file
from springback.contact.grids.measured_shapes import HeightMap, MeshBody, OccupancyGrid
from springback.contact.grids.mesh_files import Triangles
from springback.contact.library import WALL
from springback.contact.nets import Net
from springback.contact.rings import FAR
from springback.contact.scene.faces import (
    SCENE_FACES,
    SolidScene,
    VehiclePart,
    no_faces,
    scene_faces,
)
from springback.contact.shapes import Box, ShapeSettings
from springback.contact.unions import ShapeUnion
from springback.contact.worlds import obstacles
from springback.kernels.compiler import executor
from springback.kernels.layout import Buffer, TreeLayout, read, write
from springback.kernels.routines import call_routine
from springback.kernels.trees import leaves
from springback.kernels.vectors import Mat3, Quat, Vec, rotation
from springback.vehicle.state import ArmPose, Sphere

Array = np.ndarray[Any, np.dtype[np.float64]]
RADIUS, STILL = 0.11, Vec(0.0, 0.0, 0.0)
TURNED: dict[str, Any] = {"roll": 0.4, "pitch": -0.3, "yaw": 1.1, "surface": WALL}
HERE = (0.3, -0.2, 1.1)


def forms() -> dict[str, ShapeSettings]:
    """One of every measured shape."""
    return {
        "heightmap": HeightMap(type="heightmap", file=hills_file(), spacing=0.1, position=HERE, **TURNED),
        "box": MeshBody(type="mesh", file=box_file(0.5, 0.4, 0.3), position=HERE, **TURNED),
        "ball": MeshBody(type="mesh", file=ball_file(0.25), position=HERE, cell=0.01, **TURNED),
        "cells": OccupancyGrid(type="occupancy", file=cells_file(), position=HERE, **TURNED),
        "net": Net(type="net", position=HERE, tension=100.0, roll=0.4, pitch=-0.3, yaw=1.1),
    }  # fmt: skip


FORMS = forms()


def near(shape: ShapeSettings, chance: np.random.Generator, half: float, most: float) -> Array:
    """A random point near the surface of a shape, world."""
    while True:
        point = local(shape, chance.uniform(-half, half, size=3))
        for _ in range(3):
            gap, normal = face(shape, point)
            point = point - gap * normal
        if abs(face(shape, point)[0]) < 1e-3:
            return np.asarray(point + normal * chance.uniform(-most, most))


def local(shape: ShapeSettings, point: Array) -> Array:
    """A point of a shape's own axes in the world."""
    body = shape.bodies()[0]
    return np.asarray(np.array(HERE) + point @ body.axes)


# -- height maps ------------------------------------------------------------------------------------


def spline(spacing: float = 0.1, half: float = 1.0) -> Any:
    """The ground by another library: a tensor spline that goes on turned about its rim."""
    along = np.arange(-half, half + 0.5 * spacing, spacing)
    values = hills(along[:, None], along[None, :])
    ext = np.concatenate([along[0] - spacing * np.arange(len(along) - 1, 0, -1), along,
                          along[-1] + spacing * np.arange(1, len(along))])  # fmt: skip
    wide = np.pad(values, len(along) - 1, mode="reflect", reflect_type="odd")
    return scipy.interpolate.RectBivariateSpline(ext, ext, wide, s=0)


def nearest(ground: Any, q: Array, half: float = 1.0) -> float:
    """Distance of a point above from the ground, by dense samples and a bounded search from the best."""
    along = np.linspace(-half, half, 301)
    z = ground(along, along)
    square = (along[:, None] - q[0]) ** 2 + (along[None] - q[1]) ** 2 + (z - q[2]) ** 2
    best = math.inf
    for k in np.argsort(square.ravel())[:3]:
        i, j = np.unravel_index(k, square.shape)

        def cost(at: Array) -> float:
            height = float(ground(at[0], at[1])[0, 0])
            return float((at[0] - q[0]) ** 2 + (at[1] - q[1]) ** 2 + (height - q[2]) ** 2)

        found = scipy.optimize.minimize(
            cost, [along[i], along[j]], bounds=[(-half, half)] * 2, method="L-BFGS-B",
            options={"ftol": 1e-18, "gtol": 1e-12},
        )  # fmt: skip
        best = min(best, float(found.fun))
    return math.sqrt(best)


def test_ground_near_by_is_exactly_as_far_as_the_nearest_of_its_points() -> None:
    """Within 5 cm to 1e-6 m, beside the rim, too; farther away never more."""
    shape, ground, chance = FORMS["heightmap"], spline(), np.random.default_rng(1)
    near = beside = 0
    for k in range(150):
        q = chance.uniform(-1.03, 1.03, size=3)
        if k % 3 == 0:
            q[0] = chance.uniform(1.0, 1.03)
        inside = np.clip(q[:2], -1.0, 1.0)
        q[2] = float(ground(*inside)[0, 0]) + chance.uniform(1e-3, 0.12)
        true = nearest(ground, q)
        gap, normal = face(shape, local(shape, q))
        assert gap <= true + 1e-6
        if true < 0.05:
            near += 1
            beside += bool((inside != q[:2]).any())
            assert gap == pytest.approx(true, abs=1e-6)
            assert np.linalg.norm(normal) == pytest.approx(1.0, abs=1e-9)
    assert near > 40
    assert beside > 10


def test_the_spline_passes_through_the_heights() -> None:
    """At every point of the grid the distance is zero."""
    shape, along = FORMS["heightmap"], np.linspace(-0.9, 0.9, 19)
    for x in nonempty(along[::6]):
        for y in nonempty(along[::3]):
            gap, _ = face(shape, local(shape, np.array([x, y, hills(x, y)])))
            assert abs(gap) < 1e-12


@pytest.mark.parametrize("name", FORMS)
def test_normals_are_the_gradients_of_the_distance(name: str) -> None:
    """Exactly, so that the work of a contact is; a grid's differ from length 1 by its error."""
    chance, tiny, seen, straddling = np.random.default_rng(2), 1e-6, 0, 0
    shape = FORMS[name]
    for _ in range(60):
        point = near(shape, chance, 0.4, 0.02)
        _, normal = face(shape, point)
        seen += 1
        exact = name in ("heightmap", "net")
        assert np.linalg.norm(normal) == pytest.approx(1.0, abs=1e-9 if exact else 0.7)
        steps = tiny * np.eye(3)
        slope = np.array(
            [(face(shape, point + d)[0] - face(shape, point - d)[0]) / (2 * tiny) for d in steps]
        )
        straddling += bool(np.abs(slope - normal).max() > 1e-6)
    assert straddling <= seen // 8  # beside an edge, or where another face is as near


def test_below_the_ground_the_way_out_is_through_its_surface_sides_or_bottom() -> None:
    """Half a metre below the lowest point is the bottom; a level map is a box."""
    level = height_file(np.full((8, 8), 0.25), folder() / "level.npy")
    shape = HeightMap(
        type="heightmap", file=level, size=(2.0, 1.0), position=(0, 0, 0), surface=WALL
    )
    box = Box(type="box", position=(0, 0, 0), size=(2.0, 1.0, 0.5), edge_radius=0.0, surface=WALL)
    chance = np.random.default_rng(3)
    for _ in nonempty(range(100)):
        point = chance.uniform([-1.2, -0.7, -0.4], [1.2, 0.7, 0.4])
        (gap, normal), (true, other) = face(shape, point), face(box, point)
        assert gap == pytest.approx(true, abs=1e-9)
        if abs(true) > 1e-3:
            assert np.allclose(normal, other, atol=1e-6)


# -- grids ------------------------------------------------------------------------------------------


def box_distance(q: Array, half: Array) -> float:
    """Distance from a sharp box."""
    u = np.abs(q) - half
    return float(np.linalg.norm(np.maximum(u, 0.0)) + min(u.max(), 0.0))


def test_a_meshed_ball_is_as_far_as_a_ball() -> None:
    """Its triangles of 48 sides are up to 1.1 mm inside the sphere."""
    shape, chance, seen = FORMS["ball"], np.random.default_rng(5), 0
    for _ in range(200):
        q = chance.uniform(-0.29, 0.29, size=3)
        true = float(np.linalg.norm(q)) - 0.25
        gap, normal = face(shape, local(shape, q))
        if abs(true) < 0.03:
            seen += 1
            assert -1e-5 < gap - true < 1.1e-3
            outward = q / np.linalg.norm(q) @ shape.bodies()[0].axes
            assert (
                math.degrees(math.acos(min(1.0, normal @ outward / np.linalg.norm(normal)))) < 4.0
            )
    assert seen > 20


def test_the_error_of_a_meshed_box_is_where_it_is_said_to_be() -> None:
    """At faces, four cells from the edges, none; nowhere at the surface above its bound.

    Edges are rounded by up to 0.4 of a cell.  A spline through the values rounds them by 0.2, but
    ripples beneath them: forces are then 20 % off, and energy is not conserved.
    """
    shape = FORMS["box"]
    assert isinstance(shape, MeshBody)
    half, cell, chance = np.array([0.25, 0.2, 0.15]), shape.form().cell, np.random.default_rng(6)
    assert 1e-3 < cell < 0.02
    flat = close = 0
    for _ in range(800):
        q = chance.uniform(-half - 0.02, half + 0.02)
        true = box_distance(q, half)
        gap, _ = face(shape, local(shape, q))
        order = np.sort(np.abs(np.abs(q) - half))
        if abs(true) < 1.5 * cell:
            close += 1
            assert abs(gap - true) < 0.4 * cell
            if order[1] > 6.0 * cell and true < order[0] + 1e-12:
                flat += 1
                assert abs(gap - true) < 1e-8  # an STL has 24 bits
    assert close > 100
    assert flat > 30
    assert shape.form().error < 0.05 * cell
    assert shape.form().largest < 0.4 * cell


@pytest.mark.parametrize("name", ["box", "ball", "cells"])
def test_far_from_a_grid_the_distance_is_a_lower_bound_and_continuous(name: str) -> None:
    """Beyond the box of the grid, too."""
    shape, chance = FORMS[name], np.random.default_rng(7)
    true = {
        "box": lambda q: box_distance(q, np.array([0.25, 0.2, 0.15])),
        "ball": lambda q: float(np.linalg.norm(q)) - 0.25,
        "cells": lambda q: box_distance(q - np.array([0.2, 0.3, 0.3]), np.array([0.2, 0.3, 0.3])),
    }[name]  # fmt: skip
    beyond = 0
    for _ in range(200):
        q = chance.uniform(-1.2, 1.2, size=3)
        gap, _ = face(shape, local(shape, q))
        if true(q) > 0.05:
            beyond += 1
            assert 0.6 * true(q) < gap < true(q) * 1.01 + 1e-3
            step = chance.normal(size=3) * 1e-7
            assert abs(face(shape, local(shape, q + step))[0] - gap) < 1e-6
    assert beyond > 100


@pytest.mark.parametrize("name", ["box", "two boxes"])
def test_beyond_a_grid_balls_and_other_thick_parts_meet_the_body_itself(name: str) -> None:
    """Up to half a metre from a small body to 0.1 cells; normals are gradients, mostly to 1e-9, and to 0.1°.

    A bound by the grid's box is up to 12 mm too low there: a ball of 0.1 m touched so much early.
    """
    half, places = np.array([0.1, 0.1, 0.1]), [np.zeros(3)]
    if name == "two boxes":  # the nearest place of the grid's box may lead to the other one
        half, places = np.array([0.05, 0.05, 0.2]), [np.array([0, y, 0]) for y in (-0.2, 0.2)]
    one = box_triangles(*(2.0 * half).tolist())
    path, number = folder() / f"{name}.stl", len(one.vertices)
    vertices = np.concatenate([one.vertices + at for at in places])
    faces = np.concatenate([one.faces + k * number for k in range(len(places))])
    path.write_bytes(stl_bytes(Triangles(vertices, faces)))
    shape = MeshBody(type="mesh", file=str(path), position=(0, 0, 0), surface=WALL)
    chance, errors, slopes = np.random.default_rng(7), [], []
    while len(errors) < 200:
        q = chance.uniform(-0.6, 0.6, size=3)
        true = min(box_distance(q - at, half) for at in places)
        if not 0.02 < true < 0.45:
            continue
        gap, normal = face(shape, q)
        errors.append(gap - true)
        assert np.linalg.norm(normal) == pytest.approx(1.0, abs=0.05)  # 1 beyond the grid
        steps = 1e-6 * np.eye(3)
        slope = [(face(shape, q + d)[0] - face(shape, q - d)[0]) / 2e-6 for d in steps]
        slopes.append(float(np.abs(slope - normal).max()))
    assert np.abs(errors).max() < 0.1 * shape.form().cell
    assert np.quantile(slopes, 0.95) < 1e-9
    # Between two bodies some places are equally far from both.
    assert np.max(slopes) < (math.radians(0.1) if name == "box" else 0.01)


def test_occupied_cells_end_at_their_faces() -> None:
    """Half a cell beyond the centre of the last one."""
    shape = FORMS["cells"]
    for q, expected in (
        ((-0.03, 0.3, 0.3), 0.03), ((0.43, 0.3, 0.3), 0.03), ((0.2, 0.3, 0.63), 0.03),
        ((0.02, 0.3, 0.3), -0.02),
    ):  # fmt: skip
        assert face(shape, local(shape, np.array(q)))[0] == pytest.approx(expected, abs=1e-3)


# -- rings and spheres ------------------------------------------------------------------------------


def turn(chance: np.random.Generator) -> Mat3:
    """A random attitude."""
    q = chance.normal(size=4)
    return rotation(Quat(*(q / np.linalg.norm(q)).tolist()))


def scene(*shapes: Any) -> SolidScene:
    """Scene of some shapes, in which gaps are exact."""
    built = obstacles(shapes)
    assert isinstance(built, SolidScene)
    return built._replace(exact=1.0)


def lowest_of(shape: ShapeSettings, centre: Vec, r: Mat3, count: int) -> float:
    """The least of the distances of some points of a ring."""
    turns = 2.0 * np.pi * np.arange(count) / count
    points = [centre + r @ Vec(RADIUS * math.cos(a), RADIUS * math.sin(a), 0.0) for a in turns]
    return min(face(shape, np.array(point))[0] for point in points)


def lowest_by_samples(shape: ShapeSettings, centre: Vec, r: Mat3) -> float:
    """The lowest distance along a ring: 360 samples, then a search around the best three."""

    def gap(angle: float) -> float:
        at = centre + r @ Vec(RADIUS * math.cos(angle), RADIUS * math.sin(angle), 0.0)
        return face(shape, np.array(at))[0]

    angles = np.linspace(0.0, 2.0 * np.pi, 360, endpoint=False)
    values = np.array([gap(a) for a in angles])
    lows = [k for k in range(360) if values[k] <= values[k - 1] and values[k] <= values[k - 359]]
    step, found = 2.0 * np.pi / 360, []
    for k in sorted(lows, key=lambda k: values[k])[:3]:
        best = scipy.optimize.minimize_scalar(
            gap, bounds=(angles[k] - step, angles[k] + step), method="bounded",
            options={"xatol": 1e-12},
        )  # fmt: skip
        found.append(float(best.fun))
    return min(found)


@pytest.mark.parametrize("name", FORMS)
def test_a_ring_meets_the_lowest_point_of_a_form(name: str) -> None:
    """As many samples find it, to 1e-8 m; the pitch is random."""
    shape, chance, seen = FORMS[name], np.random.default_rng(8), 0
    world = scene(shape)
    while seen < 6:
        centre, r = Vec(*near(shape, chance, 0.4, 0.1).tolist()), turn(chance)
        if not -0.01 < lowest_of(shape, centre, r, 24) < 0.05:
            continue
        low = lowest_by_samples(shape, centre, r)
        if not -0.01 < low < 0.03:
            continue
        seen += 1
        pose = ArmPose(Vec(1.0, 0.0, 0.0), STILL, STILL)
        there = obstacles_in_body_frame(world, centre, r)
        found = contact_faces(there, Ring(0.0), RADIUS, pose, 1.0)[0].nearest
        assert found.gap == pytest.approx(low, abs=1e-8)


def test_a_ring_below_a_height_map_meets_its_level_bottom() -> None:
    """As it meets the box; in the middle, where the sides are farther away than the ground."""
    level = height_file(np.full((8, 8), 0.25), folder() / "level.npy")
    flat = HeightMap(
        type="heightmap", file=level, size=(2.0, 2.0), position=(0, 0, 0), surface=WALL
    )
    box = Box(type="box", position=(0, 0, 0), size=(2.0, 2.0, 0.5), edge_radius=0.0, surface=WALL)
    chance = np.random.default_rng(12)
    for _ in nonempty(range(60)):
        centre = Vec(*chance.uniform([-0.6, -0.6, -0.4], [0.6, 0.6, -0.25]).tolist())
        r, pose = turn(chance), ArmPose(Vec(1.0, 0.0, 0.0), STILL, STILL)
        one, two = (
            contact_faces(obstacles_in_body_frame(w, centre, r), Ring(0.0), RADIUS, pose, 1.0)[0]
            for w in (scene(flat), scene(box))
        )
        assert one.nearest.gap == pytest.approx(two.nearest.gap, abs=1e-8)


@pytest.mark.parametrize("name", FORMS)
def test_the_gap_of_a_sphere_is_the_distance_of_its_centre(name: str) -> None:
    """Less its radius, pushed out along the gradient."""
    shape, chance, world = FORMS[name], np.random.default_rng(9), scene(FORMS[name])
    for _ in nonempty(range(20)):
        centre, r = Vec(*local(shape, chance.uniform(-0.4, 0.4, size=3)).tolist()), turn(chance)
        gap, normal = face(shape, np.array(centre))
        pose = ArmPose(Vec(1.0, 0.0, 0.0), STILL, STILL)
        there = obstacles_in_body_frame(world, centre, r)
        met = contact_faces(there, Sphere(STILL, 0.06), 0.06, pose, 1.0)[0].nearest
        assert met.gap == pytest.approx(gap - 0.06, abs=1e-12)
        assert met.steepness == pytest.approx(np.linalg.norm(normal), abs=1e-12)
        assert np.allclose(np.array(r @ met.inward), -normal / np.linalg.norm(normal), atol=1e-12)


@executor()
def by_routine(like: TreeLayout, address: float, given: Buffer, out: Buffer) -> None:
    """Write the faces of a part, found by the routine, into a buffer."""
    write(call_routine(address, read(like, given, 0, 1, 0), no_faces()), out, 0, 1, 0)


def test_plain_python_and_the_routine_give_the_same_bits() -> None:
    """All forms, all kinds of parts."""
    chance = np.random.default_rng(10)
    world = scene(*FORMS.values())
    for k in nonempty(range(12)):
        q = Vec(*(np.array(HERE) + chance.uniform(-0.6, 0.6, size=3)).tolist())
        for one in (world, scene([*FORMS.values()][k % len(FORMS)])):
            pose = ArmPose(Vec(1.0, 0.0, 0.0), STILL, STILL)
            part = VehiclePart(
                float(one.table), float(k % 3), 0.005, RADIUS, pose, q, turn(chance), 1.0
            )
            expected = leaves(scene_faces(part))
            given, out = np.array(leaves(part)), np.zeros(len(expected))
            by_routine(TreeLayout(part), SCENE_FACES.address, given, out)
            assert np.array_equal(out, expected)


# -- unions and nets --------------------------------------------------------------------------------


def test_a_union_is_its_shapes_moved_together() -> None:
    """Faces of the union are those of its shapes where they then are."""
    inner: list[dict[str, Any]] = [
        {"type": "box", "position": (0.5, 0.0, 0.0), "size": (0.2, 0.3, 0.4), "yaw": 0.3},
        {"type": "mesh", "file": box_file(0.5, 0.4, 0.3), "position": (-0.5, 0.1, 0.0)},
    ]
    union = ShapeUnion(type="union", position=(1.0, 2.0, 0.5), yaw=math.pi / 2, surface=WALL,
                       shapes=inner)  # fmt: skip
    apart = [
        Box(type="box", position=(1.0, 2.5, 0.5), size=(0.2, 0.3, 0.4), yaw=0.3 + math.pi / 2, surface=WALL),
        MeshBody(type="mesh", file=box_file(0.5, 0.4, 0.3), position=(0.9, 1.5, 0.5), yaw=math.pi / 2,
                 surface=WALL),
    ]  # fmt: skip
    chance, seen = np.random.default_rng(11), 0
    for _ in range(60):
        centre, r = Vec(*chance.uniform([0.5, 1.0, 0.0], [1.5, 3.0, 1.0]).tolist()), turn(chance)
        pose = ArmPose(Vec(1.0, 0.0, 0.0), STILL, STILL)
        one, two = (
            contact_faces(obstacles_in_body_frame(w, centre, r), Ring(0.0), RADIUS, pose, 1.0)
            for w in (scene(union), scene(*apart))
        )
        for a, b in zip(one, two, strict=True):
            seen += a.nearest.gap < FAR
            assert a.nearest.gap == pytest.approx(b.nearest.gap, abs=1e-9)
            assert np.allclose(a.nearest.inward, b.nearest.inward, atol=1e-6)
    assert seen > 60


def test_the_law_of_a_net_follows_from_its_numbers() -> None:
    """Tight: δ = P ln(a/r)/(2πT).  Slack: P = 4 r S δ³/a³.  Nearly nothing is given back."""
    tight = Net(type="net", position=HERE, size=(2.0, 1.2), tension=80.0, contact_radius=0.1).law()
    force = 20.0
    dip = force * math.log(0.6 / 0.1) / (2.0 * math.pi * 80.0)
    assert tight.stiffness * dip**tight.exponent == pytest.approx(force, rel=1e-12)
    slack = Net(type="net", position=HERE, size=(2.0, 1.2), thread_stiffness=5e4).law()
    assert slack.stiffness * 0.1**slack.exponent == pytest.approx(
        4 * 0.1 * 5e4 * (0.1 / 0.6) ** 3, rel=1e-12
    )
    assert (tight.restitution, tight.restitution_speed) == (0.05, 2.0)


def test_a_net_is_met_at_its_face_however_deep_it_is_pressed_in() -> None:
    """To its depth; behind that is nothing, and beside it its sides."""
    net = Net(type="net", position=(2.0, 0.0, 1.0), size=(2.0, 2.0), depth=0.4, tension=50.0)
    for x, expected in ((1.9, 0.1), (2.1, -0.1), (2.39, -0.39), (2.5, 0.1)):
        gap, normal = face(net, np.array([x, 0.1, 1.05]))
        assert gap == pytest.approx(expected, abs=1e-12)
        assert np.allclose(normal, [-1.0 if x < 2.4 else 1.0, 0.0, 0.0])
    assert face(net, np.array([2.2, 1.3, 1.0]))[0] == pytest.approx(0.3, abs=1e-12)

"""Scenes: what parts of a vehicle meet, against looking through all solids, planes and own shapes."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pytest

from builders.shapes import SHAPES
from springback.contact.cage import (
    ArmTip,
    ContactFace,
    Ring,
    contact_faces,
    lowest_gap,
    obstacles_in_body_frame,
)
from springback.contact.forest import Forest
from springback.contact.library import WALL
from springback.contact.parameters import Ground, Wall
from springback.contact.rings import FAR
from springback.contact.scene.faces import (
    EXACT_BELOW,
    SCENE_FACES,
    SolidScene,
    VehiclePart,
    no_faces,
    scene_faces,
)
from springback.contact.scene.nearest import MOST_NEAR, distance_of, nearest_solid, solids_within
from springback.contact.scene.sections import FARTHEST
from springback.contact.scene.solids import solid_face
from springback.contact.shapes import Box, Capsule
from springback.contact.worlds import obstacles
from springback.kernels.compiler import executor
from springback.kernels.layout import Buffer, TreeLayout, read, write
from springback.kernels.routines import call_routine, number_at
from springback.kernels.trees import leaves
from springback.kernels.vectors import Mat3, Quat, Vec, rotation
from springback.vehicle.state import ArmPose, Sphere

RADIUS = 0.11
STILL = Vec(0.0, 0.0, 0.0)
#: Near all shapes of `SHAPES`.
MIDDLE = np.array([0.3, -0.2, 1.1])


def turn(chance: np.random.Generator) -> Mat3:
    """A random attitude."""
    q = chance.normal(size=4)
    return rotation(Quat(*map(float, q / np.linalg.norm(q))))


def vec(array: Any) -> Vec:
    """A vector of three numbers."""
    return Vec(*map(float, array))


def scene(*entries: Any) -> SolidScene:
    """A scene of some obstacles, whose gaps are exact."""
    built = obstacles(entries)
    assert isinstance(built, SolidScene)
    return built._replace(exact=1.0)


def faces(world: Any, centre: Vec, r: Mat3, part: Any, radius: float = RADIUS) -> list[ContactFace]:
    """The faces that a part at a centre meets, nearest first; `FAR` ones are left out."""
    pose = ArmPose(Vec(1.0, 0.0, 0.0), STILL, STILL)
    found = contact_faces(obstacles_in_body_frame(world, centre, r), part, radius, pose, 1.0)
    near = [one for one in found if one.nearest.gap < FAR]
    return sorted(near, key=lambda one: one.nearest.gap)


# -- the tree ---------------------------------------------------------------------------------------


def rows(world: SolidScene) -> list[int]:
    """Rows of all solids of a scene that are no half-spaces."""
    return [int(number_at(world.table, 3)) + 24 * k for k in range(int(number_at(world.table, 1)))]


@pytest.mark.parametrize("density", [0.0025, 0.05, 1.0])
def test_the_nearest_of_many_solids_is_found(density: float) -> None:
    """One, some and hundreds of trunks beside rods of all directions, against all of them."""
    chance = np.random.default_rng(1)
    forest = Forest(type="forest", density=density, size=(20.0, 20.0), surface=WALL, spacing=0.1)
    world = scene(forest, SHAPES["capsule"], SHAPES["box"], SHAPES["hoop"])
    known = rows(world)
    assert len(known) > 3
    for _ in range(100):
        point = vec(chance.uniform([-1.0, -10.0, 0.0], [21.0, 10.0, 3.0]))
        gaps = {row: solid_face(world.table, row, point).gap for row in known}
        found = nearest_solid(world.table, point, FARTHEST)
        assert found.gap == min(gaps.values()) == gaps[found.row]
        assert distance_of(world, point) == found.gap
        more = chance.uniform(0.0, 4.0)
        assert solids_within(world.table, point, found, more).number == sum(
            gap <= found.gap + more for gap in gaps.values()
        )


def test_no_solid_is_near_in_a_world_of_half_spaces() -> None:
    """A slope alone has no tree."""
    world = scene(SHAPES["slope"])
    nearest = nearest_solid(world.table, STILL, FARTHEST)
    assert nearest.gap == FAR
    assert solids_within(world.table, STILL, nearest, 100.0).number == 0


# -- rings ------------------------------------------------------------------------------------------

ONE_SOLID = [name for name in SHAPES if name not in ("slope", "stairs")]


@pytest.mark.parametrize("name", ONE_SOLID)
def test_a_ring_meets_a_solid_where_many_of_its_points_say(name: str) -> None:
    """The least distance of 20 000 points of the ring, and the normal there."""
    chance, world = np.random.default_rng(3), scene(SHAPES[name])
    row, angles = rows(world)[0], np.linspace(0.0, 2.0 * math.pi, 20_000, endpoint=False)
    place = np.array([0.3, -0.2, 1.1])
    for _ in range(4):
        centre, r = vec(place + chance.uniform(-0.5, 0.5, size=3)), turn(chance)
        first = faces(world, centre, r, Ring(0.0))[0].nearest
        turned = np.array(r)
        points = np.array(centre) + RADIUS * (
            np.cos(angles)[:, None] * turned[:, 0] + np.sin(angles)[:, None] * turned[:, 1]
        )
        # Coarse, then fine around the least: the kernel is slow in plain Python.
        coarse = [solid_face(world.table, row, vec(p)).gap for p in points[::100]]
        k = 100 * int(np.argmin(coarse))
        around = [points[i % 20_000] for i in range(k - 150, k + 150)]
        true = min(solid_face(world.table, row, vec(p)).gap for p in around)
        assert first.gap <= true + 1e-12
        assert first.gap == pytest.approx(true, abs=1e-7 if true > 0.0 else 2e-5)  # kinks inside
        touched = centre + r @ first.at.normal_lever
        normal = solid_face(world.table, row, touched).normal
        assert np.allclose(r @ first.inward, -normal, atol=1e-9)
        assert first.at.normal_lever @ first.at.normal_lever == pytest.approx(RADIUS**2)


def test_a_ring_in_an_inner_corner_meets_both_walls_and_the_ground() -> None:
    """Three faces at once: two boxes and a half-space, each with its own gap."""
    wall = {"type": "box", "size": [4.0, 0.2, 4.0], "edge_radius": 0.0, "surface": WALL}
    world = scene(
        Box(**{**wall, "position": [0.0, 0.1, 0.0]}),  # face y = 0
        Box(**{**wall, "position": [0.1, 0.0, 0.0], "yaw": 0.5 * math.pi}),  # face x = 0
        Ground(type="ground", height=-0.5, surface=WALL),
    )
    r = rotation(Quat(1.0, 0.0, 0.0, 0.0))
    centre = Vec(-RADIUS - 0.002, -RADIUS - 0.003, -0.49)
    found = faces(world, centre, r, Ring(0.005))
    on_ground = 0.01 - 0.005 * RADIUS  # it lies flat: the rounding takes 5 mrad of its radius
    assert [one.nearest.gap for one in found] == pytest.approx([0.002, 0.003, on_ground], abs=1e-7)
    assert [one.is_ground for one in found] == [0.0, 0.0, 1.0]
    inward = [np.array(r @ one.nearest.inward) for one in found]
    assert np.allclose(inward, [[1, 0, 0], [0, 1, 0], [0, 0, -1]], atol=1e-6)


@pytest.mark.parametrize("part", [Ring(0.005), ArmTip(0.0), Sphere(STILL, RADIUS)])
def test_a_half_space_of_a_scene_is_a_plane(part: Any) -> None:
    """Gap, normal and levers are those of a plane, to rounding."""
    chance = np.random.default_rng(5)
    wall = Wall(type="wall", position=(0.2, 0.1, 0.3), normal=(1.0, 2.0, -1.0), surface=WALL)
    world = scene(wall, SHAPES["sphere"])
    for _ in range(20):
        centre, r = vec(np.array([0.2, 0.1, 0.3]) + chance.uniform(-0.3, 0.3, size=3)), turn(chance)
        pose = ArmPose(Vec(1.0, 0.0, 0.0), Vec(0.19, 0.0, 0.0), STILL)
        one = obstacles_in_body_frame(obstacles((wall,)), centre, r)
        expected = contact_faces(one, part, RADIUS, pose, 1.0)[0].nearest
        many = contact_faces(obstacles_in_body_frame(world, centre, r), part, RADIUS, pose, 1.0)
        near = [face.nearest for face in many]
        same = min(near, key=lambda face: abs(face.gap - expected.gap))
        assert np.allclose([*same.inward], [*expected.inward], atol=1e-14)
        assert same.gap == pytest.approx(expected.gap, abs=1e-14)
        assert np.allclose([*same.at.normal_lever], [*expected.at.normal_lever], atol=1e-14)
        assert np.allclose([*same.at.friction_lever], [*expected.at.friction_lever], atol=1e-14)


def test_a_ring_that_lies_flat_on_a_box_touches_as_on_the_ground() -> None:
    """Over a whole face the contact is that of a plane, rounding included; beyond the rim it is not."""
    box = Box(type="box", position=(0.0, 0.0, -0.5), size=(1.0, 1.0, 1.0), surface=WALL)
    ground = obstacles((Ground(type="ground", surface=WALL),))
    level, chance = rotation(Quat(1.0, 0.0, 0.0, 0.0)), np.random.default_rng(6)
    tilted = rotation(Quat(0.9999, 0.01, -0.007, 0.0))
    for r, _ in itertools.product((level, tilted), range(5)):
        centre = vec([*chance.uniform(-0.38, 0.38, size=2), 0.01])
        pose = ArmPose(Vec(1.0, 0.0, 0.0), STILL, STILL)
        there = obstacles_in_body_frame(ground, centre, r)
        plane = contact_faces(there, Ring(0.005), RADIUS, pose, 1.0)[0].nearest
        found = faces(scene(box), centre, r, Ring(0.005))
        assert len(found) == 1
        assert found[0].nearest.gap == pytest.approx(plane.gap, abs=1e-12)
        assert np.allclose([*found[0].nearest.at.normal_lever], [*plane.at.normal_lever], atol=1e-9)
    beside = faces(scene(box), Vec(0.55, 0.0, 0.01), level, Ring(0.005))
    assert beside[0].nearest.gap == pytest.approx(0.01, abs=1e-9)


# -- spheres ----------------------------------------------------------------------------------------


def test_a_sphere_meets_two_solids_that_are_apart_and_one_where_they_are_flush() -> None:
    """Between two boxes there are two faces; on two flush ones that overlap, one."""
    sizes = {"type": "box", "size": (1.0, 1.0, 1.0), "surface": WALL}
    left = Box(**sizes, position=(0.0, 0.62, 0.0))
    right = Box(**sizes, position=(0.0, -0.63, 0.0))
    level = rotation(Quat(1.0, 0.0, 0.0, 0.0))
    found = faces(scene(left, right), STILL, level, Sphere(STILL, 0.1), 0.1)
    assert [one.nearest.gap for one in found] == pytest.approx([0.02, 0.03], abs=1e-12)
    flush = Box(**sizes, position=(0.3, 0.62, 0.0))
    found = faces(scene(left, flush), STILL, level, Sphere(STILL, 0.1), 0.1)
    assert [one.nearest.gap for one in found] == pytest.approx([0.02], abs=1e-12)


@pytest.mark.parametrize("name", SHAPES)
def test_the_gap_of_a_sphere_is_the_distance_less_its_radius(name: str) -> None:
    """Exact for every true distance."""
    chance, world = np.random.default_rng(8), scene(SHAPES[name])
    for _ in range(20):
        centre = vec(MIDDLE + chance.uniform(-0.6, 0.6, size=3))
        found = faces(world, centre, turn(chance), Sphere(STILL, 0.06), 0.06)
        assert found[0].nearest.gap == pytest.approx(distance_of(world, centre) - 0.06, abs=1e-12)


# -- clearance, and the compiled twin ---------------------------------------------------------------


@pytest.mark.parametrize("part", [Ring(0.005), Sphere(STILL, RADIUS)])
def test_a_clearance_is_exact_near_and_never_more_than_the_gap(part: Any) -> None:
    """Above `EXACT_BELOW` it is a lower bound."""
    chance, world = np.random.default_rng(9), scene(SHAPES["box"], SHAPES["sphere"])
    pose, bounds, near = ArmPose(Vec(1.0, 0.0, 0.0), STILL, STILL), 0, 0
    for _ in range(80):
        centre, r = vec(MIDDLE + chance.uniform(-1.5, 1.5, size=3)), turn(chance)
        while near < 20 and abs(distance_of(world, centre) - RADIUS) > EXACT_BELOW:
            centre = vec(MIDDLE + chance.uniform(-1.0, 1.0, size=3))
        there = obstacles_in_body_frame(world._replace(exact=0.0), centre, r)
        low, gap = (
            lowest_gap(there, part, RADIUS, pose),
            faces(world, centre, r, part)[0].nearest.gap,
        )
        assert low <= gap + 1e-12
        bounds += low < gap - 1e-9
        if gap < EXACT_BELOW:
            assert low == pytest.approx(gap, abs=1e-12)
            near += 1
    assert near >= 20
    assert bounds > 0 or not isinstance(part, Ring)


@executor()
def by_routine(like: TreeLayout, address: float, given: Buffer, out: Buffer) -> None:
    """Write the faces of a part, found by the routine, into a buffer."""
    write(call_routine(address, read(like, given, 0, 1, 0), no_faces()), out, 0, 1, 0)


def test_plain_python_and_the_routine_give_the_same_bits() -> None:
    """All kinds of parts, near a crowd of shapes and far from it."""
    chance, world = np.random.default_rng(10), scene(*SHAPES.values())
    like = TreeLayout(part_of(world, STILL, turn(chance), 0.0))
    seen = 0
    for k in range(60):
        centre = vec(MIDDLE + chance.uniform(-0.8, 0.8, size=3))
        part = part_of(world, centre, turn(chance), float(k % 3))
        expected = leaves(scene_faces(part))
        given, out = np.array(leaves(part)), np.zeros(len(expected))
        by_routine(like, SCENE_FACES.address, given, out)
        assert np.array_equal(out, expected)
        nearest = nearest_solid(world.table, centre, FARTHEST)
        seen += solids_within(world.table, centre, nearest, 0.3).number > 1
    assert seen > 10


def part_of(world: SolidScene, centre: Vec, r: Mat3, kind: float) -> VehiclePart:
    """A part of a vehicle at a place."""
    pose = ArmPose(Vec(1.0, 0.0, 0.0), STILL, STILL)
    return VehiclePart(float(world.table), kind, 0.005, RADIUS, pose, centre, r, 1.0)


def test_more_solids_than_a_part_can_list_are_looked_through() -> None:
    """Twelve rods that all pass a ring closely: the nearest is found as among few."""
    rods = [
        Capsule(type="capsule", start=(x, -1.0, z), end=(x, 1.0, z), radius=0.01, surface=WALL)
        for x, z in itertools.product((-0.15, -0.05, 0.05, 0.15), (-0.1, 0.0, 0.1))
    ]
    world = scene(*rods)
    centre, r = Vec(0.01, 0.02, 0.03), rotation(Quat(0.9, 0.3, 0.1, 0.2))
    nearest = nearest_solid(world.table, centre, FARTHEST)
    assert solids_within(world.table, centre, nearest, 0.3).number > MOST_NEAR
    gaps = [faces(scene(rod), centre, r, Ring(0.0))[0].nearest.gap for rod in rods]
    assert faces(world, centre, r, Ring(0.0))[0].nearest.gap == pytest.approx(min(gaps), abs=1e-10)

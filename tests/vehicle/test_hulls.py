"""Hulls of a vehicle: what the settings mean, and what they refuse in one line."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from builders.cases import nonempty
from builders.hull_oracle import HULLS
from springback.errors import InputError
from springback.kernels.vectors import Vec
from springback.scenario.scenario import scenario_from
from springback.vehicle.hulls import BoxHull, PointsHull, compound_hull, hull_reach
from springback.vehicle.state import CompoundHull, Sphere

BOX = {"type": "box", "size": [0.1, 0.1, 0.05]}
CORNERS = [[0.05, 0.05, 0.0], [-0.05, 0.05, 0.0], [0.0, -0.05, 0.0], [0.0, 0.0, 0.1]]


def scenario(*hulls: dict[str, Any], **vehicle: Any) -> Any:
    """A robot with some hulls, far from the ground."""
    return scenario_from({
        "vehicle": {"preset": "quad", "hulls": list(hulls), **vehicle},
        "world": {"obstacles": [{"type": "ground", "surface": "wall"}]},
        "start": {"position": [0.0, 0.0, 5.0]},
    })  # fmt: skip


@pytest.mark.parametrize(
    ("hull", "message"),
    [
        ({**BOX, "size": [0.1, 0.0, 0.05]}, "size: must be more than 0 m (got 0 m)"),
        ({**BOX, "edge_radius": 0.025}, "edge_radius: must be less than 0.025 m"),
        ({**BOX, "on": 7}, "hulls[0].on: must be body, or an arm from 1 to 4 (got 7)"),
        ({**BOX, "on": 0}, 'on: must be "body", or the number of an arm from 1 (got 0)'),
        ({**BOX, "on": "arm"}, "from 1 (got 'arm')"),
        ({**BOX, "position": [1.0, 0.0, 0.0]}, "hulls[0]: must be within 0.3 m"),
        ({"type": "sphere", "radius": -0.1}, "radius: must be more than 0 m (got -0.1 m)"),
        ({"type": "ring", "radius": 0.1, "axis": [0, 0, 0]}, "axis: must not be zero (got [0.0"),
        ({"type": "capsule", "start": [0, 0, 0], "end": [0, 0, 0], "radius": 0.1}, "end: must differ"),
        ({"type": "points", "points": CORNERS[:3]}, "points: must be at least 4 points and at most"),
        ({"type": "points", "points": [*CORNERS[:3], [0.01, 0.0, 0.0]]}, "points: must not all be in"),
        ({"type": "points", "points": [*CORNERS, [0.0, 1.0]]}, "points[4]: must be three numbers"),
        ({**BOX, "surface": {}}, "surface.stiffness: is missing"),
        ({**BOX, "surface": {"stiffness": 0}}, "surface.stiffness: must be more than 0"),
        ({**BOX, "surface": {"stiffness": 1e4, "viscosity": 2.0}}, "viscosity: needs exponent = 1"),
        ({**BOX, "surface": {"stiffness": 1e4, "exponent": 2.0}},
         "vehicle.hulls[0].surface.exponent: must be 1.5, that of world.obstacles[0].surface"),
        ({"type": "cylinder"}, "type: must be sphere, ring, capsule, box or points (got 'cylinder')"),
        ({**BOX, "radius": 0.1}, "radius: unknown key"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused_in_one_line(hull: dict[str, Any], message: str) -> None:
    """Key, value, unit and range."""
    with pytest.raises(InputError) as caught:
        scenario(hull).build()
    (line,) = caught.value.problems
    assert line.startswith("vehicle.hulls[0]")
    assert message in line


def test_too_many_hulls_are_refused() -> None:
    """A part has 32 at most."""
    with pytest.raises(InputError, match="hulls: must be at most 32 on one part"):
        scenario(*[BOX] * 33)


def test_hulls_of_a_part_are_one_part_and_arms_are_alike() -> None:
    """Any number of them is the same structure; the spherical hull is among the body's."""
    airframe = scenario({**BOX, "on": 2}, BOX, BOX).vehicle.airframe()
    (body,) = airframe.hull
    assert isinstance(body, CompoundHull)
    assert body.table.numbers[0] == 3.0
    counts = [arm.hull[0].table.numbers[0] for arm in airframe.arms]
    assert counts == [0.0, 1.0, 0.0, 0.0]
    alone = scenario().vehicle.airframe()
    assert isinstance(alone.hull[0], Sphere)
    assert all(arm.hull == () for arm in alone.arms)
    assert scenario(hull=False).vehicle.airframe().hull == ()


def test_points_inside_do_not_count_and_flat_sides_are_one_face() -> None:
    """A cube of triangles has six sides."""
    cube = [[x, y, z] for x in (0.0, 0.1) for y in (0.0, 0.1) for z in (0.0, 0.1)]
    form = PointsHull(type="points", points=[*cube, [0.05, 0.05, 0.05]]).form()
    assert len(form.points) == 8
    assert sorted(len(face.corners) for face in form.faces) == [4] * 6
    assert len(form.edges()) == 12
    box = BoxHull(type="box", size=(0.1, 0.1, 0.1), position=(0.05, 0.05, 0.05)).form()
    assert len(box.edges()) == 12
    for body in (form, box):
        for face in nonempty(body.faces):
            a, b, c = body.points[face.corners[:3]]
            assert np.cross(b - a, c - b) @ face.normal > 0.0


@pytest.mark.parametrize("name", HULLS)
def test_reach_is_the_farthest_point_and_a_sphere_holds_all(name: str) -> None:
    """By sampled points of the surface."""
    chance = np.random.default_rng(3)
    form, compound = HULLS[name].form(), compound_hull([HULLS[name]])
    if len(form.points):
        core, radius = form.points, form.radius
    else:
        angles = np.linspace(0.0, 2.0 * np.pi, 2000)[:, None]
        x, y, _ = form.axes
        core = form.centre + form.radius * (np.cos(angles) * x + np.sin(angles) * y)
        radius = 0.0
    for n in Rotation.random(20, random_state=chance).as_matrix()[:, 0]:
        assert hull_reach(compound, Vec(*n.tolist())) == pytest.approx(
            float((core @ n).max()) + radius, abs=1e-6
        )
    away = np.linalg.norm(core - np.array(compound.centre), axis=1)
    assert away.max() + radius <= compound.radius + 1e-12

"""Gaps and normals of every part against every built-in shape, beside an oracle that shares nothing.

Some hundred poses of each pair; ten thousand by `make geometry` (docs/validation.md).
"""

from __future__ import annotations

import math
import warnings
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from oracles import distances, geometry

with warnings.catch_warnings():  # it compiles something of its own at once, and says so
    warnings.simplefilter("ignore")
    from distance3d.distance import (
        line_segment_to_circle,
        line_to_circle,
        point_to_box,
        point_to_circle,
        point_to_cylinder,
    )

WORLDS = geometry.worlds()
POSES = 200
#: By how much distances to circles of distance3d, found by search, are too long here [m].
CIRCLE = 1e-6


@pytest.mark.parametrize("part", geometry.PARTS)
@pytest.mark.parametrize("name", WORLDS)
def test_gap_and_normal_are_those_of_the_oracle(name: str, part: str) -> None:
    """Within 1e-6 m, 1e-4 m at corners, and 0.1°; no gap is overstated."""
    found = geometry.compare(part, WORLDS[name], POSES, seed=7)
    assert found.poses == POSES
    assert found.touching > 20
    assert found.ties < POSES
    assert geometry.kept(found), geometry.line(name, part, found)


def test_a_wrong_gap_is_noticed() -> None:
    """A shape that is 2 µm off, or turned by 0.2°, breaks what is promised."""
    box: Any = WORLDS["box"]
    true = geometry.bodies_of
    for changes in ({"edge_radius": 0.0202}, {"yaw": box.yaw + 0.0035}):
        other = box.model_copy(update=changes)
        try:
            geometry.bodies_of = lambda shape, other=other: true(other)
            assert not geometry.kept(geometry.compare("ring", box, POSES, seed=7))
        finally:
            geometry.bodies_of = true


def test_a_rounded_ring_is_never_farther_than_the_sharp_one() -> None:
    """The rounding of a cage acts on flat faces only, and only makes a gap smaller."""
    for name in nonempty(("box", "wall", "sphere")):
        shape = WORLDS[name]
        world = geometry.obstacles((shape,), as_scene=True)
        poses = geometry.random_poses(np.random.default_rng(3), 500)
        sharp = geometry.package_faces(world, "ring", poses)
        rounded = geometry.package_faces(world, "ring", poses, rounding=0.005)
        assert (rounded.gap <= sharp.gap + 1e-15).all()
        assert (rounded.gap >= sharp.gap - 0.005 * geometry.RADIUS - 1e-15).all()


# -- the oracle against another library ------------------------------------------------------------


def test_the_oracle_is_that_of_distance3d() -> None:
    """Where both have the pair: points to box and cylinder, circles to point, line and segment."""
    chance = np.random.default_rng(5)
    poses = geometry.random_poses(chance, 40)
    rings = poses.rings()
    frame = np.eye(4)
    frame[:3, :3] = distances.attitude_axes(WORLDS["sharp"])
    frame[:3, 3] = WORLDS["sharp"].position
    size = np.array(WORLDS["sharp"].size)
    box = distances.least(geometry.bodies_of(WORLDS["sharp"]))(poses.centre)
    pole, rod, branch, ball = (WORLDS[name] for name in ("pole", "rod", "capsule", "sphere"))
    upright = np.eye(4)
    upright[:3, :3] = distances.frame_along(pole.axis)
    upright[:3, 3] = np.array(pole.position) + 0.5 * pole.height * upright[:3, 2]
    blunt = pole.model_copy(update={"edge_radius": 1e-9})
    can = distances.least(geometry.bodies_of(blunt))(poses.centre)
    lows = {
        one.type: distances.ring_minima(distances.least(geometry.bodies_of(one)), rings).gap[:, 0]
        for one in (rod, branch, ball)
    }
    axis = np.array(rod.axis) / math.sqrt(6.0)
    for k, c in nonempty(enumerate(poses.centre)):
        turned = poses.turn[k]
        circle = (c, geometry.RADIUS, np.ascontiguousarray(turned[:, 2]))
        if box[k] > 0.0:
            assert box[k] == pytest.approx(point_to_box(c, frame, size)[0], abs=1e-9)
        if can[k] > 0.0:
            there = point_to_cylinder(c, upright, pole.radius, pole.height)[0]
            assert can[k] == pytest.approx(there, abs=1e-8)
        theirs = line_to_circle(np.array(rod.position), axis, *circle)[0] - rod.radius
        assert theirs - CIRCLE <= lows["pole"][k] <= theirs + 1e-12
        theirs = point_to_circle(np.array(ball.position), *circle)[0] - ball.radius
        assert lows["sphere"][k] == pytest.approx(theirs, abs=1e-9)
        start, end = np.array(branch.start), np.array(branch.end)
        theirs = line_segment_to_circle(start, end, *circle)[0] - branch.radius
        assert theirs - CIRCLE <= lows["capsule"][k] <= theirs + 1e-12

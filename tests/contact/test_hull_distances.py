"""Gaps and normals of every hull against every shape, by the routine and by dense samples."""

from __future__ import annotations

import math
import os

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from builders.cases import nonempty
from builders.hull_oracle import HULLS, distance, is_within, lowest, normal
from builders.shapes import SHAPES
from springback.contact.hulls.compound import SCENE_HULL_FACES
from springback.contact.hulls.contacts import HullFaces, HullPart, no_hull_faces
from springback.contact.scene.faces import SCENE_FACES, SolidScene
from springback.contact.worlds import obstacles
from springback.kernels.compiler import executor
from springback.kernels.layout import Buffer, TreeLayout, read, write
from springback.kernels.routines import call_routine
from springback.kernels.trees import leaves, rebuilt
from springback.kernels.vectors import Mat3, Vec
from springback.vehicle.hulls import compound_hull

#: Poses of each hull at each shape: 14 x 5 x 8; and in the slow test (`make geometry`: 10 000).
POSES, MANY = 8, int(os.environ.get("POSES", "40"))
#: Depth of the deepest poses, and distance of the farthest [m].
DEEP, FAR = 0.004, 0.04
#: Shapes along whose edges and across whose openings the distance has several lowest points.
OPEN = ("hoop", "window", "round", "doorway")


@executor(nogil=True)
def search(like: TreeLayout, asked: Buffer, out: Buffer, address: float) -> None:
    """Faces of hulls at some poses; rows of the buffers hold the leaves."""
    for i in range(asked.shape[0]):
        part = read(like, asked[i], 0, 1, 0)
        write(call_routine(address, part, no_hull_faces()), out[i], 0, 1, 0)


def faces_at(parts: list[HullPart]) -> list[HullFaces]:
    """The deepest faces at each of some poses."""
    out = np.zeros((len(parts), len(leaves(no_hull_faces()))))
    asked = np.array([leaves(part) for part in parts])
    search(TreeLayout(parts[0]), asked, out, SCENE_HULL_FACES.address)
    return [rebuilt(no_hull_faces(), row) for row in out.tolist()]


def scene(shape: str) -> SolidScene:
    """A world of one shape."""
    found = obstacles((SHAPES[shape],), as_scene=True)
    assert isinstance(found, SolidScene)
    return found


def poses(shape: str, hull: str, count: int) -> list[tuple[HullPart, np.ndarray, np.ndarray]]:
    """Random poses of a hull near a shape, some of them pressed in a little."""
    chance = np.random.default_rng([list(SHAPES).index(shape), list(HULLS).index(hull)])
    form, compound, world = HULLS[hull].form(), compound_hull([HULLS[hull]]), scene(shape)
    middle = np.mean([body.centre for body in SHAPES[shape].bodies()], axis=0)
    found: list[tuple[HullPart, np.ndarray, np.ndarray]] = []
    points = form.points if len(form.points) else form.centre + form.radius * np.eye(3)
    while len(found) < count:
        turn = Rotation.random(random_state=chance).as_matrix()
        at = middle + chance.uniform(-0.5, 0.5, size=3)
        away = chance.normal(size=3)
        away /= np.linalg.norm(away)
        for _ in range(12):  # along a line, until it is near
            gap = float(distance(SHAPES[shape], at + points @ turn.T).min()) - form.radius
            if -DEEP < gap < FAR:
                break
            at = at + away * (0.5 * (DEEP + FAR) - gap) * 0.7
        else:
            continue
        part = HullPart(
            world.table, compound.table, compound.centre, compound.radius, Vec(0.0, 0.0, 0.0),
            Vec(*at.tolist()), Mat3(*(Vec(*row) for row in turn.tolist())), 1.0, 0.0,
            SCENE_FACES.address,
        )  # fmt: skip
        found.append((part, at, turn))
    return found


def check(shape: str, hull: str, count: int) -> None:
    """Gap to 1e-6 m, never overstated by more; normal to 0.1 degrees where there is one."""
    given = poses(shape, hull, count)
    seen = faces_at([part for part, _, _ in given])
    form, compared = HULLS[hull].form(), 0
    for (_, at, turn), faces in zip(nonempty(given), seen, strict=True):
        gap, where = lowest(form, SHAPES[shape], at, turn)
        if gap < -2.0 * DEEP:
            continue  # a corner that was not near went through
        found = faces.first.nearest
        inward = turn @ np.array(found.inward)
        core = at + turn @ np.array(found.at.point) - form.radius * inward * (hull != "ring")
        # What is said to be nearest is as near, and a point of the hull: samples may miss it.
        there = float(distance(SHAPES[shape], core[None])[0]) - form.radius * (hull != "ring")
        if there < gap and is_within(form, (core - at) @ turn):
            gap, where = there, core
        # Deep inside a shape that is open a face may have more lowest points than are looked for;
        # beyond the thickness of a shape the nearest side is another one.
        close = 1e-6 if gap > 0.0 or shape not in OPEN else 2e-3
        assert found.gap - gap < close, (shape, hull, at, found.gap, gap)
        assert gap - found.gap < 1e-6, (shape, hull, at, found.gap, gap)
        theirs = normal(SHAPES[shape], where)
        smooth = abs(np.linalg.norm(theirs) - 1.0) < 1e-6 and found.steepness > 1.0 - 1e-6
        same = np.linalg.norm(core - where) < 1e-5  # of two that are equally near
        if smooth and same and gap > 1e-3:
            assert math.degrees(math.acos(min(float(-inward @ theirs), 1.0))) < 0.1
            compared += 1
    assert compared


@pytest.mark.parametrize("shape", SHAPES)
def test_gaps_and_normals_are_those_of_dense_samples(shape: str) -> None:
    """Every hull at random poses around every shape."""
    for hull in HULLS:
        check(shape, hull, POSES)


@pytest.mark.parametrize("shape", SHAPES)
def test_gaps_and_normals_at_very_many_poses(shape: str) -> None:
    """The same, some ten thousand times in all."""
    for hull in HULLS:
        check(shape, hull, MANY)

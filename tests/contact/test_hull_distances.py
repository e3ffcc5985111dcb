"""Gaps and normals of every hull against every shape, by the routine and by dense samples."""

from __future__ import annotations

import functools
import os
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import pytest

from builders.cases import nonempty
from builders.hull_oracle import DEEP, HULLS, is_within, lowest_in, normals, poses_near
from builders.shapes import SHAPES
from oracles.distances import bodies_of, least
from springback.contact.cage import NearestFace
from springback.contact.hulls.compound import SCENE_HULL_FACES
from springback.contact.hulls.contacts import HullFaces, HullPart, no_hull_faces
from springback.contact.scene.faces import SCENE_FACES, SolidScene
from springback.contact.worlds import obstacles
from springback.kernels.compiler import executor
from springback.kernels.layout import Buffer, TreeLayout, read, write
from springback.kernels.routines import call_routine
from springback.kernels.trees import leaves, rebuilt
from springback.kernels.vectors import Mat3, Vec, norm
from springback.vehicle.hulls import compound_hull

Array = np.ndarray[Any, np.dtype[np.float64]]
#: Poses of each hull at each shape: 14 x 5 x 8; and in the slow test (`make geometry`: 10 000).
POSES, MANY = 8, int(os.environ.get("POSES", "40"))


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


class Deepest(NamedTuple):
    """The deepest face of a hull."""

    face: NearestFace
    gap: float  # of the hull there [m]


def deepest_faces(faces: HullFaces, gap_at: Callable[[Array], Any]) -> list[Deepest]:
    """The first of some faces, and those that may be deeper, as they count from a saddle.

    Where the lowest points of two faces of a hull are below that of the edge between them, one is
    in place of the edge, and the other counts from there: it is deeper by the edge's depth.  A
    face that counts from another place, as at a corner where three meet, is not: with the depth of
    its saddle it would be deeper than the hull, by 0.1 mm of 3 at one of some 600 000 poses.  The
    hull is as deep as the first, or as such a face.

    Args:
        faces: Of the hull.
        gap_at: Gap of the hull at a point of its core, body axes.
    """
    found = [Deepest(faces.first.nearest, faces.first.nearest.gap)]
    for face in (faces.second.nearest, faces.third.nearest):
        if face.gap < 0.0 and face.steepness > 0.1 and norm(face.saddle_inward) > 0.9:
            beyond = min(float(gap_at(np.array([face.saddle_lever]))[0]), 0.0)
            found.append(Deepest(face, face.gap + beyond))
    return found


def gap_of_core(field: Any, radius: float, position: Array, turn: Array, x: Array) -> Any:
    """Gap of a hull at points of its core, body axes, where it is."""
    return field(position + x @ turn.T) - radius


class Misses(NamedTuple):
    """By how much the routine differs from samples at some poses, shape (n,) each."""

    gap: Array  # by samples [m]
    over: Array  # what the routine's is more [m]
    angle: Array  # of the normals [deg]; not a number where they are not to be compared
    at: Array  # where the hull is [m], shape (n, 3)


def misses(shape: str, hull: str, count: int) -> Misses:
    """Gaps and normals by the routine beside those of samples."""
    form, compound, world = HULLS[hull].form(), compound_hull([HULLS[hull]]), scene(shape)
    field = least(bodies_of(SHAPES[shape]))
    middle = np.mean([body.centre for body in SHAPES[shape].bodies()], axis=0)
    chance = np.random.default_rng([list(SHAPES).index(shape), list(HULLS).index(hull)])
    positions, turns = poses_near(form, field, middle, chance, count)
    parts = [
        HullPart(
            world.table, compound.table, compound.centre, compound.radius, Vec(0.0, 0.0, 0.0),
            Vec(*at.tolist()), Mat3(*(Vec(*row) for row in turn.tolist())), 1.0, 0.0,
            SCENE_FACES.address,
        )
        for at, turn in zip(positions, turns, strict=True)
    ]  # fmt: skip
    solid = form.radius * (hull != "ring")
    gap, where = lowest_in(form, field, positions, turns)
    deepest = []
    for k, (faces, p, r) in enumerate(zip(faces_at(parts), positions, turns, strict=True)):
        each = deepest_faces(faces, functools.partial(gap_of_core, field, solid, p, r))
        for one in each:
            # What is said to be nearest is as near, and a point of the hull: samples may miss it.
            point = p + r @ np.array(one.face.at.point) - solid * (r @ np.array(one.face.inward))
            [there] = field(point[None]) - solid
            if there < gap[k] and is_within(form, (point - p) @ r):
                gap[k], where[k] = there, point
        deepest.append(each[int(np.argmin([abs(one.gap - gap[k]) for one in each]))])
    seen = [one.face for one in deepest]
    found, steepness = np.array([[one.gap, one.face.steepness] for one in deepest]).T
    inward = np.einsum("nij,nj->ni", turns, [face.inward for face in seen])
    lever = np.einsum("nij,nj->ni", turns, [face.at.point for face in seen])
    core = positions + lever - solid * inward
    theirs = normals(field, where)
    smooth = (np.abs(np.linalg.norm(theirs, axis=1) - 1.0) < 1e-6) & (steepness > 1.0 - 1e-6)
    same = np.linalg.norm(core - where, axis=1) < 1e-5  # of two that are equally near
    across = np.linalg.norm(np.cross(inward, theirs), axis=1)
    angle = np.degrees(np.arctan2(across, -np.sum(inward * theirs, axis=1)))
    angle[~(smooth & same & (gap > 1e-3))] = np.nan
    kept = gap > -2.0 * DEEP  # of the others a corner that was not near went through
    return Misses(*(values[kept] for values in (gap, found - gap, angle, positions)))


def check(shape: str, hull: str, count: int) -> None:
    """Gap to 1e-6 m, never overstated by more; normal to 0.1 degrees where there is one."""
    found = misses(shape, hull, count)
    nonempty(found.gap.tolist())
    wrong = (np.abs(found.over) > 1e-6) | (found.angle > 0.1)
    assert not wrong.any(), (shape, hull, *(values[wrong] for values in found))
    assert np.isfinite(found.angle).any()


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


def test_a_corner_of_a_shape_in_two_faces_is_as_deep_as_both_together() -> None:
    """A window's corner between two faces of a hull, 1.2 mm behind the edge between them.

    Found among 10 000 poses: both replace the edge, and the one that came second counts from it.
    """
    form, compound, world = HULLS["points"].form(), compound_hull([HULLS["points"]]), scene("round")
    at = np.array([0.2919338, 0.28334879, 1.55430279])
    turn = np.array([
        [-0.0203144, -0.92274176, 0.38488306],
        [-0.09824175, -0.3812572, -0.91923419],
        [0.99495522, -0.05648528, -0.08290675],
    ])  # fmt: skip
    part = HullPart(
        world.table, compound.table, compound.centre, compound.radius, Vec(0.0, 0.0, 0.0),
        Vec(*at.tolist()), Mat3(*(Vec(*row) for row in turn.tolist())), 1.0, 0.0,
        SCENE_FACES.address,
    )  # fmt: skip
    field = least(bodies_of(SHAPES["round"]))
    [faces] = faces_at([part])
    [gap], _ = lowest_in(form, field, at[None], turn[None])
    each = deepest_faces(faces, lambda x: field(at + x @ turn.T) - form.radius)
    deepest = min(each, key=lambda one: one.gap)
    assert faces.second.nearest.gap > deepest.gap + 1e-3
    assert deepest.gap == pytest.approx(gap, abs=1e-6)

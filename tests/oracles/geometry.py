"""Gaps and normals of every part of a vehicle against every built-in shape, beside a slow oracle.

The oracle (`oracles.distances`) shares nothing with the package.  A line for each pair::

    make geometry                        # 10 000 poses each, some minutes
    make geometry POSES=500 ONLY=ring    # of these parts or shapes

Poses are drawn about each shape, half of them moved to between 15 mm of depth and 20 mm of gap.
"""

from __future__ import annotations

import argparse
import math
import sys
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from builders.shapes import SHAPES
from oracles import distances
from oracles.distances import Field, Rings
from springback.contact.forest import Forest
from springback.contact.library import WALL
from springback.contact.parameters import Wall
from springback.contact.scene.faces import SCENE_FACES, SolidScene, VehiclePart, no_faces
from springback.contact.shapes import Box, Pole
from springback.contact.worlds import obstacles
from springback.kernels.compiler import executor
from springback.kernels.layout import Buffer, TreeLayout, read, write
from springback.kernels.routines import call_routine
from springback.kernels.trees import leaves
from springback.kernels.vectors import Mat3, Vec
from springback.vehicle.state import ArmPose

Array = NDArray[np.float64]

#: Parts of a vehicle and their numbers, as the routine knows them.
PARTS = {"ring": 0.0, "tip": 1.0, "sphere": 2.0}
NUMBERS = {**PARTS, "disc": 3.0}  # of a propeller, which has a gap but no normal
RADIUS = 0.11
#: Poses that are looked at together: the samples of their rings fill some 100 MB.
CHUNK = 100
#: Depths and gaps that half of the poses are moved to [m].
DEEPEST, HIGHEST = 0.015, 0.02
#: Two minima whose gaps differ by less are equally low: either may be named first [m].
TIE = 1e-9


def worlds() -> dict[str, Any]:
    """One of every built-in shape, with a thin rod, a box of sharp edges, a forest and a wall."""
    forest = Forest(
        type="forest", density=0.6, size=(4.0, 4.0), radius=0.08, radius_spread=0.5, spacing=0.2,
        position=(-1.7, -0.2, 0.0), surface=WALL,
    )  # fmt: skip
    wall = Wall(type="wall", position=(0.3, -0.2, 1.1), normal=(1.0, -2.0, 0.5), surface=WALL)
    rod = Pole(type="pole", position=(0.3, -0.2, 1.1), radius=0.005, axis=(1, -1, 2), surface=WALL)
    sharp = Box(
        type="box", position=(0.3, -0.2, 1.1), size=(0.3, 0.4, 0.25), roll=0.4, edge_radius=0.0,
        surface=WALL,
    )  # fmt: skip
    return {**SHAPES, "rod": rod, "sharp": sharp, "forest": forest, "wall": wall}


def bodies_of(shape: Any) -> list[Field]:
    """Distances of the bodies of a shape, by the oracle."""
    if isinstance(shape, Forest):
        found = shape.bodies()
        places = np.array([body.centre for body in found])
        return distances.trunks(places, np.array([body.sizes[1] for body in found]))
    return distances.bodies_of(shape)


class Poses(NamedTuple):
    """Places and attitudes of a part."""

    centre: Array  # world [m], shape (n, 3)
    turn: Array  # body to world, shape (n, 3, 3)

    def rings(self) -> Rings:
        """Rings about the centres, in the planes of the body's x and y."""
        return Rings(self.centre, self.turn[:, :, 0], self.turn[:, :, 1], RADIUS)


def random_poses(chance: np.random.Generator, count: int) -> Poses:
    """All attitudes, within 0.7 m of the middle of the shapes along each axis."""
    q = chance.normal(size=(count, 4))
    w, x, y, z = (q / np.linalg.norm(q, axis=1)[:, None]).T
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )
    middle = np.array([0.3, -0.2, 1.1])
    return Poses(middle + chance.uniform(-0.7, 0.7, size=(count, 3)), np.moveaxis(turn, -1, 0))


class Truth(NamedTuple):
    """What the oracle says of some poses."""

    gap: Array  # [m], shape (n,)
    second: Array  # gap of the second minimum, not below the first [m]
    gradient: Array  # shape (n, 3)
    corner: Array  # true where the gradient has a jump, shape (n,)


def _jump(field: Field, points: Array) -> Array:
    """True where a distance has no gradient: its length by differences is not 1, or it turns."""
    there = distances.gradient(field, points)
    turned = np.zeros(len(points))
    for step in distances.ASIDE * np.eye(3):
        ahead, behind = (distances.gradient(field, points + s * step) for s in (1.0, -1.0))
        turned = np.maximum(turned, np.linalg.norm(ahead - behind, axis=1))
    return np.asarray((np.abs(np.linalg.norm(there, axis=1) - 1.0) > 1e-6) | (turned > 0.02))


def truth(part: str, bodies: list[Field], poses: Poses) -> Truth:
    """Gap and gradient of some poses by the oracle."""
    field, centre = distances.least(bodies), poses.centre
    if part == "ring":
        rings = poses.rings()
        low = distances.ring_minima(field, rings)
        normal, kink = distances.ring_normals(field, rings, low.angle[:, 0])
        return Truth(low.gap[:, 0], low.gap[:, 1], normal, kink)
    if part == "sphere":
        none = np.full(len(centre), np.inf)
        found = field(centre) - RADIUS
        return Truth(found, none, distances.gradient(field, centre), _jump(field, centre))
    return _tip_truth(bodies, poses)


def _tip_truth(bodies: list[Field], poses: Poses) -> Truth:
    """Equation (13) for each body alone: p + (r e·n) n along the inward normal n at the arm's end."""
    arm = poses.turn[:, :, 0]
    gaps, normals, corners = [], [], []
    for body in bodies:
        inward = -distances.gradient(body, poses.centre)
        inward /= np.linalg.norm(inward, axis=1)[:, None]
        lever = RADIUS * np.sum(arm * inward, axis=1)[:, None] * inward
        at = poses.centre + lever
        gaps.append(body(at))
        normals.append(-inward)
        # Beyond the middle of a body the distance no longer changes along the normal.
        past = np.linalg.norm(distances.gradient(body, at) + inward, axis=1) > 1e-6
        corners.append(_jump(body, poses.centre) | past)
    order = np.argsort(gaps, axis=0)
    pick = (order[0], np.arange(len(poses.centre)))
    second = np.array(gaps)[order[1], pick[1]] if len(bodies) > 1 else np.full(len(arm), np.inf)
    return Truth(np.array(gaps)[pick], second, np.array(normals)[pick], np.array(corners)[pick])


@executor()
def _many_faces(
    like: TreeLayout, address: float, given: Buffer, out: Buffer, count: int, rows: int, found: int
) -> None:
    """Write the faces of parts, found by the routine, one after another."""
    for k in range(count):
        part = read(like, given[k * rows : (k + 1) * rows], 0, 1, 0)
        write(call_routine(address, part, no_faces()), out[k * found : (k + 1) * found], 0, 1, 0)


class Faces(NamedTuple):
    """What the package says of some poses."""

    gap: Array  # of the nearest face [m], shape (n,)
    normal: Array  # outward, world, shape (n, 3)
    steepness: Array  # of the gap by a motion along the normal, shape (n,)


def package_faces(
    world: SolidScene, part: str, poses: Poses, *, exact: bool = True, rounding: float = 0.0
) -> Faces:
    """The faces that the compiled routine finds."""
    none = Vec(0.0, 0.0, 0.0)
    parts = []
    for centre, turn in zip(poses.centre, poses.turn, strict=True):
        r = Mat3(*(Vec(*map(float, row)) for row in turn))
        pose = ArmPose(Vec(1.0, 0.0, 0.0), none, none)
        at = Vec(*map(float, centre))
        table, kind = float(world.table), NUMBERS[part]
        parts.append(VehiclePart(table, kind, rounding, RADIUS, pose, at, r, float(exact)))
    given = np.array([leaves(one) for one in parts])
    width = len(leaves(no_faces()))
    out = np.zeros(len(parts) * width)
    like = TreeLayout(parts[0])
    address = SCENE_FACES.address
    _many_faces(like, address, given.ravel(), out, len(parts), given.shape[1], width)
    rows = out.reshape(len(parts), width)
    inward = rows[:, 1:4]
    return Faces(rows[:, 0], -np.einsum("kij,kj->ki", poses.turn, inward), rows[:, 14])


class Errors(NamedTuple):
    """Errors of one pair over its poses."""

    poses: int
    touching: int
    corners: int
    gap: float  # largest error outside corners [m]
    gap_at_corner: float  # largest error at corners [m]
    over: float  # most that a gap is overstated by [m]
    over_in_flight: float  # the same where far gaps may be lower bounds [m]
    normal: float  # largest angle to the oracle's gradient outside corners [deg]
    at_corner: float  # largest difference of the gradients at a ring's corners
    ties: int  # poses whose normal was left out as two points are equally near


def compare(part: str, shape: Any, count: int, seed: int) -> Errors:
    """Errors of a part against a shape."""
    world, bodies = obstacles((shape,), as_scene=True), bodies_of(shape)
    assert isinstance(world, SolidScene)
    chance = np.random.default_rng(seed)
    found: list[Array] = []
    while sum(len(rows) for rows in found) < count:
        poses = _drawn(chance, part, bodies)
        if len(poses.centre):
            found.append(_errors(part, world, bodies, poses))
    rows = np.concatenate(found)[:count]
    gap, angle, corner, tie, over, in_flight, touching, turned = rows.T
    at, tied = corner > 0.0, tie > 0.0
    return Errors(
        len(rows), int(touching.sum()), int(at.sum()),
        float(gap[~at].max(initial=0.0)), float(gap[at].max(initial=0.0)), float(over.max()),
        float(in_flight.max()), float(angle[~tied & ~at].max(initial=0.0)),
        float(turned[~tied & at].max(initial=0.0)), int(tied.sum()),
    )  # fmt: skip


def _drawn(chance: np.random.Generator, part: str, bodies: list[Field]) -> Poses:
    """Some poses, none deeper than `DEEPEST`, every other one near."""
    poses = random_poses(chance, CHUNK)
    there = truth(part, bodies, poses)
    target = chance.uniform(-DEEPEST, HIGHEST, size=CHUNK)
    move = np.where(np.arange(CHUNK) % 2 == 0, there.gap - target, 0.0)
    poses = poses._replace(centre=poses.centre - move[:, None] * there.gradient)
    kept = truth(part, bodies, poses).gap > -DEEPEST - 1e-3
    return Poses(poses.centre[kept], poses.turn[kept])


def _errors(part: str, world: SolidScene, bodies: list[Field], poses: Poses) -> Array:
    true = truth(part, bodies, poses)
    ours = package_faces(world, part, poses)
    in_flight = package_faces(world, part, poses, exact=False)
    across = np.linalg.norm(np.cross(ours.normal, true.gradient), axis=1)
    angle = np.degrees(np.arctan2(across, np.sum(ours.normal * true.gradient, axis=1)))
    turned = np.linalg.norm(ours.steepness[:, None] * ours.normal - true.gradient, axis=1)
    tie = true.second - true.gap < TIE
    if part != "ring":  # at a jump either side's normal is right
        tie |= true.corner
    error = np.abs(ours.gap - true.gap)
    return np.stack(
        [
            error, angle, true.corner.astype(float), tie.astype(float), ours.gap - true.gap,
            in_flight.gap - true.gap, (true.gap < 0.0).astype(float), turned,
        ],
        axis=1,
    )  # fmt: skip


HEAD = (
    "| shape | part | poses | touching | at corners | gap [m] | gap at corners [m] | overstated [m] |"
    " in flight [m] | normal [deg] | gradient at corners | ties |"
)


def line(name: str, part: str, e: Errors) -> str:
    """A line of the table."""
    numbers = (e.gap, e.gap_at_corner, e.over, e.over_in_flight, e.normal, e.at_corner)
    told = " | ".join(f"{value:.1e}" for value in numbers)
    return f"| {name} | {part} | {e.poses} | {e.touching} | {e.corners} | {told} | {e.ties} |"


def main() -> int:
    """Print the table; 1 if a promise is broken."""
    given = argparse.ArgumentParser(description="gaps and normals beside a slow oracle")
    given.add_argument("only", nargs="*", help="shapes or parts")
    given.add_argument("--poses", type=int, default=10_000)
    given.add_argument("--seed", type=int, default=1)
    args = given.parse_args()
    print(HEAD + "\n" + "|---" * 12 + "|", flush=True)
    bad = 0
    for name, shape in worlds().items():
        for part in PARTS:
            if args.only and name not in args.only and part not in args.only:
                continue
            found = compare(part, shape, args.poses, args.seed)
            print(line(name, part, found), flush=True)
            bad += not kept(found)
    return int(bad > 0)


def kept(e: Errors) -> bool:
    """True if the errors are within what is promised."""
    limits = (1e-6, 1e-4, 1e-6, 1e-6, 0.1)
    found = (e.gap, e.gap_at_corner, e.over, e.over_in_flight, e.normal)
    return all(
        one <= limit and math.isfinite(one) for one, limit in zip(found, limits, strict=True)
    )


if __name__ == "__main__":
    sys.exit(main())

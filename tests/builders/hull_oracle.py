"""Distances of hulls from shapes by dense samples that are refined: slow, and by other formulas."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.optimize import nnls
from scipy.spatial.transform import Rotation

from oracles import distances
from springback.vehicle.hulls import (
    CIRCLE,
    BoxHull,
    CapsuleHull,
    HullForm,
    PointsHull,
    RingHull,
    SphereHull,
)

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Shares at which triangles are sampled.
LATTICE = np.linspace(0.0, 1.0, 31)
#: Samples around each of the lowest, ever closer, and at most so many times.
AROUND, STEPS = 64, 300
#: Lowest samples that are followed, and the share of a triangle to which they are.
SEEDS, FINE = 24, 1e-10
#: A distance changes by no more than this per metre: those of grids by a little more than 1.
STEEPEST = 1.2
#: Poses that are looked at together: their samples fill some 10 MB.
CHUNK = 25
#: Distance of a point of a hull from it [m].
NEAR = 1e-9
#: Depth of the deepest poses, and distance of the farthest [m].
DEEP, FAR = 0.004, 0.04
#: One of every kind.
HULLS = {
    "sphere": SphereHull(type="sphere", radius=0.05, position=(0.01, 0.02, 0.0)),
    "ring": RingHull(type="ring", radius=0.1, axis=(0.3, -0.2, 1.0), position=(0.01, 0.0, 0.03)),
    "capsule": CapsuleHull(
        type="capsule", start=(-0.1, 0.0, 0.02), end=(0.08, 0.03, 0.0), radius=0.02
    ),
    "box": BoxHull(
        type="box", size=(0.16, 0.12, 0.08), edge_radius=0.004, position=(0.01, 0.0, 0.0),
        roll=0.2, yaw=0.4,
    ),
    "points": PointsHull(
        type="points", radius=0.003,
        points=((0.0, 0.0, 0.08), (0.1, 0.0, -0.03), (-0.06, 0.09, -0.03), (-0.05, -0.08, -0.02),
                (0.03, 0.05, 0.02), (0.0, 0.0, 0.0)),
    ),
}  # fmt: skip


def lowest_in(
    form: HullForm, field: distances.Field, positions: Array, turns: Array
) -> tuple[Array, Array]:
    """Least gaps between a hull and an obstacle at some poses, and where its core is nearest.

    Args:
        form: Of the hull.
        field: Distance of points from the obstacle.
        positions: Of what the hull is fixed to, world [m], shape (n, 3).
        turns: Body axes to world axes, shape (n, 3, 3).

    Returns:
        Gaps [m], shape (n,), and points of the core, world [m], shape (n, 3).
    """
    search = _lowest_of_circles if form.kind == CIRCLE else _lowest_of_solids
    found = [
        search(form, field, positions[k : k + CHUNK], turns[k : k + CHUNK])
        for k in range(0, len(positions), CHUNK)
    ]
    return np.concatenate([gap for gap, _ in found]), np.concatenate([at for _, at in found])


def _lowest_of_solids(
    form: HullForm, field: distances.Field, positions: Array, turns: Array
) -> tuple[Array, Array]:
    """The same for hulls that are solid: samples of all triangles, and finer ones around them."""
    a, b, c = (
        positions[:, None] + np.einsum("nij,tj->nti", turns, part) for part in _triangles(form)
    )
    if len(form.points) == 1:
        return field(a[:, 0]) - form.radius, a[:, 0]

    def at(pose: Array, which: Array, u: Array, v: Array) -> Array:
        """Points of triangles by two shares."""
        first, second, third = a[pose, which], b[pose, which], c[pose, which]
        return first + u[..., None] * (second - first + v[..., None] * (third - second))

    count, sides = a.shape[:2]
    every = np.meshgrid(np.arange(count), np.arange(sides), LATTICE, LATTICE, indexing="ij")
    points = at(*every)
    found = field(points)
    around = np.pad(found, ((0, 0), (0, 0), (1, 1), (1, 1)), constant_values=np.inf)
    beside = [
        around[..., :-2, 1:-1], around[..., 2:, 1:-1], around[..., 1:-1, :-2], around[..., 1:-1, 2:]
    ]  # fmt: skip
    # A lowest point is so near to a sample, and a distance changes by no more than the way.
    lengths = [np.linalg.norm(q - p, axis=-1).max() for p, q in ((a, b), (a, c), (b, c))]
    reach = STEEPEST * 0.5 * (max(lengths[0], lengths[1]) + lengths[2]) / (len(LATTICE) - 1)
    least = found.min(axis=(1, 2, 3), keepdims=True)
    lows = np.flatnonzero((found <= np.min(beside, axis=0)) & (found <= least + reach))
    pose, which, u, v = (grid.ravel()[lows] for grid in every)
    places = np.column_stack([pose, np.round(points.reshape(-1, 3)[lows], 9)])
    _, once = np.unique(places, axis=0, return_index=True)  # corners are in many triangles
    order = once[np.lexsort((found.ravel()[lows[once]], pose[once]))]
    rank = np.arange(len(order)) - np.searchsorted(pose[order], pose[order])
    pose, which, u, v = (values[order[rank < SEEDS]] for values in (pose, which, u, v))
    gaps, places = _refined(lambda i, us, vs: at(pose[i], which[i], us, vs), field, u, v)
    order = np.lexsort((gaps, pose))
    best = order[np.searchsorted(pose[order], np.arange(count))]
    return gaps[best] - form.radius, places[best]


def _refined(at: Any, field: distances.Field, u: Array, v: Array) -> tuple[Array, Array]:
    """Distances and places of the lowest points near some samples, by ever closer samples.

    They are drawn by chance about the lowest so far, anew at each step: along a kink that is
    oblique to them, the same samples again and again end beside the lowest point.

    Args:
        at: Points of the samples' triangles: numbers of samples, and two shares.
        field: Distance of points from the obstacle.
        u: First shares of the samples ...
        v: ... and second ones.
    """
    chance = np.random.default_rng(1)
    wide = np.full(len(u), 1.0 / (len(LATTICE) - 1))
    gaps, places = np.full(len(u), np.inf), np.zeros((len(u), 3))
    u, v = u.copy(), v.copy()
    for _ in range(STEPS):
        left = np.flatnonzero(wide > FINE)
        if len(left) == 0:
            break
        across, along = chance.uniform(-1.0, 1.0, size=(2, AROUND))
        across[0] = along[0] = 0.0
        us = np.clip(u[left, None] + wide[left, None] * across, 0.0, 1.0)
        vs = np.clip(v[left, None] + wide[left, None] * along, 0.0, 1.0)
        points = at(left[:, None], us, vs)
        found = field(points)
        least, rows = np.argmin(found, axis=1), np.arange(len(left))
        u[left], v[left] = us[rows, least], vs[rows, least]
        gaps[left], places[left] = found[rows, least], points[rows, least]
        aside = np.maximum(np.abs(across), np.abs(along))[least]
        wide[left] *= np.where(aside == 0.0, 0.5, np.where(aside < 0.25, 0.8, 1.0))
    return gaps, places


def _lowest_of_circles(
    form: HullForm, field: distances.Field, positions: Array, turns: Array
) -> tuple[Array, Array]:
    """The same for rings."""
    x, y, _ = (turns @ axis for axis in np.asarray(form.axes))
    centres = positions + turns @ np.asarray(form.centre)
    rings = distances.Rings(centres, x, y, form.radius)
    found = distances.ring_minima(field, rings)
    return found.gap[:, 0], rings.at(found.angle[:, :1])[:, 0]


def poses_near(
    form: HullForm, field: distances.Field, middle: Array, chance: Any, count: int
) -> tuple[Array, Array]:
    """Random poses of a hull near an obstacle, some of them pressed in a little.

    Args:
        form: Of the hull.
        field: Distance of points from the obstacle.
        middle: Of the obstacle, world [m].
        chance: Where they are drawn from.
        count: Number of poses.

    Returns:
        Positions [m], shape (count, 3), and body axes to world axes, shape (count, 3, 3).
    """
    points = form.points if len(form.points) else form.centre + form.radius * np.eye(3)
    positions, turns = np.zeros((0, 3)), np.zeros((0, 3, 3))
    while len(positions) < count:
        drawn = [
            (
                Rotation.random(random_state=chance).as_matrix(),
                middle + chance.uniform(-0.5, 0.5, size=3),
                chance.normal(size=3),
            )
            for _ in range(CHUNK)
        ]
        turn, at, away = (np.array(values) for values in zip(*drawn, strict=True))
        away /= np.linalg.norm(away, axis=1)[:, None]
        offsets = np.einsum("nij,pj->npi", turn, points)
        near = np.zeros(CHUNK, dtype=bool)
        for _ in range(12):  # along a line, until it is near
            gap = field(at[:, None] + offsets).min(axis=1) - form.radius
            near |= (gap > -DEEP) & (gap < FAR)
            move = np.where(near, 0.0, 0.5 * (DEEP + FAR) - gap) * 0.7
            at = at + away * move[:, None]
        positions = np.concatenate([positions, at[near]])
        turns = np.concatenate([turns, turn[near]])
    return positions[:count], turns[:count]


def _triangles(form: HullForm) -> tuple[Array, Array, Array]:
    """First, second and third corners of triangles that are a hull's core, shape (n, 3) each."""
    p = np.asarray(form.points)
    if len(p) < 3:
        return p[:1], p[-1:], p[-1:]
    corners = [
        (face.corners[0], face.corners[k], face.corners[k + 1])
        for face in form.faces
        for k in range(1, len(face.corners) - 1)
    ]
    first, second, third = np.array(corners).T
    return p[first], p[second], p[third]


def is_within(form: HullForm, point: Array) -> bool:
    """True for a point of a hull's core, in the axes of what the hull is fixed to."""
    if form.kind == CIRCLE:
        x, y, z = np.asarray(form.axes) @ (point - np.asarray(form.centre))
        return abs(np.hypot(x, y) - form.radius) < NEAR and abs(z) < NEAR
    corners = np.asarray(form.points)
    shares, residual = nnls(
        np.vstack([corners.T, np.ones(len(corners))]), np.append(point, 1.0)
    )  # a convex combination
    return residual < NEAR and float(shares.sum()) > 0.0


def normals(field: distances.Field, points: Array) -> Array:
    """Gradients of a distance at some points, by differences, shape (n, 3)."""
    h = 1e-6
    steps = h * np.eye(3)
    return np.stack([(field(points + d) - field(points - d)) / (2.0 * h) for d in steps], axis=-1)


def is_corner(field: distances.Field, points: Array) -> Array:
    """True where a distance has no one gradient: it turns by more than 0.02 within 8 µm."""
    turned = np.zeros(len(points))
    for step in distances.ASIDE * np.eye(3):
        jump = normals(field, points + step) - normals(field, points - step)
        turned = np.maximum(turned, np.linalg.norm(jump, axis=1))
    return np.asarray(turned > 0.02)

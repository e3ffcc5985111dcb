"""Distances of hulls from shapes by dense samples that are refined: slow, and by other formulas."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.optimize import nnls

from oracles import distances
from springback.contact.shapes import ShapeSettings
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

#: Shares at which triangles are sampled, and around the lowest samples, ever closer.
LATTICE, AROUND, STEPS = np.linspace(0.0, 1.0, 31), np.linspace(-1.0, 1.0, 9), 60
#: Lowest samples that are followed.
SEEDS = 24
#: Distance of a point of a hull from it [m].
NEAR = 1e-9
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


def distance(shape: ShapeSettings, points: Array) -> Array:
    """Distance of points from a shape, world axes, shape (..., 3) to (...) [m]."""
    return distances.least(distances.bodies_of(shape))(points)


def lowest(
    form: HullForm, shape: ShapeSettings, position: Array, turn: Array
) -> tuple[float, Array]:
    """Least gap between a hull and a built-in shape, and where the hull's core is nearest."""
    return lowest_in(form, distances.least(distances.bodies_of(shape)), position, turn)


def lowest_in(
    form: HullForm, field: distances.Field, position: Array, turn: Array
) -> tuple[float, Array]:
    """Least gap between a hull and an obstacle, and where the hull's core is nearest.

    Args:
        form: Of the hull.
        field: Distance of points from the obstacle.
        position: Of what the hull is fixed to, world [m].
        turn: Body axes to world axes, shape (3, 3).
    """
    if form.kind == CIRCLE:
        return _lowest_of_circle(form, field, position, turn)
    a, b, c = (position + corners @ turn.T for corners in _triangles(form))

    def at(k: Array, u: Array, v: Array) -> Array:
        """Points of triangles by two shares."""
        return a[k] + u[..., None] * (b[k] - a[k] + v[..., None] * (c[k] - b[k]))

    which, u, v = (
        grid.ravel() for grid in np.meshgrid(np.arange(len(a)), LATTICE, LATTICE, indexing="ij")
    )
    points = at(which, u, v)
    found = field(points).reshape(len(a), len(LATTICE), len(LATTICE))
    around = np.pad(found, ((0, 0), (1, 1), (1, 1)), constant_values=np.inf)
    low = np.min(
        [around[:, :-2, 1:-1], around[:, 2:, 1:-1], around[:, 1:-1, :-2], around[:, 1:-1, 2:]],
        axis=0,
    )
    lows = np.flatnonzero(found <= low)
    _, first = np.unique(np.round(points[lows], 9), axis=0, return_index=True)  # corners are many
    lows = lows[first]
    seeds = lows[np.argsort(found.ravel()[lows])[:SEEDS]]
    k, u, v, wide = (
        which[seeds][:, None],
        u[seeds],
        v[seeds],
        np.full(len(seeds), 1.0 / (len(LATTICE) - 1)),
    )
    across, along = (grid.ravel() for grid in np.meshgrid(AROUND, AROUND))
    rows = np.arange(len(seeds))
    for _ in range(STEPS):
        us = np.clip(u[:, None] + wide[:, None] * across, 0.0, 1.0)
        vs = np.clip(v[:, None] + wide[:, None] * along, 0.0, 1.0)
        points = at(k, us, vs)
        found = field(points)
        least = np.argmin(found, axis=1)
        u, v = us[rows, least], vs[rows, least]
        inside = (np.abs(across) < 1.0) & (np.abs(along) < 1.0)
        wide = np.where(inside[least], 0.5, 1.0) * wide
    gaps, places = found[rows, least], points[rows, least]
    best = int(np.argmin(gaps))
    return float(gaps[best]) - form.radius, places[best]


def _lowest_of_circle(
    form: HullForm, field: distances.Field, position: Array, turn: Array
) -> tuple[float, Array]:
    x, y, _ = np.asarray(form.axes) @ turn.T
    centre = position + turn @ np.asarray(form.centre)
    ring = distances.Rings(centre[None], x[None], y[None], form.radius)
    found = distances.ring_minima(field, ring)
    return float(found.gap[0, 0]), ring.at(found.angle[:, :1])[0, 0]


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


def normal(shape: ShapeSettings, point: Array) -> Array:
    """Gradient of the distance at a point, by differences."""
    h = 1e-6
    steps = h * np.eye(3)
    return np.asarray((distance(shape, point + steps) - distance(shape, point - steps)) / (2.0 * h))

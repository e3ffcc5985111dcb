"""Distances of hulls from shapes by dense samples that are refined: slow, and by other formulas."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np

from springback.contact.scene.solids import (
    BOX,
    CAPSULE,
    FRUSTUM,
    HALF_SPACE,
    ROUND_WINDOW,
    TORUS,
    WINDOW,
)
from springback.contact.shapes import ShapeSettings, SolidShape
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


def _corner(a: Array, b: Array) -> Array:
    """Distance from the quadrant a < 0, b < 0."""
    outside = np.hypot(np.maximum(a, 0.0), np.maximum(b, 0.0))
    return outside + np.minimum(np.maximum(a, b), 0.0)


def _distance_of_body(body: SolidShape, points: Array) -> Array:
    """Distance of points from one solid, shape (..., 3) to (...)."""
    q = (points - body.centre) @ np.asarray(body.axes).T
    x, y, z = q[..., 0], q[..., 1], q[..., 2]
    s = body.sizes
    if body.kind == HALF_SPACE:
        return np.asarray(z)
    if body.kind == BOX:
        u = np.abs(q) - np.array(s[:3])
        inside = np.minimum(u.max(axis=-1), 0.0)
        found = np.linalg.norm(np.maximum(u, 0.0), axis=-1) + inside
    elif body.kind == CAPSULE:
        along = np.clip(z, -s[0], s[0])
        found = np.sqrt(x * x + y * y + (z - along) ** 2) - s[1]
    elif body.kind == FRUSTUM:
        found = _frustum(np.hypot(x, y), z, *s[:3])
    elif body.kind == TORUS:
        found = np.hypot(np.hypot(x, y) - s[0], z) - s[1]
    else:
        outline = _corner(np.abs(x) - s[0], np.abs(y) - s[1])
        if body.kind == WINDOW:
            opening = _corner(np.abs(x) - s[3], np.abs(y - s[5]) - s[4])
        else:
            assert body.kind == ROUND_WINDOW
            opening = np.hypot(x, y) - s[3]
        found = _corner(np.maximum(outline, -opening), np.abs(z) - s[2])
    return np.asarray(found - body.rounding)


def _frustum(rho: Array, z: Array, bottom: float, top: float, half: float) -> Array:
    """Distance from a polygon in the plane of radius and height."""
    corners = np.array([[0.0, -half], [bottom, -half], [top, half], [0.0, half]])
    point = np.stack([rho, z], axis=-1)
    nearest, inside = np.full(rho.shape, np.inf), np.ones(rho.shape, dtype=bool)
    for a, b in itertools.pairwise(corners):
        way = b - a
        t = np.clip((point - a) @ way / max(float(way @ way), 1e-300), 0.0, 1.0)
        away = point - (a + t[..., None] * way)
        nearest = np.minimum(nearest, np.linalg.norm(away, axis=-1))
        inside &= (point - a) @ np.array([way[1], -way[0]]) <= 0.0
    return np.where(inside, -nearest, nearest)


def distance(shape: ShapeSettings, points: Array) -> Array:
    """Distance of points from a shape, world axes, shape (..., 3) to (...) [m]."""
    return np.min([_distance_of_body(body, points) for body in shape.bodies()], axis=0)


def lowest(
    form: HullForm, shape: ShapeSettings, position: Array, turn: Array
) -> tuple[float, Array]:
    """Least gap between a hull and a shape, and where the hull's core is nearest.

    Args:
        form: Of the hull.
        shape: The obstacle.
        position: Of what the hull is fixed to, world [m].
        turn: Body axes to world axes, shape (3, 3).
    """
    patches = _patches(form, position, turn)
    best, where = math.inf, position
    for at in patches:
        u = np.linspace(0.0, 1.0, 41)
        v = np.linspace(0.0, 1.0, 41)
        found = distance(shape, at(u[:, None], v[None, :]))
        flat = np.argsort(found, axis=None)[:400]
        seeds: list[tuple[int, int]] = []
        for k in flat:  # the lowest places that are apart
            i, j = divmod(int(k), 41)
            if all(abs(i - a) + abs(j - b) > 4 for a, b in seeds):
                seeds.append((i, j))
            if len(seeds) == 4:
                break
        for i, j in seeds:
            here, there, wide = u[i], v[j], 1.0 / 40.0
            for _ in range(28):
                us = np.clip(here + wide * np.linspace(-1.0, 1.0, 7), 0.0, 1.0)
                vs = np.clip(there + wide * np.linspace(-1.0, 1.0, 7), 0.0, 1.0)
                points = at(us[:, None], vs[None, :])
                now = distance(shape, points)
                a, b = divmod(int(np.argmin(now)), 7)
                here, there, wide = us[a], vs[b], 0.6 * wide
                if now[a, b] < best:
                    best, where = float(now[a, b]), points[a, b]
    radius = 0.0 if form.kind == CIRCLE else form.radius
    return best - radius, where


def _patches(form: HullForm, position: Array, turn: Array) -> list[Any]:
    """Parts of a hull's core as functions of two shares, broadcast."""

    def world(points: Array) -> Array:
        return position + points @ turn.T

    if form.kind == CIRCLE:
        x, y, _ = form.axes

        def around(u: Array, v: Array) -> Array:
            angle = 2.0 * np.pi * (u + 0.0 * v)[..., None]
            return world(form.centre + form.radius * (np.cos(angle) * x + np.sin(angle) * y))

        return [around]

    def triangle(a: Array, b: Array, c: Array) -> Any:
        def inside(u: Array, v: Array) -> Array:
            u, v = np.broadcast_arrays(u, v)
            return world(a + u[..., None] * (b - a + v[..., None] * (c - b)))

        return inside

    p = form.points
    if len(p) == 1:
        return [triangle(p[0], p[0], p[0])]
    if len(p) == 2:
        return [triangle(p[0], p[1], p[1])]
    return [
        triangle(p[face.corners[0]], p[face.corners[k]], p[face.corners[k + 1]])
        for face in form.faces
        for k in range(1, len(face.corners) - 1)
    ]


def normal(shape: ShapeSettings, point: Array) -> Array:
    """Gradient of the distance at a point, by differences."""
    h = 1e-6
    steps = h * np.eye(3)
    return np.asarray((distance(shape, point + steps) - distance(shape, point - steps)) / (2.0 * h))

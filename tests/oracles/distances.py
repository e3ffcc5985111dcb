"""Distances of the built-in shapes written once more, in NumPy, from the words of their settings.

Nothing here is shared with the package's solids: boxes are clipped to, walls with an opening are
unions of boxes, round bodies are convex polygons turned about an axis, half-planes are met by SciPy.
Rounded edges are what a ball leaves that rolls inside: the body moved inwards, then outwards again.

Rings are followed by dense samples and a golden-section search, many poses at a time.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import HalfspaceIntersection
from scipy.spatial.transform import Rotation

Array = NDArray[np.float64]
#: Signed distances of points, shape (..., 3) -> (...).
Field = Callable[[Array], Array]

#: Offset of the central differences that give gradients [m].
TINY = 1e-7
#: Distance over which a gradient is looked at for a corner [m].
ASIDE = 4e-6


# -- bodies in their own axes ---------------------------------------------------------------------


def _to_box(q: Array, low: Array, high: Array) -> Array:
    """Distance to a box between two corners; inside, minus that to the nearest face."""
    outside = np.linalg.norm(q - np.clip(q, low, high), axis=-1)
    depth = np.minimum(q - low, high - q).min(axis=-1)
    return np.where(depth >= 0.0, -depth, outside)


def _to_polygon(p: Array, corners: Array) -> Array:
    """Distance to a convex polygon in a plane, its corners counterclockwise."""
    x, y = np.roll(corners, -1, axis=0).T - corners.T
    square = x * x + y * y
    px, py = p[..., :1] - corners[:, 0], p[..., 1:] - corners[:, 1]
    share = np.clip((px * x + py * y) / np.where(square > 0.0, square, 1.0), 0.0, 1.0)
    found = np.hypot(px - share * x, py - share * y).min(axis=-1)
    return np.where((x * py - y * px >= 0.0).all(axis=-1), -found, found)


def _moved_in(corners: Array, by: float) -> Array:
    """A convex polygon without a margin along its sides, counterclockwise."""
    rows = []
    for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        if np.allclose(a, b):
            continue
        out = np.array([b[1] - a[1], a[0] - b[0]]) / np.linalg.norm(b - a)
        rows.append([*out, -(out @ a) + by])
    middle = corners.mean(axis=0)
    found = HalfspaceIntersection(np.array(rows), middle).intersections
    angles = np.arctan2(found[:, 1] - middle[1], found[:, 0] - middle[0])
    return np.asarray(found[np.argsort(angles)])


def _turned(section: Array, edge: float) -> Field:
    """A convex section about the third axis, between its left and right, with rounded edges."""
    core = _moved_in(section, edge)

    def field(q: Array) -> Array:
        flat = np.stack([np.hypot(q[..., 0], q[..., 1]), q[..., 2]], axis=-1)
        return _to_polygon(flat, core) - edge

    return field


def _frame(low: Array, high: Array, hole_low: Array, hole_high: Array, edge: float) -> Field:
    """A plate with a rectangular opening along the third axis, as four plates around it."""
    low, high = low + edge, high - edge
    (a, b), (c, d) = hole_low - edge, hole_high + edge
    parts = [
        (low, np.array([a, high[1], high[2]])),
        (np.array([c, low[1], low[2]]), high),
        (low, np.array([high[0], b, high[2]])),
        (np.array([low[0], d, low[2]]), high),
    ]
    parts = [(x, y) for x, y in parts if (y - x >= 0.0).all()]  # a doorway has none below

    def field(q: Array) -> Array:
        outside = np.min([_to_box(q, x, y) for x, y in parts], axis=0)
        flat = q[..., :2]
        to_hole = np.linalg.norm(flat - np.clip(flat, [a, b], [c, d]), axis=-1)
        depth = np.minimum(-_to_box(q, low, high), to_hole)
        return np.where(outside > 0.0, outside, -depth) - edge

    return field


def _porthole(half: Array, radius: float, edge: float) -> Field:
    """A plate with a round opening in its middle."""
    half, radius = half - edge, radius + edge

    def field(q: Array) -> Array:
        flat, rho = q[..., :2], np.hypot(q[..., 0], q[..., 1])
        beside = np.linalg.norm(flat - np.clip(flat, -half[:2], half[:2]), axis=-1)
        aside = np.maximum(beside, np.maximum(radius - rho, 0.0))  # never both
        above = np.maximum(np.abs(q[..., 2]) - half[2], 0.0)
        outside = np.hypot(aside, above)
        depth = np.minimum((half - np.abs(q)).min(axis=-1), rho - radius)
        return np.where(outside > 0.0, outside, -depth) - edge

    return field


# -- shapes ---------------------------------------------------------------------------------------


def frame_along(direction: Any) -> Array:
    """Some axes, one a column, the third along a direction."""
    z = np.asarray(direction, dtype=float)
    z = z / np.linalg.norm(z)
    _, _, rows = np.linalg.svd(z[None])
    return np.stack([rows[1], rows[2], z], axis=1)


def attitude_axes(shape: Any) -> Array:
    """Axes of a shape in world axes, one a column."""
    turn = Rotation.from_euler("ZYX", [shape.yaw, shape.pitch, shape.roll])
    return np.asarray(turn.as_matrix())


def _placed(field: Field, origin: Any, axes: Array) -> Field:
    place = np.asarray(origin, dtype=float)
    return lambda points: field((points - place) @ axes)


def _box(shape: Any) -> list[Field]:
    half, edge = 0.5 * np.array(shape.size) - shape.edge_radius, shape.edge_radius
    own: Field = lambda q: _to_box(q, -half, half) - edge  # noqa: E731
    return [_placed(own, shape.position, attitude_axes(shape))]


def _edge(shape: Any) -> list[Field]:
    """Its faces are along (1, 1) and (1, −1) of its own x and y."""
    r, s = shape.edge_radius, math.sqrt(0.5)
    low = np.array([0.0, 0.0, -0.5 * shape.length]) + r
    high = np.array([shape.width, shape.width, 0.5 * shape.length]) - r
    along = np.array([[s, s, 0.0], [-s, s, 0.0], [0.0, 0.0, 1.0]])  # columns
    own: Field = lambda q: _to_box(q, low, high) - r  # noqa: E731
    return [_placed(own, shape.position, attitude_axes(shape) @ along)]


def _sphere(shape: Any) -> list[Field]:
    return [lambda p: np.linalg.norm(p - np.array(shape.position), axis=-1) - shape.radius]


def _about_line(point: Any, direction: Any, radius: float) -> Field:
    d = np.asarray(direction, dtype=float)
    d = d / np.linalg.norm(d)
    return lambda p: np.linalg.norm(np.cross(p - np.asarray(point), d), axis=-1) - radius


def _pole(shape: Any) -> list[Field]:
    if shape.height is None:
        return [_about_line(shape.position, shape.axis, shape.radius)]
    r, h = shape.radius, shape.height
    section = np.array([[-r, 0.0], [r, 0.0], [r, h], [-r, h]])
    return [_placed(_turned(section, shape.edge_radius), shape.position, frame_along(shape.axis))]


def _cone(shape: Any) -> list[Field]:
    r, s, h = shape.radius, shape.top_radius, shape.height
    section = np.array([[-r, 0.0], [r, 0.0], [s, h], [-s, h]])
    return [_placed(_turned(section, shape.edge_radius), shape.position, frame_along(shape.axis))]


def _capsule(shape: Any) -> list[Field]:
    a, b = np.array(shape.start), np.array(shape.end)

    def field(p: Array) -> Array:
        share = np.clip((p - a) @ (b - a) / ((b - a) @ (b - a)), 0.0, 1.0)
        return np.linalg.norm(p - a - share[..., None] * (b - a), axis=-1) - shape.radius

    return [field]


def _hoop(shape: Any) -> list[Field]:
    def own(q: Array) -> Array:
        rho = np.hypot(q[..., 0], q[..., 1])
        unit = q[..., :2] / np.where(rho > 0.0, rho, 1.0)[..., None]
        nearest = np.concatenate([shape.radius * unit, np.zeros_like(q[..., 2:])], axis=-1)
        return np.linalg.norm(q - nearest, axis=-1) - shape.tube_radius

    return [_placed(own, shape.position, frame_along(shape.axis))]


def _panel(shape: Any) -> Array:
    """Axes of a wall with an opening: to the left, upwards, and through it, as columns."""
    x, y, z = attitude_axes(shape).T
    return np.stack([y, z, x], axis=1)


def _window(shape: Any) -> list[Field]:
    half = 0.5 * np.array([*shape.size, shape.thickness])
    if shape.opening is None:
        own = _porthole(half, shape.opening_radius, shape.edge_radius)
    else:
        hole, up = 0.5 * np.array(shape.opening), np.array([0.0, shape.opening_height])
        own = _frame(-half, half, up - hole, up + hole, shape.edge_radius)
    return [_placed(own, shape.position, _panel(shape))]


def _doorway(shape: Any) -> list[Field]:
    (width, height), (w, h), t = shape.size, shape.opening, shape.thickness
    low, high = np.array([-0.5 * width, 0.0, -0.5 * t]), np.array([0.5 * width, height, 0.5 * t])
    below = np.array([-0.5 * w, -1.0])
    own = _frame(low, high, below, np.array([0.5 * w, h]), shape.edge_radius)
    return [_placed(own, shape.position, _panel(shape))]


def _slope(shape: Any) -> list[Field]:
    up_hill = np.array([math.cos(shape.uphill), math.sin(shape.uphill), 0.0])
    climb = math.cos(shape.angle) * up_hill + math.sin(shape.angle) * np.array([0.0, 0.0, 1.0])
    normal = np.cross(climb, np.cross([0.0, 0.0, 1.0], up_hill))
    return [lambda p: (p - np.array(shape.position)) @ normal]


def _stairs(shape: Any) -> list[Field]:
    axes = np.asarray(Rotation.from_euler("Z", shape.yaw).as_matrix())
    edge, end = shape.edge_radius, shape.steps * shape.tread

    def step(k: int) -> Field:
        low = np.array([k * shape.tread, -0.5 * shape.width, 0.0]) + edge
        high = np.array([end, 0.5 * shape.width, (k + 1) * shape.rise]) - edge
        return _placed(lambda q: _to_box(q, low, high) - edge, shape.position, axes)

    return [step(k) for k in range(shape.steps)]


def _wall(shape: Any) -> list[Field]:
    n = np.array(shape.normal) / np.linalg.norm(shape.normal)
    return [lambda p: (p - np.array(shape.position)) @ n]


_OF_TYPE: dict[str, Callable[[Any], list[Field]]] = {
    "box": _box, "edge": _edge, "sphere": _sphere, "pole": _pole, "cone": _cone,
    "capsule": _capsule, "hoop": _hoop, "window": _window, "doorway": _doorway, "slope": _slope,
    "stairs": _stairs, "wall": _wall,
}  # fmt: skip


def bodies_of(shape: Any) -> list[Field]:
    """Distances of the bodies of a shape, by the words of its settings.

    A forest's trunks are placed by chance: theirs are taken from the package (`trunks`).
    """
    return _OF_TYPE[shape.type](shape)


def trunks(places: Array, radii: Array) -> list[Field]:
    """Distances of upright trunks without end: places (n, 3), radii (n,)."""
    return [
        _about_line(place, (0.0, 0.0, 1.0), float(radius))
        for place, radius in zip(places, radii, strict=True)
    ]


def least(bodies: list[Field]) -> Field:
    """Distance of a union; exact outside."""
    return lambda points: np.min([body(points) for body in bodies], axis=0)


def gradient(field: Field, points: Array) -> Array:
    """Gradient by central differences, shape of the points."""
    steps = TINY * np.concatenate([np.eye(3), -np.eye(3)])
    there = field(points + steps.reshape(6, *[1] * (points.ndim - 1), 3))
    return np.asarray(np.moveaxis(there[:3] - there[3:], 0, -1) / (2.0 * TINY))


# -- rings ----------------------------------------------------------------------------------------


class Rings(NamedTuple):
    """Some rings: of one radius, in any planes."""

    centre: Array  # world [m], shape (n, 3)
    x: Array  # unit vectors that span their planes, shape (n, 3)
    y: Array
    radius: float  # [m]

    def at(self, angle: Array) -> Array:
        """Points at angles, shape (n, m) -> (n, m, 3)."""
        c, s = np.cos(angle)[..., None], np.sin(angle)[..., None]
        return np.asarray(
            self.centre[:, None] + self.radius * (c * self.x[:, None] + s * self.y[:, None])
        )


class Minima(NamedTuple):
    """The two lowest minima of a distance along some rings; infinite where there is no second."""

    gap: Array  # [m], shape (n, 2), the lower first
    angle: Array  # [rad], shape (n, 2)


#: Ratio of the golden section, and its steps: brackets of a sample end below 1e-11 rad.
GOLDEN, STEPS = 0.5 * (math.sqrt(5.0) - 1.0), 44


def ring_minima(field: Field, rings: Rings, samples: int = 1440, steps: int = STEPS) -> Minima:
    """The two lowest minima along rings, by samples all around and a golden-section search."""
    n, width = len(rings.centre), 2.0 * math.pi / samples
    angles = np.broadcast_to(width * np.arange(samples), (n, samples))
    gaps = field(rings.at(angles))
    low = (gaps <= np.roll(gaps, 1, axis=1)) & (gaps < np.roll(gaps, -1, axis=1))
    order = np.argsort(np.where(low, gaps, np.inf), axis=1)[:, :4]
    is_low = np.take_along_axis(low, order, axis=1)
    order = order[:, : max(1, int(is_low.any(axis=0).sum()))]
    is_low = is_low[:, : order.shape[1]]
    middle = np.take_along_axis(angles, order, axis=1)
    a, b = middle - width, middle + width
    for _ in range(steps):
        c, d = b - GOLDEN * (b - a), a + GOLDEN * (b - a)
        at_c, at_d = np.split(field(rings.at(np.concatenate([c, d], axis=1))), 2, axis=1)
        left = at_c < at_d
        a, b = np.where(left, a, c), np.where(left, d, b)
    found = 0.5 * (a + b)
    gap = np.where(is_low, field(rings.at(found)), np.inf)
    if gap.shape[1] == 1:
        gap, found = np.pad(gap, ((0, 0), (0, 1)), constant_values=np.inf), np.tile(found, 2)
    order = np.argsort(gap, axis=1)[:, :2]
    return Minima(np.take_along_axis(gap, order, axis=1), np.take_along_axis(found, order, axis=1))


def ring_normals(field: Field, rings: Rings, angle: Array) -> tuple[Array, Array]:
    """Gradients of the lowest gap by the ring's motion, and whether there is a corner, shape (n,).

    A corner has a radius below some 0.4 mm.  On a kink the gradient is the mean of both sides with
    which the slope along the ring is zero.  The sides are looked at where no difference reaches
    across: beside the ring, away from the surface on which both are equally far.
    """
    there = rings.at(angle[:, None])[:, 0]
    aside = ASIDE / rings.radius
    low, high = (gradient(field, rings.at((angle + k * aside)[:, None]))[:, 0] for k in (-1, 1))
    corner = np.linalg.norm(high - low, axis=1) > 0.02
    for _ in range(3):
        apart = high - low
        apart /= np.maximum(np.linalg.norm(apart, axis=1), 1e-12)[:, None]
        low, high = (gradient(field, there + k * 3.0 * TINY * apart) for k in (-1.0, 1.0))
    along = np.cos(angle)[:, None] * rings.y - np.sin(angle)[:, None] * rings.x
    falls, rises = np.sum(low * along, axis=1), np.sum(high * along, axis=1)
    is_kink = corner & (falls * rises < 0.0)
    share = np.where(is_kink, rises / np.where(is_kink, rises - falls, 1.0), 0.5)
    mean = share[:, None] * low + (1.0 - share)[:, None] * high
    return np.where(corner[:, None], mean, gradient(field, there)), corner

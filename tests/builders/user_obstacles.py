"""Obstacles as a user would write them: a vertical pole, a sphere and a box."""

from __future__ import annotations

import math
from typing import NamedTuple

from springback.contact.obstacles import outward_normal, signed_distance
from springback.kernels.compiler import kernel
from springback.kernels.vectors import ZERO, Vec, positive_part


class Pole(NamedTuple):
    """An upright cylinder without end."""

    x: float
    y: float
    radius: float


class Ball(NamedTuple):
    """A sphere."""

    centre: Vec
    radius: float


@signed_distance.register(Pole)  # type: ignore[attr-defined]
@kernel
def pole_distance(pole: Pole, point: Vec) -> float:
    """Distance from the mantle [m]."""
    return math.hypot(point.x - pole.x, point.y - pole.y) - pole.radius


@outward_normal.register(Pole)  # type: ignore[attr-defined]
@kernel
def pole_normal(pole: Pole, point: Vec) -> Vec:
    """Away from the axis."""
    away = Vec(point.x - pole.x, point.y - pole.y, 0.0)
    return away * (1.0 / math.sqrt(away @ away))


@signed_distance.register(Ball)  # type: ignore[attr-defined]
@kernel
def ball_distance(ball: Ball, point: Vec) -> float:
    """Distance from the sphere [m]."""
    away = point - ball.centre
    return math.sqrt(away @ away) - ball.radius


@outward_normal.register(Ball)  # type: ignore[attr-defined]
@kernel
def ball_normal(ball: Ball, point: Vec) -> Vec:
    """Away from the centre."""
    away = point - ball.centre
    return away * (1.0 / math.sqrt(away @ away))


class Box(NamedTuple):
    """A box with sides along the axes."""

    half: Vec  # [m]
    centre: Vec = ZERO  # [m]


@kernel
def _outside(box: Box, point: Vec) -> Vec:
    d = point - box.centre
    return Vec(abs(d.x) - box.half.x, abs(d.y) - box.half.y, abs(d.z) - box.half.z)


@signed_distance.register(Box)  # type: ignore[attr-defined]
@kernel
def box_distance(box: Box, point: Vec) -> float:
    """Distance from the box, exact inside, too [m]."""
    u = _outside(box, point)
    out = Vec(positive_part(u.x), positive_part(u.y), positive_part(u.z))
    return math.sqrt(out @ out) + min(max(u.x, max(u.y, u.z)), 0.0)


@outward_normal.register(Box)  # type: ignore[attr-defined]
@kernel
def box_normal(box: Box, point: Vec) -> Vec:
    """Gradient of the distance."""
    u, d = _outside(box, point), point - box.centre
    most = max(u.x, max(u.y, u.z))
    inside = most <= 0.0
    x = (1.0 if u.x == most else 0.0) if inside else positive_part(u.x)
    y = (1.0 if u.y == most else 0.0) if inside else positive_part(u.y)
    z = (1.0 if u.z == most else 0.0) if inside else positive_part(u.z)
    n = Vec(math.copysign(x, d.x), math.copysign(y, d.y), math.copysign(z, d.z))
    return n * (1.0 / math.sqrt(n @ n))

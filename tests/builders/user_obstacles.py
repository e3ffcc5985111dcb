"""Obstacles as a user would write them: a vertical pole and a sphere."""

from __future__ import annotations

import math
from typing import NamedTuple

from springback.contact.obstacles import outward_normal, signed_distance
from springback.kernels.compiler import kernel
from springback.kernels.vectors import Vec


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

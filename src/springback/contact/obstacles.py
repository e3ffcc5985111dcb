"""Obstacles: a signed distance and an outward normal, nothing more.

A new obstacle is a NamedTuple of floats and vectors with two functions registered for it::

    class Pole(NamedTuple): ...

    @signed_distance.register(Pole)
    @kernel
    def _(pole, point): ...

and the same for `outward_normal`; it then works in every executor.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.surfaces import Surface
from springback.kernels.compiler import generic, kernel
from springback.kernels.vectors import Vec


class Plane(NamedTuple):
    """A half-space: walls, the ground, the face of a mat."""

    normal: Vec  # unit vector out of the obstacle, world
    offset: float  # normal · x of the face [m]


class Obstacle(NamedTuple):
    """A shape with its surface."""

    shape: Any  # Plane, or any type registered with signed_distance and outward_normal
    surface: Surface
    is_ground: float  # 1 where a touch means the vehicle hit the ground


class Forces(NamedTuple):
    """All surfaces follow laws of force."""

    unused: float


class Impulses(NamedTuple):
    """Some surface follows the impulse law."""

    unused: float


class World(NamedTuple):
    """All that a vehicle can meet."""

    obstacles: tuple[Obstacle, ...]
    laws: Forces | Impulses
    gravity: float  # g along −Z [m/s²]


@generic
def signed_distance(shape: Any, point: Vec) -> float:
    """Distance of a point from an obstacle [m]: positive outside, negative inside."""
    raise TypeError(f"{type(shape).__name__} has no signed_distance; register one")


@generic
def outward_normal(shape: Any, point: Vec) -> Vec:
    """Unit vector out of the obstacle at the surface point nearest to ``point``, world axes.

    It is the gradient of the signed distance.
    """
    raise TypeError(f"{type(shape).__name__} has no outward_normal; register one")


@signed_distance.register(Plane)
@kernel
def _plane_distance(plane: Plane, point: Vec) -> float:
    return plane.normal @ point - plane.offset


@outward_normal.register(Plane)
@kernel
def _plane_normal(plane: Plane, point: Vec) -> Vec:
    return plane.normal

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
from springback.kernels.vectors import Mat3, Vec


class Plane(NamedTuple):
    """A half-space: walls, the ground, the face of a mat."""

    normal: Vec  # unit vector out of the obstacle, world
    offset: float  # normal · x of the face [m]


class Again(NamedTuple):
    """A shape once more: for the second point at which one ring touches it."""

    shape: Any


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


class InBodyFrame(NamedTuple):
    """A shape that stands in the world, seen from a body: points and normals in body axes."""

    shape: Any
    position: Vec  # of the body, world [m]
    r: Mat3  # body axes to world axes


@generic
def in_body_frame(shape: Any, position: Vec, r: Mat3) -> Any:
    """A shape as it appears in the axes of a body, from where the body is.

    Any shape will do; one that is registered here itself can be faster.

    Args:
        shape: In world axes.
        position: Of the body, world [m].
        r: Body axes to world axes.
    """
    return InBodyFrame(shape, position, r)


@in_body_frame.register(Plane)
@kernel
def _plane_seen(plane: Plane, position: Vec, r: Mat3) -> Plane:
    return Plane(plane.normal @ r, plane.offset - plane.normal @ position)


@in_body_frame.register(Again)
@kernel
def _seen_again(again: Again, position: Vec, r: Mat3) -> Again:
    return Again(in_body_frame(again.shape, position, r))


@signed_distance.register(Again)
@kernel
def _distance_again(again: Again, point: Vec) -> float:
    return signed_distance(again.shape, point)


@outward_normal.register(Again)
@kernel
def _normal_again(again: Again, point: Vec) -> Vec:
    return outward_normal(again.shape, point)


@signed_distance.register(InBodyFrame)
@kernel
def _seen_distance(view: InBodyFrame, point: Vec) -> float:
    return signed_distance(view.shape, view.position + view.r @ point)


@outward_normal.register(InBodyFrame)
@kernel
def _seen_normal(view: InBodyFrame, point: Vec) -> Vec:
    return outward_normal(view.shape, view.position + view.r @ point) @ view.r


@kernel
def obstacle_in_body_frame(obstacle: Obstacle, position: Vec, r: Mat3) -> Obstacle:
    """An obstacle as it appears in the axes of a body, from where the body is."""
    return Obstacle(
        in_body_frame(obstacle.shape, position, r), obstacle.surface, obstacle.is_ground
    )


@signed_distance.register(Plane)
@kernel
def _plane_distance(plane: Plane, point: Vec) -> float:
    return plane.normal @ point - plane.offset


@outward_normal.register(Plane)
@kernel
def _plane_normal(plane: Plane, point: Vec) -> Vec:
    return plane.normal

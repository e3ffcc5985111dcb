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


class SecondContact(NamedTuple):
    """The same shape again, for the second point at which one ring touches it."""

    shape: Any


class Obstacle(NamedTuple):
    """A shape with its surface."""

    shape: Any  # Plane, or any type registered with signed_distance and outward_normal
    surface: Surface
    is_ground: float  # 1 if touching it counts as hitting the ground


class Forces(NamedTuple):
    """Mark of a world in which all surfaces follow force laws."""

    unused: float


class Impulses(NamedTuple):
    """Mark of a world in which some surface follows the impulse law."""

    unused: float


class World(NamedTuple):
    """Obstacles and gravity."""

    obstacles: Any  # a tuple of Obstacle, or a `springback.contact.scene.faces.SolidScene`
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
    """A shape fixed in the world, viewed from a body: points and normals in body axes."""

    shape: Any
    position: Vec  # of the body, world [m]
    r: Mat3  # body axes to world axes


@generic
def in_body_frame(shape: Any, position: Vec, r: Mat3) -> Any:
    """A shape in the frame of a body: its axes, with the body at the origin.

    The default accepts any shape; registering a shape here can be faster.

    Args:
        shape: In world axes.
        position: Position of the body, world [m].
        r: Rotation from body axes to world axes.
    """
    return InBodyFrame(shape, position, r)


@in_body_frame.register(Plane)
@kernel
def _plane_in_body_frame(plane: Plane, position: Vec, r: Mat3) -> Plane:
    return Plane(plane.normal @ r, plane.offset - plane.normal @ position)


@in_body_frame.register(SecondContact)
@kernel
def _second_in_body_frame(second: SecondContact, position: Vec, r: Mat3) -> SecondContact:
    return SecondContact(in_body_frame(second.shape, position, r))


@signed_distance.register(SecondContact)
@kernel
def _second_distance(second: SecondContact, point: Vec) -> float:
    return signed_distance(second.shape, point)


@outward_normal.register(SecondContact)
@kernel
def _second_normal(second: SecondContact, point: Vec) -> Vec:
    return outward_normal(second.shape, point)


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
    """An obstacle in the frame of a body: its axes, with the body at the origin."""
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

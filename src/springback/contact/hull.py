"""The main body's hull against obstacles.

A sphere is the one body whose contact with any obstacle is exact: its gap is the signed distance of
its centre less its radius, and it touches on the normal through its centre.  It meets what a cage
meets, by the same laws (`springback.contact.cage.meeting_while`).
"""

from __future__ import annotations

from typing import Any

from springback.contact.cage import FAR, Facing, Meeting, Support, apart, faced, meeting_while
from springback.contact.obstacles import Again, Obstacle, outward_normal, signed_distance
from springback.kernels.compiler import generic, kernel
from springback.kernels.vectors import Vec
from springback.vehicle.state import ArmPose, Sphere


@generic
def sphere_faced(shape: Any, hull: Sphere, radius: float, pose: ArmPose) -> Facing:
    """Where a sphere about the end of a pose is nearest to a shape."""
    return _sphere_faced_once(shape, radius, pose)


@sphere_faced.register(object)
@kernel
def _any_faced(shape: Any, hull: Sphere, radius: float, pose: ArmPose) -> Facing:
    return _sphere_faced_once(shape, radius, pose)


@sphere_faced.register(Again)
@kernel
def _faced_again(shape: Again, hull: Sphere, radius: float, pose: ArmPose) -> Facing:
    """Far away: a sphere touches a shape at one point."""
    there = _sphere_faced_once(shape.shape, radius, pose)
    return Facing(FAR, there.inward, there.at)


@kernel
def _sphere_faced_once(shape: Any, radius: float, pose: ArmPose) -> Facing:
    inward = -outward_normal(shape, pose.lever)
    lever = radius * inward
    at = Support(lever, lever, lever, 0.0)
    return Facing(signed_distance(shape, pose.lever) - radius, inward, at)


@faced.register(Sphere)
@kernel
def _hull_faced(model: Sphere, shape: Any, radius: float, arm: ArmPose) -> Facing:
    return sphere_faced(shape, model, radius, arm)


@kernel
def _pose(hull: Sphere, velocity: Vec) -> ArmPose:
    """A sphere as the end of an arm that does not slide."""
    return ArmPose(Vec(0.0, 0.0, 0.0), hull.centre, velocity)


@kernel
def hull_apart(obstacle: Obstacle, hull: Sphere) -> float:
    """The gap between the hull and an obstacle as it is seen from the main body [m]."""
    return apart(obstacle, hull, hull.radius, _pose(hull, Vec(0.0, 0.0, 0.0)))


@kernel
def hull_meeting(
    obstacle: Obstacle, engaged: float, hull: Sphere, velocity: Vec, omega: Vec, vertical: Vec
) -> Meeting:
    """Eqs. (13)-(15) for the hull and one obstacle.

    Args:
        obstacle: As it is seen from the main body.
        engaged: As for `springback.contact.cage.meeting_while`.
        hull: Of the main body.
        velocity: Rᵀ v, of the main body, body axes [m/s].
        omega: ω [rad/s].
        vertical: Rᵀ e_Z.
    """
    pose = _pose(hull, velocity)
    return meeting_while(obstacle, engaged, hull, hull.radius, pose, omega, vertical)

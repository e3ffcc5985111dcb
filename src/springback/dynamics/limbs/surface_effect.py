"""Thrust of rotors above surfaces: the ground effect of Cheeseman and Bennett, at any obstacle.

Source: I. C. Cheeseman and W. E. Bennett, "The effect of the ground on a helicopter rotor in
forward flight", ARC R. & M. 3021, 1955: in hover a rotor is a source of strength R² v/4, and a
plane at the distance z is its image at 2 z, which slows the flow through the rotor by (R/(4 z))² v;
at the same power the thrust is larger by

    T/T∞ = 1/(1 − (R/(4 z))²).

Here z is the distance of the middle of the disc from the obstacle, whose tangent plane counts.  The
image blows along the normal n of that plane; its part along the axis a counts, so that the square
is multiplied by n·a.  A wall beside an upright rotor therefore changes nothing.  Neither does what
is above it: n·a < 0 is left out, as the image would take thrust there, and ceilings are measured to
add some (Hsiao and Chirarattananon, arXiv 1905.04632).
"""

from __future__ import annotations

from typing import Any

from springback.contact.cage import ContactFace, contact_faces
from springback.kernels.compiler import kernel
from springback.kernels.trees import fold, tree_map
from springback.kernels.vectors import Vec, larger, positive_part
from springback.vehicle.placed.rotors import RotorPose, poses_of_all
from springback.vehicle.propulsion import SurfaceEffect
from springback.vehicle.state import Airframe, ArmPose, Sphere


@kernel
def image_flow(effect: SurfaceEffect, height: float, upward: float) -> float:
    """Share by which an image slows the flow through a rotor, at most that of the least height.

    Args:
        effect: Constants.
        height: z, of the middle of the disc above the surface [m].
        upward: n·a, cosine between the outward normal of the surface and the axis of the rotor.
    """
    ratio = effect.radius / (4.0 * larger(height, effect.least_height))
    return ratio * ratio * positive_part(upward)


@kernel
def _strongest(so_far: float, face: ContactFace, effect: SurfaceEffect, up: Vec) -> float:
    near = face.nearest
    return larger(image_flow(effect, near.gap, -(near.inward @ up)), so_far)


@kernel
def _raised(thrust: float, pose: RotorPose, effect: SurfaceEffect, obstacles: Any) -> float:
    """Thrust of a rotor [N], with that of the obstacle which matters most."""
    none, up = Vec(0.0, 0.0, 0.0), pose.up
    middle = pose.mount.end + pose.lever + effect.height * up
    faces = contact_faces(obstacles, Sphere(none, 0.0), 0.0, ArmPose(none, middle, none), 1.0)
    return thrust / (1.0 - fold(_strongest, 0.0, faces, (effect, up)))


@kernel
def thrusts_near(
    thrust: tuple[float, ...],
    effect: SurfaceEffect,
    airframe: Airframe,
    lengths: tuple[float, ...],
    obstacles: Any,
) -> tuple[float, ...]:
    """Thrusts of all rotors near obstacles [N].

    Args:
        thrust: Far from all of them [N].
        effect: Constants.
        airframe: Of the vehicle.
        lengths: Of its arms [m].
        obstacles: In the body frame.
    """
    poses = poses_of_all(airframe.rotors, airframe.arms, lengths)
    return tree_map(_raised, (thrust, poses), (effect, obstacles))

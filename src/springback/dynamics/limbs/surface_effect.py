"""Rotors near surfaces: the ground effect of Cheeseman and Bennett, and suction by walls.

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

A wall beside a rotor draws it near, by a share of its thrust that falls linearly with the distance
d of the middle of its disc, to nothing at some radii:

    S = s T (1 − d/(b R)) (m − (m·a) a),   m the normal into the wall

It acts on the main body where the rotor is, and not along the path of an arm.  Numbers are the
user's; `springback.vehicle.propulsion.SurfaceEffectSettings` names a measurement.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.cage import ContactFace, contact_faces
from springback.kernels.compiler import kernel
from springback.kernels.trees import field_of, fold, select, tree_map, tree_sum
from springback.kernels.vectors import Vec, larger, positive_part
from springback.vehicle.placed.rotors import RotorPose, RotorWrench, poses_of_all
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
def _drawn(so_far: Vec, face: ContactFace, effect: SurfaceEffect, up: Vec) -> Vec:
    """Suction per thrust, of the surface that draws most; body axes."""
    near = face.nearest
    share = effect.suction * positive_part(1.0 - positive_part(near.gap) / effect.reach)
    drawn = share * (near.inward - (near.inward @ up) * up)
    return select(drawn @ drawn > so_far @ so_far, drawn, so_far)


class SurfaceLoad(NamedTuple):
    """One rotor near obstacles."""

    thrust: float  # [N]
    suction: RotorWrench


class SurfaceLoads(NamedTuple):
    """All rotors of a vehicle near obstacles."""

    thrust: tuple[float, ...]  # of each [N]
    suction: tuple[RotorWrench, ...]  # of all together; empty without an effect


@kernel
def rotors_far(thrust: tuple[float, ...]) -> SurfaceLoads:
    """Rotors that surfaces do nothing to."""
    return SurfaceLoads(thrust, ())


@kernel
def _near(thrust: float, pose: RotorPose, effect: SurfaceEffect, obstacles: Any) -> SurfaceLoad:
    """A rotor by its thrust far away [N], with the obstacles that matter most."""
    none, up = Vec(0.0, 0.0, 0.0), pose.up
    middle = pose.mount.end + pose.lever + effect.height * up
    faces = contact_faces(obstacles, Sphere(none, 0.0), 0.0, ArmPose(none, middle, none), 1.0)
    push = thrust * fold(_drawn, none, faces, (effect, up))
    raised = thrust / (1.0 - fold(_strongest, 0.0, faces, (effect, up)))
    return SurfaceLoad(raised, RotorWrench(push, middle ^ push, 0.0))


@kernel
def rotors_near(
    far: SurfaceLoads,
    effect: SurfaceEffect,
    airframe: Airframe,
    lengths: tuple[float, ...],
    obstacles: Any,
) -> SurfaceLoads:
    """All rotors near obstacles.

    Args:
        far: Their thrusts far from all of them.
        effect: Constants.
        airframe: Of the vehicle.
        lengths: Of its arms [m].
        obstacles: In the body frame.
    """
    poses = poses_of_all(airframe.rotors, airframe.arms, lengths)
    near = tree_map(_near, (far.thrust, poses), (effect, obstacles))
    return SurfaceLoads(field_of(near, "thrust"), (tree_sum(field_of(near, "suction")),))

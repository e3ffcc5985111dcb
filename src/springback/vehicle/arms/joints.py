"""Arms on joints: slides in any direction, and hinges about any axis.

The end of an arm, a point mass, moves on a path that is known by its length: a straight line, or an
arc about a hinge of curvature κ = 1/ρ.  The coordinate of an arm is that length l, as for an arm
that slides in the body plane, and L − l is its compression, along the arc.  With s = l − L, the end
at s = 0 and the unit vectors e₀ along the path and n₀ towards the hinge,

    r(s) = r₀ + e₀ sin(κ s)/κ + n₀ (1 − cos(κ s))/κ,    e = dr/ds = e₀ cos(κ s) + n₀ sin(κ s)

and de/ds = κ n.  What is at the end of a hinged arm turns with it, by κ s about e₀ × n₀.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from springback.kernels.angles import sine_cosine
from springback.kernels.compiler import kernel
from springback.kernels.trees import fold, select
from springback.kernels.vectors import Mat3, Vec, isotropic, larger, norm, outer, positive_part
from springback.vehicle.force_curves import pressed_at
from springback.vehicle.state import (
    ArmEnd,
    ArmPose,
    CompoundHull,
    Propeller,
    arm_pose,
    compression_of,
    end_place,
    farthest_of_arm,
    fastest_of_arm,
    in_body_axes,
    resting_stiffness,
    upper_stop,
)

#: A path of less curvature is straight [1/m].
STRAIGHT = 1e-9


class Joint(NamedTuple):
    """Path of the end of an arm; body axes."""

    end: Vec  # r₀, at the free length, from the main body [m]
    direction: Vec  # e₀, along which the arm gets longer there
    inward: Vec  # n₀, towards the hinge, normal to e₀; any such vector for a slide
    curvature: float  # κ [1/m]; 0 for a slide
    follows: float  # 1: the rotor turns with the arm; 0: its axis remains that of the body


class Latch(NamedTuple):
    """What holds an arm at its free position until a force opens it, as a magnet does."""

    force: float  # F, at which it opens [N]
    travel: float  # d, at which it opens [m]


class JointSpring(NamedTuple):
    """Spring of an arm on a joint, besides its stiffness, by its compression x = L − l."""

    quadratic: float  # force beside the linear one, k₂ x |x| [N/m²]
    preload: float  # force that acts before the arm yields [N]
    play: float  # free travel to either side before the spring acts [m]
    both_sides: float  # 0: it acts in compression only
    curve: tuple[float, ...] = ()  # address of a table of forces besides the others
    latch: tuple[Latch, ...] = ()  # that holds the arm at its free position


class JointedArm(NamedTuple):
    """Constants of an arm on a joint; as `springback.vehicle.state.Arm`, its path apart."""

    joint: Joint
    spring: JointSpring
    mass: float  # m_a [kg]
    inverse_mass: float  # 1/m_a [1/kg]; 0 for an arm that cannot move
    stiffness: float  # k_l, along the path, besides a table [N/m]
    resting_stiffness: float  # by which it is told whether the arm rests [N/m]
    damping: float  # b_l, along the path [N s/m]
    length: float  # L, free length [m]
    shortest: float  # length at one stop [m]
    longest: float  # length at the other [m]
    stop_stiffness: float  # of both end stops [N/m]; 0 switches them off
    stop_dissipation: float  # d of the end stops, force k δ (1 + d δ̇) [s/m]
    compliance: float  # 1 moves, 0 is locked
    cage_radius: float  # r_0 [m]
    torque_ratio: float  # rotor torque about its axis per thrust, with its sign [m]
    hull: tuple[CompoundHull, ...] = ()  # at its end, besides the cage
    propeller: tuple[Propeller, ...] = ()  # at its end, if its size is known
    caged: float = 1.0  # 0: its circle touches nothing, only its hulls do


class JointPose(NamedTuple):
    """Where an arm on a joint is, and how it moves; body axes."""

    end: Vec  # r, from the main body [m]
    direction: Vec  # e
    bend: Vec  # de/dl [1/m]
    axis: Vec  # about which what is at the end turns; unit
    turning: float  # κ l̇, its angular velocity about that [rad/s]
    turn: Mat3  # axes of what is at the end, to body axes


class PathPoint(NamedTuple):
    """Point of the path of an arm's end; body axes."""

    end: Vec  # r, from the main body [m]
    sine: float  # of the angle by which a hinge has turned
    cosine: float


@kernel
def path_point(joint: Joint, way: float) -> PathPoint:
    """Point of a path at a way s from the free end [m], positive as the arm gets longer."""
    k, is_arc = joint.curvature, joint.curvature > STRAIGHT
    turned = sine_cosine(k * way)
    over = 1.0 / select(is_arc, k, 1.0)
    ahead = select(is_arc, turned.sine * over, way)
    aside = select(is_arc, (1.0 - turned.cosine) * over, 0.0)
    end = joint.end + ahead * joint.direction + aside * joint.inward
    return PathPoint(end, turned.sine, turned.cosine)


@kernel
def joint_pose(arm: JointedArm, length: float, rate: float) -> JointPose:
    """Kinematics of an arm on a joint, at a length [m] that changes at a rate [m/s]."""
    along, inward, k = arm.joint.direction, arm.joint.inward, arm.joint.curvature
    end, sine, cosine = path_point(arm.joint, length - arm.length)
    axis = along ^ inward
    return JointPose(
        end,
        cosine * along + sine * inward,
        k * (cosine * inward - sine * along),
        axis,
        k * rate,
        turn_about(axis, sine, 1.0 - cosine),
    )


@kernel
def turn_about(axis: Vec, sine: float, versine: float) -> Mat3:
    """Rotation about a unit vector by an angle φ, from sin φ and 1 − cos φ (Rodrigues)."""
    u, s, v = axis, sine, versine
    c = 1.0 - v
    return Mat3(
        Vec(c + v * u.x * u.x, v * u.x * u.y - s * u.z, v * u.x * u.z + s * u.y),
        Vec(v * u.x * u.y + s * u.z, c + v * u.y * u.y, v * u.y * u.z - s * u.x),
        Vec(v * u.x * u.z - s * u.y, v * u.y * u.z + s * u.x, c + v * u.z * u.z),
    )


@kernel
def point_inertia(mass: float, at: Vec) -> Mat3:
    """Inertia m (r² 1 − r rᵀ) of a point mass about the main body [kg m²]."""
    return mass * (isotropic(at @ at) - outer(at, at))


@kernel
def thrust_direction(arm: JointedArm, pose: JointPose) -> Vec:
    """Direction of the thrust of its rotor, body axes."""
    q, up = pose.turn, Vec(0.0, 0.0, 1.0)
    return select(arm.joint.follows > 0.0, Vec(q.x.z, q.y.z, q.z.z), up)


@kernel
def _farther_of_hull(so_far: float, hull: CompoundHull) -> float:
    return larger(norm(hull.centre) + hull.radius, so_far)


@kernel
def farthest_from_end(arm: Any) -> float:
    """Distance from the end of an arm to the farthest point that touches anything [m]."""
    farthest: float = fold(_farther_of_hull, arm.cage_radius, arm.hull, ())
    return farthest


@arm_pose.register(JointedArm)
@kernel
def _pose_on_joint(arm: JointedArm, length: float, rate: float, velocity: Vec) -> ArmPose:
    there = joint_pose(arm, length, rate)
    return ArmPose(there.direction, there.end, velocity + rate * there.direction)


@end_place.register(JointedArm)
@kernel
def _end_on_joint(arm: JointedArm, length: float) -> ArmEnd:
    end = joint_pose(arm, length, 0.0).end
    distance = math.sqrt(end.x * end.x + end.y * end.y)
    over = 1.0 / select(distance > 0.0, distance, 1.0)
    return ArmEnd(Vec(end.x * over, end.y * over, 0.0), distance)


@compression_of.register(JointedArm)
@kernel
def _travel(arm: JointedArm, length: float) -> float:
    return abs(arm.length - length)


@resting_stiffness.register(JointedArm)
@kernel
def _resting_on_joint(arm: JointedArm) -> float:
    return arm.resting_stiffness


@in_body_axes.register(JointedArm)
@kernel
def _turned(arm: JointedArm, length: float, vector: Vec) -> Vec:
    return joint_pose(arm, length, 0.0).turn @ vector


@upper_stop.register(JointedArm)
@kernel
def _on_joint(arm: JointedArm) -> float:
    return arm.longest


@kernel
def _beyond_disc(so_far: float, disc: Propeller) -> float:
    return larger(disc.radius + abs(disc.height), so_far)


@farthest_of_arm.register(JointedArm)
@kernel
def _farthest_on_joint(arm: JointedArm) -> float:
    travel = larger(arm.longest - arm.length, arm.length - arm.shortest)
    besides = fold(_beyond_disc, farthest_from_end(arm), arm.propeller, ())
    return norm(arm.joint.end) + travel + besides


@fastest_of_arm.register(JointedArm)
@kernel
def _speed_on_joint(arm: JointedArm, rate: float) -> float:
    return abs(rate) * (1.0 + arm.joint.curvature * farthest_from_end(arm))


def preload_strain(spring: JointSpring, stiffness: float, stop_stiffness: float) -> float:
    """How far a preload presses an arm into its stop at rest [m].

    Args:
        spring: Of the arm, with a preload.
        stiffness: Of it, besides a table [N/m].
        stop_stiffness: Of the stop [N/m].
    """
    pulls = stiffness if spring.both_sides > 0.0 and spring.play == 0.0 else 0.0
    return spring.preload / (stop_stiffness + pulls)


class SpringForce(NamedTuple):
    """Force of a spring and the energy in it."""

    force: float  # positive lengthens the arm [N]
    energy: float  # [J]


@kernel
def joint_spring(arm: Any, length: float) -> SpringForce:
    """Spring of an arm on a joint: preload, play, linear, quadratic, or a table, and a latch."""
    spring, x = arm.spring, arm.length - length
    size = positive_part(abs(x) - spring.play)
    square, k, k2 = size * size, arm.stiffness, spring.quadratic
    alone = SpringForce(k * size + k2 * square, square * (0.5 * k + k2 * size / 3.0))
    bent = fold(_with_curve, alone, spring.curve, (size,))
    acts, sign = (x > 0.0) | (spring.both_sides > 0.0), select(x < 0.0, -1.0, 1.0)
    springs = SpringForce(
        select(acts, sign * bent.force, 0.0) + spring.preload,
        select(acts, bent.energy, 0.0) + spring.preload * x,
    )
    return fold(_with_latch, springs, spring.latch, (x,))


@kernel
def latch_force(latch: Latch, pressed: float) -> SpringForce:
    """Force of a latch on an arm that is pressed in by x, and the energy that opening it takes.

    The force 16 F (x/d)/(3 + (x/d)²)² is stiff at first, largest at d, where it is F, and falls
    as 1/x³, as that between two magnets.  It has a potential, (8/3) F d (x/d)²/(3 + (x/d)²): what
    opens it comes back as speed when it closes, to be lost in the damper and the stop.  The form
    is chosen, for its one maximum and its smoothness.
    """
    w = pressed / latch.travel
    square = w * w
    over = 1.0 / (3.0 + square)
    return SpringForce(
        (16.0 * latch.force) * (w * over * over),
        (8.0 / 3.0) * (latch.force * latch.travel) * (square * over),
    )


@kernel
def _with_latch(so_far: SpringForce, latch: Latch, pressed: float) -> SpringForce:
    held = latch_force(latch, pressed)
    return SpringForce(so_far.force + held.force, so_far.energy + held.energy)


@kernel
def _with_curve(so_far: SpringForce, curve: float, size: float) -> SpringForce:
    more = pressed_at(curve, size)
    return SpringForce(so_far.force + more.force, so_far.energy + more.energy)

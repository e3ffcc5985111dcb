"""Arms on two joints, one after the other: a hinge about two axes, or a slide on a hinge.

The first joint is on the main body and carries the second, whose axis and point are given where
both are free.  With the ways s₁ = l − L and s₂ along both paths (`springback.vehicle.arms.joints`),
x₁ and x₂ the points that the end would have on each alone, R₁ and R₂ their turns, and r₀ the free
end, which both paths share,

    r = x₁(s₁) + R₁(s₁) d,    d = x₂(s₂) − r₀,    R = R₁ R₂
    e₁ = ∂r/∂s₁ = t₁ + κ₁ a₁ × R₁ d,    e₂ = ∂r/∂s₂ = R₁ t₂

with t the tangents of the paths and a the axes of the hinges.  Each way is thus a length of the
end's own path while the other joint is free.  e₂ is a unit vector always, e₁ only at s₂ = 0, and
they need not be normal to each other: motion along both is solved for with the matrix of their
products, G = [e₁ e₂]ᵀ [e₁ e₂].  A universal joint has both hinges in one point.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import fold, select, tree_map
from springback.kernels.vectors import Mat3, Vec, larger, norm
from springback.vehicle.arms.joints import (
    Joint,
    JointedArm,
    JointSpring,
    farthest_from_end,
    path_point,
    turn_about,
)
from springback.vehicle.state import (
    ArmEnd,
    ArmPose,
    Bend,
    CompoundHull,
    Propeller,
    State,
    arm_pose,
    compression_of,
    coordinates_of_arms,
    end_place,
    farthest_of_arm,
    fastest_of_arm,
    in_body_axes,
    largest_rate,
    rates_of_arms,
    resting_stiffness,
    upper_stop,
)


class SecondJoint(NamedTuple):
    """Constants of the second joint of an arm: what `JointedArm` has of its own."""

    joint: Joint
    spring: JointSpring
    stiffness: float  # k, along the path, besides a table [N/m]
    resting_stiffness: float  # by which it is told whether the arm rests [N/m]
    damping: float  # b, along the path [N s/m]
    length: float  # its free position, 0 [m]
    shortest: float  # s₂ at one stop [m]
    longest: float  # s₂ at the other [m]
    stop_stiffness: float  # of both end stops [N/m]; 0 switches them off
    stop_dissipation: float  # d of the end stops, force k δ (1 + d δ̇) [s/m]
    compliance: float  # 1 moves, 0 is locked


class BentArm(NamedTuple):
    """Constants of an arm on two joints: as `JointedArm`, on its first one, and the second."""

    joint: Joint
    spring: JointSpring
    mass: float  # m_a [kg]
    inverse_mass: float  # 1/m_a [1/kg]; 0 for an arm that cannot move
    stiffness: float  # k_l, along the first path, besides a table [N/m]
    resting_stiffness: float  # by which it is told whether the arm rests [N/m]
    damping: float  # b_l, along the first path [N s/m]
    length: float  # L, free length [m]
    shortest: float  # length at one stop of the first joint [m]
    longest: float  # length at the other [m]
    stop_stiffness: float  # of both end stops [N/m]; 0 switches them off
    stop_dissipation: float  # d of the end stops, force k δ (1 + d δ̇) [s/m]
    compliance: float  # 1 moves, 0 is locked
    cage_radius: float  # r_0 [m]
    torque_ratio: float  # rotor torque about its axis per thrust, with its sign [m]
    second: SecondJoint
    hull: tuple[CompoundHull, ...] = ()  # at its end, besides the cage
    propeller: tuple[Propeller, ...] = ()  # at its end, if its size is known
    caged: float = 1.0  # 0: its circle touches nothing, only its hulls do


#: Arms that are not in the body plane.
ON_JOINTS = (JointedArm, BentArm)


class BentCoordinates(NamedTuple):
    """A number for each of the two joints of an arm: a length, a rate, an acceleration, a force."""

    first: float
    second: float


@generic
def coordinates_on(given: Any) -> BentCoordinates:
    """Both coordinates of an arm; where its length alone is known, the second is taken as free."""
    return BentCoordinates(given, 0.0)


@coordinates_on.register(BentCoordinates)
@kernel
def _both_given(given: BentCoordinates) -> BentCoordinates:
    return given


@largest_rate.register(BentCoordinates)
@kernel
def _larger_rate(rate: BentCoordinates) -> float:
    return larger(abs(rate.first), abs(rate.second))


class BentPose(NamedTuple):
    """Where an arm on two joints is, and how it moves; body axes."""

    end: Vec  # r, from the main body [m]
    first: Vec  # e₁
    second: Vec  # e₂
    bias: Vec  # acceleration of the end at constant rates ṡ₁ and ṡ₂ [m/s²]
    about_first: Vec  # κ₁ a₁: angular velocity of what is at the end, for each m/s of ṡ₁ [1/m]
    about_second: Vec  # κ₂ R₁ a₂, the same for ṡ₂ [1/m]
    velocity: Vec  # ṡ₁ e₁ + ṡ₂ e₂, of the end as seen from the body [m/s]
    spin: Vec  # of what is at the end, as seen from the body [rad/s]
    turn: Mat3  # axes of what is at the end, to body axes


@kernel
def bent_pose(arm: BentArm, length: Any, rate: Any) -> BentPose:
    """Kinematics of an arm on two joints.

    Args:
        arm: Constants of the arm.
        length: `BentCoordinates` [m], or the length alone, for a free second joint.
        rate: Of these [m/s].
    """
    at, speed = coordinates_on(length), coordinates_on(rate)
    inner, outer = arm.joint, arm.second.joint
    there = path_point(inner, at.first - arm.length)
    beyond = path_point(outer, at.second - arm.second.length)
    axis, other = inner.direction ^ inner.inward, outer.direction ^ outer.inward
    turned = turn_about(axis, there.sine, 1.0 - there.cosine)
    out = turned @ (beyond.end - outer.end)
    about = inner.curvature * axis
    about_second = turned @ (outer.curvature * other)
    tangent = there.cosine * inner.direction + there.sine * inner.inward
    curving = inner.curvature * (there.cosine * inner.inward - there.sine * inner.direction)
    first = tangent + (about ^ out)
    second = turned @ (beyond.cosine * outer.direction + beyond.sine * outer.inward)
    bend = outer.curvature * (beyond.cosine * outer.inward - beyond.sine * outer.direction)
    s, u = speed.first, speed.second
    bias = (
        (s * s) * (curving + (about ^ (about ^ out)))
        + (2.0 * s * u) * (about ^ second)
        + (u * u) * (turned @ bend)
    )
    return BentPose(
        there.end + out, first, second, bias, about, about_second, s * first + u * second,
        s * about + u * about_second,
        turned @ turn_about(other, beyond.sine, 1.0 - beyond.cosine),
    )  # fmt: skip


class BentInverse(NamedTuple):
    """Inverse of G, the products of e₁ and e₂."""

    xx: float
    yy: float
    xy: float


@kernel
def bent_mobility(there: BentPose) -> BentInverse:
    """Inverse of the matrix of the products of e₁ and e₂."""
    xx, yy = there.first @ there.first, there.second @ there.second
    xy = there.first @ there.second
    scale = 1.0 / (xx * yy - xy * xy)
    return BentInverse(yy * scale, xx * scale, -xy * scale)


@kernel
def along_both(inverse: BentInverse, first: float, second: float) -> BentCoordinates:
    """Product of that inverse with what acts along both paths."""
    return BentCoordinates(
        inverse.xx * first + inverse.xy * second, inverse.xy * first + inverse.yy * second
    )


@kernel
def bent_thrust_direction(arm: BentArm, there: BentPose) -> Vec:
    """Direction of the thrust of its rotor, body axes."""
    q, up = there.turn, Vec(0.0, 0.0, 1.0)
    return select(arm.joint.follows > 0.0, Vec(q.x.z, q.y.z, q.z.z), up)


@kernel
def _coordinates(length: float, bend: Bend) -> BentCoordinates:
    return BentCoordinates(length, bend.way)


@kernel
def _rates(rate: float, bend: Bend) -> BentCoordinates:
    return BentCoordinates(rate, bend.rate)


@coordinates_of_arms.register(BentArm)
@kernel
def _both_coordinates(arm: BentArm, state: State) -> tuple[Any, ...]:
    return tree_map(_coordinates, (state.arm_length, state.bends), ())


@rates_of_arms.register(BentArm)
@kernel
def _both_rates(arm: BentArm, state: State) -> tuple[Any, ...]:
    return tree_map(_rates, (state.arm_rate, state.bends), ())


@arm_pose.register(BentArm)
@kernel
def _pose_on_two(arm: BentArm, length: Any, rate: Any, velocity: Vec) -> ArmPose:
    there = bent_pose(arm, length, rate)
    return ArmPose(there.first, there.end, velocity + there.velocity)


@end_place.register(BentArm)
@kernel
def _end_on_two(arm: BentArm, length: Any) -> ArmEnd:
    end = bent_pose(arm, length, 0.0).end
    distance = math.sqrt(end.x * end.x + end.y * end.y)
    over = 1.0 / select(distance > 0.0, distance, 1.0)
    return ArmEnd(Vec(end.x * over, end.y * over, 0.0), distance)


@compression_of.register(BentArm)
@kernel
def _travel_on_two(arm: BentArm, length: Any) -> float:
    """The larger of both."""
    at = coordinates_on(length)
    return larger(abs(arm.length - at.first), abs(arm.second.length - at.second))


@resting_stiffness.register(BentArm)
@kernel
def _resting_on_two(arm: BentArm) -> float:
    return arm.resting_stiffness


@in_body_axes.register(BentArm)
@kernel
def _turned_on_two(arm: BentArm, length: Any, vector: Vec) -> Vec:
    return bent_pose(arm, length, 0.0).turn @ vector


@upper_stop.register(BentArm)
@kernel
def _on_first(arm: BentArm) -> float:
    return arm.longest


@upper_stop.register(SecondJoint)
@kernel
def _on_second(arm: SecondJoint) -> float:
    return arm.longest


@kernel
def _beyond_disc(so_far: float, disc: Propeller) -> float:
    return larger(disc.radius + abs(disc.height), so_far)


@kernel
def _travel_of(arm: Any) -> float:
    return larger(arm.longest - arm.length, arm.length - arm.shortest)


@kernel
def _reach_of_end(arm: BentArm) -> float:
    """Distance from the end to the farthest point that turns with it [m]."""
    return fold(_beyond_disc, farthest_from_end(arm), arm.propeller, ())


@farthest_of_arm.register(BentArm)
@kernel
def _farthest_on_two(arm: BentArm) -> float:
    """By x₁, which is within the first travel of r₀, and d, as long as the second at most."""
    travels = _travel_of(arm) + _travel_of(arm.second)
    return norm(arm.joint.end) + travels + _reach_of_end(arm)


@fastest_of_arm.register(BentArm)
@kernel
def _speed_on_two(arm: BentArm, rate: Any) -> float:
    """|e₁| is at most 1 + κ₁ |d|."""
    speed, far = coordinates_on(rate), _reach_of_end(arm)
    first = 1.0 + arm.joint.curvature * (_travel_of(arm.second) + far)
    second = 1.0 + arm.second.joint.curvature * far
    return abs(speed.first) * first + abs(speed.second) * second

"""Rotors that a vehicle lists: where they are, and what their thrusts do.

A rotor is fixed to the main body or to the end of an arm, at an offset d from it, and blows along
its own axis a.  With the end of its arm at r, a thrust T pushes with F = T a, turns with
n = d × F + Q a about that end, where Q is c T and what it gives by changing its speed, and

    moves the vehicle with F and r × F + n, and the arm along its path with e·F + κ u·n

where e is the direction of the path, κ its curvature and u the axis of a hinge.  The main body is
an arm without length.  A vehicle without a list has one rotor at the end of each arm
(`springback.dynamics.limbs`): this module is then not compiled.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import field_of, fold, one_tuple, replace, select, tree_map, tree_sum
from springback.kernels.vectors import Mat3, Vec
from springback.vehicle.arms.bent import (
    BentArm,
    along_both,
    bent_mobility,
    bent_pose,
    coordinates_on,
)
from springback.vehicle.arms.joints import JointedArm, joint_pose
from springback.vehicle.state import Airframe, Arm, Propeller, arm_direction, farthest_of_rotors


class PlacedRotor(NamedTuple):
    """Constants of one rotor."""

    arm: float  # number of the arm at whose end it is; 0: on the main body
    offset: Vec  # d, from what it is on [m]
    axes: Mat3  # of its disc, one a column, in those of what it is on; it blows along the third
    torque_ratio: float  # c, torque about its axis per thrust, with its sign [m]
    lifts: float  # 1 if springback's own pilots use it
    propeller: tuple[Propeller, ...] = ()  # if its size is known


class PlacedRotors(NamedTuple):
    """All rotors of a vehicle that lists them."""

    each: tuple[PlacedRotor, ...]
    arms: tuple[float, ...]  # numbers of the arms, from 1
    farthest: float  # distance from the main body that no disc exceeds, arms in their travel [m]


class Mount(NamedTuple):
    """What a rotor is fixed to at one instant: the main body, or the end of an arm; body axes."""

    end: Vec  # r, from the main body [m]
    turn: Mat3  # axes of what is there, to body axes
    aim: Mat3  # the same for the axes of rotors
    direction: Vec  # e; zero for the main body
    bend: Vec  # κ u [1/m]; zero but for a hinge
    rate: float  # l̇ [m/s]
    second: tuple[SecondMount, ...] = ()  # of an arm on two joints; of all or of none


class SecondMount(NamedTuple):
    """Second joint of the arm that a rotor is on; body axes."""

    direction: Vec  # e₂
    bend: Vec  # κ₂ u₂ [1/m]
    rate: float  # ṡ₂ [m/s]
    pull: Vec  # force on the end whose components are 1 N along the first path, 0 along this
    own_pull: Vec  # the reverse


class NumberedMount(NamedTuple):
    """End of an arm, with the number of that arm."""

    number: float
    mount: Mount


class RotorPose(NamedTuple):
    """Where a rotor is; body axes."""

    mount: Mount
    lever: Vec  # d, from what it is fixed to [m]
    up: Vec  # a, along which it pushes


class RotorWrench(NamedTuple):
    """What rotors do to a vehicle; body axes."""

    push: Vec  # [N]
    moment: Vec  # about the main body [N m]
    arm_power: float  # by the motion of the arms [W]


class RotorLoad(NamedTuple):
    """What one rotor does."""

    wrench: RotorWrench
    along: float  # force along the path of its arm [N]
    second: tuple[float, ...] = ()  # the same along the path of the second joint


class ActingRotors(NamedTuple):
    """What the rotors of a vehicle do to it."""

    thrust: tuple[float, ...]  # of the rotor of each arm; zero where rotors are listed [N]
    pulls: tuple[tuple[Vec, ...], ...]  # on the end of each arm along its path, body axes [N]
    listed: tuple[RotorWrench, ...]  # of all listed rotors together; empty without a list
    reaction: tuple[float, ...]  # of rotors of arms that change speed, about body z [N m]


# -- places ----------------------------------------------------------------------------------------


@kernel
def body_mount() -> Mount:
    """The main body, to which a rotor may be fixed."""
    none = Vec(0.0, 0.0, 0.0)
    turn = Mat3(Vec(1.0, 0.0, 0.0), Vec(0.0, 1.0, 0.0), Vec(0.0, 0.0, 1.0))
    return Mount(none, turn, turn, none, none, 0.0, ())


@generic
def mount_of(arm: Any, length: float, rate: float) -> Mount:
    """The end of an arm at a length [m] that changes at a rate [m/s]."""
    raise TypeError(f"{type(arm).__name__} is not an arm")


@mount_of.register(Arm)
@kernel
def _on_slide(arm: Arm, length: float, rate: float) -> Mount:
    e, body = arm_direction(arm), body_mount()
    return Mount(length * e, body.turn, body.turn, e, body.bend, rate, ())


@mount_of.register(JointedArm)
@kernel
def _on_joint(arm: JointedArm, length: float, rate: float) -> Mount:
    there = joint_pose(arm, length, rate)
    aim = select(arm.joint.follows > 0.0, there.turn, body_mount().turn)
    bend = arm.joint.curvature * there.axis
    return Mount(there.end, there.turn, aim, there.direction, bend, rate, ())


@mount_of.register(BentArm)
@kernel
def _on_two_joints(arm: BentArm, length: Any, rate: Any) -> Mount:
    there, speed = bent_pose(arm, length, rate), coordinates_on(rate)
    aim = select(arm.joint.follows > 0.0, there.turn, body_mount().turn)
    to_first = along_both(bent_mobility(there), 1.0, 0.0)
    to_second = along_both(bent_mobility(there), 0.0, 1.0)
    way = SecondMount(
        there.second, there.about_second, speed.second,
        to_first.first * there.first + to_first.second * there.second,
        to_second.first * there.first + to_second.second * there.second,
    )  # fmt: skip
    return Mount(there.end, there.turn, aim, there.first, there.about_first, speed.first, (way,))


@kernel
def _no_way(way: SecondMount) -> SecondMount:
    none = Vec(0.0, 0.0, 0.0)
    return SecondMount(none, none, 0.0, none, none)


@kernel
def _no_ways(like: NumberedMount) -> tuple[SecondMount, ...]:
    return tree_map(_no_way, (like.mount.second,), ())


@kernel
def _main_body(mounts: tuple[NumberedMount, ...]) -> Mount:
    """The main body as a mount of the structure that those of the arms have."""
    return replace(body_mount(), second=one_tuple(tree_map(_no_ways, (mounts[:1],), ())))


@kernel
def _numbered(number: float, arm: Any, length: float, rate: float) -> NumberedMount:
    return NumberedMount(number, mount_of(arm, length, rate))


@kernel
def mounts_of(
    rotors: PlacedRotors,
    arms: tuple[Any, ...],
    lengths: tuple[float, ...],
    rates: tuple[float, ...],
) -> tuple[NumberedMount, ...]:
    """Ends of all arms, by their lengths [m] and the rates of these [m/s]."""
    return tree_map(_numbered, (rotors.arms, arms, lengths, rates), ())


@kernel
def _if_wanted(so_far: Mount, here: NumberedMount, wanted: float) -> Mount:
    return select(here.number == wanted, here.mount, so_far)


@kernel
def rotor_pose(rotor: PlacedRotor, mounts: tuple[NumberedMount, ...]) -> RotorPose:
    """Where a rotor is."""
    mount, q = fold(_if_wanted, _main_body(mounts), mounts, (rotor.arm,)), rotor.axes
    return RotorPose(mount, mount.turn @ rotor.offset, mount.aim @ Vec(q.x.z, q.y.z, q.z.z))


@kernel
def _no_rate(length: Any) -> float:
    return 0.0


@kernel
def poses_at(
    rotors: PlacedRotors, arms: tuple[Any, ...], lengths: tuple[float, ...]
) -> tuple[RotorPose, ...]:
    """Where all rotors are, by the lengths of the arms [m], which do not change."""
    mounts = mounts_of(rotors, arms, lengths, tree_map(_no_rate, (lengths,), ()))
    return tree_map(rotor_pose, (rotors.each,), (mounts,))


@kernel
def _pose_at_end(arm: Any, length: float) -> RotorPose:
    mount = mount_of(arm, length, 0.0)
    q = mount.aim
    return RotorPose(mount, Vec(0.0, 0.0, 0.0), Vec(q.x.z, q.y.z, q.z.z))


@generic
def poses_of_all(
    rotors: Any, arms: tuple[Any, ...], lengths: tuple[float, ...]
) -> tuple[RotorPose, ...]:
    """As `poses_at`, also of rotors at the ends of arms, without a list."""
    return tree_map(_pose_at_end, (arms, lengths), ())


@poses_of_all.register(PlacedRotors)
@kernel
def _poses_of_listed(
    rotors: PlacedRotors, arms: tuple[Any, ...], lengths: tuple[float, ...]
) -> tuple[RotorPose, ...]:
    return poses_at(rotors, arms, lengths)


# -- loads -----------------------------------------------------------------------------------------


@kernel
def _load_of(pose: RotorPose, push: Vec, torque: float) -> RotorLoad:
    """Load of a force at a rotor [N] and a moment about its axis [N m]."""
    mount, turning = pose.mount, (pose.lever ^ push) + torque * pose.up
    along = mount.direction @ push + mount.bend @ turning
    power = fold(_with_second_power, mount.rate * along, mount.second, (push, turning))
    wrench = RotorWrench(push, (mount.end ^ push) + turning, power)
    return RotorLoad(wrench, along, tree_map(_along_second, (mount.second,), (push, turning)))


@kernel
def _along_second(way: SecondMount, push: Vec, turning: Vec) -> float:
    return way.direction @ push + way.bend @ turning


@kernel
def _with_second_power(so_far: float, way: SecondMount, push: Vec, turning: Vec) -> float:
    return so_far + way.rate * _along_second(way, push, turning)


@kernel
def rotor_load(pose: RotorPose, rotor: PlacedRotor, thrust: float) -> RotorLoad:
    """What one rotor does to its vehicle by its thrust [N]."""
    return _load_of(pose, thrust * pose.up, thrust * rotor.torque_ratio)


@kernel
def _with_torque(load: RotorLoad, pose: RotorPose, torque: float) -> RotorLoad:
    return tree_sum((load, _load_of(pose, Vec(0.0, 0.0, 0.0), torque)))


@kernel
def _with_torques(
    loads: tuple[RotorLoad, ...], torques: tuple[float, ...], poses: tuple[RotorPose, ...]
) -> tuple[RotorLoad, ...]:
    return tree_map(_with_torque, (loads, poses, torques), ())


@kernel
def _along_if_on(load: RotorLoad, rotor: PlacedRotor, number: float) -> float:
    return select(rotor.arm == number, load.along, 0.0)


@kernel
def _pull(
    here: NumberedMount, loads: tuple[RotorLoad, ...], each: tuple[PlacedRotor, ...]
) -> tuple[Vec]:
    along = tree_sum(tree_map(_along_if_on, (loads, each), (here.number,)))
    mount = here.mount
    return (fold(_pull_on_two, along * mount.direction, mount.second, (along, here, loads, each)),)


@kernel
def _pull_on_two(
    alone: Vec, way: SecondMount, along: float, here: NumberedMount,
    loads: tuple[RotorLoad, ...], each: tuple[PlacedRotor, ...],
) -> Vec:  # fmt: skip
    """A force whose components along both paths are those of all rotors on the arm."""
    second = tree_sum(tree_map(_second_if_on, (loads, each), (here.number,)))
    return along * way.pull + second * way.own_pull


@kernel
def _second_if_on(load: RotorLoad, rotor: PlacedRotor, number: float) -> float:
    return select(rotor.arm == number, tree_sum(load.second), 0.0)


@kernel
def _no_pull(arm: Any) -> tuple[()]:
    return ()


@kernel
def _no_thrust(arm: Any) -> float:
    return 0.0


@generic
def acting_rotors(
    rotors: Any,
    arms: tuple[Any, ...],
    lengths: tuple[float, ...],
    rates: tuple[float, ...],
    thrust: tuple[float, ...],
    reaction: tuple[Any, ...],
) -> ActingRotors:
    """What the rotors of a vehicle do to it.

    Args:
        rotors: `PlacedRotors`; empty for one at the end of each arm.
        arms: Constants of all arms.
        lengths: l_j [m].
        rates: l̇_j [m/s].
        thrust: Of each rotor [N].
        reaction: Of rotors that change speed [N m]: that of all about body z; or, of listed
            rotors, a tuple with that of each about its axis; empty where it is not known.
    """
    return ActingRotors(thrust, tree_map(_no_pull, (arms,), ()), (), reaction)


@acting_rotors.register(PlacedRotors)
@kernel
def _listed(
    rotors: PlacedRotors,
    arms: tuple[Any, ...],
    lengths: tuple[float, ...],
    rates: tuple[float, ...],
    thrust: tuple[float, ...],
    reaction: tuple[Any, ...],
) -> ActingRotors:
    mounts = mounts_of(rotors, arms, lengths, rates)
    poses = tree_map(rotor_pose, (rotors.each,), (mounts,))
    by_thrust = tree_map(rotor_load, (poses, rotors.each, thrust), ())
    loads = fold(_with_torques, by_thrust, reaction, (poses,))
    pulls = tree_map(_pull, (mounts,), (loads, rotors.each))
    whole = tree_sum(field_of(loads, "wrench"))
    return ActingRotors(tree_map(_no_thrust, (arms,), ()), pulls, (whole,), ())


@kernel
def with_rotor_push(force: Vec, listed: RotorWrench) -> Vec:
    """A force with that of listed rotors [N]."""
    return force + listed.push


@kernel
def with_rotor_moment(moment: Vec, listed: RotorWrench) -> Vec:
    """A moment about the main body with that of listed rotors [N m]."""
    return moment + listed.moment


@kernel
def with_lift(thrust: float, listed: RotorWrench) -> float:
    """A collective thrust with that of listed rotors along body z [N]."""
    return thrust + listed.push.z


@kernel
def with_rotor_power(power: float, listed: RotorWrench, velocity: Vec) -> float:
    """Power of rotors [W] with that of listed ones, but for that of their moment.

    Args:
        power: That of the moment of all, and of others.
        listed: What they do.
        velocity: Of the main body, body axes [m/s].
    """
    return power + listed.push @ velocity + listed.arm_power


# -- hits, reach -----------------------------------------------------------------------------------


class Guard(NamedTuple):
    """What guards one rotor: the cage and hulls of the arm that it is on."""

    normal: float  # normal force on it [N]
    impulsive: float  # 1 if it approaches a surface of the impulse law


@generic
def guards_of(rotors: Any, arms: tuple[Any, ...]) -> tuple[Any, ...]:
    """Of each rotor what guards it, by the views of all arms; nothing guards one on the body."""
    return arms


@guards_of.register(PlacedRotors)
@kernel
def _guards_by_arm(rotors: PlacedRotors, arms: tuple[Any, ...]) -> tuple[Guard, ...]:
    seen = tree_map(_numbered_guard, (rotors.arms, arms), ())
    return tree_map(_guard_of, (rotors.each,), (seen,))


class NumberedGuard(NamedTuple):
    """Guard of an arm, with the number of that arm."""

    number: float
    guard: Guard


@kernel
def _numbered_guard(number: float, arm: Any) -> NumberedGuard:
    return NumberedGuard(number, Guard(arm.normal, arm.impulsive))


@kernel
def _guard_if(so_far: Guard, here: NumberedGuard, wanted: float) -> Guard:
    return select(here.number == wanted, here.guard, so_far)


@kernel
def _guard_of(rotor: PlacedRotor, seen: tuple[NumberedGuard, ...]) -> Guard:
    return fold(_guard_if, Guard(0.0, 0.0), seen, (rotor.arm,))


@farthest_of_rotors.register(PlacedRotors)
@kernel
def _farthest(rotors: PlacedRotors) -> tuple[float]:
    return (rotors.farthest,)


def propellers_of(airframe: Airframe) -> int:
    """Number of propellers of known size."""
    holders = getattr(airframe.rotors, "each", airframe.arms)
    return sum(len(one.propeller) for one in holders)

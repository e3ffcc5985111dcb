"""Rotor thrusts from thrust and moment, and back, for the present arm lengths.

The rotors have the effects of eqs. (2) and (10) of the paper, for any number of arms in any
directions; or those of rotors that a vehicle lists.  Forces across body z are not commanded: what
the shares of least norm leave of them, a tilted rotor's own, disturbs.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.control.target import Wrench
from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import maximum, minimum, tree_map, tree_sum
from springback.kernels.vectors import Vec, within
from springback.vehicle.arms.bent import BentArm, bent_pose, bent_thrust_direction
from springback.vehicle.arms.joints import JointedArm, joint_pose, thrust_direction
from springback.vehicle.placed.rotors import (
    PlacedRotor,
    PlacedRotors,
    RotorPose,
    poses_at,
    rotor_load,
)
from springback.vehicle.state import Airframe, Arm

#: A pivot smaller than its diagonal entry by this factor is rounding: the rotors lack that effect.
NO_EFFECT = 1e-9
#: Smallest effect of a rotor, relative to 1, used as a divisor (chosen; far below any real one).
SMALL = 1e-9


class Effect(NamedTuple):
    """Column of B(l): contribution of one newton of a rotor to thrust [1] and moments [m]."""

    thrust: float
    roll: float
    pitch: float
    yaw: float


class Gram(NamedTuple):
    """Upper half of B Bᵀ by rows."""

    g00: float
    g01: float
    g02: float
    g03: float
    g11: float
    g12: float
    g13: float
    g22: float
    g23: float
    g33: float


class Mixer(NamedTuple):
    """Allocation at given arm lengths."""

    lengths: tuple[float, ...]  # l_j [m]
    shares: tuple[Effect, ...]  # rows of Bᵀ (B Bᵀ)⁻¹: share of a rotor in each part of a wrench


class Rotor(NamedTuple):
    """Thrust of one rotor, split by purpose."""

    collective: float  # for each newton of collective thrust [1]
    tilting: float  # for the roll and pitch moment [N]
    turning: float  # for the yaw moment [N]


@generic
def rotor_effect(arm: Any, length: float) -> Effect:
    """Effect of the rotor of an arm at a length [m], for each newton of its thrust."""
    raise TypeError(f"{type(arm).__name__} is not an arm")


@rotor_effect.register(JointedArm)
@kernel
def _on_joint(arm: JointedArm, length: float) -> Effect:
    there = joint_pose(arm, length, 0.0)
    up = thrust_direction(arm, there)
    moment = (there.end ^ up) + arm.torque_ratio * up
    return Effect(up.z, moment.x, moment.y, moment.z)


@rotor_effect.register(BentArm)
@kernel
def _on_two_joints(arm: BentArm, length: Any) -> Effect:
    there = bent_pose(arm, length, 0.0)
    up = bent_thrust_direction(arm, there)
    moment = (there.end ^ up) + arm.torque_ratio * up
    return Effect(up.z, moment.x, moment.y, moment.z)


@rotor_effect.register(Arm)
@kernel
def _on_slide(arm: Arm, length: float) -> Effect:
    """Effect by eq. (10): r_j × T_j e_z = (y_j, −x_j, 0) T_j, and the rotor's torque about z."""
    return Effect(1.0, arm.sine * length, -arm.cosine * length, arm.torque_ratio)


@generic
def rotor_effects(
    rotors: Any, arms: tuple[Any, ...], lengths: tuple[float, ...]
) -> tuple[Effect, ...]:
    """Effects of all rotors.

    Args:
        rotors: `PlacedRotors`; empty for one at the end of each arm.
        arms: Constants of the arms.
        lengths: l_j [m].
    """
    return tree_map(rotor_effect, (arms, lengths), ())


@kernel
def _of_listed(pose: RotorPose, rotor: PlacedRotor) -> Effect:
    wrench = rotor_load(pose, rotor, 1.0).wrench
    return Effect(wrench.push.z, wrench.moment.x, wrench.moment.y, wrench.moment.z)


@rotor_effects.register(PlacedRotors)
@kernel
def _effects_of_listed(
    rotors: PlacedRotors, arms: tuple[Any, ...], lengths: tuple[float, ...]
) -> tuple[Effect, ...]:
    poses = poses_at(rotors, arms, lengths)
    return tree_map(_of_listed, (poses, rotors.each), ())


@generic
def used_effects(rotors: Any, effects: tuple[Effect, ...]) -> tuple[Effect, ...]:
    """Effects of rotors as a pilot uses them: of those that do not lift none."""
    return effects


@kernel
def _used(effect: Effect, rotor: PlacedRotor) -> Effect:
    u = rotor.lifts
    return Effect(u * effect.thrust, u * effect.roll, u * effect.pitch, u * effect.yaw)


@used_effects.register(PlacedRotors)
@kernel
def _of_those_that_lift(rotors: PlacedRotors, effects: tuple[Effect, ...]) -> tuple[Effect, ...]:
    return tree_map(_used, (effects, rotors.each), ())


@generic
def sideways_of(
    rotors: Any, arms: tuple[Any, ...], lengths: tuple[float, ...], thrusts: tuple[float, ...]
) -> tuple[Vec, ...]:
    """Force of listed rotors across body z, body axes [N]; empty without a list."""
    return ()


@kernel
def _sideways(pose: RotorPose, thrust: float) -> Vec:
    return Vec(thrust * pose.up.x, thrust * pose.up.y, 0.0)


@sideways_of.register(PlacedRotors)
@kernel
def _sideways_of_listed(
    rotors: PlacedRotors,
    arms: tuple[Any, ...],
    lengths: tuple[float, ...],
    thrusts: tuple[float, ...],
) -> tuple[Vec]:
    poses = poses_at(rotors, arms, lengths)
    return (tree_sum(tree_map(_sideways, (poses, thrusts), ())),)


@kernel
def _wrench_of_rotor(effect: Effect, thrust: float) -> Wrench:
    moment = Vec(effect.roll, effect.pitch, effect.yaw)
    return Wrench(effect.thrust * thrust, moment * thrust)


@kernel
def wrench_of(airframe: Airframe, lengths: tuple[float, ...], thrusts: tuple[float, ...]) -> Wrench:
    """Collective thrust and moment about the main body of given rotor thrusts [N]."""
    effects = rotor_effects(airframe.rotors, airframe.arms, lengths)
    return tree_sum(tree_map(_wrench_of_rotor, (effects, thrusts), ()))


@kernel
def _product(b: Effect) -> Gram:
    """Contribution of one rotor to B Bᵀ, upper half."""
    return Gram(
        b.thrust * b.thrust, b.thrust * b.roll, b.thrust * b.pitch, b.thrust * b.yaw,
        b.roll * b.roll, b.roll * b.pitch, b.roll * b.yaw,
        b.pitch * b.pitch, b.pitch * b.yaw,
        b.yaw * b.yaw,
    )  # fmt: skip


@kernel
def _inverse_pivot(pivot: float, diagonal: float) -> float:
    """Inverse of a pivot, or zero for an effect that the rotors lack."""
    return 1.0 / pivot if pivot > NO_EFFECT * diagonal else 0.0


@kernel
def _factors(g: Gram) -> Gram:
    """Factors L D Lᵀ of B Bᵀ: the entries of Lᵀ above the diagonal, and on it the inverses of D.

    A zero pivot, as of yaw where no rotor has a torque, gets the inverse zero: the solution then
    omits that part.
    """
    d0 = _inverse_pivot(g.g00, g.g00)
    l01, l02, l03 = g.g01 * d0, g.g02 * d0, g.g03 * d0
    d1 = _inverse_pivot(g.g11 - l01 * g.g01, g.g11)
    u12, u13 = g.g12 - l01 * g.g02, g.g13 - l01 * g.g03
    l12, l13 = u12 * d1, u13 * d1
    d2 = _inverse_pivot(g.g22 - l02 * g.g02 - l12 * u12, g.g22)
    u23 = g.g23 - l02 * g.g03 - l12 * u13
    l23 = u23 * d2
    d3 = _inverse_pivot(g.g33 - l03 * g.g03 - l13 * u13 - l23 * u23, g.g33)
    return Gram(d0, l01, l02, l03, d1, l12, l13, d2, l23, d3)


@kernel
def _solution(f: Gram, wanted: Effect) -> Effect:
    """Solution (B Bᵀ)⁻¹ w from the factors, by forward and back substitution."""
    y0 = wanted.thrust
    y1 = wanted.roll - f.g01 * y0
    y2 = wanted.pitch - f.g02 * y0 - f.g12 * y1
    y3 = wanted.yaw - f.g03 * y0 - f.g13 * y1 - f.g23 * y2
    x3 = y3 * f.g33
    x2 = y2 * f.g22 - f.g23 * x3
    x1 = y1 * f.g11 - f.g12 * x2 - f.g13 * x3
    x0 = y0 * f.g00 - f.g01 * x1 - f.g02 * x2 - f.g03 * x3
    return Effect(x0, x1, x2, x3)


@kernel
def _share(b: Effect, x: Effect) -> float:
    """Product of a row and a column."""
    return b.thrust * x.thrust + b.roll * x.roll + b.pitch * x.pitch + b.yaw * x.yaw


@kernel
def _shares(b: Effect, f: Gram) -> Effect:
    """Row of Bᵀ (B Bᵀ)⁻¹ of one rotor: the solution for its column, by the Gram's symmetry."""
    return _solution(f, b)


@kernel
def mixer(airframe: Airframe, lengths: tuple[float, ...]) -> Mixer:
    """Pseudoinverse of B(l).

    Args:
        airframe: Directions and torque ratios of the arms, or the rotors that it lists.
        lengths: Present l_j [m].
    """
    effects = rotor_effects(airframe.rotors, airframe.arms, lengths)
    effects = used_effects(airframe.rotors, effects)
    factors = _factors(tree_sum(tree_map(_product, (effects,), ())))
    return Mixer(lengths, tree_map(_shares, (effects,), (factors,)))


@kernel
def allocation(mixer: Mixer, wrench: Wrench) -> tuple[float, ...]:
    """Rotor thrusts Bᵀ (B Bᵀ)⁻¹ w for a wrench, without limits [N].

    Exact for four rotors, and of least norm for more.
    """
    m = wrench.moment
    return tree_map(_share, (mixer.shares,), (Effect(wrench.thrust, m.x, m.y, m.z),))


@kernel
def _rotor(share: Effect, moment: Vec) -> Rotor:
    """Contributions of one rotor to each part of a wrench; every rotor must contribute to lift.

    One that a pilot does not use contributes next to nothing, 1e-9 of the lift.
    """
    collective = share.thrust if share.thrust > SMALL else SMALL
    return Rotor(collective, share.roll * moment.x + share.pitch * moment.y, share.yaw * moment.z)


@kernel
def _tilt_beside(k: Rotor, j: Rotor, lowest: float, highest: float) -> float:
    """Largest share of the tilting moment for which rotor j ≥ lowest and rotor k ≤ highest.

    Both can be met by some collective c: (lowest − s R_j)/u_j ≤ c ≤ (highest − s R_k)/u_k.
    """
    room = highest / k.collective - lowest / j.collective
    need = k.tilting / k.collective - j.tilting / j.collective
    is_tight = need > room
    return room / (need if is_tight else 1.0) if is_tight else 1.0


@kernel
def _tilt_share(j: Rotor, rotors: tuple[Rotor, ...], lowest: float, highest: float) -> float:
    """Largest share of the tilting moment that rotor j allows with all others."""
    return minimum(tree_map(_tilt_beside, (rotors,), (j, lowest, highest)))


@kernel
def _tilt_under(rotor: Rotor, most: float, lowest: float) -> float:
    """Largest share of the tilting moment for which a rotor ≥ lowest with a collective ≤ most."""
    room, need = most * rotor.collective - lowest, -rotor.tilting
    is_tight = need > room
    return room / (need if is_tight else 1.0) if is_tight else 1.0


@kernel
def _collective_bound(rotor: Rotor, tilt: float, bound: float) -> float:
    """Collective thrust at which a rotor reaches a bound [N]."""
    return (bound - tilt * rotor.tilting) / rotor.collective


@kernel
def _turn_share(
    rotor: Rotor, collective: float, tilt: float, lowest: float, highest: float
) -> float:
    """Largest share of the yaw moment that a rotor allows."""
    used = collective * rotor.collective + tilt * rotor.tilting
    room = (highest if rotor.turning > 0.0 else lowest) - used
    is_tight = (room - rotor.turning) * rotor.turning < 0.0
    return room / (rotor.turning if is_tight else 1.0) if is_tight else 1.0


@kernel
def _rotor_thrust(rotor: Rotor, collective: float, tilt: float, turn: float) -> float:
    """Thrust of a rotor for these shares [N]."""
    return collective * rotor.collective + tilt * rotor.tilting + turn * rotor.turning


@kernel
def _limited_thrusts(
    rotors: tuple[Rotor, ...], thrust: float, lowest: float, highest: float, lift: float
) -> tuple[float, ...]:
    """Thrusts within their limits if the demand does not fit [N]."""
    most = thrust if thrust > lift else lift
    beside = minimum(tree_map(_tilt_share, (rotors,), (rotors, lowest, highest)))
    under = minimum(tree_map(_tilt_under, (rotors,), (most, lowest)))
    tilt = within(under if under < beside else beside, 0.0, 1.0)
    floor = maximum(tree_map(_collective_bound, (rotors,), (tilt, lowest)))
    ceiling = minimum(tree_map(_collective_bound, (rotors,), (tilt, highest)))
    collective = within(thrust, floor, ceiling)
    turns = tree_map(_turn_share, (rotors,), (collective, tilt, lowest, highest))
    turn = within(minimum(turns), 0.0, 1.0)
    given = tree_map(_rotor_thrust, (rotors,), (collective, tilt, turn))
    return tree_map(within, (given,), (lowest, highest))


@kernel
def rotor_thrusts(
    mixer: Mixer, lowest: float, highest: float, wrench: Wrench, lift: float
) -> tuple[float, ...]:
    """Rotor thrusts within their limits that approach a wrench by priority of its parts [N].

    If the demand does not fit, its parts are reduced in this order: the yaw moment, down to zero;
    then the collective thrust is shifted, up or down, as far as roll and pitch require; and only if
    no collective thrust suffices, the roll and pitch moment, in its own direction.  A demand that
    fits is met exactly.  The order is that of PX4's mixer: with airmode the collective may rise as
    far as roll and pitch require, without it only to the demanded thrust, or to some small thrust.

    Args:
        mixer: Allocation at the present arm lengths.
        lowest: Minimum thrust of a rotor, at least 0 [N].
        highest: Maximum thrust of a rotor [N].
        wrench: Demanded thrust and moment.
        lift: Collective thrust to which roll and pitch may raise a smaller one [N].
    """
    asked = free_thrusts(mixer, wrench)
    if fits(asked, lowest, highest):
        return asked
    return limited_thrusts(mixer, lowest, highest, wrench, lift)


@kernel
def free_thrusts(mixer: Mixer, wrench: Wrench) -> tuple[float, ...]:
    """Rotor thrusts that give a wrench, without limits [N]."""
    rotors = tree_map(_rotor, (mixer.shares,), (wrench.moment,))
    return tree_map(_rotor_thrust, (rotors,), (wrench.thrust, 1.0, 1.0))


@kernel
def fits(thrusts: tuple[float, ...], lowest: float, highest: float) -> bool:
    """True if all rotors are within their limits."""
    return (minimum(thrusts) >= lowest) & (maximum(thrusts) <= highest)


@kernel
def limited_thrusts(
    mixer: Mixer, lowest: float, highest: float, wrench: Wrench, lift: float
) -> tuple[float, ...]:
    """Thrusts as by `rotor_thrusts`, if the demand does not fit."""
    rotors = tree_map(_rotor, (mixer.shares,), (wrench.moment,))
    return _limited_thrusts(rotors, wrench.thrust, lowest, highest, lift)

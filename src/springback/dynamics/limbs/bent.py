"""Arms on two joints in the equations of motion.

With r_j the end of an arm, e₁ and e₂ its derivatives by both ways (`springback.vehicle.arms.bent`)
and a' = Rᵀ(v̇ + g e_Z), the point mass at the end obeys, along either path k,

    m_j (G s̈ + Eᵀ(a' + α × r_j))_k = h_k = e_k·f_j + κ_k a_k·n_j − m_j e_k·c_j
                                            + (spring, damper, stops of joint k)

with E = [e₁ e₂], G = EᵀE, the force f_j on what is at the end, its moment n_j about the end, and
c_j = ω × (ω × r_j) + 2 ω × ṙ_j + r̈_j at constant rates.  Both s̈ are eliminated as the one of an arm
on one joint is, with the projection P = E G⁻¹ Eᵀ in place of e eᵀ:

    M = m 1 − Σ u_j m_j P_j                        − Σ u_j E_j G_j⁻¹ h_j         on the right
    C = −ŝ + Σ u_j m_j P_j r̂_j                     − Σ u_j r_j × E_j G_j⁻¹ h_j
    J = I + Σ m_j (r_j² 1 − r_j r_jᵀ) + Σ u_j m_j r̂_j P_j r̂_j

so that the six equations, and all that follows from them, are those of
`springback.dynamics.limbs.jointed`.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.cage import LANDED, moving_bodies
from springback.contact.hull_contact import arm_sight
from springback.contact.laws.memory import bristles_of
from springback.contact.laws.step_bounds import ArmFrictionRate, Stiffness
from springback.contact.loads import CageContact
from springback.dynamics.crossing import sooner
from springback.dynamics.limbs.arms import (
    ArmMotion,
    ArmPull,
    ArmState,
    ArmView,
    Surroundings,
    acceleration_at_end,
    arm_acceleration,
    arm_state,
    arm_touch,
    arm_view,
    assemble,
    bend_rates,
    length_accelerations,
    spring_damper_force,
    unbalanced_force,
)
from springback.dynamics.limbs.jointed import (
    Coupling,
    JointShare,
    assembled_in_space,
    grip_along,
    turned_contact,
)
from springback.dynamics.stops import Stop, end_stop, next_stop
from springback.dynamics.touches import (
    BodyAcceleration,
    PartPush,
    contact_of,
    place_in_body,
    slip_of,
    turning_points_of,
)
from springback.kernels.compiler import kernel
from springback.kernels.trees import field_of, fold, one_tuple, replace, tree_map, tree_sum
from springback.kernels.vectors import Mat3, Vec, larger, outer
from springback.vehicle.arms.bent import (
    BentArm,
    BentCoordinates,
    BentInverse,
    BentPose,
    SecondJoint,
    along_both,
    bent_mobility,
    bent_pose,
    bent_thrust_direction,
)
from springback.vehicle.arms.joints import joint_spring, point_inertia
from springback.vehicle.arms.neighbours import with_pull
from springback.vehicle.state import Bend, PartMemory


@spring_damper_force.register(SecondJoint)
@kernel
def _of_second(arm: SecondJoint, way: float, rate: float) -> float:
    return joint_spring(arm, way).force - arm.damping * rate


@spring_damper_force.register(BentArm)
@kernel
def _of_first(arm: BentArm, length: float, rate: float) -> float:
    """Of the first joint alone."""
    return joint_spring(arm, length).force - arm.damping * rate


class BentLoad(NamedTuple):
    """Contacts of an arm as a spring and dampers per mass, along its stiffest motion."""

    spring: float  # of the normal forces [N/m]
    damper: float  # of the normal forces [N s/m]
    grip: float  # of friction [N s/m]


@kernel
def _quadratic(inverse: BentInverse, first: float, second: float) -> float:
    """xᵀ G⁻¹ x."""
    own = inverse.xx * first * first + inverse.yy * second * second
    return own + 2.0 * inverse.xy * first * second


@kernel
def _load_of(met: CageContact, turn: Mat3, there: BentPose, inverse: BentInverse) -> BentLoad:
    """One contact, whose point moves by x_k = e_k + κ_k a_k × d for each metre of way k.

    The largest eigenvalue of G⁻¹ K, K = k (n·x)(n·x)ᵀ, is k (n·x)ᵀ G⁻¹ (n·x); that of friction
    is at most the trace.
    """
    n, at = turn @ met.inward, turn @ met.rubbing_at - there.end
    first = there.first + (there.about_first ^ at)
    second = there.second + (there.about_second ^ at)
    along = _quadratic(inverse, first @ n, second @ n)
    both = 2.0 * inverse.xy * (first @ second)
    every = inverse.xx * (first @ first) + inverse.yy * (second @ second) + both
    press, alone = met.touch.press, met.touch.grip.alone
    return BentLoad(press.stiffness * along, press.damper * along, alone * (every - along))


@kernel
def _with_second(view: ArmView, arm: BentArm, way: float, rate: float, stop: Stop) -> ArmView:
    """The view of an arm with the stops of its second joint."""
    outer_joint = arm.second
    has_stops = (outer_joint.stop_stiffness > 0.0) & (view.unbalance > 0.0)
    crossing = next_stop(outer_joint, way, rate if has_stops else 0.0)
    beyond = has_stops & (way < outer_joint.shortest + LANDED)
    pressed = larger(view.compression, abs(outer_joint.length - way))
    return replace(
        view, compression=pressed, unbalance=0.0, crossing=sooner(view.crossing, crossing),
        bottomed=1.0 if beyond else view.bottomed,
        stopped=1.0 if has_stops & (stop.stiffness > 0.0) else view.stopped,
    )  # fmt: skip


@arm_state.register(BentArm)
@kernel
def _bent_state(
    arm: BentArm,
    length: BentCoordinates,
    rate: BentCoordinates,
    thrust: float,
    engaged: tuple[float, ...],
    push: tuple[PartPush, ...],
    pull: tuple[Vec, ...],
    memory: PartMemory,
    around: Surroundings,
) -> ArmState:
    omega, m, u = around.seen.body.omega, arm.mass, arm.compliance * around.released
    there = bent_pose(arm, length, rate)
    inverse = bent_mobility(there)
    sight = arm_sight(arm, length, rate, around.seen)
    e, f, end, turn, v = there.first, there.second, there.end, there.turn, there.velocity

    contacts = arm_touch(arm, sight, engaged, push, memory, around.contact_point)
    met = contacts.met
    contact = contact_of(contacts.load, moving_bodies(sight.obstacles), met)
    contact = turned_contact(contact, turn)
    inner_stop = end_stop(arm, length.first, rate.first)
    outer_stop = end_stop(arm.second, length.second, rate.second)

    up = bent_thrust_direction(arm, there)
    blown, torque = thrust * up, (thrust * arm.torque_ratio) * up
    about_end = contact.moment - (end ^ contact.force) + torque
    c = m * ((omega ^ (omega ^ end)) + 2.0 * (omega ^ v) + there.bias)
    acts = contact.force + blown - c
    on_first = spring_damper_force(arm, length.first, rate.first) + inner_stop.force
    on_second = spring_damper_force(arm.second, length.second, rate.second) + outer_stop.force
    h1 = fold(with_pull, e @ acts + there.about_first @ about_end + on_first, pull, (e,))
    h2 = fold(with_pull, f @ acts + there.about_second @ about_end + on_second, pull, (f,))

    drive = along_both(inverse, h1, h2)
    um, taken = u * m, u * (drive.first * e + drive.second * f)
    # Columns of E G⁻¹, so that P = Σ column eᵀ.
    g1, g2 = inverse.xx * e + inverse.xy * f, inverse.xy * e + inverse.yy * f
    swing1, swing2 = end ^ e, end ^ f
    share = JointShare(
        contact=contact,
        thrust=blown.z,
        push=blown,
        rotor_moment=(end ^ blown) + torque,
        power_on_arm=blown @ v + there.spin @ torque,
        taken=taken,
        taken_moment=end ^ taken,
        coupling=Coupling(
            um * (outer(g1, e) + outer(g2, f)),
            um * (outer(g1, swing1) + outer(g2, swing2)),
            um * (outer(end ^ g1, swing1) + outer(end ^ g2, swing2)),
            um,
        ),
        inertial=c,
        inertial_moment=end ^ c,
        carried=m * end,
        drift=m * v,
        inertia=point_inertia(m, end),
        arm_loss=u
        * (arm.damping * rate.first * rate.first + arm.second.damping * rate.second * rate.second),
        stop_loss=u * (inner_stop.loss + outer_stop.loss),
        grip=tree_sum(tree_map(grip_along, (met,), (turn, e))),
    )
    per_mass = u * arm.inverse_mass
    load = tree_sum(tree_map(_load_of, (met,), (turn, there, inverse)))
    xx, yy = inverse.xx, inverse.yy
    slide = Stiffness(
        (load.spring + xx * inner_stop.stiffness + yy * outer_stop.stiffness) * per_mass,
        (load.damper + xx * inner_stop.damper + yy * outer_stop.damper) * per_mass,
    )
    grip = ArmFrictionRate(0.0, 0.0, load.grip * per_mass)
    r = sight.body.r
    view = arm_view(arm, length.first, rate.first, inner_stop, u, contacts, memory, r)
    view = _with_second(replace(view, unbalance=u), arm, length.second, rate.second, outer_stop)
    pulls = ArmPull(BentCoordinates(drive.first * per_mass, drive.second * per_mass), u)
    return ArmState(
        share, pulls, view, place_in_body(contacts.seen, turn), grip, slide,
        tree_map(slip_of, (met,), ()), bristles_of(memory, met, r),
        one_tuple(tree_map(turning_points_of, (met,), ())),
    )  # fmt: skip


@arm_acceleration.register(BentArm)
@kernel
def _along_paths(
    arm: BentArm, length: BentCoordinates, known: ArmState, a: Vec, alpha: Vec
) -> BentCoordinates:
    there = bent_pose(arm, length, 0.0)
    here = a + (alpha ^ there.end)
    given = along_both(bent_mobility(there), there.first @ here, there.second @ here)
    drive, hold = known.pull.drive, known.pull.hold
    return BentCoordinates(drive.first - hold * given.first, drive.second - hold * given.second)


@kernel
def _bend_rate(bend: Bend, acceleration: BentCoordinates) -> Bend:
    return Bend(bend.rate, acceleration.second)


@length_accelerations.register(BentArm)
@kernel
def _of_lengths(arm: BentArm, accelerations: tuple[Any, ...]) -> tuple[float, ...]:
    return field_of(accelerations, "first")


@bend_rates.register(BentArm)
@kernel
def _of_bends(arm: BentArm, bends: tuple[Bend, ...], accelerations: tuple[Any, ...]) -> Any:
    return tree_map(_bend_rate, (bends, accelerations), ())


@unbalanced_force.register(BentArm)
@kernel
def _larger_unbalance(arm: BentArm, moves: ArmMotion) -> float:
    """The larger of both, that of the second as if the first joint were as stiff as that."""
    outer_joint, rate, acceleration = arm.second, moves.rate, moves.acceleration
    first = arm.mass * acceleration.first + arm.damping * rate.first
    second = arm.mass * acceleration.second + outer_joint.damping * rate.second
    share = arm.resting_stiffness / outer_joint.resting_stiffness
    return larger(abs(first), abs(second) * share)


@acceleration_at_end.register(BentArm)
@kernel
def _at_end_of_two(arm: BentArm, moves: ArmMotion, body: BodyAcceleration) -> BodyAcceleration:
    there, second = bent_pose(arm, moves.length, moves.rate), moves.acceleration
    turn = there.turn
    spin = second.first * there.about_first + second.second * there.about_second
    way = second.first * there.first + second.second * there.second
    linear = body.linear + way - (spin ^ there.end)
    return BodyAcceleration(linear @ turn, (body.angular + spin) @ turn, body.vertical @ turn)


assemble.register(BentArm)(assembled_in_space)

"""Arms on joints in the equations of motion: slides in any direction, hinges about any axis.

With r_j the end of an arm, e_j = ∂r_j/∂l_j along its path and a' = Rᵀ(v̇ + g e_Z), the point mass at
the end obeys, along the path,

    m_j (l̈_j + e_j·a' + (r_j × e_j)·α) = h_j = e_j·f_j + κ_j a_j·n_j − m_j e_j·(ω × (ω × r_j))
                                                + (spring, damper, stops)

where f_j is the force on what is at the end, contact and thrust, n_j its moment about the end, and
a_j the axis about which a hinged arm turns as it gets longer.  Each l̈_j is eliminated:

    [ M   C ] [a']   [ F − Σ u_j h_j e_j         − Σ m_j c_j       ]
    [ Cᵀ  J ] [α ] = [ τ − Σ u_j h_j (r_j × e_j) − Σ m_j r_j × c_j − ω × I ω ]

    M = m 1 − Σ u_j m_j e_j e_jᵀ
    C = −ŝ − Σ u_j m_j e_j (r_j × e_j)ᵀ
    J = I + Σ m_j (r_j² 1 − r_j r_jᵀ) − Σ u_j m_j (r_j × e_j)(r_j × e_j)ᵀ
    c_j = ω × (ω × r_j) + 2 l̇_j ω × e_j + l̇_j² de_j/dl_j

For slides in the body plane through the main body r_j × e_j = 0: what remains is
`springback.dynamics.motion`.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.cage import moving_bodies
from springback.contact.hull_contact import arm_sight
from springback.contact.laws.memory import bristles_of
from springback.contact.laws.step_bounds import (
    ArmFrictionRate,
    FrictionDamping,
    Stiffness,
    friction_damping,
)
from springback.contact.loads import CageContact
from springback.dynamics.air import with_reaction
from springback.dynamics.limbs.arms import (
    ActingLoad,
    ArmMotion,
    ArmPull,
    ArmState,
    Assembly,
    Surroundings,
    acceleration_at_end,
    arm_acceleration,
    arm_state,
    arm_touch,
    arm_view,
    assemble,
    spring_damper_force,
)
from springback.dynamics.solution import SpatialSystem
from springback.dynamics.stops import end_stop
from springback.dynamics.touches import (
    BodyAcceleration,
    Contact,
    PartPush,
    Reaction,
    contact_of,
    place_in_body,
    slip_of,
    turning_points_of,
)
from springback.kernels.compiler import kernel
from springback.kernels.trees import fold, one_tuple, replace, tree_map, tree_sum
from springback.kernels.vectors import Mat3, Vec, isotropic, outer, skew
from springback.vehicle.arms.joints import (
    JointedArm,
    JointPose,
    joint_pose,
    joint_spring,
    point_inertia,
    thrust_direction,
)
from springback.vehicle.arms.neighbours import with_pull
from springback.vehicle.placed.rotors import with_rotor_moment, with_rotor_power, with_rotor_push
from springback.vehicle.state import Airframe, PartMemory


class Coupling(NamedTuple):
    """What the arms that move take out of the matrix of the six equations."""

    linear: Mat3  # Σ u m e eᵀ [kg]
    mixed: Mat3  # Σ u m e (r × e)ᵀ [kg m]
    angular: Mat3  # Σ u m (r × e)(r × e)ᵀ [kg m²]
    mass: float  # Σ u m [kg]


class JointShare(NamedTuple):
    """Contribution of one arm on a joint to the six equations; vectors in body axes."""

    contact: Contact
    thrust: float  # along body z [N]
    push: Vec  # thrust [N]
    rotor_moment: Vec  # of the rotor, about the main body [N m]
    power_on_arm: float  # of the rotor, by the motion of the arm [W]
    taken: Vec  # u_j h_j e_j: force that accelerates the arm itself
    taken_moment: Vec  # u_j h_j (r_j × e_j)
    coupling: Coupling
    inertial: Vec  # m_j c_j
    inertial_moment: Vec  # m_j r_j × c_j
    carried: Vec  # m_j r_j
    drift: Vec  # m_j l̇_j e_j
    inertia: Mat3  # m_j (r_j² 1 − r_j r_jᵀ)
    arm_loss: float
    stop_loss: float
    grip: FrictionDamping  # friction as a damper


@kernel
def _turned_reaction(reaction: Reaction, turn: Mat3) -> Reaction:
    of = reaction
    return replace(
        of, force=turn @ of.force, moment=turn @ of.moment, friction=turn @ of.friction,
        inward=turn @ of.inward,
    )  # fmt: skip


@kernel
def turned_contact(contact: Contact, turn: Mat3) -> Contact:
    """A contact in the axes of what is at the end of an arm, in those of the body.

    Args:
        contact: In the former.
        turn: The former to the latter.
    """
    reactions = tree_map(_turned_reaction, (contact.reactions,), (turn,))
    return replace(
        contact, force=turn @ contact.force, moment=turn @ contact.moment, reactions=reactions
    )


@kernel
def grip_along(met: CageContact, turn: Mat3, direction: Vec) -> FrictionDamping:
    """Friction of a contact of an arm as a damper.

    Args:
        met: In the axes of what is at the end of the arm.
        turn: These axes, to body axes.
        direction: In which the end moves, body axes.
    """
    damper = met.touch.grip.alone
    return friction_damping(damper, turn @ met.inward, turn @ met.rubbing_at, direction)


class PathLoad(NamedTuple):
    """Contacts of an arm as a spring and dampers along the path of its end."""

    stiffness: float  # of the normal forces [N/m]
    damper: float  # of the normal forces [N s/m]
    grip: float  # of friction [N s/m]


@kernel
def _along_path_of(met: CageContact, turn: Mat3, there: JointPose, curvature: float) -> PathLoad:
    """One contact along the path: its point moves by e + κ a × d for each metre of it."""
    n, at = turn @ met.inward, turn @ met.rubbing_at - there.end
    moves = there.direction + curvature * (there.axis ^ at)
    along, press = moves @ n, met.touch.press
    squared = along * along
    across = moves @ moves - squared
    return PathLoad(
        press.stiffness * squared, press.damper * squared, met.touch.grip.alone * across
    )


@spring_damper_force.register(JointedArm)
@kernel
def _of_joint(arm: JointedArm, length: float, rate: float) -> float:
    return joint_spring(arm, length).force - arm.damping * rate


@arm_state.register(JointedArm)
@kernel
def _joint_state(
    arm: JointedArm,
    length: float,
    rate: float,
    thrust: float,
    engaged: tuple[float, ...],
    push: tuple[PartPush, ...],
    pull: tuple[Vec, ...],
    memory: PartMemory,
    around: Surroundings,
) -> ArmState:
    omega, m, u = around.seen.body.omega, arm.mass, arm.compliance * around.released
    there = joint_pose(arm, length, rate)
    sight = arm_sight(arm, length, rate, around.seen)
    e, end, turn, k = there.direction, there.end, there.turn, arm.joint.curvature

    contacts = arm_touch(arm, sight, engaged, push, memory, around.contact_point)
    met = contacts.met
    contact = contact_of(contacts.load, moving_bodies(sight.obstacles), met)
    contact = turned_contact(contact, turn)
    stop = end_stop(arm, length, rate)

    up = thrust_direction(arm, there)
    blown, torque = thrust * up, (thrust * arm.torque_ratio) * up
    about_end = contact.moment - (end ^ contact.force) + torque
    moving = rate * e
    bent = (omega ^ (omega ^ end)) + 2.0 * (omega ^ moving) + (rate * rate) * there.bend
    c = m * bent
    own = spring_damper_force(arm, length, rate) + stop.force
    acts = e @ (contact.force + blown - c) + k * (there.axis @ about_end) + own
    h = fold(with_pull, acts, pull, (e,))

    swing, um = end ^ e, u * m
    share = JointShare(
        contact=contact,
        thrust=blown.z,
        push=blown,
        rotor_moment=(end ^ blown) + torque,
        power_on_arm=blown @ moving + there.turning * (there.axis @ torque),
        taken=(u * h) * e,
        taken_moment=(u * h) * swing,
        coupling=Coupling(um * outer(e, e), um * outer(e, swing), um * outer(swing, swing), um),
        inertial=c,
        inertial_moment=end ^ c,
        carried=m * end,
        drift=m * moving,
        inertia=point_inertia(m, end),
        arm_loss=u * (arm.damping * rate * rate),
        stop_loss=u * stop.loss,
        grip=tree_sum(tree_map(grip_along, (met,), (turn, e))),
    )
    per_mass = u * arm.inverse_mass
    load = tree_sum(tree_map(_along_path_of, (met,), (turn, there, k)))
    slide = Stiffness(
        (load.stiffness + stop.stiffness) * per_mass, (load.damper + stop.damper) * per_mass
    )
    grip = ArmFrictionRate(0.0, 0.0, load.grip * per_mass)
    r = sight.body.r
    view = arm_view(arm, length, rate, stop, u, contacts, memory, r)
    return ArmState(
        share, ArmPull(h * per_mass, u), view, place_in_body(contacts.seen, turn), grip, slide,
        tree_map(slip_of, (met,), ()), bristles_of(memory, met, r),
        one_tuple(tree_map(turning_points_of, (met,), ())),
    )  # fmt: skip


@arm_acceleration.register(JointedArm)
@kernel
def _along_path(arm: JointedArm, length: float, known: ArmState, a: Vec, alpha: Vec) -> float:
    there = joint_pose(arm, length, 0.0)
    e = there.direction
    along: float = known.pull.drive - known.pull.hold * (e @ a + (there.end ^ e) @ alpha)
    return along


@acceleration_at_end.register(JointedArm)
@kernel
def _at_end(arm: JointedArm, moves: ArmMotion, body: BodyAcceleration) -> BodyAcceleration:
    there = joint_pose(arm, moves.length, moves.rate)
    e, turn = there.direction, there.turn
    spin = (arm.joint.curvature * moves.acceleration) * there.axis
    linear = body.linear + moves.acceleration * e - (spin ^ there.end)
    return BodyAcceleration(linear @ turn, (body.angular + spin) @ turn, body.vertical @ turn)


@assemble.register(JointedArm)
@kernel
def assembled_in_space(
    arm: Any, airframe: Airframe, share: JointShare, acts: ActingLoad
) -> Assembly:
    """The six equations of a vehicle whose arms are on joints; arguments as for `assemble`."""
    a, omega, contact, m = share, acts.omega, acts.contact, airframe.mass
    force = contact.force + a.push + acts.blown - a.taken - a.inertial
    force = fold(with_rotor_push, force, acts.listed, ())
    rotor_moment = with_reaction(a.rotor_moment, acts.reaction)
    rotor_moment = fold(with_rotor_moment, rotor_moment, acts.listed, ())
    own_spin = omega ^ (airframe.inertia @ omega)
    moment = contact.moment + rotor_moment - a.taken_moment - a.inertial_moment - own_spin
    inertia = airframe.inertia + a.inertia - a.coupling.angular
    system = SpatialSystem(
        isotropic(m) - a.coupling.linear,
        -1.0 * (skew(a.carried) + a.coupling.mixed),
        inertia,
        force,
        moment,
    )
    power = a.push @ acts.velocity + rotor_moment @ omega + a.power_on_arm
    power = fold(with_rotor_power, power, acts.listed, (acts.velocity,))
    momentum = (omega ^ a.carried) + a.drift
    return Assembly(system, inertia, m - a.coupling.mass, momentum, power)

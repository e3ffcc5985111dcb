"""Arms that slide in the body plane: contact, spring, stops, rotor and inertia of each.

Arms on joints are in `springback.dynamics.limbs.jointed`; both give what
`springback.dynamics.motion` needs of an arm.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.cage import LANDED, moving_bodies
from springback.contact.hull_contact import ArmSight, BodySight, arm_faces, arm_sight
from springback.contact.laws.memory import PartBristles, bristles_of, pressed_of
from springback.contact.laws.step_bounds import (
    ArmFrictionRate,
    FrictionDamping,
    Stiffness,
)
from springback.contact.loads import ContactLoad, contacts_with
from springback.dynamics.air import with_reaction
from springback.dynamics.crossing import Crossing, sooner, soonest
from springback.dynamics.solution import System
from springback.dynamics.stops import Stop, end_stop, next_stop
from springback.dynamics.touches import (
    BodyAcceleration,
    Contact,
    PartPush,
    PartTouch,
    Slip,
    TurningPoint,
    contact_of,
    crossing_of,
    or_turn,
    slip_of,
    slip_rate,
    strikes,
    touch_of,
    turning_points_of,
    with_push,
)
from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import (
    field_of,
    fold,
    maximum,
    one_tuple,
    replace,
    select,
    tree_map,
    tree_sum,
)
from springback.kernels.vectors import Mat3, Vec, positive_part
from springback.vehicle.arms.neighbours import with_pull
from springback.vehicle.placed.rotors import (
    RotorWrench,
    with_rotor_moment,
    with_rotor_power,
    with_rotor_push,
)
from springback.vehicle.state import (
    Airframe,
    Arm,
    Bend,
    PartMemory,
    PressedPoints,
    arms_inertia,
    compression_of,
    planar_product,
)


class ArmView(NamedTuple):
    """Observable quantities of one arm."""

    gap: float  # to the nearest obstacle [m]
    depth: float  # deepest penetration [m]
    normal: float  # f_n [N]
    friction: Vec  # f_f, world [N]
    compression: float  # L − l; on a joint, to either side [m]
    unbalance: float  # m_j l̈ + b_l l̇, the net force that moves it from its position [N]
    crossing: Crossing  # of a gap or a stop: the next zero
    engaged: tuple[float, ...]  # 1 while the cage touches, for each face
    impulsive: float  # 1 if it approaches a surface of the impulse law
    bottomed: float  # 1 at the end of the stroke
    stopped: float  # 1 while an end stop is pressed
    pressed: tuple[PressedPoints, ...]  # what its contacts remember, if a surface does


class ArmShare(NamedTuple):
    """Contribution of one arm to the six equations; vectors in body axes."""

    contact: Contact
    thrust: float
    rotor_moment: Vec  # r_j × T_j e_z and the rotor's own torque
    taken: Vec  # u_j h_j e_j: force that accelerates the sliding arm itself
    carried: Vec  # m_j r_j
    drift: Vec  # m_j l̇_j e_j
    inertia: Vec  # m_j l_j² (e_x², e_y², e_x e_y)
    half_inertia_rate: Vec  # m_j l_j l̇_j (e_x², e_y², e_x e_y)
    arm_loss: float
    stop_loss: float
    grip: FrictionDamping  # friction as a damper


class ArmPull(NamedTuple):
    """Acceleration of an arm along its slide once a' is known: l̈ = drive − u e·a'."""

    drive: Any  # u_j h_j / m_j; of two joints both
    hold: float  # u_j


class Surroundings(NamedTuple):
    """What all arms of a vehicle share at one instant."""

    seen: BodySight
    contact_point: Any  # Ring or ArmTip
    released: float  # 1 lets compliant arms slide, 0 locks them


class ArmState(NamedTuple):
    """All quantities of one arm at one instant."""

    share: Any  # `ArmShare`, or that of an arm on a joint
    pull: ArmPull
    seen: ArmView
    touched: PartTouch  # in axes of the main body
    grip: ArmFrictionRate
    slide: Stiffness  # spring and damper along the slide
    slips: tuple[Slip, ...]  # one for each face
    bristles: tuple[PartBristles, ...]  # if a surface has any
    turns: tuple[TurningPoint, ...]  # one for each face, if a surface remembers the deepest depth


@generic
def spring_damper_force(arm: Any, length: float, rate: float) -> float:
    """Force of the spring and the damper of an arm: positive lengthens it [N]."""
    raise TypeError(f"{type(arm).__name__} is not an arm")


@spring_damper_force.register(Arm)
@kernel
def _of_slide(arm: Arm, length: float, rate: float) -> float:
    """Force of the Kelvin–Voigt arm, k_l (L − l) − b_l l̇.

    The damper opposes l̇ (Rayleigh); the sign printed in eq. (11) would add energy.
    """
    return arm.stiffness * (arm.length - length) - arm.damping * rate


@generic
def arm_state(
    arm: Any,
    length: float,
    rate: float,
    thrust: float,
    engaged: tuple[float, ...],
    push: tuple[PartPush, ...],
    pull: tuple[Vec, ...],
    memory: PartMemory,
    around: Surroundings,
) -> ArmState:
    """One arm: contact at its cage, its spring, its stops, its rotor, its inertia.

    Args:
        arm: Constants of the arm.
        length: l_j [m].
        rate: l̇_j [m/s].
        thrust: T_j [N].
        engaged: For each face, 0 if the cage did not touch it when the step began.
        push: Of another vehicle, if there is one.
        pull: Of the springs to its neighbours on its end, and of listed rotors on it along its
            path, if there are any, body axes [N].
        memory: Of its contacts.
        around: What all arms share.
    """
    raise TypeError(f"{type(arm).__name__} is not an arm")


class ArmTouch(NamedTuple):
    """Contacts of one arm, in the axes of what is at its end."""

    met: tuple[Any, ...]  # `CageContact` with each face
    load: ContactLoad  # of all of them
    seen: PartTouch


@kernel
def arm_touch(
    arm: Any,
    sight: ArmSight,
    engaged: tuple[float, ...],
    push: tuple[PartPush, ...],
    memory: PartMemory,
    contact_point: Any,
) -> ArmTouch:
    """Contacts of one arm; arguments as for `arm_state`."""
    pose, obstacles, body = sight
    faces = arm_faces(arm, obstacles, contact_point, pose, maximum(engaged))
    met = contacts_with(obstacles, faces, engaged, memory, pose, body)
    load = fold(with_push, tree_sum(field_of(met, "touch")), push, (pose.lever, body.r))
    return ArmTouch(met, load, touch_of(met, push, body.r))


@kernel
def arm_view(
    arm: Any, length: float, rate: float, stop: Stop, moves: float, touch: ArmTouch,
    memory: PartMemory, r: Mat3,
) -> ArmView:  # fmt: skip
    """The view of an arm, but for what its acceleration tells.

    Args:
        arm: Constants of the arm.
        length: l_j [m].
        rate: l̇_j [m/s].
        stop: Force of its end stops.
        moves: 1 if it is free to move.
        touch: Its contacts.
        memory: Of its contacts.
        r: Axes of what is at its end, to world axes.
    """
    has_stops = (arm.stop_stiffness > 0.0) & (moves > 0.0)
    stops_at = next_stop(arm, length, rate if has_stops else 0.0)
    met, load, touches = touch
    return ArmView(
        gap=touches.gap,
        depth=positive_part(-touches.gap),
        normal=load.normal,
        friction=r @ load.friction,
        compression=compression_of(arm, length),
        unbalance=0.0,
        crossing=sooner(soonest(tree_map(crossing_of, (met,), ())), stops_at),
        engaged=touches.engaged,
        impulsive=maximum(tree_map(strikes, (met,), ())),
        bottomed=1.0 if has_stops & (length < arm.shortest + LANDED) else 0.0,
        stopped=1.0 if moves * stop.stiffness > 0.0 else 0.0,
        pressed=pressed_of(memory, met),
    )


@arm_state.register(Arm)
@kernel
def _slide_state(
    arm: Arm,
    length: float,
    rate: float,
    thrust: float,
    engaged: tuple[float, ...],
    push: tuple[PartPush, ...],
    pull: tuple[Vec, ...],
    memory: PartMemory,
    around: Surroundings,
) -> ArmState:
    body, obstacles = around.seen.body, around.seen.obstacles
    omega = body.omega
    m, u = arm.mass, arm.compliance * around.released
    sight = arm_sight(arm, length, rate, around.seen)
    e, lever = sight.pose.direction, sight.pose.lever

    contacts = arm_touch(arm, sight, engaged, push, memory, around.contact_point)
    met, touch = contacts.met, contacts.load
    stop = end_stop(arm, length, rate)

    across = e.x * omega.y - e.y * omega.x
    ml = m * length
    outward = ml * (across * across + omega.z * omega.z)  # centrifugal force along the arm
    own = spring_damper_force(arm, length, rate) + stop.force
    h = fold(with_pull, e @ touch.force + outward + own, pull, (e,))

    carried, drift = ml * e, (m * rate) * e
    per_mass = u * arm.inverse_mass
    share = ArmShare(
        contact=contact_of(touch, moving_bodies(obstacles), met),
        thrust=thrust,
        rotor_moment=thrust * Vec(lever.y, -lever.x, arm.torque_ratio),
        taken=(u * h) * e,
        carried=carried,
        drift=drift,
        inertia=planar_product(carried, lever),
        half_inertia_rate=planar_product(drift, lever),
        arm_loss=u * (arm.damping * rate * rate),
        stop_loss=u * stop.loss,
        grip=touch.grip,
    )
    slide = Stiffness(
        (touch.press.arm_stiffness + stop.stiffness) * per_mass,
        (touch.press.arm_damper + stop.damper) * per_mass,
    )
    view = arm_view(arm, length, rate, stop, u, contacts, memory, body.r)
    grip = ArmFrictionRate(touch.grip.on_arm * per_mass, touch.grip.lean * per_mass, 0.0)
    return ArmState(
        share, ArmPull(h * per_mass, u), view, contacts.seen, grip, slide,
        tree_map(slip_of, (met,), ()), bristles_of(memory, met, body.r),
        one_tuple(tree_map(turning_points_of, (met,), ())),
    )  # fmt: skip


@generic
def arm_acceleration(arm: Any, length: float, known: ArmState, a: Vec, alpha: Vec) -> float:
    """Acceleration of an arm along its path [m/s²].

    Args:
        arm: Constants of the arm.
        length: l_j [m].
        known: State of the arm.
        a: a' of the main body, body axes [m/s²].
        alpha: Angular acceleration, body axes [rad/s²].
    """
    raise TypeError(f"{type(arm).__name__} is not an arm")


@arm_acceleration.register(Arm)
@kernel
def _along_slide(arm: Arm, length: float, known: ArmState, a: Vec, alpha: Vec) -> float:
    along: float = known.pull.drive - known.pull.hold * (arm.cosine * a.x + arm.sine * a.y)
    return along


@generic
def length_accelerations(arm: Any, accelerations: tuple[Any, ...]) -> tuple[float, ...]:
    """Of the accelerations of all arms those of their lengths [m/s²].

    Args:
        arm: Any one of the arms, whose type tells the kind.
        accelerations: By `arm_acceleration`, along their paths.
    """
    return accelerations


@generic
def bend_rates(arm: Any, bends: tuple[Bend, ...], accelerations: tuple[Any, ...]) -> Any:
    """Rates of the second coordinates of all arms; arguments as for `length_accelerations`."""
    return ()


class ArmMotion(NamedTuple):
    """Length of an arm and its rates; of one on two joints, both coordinates."""

    length: Any  # [m]
    rate: Any  # [m/s]
    acceleration: Any  # [m/s²]


@generic
def acceleration_at_end(arm: Any, moves: ArmMotion, body: BodyAcceleration) -> BodyAcceleration:
    """Acceleration of the main body and of the end of an arm, as one body in the axes of the end.

    Terms that are quadratic in rates are neglected: they are small.
    """
    raise TypeError(f"{type(arm).__name__} is not an arm")


@acceleration_at_end.register(Arm)
@kernel
def _at_end(arm: Arm, moves: ArmMotion, body: BodyAcceleration) -> BodyAcceleration:
    sliding = moves.acceleration
    end = body.linear + Vec(arm.cosine * sliding, arm.sine * sliding, 0.0)
    return replace(body, linear=end)


@kernel
def arm_motion(length: Any, rate: Any, acceleration: Any) -> ArmMotion:
    """Length of an arm and its rates, in one."""
    return ArmMotion(length, rate, acceleration)


@generic
def unbalanced_force(arm: Any, moves: ArmMotion) -> float:
    """Net force that moves an arm from its position, m l̈ + b l̇ [N]."""
    away: float = arm.mass * moves.acceleration + arm.damping * moves.rate
    return away


@kernel
def completed_view(known: ArmState, arm: Any, moves: ArmMotion, body: BodyAcceleration) -> ArmView:
    """The view of an arm, completed by its acceleration."""
    away = unbalanced_force(arm, moves)
    at_end = acceleration_at_end(arm, moves, body)
    next_ = fold(or_turn, known.seen.crossing, known.turns, (at_end,))
    return replace(known.seen, unbalance=away, crossing=next_)


@kernel
def arm_slip_rate(
    arm: Any, moves: ArmMotion, slips: tuple[Slip, ...], body: BodyAcceleration
) -> float:
    """The largest square of the rate of a slip of an arm [1/s²]; see `slip_rate`."""
    return maximum(tree_map(slip_rate, (slips,), (acceleration_at_end(arm, moves, body),)))


class ActingLoad(NamedTuple):
    """What acts on the vehicle besides gravity, and how it moves; body axes."""

    contact: Contact
    blown: Vec  # force of the air [N]
    reaction: tuple[float, ...]  # moment of rotors that change speed, about body z [N m]
    velocity: Vec  # Rᵀ v [m/s]
    omega: Vec  # [rad/s]
    released: float  # 1 lets compliant arms move
    listed: tuple[RotorWrench, ...] = ()  # of rotors that the vehicle lists


class Assembly(NamedTuple):
    """The equations of motion of a vehicle, assemble; body axes."""

    system: Any  # `System`, or that of arms on joints
    inertia: Mat3  # for bounds on rates: about the main body, of what turns with it [kg m²]
    stays: float  # for those of the main body's hull: mass of what no arm takes with it [kg]
    momentum: Vec  # of the arms relative to the main body [kg m/s]
    thrust_power: float  # [W]


@generic
def assemble(arm: Any, airframe: Airframe, share: Any, acts: ActingLoad) -> Assembly:
    """The six equations of a vehicle.

    Args:
        arm: Any one of its arms, whose type tells the kind.
        airframe: Constants of the vehicle.
        share: Sum of the shares of its arms.
        acts: What acts on it.
    """
    raise TypeError(f"{type(arm).__name__} is not an arm")


@assemble.register(Arm)
@kernel
def _assembled_in_plane(
    arm: Arm, airframe: Airframe, share: ArmShare, acts: ActingLoad
) -> Assembly:
    a, omega, contact, released = share, acts.omega, acts.contact, acts.released
    turning = omega ^ a.carried
    inertia = airframe.inertia + arms_inertia(a.inertia)
    inertia_rate = arms_inertia(a.half_inertia_rate + a.half_inertia_rate)
    spin_rate = (omega ^ (inertia @ omega)) + inertia_rate @ omega
    force = (
        contact.force + Vec(0.0, 0.0, a.thrust) - a.taken - (omega ^ (turning + a.drift + a.drift))
    )
    force = fold(with_rotor_push, force, acts.listed, ())
    rotor_moment = with_reaction(a.rotor_moment, acts.reaction)
    rotor_moment = fold(with_rotor_moment, rotor_moment, acts.listed, ())
    moment = contact.moment + rotor_moment - spin_rate
    sliding_mass = airframe.sliding * released
    mobility = select(released > 0.0, airframe.released, airframe.locked)
    system = System(
        airframe.mass, sliding_mass, mobility, a.carried, inertia, force + acts.blown, moment
    )
    stays = airframe.mass - sliding_mass.x - sliding_mass.y
    power = a.thrust * acts.velocity.z + rotor_moment @ omega
    power = fold(with_rotor_power, power, acts.listed, (acts.velocity,))
    return Assembly(system, inertia, stays, turning + a.drift, power)

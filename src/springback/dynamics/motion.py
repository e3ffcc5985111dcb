"""Equations of motion of the main body and its arms.

Ten coordinates for four arms: position, quaternion, arm lengths.  The equations are the paper's
Euler–Lagrange equations (3)-(12) in Newton–Euler form, free of the singularity of Euler angles; a
test proves the equivalence (tests/dynamics/test_lagrangian.py).  Vectors are in body axes, where
arms, rotors and cages lie in the plane z = 0.  With a' = Rᵀ(v̇ + g e_Z) and r_j = l_j e_j, each arm
obeys, along its own slide,

    m_j (l̈_j + e_j·a') = h_j = e_j·f_j − m_j e_j·(ω × (ω × r_j)) + (spring, damper, stops)

so l̈_j is eliminated before the system is solved, and six equations remain:

    [ M   −ŝ ] [a']   [ F − ω × (ω × s + 2 d) − Σ u_j h_j e_j ]
    [ ŝ    J ] [α ] = [ τ − ω × J ω − J̇ ω                     ]

    M = m 1 − Σ u_j m_j e_j e_jᵀ
    J = I + Σ m_j l_j² (1 − e_j e_jᵀ)

with the arms' first moment s = Σ m_j r_j and its rate d = Σ m_j l̇_j e_j; F and τ are the forces of
contact, rotors and air and their moments about the main body.

u_j is 1 for a sliding arm and 0 for a locked one.  With all arms locked these are the rigid
Newton–Euler equations (1), for any position of the centre of mass.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple, Protocol

from springback.contact.cage import LANDED as LANDED
from springback.contact.cage import (
    BodyMotion,
    body_motion,
    moving_bodies,
    obstacles_in_body_frame,
    obstacles_now,
)
from springback.contact.hull_contact import arm_faces, arm_flags, hull_flags
from springback.contact.laws.step_bounds import (
    ArmFrictionRate,
    FrictionDamping,
    Stiffness,
    contact_rate_bound,
    friction_rate_bound,
    inverse_inertia,
)
from springback.contact.loads import contacts_with
from springback.contact.obstacles import World
from springback.dynamics.air import aerodynamics
from springback.dynamics.crossing import Crossing, sooner, soonest
from springback.dynamics.hull_state import HullView as HullView
from springback.dynamics.hull_state import friction_rate_with_hull, hull_slip_rate, hull_state
from springback.dynamics.ledger import Work as Work
from springback.dynamics.moving_obstacles import VehiclePlace, all_flags, bodies_rates
from springback.dynamics.obstacle_views import (
    BodyView,
    StepRates,
    touched_obstacles,
    with_body_rates,
)
from springback.dynamics.solution import Free as Free
from springback.dynamics.solution import Slider as Slider
from springback.dynamics.solution import System as System
from springback.dynamics.solution import solve as solve
from springback.dynamics.stops import AHEAD, next_stop
from springback.dynamics.stops import end_stop as end_stop
from springback.dynamics.touches import RESTING as RESTING
from springback.dynamics.touches import (
    BodyAcceleration,
    Contact,
    PartBristles,
    PartPush,
    Slip,
    arm_bristles,
    arm_pushes,
    bristle_rates,
    bristles_of,
    contact_of,
    crossing_of,
    friction_rate_with_bristles,
    hull_bristles,
    hull_pushes,
    slip_of,
    slip_rate,
    strikes,
    touch_of,
    with_push,
)
from springback.dynamics.touches import Engaged as Engaged
from springback.kernels.compiler import kernel
from springback.kernels.trees import (
    field_of,
    fold,
    maximum,
    one_tuple,
    replace,
    select,
    tree_map,
    tree_map_sum,
    tree_sum,
)
from springback.kernels.vectors import Vec, positive_part, quaternion_rate
from springback.vehicle.state import (
    Airframe,
    Arm,
    Bristles,
    State,
    arm_pose,
    arms_inertia,
    fastest_cage,
    planar_product,
    reach,
)


class Motion(NamedTuple):
    """Integrated quantities: the state and the work."""

    state: State
    work: Work


class ArmView(NamedTuple):
    """Observable quantities of one arm."""

    gap: float  # to the nearest obstacle [m]
    depth: float  # deepest penetration [m]
    normal: float  # f_n [N]
    friction: Vec  # f_f, world [N]
    compression: float  # L − l [m]
    unbalance: float  # m_j l̈ + b_l l̇, the net force that moves it from its position [N]
    crossing: Crossing  # of a gap or a stop: the next zero
    engaged: tuple[float, ...]  # 1 while the cage touches, for each face
    impulsive: float  # 1 if it approaches a surface of the impulse law
    bottomed: float  # 1 at the end of the stroke
    stopped: float  # 1 while an end stop is pressed


class View(NamedTuple):
    """Observable quantities of the vehicle at one instant."""

    acceleration: Vec  # v̇ of the main body, world [m/s²]
    specific_force: Vec  # a' = Rᵀ(v̇ + g e_Z), measured by an accelerometer there [m/s²]
    mass_centre_velocity: Vec  # world [m/s]
    contact_force: Vec  # sum over cages, world [N]
    touched: Vec  # normals into touched obstacles, summed over cages and hull, world
    arms: tuple[ArmView, ...]
    hull: tuple[HullView, ...]  # of the main body; empty without one
    on_ground: float  # number of grounds touched
    friction_rate: float  # upper bound on the rate at which friction stops a sliding cage [1/s]
    contact_rate: float  # upper bound on the rate of contacts and end stops [1/s]
    slip_rate: float  # rate of change of a slip, over its regularised speed [1/s]
    bodies: tuple[BodyView, ...] = ()  # obstacles that move; mostly none


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

    drive: float  # u_j h_j / m_j
    hold: float  # u_j


class Surroundings(NamedTuple):
    """What all arms of a vehicle share at one instant."""

    obstacles: Any  # in the body frame
    contact_point: Any  # Ring or ArmTip
    body: BodyMotion
    released: float  # 1 lets compliant arms slide, 0 locks them


class ArmState(NamedTuple):
    """All quantities of one arm at one instant."""

    share: ArmShare
    pull: ArmPull
    seen: ArmView
    touched: Vec  # normal into the obstacle that it touches, body; zero without contact
    grip: ArmFrictionRate
    slide: Stiffness  # spring and damper along the slide
    slips: tuple[Slip, ...]  # one for each face
    bristles: tuple[PartBristles, ...]  # if a surface has any


@kernel
def spring_damper_force(arm: Arm, length: float, rate: float) -> float:
    """Force of the Kelvin–Voigt arm, k_l (L − l) − b_l l̇: positive lengthens the arm [N].

    The damper opposes l̇ (Rayleigh); the sign printed in eq. (11) would add energy.
    """
    return arm.stiffness * (arm.length - length) - arm.damping * rate


@kernel
def arm_state(
    arm: Arm,
    length: float,
    rate: float,
    thrust: float,
    engaged: tuple[float, ...],
    push: tuple[PartPush, ...],
    bristles: tuple[Bristles, ...],
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
        bristles: Of the cage and its hulls, if a surface has any.
        around: What all arms share.
    """
    body, omega = around.body, around.body.omega
    m, u = arm.mass, arm.compliance * around.released
    pose = arm_pose(arm, length, rate, body.velocity)
    e, lever = pose.direction, pose.lever

    touching = maximum(engaged)
    faces = arm_faces(arm, around.obstacles, around.contact_point, pose, touching)
    met = contacts_with(around.obstacles, faces, engaged, bristles, pose, body)
    touch = fold(with_push, tree_sum(field_of(met, "touch")), push, (lever, body.r))
    touches = touch_of(met, push, body.r)
    stop = end_stop(arm, length, rate)

    across = e.x * omega.y - e.y * omega.x
    ml = m * length
    outward = ml * (across * across + omega.z * omega.z)  # centrifugal force along the arm
    own = spring_damper_force(arm, length, rate) + stop.force
    h = e @ touch.force + outward + own

    carried, drift = ml * e, (m * rate) * e
    per_mass = u * arm.inverse_mass
    share = ArmShare(
        contact=contact_of(touch, moving_bodies(around.obstacles), met),
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
    has_stops = (arm.stop_stiffness > 0.0) & (u > 0.0)
    stops_at = next_stop(arm, length, rate if has_stops else 0.0)
    view = ArmView(
        gap=touches.gap,
        depth=positive_part(-touches.gap),
        normal=touch.normal,
        friction=body.r @ touch.friction,
        compression=arm.length - length,
        unbalance=0.0,
        crossing=sooner(soonest(tree_map(crossing_of, (met,), ())), stops_at),
        engaged=touches.engaged,
        impulsive=maximum(tree_map(strikes, (met,), ())),
        bottomed=1.0 if has_stops & (length < arm.shortest) else 0.0,
        stopped=1.0 if u * stop.stiffness > 0.0 else 0.0,
    )
    grip = ArmFrictionRate(touch.grip.on_arm * per_mass, touch.grip.lean * per_mass)
    return ArmState(
        share, ArmPull(h * per_mass, u), view, touches.inward, grip, slide,
        tree_map(slip_of, (met,), ()), bristles_of(bristles, met, body.r),
    )  # fmt: skip


@kernel
def _arm_acceleration(arm: Arm, known: ArmState, a: Vec) -> float:
    return known.pull.drive - known.pull.hold * (arm.cosine * a.x + arm.sine * a.y)


@kernel
def _with_unbalance(view: ArmView, arm: Arm, rate: float, sliding: float) -> ArmView:
    """The view of an arm, completed by its acceleration."""
    away = arm.mass * sliding + arm.damping * rate
    return replace(view, unbalance=away)


@kernel
def _arm_slip_rate(
    arm: Arm,
    sliding: float,
    slips: tuple[Slip, ...],
    body: BodyAcceleration,
) -> float:
    end = body.linear + Vec(arm.cosine * sliding, arm.sine * sliding, 0.0)
    return maximum(tree_map(slip_rate, (slips,), (replace(body, linear=end),)))


class Rates(NamedTuple):
    """Rate of change of the motion, and the view at the same instant."""

    motion: Motion
    seen: View


@kernel
def _together(so_far: Contact, more: Contact) -> Contact:
    return tree_sum((so_far, more))


class Plant(Protocol):
    """A vehicle, and all that acts on it: `springback.simulation.record.Model` is one."""

    @property
    def airframe(self) -> Airframe:
        """Constants of the vehicle."""

    @property
    def world(self) -> World:
        """Obstacles and gravity."""

    @property
    def contact_point(self) -> Any:
        """`Ring` or `ArmTip`."""

    @property
    def guide(self) -> Any:
        """`Free` or `Slider`."""

    @property
    def air(self) -> Any:
        """`Still` or `Air`."""

    @property
    def thrust(self) -> tuple[float, ...]:
        """Thrust of each rotor, along body z at the end of its arm [N]."""

    @property
    def pushes(self) -> Any:
        """`Pushes` of another vehicle; empty without one."""


@kernel
def rates(plant: Plant, state: State, released: float, looks: float = 1.0) -> Rates:
    """Rate of change of all integrated quantities.

    Args:
        plant: The vehicle, and all that acts on it.
        state: Present state.
        released: 1 lets the compliant arms slide, 0 locks all arms (rigid flight).
        looks: 0 where no part can touch: faces of a scene are then not looked for.
    """
    engaged = Engaged(
        tree_map(arm_flags, (plant.airframe.arms,), (plant.world.obstacles, looks)),
        tree_map(hull_flags, (plant.airframe.hull,), (plant.world.obstacles, looks)),
        tree_map(all_flags, (moving_bodies(plant.world.obstacles),), ()),
    )
    return rates_while(plant, state, released, engaged)


@kernel
def rates_while(plant: Plant, state: State, released: float, engaged: Engaged) -> Rates:
    """Rates as by `rates`, with contact off where not engaged: see `face_contact`.

    Args:
        plant: As for `rates`.
        state: As for `rates`.
        released: As for `rates`.
        engaged: 0 where contact is off.
    """
    airframe, world = plant.airframe, plant.world
    body = body_motion(state, AHEAD * fastest_cage(airframe, state))
    r, omega, velocity = body.r, body.omega, body.velocity
    there = obstacles_now(world.obstacles, state.bodies)
    obstacles = obstacles_in_body_frame(there, state.position, r)
    arms, a = tree_map_sum(
        arm_state,
        "share",
        (
            airframe.arms,
            state.arm_length,
            state.arm_rate,
            plant.thrust,
            engaged.arms,
            arm_pushes(plant.pushes, airframe.arms),
            arm_bristles(state.bristles, airframe.arms),
        ),
        (Surroundings(obstacles, plant.contact_point, body, released),),
    )
    pushed = hull_pushes(plant.pushes, airframe.hull)
    held = hull_bristles(state.bristles, airframe.hull)
    hull = tree_map(hull_state, (airframe.hull, engaged.hull, pushed, held), (obstacles, body))
    contact = fold(_together, a.contact, field_of(hull, "contact"), ())
    bodies = bodies_rates(
        world.obstacles, state.bodies, moving_bodies(obstacles), contact.reactions, engaged.bodies,
        VehiclePlace(state.position, r), world.gravity,
    )  # fmt: skip
    seen_bodies = touched_obstacles(plant.pushes, field_of(bodies, "seen"))

    blown = aerodynamics(plant.air, velocity, r, a.thrust)
    turning = omega ^ a.carried
    inertia = airframe.inertia + arms_inertia(a.inertia)
    inertia_rate = arms_inertia(a.half_inertia_rate + a.half_inertia_rate)
    spin_rate = (omega ^ (inertia @ omega)) + inertia_rate @ omega
    force = (
        contact.force + Vec(0.0, 0.0, a.thrust) - a.taken - (omega ^ (turning + a.drift + a.drift))
    )
    moment = contact.moment + a.rotor_moment - spin_rate
    sliding_mass = airframe.sliding * released
    mobility = select(released > 0.0, airframe.released, airframe.locked)
    system = System(
        airframe.mass, sliding_mass, mobility, a.carried, inertia, force + blown.force, moment
    )
    solved = solve(plant.guide, system, r, world.gravity)

    acceleration = r @ solved.linear - Vec(0.0, 0.0, world.gravity)
    sliding = tree_map(_arm_acceleration, (airframe.arms, arms), (solved.linear,))
    on_arms, on_hull = one_tuple(field_of(arms, "bristles")), one_tuple(field_of(hull, "bristles"))
    state_rate = State(
        state.velocity,
        quaternion_rate(state.attitude, omega),
        acceleration,
        solved.angular,
        state.arm_rate,
        sliding,
        field_of(bodies, "state"),
        bristle_rates(state.bristles, on_arms, on_hull),
    )
    thrust_power = a.thrust * velocity.z + a.rotor_moment @ omega
    push = r @ contact.force
    work_rate = Work(
        thrust_power,
        a.arm_loss,
        a.stop_loss,
        contact.contact_loss,
        contact.friction_loss,
        0.0,
        blown.loss,
        push,
        field_of(bodies, "work"),
    )
    mass_centre_velocity = state.velocity + r @ ((turning + a.drift) * airframe.inverse_mass)
    views = tree_map(
        _with_unbalance, (field_of(arms, "seen"), airframe.arms, state.arm_rate, sliding), ()
    )
    grips = field_of(arms, "grip")
    inverse = inverse_inertia(inertia)
    friction_rate = friction_rate_bound(
        a.grip, field_of(grips, "whole"), field_of(grips, "lean"), airframe.inverse_mass,
        inertia, inverse,
    )  # fmt: skip
    stays = airframe.mass - sliding_mass.x - sliding_mass.y
    friction_rate = fold(friction_rate_with_hull, friction_rate, hull, (stays, inverse))
    held_parts = on_arms + on_hull
    friction_rate = fold(friction_rate_with_bristles, friction_rate, held_parts, (inverse.largest,))
    # Terms of a cage's acceleration that are quadratic in rates are neglected: they are small.
    linear = solved.linear - world.gravity * body.vertical
    moving = BodyAcceleration(linear, solved.angular, body.vertical)
    cage_slips = tree_map(
        _arm_slip_rate, (airframe.arms, sliding, field_of(arms, "slips")), (moving,)
    )
    hull_slips = tree_map(hull_slip_rate, (hull,), (moving,))
    contact_rate = contact_rate_bound(
        contact.press, field_of(arms, "slide"), airframe.inverse_mass, inverse, reach(airframe)
    )
    own = StepRates(friction_rate, contact_rate, math.sqrt(maximum(cage_slips + hull_slips)))
    limits = fold(with_body_rates, own, seen_bodies, ())
    view = View(
        acceleration,
        solved.linear,
        mass_centre_velocity,
        push,
        r @ tree_sum(field_of(arms, "touched") + field_of(hull, "touched")),
        views,
        field_of(hull, "seen"),
        contact.on_ground,
        limits.friction,
        limits.contact,
        limits.slip,
        seen_bodies,
    )
    return Rates(Motion(state_rate, work_rate), view)

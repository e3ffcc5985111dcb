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
from typing import NamedTuple

from springback.contact.cage import LANDED as LANDED
from springback.contact.cage import (
    moving_bodies,
)
from springback.contact.hull_contact import arm_flags, body_sight, hull_flags
from springback.contact.laws.memory import (
    arm_memory,
    friction_rate_with_bristles,
    hull_memory,
    memory_rates,
)
from springback.contact.laws.step_bounds import (
    contact_rate_bound,
    friction_rate_bound,
    inverse_inertia,
)
from springback.dynamics.air import aerodynamics
from springback.dynamics.hull_state import HullView as HullView
from springback.dynamics.hull_state import (
    friction_rate_with_hull,
    hull_slip_rate,
    hull_state,
    view_with_turns,
)
from springback.dynamics.ledger import Work as Work
from springback.dynamics.limbs import bent as bent  # registers arms on two joints
from springback.dynamics.limbs import jointed as jointed  # registers arms on joints
from springback.dynamics.limbs.arms import (
    ActingLoad,
    ArmView,
    Surroundings,
    arm_acceleration,
    arm_motion,
    arm_slip_rate,
    arm_state,
    assemble,
    bend_rates,
    completed_view,
    length_accelerations,
)
from springback.dynamics.limbs.surface_effect import rotors_far, rotors_near
from springback.dynamics.moving_obstacles import VehiclePlace, all_flags, bodies_rates
from springback.dynamics.obstacle_views import (
    BodyView,
    StepRates,
    touched_obstacles,
    with_body_rates,
)
from springback.dynamics.solution import Free as Free
from springback.dynamics.solution import Plant as Plant
from springback.dynamics.solution import Slider as Slider
from springback.dynamics.solution import System as System
from springback.dynamics.solution import (
    rail_friction_rate,
    rail_loss,
    rail_slip_rate,
    with_rail,
)
from springback.dynamics.solution import solve as solve
from springback.dynamics.stops import AHEAD
from springback.dynamics.stops import end_stop as end_stop
from springback.dynamics.touches import RESTING as RESTING
from springback.dynamics.touches import (
    BodyAcceleration,
    Contact,
    arm_pushes,
    hull_pushes,
    or_point,
)
from springback.dynamics.touches import Engaged as Engaged
from springback.kernels.compiler import kernel
from springback.kernels.trees import (
    field_of,
    fold,
    maximum,
    one_tuple,
    tree_map,
    tree_map_sum,
    tree_sum,
)
from springback.kernels.vectors import Vec, quaternion_rate
from springback.vehicle.arms.neighbours import neighbour_load
from springback.vehicle.placed.rotors import acting_rotors, with_lift
from springback.vehicle.state import (
    State,
    coordinates_of_arms,
    fastest_cage,
    rates_of_arms,
    reach,
)


class Motion(NamedTuple):
    """Integrated quantities: the state and the work."""

    state: State
    work: Work


class View(NamedTuple):
    """Observable quantities of the vehicle at one instant."""

    acceleration: Vec  # v̇ of the main body, world [m/s²]
    specific_force: Vec  # a' = Rᵀ(v̇ + g e_Z), measured by an accelerometer there [m/s²]
    mass_centre_velocity: Vec  # world [m/s]
    contact_force: Vec  # sum over cages, world [N]
    touched: Vec  # normals into touched obstacles, summed over cages and hull, world
    touched_at: Vec  # where one of them is touched, world [m]
    arms: tuple[ArmView, ...]
    hull: tuple[HullView, ...]  # of the main body; empty without one
    on_ground: float  # number of grounds touched
    friction_rate: float  # upper bound on the rate at which friction stops a sliding cage [1/s]
    contact_rate: float  # upper bound on the rate of contacts and end stops [1/s]
    slip_rate: float  # rate of change of a slip, over its regularised speed [1/s]
    bodies: tuple[BodyView, ...] = ()  # obstacles that move; mostly none


class Rates(NamedTuple):
    """Rate of change of the motion, and the view at the same instant."""

    motion: Motion
    seen: View


@kernel
def _together(so_far: Contact, more: Contact) -> Contact:
    return tree_sum((so_far, more))


@kernel
def _both_tuples(first: tuple[Vec, ...], second: tuple[Vec, ...]) -> tuple[Vec, ...]:
    return first + second


@kernel
def all_engaged(plant: Plant, looks: float = 1.0) -> Engaged:
    """Contacts none of which is off; with ``looks`` 0, faces of a scene are not looked for."""
    return Engaged(
        tree_map(arm_flags, (plant.airframe.arms,), (plant.world.obstacles, looks)),
        tree_map(hull_flags, (plant.airframe.hull,), (plant.world.obstacles, looks)),
        tree_map(all_flags, (moving_bodies(plant.world.obstacles),), ()),
    )


@kernel
def rates(plant: Plant, state: State, released: float, looks: float = 1.0) -> Rates:
    """Rate of change of all integrated quantities.

    Args:
        plant: The vehicle, and all that acts on it.
        state: Present state.
        released: 1 lets the compliant arms slide, 0 locks all arms (rigid flight).
        looks: 0 where no part can touch: faces of a scene are then not looked for.
    """
    return rates_while(plant, state, released, all_engaged(plant, looks))


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
    around = body_sight(world.obstacles, state, AHEAD * fastest_cage(airframe, state))
    lengths = coordinates_of_arms(airframe.arms[0], state)
    arm_rates = rates_of_arms(airframe.arms[0], state)
    between = neighbour_load(airframe.neighbours, airframe.arms, lengths, arm_rates)
    here = (airframe, lengths, around.obstacles)
    near = fold(rotors_near, rotors_far(plant.thrust), plant.surface_effect, here)
    rotors = acting_rotors(
        airframe.rotors, airframe.arms, lengths, arm_rates, near.thrust, plant.reaction
    )
    listed = rotors.listed + near.suction
    pulls = tree_map(_both_tuples, (between.pulls, rotors.pulls), ())
    body, obstacles = around.body, around.obstacles
    r, omega, velocity = body.r, body.omega, body.velocity
    arms, a = tree_map_sum(
        arm_state,
        "share",
        (
            airframe.arms,
            lengths,
            arm_rates,
            rotors.thrust,
            engaged.arms,
            arm_pushes(plant.pushes, airframe.arms),
            pulls,
            arm_memory(state.memory, airframe.arms),
        ),
        (Surroundings(around, plant.contact_point, released),),
    )
    pushed = hull_pushes(plant.pushes, airframe.hull)
    held = hull_memory(state.memory, airframe.hull)
    hull = tree_map(hull_state, (airframe.hull, engaged.hull, pushed, held), (obstacles, body))
    contact = fold(_together, a.contact, field_of(hull, "contact"), ())
    bodies = bodies_rates(
        world.obstacles, state.bodies, moving_bodies(obstacles), contact.reactions, engaged.bodies,
        VehiclePlace(state.position, r), world.gravity,
    )  # fmt: skip
    seen_bodies = touched_obstacles(plant.pushes, field_of(bodies, "seen"))

    blown = aerodynamics(plant.air, velocity, r, fold(with_lift, a.thrust, listed, ()))
    rail = plant.guide.rail  # empty without dry friction
    outside = fold(with_rail, blown.force, rail, (state.velocity, r))
    acts = ActingLoad(contact, outside, rotors.reaction, velocity, omega, released, listed)
    whole = assemble(airframe.arms[0], airframe, a, acts)
    solved = solve(plant.guide, whole.system, r, world.gravity)

    acceleration = r @ solved.linear - Vec(0.0, 0.0, world.gravity)
    sliding = tree_map(
        arm_acceleration, (airframe.arms, lengths, arms), (solved.linear, solved.angular)
    )
    on_arms, on_hull = field_of(arms, "bristles"), field_of(hull, "bristles")
    state_rate = State(
        state.velocity,
        quaternion_rate(state.attitude, omega),
        acceleration,
        solved.angular,
        state.arm_rate,
        length_accelerations(airframe.arms[0], sliding),
        field_of(bodies, "state"),
        memory_rates(state.memory, on_arms, on_hull, field_of(hull, "spin")),
        bend_rates(airframe.arms[0], state.bends, sliding),
    )
    push = r @ contact.force
    work_rate = Work(
        whole.thrust_power,
        a.arm_loss + between.loss,
        a.stop_loss,
        contact.contact_loss,
        fold(rail_loss, contact.friction_loss, rail, (state.velocity,)),
        0.0,
        blown.loss,
        push,
        field_of(bodies, "work"),
    )
    mass_centre_velocity = state.velocity + r @ (whole.momentum * airframe.inverse_mass)
    grips = field_of(arms, "grip")
    inverse = inverse_inertia(whole.inertia)
    friction_rate = friction_rate_bound(
        a.grip, field_of(grips, "whole"), field_of(grips, "lean"), airframe.inverse_mass,
        whole.inertia, inverse,
    ) + maximum(field_of(grips, "any_way"))  # fmt: skip
    friction_rate = fold(friction_rate_with_hull, friction_rate, hull, (whole.stays, inverse))
    held_parts = one_tuple(on_arms + on_hull)
    friction_rate = fold(friction_rate_with_bristles, friction_rate, held_parts, (inverse.largest,))
    # Terms of a cage's acceleration that are quadratic in rates are neglected: they are small.
    linear = solved.linear - world.gravity * body.vertical
    moving = BodyAcceleration(linear, solved.angular, body.vertical)
    moves = tree_map(arm_motion, (lengths, arm_rates, sliding), ())
    views = tree_map(completed_view, (arms, airframe.arms, moves), (moving,))
    cage_slips = tree_map(arm_slip_rate, (airframe.arms, moves, field_of(arms, "slips")), (moving,))
    hull_slips = tree_map(hull_slip_rate, (hull,), (moving,))
    contact_rate = contact_rate_bound(
        contact.press, field_of(arms, "slide"), airframe.inverse_mass, inverse, reach(airframe)
    )
    friction_rate = fold(rail_friction_rate, friction_rate, rail, (state.velocity, whole.system, r))
    slips = math.sqrt(maximum(cage_slips + hull_slips))
    slips = fold(rail_slip_rate, slips, rail, (state.velocity, acceleration))
    own = StepRates(friction_rate, contact_rate, slips)
    touches = field_of(arms, "touched") + field_of(hull, "touched")
    limits = fold(with_body_rates, own, seen_bodies, ())
    view = View(
        acceleration,
        solved.linear,
        mass_centre_velocity,
        push,
        r @ tree_sum(field_of(touches, "inward")),
        state.position + r @ fold(or_point, Vec(0.0, 0.0, 0.0), touches, ()),
        views,
        tree_map(view_with_turns, (hull,), (moving,)),
        contact.on_ground,
        limits.friction,
        limits.contact,
        limits.slip,
        seen_bodies,
    )
    return Rates(Motion(state_rate, work_rate), view)

"""Energy and momentum of a vehicle, and the jump when settled arms are locked."""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.cage import (
    BodyMotion,
    ContactFace,
    body_motion,
    obstacles_in_body_frame,
    obstacles_now,
)
from springback.contact.hull_contact import arm_faces, hull_faces
from springback.contact.obstacles import World
from springback.contact.surfaces import elastic_energy
from springback.dynamics.moving_obstacles import BodyEnergy, bodies_energy
from springback.kernels.compiler import rare_kernel
from springback.kernels.trees import field_of, fold, replace, tree_map, tree_sum
from springback.kernels.vectors import (
    Mat3,
    Vec,
    positive_part,
    rotation,
    solve_symmetric,
)
from springback.vehicle.state import (
    Airframe,
    Arm,
    State,
    arm_direction,
    arm_pose,
    arms_inertia,
)


class Energy(NamedTuple):
    """Mechanical energy of a vehicle by its parts [J]."""

    kinetic: float
    gravity: float  # above Z = 0
    springs: float  # arm springs
    stops: float  # end stops
    contact: float  # elastic part of the contacts
    obstacles: float  # of obstacles that move by themselves: all of theirs

    @property
    def total(self) -> float:
        """Sum of all parts [J]."""
        held = self.kinetic + self.gravity + self.springs + self.stops + self.contact
        return held + self.obstacles


@rare_kernel
def _arm_energy(
    arm: Arm,
    length: float,
    rate: float,
    world: World,
    contact_point: Any,
    body: BodyMotion,
) -> Energy:
    """Energy of an arm in a world whose obstacles are in the body frame."""
    pose = arm_pose(arm, length, rate, body.velocity)
    velocity = pose.sliding + (body.omega ^ pose.lever)
    faces = arm_faces(arm, world.obstacles, contact_point, pose, 1.0)
    stored = tree_map(_contact_energy, (faces,), ())
    pressed = positive_part(arm.shortest - length) * positive_part(arm.shortest - length)
    pressed += positive_part(length - arm.length) * positive_part(length - arm.length)
    return Energy(
        kinetic=0.5 * arm.mass * (velocity @ velocity),
        gravity=arm.mass * world.gravity * (body.position.z + body.vertical @ pose.lever),
        springs=0.5
        * arm.compliance
        * arm.stiffness
        * (arm.length - length)
        * (arm.length - length),
        stops=0.5 * arm.compliance * arm.stop_stiffness * pressed,
        contact=tree_sum(stored),
        obstacles=0.0,
    )


@rare_kernel
def _contact_energy(face: ContactFace) -> float:
    return elastic_energy(face.surface, positive_part(-face.nearest.gap))


@rare_kernel
def _hull_energy(so_far: float, hull: Any, obstacles: Any) -> float:
    """Elastic energy of contacts, with those of the hull added [J]."""
    return so_far + tree_sum(tree_map(_contact_energy, (hull_faces(hull, obstacles, 1.0),), ()))


@rare_kernel
def energy(airframe: Airframe, world: World, contact_point: Any, state: State) -> Energy:
    """Mechanical energy of a vehicle [J], eqs. (5) and (7) with contact and end stops added."""
    body, omega = body_motion(state, 0.0), state.angular_velocity
    there = obstacles_now(world.obstacles, state.bodies)
    obstacles = obstacles_in_body_frame(there, state.position, body.r)
    arms = tree_map(
        _arm_energy,
        (airframe.arms, state.arm_length, state.arm_rate),
        (replace(world, obstacles=obstacles), contact_point, body),
    )
    a = tree_sum(arms)
    body_mass = airframe.mass - tree_sum(field_of(airframe.arms, "mass"))
    kinetic = 0.5 * body_mass * (state.velocity @ state.velocity)
    kinetic += 0.5 * (omega @ (airframe.inertia @ omega))
    gravity = body_mass * world.gravity * state.position.z
    contact = fold(_hull_energy, a.contact, airframe.hull, (obstacles,))
    held = Energy(a.kinetic + kinetic, a.gravity + gravity, a.springs, a.stops, contact, 0.0)
    moving = bodies_energy(world.obstacles, state.bodies, world.gravity)
    return fold(_with_body, held, moving, ())


@rare_kernel
def _with_body(held: Energy, body: BodyEnergy) -> Energy:
    more = body.kinetic + body.gravity + body.springs + body.contact
    return replace(held, obstacles=held.obstacles + more)


class Spread(NamedTuple):
    """Mass moments of the arms about the main body, body axes."""

    first: Vec  # Σ m_j r_j [kg m]
    drift: Vec  # Σ m_j l̇_j e_j [kg m/s]
    second: Vec  # Σ m_j l_j² (e_x², e_y², e_x e_y) [kg m²]


@rare_kernel
def spread(arm: Arm, length: float, rate: float) -> Spread:
    """Mass moments of one arm."""
    e, m = arm_direction(arm), arm.mass
    squares = Vec(e.x * e.x, e.y * e.y, e.x * e.y)
    return Spread((m * length) * e, (m * rate) * e, (m * length * length) * squares)


@rare_kernel
def about_mass_centre(inertia: Mat3, mass: float, centre: Vec) -> Mat3:
    """Inertia about the centre of mass, from that about another point (Steiner)."""
    c, square = centre, centre @ centre
    return inertia + Mat3(
        Vec(-mass * (square - c.x * c.x), mass * c.x * c.y, mass * c.x * c.z),
        Vec(mass * c.y * c.x, -mass * (square - c.y * c.y), mass * c.y * c.z),
        Vec(mass * c.z * c.x, mass * c.z * c.y, -mass * (square - c.z * c.z)),
    )


@rare_kernel
def angular_momentum(airframe: Airframe, state: State) -> Vec:
    """Angular momentum about the centre of mass, world axes [kg m²/s]."""
    now = tree_sum(tree_map(spread, (airframe.arms, state.arm_length, state.arm_rate), ()))
    omega, m = state.angular_velocity, airframe.mass
    centre, drift = now.first * (1.0 / m), now.drift * (1.0 / m)
    about_body = (airframe.inertia + arms_inertia(now.second)) @ omega
    return rotation(state.attitude) @ (about_body - m * (centre ^ ((omega ^ centre) + drift)))


@rare_kernel
def _still(arm: Arm) -> float:
    return 0.0


@rare_kernel
def locked_state(airframe: Airframe, state: State) -> State:
    """State after all arms have stopped at their present lengths.

    The velocity of the centre of mass and the angular momentum about it are conserved.  The kinetic
    energy of the arms along their slides is lost (Carnot), which is never negative; the caller
    books it.
    """
    r, omega, m = rotation(state.attitude), state.angular_velocity, airframe.mass
    now = tree_sum(tree_map(spread, (airframe.arms, state.arm_length, state.arm_rate), ()))
    centre, drift = now.first * (1.0 / m), now.drift * (1.0 / m)
    spin = angular_momentum(airframe, state) @ r
    velocity = state.velocity + r @ ((omega ^ centre) + drift)

    inertia = about_mass_centre(airframe.inertia + arms_inertia(now.second), m, centre)
    new_omega = solve_symmetric(inertia, spin)
    return State(
        state.position,
        state.attitude,
        velocity - r @ (new_omega ^ centre),
        new_omega,
        state.arm_length,
        tree_map(_still, (airframe.arms,), ()),
        state.bodies,
        state.bristles,
    )

"""Energy and momentum of a vehicle, and the jump when settled arms are locked."""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.cage import (
    BodyMotion,
    ContactFace,
)
from springback.contact.hull_contact import (
    BodySight,
    arm_faces,
    arm_sight,
    body_sight,
    hull_faces,
    hull_pose,
)
from springback.contact.laws.hysteresis import Pressing, hysteretic_energy
from springback.contact.laws.memory import arm_memory, hull_memory
from springback.contact.obstacles import World
from springback.contact.surfaces import elastic_energy
from springback.dynamics.moving_obstacles import BodyEnergy, bodies_energy
from springback.kernels.compiler import generic, rare_kernel
from springback.kernels.trees import field_of, fold, replace, tree_map, tree_sum
from springback.kernels.vectors import (
    Mat3,
    Vec,
    positive_part,
    rotation,
    solve_symmetric,
)
from springback.vehicle.arms.bent import BentArm, BentCoordinates, bent_pose
from springback.vehicle.arms.joints import JointedArm, joint_pose, joint_spring, point_inertia
from springback.vehicle.arms.neighbours import neighbour_energy
from springback.vehicle.state import (
    Airframe,
    Arm,
    Bend,
    PartMemory,
    Shell,
    State,
    arm_direction,
    arms_inertia,
    coordinates_of_arms,
    rates_of_arms,
    upper_stop,
)


class Energy(NamedTuple):
    """Mechanical energy of a vehicle by its parts [J]."""

    kinetic: float
    gravity: float  # above Z = 0
    springs: float  # of the arms, and between them
    stops: float  # end stops
    contact: float  # elastic part of the contacts
    obstacles: float  # of obstacles that move by themselves: all of theirs

    @property
    def total(self) -> float:
        """Sum of all parts [J]."""
        held = self.kinetic + self.gravity + self.springs + self.stops + self.contact
        return held + self.obstacles


@rare_kernel
def _arm_energy(arm: Any, length: float, rate: float, gravity: float, around: BodySight) -> Energy:
    """Energy of an arm without its contacts."""
    pose, _, body = arm_sight(arm, length, rate, around)
    velocity = pose.sliding + (body.omega ^ pose.lever)
    return Energy(
        kinetic=0.5 * arm.mass * (velocity @ velocity),
        gravity=arm.mass * gravity * (body.position.z + body.vertical @ pose.lever),
        springs=spring_energy(arm, length),
        stops=stop_energy(arm, length),
        contact=0.0,
        obstacles=0.0,
    )


@rare_kernel
def _energy_at_arm(
    arm: Any, length: float, rate: float, memory: PartMemory, contact_point: Any, around: BodySight
) -> float:
    """Energy that the contacts of an arm will give back [J]."""
    pose, obstacles, _ = arm_sight(arm, length, rate, around)
    faces = arm_faces(arm, obstacles, contact_point, pose, 1.0)
    stored = tree_map(_contact_energy, (faces,), (memory, pose.lever))
    return tree_sum(stored)


@generic
def stop_energy(arm: Any, length: Any) -> float:
    """Energy in the end stops of an arm [J]."""
    return in_end_stops(arm, length)


@rare_kernel
def in_end_stops(arm: Any, length: float) -> float:
    """Energy in the end stops of one coordinate of an arm [J]."""
    pressed = positive_part(arm.shortest - length) * positive_part(arm.shortest - length)
    beyond = positive_part(length - upper_stop(arm))
    pressed += beyond * beyond
    held: float = 0.5 * arm.compliance * arm.stop_stiffness * pressed
    return held


@stop_energy.register(BentArm)
@rare_kernel
def _in_stops_of_two(arm: BentArm, length: BentCoordinates) -> float:
    return in_end_stops(arm, length.first) + in_end_stops(arm.second, length.second)


@generic
def spring_energy(arm: Any, length: float) -> float:
    """Energy in the spring of an arm [J]."""
    raise TypeError(f"{type(arm).__name__} is not an arm")


@spring_energy.register(Arm)
@rare_kernel
def _in_slide(arm: Arm, length: float) -> float:
    return 0.5 * arm.compliance * arm.stiffness * (arm.length - length) * (arm.length - length)


@spring_energy.register(JointedArm)
@rare_kernel
def _in_joint(arm: JointedArm, length: float) -> float:
    return arm.compliance * joint_spring(arm, length).energy


@spring_energy.register(BentArm)
@rare_kernel
def _in_two_joints(arm: BentArm, length: BentCoordinates) -> float:
    held = joint_spring(arm, length.first).energy + joint_spring(arm.second, length.second).energy
    return arm.compliance * held


@rare_kernel
def _contact_energy(face: ContactFace, memory: PartMemory, end: Vec) -> float:
    """Energy that a contact of a part will give back [J].

    Args:
        face: In the body frame.
        memory: Of the part.
        end: From the main body to what the levers of the part begin at [m].
    """
    there, depth = face.nearest, positive_part(-face.nearest.gap)
    place = end + there.at.normal_lever
    at = Pressing(face.surface, place, there.inward, depth, 0.0, 0.0)
    elastic = elastic_energy(face.surface, depth)
    whole = fold(hysteretic_energy, elastic, memory.pressed, (at,))
    return fold(_share_of, whole, memory.stiffness, ())


@rare_kernel
def _share_of(whole: float, share: float) -> float:
    return share * whole


@rare_kernel
def _hull_energy(hull: Any, memory: PartMemory, obstacles: Any, body: BodyMotion) -> float:
    """Energy that the contacts of the hull will give back [J]."""
    faces, pose = hull_faces(hull, obstacles, 1.0), hull_pose(hull, body.velocity)
    return tree_sum(tree_map(_contact_energy, (faces,), (memory, pose.lever)))


@rare_kernel
def energy_without_contact(airframe: Airframe, world: World, state: State) -> Energy:
    """Mechanical energy of a vehicle [J], eqs. (5) and (7), with end stops: none in contacts."""
    around, omega = body_sight(world.obstacles, state, 0.0), state.angular_velocity
    lengths = coordinates_of_arms(airframe.arms[0], state)
    arm_rates = rates_of_arms(airframe.arms[0], state)
    moving = (airframe.arms, lengths, arm_rates)
    a = tree_sum(tree_map(_arm_energy, moving, (world.gravity, around)))
    body_mass = airframe.mass - tree_sum(field_of(airframe.arms, "mass"))
    kinetic = 0.5 * body_mass * (state.velocity @ state.velocity)
    kinetic += 0.5 * (omega @ (airframe.inertia @ omega))
    shells = tree_map(_spin_energy, (hull_memory(state.memory, airframe.hull), airframe.hull), ())
    kinetic = tree_sum((kinetic,) + shells)  # noqa: RUF005
    gravity = body_mass * world.gravity * state.position.z
    springs = a.springs + neighbour_energy(airframe.neighbours, airframe.arms, lengths, arm_rates)
    return Energy(a.kinetic + kinetic, a.gravity + gravity, springs, a.stops, 0.0, 0.0)


@rare_kernel
def energy(airframe: Airframe, world: World, contact_point: Any, state: State) -> Energy:
    """Mechanical energy of a vehicle [J], with that in contacts, and of what moves by itself."""
    around = body_sight(world.obstacles, state, 0.0)
    lengths = coordinates_of_arms(airframe.arms[0], state)
    arm_rates = rates_of_arms(airframe.arms[0], state)
    on_arms = arm_memory(state.memory, airframe.arms)
    known = (airframe.arms, lengths, arm_rates, on_arms)
    at_arms = tree_map(_energy_at_arm, known, (contact_point, around))
    on_hull = hull_memory(state.memory, airframe.hull)
    at_hull = tree_map(_hull_energy, (airframe.hull, on_hull), (around.obstacles, around.body))
    contact = tree_sum((tree_sum(at_arms),) + at_hull)  # noqa: RUF005
    held = replace(energy_without_contact(airframe, world, state), contact=contact)
    moving = bodies_energy(world.obstacles, state.bodies, world.gravity)
    return fold(_with_body, held, moving, ())


@rare_kernel
def _spin_energy(memory: PartMemory, hull: Any) -> float:
    return fold(_with_spin_energy, 0.0, memory.spin, (hull,))


@rare_kernel
def _with_spin_energy(so_far: float, spin: Vec, shell: Shell) -> float:
    return so_far + 0.5 * shell.inertia * (spin @ spin)


@rare_kernel
def _own_spin(memory: PartMemory, hull: Any) -> Vec:
    return fold(_with_spin_momentum, Vec(0.0, 0.0, 0.0), memory.spin, (hull,))


@rare_kernel
def _with_spin_momentum(so_far: Vec, spin: Vec, shell: Shell) -> Vec:
    return so_far + shell.inertia * spin


@rare_kernel
def _with_body(held: Energy, body: BodyEnergy) -> Energy:
    more = body.kinetic + body.gravity + body.springs + body.contact
    return replace(held, obstacles=held.obstacles + more)


class Spread(NamedTuple):
    """Mass moments of the arms about the main body, body axes."""

    first: Vec  # Σ m_j r_j [kg m]
    drift: Vec  # Σ m_j l̇_j e_j [kg m/s]
    second: Any  # Σ m_j l_j² (e_x², e_y², e_x e_y), or as inertia of arms on joints [kg m²]
    swing: Vec  # Σ m_j l̇_j r_j × e_j [kg m²/s]


@generic
def spread(arm: Any, length: float, rate: float) -> Spread:
    """Mass moments of one arm."""
    raise TypeError(f"{type(arm).__name__} is not an arm")


@spread.register(JointedArm)
@rare_kernel
def _on_joint(arm: JointedArm, length: float, rate: float) -> Spread:
    there, m = joint_pose(arm, length, rate), arm.mass
    first, drift = m * there.end, (m * rate) * there.direction
    return Spread(first, drift, point_inertia(m, there.end), there.end ^ drift)


@spread.register(BentArm)
@rare_kernel
def _on_two_joints(arm: BentArm, length: BentCoordinates, rate: BentCoordinates) -> Spread:
    there, m = bent_pose(arm, length, rate), arm.mass
    drift = m * there.velocity
    return Spread(m * there.end, drift, point_inertia(m, there.end), there.end ^ drift)


@spread.register(Arm)
@rare_kernel
def _on_slide(arm: Arm, length: float, rate: float) -> Spread:
    e, m = arm_direction(arm), arm.mass
    squares = Vec(e.x * e.x, e.y * e.y, e.x * e.y)
    none = Vec(0.0, 0.0, 0.0)
    return Spread((m * length) * e, (m * rate) * e, (m * length * length) * squares, none)


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
    now = mass_moments(airframe, state)
    omega, m = state.angular_velocity, airframe.mass
    centre, drift = now.first * (1.0 / m), now.drift * (1.0 / m)
    about_body = (airframe.inertia + arms_inertia(now.second)) @ omega + now.swing
    of_parts = rotation(state.attitude) @ (about_body - m * (centre ^ ((omega ^ centre) + drift)))
    memory = hull_memory(state.memory, airframe.hull)
    return tree_sum((of_parts,) + tree_map(_own_spin, (memory, airframe.hull), ()))  # noqa: RUF005


@rare_kernel
def _still(arm: Any) -> float:
    return 0.0


@rare_kernel
def _stopped(bend: Bend) -> Bend:
    return Bend(bend.way, 0.0)


@rare_kernel
def mass_moments(airframe: Airframe, state: State) -> Spread:
    """Mass moments of all arms."""
    arms = airframe.arms
    lengths, arm_rates = coordinates_of_arms(arms[0], state), rates_of_arms(arms[0], state)
    return tree_sum(tree_map(spread, (arms, lengths, arm_rates), ()))


@rare_kernel
def locked_state(airframe: Airframe, state: State) -> State:
    """State after all arms have stopped at their present lengths.

    The velocity of the centre of mass and the angular momentum about it are conserved.  The kinetic
    energy of the arms along their slides is lost (Carnot), which is never negative; the caller
    books it.
    """
    r, omega, m = rotation(state.attitude), state.angular_velocity, airframe.mass
    now = mass_moments(airframe, state)
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
        state.memory,
        tree_map(_stopped, (state.bends,), ()),
    )

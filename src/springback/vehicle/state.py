"""State of a vehicle and the kinematics of its arms.

Frames: NWU world (X north, Y west, Z up), FLU body (x forward, y left, z up).  The reference point
is the centre of mass of the main body, not of the whole vehicle.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import fold, maximum, tree_map
from springback.kernels.vectors import Mat3, Quat, Vec, larger, norm


class Sphere(NamedTuple):
    """Hull of the main body: a sphere that is fixed to it and has no mass of its own."""

    centre: Vec  # from the main body, body axes [m]
    radius: float  # [m]


class CompoundHull(NamedTuple):
    """All hulls that are fixed to the main body, or to one arm, as one part; without mass.

    Their numbers are in a table (`springback.vehicle.hulls`), so that any number of them, of any
    kinds, is one structure to the compiler.
    """

    table: float  # address of their numbers
    centre: Vec  # of a sphere around all, from the main body or the arm's end, body axes [m]
    radius: float  # of that sphere [m]


class Shell(NamedTuple):
    """Hull of the main body that turns by itself: a sphere in a gimbal, a ring about its axis."""

    touching: Any  # what touches: a `Sphere`, or a `CompoundHull` of one hull
    centre: Vec  # from the main body, body axes [m]
    radius: float  # [m]
    inertia: float  # I_s, about its centre, or its axis [kg m²]
    damping: float  # b, of the bearings [N m s]
    friction: float  # M_c, dry friction of the bearings [N m]
    axis: tuple[Vec, ...] = ()  # a, of a ring: the only one about which it turns, body axes


class Propeller(NamedTuple):
    """Disc that a propeller sweeps, parallel to the plane of the arms; what is in it is hit."""

    radius: float  # [m]
    height: float  # of its centre above the end of its arm, along body z [m]


class Arm(NamedTuple):
    """Constants of one arm: a point mass that slides along a straight line in the body plane.

    The cage and the rotor sit at the arm's end.  `compliance` is 1 for a sliding arm and 0 for a
    locked one: rigid and compliant vehicles differ in this number only.
    """

    cosine: float  # e_j = (cosine, sine, 0), unit vector in body axes
    sine: float
    mass: float  # m_a [kg]
    inverse_mass: float  # 1/m_a [1/kg]; 0 for an arm that cannot slide
    stiffness: float  # k_l [N/m]
    damping: float  # b_l [N s/m]
    length: float  # L, free length [m]
    shortest: float  # length at which the arm bottoms out [m]
    stop_stiffness: float  # of both end stops [N/m]; 0 switches them off
    stop_dissipation: float  # d of the end stops, force k δ (1 + d δ̇) [s/m]
    compliance: float  # 1 slides, 0 is locked
    cage_radius: float  # r_0 [m]
    torque_ratio: float  # rotor torque about body z per thrust, with its sign [m]
    hull: tuple[CompoundHull, ...] = ()  # at its end, besides the cage
    propeller: tuple[Propeller, ...] = ()  # at its end, if its size is known
    caged: float = 1.0  # 0: its circle touches nothing, only its hulls do


class PlanarInverse(NamedTuple):
    """Inverse of M = m 1 − Σ m_j e_j e_jᵀ, all e_j in the body plane: a 2 x 2 block and a number.

    M is the mass that resists translation once the arms in the sum slide freely.
    """

    xx: float  # [1/kg]
    yy: float
    xy: float
    zz: float


class Airframe(NamedTuple):
    """Constants of a vehicle for the equations of motion; `build_airframe` builds one."""

    mass: float  # m, everything [kg]
    inverse_mass: float  # 1/m [1/kg]
    inertia: Mat3  # of the main body alone, about its centre of mass, body axes [kg m²]
    arms: tuple[Any, ...]  # `Arm`, or all on joints
    hull: tuple[Any, ...]  # `Sphere`, `CompoundHull` or `Shell` of the main body; or no contact
    sliding: Vec  # Σ m_j (e_x², e_y², e_x e_y) of the arms that can slide [kg]
    released: PlanarInverse  # while they can
    locked: PlanarInverse  # while all arms are locked
    neighbours: Any = ()  # `springback.vehicle.arms.neighbours.NeighbourSprings`, if there are any
    rotors: Any = ()  # `springback.vehicle.placed.rotors.PlacedRotors`; none: one on each arm


def _planar_inverse(mass: float, sliding: Vec) -> PlanarInverse:
    xx, yy, xy = mass - sliding.x, mass - sliding.y, -sliding.z
    scale = 1.0 / (xx * yy - xy * xy)
    return PlanarInverse(yy * scale, xx * scale, -xy * scale, 1.0 / mass)


def about_axis(moment: float, axis: Vec) -> Mat3:
    """Inertia of what resists turning about one axis only, I a aᵀ [kg m²]."""
    return Mat3(moment * axis.x * axis, moment * axis.y * axis, moment * axis.z * axis)


def build_airframe(
    mass: float,
    inertia: Mat3,
    arms: tuple[Any, ...],
    hull: tuple[Any, ...] = (),
    neighbours: Any = (),
    rotors: Any = (),
) -> Airframe:
    """Constants of a vehicle, with those that follow from others.

    Args:
        mass: m, everything [kg].
        inertia: Of the main body alone, about its centre of mass, body axes [kg m²]; with a ring
            that turns about its axis, as if it were held.
        arms: At least one, all in the plane or all on joints.
        hull: Of the main body, a `Sphere`, `CompoundHull` or `Shell`; empty: it has no contact.
        neighbours: Springs between arms; empty: none.
        rotors: Those that the vehicle lists; empty: one at the end of each arm.
    """
    none = sliding = Vec(0.0, 0.0, 0.0)
    for arm in arms:
        if not isinstance(arm, Arm):  # on a joint: its path decides, at every instant
            continue
        x, y = arm.compliance * arm.mass * arm.cosine, arm.compliance * arm.mass * arm.sine
        sliding = sliding + Vec(x * arm.cosine, y * arm.sine, x * arm.sine)
    released, locked = _planar_inverse(mass, sliding), _planar_inverse(mass, none)
    for one in hull:
        for axis in one.axis if isinstance(one, Shell) else ():
            inertia = inertia - about_axis(one.inertia, axis)
    return Airframe(
        mass, 1.0 / mass, inertia, arms, hull, sliding, released, locked, neighbours, rotors
    )  # fmt: skip


@kernel
def _farthest_of_hull(hull: Any) -> float:
    farthest: float = norm(hull.centre) + hull.radius
    return farthest


@kernel
def _farther(so_far: float, hull: Any) -> float:
    return larger(_farthest_of_hull(hull), so_far)


@kernel
def _beyond_disc(so_far: float, disc: Propeller) -> float:
    return larger(disc.radius + abs(disc.height), so_far)


@generic
def farthest_of_arm(arm: Any) -> float:
    """Distance from the main body that no point of an arm exceeds [m], in its free travel."""
    raise TypeError(f"{type(arm).__name__} is not an arm")


@farthest_of_arm.register(Arm)
@kernel
def _farthest(arm: Arm) -> float:
    besides = fold(_farther, arm.cage_radius, arm.hull, ())
    return arm.length + fold(_beyond_disc, besides, arm.propeller, ())


@generic
def farthest_of_rotors(rotors: Any) -> tuple[float, ...]:
    """Distance from the main body that no disc of listed rotors exceeds [m]; empty without any."""
    return ()


@kernel
def reach(airframe: Airframe) -> float:
    """Distance from the main body to its farthest point, arms at their free length [m]."""
    parts = tree_map(farthest_of_arm, (airframe.arms,), ()) + tree_map(
        _farthest_of_hull, (airframe.hull,), ()
    )
    return maximum(parts + farthest_of_rotors(airframe.rotors))


class BodyState(NamedTuple):
    """Motion of an obstacle that moves by itself; or, field by field, its rate.

    Only what its kind of motion leaves open is used: `springback.contact.moving.bodies.body_pose`.
    """

    position: Vec  # of its centre of mass, world [m]; x: the time [s], where its motion is given
    attitude: Quat  # its axes to world
    velocity: Vec  # world [m/s]
    angular_velocity: Vec  # its axes [rad/s]


class Bristles(NamedTuple):
    """Elastic slip of the contacts of one part of a vehicle since they stuck; or its rate."""

    slip: Vec  # world [m]
    roll: Vec  # angle turned about the contact, world [rad]


class PressedPoint(NamedTuple):
    """A contact of a part of a vehicle; body axes."""

    place: Vec  # from the main body [m]
    inward: Vec  # unit normal into the obstacle
    depth: float  # the deepest so far [m]; 0: nothing touches
    crushed: float  # the same where the surface does not recover, else 0 [m]
    lost: float = 0.0  # energy that the last step cost by coming deeper [J]


class PressedPoints(NamedTuple):
    """Contacts of one part of a vehicle, and how deep they were; or a rate, which is zero."""

    crushed: float  # deepest depth from which the part has not recovered [m]
    points: tuple[PressedPoint, ...]  # one for each face that it can meet


class PartMemory(NamedTuple):
    """What the contacts of one part of a vehicle remember; or its rate."""

    bristles: tuple[Bristles, ...]  # one, if a surface has any
    pressed: tuple[PressedPoints, ...]  # one, if a surface remembers the deepest depth
    spin: tuple[Vec, ...] = ()  # Ω of a shell that turns by itself, world axes [rad/s]
    stiffness: tuple[float, ...] = ()  # share that a guard has left, if it can lose some


class VehicleMemory(NamedTuple):
    """What the contacts of all parts of a vehicle remember."""

    arms: tuple[PartMemory, ...]
    hull: tuple[PartMemory, ...]  # of the main body, if it has a hull


class Bend(NamedTuple):
    """Second coordinate of an arm on two joints; or, field by field, its rate."""

    way: float  # s₂, along the path of the second joint, 0 where that is free [m]
    rate: float  # ṡ₂ [m/s]


class State(NamedTuple):
    """Position, attitude and velocities of a vehicle; or, field by field, their rates."""

    position: Vec  # p, world [m]
    attitude: Quat  # q, body to world
    velocity: Vec  # v = ṗ, world [m/s]
    angular_velocity: Vec  # ω, body axes [rad/s]
    arm_length: tuple[float, ...]  # l_j [m]
    arm_rate: tuple[float, ...]  # l̇_j [m/s]
    bodies: tuple[BodyState, ...] = ()  # obstacles that move; mostly none
    memory: Any = ()  # `VehicleMemory` where a surface has one
    bends: tuple[Bend, ...] = ()  # of arms on two joints; mostly none


@generic
def coordinates_of_arms(arm: Any, state: State) -> tuple[Any, ...]:
    """Of each arm where it is along its path, or both its paths.

    Args:
        arm: Any one of the arms, whose type tells the kind.
        state: Of the vehicle.
    """
    return state.arm_length


@generic
def rates_of_arms(arm: Any, state: State) -> tuple[Any, ...]:
    """Rates of `coordinates_of_arms`; arguments as there."""
    return state.arm_rate


@generic
def largest_rate(rate: Any) -> float:
    """Size of the rate of an arm, of both if it has two [m/s]."""
    size: float = abs(rate)
    return size


@kernel
def fastest_point(airframe: Airframe, velocity: Vec, angular_velocity: Vec) -> float:
    """Upper bound on the speed of any point of the vehicle [m/s], with the arms locked."""
    return norm(velocity) + reach(airframe) * norm(angular_velocity)


@generic
def fastest_of_arm(arm: Any, rate: float) -> float:
    """Upper bound on the speed of any point of an arm relative to the main body [m/s]."""
    raise TypeError(f"{type(arm).__name__} is not an arm")


@fastest_of_arm.register(Arm)
@kernel
def _speed(arm: Arm, rate: float) -> float:
    return rate if rate > 0.0 else -rate


@kernel
def fastest_cage(airframe: Airframe, state: State) -> float:
    """Upper bound on the speed of any point of the vehicle [m/s], with sliding arms."""
    fastest = fastest_point(airframe, state.velocity, state.angular_velocity)
    arm_rates = rates_of_arms(airframe.arms[0], state)
    return fastest + maximum(tree_map(fastest_of_arm, (airframe.arms, arm_rates), ()))


class ArmPose(NamedTuple):
    """Kinematics of an arm relative to the main body, in body axes."""

    direction: Vec  # e_j
    lever: Vec  # r_j = l_j e_j, from the main body to the arm's end [m]
    sliding: Vec  # Rᵀ v + l̇_j e_j: velocity of the arm's end without that of rotation [m/s]


@kernel
def arm_direction(arm: Arm) -> Vec:
    """Unit vector e_j in body axes."""
    return Vec(arm.cosine, arm.sine, 0.0)


class ArmEnd(NamedTuple):
    """Where the end of an arm is in the body plane."""

    direction: Vec  # from the main body, unit vector, body axes
    distance: float  # [m]


@generic
def end_place(arm: Any, length: float) -> ArmEnd:
    """Where the end of an arm is in the body plane, at a length [m]."""
    raise TypeError(f"{type(arm).__name__} is not an arm")


@end_place.register(Arm)
@kernel
def _end_of_slide(arm: Arm, length: float) -> ArmEnd:
    return ArmEnd(arm_direction(arm), length)


@generic
def compression_of(arm: Any, length: float) -> float:
    """Compression of an arm at a length [m]; of one on a joint, to either side."""
    raise TypeError(f"{type(arm).__name__} is not an arm")


@compression_of.register(Arm)
@kernel
def _shortening(arm: Arm, length: float) -> float:
    return arm.length - length


@generic
def arm_pose(arm: Any, length: float, rate: float, velocity: Vec) -> ArmPose:
    """Kinematics of an arm, eq. (5), in body axes.

    Args:
        arm: Constants of the arm.
        length: l_j [m].
        rate: l̇_j [m/s].
        velocity: Rᵀ v, of the main body, body axes [m/s].
    """
    raise TypeError(f"{type(arm).__name__} is not an arm")


@arm_pose.register(Arm)
@kernel
def _pose_in_plane(arm: Arm, length: float, rate: float, velocity: Vec) -> ArmPose:
    e = arm_direction(arm)
    return ArmPose(e, length * e, velocity + rate * e)


@generic
def resting_stiffness(arm: Any) -> float:
    """Stiffness by which it is told whether an arm rests [N/m]."""
    raise TypeError(f"{type(arm).__name__} is not an arm")


@resting_stiffness.register(Arm)
@kernel
def _own_stiffness(arm: Arm) -> float:
    return arm.stiffness


@generic
def in_body_axes(arm: Any, length: float, vector: Vec) -> Vec:
    """A vector in the axes of what is at the end of an arm, in body axes."""
    raise TypeError(f"{type(arm).__name__} is not an arm")


@in_body_axes.register(Arm)
@kernel
def _unturned(arm: Arm, length: float, vector: Vec) -> Vec:
    return vector


@generic
def upper_stop(arm: Any) -> float:
    """Length of an arm at the stop that it reaches by getting longer [m]."""
    raise TypeError(f"{type(arm).__name__} is not an arm")


@upper_stop.register(Arm)
@kernel
def _free_length(arm: Arm) -> float:
    return arm.length


@kernel
def planar_product(a: Vec, b: Vec) -> Vec:
    """Components (a_x b_x, a_y b_y, a_x b_y) of a bᵀ, for parallel vectors in the body plane."""
    return Vec(a.x * b.x, a.y * b.y, a.x * b.y)


@generic
def arms_inertia(second: Any) -> Mat3:
    """Inertia of the arms about the main body, body axes [kg m²].

    Args:
        second: Σ m_j l_j² (e_x², e_y², e_x e_y) of arms in the body plane, or its rate, for the
            rate; or, of arms on joints, the inertia itself.
    """
    raise TypeError(f"{type(second).__name__} is no second moment of mass")


@arms_inertia.register(Mat3)
@kernel
def _known_inertia(second: Mat3) -> Mat3:
    return second


@arms_inertia.register(Vec)
@kernel
def _planar_inertia(second: Vec) -> Mat3:
    """Σ m_j l_j² (1 − e_j e_jᵀ)."""
    return Mat3(
        Vec(second.y, -second.z, 0.0),
        Vec(-second.z, second.x, 0.0),
        Vec(0.0, 0.0, second.x + second.y),
    )

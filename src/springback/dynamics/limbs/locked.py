"""A vehicle with its arms locked: one rigid body under rotor thrusts, and its rates by eq. (1)."""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.dynamics.air import aerodynamics, with_reaction
from springback.dynamics.solution import SpatialSystem, System, solve
from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import replace, tree_map, tree_sum
from springback.kernels.vectors import Mat3, Quat, Vec, isotropic, quaternion_rate, rotation, skew
from springback.vehicle.arms.bent import BentArm, bent_pose, bent_thrust_direction
from springback.vehicle.arms.joints import JointedArm, joint_pose, point_inertia, thrust_direction
from springback.vehicle.placed.rotors import PlacedRotors, acting_rotors
from springback.vehicle.state import (
    Airframe,
    Arm,
    PlanarInverse,
    arm_direction,
    arms_inertia,
    planar_product,
)


class OneBody(NamedTuple):
    """A vehicle with its arms locked, and the thrust that acts on it."""

    mass: float  # m [kg]
    inverse_mass: float  # 1/m [1/kg]
    inverse: PlanarInverse  # of the mass that resists translation
    carried: Vec  # s = Σ m_j r_j [kg m]
    inertia: Mat3  # J about the main body's centre of mass, body axes [kg m²]
    thrust: float  # collective [N]
    rotor_moment: Vec  # body axes [N m]


class RigidState(NamedTuple):
    """Position, attitude and velocities of one body, and the work done on it."""

    position: Vec  # of the main body, world [m]
    attitude: Quat
    velocity: Vec  # world [m/s]
    angular_velocity: Vec  # body [rad/s]
    thrust_work: float  # put in by the rotors [J]
    air_work: float  # taken by the air [J]


class RigidRates(NamedTuple):
    """Rate of change of a `RigidState`, and observable quantities at that instant."""

    flight: RigidState
    specific_force: Vec  # a' = Rᵀ(v̇ + g e_Z) of the main body, body [m/s²]
    mass_centre_velocity: Vec  # world [m/s]


class _Part(NamedTuple):
    """Contribution of one locked arm."""

    carried: Vec
    inertia: Vec  # m_j l_j² (e_x², e_y², e_x e_y)
    thrust: float
    rotor_moment: Vec


@kernel
def _part(arm: Arm, length: float, thrust: float) -> _Part:
    e = arm_direction(arm)
    lever = length * e
    carried = (arm.mass * length) * e
    moment = thrust * Vec(lever.y, -lever.x, arm.torque_ratio)
    return _Part(carried, planar_product(carried, lever), thrust, moment)


@kernel
def rigid_body(
    airframe: Airframe,
    lengths: tuple[float, ...],
    thrust: tuple[float, ...],
    reaction: tuple[Any, ...],
) -> Any:
    """A vehicle with its arms locked at given lengths, under the loads of its rotors.

    Args:
        airframe: Constants of the vehicle.
        lengths: Of the arms [m].
        thrust: Of each rotor [N].
        reaction: Of rotors that change speed, as of `springback.dynamics.solution.Plant` [N m].
    """
    return with_rotors(airframe.rotors, airframe, lengths, thrust, reaction)


@generic
def with_rotors(
    rotors: Any,
    airframe: Airframe,
    lengths: tuple[float, ...],
    thrust: tuple[float, ...],
    reaction: tuple[Any, ...],
) -> Any:
    """As `rigid_body`, by the list of rotors; without one each arm has one."""
    body = with_locked_arms(airframe.arms[0], airframe, lengths, thrust)
    return replace(body, rotor_moment=with_reaction(body.rotor_moment, reaction))


@with_rotors.register(PlacedRotors)
@kernel
def _with_listed_rotors(
    rotors: PlacedRotors,
    airframe: Airframe,
    lengths: tuple[float, ...],
    thrust: tuple[float, ...],
    reaction: tuple[Any, ...],
) -> LeaningBody:
    still = tree_map(_no_rate, (airframe.arms,), ())
    acting = acting_rotors(rotors, airframe.arms, lengths, still, thrust, reaction)
    alone = with_locked_arms(airframe.arms[0], airframe, lengths, acting.thrust)
    whole = acting.listed[0]
    return LeaningBody(
        alone.mass, alone.inverse_mass, alone.carried, alone.inertia, whole.push, whole.moment
    )


@kernel
def _no_rate(arm: Any) -> float:
    return 0.0


@generic
def with_locked_arms(
    arm: Any, airframe: Airframe, lengths: tuple[float, ...], thrust: tuple[float, ...]
) -> Any:
    """As `rigid_body`, by the kind of one of its arms."""
    raise TypeError(f"{type(arm).__name__} is not an arm")


@with_locked_arms.register(Arm)
@kernel
def _of_slides(
    arm: Arm, airframe: Airframe, lengths: tuple[float, ...], thrust: tuple[float, ...]
) -> OneBody:
    a = tree_sum(tree_map(_part, (airframe.arms, lengths, thrust), ()))
    inertia = airframe.inertia + arms_inertia(a.inertia)
    return OneBody(
        airframe.mass,
        airframe.inverse_mass,
        airframe.locked,
        a.carried,
        inertia,
        a.thrust,
        a.rotor_moment,
    )


@generic
def flight_rates(body: Any, guide: Any, air: Any, gravity: float, x: RigidState) -> RigidRates:
    """Rates by eq. (1), Newton–Euler about the main body, which need not be the centre of mass.

    Args:
        body: The vehicle.
        guide: `Free` or `Slider`.
        air: `Still` or `Air`.
        gravity: g along −Z [m/s²].
        x: Present motion.
    """
    raise TypeError(f"{type(body).__name__} is no body")


@flight_rates.register(OneBody)
@kernel
def _rates_in_plane(
    body: OneBody, guide: Any, air: Any, gravity: float, x: RigidState
) -> RigidRates:
    r, omega = rotation(x.attitude), x.angular_velocity
    velocity = x.velocity @ r
    blown = aerodynamics(air, velocity, r, body.thrust)
    turning = omega ^ body.carried
    force = Vec(0.0, 0.0, body.thrust) + blown.force - (omega ^ turning)
    moment = body.rotor_moment - (omega ^ (body.inertia @ omega))
    still = Vec(0.0, 0.0, 0.0)
    system = System(body.mass, still, body.inverse, body.carried, body.inertia, force, moment)
    solved = solve(guide, system, r, gravity)
    acceleration = r @ solved.linear - Vec(0.0, 0.0, gravity)
    power = body.thrust * velocity.z + body.rotor_moment @ omega
    rate = RigidState(
        x.velocity,
        quaternion_rate(x.attitude, omega),
        acceleration,
        solved.angular,
        power,
        blown.loss,
    )
    return RigidRates(rate, solved.linear, x.velocity + r @ (turning * body.inverse_mass))


# -- arms on joints, and rotors that a vehicle lists -----------------------------------------------


class LeaningBody(NamedTuple):
    """A vehicle with its arms locked, whose thrust need not be along body z."""

    mass: float  # m [kg]
    inverse_mass: float  # 1/m [1/kg]
    carried: Vec  # s = Σ m_j r_j [kg m]
    inertia: Mat3  # J about the main body's centre of mass, body axes [kg m²]
    push: Vec  # thrust of all rotors, body axes [N]
    rotor_moment: Vec  # body axes [N m]


class _JointPart(NamedTuple):
    """Contribution of one arm locked on its joint."""

    carried: Vec
    inertia: Mat3
    push: Vec
    rotor_moment: Vec


@kernel
def _part_on_joint(arm: JointedArm, length: float, thrust: float) -> _JointPart:
    there = joint_pose(arm, length, 0.0)
    up = thrust_direction(arm, there)
    push = thrust * up
    moment = (there.end ^ push) + (thrust * arm.torque_ratio) * up
    return _JointPart(arm.mass * there.end, point_inertia(arm.mass, there.end), push, moment)


@with_locked_arms.register(JointedArm)
@kernel
def _of_joints(
    arm: JointedArm, airframe: Airframe, lengths: tuple[float, ...], thrust: tuple[float, ...]
) -> LeaningBody:
    a = tree_sum(tree_map(_part_on_joint, (airframe.arms, lengths, thrust), ()))
    return LeaningBody(
        airframe.mass, airframe.inverse_mass, a.carried, airframe.inertia + a.inertia, a.push,
        a.rotor_moment,
    )  # fmt: skip


@kernel
def _part_on_two(arm: BentArm, length: Any, thrust: float) -> _JointPart:
    there = bent_pose(arm, length, 0.0)
    up = bent_thrust_direction(arm, there)
    push = thrust * up
    moment = (there.end ^ push) + (thrust * arm.torque_ratio) * up
    return _JointPart(arm.mass * there.end, point_inertia(arm.mass, there.end), push, moment)


@with_locked_arms.register(BentArm)
@kernel
def _of_two_joints(
    arm: BentArm, airframe: Airframe, lengths: tuple[Any, ...], thrust: tuple[float, ...]
) -> LeaningBody:
    a = tree_sum(tree_map(_part_on_two, (airframe.arms, lengths, thrust), ()))
    return LeaningBody(
        airframe.mass, airframe.inverse_mass, a.carried, airframe.inertia + a.inertia, a.push,
        a.rotor_moment,
    )  # fmt: skip


@flight_rates.register(LeaningBody)
@kernel
def _rates_in_space(
    body: LeaningBody, guide: Any, air: Any, gravity: float, x: RigidState
) -> RigidRates:
    r, omega = rotation(x.attitude), x.angular_velocity
    velocity = x.velocity @ r
    blown = aerodynamics(air, velocity, r, body.push.z)
    turning = omega ^ body.carried
    force = body.push + blown.force - (omega ^ turning)
    moment = body.rotor_moment - (omega ^ (body.inertia @ omega))
    system = SpatialSystem(
        isotropic(body.mass), -1.0 * skew(body.carried), body.inertia, force, moment
    )
    solved = solve(guide, system, r, gravity)
    acceleration = r @ solved.linear - Vec(0.0, 0.0, gravity)
    power = body.push @ velocity + body.rotor_moment @ omega
    rate = RigidState(
        x.velocity,
        quaternion_rate(x.attitude, omega),
        acceleration,
        solved.angular,
        power,
        blown.loss,
    )
    return RigidRates(rate, solved.linear, x.velocity + r @ (turning * body.inverse_mass))

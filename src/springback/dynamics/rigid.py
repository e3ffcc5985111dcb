"""A vehicle whose arms stand still and whose cages touch nothing: one rigid body, eq. (1).

The same motion as `springback.dynamics.motion.rates` with locked arms and no obstacle near, with
everything left out that is then zero: mass, first moment and inertia stand still, too.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.dynamics.air import aerodynamics
from springback.dynamics.motion import System, planar_product, solve
from springback.kernels.compiler import kernel
from springback.kernels.trees import along, each, total
from springback.kernels.vectors import Mat, Quat, Vec, quaternion_rate, rotation
from springback.vehicle.state import Airframe, Arm, arm_direction, arms_inertia


class OneBody(NamedTuple):
    """A vehicle with its arms locked, and the thrust that acts on it."""

    mass: float  # m [kg]
    carried: Vec  # s = Σ m_j r_j [kg m]
    inertia: Mat  # J about the main body's centre of mass, body axes [kg m²]
    thrust: float  # collective [N]
    rotor_moment: Vec  # body axes [N m]


class Flight(NamedTuple):
    """Where one body is, how it moves, and the work done on it."""

    position: Vec  # of the main body, world [m]
    attitude: Quat
    velocity: Vec  # world [m/s]
    angular_velocity: Vec  # body [rad/s]
    thrust_work: float  # put in by the rotors [J]
    air_work: float  # taken by the air [J]


class FlightRates(NamedTuple):
    """Rate of change of a `Flight`, and what an instant looks like."""

    flight: Flight
    specific_force: Vec  # a' = Rᵀ(v̇ + g e_Z) of the main body, body [m/s²]
    mass_centre_velocity: Vec  # world [m/s]


class _Part(NamedTuple):
    """What one locked arm adds."""

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
def as_one_body(
    airframe: Airframe, lengths: tuple[float, ...], thrust: tuple[float, ...]
) -> OneBody:
    """A vehicle with its arms locked at some lengths [m], under rotor thrusts [N]."""
    a = total(each(_part, (airframe.arms, lengths, thrust), ()))
    inertia = airframe.inertia + arms_inertia(a.inertia)
    return OneBody(airframe.mass, a.carried, inertia, a.thrust, a.rotor_moment)


@kernel
def flight_rates(body: OneBody, guide: Any, air: Any, gravity: float, x: Flight) -> FlightRates:
    """Eq. (1), Newton–Euler about the main body, which need not be the centre of mass.

    Args:
        body: The vehicle.
        guide: `Free` or `Slider`.
        air: `Still` or `Air`.
        gravity: g along −Z [m/s²].
        x: Present motion.
    """
    r, omega = rotation(x.attitude), x.angular_velocity
    velocity = x.velocity @ r
    blown = aerodynamics(air, velocity, r, body.thrust)
    turning = omega ^ body.carried
    force = Vec(0.0, 0.0, body.thrust) + blown.force - (omega ^ turning)
    moment = body.rotor_moment - (omega ^ (body.inertia @ omega))
    still = Vec(0.0, 0.0, 0.0)
    system = System(body.mass, still, body.carried, body.inertia, force, moment)
    solved = solve(guide, system, r, gravity)
    acceleration = r @ solved.linear - Vec(0.0, 0.0, gravity)
    power = body.thrust * velocity.z + body.rotor_moment @ omega
    rate = Flight(
        x.velocity,
        quaternion_rate(x.attitude, omega),
        acceleration,
        solved.angular,
        power,
        blown.loss,
    )
    return FlightRates(rate, solved.linear, x.velocity + r @ (turning * (1.0 / body.mass)))


@kernel
def flown_on(
    body: OneBody, guide: Any, air: Any, gravity: float, x: Flight, first: Flight, h: float
) -> Flight:
    """One classical Runge–Kutta step; the attitude is not normalised.

    Args:
        body: The vehicle.
        guide: `Free` or `Slider`.
        air: `Still` or `Air`.
        gravity: g along −Z [m/s²].
        x: Motion at the start of the step.
        first: Its rate, from `flight_rates`.
        h: Step [s].
    """
    second = flight_rates(body, guide, air, gravity, along(x, first, 0.5 * h)).flight
    third = flight_rates(body, guide, air, gravity, along(x, second, 0.5 * h)).flight
    fourth = flight_rates(body, guide, air, gravity, along(x, third, h)).flight
    rate = along(along(along(first, second, 2.0), third, 2.0), fourth, 1.0)
    return along(x, rate, h / 6.0)

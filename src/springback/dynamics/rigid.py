"""Flight with locked arms and without contact: one rigid body, eq. (1).

The same motion as `springback.dynamics.motion.rates` with locked arms and no obstacle near, without
the terms that are then zero: mass, first moment and inertia are constant.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.dynamics.air import Still
from springback.dynamics.limbs.locked import (
    OneBody,
    RigidRates,
    RigidState,
    flight_rates,
)
from springback.dynamics.limbs.locked import rigid_body as rigid_body
from springback.dynamics.motion import Free
from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import axpy
from springback.kernels.vectors import (
    Mat3,
    Quat,
    Vec,
    inverse_symmetric,
    quaternion_rate,
    renormalise,
    rotation,
)


class RigidStep(NamedTuple):
    """One step of a `RigidState`."""

    known: RigidRates  # at its start
    flight: RigidState  # at its end; the attitude is normalised


@generic
def rigid_step(
    guide: Any, air: Any, body: Any, gravity: float, x: RigidState, h: float
) -> RigidStep:
    """One classical Runge–Kutta step.

    Args:
        guide: `Free` or `Slider`.
        air: `Still` or `Air`.
        body: The vehicle.
        gravity: g along −Z [m/s²].
        x: Motion at the start of the step.
        h: Step [s].
    """
    return runge_kutta_step(guide, air, body, gravity, x, h)


@kernel
def runge_kutta_step(
    guide: Any, air: Any, body: Any, gravity: float, x: RigidState, h: float
) -> RigidStep:
    """One step of all integrated quantities under any load; arguments as for `rigid_step`."""
    return driven_step(guide, air, (body, body, body), gravity, x, h)


@kernel
def driven_step(
    guide: Any,
    air: Any,
    bodies: tuple[Any, Any, Any],
    gravity: float,
    x: RigidState,
    h: float,
) -> RigidStep:
    """`runge_kutta_step` with the vehicle of its beginning, its middle and its end."""
    begin, middle, end = bodies
    first = flight_rates(begin, guide, air, gravity, x)
    second = flight_rates(middle, guide, air, gravity, axpy(x, first.flight, 0.5 * h)).flight
    third = flight_rates(middle, guide, air, gravity, axpy(x, second, 0.5 * h)).flight
    fourth = flight_rates(end, guide, air, gravity, axpy(x, third, h)).flight
    rate = axpy(axpy(axpy(first.flight, second, 2.0), third, 2.0), fourth, 1.0)
    new = axpy(x, rate, h / 6.0)
    after = RigidState(
        new.position, renormalise(new.attitude), new.velocity, new.angular_velocity,
        new.thrust_work, new.air_work,
    )  # fmt: skip
    return RigidStep(first, after)


@rigid_step.register(Free)
@kernel
def _flown_freely(
    guide: Free, air: Any, body: Any, gravity: float, x: RigidState, h: float
) -> RigidStep:
    return free_step(air, guide, body, gravity, x, h)


@generic
def free_step(
    air: Any, guide: Free, body: Any, gravity: float, x: RigidState, h: float
) -> RigidStep:
    """Step as by `rigid_step`, for a vehicle without constraint."""
    return runge_kutta_step(guide, air, body, gravity, x, h)


class _Turning(NamedTuple):
    """Attitude of a body and its angular velocity."""

    attitude: Quat
    angular_velocity: Vec


class _Driven(NamedTuple):
    """Loads on a body about its centre of mass, in its own axes."""

    inertia: Mat3  # [kg m²]
    inverse: Mat3
    moment: Vec  # of the rotors [N m]
    thrust: float  # collective [N]


class _Stage(NamedTuple):
    """Rates at one stage of a step, about the centre of mass."""

    turning: _Turning
    up: Vec  # body z axis, world: direction of the thrust
    power: float  # of the rotors [W]


@kernel
def _stage(by: _Driven, x: _Turning, velocity: Vec) -> _Stage:
    q, omega = x.attitude, x.angular_velocity
    up = Vec(
        2.0 * (q.x * q.z + q.w * q.y),
        2.0 * (q.y * q.z - q.w * q.x),
        1.0 - 2.0 * (q.x * q.x + q.y * q.y),
    )
    angular = by.inverse @ (by.moment - (omega ^ (by.inertia @ omega)))
    power = by.thrust * (velocity @ up) + by.moment @ omega
    return _Stage(_Turning(quaternion_rate(q, omega), angular), up, power)


@free_step.register(Still)
@kernel
def _freely_in_still_air(
    air: Still, guide: Free, body: Any, gravity: float, x: RigidState, h: float
) -> RigidStep:
    return still_step(body, guide, air, gravity, x, h)


@generic
def still_step(
    body: Any, guide: Free, air: Still, gravity: float, x: RigidState, h: float
) -> RigidStep:
    """Step as by `rigid_step`, without constraint and in still air."""
    return runge_kutta_step(guide, air, body, gravity, x, h)


@still_step.register(OneBody)
@kernel
def _about_mass_centre(
    body: OneBody, guide: Free, air: Still, gravity: float, x: RigidState, h: float
) -> RigidStep:
    """The same step about the centre of mass, where rotation and translation decouple.

    Thrust and moment are constant in body axes over a step, and gravity acts at the centre of mass:
    of a stage only the attitude, the angular velocity and, for the rotors' work, the velocity
    matter.  Quantities that do not act on others are summed once, by the same Runge–Kutta formula.
    """
    omega, half, sixth = x.angular_velocity, 0.5 * h, h / 6.0
    c, lift = body.carried * body.inverse_mass, body.thrust * body.inverse_mass
    inertia = about_mass_centre(body)
    moment = body.rotor_moment - Vec(c.y * body.thrust, -c.x * body.thrust, 0.0)
    by = _Driven(inertia, inverse_symmetric(inertia), moment, body.thrust)
    r, swing, down = rotation(x.attitude), omega ^ c, Vec(0.0, 0.0, gravity)

    v, now = x.velocity + r @ swing, _Turning(x.attitude, omega)
    first = _stage(by, now, v)
    a1 = first.up * lift - down
    second = _stage(by, axpy(now, first.turning, half), v + a1 * half)
    a2 = second.up * lift - down
    third = _stage(by, axpy(now, second.turning, half), v + a2 * half)
    a3 = third.up * lift - down
    fourth = _stage(by, axpy(now, third.turning, h), v + a3 * h)
    a4 = fourth.up * lift - down

    turning = axpy(axpy(first.turning, second.turning, 2.0), third.turning, 2.0)
    end = axpy(now, axpy(turning, fourth.turning, 1.0), sixth)
    q, spin = renormalise(end.attitude), end.angular_velocity
    after, between = rotation(q), a2 + a3
    work = sixth * (first.power + 2.0 * (second.power + third.power) + fourth.power)
    new = RigidState(
        x.position + h * (v + (a1 + between) * sixth) + (r @ c - after @ c),
        q,
        v + (a1 + 2.0 * between + a4) * sixth - after @ (spin ^ c),
        spin,
        x.thrust_work + work,
        x.air_work,
    )
    alpha = first.turning.angular_velocity
    felt = Vec(0.0, 0.0, lift) - (alpha ^ c) - (omega ^ swing)
    rate = RigidState(x.velocity, first.turning.attitude, r @ felt - down, alpha, first.power, 0.0)
    return RigidStep(RigidRates(rate, felt, v), new)


@kernel
def about_mass_centre(body: OneBody) -> Mat3:
    """Inertia about the centre of mass, body axes [kg m²] (Steiner)."""
    s, j = body.carried, body.inertia
    n = body.inverse_mass
    xx, yy, xy = n * s.x * s.x, n * s.y * s.y, n * s.x * s.y
    upper = Vec(j.x.x - yy, j.x.y + xy, j.x.z)
    return Mat3(upper, Vec(upper.y, j.y.y - xx, j.y.z), Vec(j.x.z, j.y.z, j.z.z - (xx + yy)))

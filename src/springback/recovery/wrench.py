"""Observer of the external wrench: force and moment on the robot besides rotors and gravity.

Source: Tomić, Ott and Haddadin, "External wrench estimation, collision detection, and reflex
reaction for flying robots", T-RO 2017.  The force comes from the accelerometer or from the
estimated momentum, the moment from the angular momentum; every part of the estimate follows the
truth with a lag of first order.  Here the force is in world axes, because obstacles do not turn
with the robot.

The observer also integrates force and moment to recent impulses, which decay at the same rate.
Their ratio is the lever arm of a collision, and as integrals they do not suffer from the lag; they
come from the estimated motion, which motion capture corrects when an accelerometer clips.
"""

from __future__ import annotations

from typing import NamedTuple

from springback.control.mixing import sideways_of, wrench_of
from springback.control.rate import inertia_at
from springback.control.target import Wrench
from springback.kernels.compiler import kernel
from springback.kernels.trees import fold, select, tree_map
from springback.kernels.vectors import ZERO, Mat3, Vec, rotation
from springback.sensing.measurement import Estimate, Measurement
from springback.vehicle.state import Airframe


class Observer(NamedTuple):
    """Settings of the observer."""

    mass: float  # of the whole vehicle, in the pilot's model [kg]
    gravity: float  # g [m/s²]
    interval: float  # between inertial samples [s]
    force_gain: float  # K_f [1/s]
    moment_gain: float  # K_m [1/s]
    steady_gain: float  # of the filter for the steady part, such as wind [1/s]
    rotor_share: float  # share of a command that a rotor follows within one tick
    momentum: float  # 1: force from the estimated momentum; 0: from the accelerometer
    fading: float  # decay rate of the impulses [1/s]


class RecentImpulse(NamedTuple):
    """Decaying impulses of external force and moment, without the lag of the observer."""

    impulse: Vec  # of the external force, world [N s]
    carried: Vec  # the same, each contribution in the body axes of its time [N s]
    turning: Vec  # of the external moment about the main body, body axes [N m s]
    velocity: Vec  # of the main body at the last sample, world [m/s]
    spin: Vec  # J ω at the last sample, body axes [N m s]
    steady_force: Vec  # slow part of that force, world [N]
    steady_moment: Vec  # slow part of that moment, body axes [N m]


class WrenchInputs(NamedTuple):
    """Inputs of the observer at a tick."""

    airframe: Airframe  # in the pilot's model
    inertia: Mat3  # J(l) about the main body, body axes [kg m²]
    measurement: Measurement
    estimate: Estimate
    command: tuple[float, ...]  # to each rotor since the last tick [N]


class ExternalWrench(NamedTuple):
    """Estimate of the observer, and its memory."""

    force: Vec  # f̂_e, world [N]
    moment: Vec  # m̂_e about the main body, body axes [N m]
    steady: Vec  # slow part of the force, world [N]
    thrust: tuple[float, ...]  # of each rotor, by the pilot's model of its lag [N]
    force_sum: Vec  # ∫ (known forces + f̂_e) dt plus the momentum at the start [N s]
    moment_sum: Vec  # likewise [N m s]
    recent: RecentImpulse


def no_wrench(
    observer: Observer, airframe: Airframe, start: Estimate, thrust: tuple[float, ...]
) -> ExternalWrench:
    """Estimate and memory of an observer at the start, without an external wrench."""
    none, inertia = ZERO, inertia_at(airframe, tuple(arm.length for arm in airframe.arms))
    momentum, spin = start.velocity * observer.mass, inertia @ start.angular_velocity
    recent = RecentImpulse(none, none, none, start.velocity, spin, none, none)
    return ExternalWrench(none, none, none, thrust, momentum, spin, recent)


@kernel
def _lag(thrust: float, command: float, share: float) -> float:
    return thrust + share * (command - thrust)


@kernel
def _from_acceleration(
    observer: Observer, by_rotors: Vec, r: Mat3, specific_force: Vec, old: Vec
) -> Vec:
    """Force from the accelerometer: f̂' = K_f (m R a − f_T R e_z − f̂)."""
    now = (r @ specific_force) * observer.mass - by_rotors
    return old + (now - old) * (observer.force_gain * observer.interval)


@kernel
def _beside(force: Vec, sideways: Vec, r: Mat3) -> Vec:
    return force + r @ sideways


class KnownWrench(NamedTuple):
    """Known wrench of one sample, and the angular momentum."""

    force: Vec  # of rotors and gravity, world [N]
    moment: Vec  # of the rotors, and −ω × J ω, body axes [N m]
    spin: Vec  # J ω, body axes [N m s]


@kernel
def recent_impulse(
    observer: Observer, r: Mat3, velocity: Vec, known: KnownWrench, recent: RecentImpulse
) -> RecentImpulse:
    """Impulses after one more sample: Δ(m v) − known force · h, and Δ(J ω) − moment · h.

    The slow parts of force and moment are subtracted, by the same filter for both, so that their
    ratio stays right; they are taken from these very sums, because the steady part of the
    accelerometer's force contains its bias.

    Args:
        observer: Settings.
        r: Attitude.
        velocity: Estimated velocity of the main body, world [m/s].
        known: Of this sample.
        recent: Impulses before.
    """
    h, left = observer.interval, 1.0 - observer.fading * observer.interval
    push = (velocity - recent.velocity) * observer.mass - (known.force + recent.steady_force) * h
    turn = known.spin - recent.spin - (known.moment + recent.steady_moment) * h
    return RecentImpulse(
        recent.impulse * left + push,
        recent.carried * left + push @ r,
        recent.turning * left + turn,
        velocity,
        known.spin,
        recent.steady_force + push * observer.steady_gain,
        recent.steady_moment + turn * observer.steady_gain,
    )


@kernel
def sampled_wrench(
    observer: Observer, inputs: WrenchInputs, memory: ExternalWrench
) -> ExternalWrench:
    """External wrench after a tick with an inertial sample; arguments as for `wrench_after`.

    From momentum f̂ = K_f (m v − ∫ (f_T R e_z − m g e_Z + f̂) dt), and always
    m̂ = K_m (J ω − ∫ (τ − ω × J ω + m̂) dt).
    """
    measurement, at = inputs.measurement, inputs.estimate
    thrust = _thrust_after(observer, inputs.command, memory)
    given: Wrench = wrench_of(inputs.airframe, measurement.arm_length, thrust)
    r, h, k = rotation(at.attitude), observer.interval, observer.force_gain
    up = Vec(r.x.z, r.y.z, r.z.z)
    craft, lengths = inputs.airframe, measurement.arm_length
    by_rotors = fold(_beside, up * given.thrust, sideways_of(
        craft.rotors, craft.arms, lengths, thrust
    ), (r,))  # fmt: skip
    sampled = measurement.inertial.specific_force
    from_acceleration = _from_acceleration(observer, by_rotors, r, sampled, memory.force)

    known = by_rotors - Vec(0.0, 0.0, observer.mass * observer.gravity)
    force_sum = memory.force_sum + (known + memory.force) * h
    from_momentum = (at.velocity * observer.mass - force_sum) * k
    force = select(observer.momentum > 0.5, from_momentum, from_acceleration)

    omega = at.angular_velocity
    spin = inputs.inertia @ omega
    known_moment = given.moment - (omega ^ spin)
    moment_sum = memory.moment_sum + (known_moment + memory.moment) * h
    moment = (spin - moment_sum) * observer.moment_gain
    steady = memory.steady + (force - memory.steady) * (observer.steady_gain * h)
    wrench = KnownWrench(known, known_moment, spin)
    recent = recent_impulse(observer, r, at.velocity, wrench, memory.recent)
    return ExternalWrench(force, moment, steady, thrust, force_sum, moment_sum, recent)


@kernel
def _thrust_after(
    observer: Observer, command: tuple[float, ...], memory: ExternalWrench
) -> tuple[float, ...]:
    return tree_map(_lag, (memory.thrust, command), (observer.rotor_share,))


@kernel
def wrench_after(
    observer: Observer, inputs: WrenchInputs, memory: ExternalWrench
) -> ExternalWrench:
    """External wrench after a tick; between inertial samples the estimate is kept.

    Args:
        observer: Settings.
        inputs: At this tick.
        memory: `no_wrench` at the start.
    """
    m, thrust = memory, _thrust_after(observer, inputs.command, memory)
    same = ExternalWrench(m.force, m.moment, m.steady, thrust, m.force_sum, m.moment_sum, m.recent)
    now = sampled_wrench(observer, inputs, memory)
    return select(inputs.measurement.inertial.fresh > 0.5, now, same)

"""What pushes and turns the robot besides its rotors: an observer of the external wrench.

Source: Tomić, Ott and Haddadin, "External wrench estimation, collision detection, and reflex
reaction for flying robots", T-RO 2017.  The force comes from the accelerometer or from the
estimated momentum, the moment from the angular momentum; every part of the estimate follows the
truth with a lag of first order.  Here the force is in world axes, for obstacles do not turn with
the robot.

Beside the lagging estimate stand impulses: what has pushed and turned the robot lately, summed up
and fading alike.  Their ratio is the lever arm of a collision, and as a sum they need not follow
its force; they come from the estimated motion, which motion capture keeps right where an
accelerometer clips.
"""

from __future__ import annotations

from typing import NamedTuple

from springback.control.mixing import wrench_of
from springback.control.rate import inertia_at
from springback.control.target import Wrench
from springback.kernels.compiler import kernel
from springback.kernels.memo import Build, plain_build
from springback.kernels.trees import select, tree_map
from springback.kernels.vectors import ZERO, Mat3, Vec, rotation
from springback.sensing.measurement import Estimate, Measurement
from springback.vehicle.state import Airframe


class Observer(NamedTuple):
    """Settings of the observer."""

    mass: float  # of the whole vehicle, as the pilot believes [kg]
    gravity: float  # g [m/s²]
    interval: float  # between inertial samples [s]
    force_gain: float  # K_f [1/s]
    moment_gain: float  # K_m [1/s]
    steady_gain: float  # of what counts as steady, as wind does [1/s]
    rotor_share: float  # of a command that a rotor follows within one tick
    momentum: float  # 1: force from the estimated momentum; 0: from the accelerometer
    fading: float  # of the impulses [1/s]


class RecentImpulse(NamedTuple):
    """What has pushed and turned the robot lately, fading; forces as they came, not as they lag."""

    impulse: Vec  # of the external force, world [N s]
    carried: Vec  # the same, each part in the body axes of its time [N s]
    turning: Vec  # of the external moment about the main body, body axes [N m s]
    velocity: Vec  # of the main body at the last sample, world [m/s]
    spin: Vec  # J ω at the last sample, body axes [N m s]
    steady_force: Vec  # what is slow of that force, world [N]
    steady_moment: Vec  # what is slow of that moment, body axes [N m]


class ExternalWrench(NamedTuple):
    """What the observer says, and remembers."""

    force: Vec  # f̂_e, world [N]
    moment: Vec  # m̂_e about the main body, body axes [N m]
    steady: Vec  # slow part of the force, world [N]
    thrust: tuple[float, ...]  # of each rotor, as its lag is believed to be [N]
    force_sum: Vec  # ∫ (known forces + f̂_e) dt, less the momentum at the start [N s]
    moment_sum: Vec  # likewise [N m s]
    recent: RecentImpulse


def no_wrench(
    observer: Observer,
    airframe: Airframe,
    start: Estimate,
    thrust: tuple[float, ...],
    build: Build = plain_build,
) -> ExternalWrench:
    """Memory of an observer that starts with a motion and nothing pushing."""
    none, inertia = ZERO, build(_whole_inertia, airframe)
    momentum, spin = start.velocity * observer.mass, inertia @ start.angular_velocity
    recent = RecentImpulse(none, none, none, start.velocity, spin, none, none)
    return ExternalWrench(none, none, none, thrust, momentum, spin, recent)


def _whole_inertia(airframe: Airframe) -> Mat3:
    return inertia_at(airframe, tuple(arm.length for arm in airframe.arms))


@kernel
def _lagged(thrust: float, command: float, share: float) -> float:
    return thrust + share * (command - thrust)


@kernel
def _felt(observer: Observer, by_rotors: Vec, r: Mat3, specific_force: Vec, old: Vec) -> Vec:
    """Force from the accelerometer: f̂' = K_f (m R a − f_T R e_z − f̂)."""
    now = (r @ specific_force) * observer.mass - by_rotors
    return old + (now - old) * (observer.force_gain * observer.interval)


@kernel
def recent_impulse(
    observer: Observer,
    r: Mat3,
    at: Estimate,
    known: Vec,
    moment: Vec,
    spin: Vec,
    recent: RecentImpulse,
) -> RecentImpulse:
    """The impulses after one more sample: Δ(m v) − known force · h, and Δ(J ω) − moment · h.

    Less what is slow of either, by one and the same filter, lest their ratio be wrong; and of these
    very sums, for what is steady of the accelerometer holds its bias.

    Args:
        observer: Settings.
        r: Attitude.
        at: What the estimator says.
        known: Force of rotors and gravity, world [N].
        moment: Of the rotors, and −ω × J ω, body axes [N m].
        spin: J ω, body axes [N m s].
        recent: So far.
    """
    h, kept = observer.interval, 1.0 - observer.fading * observer.interval
    push = (at.velocity - recent.velocity) * observer.mass - (known + recent.steady_force) * h
    turn = spin - recent.spin - (moment + recent.steady_moment) * h
    return RecentImpulse(
        recent.impulse * kept + push,
        recent.carried * kept + push @ r,
        recent.turning * kept + turn,
        at.velocity,
        spin,
        recent.steady_force + push * observer.steady_gain,
        recent.steady_moment + turn * observer.steady_gain,
    )


@kernel
def renewed_wrench(
    observer: Observer,
    airframe: Airframe,
    inertia: Mat3,
    seen: Measurement,
    at: Estimate,
    command: tuple[float, ...],
    memory: ExternalWrench,
) -> ExternalWrench:
    """The external wrench after a tick with an inertial sample; arguments as `observed_wrench`.

    From momentum f̂ = K_f (m v − ∫ (f_T R e_z − m g e_Z + f̂) dt), and always
    m̂ = K_m (J ω − ∫ (τ − ω × J ω + m̂) dt).
    """
    thrust = _believed_thrust(observer, command, memory)
    given: Wrench = wrench_of(airframe, seen.arm_length, thrust)
    r, h, k = rotation(at.attitude), observer.interval, observer.force_gain
    up = Vec(r.x.z, r.y.z, r.z.z)
    by_rotors = up * given.thrust
    felt = _felt(observer, by_rotors, r, seen.inertial.specific_force, memory.force)

    known = by_rotors - Vec(0.0, 0.0, observer.mass * observer.gravity)
    force_sum = memory.force_sum + (known + memory.force) * h
    from_momentum = (at.velocity * observer.mass - force_sum) * k
    force = select(observer.momentum > 0.5, from_momentum, felt)

    omega = at.angular_velocity
    spin = inertia @ omega
    known_moment = given.moment - (omega ^ spin)
    moment_sum = memory.moment_sum + (known_moment + memory.moment) * h
    moment = (spin - moment_sum) * observer.moment_gain
    steady = memory.steady + (force - memory.steady) * (observer.steady_gain * h)
    recent = recent_impulse(observer, r, at, known, known_moment, spin, memory.recent)
    return ExternalWrench(force, moment, steady, thrust, force_sum, moment_sum, recent)


@kernel
def _believed_thrust(
    observer: Observer, command: tuple[float, ...], memory: ExternalWrench
) -> tuple[float, ...]:
    return tree_map(_lagged, (memory.thrust, command), (observer.rotor_share,))


@kernel
def observed_wrench(
    observer: Observer,
    airframe: Airframe,
    inertia: Mat3,
    seen: Measurement,
    at: Estimate,
    command: tuple[float, ...],
    memory: ExternalWrench,
) -> ExternalWrench:
    """The external wrench after a tick; between inertial samples the estimate stands.

    Args:
        observer: Settings.
        airframe: As the pilot believes it to be.
        inertia: J(l) about the main body, body axes [kg m²].
        seen: What the sensors say.
        at: What the estimator says.
        command: To each rotor since the last tick [N].
        memory: `no_wrench` at the start.
    """
    m, thrust = memory, _believed_thrust(observer, command, memory)
    kept = ExternalWrench(m.force, m.moment, m.steady, thrust, m.force_sum, m.moment_sum, m.recent)
    now = renewed_wrench(observer, airframe, inertia, seen, at, command, memory)
    return select(seen.inertial.fresh > 0.5, now, kept)

"""Attitude from gyroscope, gravity and external heading; position from an observer.

The attitude filter is that of the PX4 autopilot (module attitude_estimator_q), for FLU body axes
and a world with Z up: motion capture gives it the heading, and tilt comes from the direction of the
specific force, which is used only while its magnitude is near g.  Errors of the gyroscope from an
impact would therefore stay in the tilt for seconds.  Poses contain the tilt as well; by default,
each corrects a fraction of the whole attitude error, as it does of the position error.

Position and velocity come from a fading-memory filter of motion capture (E. Brookner, Tracking and
Kalman Filtering Made Easy, 1998, section 1.2.6; gains 1 − z² and (1 − z)²/T) and the measured
force.  The inertial sensor is assumed at the main body's centre of mass: an offset r causes an
error ω × r of velocity, and one of ω² r of the force.
"""

from __future__ import annotations

from typing import NamedTuple

from springback.kernels.angles import angle_of
from springback.kernels.compiler import kernel
from springback.kernels.layout import TreeLayout, load, store
from springback.kernels.trees import select
from springback.kernels.vectors import (
    ZERO,
    Quat,
    Vec,
    conjugate,
    exponential_map,
    norm,
    normalise,
    positive_part,
    quaternion_product,
    renormalise,
    rotation,
    small_angle_map,
)
from springback.sensing.measurement import (
    Estimate,
    EstimatorStep,
    Inertial,
    Measurement,
    Pose,
    believe,
    update,
)
from springback.simulation.ticks import Lanes

#: Above this rate of rotation the bias is not updated [rad/s] (PX4, attitude_estimator_q).
SLOW_SPIN = 0.175
#: The force's direction is used while its magnitude is within these multiples of g (PX4).
LEAST_FORCE, MOST_FORCE = 0.9, 1.1
#: A heading older than this is no longer used [s] (PX4: half a second).
HEADING_TIMEOUT = 0.5


class Complementary(NamedTuple):
    """Settings of the filter; see `springback.sensing.estimation.ComplementarySettings`."""

    tick: float  # [s]
    interval: float  # between inertial samples [s]
    gravity: float  # g along −Z [m/s²]
    accelerometer_weight: float  # [1/s]
    heading_weight: float  # [1/s]
    bias_weight: float  # [1/s]
    largest_bias: float  # of each axis [rad/s]
    decay: float  # of the position filter in a tick, exp(−bandwidth Δt)
    whole: float  # 1: poses correct the whole attitude; 0: the heading only


class ComplementaryMemory(NamedTuple):
    """Memory of the filter."""

    position: Vec  # world [m]
    velocity: Vec  # world [m/s]
    attitude: Quat  # body to world
    gyroscope_bias: Vec  # body [rad/s]
    angular_velocity: Vec  # body, bias subtracted [rad/s]
    heading_error: float  # of the last pose: measured minus estimated [rad]
    waiting: float  # time since the last inertial sample [s]
    unposed: float  # time since the last pose [s]
    faded: float  # z = exp(−bandwidth T) for that time T


def complementary_memory(complementary: Complementary, estimate: Estimate) -> ComplementaryMemory:
    """Memory of a filter that starts from a known state."""
    return ComplementaryMemory(
        position=estimate.position,
        velocity=estimate.velocity,
        attitude=estimate.attitude,
        gyroscope_bias=ZERO,
        angular_velocity=estimate.angular_velocity,
        heading_error=0.0,
        waiting=0.0,
        unposed=0.0,
        faded=1.0,
    )


@update.register(Complementary)
@kernel
def _complementary(
    weights: Complementary, tick: float, seen: Measurement, memory: ComplementaryMemory
) -> EstimatorStep:
    memory = _moved_on(weights, seen.inertial, memory)
    memory = select(seen.pose.fresh > 0.5, _correct(weights, seen.pose, memory), memory)
    return EstimatorStep(_at_tick(memory), memory)


@believe.register(Complementary)
@kernel
def _believe(
    estimator: TreeLayout,
    seen: TreeLayout,
    memory: TreeLayout,
    estimate: TreeLayout,
    ticks: TreeLayout,
    lanes: Lanes,
) -> None:
    """Batch version of `_complementary`, step by step; poses are processed where one is fresh."""
    _, g, w, once, _ = lanes
    posed, waiting = 0, 0
    for i in range(w * once):
        posed += 1 if load(seen.pose.fresh, g, w, i) > 0.5 else 0
        waiting += 0 if load(seen.inertial.fresh, g, w, i) > 0.5 else 1
    for i in range(w * once if waiting == 0 else 0):  # all lanes, so without a mask
        weights, m = load(estimator, g, w, i), load(memory, g, w, i)
        sample = load(seen.inertial, g, w, i)
        store(_integrate(weights, sample, _older(weights, m)), memory, g, w, i)
    for i in range(w * once if waiting > 0 else 0):
        weights, m = load(estimator, g, w, i), load(memory, g, w, i)
        store(_moved_on(weights, load(seen.inertial, g, w, i), m), memory, g, w, i)
    for i in range(w * once if posed > 0 else 0):
        weights, m, pose = load(estimator, g, w, i), load(memory, g, w, i), load(seen.pose, g, w, i)
        store(select(pose.fresh > 0.5, _correct(weights, pose, m), m), memory, g, w, i)
    for i in range(w * once if waiting == 0 else 0):  # all lanes, without an empty rotation
        m = load(memory, g, w, i)
        now = Estimate(m.position, m.attitude, m.velocity, m.angular_velocity)
        store(now, estimate, g, w, i)
    for i in range(w * once if waiting > 0 else 0):
        store(_at_tick(load(memory, g, w, i)), estimate, g, w, i)


@kernel
def _moved_on(
    weights: Complementary, inertial: Inertial, m: ComplementaryMemory
) -> ComplementaryMemory:
    """Memory one tick later, with an inertial sample where there is one."""
    older = _older(weights, m)
    return select(inertial.fresh > 0.5, _integrate(weights, inertial, older), older)


@kernel
def _at_tick(m: ComplementaryMemory) -> Estimate:
    """Estimate, extrapolated from the last inertial sample at constant rates."""
    q = quaternion_product(m.attitude, small_angle_map(m.waiting * m.angular_velocity))
    position = m.position + m.waiting * m.velocity
    return Estimate(position, q, m.velocity, m.angular_velocity)


@kernel
def _older(weights: Complementary, m: ComplementaryMemory) -> ComplementaryMemory:
    """Memory aged by one tick."""
    return ComplementaryMemory(
        m.position,
        m.velocity,
        m.attitude,
        m.gyroscope_bias,
        m.angular_velocity,
        m.heading_error,
        m.waiting + weights.tick,
        m.unposed + weights.tick,
        m.faded * weights.decay,
    )


@kernel
def _attitude_correction(weights: Complementary, force: Vec, m: ComplementaryMemory) -> Vec:
    """Rate that turns the estimate towards external heading and measured vertical [rad/s].

    W_EXT_HDG Rᵀ (0, 0, ψ_m − ψ) + W_ACC f/|f| × Rᵀ e_Z, body axes (PX4, attitude_estimator_q).
    """
    up = rotation(m.attitude).z
    magnitude = norm(force)
    g = weights.gravity
    near_g = (LEAST_FORCE * g < magnitude) & (magnitude < MOST_FORCE * g)
    trust = weights.accelerometer_weight / select(near_g, magnitude, 1.0) * select(near_g, 1.0, 0.0)
    recent = m.unposed < HEADING_TIMEOUT
    turn = weights.heading_weight * m.heading_error if recent else 0.0
    return turn * up + (trust * force ^ up)


@kernel
def _clamp(x: float, limit: float) -> float:
    """Clamp x to ± limit."""
    low = x if x > -limit else -limit
    return low if low < limit else limit


@kernel
def _bias(weights: Complementary, spin: Vec, turn: Vec, m: ComplementaryMemory) -> Vec:
    """Gyroscope bias, learnt from persistent corrections at slow rotation only."""
    slow = spin @ spin < SLOW_SPIN * SLOW_SPIN
    learnt = weights.bias_weight * weights.interval if slow else 0.0
    b, limit = m.gyroscope_bias - learnt * turn, weights.largest_bias
    return Vec(_clamp(b.x, limit), _clamp(b.y, limit), _clamp(b.z, limit))


@kernel
def _integrate(
    weights: Complementary, inertial: Inertial, m: ComplementaryMemory
) -> ComplementaryMemory:
    """Memory after one inertial sample: q̇ = ½ q ⊗ (ω + correction), v̇ = R f − g e_Z."""
    dt = weights.interval
    turn = _attitude_correction(weights, inertial.specific_force, m)
    bias = _bias(weights, inertial.angular_velocity, turn, m)
    omega = inertial.angular_velocity - bias
    half = small_angle_map((0.5 * dt) * (omega + turn))
    middle = quaternion_product(m.attitude, half)
    force = rotation(middle) @ inertial.specific_force
    acceleration = force - Vec(0.0, 0.0, weights.gravity)
    return ComplementaryMemory(
        position=m.position + dt * m.velocity + (0.5 * dt * dt) * acceleration,
        velocity=m.velocity + dt * acceleration,
        attitude=renormalise(quaternion_product(middle, half)),
        gyroscope_bias=bias,
        angular_velocity=omega,
        heading_error=m.heading_error,
        waiting=0.0,
        unposed=m.unposed,
        faded=m.faded,
    )


@kernel
def _heading_error(measured: Quat, believed: Quat) -> float:
    """Measured minus estimated heading [rad]: error of the estimated north in the world."""
    north = rotation(believed) @ rotation(measured).x
    return -angle_of(north.y, north.x)


@kernel
def _missing_turn(believed: Quat, measured: Quat) -> Vec:
    """Small rotation from estimated to measured, 2 sgn(w) (x, y, z) of q⁻¹ ⊗ q_m [rad]."""
    e = quaternion_product(conjugate(believed), measured)
    twice = select(e.w < 0.0, -2.0, 2.0)
    return Vec(twice * e.x, twice * e.y, twice * e.z)


@kernel
def _correct(weights: Complementary, pose: Pose, m: ComplementaryMemory) -> ComplementaryMemory:
    """Memory after a pose, compared with the estimate extrapolated back by the pose's age."""
    age = positive_part(pose.age - m.waiting)
    then = quaternion_product(m.attitude, exponential_map(-age * m.angular_velocity))
    missed = pose.position - (m.position - age * m.velocity)
    z = m.faded
    missing = _missing_turn(then, pose.attitude)
    whole = exponential_map(missing * (weights.whole * (1.0 - z * z)))
    return ComplementaryMemory(
        position=m.position + (1.0 - z * z) * missed,
        velocity=m.velocity + ((1.0 - z) * (1.0 - z) / m.unposed) * missed,
        attitude=normalise(quaternion_product(m.attitude, whole)),
        gyroscope_bias=m.gyroscope_bias,
        angular_velocity=m.angular_velocity,
        heading_error=_heading_error(pose.attitude, then),
        waiting=m.waiting,
        unposed=0.0,
        faded=1.0,
    )

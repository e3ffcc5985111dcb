"""Inertial navigation corrected by motion capture: an error-state Kalman filter.

The filter estimates the motion of the inertial sensor, whose measured specific force applies
exactly there, and reports that of the main body: with the offset r of the sensor from it, p = p_s −
R r and v = v_s − R (ω × r).  So no angular acceleration needs to be derived from rates.

A pose from motion capture arrives late.  The filter saves its estimate at each exposure of the
cameras until the pose arrives, and compares there; corrections apply to the saved poses as well.
A delay thus causes no bias, not even during the acceleration of an impact.

Source: J. Solà, Quaternion kinematics for the error-state Kalman filter, arXiv 1711.02508, with
rotation errors in body axes: sections 5.4 (prediction), 6.1 (correction), 6.2 (injection). The
reset's Jacobian of section 6.3 is taken as the identity, as the source allows: it differs by half
the correction of the rotation, some 1e-3.
"""

from __future__ import annotations

from springback.kernels.compiler import kernel
from springback.kernels.tree_code import Rarely
from springback.kernels.trees import maximum
from springback.kernels.vectors import (
    Quat,
    Vec,
    exponential_map,
    normalise,
    quaternion_product,
    rotation,
    skew,
    transpose,
)
from springback.sensing.kalman.correction import with_pose
from springback.sensing.kalman.covariance import Noise, Transition, propagate
from springback.sensing.kalman.memory import (
    ROUNDING,
    Deviations,
    Kalman,
    KalmanMemory,
    Known,
    Nominal,
    PoseWindow,
    StoredPose,
    Track,
    empty_window,
    exposed_before,
    kalman_memory,
)
from springback.sensing.measurement import (
    Estimate,
    EstimatorStep,
    Inertial,
    Measurement,
    estimator_step,
)

__all__ = ["Deviations", "Kalman", "KalmanMemory", "kalman_memory"]

#: A reading above this fraction of its range may be clipped (chosen: a low-pass behind the
#: converter rounds the top of a clipped peak).
AT_RANGE = 0.9


@estimator_step.register(Kalman)
@kernel
def _kalman(kalman: Kalman, tick: float, seen: Measurement, memory: KalmanMemory) -> EstimatorStep:
    track = memory.track
    if seen.inertial.fresh > 0.5:
        track = _integrate(kalman, tick, seen.inertial, track)
    else:
        track = _wait(kalman, track)
    after = KalmanMemory(track, Rarely(0.0, memory.known.tree))
    posed = seen.pose.fresh > 0.5
    if posed or track.window.duration > (kalman.every - 0.5) * kalman.interval:
        after = _predict(kalman, after)
        if posed:
            after = with_pose(kalman, tick, seen.pose, after.track, after.known.tree.covariance)
    return EstimatorStep(_estimate(kalman, after.track), after)


@kernel
def _estimate(kalman: Kalman, track: Track) -> Estimate:
    """Present motion of the main body: the last, delayed sample extrapolated at constant rates."""
    n, omega, a = track.nominal, track.angular_velocity, track.acceleration
    ahead = track.waiting + kalman.inertial_lag
    q = quaternion_product(n.attitude, exponential_map(ahead * omega))
    r = rotation(q)
    position = n.position + ahead * n.velocity + (0.5 * ahead * ahead) * a
    velocity = n.velocity + ahead * a
    return Estimate(position - r @ kalman.offset, q, velocity - r @ (omega ^ kalman.offset), omega)


@kernel
def _wait(kalman: Kalman, track: Track) -> Track:
    """Track after a tick without an inertial sample."""
    return Track(
        track.nominal,
        track.angular_velocity,
        track.acceleration,
        track.window,
        track.stored,
        track.waiting + kalman.tick,
    )


@kernel
def _begin(track: Track) -> Track:
    """Track with a new, empty window."""
    return Track(
        track.nominal,
        track.angular_velocity,
        track.acceleration,
        empty_window(track.nominal.attitude),
        track.stored,
        track.waiting,
    )


@kernel
def _at_range(reading: Vec, limit: float) -> bool:
    """True if a reading is at its range."""
    return maximum((abs(reading.x), abs(reading.y), abs(reading.z))) > AT_RANGE * limit


@kernel
def _stored_poses(
    kalman: Kalman,
    tick: float,
    n: Nominal,
    omega: Vec,
    acceleration: Vec,
    stored: tuple[StoredPose, ...],
) -> tuple[StoredPose, ...]:
    """Saved poses after a sample, with a new one if the cameras exposed during it.

    The pose at the exposure is extrapolated back from the sample, at constant rate and
    acceleration.
    """
    since = exposed_before(kalman, tick)
    if since < (1.0 - ROUNDING) * kalman.interval:
        position = n.position - since * n.velocity + (0.5 * since * since) * acceleration
        attitude = quaternion_product(n.attitude, exponential_map(-since * omega))
        return (StoredPose(position, attitude), *stored[:-1])
    return stored


@kernel
def _integrate(kalman: Kalman, tick: float, inertial: Inertial, track: Track) -> Track:
    """Track after an inertial sample (section 5.4.1), with the force rotated at its midpoint.

    A sample is the mean over the interval that ends with it.
    """
    n, window, dt = track.nominal, track.window, kalman.interval
    omega = inertial.angular_velocity - n.gyroscope_bias
    half = exponential_map((0.5 * dt) * omega)
    middle = quaternion_product(n.attitude, half)
    force = rotation(middle) @ (inertial.specific_force - n.accelerometer_bias)
    acceleration = force - Vec(0.0, 0.0, kalman.gravity)
    position = n.position + dt * n.velocity + (0.5 * dt * dt) * acceleration
    attitude = normalise(quaternion_product(middle, half))
    clipped = dt if _at_range(inertial.specific_force, kalman.accelerometer_range) else 0.0
    spun = dt if _at_range(inertial.angular_velocity, kalman.gyroscope_range) else 0.0
    velocity = n.velocity + dt * acceleration
    after = Nominal(position, velocity, attitude, n.accelerometer_bias, n.gyroscope_bias)
    return Track(
        nominal=after,
        angular_velocity=omega,
        acceleration=acceleration,
        window=PoseWindow(
            window.duration + dt,
            window.gained + dt * force,
            window.attitude,
            window.clipped + clipped,
            window.spun + spun,
        ),
        stored=_stored_poses(kalman, tick, after, omega, acceleration, track.stored),
        waiting=0.0,
    )


@kernel
def _transition(window: PoseWindow, attitude: Quat) -> Transition:
    """Transition F over a window that ends with an attitude."""
    before, after = rotation(window.attitude), rotation(attitude)
    return Transition(
        duration=window.duration,
        vt=skew(window.gained) @ before * -1.0,
        va=(before + after) * (-0.5 * window.duration),
        tt=transpose(after) @ before,
    )


@kernel
def _noise(kalman: Kalman, window: PoseWindow) -> Noise:
    """Noise Q over a window: a one-sided density N, as in data sheets, adds a variance ½ N² T.

    (Its power N² f/2 per sample at the rate f, times f T samples of 1/f² each.)  A bias with a
    random walk of density K adds K² T.

    While a reading is at its range the true value may be anywhere beyond.  The variance then grows
    by range² τ per time: as if the range itself were missing, over a clipping that lasts τ.
    """
    a, w, duration = kalman.accelerometer_noise, kalman.gyroscope_noise, window.duration
    missing = kalman.accelerometer_range * kalman.accelerometer_range * kalman.distrust
    unturned = kalman.gyroscope_range * kalman.gyroscope_range * kalman.distrust
    return Noise(
        velocity=0.5 * a * a * duration + missing * window.clipped,
        rotation=0.5 * w * w * duration + unturned * window.spun,
        accelerometer_bias=kalman.accelerometer_walk * kalman.accelerometer_walk * duration,
        gyroscope_bias=kalman.gyroscope_walk * kalman.gyroscope_walk * duration,
    )


@kernel
def _predict(kalman: Kalman, m: KalmanMemory) -> KalmanMemory:
    """Memory with the covariance propagated to the last sample, and a new window."""
    track, known = m.track, m.known.tree
    transition = _transition(track.window, track.nominal.attitude)
    covariance = propagate(known.covariance, transition, _noise(kalman, track.window))
    return KalmanMemory(_begin(track), Rarely(1.0, Known(covariance, known.innovation)))

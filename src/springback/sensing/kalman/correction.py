"""Correction of the Kalman filter by a pose from motion capture taken some time ago."""

from __future__ import annotations

from typing import NamedTuple

from springback.kernels.compiler import kernel
from springback.kernels.tree_code import Rarely
from springback.kernels.trees import axpy, minimum, tree_map, tree_sum
from springback.kernels.vectors import (
    Mat3,
    Quat,
    Vec,
    conjugate,
    exponential_map,
    inverse_symmetric,
    isotropic,
    normalise,
    positive_part,
    quaternion_product,
    rotation,
    rotation_vector,
    skew,
    transpose,
)
from springback.sensing.kalman.covariance import (
    Column,
    Covariance,
    correct,
    correction,
    times,
    with_gyroscope_bias,
    with_position,
    with_rotation,
    with_velocity,
)
from springback.sensing.kalman.memory import (
    Innovation,
    Kalman,
    KalmanMemory,
    Known,
    Nominal,
    StoredPose,
    Track,
    empty_window,
    exposed_before,
)
from springback.sensing.measurement import Pose


@kernel
def _scale(stored: StoredPose, weight: float) -> StoredPose:
    """A saved pose times a weight."""
    q = stored.attitude
    return StoredPose(
        weight * stored.position, Quat(weight * q.w, weight * q.x, weight * q.y, weight * q.z)
    )


@kernel
def _share(stored: StoredPose, delay: float, lag: float, interval: float) -> StoredPose:
    """A saved pose times its weight in linear interpolation at a lag."""
    return _scale(stored, positive_part(1.0 - abs(lag - delay) / interval))


@kernel
def _stored_pose_at(kalman: Kalman, track: Track, since: float, lag: float) -> StoredPose:
    """Present estimate of the pose at some time before the last sample.

    At an exposure this is the pose saved there.  Elsewhere, such as where motion capture is faster
    than the inertial samples, it is interpolated linearly.

    Args:
        kalman: Settings of the filter.
        track: Track of the filter.
        since: Time from the newest saved pose to the last sample [s].
        lag: Time before the last sample, not beyond the oldest saved pose [s].
    """
    stored = tree_map(_share, (track.stored, kalman.delays), (lag - since, kalman.pose_interval))
    pose = tree_sum(stored)
    if lag < since:
        n, share = track.nominal, lag / since
        now = _scale(StoredPose(n.position, n.attitude), 1.0 - share)
        pose = tree_sum((now, _scale(track.stored[0], share)))
    return StoredPose(pose.position, normalise(pose.attitude))


@kernel
def _inject(n: Nominal, seen: Column, weighed: Vec) -> Nominal:
    """Add the correction δx = K z to the estimate (section 6.2)."""
    d = correction(seen, weighed)
    return Nominal(
        n.position + d.p,
        n.velocity + d.v,
        normalise(quaternion_product(n.attitude, exponential_map(d.t))),
        n.accelerometer_bias + d.a,
        n.gyroscope_bias + d.w,
    )


@kernel
def _shift(
    stored: StoredPose, delay: float, since: float, before: Nominal, after: Nominal
) -> StoredPose:
    """Correct a saved pose as the last sample: at its time, δp − t δv, and the rotation.

    Its time t before the last sample is its delay relative to the newest saved pose, plus the age
    of that one.
    """
    shift = after.position - before.position - (since + delay) * (after.velocity - before.velocity)
    turn = quaternion_product(after.attitude, conjugate(before.attitude))
    return StoredPose(stored.position + shift, quaternion_product(turn, stored.attitude))


class _Correction(NamedTuple):
    """A filter after a correction."""

    nominal: Nominal
    covariance: Covariance
    innovation: float


@kernel
def _with_position(
    kalman: Kalman, pose: Pose, lag: float, then: StoredPose, n: Nominal, c: Covariance
) -> _Correction:
    """Correct by the position of the main body some time ago.

    z = p_m − (p_s − R r) at that time, and its error is δp − t δv + R [r]× δθ there.
    """
    r = rotation(then.attitude)
    z = pose.position - (then.position - r @ kalman.offset)
    lever = r @ skew(kalman.offset) @ (transpose(r) @ rotation(n.attitude))
    position = axpy(with_position(c), with_velocity(c), -lag)
    seen = axpy(position, times(with_rotation(c), transpose(lever)), 1.0)
    variance = isotropic(kalman.position_noise * kalman.position_noise)
    s = seen.p - lag * seen.v + lever @ seen.t + variance
    return _correct(n, c, seen, s, z)


@kernel
def _with_attitude(
    kalman: Kalman, pose: Pose, lag: float, then: StoredPose, n: Nominal, c: Covariance
) -> _Correction:
    """Correct by the attitude some time ago.

    z = log(q⁻¹ ⊗ q_m) at that time, rotated to the present body axes; its error is δθ + t δw.
    """
    turn = rotation_vector(quaternion_product(conjugate(then.attitude), pose.attitude))
    z = (rotation(then.attitude) @ turn) @ rotation(n.attitude)
    seen = axpy(with_rotation(c), with_gyroscope_bias(c), lag)
    variance = isotropic(kalman.attitude_noise * kalman.attitude_noise)
    return _correct(n, c, seen, seen.t + lag * seen.w + variance, z)


@kernel
def _correct(n: Nominal, c: Covariance, seen: Column, s: Mat3, z: Vec) -> _Correction:
    """Correct by an innovation z with covariance S, given P Hᵀ (section 6.1)."""
    inverse = inverse_symmetric(s)
    weighed = inverse @ z
    return _Correction(_inject(n, seen, weighed), correct(c, seen, inverse), z @ weighed)


@kernel
def with_pose(kalman: Kalman, tick: float, pose: Pose, track: Track, c: Covariance) -> KalmanMemory:
    """Memory of the filter after a pose: first its position, then its attitude.

    Args:
        kalman: Settings of the filter.
        tick: Number of the tick.
        pose: The pose.
        track: Track of the filter, its window empty.
        c: Covariance, at the last inertial sample.
    """
    before = track.nominal
    late = positive_part(pose.age - track.waiting - kalman.inertial_lag)
    since = exposed_before(kalman, tick - track.waiting / kalman.tick)
    lag = minimum((late, since + kalman.delays[-1]))
    then = _stored_pose_at(kalman, track, since, lag)
    first = _with_position(kalman, pose, lag, then, before, c)
    then = _shift(then, lag, 0.0, before, first.nominal)
    second = _with_attitude(kalman, pose, lag, then, first.nominal, first.covariance)
    after = second.nominal
    corrected_track = Track(
        nominal=after,
        angular_velocity=track.angular_velocity + before.gyroscope_bias - after.gyroscope_bias,
        acceleration=track.acceleration,
        window=empty_window(after.attitude),
        stored=tree_map(_shift, (track.stored, kalman.delays), (since, before, after)),
        waiting=track.waiting,
    )
    known = Known(second.covariance, Innovation(first.innovation, second.innovation))
    return KalmanMemory(corrected_track, Rarely(1.0, known))

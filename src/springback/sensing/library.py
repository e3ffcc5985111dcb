"""Estimators of the literature, each number with its source."""

from __future__ import annotations

from springback.sensing.estimation import EstimatorSettings, KalmanSettings

#: PX4's EKF2 in its default configuration.  It trusts external poses far less than a camera system
#: deserves, and so relies on the accelerometer through an impact.
PX4_EKF2 = EstimatorSettings(
    type="kalman",
    kalman=KalmanSettings(
        position_noise=0.1, attitude_noise=0.05, inflation=24.0, distrust_clipped=False
    ),
)

ESTIMATORS = {"px4-ekf2": PX4_EKF2}

SOURCES = {
    "px4-ekf2": {
        "type": "chosen: springback's error-state Kalman filter, with the noise that EKF2 assumes",
        "kalman.position_noise": "given: EKF2_EVP_NOISE, 0.1 m, PX4-Autopilot, "
        "src/modules/ekf2, all versions",
        "kalman.attitude_noise": "given: EKF2_EVA_NOISE, 0.05 rad in earlier versions, "
        "0.1 rad in later",
        "kalman.inflation": "derived: EKF2_ACC_NOISE, 0.35 m/s^2 at a step of 10 ms, is 24 times "
        "the data sheet's density if both are read as two-sided, 34 times if the data sheet's is "
        "one-sided; EKF2_GYR_NOISE, 0.015 rad/s, 14 or 20 times (docs/decisions/0018)",
        "kalman.distrust_clipped": "given: earlier versions of EKF2 do not model clipping; later "
        "ones assume 4.9 m/s^2 while a sample is clipped (docs/decisions/0018)",
    }
}

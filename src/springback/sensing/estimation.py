"""Estimators: validated user input, converted to the numbers of the filters."""

from __future__ import annotations

import math
from typing import Annotated, Literal

from pydantic import Field, model_validator

from springback.kernels.vectors import Vec
from springback.quantities import Duration, Factor, Length, Triple, Unit
from springback.sensing.complementary import (
    Complementary,
    ComplementaryMemory,
    complementary_memory,
)
from springback.sensing.kalman.filter import Deviations, Kalman, KalmanMemory, kalman_memory
from springback.sensing.kalman.memory import ROUNDING
from springback.sensing.measurement import Estimate
from springback.sensing.perfect import PerfectMemory, PerfectState
from springback.settings import Settings, problem
from springback.user_code import Arguments, CodeName

#: Standard gravity [m/s²], the g of data sheets (3rd CGPM, 1901).
STANDARD_GRAVITY = 9.80665

#: Most poses that the filter remembers, chosen: sensors need five.
MOST_POSES = 64

Estimator = PerfectState | Kalman | Complementary
Memory = PerfectMemory | KalmanMemory | ComplementaryMemory


class Rhythm(Settings):
    """Timing of the sensors of an estimator."""

    tick: Duration
    """Tick of the clock."""
    interval: Duration
    """Time between inertial samples."""
    pose_age: Annotated[float, Unit("s", least=0.0)] = 0.0
    """Upper bound on the age of a pose when it arrives; older poses are treated as this old."""
    pose_interval: Duration | None = None
    """Time between exposures of motion capture, one of them at tick 0; None if unknown."""


class KalmanSettings(Settings):
    """Assumptions of the Kalman filter about its sensors.

    Densities are one-sided, as in data sheets.  Noise densities are multiplied by `inflation`.
    """

    accelerometer_noise: Annotated[float, Unit("m/s^2/Hz^0.5", above=0.0)] = (
        150e-6 * STANDARD_GRAVITY
    )
    """Data sheet TDK DS-000143 (ICM-20689): 150 µg/√Hz."""
    gyroscope_noise: Annotated[float, Unit("rad/s/Hz^0.5", above=0.0)] = math.radians(0.006)
    """The same data sheet: 0.006 °/s/√Hz."""
    inflation: Factor = 10.0
    """Ratio of assumed noise to that of a data sheet at rest: vibration, scale factors, filters.

    Chosen.  PX4's EKF2 assumes 0.35 m/s² and 0.015 rad/s for a step of about 10 ms, some 24 and 14
    times the data sheet.
    """
    accelerometer_walk: Annotated[float, Unit("m/s^3/Hz^0.5", least=0.0)] = 3e-3
    """Random walk of the bias; the unit of the EuRoC data set (Burri et al., IJRR 2016)."""
    gyroscope_walk: Annotated[float, Unit("rad/s^2/Hz^0.5", least=0.0)] = 1.9393e-5
    """Random walk of the bias; the same source."""
    accelerometer_range: Annotated[float, Unit("m/s^2", above=0.0)] = 16.0 * STANDARD_GRAVITY
    """ICM-20689: ±16 g."""
    gyroscope_range: Annotated[float, Unit("rad/s", above=0.0)] = math.radians(2000.0)
    """ICM-20689: ±2000 °/s."""
    distrust_clipped: bool = True
    """Assume more noise while a reading is at its range, so that poses soon correct the loss.

    The clipped part is missing from the estimate in any case.
    """
    clipping: Duration = 0.01
    """Duration of clipping that loses as much as the range; chosen, the order of an impact."""
    inertial_lag: Annotated[float, Unit("s")] = 5e-4
    """Delay of inertial samples: (1 − s)/s ticks for a low-pass with coefficient s.

    176 Hz at 1 kHz (s = 0.67), the ICM-20689's gyroscope: 0.49 ms.  0 without a low-pass; minus
    half a sample if rates are those at the end of the sample.
    """
    offset: Annotated[Triple, Unit("m")] = (0.0, 0.0, 0.0)
    """Position of the inertial sensor from the main body's centre of mass, body axes."""
    every: Annotated[int, Field(ge=1, strict=True)] = 5
    """Inertial samples per prediction of the covariance: 200 Hz at 1 kHz, the rate of the poses;
    chosen.
    """
    position_noise: Length = 2e-4
    """Standard deviation of motion capture along each axis; chosen, a common camera system."""
    attitude_noise: Annotated[float, Unit("rad", above=0.0)] = math.radians(0.1)
    """Standard deviation of motion capture about each axis; chosen likewise."""
    initial_position: Annotated[float, Unit("m", least=0.0)] = 1e-3
    """Standard deviation at the start; chosen, as are those below."""
    initial_velocity: Annotated[float, Unit("m/s", least=0.0)] = 0.01
    initial_attitude: Annotated[float, Unit("rad", least=0.0)] = math.radians(0.5)
    initial_accelerometer_bias: Annotated[float, Unit("m/s^2", least=0.0)] = 0.05
    initial_gyroscope_bias: Annotated[float, Unit("rad/s", least=0.0)] = math.radians(0.1)

    def estimator(self, rhythm: Rhythm, gravity: float) -> Kalman:
        """Settings of the filter; gravity is g along −Z [m/s²].

        Raises:
            The problem, if a lag far from a sample asks for more than `MOST_POSES` past poses.
        """
        spacing = max(rhythm.pose_interval or 0.0, rhythm.interval)
        late = max(rhythm.pose_age - self.inertial_lag, 0.0) / spacing
        if late >= MOST_POSES - 1:
            least = rhythm.pose_age - (MOST_POSES - 1) * spacing
            raise problem(
                f"must be above {least:.6g} s with poses {spacing:.6g} s apart "
                f"(got {self.inertial_lag:.6g} s)",
                "kalman.inertial_lag",
            )
        # Poses that are not all saved at their own time are interpolated, which needs an older one.
        all_stored = spacing == rhythm.pose_interval
        reach = math.floor(late + ROUNDING) if all_stored else math.ceil(late - ROUNDING)
        return Kalman(
            tick=rhythm.tick,
            interval=rhythm.interval,
            inertial_lag=self.inertial_lag,
            every=float(self.every),
            pose_interval=spacing,
            pose_phase=0.0,
            delays=tuple(k * spacing for k in range(reach + 1)),
            gravity=gravity,
            offset=Vec(*self.offset),
            accelerometer_noise=self.inflation * self.accelerometer_noise,
            gyroscope_noise=self.inflation * self.gyroscope_noise,
            accelerometer_walk=self.accelerometer_walk,
            gyroscope_walk=self.gyroscope_walk,
            accelerometer_range=self.accelerometer_range,
            gyroscope_range=self.gyroscope_range,
            distrust=self.clipping if self.distrust_clipped else 0.0,
            position_noise=self.position_noise,
            attitude_noise=self.attitude_noise,
        )

    def deviations(self) -> Deviations:
        """Standard deviations of the errors at the start."""
        return Deviations(
            position=self.initial_position,
            velocity=self.initial_velocity,
            attitude=self.initial_attitude,
            accelerometer_bias=self.initial_accelerometer_bias,
            gyroscope_bias=self.initial_gyroscope_bias,
        )


class ComplementarySettings(Settings):
    """Weights of the complementary filter: the defaults of PX4's attitude_estimator_q."""

    accelerometer_weight: Annotated[float, Unit("1/s", least=0.0)] = 0.2
    """ATT_W_ACC."""
    heading_weight: Annotated[float, Unit("1/s", least=0.0)] = 0.1
    """ATT_W_EXT_HDG, with the heading of motion capture."""
    bias_weight: Annotated[float, Unit("1/s", least=0.0)] = 0.1
    """ATT_W_GYRO_BIAS."""
    largest_bias: Annotated[float, Unit("rad/s", least=0.0)] = 0.05
    """ATT_BIAS_MAX, of each axis."""
    bandwidth: Annotated[float, Unit("1/s", above=0.0)] = 20.0
    """Bandwidth of the corrections by motion capture; chosen: an error halves in about 50 ms."""
    attitude: Literal["pose", "heading"] = "pose"
    """Attitude from motion capture: all of it, with the same bandwidth, or as in PX4 the heading
    only; tilt is then wrong for seconds after an impact.
    """

    def estimator(self, rhythm: Rhythm, gravity: float) -> Complementary:
        """Settings of the filter; gravity is g along −Z [m/s²]."""
        return Complementary(
            tick=rhythm.tick,
            interval=rhythm.interval,
            gravity=gravity,
            accelerometer_weight=self.accelerometer_weight,
            heading_weight=self.heading_weight,
            bias_weight=self.bias_weight,
            largest_bias=self.largest_bias,
            decay=math.exp(-self.bandwidth * rhythm.tick),
            whole=1.0 if self.attitude == "pose" else 0.0,
        )


class EstimatorSettings(Settings):
    """Estimator of a robot's own motion."""

    type: Literal["kalman", "complementary", "perfect", "own"] = "kalman"
    """`perfect` uses the exact state, which the sensors must reveal; `own` is one of your own."""
    kalman: KalmanSettings = KalmanSettings()
    complementary: ComplementarySettings = ComplementarySettings()
    code: CodeName | None = None
    """``FILE.py:NAME`` of a `CompiledEstimator`, or of a function that returns one."""
    parameters: Arguments = Field(default_factory=dict)
    """Arguments of that function, in SI."""

    @model_validator(mode="after")
    def _has_code(self) -> EstimatorSettings:
        if self.type == "own" and self.code is None:
            raise problem("is missing: FILE.py:NAME of your estimator", "code")
        if self.type != "own" and (self.code is not None or self.parameters):
            raise problem(f'must be "own" for an estimator of your own (got "{self.type}")', "type")
        return self

    def estimator(self, rhythm: Rhythm, gravity: float) -> Estimator:
        """Settings of the chosen estimator, one of springback's.

        Args:
            rhythm: Timing of its sensors.
            gravity: g along −Z [m/s²].
        """
        if self.type == "kalman":
            return self.kalman.estimator(rhythm, gravity)
        if self.type == "complementary":
            return self.complementary.estimator(rhythm, gravity)
        return PerfectState(0.0)

    def memory(self, estimator: Estimator, start: Estimate) -> Memory:
        """Memory of an estimator at the start, which it knows."""
        if isinstance(estimator, Kalman):
            return kalman_memory(estimator, start, self.kalman.deviations())
        if isinstance(estimator, Complementary):
            return complementary_memory(estimator, start)
        return PerfectMemory(0.0)

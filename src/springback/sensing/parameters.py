"""Sensors: validated user input, checked against the clock, converted to numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from statistics import NormalDist
from typing import Annotated, Any

import numpy as np
from pydantic import Field, model_validator

from springback.kernels.tracing import traceable  # for batch set-up
from springback.kernels.vectors import Vec
from springback.quantities import Length, Triple, Unit
from springback.sensing.clock import inside, lateness, period
from springback.sensing.hall import (
    HallSensors,
    Magnet,
    PerfectArmLengths,
    Span,
    axial_field,
    slope,
)
from springback.sensing.inertial import Channel, InertialUnit, PerfectInertial, per_tick
from springback.sensing.measurement import task_pace
from springback.sensing.motion_capture import MotionCapture, PerfectMotionCapture
from springback.sensing.sensors import Sensors
from springback.settings import Settings, naming, problem
from springback.vehicle.parameters import Vehicle

#: Standard gravity [m/s²], the g of data sheets (3rd CGPM, 1901).
STANDARD_GRAVITY = 9.80665
#: Quantile for a probability of zero or one, instead of infinity: probability 1e-350.
IMPOSSIBLE = -40.0
#: Normal numbers for a flight's sensor biases: three axes of accelerometer and gyroscope.
BIASES = 6

Rate = Annotated[float, Unit("Hz", above=0.0)]
Delay = Annotated[float, Unit("s", least=0.0)]


def _quantile(probability: float) -> float:
    """Finite quantile Φ⁻¹ of a probability."""
    if not 0.0 < probability < 1.0:
        return IMPOSSIBLE if probability <= 0.0 else -IMPOSSIBLE
    return min(max(NormalDist().inv_cdf(probability), IMPOSSIBLE), -IMPOSSIBLE)


class MotionCaptureSettings(Settings):
    """Motion capture.

    Rate: the paper, section IV-A.  The rest is chosen: noise and delay of a common system of
    infrared cameras with a radio link behind it, and no gaps.
    """

    perfect: bool = False
    """Exact, at every tick, without delay; everything below is then unused."""
    rate: Rate = 200.0
    delay: Delay = 0.01
    position_noise: Annotated[float, Unit("m", least=0.0)] = 2e-4
    """Standard deviation of each axis."""
    attitude_noise: Annotated[float, Unit("rad", least=0.0)] = math.radians(0.1)
    """Standard deviation of each component of a small rotation vector."""
    loss_probability: Annotated[float, Unit("", least=0.0, most=1.0)] = 0.0
    """Probability that a gap starts at the next sample."""
    loss_length: Annotated[float, Unit("", least=1.0)] = 10.0
    """Mean length of a gap in samples; the distribution is geometric."""

    def device(self, tick: float) -> MotionCapture | PerfectMotionCapture:
        """Settings of the device, for a tick of given duration [s].

        Raises:
            The problem, if the rate or the delay does not fit the clock.
        """
        if self.perfect:
            return PerfectMotionCapture(0.0)
        with naming("rate"):
            every = period(self.rate, tick)
        with naming("delay"):
            delay = lateness(self.delay, every, tick)
        return MotionCapture(
            every=task_pace(every),
            delay=delay,
            position_noise=self.position_noise,
            attitude_noise=self.attitude_noise,
            loss=_quantile(self.loss_probability),
            recovery=_quantile(1.0 / self.loss_length),
        )


class ChannelSettings(Settings):
    """Three axes of an accelerometer [m/s²] or a gyroscope [rad/s]."""

    full_scale: float
    noise: float
    """Density of the white noise, one-sided [unit/√Hz]."""
    bandwidth: Rate
    """3 dB corner of the low-pass, here of first order."""
    bias: float
    """Standard deviation of the bias of each axis, from flight to flight."""
    walk: float
    """Random walk of the bias [unit/s/√Hz]."""
    bits: Annotated[int, Field(ge=2, le=32, strict=True)] = 16

    def channel(self, tick: float, normal: Vec) -> Channel:
        """Settings of the channel.

        Args:
            tick: Duration of a tick [s].
            normal: Standard normal numbers for this flight's bias.
        """
        numbers = per_tick(self.noise, self.walk, self.bandwidth, tick)
        return Channel(
            noise=numbers.noise,
            bias=self.bias * normal,
            drift=numbers.drift,
            full_scale=self.full_scale,
            smoothing=numbers.smoothing,
            step=2.0 * self.full_scale / 2**self.bits,
        )


class AccelerometerSettings(ChannelSettings):
    """Accelerometer of the ICM-20689 in the flight controller that the paper names.

    Data sheet TDK DS-000143: range, 150 µg/√Hz, 16 bits, 218.1 Hz the widest filter at 1 kHz.  The
    bias that remains after calibration is chosen.  The data sheet gives no random walk: it is that
    of the unit in the EuRoC data set (Burri et al., International Journal of Robotics Research,
    2016).
    """

    full_scale: Annotated[float, Unit("m/s^2", above=0.0)] = 16.0 * STANDARD_GRAVITY
    noise: Annotated[float, Unit("m/s^2/Hz^0.5", least=0.0)] = 150e-6 * STANDARD_GRAVITY
    bandwidth: Rate = 218.1
    bias: Annotated[float, Unit("m/s^2", least=0.0)] = 0.05
    walk: Annotated[float, Unit("m/s^3/Hz^0.5", least=0.0)] = 3e-3


class GyroscopeSettings(ChannelSettings):
    """Gyroscope of the ICM-20689; sources as for the accelerometer.

    Data sheet TDK DS-000143: range, 0.006 °/s/√Hz, 16 bits, 176 Hz at 1 kHz.
    """

    full_scale: Annotated[float, Unit("rad/s", above=0.0)] = math.radians(2000.0)
    noise: Annotated[float, Unit("rad/s/Hz^0.5", least=0.0)] = math.radians(0.006)
    bandwidth: Rate = 176.0
    bias: Annotated[float, Unit("rad/s", least=0.0)] = math.radians(0.1)
    walk: Annotated[float, Unit("rad/s^2/Hz^0.5", least=0.0)] = 1.9393e-5


class InertialSettings(Settings):
    """Accelerometer and gyroscope."""

    perfect: bool = False
    """No noise, bias, range or filter; only the offset below is then used."""
    rate: Rate = 1000.0
    """Rate of its output; conversion and filter run at every tick of the clock."""
    offset: Annotated[Triple, Unit("m")] = (0.0, 0.0, 0.0)
    """Position of the sensor from the main body's centre of mass, body axes."""
    accelerometer: AccelerometerSettings = AccelerometerSettings()
    gyroscope: GyroscopeSettings = GyroscopeSettings()

    def device(self, tick: float, normals: tuple[Vec, Vec]) -> InertialUnit | PerfectInertial:
        """Settings of the device.

        Args:
            tick: Duration of a tick [s].
            normals: Standard normal numbers for the biases of accelerometer and gyroscope.

        Raises:
            The problem, if the rate does not fit the clock.
        """
        offset = Vec(*self.offset)
        if self.perfect:
            return PerfectInertial(offset)
        with naming("rate"):
            every = period(self.rate, tick)
        return InertialUnit(
            offset,
            task_pace(every),
            self.accelerometer.channel(tick, normals[0]),
            self.gyroscope.channel(tick, normals[1]),
        )


class HallSettings(Settings):
    """Hall-effect sensors of the arms, read by a small microcontroller.

    The paper names the sensor, Allegro A1302, and the converter, Arduino Nano.  Data sheet A1301-DS
    at 5 V: 1.3 mV/G, 2.5 V without a field, outputs from 0.2 V to 4.7 V, 150 µV noise up to 10 kHz.
    Converter: 10 bits of the supply (ATmega328P).  The paper gives neither magnet nor distances nor
    rates: these are chosen: a neodymium disc (grade N42) of 15 mm by 8 mm, 11 g, as close as the
    sensor allows without saturation; samples at 200 Hz, one period late through a serial link.

    One count of the converter is then 0.018 mm at the free length, 0.12 mm at 10 mm of compression,
    0.49 mm at 20 mm and 6.5 mm at the end of a stroke of 50 mm; the error of a length is at most
    half a count.  For an arm that opens beyond its free length, a second magnet and sensor read
    that side in the same way.
    """

    perfect: bool = False
    """Exact, at every tick, without delay; everything below is then unused."""
    rate: Rate = 200.0
    delay: Delay = 0.005
    remanence: Annotated[float, Unit("T", above=0.0)] = 1.3
    magnet_radius: Length = 7.5e-3
    magnet_thickness: Length = 8e-3
    distance: Length = 8e-3
    """Distance from the magnet's face to the sensor at the arm's free length."""
    overrun: Annotated[float, Unit("m", least=0.0)] = 2e-3
    """Extension of the calibration beyond both ends of the stroke; chosen."""
    way: Length = 0.05
    """Longest travel of the magnet of a hinged arm: if the arm's end moves farther, the magnet is
    that much nearer to the hinge; chosen, the stroke of the paper's arms."""
    sensitivity: Annotated[float, Unit("V/T", above=0.0)] = 13.0
    supply: Annotated[float, Unit("V", above=0.0)] = 5.0
    quiescent: Annotated[float, Unit("V", above=0.0)] = 2.5
    lowest: Annotated[float, Unit("V", least=0.0)] = 0.2
    highest: Annotated[float, Unit("V", above=0.0)] = 4.7
    noise: Annotated[float, Unit("V", least=0.0)] = 150e-6
    """Standard deviation at each sample."""
    bits: Annotated[int, Field(ge=2, le=32, strict=True)] = 10

    @model_validator(mode="after")
    def _readable(self) -> HallSettings:
        if not self.distance > self.overrun:
            raise problem(
                f"must be more than the overrun, {self.overrun:g} m (got {self.distance:g} m)",
                "distance",
            )
        field = traceable(axial_field)(self.magnet(), self.distance)
        strongest = self.quiescent + self.sensitivity * field
        if not strongest < self.highest:
            raise problem(
                f"of {self.distance:g} m saturates the sensor: {strongest:.3g} V at the free "
                f"length, above its limit of {self.highest:g} V; increase the distance",
                "distance",
            )
        return self

    def magnet(self) -> Magnet:
        """Settings of the magnet."""
        return Magnet(self.remanence, self.magnet_radius, self.magnet_thickness)

    def device(self, tick: float, vehicle: Vehicle) -> HallSensors | PerfectArmLengths:
        """Settings of the device, for a tick of given duration [s] and the arms of a vehicle.

        Raises:
            The problem, if the rate or the delay does not fit the clock.
        """
        if self.perfect:
            return PerfectArmLengths(0.0)
        with naming("rate"):
            every = period(self.rate, tick)
        with naming("delay"):
            delay = lateness(self.delay, every, tick)
        spans, hinged = [], vehicle.arms.hinges[:1] == (True,)
        for j, free in enumerate(vehicle.lengths()):
            low, high = vehicle.arms.travel(j)
            most = max(float(vehicle.arms.at("stroke", j)), high)
            share = min(1.0, self.way / max(high, -low)) if hinged else 1.0
            spans.append(Span(
                free, free - most - self.overrun, free - low + self.overrun,
                1.0 if low < 0.0 else 0.0, share,
            ))  # fmt: skip
        sensors = HallSensors(
            magnet=self.magnet(),
            distance=self.distance,
            sensitivity=self.sensitivity,
            quiescent=self.quiescent,
            lowest=self.lowest,
            highest=self.highest,
            noise=self.noise,
            supply=self.supply,
            counts=float(2**self.bits),
            every=task_pace(every),
            delay=delay,
            beyond=self.overrun,
            spans=tuple(spans),
        )
        for j, span in enumerate(spans, start=1):
            if not slope(sensors, span.share * (span.free - span.shortest)) < 0.0:
                raise problem(
                    f"leaves an output that does not change with the length of arm {j} where it is "
                    f"shortest, {span.shortest:g} m, so that it cannot be calibrated; check the "
                    f"magnet and the stroke as well (got {self.distance:g} m)",
                    "distance",
                )
        return sensors


class SensorSettings(Settings):
    """All sensors of a robot."""

    motion_capture: MotionCaptureSettings = MotionCaptureSettings()
    imu: InertialSettings = InertialSettings()
    hall: HallSettings = HallSettings()
    reveal: bool = False
    """Add the exact state to the measurement, for perfect estimators."""

    def sensors(self, tick: float, vehicle: Vehicle, generator: np.random.Generator) -> Sensors:
        """Settings of one flight.

        Six numbers are drawn from the generator regardless of the settings.

        Args:
            tick: Duration of a tick of the clock [s].
            vehicle: The vehicle with its arms.
            generator: Generator of this flight's biases.

        Raises:
            The problem, if a rate or a delay does not fit the clock.
        """
        normals = generator.standard_normal(BIASES).tolist()
        return self.switched_on(self.devices(tick, vehicle), normals)

    def devices(self, tick: float, vehicle: Vehicle) -> Sensors:
        """Settings common to all flights, with zero biases; see `sensors`."""
        still = Vec(0.0, 0.0, 0.0)
        with inside("motion_capture"):
            motion_capture: Any = self.motion_capture.device(tick)
        with inside("imu"):
            inertial: Any = self.imu.device(tick, (still, still))
        with inside("hall"):
            arm_length: Any = self.hall.device(tick, vehicle)
        return Sensors(motion_capture, inertial, arm_length, 1.0 if self.reveal else 0.0)

    def switched_on(self, devices: Sensors, normals: Sequence[float]) -> Sensors:
        """The devices with the biases of one flight, from standard normal numbers for each axis."""
        if self.imu.perfect:
            return devices
        a, unit, imu = normals, devices.inertial, self.imu
        biased = InertialUnit(
            unit.offset,
            unit.every,
            unit.accelerometer._replace(bias=imu.accelerometer.bias * Vec(a[0], a[1], a[2])),
            unit.gyroscope._replace(bias=imu.gyroscope.bias * Vec(a[3], a[4], a[5])),
        )
        return Sensors(devices.motion_capture, biased, devices.arm_length, devices.reveal)

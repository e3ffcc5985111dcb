"""What a simulated vehicle's sensors gave, as a recording."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from springback.errors import InputError
from springback.logs.reading import LogOptions, read_recording
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ARM_LENGTH,
    AT_END,
    ATTITUDE,
    POSITION,
    ROTOR_COMMAND,
    SPECIFIC_FORCE,
    Array,
    LogChannel,
    Recording,
    SensorChain,
    log_channel,
)
from springback.results.result import FlightResult
from springback.results.saved import is_result, load
from springback.sensing.hall import HallSensors, ends
from springback.sensing.parameters import HallSettings

#: Name of the clocks: on board, and of the motion capture, which share their zero here.
ONBOARD, CAPTURE = "log", "motion capture"
#: Rounding of a length at the end of a sensor's range [m] (chosen).
ROUNDING = 1e-9


def log_or_flight(path: Path, options: LogOptions) -> Recording:
    """Recording of a log, or of what the sensors of a saved flight gave.

    Args:
        path: Of a log, or of a folder that `springback fly` wrote.
        options: Part and axes.

    Raises:
        InputError: If it cannot be read.
    """
    if is_result(path):
        return flight_recording(load(path), path).within(options.part())
    return read_recording(path, options)


def flight_recording(flight: FlightResult, path: Path) -> Recording:
    """Recording of a flight: accelerometer, gyroscope, motion capture, arm lengths, commands.

    Args:
        flight: With telemetry, of a pilot or of its sensors.
        path: Where it is from, for messages.

    Raises:
        InputError: If it has no readings of sensors.
    """
    told = flight.telemetry
    if "imu_ax" not in told:
        raise InputError(
            f"{path}: has no readings of sensors; give the scenario a table [sensors], such as "
            "[sensors.imu], and fly it again"
        )
    sensors, where = flight.scenario.sensors, str(path)
    channels: list[LogChannel] = []
    fresh = told["imu_fresh"] > 0.0
    at = told["t"][fresh]
    imu = sensors.imu
    for name, quantity, stem, part in (
        ("accelerometer", SPECIFIC_FORCE, "imu_a", imu.accelerometer),
        ("gyroscope", ANGULAR_VELOCITY, "imu_w", imu.gyroscope),
    ):
        values = _columns(told, stem, "xyz")[fresh]
        chain, clipped = SensorChain(note="simulated"), None
        if not imu.perfect:
            chain = SensorChain(
                full_scale=part.full_scale, low_pass=part.bandwidth, note="simulated"
            )
            clipped = np.abs(values) >= AT_END * part.full_scale
        channels.append(
            log_channel(where, name, quantity, at, values, clipped=clipped, chain=chain)
        )
    channels += _poses(where, told)
    names = sorted(name for name in told if name.startswith("hall"))
    if names:
        rows, at = _hall_samples(told["t"], sensors.hall)
        values = np.stack([told[name] for name in names], axis=1)[rows]
        chain, clipped = SensorChain(note="simulated"), _arms_at_ends(flight, values)
        channels.append(log_channel(
            where, "arm lengths", ARM_LENGTH, at, values, chain=chain, clipped=clipped
        ))  # fmt: skip
    propulsion = flight.scenario.vehicle.propulsion
    if flight.is_piloted and propulsion is not None:
        names = sorted(name for name in told if name.startswith("command"))
        values = np.stack([told[name] for name in names], axis=1) / propulsion.max_thrust
        channels.append(log_channel(where, "commands", ROTOR_COMMAND, told["t"], values))
    about = {"name": flight.scenario.name, "made by": "springback, simulated"}
    return Recording(path, "springback", tuple(channels), parameters=about)


def _hall_samples(ticks: Array, hall: HallSettings) -> tuple[Any, Array]:
    """Ticks at which new arm lengths came, and the instants [s] at which they were measured."""
    if hall.perfect or len(ticks) < 2:
        return np.arange(len(ticks)), ticks
    tick = float(ticks[1] - ticks[0])
    every, late = max(1, round(1.0 / (hall.rate * tick))), round(hall.delay / tick)
    rows = np.arange(late, len(ticks), every)
    return rows, np.round(ticks[rows] - late * tick, 9)


def _arms_at_ends(flight: FlightResult, lengths: Array) -> Any:
    """True for lengths at the end of what a sensor can tell, shape as given; None for all."""
    scenario = flight.scenario
    device = scenario.sensors.devices(1.0 / scenario.clock, scenario.vehicle).arm_length
    if not isinstance(device, HallSensors):
        return None
    low, high = np.array([ends(device, span) for span in device.spans]).T
    return (lengths <= low + ROUNDING) | (lengths >= high - ROUNDING)


def _columns(told: dict[str, Array], stem: str, axes: str) -> Array:
    return np.stack([told[f"{stem}{axis}"] for axis in axes], axis=1)


def _poses(where: str, told: dict[str, Array]) -> list[LogChannel]:
    """Poses of the motion capture, at the instants that they are of."""
    if "pose_x" not in told:
        return []
    fresh = told["pose_fresh"] > 0.0
    if not fresh.any():
        return []
    at: Any = (told["t"] - told["pose_age"])[fresh]
    at = np.round(at, 9)  # differences of ticks
    chain = SensorChain(note="simulated")
    return [
        log_channel(
            where, f"vehicle.{name}", quantity, at, _columns(told, stem, axes)[fresh],
            clock=CAPTURE, chain=chain,
        )
        for name, quantity, stem, axes in (
            ("position", POSITION, "pose_", "xyz"), ("attitude", ATTITUDE, "pose_q", "wxyz"),
        )
    ]  # fmt: skip

"""Errors of a pilot's estimate, and velocity lost to accelerometer clipping."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError
from springback.results.flight import Flight

Array = np.ndarray[Any, np.dtype[np.float64]]


class EstimateErrors(NamedTuple):
    """Errors of the estimate, each of shape (ticks,)."""

    time: Array  # [s]
    position: Array  # length of the error [m]
    velocity: Array  # length of the error [m/s]
    attitude: Array  # angle between the two [rad]


def _ticks(flight: Flight) -> Array:
    """Instants of the ticks [s]; without a pilot, those of the clock."""
    if not flight.columns:
        raise InputError("the flight has no trajectory")
    if "t" in flight.telemetry:
        return flight.telemetry["t"]
    clock = float(flight.scenario.clock)
    return np.arange(int(flight.columns["t"][-1] * clock) + 1) / clock


def _at_ticks(flight: Flight, names: tuple[str, ...]) -> Array:
    """Columns of the trajectory at the ticks, shape (ticks, names)."""
    c, ticks = flight.columns, _ticks(flight)
    return np.stack([np.interp(ticks, c["t"], c[name]) for name in names], axis=1)


def estimate_errors(flight: Flight) -> EstimateErrors:
    """Errors of the estimate at every tick of a flight.

    Raises:
        InputError: If the trajectory was not recorded, or there is no estimate.
    """
    if "est_x" not in flight.telemetry:
        raise InputError("the flight has no trajectory, or no estimate was made")
    names = ("x", "y", "z"), ("vx", "vy", "vz"), ("qw", "qx", "qy", "qz")
    truth = [_at_ticks(flight, group) for group in names]
    believed = [
        np.stack([flight.telemetry[f"est_{name}"] for name in group], axis=1) for group in names
    ]
    q = truth[2] / np.linalg.norm(truth[2], axis=1)[:, None]
    s = np.where((q * believed[2]).sum(axis=1) < 0.0, -1.0, 1.0)[:, None]
    apart = np.linalg.norm(q - s * believed[2], axis=1)
    return EstimateErrors(
        time=flight.telemetry["t"],
        position=np.linalg.norm(believed[0] - truth[0], axis=1),
        velocity=np.linalg.norm(believed[1] - truth[1], axis=1),
        attitude=4.0 * np.arcsin(np.clip(0.5 * apart, 0.0, 1.0)),
    )


def specific_force(flight: Flight) -> Array:
    """Mean specific force over each tick along the body axes, shape (ticks, 3) [m/s²].

    From the velocities at the ticks and the attitude at the later one; zero at the first.  It is
    the output of a perfect accelerometer, apart from its position and the rotation within the tick.
    """
    v, q = _at_ticks(flight, ("vx", "vy", "vz")), _at_ticks(flight, ("qw", "qx", "qy", "qz"))
    gravity = np.array([0.0, 0.0, float(flight.scenario.world.gravity)])
    world = np.diff(v, axis=0) * float(flight.scenario.clock) + gravity
    w, u = q[1:, :1], -q[1:, 1:]  # world to body
    body = world + 2.0 * np.cross(u, np.cross(u, world) + w * world)
    return np.concatenate([np.zeros((1, 3)), body])


def clipped_area(flight: Flight, full_scale: float) -> float:
    """Velocity that an accelerometer of some range misses [m/s].

    ∫ max(|f_i| − range, 0) dt, signed, of each body axis; the length of the three.

    Args:
        flight: Flight with its trajectory.
        full_scale: Range of each axis [m/s²].
    """
    force = specific_force(flight)
    beyond = force - np.clip(force, -full_scale, full_scale)
    return float(np.linalg.norm(beyond.sum(axis=0)) / float(flight.scenario.clock))

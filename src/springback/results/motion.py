"""Motion of the main body between and at the recorded instants: any time base, any point, sensors.

Contacts and distances are evaluated again at the recorded states by the kernels of the flight.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import scipy  # submodules are loaded on first use

from springback.contact.worlds import Own
from springback.dynamics.solution import Slider
from springback.errors import InputError
from springback.kernels.trees import leaves, names, rebuilt
from springback.results.contacts.history import contact_history, model_of
from springback.results.joints.turning import turning_by_equations
from springback.results.pair.contacts import pair_view
from springback.results.result import FlightResult
from springback.scenario.avionics import devices_of, normals_at_start, propulsion_of
from springback.scenario.scenario import Scenario
from springback.sensing.sensors import sensors_at_start
from springback.simulation.flight import Trace, still_state
from springback.simulation.guided import ticks_of
from springback.simulation.measuring.record import Model
from springback.simulation.noise import noise_table
from springback.simulation.onboard import Truth, sensor_step
from springback.vehicle.arms.bent import ON_JOINTS
from springback.vehicle.propulsion import Propulsion
from springback.vehicle.rotor_stop import BROKEN, RotorStop, reaction
from springback.vehicle.rotors import INSTANT, Lag, lag_over
from springback.vehicle.state import (
    Shell,
    State,
)

Array = np.ndarray[Any, np.dtype[np.float64]]

Places = np.ndarray[Any, np.dtype[np.intp]]

#: Instants closer together than this are one [s].
ROUNDING = 1e-9
ATTITUDE = ("qw", "qx", "qy", "qz")
#: Parts whose motion turns the main body.
_TURNING = (*ON_JOINTS, Shell)


# -- any time base --------------------------------------------------------------------------------


def columns_at(
    flight: FlightResult, step: float | None = None, times: Any = None
) -> dict[str, Array]:
    """Trajectory and telemetry at given instants; see `springback.Flight.resample`."""
    flight.need_trajectory()
    t = flight.t
    if (step is None) == (times is None):
        raise InputError("give either step, the spacing of the instants in s, or times")
    if step is not None:
        span = float(t[-1] - t[0])
        if not span * 1e-7 <= step <= span:
            raise InputError(f"step: must be from {span * 1e-7:.3g} s to {span:.6g} s (got {step})")
        times = t[0] + step * np.arange(int(span / step * (1.0 + 1e-12)) + 1)
    at = np.asarray(times, dtype=np.float64)
    if at.ndim != 1 or not len(at) or not (at >= t[0]).all() or not (at <= t[-1] + 1e-12).all():
        raise InputError(f"times: must be instants from {t[0]:.6g} s to {t[-1]:.6g} s, in a row")
    at = np.minimum(at, t[-1])
    found = {name: np.interp(at, t, values) for name, values in flight.columns.items()}
    found |= dict(zip(ATTITUDE, _attitudes(flight.columns, at), strict=True)) | {"t": at}
    if flight.telemetry:
        tick = _ticks(flight, at)
        found |= {n: values[tick] for n, values in flight.telemetry.items() if n != "t"}
    return found


def _attitudes(columns: Mapping[str, Array], at: Array) -> Array:
    """Quaternions wxyz by spherical interpolation, shape (4, instants), signs as recorded."""
    recorded = np.stack([columns[name] for name in ATTITUDE], axis=1)
    found = scipy.spatial.transform.Slerp(
        columns["t"], scipy.spatial.transform.Rotation.from_quat(recorded, scalar_first=True)
    )(at)
    return np.asarray(found.as_quat(scalar_first=True).T)


# -- sensors without a pilot -----------------------------------------------------------------------


def sensor_readings(scenario: Scenario, columns: Mapping[str, Array]) -> Trace:
    """Measurements at the ticks of the clock along a recorded trajectory, flown without a pilot.

    They are those of `springback.simulation.onboard.sensor_step`, with the noise of the seed.
    Between instants positions, velocities and arm lengths are interpolated by cubics with the
    recorded rates, attitudes spherically, all else linearly.

    Args:
        scenario: With its sensors, clock and seed.
        columns: Trajectory.

    Returns:
        One row for each tick.

    Raises:
        The problem, if a rate or a delay of a sensor does not fit the clock.
    """
    s, period = scenario, 1.0 / scenario.clock
    devices = devices_of(s.sensors, s.estimator, period, s.vehicle)
    ticks = ticks_of(float(columns["t"][-1]), period)
    states = _states_at(columns, np.array([k * period for k in range(ticks)]), s.vehicle.arm_count)
    sensors = devices.settings.switched_on(devices.sensors, normals_at_start(s.seed, False))
    memory: Any = sensors_at_start(sensors, states[0], s.world.gravity)
    noise, found = noise_table(s.seed, 0, ticks, devices.noise).tolist(), []
    for k, (now, drawn) in enumerate(zip(states, noise, strict=True)):
        truth = Truth(states[max(k - 1, 0)], now, period, s.world.gravity)
        read = sensor_step(sensors, float(k), truth, tuple(drawn), memory)
        memory = read.memory
        found.append([k * period, *leaves(read.measurement)])
    return Trace(("time", *names(read.measurement, "measurement")), np.array(found))


def _states_at(columns: Mapping[str, Array], at: Array, arms: int) -> list[State]:
    """States at some instants of a trajectory."""
    c, t = columns, columns["t"]
    after = np.clip(np.searchsorted(t, at, "right"), 1, len(t) - 1)
    before = after - 1
    h = t[after] - t[before]
    u = (at - t[before]) / h

    def cubic(name: str, rate: str) -> Array:
        rise, begins, ends = c[name][after] - c[name][before], c[rate][before], c[rate][after]
        bend = (1.0 - u) * (h * begins - rise) + u * (rise - h * ends)
        return np.asarray(c[name][before] + u * rise + u * (1.0 - u) * bend)

    numbers = [
        *(cubic(axis, f"v{axis}") for axis in "xyz"), *_attitudes(c, at),
        *(cubic(f"v{axis}", f"a{axis}") for axis in "xyz"),
        *(np.interp(at, t, c[f"w{axis}"]) for axis in "xyz"),
        *(cubic(f"l{j}", f"dl{j}") for j in range(1, arms + 1)),
        *(np.interp(at, t, c[f"dl{j}"]) for j in range(1, arms + 1)),
    ]  # fmt: skip
    like = still_state((0.0,) * arms)
    return [rebuilt(like, row) for row in np.stack(numbers, axis=1).tolist()]


# -- any point ------------------------------------------------------------------------------------


def angular_acceleration(flight: FlightResult, own: tuple[Own, ...] = ()) -> Array:
    """Angular acceleration of the main body, body axes [rad/s²], shape (instants, 3).

    Exact: from the moments of contacts and rotors and the recorded acceleration of the main body
    by the second of the six equations of `springback.dynamics.motion`; for arms on joints, rotors
    that the vehicle lists, and with a hull that turns by itself, from all of them.

    Args:
        flight: With its trajectory.
        own: The user's own obstacles, for a flight read from a file.

    Raises:
        InputError: If the trajectory was not recorded, or the user's own obstacles are unknown.
    """
    model, c = model_of(flight, own), flight.columns
    if isinstance(model.guide, Slider):
        return np.zeros((len(flight.t), 3))
    thrusts = _thrusts(flight, model)
    airframe = model.airframe
    listed = airframe.rotors or model.surface_effect
    if listed or any(isinstance(one, _TURNING) for one in airframe.arms + airframe.hull):
        reactions = _reactions(flight, model)
        return turning_by_equations(*_beside_second(model, flight), thrusts, reactions)
    omega, felt = _vectors(flight, "w"), _in_body_frame(flight)
    moment = _contact_moment(model, flight)
    inertia = np.broadcast_to(np.array(model.airframe.inertia), (len(omega), 3, 3)).copy()
    rate, carried = np.zeros_like(inertia), np.zeros_like(omega)
    for j, (arm, thrust) in enumerate(zip(model.airframe.arms, thrusts, strict=True), start=1):
        e, length = np.array([arm.cosine, arm.sine, 0.0]), c[f"l{j}"]
        across = np.eye(3) - np.outer(e, e)
        inertia += (arm.mass * length**2)[:, None, None] * across
        rate += (2.0 * arm.mass * length * c[f"dl{j}"])[:, None, None] * across
        carried += (arm.mass * length)[:, None] * e
        moment += thrust[:, None] * np.stack(
            [length * arm.sine, -length * arm.cosine, np.full_like(length, arm.torque_ratio)], 1
        )
    moment[:, 2] += sum(_reactions(flight, model))
    momentum = np.einsum("tij,tj->ti", inertia, omega)
    rest = moment - np.cross(omega, momentum) - np.einsum("tij,tj->ti", rate, omega)
    rest -= np.cross(carried, felt)
    return np.linalg.solve(inertia, rest[:, :, None])[:, :, 0]


def _contact_moment(model: Model, flight: FlightResult) -> Array:
    """Moment of all contacts about the main body, body axes [N m], shape (instants, 3)."""
    return contact_history(*_beside_second(model, flight)).moment.copy()


def _beside_second(model: Model, flight: FlightResult) -> tuple[Model, FlightResult]:
    """Model and flight of a vehicle, to which the parts of a second one are moving obstacles."""
    if flight.is_second:
        raise InputError(
            "at: must be [0, 0, 0] for a second vehicle: its contacts with the first one are known "
            "by their sum only"
        )
    if flight.second is None:
        return model, flight
    seen = pair_view(flight.scenario, flight.columns, flight.second.columns)
    return seen.model, replace(flight, columns=seen.columns)


def specific_force_at(flight: FlightResult, at: Any, own: tuple[Own, ...] = ()) -> Array:
    """Specific force at a point of the main body; see `springback.Flight.specific_force`."""
    r = np.asarray(at, dtype=np.float64)
    if r.shape != (3,) or not np.isfinite(r).all():
        raise InputError(f"at: must be three numbers, x, y, z in m along the body axes (got {at})")
    flight.need_trajectory()
    felt = _in_body_frame(flight)
    if not r.any():
        return felt
    omega = _vectors(flight, "w")
    turning = np.cross(omega, np.cross(omega, r))
    return np.asarray(felt + np.cross(angular_acceleration(flight, own), r) + turning)


def _vectors(flight: FlightResult, stem: str) -> Array:
    return np.stack([flight.columns[f"{stem}{axis}"] for axis in "xyz"], axis=1)


def _in_body_frame(flight: FlightResult) -> Array:
    """Specific force of the main body, Rᵀ(v̇ + g e_Z), shape (instants, 3) [m/s²]."""
    felt = _vectors(flight, "a") + np.array([0.0, 0.0, flight.scenario.world.gravity])
    recorded = np.stack([flight.columns[name] for name in ATTITUDE], axis=1)
    return np.asarray(
        scipy.spatial.transform.Rotation.from_quat(recorded, scalar_first=True).apply(
            felt, inverse=True
        )
    )


def _thrusts(flight: FlightResult, model: Model) -> list[Array]:
    """Thrust of each rotor in the equations of motion [N], each of shape (instants,).

    With a pilot it is the mean over a tick, which follows from the thrusts at its ends.
    """
    telemetry = flight.telemetry
    if "thrust1" in flight.columns:
        return [flight.columns[f"thrust{j}"] for j in range(1, len(model.thrust) + 1)]
    if "thrust1" not in telemetry:
        return [np.full(len(flight.t), thrust) for thrust in model.thrust]
    rotors, period = propulsion_of(flight.scenario, model.airframe), 1.0 / flight.scenario.clock
    turns, stands = (
        (1.0 - lag.mean) / (1.0 - lag.end)
        for lag in (lag_over(rotors.time_constant, period), _lag_of_a_stop(rotors, period))
    )
    tick = _ticks(flight, flight.t)
    found = []
    for j in range(1, len(model.thrust) + 1):
        begin, end = _thrust_at_ends(telemetry, j)
        share = np.where(_stands(telemetry, j), stands, turns)
        found.append((begin + (end - begin) * share)[tick])
    return found


def _thrust_at_ends(telemetry: dict[str, Array], j: int) -> tuple[Array, Array]:
    """Thrust of rotor ``j`` at the beginning and the end of each tick [N]; constant at the last."""
    begin = telemetry[f"thrust{j}"]
    return begin, np.append(begin[1:], begin[-1])


def _stands(telemetry: dict[str, Array], j: int) -> Array:
    """True in the ticks in which rotor ``j`` has stopped; that of the last one is not recorded."""
    if f"stopped{j}" not in telemetry:
        return np.zeros(len(telemetry["t"]), dtype=bool)
    since = np.append(telemetry[f"stopped{j}"][1:], telemetry[f"stopped{j}"][-1])
    stands = (since >= 0.0) & (since <= telemetry["t"] + ROUNDING)
    return np.asarray(stands | (since == BROKEN))


def _lag_of_a_stop(propulsion: Propulsion, period: float) -> Lag:
    stop = propulsion.rotor_stop(period)
    return stop.lag if isinstance(stop, RotorStop) else lag_over(INSTANT, period)


def _reactions(flight: FlightResult, model: Model) -> list[Array | float]:
    """Moments of rotors that change speed, each about its axis [N m]; mostly zero.

    Each is one number or has the shape (instants,).
    """
    rotors = getattr(model.airframe.rotors, "each", model.airframe.arms)
    telemetry, period = flight.telemetry, 1.0 / flight.scenario.clock
    propulsion = flight.scenario.vehicle.propulsion
    stop = None if propulsion is None else propulsion.rotor_stop(period)
    if not isinstance(stop, RotorStop) or "thrust1" not in telemetry:
        return [0.0] * len(rotors)
    ticks = _ticks(flight, flight.t)
    found: list[Array | float] = []
    for j, rotor in enumerate(rotors, start=1):
        ends = zip(*_thrust_at_ends(telemetry, j), strict=True)
        found.append(np.array([reaction(rotor, *both, stop) for both in ends])[ticks])
    return found


def _ticks(flight: FlightResult, at: Array) -> Places:
    """Number of the last tick before or at each instant; a step ends at it to within rounding."""
    rows = np.searchsorted(flight.telemetry["t"], at + ROUNDING, "right") - 1
    return np.clip(rows, 0, None)

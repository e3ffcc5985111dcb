"""Columns of a flight's files, from the trace of the simulation."""

from __future__ import annotations

from typing import Any

import numpy as np
import scipy  # submodules are loaded on first use

from springback.contact.cage import moving_bodies
from springback.contact.moving.bodies import ABSENT, CARRIED
from springback.contact.obstacles import Impulses
from springback.results.contacts.jumps import impulse_columns
from springback.simulation.flight import FlightRecord, Trace
from springback.simulation.playback import bend_columns, recorded_memory
from springback.simulation.thrusts import ThrustTable

Array = np.ndarray[Any, np.dtype[np.float64]]


def trajectory_columns(
    flown: FlightRecord, thrusts: ThrustTable | None = None
) -> tuple[dict[str, Array], dict[str, str]]:
    """Trajectory columns under their file names, with units; thrusts that are a table included."""
    trace = flown.trace
    if trace is None:
        return {}, {}
    state, view = "state", "acceleration"
    names: dict[str, tuple[str, str]] = {"t": ("time", "s")}
    names |= {axis: (f"{state}.position.{axis}", "m") for axis in "xyz"}
    names |= {f"q{part}": (f"{state}.attitude.{part}", "") for part in "wxyz"}
    names |= {f"v{axis}": (f"{state}.velocity.{axis}", "m/s") for axis in "xyz"}
    names |= {f"w{axis}": (f"{state}.angular_velocity.{axis}", "rad/s") for axis in "xyz"}
    count = range(1, len(flown.start.arm_length) + 1)
    names |= {f"l{j}": (f"{state}.arm_length.{j}", "m") for j in count}
    names |= {f"dl{j}": (f"{state}.arm_rate.{j}", "m/s") for j in count}
    names |= bend_columns(len(flown.start.bends))
    names |= {f"a{axis}": (f"{view}.{axis}", "m/s^2") for axis in "xyz"}
    names |= {f"fn{j}": (f"arms.{j}.normal", "N") for j in count}
    names |= {"fn_body": ("hull.1.normal", "N")} if flown.model.airframe.hull else {}
    columns = {name: np.ascontiguousarray(trace[source]) for name, (source, _) in names.items()}
    units = {name: unit for name, (_, unit) in names.items()}
    rubbed = {f"ff{j}": f"arms.{j}.friction" for j in count}
    rubbed |= {"ff_body": "hull.1.friction"} if flown.model.airframe.hull else {}
    for name, source in rubbed.items():
        parts = np.stack([trace[f"{source}.{axis}"] for axis in "xyz"])
        columns[name], units[name] = np.linalg.norm(parts, axis=0), "N"
    if isinstance(flown.model.world.laws, Impulses):
        jumped = impulse_columns(columns, trace)
        columns, units = columns | jumped, units | dict.fromkeys(jumped, "N s")
    kept = recorded_memory(flown.start.memory, flown.model.world.obstacles)
    for name, (source, unit) in kept.items():
        columns[name], units[name] = np.ascontiguousarray(trace[source]), unit
    for number, body in enumerate(moving_bodies(flown.model.world.obstacles), start=1):
        if body.kind not in (ABSENT, CARRIED):  # of another vehicle, which has its own
            moving = _body_columns(trace, f"bodies.{number}.pose", f"obstacle{int(body.obstacle)}_")
            columns |= {name: column for name, (column, _) in moving.items()}
            units |= {name: unit for name, (_, unit) in moving.items()}
    if thrusts is not None:
        given = {f"thrust{j}": row for j, row in enumerate(thrusts.at(columns["t"]).T, start=1)}
        columns, units = columns | given, units | dict.fromkeys(given, "N")
    return columns, units


def _body_columns(trace: Trace, source: str, stem: str) -> dict[str, tuple[Array, str]]:
    """Pose and motion of a moving obstacle, with units; its angular velocity is in its own axes."""

    def vectors(name: str) -> Array:
        return np.stack([trace[f"{source}.{name}.{axis}"] for axis in "xyz"], axis=-1)

    r = np.stack([vectors(f"r.{row}") for row in "xyz"], axis=1)
    turn = scipy.spatial.transform.Rotation.from_matrix(r)
    spin = np.einsum("tji,tj->ti", r, vectors("spin"))
    parts = [
        ("", "xyz", vectors("position"), "m"),
        ("q", "wxyz", turn.as_quat(canonical=True, scalar_first=True), ""),
        ("v", "xyz", vectors("velocity"), "m/s"),
        ("w", "xyz", spin, "rad/s"),
    ]
    return {
        f"{stem}{name}{axis}": (np.ascontiguousarray(values[:, k]), unit)
        for name, axes, values, unit in parts
        for k, axis in enumerate(axes)
    }


def work_columns(flown: FlightRecord) -> dict[str, Array]:
    """Work in the trace by name, and a flag for contact of any cage."""
    trace, stem = flown.trace, "work."
    if trace is None:
        return {}
    names = [name for name in trace.columns if name.startswith(stem)]
    work = {name.removeprefix(stem): np.ascontiguousarray(trace[name]) for name in names}
    touching = np.zeros(len(trace.values))
    for name in trace.columns:
        if ".engaged." in name:
            np.maximum(touching, trace[name], out=touching)
    return work | {"touching": touching}


#: Columns of telemetry: name, source, unit.  An `n` represents the number of an arm or a rotor.
_TELEMETRY = (
    ("t", "time", "s"),
    ("command{n}", "command.{n}", "N"), ("thrust{n}", "thrust.{n}", "N"),
    ("imu_a{a}", "measurement.inertial.specific_force.{a}", "m/s^2"),
    ("imu_w{a}", "measurement.inertial.angular_velocity.{a}", "rad/s"),
    ("imu_fresh", "measurement.inertial.fresh", ""),
    ("pose_{a}", "measurement.pose.position.{a}", "m"),
    ("pose_q{q}", "measurement.pose.attitude.{q}", ""),
    ("pose_fresh", "measurement.pose.fresh", ""), ("pose_age", "measurement.pose.age", "s"),
    ("hall{n}", "measurement.arm_length.{n}", "m"),
    ("est_{a}", "pilot.estimate.position.{a}", "m"),
    ("est_q{q}", "pilot.estimate.attitude.{q}", ""),
    ("est_v{a}", "pilot.estimate.velocity.{a}", "m/s"),
    ("est_w{a}", "pilot.estimate.angular_velocity.{a}", "rad/s"),
    ("ref_{a}", "pilot.wanted.position.{a}", "m"), ("ref_v{a}", "pilot.wanted.velocity.{a}", "m/s"),
    ("ref_a{a}", "pilot.wanted.acceleration.{a}", "m/s^2"), ("ref_yaw", "pilot.wanted.yaw", "rad"),
    ("aim_q{q}", "pilot.aim.attitude.{q}", ""), ("aim_thrust", "pilot.aim.thrust", "N"),
    ("aim_w{a}", "pilot.setpoint.{a}", "rad/s"),
    ("phase", "pilot.phase", ""), ("goal_{a}", "pilot.goal.{a}", "m"),
    ("pressed", "pilot.pressed", "m"), ("jolt", "pilot.jolt", "m/s^2"), ("push", "pilot.push", "N"),
    ("alarms_hall", "pilot.alarms.1", ""), ("alarms_acceleration", "pilot.alarms.2", ""),
    ("alarms_wrench", "pilot.alarms.3", ""),
    ("force_{a}", "pilot.force.{a}", "N"), ("moment_{a}", "pilot.moment.{a}", "N m"),
    ("hit_{a}", "pilot.direction.{a}", ""),
    ("alarm", "report.alarm", ""), ("stopped{n}", "stopped.{n}", "s"),
)  # fmt: skip


def telemetry_columns(trace: Trace | None, most: int) -> tuple[dict[str, Array], dict[str, str]]:
    """Columns of telemetry under their file names, with units; those that the pilot recorded.

    Args:
        trace: As recorded.
        most: Number of arms, or of rotors if there are more.
    """
    columns: dict[str, Array] = {}
    units: dict[str, str] = {}
    if trace is None:
        return columns, units
    for name, source, unit in _TELEMETRY:
        for n in range(1, most + 1) if "{n}" in source else (0,):
            for a in "xyz" if "{a}" in source else ("",):
                for q in "wxyz" if "{q}" in source else ("",):
                    known = source.format(n=n, a=a, q=q)
                    if known in trace.columns:
                        column = name.format(n=n, a=a, q=q)
                        columns[column] = np.ascontiguousarray(trace[known])
                        units[column] = unit
    return columns, units

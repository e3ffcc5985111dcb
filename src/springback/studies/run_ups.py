"""Vehicles and run-ups of studies: speed and pitch at the wall, against those asked for."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.control.reference_parameters import RunUpSettings
from springback.errors import InputError
from springback.kernels.vectors import Vec
from springback.results.flight import Flight
from springback.scenario.presets import is_vehicle_file, read_vehicle
from springback.scenario.scenario import scenario_from
from springback.vehicle.arms.paths import free_end_along
from springback.vehicle.hulls import hull_reach
from springback.vehicle.parameters import Vehicle

ROBOTS = ("arq", "quad")
"""Presets of the paper's robots."""

#: Pitch [deg, positive nose down] and speed [m/s] of the paper's collisions, Impact Resilience.
CONDITIONS = (
    (0.0, 2.0), (0.0, 3.5), (-45.0, 2.0), (-30.0, 2.0), (30.0, 2.0), (-15.0, 2.0), (15.0, 2.0),
)  # fmt: skip
#: Paper: start to wall [m].
WALL_DISTANCE = 2.75
#: Preset of the paper's wall with the paper's friction, which acts along the vertical only.
PAPER_WALL = "paper-wall"
#: Long enough to arrive, and to be seen leaving [s], chosen.
DURATION = 4.0


class StudyVehicle(NamedTuple):
    """Vehicle of a study, a preset or the user's own."""

    name: str
    tables: dict[str, Any]
    """Raw, as in a scenario."""
    vehicle: Vehicle

    def reach(self, yaw: float = 0.0) -> float:
        """From the main body to the foremost point along x, level [m].

        Args:
            yaw: Of the vehicle [rad].
        """
        arms, airframe = self.vehicle.arms, self.vehicle.airframe()
        ahead = Vec(math.cos(yaw), -math.sin(yaw), 0.0)  # world x in body axes
        points = [
            float(arms.at("length", j)) * math.cos(float(direction) + yaw)
            + float(arms.at("cage_radius", j))
            for j, direction in enumerate(arms.directions if arms.cages else ())
        ]
        points += [hull_reach(hull, ahead) for hull in airframe.hull]
        for arm in airframe.arms:
            along = free_end_along(arm, ahead)
            points += [along + hull_reach(hull, ahead) for hull in arm.hull]
        return max(points)


def study_vehicles(words: Sequence[str]) -> tuple[StudyVehicle, ...]:
    """Vehicles of a study, which must be able to fly.

    Args:
        words: Presets, and files with a vehicle; repeated words count once.

    Raises:
        InputError: If one is unknown or invalid, has no rotors, or has the name of another.
    """
    found: dict[str, StudyVehicle] = {}
    for word in dict.fromkeys(words):
        own = is_vehicle_file(word)
        try:
            tables = read_vehicle(word) if own else {"preset": word}
            vehicle = scenario_from({"vehicle": tables}).vehicle
        except InputError as error:
            lines = (line if word in line else f"{word}: {line}" for line in error.problems)
            raise InputError(*(f"--robot: {line}" for line in lines)) from None
        name = str(tables["name"]) if own else word
        if vehicle.propulsion is None:
            raise InputError(f"--robot: {word}: vehicle.propulsion: is missing, so it cannot fly")
        if name in found:
            raise InputError(
                f"--robot: {word} has the name of another vehicle, {name!r}; give it another"
            )
        found[name] = StudyVehicle(name, tables, vehicle)
    return tuple(found.values())


class Arrival(NamedTuple):
    """Motion at first touch, and its errors."""

    speed: float  # of the main body into the wall [m/s]
    pitch: float  # positive nose down [rad]
    speed_error: float  # had less wanted [m/s]
    pitch_error: float  # [rad]
    pitch_rate: float  # d(pitch)/dt where neither roll nor yaw are [rad/s]
    height_error: float  # of the main body, against the run-up's height [m]
    time: float  # of first touch [s]


def run_up_scenario(vehicle: str, pitch: float, speed: float, **tables: Any) -> dict[str, Any]:
    """A run-up of a preset vehicle at the paper's wall, as plain tables.

    Args:
        vehicle: Preset.
        pitch: At contact, positive nose down [deg].
        speed: At contact [m/s].
        **tables: Further tables, or others in place of these.
    """
    given: dict[str, Any] = {
        "name": f"{vehicle}, {speed:g} m/s, {pitch:g} deg",
        "vehicle": vehicle,
        "reference": {"type": "run-up", "speed": speed, "pitch": math.radians(pitch)},
        "world": {
            "obstacles": [{"type": "wall", "distance": WALL_DISTANCE, "surface": PAPER_WALL}]
        },
        "start": {"position": [0.0, 0.0, 1.0]},
        "simulation": {"duration": DURATION},
    }
    return given | tables


def run_up_errors(flight: Flight) -> Arrival:
    """Speed and pitch with which a run-up arrived, and their errors.

    Args:
        flight: Of a scenario with a run-up, its trajectory kept.

    Raises:
        InputError: If the flight was no run-up, touched nothing, or has no trajectory.
    """
    wanted, time = flight.scenario.reference, flight.measures["touch_time"]
    if not isinstance(wanted, RunUpSettings):
        raise InputError("reference.type: must be run-up, to ask how a run-up arrived")
    if time is None or not flight.columns:
        raise InputError("the flight touched nothing, or has no trajectory")
    c = flight.columns
    at = {name: c[name][np.searchsorted(c["t"], time)] for name in ("qw", "qx", "qy", "qz", "wy")}
    pitch = math.asin(2.0 * (at["qw"] * at["qy"] - at["qz"] * at["qx"]))
    speed, height = float(flight.measures["touch_speed"] or 0.0), np.interp(time, c["t"], c["z"])
    return Arrival(
        speed=speed,
        pitch=pitch,
        speed_error=speed - float(wanted.speed),
        pitch_error=pitch - float(wanted.pitch),
        pitch_rate=float(at["wy"]),
        height_error=float(height) - float(tuple(wanted.start)[2]),
        time=time,
    )


def arrivals_table(rows: Sequence[tuple[str, Arrival]]) -> str:
    """Arrivals as a Markdown table.

    Args:
        rows: Name and arrival of each flight.
    """
    lines = [
        "| flight | speed [m/s] | error | pitch [deg] | error | rate [deg/s] | height error [m] |",
        "|:---|---:|---:|---:|---:|---:|---:|",
    ]
    for name, a in rows:
        turned = (math.degrees(x) for x in (a.pitch, a.pitch_error, a.pitch_rate))
        pitch, off, rate = turned
        lines.append(
            f"| {name} | {a.speed:.3f} | {a.speed_error:+.3f} | {pitch:.2f} | {off:+.2f} "
            f"| {rate:+.0f} | {a.height_error:+.3f} |"
        )
    return "\n".join(lines)

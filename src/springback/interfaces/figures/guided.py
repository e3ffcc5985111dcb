"""Figures of flights with a pilot."""

from __future__ import annotations

import numpy as np

from springback.interfaces.figures.panels import (
    Array,
    Curve,
    Panel,
    alike,
    arms_of,
    body_curves,
    hinge_curves,
)
from springback.interfaces.figures.style import Look
from springback.interfaces.output.robots import BLUE, GREY, ORANGE
from springback.results.flight import Flight

FLOWN: Look = {"color": BLUE, "ls": "-"}
WANTED: Look = {"color": ORANGE, "ls": (0, (3.2, 1.4))}
LIMIT: Look = {"color": GREY, "ls": (0, (1.2, 1.2))}
HOVERING = {"m": 0.05, "deg": 2.0, "m/s": 0.1}
"""Chosen: curves that vary less than this are shown on an axis of twice this span."""


def _panel(label: str, unit: str, curves: list[Curve], explained: bool = True) -> Panel:
    least = HOVERING[unit]
    return Panel(label, curves, 2.0 * least, least, explained)


def euler_angles(columns: dict[str, Array], prefix: str = "q") -> tuple[Array, Array, Array]:
    """Roll, pitch and yaw [rad] of quaternion columns, ZYX, pitch positive nose down."""
    w, x, y, z = (columns[prefix + part] for part in "wxyz")
    roll = np.arctan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y))
    pitch = np.arcsin(np.clip(2.0 * (w * y - z * x), -1.0, 1.0))
    yaw = np.arctan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))
    return roll, pitch, yaw


def tilt(columns: dict[str, Array], prefix: str = "q") -> Array:
    """Angle between the body's z axis and the vertical [rad], with cosine R_zz."""
    x, y = columns[prefix + "x"], columns[prefix + "y"]
    return np.arccos(np.clip(1.0 - 2.0 * (x * x + y * y), -1.0, 1.0))


def guided_panels(flight: Flight) -> list[Panel]:
    """Panels: position, velocity, attitude, tilt, thrusts, hinges, normal forces, estimation error.

    Panels without data in the telemetry (reference, attitude set-point, estimate) are left out.
    """
    return [
        *_positions(flight), _velocities(flight), *_attitudes(flight), _thrusts(flight),
        *_hinges(flight), *_impacts(flight), *_estimate(flight),
    ]  # fmt: skip


def _positions(flight: Flight) -> list[Panel]:
    c, d = flight.columns, flight.telemetry
    panels = []
    for axis in "xyz":
        curves = [Curve("flown", c["t"], c[axis], FLOWN)]
        if f"ref_{axis}" in d:
            curves.append(Curve("wanted", d["t"], d[f"ref_{axis}"], WANTED))
        panels.append(_panel(f"{axis} [m]", "m", curves, axis == "x"))
    return panels


def _velocities(flight: Flight) -> Panel:
    c = flight.columns
    curves = [Curve(f"v{axis}", c["t"], c[f"v{axis}"]) for axis in "xyz"]
    return _panel("Velocity [m/s]", "m/s", curves)


def _attitudes(flight: Flight) -> list[Panel]:
    c, d = flight.columns, flight.telemetry
    names = ("roll", "pitch", "yaw")
    angles = [
        Curve(name, c["t"], np.degrees(angle))
        for name, angle in zip(names, euler_angles(c), strict=True)
    ]
    tilted = [Curve("flown", c["t"], np.degrees(tilt(c)), FLOWN)]
    if "aim_qw" in d:
        tilted.append(Curve("aimed at", d["t"], np.degrees(tilt(d, "aim_q")), WANTED))
    return [_panel("Attitude [deg]", "deg", angles), _panel("Tilt [deg]", "deg", tilted)]


def _thrusts(flight: Flight) -> Panel:
    """Panel of the rotors' thrusts, with their limits."""
    d = flight.telemetry
    t = d["t"]
    numbers = [int(name[6:]) for name in d if name.startswith("thrust")]
    curves = [
        Curve(name, t, values)
        for name, values in alike("rotor", [(j, d[f"thrust{j}"]) for j in numbers])
    ]
    propulsion = flight.scenario.vehicle.propulsion
    if propulsion is not None:
        rotors = propulsion.rotors()
        bounds = np.array([rotors.most, rotors.most, np.nan, rotors.least, rotors.least])
        curves.append(Curve("limits", t[[0, -1, -1, 0, -1]], bounds, LIMIT))
    return Panel("Thrust [N]", curves)


def _hinges(flight: Flight) -> list[Panel]:
    """Panels of the hinges of arms that fold, if there are any."""
    t = flight.columns["t"]
    return [
        Panel(label, [Curve(name, t, values) for name, values in curves])
        for label, curves in hinge_curves(flight)
    ]


def _impacts(flight: Flight) -> list[Panel]:
    c = flight.columns
    touched = [j for j in arms_of(c) if np.any(c[f"fn{j}"] > 0.0)]
    forces = alike("arm", [(j, c[f"fn{j}"]) for j in touched]) + body_curves(c, {"fn": "body"})
    if not forces:
        return []
    return [Panel("Normal force [N]", [Curve(name, c["t"], values) for name, values in forces])]


def _estimate(flight: Flight) -> list[Panel]:
    """Panel of the error of the estimated position, if there is any error."""
    c, d = flight.columns, flight.telemetry
    if "est_x" not in d:
        return []
    errors = [d[f"est_{a}"] - np.interp(d["t"], c["t"], c[a]) for a in "xyz"]
    error = 1e3 * np.linalg.norm(errors, axis=0)
    if float(np.max(error, initial=0.0)) < 1e-6:
        return []
    return [Panel("Error [mm]", [Curve("of the estimated position", d["t"], error)])]

"""Vehicles that equal thrusts of their rotors turn: hover without a pilot lets them tip over."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from springback.vehicle.parameters import Vehicle
from springback.vehicle.placed.balance import mass_centre
from springback.vehicle.placed.settings import RotorSettings, wrench_matrix

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Time that is looked at [s], and the turn from rest in it that is worth a warning [rad] (chosen:
#: 1 deg, an angular acceleration of 3.5 rad/s²; 16 deg in the 0.4 s of a short flight).
SOON, MOST_TURN = 0.1, math.radians(1.0)


def hover_turn(vehicle: Vehicle, gravity: float) -> tuple[Array, Array]:
    """What the thrusts of ``"hover"`` do to a vehicle at rest, level, arms free.

    Args:
        vehicle: One with rotors that lift.
        gravity: g [m/s²].

    Returns:
        The moment about the centre of mass [N m], and the angular acceleration [rad/s²] that it
        gives; body axes, shape (3,) each.
    """
    arms, spin = vehicle.arms, vehicle.arms.spin
    rotors = vehicle.rotors or tuple(
        RotorSettings.model_validate({"on": j + 1, "spin": spin[j] if spin else None})
        for j in range(vehicle.arm_count)
    )
    thrusts = np.array(vehicle.hover_thrusts(vehicle.mass * gravity))
    wrench, centre = wrench_matrix(rotors, arms) @ thrusts, mass_centre(vehicle)
    moment: Array = wrench[3:] - np.cross(centre, wrench[:3])
    moved = vehicle.mass * (centre @ centre * np.eye(3) - np.outer(centre, centre))
    acceleration = np.linalg.solve(vehicle.inertia() - moved, moment)
    return moment, np.asarray(acceleration, dtype=float)


def balance_warnings(vehicle: Vehicle, gravity: float) -> list[str]:
    """A sentence on a vehicle that the thrusts of ``"hover"`` turn, if they do so soon.

    Args:
        vehicle: One with rotors that lift, which no pilot steers.
        gravity: g [m/s²].
    """
    moment, acceleration = hover_turn(vehicle, gravity)
    turn = 0.5 * float(np.linalg.norm(acceleration)) * SOON * SOON
    if turn <= MOST_TURN:
        return []
    axis = "xyz"[int(np.abs(acceleration).argmax())]
    return [
        f'thrust: the equal thrusts of "hover" leave a moment of {np.linalg.norm(moment):.3g} N m '
        f"about the centre of mass, which turns the vehicle, mostly about body {axis}, by "
        f"{math.degrees(turn):.3g} deg in the first {SOON:g} s: give it a pilot ([reference]), or "
        "thrust as a list with one for each rotor"
    ]

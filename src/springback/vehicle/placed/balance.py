"""What listed rotors do to a vehicle in hover, at equal thrusts of those that lift."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from springback.vehicle.parameters import Vehicle
from springback.vehicle.placed.settings import wrench_matrix

Array = np.ndarray[Any, np.dtype[np.float64]]


class HoverBalance(NamedTuple):
    """Force and moment of rotors that carry the weight, per newton of it; body axes."""

    sideways: float  # force across body z [1]
    tilting: float  # moment about x and y through the centre of mass [m]
    turning: float  # moment about z [m]


def hover_balance(vehicle: Vehicle) -> HoverBalance:
    """Balance in hover, level, arms free; listed rotors share the weight equally.

    Args:
        vehicle: One that lists its rotors, some of which lift.
    """
    shares = np.array(vehicle.hover_thrusts(1.0))
    wrench = wrench_matrix(vehicle.rotors, vehicle.arms) @ shares
    force, moment = wrench[:3], wrench[3:]
    moment = moment - np.cross(mass_centre(vehicle), force)
    return HoverBalance(
        float(np.hypot(*force[:2])), float(np.hypot(*moment[:2])), abs(float(moment[2]))
    )


def mass_centre(vehicle: Vehicle) -> Array:
    """Centre of mass from that of the main body, arms free, body axes [m], shape (3,)."""
    arms = vehicle.arms
    carried: Array = sum(
        (arms.at("mass", j) * np.array(arms.end(j)) for j in range(vehicle.arm_count)), np.zeros(3)
    )
    return carried / vehicle.mass

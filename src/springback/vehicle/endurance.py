"""Hover time and payload of a vehicle.

Momentum theory of the hovering rotor (J. G. Leishman, Principles of Helicopter Aerodynamics,
chapter 2): the ideal power of one disk is T^1.5/√(2ρA), and the figure of merit is the ratio of
ideal power to battery power.  The battery delivers constant power until its usable energy is spent;
its voltage drop and the loss in its internal resistance are neglected.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import numpy as np

from springback.errors import InputError
from springback.vehicle.parameters import Vehicle

GRAVITY = 9.81
"""g [m/s²], that of a world by default."""
ROUNDING = 1e-9
"""Chosen: share of the most thrust that is forgiven, so that the largest payload can hover."""


def induced_power(thrust: float, disk_radius: float, air_density: float) -> float:
    """Ideal power of one hovering rotor, T v_i with v_i = √(T/(2ρA)) [W].

    Args:
        thrust: T [N].
        disk_radius: Radius of the propeller; A = π r² [m].
        air_density: ρ [kg/m³].
    """
    area = math.pi * disk_radius**2
    return float(thrust**1.5 / math.sqrt(2.0 * air_density * area))


def _datum(vehicle: Vehicle, name: str) -> float:
    """A number of the propulsion, or an error naming it."""
    if vehicle.propulsion is None:
        raise InputError(f"vehicle {vehicle.name} has no propulsion; give it one")
    value = getattr(vehicle.propulsion, name)
    if value is None:
        raise InputError(f"vehicle {vehicle.name}: propulsion.{name} is missing; give it a number")
    return float(value)


def _hover_thrust(vehicle: Vehicle, payload: float) -> float:
    """Thrust of one rotor [N]."""
    if not (math.isfinite(payload) and payload >= 0.0):
        raise InputError(f"payload must be at least 0 kg (got {payload:g} kg)")
    if not vehicle.lift > 0.0:
        raise InputError(f"vehicle {vehicle.name} cannot hover: none of its rotors lifts")
    thrust = (vehicle.mass + payload) * GRAVITY / vehicle.lift
    most = _datum(vehicle, "max_thrust")
    if thrust > most * (1.0 + ROUNDING):
        raise InputError(
            f"vehicle {vehicle.name} with {payload:g} kg of payload cannot hover: "
            f"it takes {thrust:.6g} N a rotor, propulsion.max_thrust is {most:.6g} N"
        )
    return thrust


def _ideal_power(vehicle: Vehicle, payload: float) -> float:
    """Ideal power of all rotors [W]."""
    thrust = _hover_thrust(vehicle, payload)
    radius, density = _datum(vehicle, "disk_radius"), _datum(vehicle, "air_density")
    lifting = sum(one.lifts for one in vehicle.rotors) if vehicle.rotors else vehicle.arm_count
    return lifting * induced_power(thrust, radius, density)


def hover_power(vehicle: Vehicle, payload: float = 0.0) -> float:
    """Power from the battery in hover, n T^1.5/(FM √(2ρA)) + P_e [W].

    Args:
        vehicle: With propulsion.
        payload: Additional mass [kg].

    Raises:
        InputError: If a number of the propulsion is missing, or the payload cannot be lifted.
    """
    ideal = _ideal_power(vehicle, payload)
    return ideal / _datum(vehicle, "figure_of_merit") + _datum(vehicle, "electronics_power")


def hover_time(vehicle: Vehicle, payload: float = 0.0) -> float:
    """Time in hover until the usable energy of the full battery is spent [s].

    Args:
        vehicle: With propulsion.
        payload: Additional mass [kg].

    Raises:
        InputError: If a number of the propulsion is missing, or the payload cannot be lifted.
    """
    return _usable_energy(vehicle) / hover_power(vehicle, payload)


def _usable_energy(vehicle: Vehicle) -> float:
    """Usable energy of the battery [J]."""
    return _datum(vehicle, "usable_share") * _datum(vehicle, "battery_energy")


def largest_payload(vehicle: Vehicle, thrust_to_weight: float = 1.0) -> float:
    """Largest additional mass that can be carried, m_p = n T_max/(k g) − m [kg].

    Args:
        vehicle: With propulsion.
        thrust_to_weight: k, ratio of maximum thrust to weight required with the payload; 1 leaves
            no thrust for control.

    Raises:
        InputError: If the vehicle has no propulsion, or cannot even lift itself.
    """
    if not (math.isfinite(thrust_to_weight) and thrust_to_weight >= 1.0):
        raise InputError(f"thrust_to_weight must be at least 1 (got {thrust_to_weight:g})")
    most = vehicle.lift * _datum(vehicle, "max_thrust")
    payload = most / (thrust_to_weight * GRAVITY) - vehicle.mass
    if payload < 0.0:
        raise InputError(
            f"vehicle {vehicle.name} cannot lift itself with thrust_to_weight {thrust_to_weight:g}:"
            f" it weighs {vehicle.mass:.3g} kg, {most:.3g} N is the most thrust of all rotors"
        )
    return payload


def endurance_curve(
    vehicle: Vehicle, payloads: Iterable[float]
) -> np.ndarray[Any, np.dtype[np.float64]]:
    """`hover_time` for each payload [kg]: times [s], one for each.

    Raises:
        InputError: If a number of the propulsion is missing, or a payload cannot be lifted.
    """
    return np.array([hover_time(vehicle, float(payload)) for payload in payloads], dtype=float)


def figure_of_merit_for(vehicle: Vehicle, time: float, payload: float = 0.0) -> float:
    """Figure of merit that reproduces a measured hover time.

    FM = P_ideal/(E/t − P_e); the vehicle's own figure of merit is not read.

    Args:
        vehicle: With propulsion.
        time: Measured hover time t [s].
        payload: Payload in that measurement [kg].

    Raises:
        InputError: If another number is missing, the payload cannot be lifted, or the electronics
            alone would empty the battery sooner.
    """
    if not (math.isfinite(time) and time > 0.0):
        raise InputError(f"time must be more than 0 s (got {time:g} s)")
    ideal = _ideal_power(vehicle, payload)
    left = _usable_energy(vehicle) / time - _datum(vehicle, "electronics_power")
    if left <= 0.0:
        raise InputError(
            f"vehicle {vehicle.name}: the electronics alone empty the battery within {time:g} s"
        )
    return ideal / left

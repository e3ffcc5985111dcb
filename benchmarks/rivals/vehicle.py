"""The vehicle that rivals fly, where they can fly another than their own."""

from __future__ import annotations

from typing import Any

from springback.vehicle.library import VEHICLES


def quad() -> dict[str, Any]:
    """Quad as plain numbers: as RotorPy gets it.  SI units, body axes."""
    vehicle = VEHICLES["quad"].vehicle
    arms, rotors = vehicle.airframe().arms, vehicle.propulsion
    if rotors is None:
        raise ValueError("the vehicle has no rotors")
    return {
        "mass": vehicle.mass,
        "inertia": [float(vehicle.inertia()[k][k]) for k in range(3)],
        "rotors": [[arm.length * arm.cosine, arm.length * arm.sine, 0.0] for arm in arms],
        "spins": [1.0 if arm.torque_ratio > 0.0 else -1.0 for arm in arms],
        "torque_ratio": abs(arms[0].torque_ratio),
        "max_thrust": float(rotors.max_thrust),
        "rotor_lag": float(rotors.time_constant),
    }

"""Thrusts of a scenario, as numbers that the rotors can give."""

from __future__ import annotations

from typing import Any

from springback.quantities import si_number
from springback.scenario.fields import LARGEST_BY_UNIT
from springback.scenario.tables import ThrustSettings
from springback.settings import naming, problem
from springback.simulation.thrusts import ThrustTable
from springback.vehicle.parameters import ROUNDING, Vehicle


def hover_thrusts(vehicle: Vehicle, gravity: float) -> tuple[float, ...]:
    """Weight of a vehicle, shared by all rotors that lift [N]."""
    return vehicle.hover_thrusts(vehicle.mass * gravity)


def thrusts_of(
    vehicle: Vehicle, gravity: float, thrust: Any, is_piloted: bool
) -> tuple[float, ...]:
    """Thrust of each rotor [N].

    Args:
        vehicle: Nominal vehicle.
        gravity: g [m/s²].
        thrust: As given: one for all, a list, ``"hover"``, or a table, whose first row is taken.
        is_piloted: True for a pilot, which starts at the hover thrust.
    """
    count = vehicle.rotor_count
    if isinstance(thrust, ThrustSettings):
        _check_table(vehicle, thrust)
        return thrust.values[0]
    if thrust == "hover" or is_piloted:
        hover = hover_thrusts(vehicle, gravity)
        if not is_piloted:  # else the true weight counts, and is held against it elsewhere
            _check_hover(vehicle, hover)
        return hover
    if not isinstance(thrust, list | tuple):
        with naming("thrust"):
            return (_rotor_thrust(vehicle, thrust),) * count
    if len(thrust) != count:
        raise problem(f"has {len(thrust)} entries for {count} rotors", "thrust")
    found = []
    for k, entry in enumerate(thrust):
        with naming(f"thrust[{k}]"):
            found.append(_rotor_thrust(vehicle, entry))
    return tuple(found)


def _check_hover(vehicle: Vehicle, hover: tuple[float, ...]) -> None:
    """Reject a vehicle that its rotors cannot hold."""
    if vehicle.propulsion is None:
        return
    most = vehicle.propulsion.max_thrust
    for thrust in hover:
        if thrust > most * (1.0 + ROUNDING):
            raise problem(
                f"hover takes {thrust:g} N of a rotor, which must be at most its max_thrust, "
                f"{most:g} N",
                "thrust",
            )


def _rotor_thrust(vehicle: Vehicle, given: Any) -> float:
    """Thrust of a rotor [N], which it can give."""
    thrust, propulsion = si_number(given, "N", least=0.0), vehicle.propulsion
    if propulsion is not None and thrust > propulsion.max_thrust:
        raise problem(
            f"must be at most {propulsion.max_thrust:g} N, the largest thrust of a rotor "
            f"(got {thrust:g} N)"
        )
    if thrust > LARGEST_BY_UNIT["N"]:
        raise problem(f"must be at most {LARGEST_BY_UNIT['N']:g} N (got {thrust:g} N)")
    return thrust


def _check_table(vehicle: Vehicle, thrust: ThrustSettings) -> None:
    """Reject rows of another number of rotors, and thrusts that the rotors cannot give."""
    count = vehicle.rotor_count
    for k, row in enumerate(thrust.values):
        if len(row) != count:
            raise problem(f"has {len(row)} entries for {count} rotors", f"thrust.values[{k}]")
        with naming(f"thrust.values[{k}]"):
            _rotor_thrust(vehicle, max(row))


def thrust_table(thrust: Any) -> ThrustTable | None:
    """Thrusts over time, as `thrusts_of` has checked them; None if they are constant."""
    if not isinstance(thrust, ThrustSettings) or len(set(thrust.values)) == 1:
        return None
    return ThrustTable(thrust.time, thrust.values)

"""Robots of the impact lab: their raw vehicles with the changes of the page, and their labels."""

from __future__ import annotations

from typing import Any

from springback.errors import InputError
from springback.interfaces.lab.settings import LabSettings, digits, is_default
from springback.interfaces.lab.vehicle_controls import (
    SPRINGS,
    VEHICLE_FIELDS,
    Change,
    arm_changes,
    changed_vehicle,
    scaled_inertia,
)
from springback.interfaces.output.robots import robot_label
from springback.scenario.presets import vehicle_table
from springback.vehicle.library import ARQ, VEHICLES
from springback.vehicle.parameters import Vehicle
from springback.vehicle.placed.balance import hover_balance

#: Largest moment of equal thrusts, as a share of that of one rotor, of a balanced vehicle (chosen).
SMALL = 1e-9


def robot_name(settings: LabSettings, robot: str) -> str:
    """Label of a robot on the page and in names of scenarios."""
    if settings.user is None:
        return robot_label(robot)
    label = settings.user.label
    mine = {"mine": label, "file": f"{label} as in file", "twin": f"{label}, rigid"}
    return mine.get(robot) or robot_label(robot)


def vehicle_table_of(settings: LabSettings, robot: str, slides: bool) -> Any:
    """Raw vehicle of a robot: table or preset, with the changes of the page.

    Args:
        settings: Settings of the lab.
        robot: One of `springback.interfaces.lab.scenarios.robots_of`.
        slides: True on the slider, where ARQ and Quad have the paper's bar.
    """
    preset = f"{robot}-slider" if slides else robot
    user = settings.user
    if user is None:
        return changed_vehicle(preset, _preset_changes(settings, robot, preset))
    if robot not in ("mine", "file", "twin"):
        return preset
    raw = user.tables["vehicle"]
    if robot == "file":
        return raw
    changes = _changes(settings, user.vehicle, tuple(VEHICLE_FIELDS))
    locked: list[Change] = [(("arms", "compliant"), False)] if robot == "twin" else []
    return changed_vehicle(raw, changes + locked)


def _changes(s: LabSettings, vehicle: Vehicle, names: tuple[str, ...]) -> list[Change]:
    """Changes of the page to a vehicle whose numbers are the defaults."""
    found: list[Change] = list(arm_changes(vehicle, round(s.arm_count), s.arm_angle))
    for name in names:
        if not is_default(s, name):
            field = VEHICLE_FIELDS[name]
            found.append((field.path, f"{digits(getattr(s, name))} {field.slider.unit}"))
    if s.inertia == "scale" and not is_default(s, "body_mass"):
        found.append((("body", "inertia"), scaled_inertia(vehicle, s.body_mass)))
    return found


def _preset_changes(s: LabSettings, robot: str, preset: str) -> list[Change]:
    """Changes to ARQ or Quad: springs and arm mass are ARQ's alone, body masses change alike."""
    vehicle = VEHICLES[preset].vehicle
    names = ("length", "cage_radius", *(("arm_mass", *SPRINGS) if robot == "arq" else ()))
    found = _changes(s.with_checked(inertia="keep"), vehicle, names)
    if not is_default(s, "body_mass"):
        mass = round(vehicle.body.mass + s.body_mass - ARQ.vehicle.body.mass, 9)
        found.append((("body", "mass"), f"{digits(mass)} kg"))
        if s.inertia == "scale":
            found.append((("body", "inertia"), scaled_inertia(vehicle, mass)))
    return found


def vehicle_of(table: Any) -> Vehicle:
    """Vehicle of a raw table.

    Raises:
        InputError: If it cannot be; one line for each problem, with its field.
    """
    try:
        return Vehicle(**vehicle_table(table))
    except InputError as error:
        raise InputError(*(f"vehicle.{line}" for line in error.problems)) from None


def is_balanced(vehicle: Vehicle) -> bool:
    """True if equal thrusts turn a vehicle about no axis, and push it along body z."""
    if vehicle.rotors:
        if not vehicle.lift > 0.0:
            return False
        found, reach = hover_balance(vehicle), vehicle.reach()
        return max(found.sideways * reach, found.tilting, found.turning) <= SMALL * reach
    arms, count = vehicle.arms, vehicle.arm_count
    ends = [arms.end(j) for j in range(count)]
    shares = [1.0 / count - arms.at("mass", j) / vehicle.mass for j in range(count)]
    signs = arms.spin or [-1 if j % 2 == 0 else 1 for j in range(count)]
    yaw = sum(sign * arms.at("torque_ratio", j) for j, sign in enumerate(signs))
    moments = [sum(c * end[axis] for c, end in zip(shares, ends, strict=True)) for axis in (0, 1)]
    size = max(arms.at("length", j) for j in range(count))
    largest: float = max(abs(x) for x in (*moments, yaw))
    return bool(largest <= SMALL * size)

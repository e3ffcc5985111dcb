"""Controls of a vehicle in the impact lab: which field each sets, and the changed vehicle."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

from springback.interfaces.lab.controls import NoControl, SliderControl, SliderMark
from springback.quantities import number_in
from springback.scenario.fields import fields_of
from springback.scenario.overrides import with_value
from springback.settings import Settings
from springback.vehicle.arms.settings import OF_SLIDES
from springback.vehicle.parameters import Arms, Vehicle
from springback.vehicle.placed.settings import RotorSettings

Change = tuple[tuple[str, ...], Any]
"""Path below ``vehicle``, and the value to set there."""

#: Digits after which a number of a file is rounded for a slider, in the unit of the page.
DIGITS = 9
#: Tolerance for evenly spaced arms [rad].
EVEN = 1e-6


@dataclass(frozen=True)
class VehicleField:
    """A number of a vehicle and its slider; the unit is of the dimension of the field's own."""

    path: tuple[str, ...]
    slider: SliderControl

    @property
    def name(self) -> str:
        """Key of the field."""
        return self.path[-1]

    def values(self, vehicle: Vehicle) -> tuple[float, ...]:
        """Its values in a vehicle, in the unit of the slider: one, or one for each arm."""
        table: Settings = getattr(vehicle, self.path[0])
        found = getattr(table, self.name)
        unit = fields_of(type(table))[self.name].unit
        assert unit is not None
        scale = number_in(f"1 {self.slider.unit}", unit.unit)
        numbers = found if isinstance(found, tuple) else (found,)
        return tuple(round(float(number) / scale, DIGITS) for number in numbers)


def _field(path: str, label: str, unit: str, least: float, most: float, step: float,
           explains: str, **more: Any) -> VehicleField:  # fmt: skip
    slider = SliderControl(
        unit, label=label, least=least, most=most, step=step, explains=explains,
        path=f"vehicle.{path}", **more,
    )  # fmt: skip
    return VehicleField(tuple(path.split(".")), slider)


#: Numbers of a vehicle by the name of their setting; ranges are chosen, and contain the user's.
VEHICLE_FIELDS = {
    "body_mass": _field(
        "body.mass", "Body mass", "kg", 0.1, 5.0, 0.01, "Of the main body, without arms.",
        group="Body", logarithmic=True,
    ),
    "length": _field(
        "arms.length", "Arm length L", "mm", 80.0, 500.0, 1.0,
        "From the centre to the end of an arm. The arms' share of the inertia follows.",
        group="Arms",
    ),
    "cage_radius": _field(
        "arms.cage_radius", "Cage radius r₀", "mm", 20.0, 250.0, 1.0,
        "Of the guard around each rotor; cages must not overlap.", group="Arms",
    ),
    "arm_mass": _field(
        "arms.mass", "Arm mass m_a", "g", 10.0, 200.0, 1.0,
        "Of each arm; the main body keeps its own.", group="Arms",
    ),
    "stiffness": _field(
        "arms.stiffness", "Arm stiffness k_l", "N/mm", 0.5, 50.0, 0.1, "Of each arm's spring.",
        group="Springs", logarithmic=True,
    ),
    "damping": _field(
        "arms.damping", "Arm damping b_l", "N s/m", 0.0, 300.0, 1.0, "Of each arm.",
        group="Springs",
    ),
    "stroke": _field(
        "arms.stroke", "Stroke", "mm", 1.0, 150.0, 1.0,
        "Largest compression of an arm, where its end stop acts.", group="Springs",
    ),
    "stop_stiffness": _field(
        "arms.stop_stiffness", "Stiffness of the stops", "N/mm", 10.0, 2000.0, 1.0,
        "Of both end stops of each arm.", group="Springs", logarithmic=True,
    ),
    "stop_dissipation": _field(
        "arms.stop_dissipation", "Dissipation of the stops", "s/m", 0.0, 5.0, 0.05,
        "Coefficient d of their force k δ (1 + d δ̇).", group="Springs",
    ),
}  # fmt: skip
#: Those of springs: they act on compliant arms only.
SPRINGS = ("stiffness", "damping", "stroke", "stop_stiffness", "stop_dissipation")


def control_for(name: str, vehicle: Vehicle, words: str) -> tuple[SliderControl | NoControl, float]:
    """Control of a number of a vehicle, and its default: that of the vehicle, which is marked.

    The range is widened to contain it.  Numbers that differ between arms cannot be set by one.

    Args:
        name: Of `VEHICLE_FIELDS`.
        vehicle: Vehicle as it is in the file.
        words: Source of its numbers, beside the mark.
    """
    field = VEHICLE_FIELDS[name]
    if field.name in OF_SLIDES and vehicle.arms.joint is not None:
        why = f"the arms are on a {vehicle.arms.joint.type}, which has its own; kept as in the file"
        return no_control(field.slider, why), 0.0
    slider, values = field.slider, field.values(vehicle)
    value = values[0]
    if any(one != value for one in values):
        why = f"arms differ, {min(values):g} to {max(values):g} {slider.unit}; kept as in the file"
        return no_control(slider, why), 0.0
    least, most = slider.least, slider.most
    if not least <= value <= most:
        least = min(least, round(value / 2.0, DIGITS)) or least
        most = max(most, round(2.0 * value, DIGITS))
    step = min(slider.step, 10.0 ** math.floor(math.log10(value) - 1.0)) if value else slider.step
    marks = (SliderMark(value, words),)
    return replace(slider, least=least, most=most, step=step, marks=marks), value


def no_control(slider: SliderControl, why: str) -> NoControl:
    """A slider's place with the reason why it is none."""
    return NoControl(
        slider.unit, label=slider.label, explains=why, group=slider.group, when=slider.when
    )


# -- directions -----------------------------------------------------------------------------------


def spacing(directions: tuple[float, ...]) -> float | None:
    """Angle from each arm to the next, a whole part of a turn [rad]; None if they are uneven.

    Args:
        directions: Angles of the arms [rad].
    """
    count = len(directions)
    steps = [
        math.remainder(after - before, math.tau) for before, after in itertools.pairwise(directions)
    ]
    for turn in (-math.tau / count, math.tau / count):
        if all(abs(math.remainder(step - turn, math.tau)) < EVEN for step in steps):
            return turn
    return None


def first_angle(vehicle: Vehicle) -> float:
    """Direction of the first arm [deg], from −180 to 180."""
    return round(math.degrees(math.remainder(vehicle.arms.directions[0], math.tau)), DIGITS) + 0.0


def why_fixed_count(vehicle: Vehicle) -> str:
    """Reason why the number of arms cannot be changed; empty if it can."""
    arms = vehicle.arms
    if vehicle.rotors:
        return "rotors are listed one by one; the number of arms is kept as in the file"
    if spacing(arms.directions) is None:
        return "arms are not evenly spaced one after another; their number is kept as in the file"
    for name in fields_of(Arms):
        value = getattr(arms, name)
        if name not in ("directions", "spin") and isinstance(value, tuple) and len({*value}) > 1:
            return f"arms differ in {name}; their number is kept as in the file"
    if arms.joint is not None and arms.joint.differs:
        return "arms differ in their joints; their number is kept as in the file"
    if arms.spin and any(a == b for a, b in itertools.pairwise(arms.spin)):
        return "spins do not alternate; the number of arms is kept as in the file"
    return ""


def arm_changes(vehicle: Vehicle, count: int, angle: float) -> Iterator[Change]:
    """Changes to a vehicle with another number of arms, or other directions.

    Args:
        vehicle: Vehicle as it is in the file.
        count: Number of arms; evenly spaced if it differs.
        angle: Direction of the first [deg].
    """
    arms, before = vehicle.arms, first_angle(vehicle)
    if count != vehicle.arm_count:
        turn = math.copysign(360.0 / count, spacing(arms.directions) or 1.0)
        yield ("arms", "directions"), [_degrees(angle + k * turn) for k in range(count)]
        for name in fields_of(Arms):
            value = getattr(arms, name)
            if isinstance(value, tuple) and name not in ("directions", "spin"):
                yield ("arms", name), value[0]
        if arms.spin:
            yield ("arms", "spin"), [arms.spin[0] * (-1) ** k for k in range(count)]
    elif angle != before:
        turned = (math.degrees(one) + angle - before for one in arms.directions)
        yield ("arms", "directions"), [_degrees(one) for one in turned]
        if vehicle.rotors:
            turn = math.radians(angle - before)
            yield ("rotors",), [_turned_rotor(one, turn) for one in vehicle.rotors]


def _turned_rotor(rotor: RotorSettings, angle: float) -> dict[str, Any]:
    """A rotor of a raw vehicle, turned about body z by an angle [rad]."""
    given = rotor.model_dump(exclude_unset=True)
    for name in ("position", "axis"):
        if (vector := getattr(rotor, name)) is not None:
            x, y, z = vector
            c, s = math.cos(angle), math.sin(angle)
            given[name] = [c * x - s * y, s * x + c * y, z]
    return given


def _degrees(angle: float) -> str:
    """Angle [deg] within half a turn, as text."""
    return f"{round(math.remainder(angle, 360.0), DIGITS) + 0.0!r} deg"


# -- changed vehicles -----------------------------------------------------------------------------


def scaled_inertia(vehicle: Vehicle, body_mass: float) -> list[list[float]]:
    """Inertia of the main body at another mass of the same shape [kg m²], shape (3, 3).

    Its radii of gyration stay, so that I = m k² (Goldstein, Classical Mechanics, chapter 5) is
    proportional to the mass.

    Args:
        vehicle: Vehicle with inertia and mass that belong together.
        body_mass: New mass of the main body [kg].
    """
    share = body_mass / vehicle.body.mass
    return [[share * entry for entry in row] for row in vehicle.body.inertia]


def changed_vehicle(table: Any, changes: list[Change]) -> Any:
    """A raw vehicle, or the name of a preset, with changes."""
    for path, value in changes:
        table = with_value(table, path, value, ".".join(("vehicle", *path)))
    return table

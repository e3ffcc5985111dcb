"""Sliders for the second vehicle of the user's own scenario: its start, and its springs."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Annotated, Any

from springback.interfaces.lab.controls import NoControl, SliderControl, SliderMark
from springback.interfaces.lab.settings import LabSettings, When, digits, is_default
from springback.interfaces.lab.user_scenario import UserScenario
from springback.interfaces.lab.vehicle_controls import VEHICLE_FIELDS, changed_vehicle, control_for
from springback.scenario.tables import SecondVehicle

#: Digits kept of numbers taken from a file, in the unit of the page (chosen).
DIGITS = 6
#: How far its start may be moved along each axis [m], and the least range of its speed [m/s]
#: (chosen).
AROUND, FASTEST = 2.0, 6.0
#: Where the sliders have an effect: an impact or a flight of the page's own has one vehicle.
_AS_IN_FILE: When = {"mode": ("file",)}
_AXES = ("x", "y", "z")

Table = dict[str, Any]


def second_fields(user: UserScenario, words: str) -> dict[str, Any]:
    """Settings for the second vehicle, by name; none without one.

    Args:
        user: The scenario.
        words: Source of its numbers, beside the marks.
    """
    second = user.scenario.second
    if second is None:
        return {}
    start, found = second.start, dict[str, Any]()

    def slider(name: str, value: float, unit: str, **control: Any) -> None:
        marks = (SliderMark(value, words),)
        made = SliderControl(
            unit, group=f"Second vehicle, {second.name}", when=_AS_IN_FILE, marks=marks, **control
        )
        found[f"second_{name}"] = Annotated[float, made], value

    speed = _rounded(math.hypot(*start.velocity))
    if speed:
        slider(
            "speed", speed, "m/s", label="Speed", least=0.0, most=max(FASTEST, 2.0 * speed),
            step=0.05, explains="Of its start, in the direction of the file.",
            path="second.start.velocity",
        )  # fmt: skip
    for axis, place in zip(_AXES, start.position, strict=True):
        value = _rounded(place)
        slider(
            axis, value, "m", label=f"Start, {axis}", least=value - AROUND, most=value + AROUND,
            step=0.01, explains="Of its main body, world axes.", path="second.start.position",
        )  # fmt: skip
    slider(
        "yaw", _yaw(second), "deg", label="Yaw", least=-180.0, most=180.0, step=1.0,
        explains="Of its start, in world axes.", path="second.start.yaw",
    )  # fmt: skip
    if second.vehicle.is_compliant:
        control, value = control_for("stiffness", second.vehicle, words)
        own: SliderControl | NoControl = replace(
            control, group=f"Second vehicle, {second.name}", when=_AS_IN_FILE
        )
        if isinstance(own, SliderControl):
            own = replace(own, path="second.vehicle.arms.stiffness")
        found["second_stiffness"] = Annotated[float, own], value
    return found


def is_second_default(settings: LabSettings) -> bool:
    """True if the second vehicle, if there is one, is as in the file."""
    return is_default(settings, *_names(settings))


def second_table(settings: LabSettings, user: UserScenario) -> Table:
    """Raw second vehicle of the file, with the changes of the page."""
    second, found = user.scenario.second, dict(user.tables["second"])
    assert second is not None
    changed = [name for name in _names(settings) if not is_default(settings, name)]
    values = {name.removeprefix("second_"): getattr(settings, name) for name in changed}
    if "stiffness" in values:
        field = VEHICLE_FIELDS["stiffness"]
        text = f"{digits(values.pop('stiffness'))} {field.slider.unit}"
        found["vehicle"] = changed_vehicle(found["vehicle"], [(field.path, text)])
    if not values:
        return found
    start, given = second.start, dict(found.get("start", {}))
    if "speed" in values:
        share = values["speed"] / math.hypot(*start.velocity)
        given["velocity"] = [share * v for v in start.velocity]
    if values.keys() & set(_AXES):
        place = zip(_AXES, start.position, strict=True)
        given["position"] = [values.get(axis, here) for axis, here in place]
    if "yaw" in values:
        if given.pop("quaternion", None):
            given |= dict(zip(("roll", "pitch"), start.angles()[:2], strict=True))
        given["yaw"] = f"{digits(values['yaw'])} deg"
    return found | {"start": given}


def _names(settings: LabSettings) -> list[str]:
    return [name for name in type(settings).model_fields if name.startswith("second_")]


def _yaw(second: SecondVehicle) -> float:
    return _rounded(math.degrees(math.remainder(second.start.angles()[2], math.tau)))


def _rounded(number: float) -> float:
    return float(f"{number:.{DIGITS}g}") + 0.0

"""Settings of the lab for the user's own scenario: its numbers as defaults, its robot to choose."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated, Any

from pydantic import create_model

from springback.contact.library import SURFACES
from springback.contact.parameters import SurfaceSettings
from springback.interfaces.lab.controls import ChoiceControl, SliderControl, SliderMark
from springback.interfaces.lab.second_vehicle import second_fields
from springback.interfaces.lab.settings import (
    ARM_ANGLE,
    ARM_COUNT,
    LabSettings,
    When,
    control_of,
)
from springback.interfaces.lab.user_scenario import UserScenario
from springback.interfaces.lab.vehicle_controls import (
    SPRINGS,
    VEHICLE_FIELDS,
    control_for,
    first_angle,
    no_control,
    why_fixed_count,
)
from springback.interfaces.output.robots import ROBOTS

WORDS = "your file"
_OURS: When = {"mode": ("impact", "flight")}
_MINE: When = {"robot": ("mine",)}


def user_settings(user: UserScenario) -> type[LabSettings]:
    """Table of settings for a scenario of the user's own."""
    fields: dict[str, Any] = {
        "mode": _modes(user),
        "robot": _robots(user),
        "beside": _others(user),
        "guide": _guides(user),
        "speed": _collision(user, "speed", user.speed),
        "pitch": _collision(user, "pitch", user.pitch),
        "yaw": _collision(user, "yaw", user.yaw),
        **_start_yaw(user),
        **_surfaces(user),
        **_vehicle(user),
        **second_fields(user, WORDS),
    }
    table: type[LabSettings] = create_model("UserLabSettings", __base__=LabSettings, **fields)
    table.user = user
    return table


def _modes(user: UserScenario) -> Any:
    words = {"file": "As in file", "impact": "Impact", "flight": "Flight"}
    explains = (
        "As in file: your start, obstacles and pilot. Impact: the collision alone, straight into "
        "one obstacle with constant thrust. Flight: run-up, collision and recovery, with our pilot."
    )
    default = "impact" if user.is_piloted and user.scenario.second is None else "file"
    return Annotated[str, ChoiceControl("Fly", words, explains)], default


def _robots(user: UserScenario) -> Any:
    words = {"mine": user.label, **{name: robot.label for name, robot in ROBOTS.items()}}
    explains = f"{user.label} is the vehicle of your file; ARQ and Quad are the paper's."
    return Annotated[str, ChoiceControl("Robot", words, explains, "Robot")], "mine"


def _others(user: UserScenario) -> Any:
    words = {
        "none": "Nothing", "file": "as in the file", "twin": "its rigid twin",
        **{name: robot.label for name, robot in ROBOTS.items()},
    }  # fmt: skip
    explains = "A second robot, in the same collision. The rigid twin has its arms locked."
    return Annotated[str, ChoiceControl("Compare with", words, explains, "Robot")], "none"


def _guides(user: UserScenario) -> Any:
    control = control_of("guide")
    assert isinstance(control, ChoiceControl)
    explains = (
        "Slider: along X, without rotors; your vehicle has no bar. Nothing: free flight at hover "
        "thrust, or with the rotors off if equal thrusts would turn the vehicle."
    )
    default = "free" if user.scenario.model.slider is None else "slider"
    return Annotated[str, replace(control, explains=explains)], default


def _collision(user: UserScenario, name: str, value: float | None) -> Any:
    """Speed, pitch or yaw of the collision."""
    control = control_of(name)
    assert isinstance(control, SliderControl)
    when: dict[str, tuple[str, ...]] = {}
    movable = user.run_up is not None if user.is_piloted else value is not None
    if not movable or name == "yaw":
        when = {"mode": ("impact", "flight")}
    explains = {
        "speed": "Of the start, or of the run-up; of an impact, into the obstacle at first touch.",
        "pitch": "Of the start, or of the run-up. Positive is nose down.",
        "yaw": "Of the robot against the obstacle, not of the world. In flight the obstacle is "
        "turned, and the robot hits it at an angle.",
    }
    if value is None:
        return Annotated[float, replace(control, when=when)], LabSettings().speed
    least, most = min(control.least, value / 2), max(control.most, 2 * value)
    if name != "speed":
        limit = {"pitch": max(control.most, abs(value)), "yaw": 180.0}[name]
        least, most = -limit, limit
    marks = tuple(mark for mark in control.marks if mark.value != value)
    marks = (SliderMark(value, WORDS), *marks) if name != "yaw" else (SliderMark(value, WORDS),)
    label = "Yaw against the obstacle" if name == "yaw" else control.label
    return Annotated[float, replace(
        control, least=least, most=most, marks=marks, when=when, explains=explains[name],
        label=label,
    )], value  # fmt: skip


def _start_yaw(user: UserScenario) -> dict[str, Any]:
    """Yaw of the file's start, in the world's axes as in the file; none where a pilot begins."""
    if user.is_piloted:
        return {}
    value = user.start_yaw
    control = SliderControl(
        "deg", label="Yaw of the start", least=-180.0, most=180.0, step=1.0, group="Collision",
        marks=(SliderMark(value, WORDS),), when={"mode": ("file",)}, path="start.yaw",
        explains="As in the file, in the world's axes: at 0 the robot faces north, along x; "
        "positive is to the left.",
    )  # fmt: skip
    return {"start_yaw": (Annotated[float, control], value)}


# -- surfaces -------------------------------------------------------------------------------------


def _surfaces(user: UserScenario) -> dict[str, Any]:
    """Choice of the surface, and the numbers of one's own, from the file where it has them."""
    control = control_of("surface")
    assert isinstance(control, ChoiceControl)
    found: dict[str, Any]
    if user.surface is None:  # of none of its obstacles
        found = {"surface": (Annotated[str, replace(control, when=_OURS)], LabSettings().surface)}
        for name in own_surface(SURFACES["wall"]):
            slider = control_of(name)
            found[name] = (
                Annotated[float, replace(slider, when={**slider.when, **_OURS})],
                getattr(LabSettings(), name),
            )
        return found
    kinds = user.surface_types
    is_of_one = len(kinds) == 1 and kinds <= {"wall", "mat"}
    words = {"file": f"Your {min(kinds)}" if is_of_one else "As in file", **control.words}
    explains = (
        f"{words['file']}: what your file says. Wall and mat: those of Table II. Own: the numbers "
        f"below. The last three are put on every obstacle of your file, "
        f"{'but for nets' if 'ground' in kinds else 'but for ground and nets'}."
    )
    found = {"surface": (Annotated[str, replace(control, words=words, explains=explains)], "file")}
    for name, value in own_surface(user.surface).items():
        slider = control_of(name)
        assert isinstance(slider, SliderControl)
        least, most = slider.least, slider.most
        if not least <= value <= most:
            least, most = min(least, value / 2), max(most, 2 * value)
        marks = (SliderMark(value, WORDS), *(m for m in slider.marks if m.value != value))
        slider = replace(slider, least=least, most=most, marks=marks)
        found[name] = (Annotated[float, slider], value)
    return found


def own_surface(surface: SurfaceSettings) -> dict[str, float]:
    """Numbers of a Hunt–Crossley surface in the units of the page; of others only the friction."""
    found = {"friction": surface.friction}
    if surface.law == "hunt-crossley" and surface.exponent == 1.5:
        found["contact_stiffness"] = round(1e-3 * surface.stiffness, 9)
        found["dissipation"] = round(surface.dissipation_value(), 6)
    return found


# -- vehicle --------------------------------------------------------------------------------------


def _vehicle(user: UserScenario) -> dict[str, Any]:
    """Controls of the vehicle, with the file's numbers as defaults."""
    fields: dict[str, Any] = {}
    for name in VEHICLE_FIELDS:
        control, value = control_for(name, user.vehicle, WORDS)
        if name in SPRINGS and not user.vehicle.is_compliant:
            control, value = no_control(_slider(name), "no arm of your vehicle is compliant"), 0.0
        fields[name] = (Annotated[float, replace(control, when=_MINE)], value)
    count, angle = user.vehicle.arm_count, first_angle(user.vehicle)
    counts: Any = replace(
        ARM_COUNT, when=_MINE, most=max(ARM_COUNT.most, float(count)),
        marks=(SliderMark(float(count), WORDS),), least=min(ARM_COUNT.least, float(count)),
    )  # fmt: skip
    if why := why_fixed_count(user.vehicle):
        counts = no_control(counts, why)
    fields["arm_count"] = (Annotated[float, counts], float(count))
    turned = replace(ARM_ANGLE, when=_MINE, marks=(SliderMark(angle, WORDS),))
    fields["arm_angle"] = (Annotated[float, turned], angle)
    kept = control_of("inertia")
    fields["inertia"] = (Annotated[str, replace(kept, when=_MINE)], "keep")
    return fields


def _slider(name: str) -> SliderControl:
    return VEHICLE_FIELDS[name].slider

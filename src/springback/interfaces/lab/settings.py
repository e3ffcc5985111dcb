"""What can be set in the impact lab: one table of knobs, from which page, checks and links follow.

Every number of the lab stands here once, in the unit in which the page shows it: its range, its
step, its default, and the values of the paper that are marked beside it, which come from where the
package keeps them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, get_args
from urllib.parse import quote

from pydantic import ValidationError
from pydantic.fields import FieldInfo

from springback.contact.library import SURFACES
from springback.errors import InputError
from springback.interfaces.lab.controls import (
    ChoiceControl,
    SliderControl,
    SliderMark,
    choice_control,
    shortened,
    slider_control,
)
from springback.interfaces.output.robots import ROBOTS
from springback.paper.printed import SLIDER_SPEED, SWEEP_SPEEDS
from springback.problems import problem_paths
from springback.recovery.parameters import Answering
from springback.settings import Settings
from springback.studies.run_ups import CONDITIONS
from springback.vehicle.library import ARQ

When = Mapping[str, tuple[str, ...]]
#: Letters of all settings together that are looked at at all (chosen).
LONGEST_QUERY = 800

WAYS: tuple[str, ...] = get_args(Answering.model_fields["way"].annotation)


_ARMS, _WALL, _MAT = ARQ.vehicle.arms, SURFACES["wall"], SURFACES["mat"]
_IMPACT: When = {"mode": ("impact",)}
_FLIGHT: When = {"mode": ("flight",)}
_OWN: When = {"surface": ("own",)}
_COMPLIANT: When = {"robot": ("both", "arq")}
_TESTED = sorted({speed for _, speed in CONDITIONS})
_SPEEDS = (
    SliderMark(SLIDER_SPEED, "paper: slider tests, section IV-A"),
    *(SliderMark(speed, "paper: collisions in flight, Impact Resilience") for speed in _TESTED),
    SliderMark(SWEEP_SPEEDS[-1], "paper: fastest of the speed sweep"),
)
_PITCHES = tuple(
    SliderMark(pitch, "paper: Impact Resilience")
    for pitch in sorted({pitch for pitch, _ in CONDITIONS})
)


def _fitted(surface: Any) -> float:
    """c_a of a surface of the library, to the step of its knob [s/m]."""
    return round(float(surface.dissipation_value()), 3)


Modes = choice_control(
    ("impact", "flight"),
    ChoiceControl(
        "What to fly",
        {"impact": "Impact", "flight": "Flight"},
        "Impact: the collision alone, rotors as before it. Flight: run-up, collision and recovery, "
        "with a pilot aboard.",
    ),
)
Robots = choice_control(
    ("both", "arq", "quad"),
    ChoiceControl(
        "Robot",
        {"both": "Both", **{name: robot.label for name, robot in ROBOTS.items()}},
        "ARQ has springs in its arms; Quad is its rigid twin.",
        "Robot",
    ),
)
Guides = choice_control(
    ("slider", "free"),
    ChoiceControl(
        "Guided by",
        {"slider": "Slider", "free": "Nothing"},
        "Slider: the paper's testbed, along X, with its bar's mass and no rotors. Nothing: the "
        "robots as flown, hovering.",
        "Collision",
        _IMPACT,
    ),
)
Surfaces = choice_control(
    ("wall", "mat", "own"),
    ChoiceControl(
        "Surface",
        {"wall": "Wall", "mat": "Mat", "own": "Own"},
        "Wall and mat are Table II's; a mat lies before the wall. Own: a wall of your numbers.",
        "Surface",
    ),
)
Recoveries = choice_control(
    ("none", *WAYS),
    ChoiceControl(
        "Recovery",
        {"none": "None: flies on", **{way: way.capitalize() for way in WAYS}},
        "How the pilot answers a collision; the paper's is pre-impact.",
        "Collision",
        _FLIGHT,
    ),
)


class LabSettings(Settings):
    """The settings of the impact lab, in the units of its page."""

    mode: Modes = "impact"  # type: ignore[valid-type]
    robot: Robots = "both"  # type: ignore[valid-type]
    guide: Guides = "slider"  # type: ignore[valid-type]
    speed: slider_control(  # type: ignore[valid-type]
        SliderControl(
            "Speed", "m/s", 0.5, 6.0, 0.05, "Into the wall, at first touch.", _SPEEDS, "Collision"
        )
    ) = SLIDER_SPEED
    pitch: slider_control(  # type: ignore[valid-type]
        SliderControl(
            "Pitch", "deg", -60.0, 60.0, 1.0, "Positive is nose down.", _PITCHES, "Collision"
        )
    ) = 0.0
    yaw: slider_control(  # type: ignore[valid-type]
        SliderControl(
            "Yaw", "deg", -45.0, 45.0, 1.0,
            "Of the robot against the wall; at 45 deg one arm meets it. In flight the wall is "
            "turned, and the robot meets it aslant.",
            (SliderMark(0.0, "paper: all tests"),), "Collision",
        )
    ) = 0.0  # fmt: skip
    recovery: Recoveries = "pre-impact"  # type: ignore[valid-type]
    surface: Surfaces = "wall"  # type: ignore[valid-type]
    contact_stiffness: slider_control(  # type: ignore[valid-type]
        SliderControl(
            "Contact stiffness k_c", "kN/m^1.5", 20.0, 1000.0, 1.0, "Of the whole front.",
            (
                SliderMark(1e-3 * float(_MAT.stiffness), "paper: mat, Table II"),
                SliderMark(1e-3 * float(_WALL.stiffness), "paper: wall, Table II"),
            ),
            "Surface", _OWN, logarithmic=True,
        )
    ) = 1e-3 * float(_WALL.stiffness)  # fmt: skip
    dissipation: slider_control(  # type: ignore[valid-type]
        SliderControl(
            "Dissipation c_a", "s/m", 0.0, 1.0, 0.001, "Of the Hunt-Crossley law; 0 loses nothing.",
            (
                SliderMark(_fitted(_MAT), "mat: fitted to Quad's restitution in Table III"),
                SliderMark(_fitted(_WALL), "wall: fitted to Quad's restitution in Table III"),
            ),
            "Surface", _OWN,
        )
    ) = _fitted(_WALL)  # fmt: skip
    friction: slider_control(  # type: ignore[valid-type]
        SliderControl(
            "Friction μ", "", 0.0, 1.5, 0.05,
            "Coulomb's, along the surface. Where two cages touch at once it holds them, and arms "
            "at 45 deg cannot give way; turn the robot by 10 deg and they can. On the slider it "
            "acts along the vertical only, as in the paper.",
            (SliderMark(float(_WALL.friction), "paper: Table II"),), "Surface", _OWN,
        )
    ) = float(_WALL.friction)  # fmt: skip
    stiffness: slider_control(  # type: ignore[valid-type]
        SliderControl(
            "Arm stiffness k_l", "N/mm", 0.5, 50.0, 0.1, "Of each arm's spring.",
            (SliderMark(1e-3 * float(_ARMS.stiffness), "paper: Table II"),), "Arms of ARQ",
            _COMPLIANT,
            logarithmic=True,
        )
    ) = 1e-3 * float(_ARMS.stiffness)  # fmt: skip
    damping: slider_control(  # type: ignore[valid-type]
        SliderControl(
            "Arm damping b_l", "N s/m", 0.0, 300.0, 1.0, "Of each arm.",
            (SliderMark(float(_ARMS.damping), "paper: Table II"),), "Arms of ARQ", _COMPLIANT,
        )
    ) = float(_ARMS.damping)  # fmt: skip
    arm_mass: slider_control(  # type: ignore[valid-type]
        SliderControl(
            "Arm mass m_a", "g", 10.0, 200.0, 1.0, "Of each arm; the main body keeps its own.",
            (SliderMark(round(1e3 * float(_ARMS.mass), 9), "paper: Table II, 0.2 kg for four"),),
            "Arms of ARQ", _COMPLIANT,
        )
    ) = round(1e3 * float(_ARMS.mass), 9)  # fmt: skip


FIELDS: dict[str, FieldInfo] = LabSettings.model_fields
DEFAULTS = LabSettings()


def control_of(name: str) -> SliderControl | ChoiceControl:
    """The knob or choice of a setting."""
    found: SliderControl | ChoiceControl = next(
        data for data in FIELDS[name].metadata if isinstance(data, SliderControl | ChoiceControl)
    )
    return found


def controls() -> list[dict[str, Any]]:
    """All that the page needs to know of every setting, in plain data."""
    found = []
    for name, told in FIELDS.items():
        control = control_of(name)
        kind = "knob" if isinstance(control, SliderControl) else "choice"
        data: dict[str, Any] = {"name": name, "kind": kind, "default": told.default}
        data |= control._asdict() | {"when": dict(control.when)}
        if isinstance(control, SliderControl):
            data["marks"] = [mark._asdict() for mark in control.marks]
        found.append(data)
    return found


def settings_from(pairs: Iterable[tuple[str, str]]) -> LabSettings:
    """Settings from the pairs of a query, checked.

    Raises:
        InputError: One line for each problem, with field, value, unit and range.
    """
    given: dict[str, str] = {}
    for name, value in pairs:
        if name in given:
            raise InputError(f"{shortened(name)}: is given twice; give it once")
        given[shortened(name)] = value
    try:
        return LabSettings.model_validate(given)
    except ValidationError as error:
        raise InputError(*(_line(path, what) for path, what in problem_paths(error))) from None


def _line(path: tuple[str | int, ...], what: str) -> str:
    """A problem with its field and, of a knob, the whole range."""
    name = str(path[0]) if path else ""
    line = f"{name}: {what}" if name else what
    if name in FIELDS and isinstance(how := control_of(name), SliderControl):
        return f"{line}; {shown(how.least)} to {shown(how.most)} {how.unit}".rstrip()
    return line


def shown(number: float) -> str:
    """A number as short as it can be said to the last bit: 5 for 5.0."""
    return repr(number).removesuffix(".0")


def query_of(settings: LabSettings) -> str:
    """The canonical query: what differs from the defaults, in the order of the table."""
    told = []
    for name in FIELDS:
        value = getattr(settings, name)
        if value != getattr(DEFAULTS, name):
            text = shown(value) if isinstance(value, float) else value
            told.append(f"{name}={quote(text, safe='')}")
    return "&".join(told)

"""Settings of the impact lab: one table from which page, validation and links follow.

Every number of the lab is here once, in the unit of the page: its range, step and default, and the
paper's values marked beside it, which come from the modules that define them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Annotated, Any
from urllib.parse import quote

from pydantic import ValidationError

from springback.contact.library import SURFACES
from springback.errors import InputError
from springback.interfaces.lab.controls import (
    ChoiceControl,
    SliderControl,
    SliderMark,
    excerpt,
)
from springback.interfaces.output.robots import ROBOTS
from springback.paper.printed import SLIDER_SPEED, SWEEP_SPEEDS
from springback.problems import problem_paths
from springback.recovery.parameters import Answering
from springback.scenario.fields import fields_of
from springback.settings import Settings
from springback.studies.run_ups import CONDITIONS
from springback.vehicle.library import ARQ

When = Mapping[str, tuple[str, ...]]
#: Longest query that is read [characters] (chosen).
LONGEST_QUERY = 800

WAYS = fields_of(Answering)["way"].words


_WALL, _MAT = SURFACES["wall"], SURFACES["mat"]
_ARMS: dict[str, Any] = ARQ.vehicle.arms.model_dump()  # the same for all four
_STIFFNESS, _DAMPING = 1e-3 * _ARMS["stiffness"], _ARMS["damping"]  # [N/mm], [N s/m]
_ARM_MASS = round(1e3 * _ARMS["mass"], 9)  # [g]
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


def _dissipation(surface: Any) -> float:
    """c_a of a surface of the library, rounded to the step of its slider [s/m]."""
    return round(float(surface.dissipation_value()), 3)


Modes = Annotated[
    str,
    ChoiceControl(
        "What to fly",
        {"impact": "Impact", "flight": "Flight"},
        "Impact: the collision alone, with constant thrust. Flight: run-up, collision and "
        "recovery, with a pilot.",
    ),
]
Robots = Annotated[
    str,
    ChoiceControl(
        "Robot",
        {"both": "Both", **{name: robot.label for name, robot in ROBOTS.items()}},
        "ARQ has springs in its arms; Quad is its rigid twin.",
        "Robot",
    ),
]
Guides = Annotated[
    str,
    ChoiceControl(
        "Guided by",
        {"slider": "Slider", "free": "Nothing"},
        "Slider: the paper's test bench, along X, with the mass of its bar and without rotors. "
        "Nothing: free flight at hover thrust.",
        "Collision",
        _IMPACT,
    ),
]
Surfaces = Annotated[
    str,
    ChoiceControl(
        "Surface",
        {"wall": "Wall", "mat": "Mat", "own": "Own"},
        "Wall and mat are those of Table II; the mat is in front of the wall. Own: a wall with "
        "your numbers.",
        "Surface",
    ),
]
Recoveries = Annotated[
    str,
    ChoiceControl(
        "Recovery",
        {"none": "None: flies on", **{way: way.capitalize() for way in WAYS}},
        "Response of the pilot to a collision; the paper's is pre-impact.",
        "Collision",
        _FLIGHT,
    ),
]


class LabSettings(Settings):
    """Settings of the impact lab, in the units of its page."""

    mode: Modes = "impact"
    robot: Robots = "both"
    guide: Guides = "slider"
    speed: Annotated[float, SliderControl(
        "m/s", label="Speed", least=0.5, most=6.0, step=0.05, group="Collision",
        marks=_SPEEDS, explains="Into the wall, at first touch.",
    )] = SLIDER_SPEED  # fmt: skip
    pitch: Annotated[float, SliderControl(
        "deg", label="Pitch", least=-60.0, most=60.0, step=1.0, group="Collision",
        marks=_PITCHES, explains="Positive is nose down.",
    )] = 0.0  # fmt: skip
    yaw: Annotated[float, SliderControl(
        "deg", label="Yaw", least=-45.0, most=45.0, step=1.0, group="Collision",
        marks=(SliderMark(0.0, "paper: all tests"),),
        explains="Of the robot relative to the wall; at 45 deg one arm hits it. In flight the wall "
        "is turned, and the robot hits it at an angle.",
    )] = 0.0  # fmt: skip
    recovery: Recoveries = "pre-impact"
    surface: Surfaces = "wall"
    contact_stiffness: Annotated[float, SliderControl(
        "kN/m^1.5", label="Contact stiffness k_c", least=20.0, most=1000.0, step=1.0,
        group="Surface",
        marks=(
            SliderMark(1e-3 * _MAT.stiffness, "paper: mat, Table II"),
            SliderMark(1e-3 * _WALL.stiffness, "paper: wall, Table II"),
        ),
        when=_OWN, logarithmic=True, explains="Of the whole front.",
    )] = 1e-3 * _WALL.stiffness  # fmt: skip
    dissipation: Annotated[float, SliderControl(
        "s/m", label="Dissipation c_a", least=0.0, most=1.0, step=0.001, group="Surface",
        marks=(
            SliderMark(_dissipation(_MAT), "mat: fitted to Quad's restitution in Table III"),
            SliderMark(_dissipation(_WALL), "wall: fitted to Quad's restitution in Table III"),
        ),
        when=_OWN, explains="Of the Hunt-Crossley law; 0 loses no energy.",
    )] = _dissipation(_WALL)  # fmt: skip
    friction: Annotated[float, SliderControl(
        "", label="Friction μ", least=0.0, most=1.5, step=0.05, group="Surface",
        marks=(SliderMark(_WALL.friction, "paper: Table II"),), when=_OWN,
        explains="Coulomb friction along the surface. Where two cages touch at once it holds both, "
        "and arms at 45 deg cannot compress; turn the robot by 10 deg and they can. On the slider "
        "it acts along the vertical only, as in the paper.",
    )] = _WALL.friction  # fmt: skip
    stiffness: Annotated[float, SliderControl(
        "N/mm", label="Arm stiffness k_l", least=0.5, most=50.0, step=0.1, group="Arms of ARQ",
        marks=(SliderMark(_STIFFNESS, "paper: Table II"),), when=_COMPLIANT, logarithmic=True,
        explains="Of each arm's spring.",
    )] = _STIFFNESS  # fmt: skip
    damping: Annotated[float, SliderControl(
        "N s/m", label="Arm damping b_l", least=0.0, most=300.0, step=1.0, group="Arms of ARQ",
        marks=(SliderMark(_DAMPING, "paper: Table II"),), when=_COMPLIANT,
        explains="Of each arm.",
    )] = _DAMPING  # fmt: skip
    arm_mass: Annotated[float, SliderControl(
        "g", label="Arm mass m_a", least=10.0, most=200.0, step=1.0, group="Arms of ARQ",
        marks=(SliderMark(_ARM_MASS, "paper: Table II, 0.2 kg for four"),), when=_COMPLIANT,
        explains="Of each arm; the main body keeps its own.",
    )] = _ARM_MASS  # fmt: skip


FIELDS = fields_of(LabSettings)
DEFAULTS = LabSettings()


def control_of(name: str) -> SliderControl | ChoiceControl:
    """Control of a setting."""
    control: SliderControl | ChoiceControl = FIELDS[name].metadata[0]
    return control


def controls() -> list[dict[str, Any]]:
    """Description of every setting for the page, as plain data."""
    found = []
    for name, field in FIELDS.items():
        control = control_of(name)
        kind = "slider" if isinstance(control, SliderControl) else "choice"
        data = {"name": name, "kind": kind, "default": field.default} | vars(control)
        data["when"] = dict(control.when)
        if isinstance(control, SliderControl):
            del data["above"]
            data["marks"] = [mark._asdict() for mark in control.marks]
        found.append(data)
    return found


def settings_from(pairs: Iterable[tuple[str, str]]) -> LabSettings:
    """Validated settings from the pairs of a query.

    Raises:
        InputError: One line for each problem, with field, value, unit and range.
    """
    given: dict[str, str] = {}
    for name, value in pairs:
        if name in given:
            raise InputError(f"{excerpt(name)}: is given twice; give it once")
        given[excerpt(name)] = value
    try:
        return LabSettings.model_validate(given)
    except ValidationError as error:
        raise InputError(*(_line(path, what) for path, what in problem_paths(error))) from None


def _line(path: tuple[str | int, ...], what: str) -> str:
    """A problem with its field and, for a slider, the whole range."""
    name = str(path[0]) if path else ""
    line = f"{name}: {what}" if name else what
    if name in FIELDS and isinstance(how := control_of(name), SliderControl):
        return f"{line}; {digits(how.least)} to {digits(how.most)} {how.unit}".rstrip()
    return line


def digits(number: float) -> str:
    """Shortest text that reads back to the same number: 5 for 5.0."""
    return repr(number).removesuffix(".0")


def query_of(settings: LabSettings) -> str:
    """Canonical query: settings that differ from the defaults, in the order of the table."""
    words = []
    for name in FIELDS:
        value = getattr(settings, name)
        if value != getattr(DEFAULTS, name):
            text = digits(value) if isinstance(value, float) else value
            words.append(f"{name}={quote(text, safe='')}")
    return "&".join(words)

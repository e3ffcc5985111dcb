"""Settings of the impact lab: one table from which page, validation and links follow.

Every number of the lab is here once, in the unit of the page: its range, step and default, and the
paper's values marked beside it, which come from the modules that define them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Annotated, Any, ClassVar
from urllib.parse import quote

from pydantic import ValidationError

from springback.contact.library import SURFACES
from springback.errors import InputError
from springback.interfaces.lab.controls import (
    ChoiceControl,
    NoControl,
    SliderControl,
    SliderMark,
    excerpt,
)
from springback.interfaces.lab.user_scenario import UserScenario
from springback.interfaces.lab.vehicle_controls import VEHICLE_FIELDS, control_for, first_angle
from springback.interfaces.output.robots import ROBOTS
from springback.paper.printed import SLIDER_SPEED, SWEEP_SPEEDS
from springback.problems import problem_paths
from springback.recovery.parameters import ResponseSettings
from springback.scenario.fields import fields_of
from springback.settings import Settings
from springback.studies.run_ups import CONDITIONS
from springback.vehicle.library import ARQ

When = Mapping[str, tuple[str, ...]]
#: Longest query that is read [characters] (chosen).
LONGEST_QUERY = 800

WAYS = fields_of(ResponseSettings)["way"].words


_WALL, _MAT = SURFACES["wall"], SURFACES["mat"]
_IMPACT: When = {"mode": ("impact",)}
_FLIGHT: When = {"mode": ("flight",)}
_OWN: When = {"surface": ("own",)}
_OURS: When = {"mode": ("impact", "flight")}
_COMPLIANT: When = {"robot": ("both", "arq")}
_TWINS: When = {"robot": ("both", "arq", "quad")}
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
        {**_IMPACT, "obstacle": ("wall",)},
    ),
]
Obstacles = Annotated[
    str,
    ChoiceControl(
        "Obstacle",
        {
            "wall": "Wall or mat", "pole": "Pole", "edge": "Edge", "sphere": "Sphere",
            "window": "Window", "slope": "Slope", "net": "Net", "ball": "Swinging ball",
            "door": "Door", "robot": "Other robot",
        },
        "All but the wall are hit in free flight. The ball swings into the hovering robot; the "
        "door has a closer. The other robot is like the first, faces it, and hovers.",
        "Obstacle",
        _OURS,
    ),
]  # fmt: skip
Surfaces = Annotated[
    str,
    ChoiceControl(
        "Surface",
        {"wall": "Wall", "mat": "Mat", "own": "Own"},
        "Wall and mat are those of Table II; the mat is in front of the wall. Own: a surface with "
        "your numbers. Other obstacles than the wall have the surface alone; between two robots, "
        "Wall is that of two cages.",
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


Inertias = Annotated[
    str,
    ChoiceControl(
        "Body inertia",
        {"keep": "Kept", "scale": "With mass"},
        "At another body mass. Kept: as it is. With mass: in proportion, for a body of the same "
        "shape, I = m k². The share of arms with a mass always follows.",
        "Body",
    ),
]


def _of_arq(name: str, words: str, when: When, **changed: Any) -> tuple[SliderControl, float]:
    """Slider of a number of ARQ, and its default."""
    control, value = control_for(name, ARQ.vehicle, words)
    assert isinstance(control, SliderControl)
    return replace(control, when=when, **changed), value


_PAPER = {
    "body_mass": _of_arq(
        "body_mass", "paper: ARQ in flight, Table I", _TWINS,
        explains="Of ARQ's main body, without arms. Quad's, and that with the slider's bar, change "
        "by as much.",
    ),
    "length": _of_arq("length", "paper: Table I", _TWINS),
    "cage_radius": _of_arq("cage_radius", "paper: section II", _TWINS),
    "arm_mass": _of_arq(
        "arm_mass", "paper: Table II, 0.2 kg for four", _COMPLIANT, group="Springs of ARQ"
    ),
    "stiffness": _of_arq("stiffness", "paper: Table II", _COMPLIANT, group="Springs of ARQ"),
    "damping": _of_arq("damping", "paper: Table II", _COMPLIANT, group="Springs of ARQ"),
    "stroke": _of_arq(
        "stroke", "chosen; the paper prints none", _COMPLIANT, group="Springs of ARQ",
        explains="Largest compression of an arm, where its end stop acts. On the slider there are "
        "no stops, as in the paper.",
    ),
    "stop_stiffness": _of_arq(
        "stop_stiffness", "chosen; the paper has no end stops", _COMPLIANT, group="Springs of ARQ"
    ),
    "stop_dissipation": _of_arq(
        "stop_dissipation", "chosen; the paper has no end stops", _COMPLIANT,
        group="Springs of ARQ",
    ),
}  # fmt: skip
ARM_COUNT = SliderControl(
    "", label="Number of arms", least=2.0, most=12.0, step=1.0, group="Arms", when=_TWINS,
    marks=(SliderMark(float(ARQ.vehicle.arm_count), "paper"),), path="vehicle.arms.directions",
    whole=True, explains="Evenly spaced. Each new number is compiled once.",
)  # fmt: skip
ARM_ANGLE = SliderControl(
    "deg", label="Angle of the first arm", least=-180.0, most=180.0, step=1.0, group="Arms",
    when=_TWINS, marks=(SliderMark(first_angle(ARQ.vehicle), "paper: section III"),),
    path="vehicle.arms.directions", explains="From body x towards body y; the others follow.",
)  # fmt: skip


def _of_shapes(*shapes: str, unit: str = "mm", **control: Any) -> SliderControl:
    """Slider of a number that some obstacles have."""
    when = {**_OURS, "obstacle": shapes}
    return SliderControl(unit, group="Obstacle", when=when, **control)


class LabSettings(Settings):
    """Settings of the impact lab, in the units of its page."""

    user: ClassVar[UserScenario | None] = None
    """The user's own scenario, if the lab opened with one."""

    mode: Modes = "impact"
    robot: Robots = "both"
    guide: Guides = "slider"
    speed: Annotated[float, SliderControl(
        "m/s", label="Speed", least=0.5, most=6.0, step=0.05, group="Collision",
        marks=_SPEEDS, explains="Into the obstacle, at first touch; of the ball, into the robot.",
    )] = SLIDER_SPEED  # fmt: skip
    pitch: Annotated[float, SliderControl(
        "deg", label="Pitch", least=-60.0, most=60.0, step=1.0, group="Collision",
        marks=_PITCHES, explains="Positive is nose down.",
    )] = 0.0  # fmt: skip
    yaw: Annotated[float, SliderControl(
        "deg", label="Yaw", least=-45.0, most=45.0, step=1.0, group="Collision",
        marks=(SliderMark(0.0, "paper: all tests"),),
        explains="Of the robot against the obstacle; at 45 deg one arm hits a wall. In flight the "
        "obstacle is turned, and the robot hits it at an angle.",
    )] = 0.0  # fmt: skip
    recovery: Recoveries = "pre-impact"
    obstacle: Obstacles = "wall"
    radius: Annotated[float, _of_shapes(
        "pole", "sphere", "ball", label="Radius", least=5.0, most=1000.0, step=1.0,
        logarithmic=True, explains="Of the pole, the sphere, or the ball.",
        path="world.obstacles.0.radius",
    )] = 50.0  # fmt: skip
    opening: Annotated[float, _of_shapes(
        "window", label="Opening", least=100.0, most=1500.0, step=10.0,
        explains="Width and height, in a frame of 250 mm. ARQ, arms at 45 deg, is 490 mm wide.",
        path="world.obstacles.0.opening",
    )] = 450.0  # fmt: skip
    incline: Annotated[float, _of_shapes(
        "slope", unit="deg", label="Angle of the slope", least=10.0, most=90.0, step=1.0,
        explains="From the horizontal; 90 deg is a wall.", path="world.obstacles.0.angle",
    )] = 45.0  # fmt: skip
    tension: Annotated[float, _of_shapes(
        "net", unit="N/m", label="Tension of the net", least=10.0, most=1000.0, step=1.0,
        logarithmic=True, explains="Per width. The net is 2 m by 1 m, with its own surface.",
        path="world.obstacles.0.tension",
    )] = 100.0  # fmt: skip
    turn: Annotated[float, _of_shapes(
        "edge", "window", "net", unit="deg", label="Turned by", least=-60.0, most=60.0, step=1.0,
        explains="About the vertical. At 0 the edge points at the robot, window and net face it.",
        path="world.obstacles.0.yaw",
    )] = 0.0  # fmt: skip
    offset: Annotated[float, _of_shapes(
        "pole", "edge", "sphere", "window", "net", "ball", "door", "robot", label="Offset",
        least=-500.0, most=500.0, step=5.0, explains="To the left of the robot's way.",
        path="world.obstacles.0.position",
    )] = 0.0  # fmt: skip
    ball_mass: Annotated[float, _of_shapes(
        "ball", unit="kg", label="Mass of the ball", least=0.05, most=20.0, step=0.05,
        logarithmic=True, explains="It hangs on a rod of 1.5 m without mass.",
        path="world.obstacles.0.motion.mass",
    )] = 1.0  # fmt: skip
    door_mass: Annotated[float, _of_shapes(
        "door", unit="kg", label="Mass of the door", least=1.0, most=100.0, step=0.5,
        logarithmic=True, explains="90 cm wide, hinged on its left, with a closer of 5 N m/rad.",
        path="world.obstacles.0.motion.mass",
    )] = 8.0  # fmt: skip
    other_speed: Annotated[float, SliderControl(
        "m/s", label="Speed of the other robot", least=0.0, most=3.0, step=0.05, group="Obstacle",
        when={**_IMPACT, "obstacle": ("robot",)}, path="second.start.velocity",
        explains="Towards the first. In flight it hovers with a pilot of its own.",
    )] = 0.0  # fmt: skip
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
    stiffness: Annotated[float, _PAPER["stiffness"][0]] = _PAPER["stiffness"][1]
    damping: Annotated[float, _PAPER["damping"][0]] = _PAPER["damping"][1]
    arm_mass: Annotated[float, _PAPER["arm_mass"][0]] = _PAPER["arm_mass"][1]
    stroke: Annotated[float, _PAPER["stroke"][0]] = _PAPER["stroke"][1]
    stop_stiffness: Annotated[float, _PAPER["stop_stiffness"][0]] = _PAPER["stop_stiffness"][1]
    stop_dissipation: Annotated[float, _PAPER["stop_dissipation"][0]] = _PAPER["stop_dissipation"][
        1
    ]
    arm_count: Annotated[float, ARM_COUNT] = float(ARQ.vehicle.arm_count)
    arm_angle: Annotated[float, ARM_ANGLE] = first_angle(ARQ.vehicle)
    length: Annotated[float, _PAPER["length"][0]] = _PAPER["length"][1]
    cage_radius: Annotated[float, _PAPER["cage_radius"][0]] = _PAPER["cage_radius"][1]
    body_mass: Annotated[float, _PAPER["body_mass"][0]] = _PAPER["body_mass"][1]
    inertia: Inertias = "keep"


#: Settings that change the vehicle.
VEHICLE_SETTINGS = ("arm_count", "arm_angle", "inertia", *VEHICLE_FIELDS)
FIELDS = fields_of(LabSettings)
DEFAULTS = LabSettings()


Control = SliderControl | NoControl | ChoiceControl


def control_of(name: str, table: type[LabSettings] = LabSettings) -> Control:
    """Control of a setting."""
    control: Control = fields_of(table)[name].metadata[0]
    return control


def controls(table: type[LabSettings] = LabSettings) -> list[dict[str, Any]]:
    """Description of every setting for the page, as plain data."""
    kinds = {SliderControl: "slider", NoControl: "fixed", ChoiceControl: "choice"}
    found = []
    for name, field in fields_of(table).items():
        control = control_of(name, table)
        data = {"name": name, "kind": kinds[type(control)], "default": field.default}
        data |= {key: value for key, value in vars(control).items() if key != "above"}
        data["when"] = dict(control.when)
        if isinstance(control, SliderControl):
            data["marks"] = [mark._asdict() for mark in control.marks]
        found.append(data)
    return found


def settings_from(
    pairs: Iterable[tuple[str, str]], table: type[LabSettings] = LabSettings
) -> LabSettings:
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
        return table.model_validate(given)
    except ValidationError as error:
        lines = (_line(table, path, what) for path, what in problem_paths(error))
        raise InputError(*lines) from None


def _line(table: type[LabSettings], path: tuple[str | int, ...], what: str) -> str:
    """A problem with its field and, for a slider, the whole range."""
    name = str(path[0]) if path else ""
    line = f"{name}: {what}" if name else what
    if name in fields_of(table) and isinstance(how := control_of(name, table), SliderControl):
        return f"{line}; {digits(how.least)} to {digits(how.most)} {how.unit}".rstrip()
    return line


def digits(number: float) -> str:
    """Shortest text that reads back to the same number: 5 for 5.0, 0 for either zero."""
    return repr(number + 0.0).removesuffix(".0")


def is_default(settings: LabSettings, *names: str) -> bool:
    """True if some settings are those with which the page opens."""
    fields = fields_of(type(settings))
    return all(getattr(settings, name) == fields[name].default for name in names)


def query_of(settings: LabSettings) -> str:
    """Canonical query: settings that differ from the defaults, in the order of the table."""
    words = []
    for name in fields_of(type(settings)):
        if not is_default(settings, name):
            value = getattr(settings, name)
            text = digits(value) if isinstance(value, float) else value
            words.append(f"{name}={quote(text, safe='')}")
    return "&".join(words)

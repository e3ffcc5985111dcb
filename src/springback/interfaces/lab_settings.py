"""What can be set in the impact lab: one table of knobs, from which page, checks and links follow.

Every number of the lab stands here once, in the unit in which the page shows it: its range, its
step, its default, and the values of the paper that are marked beside it, which come from where the
package keeps them.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Annotated, Any, Literal, NamedTuple, get_args
from urllib.parse import quote

from pydantic import BeforeValidator, ValidationError
from pydantic.fields import FieldInfo

from springback.contact.library import SURFACES
from springback.errors import InputError
from springback.experiments.paper.printed import SLIDER_SPEED, SWEEP_SPEEDS
from springback.experiments.problems import problem_paths
from springback.experiments.run_ups import CONDITIONS
from springback.quantities import checked
from springback.recovery.parameters import Answering
from springback.settings import Settings, problem
from springback.vehicle.library import ARQ

#: Letters of a value, and of all settings together, that are looked at at all (chosen).
LONGEST_VALUE, LONGEST_QUERY = 32, 800
_WITH_UNIT = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)(e[+-]?[0-9]{1,3})? *[a-z%° /·]{1,12}", re.IGNORECASE)

WAYS: tuple[str, ...] = get_args(Answering.model_fields["way"].annotation)


class Mark(NamedTuple):
    """A value that is marked beside a slider, and whose it is."""

    value: float
    words: str


class Knob(NamedTuple):
    """How a number is set: a slider with a field, in the unit of the page."""

    label: str
    unit: str
    least: float
    most: float
    step: float
    explains: str
    marks: tuple[Mark, ...] = ()
    group: str = ""
    when: dict[str, tuple[str, ...]] = {}  # noqa: RUF012  # read only
    """Settings under which it has an effect; elsewhere the page hides it."""
    logarithmic: bool = False


class Choice(NamedTuple):
    """How one of several words is chosen."""

    label: str
    words: dict[str, str]
    """What the page says for each."""
    explains: str
    group: str = ""
    when: dict[str, tuple[str, ...]] = {}  # noqa: RUF012  # read only


def _knob(knob: Knob) -> Any:
    """Type of a field that a knob sets, checked to its range."""

    def validate(value: Any) -> float:
        if isinstance(value, str):
            value = _number_of(value, knob.unit)
        return checked(value, knob.unit, least=knob.least, most=knob.most)

    return Annotated[float, BeforeValidator(validate), knob]


def _number_of(text: str, unit: str) -> float | str:
    """A number in a knob's unit; text with a unit is left to `checked` if it is no more than that.

    Strings come from strangers: expressions such as ``9**9**9`` are not to be computed.
    """
    text = text.strip()
    try:
        return float(text)
    except ValueError:
        if len(text) <= LONGEST_VALUE and _WITH_UNIT.fullmatch(text):
            return text
    short = text if len(text) <= LONGEST_VALUE else text[: LONGEST_VALUE - 1] + "…"
    raise problem(f"must be a number in {unit or 'no unit'} (got {short!r})")


def _choice(words: tuple[str, ...], choice: Choice) -> Any:
    """Type of a field with one of several words."""

    def validate(value: Any) -> str:
        if value in words:
            return str(value)
        short = str(value) if len(str(value)) <= LONGEST_VALUE else str(value)[:LONGEST_VALUE] + "…"
        raise problem(f"must be {', '.join(words[:-1])} or {words[-1]} (got {short!r})")

    return Annotated[Literal[words], BeforeValidator(validate), choice]


_ARMS, _WALL, _MAT = ARQ.vehicle.arms, SURFACES["wall"], SURFACES["mat"]
_IMPACT, _FLIGHT, _OWN = {"mode": ("impact",)}, {"mode": ("flight",)}, {"surface": ("own",)}
_COMPLIANT = {"robot": ("both", "arq")}
_TESTED = sorted({speed for _, speed in CONDITIONS})
_SPEEDS = (
    Mark(SLIDER_SPEED, "paper: slider tests, section IV-A"),
    *(Mark(speed, "paper: collisions in flight, Impact Resilience") for speed in _TESTED),
    Mark(SWEEP_SPEEDS[-1], "paper: fastest of the speed sweep"),
)
_PITCHES = tuple(
    Mark(pitch, "paper: Impact Resilience") for pitch in sorted({pitch for pitch, _ in CONDITIONS})
)


def _fitted(surface: Any) -> float:
    """c_a of a surface of the library, to the step of its knob [s/m]."""
    return round(float(surface.dissipation_value()), 3)


Modes = _choice(
    ("impact", "flight"),
    Choice(
        "What to fly",
        {"impact": "Impact", "flight": "Flight"},
        "Impact: the collision alone, rotors as before it. Flight: run-up, collision and recovery, "
        "with a pilot aboard.",
    ),
)
Robots = _choice(
    ("both", "arq", "quad"),
    Choice(
        "Robot",
        {"both": "Both", "arq": "ARQ", "quad": "Quad"},
        "ARQ has springs in its arms; Quad is its rigid twin.",
        "Robot",
    ),
)
Guides = _choice(
    ("slider", "free"),
    Choice(
        "Guided by",
        {"slider": "Slider", "free": "Nothing"},
        "Slider: the paper's testbed, along X, with its bar's mass and no rotors. Nothing: the "
        "robots as flown, hovering.",
        "Collision",
        _IMPACT,
    ),
)
Surfaces = _choice(
    ("wall", "mat", "own"),
    Choice(
        "Surface",
        {"wall": "Wall", "mat": "Mat", "own": "Own"},
        "Wall and mat are Table II's; a mat lies before the wall. Own: a wall of your numbers.",
        "Surface",
    ),
)
Recoveries = _choice(
    ("none", *WAYS),
    Choice(
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
    speed: _knob(  # type: ignore[valid-type]
        Knob(
            "Speed", "m/s", 0.5, 6.0, 0.05, "Into the wall, at first touch.", _SPEEDS, "Collision"
        )
    ) = SLIDER_SPEED
    pitch: _knob(  # type: ignore[valid-type]
        Knob("Pitch", "deg", -60.0, 60.0, 1.0, "Positive is nose down.", _PITCHES, "Collision")
    ) = 0.0
    yaw: _knob(  # type: ignore[valid-type]
        Knob(
            "Yaw", "deg", -45.0, 45.0, 1.0,
            "Of the robot against the wall; at 45 deg one arm meets it. In flight the wall is "
            "turned, and the robot meets it aslant.",
            (Mark(0.0, "paper: all tests"),), "Collision",
        )
    ) = 0.0  # fmt: skip
    recovery: Recoveries = "pre-impact"  # type: ignore[valid-type]
    surface: Surfaces = "wall"  # type: ignore[valid-type]
    contact_stiffness: _knob(  # type: ignore[valid-type]
        Knob(
            "Contact stiffness k_c", "kN/m^1.5", 20.0, 1000.0, 1.0, "Of the whole front.",
            (
                Mark(1e-3 * float(_MAT.stiffness), "paper: mat, Table II"),
                Mark(1e-3 * float(_WALL.stiffness), "paper: wall, Table II"),
            ),
            "Surface", _OWN, logarithmic=True,
        )
    ) = 1e-3 * float(_WALL.stiffness)  # fmt: skip
    dissipation: _knob(  # type: ignore[valid-type]
        Knob(
            "Dissipation c_a", "s/m", 0.0, 1.0, 0.001, "Of the Hunt-Crossley law; 0 gives all back.",
            (
                Mark(_fitted(_MAT), "mat: fitted to Quad's restitution in Table III"),
                Mark(_fitted(_WALL), "wall: fitted to Quad's restitution in Table III"),
            ),
            "Surface", _OWN,
        )
    ) = _fitted(_WALL)  # fmt: skip
    friction: _knob(  # type: ignore[valid-type]
        Knob(
            "Friction μ", "", 0.0, 1.5, 0.05, "Coulomb's, along the surface.",
            (Mark(float(_WALL.friction), "paper: Table II"),), "Surface", _OWN,
        )
    ) = float(_WALL.friction)  # fmt: skip
    stiffness: _knob(  # type: ignore[valid-type]
        Knob(
            "Arm stiffness k_l", "N/mm", 0.5, 50.0, 0.1, "Of each arm's spring.",
            (Mark(1e-3 * float(_ARMS.stiffness), "paper: Table II"),), "Arms of ARQ", _COMPLIANT,
            logarithmic=True,
        )
    ) = 1e-3 * float(_ARMS.stiffness)  # fmt: skip
    damping: _knob(  # type: ignore[valid-type]
        Knob(
            "Arm damping b_l", "N s/m", 0.0, 300.0, 1.0, "Of each arm.",
            (Mark(float(_ARMS.damping), "paper: Table II"),), "Arms of ARQ", _COMPLIANT,
        )
    ) = float(_ARMS.damping)  # fmt: skip
    arm_mass: _knob(  # type: ignore[valid-type]
        Knob(
            "Arm mass m_a", "g", 10.0, 200.0, 1.0, "Of each arm; the main body keeps its own.",
            (Mark(round(1e3 * float(_ARMS.mass), 9), "paper: Table II, 0.2 kg for four"),),
            "Arms of ARQ", _COMPLIANT,
        )
    ) = round(1e3 * float(_ARMS.mass), 9)  # fmt: skip


FIELDS: dict[str, FieldInfo] = LabSettings.model_fields
DEFAULTS = LabSettings()


def control_of(name: str) -> Knob | Choice:
    """The knob or choice of a setting."""
    return next(data for data in FIELDS[name].metadata if isinstance(data, Knob | Choice))


def controls() -> list[dict[str, Any]]:
    """All that the page needs to know of every setting, in plain data."""
    found = []
    for name, told in FIELDS.items():
        control = control_of(name)
        kind = "knob" if isinstance(control, Knob) else "choice"
        data: dict[str, Any] = {"name": name, "kind": kind, "default": told.default}
        data |= control._asdict()
        if isinstance(control, Knob):
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
            raise InputError(f"{name}: is given twice; give it once")
        given[name if len(name) <= LONGEST_VALUE else name[:LONGEST_VALUE] + "…"] = value
    try:
        return LabSettings.model_validate(given)
    except ValidationError as error:
        raise InputError(*(_line(path, what) for path, what in problem_paths(error))) from None


def _line(path: tuple[str | int, ...], what: str) -> str:
    """A problem with its field and, of a knob, the whole range."""
    name = str(path[0]) if path else ""
    line = f"{name}: {what}" if name else what
    if name in FIELDS and isinstance(knob := control_of(name), Knob):
        return f"{line}; {shown(knob.least)} to {shown(knob.most)} {knob.unit}".rstrip()
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


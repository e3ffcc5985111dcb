"""Insertion of a plan's values into a scenario.

Tables are copied along the path to the value and otherwise shared; none is changed in place.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from springback.errors import InputError
from springback.problems import dotted_path, key_path
from springback.scenario.fields import Parameter, Path, number_at
from springback.scenario.overrides import with_value
from springback.scenario.scenario import Scenario
from springback.scenario.tables import Start

Place = Callable[[Any, Any], Any]
"""Function from a table of the scenario and a value to the table with the value."""

#: Short names of fields.
NAMES: dict[str, Path] = {
    "speed": ("reference", "speed"),
    "pitch": ("reference", "pitch"),
    "yaw": ("start", "yaw"),
    "surface": ("world", "obstacles", 0, "surface"),
    "friction": ("world", "obstacles", 0, "surface", "friction"),
    "stiffness": ("vehicle", "arms", "stiffness"),
    "damping": ("vehicle", "arms", "damping"),
    "mass": ("vehicle", "body", "mass"),
}
#: Changes of the first wall or mat, which are not paths.
WALL_ANGLE, WALL_SHIFT = "wall_angle", "wall_shift"
#: Fields that a plan sets itself.
DEALT = {
    "seed": "each flight has its own, from the plan's seed",
    "vehicle.preset": "name presets under robots",
    "vehicle": "name presets under robots, or vary a number of it",
    "name": "a flight of a campaign has a number instead",
    "pilot": "name pilots under pilots, or vary a parameter of it",
    "pilot.code": "name pilots under pilots",
    "second": "vary a field of it",
    "second.preset": "vary a field of it",
    "second.seed": "each flight has its own, from the plan's seed",
    "second.name": "a flight of a campaign has a number instead",
}


class TargetField(NamedTuple):
    """A field of the scenario that can be varied."""

    column: str
    path: Path
    """Path in the scenario, at least its table."""
    number: Parameter | None
    """Its number; None if it is not a single one."""
    place: Place
    """Insertion into the table that the path begins with."""
    relative: bool = False
    """True if the value changes the present one instead of replacing it."""


def target(field: str, scenario: Scenario) -> TargetField:
    """Field of a name.

    Args:
        field: ``wall angle``, ``wall shift``, a short name, or a dotted path.
        scenario: Scenario that has it.

    Raises:
        InputError: If there is no field of this name, or the plan sets it itself.
    """
    word = _word(field)
    if word in (WALL_ANGLE, WALL_SHIFT):
        return _of_the_wall(word, scenario)
    path = field_path(field)
    if not path:
        raise InputError("must be a short name or a dotted path")
    column = next((short for short, full in NAMES.items() if full == path), dotted_path(path))
    if why := DEALT.get(dotted_path(path)):
        raise InputError(f"cannot be varied; {why}")
    name = column if isinstance(path[0], str) else field
    try:
        number = number_at(name, path, scenario, tuple(NAMES))
    except InputError as error:
        raise InputError(str(error).removeprefix(f"{name}: ")) from None
    return TargetField(column, path, number, _at_path(path, number))


def field_path(field: str) -> Path:
    """Path of a field from its short name or dotted path; empty if invalid."""
    return NAMES.get(_word(field)) or key_path(field.strip())


def _word(field: str) -> str:
    return field.strip().replace(" ", "_")


def _at_path(path: Path, number: Parameter | None) -> Place:
    """Insert a value at a path."""
    rest, word = path[1:], dotted_path(path)
    others = list(number.others) if number is not None else []

    def place(table: Any, value: Any) -> Any:
        if not rest:
            return value
        if others and not isinstance(_at(table, rest[:-1]), list):
            table = with_value(table, rest[:-1], others, word)
        return with_value(table, rest, value, word)

    return place


def _at(table: Any, path: Sequence[str | int]) -> Any:
    for key in path:
        try:
            table = table[key]
        except (KeyError, IndexError, TypeError):
            return None
    return table


# -- the wall -------------------------------------------------------------------------------------


def _of_the_wall(word: str, scenario: Scenario) -> TargetField:
    kinds = [obstacle.type for obstacle in scenario.world.obstacles]
    index = next((k for k, kind in enumerate(kinds) if kind in ("wall", "mat")), None)
    if index is None:
        raise InputError(
            "needs a wall or a mat in world.obstacles; with other shapes write "
            'scatter = {preset = "trials", wall_distance = 0, wall_yaw = 0}'
        )
    moved, unit = (_rotate, "rad") if word == WALL_ANGLE else (_shift, "m")

    def place(world: Any, value: float) -> Any:
        entries = world["obstacles"]
        entry = moved(entries[index], value)
        return {**world, "obstacles": [*entries[:index], entry, *entries[index + 1 :]]}

    path = ("world", "obstacles", index)
    return TargetField(word, path, Parameter(word, path, unit), place, relative=True)


def _by_face(entry: Mapping[str, Any]) -> dict[str, Any]:
    """Wall defined by a point of its face and its normal, in numbers."""
    if entry.get("distance") is None:
        return dict(entry)
    there = {"position": [entry["distance"], 0.0, 0.0], "normal": [-1.0, 0.0, 0.0]}
    return {key: value for key, value in entry.items() if key != "distance"} | there


def _rotate(entry: Mapping[str, Any], angle: float) -> dict[str, Any]:
    """Wall rotated about the vertical through its point, counterclockwise from above [rad]."""
    wall, c, s = _by_face(entry), math.cos(angle), math.sin(angle)
    x, y, z = wall["normal"]
    return wall | {"normal": [c * x - s * y, s * x + c * y, z]}


def _shift(entry: Mapping[str, Any], distance: float) -> dict[str, Any]:
    """Wall moved against its normal [m]."""
    wall = _by_face(entry)
    size = math.hypot(*wall["normal"])
    place = zip(wall["position"], wall["normal"], strict=True)
    return wall | {"position": [p - distance * n / size for p, n in place]}


# -- changes of what is there ---------------------------------------------------------------------


def addition(path: Path) -> Place:
    """Add a value to the number at a path within a table."""

    def place(table: Any, value: float) -> Any:
        return with_value(table, path, _at(table, path) + value, dotted_path(path))

    return place


def multiplication(path: Path) -> Place:
    """Multiply the number at a path within a table by a value."""

    def place(table: Any, value: float) -> Any:
        return with_value(table, path, _at(table, path) * value, dotted_path(path))

    return place


def in_numbers(tables: Mapping[str, Any], scenario: Scenario) -> dict[str, Any]:
    """Raw tables with SI numbers where scatter and walls change them.

    Args:
        tables: Tables of the scenario, as written.
        scenario: The validated scenario.
    """
    start, control, error = scenario.start, scenario.control, scenario.model_error
    changes = {
        "start": {
            "position": list(start.position), "offset": list(start.offset),
            "velocity": list(start.velocity), "yaw": start.yaw, **_as_angles(start),
        },
        "control": {name: getattr(control, name) for name in GAINS},
        "model_error": {"mass": error.mass, "inertia": error.inertia},
    }  # fmt: skip
    result = dict(tables)
    for key, numbers in changes.items():
        before = {name: x for name, x in result.get(key, {}).items() if name != "quaternion"}
        result[key] = before | numbers
    entries = []
    given = (tables.get("world") or {}).get("obstacles", [])
    for raw, entry in zip(given, scenario.world.obstacles, strict=True):
        places = {key: getattr(entry, key, None) for key in ("distance", "position", "normal")}
        known = {key: value for key, value in places.items() if value is not None}
        as_lists = {k: list(v) if isinstance(v, tuple) else v for k, v in known.items()}
        entries.append({**raw, **as_lists})
    if entries:
        result["world"] = {**result["world"], "obstacles": entries}
    return result


def _as_angles(start: Start) -> dict[str, float]:
    """Euler angles in place of a quaternion; nothing without one."""
    angles = zip(("roll", "pitch", "yaw"), start.angles(), strict=True)
    return {} if start.quaternion is None else dict(angles)


#: Gains of `springback.studies.trials.Scatter`.
GAINS = ("stiffness", "vertical_stiffness", "damping_ratio", "time_constant", "rate_gain")

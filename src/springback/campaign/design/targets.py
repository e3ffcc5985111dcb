"""Where a value of a plan goes in a scenario: how tables with it come from tables without.

Nothing is changed in place, and what is not on the way to the value stays the same object.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from springback.errors import InputError
from springback.problems import dotted_path, key_path
from springback.scenario.fields import Parameter, Path, number_at
from springback.scenario.files import with_value
from springback.scenario.scenario import Scenario

Place = Callable[[Any, Any], Any]
"""A table of the scenario and a value to the table with the value."""

#: Fields with a name of their own.
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
#: Not a path, but a change of the first wall or mat.
WALL_ANGLE, WALL_SHIFT = "wall_angle", "wall_shift"
#: What a plan deals out by itself.
DEALT = {
    "seed": "each flight has its own, from the plan's seed",
    "vehicle.preset": "name presets under robots",
    "vehicle": "name presets under robots, or vary a number of it",
    "name": "a flight of a campaign has a number instead",
}


class TargetField(NamedTuple):
    """A field of the scenario that can be varied."""

    column: str
    path: Path
    """Its table at least."""
    number: Parameter | None
    """None where it is no single number."""
    place: Place
    """On the table that the path begins with."""
    relative: bool = False
    """Whether the value changes what is there, instead of taking its place."""


def target(field: str, scenario: Scenario) -> TargetField:
    """The field of a name.

    Args:
        field: ``wall angle``, ``wall shift``, a short name, or a dotted path.
        scenario: That has it.

    Raises:
        InputError: If there is none of this name, or the plan deals it out.
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
    """Where a field is, by a short name or its dotted path; empty for no name."""
    return NAMES.get(_word(field)) or key_path(field.strip())


def _word(field: str) -> str:
    return field.strip().replace(" ", "_")


def _at_path(path: Path, number: Parameter | None) -> Place:
    """Put a value where a path leads."""
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
        raise InputError("needs a wall or a mat among world.obstacles, and there is none")
    moved, unit = (_turned, "rad") if word == WALL_ANGLE else (_shifted, "m")

    def place(world: Any, value: float) -> Any:
        entries = world["obstacles"]
        entry = moved(entries[index], value)
        return {**world, "obstacles": [*entries[:index], entry, *entries[index + 1 :]]}

    path = ("world", "obstacles", index)
    return TargetField(word, path, Parameter(word, path, unit), place, relative=True)


def _faced(entry: Mapping[str, Any]) -> dict[str, Any]:
    """A wall by a point of its face and its normal, in numbers."""
    if entry.get("distance") is None:
        return dict(entry)
    there = {"position": [entry["distance"], 0.0, 0.0], "normal": [-1.0, 0.0, 0.0]}
    return {key: value for key, value in entry.items() if key != "distance"} | there


def _turned(entry: Mapping[str, Any], angle: float) -> dict[str, Any]:
    """A wall turned about the vertical through its point, counterclockwise from above [rad]."""
    wall, c, s = _faced(entry), math.cos(angle), math.sin(angle)
    x, y, z = wall["normal"]
    return wall | {"normal": [c * x - s * y, s * x + c * y, z]}


def _shifted(entry: Mapping[str, Any], distance: float) -> dict[str, Any]:
    """A wall moved into itself, away from who faces it [m]."""
    wall = _faced(entry)
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
    """Raw tables with numbers in SI where scatter and walls change them.

    Args:
        tables: Of the scenario, as written.
        scenario: The same, checked.
    """
    start, control, error = scenario.start, scenario.control, scenario.model_error
    changes = {
        "start": {
            "position": list(start.position), "velocity": list(start.velocity), "yaw": start.yaw,
        },
        "control": {name: getattr(control, name) for name in GAINS},
        "model_error": {"mass": error.mass, "inertia": error.inertia},
    }  # fmt: skip
    result = dict(tables)
    for key, numbers in changes.items():
        result[key] = {**result.get(key, {}), **numbers}
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


#: What `springback.studies.trials.Scatter` calls gains.
GAINS = ("stiffness", "vertical_stiffness", "damping_ratio", "time_constant", "rate_gain")

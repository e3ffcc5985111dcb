"""Problems of a scenario as path and message."""

from __future__ import annotations

import re
from collections.abc import Sequence

from pydantic import ValidationError

from springback.errors import excerpt, shown_value

#: Types of tables that have several, by key.
_KINDS = {
    "obstacles": (
        "wall",
        "ground",
        "mat",
        "box",
        "edge",
        "sphere",
        "pole",
        "capsule",
        "cone",
        "hoop",
        "window",
        "doorway",
        "slope",
        "stairs",
        "forest",
        "heightmap",
        "mesh",
        "occupancy",
        "net",
        "union",
        "own",
        "import",
    ),
    "hulls": ("sphere", "ring", "capsule", "box", "points"),
    "motion": ("constant", "sine", "table", "free", "pendulum", "hinge"),
    "shapes": (
        "box",
        "edge",
        "sphere",
        "pole",
        "capsule",
        "cone",
        "hoop",
        "window",
        "doorway",
        "slope",
        "stairs",
        "forest",
        "heightmap",
        "mesh",
        "occupancy",
        "net",
    ),
    "reference": ("hold", "steps", "circle", "waypoints", "run-up"),
}


#: Index of an entry of a list.
_INDEX = re.compile(r"[0-9]{1,6}")


def _choice(words: Sequence[str]) -> str:
    return f"{', '.join(words[:-1])} or {words[-1]}"


def _without_kinds(where: tuple[str | int, ...]) -> tuple[str | int, ...]:
    """Path without the names of types, which are not keys."""
    path: list[str | int] = []
    for part in where:
        holder = next((key for key in reversed(path) if isinstance(key, str)), "")
        if part not in _KINDS.get(holder, ()):
            path.append(part)
    return tuple(path)


def problem_paths(error: ValidationError) -> list[tuple[tuple[str | int, ...], str]]:
    """Path and message of each problem."""
    found = []
    for detail in error.errors(include_url=False):
        path = _without_kinds(detail["loc"])
        kinds = _KINDS.get(next((key for key in reversed(path) if isinstance(key, str)), ""), ())
        message = detail["msg"].replace("Input should be", "must be", 1)
        if detail["type"] == "problem":
            path = (*path, *key_path(str(detail["ctx"]["field"])))
        elif detail["type"] == "missing":
            message = "is missing"
        elif detail["type"] == "union_tag_not_found":
            path, message = (*path, "type"), f"is missing; {_choice(kinds)}"
        elif detail["type"] == "union_tag_invalid":
            tag = detail["ctx"]["tag"]
            path, message = (*path, "type"), f"must be {_choice(kinds)} (got {shown_value(tag)})"
        elif detail["type"] in ("model_type", "model_attributes_type", "dict_type"):
            message = f"must be a table (got {shown_value(detail['input'])})"
        elif detail["type"] == "tuple_type":
            message = f"must be a list (got {shown_value(detail['input'])})"
        elif detail["type"] in ("bool_type", "bool_parsing"):
            message = f"must be true or false (got {shown_value(detail['input'])})"
        elif detail["type"].startswith("int_"):
            message = f"must be a whole number (got {shown_value(detail['input'])})"
        elif isinstance(detail.get("input"), str | int | float | bool):
            message = f"{message} (got {shown_value(detail['input'])})"
        found.append((path, message))
    return found


def key_path(text: str) -> tuple[str | int, ...]:
    """Keys and indices of ``world.obstacles.0.distance`` or ``world.obstacles[0].distance``."""
    words = [word for word in re.split(r"[.\[\]]+", text) if word]
    return tuple(int(word) if _INDEX.fullmatch(word) else word for word in words)


def dotted_path(path: tuple[str | int, ...]) -> str:
    """Path as text, such as ``world.obstacles[0].distance``."""
    text = ""
    for key in path:
        part = key if isinstance(key, int) else excerpt(key)
        text += f"[{part}]" if isinstance(part, int) else f".{part}" if text else part
    return text

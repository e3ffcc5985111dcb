"""Problems of a scenario as path and message."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Sequence

from pydantic import ValidationError

from springback.errors import excerpt, shown_value

#: Smallest similarity of a word to a suggestion, from 0 to 1 (chosen: foo is not robot).
LIKE = 0.6
#: Smallest number of letters that identify a name by its beginning (chosen).
SHORTEST = 3


def nearest_name(word: str, known: Iterable[str]) -> str:
    """Known name that a word most likely stands for, or empty.

    Args:
        word: A misspelt name, or the beginning of one.
        known: Known names.
    """
    names = list(known)
    near = difflib.get_close_matches(word.lower(), names, n=1, cutoff=LIKE)
    begun = [name for name in names if len(word) >= SHORTEST and name.startswith(word.lower())]
    return next(iter([*near, *begun]), "")


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
    "guard": ("ring", "cantilever", "shell", "pad", "sphere"),
    "joint": ("slide", "hinge"),
    "second": ("slide", "hinge"),
    "parts": ("point", "ball", "box", "tube"),
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


#: What types are for that some tables of a key do not take.
_WITH_AN_END = (
    "an obstacle with an end: box, edge, sphere, capsule, cone, hoop, window, doorway, stairs, "
    "union, net, or pole with a height"
)
_ELSEWHERE = {
    ("motion", word): f"{word} is a motion of {_WITH_AN_END}"
    for word in ("free", "pendulum", "hinge")
}

#: Index of an entry of a list.
_INDEX = re.compile(r"[0-9]{1,6}")


def _choice(words: Sequence[str]) -> str:
    return f"{', '.join(words[:-1])} or {words[-1]}"


def _meant(given: object, known: Iterable[str]) -> str:
    """Question for the known word that another one most likely stands for, or empty."""
    near = nearest_name(given, known) if isinstance(given, str) else ""
    return f"; did you mean {near}?" if near else ""


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
            here = tuple(re.findall(r"'([^']*)'", detail["ctx"]["expected_tags"]))
            holder = next((key for key in reversed(path) if isinstance(key, str)), "")
            elsewhere = _ELSEWHERE.get((holder, tag))
            hint = _meant(tag, here) if elsewhere is None else f"; {elsewhere}"
            said = f"must be {_choice(here)} (got {shown_value(tag)}){hint}"
            path, message = (*path, "type"), said
        elif detail["type"] == "literal_error":
            given, known = detail["input"], re.findall(r"'([^']*)'", detail["ctx"]["expected"])
            message = f"{message} (got {shown_value(given)}){_meant(given, known)}"
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

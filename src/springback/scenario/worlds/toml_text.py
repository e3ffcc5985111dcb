"""Imported worlds in Python, and as obstacles of a scenario in TOML."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from springback.contact.library import SURFACES
from springback.contact.parameters import SurfaceSettings
from springback.errors import InputError
from springback.scenario.code_files import with_absolute_names
from springback.scenario.presets import obstacle_table
from springback.scenario.worlds.imported import Imported, NamedObstacle


def read_world(
    path: str | Path, *, surface: Any = "wall", surfaces: Mapping[str, Any] | None = None,
    search: Sequence[str | Path] = (), position: Sequence[Any] = (0.0, 0.0, 0.0), yaw: Any = 0.0,
    friction: str = "file", bounds: bool = False, missing: str = "warn",
) -> Imported:  # fmt: skip
    """Read a world of another program.

    Args:
        path: SDF or Gazebo world, MJCF, URDF, world of RotorPy, OctoMap, mesh, height map or grid.
        surface: Preset or settings for all elements but those named in ``surfaces``.
        surfaces: Presets or settings by patterns of names, such as ``{"shelf*": "mat"}``.
        search: Further folders for what the file includes.
        position: Position of its origin [m].
        yaw: Yaw of its x axis [rad], or text with a unit.
        friction: ``file`` takes coefficients of friction from the file, ``surface`` does not.
        bounds: True if the bounds of a world of RotorPy are walls.
        missing: ``refuse`` raises an error for what cannot be represented.

    Returns:
        An obstacle for a scenario: its ``parts`` are named obstacles, ``unrepresented`` lists what
        cannot be represented, by name and with the reason, ``remarks`` what is represented
        differently.

    Raises:
        InputError: One line, if the file cannot be read or is wrong.
    """
    given = {
        "type": "import", "file": str(path), "search": [str(folder) for folder in search],
        "surface": surface, "surfaces": dict(surfaces or {}), "friction": friction,
        "position": list(position), "yaw": yaw, "bounds": bounds, "missing": missing,
    }  # fmt: skip
    for key in ("surface", "surfaces"):
        given[key] = _plain(given[key])
    [entry] = with_absolute_names({"world": {"obstacles": [given]}}, Path())["world"]["obstacles"]
    try:
        return Imported.model_validate(obstacle_table(entry))
    except InputError as error:
        where = "".join(f"{key}: " for key in error.path if key != "file")
        raise InputError(*(where + line for line in error.problems)) from None
    except ValidationError as error:
        raise InputError(*(f"{path}: {line}" for line in Imported.in_words(error))) from None


def _plain(given: Any) -> Any:
    """Settings of surfaces as raw tables."""
    if isinstance(given, SurfaceSettings):
        return given.model_dump(exclude_none=True)
    if isinstance(given, Mapping):
        return {key: _plain(value) for key, value in given.items()}
    return given


def world_toml(world: Imported, folder: Path | None = None) -> str:
    """Obstacles of an imported world as TOML, with the name of each as a comment.

    Read back they are the same solids with the same surfaces, bit for bit.

    Args:
        world: From `read_world`, or of a scenario.
        folder: Of the file that is written: paths of meshes below it become relative.
    """
    head = [f"# {len(world.parts)} obstacles of {Path(world.file).name}"]
    head += [f"# not represented: {_comment(line)}" for line in world.unrepresented]
    return "\n".join(head) + "\n" + "".join(_entry(part, folder) for part in world.parts)


def _entry(part: NamedObstacle, folder: Path | None) -> str:
    table = part.obstacle.model_dump(exclude_defaults=True, exclude={"surface", "backing"})
    if folder is not None and isinstance(table.get("file"), str):
        path = Path(table["file"])
        inside = path.is_relative_to(folder.resolve())
        table["file"] = str(path.relative_to(folder.resolve())) if inside else str(path)
    lines = [f"{key} = {_value(value)}" for key, value in table.items()]
    lines += [
        f"{key} = {_surface(law)}"
        for key in ("surface", "backing")
        if isinstance(law := getattr(part.obstacle, key, None), SurfaceSettings)
    ]
    return "\n".join(["", f"[[world.obstacles]] # {_comment(part.name)}", *lines, ""])


def _comment(text: str) -> str:
    return "".join(letter if letter.isprintable() else "?" for letter in text)


def _surface(law: SurfaceSettings) -> str:
    """A surface as a preset, as one with another friction, or in full."""
    for name, known in SURFACES.items():
        if law == known:
            return json.dumps(name)
        if law == known.with_checked(friction=law.friction):
            return f"{{ preset = {json.dumps(name)}, friction = {_value(law.friction)} }}"
    keys = law.model_dump(exclude_none=True)
    return "{ " + ", ".join(f"{key} = {_value(value)}" for key, value in keys.items()) + " }"


def _value(value: Any) -> str:
    """A value of TOML; numbers are written so that they are read back unchanged."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float | int):
        return repr(value)
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(_value, value))}]"
    return json.dumps(str(value))

"""Scenario files: TOML with presets and overrides, and errors that name file, line and field."""

from __future__ import annotations

import contextlib
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from pydantic import ValidationError
from pydantic_core import PydanticCustomError

from springback.errors import InputError, excerpt
from springback.problems import dotted_path, key_path, problem_paths
from springback.scenario.code_files import with_absolute_names
from springback.scenario.key_lines import Key, line_of
from springback.scenario.overrides import apply_overrides
from springback.scenario.presets import is_vehicle_file
from springback.scenario.scenario import Scenario, expand_presets
from springback.scenario.source_text import source_text, toml_tables
from springback.scenario.worlds.mesh_check import tell_of_grids
from springback.vehicle.parameters import Vehicle

#: An obstacle that a problem of another key names.
_NAMED = re.compile(r"world\.obstacles\[\d+\]")


class SourceText(NamedTuple):
    """A file with tables."""

    name: str
    text: str
    tables: Any  # raw
    is_bare: bool = False  # it is the table of a vehicle; ``tables`` have it as their vehicle


def _blame(path: tuple[Key, ...], what: str, source: SourceText, overrides: Sequence[str]) -> str:
    """Source of a problem: the override of its key, or of an obstacle in it, else file and line."""
    whole = path
    for blamed in (path, *map(key_path, _NAMED.findall(what))):
        for word in reversed(overrides):
            parts = key_path(word.partition("=")[0])
            if blamed[: len(parts)] == parts or (blamed and parts[: len(blamed)] == blamed):
                return f"override {excerpt(word)}"
    source, path = _file_of(source, path)
    if _known_depth(source.tables, path) < len(path):  # by another key of its table, then
        for word in reversed(overrides):
            if key_path(word.partition("=")[0])[:-1] == whole[:-1] != ():
                return f"override {excerpt(word)}"
    return place_of(source.name, source.text, path[1:] if source.is_bare else path)


#: Tables in whose place a file can be named, innermost first.
_IN_FILES: tuple[tuple[Key, ...], ...] = (("second", "vehicle"), ("second",), ("vehicle",))


def _file_of(
    source: SourceText, path: tuple[Key, ...], chain: tuple[str, ...] = ()
) -> tuple[SourceText, tuple[Key, ...]]:
    """File in which a key is set, this one or one that it names, and the key's path in it.

    Files that name each other, ``chain``, are followed once.
    """
    for table in _IN_FILES:
        further = _named_file(source, table) if path[: len(table)] == table else None
        if further is None or further.name in chain:
            continue
        rest = path[len(table) :]
        found, inner = _file_of(
            further,
            ("vehicle", *rest) if table[-1] == "vehicle" else rest,
            (*chain, further.name),
        )
        here = len(path) - _known_depth(source.tables, path)
        there = len(inner) - _known_depth(found.tables, inner)
        return (source, path) if here <= there else (found, inner)
    return source, path


def _named_file(source: SourceText, path: tuple[Key, ...]) -> SourceText | None:
    """File that is named in place of a table, or as what the table changes; None without one."""
    table = source.tables
    for key in path:
        table = table.get(key) if isinstance(table, Mapping) else None
    word = table.get("preset") if isinstance(table, Mapping) else table
    if not is_vehicle_file(word):
        return None
    file = Path(source.name).parent / str(word)
    try:
        text = source_text(file)
        tables = toml_tables(text, str(file))
    except InputError:
        return None
    is_bare = path[-1] == "vehicle" and "vehicle" not in tables
    return SourceText(_shown(file), text, {"vehicle": tables} if is_bare else tables, is_bare)


def _shown(file: Path) -> str:
    """Name of a file, relative to the present folder if it is below it."""
    here = Path.cwd()
    return str(file.relative_to(here) if file.is_relative_to(here) else file)


def _known_depth(tables: Any, path: tuple[Key, ...]) -> int:
    """Number of keys of a path that raw tables have, from the first on."""
    for depth, key in enumerate(path):
        try:
            tables = tables[key]
        except (KeyError, IndexError, TypeError):
            return depth
    return len(path)


def place_of(name: str, text: str, path: Sequence[Key]) -> str:
    """File and line of a key path, or the file alone if its text does not mention the path."""
    line = line_of(text, path)
    return name if line is None else f"{name}:{line}"


def has_vehicle_only(tables: Mapping[str, Any]) -> bool:
    """True for raw tables of a vehicle without a scenario around it."""
    foreign = set(tables) - set(Vehicle.model_fields) - {"preset"}
    return not foreign and bool(set(tables) - {"name"})


def read_scenario(
    path: str | Path, overrides: Sequence[str] = (), *, pilot: bool | None = None
) -> Scenario:
    """Read a scenario file, apply overrides, and check it.

    Args:
        path: TOML file.
        overrides: Words such as ``vehicle.arms.stiffness=6000`` or ``start.pitch="15 deg"``.
        pilot: True if a pilot of your own will fly it; None if unknown.

    Raises:
        InputError: One line for each problem: file and line or override, field, value, unit, range.
    """
    if not isinstance(path, str | Path):
        raise InputError(f"scenario must be the path of a TOML file (got {path!r})")
    if isinstance(overrides, str):
        raise InputError(f"overrides must be a list of words (got {overrides!r})")
    path = Path(path)
    text = source_text(path)
    tables = toml_tables(text, str(path))
    if has_vehicle_only(tables):
        raise InputError(
            f'{path}: holds a vehicle, not a scenario: name it in one, vehicle = "{path.name}"'
        )
    given = with_absolute_names(tables, path.parent)
    return checked_scenario(apply_overrides(given, overrides), str(path), text, overrides, pilot)


#: Key of a scenario before a problem of it, and the name of a shape of the user's own.
_KEYED = re.compile(r"(?P<key>[a-z_]+(?:\.\w+|\[\d+\])*)(, \w+)?: ")


@contextlib.contextmanager
def as_input(scenario: object = None, overrides: Sequence[str] = ()) -> Iterator[None]:
    """Convert a problem that is found when a flight is built, and name its file and line.

    Args:
        scenario: Path of the scenario's file; anything else has none.
        overrides: Words, one of which may be at fault.

    Raises:
        InputError: One line for each problem.
    """
    try:
        try:
            yield
        except PydanticCustomError as error:
            said = f"{(error.context or {})['field']}: {error.message()}"
            raise InputError(said) from None
    except InputError as error:
        if not isinstance(scenario, str | Path):
            raise
        raise InputError(
            *(_with_place(line, Path(scenario), overrides) for line in error.problems)
        ) from error.__cause__


def _with_place(line: str, file: Path, overrides: Sequence[str]) -> str:
    """Problem of a key of a scenario, with its file and line or the override."""
    found = _KEYED.match(line)
    path = key_path(found["key"]) if found else ()
    if not path or path[0] not in Scenario.model_fields:
        return line
    text = source_text(file)
    source = SourceText(str(file), text, toml_tables(text, str(file)))
    return f"{_blame(path, line, source, overrides)}: {line}"


def checked_scenario(
    given: dict[str, Any],
    name: str,
    text: str,
    overrides: Sequence[str],
    pilot: bool | None = None,
) -> Scenario:
    """A scenario from raw tables; problems refer to lines of ``text`` or to overrides."""
    found: list[tuple[tuple[Key, ...], str]]
    try:
        expanded = expand_presets(with_absolute_names(given, Path()))
        tell_of_grids(expanded)
        return Scenario.model_validate(expanded, context={"pilot": pilot})
    except InputError as error:
        found = [(error.path, line) for line in error.problems]
    except ValidationError as error:
        found = problem_paths(error)
    problems = []
    for path, what in found:
        where = _blame(path, what, SourceText(name, text, given), overrides)
        problems.append(f"{where}: {dotted_path(path)}: {what}" if path else f"{where}: {what}")
    raise InputError(*problems)

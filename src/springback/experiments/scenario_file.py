"""Scenario files: TOML with presets and overrides, and errors that name file, line and field."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from springback.errors import InputError, shortened, shown_value
from springback.experiments.problems import dotted, key_path, problem_paths
from springback.experiments.scenario import Scenario, expanded
from springback.experiments.source_text import (
    MOST_DEPTH,
    check_depth,
    source_text,
    toml_tables,
)

Key = str | int
#: Lines of a file, and characters of a line, that are searched for the one at fault (chosen).
MOST_LINES, LONGEST_LINE = 20_000, 500


def _value(text: str) -> Any:
    """The value of an override: TOML where it is TOML, else the text itself."""
    try:
        return tomllib.loads(f"value = {text}")["value"]
    except (ValueError, RecursionError):
        return text


def overridden(given: dict[str, Any], overrides: Sequence[str]) -> dict[str, Any]:
    """A raw scenario with ``key=value`` words applied, in order.

    Raises:
        InputError: For a word that is no ``key=value``, or that points into something that is no
            table.
    """
    result: Any = given
    check_depth(given, "scenario")
    for word in overrides:
        key, sign, text = word.partition("=")
        parts = list(key_path(key.strip()))
        if not sign or not parts:
            raise InputError(
                f"{shown_value(word)} is no override; write key=value, such as "
                "vehicle.arms.stiffness=6000"
            )
        if len(parts) > MOST_DEPTH:
            raise InputError(
                f"{shown_value(word)} is no override; its key has {len(parts)} parts, "
                f"and at most {MOST_DEPTH} are read"
            )
        result = replaced(result, parts, _value(text.strip()), word)
        check_depth(result, f"override {shown_value(word)}")
    return dict(result)


def replaced(node: Any, parts: Sequence[Key], value: Any, word: str) -> Any:
    """``node`` with one value replaced, copied on the way; all that is beside the way is shared.

    Args:
        node: Raw tables, of which strings are names of presets.
        parts: Keys and indices of the value.
        value: In its place.
        word: Who asks, for errors.
    """
    head, *rest = parts
    if isinstance(node, str):  # a preset's name, about to be adjusted
        node = {"preset": node}
    if isinstance(head, int):
        if not isinstance(node, list) or head >= len(node):
            raise InputError(f"{shown_value(word)}: there is no entry {head}")
        entry = replaced(node[head], rest, value, word) if rest else value
        return [*node[:head], entry, *node[head + 1 :]]
    if not isinstance(node, dict):
        raise InputError(f"{shown_value(word)}: {shown_value(head)} is not inside a table")
    if not rest and isinstance(node.get(head), dict) and isinstance(value, str):
        value = {"preset": value}
    return {**node, head: replaced(node.get(head, {}), rest, value, word) if rest else value}


def line_of(text: str, path: Sequence[Key]) -> int:
    """Line of the most exact mention of a key path in a TOML text; 1 if there is none.

    TOML parsers keep no positions, so this follows table headers and keys; inline tables and dotted
    keys count as their first line.
    """
    counts: dict[str, int] = {}
    table: list[Key] = []
    best, best_length = 1, 0
    for number, line in enumerate(text.splitlines()[:MOST_LINES], start=1):
        if len(line) > LONGEST_LINE:
            continue
        header = re.match(r"\s*(\[\[?)\s*([^\[\]]+?)\s*\]\]?\s*(#.*)?$", line)
        key = re.match(r"\s*([A-Za-z0-9_.\"'-]+)\s*=", line)
        if header:
            name = header.group(2)
            table = list(key_path(name))
            if header.group(1) == "[[":
                counts[name] = counts.get(name, -1) + 1
                table = [*table, counts[name]]
            else:
                for owner, index in counts.items():
                    stem = list(key_path(owner))
                    if table[: len(stem)] == stem:
                        table = [*stem, index, *table[len(stem) :]]
            here = table
        elif key:
            here = [*table, *key_path(key.group(1).replace('"', "").replace("'", ""))]
        else:
            continue
        if list(path[: len(here)]) == here and len(here) > best_length:
            best, best_length = number, len(here)
    return best


def _blame(path: tuple[Key, ...], name: str, text: str, overrides: Sequence[str]) -> str:
    """Where a problem comes from: the override that set it, else file and line."""
    for word in reversed(overrides):
        parts = key_path(word.partition("=")[0])
        if path[: len(parts)] == parts or (path and parts[: len(path)] == path):
            return f"override {shortened(word)}"
    return f"{name}:{line_of(text, path)}"


def read_scenario(
    path: str | Path, overrides: Sequence[str] = (), *, pilot: bool | None = None
) -> Scenario:
    """Read a scenario file, apply overrides, and check it.

    Args:
        path: TOML file.
        overrides: Words such as ``vehicle.arms.stiffness=6000`` or ``start.pitch="15 deg"``.
        pilot: Whether a pilot of the user's own will fly it; None if that is not known yet.

    Raises:
        InputError: One line for each problem: file and line or override, field, value, unit, range.
    """
    path = Path(path)
    text = source_text(path)
    given = toml_tables(text, str(path))
    return checked_scenario(overridden(given, overrides), str(path), text, overrides, pilot)


def checked_scenario(
    given: dict[str, Any],
    name: str,
    text: str,
    overrides: Sequence[str],
    pilot: bool | None = None,
) -> Scenario:
    """A scenario from raw tables; problems are blamed on lines of ``text`` or on overrides."""
    try:
        return Scenario.model_validate(expanded(given), context={"pilot": pilot})
    except InputError as error:
        quoted = re.search(r"'([^']+)'", str(error))
        value = f"""[=\\s{{\\[]["']?{re.escape(quoted[1])}["']?\\s*([,}}#]|$)""" if quoted else "$^"
        lines = [n for n, line in enumerate(text.splitlines(), 1) if re.search(value, line)]
        where = next(
            (f"override {shortened(w)}" for w in overrides if quoted and quoted[1] in w), None
        )
        raise InputError(f"{where or f'{name}:{lines[0] if lines else 1}'}: {error}") from None
    except ValidationError as error:
        problems = []
        for path, what in problem_paths(error):
            where = _blame(path, name, text, overrides)
            problems.append(f"{where}: {dotted(path)}: {what}" if path else f"{where}: {what}")
        raise InputError(*problems) from None

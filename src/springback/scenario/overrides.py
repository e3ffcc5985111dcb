"""Overrides: words such as ``start.pitch=15 deg`` applied to the raw tables of a scenario."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from springback.errors import InputError, excerpt, shown_value
from springback.problems import dotted_path, key_path, nearest_name
from springback.scenario.fields import fields_of
from springback.scenario.scenario import Scenario, expand_presets
from springback.scenario.source_text import MOST_DEPTH, check_depth, source_text, toml_tables
from springback.settings import Settings
from springback.user_code import CODE_FORM

Key = str | int

#: Two notations of the attitude at the start: an override in one replaces the file's in the other.
_ANGLES = frozenset({"roll", "pitch", "yaw"})

#: Numbers that TOML does not know, without a digit before or after the point.
_SHORT_NUMBER = re.compile(r"[+-]?(?:\.[0-9]+|[0-9]+\.)(?:[eE][+-]?[0-9]{1,3})?")


def _value(text: str) -> Any:
    """Value of an override: parsed as TOML if possible, else a number or the text itself."""
    if _SHORT_NUMBER.fullmatch(text):
        return float(text)
    try:
        return tomllib.loads(f"value = {text}")["value"]
    except (ValueError, RecursionError):
        return text


def apply_overrides(given: dict[str, Any], overrides: Sequence[str]) -> dict[str, Any]:
    """A raw scenario with ``key=value`` words applied, in order.

    Raises:
        InputError: For a word that is not ``key=value``, or that points into something that is not
            a table.
    """
    result: Any = _without_replaced(given, overrides)
    check_depth(given, "scenario")
    for word in overrides:
        if not isinstance(word, str):
            raise InputError(
                f"{word!r} is not an override; write text such as 'start.pitch=15 deg'"
            )
        key, sign, text = word.partition("=")
        parts = list(key_path(key.strip()))
        if not sign or not parts:
            raise InputError(
                f"{shown_value(word)} is not an override; write key=value, such as "
                "vehicle.arms.stiffness=6000"
            )
        if len(parts) > MOST_DEPTH:
            raise InputError(
                f"{shown_value(word)} is not an override; its key has {len(parts)} parts, "
                f"and at most {MOST_DEPTH} are read"
            )
        result = with_value(_with_full_list(result, parts, word), parts, _value(text.strip()), word)
        check_depth(result, f"override {shown_value(word)}")
    return dict(result)


def _without_replaced(given: dict[str, Any], overrides: Sequence[str]) -> dict[str, Any]:
    """Raw tables without the attitude that overrides give in the other notation."""
    start = given.get("start")
    keys = {word.partition("=")[0].strip() for word in overrides if isinstance(word, str)}
    replaced = _ANGLES if "start.quaternion" in keys else frozenset()
    if any(f"start.{angle}" in keys for angle in _ANGLES):
        replaced |= {"quaternion"}
    if not isinstance(start, dict) or not replaced.intersection(start):
        return given
    return {**given, "start": {key: start[key] for key in start if key not in replaced}}


def _with_full_list(given: Any, parts: Sequence[Key], word: str) -> Any:
    """Raw tables in which the list that ``parts`` refer to is written out.

    An entry such as ``start.position.2`` can be overridden although the list is not given, but
    comes from a preset or a default: the other entries remain.
    """
    lists = [parts[:k] for k, part in enumerate(parts) if isinstance(part, int) and k]
    if not lists or (found := default_at(given, lists[0])) is None:
        return given
    return with_value(given, lists[0], found, word)


def default_at(given: Any, path: Sequence[Key]) -> list[Any] | None:
    """Default list at a path; None if there is none, or if raw tables give one.

    Args:
        given: Raw tables of a scenario.
        path: Keys of the list.
    """
    if not isinstance(given, dict) or _at(given, path) is not None:
        return None
    try:
        found = _at(expand_presets(given), path)
    except InputError:  # from another part, reported when the whole is read
        return None
    table: Any = Scenario
    for key in path if found is None else ():
        field = table.model_fields.get(key) if issubclass(table, Settings) else None
        found = field.default if field is not None else None
        table = type(found) if found is not None else _table_of(table, key)
    return list(found) if isinstance(found, list | tuple) else None


def _table_of(table: Any, key: Any) -> Any:
    """Type of the table at a key of another one; that of nothing if there is none."""
    is_table = isinstance(table, type) and issubclass(table, Settings)
    known = fields_of(table).get(key) if is_table else None
    return (known and known.table) or type(None)


def _at(tables: Any, path: Sequence[Key]) -> Any:
    """Value at a path of raw tables; None if there is none."""
    for key in path:
        if isinstance(tables, dict):
            tables = tables.get(key)
        elif isinstance(tables, list | tuple) and isinstance(key, int) and key < len(tables):
            tables = tables[key]
        else:
            return None
    return tables


def with_value(node: Any, parts: Sequence[Key], value: Any, word: str) -> Any:
    """``node`` with one value replaced; the path to it is copied, all else is shared.

    Args:
        node: Raw tables, in which strings are names of presets.
        parts: Keys and indices of the value.
        value: New value.
        word: Override, for errors.
    """
    head, rest = parts[0], parts[1:]
    if isinstance(node, str):  # a name alone, of a table to be modified
        node = _named_table(node)
    if isinstance(head, int):
        if not isinstance(node, list) or head >= len(node):
            problem = _misspelt(word) or f"there is no entry {head}{_entry_count(node)}"
            raise InputError(f"override {excerpt(word)}: {problem}")
        entry = with_value(node[head], rest, value, word) if rest else value
        return [*node[:head], entry, *node[head + 1 :]]
    if not isinstance(node, dict):
        problem = _by_number(node, parts, word) or f"{shown_value(head)} is not inside a table"
        raise InputError(f"override {excerpt(word)}: {problem}")
    if not rest and isinstance(node.get(head), dict) and isinstance(value, str):
        value = _named_table(value)
    if not rest:
        return {**node, head: value}
    inner = {} if node.get(head) is None else node[head]  # a table that is not there yet
    return {**node, head: with_value(inner, rest, value, word)}


def _named_table(word: str) -> dict[str, Any]:
    """Table of a name alone: that of code of the user's own, else of a preset."""
    return {"code" if CODE_FORM.match(word) else "preset": word}


def _misspelt(word: str) -> str:
    """Problem with the first key of an override that its table does not know, or empty."""
    table: Any = Scenario
    for key in key_path(word.partition("=")[0].strip()):
        if not isinstance(key, str) or not issubclass(table, Settings):
            return ""
        known = {one.key for one in fields_of(table).values()}
        if key not in known:
            near = nearest_name(key, known)
            hint = (
                f"; did you mean {near}?" if near else f"; known here: {', '.join(sorted(known))}"
            )
            return f"unknown key {shown_value(key)}{hint}"
        table = _table_of(table, key)
    return ""


def _by_number(node: Any, parts: Sequence[Key], word: str) -> str:
    """Problem with a name where a list wants a number, or empty.

    Args:
        node: The list, if it is one.
        parts: The name, and the keys below it.
        word: Override.
    """
    if not isinstance(node, list):
        return ""
    above = dotted_path(key_path(word.partition("=")[0].strip())[: -len(parts)])
    said = f"entries of {above} go by number{_entry_count(node).replace('; entries are', ',')}"
    names = [entry.get("name") if isinstance(entry, dict) else None for entry in node]
    near = nearest_name(str(parts[0]), [name for name in names if isinstance(name, str)])
    if not near:
        return said
    number = names.index(near)
    if near == parts[0]:
        return f"{said}: {near} is number {number}"
    return f"{said}, not by {shown_value(parts[0])}; did you mean {near}, number {number}?"


def _entry_count(node: Any) -> str:
    """Number of entries, in words."""
    if not isinstance(node, list):
        return "; it is not a list"
    last = len(node) - 1
    if last < 0:
        return "; the list is empty"
    return f"; entries are 0 to {last}" if last else "; the only entry is 0"


def overlay_words(path: str | Path) -> list[str]:
    """Overrides of a scenario that an overlay holds, such as ``vehicle.body.mass=1.2``.

    Raises:
        InputError: If the file is no overlay.
    """
    given = toml_tables(source_text(Path(path)), str(path))
    values = given.get("values")
    if not isinstance(values, Mapping) or not values:
        raise InputError(
            f"{path}: is no overlay: it has no table [values], which springback identify fit writes"
        )
    for key, value in values.items():
        if isinstance(value, bool) or not isinstance(value, int | float | str):
            raise InputError(f"{path}: values.{key}: must be a number (got {value!r})")
    return [f"{key}={value!r}" if not isinstance(value, str) else f"{key}={json.dumps(value)}"
            for key, value in values.items()]  # fmt: skip

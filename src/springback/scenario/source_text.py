"""User files: read as text, within limits, and parsed to plain tables.

A file may come from a stranger or be the wrong one, so its size, depth and type are checked before
it is used.
"""

from __future__ import annotations

import json
import re
import stat
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

from springback.errors import InputError
from springback.problems import dotted_path
from springback.scenario.key_lines import RepeatedKey, repeated_key

#: Largest file that is read [B] (chosen: a plan of 100 000 explicit values has 2 MB).
MOST_BYTES = 8_000_000
#: Maximum nesting of tables and lists (chosen: a scenario has five).
MOST_DEPTH = 32

#: Place of an error, as parsers of TOML and JSON word it.
_AT = re.compile(r"\(?(at )?line (?P<line>\d+),? column (?P<column>\d+).*")

#: How the parser of TOML words a key or a table that is there already.
_TWICE = ("Cannot overwrite a value", "Cannot declare")


def source_text(path: Path) -> str:
    """Text of a file, without byte order mark.

    Raises:
        InputError: If it cannot be read, is not a regular file, is too large, or is not UTF-8.
    """
    try:
        kind = path.stat()
        if not stat.S_ISREG(kind.st_mode) and not stat.S_ISDIR(kind.st_mode):
            raise InputError(f"{path}: cannot be read (is not a regular file)")
        if kind.st_size > MOST_BYTES and not stat.S_ISDIR(kind.st_mode):
            size = f"{kind.st_size / 1e6:.3g} MB"
            raise InputError(
                f"{path}: is too large, {size}; a file of at most {MOST_BYTES / 1e6:g} MB is read"
            )
        return path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError:
        raise InputError(f"{path}: is not text in UTF-8") from None
    except InputError:  # a ValueError, too
        raise
    except OSError as error:
        raise InputError(f"{path}: cannot be read ({error.strerror})") from None
    except ValueError as error:  # an invalid file name
        raise InputError(f"{path}: cannot be read ({error})") from None


def toml_tables(text: str, name: str) -> dict[str, Any]:
    """Tables of a text in TOML.

    Args:
        text: Text of a file or a string.
        name: Name of the file, for errors.

    Raises:
        InputError: If it is not TOML, or too deep.
    """
    tables: dict[str, Any] = _parse(tomllib.loads, "TOML", text, name)
    return tables


def json_tables(text: str, name: str) -> dict[str, Any]:
    """Object of a text in JSON.

    Args:
        text: Text of a file.
        name: Name of the file, for errors.

    Raises:
        InputError: If it is not JSON, not an object, or too deep.
    """
    found = _parse(json.loads, "JSON", text, name)
    if not isinstance(found, dict):
        raise InputError(f"{name}: must be an object of JSON (got a {type(found).__name__})")
    return found


def _parse(parse: Callable[[str], Any], language: str, text: str, name: str) -> Any:
    try:
        found = parse(text)
    except RecursionError:
        raise InputError(f"{name}: {_too_deep()}") from None
    except ValueError as error:  # a syntax error, an integer of thousands of digits, a wrong date
        said = str(error).partition(";")[0]
        at = _AT.search(said)
        if at is None:
            raise InputError(f"{name}: is not {language}: {said}") from None
        line = int(at["line"])
        twice = repeated_key(text, line) if said.startswith(_TWICE) else None
        if twice is not None:
            raise InputError(f"{name}:{line}: {_repeated(twice)}") from None
        what = f"{said[: at.start()].rstrip(' :')}, column {at['column']}"
        raise InputError(f"{name}:{line}: is not {language}: {what}") from None
    if isinstance(found, dict):
        check_depth(found, name)
    return found


def _repeated(key: RepeatedKey) -> str:
    """What is wrong with a key that is given twice, or inside of a value."""
    path, holder = dotted_path(key.path), dotted_path(key.holder)
    if path == holder:
        return f"{path}: is given twice; the first is in line {key.line}"
    return (
        f"{path}: is inside {holder}, which has a value in line {key.line}: make that a "
        "table; a preset is its key preset"
    )


def check_depth(tables: Any, name: str) -> None:
    """Reject tables and lists nested too deeply.

    Args:
        tables: From a file, or from overrides.
        name: Their source, for errors.
    """
    layer, depth = [tables], 0
    while layer:
        if depth > MOST_DEPTH:
            raise InputError(f"{name}: {_too_deep()}")
        layer = [
            inner
            for outer in layer
            for inner in (outer.values() if isinstance(outer, dict) else outer)
            if isinstance(inner, dict | list | tuple)
        ]
        depth += 1


def _too_deep() -> str:
    return f"has tables or lists nested more than {MOST_DEPTH} deep"

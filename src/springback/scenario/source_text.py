"""Files that a user wrote: read as text, within bounds, and made plain tables.

A file may come from a stranger or be the wrong one, so that its size, its depth and what it is are
looked at before anything is made of it.
"""

from __future__ import annotations

import json
import stat
import tomllib
from pathlib import Path
from typing import Any

from springback.errors import InputError

#: Largest file that is read [B] (chosen: a plan of 100 000 values written out has 2 MB).
MOST_BYTES = 8_000_000
#: Tables and lists within one another, at most (chosen: a scenario has five).
MOST_DEPTH = 32


def source_text(path: Path) -> str:
    """The text of a file, without the mark that some editors put before it.

    Raises:
        InputError: If it cannot be read, is no regular file, is too large, or is not UTF-8.
    """
    try:
        kind = path.stat()
        if not stat.S_ISREG(kind.st_mode) and not stat.S_ISDIR(kind.st_mode):
            raise InputError(f"{path}: cannot be read (is no regular file)")
        if kind.st_size > MOST_BYTES and not stat.S_ISDIR(kind.st_mode):
            size = f"{kind.st_size / 1e6:.3g} MB"
            raise InputError(
                f"{path}: is too large, {size}; a file of at most {MOST_BYTES / 1e6:g} MB is read"
            )
        return path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError:
        raise InputError(f"{path}: is not text in UTF-8") from None
    except OSError as error:
        raise InputError(f"{path}: cannot be read ({error.strerror})") from None
    except ValueError as error:  # a name that no file can have
        raise InputError(f"{path}: cannot be read ({error})") from None


def toml_tables(text: str, name: str) -> dict[str, Any]:
    """The tables of a text in TOML.

    Args:
        text: Of a file or a string.
        name: Of the file, for errors.

    Raises:
        InputError: If it is not TOML, or too deep.
    """
    try:
        tables = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"{name}: is not TOML: {error}") from None
    except RecursionError:
        raise InputError(f"{name}: {_too_deep()}") from None
    except ValueError as error:  # a whole number of thousands of digits, a day that is none
        raise InputError(f"{name}: is not TOML: {str(error).partition(';')[0]}") from None
    check_depth(tables, name)
    return tables


def json_tables(text: str, name: str) -> dict[str, Any]:
    """The object of a text in JSON.

    Args:
        text: Of a file.
        name: Of the file, for errors.

    Raises:
        InputError: If it is not JSON, no object, or too deep.
    """
    try:
        found = json.loads(text)
    except json.JSONDecodeError as error:
        raise InputError(f"{name}: is not JSON: {error}") from None
    except RecursionError:
        raise InputError(f"{name}: {_too_deep()}") from None
    except ValueError as error:
        raise InputError(f"{name}: is not JSON: {str(error).partition(';')[0]}") from None
    if not isinstance(found, dict):
        raise InputError(f"{name}: must be an object of JSON (got a {type(found).__name__})")
    check_depth(found, name)
    return found


def check_depth(tables: Any, name: str) -> None:
    """Refuse tables and lists too deep within one another.

    Args:
        tables: Of a file, or made of overrides.
        name: Whose they are, for errors.
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
    return f"has tables or lists more than {MOST_DEPTH} deep within one another"

"""Problems as data, for ``--json``: each line of an error, taken apart."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path
from typing import Any

#: Beginning of a line: the override or the file at fault, and perhaps its line.
_SOURCE = re.compile(r"(?:override (?P<override>.+?)|(?P<file>[^\s:][^:]*?)(?::(?P<line>\d+))?): ")
#: Key at fault, perhaps with the type of what is there.
_FIELD = re.compile(r"(?P<field>[A-Za-z_]\w*(?:\.[\w-]+|\[\d+\])*)(?:, \w+)?: ")


def problem_data(lines: Iterable[str]) -> dict[str, Any]:
    """Data of an error: what each of its lines says of file, line or override, field and problem.

    Args:
        lines: Of an `springback.errors.InputError`, or any others.
    """
    return {"kind": "error", "problems": [_parts(line) for line in lines]}


def _parts(line: str) -> dict[str, Any]:
    found: dict[str, Any] = {"file": None, "line": None, "override": None, "field": None}
    rest = line
    source = _SOURCE.match(line)
    if source is not None and (source["override"] or source["line"] or _is_file(source["file"])):
        found["override"], found["file"] = source["override"], source["file"]
        found["line"] = None if source["line"] is None else int(source["line"])
        rest = line[source.end() :]
    field = _FIELD.match(rest)
    if field is not None:
        found["field"], rest = field["field"], rest[field.end() :]
    return {**found, "message": rest}


def _is_file(word: str) -> bool:
    try:
        return Path(word).exists() or Path(word).suffix in (".toml", ".py", ".csv", ".json")
    except (OSError, ValueError):
        return False

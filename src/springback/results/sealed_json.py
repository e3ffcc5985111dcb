"""JSON with a checksum: plain data with a digest of the rest."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from springback.errors import InputError

#: Key of the digest.
SEAL = "seal"


def digest_of(data: Mapping[str, Any]) -> str:
    """SHA-256 of plain data, independent of the order of keys and of white space."""
    rest = {key: value for key, value in data.items() if key != SEAL}
    text = json.dumps(rest, sort_keys=True, ensure_ascii=True, allow_nan=False)
    return hashlib.sha256(text.encode()).hexdigest()


def with_digest(data: Mapping[str, Any]) -> dict[str, Any]:
    """Plain data with its digest."""
    return {**data, SEAL: digest_of(data)}


def is_sealed(data: Mapping[str, Any]) -> bool:
    """True if the data agree with their digest."""
    try:
        return data.get(SEAL) == digest_of(data)
    except (ValueError, RecursionError):
        return False


def read_object(path: Path) -> dict[str, Any]:
    """Read a JSON object from a file, sealed or not.

    Raises:
        FileNotFoundError: If there is no such file.
        InputError: If it cannot be read, or holds something else.
    """
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise
    except (OSError, ValueError, RecursionError) as error:
        text = getattr(error, "strerror", None) or str(error)
        first = (text.strip().splitlines() or [type(error).__name__])[0][:200]
        raise InputError(f"{path}: cannot be read as JSON ({first})") from None
    if not isinstance(found, dict):
        raise InputError(f"{path}: must be a JSON object (got {type(found).__name__})")
    return found


def file_digest(path: Path) -> str:
    """SHA-256 of a file, hexadecimal."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()

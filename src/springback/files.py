"""Files written completely or not at all; JSON and CSV in the form used by all commands."""

from __future__ import annotations

import contextlib
import csv
import io
import json
import os
import secrets
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

#: Suffix of files that are still being written.
DRAFT = ".draft"


@contextlib.contextmanager
def atomic_file(
    path: Path, *, suffix: str = "", durable: bool = False, mode: int = 0o666
) -> Iterator[Path]:
    """Open a new, empty file, which becomes ``path`` when the block ends without an error.

    Its name is unpredictable and it is created here (``O_EXCL``, ``O_NOFOLLOW``), so that no other
    user of the folder can put a link in its place.  If the block fails, it is removed.

    Args:
        path: Path of the file.
        suffix: Suffix of the draft's name, for writers that depend on it.
        durable: Flush it to the disk at the end of the block.
        mode: Permissions, less those that the process masks.

    Raises:
        OSError: If it cannot be written.
    """
    draft = path.with_name(f".{secrets.token_hex(8)}{DRAFT}{suffix}")
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_NOFOLLOW", 0)
    try:
        os.close(os.open(draft, flags, mode))
        yield draft
        if durable:
            _sync(draft)
        os.replace(draft, path)
        if durable and os.name == "posix":
            _sync(path.parent)
    finally:
        with contextlib.suppress(OSError):
            draft.unlink(missing_ok=True)


def _sync(path: Path) -> None:
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def write_atomically(
    path: Path, data: str | bytes, *, durable: bool = False, mode: int = 0o666
) -> None:
    """Write a file completely or not at all; text as UTF-8.

    Args:
        path: Path of the file.
        data: Its content.
        durable: Flush it to the disk.
        mode: Permissions, less those that the process masks.

    Raises:
        OSError: If it cannot be written.
    """
    with atomic_file(path, durable=durable, mode=mode) as draft:
        draft.write_bytes(data.encode() if isinstance(data, str) else data)


def json_text(data: Any) -> str:
    """Plain data as readable JSON: indented, without NaN or infinity."""
    return json.dumps(data, indent=2, allow_nan=False, ensure_ascii=False) + "\n"


def write_json(path: Path, data: Any) -> None:
    """Write plain data as JSON, without NaN or infinity."""
    path.write_text(json_text(data), encoding="utf-8")


def csv_text(rows: Iterable[Sequence[Any]]) -> str:
    """Comma-separated values with a header; None is empty."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()


def write_csv(path: Path, rows: Sequence[Mapping[str, Any]]) -> None:
    """Write rows with the same columns as CSV with a header."""
    lines = [list(rows[0]), *(list(row.values()) for row in rows)] if rows else [[]]
    path.write_text(csv_text(lines), encoding="utf-8")

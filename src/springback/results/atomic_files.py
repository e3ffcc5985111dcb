"""Files that are there whole or not at all."""

from __future__ import annotations

import contextlib
import os
import secrets
from collections.abc import Iterator
from pathlib import Path

#: How names of files end that are still being written.
DRAFT = ".draft"


@contextlib.contextmanager
def drafted(path: Path, *, suffix: str = "", durable: bool = False) -> Iterator[Path]:
    """A new, empty file to write, which becomes ``path`` when the block ends well.

    Its name cannot be foreseen and it is made here (``O_EXCL``, ``O_NOFOLLOW``): nobody who may
    write to the folder can put a link in its place.  If the block fails, nothing is left of it.

    Args:
        path: Of the file.
        suffix: What the draft's name ends in, for writers that go by it.
        durable: Whether it is on the disk when the block has ended.

    Raises:
        OSError: If it cannot be written.
    """
    draft = path.with_name(f".{secrets.token_hex(8)}{DRAFT}{suffix}")
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_NOFOLLOW", 0)
    try:
        os.close(os.open(draft, flags, 0o666))
        yield draft
        if durable:
            _onto_disk(draft)
        os.replace(draft, path)
        if durable and os.name == "posix":
            _onto_disk(path.parent)
    finally:
        with contextlib.suppress(OSError):
            draft.unlink(missing_ok=True)


def _onto_disk(path: Path) -> None:
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)

"""The ledger: which parts of a campaign are there, one line of JSON for each."""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from springback.errors import InputError

NAME = "ledger.jsonl"


@dataclass(frozen=True)
class Part:
    """A stretch of flights that is in a file of its own."""

    first: int
    last: int
    """Before this flight."""
    file: str
    bytes: int
    sha256: str
    refused: int = 0
    """Flights that could not be flown."""
    ledger_open: int = 0
    """Flights whose energy ledger does not close to 1e-4."""
    withdrawn: bool = False
    """Whether it was found damaged, and is to be flown again."""

    def whole(self, folder: Path) -> bool:
        """Whether the file is there as it was written."""
        path = folder / self.file
        try:
            if path.stat().st_size != self.bytes:
                return False
            with path.open("rb") as file:
                return hashlib.file_digest(file, "sha256").hexdigest() == self.sha256
        except OSError:
            return False


def read(path: Path) -> list[Part]:
    """Parts in the ledger, in the order of their flights; none if there is no ledger.

    A last line that a crash tore does not count, nor does a part that was withdrawn.

    Raises:
        InputError: If a line that was written whole cannot be read.
    """
    try:
        lines = path.read_bytes().split(b"\n")[:-1]  # a whole line ends with a newline
    except FileNotFoundError:
        return []
    parts: dict[str, Part] = {}
    for number, line in enumerate(lines, 1):
        try:
            part = Part(**json.loads(line))
        except (ValueError, TypeError):
            raise InputError(f"{path}:{number}: is not a line of a ledger") from None
        parts.pop(part.file, None)
        if not part.withdrawn:
            parts[part.file] = part
    return sorted(parts.values(), key=lambda part: part.first)


def append(path: Path, part: Part) -> None:
    """Add a line; it is on the disk when this returns, or is not there at all.

    Raises:
        OSError: If the disk is full.
    """
    with path.open("ab") as file:
        size = file.tell()
        try:
            file.write(json.dumps(asdict(part)).encode() + b"\n")
            file.flush()
            os.fsync(file.fileno())
        except OSError:
            with contextlib.suppress(OSError):
                os.ftruncate(file.fileno(), size)
            raise


def mend(path: Path) -> None:
    """Cut off a last line that a crash tore, so that the next line starts afresh."""
    if path.exists():
        data = path.read_bytes()
        whole = data.rfind(b"\n") + 1
        if whole < len(data):
            os.truncate(path, whole)


def missing(parts: Iterable[Part], flights: int, chunk: int) -> list[tuple[int, int]]:
    """Stretches of flights that no part holds, cut into chunks.

    Args:
        parts: In the order of their flights.
        flights: Of the whole campaign.
        chunk: Most flights of a stretch.
    """
    found: list[tuple[int, int]] = []
    at = 0
    for first, last in [*((part.first, part.last) for part in parts), (flights, flights)]:
        found += ((k, min(k + chunk, first)) for k in range(at, first, chunk))
        at = max(at, last)
    return found


def held(parts: Sequence[Part]) -> int:
    """Number of flights in parts."""
    return sum(part.last - part.first for part in parts)

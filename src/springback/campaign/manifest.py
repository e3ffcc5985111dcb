"""The ledger: which parts of a campaign are there, one line of JSON for each."""

from __future__ import annotations

import contextlib
import functools
import json
import os
from collections.abc import Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass, fields
from itertools import pairwise
from pathlib import Path

from springback.errors import InputError
from springback.results.sealed_json import SEAL, file_digest, is_sealed, with_digest

NAME, PARTS = "ledger.jsonl", "parts"


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
        """Whether the file is there as it was written, by its digest."""
        path = folder / self.file
        try:
            about = path.stat()
            return about.st_size == self.bytes and self.sha256 == _digest(
                path, about.st_mtime_ns, about.st_size
            )
        except OSError:
            return False


def file_of(first: int) -> str:
    """Name of the part that begins with a flight."""
    return f"{PARTS}/part-{first:010d}.parquet"


@functools.lru_cache(maxsize=65536)
def _digest(path: Path, changed: int, size: int) -> str:
    """Digest of a file as it was at a time: worked out once in a process."""
    return file_digest(path)


def damaged_parts(parts: Iterable[Part], folder: Path) -> list[Part]:
    """Parts that are not as they were written: all bytes are read, on as many cores as there are.

    Args:
        parts: Any.
        folder: Of the campaign.
    """
    every = list(parts)
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        whole = pool.map(lambda part: part.whole(folder), every)
        return [part for part, is_whole in zip(every, whole, strict=True) if not is_whole]


def read(path: Path) -> list[Part]:
    """Parts in the ledger, in the order of their flights; none if there is no ledger.

    A last line that a crash tore does not count, nor does a part that was withdrawn.

    Raises:
        InputError: If a line that was written whole cannot be read, names another file than its
            flights belong in, or holds flights that another one holds.
    """
    try:
        *lines, torn = path.read_bytes().split(b"\n")  # a whole line ends with a newline
    except FileNotFoundError:
        return []
    except OSError as error:
        raise InputError(f"{path}: cannot be read ({error.strerror})") from None
    parts: dict[str, Part] = {}
    for number, line in enumerate(lines, 1):
        part = _part(line)
        if part is None:
            raise InputError(f"{path}:{number}: is not a line of a ledger, or was damaged")
        parts.pop(part.file, None)
        if not part.withdrawn:
            parts[part.file] = part
    if torn and not _could_be_torn(torn):
        raise InputError(f"{path}:{len(lines) + 1}: is not a line of a ledger, or was damaged")
    found = sorted(parts.values(), key=lambda part: part.first)
    for one, other in pairwise(found):
        if other.first < one.last:
            raise InputError(
                f"{path}: {other.file} holds flights from {other.first} on, which {one.file} holds "
                f"up to {one.last - 1}; move the folder aside and fly the campaign afresh"
            )
    return found


def _part(line: bytes) -> Part | None:
    """A line of the ledger; None if it is none, or not as it was written."""
    try:
        given = json.loads(line)
    except (ValueError, RecursionError):
        return None
    if not isinstance(given, dict) or not is_sealed(given):
        return None
    try:
        part = Part(**{key: value for key, value in given.items() if key != SEAL})
    except TypeError:
        return None
    return part if _is_sound(part) else None


def _is_sound(part: Part) -> bool:
    """Whether types fit, and the file is the one where its flights belong: nothing elsewhere."""
    kinds = {"str": str, "int": int, "bool": bool}
    for one in fields(part):
        if type(getattr(part, one.name)) is not kinds[str(one.type)]:
            return False
    return 0 <= part.first < part.last and part.file == file_of(part.first)


def _could_be_torn(line: bytes) -> bool:
    """Whether a line without an end may be the beginning of one that was written whole."""
    if not line.isascii():  # which no line is
        return False
    try:
        text = line.decode()
        _, end = json.JSONDecoder().raw_decode(text)
    except (ValueError, RecursionError):
        return line.startswith(_BEGINNING[: len(line)])
    return end == len(text) and _part(line) is not None


#: How every line begins.
_BEGINNING = b'{"first": '


def append(path: Path, part: Part) -> None:
    """Add a line; it is on the disk when this returns, or is not there at all.

    Raises:
        OSError: If the disk is full.
    """
    with path.open("ab") as file:
        size = file.tell()
        try:
            file.write(json.dumps(with_digest(asdict(part))).encode() + b"\n")
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


def flight_count(parts: Sequence[Part]) -> int:
    """Number of flights in parts."""
    return sum(part.last - part.first for part in parts)

"""Manifest of the parts of a campaign, ``manifest.jsonl``: one line of JSON for each."""

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

NAME, PARTS = "manifest.jsonl", "parts"


@dataclass(frozen=True)
class Part:
    """A range of flights stored in a file of its own."""

    first: int
    last: int
    """Flight after the last."""
    file: str
    bytes: int
    sha256: str
    refused: int = 0
    """Number of flights that could not be flown."""
    ledger_open: int = 0
    """Number of flights whose energy balance does not close to 1e-4."""
    withdrawn: bool = False
    """True if it was found damaged, and will be flown again."""

    def whole(self, folder: Path) -> bool:
        """True if the file exists and agrees with its digest."""
        path = folder / self.file
        try:
            about = path.stat()
            return about.st_size == self.bytes and self.sha256 == _digest(
                path, about.st_mtime_ns, about.st_size
            )
        except OSError:
            return False


def file_of(first: int) -> str:
    """File name of the part that begins with a flight."""
    return f"{PARTS}/part-{first:010d}.parquet"


@functools.lru_cache(maxsize=65536)
def _digest(path: Path, changed: int, size: int) -> str:
    """Digest of a file in the state of a time and size, computed once per process."""
    return file_digest(path)


def damaged_parts(parts: Iterable[Part], folder: Path) -> list[Part]:
    """Parts that differ from their digests; all bytes are read, on all cores.

    Args:
        parts: Any.
        folder: Folder of the campaign.
    """
    every = list(parts)
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        whole = pool.map(lambda part: part.whole(folder), every)
        return [part for part, is_whole in zip(every, whole, strict=True) if not is_whole]


def read(path: Path) -> list[Part]:
    """Parts in the manifest, in order of their flights; empty if there is no manifest.

    An incomplete last line, left by a crash, is ignored, and so are withdrawn parts.

    Raises:
        InputError: If a complete line cannot be read, names a wrong file, or has flights of another
            part.
    """
    try:
        *lines, torn = path.read_bytes().split(b"\n")  # a complete line ends with a newline
    except FileNotFoundError:
        return []
    except OSError as error:
        raise InputError(f"{path}: cannot be read ({error.strerror})") from None
    parts: dict[str, Part] = {}
    for number, line in enumerate(lines, 1):
        part = _part(line)
        if part is None:
            raise InputError(f"{path}:{number}: is not a line of a manifest, or was damaged")
        parts.pop(part.file, None)
        if not part.withdrawn:
            parts[part.file] = part
    if torn and not _could_be_torn(torn):
        raise InputError(f"{path}:{len(lines) + 1}: is not a line of a manifest, or was damaged")
    found = sorted(parts.values(), key=lambda part: part.first)
    for one, other in pairwise(found):
        if other.first < one.last:
            raise InputError(
                f"{path}: {other.file} holds flights from {other.first} on, which {one.file} holds "
                f"up to {one.last - 1}; move the folder aside and fly the campaign afresh"
            )
    return found


def _part(line: bytes) -> Part | None:
    """Part of a line of the manifest; None if the line is invalid or altered."""
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
    """True if the types are right, and the file is the one that belongs to its flights."""
    kinds = {"str": str, "int": int, "bool": bool}
    for one in fields(part):
        if type(getattr(part, one.name)) is not kinds[str(one.type)]:
            return False
    return 0 <= part.first < part.last and part.file == file_of(part.first)


def _could_be_torn(line: bytes) -> bool:
    """True if an unterminated line may be the beginning of a valid one."""
    if not line.isascii():  # longer than any line
        return False
    try:
        text = line.decode()
        _, end = json.JSONDecoder().raw_decode(text)
    except (ValueError, RecursionError):
        return line.startswith(_BEGINNING[: len(line)])
    return end == len(text) and _part(line) is not None


#: Beginning of every line.
_BEGINNING = b'{"first": '


def append(path: Path, part: Part) -> None:
    """Append a line, flushed to the disk; if that fails, the manifest is unchanged.

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
    """Remove an incomplete last line, left by a crash."""
    if path.exists():
        data = path.read_bytes()
        whole = data.rfind(b"\n") + 1
        if whole < len(data):
            os.truncate(path, whole)


def missing(parts: Iterable[Part], flights: int, chunk: int) -> list[tuple[int, int]]:
    """Ranges of flights that no part has, split into chunks.

    Args:
        parts: Parts in order of their flights.
        flights: Number of flights of the campaign.
        chunk: Most flights of a chunk.
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

"""Files with the form of an obstacle: read within limits, and known by their content.

A file may come from a stranger or be the wrong one, so its size is checked before it is read.  What
identifies it is the SHA-256 of its bytes, which settings hold: a file that changes is noticed.
"""

from __future__ import annotations

import hashlib
import io
import math
import os
import stat
import zipfile
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.lib import format as npy
from pydantic_core import PydanticCustomError

from springback.settings import problem

Array = np.ndarray[Any, np.dtype[Any]]

#: Largest file that is read [B] (chosen: two million triangles of a binary STL).
MOST_BYTES = 100_000_000


class _KnownFile(NamedTuple):
    """State of a file when its digest was taken."""

    size: int
    changed: int  # [ns]
    digest: str


#: Digests of files that were read before, by path.
_KNOWN: dict[str, _KnownFile] = {}
#: Readers of content that is kept elsewhere, as with a saved flight, by digest.
_ELSEWHERE: dict[str, Callable[[], bytes]] = {}


def place_content(digest: str, read: Callable[[], bytes]) -> None:
    """Let a copy stand in for all files of the same content, wherever they were.

    Args:
        digest: SHA-256 of the content.
        read: Returns the content.
    """
    _ELSEWHERE[digest] = read


def _about(path: Path) -> os.stat_result:
    try:
        found = path.stat()
    except OSError as error:
        raise problem(f"{path}: cannot be read ({error.strerror})", "file") from None
    except ValueError as error:  # an impossible file name
        raise problem(f"{path}: cannot be read ({error})", "file") from None
    if not stat.S_ISREG(found.st_mode):
        raise problem(f"{path}: cannot be read (is not a regular file)", "file")
    if found.st_size > MOST_BYTES:
        raise problem(
            f"{path}: is too large, {found.st_size / 1e6:.4g} MB; a file of at most "
            f"{MOST_BYTES / 1e6:g} MB is read",
            "file",
        )
    return found


def content_digest(file: str) -> str:
    """SHA-256 of a file's content.

    Raises:
        The problem, if it cannot be read or is larger than `MOST_BYTES`.
    """
    path = Path(file)
    about = _about(path)
    known = _KNOWN.get(file)
    if known is not None and (known.size, known.changed) == (about.st_size, about.st_mtime_ns):
        return known.digest
    digest = hashlib.sha256(_bytes(path)).hexdigest()
    _KNOWN[file] = _KnownFile(about.st_size, about.st_mtime_ns, digest)
    return digest


def _bytes(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except OSError as error:
        raise problem(f"{path}: cannot be read ({error.strerror})", "file") from None


def checked_content(file: str, content: str) -> str:
    """SHA-256 of a file's content, which must be as given if it is given.

    Raises:
        The problem, if the file cannot be read, or was changed since its content was noted.
    """
    if content in _ELSEWHERE:
        return content
    found = content_digest(file)
    if content and found != content:
        raise problem(
            f"{file}: was changed: its content is {found[:12]}…, and was {content[:12]}…", "file"
        )
    return found


def file_bytes(file: str, content: str) -> bytes:
    """Bytes of a file of some content.

    Raises:
        The problem, if it cannot be read or has another content.
    """
    if content in _ELSEWHERE:
        data = _ELSEWHERE[content]()
    else:
        _about(Path(file))
        data = _bytes(Path(file))
    if hashlib.sha256(data).hexdigest() != content:
        raise problem(f"{file}: was changed while it was read", "file")
    return data


def suffix_of(file: str, known: Mapping[str, Any] | tuple[str, ...]) -> str:
    """Suffix of a file in small letters.

    Raises:
        The problem, if it is none of those known.
    """
    suffix = Path(file).suffix.lower()
    if suffix not in known:
        raise problem(f"{file}: must end in {', '.join(known)}", "file")
    return suffix


# -- arrays of numbers ----------------------------------------------------------------------------


#: Kinds of entries of an array that are no numbers, by NumPy's letter.
_OTHERS = {
    "U": "text", "S": "text", "O": "Python objects", "V": "records", "c": "complex numbers",
    "M": "dates", "m": "time differences",
}  # fmt: skip


def _npy(file: str, data: bytes, most: int) -> Array:
    stream = io.BytesIO(data)
    try:
        version = npy.read_magic(stream)
        read: Callable[[Any], Any] = (
            npy.read_array_header_1_0 if version == (1, 0) else npy.read_array_header_2_0
        )
        shape, _, kind = read(stream)
        if kind.kind not in "fiub":
            what = _OTHERS.get(kind.kind, f"{kind}")
            raise problem(f"{file}: must hold numbers (got {what})", "file")
        if (count := math.prod(shape)) > most:
            raise problem(f"{file}: must hold at most {most} numbers (got {count})", "file")
        stream.seek(0)
        found: Array = npy.read_array(stream, allow_pickle=False)
    except PydanticCustomError:  # a whole file, of other things or too many: a ValueError, too
        raise
    except (ValueError, EOFError, OSError, SyntaxError, MemoryError) as error:
        what = " ".join(str(error).split())[:120]
        raise problem(f"{file}: is not a whole file of NumPy ({what})", "file") from None
    return found


def npy_array(file: str, data: bytes, most: int) -> Array:
    """Array of numbers of a file of NumPy.

    Args:
        file: Its name, for errors.
        data: Its content.
        most: Most numbers.

    Raises:
        The problem, if it is damaged, holds other things than numbers, or too many.
    """
    return _npy(file, data, most)


def npz_arrays(file: str, data: bytes, most: int) -> dict[str, Array]:
    """Arrays of numbers of a file ``.npz``, by name; arguments and problems as of `npy_array`."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            entries = archive.infolist()
            room = 8 * most + 4096 * len(entries)
            if sum(entry.file_size for entry in entries) > room:
                raise problem(f"{file}: must hold at most {most} numbers", "file")
            return {
                entry.filename.removesuffix(".npy"): _npy(file, archive.read(entry), most)
                for entry in entries
            }
    except (zipfile.BadZipFile, OSError, EOFError, NotImplementedError, RuntimeError) as error:
        raise problem(f"{file}: is not a whole file of NumPy ({error})", "file") from None

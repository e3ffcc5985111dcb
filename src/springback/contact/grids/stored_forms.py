"""Distance grids on disk: computed once for a content, by one process, and verified before use.

A file holds SHA-256 of the rest, then arrays.  One that is damaged, or cannot be written, is
skipped with a `CacheWarning`; the numbers are the same.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import os
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import platformdirs
from filelock import FileLock, Timeout

from springback.contact.grids.distance_grids import DistanceGrid
from springback.errors import CacheWarning
from springback.files import write_atomically

#: Number of the form of the files, and of what computes them: a change makes them anew.
VERSION = 7
_DIGEST = 32
#: Longest wait for another process that computes the same [s] (chosen).
_PATIENCE = 600.0


def form_folder() -> Path:
    """Folder of the kept grids; ``SPRINGBACK_CACHE_DIR`` overrides the user's."""
    root = os.environ.get("SPRINGBACK_CACHE_DIR") or platformdirs.user_cache_dir("springback")
    return Path(os.path.expanduser(root)) / "forms"


def stored_grid(key: str, make: Callable[[], DistanceGrid]) -> DistanceGrid:
    """A grid of the disk, or a new one, which is then kept.

    Args:
        key: Everything that it depends on, in words.
        make: Computes it.
    """
    name = hashlib.sha256(f"{VERSION} {key}".encode()).hexdigest()
    path = form_folder() / f"{name}.grid"
    found = _read(path)
    if found is not None:
        return found
    with _alone(path):
        found = _read(path)  # another process may have made it meanwhile
        if found is not None:
            return found
        made = make()
        _write(path, made)
    return made


@contextlib.contextmanager
def _alone(path: Path) -> Iterator[None]:
    """Context that one process enters at a time, where files can be locked."""
    lock = None
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        lock = FileLock(path.with_name(f".{path.stem}.lock"))
        lock.acquire(timeout=_PATIENCE)
    except (OSError, NotImplementedError, Timeout):
        lock = None
    try:
        yield
    finally:
        if lock is not None:
            lock.release()


def _read(path: Path) -> DistanceGrid | None:
    try:
        data = path.read_bytes()
    except (FileNotFoundError, NotADirectoryError):
        return None
    except OSError as error:
        _warn(f"{path}: kept grid ignored ({error.strerror}); it is made anew")
        return None
    try:
        if hashlib.sha256(data[_DIGEST:]).digest() != data[:_DIGEST]:
            raise ValueError("it is damaged")
        with np.load(io.BytesIO(data[_DIGEST:]), allow_pickle=False) as arrays:
            return DistanceGrid(
                arrays["low"], float(arrays["cell"]), arrays["values"], arrays["error"],
                float(arrays["thinnest"]),
            )  # fmt: skip
    except Exception as error:  # whatever a foreign file causes
        what = " ".join(str(error).split())[:120]
        _warn(f"{path}: kept grid ignored ({what}); it is made anew")
        return None


def _write(path: Path, grid: DistanceGrid) -> None:
    stream: Any = io.BytesIO()
    np.savez(stream, **grid._asdict())
    data = stream.getvalue()
    try:
        write_atomically(path, hashlib.sha256(data).digest() + data, mode=0o644)
    except OSError as error:
        _warn(
            f"{path.parent}: grids cannot be kept ({error.strerror}); every start makes them anew. "
            "SPRINGBACK_CACHE_DIR names another folder"
        )


def _warn(text: str) -> None:
    warnings.warn(text, CacheWarning, stacklevel=3)

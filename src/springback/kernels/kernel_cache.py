"""Compiled kernels on disk: one file for each signature, checked before it is believed.

A file holds SHA-256 of the rest, then a pickle of the key and the compiled code; for a GPU its name
and LLVM's bitcode or PTX.  Each is a program, so only files are read that the user or root owns and
that nobody else can write, as ssh does with its keys.  Whatever cannot be read, checked or written
is left aside with a `CacheWarning`, and the kernel is compiled for this process alone.

The compiler's own cache has an index with neither checksum nor owner: an empty or torn file stops
every later start, and two processes that keep different signatures at once can exchange them.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import pickle
import stat
import time
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from numba.core import compiler, serialize

from springback.errors import CacheWarning
from springback.files import write_atomically

#: What reads and writes compiled code.
_rebuild: Any = compiler.CompileResult._rebuild
_dumps: Any = serialize.dumps
#: Length of SHA-256 [bytes].
_DIGEST = 32
#: Drafts older than this are of processes that were killed [s] (chosen).
_STALE = 3600.0
#: What was said already in this process.
_said: set[str] = set()


class KernelCache:
    """The kept signatures of one entry point; the interface is that of numba's own caches."""

    def __init__(self, function: Any, folder: Path) -> None:
        """Of an entry point; the folder is made when something is kept in it.

        Args:
            function: The undecorated entry point.
            folder: Of its own for every state of the source.
        """
        self._folder = folder
        self._code = hashlib.sha256(function.__code__.co_code).hexdigest()
        line = function.__code__.co_firstlineno
        self._name = f"{function.__module__}.{function.__qualname__}-{line}"

    @property
    def cache_path(self) -> str:
        """The folder."""
        return str(self._folder)

    def enable(self) -> None:
        """Nothing to do: it is always on."""

    def disable(self) -> None:
        """Nothing to do: it is always on."""

    def flush(self) -> None:
        """Keep what is kept: the folder's name changes with the source."""

    def load_overload(self, signature: Any, context: Any) -> Any:
        """The kernel for a signature, or None if it is not there or not to be trusted."""
        context.refresh()
        key = self._key(signature, context.codegen())
        for path in self._candidates(key):
            try:
                data = _trusted(path)
                if data is None:
                    return None
                known, payload = pickle.loads(data)
                if known != key:
                    continue
                return _rebuild(context, *payload)
            except Exception as error:  # whatever a torn or foreign file leads to
                _left_aside(path, error)
                return None
        return None

    def save_overload(self, signature: Any, result: Any) -> None:
        """Keep a kernel, whole or not at all."""
        if any(not lifted.can_cache for lifted in result.lifted):
            return
        if result.library.has_dynamic_globals:
            return
        key = self._key(signature, result.codegen)
        try:
            data = _dumps((key, result._reduce()))
            _write(self._free(key), data)
        except Exception as error:
            _not_kept(self._folder, error)

    def _key(self, signature: Any, codegen: Any) -> tuple[Any, ...]:
        return self._name, signature, codegen.magic_tuple(), self._code

    def _candidates(self, key: tuple[Any, ...]) -> Iterator[Path]:
        """Files that may hold a key: types of equal names share a stem."""
        stem = hashlib.sha256(repr(key).encode()).hexdigest()[:32]
        return (self._folder / f"{stem}-{k}.kernel" for k in range(100))

    def _free(self, key: tuple[Any, ...]) -> Path:
        """Where to keep a key: in its own file, or in place of one that cannot be used."""
        path = Path()
        for path in self._candidates(key):
            try:
                data = _trusted(path)
                if data is None or pickle.loads(data)[0] == key:
                    return path
            except Exception:
                return path
        return path


def cached(path: Path) -> bytes | None:
    """What `keep` wrote; None if there is nothing, or, with a warning, nothing to be trusted.

    Args:
        path: Whose last part is the key.
    """
    try:
        data = _trusted(path)
        if data is None:
            return None
        name, _, content = data.partition(b"\n")
        if name != path.name.encode():
            raise ValueError("it is another one's")
        return content
    except (OSError, ValueError) as error:
        _left_aside(path, error)
        return None


def keep(path: Path, content: bytes) -> None:
    """Keep a compiled program for other processes; not to be able to is a warning.

    Args:
        path: Whose last part is the key: the same for the same program only.
        content: Of the program.
    """
    try:
        _write(path, path.name.encode() + b"\n" + content)
    except OSError as error:
        _not_kept(path.parent, error)


def _trusted(path: Path) -> bytes | None:
    """What a file holds behind its digest; None if there is no such file.

    Raises:
        OSError: If it cannot be read, or somebody else could have written it.
        ValueError: If it is damaged.
    """
    try:
        handle = os.open(path, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0))
    except (FileNotFoundError, NotADirectoryError):
        return None
    with os.fdopen(handle, "rb") as file:
        about = os.fstat(handle)
        if not stat.S_ISREG(about.st_mode):
            raise ValueError("it is no file")
        if hasattr(os, "getuid"):
            if about.st_uid not in (os.getuid(), 0):
                raise PermissionError(f"it belongs to user {about.st_uid}")
            if about.st_mode & (stat.S_IWGRP | stat.S_IWOTH):
                raise PermissionError("others than its owner can write it")
        data = file.read()
    if hashlib.sha256(data[_DIGEST:]).digest() != data[:_DIGEST]:
        raise ValueError("it is damaged")
    return data[_DIGEST:]


def _write(path: Path, data: bytes) -> None:
    """Write data behind its digest, whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    _remove_stale(path.parent)
    write_atomically(path, hashlib.sha256(data).digest() + data, mode=0o644)


def _remove_stale(folder: Path) -> None:
    """Remove drafts of processes that were killed."""
    for draft in folder.glob(".*.draft"):
        with contextlib.suppress(OSError):
            if time.time() - draft.stat().st_mtime > _STALE:
                draft.unlink()


def _reason(error: BaseException) -> str:
    text = getattr(error, "strerror", None) or " ".join(str(error).split())
    return text[:200] or type(error).__name__


def _left_aside(path: Path, error: BaseException) -> None:
    _say(f"{path}: kept kernel left aside ({_reason(error)}); compiling it anew")


def _not_kept(folder: Path, error: BaseException) -> None:
    _say(
        f"{folder}: compiled kernels cannot be kept ({_reason(error)}); every start compiles them "
        "anew. SPRINGBACK_CACHE_DIR names another folder"
    )


def _say(text: str) -> None:
    """Warn, once a process."""
    if text not in _said:
        _said.add(text)
        warnings.warn(text, CacheWarning, stacklevel=2)

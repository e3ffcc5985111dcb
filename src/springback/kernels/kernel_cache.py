"""Compiled kernels on disk: one file per signature, verified before use.

A file holds SHA-256 of the rest, then a pickle of the key and the compiled code; for a GPU its name
and LLVM's bitcode or PTX.  Each is executable code, so only files are read that the user or root
owns and that no other user can write, as ssh does with its keys.  A file that cannot be read,
verified or written is skipped with a `CacheWarning`, and the kernel is compiled for this process
alone.

The compiler's own cache has an index with neither checksum nor owner: an empty or truncated file
breaks every later start, and two processes that save different signatures at once can swap them.

Before a kernel is compiled, it is looked for among those that came with the package
(`springback.kernels.packaged.manifest`), which are only read, and verified alike.

A kernel that is not there is compiled by one process; others that need it wait for its file.  The
lock is the system's, so it ends with its holder, however that ends.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import pickle
import stat
import time
import warnings
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from filelock import FileLock, Timeout
from numba.core import compiler, serialize

from springback.errors import CacheWarning
from springback.files import write_atomically
from springback.kernels.packaged.manifest import fitting_kernels

#: Reader and writer of compiled code.
_rebuild: Any = compiler.CompileResult._rebuild
_dumps: Any = serialize.dumps
#: Length of SHA-256 [bytes].
_DIGEST = 32
#: Longest wait for another process to compile a kernel [s] (chosen: far beyond the longest).
_PATIENCE = 600.0
#: Interval between two looks for its end [s] (chosen).
_LOOK_AGAIN = 0.05
#: Temporary files older than this were left by killed processes [s] (chosen).
_STALE = 3600.0
#: Warnings already issued in this process.
_said: set[str] = set()


class KernelCache:
    """Cached signatures of one entry point; the interface is that of numba's own caches."""

    def __init__(self, function: Any, folder: Path, source: str = "") -> None:
        """Cache for an entry point; the folder is created on the first write.

        Args:
            function: The undecorated entry point.
            folder: A separate one for every state of the source.
            source: Digest of the source, to look among packaged kernels, too; empty: not there.
        """
        self._folder, self._source = folder, source
        self._code = hashlib.sha256(function.__code__.co_code).hexdigest()
        line = function.__code__.co_firstlineno
        self._name = f"{function.__module__}.{function.__qualname__}-{line}"
        self._locks: list[FileLock | None] = []  # of kernels that are being compiled, nested

    @property
    def cache_path(self) -> str:
        """Path of the folder."""
        return str(self._folder)

    def enable(self) -> None:
        """Do nothing: the cache is always on."""

    def disable(self) -> None:
        """Do nothing: the cache is always on."""

    def flush(self) -> None:
        """Do nothing: the folder's name changes with the source."""

    def load_overload(self, signature: Any, context: Any) -> Any:
        """The kernel for a signature, or None if there is no trusted file of it.

        It is then to be compiled by this process, which holds its lock until `end_compilation`.
        """
        context.refresh()
        key = self._key(signature, context.codegen())
        found = self._load(key, context)
        if found is None:
            found = self._load_packaged(signature, context)
        if found is not None:
            return found
        self._locks.append(_locked(self._lock_path(key)))
        found = self._load(key, context)  # another process may have compiled it meanwhile
        if found is not None:
            self.end_compilation()
        return found

    def holds(self, signature: Any, codegen: Any) -> bool:
        """True if there is a file for a signature, or for one whose types have the same names."""
        packaged = self._packaged(signature, codegen)
        own = self._candidates(self._key(signature, codegen))
        known = [own] if packaged is None else [own, self._candidates(*packaged)]
        return any(next(paths).exists() for paths in known)

    def _packaged(self, signature: Any, codegen: Any) -> tuple[tuple[Any, ...], Path] | None:
        """Key and folder of the kernel among those that came with the package, and fit."""
        if not self._source:
            return None
        fitting = fitting_kernels(self._source, codegen.magic_tuple())
        if fitting is None:
            return None
        return (self._name, signature, fitting.target, self._code), fitting.folder

    def _load_packaged(self, signature: Any, context: Any) -> Any:
        packaged = self._packaged(signature, context.codegen())
        return None if packaged is None else self._load(packaged[0], context, packaged[1])

    def _load(self, key: tuple[Any, ...], context: Any, packaged: Path | None = None) -> Any:
        for path in self._candidates(key, packaged):
            try:
                data = _verified_content(path, packaged is not None)
                if data is None:
                    return None
                known, payload = pickle.loads(zlib.decompress(data) if packaged else data)
                if known != key:
                    continue
                return _rebuild(context, *payload)
            except Exception as error:  # any error that a truncated or foreign file causes
                _warn_ignored(path, error)
                return None
        return None

    def save_overload(self, signature: Any, result: Any) -> None:
        """Save a kernel atomically, and unlock it."""
        try:
            self._save(signature, result)
        finally:
            self.end_compilation()

    def _save(self, signature: Any, result: Any) -> None:
        if any(not lifted.can_cache for lifted in result.lifted):
            return
        if result.library.has_dynamic_globals:
            return
        key = self._key(signature, result.codegen)
        try:
            data = _dumps((key, _without_annotation(result._reduce())))
            _write(self._free(key), data)
        except Exception as error:
            _warn_not_cached(self._folder, error)

    def end_compilation(self) -> None:
        """Unlock the kernel that was compiled last, or that could not be compiled."""
        lock = self._locks.pop()
        if lock is not None:
            lock.release()

    def _lock_path(self, key: tuple[Any, ...]) -> Path:
        return self._folder / f".{_stem(key)}.lock"

    def _key(self, signature: Any, codegen: Any) -> tuple[Any, ...]:
        return self._name, signature, codegen.magic_tuple(), self._code

    def _candidates(self, key: tuple[Any, ...], folder: Path | None = None) -> Iterator[Path]:
        """Files that may hold a key: types of equal names share a stem."""
        return ((folder or self._folder) / f"{_stem(key)}-{k}.kernel" for k in range(100))

    def _free(self, key: tuple[Any, ...]) -> Path:
        """Path to write a key to: its own file, or in place of one that cannot be used."""
        path = Path()
        for path in self._candidates(key):
            try:
                data = _verified_content(path)
                if data is None or pickle.loads(data)[0] == key:
                    return path
            except Exception:
                return path
        return path


def pack_kernel(path: Path, folder: Path) -> None:
    """Write a kernel's file into a folder of packaged kernels, where they are compressed.

    Raises:
        OSError: If it cannot be read or written.
        ValueError: If it is damaged.
    """
    data = _verified_content(path)
    if data is None:
        raise FileNotFoundError(f"{path}: there is no such file")
    _write(folder / path.name, zlib.compress(data, 9))


def _without_annotation(parts: tuple[Any, ...]) -> tuple[Any, ...]:
    """A compiled kernel without its source text and types in words, which name its file."""
    place = 6  # as `_rebuild` takes them
    return (*parts[:place], "", *parts[place + 1 :])


def _stem(key: tuple[Any, ...]) -> str:
    return hashlib.sha256(repr(key).encode()).hexdigest()[:32]


def _locked(path: Path) -> FileLock | None:
    """Lock of a kernel, once no other process holds it; None where files cannot be locked.

    Only in a folder of the user's own: where everyone can write, a link could be in its place.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        about = path.parent.stat()
        mine = not hasattr(os, "getuid") or about.st_uid == os.getuid()
        if not mine or about.st_mode & stat.S_IWOTH:
            return None
        lock = FileLock(path)
        lock.acquire(timeout=_PATIENCE, poll_interval=_LOOK_AGAIN)
        return lock
    except (OSError, NotImplementedError, Timeout):
        return None


def load_program(path: Path) -> bytes | None:
    """Content written by `save_program`; None if there is no file, or no trusted one (a warning).

    Args:
        path: Its last part is the key.
    """
    try:
        data = _verified_content(path)
        if data is None:
            return None
        name, _, content = data.partition(b"\n")
        if name != path.name.encode():
            raise ValueError("it holds another key")
        return content
    except (OSError, ValueError) as error:
        _warn_ignored(path, error)
        return None


def save_program(path: Path, content: bytes) -> None:
    """Save a compiled program for other processes; a failure is a warning.

    Args:
        path: Its last part is the key, which identifies the program.
        content: The compiled program.
    """
    try:
        _write(path, path.name.encode() + b"\n" + content)
    except OSError as error:
        _warn_not_cached(path.parent, error)


def _verified_content(path: Path, packaged: bool = False) -> bytes | None:
    """Content of a file after its digest; None if there is no such file.

    Args:
        path: The file.
        packaged: True if it came with the package: who can write this module may write it, too, for
            he can run anything anyway, and links of package managers are followed.

    Raises:
        OSError: If it cannot be read, or another user could have written it.
        ValueError: If it is damaged.
    """
    try:
        flags = 0 if packaged else getattr(os, "O_NOFOLLOW", 0)
        handle = os.open(path, os.O_RDONLY | flags)
    except (FileNotFoundError, NotADirectoryError):
        return None
    with os.fdopen(handle, "rb") as file:
        about = os.fstat(handle)
        if not stat.S_ISREG(about.st_mode):
            raise ValueError("it is not a regular file")
        if hasattr(os, "getuid"):
            owners, writable = {os.getuid(), 0}, stat.S_IWGRP | stat.S_IWOTH
            if packaged:
                module = os.stat(__file__)
                owners.add(module.st_uid)
                writable &= ~(module.st_mode if module.st_gid == about.st_gid else 0)
            if about.st_uid not in owners:
                raise PermissionError(f"it belongs to user {about.st_uid}")
            if about.st_mode & writable:
                raise PermissionError("other users can write to it")
        data = file.read()
    if hashlib.sha256(data[_DIGEST:]).digest() != data[:_DIGEST]:
        raise ValueError("it is damaged")
    return data[_DIGEST:]


def _write(path: Path, data: bytes) -> None:
    """Write data with its digest, atomically."""
    path.parent.mkdir(parents=True, exist_ok=True)
    _remove_stale(path.parent)
    write_atomically(path, hashlib.sha256(data).digest() + data, mode=0o644)


def _remove_stale(folder: Path) -> None:
    """Remove temporary files of processes that were killed."""
    for draft in folder.glob(".*.draft"):
        with contextlib.suppress(OSError):
            if time.time() - draft.stat().st_mtime > _STALE:
                draft.unlink()


def _reason(error: BaseException) -> str:
    text = getattr(error, "strerror", None) or " ".join(str(error).split())
    return text[:200] or type(error).__name__


def _warn_ignored(path: Path, error: BaseException) -> None:
    _say(f"{path}: cached kernel ignored ({_reason(error)}); recompiling it")


def _warn_not_cached(folder: Path, error: BaseException) -> None:
    _say(
        f"{folder}: compiled kernels cannot be cached ({_reason(error)}); every start recompiles "
        "them. SPRINGBACK_CACHE_DIR names another folder"
    )


def _say(text: str) -> None:
    """Warn once per process."""
    if text not in _said:
        _said.add(text)
        warnings.warn(text, CacheWarning, stacklevel=2)

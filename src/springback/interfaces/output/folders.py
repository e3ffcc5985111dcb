"""Output folders: written completely or not at all, never over results without ``force``."""

from __future__ import annotations

import contextlib
import errno
import itertools
import os
import re
import secrets
import shutil
import sys
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

from springback.errors import InputError
from springback.interfaces.output import interrupts

#: Suffix of folders that are still being written.
DRAFT = ".springback-draft"
#: An unlocked draft older than this is that of a killed process [s] (chosen).
YOUNG = 10.0
#: File without which a folder is not a result.
SUMMARY = "summary.json"
#: Index of an entry, and characters that file names here do not have.
_INDEX, _UNUSUAL = re.compile(r"\[(\w*)\]"), re.compile(r"[^A-Za-z0-9._-]+")


def file_stem(*names: str, taken: set[str]) -> str:
    """Name for files of what has some names, of letters, digits, points and dashes only.

    An entry of a list, ``arms[0]``, goes by its number, ``arms.0``.

    Args:
        names: Such as paths of fields.
        taken: Stems of other files, in small letters; the new one is added.
    """
    plain = _UNUSUAL.sub("_", _INDEX.sub(r".\1", "-".join(names)))
    numbered = (plain if k < 2 else f"{plain}-{k}" for k in itertools.count(1))
    stem = next(one for one in numbered if one.lower() not in taken)
    taken.add(stem.lower())
    return stem


def _existing_ancestor(folder: Path) -> Path:
    return next(parent for parent in (folder, *folder.parents) if parent.exists())


@contextmanager
def output_folder(
    folder: Path, *, force: bool = False, replaces: Iterable[str] = ()
) -> Iterator[Path]:
    """Draft folder to write into, which becomes ``folder`` when the block ends without an error.

    The folder is replaced completely or not at all: if the block fails, or the process is killed,
    it is unchanged.  With ``force`` files of earlier results are replaced, and all others stay.

    Args:
        folder: Folder to be written.
        force: Replace results in it.
        replaces: Names of files to remove with the results they belong to.

    Raises:
        InputError: If the folder cannot be written, is a file, or is not empty without ``force``.
    """
    folder = folder.absolute()
    try:
        folder = folder.resolve() if folder.is_symlink() else folder
        if folder.exists() and not folder.is_dir():
            raise InputError(f"--out {folder}: is a file, not a folder")
        if folder.exists() and any(folder.iterdir()) and not force:
            raise InputError(
                f"--out {folder}: is not empty; give another folder, or --force to replace results"
            )
        anchor = _existing_ancestor(folder.parent)
        if folder.exists() and not os.access(folder, os.W_OK):
            raise PermissionError(13, "Permission denied")
        remove_abandoned(anchor, folder.name)
    except OSError as error:
        raise InputError(f"--out {folder}: cannot be written ({error.strerror})") from None
    draft = _hidden_path(anchor, folder.name)
    try:  # from here on the draft is removed whatever happens
        try:
            draft.mkdir(0o700)
        except OSError as error:
            raise InputError(f"--out {folder}: cannot be written ({error.strerror})") from None
        with _locked_folder(draft):
            yield draft
            _replace(draft, folder, set(replaces))
            interrupts.say(f"interrupted; {folder} had already been written")
    except OSError as error:
        if error.errno not in FULL:
            raise
        raise InputError(f"--out {folder}: cannot be written ({error.strerror})") from None
    finally:
        _remove(draft)


def _hidden_path(anchor: Path, name: str) -> Path:
    """New hidden path beside a folder, by a pattern known to `remove_abandoned`."""
    return anchor / f".{name}-{secrets.token_hex(4)}{DRAFT}"


#: Errors of a full disk.
FULL = {errno.ENOSPC, errno.EDQUOT, errno.EIO, errno.EROFS, errno.EFBIG}


def _remove(draft: Path) -> None:
    try:
        shutil.rmtree(draft, ignore_errors=True)
    except KeyboardInterrupt:  # a second time, completely
        shutil.rmtree(draft, ignore_errors=True)
        raise


# -- drafts of processes that were killed ---------------------------------------------------------


@contextmanager
def _locked_folder(folder: Path) -> Iterator[None]:
    """Lock a folder; the system unlocks it when this process ends, however it ends."""
    if sys.platform == "win32":
        yield
        return
    import fcntl

    handle = os.open(folder, os.O_RDONLY)
    try:
        with contextlib.suppress(OSError):  # a file system without locks
            fcntl.flock(handle, fcntl.LOCK_SH | fcntl.LOCK_NB)
        yield
    finally:
        os.close(handle)


def remove_abandoned(anchor: Path, name: str) -> None:
    """Remove drafts of a folder left by killed processes.

    Args:
        anchor: Folder that contains them.
        name: Name of the folder that they would have become.
    """
    if sys.platform == "win32":
        return
    import fcntl

    draft = re.compile(rf"\.{re.escape(name)}-[a-z0-9_]{{8}}{re.escape(DRAFT)}")
    for path in [path for path in anchor.iterdir() if draft.fullmatch(path.name)]:
        with contextlib.suppress(OSError):
            if path.is_symlink() or time.time() - path.stat().st_ctime < YOUNG:
                continue
            handle = os.open(path, os.O_RDONLY)
            try:
                fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
                shutil.rmtree(path, ignore_errors=True)
            finally:
                os.close(handle)


# -- one folder in place of another ---------------------------------------------------------------


def _replace(draft: Path, folder: Path, replaces: set[str]) -> None:
    """Move a draft into the place of a folder, atomically where the system can."""
    mask = os.umask(0)
    os.umask(mask)
    draft.chmod(0o777 & ~mask)
    if not folder.exists():
        folder.parent.mkdir(parents=True, exist_ok=True)
        os.rename(draft, folder)
        return
    elsewhere = folder.stat().st_dev != draft.stat().st_dev
    if elsewhere or Path.cwd().is_relative_to(folder):  # a mount point, or the working directory
        _move_into(draft, folder, replaces)
        return
    _keep_others(folder, draft, replaces)
    if _exchange(draft, folder):
        return
    old = _hidden_path(draft.parent, folder.name)
    try:
        os.rename(folder, old)
        os.rename(draft, folder)
    except BaseException as error:
        if old.exists() and not folder.exists():
            os.rename(old, folder)
        if not isinstance(error, OSError):
            raise
        _move_into(draft, folder, replaces)  # a process uses it in a way that locks its name
    _remove(old)


def _keep_others(folder: Path, draft: Path, replaces: set[str]) -> None:
    """Add the other files of a folder to its draft, as hard links where the disk supports them."""
    for path in folder.iterdir():
        target = draft / path.name
        if path.name in replaces or (target.exists() and not target.is_dir()):
            continue
        if path.is_dir() and not path.is_symlink():
            target.mkdir(exist_ok=True)
            _keep_others(path, target, set())
            shutil.copystat(path, target)
        else:
            try:
                os.link(path, target, follow_symlinks=False)
            except OSError:
                shutil.copy2(path, target, follow_symlinks=False)


def _exchange(one: Path, other: Path) -> bool:
    """Exchange two folders atomically; False where the system cannot."""
    import ctypes

    at_working_directory, exchange = -100, 2
    try:
        rename = ctypes.CDLL(None, use_errno=True).renameat2
    except (AttributeError, OSError, TypeError):
        return False
    done = rename(
        at_working_directory, os.fsencode(one), at_working_directory, os.fsencode(other), exchange
    )
    return bool(done == 0)


def _move_into(draft: Path, folder: Path, replaces: set[str]) -> None:
    """Replace files one by one; the summary, without which a folder is no result, goes first."""
    for name in [SUMMARY, *sorted(replaces)]:
        with contextlib.suppress(FileNotFoundError, IsADirectoryError):
            (folder / name).unlink()
    for source in sorted(draft.rglob("*"), key=lambda path: (path.name == SUMMARY, path)):
        target = folder / source.relative_to(draft)
        if source.is_dir() and not source.is_symlink():
            target.mkdir(parents=True, exist_ok=True)
        elif not (os.path.lexists(target) and os.path.samestat(source.lstat(), target.lstat())):
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.move(source, target)

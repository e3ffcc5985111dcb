"""Files that a world names: sought beside it and along a search path, and nowhere else."""

from __future__ import annotations

import os
import stat
from collections.abc import Sequence
from pathlib import Path

from springback.errors import InputError, excerpt, shown_value

#: Largest file that is read [B] (chosen: 10 000 boxes in SDF take 4 to 10 MB).
MOST_BYTES = 64_000_000
#: Ways in which files name others in a package or library of models.
SCHEMES = ("model", "package", "file")


def file_bytes(path: Path) -> bytes:
    """Content of a file.

    Raises:
        InputError: If it cannot be read, is not a regular file, or is too large.
    """
    try:
        about = path.stat()
        if not stat.S_ISREG(about.st_mode):
            raise InputError(f"{path}: cannot be read (is not a regular file)")
        if about.st_size > MOST_BYTES:
            size = f"{about.st_size / 1e6:.3g} MB"
            raise InputError(
                f"{path}: is too large, {size}; a file of at most {MOST_BYTES / 1e6:g} MB is read"
            )
        return path.read_bytes()
    except InputError:  # a ValueError, too
        raise
    except OSError as error:
        raise InputError(f"{path}: cannot be read ({error.strerror})") from None
    except ValueError as error:  # an impossible file name
        raise InputError(f"{shown_value(str(path))}: cannot be read ({error})") from None


def found_file(word: str, beside: Path, search: Sequence[Path]) -> Path | str:
    """The file or folder that a file names, or in words why there is none.

    Args:
        word: ``model://NAME/FILE``, ``package://NAME/FILE``, ``file://PATH`` or a path.
        beside: Folder of the file that names it.
        search: Further folders: the folder of the world, and those of the user.
    """
    scheme, sign, rest = word.partition("://")
    shown, folders = excerpt(word, 80), list(dict.fromkeys((beside, *search)))
    if not sign:
        scheme, rest = "", word
    elif scheme not in SCHEMES:
        return f"{shown} is not a local file; download it, and name its folder in search"
    rest = rest.replace("\\", "/")
    if not rest or "\x00" in rest or len(rest) > 1000:
        return f"{shown} is no name of a file"
    tried = [Path(rest)] if scheme == "file" and rest.startswith("/") else []
    tried += [folder / rest.lstrip("/") for folder in folders]
    if scheme == "package" or scheme == "model":  # its own folder may be that package
        head, _, tail = rest.partition("/")
        tried += [folder / tail for folder in _with_parents(folders) if folder.name == head]
        tried += [folder / rest for folder in _with_parents(folders)]
    outside = False
    for path in tried:
        try:
            real = Path(os.path.realpath(path))
            there = real.exists()
        except (OSError, ValueError):
            continue
        if not there:
            continue
        if any(real.is_relative_to(os.path.realpath(folder)) for folder in folders):
            return real
        outside = True
    if outside:
        return f"{shown} is outside the folder of its file; name its folder in search"
    looked = ", ".join(str(folder) for folder in folders)
    return f"there is no {shown} in {excerpt(looked, 300)}"


def _with_parents(folders: Sequence[Path]) -> list[Path]:
    """Folders and those that they are in, nearest first, some levels up."""
    found: list[Path] = []
    for folder in folders:
        found += [folder, *list(folder.parents)[:3]]
    return list(dict.fromkeys(found))

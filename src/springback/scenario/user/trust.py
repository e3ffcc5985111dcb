"""Folders whose code may run because a scenario names it: the user says so once for each.

A scenario, plan or campaign folder may come from a stranger, with Python files beside it.  A pilot
that the user names on the command line, or in a program, needs no such consent.
"""

from __future__ import annotations

import json
import os
import shlex
import stat
from pathlib import Path

import platformdirs

from springback.errors import InputError
from springback.files import write_atomically

#: Environment variable with further folders, separated as in PATH.
VARIABLE = "SPRINGBACK_TRUST"


def _file() -> Path:
    return Path(platformdirs.user_config_dir("springback")) / "trusted.json"


def trusted_folders() -> list[Path]:
    """Trusted folders, with all below them."""
    given = [Path(word) for word in os.environ.get(VARIABLE, "").split(os.pathsep) if word]
    return [*listed_folders(), *(folder.resolve() for folder in given)]


def listed_folders() -> list[Path]:
    """Folders in the user's list; one that others could have written is ignored."""
    given, path = list[Path](), _file()
    try:
        about = path.stat()
        mine = not hasattr(os, "getuid") or about.st_uid in (os.getuid(), 0)
        if mine and not about.st_mode & (stat.S_IWGRP | stat.S_IWOTH):
            given = list(map(Path, json.loads(path.read_text(encoding="utf-8"))))
    except (OSError, ValueError, TypeError):  # none, or a damaged one
        pass
    return [folder.resolve() for folder in given]


def trust(folder: str | Path, *, ends: bool = False) -> list[Path]:
    """Trust a folder and all below it from now on; returns the user's list.

    Args:
        folder: Folder of code.
        ends: Trust it no longer.

    Raises:
        InputError: If there is no such folder, or the list cannot be written.
    """
    path = Path(folder).resolve()
    if not ends and not path.is_dir():
        raise InputError(f"{folder}: there is no such folder")
    known = [one for one in listed_folders() if one != path]
    kept = known if ends else [*known, path]
    try:
        _file().parent.mkdir(parents=True, exist_ok=True)
        text = json.dumps([str(one) for one in kept], indent=1)
        write_atomically(_file(), text, mode=0o600)
    except OSError as error:
        raise InputError(
            f"{_file()}: cannot be written ({error.strerror}); set {VARIABLE}={path} instead"
        ) from None
    return kept


def check_trusted(word: str, where: str) -> None:
    """Reject code in a folder that is not trusted.

    Args:
        word: Name of the code, ``FILE.py:NAME``.
        where: What names it, for the message, such as ``pilot``.

    Raises:
        InputError: With what to type.
    """
    folder = Path(word.rpartition(":")[0]).resolve().parent
    if not any(folder.is_relative_to(known) for known in trusted_folders()):
        raise InputError(
            f"{where}: {word} is code, and its folder is not trusted; if it is yours, type once: "
            f"springback trust {shlex.quote(str(folder))}"
        )

"""Optional packages: contents of the extras, and the commands that install them."""

from __future__ import annotations

import importlib
import json
import re
import shlex
import sys
from importlib import metadata
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

from springback.errors import InputError

#: Extras for the development of springback, and the one that contains all those for users.
OF_DEVELOPERS = ("bench", "docs", "dev")
EVERYTHING = "all"


def needs(module: str, extra: str) -> Any:
    """Import an optional module.

    Raises:
        InputError: With the command that installs it.
    """
    try:
        return importlib.import_module(module)
    except ImportError:
        raise InputError(
            f"this needs {module}, which is not installed: {install_line(extra)}"
        ) from None


def install_line(extra: str) -> str:
    """Command that adds an extra to this installation.

    springback is not on a package registry, so the command names the checkout that it was installed
    from, as recorded by pip and uv (PEP 610), or the repository.
    """
    name, python = "springback", shlex.quote(sys.executable)
    pip = f"{python} -m pip install" if find_spec("pip") else f"uv pip install --python {python}"
    try:
        noted = metadata.distribution(name).read_text("direct_url.json")
        origin = json.loads(noted) if noted else {}
    except (metadata.PackageNotFoundError, json.JSONDecodeError):
        origin = {}
    url = str(origin.get("url", ""))
    if "vcs_info" in origin:
        kind = origin["vcs_info"].get("vcs", "git")
        return f"{pip} {shlex.quote(f'{name}[{extra}] @ {kind}+{url}')}"
    folder = Path(unquote(urlsplit(url).path)) if url.startswith("file://") else None
    if folder is None or not (folder / "pyproject.toml").is_file():
        return f"{pip} '.[{extra}]' in the checkout of springback"
    edited = "-e " if origin.get("dir_info", {}).get("editable") else ""
    return f"{pip} {edited}{shlex.quote(f'{folder}[{extra}]')}"


def packages() -> dict[str, tuple[str, ...]]:
    """Packages required by the installed springback, by extra; those of the core under ``""``.

    Extras for development and the one that contains all others are left out.
    """
    found: dict[str, list[str]] = {"": []}
    for line in metadata.requires("springback") or ():
        name = re.match(r"[A-Za-z0-9._-]+", line)
        extra = re.search(r"extra\s*==\s*['\"]([\w-]+)['\"]", line)
        if name is not None:
            found.setdefault(extra[1] if extra else "", []).append(name[0])
    left_out = (*OF_DEVELOPERS, EVERYTHING)
    return {extra: tuple(names) for extra, names in found.items() if extra not in left_out}

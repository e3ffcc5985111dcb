"""Forms of obstacles beside a saved flight, which then needs no other file."""

from __future__ import annotations

import zipfile
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

from springback.contact.grids.data_files import MOST_BYTES, file_bytes, place_content
from springback.contact.grids.measured_shapes import FormShape
from springback.contact.unions import ShapeUnion
from springback.errors import InputError

#: Name of the file that holds them, each by its SHA-256.
FORMS = "forms.zip"


def forms_of(world: Any) -> Iterator[FormShape]:
    """Obstacles whose form is in a file, those in unions, too."""
    for entry in world.obstacles:
        for one in entry.shapes if isinstance(entry, ShapeUnion) else (entry,):
            if isinstance(one, FormShape):
                yield one


def write_forms(world: Any, folder: Path) -> list[Path]:
    """Write the files of all forms of a world to a folder, if there are any."""
    found = {one.content: one.file for one in forms_of(world)}
    if not found:
        return []
    path = folder / FORMS
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for content, file in sorted(found.items()):
            archive.writestr(zipfile.ZipInfo(content), file_bytes(file, content))
    return [path]


def place_forms(path: Path) -> None:
    """Let the forms of a saved flight stand in for the files that it was flown with.

    Raises:
        InputError: If they cannot be read.
    """
    try:
        with zipfile.ZipFile(path) as archive:
            sizes = {entry.filename: entry.file_size for entry in archive.infolist()}
    except (zipfile.BadZipFile, OSError) as error:
        raise InputError(f"{path}: cannot be read ({error})") from None
    for content, size in sizes.items():
        if size > MOST_BYTES:
            raise InputError(f"{path}: {content[:12]}: is too large, {size / 1e6:.4g} MB")
        place_content(content, partial(_content, path.resolve(), content))


def _content(path: Path, content: str) -> bytes:
    try:
        with zipfile.ZipFile(path) as archive:
            return archive.read(content)
    except (zipfile.BadZipFile, OSError, KeyError, RuntimeError) as error:
        raise InputError(f"{path}: cannot be read ({error})") from None

"""Files of other programs, each read by the reader of its format."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from springback.errors import InputError, shown_value
from springback.scenario.worlds.blocks import read_blocks
from springback.scenario.worlds.content import Collector, WorldContent
from springback.scenario.worlds.meshes import (
    MESHES,
    RELIEFS,
    read_mesh,
    read_occupancy,
    read_relief,
)
from springback.scenario.worlds.mjcf import MjcfReader
from springback.scenario.worlds.octomap import read_octomap
from springback.scenario.worlds.sdf import SdfReader
from springback.scenario.worlds.urdf import read_urdf
from springback.scenario.worlds.xml_text import XmlNode, xml_root

#: Formats by suffix.
XML = (".sdf", ".world", ".xml", ".mjcf", ".urdf")
SUFFIXES = (*XML, ".json", ".bt", ".ot", *MESHES, *RELIEFS, ".npz")

#: Worlds that are remembered: by what was asked, the state of all files read, and the content.
_LATEST: dict[tuple[object, ...], tuple[tuple[object, ...], WorldContent]] = {}
#: Most of them (chosen).
MOST_LATEST = 16


def world_content(
    path: Path, search: Sequence[Path], kinds: Sequence[str], *, bounds: bool = False
) -> WorldContent:
    """What is in a file; it is read once as long as no file that it names changes.

    Args:
        path: Of the file; its suffix tells the format, in XML its outermost element.
        search: Folders, beside its own, in which what it names is sought.
        kinds: Types of built-in obstacles.
        bounds: True if the bounds of a world of RotorPy are walls.

    Raises:
        InputError: One line, if the file cannot be read or is wrong.
    """
    key = (str(path.absolute()), *map(str, search), *kinds, bounds)
    known = _LATEST.get(key)
    if known is not None and known[0] == states_of(known[1].files):
        return known[1]
    found = _content(path, search, kinds, bounds)
    if not found.missing:  # what is missing may be there the next time
        _LATEST.pop(key, None)
        _LATEST[key] = states_of(found.files), found
        if len(_LATEST) > MOST_LATEST:
            del _LATEST[next(iter(_LATEST))]
    return found


def states_of(files: Sequence[Path]) -> tuple[object, ...]:
    """Size, time and number of files, which tell whether they changed.

    Args:
        files: Any; those that are not there have none.
    """
    found: list[object] = []
    for path in files:
        try:
            about = os.stat(path)
            found.append((about.st_size, about.st_mtime_ns, about.st_ino))
        except OSError:
            found.append(None)
    return tuple(found)


def _content(
    path: Path, search: Sequence[Path], kinds: Sequence[str], bounds: bool
) -> WorldContent:
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise InputError(
            f"{shown_value(str(path))}: is not in a format that is read: {', '.join(SUFFIXES)}"
        )
    found = Collector(path, search, kinds)
    if bounds and suffix != ".json":
        raise InputError(f"{path}: bounds: only worlds of RotorPy (.json) have bounds")
    try:
        if suffix in XML:
            _read_xml(found, xml_root(path))
        elif suffix == ".json":
            read_blocks(found, bounds)
        elif suffix in (".bt", ".ot"):
            read_octomap(found)
        else:
            _check_there(path)
            read = read_mesh if suffix in MESHES else read_relief
            (read_occupancy if suffix == ".npz" else read)(found)
    except RecursionError:
        raise InputError(f"{path}: has frames or models that depend on too many others") from None
    return found.content()


def _read_xml(found: Collector, root: XmlNode) -> None:
    """Read a file in XML, whatever its suffix."""
    if root.tag in ("sdf", "gazebo"):
        SdfReader(found).read(root)
    elif root.tag == "mujoco":
        MjcfReader(found).read(root)
    elif root.tag == "robot":
        read_urdf(found, root)
    else:
        raise root.problem("is neither SDF (sdf), MJCF (mujoco) nor URDF (robot)")


def _check_there(path: Path) -> None:
    """Reject a file that is not there; obstacles read it when they are made."""
    try:
        there = path.is_file()
    except (OSError, ValueError):
        there = False
    if not there:
        raise InputError(f"{shown_value(str(path))}: there is no such file")

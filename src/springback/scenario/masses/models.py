"""The main body of a raw vehicle, its mass and inertia read from a model file."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from pydantic_core import PydanticCustomError

from springback.errors import InputError, shown_value, within
from springback.scenario.masses.formats import links_of
from springback.scenario.masses.links import chosen_links
from springback.scenario.worlds.files import states_of
from springback.scenario.worlds.xml_text import xml_root
from springback.vehicle.mass.parts import MassOfParts, properties_of
from springback.vehicle.parameters import check_matrix

#: Models that are remembered: by path and links, the state of all files read, and the mass.
_LATEST: dict[tuple[str, ...], tuple[tuple[object, ...], tuple[Path, ...], MassOfParts]] = {}
#: Most of them (chosen).
MOST_LATEST = 16


def mass_of_model(path: Path, links: Sequence[str] = ()) -> MassOfParts:
    """Mass, centre of mass and inertia of a robot, from SDF, URDF or MJCF.

    Joints are at zero.  The centre is from the origin of the first of the links, and all is in the
    axes of that link: x forward, y left, z up by the conventions of all three formats.

    Args:
        path: Of the file; its outermost element tells the format.
        links: Names of links (bodies of MJCF), or patterns of them, whose masses are added up; none
            for the first link and all that are fixed to it.

    Raises:
        InputError: One line with file, line, element, value and unit, if something is missing or
            cannot be.
    """
    key = (str(path.absolute()), *links)
    known = _LATEST.get(key)
    if known is not None and known[0] == states_of(known[1]):
        return known[2]
    root = xml_root(path)
    try:
        every, read = links_of(path, root)
    except RecursionError:
        raise InputError(f"{path}: has frames or models that depend on too many others") from None
    chosen = chosen_links(every, links, root)
    if not chosen:
        raise InputError(f"{path}: has no link")
    axes = chosen[0].pose.inverse()
    parts = tuple(link.mass().placed_at(axes @ link.pose) for link in chosen)
    names = ", ".join(link.name for link in chosen[:5]) + (", ..." if len(chosen) > 5 else "")
    if not sum(part.mass for part in parts) > 0.0:
        raise InputError(f"{path}: mass of {names} is 0 kg; must be more than 0 kg")
    found, files = properties_of(parts), tuple(dict.fromkeys(read.files))
    try:
        check_matrix(found.inertia)
    except PydanticCustomError as error:
        raise InputError(f"{path}: inertia of {names} {error.message()}") from None
    _LATEST.pop(key, None)
    _LATEST[key] = states_of(files), files, found
    if len(_LATEST) > MOST_LATEST:
        del _LATEST[next(iter(_LATEST))]
    return found


def with_mass_of_model(given: Any) -> Any:
    """A raw main body, its mass and inertia those of the model that it names, if it names one.

    That of a stored scenario holds what was read, and the file is not read again; unless it or its
    links are changed.

    Raises:
        InputError: If the file cannot be read or is wrong, or for a mass beside it.
    """
    if not isinstance(given, Mapping) or not given.get("model"):
        return given
    word, links = given["model"], given.get("links") or ()
    names = [links] if isinstance(links, str) else links
    if not isinstance(names, list | tuple) or not all(isinstance(name, str) for name in names):
        raise InputError(f"must be names of links (got {shown_value(links)})", path=("links",))
    before = given.get("measured")
    if isinstance(before, Mapping):
        if before.get("model") == word and list(before.get("links", ())) == list(names):
            return given
    elif given.get("parts"):
        return given  # its problem is that of the field
    else:
        for name in ("mass", "inertia"):
            if given.get(name) is not None:
                raise InputError("follows from model; leave it out", path=(name,))
    with within("model"):
        if not isinstance(word, str):
            raise InputError(f"must be the path of a file (got {shown_value(word)})")
        known = mass_of_model(Path(word), tuple(names))
    path = os.path.abspath(word)
    measured = {"model": path, "links": list(names), "centre": known.centre}
    found = {"model": path, "links": list(names), "mass": known.mass, "inertia": known.inertia}
    return {**given, **found, "measured": measured}

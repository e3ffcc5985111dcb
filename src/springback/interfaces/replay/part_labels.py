"""What the parts of imported worlds are called in a legend."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from springback.scenario.worlds.imported import Imported, NamedObstacle

#: Longest name in a legend, without its kind (chosen: five of them are as wide as a view).
LONGEST = 24
#: Kinds of one part that are named; of more, none is.
MOST_KINDS = 2


def part_names(entries: Sequence[Any]) -> dict[int, str]:
    """Names of the elements of imported worlds for a legend, by the identity of their obstacles.

    An element goes by what it is a part of, its model or body, and by the kinds of that: the box
    ``crate/link/collision`` is ``crate (box)``.  The name of the world is before it, if it has one.
    Where all elements of a file are parts of one thing, they go by the next names in it.

    Args:
        entries: Entries of a scenario's world.
    """
    found = dict[int, str]()
    for entry in entries:
        if not isinstance(entry, Imported):
            continue
        groups = dict[str, list[NamedObstacle]]()
        for part in entry.parts:
            groups.setdefault(_stem(part.name, _shared(entry.parts)), []).append(part)
        for stem, parts in groups.items():
            kinds = list(dict.fromkeys(part.obstacle.type for part in parts))
            kind = f" ({', '.join(kinds)})" if len(kinds) <= MOST_KINDS else ""
            word = short_name(f"{entry.name}/{stem}" if entry.name else stem)
            found |= {id(part.obstacle): f"{word}{kind}" for part in parts}
    return found


def short_name(name: str) -> str:
    """A name with its middle left out if it is longer than `LONGEST`."""
    if len(name) <= LONGEST:
        return name
    half = (LONGEST - 1) // 2
    return f"{name[: LONGEST - 1 - half]}…{name[-half:]}"


def _shared(parts: Sequence[NamedObstacle]) -> int:
    """Number of outer names that all elements have in common; not counting the name of one."""
    paths = [part.name.split("/") for part in parts]
    if len(paths) < 2:
        return 0
    count = 0
    while all(
        len(path) > count + 1 and path[: count + 1] == paths[0][: count + 1] for path in paths
    ):
        count += 1
    return count


def _stem(name: str, shared: int) -> str:
    return "/".join(name.split("/")[: shared + 1])

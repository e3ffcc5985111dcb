"""Labels of flights shown side by side, and the settings in which they differ."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from springback.interfaces.output.robots import robot_label
from springback.interfaces.replay.scene import Scene, scene_beside, scene_of
from springback.results.flight import Flight
from springback.scenario.tables import SecondVehicle

#: Most differing settings that are named (chosen); further ones are counted.
MOST_NAMED = 4
#: Name of a second vehicle that was given none.
UNNAMED = str(SecondVehicle.model_fields["name"].default)


def labels_of(flights: Sequence[Flight], origins: Sequence[str | Path] = ()) -> list[str]:
    """Labels that distinguish flights: robots, else scenarios, else folders, else numbers.

    Two vehicles in one world go by the names that their scenario gives them, if it does.  Folders
    of the same name are given with as many folders above them as distinguish them.

    Args:
        flights: Flights shown side by side.
        origins: Folder or file that each was read from, if any.
    """
    robots = [_name_in_pair(f) or robot_label(f.scenario.vehicle.name) for f in flights]
    scenarios = [flight.scenario.name for flight in flights]
    for names in (robots, scenarios):
        if len(set(names)) == len(names):
            return names
    if len(origins) == len(flights):
        paths = [Path(origin).absolute().parts for origin in origins]
        for depth in range(1, max(map(len, paths)) + 1):
            read = ["/".join(parts[-depth:]) for parts in paths]
            if len(set(read)) == len(read):
                return [f"{robot} ({name})" for robot, name in zip(robots, read, strict=True)]
    return [f"{name} {k}" for k, name in enumerate(robots, start=1)]


def _name_in_pair(flight: Flight) -> str:
    """Name of one of two vehicles where their scenario names the second; empty otherwise."""
    scenario = flight.scenario
    if flight.is_second:
        return "" if scenario.name == UNNAMED else scenario.name
    named = scenario.second is not None and scenario.second.name != UNNAMED
    return scenario.name if named and "name" in scenario.model_fields_set else ""


def scenes_of(flights: Sequence[Flight], origins: Sequence[str | Path] = ()) -> list[Scene]:
    """Scenes of flights to show side by side; each has a remark on settings unlike the first's.

    A second vehicle follows the first one of its world.

    Args:
        flights: One or several.
        origins: Folder or file that each was read from, if any.
    """
    places: Sequence[str | Path] = origins or [""] * len(flights)
    named = [
        one
        for flight, place in zip(flights, places, strict=True)
        for one in [(flight, place), (flight.second, f"{place}, second")][: vehicles_of(flight)]
    ]
    labels = iter(
        labels_of(
            [flight for flight, _ in named if flight is not None],
            [place for _, place in named] if origins else (),
        )
    )
    scenes = list[Scene]()
    for k, flight in enumerate(flights):
        found = [replace(scene_of(flight, label=next(labels)), world=k)]
        if k and (said := difference(flights[0], flight)):
            note = f"differs from {scenes[0].label} in {said}"
            found[0] = replace(found[0], notes=(*found[0].notes, note))
        if flight.second is not None:
            found.append(replace(scene_beside(flight, label=next(labels)), world=k))
        scenes += in_one_world(found)
    return scenes


def vehicles_of(flight: Flight) -> int:
    """Number of vehicles of a flight."""
    return 1 if flight.second is None else 2


def in_one_world(scenes: Sequence[Scene]) -> list[Scene]:
    """Scenes of one world, whose first touch is that of any of them."""
    touches = [scene.impacts[0][0] for scene in scenes if scene.impacts]
    return [replace(scene, first_touch=min(touches, default=None)) for scene in scenes]


def difference(first: Flight, second: Flight) -> str:
    """Settings of the second flight that differ from the first, in SI; empty if there are none.

    Names of flights and vehicles are ignored.
    """
    before, after = (
        dict(
            _leaves(f.scenario.model_dump(mode="json", exclude={"name": True, "vehicle": {"name"}}))
        )
        for f in (first, second)
    )
    keys = [key for key in {**before, **after} if before.get(key) != after.get(key)]
    named = [
        f"{key} ({_value(after.get(key))} instead of {_value(before.get(key))})"
        for key in keys[:MOST_NAMED]
    ]
    rest = len(keys) - len(named)
    if rest:
        named.append(f"{rest} more setting{'s' if rest > 1 else ''}")
    return ", ".join(named[:-1]) + (" and " if len(named) > 1 else "") + "".join(named[-1:])


def _leaves(value: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    """Dotted paths and values of nested plain data; lists of numbers are single values."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from _leaves(inner, f"{path}.{key}" if path else str(key))
    elif isinstance(value, list) and any(isinstance(entry, dict) for entry in value):
        for k, entry in enumerate(value):
            yield from _leaves(entry, f"{path}[{k}]")
    else:
        yield path, value


def _value(value: Any) -> str:
    if isinstance(value, bool) or value is None:
        return {True: "true", False: "false", None: "nothing"}[value]
    if isinstance(value, float):
        return f"{value:.4g}"
    if isinstance(value, list):
        return f"[{', '.join(_value(entry) for entry in value)}]"
    return str(value)

"""Presets by name, and tables merged over them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from springback.contact.library import SURFACES
from springback.errors import InputError, shown_value, within
from springback.sensing.library import ESTIMATORS
from springback.settings import nearest_name
from springback.vehicle.library import VEHICLES


def preset(kind: str, name: str, known: Mapping[str, Any]) -> Any:
    """A preset by name.

    Raises:
        InputError: With the nearest known name.
    """
    if name in known:
        return known[name]
    near = nearest_name(name, known)
    hint = f"did you mean {near}? " if near else ""
    raise InputError(f"unknown {kind} preset {shown_value(name)}; {hint}known: {', '.join(known)}")


def merge(base: Mapping[str, Any], over: Mapping[str, Any]) -> dict[str, Any]:
    """``base`` with the values of ``over``, table by table."""
    result = dict(base)
    for key, value in over.items():
        inner = result.get(key)
        if isinstance(value, Mapping) and isinstance(inner, Mapping):
            result[key] = merge(inner, value)
        else:
            result[key] = value
    return result


def vehicle_table(given: Any) -> Any:
    """A raw vehicle, its preset replaced by its values."""
    table = {"preset": given} if isinstance(given, str) else given
    if not isinstance(table, Mapping) or "preset" not in table:
        return given
    known = {name: entry.vehicle for name, entry in VEHICLES.items()}
    with within(*_key_of_preset(given)):
        base = preset("vehicle", str(table["preset"]), known)
    own = {key: value for key, value in table.items() if key != "preset"}
    return merge(base.model_dump(), own)


def _key_of_preset(given: Any) -> tuple[str, ...]:
    """Key of the name of a preset: in a table, or in the table's place."""
    return () if isinstance(given, str) else ("preset",)


def surface_table(given: Any) -> Any:
    """A raw surface, its preset replaced by its values."""
    table = {"preset": given} if isinstance(given, str) else given
    if not isinstance(table, Mapping) or "preset" not in table:
        return given
    with within(*_key_of_preset(given)):
        base = preset("surface", str(table["preset"]), SURFACES).model_dump(exclude_none=True)
    own = {key: value for key, value in table.items() if key != "preset"}
    if "dissipation" in own or own.get("law", "hunt-crossley") not in ("hunt-crossley", "impulse"):
        base.pop("restitution", None)
        base.pop("restitution_speed", None)
    if "restitution" in own and "restitution_speed" not in own:
        base.pop("restitution_speed", None)
    return merge(base, own)


def estimator_table(given: Any) -> Any:
    """A raw estimator, its preset replaced by its values."""
    table = {"preset": given} if isinstance(given, str) else given
    if not isinstance(table, Mapping) or "preset" not in table:
        return given
    base = preset("estimator", str(table["preset"]), ESTIMATORS).model_dump(exclude_unset=True)
    return merge(base, {key: value for key, value in table.items() if key != "preset"})


def obstacle_table(entry: Any) -> Any:
    """A raw obstacle, the presets of its surfaces replaced by their values."""
    if not isinstance(entry, Mapping):
        return entry
    own = {}
    for key in ("surface", "backing"):
        if key in entry:
            with within(key):
                own[key] = surface_table(entry[key])
    return {**entry, **own}


def expand_presets(given: Mapping[str, Any]) -> dict[str, Any]:
    """A raw scenario, every preset replaced by its values."""
    result = dict(given)
    if "vehicle" in result:
        with within("vehicle"):
            result["vehicle"] = vehicle_table(result["vehicle"])
    if "estimator" in result:
        with within("estimator"):
            result["estimator"] = estimator_table(result["estimator"])
    world = result.get("world")
    if isinstance(world, Mapping) and isinstance(world.get("obstacles"), list | tuple):
        entries = []
        for k, entry in enumerate(world["obstacles"]):
            with within("world", "obstacles", k):
                entries.append(obstacle_table(entry))
        result["world"] = {**world, "obstacles": entries}
    return result

"""Presets by name, vehicle files, and tables merged over them."""

from __future__ import annotations

import csv
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from pydantic_core import PydanticCustomError

from springback.contact.grids.data_files import content_digest
from springback.contact.library import SURFACES
from springback.errors import InputError, shown_value, within
from springback.problems import nearest_name
from springback.quantities import Unit
from springback.scenario.code_files import with_absolute_names
from springback.scenario.masses.models import with_mass_of_model
from springback.scenario.source_text import source_text, toml_tables
from springback.scenario.worlds.imported import read_import
from springback.sensing.library import ESTIMATORS
from springback.vehicle.arms.settings import OF_SLIDES
from springback.vehicle.force_laws import REMEMBERING
from springback.vehicle.library import VEHICLES
from springback.vehicle.materials import MATERIALS

#: A surface of the user's own.
_OWN_SURFACE = '{ preset = "wall", stiffness = 2e6, friction = 0.6 }'
#: Duration of a flight with a run-up that does not say how long it lasts [s]: as in the paper, time
#: for the run-up, the impact and the recovery.
RUN_UP_DURATION = 6.0


def preset(kind: str, name: str, known: Mapping[str, Any]) -> Any:
    """A preset by name.

    Raises:
        InputError: With the nearest known name.
    """
    if name in known:
        return known[name]
    near = nearest_name(name, known)
    hint = f"did you mean {near}? " if near else ""
    own = f"; or write a table, such as {_OWN_SURFACE}" if kind == "surface" else ""
    if kind == "surface" and name in MATERIALS:
        own += f"; {name} is a material, whose numbers `springback show {name}` lists"
    raise InputError(
        f"unknown {kind} preset {shown_value(name)}; {hint}known: {', '.join(known)}{own}"
    )


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


def _preset_of(
    given: Any, kind: str, known: Mapping[str, Any]
) -> tuple[Any, dict[str, Any]] | None:
    """The preset that a raw table names, and the table's other keys; None if it names none."""
    table = {"preset": given} if isinstance(given, str) else given
    if not isinstance(table, Mapping) or "preset" not in table:
        return None
    with within(*(() if isinstance(given, str) else ("preset",))):
        base = preset(kind, str(table["preset"]), known)
    return base, {key: value for key, value in table.items() if key != "preset"}


def is_vehicle_file(word: Any) -> bool:
    """True for the name of a file with a vehicle, in place of that of a preset."""
    return isinstance(word, str) and word.endswith(".toml")


def read_vehicle(path: str | Path, named_by: tuple[Path, ...] = ()) -> dict[str, Any]:
    """Read the raw vehicle of a TOML file: its table ``[vehicle]``, or all of it.

    Args:
        path: Of the file; it may name a preset, or another such file that it changes.
        named_by: Files that name this one, each in the next.

    Raises:
        InputError: If it cannot be read, has no vehicle, or names itself.
    """
    given = toml_tables(source_text(Path(path)), str(path))
    found = given.get("vehicle", given)
    table = {"preset": found} if isinstance(found, str) else found
    if not isinstance(table, Mapping):
        raise InputError(f"{path}: vehicle: must be a table (got {shown_value(found)})")
    word, named = table.get("preset"), {"name": table.get("name", Path(path).stem)}
    table = with_absolute_names({"vehicle": table}, Path(path).parent)["vehicle"]
    if not is_vehicle_file(word):
        return {**vehicle_table(table), **named}
    further, here = Path(path).parent / str(word), (*named_by, Path(path).resolve())
    if further.resolve() in here:
        raise InputError(
            f"{path}: vehicle.preset: must not name a file that names this one, {word}"
        )
    changes = {key: value for key, value in table.items() if key != "preset"}
    return {**_changed_vehicle(read_vehicle(further, here), changes), **named}


def vehicle_table(given: Any) -> Any:
    """A raw vehicle, its preset or files replaced by their values."""
    word = given.get("preset") if isinstance(given, Mapping) else given
    if word is not None and is_vehicle_file(word):
        own = {} if isinstance(given, str) else {k: v for k, v in given.items() if k != "preset"}
        return _changed_vehicle(read_vehicle(word), own)
    found = _preset_of(given, "vehicle", VEHICLES)
    if found is None:
        return _with_model(given)
    base, own = found[0].vehicle.model_dump(), found[1]
    arms = own.get("arms")
    has_joint = isinstance(arms, Mapping) and arms.get("joint") is not None
    if has_joint and base["arms"]["joint"] is None:
        base["arms"] = {k: v for k, v in base["arms"].items() if k not in OF_SLIDES}
    return _changed_vehicle(base, own)


def _changed_vehicle(base: dict[str, Any], own: Mapping[str, Any]) -> Any:
    """A raw vehicle with changes; parts, a model or other links of it replace its main body."""
    body, model = own.get("body"), None
    if isinstance(body, Mapping) and any(body.get(key) for key in ("parts", "model", "links")):
        if isinstance(base.get("body"), Mapping) and "parts" not in body:
            model = base["body"].get("model")
        base = {**base, "body": {"model": model} if model else {}}
    return _with_model(merge(base, own))


def _with_model(table: Any) -> Any:
    """A raw vehicle whose main body has the mass of its model, if it names one."""
    if not isinstance(table, Mapping) or not isinstance(table.get("body"), Mapping):
        return table
    with within("body"):
        return {**table, "body": with_mass_of_model(table["body"])}


def surface_table(given: Any) -> Any:
    """A raw surface, its preset replaced by its values."""
    found = _preset_of(given, "surface", SURFACES)
    if found is None:
        return given
    base, own = found[0].model_dump(exclude_none=True), found[1]
    if "dissipation" in own or own.get("law", "hunt-crossley") not in ("hunt-crossley", "impulse"):
        base.pop("restitution", None)
        base.pop("restitution_speed", None)
    if own.get("law") in REMEMBERING:
        base.pop("dissipation", None)
    if "restitution" in own and "restitution_speed" not in own:
        base.pop("restitution_speed", None)
    return merge(base, own)


def estimator_table(given: Any) -> Any:
    """A raw estimator, its preset replaced by its values."""
    found = _preset_of(given, "estimator", ESTIMATORS)
    return given if found is None else merge(found[0].model_dump(exclude_unset=True), found[1])


def obstacle_table(entry: Any) -> Any:
    """A raw obstacle, the presets of its surfaces replaced by their values."""
    if not isinstance(entry, Mapping):
        return entry
    own: dict[str, Any] = {}
    for key in ("surface", "backing"):
        if key in entry:
            with within(key):
                own[key] = surface_table(entry[key])
    if isinstance(entry.get("shapes"), list | tuple):
        own["shapes"] = []
        for k, shape in enumerate(entry["shapes"]):
            with within("shapes", k):
                own["shapes"].append(obstacle_table(shape))
    if entry.get("type") != "import":
        return {**entry, **own}
    if isinstance(patterns := entry.get("surfaces"), Mapping):
        own["surfaces"] = {}
        for pattern, given in patterns.items():
            with within("surfaces", pattern):
                own["surfaces"][pattern] = surface_table(given)
    return read_import({**entry, **own})


def with_contents(given: Mapping[str, Any]) -> dict[str, Any]:
    """Raw tables of a scenario in which the files of obstacles are named with their content.

    A file that is changed later is then noticed; models of vehicles are replaced by their mass.
    One that cannot be read is left as it is, for the check of the scenario.
    """
    given = _with_mass(given)
    if isinstance(given.get("second"), Mapping):
        given = {**given, "second": _with_mass(given["second"])}
    world = given.get("world")
    if not isinstance(world, Mapping) or not isinstance(world.get("obstacles"), list | tuple):
        return dict(given)
    return {**given, "world": {**world, "obstacles": [*map(_with_content, world["obstacles"])]}}


def _with_mass(tables: Mapping[str, Any]) -> Mapping[str, Any]:
    """Raw tables of a vehicle, with the mass of the model that its main body names."""
    vehicle = tables.get("vehicle")
    if not isinstance(vehicle, Mapping) or "body" not in vehicle:
        return tables
    try:
        body = with_mass_of_model(vehicle["body"])
    except InputError:
        return tables
    return {**tables, "vehicle": {**vehicle, "body": body}}


def _with_content(entry: Any) -> Any:
    if not isinstance(entry, Mapping):
        return entry
    if isinstance(entry.get("shapes"), list | tuple):
        return {**entry, "shapes": [*map(_with_content, entry["shapes"])]}
    if not isinstance(entry.get("file"), str) or "content" in entry:
        return entry
    try:
        return {**entry, "content": content_digest(entry["file"])}
    except PydanticCustomError:
        return entry


def read_thrusts(path: str | Path) -> dict[str, Any]:
    """Raw table of thrusts over time of a CSV file.

    Args:
        path: Of the file.  Its first line names the columns: ``time`` or ``t`` [s], ``thrust1``,
            ``thrust2``, … [N]; others, as of telemetry, are not read.

    Raises:
        InputError: If it cannot be read, has no such columns, or holds something else than numbers.
    """
    try:
        head, *lines = list(csv.reader(source_text(Path(path)).splitlines())) or [[]]
    except csv.Error as error:
        raise InputError(f"{path}: is not CSV: {error}") from None
    names = [name.strip() for name in head]
    wanted = [next((name for name in ("time", "t") if name in names), "time")]
    while (name := f"thrust{len(wanted)}") in names or len(wanted) == 1:
        wanted.append(name)
    for name in wanted:
        if name not in names:
            raise InputError(f"{path}:1: has no column {name}; there are: {', '.join(names)[:200]}")
    places, rows = [names.index(name) for name in wanted], []
    for number, line in enumerate(lines, start=2):
        if not line:
            continue
        try:
            rows.append([float(line[place]) for place in places])
        except (ValueError, IndexError):
            what = f"must have numbers as {', '.join(wanted)} (got {shown_value(','.join(line))})"
            raise InputError(f"{path}:{number}: {what}") from None
    return {"time": [row[0] for row in rows], "values": [row[1:] for row in rows]}


def thrust_of(given: Any) -> Any:
    """A raw thrust, the name of a file replaced by its table."""
    is_file = isinstance(given, str) and given.endswith(".csv")
    return read_thrusts(given) if is_file else given


#: Tables of a scenario that belong to its world and its flight, not to its vehicle.
OF_THE_WORLD = ("world", "clock", "simulation", "second")


def second_tables(given: Any) -> Any:
    """Raw second vehicle, the names of a scenario file and of one of a vehicle replaced by tables.

    Its world, clock, duration and steps are not read: they are those of the other scenario.

    Raises:
        InputError: If the file cannot be read.
    """
    word = given.get("preset") if isinstance(given, Mapping) else given
    if word is None:
        return _with_vehicle(given)
    with within(*(() if isinstance(given, str) else ("preset",))):
        if not is_vehicle_file(word):
            raise InputError(f"must be the path of a scenario file (got {shown_value(word)})")
        found = toml_tables(source_text(Path(word)), str(word))
    own = {} if isinstance(given, str) else {k: v for k, v in given.items() if k != "preset"}
    kept = {key: value for key, value in found.items() if key not in OF_THE_WORLD}
    return _with_vehicle(merge(with_absolute_names(kept, Path(word).parent), own))


def _with_vehicle(tables: Any) -> Any:
    """Raw tables in which the file of a vehicle is replaced by its values."""
    vehicle = tables.get("vehicle") if isinstance(tables, Mapping) else None
    word = vehicle.get("preset") if isinstance(vehicle, Mapping) else vehicle
    return {**tables, "vehicle": vehicle_table(vehicle)} if is_vehicle_file(word) else tables


def _second(given: Any, scenario: Mapping[str, Any]) -> Any:
    """A raw second vehicle, presets replaced by their values; the wind is that of the scenario."""
    tables = second_tables(given)
    if not isinstance(tables, Mapping):
        return tables
    air = {"air": scenario["air"]} if "air" in scenario else {}
    surface = {}
    if tables.get("surface") is not None:
        with within("surface"):
            surface = {"surface": surface_table(tables["surface"])}
    others = {key: value for key, value in tables.items() if key != "surface"}
    return {**air, **_of_a_vehicle(others), **surface}


#: How values of a start are read.
_START: dict[str, Callable[[Any], Any]] = {"position": Unit("m").triple, "yaw": Unit("rad").read}
#: Keys of references, by their types, and of the start, whose value they have by default.
_FROM_START = {"run-up": {"start": "position"}, "hold": {"position": "position", "yaw": "yaw"}}


def _with_its_start(given: Mapping[str, Any]) -> dict[str, Any]:
    """A raw scenario whose reference begins as its start does, unless it says otherwise.

    A run-up begins at ``start.position``; to hold is to stay there, and to keep ``start.yaw``.
    """
    result, reference, start = dict(given), given.get("reference"), given.get("start")
    if not isinstance(reference, Mapping) or not isinstance(start, Mapping):
        return result
    kind, taken = reference.get("type"), dict[str, Any]()
    for key, source in _FROM_START.get(kind, {}).items() if isinstance(kind, str) else ():
        if key in reference or source not in start:
            continue
        try:
            taken[key] = _START[source](start[source])
        except PydanticCustomError:  # reported where it was written
            continue
    return {**result, "reference": {**reference, **taken}}


def _with_its_duration(given: Mapping[str, Any]) -> dict[str, Any]:
    """A raw scenario that flies on for `RUN_UP_DURATION` with a run-up, unless it says how long."""
    reference, simulation = given.get("reference"), given.get("simulation", {})
    if not isinstance(reference, Mapping) or not isinstance(simulation, Mapping):
        return dict(given)
    if reference.get("type") != "run-up" or "duration" in simulation:
        return dict(given)
    return {**given, "simulation": {"duration": RUN_UP_DURATION, **simulation}}


def expand_presets(given: Mapping[str, Any]) -> dict[str, Any]:
    """A raw scenario, presets replaced by their values; its reference begins at its start."""
    result = _with_its_duration(_of_a_vehicle(given))
    if result.get("second") is not None:
        with within("second"):
            result["second"] = _second(result["second"], result)
    world = result.get("world")
    if isinstance(world, Mapping) and isinstance(world.get("obstacles"), list | tuple):
        entries = []
        for k, entry in enumerate(world["obstacles"]):
            with within("world", "obstacles", k):
                entries.append(obstacle_table(entry))
        result["world"] = {**world, "obstacles": entries}
    return result


def _of_a_vehicle(given: Mapping[str, Any]) -> dict[str, Any]:
    """Raw tables of one vehicle, presets replaced by their values."""
    result = _with_its_start(given)
    if "vehicle" in result:
        with within("vehicle"):
            result["vehicle"] = vehicle_table(result["vehicle"])
    if "thrust" in result:
        with within("thrust"):
            result["thrust"] = thrust_of(result["thrust"])
    if "estimator" in result:
        with within("estimator"):
            result["estimator"] = estimator_table(result["estimator"])
    return result

"""Saved results: flights read back from the folders that `springback fly` writes."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from springback.contact.grids.form_copies import FORMS, place_forms
from springback.errors import InputError
from springback.results.contacts.stored import CONTACTS, check_contacts
from springback.results.database import in_database, parquet, pattern, sandbox
from springback.results.flight import Flight
from springback.results.meshes import read_surfaces
from springback.results.recovery_measures import RECOVERY_MEASURES
from springback.results.sealed_json import file_digest, is_sealed, read_object
from springback.scenario.scenario import Scenario, scenario_from
from springback.simulation.measuring.measures import MEASURES, Outcome
from springback.vehicle.parameters import Vehicle

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Beginning of the names of the files of a second vehicle.
SECOND = "second_"
#: No flight has such a number; its square is still finite.
LARGEST = 1e100


def is_result(folder: Path) -> bool:
    """True for a folder that has the summary of a flight."""
    return (folder / "summary.json").is_file()


def load(folder: str | Path) -> Flight:
    """Read a flight as it was written, with its scenario, measures, trajectory and telemetry.

    Args:
        folder: Folder with ``summary.json``, ``trajectory.parquet`` and, for a flight with a pilot
            or sensors, ``telemetry.parquet``.

    Raises:
        InputError: In one line, if the folder is not a result, or its content is damaged or
            foreign.
    """
    folder = Path(folder)
    if not folder.exists():
        raise InputError(f"{folder}: there is no such folder")
    if not folder.is_dir():
        raise InputError(f"{folder}: is a file; give the folder that springback fly wrote")
    summary = _summary(folder / "summary.json")
    scenario_path = folder / "summary.json"
    _check_files(folder, summary["files"])
    if FORMS in summary["files"]:
        place_forms(folder / FORMS)
    scenario = _scenario(scenario_path, summary)
    flight = _flight(folder, summary, scenario, summary["files"], "")
    flight = replace(flight, warned=_warnings(scenario_path, summary))
    if CONTACTS in summary["files"]:
        flight = replace(flight, own_contacts=_contacts(folder / CONTACTS, flight.columns))
    if scenario.second is None:
        return flight
    verdict: Any = summary.get("second")
    kinds = {"outcome": str, "measures": dict}
    is_table = isinstance(verdict, dict)
    if not is_table or any(not isinstance(verdict.get(n), k) for n, k in kinds.items()):
        raise InputError(f"{scenario_path}: second: is missing or of another kind")
    second = _flight(folder, verdict, scenario.beside(), summary["files"], SECOND)
    if not np.array_equal(flight.t, second.t):
        raise InputError(
            f"{folder / SECOND}trajectory.parquet: column t: must be that of trajectory.parquet"
        )
    return replace(flight, second=replace(second, first=flight))


def _check_files(folder: Path, files: Mapping[str, Any]) -> None:
    """Reject a folder without a trajectory, and files that are not the flight's."""
    path = folder / "trajectory.parquet"
    if path.name not in files:
        raise InputError(f"{path}: is missing; fly the scenario again to have a trajectory")
    tables = ("trajectory.parquet", "telemetry.parquet")
    for name in (*tables, CONTACTS, FORMS, *(SECOND + name for name in tables)):
        _check_file(folder / name, files)


def _flight(
    folder: Path, verdict: Mapping[str, Any], scenario: Scenario, files: Any, prefix: str
) -> Flight:
    """Flight of one vehicle.

    Args:
        folder: Of the result.
        verdict: With its outcome and measures.
        scenario: Of this vehicle.
        files: Names of the files that there are.
        prefix: Of their names.
    """
    path = folder / f"{prefix}trajectory.parquet"
    if path.name not in files:
        raise InputError(f"{path}: is missing; fly the scenario again to have a trajectory")
    columns, units = _table(path)
    _check(path, columns, _required_columns(scenario.vehicle))
    _check_vehicle(path, columns, scenario.vehicle)
    telemetry: dict[str, Array] = {}
    path = folder / f"{prefix}telemetry.parquet"
    if path.name in files:
        telemetry, more = _table(path)
        vehicle = scenario.vehicle
        flown = scenario.reference or scenario.pilot or {"command1", "thrust1"} & telemetry.keys()
        kinds = ("command", "thrust") if flown else ("hall",)  # of a pilot, of sensors alone
        count = vehicle.rotor_count if flown else vehicle.arm_count
        numbers = range(1, count + 1)
        _check_there(path, telemetry, [f"{kind}{n}" for kind in kinds for n in numbers])
        _check(path, telemetry, ["t"])
        units |= more
    outcome, measures = _outcome(folder / "summary.json", verdict), _measures(folder, verdict)
    where = f"{folder / 'summary.json'}: own_obstacles"
    surfaces = read_surfaces(verdict.get("own_obstacles", ()), where)
    return Flight(scenario, outcome, measures, columns, units, telemetry, own_surfaces=surfaces)


def _warnings(path: Path, summary: Mapping[str, Any]) -> tuple[str, ...]:
    """Warnings that the flight had; none in results that are older than they are."""
    told = summary.get("warnings", [])
    if not isinstance(told, list) or not all(isinstance(one, str) for one in told):
        raise InputError(f"{path}: warnings: must be a list of texts")
    return tuple(told)


def _contacts(path: Path, trajectory: Mapping[str, Array]) -> dict[str, Array]:
    """Contacts with obstacles of the user's own."""
    columns, _ = _table(path)
    check_contacts(path, columns, trajectory)
    for name, values in columns.items():
        if not (np.abs(values) < LARGEST).all():
            raise InputError(
                f"{path}: column {name}: must be finite numbers below {LARGEST:g} in magnitude"
            )
    return columns


def _summary(path: Path) -> Mapping[str, Any]:
    if not path.is_file():
        raise InputError(
            f"{path}: is missing; {path.parent} is no result folder as springback fly writes it"
        )
    read = read_object(path)
    for name, kind in {"scenario": dict, "measures": dict, "outcome": str, "files": dict}.items():
        if not isinstance(read.get(name), kind):
            raise InputError(
                f"{path}: {name}: is missing or of another kind; this is no summary of one flight"
            )
    if not is_sealed(read):
        raise InputError(f"{path}: is damaged or was edited; fly the scenario again")
    return read


def _check_file(path: Path, files: Mapping[str, Any]) -> None:
    """Reject a file that is not the flight's: damaged, or from another flight."""
    if path.name not in files:
        return
    try:
        same = file_digest(path) == files[path.name]
    except FileNotFoundError:
        raise InputError(f"{path}: is missing; fly the scenario again") from None
    except OSError as error:
        raise InputError(f"{path}: cannot be read ({error.strerror})") from None
    if not same:
        raise InputError(
            f"{path}: is damaged, or belongs to another flight than summary.json; fly the scenario "
            "again"
        )


def _first_line(error: BaseException) -> str:
    text = str(error).strip().splitlines() or [type(error).__name__]
    return text[0][:200]


def _without_unread_sensors(tables: Any) -> Any:
    """Tables of a saved flight; where not every step was recorded, no sensor was read from them.

    A scenario is saved with all its tables, those that were left out, too.
    """
    simulation = tables.get("simulation") if isinstance(tables, dict) else None
    if not isinstance(simulation, dict) or not simulation.get("record_interval"):
        return tables
    second = tables.get("second")
    kept = tables | {"second": _of_pilots(second)} if isinstance(second, dict) else tables
    return _of_pilots(kept)


def _of_pilots(tables: dict[str, Any]) -> dict[str, Any]:
    """Tables of a vehicle, without sensors if it has no pilot that reads them."""
    guided = tables.get("reference") is not None or tables.get("pilot") is not None
    return {key: value for key, value in tables.items() if guided or key != "sensors"}


def _scenario(path: Path, summary: Mapping[str, Any]) -> Scenario:
    try:
        return scenario_from(_without_unread_sensors(summary["scenario"]))
    except (InputError, TypeError, ValueError) as error:
        by = f"; it was written by springback {str(summary.get('springback', '?'))[:20]}"
        raise InputError(f"{path}: scenario: {_first_line(error)}{by}") from None


def _outcome(path: Path, summary: Mapping[str, Any]) -> Outcome:
    known = {outcome.word: outcome for outcome in Outcome}
    if summary["outcome"] not in known:
        raise InputError(
            f"{path}: outcome: {summary['outcome'][:40]!r} is none of {', '.join(known)}"
        )
    return known[summary["outcome"]]


def _measures(folder: Path, summary: Mapping[str, Any]) -> dict[str, float | None]:
    measures: dict[str, float | None] = {}
    for name, value in summary["measures"].items():
        number = isinstance(value, int | float) and not isinstance(value, bool)
        if value is not None and not (number and math.isfinite(value)):
            raise InputError(
                f"{folder / 'summary.json'}: measures.{name[:40]}: must be a number or null "
                f"(got {str(value)[:40]!r})"
            )
        measures[name] = None if value is None else float(value)
    for name in (*MEASURES, *(RECOVERY_MEASURES if "runs" in measures else ())):
        if name not in measures:
            raise InputError(f"{folder / 'summary.json'}: measures.{name}: is missing")
    return measures


def _required_columns(vehicle: Vehicle) -> list[str]:
    """Required columns of a trajectory."""
    numbers = range(1, vehicle.arm_count + 1)
    names = ["t", *"xyz", *(f"q{p}" for p in "wxyz")]
    names += [f"{kind}{axis}" for kind in "vwa" for axis in "xyz"]
    names += [f"{kind}{j}" for kind in ("l", "dl", "fn", "ff") for j in numbers]
    return names + (["fn_body", "ff_body"] if vehicle.has_body_hull else [])


def _check_vehicle(path: Path, columns: Mapping[str, Array], vehicle: Vehicle) -> None:
    """Reject a trajectory of a vehicle with more arms, or with a hull that this one lacks."""
    arms = sum(1 for name in columns if re.fullmatch(r"l\d+", name))
    if arms != vehicle.arm_count:
        raise InputError(
            f"{path}: is of a vehicle with {arms} arms; that of the scenario has "
            f"{vehicle.arm_count}"
        )
    if "fn_body" in columns and not vehicle.has_body_hull:
        raise InputError(f"{path}: is of a vehicle with a hull; that of the scenario has none")


def _table(path: Path) -> tuple[dict[str, Array], dict[str, str]]:
    """Columns of a Parquet file, and their units."""
    path = path.absolute()
    import duckdb

    def ask(connection: Any) -> tuple[Any, Any]:
        read = connection.execute(f"SELECT * FROM {parquet([path])}").fetchnumpy()
        metadata = connection.execute(
            "SELECT value FROM parquet_kv_metadata(?) WHERE key = 'units'", [pattern(path)]
        ).fetchone()
        return read, metadata

    try:
        read, metadata = in_database(ask, sandbox([path], threads=1))
    except duckdb.Error as error:
        raise InputError(f"{path}: cannot be read as Parquet ({_first_line(error)})") from None
    columns: dict[str, Array] = {}
    for name, values in read.items():
        if np.ma.isMaskedArray(values) and np.ma.getmaskarray(values).any():
            raise InputError(f"{path}: column {name}: has missing values")
        try:
            columns[name] = np.ascontiguousarray(values, dtype=np.float64)
        except (TypeError, ValueError):
            raise InputError(f"{path}: column {name}: must hold numbers") from None
    try:
        units = json.loads(metadata[0]) if metadata else {}
    except ValueError:
        units = {}
    known = units if isinstance(units, dict) else {}
    return columns, {name: str(known.get(name, "")) for name in columns}


def _check_there(path: Path, columns: Mapping[str, Array], wanted: list[str]) -> None:
    """Reject a table with missing columns."""
    missing = [name for name in wanted if name not in columns]
    if missing:
        raise InputError(f"{path}: has no column {', '.join(missing[:6])}; it is of another kind")


def _check(path: Path, columns: Mapping[str, Array], wanted: list[str]) -> None:
    """Reject columns that are not those of a flight."""
    _check_there(path, columns, wanted)
    t = columns["t"]
    if len(t) < 2:
        raise InputError(f"{path}: has {len(t)} instants; a flight has at least 2")
    for name in wanted:
        if not (np.abs(columns[name]) < LARGEST).all():
            raise InputError(
                f"{path}: column {name}: must be finite numbers below {LARGEST:g} in magnitude"
            )
    if not (np.diff(t) > 0.0).all():
        raise InputError(f"{path}: column t: must increase from row to row, in s")

"""Contacts of flights with obstacles of the user's own, as files have them.

Their laws are code, which no file contains: a flight that is read back cannot evaluate them again.
So the force and the place of each contact are written when the flight is.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from springback.errors import InputError
from springback.results.contacts.history import model_of
from springback.results.contacts.spans import contact_mask, parts_of
from springback.results.result import FlightResult
from springback.simulation.playback import NO_FORCE, LoadHistory, load_history

Array = np.ndarray[Any, np.dtype[np.float64]]
Places = np.ndarray[Any, np.dtype[np.intp]]

#: File of a result folder.
CONTACTS = "contacts.parquet"
#: Column of the elastic energy of all contacts.
ENERGY = "energy_contact"
#: Columns of a contact: the part with it, as in ``fn1`` and ``fn_body``, and its number there.
_FORCE = re.compile(r"force(?P<part>\d+|_body)_(?P<number>\d+)_x")


def contact_columns(flight: FlightResult) -> tuple[dict[str, Array], dict[str, str]]:
    """Columns of `CONTACTS` at the instants with a contact, and their units.

    Those of contact 1 of cage 2 are ``force2_1_x`` and so on, on the cage, and ``point2_1_x``,
    where it acts, both in the world; all are 0 where there is no such contact.

    Args:
        flight: With its trajectory.

    Returns:
        Empty ones for a flight without obstacles of the user's own, or without a contact.
    """
    if flight.own_contacts:
        return dict(flight.own_contacts), {name: _unit(name) for name in flight.own_contacts}
    if not flight.own or not flight.columns:
        return {}, {}
    rows = np.flatnonzero(contact_mask(flight.columns))
    if not len(rows):
        return {}, {}
    loads = load_history(model_of(flight, ()), flight.columns, rows)
    found = {"t": flight.t[rows], ENERGY: loads.energy["contact"]}
    named, counts = parts_of(flight.columns), dict[int, int]()
    for k, part in enumerate(loads.part):
        number = counts[part] = counts.get(part, 0) + 1
        for kind, values in (("force", loads.force), ("point", np.nan_to_num(loads.point))):
            for axis, column in zip("xyz", values[:, k].T, strict=True):
                found[f"{kind}{named[part]}_{number}_{axis}"] = np.ascontiguousarray(column)
    return found, {name: _unit(name) for name in found}


def _unit(name: str) -> str:
    if name in ("t", ENERGY):
        return "s" if name == "t" else "J"
    return "N" if name.startswith("force") else "m"


def stored_loads(flight: FlightResult, loads: LoadHistory, places: Places) -> LoadHistory:
    """Contacts and energies of a flight that was read back, at some instants.

    Args:
        flight: With its stored contacts.
        loads: As evaluated again without the obstacles of the user's own.
        places: Rows of the instants.
    """
    c, named = flight.own_contacts, parts_of(flight.columns)
    at = np.searchsorted(flight.t, c["t"])
    row = np.full(len(flight.t), -1, dtype=np.intp)
    row[at] = np.arange(len(at))
    row = row[places]
    stems = [match for match in map(_FORCE.fullmatch, c) if match]
    stems.sort(key=lambda match: named.index(match["part"]))
    force, point = (
        np.stack([_vectors(c, f"{kind}{m['part']}_{m['number']}", row) for m in stems], axis=1)
        for kind in ("force", "point")
    )
    point = np.where(np.abs(force).max(axis=2, keepdims=True) > NO_FORCE, point, np.nan)
    energy = np.where(row >= 0, c[ENERGY][row], loads.energy["contact"])
    part = tuple(named.index(match["part"]) for match in stems)
    return loads._replace(
        part=part, force=force, point=point, energy={**loads.energy, "contact": energy}
    )


def stored_point(flight: FlightResult, part: str, when: float) -> tuple[float, float, float]:
    """Where a part is pressed hardest at an instant, world [m].

    Args:
        flight: With its stored contacts.
        part: Of the vehicle, as by `parts_of`.
        when: Instant of a contact [s].
    """
    c, row = flight.own_contacts, np.array([np.searchsorted(flight.own_contacts["t"], when)])
    stems = [f"{part}_{m['number']}" for m in map(_FORCE.fullmatch, c) if m and m["part"] == part]
    hardest = max(stems, key=lambda stem: np.linalg.norm(_vectors(c, f"force{stem}", row)))
    x, y, z = _vectors(c, f"point{hardest}", row)[0].tolist()
    return x, y, z


def _vectors(columns: Mapping[str, Array], stem: str, row: Places) -> Array:
    """Vectors at some rows, 0 for row −1, shape (rows, 3)."""
    found = np.stack([columns[f"{stem}_{axis}"][row] for axis in "xyz"], axis=1)
    return np.where(row[:, None] >= 0, found, 0.0)


def check_contacts(
    path: Path, columns: Mapping[str, Array], trajectory: Mapping[str, Array]
) -> None:
    """Reject columns that are no contacts of a trajectory.

    Args:
        path: Of their file, for errors.
        columns: As read.
        trajectory: Columns of the flight.

    Raises:
        InputError: In one line.
    """
    known = parts_of(trajectory)
    wanted = {"t", ENERGY, *(f"force{part}_1_x" for part in known)}
    for match in filter(None, map(_FORCE.fullmatch, columns)):
        if match["part"] not in known:
            raise InputError(f"{path}: column {match[0]}: the vehicle has no such part")
        stem = f"{match['part']}_{match['number']}"
        wanted |= {f"{kind}{stem}_{axis}" for kind in ("force", "point") for axis in "xyz"}
    missing = sorted(wanted - columns.keys())
    if missing:
        raise InputError(f"{path}: has no column {', '.join(missing[:6])}; it is of another kind")
    if not np.array_equal(columns["t"], trajectory["t"][contact_mask(trajectory)]):
        raise InputError(f"{path}: column t: must be the instants of trajectory.parquet in contact")

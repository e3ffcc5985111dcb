"""Draws of a posterior, as `springback identify fit` writes them, and overlays of its values."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from pydantic import Field, model_validator

from springback.errors import InputError, excerpt, shown_value
from springback.results.database import (
    identifier,
    in_database,
    literal,
    parquet,
    pattern,
    sandbox,
)
from springback.scenario.overrides import apply_overrides, overlay_words
from springback.settings import Settings, problem

#: Most numbers of a posterior, all of which a plan holds (chosen: some 20 MB in its file).
MOST_NUMBERS = 10**6
#: Note in the file of a posterior that no other file has.
NOTE = "draws"
#: Types of columns that are read.
_NUMBERS = ("DOUBLE", "FLOAT")


class Posterior(Settings):
    """Rows of values that belong together: one row of all fields is drawn for each sample.

    The path of a file alone stands for a table.
    """

    file: str | None = None
    """Parquet file with a column for each field, relative to the plan."""
    fields: tuple[str, ...] = ()
    """Fields in it that are drawn; by default all."""
    draws: dict[str, tuple[float, ...]] = Field(default_factory=dict)
    """Values of each field, instead of a file [SI], the same number of each."""
    units: dict[str, str] = Field(default_factory=dict)
    """SI unit of each field, as in the file."""

    @model_validator(mode="before")
    @classmethod
    def _path(cls, given: Any) -> Any:
        if not isinstance(given, str | dict):
            raise problem(f"must be the path of a file, or a table (got {shown_value(given)})")
        return {"file": given} if isinstance(given, str) else given

    @model_validator(mode="after")
    def _one_way(self) -> Posterior:
        if (self.file is None) == (not self.draws):
            raise problem("needs one of: file, draws")
        if self.draws:
            if self.fields:
                raise problem("belong to a file", "fields")
            if why := refusal(self.draws):
                raise problem(why, "draws")
        return self

    def with_file_read(self, folder: Path) -> Posterior:
        """This with the draws of its file in its place.

        Args:
            folder: That its path is relative to.

        Raises:
            InputError: If there is none, or it is no posterior.
        """
        if self.file is None:
            return self
        draws, units = read_draws(folder / self.file, self.fields)
        return self.with_checked(file=None, fields=(), draws=draws, units=units)


def existing_file(path: Path) -> str:
    """Path of a file in a message.

    Raises:
        InputError: If there is none.
    """
    shown = excerpt(str(path))
    try:
        there = path.is_file()
    except (OSError, ValueError):  # an impossible file name
        there = False
    if not there:
        raise InputError(f"there is no file {shown}")
    return shown


def refusal(draws: Mapping[str, tuple[float, ...]]) -> str:
    """What is wrong with draws; empty if nothing is."""
    lengths = {len(values) for values in draws.values()}
    if len(lengths) != 1 or not min(lengths):
        return "must have at least one value of each field, and as many of all"
    if len(draws) * max(lengths) > MOST_NUMBERS:
        return f"must be at most {MOST_NUMBERS} numbers (got {len(draws) * max(lengths)})"
    for name, values in draws.items():
        bad = next((k for k, x in enumerate(values) if not math.isfinite(x)), None)
        if bad is not None:
            return f"{name}: row {bad} must be finite (got {values[bad]})"
    return ""


def read_draws(
    path: Path, fields: tuple[str, ...] = ()
) -> tuple[dict[str, tuple[float, ...]], dict[str, str]]:
    """Draws of a posterior and units, by field.

    Args:
        path: Parquet file.
        fields: Those to read; all if empty.

    Raises:
        InputError: One line that names the file: there is none, it is no posterior, or it lacks a
            field.
    """
    shown = existing_file(path)
    no = f"{shown} is no posterior"
    units, columns = _content(path.absolute(), no)
    for name in fields:
        if name not in columns:
            known = ", ".join(columns)
            raise InputError(f"{shown} has no field {shown_value(name)}; it has {known}")
    chosen = {name: values for name, values in columns.items() if not fields or name in fields}
    if why := refusal(chosen):
        raise InputError(f"{no}: {why}")
    return chosen, {name: units.get(name, "") for name in chosen}


def _content(path: Path, no: str) -> tuple[dict[str, str], dict[str, tuple[float, ...]]]:
    """Units and columns of a Parquet file."""
    import duckdb

    table = parquet([path])

    def read(connection: Any) -> tuple[dict[str, str], dict[str, tuple[float, ...]]]:
        about = literal(pattern(path))
        pairs = connection.execute(
            f"SELECT decode(key), decode(value) FROM parquet_kv_metadata({about})"
        ).fetchall()
        notes = dict(pairs)
        if NOTE not in notes:
            raise InputError(f"{no}: springback identify fit did not write it")
        units = _units(notes.get("units"))
        heads = connection.execute(f"DESCRIBE SELECT * FROM {table}").fetchall()
        wrong = next((head for head in heads if head[1] not in _NUMBERS), None)
        if wrong is not None:
            raise InputError(f"{no}: its column {shown_value(wrong[0])} holds no numbers")
        [(count,)] = connection.execute(f"SELECT count(*) FROM {table}").fetchall()
        if count * len(heads) > MOST_NUMBERS:
            raise InputError(
                f"{no}: it must have at most {MOST_NUMBERS} numbers (got {count * len(heads)})"
            )
        names = [head[0] for head in heads]
        chosen = ", ".join(f"{identifier(name)}::DOUBLE" for name in names)
        rows = connection.execute(f"SELECT {chosen} FROM {table}").fetchall()
        found = {
            name: tuple(math.nan if row[k] is None else float(row[k]) for row in rows)
            for k, name in enumerate(names)
        }
        return units, found

    try:
        return in_database(read, sandbox([path], threads=1))
    except duckdb.Error:
        raise InputError(f"{no}: it cannot be read as Parquet") from None


def _units(text: str | None) -> dict[str, str]:
    try:
        found = json.loads(text or "{}")
    except ValueError:
        return {}
    if not isinstance(found, dict):
        return {}
    return {str(name): str(unit) for name, unit in found.items()}


def with_overlay(tables: dict[str, Any], path: Path) -> dict[str, Any]:
    """Raw tables of a scenario with the values of an overlay, ``identified.toml``, over them.

    Args:
        tables: Raw tables.
        path: Of the overlay.

    Raises:
        InputError: If it cannot be read, or is no overlay.
    """
    return apply_overrides(tables, overlay_words(path))

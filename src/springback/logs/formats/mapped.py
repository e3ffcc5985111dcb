"""Tables of one's own, CSV or Parquet, described by a mapping file in TOML."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field, ValidationError, field_validator, model_validator

from springback.errors import InputError, shown_value
from springback.logs.formats.text import NumberColumns, open_text, table_lines
from springback.logs.frame_turns import BODIES, WORLDS, attitudes_in, flags_in, vectors_in
from springback.logs.recording import (
    AT_END,
    ATTITUDE,
    MAPPED,
    QUANTITIES,
    Array,
    Budget,
    LogChannel,
    Recording,
    SensorChain,
    TimeSpan,
    log_channel,
)
from springback.problems import dotted_path, nearest_name, problem_paths
from springback.quantities import Duration, Unit
from springback.scenario.source_text import source_text, toml_tables
from springback.settings import Name, Settings, problem
from springback.units import UnitError, read_number

#: Rows that are read at a time from Parquet.
ROWS = 100_000


def _choice(known: dict[str, Any]) -> Any:
    """Validator of a name among known ones, in any case of letters."""

    def check(value: str) -> str:
        word = str(value).strip().lower()
        if word not in known:
            near = nearest_name(word, known)
            hint = f"did you mean {near}?" if near else f"known are {', '.join(known)}"
            raise problem(f"is not known; {hint} (got {shown_value(value)})")
        return word

    return check


class MappedChannel(Settings):
    """Columns of a table that are one channel."""

    name: Name
    """Name in everything that is printed about the log."""
    quantity: Name
    """What is measured, such as ``specific force``."""
    columns: Annotated[tuple[Name, ...], Field(min_length=1, max_length=64)]
    """Names of the columns, from the first line of the table."""
    unit: Name = ""
    """Unit of the columns; by default the SI unit of the quantity."""
    time: Name
    """Column with the instants."""
    time_unit: Name = "s"
    """Unit of the instants."""
    clock: Name = "log"
    """Channels with the same word share a clock."""
    order: Literal["wxyz", "xyzw"] = "wxyz"
    """Order of a quaternion's components."""
    blank: Literal["absent", "lost"] = "absent"
    """What a row means in which all the columns are blank: no sample then, or one that was lost."""
    estimated: bool = False
    """An estimate from several sensors, not a measurement."""
    smoothed: bool = False
    """Smoothed by the program that recorded it."""
    full_scale: Annotated[str, Field(max_length=64)] | float | None = None
    """Largest magnitude that the sensor gives, with its unit, or in SI."""
    clipped: Annotated[tuple[Name, ...], Field(max_length=64)] = ()
    """Columns that are 1 where a sample is at the end of the range, one for each of ``columns``; by
    default those samples are clipped that reach ``full_scale``."""
    average: Duration | None = None
    """Time over which each sample is the mean."""
    low_pass: Annotated[float, Unit("Hz", above=0.0)] | None = None
    """Corner of a low-pass filter."""
    low_pass_order: Literal[1, 2] | None = None
    """Its order: 2 is a Butterworth filter, as in PX4 and ArduPilot; by default 1."""

    @field_validator("quantity")
    @classmethod
    def _known(cls, value: str) -> str:
        return str(_choice(QUANTITIES)(value))

    @model_validator(mode="after")
    def _fits(self) -> MappedChannel:
        width = QUANTITIES[self.quantity].width
        if width is not None and len(self.columns) != width:
            raise problem(
                f"{self.quantity} needs {width} columns (got {len(self.columns)})", "columns"
            )
        if self.clipped and self.quantity == ATTITUDE:
            raise problem("an attitude has no range to end", "clipped")
        if self.clipped and len(self.clipped) != len(self.columns):
            raise problem(
                f"needs one for each of {len(self.columns)} columns (got {len(self.clipped)})",
                "clipped",
            )
        for field, unit in (("unit", self.si_unit), ("time_unit", "s")):
            text = getattr(self, field)
            try:
                read_number(f"1 {text}" if text else "1", unit if text else "")
            except UnitError as error:
                raise problem(
                    f"{error} (got {shown_value(text)}); expected {unit or 'none'}", field
                ) from None
        if isinstance(self.full_scale, str):
            try:
                read_number(self.full_scale, self.si_unit)
            except UnitError as error:
                raise problem(f"{error}; expected {self.si_unit}", "full_scale") from None
        return self

    @property
    def si_unit(self) -> str:
        """Unit of the quantity."""
        return QUANTITIES[self.quantity].unit

    @property
    def scale(self) -> float:
        """SI units in the unit of the columns."""
        return read_number(f"1 {self.unit}", self.si_unit) if self.unit else 1.0

    def chain(self) -> SensorChain:
        """What is told of the sensor."""
        most = self.full_scale
        if isinstance(most, str):
            most = read_number(most, self.si_unit)
        return SensorChain(
            full_scale=most, average=self.average, low_pass=self.low_pass,
            low_pass_order=self.low_pass_order, estimated=self.estimated, smoothed=self.smoothed,
        )  # fmt: skip


class MappedAxes(Settings):
    """Axes of the table's vectors."""

    world: Name = "nwu"
    """One of nwu, enu, ned, y-up, z-up."""
    body: Name = "flu"
    """One of flu, frd, rfu, y-up."""

    @field_validator("world")
    @classmethod
    def _world(cls, value: str) -> str:
        return str(_choice(WORLDS)(value))

    @field_validator("body")
    @classmethod
    def _body(cls, value: str) -> str:
        return str(_choice(BODIES)(value))


class Mapping(Settings):
    """A mapping file: which columns of a table are which channels."""

    file: Name
    """The table, ``.csv``, ``.tsv`` or ``.parquet``; relative to the mapping file."""
    delimiter: Annotated[str, Field(min_length=1, max_length=1)] | None = None
    """Of a text; by default a tabulator in a ``.tsv``, else a comma."""
    axes: MappedAxes = MappedAxes()
    channels: Annotated[tuple[MappedChannel, ...], Field(min_length=1, max_length=200)]
    """Channels, a table each."""


def read_mapping(path: Path) -> Mapping:
    """A mapping file.

    Raises:
        InputError: One line for each problem, with the key.
    """
    tables = toml_tables(source_text(path), str(path))
    try:
        return Mapping.model_validate(tables)
    except ValidationError as error:
        raise InputError(
            *(f"{path}: {dotted_path(at)}: {what}" for at, what in problem_paths(error))
        ) from None


def read_mapped(path: Path, part: TimeSpan) -> Recording:
    """Recording of a table, by its mapping file.

    Args:
        path: The mapping file.
        part: Instants that are wanted, in seconds of the clocks of its columns.

    Raises:
        InputError: If the mapping or the table cannot be read, or a column is missing.
    """
    mapping = read_mapping(path)
    table = path.parent / mapping.file
    if not table.is_file():
        raise InputError(f"{path}: file: there is no file {table}")
    wanted = sorted({
        name for one in mapping.channels for name in (one.time, *one.columns, *one.clipped)
    })  # fmt: skip
    budget = Budget(str(table))
    if table.suffix.lower() == ".parquet":
        columns = _parquet_columns(table, wanted, budget)
    else:
        columns = _text_columns(table, mapping, wanted, budget)
    channels = tuple(_channel(str(table), one, mapping.axes, columns, part)
                     for one in mapping.channels)  # fmt: skip
    told = {"world": mapping.axes.world, "body": mapping.axes.body}
    for one in mapping.channels:
        told[f"{one.name}.time_unit"] = one.time_unit
        if one.quantity == ATTITUDE:
            told[f"{one.name}.order"] = one.order
    return Recording(table, MAPPED, channels, parameters=told)


def _text_columns(
    table: Path, mapping: Mapping, wanted: list[str], budget: Budget
) -> dict[str, Array]:
    where = str(table)
    mark = mapping.delimiter or ("\t" if table.suffix.lower() == ".tsv" else ",")
    columns: NumberColumns | None = None
    with open_text(table) as file:
        for line, cells in table_lines(file, where, mark):
            if not any(cells) or cells[0].startswith("#"):
                continue
            if columns is None:
                names = [cell.strip() for cell in cells]
                _check_names(where, names, wanted)
                columns = NumberColumns(
                    where, wanted, [names.index(name) for name in wanted], budget
                )
            else:
                columns.add(line, cells)
    if columns is None or not columns.lines:
        raise InputError(f"{where}: has no lines of numbers")
    return dict(zip(wanted, columns.values().T, strict=True))


def _check_names(where: str, names: list[str], wanted: list[str]) -> None:
    missing = [name for name in wanted if name not in names]
    if missing:
        near = nearest_name(missing[0], dict.fromkeys(names))
        hint = f"did you mean {near}?" if near else f"it has {', '.join(names)[:300]}"
        raise InputError(f"{where}: has no column {shown_value(missing[0])}; {hint}")


def _parquet_columns(table: Path, wanted: list[str], budget: Budget) -> dict[str, Array]:
    """Columns of a Parquet file, read by the database that results use."""
    import duckdb

    where = str(table)
    try:
        with duckdb.connect(":memory:") as base:
            base.execute("SET memory_limit = '400MB'")
            source = base.from_parquet(where)
            names = list(source.columns)
            _check_names(where, names, wanted)
            [(count,)] = base.execute("SELECT count(*) FROM read_parquet(?)", [where]).fetchall()
            budget.take(count * len(wanted))
            quoted = ", ".join(
                f'CAST("{name.replace(chr(34), 2 * chr(34))}" AS DOUBLE)' for name in wanted
            )
            data = source.project(quoted).fetchnumpy()
    except duckdb.Error as error:
        said = " ".join(str(error).split())[:300]
        raise InputError(f"{where}: cannot be read as Parquet: {said}") from None
    if not count:
        raise InputError(f"{where}: has no rows")
    return {
        name: np.ma.filled(np.ma.asarray(column, dtype=float), np.nan)
        for name, column in zip(wanted, data.values(), strict=True)
    }


def _channel(
    where: str, one: MappedChannel, axes: MappedAxes, columns: dict[str, Array], part: TimeSpan
) -> LogChannel:
    times = columns[one.time] * read_number(f"1 {one.time_unit}", "s")
    values = np.stack([columns[name] for name in one.columns], axis=1)
    has_time = ~np.isnan(times)  # several clocks in one table leave cells blank
    chosen = has_time & (times >= part.first) & (times <= part.last)
    if one.blank == "absent":
        chosen &= ~np.isnan(values).all(axis=1)
    times, values = times[chosen], values[chosen] * one.scale
    if not len(times):
        raise InputError(f"{where}: {one.name}: has no samples with a time")
    frame = QUANTITIES[one.quantity].frame
    if one.quantity == ATTITUDE:
        q = values if one.order == "wxyz" else values[:, [3, 0, 1, 2]]
        values = attitudes_in(WORLDS[axes.world], BODIES[axes.body], q)
    elif frame:
        turn = WORLDS[axes.world] if frame == "world" else BODIES[axes.body]
        if values.shape[1] % 3:
            raise InputError(f"{where}: {one.name}: needs three columns for each point")
        values = vectors_in(turn, values.reshape(len(values), -1, 3)).reshape(len(values), -1)
    chain = one.chain()
    clipped = None
    if one.clipped:
        clipped = np.stack([columns[name] for name in one.clipped], axis=1)[chosen] > 0.0
        if frame:
            points = clipped.reshape(len(clipped), -1, 3)
            clipped = flags_in(turn, points).reshape(clipped.shape)
    elif chain.full_scale is not None:
        with np.errstate(invalid="ignore"):
            clipped = np.abs(values) >= AT_END * chain.full_scale
    return log_channel(
        where, one.name, one.quantity, times, values, clipped=clipped, clock=one.clock, chain=chain
    )

"""Access to a campaign: SQL queries, and repetition of single flights."""

from __future__ import annotations

import copy
import functools
import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

import numpy as np
import numpy.typing as npt

from springback.campaign import manifest
from springback.campaign.columns import known_columns
from springback.campaign.design.dimensions import Dimension
from springback.campaign.design.distributions import LevelSet
from springback.campaign.design.layout import Design, lay_out, value_text
from springback.campaign.store import (
    METADATA,
    empty_rows,
    is_disk,
    read_metadata,
    rows_of,
    stored_plan,
)
from springback.errors import InputError
from springback.files import atomic_file, json_text, write_atomically
from springback.results.database import (
    identifier,
    in_database,
    in_one_line,
    literal,
    one_expression,
    one_select,
    parquet,
    pattern,
    sandbox,
)
from springback.results.flight import Flight, fly
from springback.results.hooks import NotebookPage, hook
from springback.results.parquet import write_parquet
from springback.results.saved import SECOND
from springback.scenario.code_files import changed_files
from springback.version import __version__

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure

T = TypeVar("T")
Numbers = npt.NDArray[np.float64]
KEPT = "kept"
KEPT_NAME = re.compile(r"flight-(\d{10})\.json")
#: Most levels of a field that an error lists (chosen).
MOST_LISTED = 8
#: Rows of an answer that are read at a time (chosen).
STRETCH = 1000


class Answer(NamedTuple):
    """Result of a query."""

    columns: list[str]
    rows: list[tuple[Any, ...]]

    def as_dicts(self) -> list[dict[str, Any]]:
        """Rows as dictionaries by column name."""
        return [dict(zip(self.columns, row, strict=True)) for row in self.rows]


class RepeatedFlight(NamedTuple):
    """A flight of a campaign, repeated alone with its trajectory."""

    flight: Flight
    differences: tuple[str, ...]
    """Columns that differ from the row in any bit; empty if the flight is identical."""


class Campaign:
    """A campaign in a folder, complete or not."""

    def __init__(self, folder: str | Path) -> None:
        """Open the folder of a campaign and verify every byte of its parts.

        Raises:
            InputError: If there is no campaign, or parts of it are missing or damaged.
        """
        self.folder = Path(folder)
        self.conditions: tuple[str, ...] = ()
        """Conditions in words on the flights that are looked at; see `where`."""
        self._filters: tuple[str, ...] = ()
        self._counted = False
        self.metadata = read_metadata(self.folder)
        self.parts = manifest.read(self.folder / manifest.NAME)
        flights = self.metadata["flights"]
        if self.parts and self.parts[-1].last > flights:
            raise InputError(
                f"{self.folder / manifest.NAME}: holds flights up to {self.parts[-1].last - 1}, "
                f"and the campaign has {flights}"
            )
        for part in manifest.damaged_parts(self.parts, self.folder):
            path = self.folder / part.file
            raise InputError(
                f"{path}: is {'damaged' if path.is_file() else 'missing'}; "
                "continue the campaign with --resume to fly it again"
            )

    @functools.cached_property
    def design(self) -> Design:
        """Design of the campaign."""
        return lay_out(stored_plan(self.folder), tried=False)

    @property
    def done(self) -> int:
        """Number of stored flights."""
        return manifest.flight_count(self.parts)

    @property
    def complete(self) -> bool:
        """True if all flights are stored."""
        return self.done == int(self.metadata["flights"])

    @functools.cached_property
    def robots(self) -> list[str]:
        """Names of the robots of these flights, in the order of the plan."""
        names: list[str] = self.metadata["robots"]
        if not self._filters:
            return names
        found = {robot for (robot,) in self.query("SELECT DISTINCT robot FROM flights").rows}
        return [name for name in names if name in found]

    def where(self, *conditions: str) -> Campaign:
        """The flights that satisfy conditions, to be queried, summarised and drawn alone.

        Args:
            conditions: In words, as a plan's ``success``, which must all hold: ``speed > 3 m/s``,
                ``yaw = 45 deg or yaw = 0 deg``, ``surface = wall``, ``not success``,
                ``not (first_obstacle = 'world.obstacles[1], a pole' and penetration > 5 mm)``.

        Raises:
            InputError: If one cannot be read, or no flight satisfies them.
        """
        filters = [self.design.condition(text, judged=True) for text in conditions]
        chosen = self.selection(*filters)
        chosen.conditions += conditions
        if conditions and self.done and not chosen.count("FROM flights"):
            told = "; ".join(
                f"{one.column} is {self._extent(one)}" for one in self.design.dimensions
                if any(re.search(rf"(?<![\w.]){re.escape(one.column)}\b", c) for c in conditions)
            )  # fmt: skip
            raise InputError(f"{'; '.join(conditions)}: no flight is so{told and '; '}{told}")
        return chosen

    def _extent(self, one: Dimension) -> str:
        """Values of a varied field, in SI."""
        name, unit = identifier(one.column), f" {one.unit}" if one.unit else ""
        if isinstance(one.law, LevelSet):
            values = [one.column_value(k, 0) for k in range(min(one.law.levels, MOST_LISTED))]
            more = ", ..." if one.law.levels > MOST_LISTED else ""
            return f"{', '.join(map(value_text, values))}{more}{unit}"
        [(low, high)] = self.query(f"SELECT min({name}), max({name}) FROM flights").rows
        return f"{value_text(low)} to {value_text(high)}{unit}"

    def selection(self, *conditions: str) -> Campaign:
        """The flights that satisfy conditions in SQL; see `where`."""
        chosen = copy.copy(self)
        chosen._filters = (*self._filters, *map(one_expression, conditions))
        chosen.__dict__.pop("robots", None)
        return chosen

    def stored_flights(self) -> list[int]:
        """Numbers of the flights whose trajectories are stored, in ascending order."""
        found = (KEPT_NAME.fullmatch(path.name) for path in (self.folder / KEPT).glob("*.json"))
        numbers = (int(name[1]) for name in found if name)
        return sorted(number for number in numbers if number < self.metadata["flights"])

    @property
    def units(self) -> dict[str, str]:
        """SI units of all columns."""
        columns = known_columns(second=self.design.has_second)
        known = {name: unit for name, (unit, _) in columns.items()}
        return known | dict(self.metadata["units"])

    def _ask(
        self,
        sql: str,
        parameters: Sequence[Any],
        found: Callable[[Any], T],
        writes: Sequence[Path] = (),
    ) -> T:
        """Result of ``found`` for the answer to a query of all rows, the view ``flights``."""
        files = [(self.folder / part.file).absolute() for part in self.parts]

        def ask(connection: Any) -> T:
            if files:
                self._check_counts(connection)
                source = f"SELECT * FROM {parquet(files)}"
            else:
                connection.register("given", empty_rows(self.design))
                source = rows_of(self.design)
            if self._filters:
                kept = " AND ".join(f"({condition})" for condition in self._filters)
                source = f"SELECT * FROM ({source}) WHERE {kept}"
            connection.execute(f"CREATE VIEW flights AS {source}")
            with in_words():
                return found(connection.execute(sql, list(parameters)))

        return in_database(ask, sandbox([*files, *writes]))

    def _check_counts(self, connection: Any) -> None:
        """Reject parts with more or fewer rows than the manifest says."""
        for part in self.parts if not self._counted else ():
            path = (self.folder / part.file).absolute()
            asked = f"SELECT num_rows FROM parquet_file_metadata({literal(pattern(path))})"
            with in_words(str(path)):
                (count,) = connection.execute(asked).fetchone()
            if count != part.last - part.first:
                raise InputError(
                    f"{path}: has {count} rows; {manifest.NAME} says {part.last - part.first}"
                )
        self._counted = True

    def query(self, sql: str, parameters: Sequence[Any] = ()) -> Answer:
        """Result of an SQL query of the table ``flights``.

        All rows are held in memory; `stream` holds few.

        Args:
            sql: One SELECT.
            parameters: Values of its question marks.

        Raises:
            InputError: If it is not a valid SELECT.
        """
        return self._ask(one_select(sql), parameters, _answer)

    def stream(self, sql: str, taken: Callable[[list[str], Iterator[list[Any]]], T]) -> T:
        """Query in SQL, and process the answer in blocks of rows.

        Args:
            sql: One SELECT.
            taken: Called with the column names and an iterator of blocks of at most `STRETCH` rows.

        Returns:
            The result of ``taken``.

        Raises:
            InputError: If it is not a valid SELECT.
        """

        def take(found: Any) -> T:
            names = [column[0] for column in found.description]
            return taken(names, iter(lambda: found.fetchmany(STRETCH), []))

        return self._ask(one_select(sql), (), take)

    def count(self, sql: str) -> int:
        """Number of rows of a result."""
        counted = f"SELECT count(*) FROM (\n{one_select(sql)}\n)"
        return self._ask(counted, (), lambda found: int(found.fetchone()[0]))

    def arrays(self, sql: str, parameters: Sequence[Any] = ()) -> dict[str, Numbers]:
        """Result of a query as arrays of floats by column; NaN for missing values.

        Raises:
            InputError: If it is not a valid SELECT, or a column holds no numbers.
        """
        select = one_select(sql)
        found = self._ask(select, parameters, lambda found: found.fetchnumpy())
        try:
            return {
                name: np.ma.filled(np.ma.asarray(values).astype(np.float64), np.nan)
                for name, values in found.items()
            }
        except (TypeError, ValueError):
            raise InputError(f"{self.folder}: a column of numbers holds something else") from None

    def save(self, sql: str, path: Path) -> int:
        """Write the result of a query as Parquet, completely or not at all; returns its row count.

        Args:
            sql: One SELECT.
            path: Path of the file.

        Raises:
            InputError: If it is not a valid SELECT.
            OSError: If the file cannot be written.
        """
        select = one_select(sql)
        path = path.absolute()
        path.parent.mkdir(parents=True, exist_ok=True)
        with atomic_file(path) as draft:
            copy = (
                f"COPY (\n{select}\n) TO {literal(str(draft))} "
                "(FORMAT parquet, COMPRESSION zstd, USE_TMP_FILE false)"
            )
            return self._ask(copy, (), lambda found: int(found.fetchone()[0]), [draft])

    def to_dataframe(self, sql: str = "SELECT * FROM flights ORDER BY flight") -> pandas.DataFrame:
        """Rows as a pandas DataFrame; units in ``attrs``."""
        from springback.extras import needs

        needs("pandas", "dataframe")
        frame: pandas.DataFrame = self._ask(one_select(sql), (), lambda found: found.df())
        frame.attrs["units"] = self.units
        return frame

    def row(self, number: int) -> dict[str, Any]:
        """Row of a flight.

        Raises:
            InputError: If the flight does not exist or has not been flown.
        """
        flights = self.metadata["flights"]
        if not 0 <= number < flights:
            raise InputError(f"flight {number}: must be from 0 to {flights - 1}")
        found = self.query("SELECT * FROM flights WHERE flight = ?", [number]).as_dicts()
        if not found and self._filters:
            raise InputError(
                f"flight {number}: is not among those where {'; '.join(self.conditions)}"
            )
        if not found:
            raise InputError(f"flight {number}: has not been flown yet; continue with --resume")
        return found[0]

    def refly(self, number: int, *, trajectory: bool = True) -> RepeatedFlight:
        """Repeat one flight alone, and compare it with its row.

        Args:
            number: Number of the flight.
            trajectory: Keep the trajectory.

        Raises:
            InputError: If it has not been flown, or could not be flown; if its scenario names code
                that is not trusted, or has changed.
        """
        row = self.row(number)
        if row["outcome"] == "refused":
            raise InputError(f"flight {number}: could not be flown: {row['problem']}")
        drawn = self.design.slice(number, number + 1)
        if changed := changed_files(self.metadata["code"]):
            raise InputError(f"{', '.join(changed)}: has changed since the campaign was flown")
        flight = fly(drawn.tables[0], trajectory=trajectory)
        now = {name: values[0] for name, values in drawn.columns.items()}
        first = {"outcome": flight.outcome.word, "first_obstacle": flight.first_obstacle}
        now |= first | flight.measures
        if flight.second is not None:
            measures = {"outcome": flight.second.outcome.word, **flight.second.measures}
            now |= {SECOND + name: value for name, value in measures.items()}
        skipped = ("success", "problem")
        different = (
            f"{name}: {row[name]!r} in the row, {now.get(name)!r} now"
            for name in row
            if name not in skipped and not _same(row[name], now.get(name))
        )
        return RepeatedFlight(flight, tuple(different))

    def flight(self, number: int) -> Flight:
        """One flight, repeated with its trajectory; `refly` also compares it with its row.

        Args:
            number: Number of the flight.

        Raises:
            InputError: If it has not been flown, or could not be flown.
        """
        return self.refly(number).flight

    def view(
        self,
        number: int,
        *others: int,
        export: str | Path | None = None,
        force: bool = False,
        browser: bool = True,
    ) -> NotebookPage:
        """Replay one flight, or several side by side; see `springback.Flight.view`.

        Args:
            number: Number of the flight.
            others: Numbers of flights to show beside it.
            export: As for `springback.Flight.view`.
            force: As for `springback.Flight.view`.
            browser: As for `springback.Flight.view`.

        Raises:
            InputError: If one has not been flown or could not be flown, and as there.
        """
        first, *rest = map(self.flight, (number, *others))
        return first.view(*rest, export=export, force=force, browser=browser)

    def plot(
        self,
        measure: str = "success",
        by: str | tuple[str, str] | None = None,
        *,
        limit: str | Sequence[str] = (),
        share: float | None = None,
    ) -> Figure:
        """Figure of a measure over the flights, by robot, with 95 % intervals.

        With a limit or a share it is the worst case over all other fields, with the values of the
        field that keep the limits shaded and in a sentence: of ``campaign.where("speed < 4 m/s")``
        those for hits of up to 4 m/s.

        Args:
            measure: Name of a column: a measure, or ``success``.
            by: Name of a varied field; the measure is drawn over it.  Two names give a map; None
                the distribution, as a histogram and cumulated.
            limit: Limits in words, as a plan's ``success``, a panel each:
                ``impact_peak_acceleration < 300 m/s^2``, ``not arm_bottomed``; over two fields a
                map of the share of flights that keep them.
            share: Share of the flights at each value of the field that must keep the limits; by
                default all, 1.

        Raises:
            InputError: If matplotlib is not installed, there is no such column, a field was not
                varied, or a limit cannot be read.
        """
        limits = (limit,) if isinstance(limit, str) else tuple(limit)
        figure: Figure = hook("Campaign.plot")(self, measure, by, limits=limits, share=share)
        return figure

    def _repr_html_(self) -> str:
        return str(hook("Campaign.html")(self))

    def keep(self, remark: Callable[[str], None]) -> None:
        """Store the trajectories that the plan selects, of the first flights with its condition."""
        wanted = self.design.plan.keep
        if wanted is None:
            return
        condition = one_expression(self.design.keep_condition)
        sql = f"SELECT flight FROM flights WHERE {condition} AND outcome <> 'refused' "
        for (number,) in self.query(f"{sql} ORDER BY flight LIMIT {wanted.most}").rows:
            stem = self.folder / KEPT / f"flight-{number:010d}"
            summary = stem.with_name(f"{stem.name}.json")
            if not summary.exists():
                summary.parent.mkdir(exist_ok=True)
                again = self.refly(number)
                for line in again.differences:
                    remark(f"flight {number}, selected to be kept, differs from its row: {line}")
                _write_selected(again.flight, stem)
                data = {"flight": number, **again.flight.summary()}
                write_atomically(summary, json_text(data), durable=True)


def is_campaign(folder: Path) -> bool:
    """True if a folder holds a campaign."""
    try:
        return (folder / METADATA).is_file()
    except (OSError, ValueError):  # an impossible file name
        return False


def _answer(found: Any) -> Answer:
    return Answer([column[0] for column in found.description], found.fetchall())


def _write_selected(flight: Flight, stem: Path) -> None:
    """Write trajectory and telemetry, each completely, before the summary that names them."""
    about = {"springback": __version__, "frames": "world NWU, body FLU"}
    for one, prefix in ((flight, ""), (flight.second, SECOND)):
        if one is None:
            continue
        for word, columns in {"trajectory": one.columns, "telemetry": one.telemetry}.items():
            if columns:
                path = stem.with_name(f"{stem.name}-{prefix}{word}.parquet")
                units = {name: one.units[name] for name in columns}
                with atomic_file(path) as draft:
                    write_parquet(draft, columns, units, about)


def _same(row: Any, now: Any) -> bool:
    """True if both are the same number to the last bit, or both are None."""
    if isinstance(row, float) and isinstance(now, int | float):
        return float(row).hex() == float(now).hex()
    return bool(row == now)


@contextmanager
def in_words(whose: str = "SQL") -> Iterator[None]:
    """Convert errors of DuckDB to problems of one line."""
    import duckdb

    try:
        yield
    except duckdb.Error as error:
        if is_disk(error):
            raise
        raise InputError(f"{whose}: {in_one_line(error)}") from None

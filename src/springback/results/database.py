"""Sandboxed DuckDB connections that Ctrl-C can interrupt.

SQL comes from other people's plans and folders.  A connection therefore reads and writes only the
files that it is given, loads no extension, sees no variable of Python's, and its configuration is
locked; queries are one SELECT, and conditions are one expression.
"""

from __future__ import annotations

import functools
import threading
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar

from springback.errors import InputError

T = TypeVar("T")

_LOCK = (
    "SET enable_external_access = false",
    "SET allow_persistent_secrets = false",
    "SET autoinstall_known_extensions = false",
    "SET autoload_known_extensions = false",
    "SET lock_configuration = true",
)


def sandbox(
    paths: Sequence[Path] = (), folders: Sequence[Path] = (), *, threads: int | None = None
) -> Any:
    """A new in-memory database that can only access given files.

    Args:
        paths: Files that it may read and write.
        folders: Folders whose files it may read and write.
        threads: Number of threads; None leaves it to DuckDB.
    """
    import duckdb

    made = duckdb.connect(config={"python_enable_replacements": "false"})
    if threads is not None:
        made.execute(f"SET threads = {int(threads)}")
    names = dict.fromkeys(name for path in paths for name in (str(path), pattern(path)))
    if names:
        made.execute(f"SET allowed_paths = [{', '.join(map(literal, names))}]")
    if folders:
        made.execute(
            f"SET allowed_directories = [{', '.join(literal(str(one)) for one in folders)}]"
        )
    for statement in _LOCK:
        made.execute(statement)
    return made


def in_database(work: Callable[[Any], T], connection: Any = None) -> T:
    """Result of ``work`` with a DuckDB connection, which is closed afterwards.

    DuckDB checks for Ctrl-C between the tasks of a query, if the calling thread executes one of
    them, and turns it into a RuntimeError.  So another thread runs the query, and this one waits
    for signals.

    Args:
        work: Called with the connection.
        connection: Connection to use; None is a new in-memory database that can access no file.

    Raises:
        KeyboardInterrupt: After Ctrl-C at any instant, once the query has ended.
    """
    asked = _Asked(work, connection if connection is not None else sandbox())
    try:
        threading.Thread(target=asked.run, daemon=True, name="springback database").start()
        asked.ended.wait()
    finally:
        asked.close()
    found: T = asked.answer()
    return found


class _Asked:
    """Work for another thread, which starts it unless it was cancelled before.

    Ctrl-C may arrive while the thread is being started, when it is unknown whether it will run.
    """

    def __init__(self, work: Callable[[Any], Any], connection: Any) -> None:
        self.ended = threading.Event()
        self._work, self._connection = work, connection
        self._once = threading.Lock()
        self._found: Any = None
        self._error: BaseException | None = None

    def run(self) -> None:
        if not self._once.acquire(blocking=False):
            return  # cancelled
        try:
            self._found = self._work(self._connection)
        except BaseException as error:
            self._error = error
        finally:
            self.ended.set()

    def close(self) -> None:
        """Interrupt the work if it has not ended, and close the connection."""
        if not self._once.acquire(blocking=False):  # it has started
            while not self.ended.is_set():
                self._connection.interrupt()
                self.ended.wait(0.05)
        self._connection.close()

    def answer(self) -> Any:
        if self._error is not None:
            raise self._error
        return self._found


# -- texts in SQL ---------------------------------------------------------------------------------


def literal(text: str) -> str:
    """A text as an SQL literal."""
    return "'" + text.replace("'", "''") + "'"


def identifier(column: str) -> str:
    """A column name as an SQL identifier."""
    return '"' + column.replace('"', '""') + '"'


def pattern(path: Path) -> str:
    """A path for file readers, with the wildcards ``*``, ``?`` and ``[`` escaped."""
    return "".join(f"[{sign}]" if sign in "*?[" else sign for sign in str(path))


def parquet(paths: Sequence[Path]) -> str:
    """The rows of Parquet files, as a table in SQL."""
    return f"read_parquet([{', '.join(literal(pattern(path)) for path in paths)}])"


def one_select(sql: str) -> str:
    """A query, verified to be one SELECT.

    Returns:
        The statement; it may end in a comment, so that more must follow on the next line.

    Raises:
        InputError: If it cannot be parsed, or is something else.
    """
    import duckdb

    _encodable(sql, "SQL")
    try:
        found = duckdb.extract_statements(sql)
    except duckdb.Error as error:
        why = f"SQL: {in_one_line(error)}"
        raise InputError(
            f'{why}; a column whose name is a word of SQL needs double quotes, such as "offset"'
        ) from None
    if len(found) != 1 or found[0].type != duckdb.StatementType.SELECT:
        kinds = ", ".join(str(one.type).rpartition(".")[2] for one in found)
        raise InputError(f"SQL: must be one SELECT (got {kinds or 'nothing'})")
    return sql.rstrip().rstrip(";")


@functools.lru_cache(maxsize=64)
def one_expression(text: str) -> str:
    """A condition, verified to be one expression.

    Returns:
        The expression in parentheses, safe to use in a larger one.

    Raises:
        InputError: If it cannot be parsed, or is something else.
    """
    import duckdb

    _encodable(text, "a condition")
    try:
        duckdb.SQLExpression(text)
        [statement] = duckdb.extract_statements(f"SELECT (\n{text}\n)")
        whole = statement.type == duckdb.StatementType.SELECT
    except (duckdb.Error, ValueError) as error:
        said = in_one_line(error) if isinstance(error, duckdb.Error) else "several statements"
        raise InputError(f"must be one condition in SQL ({said})") from None
    if not whole:
        raise InputError("must be one condition in SQL")
    return f"(\n{text}\n)"


def _encodable(text: str, what: str) -> None:
    try:
        text.encode()
    except UnicodeEncodeError:
        raise InputError(f"{what}: is not text in UTF-8") from None
    if "\0" in text:
        raise InputError(f"{what}: holds a zero byte")


def in_one_line(error: BaseException) -> str:
    """Error message of DuckDB, in one line."""
    said = str(error)
    for rest in ("\nLINE ", "\n\n", " You might need", "\n\tCandidate functions"):
        said = said.partition(rest)[0]
    return " ".join(said.split())

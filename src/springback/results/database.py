"""DuckDB, locked in, and so that Ctrl-C breaks it off.

SQL comes from plans and folders that others wrote.  So a connection reads and writes the files that
it is given and nothing else, loads no extension, sees no variable of Python's, and cannot be told
otherwise; questions are one SELECT, and conditions are one expression.
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


def locked(
    paths: Sequence[Path] = (), folders: Sequence[Path] = (), *, threads: int | None = None
) -> Any:
    """A new database in memory that can reach some files and no others.

    Args:
        paths: Files that it may read and write.
        folders: Whose files it may read and write.
        threads: How many it uses; None leaves it to DuckDB.
    """
    import duckdb

    made = duckdb.connect(config={"python_enable_replacements": "false"})
    if threads is not None:
        made.execute(f"SET threads = {int(threads)}")
    names = dict.fromkeys(name for path in paths for name in (str(path), pattern(path)))
    if names:
        made.execute(f"SET allowed_paths = [{', '.join(map(quoted, names))}]")
    if folders:
        made.execute(
            f"SET allowed_directories = [{', '.join(quoted(str(one)) for one in folders)}]"
        )
    for statement in _LOCK:
        made.execute(statement)
    return made


def in_database(work: Callable[[Any], T], connection: Any = None) -> T:
    """What ``work`` finds with a DuckDB connection, which is closed afterwards.

    DuckDB hears Ctrl-C between the tasks of a query, if the thread that asked has one of them, and
    makes a RuntimeError of it. So another thread asks, and this one listens.

    Args:
        work: Given the connection.
        connection: Where to ask; None is a new database in memory that reaches no file.

    Raises:
        KeyboardInterrupt: After Ctrl-C at any instant, once the query has ended.
    """
    asked = _Asked(work, connection if connection is not None else locked())
    try:
        threading.Thread(target=asked.run, daemon=True, name="springback database").start()
        asked.ended.wait()
    finally:
        asked.close()
    found: T = asked.answer()
    return found


class _Asked:
    """Work for another thread, which begins it unless it was called off before.

    Ctrl-C may come while the thread is being started, when nobody can say whether it will run.
    """

    def __init__(self, work: Callable[[Any], Any], connection: Any) -> None:
        self.ended = threading.Event()
        self._work, self._connection = work, connection
        self._once = threading.Lock()
        self._found: Any = None
        self._error: BaseException | None = None

    def run(self) -> None:
        if not self._once.acquire(blocking=False):
            return  # called off
        try:
            self._found = self._work(self._connection)
        except BaseException as error:
            self._error = error
        finally:
            self.ended.set()

    def close(self) -> None:
        """Break the work off if it has not ended, and close the connection."""
        if not self._once.acquire(blocking=False):  # it has begun
            while not self.ended.is_set():
                self._connection.interrupt()
                self.ended.wait(0.05)
        self._connection.close()

    def answer(self) -> Any:
        if self._error is not None:
            raise self._error
        return self._found


# -- texts in SQL ---------------------------------------------------------------------------------


def quoted(text: str) -> str:
    """A text as SQL writes it."""
    return "'" + text.replace("'", "''") + "'"


def named(column: str) -> str:
    """The name of a column as SQL writes it."""
    return '"' + column.replace('"', '""') + '"'


def pattern(path: Path) -> str:
    """A path as readers of files take it, which else see a pattern in ``*``, ``?`` and ``[``."""
    return "".join(f"[{sign}]" if sign in "*?[" else sign for sign in str(path))


def parquet(paths: Sequence[Path]) -> str:
    """The rows of Parquet files, as a table in SQL."""
    return f"read_parquet([{', '.join(quoted(pattern(path)) for path in paths)}])"


def one_select(sql: str) -> str:
    """A question, that it is one SELECT.

    Returns:
        The statement; it may end in a comment, so more goes to the next line.

    Raises:
        InputError: If it cannot be understood, or is something else.
    """
    import duckdb

    _encodable(sql, "SQL")
    try:
        found = duckdb.extract_statements(sql)
    except duckdb.Error as error:
        raise InputError(f"SQL: {in_one_line(error)}") from None
    if len(found) != 1 or found[0].type != duckdb.StatementType.SELECT:
        kinds = ", ".join(str(one.type).rpartition(".")[2] for one in found)
        raise InputError(f"SQL: must be one SELECT (got {kinds or 'nothing'})")
    return sql.rstrip().rstrip(";")


@functools.lru_cache(maxsize=64)
def one_expression(text: str) -> str:
    """A condition, that it is one expression.

    Returns:
        The expression in brackets, safe to stand in a larger one.

    Raises:
        InputError: If it cannot be understood, or is something else.
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
    """What DuckDB does not understand, in one line."""
    said = str(error)
    for rest in ("\nLINE ", "\n\n", " You might need", "\n\tCandidate functions"):
        said = said.partition(rest)[0]
    return " ".join(said.split())

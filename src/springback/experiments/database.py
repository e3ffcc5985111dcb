"""DuckDB, so that Ctrl-C breaks it off."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any, TypeVar

T = TypeVar("T")


def in_database(work: Callable[[Any], T], connection: Any = None) -> T:
    """What ``work`` finds with a DuckDB connection, which is closed afterwards.

    DuckDB hears Ctrl-C between the tasks of a query, if the thread that asked has one of them, and
    makes a RuntimeError of it. So another thread asks, and this one listens.

    Args:
        work: Given the connection.
        connection: Where to ask; None is a new database in memory.

    Raises:
        KeyboardInterrupt: After Ctrl-C, once the query has ended.
    """
    import duckdb

    with connection or duckdb.connect() as opened, ThreadPoolExecutor(1) as thread:
        working = thread.submit(work, opened)
        try:
            return working.result()
        except KeyboardInterrupt:
            opened.interrupt()
            raise


def quoted(text: str) -> str:
    """A text as SQL writes it."""
    return "'" + text.replace("'", "''") + "'"


def named(column: str) -> str:
    """The name of a column as SQL writes it."""
    return '"' + column.replace('"', '""') + '"'

"""Parquet files: columns with units."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any


def write_parquet(
    path: Path,
    columns: Mapping[str, Any],
    units: Mapping[str, str],
    about: Mapping[str, str],
    *,
    select: str = "SELECT * FROM given",
) -> None:
    """Columns as Parquet, with units and ``about`` in the file's metadata.

    Args:
        path: File to write.
        columns: Arrays of equal length by name.
        units: Unit of each column, kept as JSON under the key ``units``.
        about: More metadata.
        select: What is written, in SQL over the table ``given`` of these columns.
    """
    import duckdb

    metadata = {"units": json.dumps(dict(units)), **about}
    pairs = ", ".join(f"{quoted(key)}: {quoted(value)}" for key, value in metadata.items())
    with duckdb.connect() as connection:
        connection.execute("SET threads = 1")  # so that rows keep their order at any size
        connection.register("given", dict(columns))
        connection.execute(
            f"COPY ({select}) TO {quoted(str(path))} "
            f"(FORMAT parquet, COMPRESSION zstd, KV_METADATA {{{pairs}}})"
        )


def quoted(text: str) -> str:
    """A text as SQL writes it."""
    return "'" + text.replace("'", "''") + "'"


def named(column: str) -> str:
    """The name of a column as SQL writes it."""
    return '"' + column.replace('"', '""') + '"'

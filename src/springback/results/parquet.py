"""Parquet files: columns with units."""

from __future__ import annotations

import functools
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from springback.results.database import in_database, literal, sandbox


def write_parquet(
    path: Path,
    columns: Mapping[str, Any],
    units: Mapping[str, str],
    about: Mapping[str, str],
    *,
    select: str = "SELECT * FROM given",
) -> None:
    """Write columns as Parquet, with units and ``about`` in the file's metadata.

    Args:
        path: File to write.
        columns: Arrays of equal length by name.
        units: Unit of each column, stored as JSON under the key ``units``.
        about: More metadata.
        select: SQL query for the rows to write, over the table ``given`` of these columns.
    """
    path = path.absolute()
    metadata = {"units": json.dumps(dict(units)), **about}
    pairs = ", ".join(f"{literal(key)}: {literal(value)}" for key, value in metadata.items())
    text = (
        f"COPY ({select}) TO {literal(str(path))} "
        f"(FORMAT parquet, COMPRESSION zstd, USE_TMP_FILE false, KV_METADATA {{{pairs}}})"
    )

    def write(connection: Any) -> None:
        connection.register("given", dict(columns))
        connection.execute(text)

    try:
        in_database(write, _database(path.parent).cursor())
    except BaseException:
        _database.cache_clear()  # it may be unusable
        raise


@functools.lru_cache(maxsize=4)
def _database(folder: Path) -> Any:
    """One database for all files of a folder: creating it takes as long as writing a file."""
    return sandbox(folders=[folder], threads=1)  # one thread, so that rows keep their order

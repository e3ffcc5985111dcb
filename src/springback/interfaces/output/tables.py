"""Results of SQL queries as text and files."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Iterator, Sequence
from decimal import Decimal
from itertools import chain
from pathlib import Path
from typing import Any

from springback.files import atomic_file, csv_text

Row = tuple[Any, ...]
#: Suffixes of files of results, and their formats.
SUFFIXES = {".csv": "csv", ".json": "json", ".md": "markdown"}
#: Most rows, and most characters of a column, that a table shows (chosen).
MOST_ROWS, WIDEST = 200, 48


def lines_of(
    columns: Sequence[str], stretches: Iterable[Sequence[Row]], form: str
) -> Iterator[str]:
    """Lines of text of a result, as it arrives; at most one chunk is held in memory.

    Args:
        columns: Names of the columns.
        stretches: Values, some rows at a time.
        form: ``table``, ``csv``, ``json`` or ``markdown``.
    """
    if form == "table":
        yield from _table_lines(columns, stretches)
        return
    if form == "json":
        yield from _json_lines(columns, chain.from_iterable(stretches))
        return
    if form == "markdown":
        yield from as_markdown(columns, []).splitlines()
    else:
        yield csv_text([columns]).rstrip("\n")
    for rows in stretches:
        if rows and form == "markdown":
            yield "\n".join(_markdown_line([cell_text(v) for v in row]) for row in rows)
        elif rows:
            yield csv_text(rows).rstrip("\n")


def _table_lines(columns: Sequence[str], stretches: Iterable[Sequence[Row]]) -> Iterator[str]:
    """The first rows as a table, and the number of further rows."""
    shown_rows: list[Row] = []
    count = 0
    for rows in stretches:
        shown_rows += rows[: MOST_ROWS - len(shown_rows)]
        count += len(rows)
    yield from as_text(columns, shown_rows).splitlines()
    if count > len(shown_rows):
        yield _more(count - len(shown_rows))


def _json_lines(columns: Sequence[str], rows: Iterable[Row]) -> Iterator[str]:
    before = "["
    for row in rows:
        data = dict(zip(columns, map(_plain, row), strict=True))
        text = json.dumps(data, indent=2, allow_nan=False, ensure_ascii=False, default=str)
        yield before if before == "[" else f"{before},"
        before = "\n".join(f"  {line}" for line in text.splitlines())
    yield "[]" if before == "[" else f"{before}\n]"


def _more(count: int) -> str:
    return f"... {count} more rows; use --format or --out for all"


def cell_text(value: Any) -> str:
    """Value as text for people."""
    if value is None:
        return "-"
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(cell_text, value)) + "]"
    return str(value).lower() if isinstance(value, bool) else str(value)


def as_text(columns: Sequence[str], rows: Sequence[Row]) -> str:
    """Table with aligned columns; of many rows only the first."""
    cells = [[_short(cell_text(value)) for value in row] for row in rows[:MOST_ROWS]]
    widths = [max(map(len, column)) for column in zip(columns, *cells, strict=True)]
    numbers = [
        all(isinstance(row[k], int | float | None) for row in rows[:MOST_ROWS])
        for k in range(len(columns))
    ]
    lines = []
    for line in [list(columns), *cells]:
        entries = [
            f"{word:>{width}}" if number else f"{word:<{width}}"
            for word, width, number in zip(line, widths, numbers, strict=True)
        ]
        lines.append("  ".join(entries).rstrip())
    if len(rows) > MOST_ROWS:
        lines.append(_more(len(rows) - MOST_ROWS))
    return "\n".join(lines)


def _short(text: str) -> str:
    return text if len(text) <= WIDEST else text[: WIDEST - 1] + "…"


def as_markdown(columns: Sequence[str], rows: Sequence[Row]) -> str:
    """A Markdown table."""
    lines = [columns, ["---"] * len(columns), *([cell_text(v) for v in row] for row in rows)]
    return "\n".join(map(_markdown_line, lines))


def _markdown_line(entries: Sequence[str]) -> str:
    return f"| {' | '.join(entries)} |"


def _plain(value: Any) -> Any:
    """Value for JSON: numbers that are not finite become null."""
    if isinstance(value, float) and not math.isfinite(value):
        return None
    if isinstance(value, dict):
        return {str(key): _plain(v) for key, v in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(v) for v in value]
    return float(value) if isinstance(value, Decimal) else value


def write_answer(columns: Sequence[str], stretches: Iterable[Sequence[Row]], path: Path) -> int:
    """Write a result to a file as it arrives, completely or not at all.

    Args:
        columns: Names of the columns.
        stretches: Values, some rows at a time.
        path: File, whose suffix is one of `SUFFIXES`.

    Returns:
        Number of rows.
    """
    count = 0

    def counted() -> Iterator[Sequence[Row]]:
        nonlocal count
        for rows in stretches:
            count += len(rows)
            yield rows

    path.parent.mkdir(parents=True, exist_ok=True)
    with atomic_file(path) as draft, draft.open("w", encoding="utf-8", newline="\n") as file:
        for line in lines_of(columns, counted(), SUFFIXES[path.suffix]):
            file.write(line + "\n")
    return count

"""Answers to questions in SQL as text and files."""

from __future__ import annotations

import csv
import io
import json
import math
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

Row = tuple[Any, ...]
#: What a file of an answer may end in, and the form that this stands for.
SUFFIXES = {".csv": "csv", ".json": "json", ".md": "markdown"}
#: Rows and signs of a column that a table shows at most (chosen).
MOST_ROWS, WIDEST = 200, 48


def rendered(columns: Sequence[str], rows: Sequence[Row], form: str) -> str:
    """An answer as text.

    Args:
        columns: Names.
        rows: Values.
        form: ``table``, ``csv``, ``json`` or ``markdown``.
    """
    if form == "csv":
        return as_csv(columns, rows).rstrip("\n")
    if form == "json":
        return as_json(columns, rows)
    if form == "markdown":
        return as_markdown(columns, rows)
    return as_text(columns, rows)


def shown(value: Any) -> str:
    """A value as people read it."""
    if value is None:
        return "-"
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(shown, value)) + "]"
    return str(value).lower() if isinstance(value, bool) else str(value)


def as_text(columns: Sequence[str], rows: Sequence[Row]) -> str:
    """A table with aligned columns; of many rows the first."""
    cells = [[_short(shown(value)) for value in row] for row in rows[:MOST_ROWS]]
    widths = [max(map(len, column)) for column in zip(columns, *cells, strict=True)]
    numbers = [
        all(isinstance(row[k], int | float | None) for row in rows) for k in range(len(columns))
    ]
    lines = []
    for line in [list(columns), *cells]:
        entries = [
            f"{word:>{width}}" if number else f"{word:<{width}}"
            for word, width, number in zip(line, widths, numbers, strict=True)
        ]
        lines.append("  ".join(entries).rstrip())
    if len(rows) > MOST_ROWS:
        lines.append(f"... {len(rows) - MOST_ROWS} more rows; --format or --out gives all")
    return "\n".join(lines)


def _short(text: str) -> str:
    return text if len(text) <= WIDEST else text[: WIDEST - 1] + "…"


def as_markdown(columns: Sequence[str], rows: Sequence[Row]) -> str:
    """A Markdown table."""
    lines = [columns, ["---"] * len(columns), *([shown(v) for v in row] for row in rows)]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def as_csv(columns: Sequence[str], rows: Sequence[Row]) -> str:
    """Comma-separated values; what is not there is empty."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(rows)
    return text.getvalue()


def as_json(columns: Sequence[str], rows: Sequence[Row]) -> str:
    """A list of objects."""
    data = [dict(zip(columns, map(_plain, row), strict=True)) for row in rows]
    return json.dumps(data, indent=2, allow_nan=False, ensure_ascii=False, default=str)


def _plain(value: Any) -> Any:
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return [_plain(v) for v in value] if isinstance(value, list | tuple) else value


def write_answer(columns: Sequence[str], rows: Sequence[Row], path: Path) -> None:
    """Write an answer to a file, whole or not at all.

    Args:
        columns: Names.
        rows: Values.
        path: Whose suffix is one of `SUFFIXES`.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    draft = path.with_name(f".{path.name}.draft")
    try:
        text = rendered(columns, rows, SUFFIXES[path.suffix])
        draft.write_text(text + "\n", encoding="utf-8")
        os.replace(draft, path)
    finally:
        draft.unlink(missing_ok=True)

"""Answers as text, while they come."""

from __future__ import annotations

import csv
import json
from decimal import Decimal
from itertools import chain
from pathlib import Path
from typing import Any

import pytest

from springback.interfaces.output.plain_text import plain_text
from springback.interfaces.output.tables import MOST_ROWS, SUFFIXES, lines_of, write_answer

COLUMNS = ["n", "x", "word"]


def stretches(count: int, size: int = 7) -> list[list[tuple[Any, ...]]]:
    rows = [(k, None if k % 3 else k / 4, f"w,{k}\n") for k in range(count)]
    return [rows[k : k + size] for k in range(0, count, size)]


@pytest.mark.parametrize("count", [0, 1, 20, 1000])
def test_csv_and_json_hold_every_row_in_order(tmp_path: Path, count: int) -> None:
    rows = list(chain.from_iterable(stretches(count)))
    for suffix in SUFFIXES:
        assert write_answer(COLUMNS, stretches(count), tmp_path / f"x{suffix}") == count
    with (tmp_path / "x.csv").open(newline="") as file:
        head, *read = csv.reader(file)
    assert head == COLUMNS
    assert read == [["" if v is None else str(v) for v in row] for row in rows]
    told = json.loads((tmp_path / "x.json").read_text())
    assert told == [dict(zip(COLUMNS, row, strict=True)) for row in rows]
    assert len(list(tmp_path.iterdir())) == 3


def test_a_table_shows_the_first_and_says_how_many_more() -> None:
    lines = list(
        lines_of(["n"], ([(k,) for k in range(j, j + 50)] for j in range(0, 1000, 50)), "table")
    )
    assert len(lines) == MOST_ROWS + 2
    assert lines[-1] == "... 800 more rows; use --format or --out for all"


def test_rows_are_not_kept() -> None:
    """A stretch that was written is let go before the next is taken."""
    taken: list[int] = []

    def coming() -> Any:
        for k in range(5):
            taken.append(k)
            yield [(k,)]

    for form in ("csv", "json", "markdown"):
        taken.clear()
        lines = iter(lines_of(["n"], coming(), form))
        next(lines)
        next(lines)
        assert len(taken) <= 3


def test_numbers_that_are_none_are_null_wherever_they_are() -> None:
    """Was a traceback within a STRUCT."""
    value = {"a": float("nan"), "b": [float("inf"), 1.0], "c": Decimal("1.5")}
    text = "\n".join(lines_of(["s"], [[(value,)]], "json"))
    assert json.loads(text) == [{"s": {"a": None, "b": [None, 1.0], "c": 1.5}}]


def test_text_that_steers_terminals_does_not() -> None:
    assert plain_text("a\x1b[2Jb\x9bc\udcffd\u202ee") == "a\ufffd[2Jb\ufffdc\ufffdd\ufffde"
    assert plain_text("x [m/s²]\tlänge\n") == "x [m/s²]\tlänge\n"

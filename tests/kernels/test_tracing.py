"""What was computed with cells is known for every row, by its bits."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from springback.kernels.tracing import NO_FORMULA, Evaluated, Tape, Traced, cos, sin, sqrt
from springback.kernels.vectors import Vec

ROWS = np.random.default_rng(5).normal(size=(50, 3))
Function = Callable[[Any, Any, Any], Any]


def worked_out(function: Function, rows: Any = ROWS) -> tuple[Any, Evaluated]:
    """A function given cells, and the sheet worked out."""
    sheet = Tape(rows)
    return function(*sheet.first), sheet.evaluate()


def arithmetic(a: Any, b: Any, c: Any) -> Any:
    return -(a + 2.0) * (3.0 - b) / (c * c + 1.0) - 1.0 / (2.0 + abs(a)) + 0.1 * b - c + a / 7.0


def roots_and_angles(a: Any, b: Any, c: Any) -> Any:
    return sqrt(a * a + b * b) * sin(c) - cos(a + c)


def vectors(a: Any, b: Any, c: Any) -> Any:
    force, arm = a * Vec(1.0, b, c), Vec(c, a, 0.5)
    return ((force ^ arm) + 2.0 * force) @ arm


def arrays(a: Any, b: Any, c: Any) -> Any:
    return (np.array([1.5, -2.0]) + (a - 1.0) * np.array([b, 3.0])).tolist()[1] * c


@pytest.mark.parametrize("function", [arithmetic, roots_and_angles, vectors, arrays])
def test_every_row_is_that_of_the_function(function: Function) -> None:
    cell, filled = worked_out(function)
    assert isinstance(cell, Traced)
    assert filled.holds.all()
    alone = np.array([function(*row) for row in ROWS.tolist()])
    assert filled.of(cell, np.arange(len(ROWS))).tobytes() == alone.tobytes()
    assert cell.value == alone[0]


def branching(a: Any, b: Any, c: Any) -> Any:
    if a < b:
        return max(a, c) + 1.0
    return b if c >= 0.0 and bool(a) else c


def test_rows_hold_where_all_questions_are_answered_alike() -> None:
    """Branches of the first row serve those that take them, and only those."""

    def taken(a: float, b: float, c: float) -> tuple[bool, ...]:
        return (True, c > a) if a < b else (False, c >= 0.0)

    for first in range(10):  # one for each way through
        rows = np.roll(ROWS, -first, axis=0)
        cell, filled = worked_out(branching, rows)
        alike = [taken(*row) == taken(*rows[0].tolist()) for row in rows.tolist()]
        assert filled.holds.tolist() == alike
        alone = np.array([branching(*row) for row in rows[alike].tolist()])
        assert filled.of(cell, np.flatnonzero(alike)).tobytes() == alone.tobytes()


@pytest.mark.parametrize("claim", ["<", "<=", ">", ">=", "==", "!="])
def test_every_question_is_remembered(claim: str) -> None:
    rows = np.array([[1.0, 2.0, 0.0], [2.0, 2.0, 0.0], [3.0, 2.0, 0.0]])
    for first in range(3):
        turned = np.roll(rows, -first, axis=0)
        _, filled = worked_out(lambda a, b, c: eval(f"a {claim} b"), turned)
        answers = [eval(f"{a} {claim} {b}") for a, b, _ in turned.tolist()]
        assert filled.holds.tolist() == [answer == answers[0] for answer in answers]


def test_rows_that_python_would_refuse_do_not_hold() -> None:
    rows = np.array([[1.0, 4.0, 0.0], [0.0, 4.0, 0.0], [1.0, -4.0, 0.0], [2.0, 9.0, 0.0]])
    cell, filled = worked_out(lambda a, b, c: sqrt(b) / a, rows)
    assert filled.holds.tolist() == [True, False, False, True]
    assert filled.of(cell, [0, 3]).tolist() == [2.0, 1.5]


@pytest.mark.parametrize(
    "asks_more",
    [
        math.sin, math.floor, float, int, hash, round, np.sqrt, lambda x: f"{x:g}",
        lambda x: {x: 1}, lambda x: x**2, lambda x: [1, 2][x], lambda x: x.is_integer(),
        lambda x: x + "1", lambda x: x < "1",
    ],
)  # fmt: skip
def test_what_a_cell_does_not_know_it_says(asks_more: Callable[[Any], Any]) -> None:
    """Nothing takes a cell for the number of the first row."""
    cell = Tape(ROWS).first[0]
    with pytest.raises(NO_FORMULA):
        asks_more(cell)


def test_a_number_is_no_word() -> None:
    assert Tape(ROWS).first[0] != "hover"

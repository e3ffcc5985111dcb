"""What was computed with cells is known for every row, by its bits."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from springback.kernels.tracing import (
    NO_FORMULA,
    Tape,
    Traced,
    cos,
    holds,
    hypot,
    sin,
    sqrt,
    traceable,
)
from springback.kernels.vectors import Vec

ROWS = np.random.default_rng(5).normal(size=(50, 3))
Function = Callable[[Any, Any, Any], Any]


def worked_out(function: Function, rows: Any = ROWS) -> tuple[Any, Tape]:
    """What a function returns for traced numbers, and their tape."""
    tape = Tape(rows)
    return function(*tape.first), tape


def column(x: Any, rows: Any) -> Any:
    """Values in some rows."""
    return x.column[rows] if isinstance(x, Traced) else np.full(np.shape(rows), x)


def arithmetic(a: Any, b: Any, c: Any) -> Any:
    return -(a + 2.0) * (3.0 - b) / (c * c + 1.0) - 1.0 / (2.0 + abs(a)) + 0.1 * b - c + a / 7.0


def roots_and_angles(a: Any, b: Any, c: Any) -> Any:
    return sqrt(a * a + b * b) * sin(c) - cos(a + c) + hypot(a, 1.0, b)


def vectors(a: Any, b: Any, c: Any) -> Any:
    force, arm = a * Vec(1.0, b, c), Vec(c, a, 0.5)
    return ((force ^ arm) + 2.0 * force) @ arm


def arrays(a: Any, b: Any, c: Any) -> Any:
    return (np.array([1.5, -2.0]) + (a - 1.0) * np.array([b, 3.0])).tolist()[1] * c


@pytest.mark.parametrize("function", [arithmetic, roots_and_angles, vectors, arrays])
def test_every_row_is_that_of_the_function(function: Function) -> None:
    cell, tape = worked_out(function)
    assert isinstance(cell, Traced)
    assert tape.holds.all()
    alone = np.array([function(*row) for row in ROWS.tolist()])
    assert column(cell, np.arange(len(ROWS))).tobytes() == alone.tobytes()
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
        cell, tape = worked_out(branching, rows)
        alike = [taken(*row) == taken(*rows[0].tolist()) for row in rows.tolist()]
        assert tape.holds.tolist() == alike
        alone = np.array([branching(*row) for row in rows[alike].tolist()])
        assert column(cell, np.flatnonzero(alike)).tobytes() == alone.tobytes()


@pytest.mark.parametrize("claim", ["<", "<=", ">", ">=", "==", "!="])
def test_every_question_is_remembered(claim: str) -> None:
    rows = np.array([[1.0, 2.0, 0.0], [2.0, 2.0, 0.0], [3.0, 2.0, 0.0]])
    for first in range(3):
        turned = np.roll(rows, -first, axis=0)
        _, tape = worked_out(lambda a, b, c: eval(f"a {claim} b"), turned)
        answers = [eval(f"{a} {claim} {b}") for a, b, _ in turned.tolist()]
        assert tape.holds.tolist() == [answer == answers[0] for answer in answers]


def test_rows_that_python_would_refuse_do_not_hold() -> None:
    rows = np.array([[1.0, 4.0, 0.0], [0.0, 4.0, 0.0], [1.0, -4.0, 0.0], [2.0, 9.0, 0.0]])
    cell, tape = worked_out(lambda a, b, c: sqrt(b) / a, rows)
    assert tape.holds.tolist() == [True, False, False, True]
    assert column(cell, [0, 3]).tolist() == [2.0, 1.5]


def test_a_claim_is_one_question() -> None:
    """Rows that hold for different reasons hold together."""
    rows = np.array([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.5, 0.0, 0.0], [math.nan, 0.0, 0.0]])

    def claim(x: Any) -> Any:
        return (x == 0.0) | (x >= 1.0)

    for first, wanted in ((0, True), (2, False)):
        turned = np.roll(rows, -first, axis=0)
        answer, tape = worked_out(lambda a, b, c: holds(claim, a), turned)
        assert answer == wanted
        assert tape.holds.tolist() == [True, True, False, False]
    assert [holds(claim, x) for x in (0.0, 2.0, 0.5, math.nan)] == [True, True, False, False]


@traceable
def searched(start: Vec, unit: str, more: tuple[float, ...]) -> Any:
    """Something that is no formula, of trees."""
    if start.x < -2.0:
        raise ValueError(unit)
    count = round(abs(start.x) * 10.0) % 3
    return (Vec(start.y, *more), (start.x,)) if count else (start, ())


def test_what_is_no_formula_is_called_for_every_row() -> None:
    """Trees go in and come out; rows that end otherwise than the first do not hold."""
    rows = np.concatenate([ROWS, [[-3.0, 1.0, 1.0]]])
    for first in range(4):
        turned = np.roll(rows, -first, axis=0)
        tree, tape = worked_out(lambda a, b, c: searched(Vec(a, b, 2.0), "m", (c, 1.0)), turned)
        alone = [
            searched(Vec(a, b, 2.0), "m", (c, 1.0)) if a >= -2.0 else None
            for a, b, c in turned.tolist()
        ]
        alike = [one is not None and len(one[1]) == len(alone[0][1]) for one in alone]
        assert tape.holds.tolist() == alike
        assert not all(alike)
        for k in np.flatnonzero(alike).tolist():
            vector, rest = tree
            assert type(vector) is Vec
            assert tuple(column(x, k) for x in vector) == alone[k][0]
            assert tuple(column(x, k) for x in rest) == alone[k][1]


def test_what_is_no_float_must_be_as_in_the_first_row() -> None:
    """Texts and whole numbers are not traced; constants are plain numbers."""

    def rounded(x: float) -> Any:
        return f"{x:.0f}", math.floor(x), x.is_integer(), 2.5

    rows = np.array([[1.2], [1.3], [2.2], [0.8]])
    tape = Tape(rows)
    assert traceable(rounded)(*tape.first) == ("1", 1, False, 2.5)
    assert tape.holds.tolist() == [True, True, False, False]
    with pytest.raises(TypeError, match="not given"):
        traceable(lambda x: (math.floor(x), tape.first[0]))(tape.first[0])
    with pytest.raises(TypeError):  # a mistake is not hidden
        traceable(lambda x: x + "text")(1.0)


def test_a_number_of_numbers_is_that_of_each_row() -> None:
    """Rows in which the function raises, or gives no number, do not hold."""

    def root(x: float, least: float) -> Any:
        return math.sqrt(x) if x < 4.0 else int(least)

    tape = Tape(np.array([[1.0], [2.25], [-1.0], [9.0], [1.0]]))
    found = traceable(root)(tape.first[0], 0.5) * 1.0
    assert tape.holds.tolist() == [True, True, False, False, True]
    assert found.column[tape.holds].tolist() == [1.0, 1.5, 1.0]
    assert traceable(lambda x: math.copysign(2.0, x * x))(tape.first[0]) == 2.0
    assert not isinstance(traceable(lambda x: math.floor(x * 0.0) + 2.0)(tape.first[0]), Traced)


def test_rows_that_do_not_hold_are_not_searched() -> None:
    asked: list[float] = []

    def search(x: float) -> float:
        asked.append(math.floor(x) + 0.0)
        return x

    tape = Tape(np.array([[1.0], [-1.0], [2.0]]))
    assert tape.first[0] > 0.0
    traceable(search)(tape.first[0])
    assert set(asked) == {1.0, 2.0}


@pytest.mark.parametrize("function", [arithmetic, roots_and_angles, vectors])
def test_other_rows_replayed_are_those_of_the_function(function: Function) -> None:
    cell, tape = worked_out(function)
    others = np.random.default_rng(6).normal(size=(7, 3))
    columns, holds = tape.replay(others)
    again = [function(*row) for row in others.tolist()]
    assert holds.all()
    assert columns[cell.number].tolist() == again


def test_rows_replayed_hold_that_take_the_same_branches() -> None:
    """A comparison, a division by zero, and a function that raises or returns another kind."""

    def branched(a: Any, b: Any) -> Any:
        found = a / b if a > 1.0 else a * b
        return found + traceable(lambda x: math.sqrt(x) if x < 9.0 else round(x))(b)

    tape = Tape(np.array([[2.0, 1.0], [3.0, 4.0]]))
    cell = branched(*tape.first)
    rows = np.array([[5.0, 4.0], [0.5, 4.0], [5.0, 0.0], [5.0, -1.0], [5.0, 16.0], [1.5, 1.0]])
    columns, holds = tape.replay(rows)
    assert holds.tolist() == [True, False, False, False, False, True]
    assert columns[cell.number][holds].tolist() == [branched(5.0, 4.0), branched(1.5, 1.0)]


def test_a_number_that_all_first_rows_share_must_be_shared_by_others() -> None:
    """What did not differ is a constant of what follows."""
    tape = Tape(np.array([[1.0], [2.0]]))
    assert traceable(lambda x: math.copysign(2.0, x))(tape.first[0]) == 2.0
    assert tape.replay(np.array([[3.0], [-3.0]])).holds.tolist() == [True, False]


def test_what_is_done_twice_is_recorded_once() -> None:
    """But −0 is not 0: x + 0 differs from x + (−0) where x is −0."""
    tape = Tape(np.array([[1.0], [-0.0]]))
    [x] = tape.first
    assert x + 1.0 is x + 1.0
    assert math.copysign(1.0, (x + 0.0).column[1]) == 1.0
    assert math.copysign(1.0, (x + -0.0).column[1]) == -1.0


@pytest.mark.parametrize(
    "asks_more",
    [
        math.sin, math.floor, float, int, hash, round, np.sqrt, lambda x: f"{x:g}",
        lambda x: {x: 1}, lambda x: x**2, lambda x: [1, 2][x], lambda x: x.is_integer(),
        lambda x: x + "1", lambda x: x < "1", math.hypot,
    ],
)  # fmt: skip
def test_what_a_cell_does_not_know_it_says(asks_more: Callable[[Any], Any]) -> None:
    """Nothing takes a cell for the number of the first row."""
    cell = Tape(ROWS).first[0]
    with pytest.raises(NO_FORMULA):
        asks_more(cell)


def test_a_number_is_no_word() -> None:
    assert Tape(ROWS).first[0] != "hover"

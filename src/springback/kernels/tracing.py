"""Tracing scalars: run a plain-Python function once, then evaluate it for many rows of numbers.

A `Traced` number replaces a float.  It computes as a float does, with the value of the first row,
and with those of all rows beside it; so any function in plain Python accepts traced numbers.  Where
the function compares two numbers, it gets the answer of the first row, and the tape notes which
rows give the same: the results hold for these.  Functions that are no formulas, such as
sines and searches, are marked `traceable`, and called for every row.

Every row gets the bits that the function would return for it, as the columns are computed by the
operations of IEEE 754, one by one, or by the standard library's own functions.

A tape also keeps what was done, and does it again for other rows, without the function
(`Tape.replay`).
"""

from __future__ import annotations

import contextlib
import functools
import math
import operator
import struct
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple, TypeVar

import numpy as np

from springback.settings import Settings

R = TypeVar("R")
Column = np.ndarray[Any, np.dtype[np.float64]]
#: Exceptions of a plain-Python function that asks more of traced numbers than they support: their
#: hash, say, their text or bits.
NO_FORMULA = (TypeError, AttributeError, struct.error)
_NODES = (tuple, list)


class ReplayedRows(NamedTuple):
    """Other rows of a tape."""

    columns: list[Column]
    """Values of all its numbers, by `Traced.number`."""
    holds: Any
    """True for rows that give the answers of the tape's first row."""


class _Step(NamedTuple):
    """What is done with columns."""

    many: Callable[..., Any]
    """An operation or a comparison; without operands, takes all columns so far, and which hold."""
    operands: tuple[tuple[int | None, float], ...] | None = None
    outcome: bool | None = None
    """Of a comparison, in the first row."""


class Tape:
    """Rows of numbers on which a function is traced."""

    def __init__(self, rows: Column) -> None:
        """Start a tape for rows, shape (rows, columns)."""
        self.holds = np.ones(len(rows), dtype=bool)
        """True for rows that give the first row's answers; the others' values are undefined."""
        self.columns: list[Column] = []
        """Values of all numbers, by `Traced.number`."""
        self._steps: list[_Step] = []
        self._known: dict[Any, Any] = {}
        self.first = [
            self.cell(column, value) for column, value in zip(rows.T, rows[0].tolist(), strict=True)
        ]
        """Cells for the numbers of the first row."""

    def cell(self, column: Column, value: float) -> Traced:
        """A number with its values in all rows, and in the first."""
        self.columns.append(column)
        return Traced(self, column, value, len(self.columns) - 1)

    def record(self, many: Callable[..., Any], value: float, *operands: Any) -> Traced:
        """Result of an operation on columns, with its value in the first row."""
        taken = _operands(operands)
        key = many, taken, tuple(math.copysign(1.0, x) for _, x in taken)  # −0 is not 0
        if key not in self._known:
            self._steps.append(_Step(many, taken))
            self._known[key] = self.cell(self._evaluate(many, operands), value)
        result: Traced = self._known[key]
        return result

    def guard(self, many: Callable[..., Any], outcome: bool, *operands: Any) -> bool:
        """Record a comparison; returns its result in the first row."""
        step = _Step(many, _operands(operands), outcome)
        if step not in self._known:
            self._known[step] = outcome
            self._steps.append(step)
            self.holds &= self._evaluate(many, operands) == outcome
        return outcome

    def record_rows(
        self, compute: Callable[[list[list[float]], Any], Column], given: list[Traced], first: Any
    ) -> list[Any]:
        """Floats that a function gives for each row that holds: cells where rows differ.

        Args:
            compute: Takes the values of numbers, each for all rows, and which rows hold, which it
                updates; returns floats, shape (rows, floats).
            given: The numbers.
            first: The floats of the first row.
        """
        block = compute([x.column.tolist() for x in given], self.holds)
        alike, places = _same_bits(block, block[:1]).all(axis=0), [x.number for x in given]
        moving = np.flatnonzero(~alike)

        def again(columns: list[Column], holds: Any) -> None:
            found = compute([columns[k].tolist() for k in places], holds)
            holds &= _same_bits(found, block[:1])[:, alike].all(axis=1)
            columns.extend(found[:, k] for k in moving)

        self._steps.append(_Step(again))
        return [x if same else self.cell(block[:, k], x)
                for k, (x, same) in enumerate(zip(first, alike.tolist(), strict=True))]  # fmt: skip

    def replay(self, rows: Column) -> ReplayedRows:
        """Do for other rows what was recorded for those of the tape.

        Args:
            rows: Shape (rows, columns).
        """
        columns, holds = [*rows.T], np.ones(len(rows), dtype=bool)
        with np.errstate(all="ignore"):
            for many, operands, outcome in self._steps:
                if operands is None:
                    many(columns, holds)
                    continue
                found = many(*[x if k is None else columns[k] for k, x in operands])
                if outcome is None:
                    columns.append(found)
                else:
                    holds &= found == outcome
        return ReplayedRows(columns, holds)

    def _evaluate(self, many: Callable[..., Any], operands: tuple[Any, ...]) -> Any:
        with np.errstate(all="ignore"):  # rows for which the comparisons differ may overflow
            return many(*(x.column if isinstance(x, Traced) else x for x in operands))


def _operands(given: tuple[Any, ...]) -> tuple[tuple[int | None, float], ...]:
    """Operands of an operation: those that are traced by their numbers, others by their values."""
    return tuple((x.number, 0.0) if isinstance(x, Traced) else (None, x) for x in given)


def _same_bits(a: Column, b: Column) -> Any:
    """Where two arrays have the same bits: −0 is not 0."""
    return np.ascontiguousarray(a).view(np.int64) == np.ascontiguousarray(b).view(np.int64)


class Traced:
    """A traced number."""

    __slots__ = ("column", "number", "tape", "value")

    def __init__(self, tape: Tape, column: Column, value: float, number: int) -> None:
        """Number with its values in all rows of a tape, and in the first, and its place there."""
        self.tape, self.column, self.value, self.number = tape, column, value, number

    def _with(
        self, other: Any, many: Callable[..., Any], one: Callable[..., Any], turned: bool = False
    ) -> Any:
        if not isinstance(other, Traced | float | int):
            return NotImplemented
        a, b = (other, self) if turned else (self, other)
        return self.tape.record(many, one(_value(a), _value(b)), a, b)

    def __add__(self, other: Any) -> Any:
        return self._with(other, np.add, operator.add)

    def __radd__(self, other: Any) -> Any:
        return self._with(other, np.add, operator.add, True)

    def __sub__(self, other: Any) -> Any:
        return self._with(other, np.subtract, operator.sub)

    def __rsub__(self, other: Any) -> Any:
        return self._with(other, np.subtract, operator.sub, True)

    def __mul__(self, other: Any) -> Any:
        return self._with(other, np.multiply, operator.mul)

    def __rmul__(self, other: Any) -> Any:
        return self._with(other, np.multiply, operator.mul, True)

    def __truediv__(self, other: Any) -> Any:
        return self._divide(self, other)

    def __rtruediv__(self, other: Any) -> Any:
        return self._divide(other, self)

    def _divide(self, a: Any, b: Any) -> Any:
        if not (isinstance(a, Traced | float | int) and isinstance(b, Traced | float | int)):
            return NotImplemented
        quotient = _value(a) / _value(b)
        self.tape.guard(np.not_equal, True, b, 0.0)  # Python raises on division by zero
        return self.tape.record(np.divide, quotient, a, b)

    def __neg__(self) -> Traced:
        return self.tape.record(np.negative, -self.value, self)

    def __abs__(self) -> Traced:
        return self.tape.record(np.absolute, abs(self.value), self)

    def _compare(self, other: Any, many: Callable[..., Any], one: Callable[..., Any]) -> Any:
        if not isinstance(other, Traced | float | int):
            return NotImplemented
        return self.tape.guard(many, bool(one(self.value, _value(other))), self, other)

    def __lt__(self, other: Any) -> Any:
        return self._compare(other, np.less, operator.lt)

    def __le__(self, other: Any) -> Any:
        return self._compare(other, np.less_equal, operator.le)

    def __gt__(self, other: Any) -> Any:
        return self._compare(other, np.greater, operator.gt)

    def __ge__(self, other: Any) -> Any:
        return self._compare(other, np.greater_equal, operator.ge)

    def __eq__(self, other: object) -> Any:
        return self._compare(other, np.equal, operator.eq)

    def __ne__(self, other: object) -> Any:
        return self._compare(other, np.not_equal, operator.ne)

    __hash__ = None  # type: ignore[assignment]  # a hash cannot be traced

    def __bool__(self) -> bool:
        return self.tape.guard(np.not_equal, self.value != 0.0, self, 0.0)


def _value(x: Any) -> Any:
    return x.value if isinstance(x, Traced) else x


def holds(claim: Callable[[Any], Any], x: Any) -> bool:
    """``claim(x)`` of a float or a traced number, recorded as one comparison, without branches.

    The claim is of operators, ``&`` and ``|``, and takes columns, too.
    """
    if not isinstance(x, Traced):
        return bool(claim(x))
    return x.tape.guard(claim, bool(claim(x.value)), x)


def traceable(function: Callable[..., R]) -> Callable[..., R]:
    """The same function; where it is no formula of traced numbers, the tape calls it for every row.

    Traced numbers may be anywhere in lists, tuples and settings.  The floats of the result, a tree,
    are traced then.  Rows for which the function raises a `ValueError`, or for which the result
    differs in more than floats from that of the first, do not hold.
    """

    @functools.wraps(function)
    def accepting(*given: Any) -> R:
        try:
            return function(*given)
        except NO_FORMULA:
            traced = [x for x in _leaves(given) if isinstance(x, Traced)]
            if not traced:
                raise
            result: R = _by_row(function, given, traced)
            return result

    return accepting


def _by_row(function: Callable[..., R], given: Any, traced: list[Traced]) -> Any:
    """Result of a function of traced numbers, called for every row that holds."""
    fill, tape = _filler(given), traced[0].tape
    first = function(*fill(iter([x.value for x in traced])))
    if type(first) is float and all(isinstance(x, Traced | float) for x in given):
        return _number_by_row(function, given, tape, first)
    floats, rest = _sorted_leaves(first)
    if any(isinstance(x, Traced) for x in rest):
        raise TypeError(f"{function.__name__} knows traced numbers that it was not given")

    def compute(columns: list[list[float]], holds: Any) -> Column:
        block, known = np.tile(floats, (len(holds), 1)), np.zeros(len(holds), dtype=bool)
        for k, row in enumerate(zip(*columns, strict=True)):
            with contextlib.suppress(ValueError, ArithmeticError):
                found = _sorted_leaves(function(*fill(iter(row)))) if holds[k] else ([], [])
                if found[1] == rest:
                    block[k], known[k] = found[0], True
        holds &= known
        return block

    return _filler(first, float)(iter(tape.record_rows(compute, traced, floats)))


def _number_by_row(function: Callable[..., Any], given: Any, tape: Tape, first: Any) -> Any:
    """The same where all that is given, and the result, are numbers, as for a sine."""
    moving = [isinstance(x, Traced) for x in given]

    def compute(columns: list[list[float]], holds: Any) -> Column:
        found, known = np.full((len(holds), 1), first), np.zeros(len(holds), dtype=bool)
        each = iter(columns)
        asked = (next(each) if m else [x] * len(found) for x, m in zip(given, moving, strict=True))
        for k, row in enumerate(zip(*asked, strict=True)):
            with contextlib.suppress(ValueError, ArithmeticError):
                one = function(*row) if holds[k] else None
                if type(one) is float:
                    found[k], known[k] = one, True
        holds &= known
        return found

    [result] = tape.record_rows(compute, [x for x in given if isinstance(x, Traced)], [first])
    return result


def _sorted_leaves(tree: Any) -> tuple[list[float], list[Any]]:
    """Floats of a tree, in order, and the rest: types, and leaves that are no floats."""
    floats: list[float] = []
    rest: list[Any] = []

    def gather(tree: tuple[Any, ...]) -> None:
        rest.append(type(tree))
        for branch in tree:
            if isinstance(branch, tuple):
                gather(branch)
            elif type(branch) is float:
                floats.append(branch)
                rest.append(float)
            else:
                rest.append(branch)

    gather((tree,))
    return floats, rest


def _leaves(tree: Any) -> list[Any]:
    """Whatever is in a tree, in order."""
    if isinstance(tree, Settings):
        tree = tuple(tree.__dict__.values())
    return [x for part in tree for x in _leaves(part)] if isinstance(tree, _NODES) else [tree]


def _filler(tree: Any, kind: type = Traced) -> Callable[[Iterator[Any]], Any]:
    """Function that returns a tree with others in place of its leaves of a kind, in order."""
    if not any(type(x) is kind for x in _leaves(tree)):
        return lambda others: tree
    if isinstance(tree, Settings):
        keys = {key: _filler(part, kind) for key, part in tree.__dict__.items()}
        return lambda others: tree.with_checked(**{k: fill(others) for k, fill in keys.items()})
    if isinstance(tree, _NODES):
        parts = [_filler(part, kind) for part in tree]
        make: Any = tree._make if hasattr(tree, "_make") else type(tree)
        return lambda others: make([fill(others) for fill in parts])
    return next


def sqrt(x: Any) -> Any:
    """√x of a float or a traced number."""
    if not isinstance(x, Traced):
        return math.sqrt(x)
    root = math.sqrt(x.value)
    x.tape.guard(np.greater_equal, True, x, 0.0)
    return x.tape.record(np.sqrt, root, x)


#: Sine, cosine [rad] and length of floats or traced numbers: NumPy may round differently from the
#: standard library.
sin, cos, hypot = traceable(math.sin), traceable(math.cos), traceable(math.hypot)

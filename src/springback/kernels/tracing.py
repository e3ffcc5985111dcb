"""Tracing scalars: run a plain-Python function once, then evaluate it for many rows of numbers.

A `Traced` number replaces a float.  It computes as a float does, with the value of the first row,
and its tape records the formula; so any function in plain Python accepts traced numbers.  Where the
function compares two numbers, it gets the answer of the first row, and the tape records that too:
the formulas hold for the rows that give the same answers.

Every row gets the bits that the function would return for it, as the formulas are evaluated by the
operations of IEEE 754, one by one, or by the standard library's own functions.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

Column = np.ndarray[Any, np.dtype[np.float64]]
#: Exceptions of a plain-Python function that asks more of traced numbers than they support: their
#: hash, say, or their text.
NO_FORMULA = (TypeError, AttributeError)


class Step(NamedTuple):
    """One recorded operation."""

    many: Callable[..., Any]  # the same on columns
    operands: tuple[Any, ...]  # traced numbers, or floats
    outcome: Any  # result of a comparison in the first row; None for a formula


class Tape:
    """Rows of numbers, and the operations recorded on them."""

    def __init__(self, rows: Column) -> None:
        """Start a tape for rows, shape (rows, columns)."""
        self._rows = rows
        self._steps: list[Step] = []
        self.first = [Traced(self, k, value) for k, value in enumerate(rows[0].tolist())]
        """Cells for the numbers of the first row."""

    def record(self, many: Callable[..., Any], value: float, *operands: Any) -> Traced:
        """Record an operation; returns the traced result, with its value in the first row."""
        self._steps.append(Step(many, operands, None))
        return Traced(self, self._rows.shape[1] + len(self._steps) - 1, value)

    def guard(self, many: Callable[..., Any], outcome: bool, *operands: Any) -> bool:
        """Record a comparison; returns its result in the first row."""
        self._steps.append(Step(many, operands, outcome))
        return outcome

    def evaluate(self) -> Evaluated:
        """Evaluate all formulas for every row."""
        columns: list[Any] = list(self._rows.T)
        holds = np.ones(len(self._rows), dtype=bool)
        with np.errstate(all="ignore"):  # rows for which the comparisons differ may overflow
            for many, operands, outcome in self._steps:
                given = (columns[x.place] if isinstance(x, Traced) else x for x in operands)
                columns.append(many(*given))
                if outcome is not None:
                    holds &= columns[-1] == outcome
        return Evaluated(columns, holds)


class Evaluated(NamedTuple):
    """A tape evaluated for all rows."""

    columns: list[Any]
    holds: Any
    """True for rows that give the first row's answers, shape (rows,); others are undefined."""

    def of(self, x: Any, rows: Any) -> Any:
        """Values in some rows: the column of a traced number, or the float itself."""
        return self.columns[x.place][rows] if isinstance(x, Traced) else x


class Traced:
    """A traced number."""

    __slots__ = ("place", "tape", "value")

    def __init__(self, tape: Tape, place: int, value: float) -> None:
        """Number at a place of a tape, with its value in the first row."""
        self.tape, self.place, self.value = tape, place, value

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


def _by_one(function: Callable[[float], float]) -> Callable[[Column], Column]:
    """The same, number by number: NumPy may round differently from the standard library."""

    def many(column: Column) -> Column:
        return np.array([function(x) for x in column.tolist()])

    return many


_SINES, _COSINES = _by_one(math.sin), _by_one(math.cos)


def sqrt(x: Any) -> Any:
    """√x of a float or a traced number."""
    if not isinstance(x, Traced):
        return math.sqrt(x)
    root = math.sqrt(x.value)
    x.tape.guard(np.greater_equal, True, x, 0.0)
    return x.tape.record(np.sqrt, root, x)


def sin(x: Any) -> Any:
    """Sine of a float or a traced number [rad]."""
    if not isinstance(x, Traced):
        return math.sin(x)
    return x.tape.record(_SINES, math.sin(x.value), x)


def cos(x: Any) -> Any:
    """Cosine of a float or a traced number [rad]."""
    if not isinstance(x, Traced):
        return math.cos(x)
    return x.tape.record(_COSINES, math.cos(x.value), x)

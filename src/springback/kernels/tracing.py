"""Tracing scalars: run a plain-Python function once, then evaluate it for many rows of numbers.

A `Traced` number replaces a float.  It computes as a float does, with the value of the first row,
and its tape records the formula; so any function in plain Python accepts traced numbers.  Where the
function compares two numbers, it gets the answer of the first row, and the tape records that too:
the formulas hold for the rows that give the same answers.  Functions that are no formulas, such as
sines and searches, are marked `by_row`, and called for every row.

Every row gets the bits that the function would return for it, as the formulas are evaluated by the
operations of IEEE 754, one by one, or by the standard library's own functions.
"""

from __future__ import annotations

import functools
import math
import operator
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple, TypeVar

import numpy as np

R = TypeVar("R")
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

    def computed(self, many: Callable[..., Any], value: float, *operands: Any) -> Traced:
        """Record an operation; returns the traced result, with its value in the first row."""
        self._steps.append(Step(many, operands, None))
        return Traced(self, self._rows.shape[1] + len(self._steps) - 1, value)

    def guard(self, many: Callable[..., Any], outcome: bool, *operands: Any) -> bool:
        """Record a comparison; returns its result in the first row."""
        self._steps.append(Step(many, operands, outcome))
        return outcome

    def filled(self) -> Evaluated:
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
        return self.tape.computed(many, one(_value(a), _value(b)), a, b)

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
        return self._divided(self, other)

    def __rtruediv__(self, other: Any) -> Any:
        return self._divided(other, self)

    def _divided(self, a: Any, b: Any) -> Any:
        if not (isinstance(a, Traced | float | int) and isinstance(b, Traced | float | int)):
            return NotImplemented
        quotient = _value(a) / _value(b)
        self.tape.guard(np.not_equal, True, b, 0.0)  # Python raises on division by zero
        return self.tape.computed(np.divide, quotient, a, b)

    def __neg__(self) -> Traced:
        return self.tape.computed(np.negative, -self.value, self)

    def __abs__(self) -> Traced:
        return self.tape.computed(np.absolute, abs(self.value), self)

    def _asked(self, other: Any, many: Callable[..., Any], one: Callable[..., Any]) -> Any:
        if not isinstance(other, Traced | float | int):
            return NotImplemented
        return self.tape.guard(many, bool(one(self.value, _value(other))), self, other)

    def __lt__(self, other: Any) -> Any:
        return self._asked(other, np.less, operator.lt)

    def __le__(self, other: Any) -> Any:
        return self._asked(other, np.less_equal, operator.le)

    def __gt__(self, other: Any) -> Any:
        return self._asked(other, np.greater, operator.gt)

    def __ge__(self, other: Any) -> Any:
        return self._asked(other, np.greater_equal, operator.ge)

    def __eq__(self, other: object) -> Any:
        return self._asked(other, np.equal, operator.eq)

    def __ne__(self, other: object) -> Any:
        return self._asked(other, np.not_equal, operator.ne)

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


def by_row(function: Callable[..., R]) -> Callable[..., R]:
    """The same function, which also accepts traced numbers: the tape calls it for every row.

    Arguments and result are trees.  Rows for which it raises a `ValueError`, or returns a tree of
    other types than for the first, do not hold.
    """

    @functools.wraps(function)
    def accepting(*given: Any) -> R:
        traced = [x for x in _leaves(given) if isinstance(x, Traced)]
        return _called(function, given, traced) if traced else function(*given)

    return accepting


def _called(function: Callable[..., R], given: Any, traced: list[Traced]) -> Any:
    """Result of a function of traced numbers; the tape gets one block for all its numbers."""
    first = function(*_with(given, iter([x.value for x in traced])))
    numbers, kind = _leaves(first), _kind(first)
    if not all(type(x) is float for x in numbers):
        raise TypeError(f"{function.__name__} returns more than numbers")

    def many(*columns: Column) -> Any:
        block = np.full((len(numbers) + 1, len(columns[0])), math.nan)
        for k, row in enumerate(zip(*(column.tolist() for column in columns), strict=True)):
            try:
                result = function(*_with(given, iter(row)))
            except (ValueError, ArithmeticError):
                continue
            if _kind(result) == kind:
                block[:, k] = (*_leaves(result), 1.0)
        return block

    tape = traced[0].tape
    block = tape.computed(many, math.nan, *traced)
    tape.guard(operator.itemgetter(-1), True, block)
    places = enumerate(numbers)
    return _with(
        first,
        (tape.computed(operator.itemgetter(k), x, block) for k, x in places),
        every=True,
    )


def _leaves(tree: Any) -> list[Any]:
    """Whatever is in a tree, in order."""
    return [x for branch in tree for x in _leaves(branch)] if isinstance(tree, tuple) else [tree]


def _kind(tree: Any) -> Any:
    """Types in a tree."""
    return (type(tree), *map(_kind, tree)) if isinstance(tree, tuple) else type(tree)


def _with(tree: Any, numbers: Iterator[Any], every: bool = False) -> Any:
    """A tree with others in place of its traced numbers, or of every number."""
    if isinstance(tree, tuple):
        branches = [_with(branch, numbers, every) for branch in tree]
        return type(tree)(*branches) if hasattr(tree, "_fields") else tuple(branches)
    return next(numbers) if every or isinstance(tree, Traced) else tree


def sqrt(x: Any) -> Any:
    """√x of a float or a traced number."""
    if not isinstance(x, Traced):
        return math.sqrt(x)
    root = math.sqrt(x.value)
    x.tape.guard(np.greater_equal, True, x, 0.0)
    return x.tape.computed(np.sqrt, root, x)


#: Sine, cosine [rad] and length of floats or traced numbers: NumPy may round differently from the
#: standard library.
sin, cos, hypot = by_row(math.sin), by_row(math.cos), by_row(math.hypot)

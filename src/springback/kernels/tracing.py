"""A sheet of cells: what is computed once with cells is known for many rows of numbers.

A cell stands where a float would.  It computes as a float does, with the number of the first row,
and the sheet remembers the formula; so any function in plain Python may be given cells.  Where the
function asks whether something is larger than something else, it gets the answer of the first row,
and the sheet remembers that, too: the formulas hold for the rows that answer alike.

Every row gets the bits that the function would give it, for the formulas are worked out by the
operations of IEEE 754, one by one, or by the standard library's very functions.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

Column = np.ndarray[Any, np.dtype[np.float64]]
#: What a function says, in plain Python, to which cells are given and which asks more of them than
#: they know: their hash, say, or to be written down.
NO_FORMULA = (TypeError, AttributeError)


class Step(NamedTuple):
    """One operation, as it was with the first row."""

    many: Callable[..., Any]  # the same with columns
    operands: tuple[Any, ...]  # cells, or floats
    outcome: Any  # what a claim came to; None of a formula


class Tape:
    """Rows of numbers, and what was computed from them."""

    def __init__(self, rows: Column) -> None:
        """Of rows, shape (rows, columns)."""
        self._rows = rows
        self._steps: list[Step] = []
        self.first = [Traced(self, k, value) for k, value in enumerate(rows[0].tolist())]
        """Cells for the numbers of the first row."""

    def computed(self, many: Callable[..., Any], value: float, *operands: Any) -> Traced:
        """A new cell: an operation, and what it gives with the first row."""
        self._steps.append(Step(many, operands, None))
        return Traced(self, self._rows.shape[1] + len(self._steps) - 1, value)

    def guard(self, many: Callable[..., Any], outcome: bool, *operands: Any) -> bool:
        """What a question came to with the first row."""
        self._steps.append(Step(many, operands, outcome))
        return outcome

    def filled(self) -> Evaluated:
        """All formulas, row by row."""
        columns: list[Any] = list(self._rows.T)
        holds = np.ones(len(self._rows), dtype=bool)
        with np.errstate(all="ignore"):  # rows of which the claims do not hold may do anything
            for many, operands, outcome in self._steps:
                given = (columns[x.place] if isinstance(x, Traced) else x for x in operands)
                columns.append(many(*given))
                if outcome is not None:
                    holds &= columns[-1] == outcome
        return Evaluated(columns, holds)


class Evaluated(NamedTuple):
    """A sheet worked out."""

    columns: list[Any]
    holds: Any
    """Whether a row answers all questions as the first, shape (rows,); else it is unknown."""

    def of(self, x: Any, rows: Any) -> Any:
        """What stands where a float would, in some rows: a column of a cell, or the float."""
        return self.columns[x.place][rows] if isinstance(x, Traced) else x


class Traced:
    """A number on a sheet."""

    __slots__ = ("place", "sheet", "value")

    def __init__(self, sheet: Tape, place: int, value: float) -> None:
        """At a place of a sheet, with the value that it has in the first row."""
        self.sheet, self.place, self.value = sheet, place, value

    def _with(
        self, other: Any, many: Callable[..., Any], one: Callable[..., Any], turned: bool = False
    ) -> Any:
        if not isinstance(other, Traced | float | int):
            return NotImplemented
        a, b = (other, self) if turned else (self, other)
        return self.sheet.computed(many, one(_value(a), _value(b)), a, b)

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
        self.sheet.guard(np.not_equal, True, b, 0.0)  # Python divides nothing by zero
        return self.sheet.computed(np.divide, quotient, a, b)

    def __neg__(self) -> Traced:
        return self.sheet.computed(np.negative, -self.value, self)

    def __abs__(self) -> Traced:
        return self.sheet.computed(np.absolute, abs(self.value), self)

    def _asked(self, other: Any, many: Callable[..., Any], one: Callable[..., Any]) -> Any:
        if not isinstance(other, Traced | float | int):
            return NotImplemented
        return self.sheet.guard(many, bool(one(self.value, _value(other))), self, other)

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

    __hash__ = None  # type: ignore[assignment]  # what is looked up by a number is not computed

    def __bool__(self) -> bool:
        return self.sheet.guard(np.not_equal, self.value != 0.0, self, 0.0)


def _value(x: Any) -> Any:
    return x.value if isinstance(x, Traced) else x


def _by_one(function: Callable[[float], float]) -> Callable[[Column], Column]:
    """The same, number by number: NumPy's own may round otherwise than the standard library's."""

    def many(column: Column) -> Column:
        return np.array([function(x) for x in column.tolist()])

    return many


_SINES, _COSINES = _by_one(math.sin), _by_one(math.cos)


def sqrt(x: Any) -> Any:
    """√x of a float or a cell."""
    if not isinstance(x, Traced):
        return math.sqrt(x)
    root = math.sqrt(x.value)
    x.sheet.guard(np.greater_equal, True, x, 0.0)
    return x.sheet.computed(np.sqrt, root, x)


def sin(x: Any) -> Any:
    """Sine of a float or a cell [rad]."""
    if not isinstance(x, Traced):
        return math.sin(x)
    return x.sheet.computed(_SINES, math.sin(x.value), x)


def cos(x: Any) -> Any:
    """Cosine of a float or a cell [rad]."""
    if not isinstance(x, Traced):
        return math.cos(x)
    return x.sheet.computed(_COSINES, math.cos(x.value), x)

"""Sums of a cubic B-spline in three dimensions, four numbers at a time in a vector register.

The same products and sums in the same order as in plain Python, so the bits are the same.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numba
import numpy as np
from llvmlite import ir
from numba import types

from springback.kernels.compiler import compiler_rule, kernel
from springback.kernels.routines import Numbers, number_at, number_pointer, numbers_of

_intrinsic: Any = numba.extending.intrinsic
_tuple_of: Any = types.UniTuple
_DOUBLE = ir.DoubleType()
_FOUR = ir.VectorType(_DOUBLE, 4)


class Four(NamedTuple):
    """Four numbers side by side: weights, coefficients or sums."""

    a: float
    b: float
    c: float
    d: float


class SplineSums(NamedTuple):
    """Four neighbours along z, blended along x and y."""

    value: Four
    x: Four  # with the slopes along x
    y: Four  # with the slopes along y


@kernel
def four_at(table: float, k: int) -> Four:
    """Four numbers of a table."""
    return Four(
        number_at(table, k),
        number_at(table, k + 1),
        number_at(table, k + 2),
        number_at(table, k + 3),
    )


@kernel
def blend(w: Four, p: Four, q: Four, r: Four, s: Four) -> Four:
    """Sum of four quadruples with weights."""
    return Four(
        w.a * p.a + w.b * q.a + w.c * r.a + w.d * s.a,
        w.a * p.b + w.b * q.b + w.c * r.b + w.d * s.b,
        w.a * p.c + w.b * q.c + w.c * r.c + w.d * s.c,
        w.a * p.d + w.b * q.d + w.c * r.d + w.d * s.d,
    )


def _sum_of_rows(w: Four, rows: Numbers) -> Numbers:
    """Sum of four rows with weights."""
    return np.asarray(w.a * rows[0] + w.b * rows[1] + w.c * rows[2] + w.d * rows[3])


def spline_sums(
    table: float, k: int, line: int, page: int, wx: Four, wy: Four, sx: Four, sy: Four
) -> SplineSums:
    """Sixteen lines of four coefficients, blended.

    Args:
        table: Address of the numbers.
        k: Place of the first coefficient.
        line: From one line to the next, along y.
        page: From one to the next along x.
        wx: Weights along x.
        wy: Weights along y.
        sx: Slopes of the weights along x.
        sy: Slopes of the weights along y.
    """
    numbers = numbers_of(table)
    strides = tuple(numbers.itemsize * step for step in (page, line, 1))
    cube = np.ndarray((4, 4, 4), numbers.dtype, numbers, k * numbers.itemsize, strides)
    along_y = cube.swapaxes(0, 1)
    values, slopes = _sum_of_rows(wy, along_y), _sum_of_rows(sy, along_y)
    sums = _sum_of_rows(wx, values), _sum_of_rows(sx, values), _sum_of_rows(wx, slopes)
    value, x, y = (Four(*one.tolist()) for one in sums)
    return SplineSums(value, x, y)


@_intrinsic  # type: ignore[untyped-decorator]
def _sums(
    typing_context: Any,
    table: Any,
    k: Any,
    line: Any,
    page: Any,
    wx: Any,
    wy: Any,
    sx: Any,
    sy: Any,
) -> Any:
    result = _tuple_of(types.float64, 12)

    def lower(context: Any, builder: Any, signature: Any, given: Any) -> Any:
        address, first, per_line, per_page, *weights = given

        def splat(value: Any) -> Any:
            one = builder.insert_element(ir.Constant(_FOUR, ir.Undefined), value, _index(0))
            zeros = ir.Constant(ir.VectorType(ir.IntType(32), 4), [0, 0, 0, 0])
            return builder.shuffle_vector(one, ir.Constant(_FOUR, ir.Undefined), zeros)

        wide = [[splat(builder.extract_value(w, j)) for j in range(4)] for w in weights]

        def blended(w: Any, rows: Any) -> Any:
            total = builder.fmul(w[0], rows[0])
            for j in (1, 2, 3):
                total = builder.fadd(total, builder.fmul(w[j], rows[j]))
            return total

        values, slopes = [], []
        for i in range(4):
            rows = []
            for j in range(4):
                place = builder.add(first, builder.mul(_whole(i), per_page))
                place = builder.add(place, builder.mul(_whole(j), per_line))
                pointer = number_pointer(context, builder, address, place)
                vector = builder.bitcast(pointer, _FOUR.as_pointer())
                rows.append(builder.load(vector, align=8))
            values.append(blended(wide[1], rows))
            slopes.append(blended(wide[3], rows))
        found = [blended(wide[0], values), blended(wide[2], values), blended(wide[0], slopes)]
        numbers = [builder.extract_element(v, _index(j)) for v in found for j in range(4)]
        return context.make_tuple(builder, result, numbers)

    return result(types.float64, types.int64, types.int64, types.int64, wx, wy, sx, sy), lower


def _index(j: int) -> Any:
    return ir.Constant(ir.IntType(32), j)


def _whole(j: int) -> Any:
    return ir.Constant(ir.IntType(64), j)


@compiler_rule(spline_sums)
def _spline_sums(
    table: Any, k: Any, line: Any, page: Any, wx: Any, wy: Any, sx: Any, sy: Any
) -> Any:
    def compiled(
        table: Any, k: Any, line: Any, page: Any, wx: Any, wy: Any, sx: Any, sy: Any
    ) -> Any:
        n = _sums(table, k, line, page, wx, wy, sx, sy)
        return SplineSums(
            Four(n[0], n[1], n[2], n[3]), Four(n[4], n[5], n[6], n[7]),
            Four(n[8], n[9], n[10], n[11]),
        )  # fmt: skip

    return compiled

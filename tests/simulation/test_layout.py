"""Trees in buffers: the same places in plain Python and compiled."""

from typing import NamedTuple

import numba
import numpy as np

from springback.kernels.layout import TreeLayout, read, row_of, rows, write
from springback.kernels.vectors import Quat, Vec


class Inner(NamedTuple):
    turn: Quat
    pair: tuple[float, float]


class Outer(NamedTuple):
    first: Vec
    number: float
    inner: Inner


TREE = Outer(Vec(1.0, 2.0, 3.0), 4.0, Inner(Quat(5.0, 6.0, 7.0, 8.0), (9.0, 10.0)))


def moved(like, source, target, width):
    """Read a part of every lane, and write it elsewhere, doubled."""
    at = row_of(like, "inner")
    for lane in range(width):
        inner = read(like.inner, source, at, width, lane)
        a, b = inner.pair
        write(Inner(inner.turn, (2.0 * a, 2.0 * b)), target, 1, width, lane)
        target[lane] = float(rows(like)) + 100.0 * row_of(like.inner, "pair")


def test_plain_and_compiled_reach_the_same_places() -> None:
    width = 3
    source = np.arange(10.0 * width)
    plain, packed = np.zeros(8 * width), np.zeros(8 * width)
    moved(TreeLayout(TREE), source, plain, width)
    numba.njit(numba.njit(moved).py_func)(TreeLayout(TREE), source, packed, width)
    np.testing.assert_array_equal(plain, packed)
    assert plain[0] == 10.0 + 400.0
    rows_of_lane_1 = plain.reshape(8, width)[1:7, 1]
    np.testing.assert_array_equal(rows_of_lane_1, [13.0, 16.0, 19.0, 22.0, 50.0, 56.0])


def test_rows_count_leaves() -> None:
    assert (rows(TREE), rows(TreeLayout(TREE).inner), row_of(TREE, "inner")) == (10, 6, 4)
    back = np.zeros(10)
    write(TREE, back, 0, 1, 0)
    assert read(TreeLayout(TREE), back, 0, 1, 0) == TREE

"""Trees in buffers: places that are known by name."""

from typing import NamedTuple

import numba
import numpy as np
import pytest

from springback.kernels.compiler import generic, kernel
from springback.kernels.layout import TreeLayout, load, read, store, write, zeros
from springback.kernels.vectors import Vec


class Inner(NamedTuple):
    place: Vec
    tree: float  # a name that a Like has no use for itself


class Outer(NamedTuple):
    first: tuple[float, ...]
    inner: Inner


TREE = Outer((1.0, 2.0), Inner(Vec(3.0, 4.0, 5.0), 6.0))


def test_a_like_knows_where_its_branches_lie() -> None:
    like, buffer = TreeLayout(TREE), np.arange(6.0 * 2)
    assert load(like.inner.place, buffer, 2, 1) == Vec(5.0, 7.0, 9.0)
    assert load(like.inner.tree, buffer, 2, 0) == 10.0
    store(Vec(0.1, 0.2, 0.3), like.inner.place, buffer, 2, 0)
    assert buffer.tolist() == [0, 1, 2, 3, 0.1, 5, 0.2, 7, 0.3, 9, 10, 11]


def test_the_same_when_compiled() -> None:
    @numba.njit
    def moved(like: TreeLayout, buffer: np.ndarray) -> float:
        place = load(like.inner.place, buffer, 2, 1)
        store(place * 2.0, like.inner.place, buffer, 2, 1)
        return load(like.inner.tree, buffer, 2, 1)

    buffer = np.arange(12.0)
    assert moved(TreeLayout(TREE), buffer) == 11.0
    assert buffer[5::2].tolist() == [10.0, 14.0, 18.0, 11.0]


@pytest.mark.parametrize(("width", "lane"), [(1, 0), (3, 0), (3, 2)])
def test_a_tree_at_a_row_is_read_and_written_alike_compiled_and_not(width: int, lane: int) -> None:
    def moved(like: TreeLayout, buffer: np.ndarray, row: int, width: int, lane: int) -> None:
        write(read(like, buffer, row, width, lane), buffer, row + 7, width, lane)

    plain = np.arange(16.0 * width)
    compiled = plain.copy()
    moved(TreeLayout(TREE), plain, 2, width, lane)
    numba.njit(moved)(TreeLayout(TREE), compiled, 2, width, lane)
    assert plain.tolist() == compiled.tolist()
    assert (
        plain[9 * width + lane :: width][:6].tolist()
        == plain[2 * width + lane :: width][:6].tolist()
    )


@generic
def spoken(who: TreeLayout) -> float:
    raise TypeError


def speaker(word: float) -> type:
    """A class that is called Speaker, and says a word of its own."""

    class Speaker(NamedTuple):
        unused: float

    @spoken.register(Speaker)
    @kernel
    def _(who: TreeLayout) -> float:
        return word

    return Speaker


def test_namesakes_are_not_taken_for_one_another() -> None:
    one, other = speaker(1.0), speaker(2.0)

    @numba.njit
    def asked(who: TreeLayout) -> float:
        return spoken(who)

    assert [asked(TreeLayout(cls(0.0))) for cls in (one, other)] == [1.0, 2.0]
    assert [spoken(TreeLayout(cls(0.0))) for cls in (one, other)] == [1.0, 2.0]


def test_rows_are_known_to_lie_apart() -> None:
    """The compiler packs a loop over lanes without asking first whether rows overlap."""

    @numba.njit(error_model="numpy")
    def turned(like: TreeLayout, one: np.ndarray, other: np.ndarray, ones: np.ndarray) -> None:
        for i in range(8 * ones.shape[0]):
            place = load(like.inner.place, one, 8, i)
            store(place @ place, like.inner.tree, other, 8, i)

    one, other = np.arange(6.0 * 8), np.zeros(6 * 8)
    turned(TreeLayout(TREE), one, other, np.ones(1))
    assert other[5 * 8 + 1] == 17.0**2 + 25.0**2 + 33.0**2
    (code,) = turned.inspect_llvm().values()
    assert "vector.body" in code
    assert "memcheck" not in code


@pytest.mark.parametrize("shape", [(3,), (5, 7), (2, 3, 8)])
def test_zeros_begin_a_line_of_the_cache(shape: tuple[int, ...]) -> None:
    kept = [zeros(*shape) for _ in range(20)]  # so that each lies elsewhere
    for buffer in kept:
        assert buffer.shape == shape
        assert not buffer.any()
        assert buffer.ctypes.data % 64 == 0

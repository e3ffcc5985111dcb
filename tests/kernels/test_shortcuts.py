"""Steps of the compiler in fewer steps: what else a program compiles with it is compiled as before."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from typing import Any

import numba
import pytest
from numba.core.errors import TypingError

import springback.kernels.compiler  # noqa: F401  # takes the place of numba's steps


def test_an_operator_without_a_rule_says_which_types_it_was_given() -> None:
    @numba.njit
    def wrong(x: Any) -> Any:
        return x + "a"

    with pytest.raises(TypingError, match=r"(?s)No implementation of function.*add.*float64"):
        wrong(1.0)


def test_linear_algebra_is_loaded_when_code_calls_it() -> None:
    """Not to compile the first kernel, as by numba itself: that takes a tenth of a second."""
    code = (
        "import sys, numba, numpy as np\n"
        "import springback.kernels.compiler\n"
        "assert numba.njit(lambda x: x + 1.0)(1.0) == 2.0\n"
        "assert 'scipy.linalg' not in sys.modules\n"
        "turn = np.array([[0.0, -1.0], [1.0, 0.0]])\n"
        "assert numba.njit(lambda a: a @ a)(turn).tolist() == [[-1.0, 0.0], [0.0, -1.0]]\n"
        "assert 'scipy.linalg' in sys.modules\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_operators_are_those_of_their_types() -> None:
    @numba.njit
    def quotients(x: Any, y: Any) -> Any:
        return x / y, x // y, x**2, -x, x < y

    assert quotients(7, 2) == (3.5, 3, 49, -7, False)
    assert quotients(7.0, 2.0) == (3.5, 3.0, 49.0, -7.0, False)
    assert [type(one) for one in quotients(7, 2)] == [float, int, int, int, bool]


def test_generators_and_objects_keep_what_lives_between_their_blocks() -> None:
    def squares(n: int) -> Iterator[int]:
        last = 0
        for k in range(n):
            last += k * k
            yield last

    @numba.jit(forceobj=True, looplift=False)
    def longest(words: Any) -> Any:
        found = ""
        for word in words:
            if len(word) > len(found):
                found = word
        return found

    compiled: Any = numba.njit(squares)
    assert list(compiled(4)) == [0, 1, 5, 14]
    assert longest(["a", "door", "net"]) == "door"

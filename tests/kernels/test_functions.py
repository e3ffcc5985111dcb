"""Functions made of additions and products: against the library's, and the same when compiled."""

import math

import numba
import numpy as np
import pytest

from builders.cases import nonempty
from springback.kernels.angles import angle_of, floor, nearest_integer, sine_cosine
from springback.kernels.bits import bits_of, float_of
from springback.kernels.compiler import STRICT, kernel
from springback.kernels.exponentials import exponential, logarithm
from springback.kernels.trees import replace
from springback.kernels.vectors import Vec

LUCK = np.random.default_rng(0)
ANGLES = [*LUCK.uniform(-20.0, 20.0, 3000), *LUCK.normal(0.0, 1e-3, 500), 0.0, math.pi, 1e5]
POWERS = [*LUCK.uniform(-700.0, 700.0, 2000), *LUCK.uniform(-1.0, 1.0, 1000), 0.0]


def test_sine_and_cosine() -> None:
    for angle in ANGLES:
        ours = sine_cosine(angle)
        assert ours == pytest.approx((math.sin(angle), math.cos(angle)), abs=3e-16)


def test_angles_of_directions() -> None:
    for y, x in LUCK.normal(size=(3000, 2)):
        assert angle_of(y, x) == pytest.approx(math.atan2(y, x), abs=9e-16)
    assert angle_of(0.0, 0.0) == 0.0
    assert angle_of(0.0, -2.0) == math.pi
    assert angle_of(3.0, 0.0) == 0.5 * math.pi


def test_exponential_and_logarithm() -> None:
    for x in POWERS:
        assert exponential(x) == pytest.approx(math.exp(x), rel=4e-16)
    for x in np.exp(LUCK.uniform(-30.0, 30.0, 2000)):
        assert logarithm(x) == pytest.approx(math.log(x), rel=4e-16, abs=1e-16)
    assert exponential(-1e5) == exponential(-708.0) > 0.0


def test_rounding() -> None:
    for x in (*LUCK.uniform(-1e6, 1e6, 1000), -2.0, 0.5, 1.5, 3.0, -0.25):
        assert nearest_integer(x) == round(x)
        assert floor(x) == math.floor(x)


def test_bits_there_and_back() -> None:
    assert bits_of(1.0) == np.uint64(0x3FF0000000000000)
    for x in ANGLES:
        assert float_of(bits_of(x)) == x


def test_compiled_they_give_the_same_bits() -> None:
    @numba.njit(error_model="numpy")
    def compiled(x: float) -> tuple[float, float, float, float]:
        both = sine_cosine(x)
        return both.sine, both.cosine, angle_of(x, 0.3), exponential(x)

    for x in nonempty(ANGLES[:3000]):
        both = sine_cosine(x)
        assert compiled(x) == (both.sine, both.cosine, angle_of(x, 0.3), exponential(x))


@kernel
def moved(v: Vec) -> Vec:
    here = replace(v, z=v.x + 3.0)
    there = replace(here, x=here.z + 10.0)
    return replace(there, y=there.x * 2.0, z=there.y + 0.5)


@kernel
def moved_back(v: Vec) -> Vec:
    return replace(v, z=v.z - 0.5, y=v.y)


def test_a_field_is_replaced_by_its_name() -> None:
    """Was: of two calls with the same types in one kernel, both replaced the field of the later."""

    def entry(v: Vec) -> Vec:
        return moved_back(moved(v))

    expected = Vec(14.0, 28.0, 2.0)
    assert entry(Vec(1.0, 2.0, 3.0)) == expected
    assert numba.njit(**STRICT)(entry)(Vec(1.0, 2.0, 3.0)) == expected

"""Quaternions and small matrices of the estimators, against SciPy and NumPy."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from springback.kernels.trees import leaves
from springback.kernels.vectors import (
    Mat3,
    Quat,
    Vec,
    conjugate,
    exponential_map,
    inverse_symmetric,
    isotropic,
    quaternion_product,
    renormalise,
    rotation,
    rotation_vector,
    skew,
    small_angle_map,
    symmetric_part,
    transpose,
)

numbers = st.floats(-1.7, 1.7)
vectors = st.builds(Vec, numbers, numbers, numbers)
matrices = st.builds(Mat3, vectors, vectors, vectors)


def quat(r):
    return Quat(*r.as_quat(scalar_first=True).tolist())


@given(vectors)
def test_exponential_and_logarithm_are_scipys_and_inverse(a):
    there = exponential_map(a)
    assert np.allclose(rotation(there), Rotation.from_rotvec(a).as_matrix(), rtol=0.0, atol=1e-14)
    assert np.allclose(rotation_vector(there), a, rtol=0.0, atol=1e-13)  # at most 2.94 rad long
    opposite = Quat(*(-component for component in there))
    assert np.allclose(rotation_vector(opposite), a, rtol=0.0, atol=1e-13)


@pytest.mark.parametrize(("angle", "near"), [(0.0, 0.0), (1e-9, 1e-16), (0.1, 2e-15), (0.6, 2e-9)])
def test_small_turns_are_turns(angle, near):
    axis = Vec(2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0)
    little, exactly = small_angle_map(angle * axis), exponential_map(angle * axis)
    assert leaves(little) == pytest.approx(leaves(exactly), abs=near, rel=0.0)


@given(vectors, st.floats(0.997, 1.003))
def test_nearly_unit_quaternions_become_unit_ones(a, length):
    """What is left of an error e of the squared length is 5/16 e³, and the direction stays."""
    q = exponential_map(a)
    off = Quat(*(length * x for x in q))
    back = renormalise(off)
    error = 1.0 - length * length
    assert leaves(back) == pytest.approx(leaves(q), abs=5.0 / 16.0 * abs(error) ** 3 * 1.02 + 1e-15)


def test_no_rotation_and_half_a_turn_need_no_case():
    assert exponential_map(Vec(0.0, 0.0, 0.0)) == Quat(1.0, 0.0, 0.0, 0.0)
    assert rotation_vector(Quat(1.0, 0.0, 0.0, 0.0)) == Vec(0.0, 0.0, 0.0)
    assert rotation_vector(Quat(0.0, 0.0, 1.0, 0.0)) == pytest.approx((0.0, math.pi, 0.0))
    assert rotation_vector(exponential_map(Vec(1e-9, 0.0, 0.0))).x == pytest.approx(1e-9, rel=1e-15)


@given(vectors, vectors)
def test_products_of_quaternions_are_scipys(a, b):
    one, two = Rotation.from_rotvec(a), Rotation.from_rotvec(b)
    product = quaternion_product(quat(one), quat(two))
    assert np.allclose(rotation(product), (one * two).as_matrix(), rtol=0.0, atol=1e-14)
    unit = quaternion_product(conjugate(quat(one)), quat(one))
    assert np.allclose(unit, (1.0, 0.0, 0.0, 0.0), rtol=0.0, atol=1e-15)


@given(matrices, matrices, vectors, numbers)
def test_matrices_are_numpys(a, b, v, s):
    x, y = np.array(a), np.array(b)
    close = {"rtol": 0.0, "atol": 1e-13}
    assert np.allclose(a @ b, x @ y, **close)
    assert np.allclose(a - b, x - y, **close)
    assert np.allclose(a * s, s * x, **close)
    assert np.allclose(s * a, s * x, **close)
    assert np.allclose(transpose(a), x.T, **close)
    assert np.allclose(symmetric_part(a), 0.5 * (x + x.T), **close)
    assert np.allclose(np.array(skew(v)) @ b.x, np.cross(v, b.x), **close)
    positive = x @ x.T + np.eye(3)
    inverse = inverse_symmetric(Mat3(*(Vec(*row) for row in positive.tolist())))
    assert np.allclose(np.array(inverse) @ positive, isotropic(1.0), rtol=0.0, atol=1e-11)

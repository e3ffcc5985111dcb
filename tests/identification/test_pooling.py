"""Several impacts: published numbers, and intervals that cover."""

import numpy as np
import pytest

from springback.identification.solving.pooling import pool

#: Trials of the BCG vaccine (Colditz et al., JAMA 271, 1994): cases and others among vaccinated,
#: then among controls.  Every program for random effects is checked by them.
BCG = np.array([
    [4, 119, 11, 128], [6, 300, 29, 274], [3, 228, 11, 209], [62, 13536, 248, 12619],
    [33, 5036, 47, 5761], [180, 1361, 372, 1079], [8, 2537, 10, 619], [505, 87886, 499, 87892],
    [29, 7470, 45, 7232], [17, 1699, 65, 1600], [186, 50448, 141, 27197], [5, 2493, 3, 2338],
    [27, 16886, 29, 17825],
], dtype=float)  # fmt: skip


def test_random_effects_are_those_of_published_trials() -> None:
    """Viechtbauer, Journal of Statistical Software 36 (3), 2010: REML, -0.7145 and 0.3132."""
    a, b, c, d = BCG.T
    risk = np.log(a / (a + b)) - np.log(c / (c + d))
    variance = 1.0 / a - 1.0 / (a + b) + 1.0 / c - 1.0 / (c + d)
    found = pool(risk, np.sqrt(variance))
    assert found.value == pytest.approx(-0.7145, abs=5e-5)
    assert found.scatter**2 == pytest.approx(0.3132, abs=2e-4)
    assert found.heterogeneity < 1e-4  # Q = 152.23 of 12
    assert found.common == pytest.approx(-0.4303, abs=5e-5)
    assert found.low == pytest.approx(-1.108, abs=2e-3)  # Knapp and Hartung
    assert found.high == pytest.approx(-0.321, abs=2e-3)


def test_intervals_cover_with_scatter_where_pooling_without_does_not() -> None:
    rng = np.random.default_rng(8)
    covered, without, warned = 0, 0, 0
    for _ in range(300):
        deviations = rng.uniform(0.003, 0.008, 5)
        values = 0.10 * rng.standard_normal(5) + deviations * rng.standard_normal(5)
        found = pool(values, deviations)
        covered += found.low <= 0.0 <= found.high
        without += abs(found.common) <= 1.96 * found.common_deviation
        warned += found.heterogeneity < 0.05
    assert 0.91 < covered / 300 < 0.98
    assert without / 300 < 0.15
    assert warned == 300


def test_intervals_cover_without_scatter_too() -> None:
    rng = np.random.default_rng(9)
    found = [pool(0.01 * rng.standard_normal(5), np.full(5, 0.01)) for _ in range(300)]
    assert np.mean([one.low <= 0.0 <= one.high for one in found]) > 0.93
    assert np.mean([one.heterogeneity < 0.05 for one in found]) < 0.09
    alone = pool(np.array([0.1, 0.3]), np.array([0.1, 0.2]), scatter=False)
    assert alone.value == pytest.approx((10.0 + 0.3 / 0.04) / (100.0 + 25.0))
    assert alone.without == pytest.approx((0.3, 0.1))

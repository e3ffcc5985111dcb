"""Noise: estimated from a quiet stretch, and taken out of residuals."""

import numpy as np
import pytest
from scipy.signal import lfilter

from springback.identification.observations.noise import estimated_noise, white_noise

RNG = np.random.default_rng(5)


def coloured(count: int, phi: float, sigma: float) -> np.ndarray:
    white = sigma * RNG.standard_normal((count, 3))
    return np.asarray(lfilter([1.0], [1.0, -phi], white, axis=0))


def test_coloured_noise_about_a_smooth_motion_is_recovered() -> None:
    t = np.arange(4000) * 1e-3
    motion = np.stack([2.0 + t, 3.0 * t**2, -(t**3)], axis=1)
    noise = estimated_noise(t, motion + coloured(4000, 0.6, 0.2), 1e-3)
    assert noise.coefficients[0] == pytest.approx(0.6, abs=0.03)
    np.testing.assert_allclose(noise.innovation, 0.2, rtol=0.03)
    np.testing.assert_allclose(noise.stationary, 0.25, rtol=0.05)  # 0.2 / sqrt(1 - 0.36)


def test_white_noise_stays_white() -> None:
    t = np.arange(60) * 5e-3
    orders = [
        len(estimated_noise(t, 0.3 * RNG.standard_normal((60, 3)), 1e-3).coefficients)
        for _ in range(40)
    ]
    assert np.mean(np.array(orders) > 0) < 0.1


def test_whitened_residuals_are_independent_also_after_gaps_and_losses() -> None:
    noise = estimated_noise(np.arange(4000) * 1e-3, coloured(4000, 0.7, 0.1), 1e-3)
    rest = coloured(4000, 0.7, 0.1)
    rest[1000:1010] = np.nan
    starts = np.arange(4000) == 0
    starts[2500] = True
    white = noise.whiten(rest, starts)
    assert not white[1000:1010].any()
    kept = np.delete(white, np.arange(1000, 1010), axis=0)
    assert kept.std() == pytest.approx(1.0, rel=0.03)
    lag = (kept[1:] * kept[:-1]).mean() / kept.var()
    assert abs(lag) < 0.04


def test_a_sensor_without_noise_has_what_it_resolves() -> None:
    noise = estimated_noise(np.arange(100) * 1e-3, np.zeros((100, 3)), 0.02)
    np.testing.assert_array_equal(noise.stationary, 0.02)
    assert np.isinf(noise.freedom)
    given = white_noise(0.5, 3)
    assert given.with_residuals(np.full((50, 3), 3.0)) is given  # what a user states is not changed


def test_few_samples_are_not_alone_once_residuals_of_a_fit_are_there() -> None:
    noise = estimated_noise(np.arange(24) * 5e-3, 0.5 * RNG.standard_normal((24, 3)), 1e-3)
    rest = RNG.standard_normal((400, 3))  # true deviation 1, twice what is assumed
    white = rest / noise.innovation
    better = noise.with_residuals(white)
    assert better.innovation.mean() == pytest.approx(1.0, rel=0.1)
    assert better.freedom == noise.freedom + white.size


def test_lines_of_rotors_are_not_predicted_to_nothing() -> None:
    t = np.arange(500) * 1e-3
    lines = 3.0 * np.sin(2.0 * np.pi * np.outer(t, [90.0, 97.0, 101.0]))
    noise = estimated_noise(t, lines + 0.01 * RNG.standard_normal((500, 3)), 5e-3)
    assert (noise.innovation > 0.09 * noise.stationary).all()
    np.testing.assert_allclose(noise.stationary, 3.0 / np.sqrt(2.0), rtol=0.1)

"""Gusts have the variance, correlation and spectrum of MIL-F-8785C, at every tick length."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from springback.dynamics.air import AirSettings
from springback.dynamics.gusts import (
    Dryden,
    Gust,
    GustMemory,
    Shaped,
    dryden,
    first_gust,
    gust,
    low_altitude,
)
from springback.kernels.trees import leaves
from springback.kernels.vectors import Vec


def test_low_altitude_formulas() -> None:
    """MIL-F-8785C in feet: at 20 ft, and where h = 1000 ft makes all scales and intensities one."""
    knots = 1852.0 / 3600.0
    sigma, scale = low_altitude(15.0 * knots, 20.0 * 0.3048)
    factor = 0.177 + 0.000823 * 20.0
    np.testing.assert_allclose(sigma.z, 1.5 * knots)
    np.testing.assert_allclose(sigma.x / sigma.z, factor**-0.4)
    np.testing.assert_allclose(scale.x / 0.3048, 20.0 / factor**1.2)
    assert scale.z == 20.0 * 0.3048
    sigma, scale = low_altitude(15.0 * knots, 304.8)
    np.testing.assert_allclose(sigma, sigma.z, rtol=1e-3)
    np.testing.assert_allclose(scale, scale.z, rtol=1e-3)


def filters(tick: float) -> tuple[Dryden, np.ndarray]:
    """Gusts with three different time scales T [s], of unit intensity, along X."""
    scale, speed = Vec(2.0, 3.0, 1.0), 4.0
    return dryden(Vec(1.0, 1.0, 1.0), scale, speed, tick, Vec(1.0, 0.0, 0.0)), np.array(scale) / 4.0


def responses(weather: Dryden, ticks: int) -> np.ndarray:
    """What a single unit of noise leads to, tick by tick, shape (ticks, 3)."""
    memory: Any = GustMemory(0.0, Shaped(0.0, 0.0), Shaped(0.0, 0.0))
    rows = []
    for k in range(ticks):
        now: Gust = gust(weather, (1.0, 1.0, 1.0) if k == 0 else (0.0, 0.0, 0.0), memory)
        memory = now.memory
        rows.append(leaves(now.velocity))
    return np.array(rows)


@pytest.mark.parametrize("tick", [1e-3, 1e-2, 0.1, 1.0])
def test_variance_and_correlation_are_drydens_at_every_tick_length(tick: float) -> None:
    """Σ h_n h_(n+k) of the pulse response is the autocorrelation; no chance is involved."""
    weather, t = filters(tick)
    h = responses(weather, int(45.0 * t.max() / tick) + 10)
    lags = [k for k in (0, 1, 2, 5, 50, 500) if k < len(h) - 5]
    for k in nonempty(lags):
        found = np.sum(h[: len(h) - k] * h[k:], axis=0)
        x = k * tick / t
        expected = np.exp(-x) * np.where([True, False, False], 1.0, 1.0 - 0.5 * x)
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-9)


def test_spectrum_is_that_of_the_specification() -> None:
    """|H|² h / π over angular frequency is Φ(Ω) / V, far below the rate of the ticks."""
    tick, speed = 1e-3, 4.0
    weather, t = filters(tick)
    h = responses(weather, int(45.0 * t.max() / tick))
    length = t * speed
    for omega in (0.0, 0.3, 1.0, 3.0, 10.0, 30.0):
        transfer = np.sum(h * np.exp(-1j * omega * tick * np.arange(len(h)))[:, None], axis=0)
        found = np.abs(transfer) ** 2 * tick / np.pi
        s = (length * omega / speed) ** 2
        u = 2.0 * length / np.pi / (1.0 + s)
        across = length / np.pi * (1.0 + 3.0 * s) / (1.0 + s) ** 2
        # Aliases add about (ω h)² / 12 of their own: 1e-4 at 30 rad/s.
        np.testing.assert_allclose(found, np.where([1, 0, 0], u, across) / speed, rtol=3e-4)


def test_the_first_gust_is_as_if_the_wind_had_always_blown() -> None:
    """Its covariance is kept by a tick, and is that of endless running; exactly, by linearity."""
    weather, _ = filters(0.02)
    columns = [leaves(first_gust(weather, tuple(row)).memory) for row in np.eye(5)]
    start = np.array(columns).T @ np.array(columns)
    blank = GustMemory(0.0, Shaped(0.0, 0.0), Shaped(0.0, 0.0))
    noise = np.array([leaves(gust(weather, tuple(row), blank).memory) for row in np.eye(3)]).T
    silent = (0.0, 0.0, 0.0)
    carried = []
    for row in np.eye(5):
        memory = GustMemory(row[0], Shaped(row[1], row[2]), Shaped(row[3], row[4]))
        carried.append(leaves(gust(weather, silent, memory).memory))
    a = np.array(carried).T
    np.testing.assert_allclose(a @ start @ a.T + noise @ noise.T, start, rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(np.diag(start)[[0, 2, 4]], 1.0, rtol=1e-12)


def test_a_long_run_has_the_intensities() -> None:
    """By chance this time, with seeded noise: σ of each axis, none correlated with another."""
    settings = AirSettings(
        wind=(0.0, 5.0, 0.0), rotor_drag=(0.3, 0.3, 0.0),
        gusts={"wind_at_6_m": 10.0, "airspeed": 30.0},
    )  # fmt: skip
    weather = settings.turbulence(0.5)
    assert isinstance(weather, Dryden)
    rng = np.random.default_rng(24)
    now = first_gust(weather, tuple(map(float, rng.normal(size=5))))
    rows = []
    for noise in rng.normal(size=(20_000, 3)).tolist():
        now = gust(weather, tuple(noise), now.memory)
        rows.append(now.velocity)
    # Twenty thousand samples, some 1500 independent ones of the slowest axis: 2 % of σ.
    seen = np.cov(np.array(rows).T)
    s = weather.intensity
    np.testing.assert_allclose(np.sqrt(np.diag(seen)), [s.y, s.x, s.z], rtol=0.06)
    assert np.abs(np.corrcoef(np.array(rows).T) - np.eye(3)).max() < 0.08


def test_gusts_turn_with_the_wind() -> None:
    """U along the mean wind, v to its left, w upwards."""

    def blows(along: Vec) -> Vec:
        weather = dryden(Vec(1.0, 2.0, 3.0), Vec(1.0, 1.0, 1.0), 1.0, 0.1, along)
        return first_gust(weather, (1.0, 0.0, 1.0, 0.0, 0.0)).velocity

    u_v = blows(Vec(1.0, 0.0, 0.0))
    turned = blows(Vec(0.0, 1.0, 0.0))
    assert (u_v.x, u_v.z) == (1.0, 0.0)
    assert 0.0 < u_v.y < 2.0
    assert turned == Vec(-u_v.y, u_v.x, 0.0)

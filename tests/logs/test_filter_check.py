"""An accelerometer behind a low-pass that its log does not tell."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import scipy.signal

from springback.logs.filter_check import untold_filter
from springback.logs.overview import missing_for_impact
from springback.logs.recording import SPECIFIC_FORCE, LogChannel, Recording, SensorChain

RATE = 1000.0


def log_of(noise: float, corner: float | None, order: int = 2, seed: int = 0) -> LogChannel:
    """Two seconds of hovering with an impact, and rotors at 140 Hz."""
    rng = np.random.default_rng(seed)
    t = np.arange(2000) / RATE
    values = noise * rng.standard_normal((2000, 3))
    values[:, 2] += 9.81 + 0.5 * np.sin(2.0 * np.pi * 0.7 * t)
    values += 0.3 * np.sin(2.0 * np.pi * 140.0 * t + 1.0)[:, None]
    values[1000:1030] -= 80.0 * np.sin(np.pi * np.arange(30) / 30.0)[:, None]
    if corner is not None and order == 1:
        a = -np.expm1(-2.0 * np.pi * corner / RATE)
        values = scipy.signal.lfilter([a], [1.0, a - 1.0], values, axis=0)
    elif corner is not None:
        b, c = scipy.signal.butter(2, corner, fs=RATE)
        settled = scipy.signal.lfilter_zi(b, c)[:, None] * values[:1]
        values = scipy.signal.lfilter(b, c, values, axis=0, zi=settled)[0]
    return LogChannel("sensor_accel", SPECIFIC_FORCE, t, values)


@pytest.mark.parametrize("corner", [20.0, 30.0, 60.0])
@pytest.mark.parametrize("noise", [0.05, 0.5, 3.0])
def test_a_filter_of_second_order_is_seen(noise: float, corner: float) -> None:
    said = untold_filter(log_of(noise, corner))
    assert "none near 500 Hz" in said
    assert "low_pass_order = 2" in said


@pytest.mark.parametrize("noise", [0.005, 0.05, 0.5, 3.0])
@pytest.mark.parametrize("seed", range(5))
def test_a_sensor_alone_is_not_taken_for_filtered(noise: float, seed: int) -> None:
    assert not untold_filter(log_of(noise, None, seed=seed))
    assert not untold_filter(log_of(noise, 218.0, order=1, seed=seed))


def test_what_is_told_is_not_said_again() -> None:
    found = log_of(0.1, 30.0)
    for chain in (SensorChain(low_pass=30.0), SensorChain(average=0.005)):
        assert not untold_filter(replace(found, chain=chain))
    assert not untold_filter(replace(found, times=found.times[:200], values=found.values[:200]))


def test_an_overview_says_that_the_filter_is_missing() -> None:
    one = Recording(Path("flight.ulg"), "ULog", (log_of(0.1, 30.0),), (), {}, ())
    assert any("behind a low-pass that the log does not tell" in text
               for text in missing_for_impact([one]))  # fmt: skip

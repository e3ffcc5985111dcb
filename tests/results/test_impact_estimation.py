"""Estimators through an impact that the accelerometer cannot follow: what is lost, and for how long.

Quad meets the wall at 3.5 m/s: 60 g for 24 ms, of which the accelerometer tells 16 g.
"""

import functools
import math
from typing import NamedTuple

import numpy as np
import pytest

import springback
from springback.errors import InputError
from springback.results.estimate_errors import (
    EstimateErrors,
    clipped_area,
    estimate_errors,
    specific_force,
)
from springback.results.flight import Flight

G = 9.80665
RANGE, HUGE = 16.0 * G, 2e3  # [m/s²]


class Hit(NamedTuple):
    flight: Flight
    errors: EstimateErrors

    def after(self, delay: float) -> int:
        """Tick so long after the cages have left the wall [s]."""
        left = self.flight.separation_time
        assert left is not None
        return int(np.searchsorted(self.errors.time, left + delay))


@functools.cache
def hit(estimator: str, full_scale: float = RANGE, distrust: bool = True) -> Hit:
    """The impact; a huge range has a step as fine as the small one's."""
    kalman = {"accelerometer_range": full_scale, "distrust_clipped": distrust}
    flight = springback.fly(
        {
            "vehicle": "quad",
            "reference": {"type": "hold", "position": (0.0, 0.0, 1.0)},
            "start": {"position": (2.2, 0.0, 1.0), "velocity": (3.5, 0.0, 0.0)},
            "world": {"obstacles": [{"type": "wall", "distance": 2.75, "surface": "wall"}]},
            "estimator": {"type": estimator, "kalman": kalman},
            "sensors": {"imu": {"accelerometer": {"full_scale": full_scale, "bits": 20}}},
            "simulation": {"duration": 1.0},
            "seed": 1,
        }
    )
    return Hit(flight, estimate_errors(flight))


def test_the_impact_is_beyond_the_range() -> None:
    flight = hit("kalman").flight
    assert flight.peak_acceleration is not None
    assert flight.peak_acceleration > 3.5 * RANGE
    assert np.abs(flight.telemetry["imu_ax"]).max() <= RANGE
    read = np.abs(hit("kalman", HUGE).flight.telemetry["imu_ax"]).max()
    assert 0.9 < read / flight.peak_acceleration < 1.0  # mean of a tick, and its low-pass


def test_the_mean_force_adds_up_to_the_change_of_velocity() -> None:
    """∫ (R f − g e_Z) dt = Δv: nothing of a shock of 60 g is lost between the ticks."""
    flight = hit("kalman", HUGE).flight
    c, ticks = flight.columns, flight.telemetry["t"]
    q = np.stack([np.interp(ticks, c["t"], c[f"q{a}"]) for a in "wxyz"], axis=1)
    f, w, u = specific_force(flight), q[:, :1], q[:, 1:]
    world = f + 2.0 * np.cross(u, np.cross(u, f) + w * f)
    gained = world[1:].sum(axis=0) * 1e-3 - np.array([0.0, 0.0, 9.81]) * 1e-3 * (len(f) - 1)
    ends = [np.interp(ticks[[0, -1]], c["t"], c[f"v{a}"]) for a in "xyz"]
    assert gained == pytest.approx([late - early for early, late in ends], abs=1e-9)


@pytest.mark.parametrize("estimator", ["kalman", "complementary"])
def test_the_velocity_is_wrong_by_the_clipped_area(estimator: str) -> None:
    """As long as no pose has come from after the impact, whatever the filter, within 20 %.

    The poses that come while it lasts already take some of it back; the complementary filter's
    bandwidth of 20/s takes 15 % of it over the half of 24 ms, on average.
    """
    made = hit(estimator, distrust=False)
    area = clipped_area(made.flight, RANGE)
    assert 2.0 < area < 4.0
    assert made.errors.velocity.max() == pytest.approx(area, rel=0.2)
    assert clipped_area(made.flight, HUGE) == 0.0


@pytest.mark.parametrize("estimator", ["kalman", "complementary"])
def test_without_clipping_there_is_nothing_to_recover_from(estimator: str) -> None:
    clipped, whole = hit(estimator), hit(estimator, HUGE)
    assert whole.errors.velocity.max() < 0.1 * clipped.errors.velocity.max()


def test_distrust_brings_the_velocity_back_at_once() -> None:
    """One pose from after the impact suffices: 20 ms after it, a tenth of what trust leaves."""
    distrusting, trusting = hit("kalman"), hit("kalman", distrust=False)
    late = distrusting.after(0.02)
    assert distrusting.errors.velocity[late] < 0.1 * trusting.errors.velocity[late]
    assert distrusting.errors.velocity[late] < 0.15


def test_trust_takes_its_time() -> None:
    """The filter holds its inertial unit for good, so that biases and tilt take the blame."""
    trusting, distrusting = hit("kalman", distrust=False), hit("kalman")
    late = slice(trusting.after(0.02), None)
    assert trusting.errors.velocity[late].mean() > 5.0 * distrusting.errors.velocity[late].mean()
    assert trusting.errors.attitude[late].max() > 3.0 * distrusting.errors.attitude[late].max()


def test_the_complementary_filter_forgets_with_its_bandwidth() -> None:
    """Between the two: its observer has fixed gains, and forgets the lost velocity as (1 + b t) e^(−b t).

    A double pole at b = 20/s answers an impulse of acceleration with the velocity (1 − b t) e^(−b t)
    of a fading memory or slower; what is left after 100 ms is thus no more than (1 + 2) e^(−2).
    """
    made, ours = hit("complementary"), hit("kalman")
    early, late = made.after(0.0), made.after(0.1)
    left = made.errors.velocity[late] / made.errors.velocity[early]
    assert 0.1 < left < 3.0 * math.exp(-2.0)
    assert made.errors.velocity[made.after(0.02)] > 5.0 * ours.errors.velocity[ours.after(0.02)]
    assert made.errors.velocity[made.after(0.4)] < 0.05


def test_where_nothing_is_clipped_distrust_changes_nothing() -> None:
    with_it, without = hit("kalman", HUGE), hit("kalman", HUGE, distrust=False)
    assert np.array_equal(with_it.errors.velocity, without.errors.velocity)


def test_errors_are_asked_of_flights_that_estimated() -> None:
    flight = springback.fly(
        {"vehicle": "quad", "thrust": "hover", "simulation": {"duration": 0.01}}
    )
    with pytest.raises(InputError, match="no estimate"):
        estimate_errors(flight)

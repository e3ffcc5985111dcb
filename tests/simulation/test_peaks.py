"""Peaks between instants: parabolas exactly, smooth peaks to high order, and never across a jump."""

from __future__ import annotations

import math

import numpy as np
import pytest

from builders.scenes import FACE, approaching, one_arm, surface
from springback.results.flight import fly
from springback.simulation.flight import fly_one
from springback.simulation.measuring.measures import measures_of
from springback.simulation.measuring.peaks import PeakSample, Recent, peak_of, spacing

NONE = PeakSample(0.0, 0.0, 0.0)
PLACES = {"distance": 2.75}, {"position": [0.0, 0.6, 0.0], "normal": [0.0, -1.0, 0.0]}


def test_the_vertex_of_a_parabola_is_found_exactly() -> None:
    """a - b (t - c)² at uneven instants, whatever they are."""
    chance = np.random.default_rng(3)
    found = 0
    for _ in range(200):
        before, after = chance.uniform(0.25, 2.0, 2)
        a, b, c = chance.uniform(0.0, 5.0), chance.uniform(0.1, 4.0), chance.uniform(-1.0, 1.0)
        first, second, third = (a - b * (t - c) ** 2 for t in (-before, 0.0, after))
        peak = peak_of(first, second, third, spacing(Recent(before, NONE, NONE), after, True))
        if second > first and second >= third:
            found += 1
            assert peak.value == pytest.approx(a, abs=1e-12)
            assert peak.time == pytest.approx(c - after, abs=1e-12)
        else:
            assert peak.value == third
            assert peak.time == 0.0
    assert 50 < found < 150


def test_without_a_smooth_stretch_of_three_instants_the_present_value_counts() -> None:
    """A jump before the present instant or before the one before it."""
    for recent, smooth in ((Recent(0.0, NONE, NONE), True), (Recent(0.1, NONE, NONE), False)):
        peak = peak_of(0.0, 1.0, 0.9, spacing(recent, 0.1, smooth))
        assert peak.value == 0.9
        assert peak.time == 0.0


@pytest.mark.parametrize("steps", [(1e-12, 1e-4), (1e-4, 1e-12), (1e-6, 1e-4)])
def test_what_changes_within_a_step_much_shorter_than_the_next_is_no_slope(
    steps: tuple[float, float],
) -> None:
    """As of a gust at a tick, up to which a flight may take a step of rounding."""
    peak = peak_of(1.0, 1.001, 1.0005, spacing(Recent(steps[0], NONE, NONE), steps[1], True))
    assert peak.value == 1.0005
    assert peak.time == 0.0


def test_no_peak_of_a_pilot_that_presses_on_is_above_its_samples() -> None:
    """ARQ without recovery leans on a wall for seconds; its steps end 1e-12 s before some ticks."""
    wall, side = ({"type": "wall", "surface": "wall", **place} for place in PLACES)
    flight = fly({
        "vehicle": "arq", "reference": {"type": "run-up", "speed": 2.0},
        "world": {"obstacles": [wall, side, {"type": "ground", "surface": "wall"}]},
        "simulation": {"duration": 7.0},
    })  # fmt: skip
    assert np.diff(flight.t).min() < 1e-11
    sampled = np.linalg.norm([flight.columns[f"a{axis}"] for axis in "xyz"], axis=0)
    assert flight.peak_acceleration == pytest.approx(sampled.max(), rel=0.01)


@pytest.mark.parametrize("step", [2e-4, 1e-4, 5e-5])
def test_a_dashpot_s_jump_at_touch_is_not_overshot(step: float) -> None:
    """Kelvin-Voigt with ζ above a half: the force is largest as it touches, b v, and not above."""
    m, v, stiffness, damping = 1.0, 2.0, 1e4, 300.0
    vehicle = one_arm(FACE, surface(stiffness=stiffness, exponent=1.0, viscosity=damping), mass=m)
    vehicle = vehicle._replace(timing=vehicle.timing._replace(impact_step=step))
    measured = measures_of(fly_one(vehicle, approaching(v, 1e-3), executor="python"))
    assert damping / (2.0 * math.sqrt(stiffness * m)) > 0.5  # ... ζ
    assert measured["peak_normal_force"] == pytest.approx(damping * v, rel=1e-12)
    assert measured["peak_acceleration"] == pytest.approx(damping * v / m, rel=1e-12)


def test_a_smooth_peak_is_found_far_within_the_error_of_its_samples() -> None:
    """Of a Hertzian impact: the errors of touch itself are left, of order 2.5 in the step."""

    def worst(step: float) -> float:
        return max(abs(peak(step, gap) / limit - 1.0) for gap in np.linspace(1e-3, 2e-3, 6))

    def peak(step: float, gap: float) -> float:
        vehicle = one_arm(FACE, surface(stiffness=1e5, exponent=1.5), mass=1.0)
        vehicle = vehicle._replace(timing=vehicle.timing._replace(impact_step=step))
        flown = fly_one(vehicle, approaching(2.0, gap), executor="python")
        return float(measures_of(flown)["peak_acceleration"] or 0.0)

    limit = peak(2e-5, 1e-3)
    coarse, fine = worst(4e-4), worst(2e-4)
    assert coarse < 5e-6
    assert fine < coarse / 4

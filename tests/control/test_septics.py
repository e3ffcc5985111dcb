"""Polynomials of degree 7, many at once and in turn: SciPy's, and demands as of one."""

from __future__ import annotations

import math

import numpy as np
import pytest
import scipy

from builders.cases import nonempty
from springback.control import approach
from springback.control.approach import ALIKE, _simplest
from springback.control.demands import Limits, level_demands
from springback.control.runup import RunUpContact, run_up
from springback.control.septics import LineMotions, SplineCurve, septics, shares
from springback.errors import InputError
from springback.kernels.vectors import Vec

LIMITS = Limits(1.15, 9.81, 28.0, 2.0)


def some_courses() -> tuple[np.ndarray, np.ndarray, np.ndarray, LineMotions]:
    noise_stream = np.random.default_rng(0)
    first, last = noise_stream.standard_normal((2, 4, 9))
    durations = noise_stream.uniform(0.1, 5.0, 9)
    return first, last, durations, septics(first, last, durations, 31)


def test_they_are_scipys_polynomials() -> None:
    first, last, durations, courses = some_courses()
    for k, duration in nonempty(enumerate(durations)):
        curve = scipy.interpolate.BPoly.from_derivatives([0.0, duration], [first[:, k], last[:, k]])
        t = np.linspace(0.0, duration, 31)
        for order, found in nonempty(enumerate(courses, start=1)):
            wanted = curve(t, order)
            assert found[:, k] == pytest.approx(wanted, abs=1e-9 * np.abs(wanted).max())


def test_in_turn_they_are_scipys_and_pass_through_their_rows() -> None:
    breaks = np.array([0.0, 0.7, 1.1, 3.0])
    rows = np.random.default_rng(1).standard_normal((4, 4, 3))
    curve, same = (
        SplineCurve(breaks, rows),
        scipy.interpolate.BPoly.from_derivatives(breaks, rows),
    )
    t = np.linspace(breaks[0], breaks[-1], 96).reshape(4, 24)
    for order in range(8):
        wanted = same(t, order)
        assert curve(t, order).shape == (4, 24, 3)
        assert curve(t, order) == pytest.approx(wanted, abs=1e-12 * np.abs(wanted).max())
    for order in range(4):
        assert curve(breaks, order) == pytest.approx(rows[:, order], abs=1e-12)


@pytest.mark.parametrize("limits", [LIMITS, LIMITS._replace(min_thrust=20.0)])
def test_shares_are_those_of_single_courses(limits: Limits) -> None:
    *_, courses = some_courses()
    for k, found in nonempty(enumerate(shares(courses, limits))):
        asked = level_demands(courses.acceleration[:, k], courses.jerk[:, k], limits)
        assert found == pytest.approx(max(asked.uses(limits).values()), rel=1e-12)


def test_of_durations_that_are_alike_the_shortest_is_taken() -> None:
    """Where nothing asks for more than the pitch at the end, rounding must not choose."""
    ties = 0
    for pitch in np.radians(np.linspace(-30.0, 45.0, 16)):
        for speed in (1.0, 1.5, 2.0, 2.5):
            end = (2.4, speed, 9.81 * math.tan(pitch), 0.0)
            plan = _simplest(end, LIMITS)
            durations = np.geomspace(0.02, 8.0, 150) * end[0] / end[1]
            courses = septics(np.zeros((4, 1)), np.array(end)[:, None], durations, approach.FEW)
            stays = courses.velocity.min(axis=0) >= -approach.BACKWARDS * end[1]
            share = shares(courses, LIMITS)
            alike = durations[stays & (share <= ALIKE * share[stays].min())]
            assert plan.breaks[-1] == alike.min()
            ties += len(alike) > 1
    assert ties > 10


def test_advice_is_looked_for_only_where_it_is_wanted(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[float] = []

    def least(planned: object, distance: float) -> float:
        asked.append(distance)
        return 2.0 * distance

    monkeypatch.setattr(approach, "_least_distance", least)
    start, arrival = Vec(0.0, 0.0, 1.0), RunUpContact(Vec(2.4, 0.0, 1.0), 8.0, 0.0)
    with pytest.raises(
        InputError, match=r"needs more than the 2.4 m it has; within 2.4 m it needs"
    ):
        run_up(start, arrival, LIMITS, advises=False)
    assert not asked
    with pytest.raises(InputError, match=r"needs a distance of 4.8 m, 2.4 m more than the 2.4 m"):
        run_up(start, arrival, LIMITS)
    assert asked == [2.4]

"""Polynomials: boundary conditions, closed forms against linear algebra, optimality, feasibility."""

from __future__ import annotations

import math

import numba
import numpy as np
import pytest
from scipy.interpolate import BPoly

from builders.cases import nonempty
from springback.control.demands import ROOM, Limits, demands, level_demands, level_tilt
from springback.control.polynomials import (
    BoundaryCondition,
    as_reference,
    quintic,
    snap_cost,
    snap_spline,
    through,
    waypoint_times,
)
from springback.control.target import target
from springback.errors import InputError
from springback.kernels.trees import leaves
from springback.kernels.vectors import Vec

LIMITS = Limits(mass=1.41, gravity=9.81, max_thrust=27.5)
CORNERS = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 1.5], [1.0, 2.0, 2.0], [0.0, 1.0, 1.0]])
TIMES = [0.0, 1.0, 2.5, 3.7]
START = BoundaryCondition(Vec(0.3, -0.2, 1.0), Vec(-3.5, 0.4, 0.1), Vec(2.0, -1.0, 0.5))
END = BoundaryCondition(Vec(0.1, 0.5, 1.2), Vec(0.5, 0.0, -0.3), Vec(-1.0, 0.2, 0.0))


def test_quintic_against_the_six_equations() -> None:
    T, t = 0.67, 0.41
    powers = np.arange(6)

    def row(s: float, k: int) -> np.ndarray:
        return np.array([math.perm(n, k) * s ** max(n - k, 0) if n >= k else 0.0 for n in powers])

    matrix = np.array([row(0.0, k) for k in range(3)] + [row(T, k) for k in range(3)])
    c = np.linalg.solve(matrix, np.array([*START, *END]))
    now = target(quintic(START, END, T, 2.0, 0.0), 2.0 + t)
    for k, value in enumerate((now.position, now.velocity, now.acceleration, now.jerk)):
        assert np.allclose(row(t, k) @ c, value, rtol=1e-10, atol=1e-10)


def test_quintic_meets_its_ends() -> None:
    curve = quintic(START, END, 0.67, 0.0, 0.0)
    for t, motion in ((0.0, START), (0.67, END)):
        now = target(curve, t)
        for have, wanted in nonempty(zip(now[:3], motion, strict=True)):
            assert np.allclose(have, wanted, rtol=0.0, atol=1e-9)


def test_recovery_of_the_paper_swings_as_printed() -> None:
    # Pitch at 3.5 m/s printed as -66 and +49 deg; a quintic from the collision with the speed before
    # it to rest 0.1 m back in 0.19 s²/m · 3.5 m/s gives -66 and +49.6 deg.
    still = Vec(0.0, 0.0, 0.0)
    start, end = (
        BoundaryCondition(still, Vec(3.5, 0.0, 0.0), still),
        BoundaryCondition(Vec(-0.1, 0.0, 0.0), still, still),
    )
    curve = quintic(start, end, 0.19 * 3.5, 0.0, 0.0)
    a = [target(curve, t).acceleration.x for t in np.linspace(0.0, 0.665, 2001)]
    tilt, _ = level_tilt(np.array(a), 0.0, 9.81)
    assert math.degrees(tilt.min()) == pytest.approx(-66.0, abs=0.5)
    assert math.degrees(tilt.max()) == pytest.approx(49.6, abs=0.3)


def test_compiled_quintic_gives_the_same_bits() -> None:
    @numba.njit(error_model="numpy")
    def compiled(start, end, duration, time):
        return target(quintic(start, end, duration, 0.5, 0.1), time)

    for t in np.linspace(0.0, 1.5, 31):
        plain = target(quintic(START, END, 0.67, 0.5, 0.1), float(t))
        assert leaves(compiled(START, END, 0.67, float(t))) == leaves(plain)


def test_minimum_snap_passes_its_points_and_rests_at_the_ends() -> None:
    reference = as_reference(snap_spline(TIMES, CORNERS), TIMES)
    for t, corner in zip(TIMES, CORNERS, strict=True):
        assert np.allclose(target(reference, t).position, corner, rtol=0.0, atol=1e-9)
    for t in (TIMES[0], TIMES[-1]):
        now = target(reference, t)
        assert np.abs([*now.velocity, *now.acceleration, *now.jerk]).max() < 1e-9


def test_minimum_snap_is_smooth_at_its_points() -> None:
    reference, curve = as_reference(snap_spline(TIMES, CORNERS), TIMES), snap_spline(TIMES, CORNERS)
    for t in nonempty(TIMES[1:-1]):
        left, right = target(reference, math.nextafter(t, 0.0)), target(reference, t)
        assert np.allclose(leaves(left), leaves(right), rtol=0.0, atol=1e-9)
        for k in range(4, 7):  # snap and two more: the corner conditions of least snap
            assert np.allclose(curve(t - 1e-9, k), curve(t + 1e-9, k), rtol=1e-6, atol=1e-4)


def test_minimum_snap_of_one_segment_is_the_polynomial_of_its_eight_conditions() -> None:
    ends = np.array([[[1.0, 0.0, 0.0], [0.5, 1.0, 0.0], [0.0, 0.0, 2.0]], np.zeros((3, 3))])
    curve = snap_spline([0.0, 1.3], CORNERS[:2], ends)
    rows = np.concatenate([CORNERS[:2, None], ends], axis=1)
    wanted = BPoly.from_derivatives([0.0, 1.3], rows)
    t = np.linspace(0.0, 1.3, 20)
    assert np.allclose(curve(t), wanted(t), rtol=0.0, atol=1e-10)


def test_no_other_smooth_curve_through_the_points_has_less_snap() -> None:
    # Others: through the same points, with other derivatives there (a Hermite septic in between).
    curve, random = snap_spline(TIMES, CORNERS), np.random.default_rng(3)
    least = snap_cost(curve, TIMES)
    rows = np.stack([curve(np.array(TIMES), k) for k in range(4)], axis=1)
    same = BPoly.from_derivatives(TIMES, rows)
    assert snap_cost(same, TIMES) == pytest.approx(least, rel=1e-9)
    for size in (1e-3, 1e-1, 1.0):
        for _ in range(10):
            other = rows.copy()
            other[1:-1, 1:] += size * random.standard_normal(other[1:-1, 1:].shape)
            assert snap_cost(BPoly.from_derivatives(TIMES, other), TIMES) > least


def test_snap_cost_of_a_known_curve() -> None:
    # x = t⁴: snap 24, over 2 s.  Three equal axes.
    curve = BPoly.from_derivatives(
        [0, 2], [[[0] * 3] * 4, [[16] * 3, [32] * 3, [48] * 3, [48] * 3]]
    )
    assert snap_cost(curve, [0.0, 2.0]) == pytest.approx(3 * 24**2 * 2)


def test_shared_times_are_the_best_parts() -> None:
    times = waypoint_times(CORNERS, 3.7)
    least = snap_cost(snap_spline(times, CORNERS), times)
    assert times[0] == 0.0
    assert times[-1] == pytest.approx(3.7)
    for k in (1, 2):
        for shift in (-0.02, 0.02):
            other = times.copy()
            other[k] += shift
            assert snap_cost(snap_spline(other, CORNERS), other) > least
    # Mirrored points take mirrored times.
    assert np.allclose(waypoint_times(CORNERS[::-1], 3.7), 3.7 - times[::-1], atol=1e-3)


def test_shortest_flight_uses_what_it_may() -> None:
    reference = through(CORNERS, LIMITS)
    half = through(CORNERS, LIMITS, duration=2.0 * reference.duration)
    assert [s.begins * 2.0 for s in reference.segments] == pytest.approx(
        [s.begins for s in half.segments], rel=1e-3
    )
    times = [s.begins for s in reference.segments[: len(CORNERS) - 1]] + [reference.duration]
    asked = demands(snap_spline(times, CORNERS), times, LIMITS)
    assert max(asked.uses(LIMITS).values()) == pytest.approx(ROOM, rel=1e-6)


def test_demands_of_a_circle() -> None:
    # Speed v on radius r: thrust m √(g² + v⁴/r²), tilt atan(v²/(r g)), turning at v/r · sin(tilt).
    v, r = 2.0, 1.0

    def circle(t: np.ndarray, nu: int = 0) -> np.ndarray:
        turn = np.asarray(t) * v / r + 0.5 * math.pi * nu
        level = np.zeros_like(turn)
        return r * (v / r) ** nu * np.stack([np.cos(turn), np.sin(turn), level], axis=-1)

    asked = demands(circle, [0.0, 1.0], LIMITS)
    tilt = math.atan2(v * v / r, 9.81)
    assert asked.max_thrust == pytest.approx(1.41 * math.hypot(9.81, v * v / r))
    assert asked.min_thrust == pytest.approx(asked.max_thrust)
    assert asked.tilt == pytest.approx(tilt)
    assert asked.tilt_rate == pytest.approx(v / r * math.sin(tilt))


def test_level_demands_agree_with_those_in_space() -> None:
    curve = BPoly.from_derivatives([0.0, 1.1], [[0, 0, 0, 0], [2.0, 1.0, -6.0, 3.0]])
    direction = np.array([0.6, -0.8, 0.0])
    in_space = demands(lambda t, nu=0: curve(t, nu)[..., None] * direction, [0.0, 1.1], LIMITS)
    t = np.linspace(0.0, 1.1, 200)
    assert level_demands(curve(t, 2), curve(t, 3), LIMITS) == pytest.approx(in_space)


@pytest.mark.parametrize(
    ("limits", "words"),
    [
        (
            LIMITS._replace(max_thrust=15.0),
            r"thrust of [\d.]+ N, [\d.]+ N beyond the limit of 15 N",
        ),
        (
            LIMITS._replace(min_thrust=13.9),
            r"least thrust of [\d.]+ N, .* below the limit of 13.9 N",
        ),
        (
            LIMITS._replace(max_tilt=0.1),
            r"tilt of [\d.]+ deg, [\d.]+ deg beyond the limit of 5.73 deg",
        ),
        (LIMITS._replace(max_body_rate=1.0), r"tilt rate of [\d.]+ deg/s, .* limit of 57.3 deg/s"),
    ],
)
def test_what_cannot_be_flown_names_the_limit(limits: Limits, words: str) -> None:
    with pytest.raises(InputError, match=words):
        through(CORNERS, limits, times=[0.0, 0.6, 1.6, 2.3])


def test_too_weak_to_hover() -> None:
    with pytest.raises(InputError, match="at any duration"):
        through(CORNERS, LIMITS._replace(max_thrust=13.0))

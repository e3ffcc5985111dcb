"""Many problems side by side: the optima that SciPy finds one by one."""

import numpy as np
import pytest
from scipy.optimize import least_squares

from springback.identification.solving.least_squares import jacobians, solve

TIMES = np.linspace(0.0, 2.0, 40)
RNG = np.random.default_rng(3)
DATA = 3.0 * np.exp(-1.4 * TIMES) + 0.5 + 0.01 * RNG.standard_normal(len(TIMES))


def residuals(points: np.ndarray) -> np.ndarray:
    a, b, c = points.T[:, :, None]
    data = (a * np.exp(-b * TIMES) + c - DATA) / 0.01
    return np.concatenate([data, points], axis=1)  # with standard normal priors


@pytest.mark.parametrize("central", [True, False])
def test_all_starts_reach_the_optimum_of_scipy(central: bool) -> None:
    """With differences to one side at half the evaluations, to a little less."""
    asked = 0

    def counted(points: np.ndarray) -> np.ndarray:
        nonlocal asked
        asked += len(points)
        return residuals(points)

    starts = RNG.uniform(0.1, 2.5, (6, 3))
    found = solve(counted, starts, farthest=6.0, central=central)
    assert (asked > 400) == central, asked
    best = least_squares(lambda x: residuals(x[None])[0], [1.0, 1.0, 1.0], x_scale="jac")
    assert found.converged.all()
    np.testing.assert_allclose(
        found.points, np.tile(best.x, (6, 1)), rtol=2e-5 if central else 1e-4
    )
    np.testing.assert_allclose(found.costs, 2.0 * best.cost, rtol=1e-7)


@pytest.mark.parametrize("checked", [True, False])
def test_secants_save_derivatives_on_the_way_to_the_same_optimum(checked: bool) -> None:
    """Derivatives are taken less often."""
    asked = [0, 0]

    def counted(points: np.ndarray) -> np.ndarray:
        asked[with_secants] += len(points) > 4  # more than the tries of a round
        return residuals(points)

    start = np.array([[3.2, 1.5, 0.5]])
    _, slopes = jacobians(residuals, start, np.ones(3, dtype=bool))
    with_secants = 0
    plain = solve(counted, start, farthest=6.0)
    with_secants = 1
    found = solve(
        counted, start, farthest=6.0, secants=8, slopes=None if checked else slopes, checked=checked
    )
    assert found.converged.all()
    np.testing.assert_allclose(found.costs, plain.costs, rtol=1e-5)
    np.testing.assert_allclose(found.points, plain.points, rtol=2e-3)
    assert asked[1] < asked[0], asked


def test_a_start_far_above_the_best_is_given_up_early_but_never_the_second() -> None:
    """Costs of numbers that reach their optimum, one slowly, one hardly at all."""
    asked: list[np.ndarray] = []

    def slow(points: np.ndarray) -> np.ndarray:
        asked.append(points.copy())
        x, kind = points.T
        pace = np.where(kind > 0.5, 1e3, 1.0) * np.exp(0.5 * np.abs(kind) * x) + kind
        return np.stack([pace, 0.01 * x], axis=1)

    held = np.array([False, True])
    starts = np.array([[2.0, 0.0], [2.0, 0.2], [2.0, 1.0]])
    solve(slow, starts, farthest=6.0, held=held, rounds=4, enough=0.0, hasty=True)
    last = {float(kind) for kind in asked[-1][:, 1]}
    assert last == {0.0, 0.2}
    asked.clear()
    solve(slow, starts[[0, 2]], farthest=6.0, held=held, rounds=4, enough=0.0, hasty=True)
    assert 1.0 in asked[-1][:, 1]  # one of the two best


def test_numbers_that_are_held_stay_and_bounds_are_kept() -> None:
    held = np.array([[False, True, False], [True, False, False]])
    found = solve(residuals, np.ones((2, 3)), farthest=2.0, held=held, together=False)
    assert found.points[0, 1] == 1.0
    assert found.points[1, 0] == 1.0
    assert np.abs(found.points).max() <= 2.0
    free = solve(residuals, np.ones((1, 3)), farthest=2.0)
    assert free.points[0, 0] == pytest.approx(2.0)  # 3 is out of reach
    alone = least_squares(
        lambda x: residuals(np.array([[2.0, x[0], x[1]]]))[0], [1.0, 0.5], x_scale="jac"
    )
    np.testing.assert_allclose(free.points[0, 1:], alone.x, rtol=1e-4)


def test_derivatives_are_those_of_the_formula() -> None:
    point = np.array([[2.0, 1.1, 0.3]])
    _, [slopes] = jacobians(residuals, point, np.ones(3, dtype=bool))
    decay = np.exp(-1.1 * TIMES)
    exact = np.stack([decay, -2.0 * TIMES * decay, np.ones_like(TIMES)], axis=1) / 0.01
    np.testing.assert_allclose(slopes[:-3], exact, rtol=1e-6, atol=1e-6)


def test_a_start_that_cannot_be_evaluated_is_left_alone() -> None:
    def refusing(points: np.ndarray) -> np.ndarray:
        found = residuals(points)
        found[points[:, 1] < -1.0] = np.nan
        return found

    found = solve(refusing, np.array([[1.0, -2.0, 0.0], [1.0, 1.0, 0.0]]), farthest=6.0)
    assert list(found.converged) == [False, True]
    assert np.isinf(found.costs[0])


@pytest.mark.parametrize("central", [True, False])
def test_the_others_are_solved_where_one_is_stopped_at_an_edge(central: bool) -> None:
    """The first would go to 3; beyond 2 nothing can be evaluated, nor be its difference."""

    def refusing(points: np.ndarray) -> np.ndarray:
        found = residuals(points)
        found[points[:, 0] > 2.0] = np.nan
        return found

    found = solve(refusing, np.ones((1, 3)), farthest=6.0, central=central)
    assert found.points[0, 0] == pytest.approx(2.0, abs=1e-3)
    alone = least_squares(
        lambda x: residuals(np.array([[found.points[0, 0], x[0], x[1]]]))[0], [1.0, 0.5],
        x_scale="jac",
    )  # fmt: skip
    np.testing.assert_allclose(found.points[0, 1:], alone.x, rtol=1e-3)
    _, [slopes] = jacobians(refusing, np.array([[2.0, 1.4, 0.5]]), np.ones(3, dtype=bool))
    _, [free] = jacobians(residuals, np.array([[2.0, 1.4, 0.5]]), np.ones(3, dtype=bool))
    np.testing.assert_allclose(slopes, free, rtol=1e-3, atol=1e-3)

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

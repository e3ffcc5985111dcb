"""Draws by Monte Carlo: of a posterior that is known, and of one that is cut off."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from springback.errors import InputError
from springback.identification.results_files import draws
from springback.identification.solving import sampling
from springback.identification.solving.sampling import posterior_sample
from springback.identification.unknowns import Unknown

FIELDS = [Unknown(name, "free", 0.0, 1.0, False, "", "") for name in "ab"]


def linear(*, floor: float = -np.inf) -> Any:
    """Fit of three readings that are linear in a, b and a latent; nothing flies below a floor."""
    jacobian = np.array([[20.0, 18.0, 1.0], [3.0, -2.0, 0.5], [1.0, 0.0, 2.0]])
    seen = jacobian @ np.array([0.3, -0.2, 0.1]) + np.array([0.4, -0.7, 0.2])

    def residuals(u: Any) -> Any:
        rows = np.concatenate([u @ jacobian.T - seen, u], axis=1)
        rows[u[:, 0] < floor] = np.nan
        return rows

    covariance = np.linalg.inv(jacobian.T @ jacobian + np.eye(3))
    place = {"a": 0, "b": 1, "bias": 2}
    problem: Any = residuals
    fit: Any = SimpleNamespace(
        problem=problem, name="impact", point=covariance @ jacobian.T @ seen, covariance=covariance
    )
    residuals.place = place  # type: ignore[attr-defined]
    return fit


def test_draws_of_a_linear_fit_are_those_by_laplace() -> None:
    fit = linear()
    found = posterior_sample(fit, seed=1, count=4000)
    deviations = np.sqrt(np.diag(fit.covariance))
    assert found.independent >= 4000.0
    assert found.draws.mean(axis=0) == pytest.approx(fit.point, abs=0.07 * deviations.max())
    scale = np.outer(deviations, deviations)
    told = np.cov(found.draws.T) / scale
    assert told == pytest.approx(fit.covariance / scale, abs=0.08)
    # Of several chains together: one whose moves are wrong is narrower in each.
    spread = [posterior_sample(fit, seed=k, count=4000).draws.var(axis=0) for k in range(2, 7)]
    assert np.mean(spread, axis=0) / deviations**2 == pytest.approx(1.0, abs=0.03)
    again = posterior_sample(fit, seed=1, count=4000)
    assert np.array_equal(again.draws, found.draws)


def test_what_cannot_be_flown_is_not_drawn() -> None:
    """A normal distribution cut off at its middle has a mean of 0.8 deviations above it."""
    fit = linear()
    cut = linear(floor=float(fit.point[0]))
    found = posterior_sample(cut, seed=2, count=2000).draws[:, 0]
    assert found.min() >= fit.point[0]
    above = (found.mean() - fit.point[0]) / fit.covariance[0, 0] ** 0.5
    assert above == pytest.approx((2.0 / np.pi) ** 0.5, abs=0.08)


def test_the_posterior_of_one_impact_is_that_of_its_draws() -> None:
    fit = linear()
    result: Any = SimpleNamespace(
        plan=SimpleNamespace(seed=1, method="emcee"), fits=(fit,),
        estimates=[SimpleNamespace(unknown=one) for one in FIELDS],
    )  # fmt: skip
    sampled = posterior_sample(fit, seed=1, count=500).draws
    assert np.array_equal(draws(result, 500), sampled[:, :2])


def test_without_emcee_the_command_that_installs_it_is_said(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def missing(name: str) -> Any:
        raise ImportError(name)

    monkeypatch.setattr("springback.extras.importlib.import_module", missing)
    with pytest.raises(InputError, match=r"this needs emcee, which is not installed: .*mcmc"):
        posterior_sample(linear(), seed=0, count=10)


def test_a_chain_that_is_too_short_is_refused_with_its_numbers(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(sampling, "MOST", sampling.BLOCK)
    with pytest.raises(InputError, match=r'method: "emcee" needs longer than 100 steps'):
        posterior_sample(linear(), seed=0, count=100_000)

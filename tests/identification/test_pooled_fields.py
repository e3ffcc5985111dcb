"""Fields of several impacts together: correlations are those of a posterior that is known."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from springback.identification.estimates import field_estimates
from springback.identification.results_files import draws
from springback.identification.unknowns import Unknown

FIELDS = [
    Unknown("k", "free", 0.0, 1.0, False, "", ""), Unknown("n", "free", 0.0, 1.0, False, "", ""),
    Unknown("m", "known", 0.0, 1.0, False, "", ""),
]  # fmt: skip
NAMES = {one.name: k for k, one in enumerate(FIELDS)}


def impact(rows: Any, seen: Any) -> Any:
    """Posterior of readings with unit noise that are linear in k, n, m and a latent."""
    jacobian = np.array(rows)
    covariance = np.linalg.inv(jacobian.T @ jacobian + np.eye(4))
    unknowns = [*FIELDS, Unknown("bias", "latent", 0.0, 1.0, False, "", "")]
    return SimpleNamespace(
        problem=SimpleNamespace(fields=FIELDS, unknowns=unknowns, place={**NAMES, "bias": 3}),
        point=covariance @ jacobian.T @ np.array(seen), covariance=covariance, profiles={}, settled=True,
        deviation=lambda name: float(covariance[NAMES[name], NAMES[name]] ** 0.5),
    )  # fmt: skip


def posterior(fits: Any, scatter: str, count: int = 20_000) -> Any:
    """Draws of the fields."""
    estimates = field_estimates(fits, scatter=scatter == "impact")
    result: Any = SimpleNamespace(
        plan=SimpleNamespace(seed=3, scatter=scatter, method="laplace"),
        fits=fits,
        estimates=estimates,
    )
    return draws(result, count)


def impacts(seed: int, count: int, scatter: Any) -> tuple[Any, Any, Any]:
    """Impacts of 12 readings, k and n told apart badly, and all of m; with rows and readings."""
    rng = np.random.default_rng(seed)
    common, mass = np.array([0.4, -0.3]), 0.7
    rows, seen = [], []
    for _ in range(count):
        along, apart = 30.0 * rng.standard_normal(12), 2.0 * rng.standard_normal(12)
        these = np.stack([
            along, 0.6 * along + apart, -0.8 * along, rng.standard_normal(12)
        ], axis=1)  # fmt: skip
        own = common + np.linalg.cholesky(scatter + 1e-20 * np.eye(2)) @ rng.standard_normal(2)
        rows.append(these)
        seen.append(these @ [*own, mass, rng.standard_normal()] + rng.standard_normal(12))
    return [impact(*one) for one in zip(rows, seen, strict=True)], rows, seen


def test_draws_of_several_impacts_are_the_posterior_that_is_known_exactly() -> None:
    """All readings at once, k, n and m common, a latent for each impact."""
    fits, rows, seen = impacts(5, 4, np.zeros((2, 2)))
    precision, weighted = np.eye(3 + 4), np.zeros(3 + 4)
    for j, (these, read) in enumerate(zip(rows, seen, strict=True)):
        whole = np.zeros((12, 7))
        whole[:, :3], whole[:, 3 + j] = these[:, :3], these[:, 3]
        precision += whole.T @ whole
        weighted += whole.T @ read
    exact = np.linalg.inv(precision)
    mean, covariance = (exact @ weighted)[:3], exact[:3, :3]
    deviations = np.sqrt(np.diag(covariance))
    wanted = covariance / np.outer(deviations, deviations)
    assert abs(wanted[0, 2]) > 0.9  # k and m are told together
    found = posterior(fits, "none")
    assert found.mean(axis=0) == pytest.approx(mean, abs=0.03 * deviations.max())
    assert found.std(axis=0) == pytest.approx(deviations, rel=0.03)
    assert np.corrcoef(found.T) == pytest.approx(wanted, abs=0.01)


def test_draws_keep_what_one_impact_does_not_tell_apart() -> None:
    """Without scatter in truth, but looked for: the correlations are near those of one impact."""
    fits, _, _ = impacts(6, 4, np.zeros((2, 2)))
    part = fits[0].covariance[:3, :3]
    scale = np.sqrt(np.diag(part))
    one = part / np.outer(scale, scale)
    found = np.corrcoef(posterior(fits, "impact").T)
    assert abs(one[0, 2]) > 0.9
    assert found[0, 2] == pytest.approx(one[0, 2], abs=0.1)


def test_draws_of_a_next_impact_have_the_scatter_and_its_correlation() -> None:
    """Of 40 impacts that differ by more than their noise, stiffer ones being less n."""
    scatter = np.array([[0.25, -0.12], [-0.12, 0.09]])
    fits, _, _ = impacts(7, 40, scatter)
    found = posterior(fits, "impact")
    # What is left of m, told by k of each impact only through their mean, is not of the scatter.
    rest = found[:, :2] - found[:, 2:] * (
        np.cov(found.T)[:2, 2] / found[:, 2].var()
    )  # fmt: skip
    assert rest.std(axis=0) == pytest.approx([0.5, 0.3], rel=0.25)
    assert np.corrcoef(rest.T)[0, 1] == pytest.approx(-0.8, abs=0.15)


def test_means_and_widths_of_draws_are_those_of_the_estimates() -> None:
    """Of impacts alike: what is reported of each field, Knapp and Hartung included."""
    rng = np.random.default_rng(2)
    rows = 12.0 * rng.standard_normal((12, 4))
    true = np.array([0.3, -0.2, 0.5, 0.1])
    noise = [rng.standard_normal(12) + rows[:, :2] @ (0.05 * rng.standard_normal(2)) for _ in "abc"]
    fits = [impact(rows, rows @ true + one) for one in noise]
    found = posterior(fits, "impact")
    free = field_estimates(fits, scatter=True)[:2]
    for one, column in nonempty(zip(free, found.T[:2], strict=True)):
        assert one.pooled is not None
        assert column.mean() == pytest.approx(one.value, abs=0.1 * one.deviation)
        wanted = np.hypot(one.deviation, one.pooled.scatter)
        assert column.std() == pytest.approx(wanted, rel=0.12)

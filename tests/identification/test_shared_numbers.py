"""What all impacts share does not average out: mass, and the calibration of a sensor."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from identification.rigs import LOSS, STIFFNESS, TRUE, problem_of, recorded, rig
from springback.identification.estimates import depth_forces, field_estimates
from springback.identification.fits import result_of
from springback.identification.observations.likelihood import SCALE
from springback.identification.solving.fitting import fit_impact
from springback.identification.unknowns import Unknown

FREE = Unknown("k", "free", 0.0, 1.0, False, "", "")
MASS = Unknown("m", "known", 0.0, 1.0, False, "", "")
IMPACTS, SMALL, SLOPE = 10, 0.01, 0.05


def impact(seen: float) -> Any:
    """Posterior of k + SLOPE m = seen ± SMALL with priors of deviation 1 for both."""
    row = np.array([1.0, SLOPE]) / SMALL
    covariance = np.linalg.inv(np.outer(row, row) + np.eye(2))
    point = covariance @ row * seen / SMALL
    names = {"k": 0, "m": 1}
    problem = SimpleNamespace(fields=[FREE, MASS], unknowns=[FREE, MASS], place=names)
    deviations = dict(zip(names, np.sqrt(np.diag(covariance)), strict=True))
    return SimpleNamespace(
        problem=problem, point=point, covariance=covariance, profiles={}, settled=True,
        deviation=lambda name: float(deviations[name]),
    )  # fmt: skip


@pytest.mark.parametrize("scatter", [True, False])
def test_the_error_of_a_shared_number_is_in_the_interval_of_ten_impacts(scatter: bool) -> None:
    """Ten impacts tell k + 0.05 m to 0.01/√10; k itself to 0.05, whatever their number."""
    rng, covered, widths, differing = np.random.default_rng(4), 0, [], 0
    for _ in range(300):
        mass = rng.standard_normal()
        seen = 0.3 + SLOPE * mass + SMALL * rng.standard_normal(IMPACTS)
        found, known = field_estimates([impact(x) for x in seen], scatter=scatter)
        covered += found.low <= 0.3 <= found.high
        widths.append(0.5 * (found.high - found.low) / 1.96)
        assert found.pooled is not None
        differing += found.pooled.heterogeneity < 0.05
    assert 0.92 * 300 <= covered <= 0.985 * 300
    assert np.median(widths) == pytest.approx(np.hypot(SLOPE, SMALL / 10**0.5), rel=0.05)
    assert differing <= 30  # 5 % by chance
    assert known.deviation == pytest.approx(1.0, abs=0.02)  # k's own prior tells a little of it


def test_a_shared_number_that_the_impacts_tell_is_told_by_all_of_them() -> None:
    """Two impacts of which each tells m: their precisions add, the prior counts once."""
    fits = [impact(0.1), impact(0.1)]
    for fit in fits:
        information = np.diag([100.0, 4.0])
        fit.covariance = np.linalg.inv(information + np.eye(2))
        fit.point = fit.covariance @ information @ np.array([0.2, 0.5])
    _, known = field_estimates(fits, scatter=False)
    assert known.deviation == pytest.approx((1.0 + 2.0 * 4.0) ** -0.5)
    assert known.value == pytest.approx(0.5 * 8.0 / 9.0)


def test_a_scale_that_is_uncertain_is_found_where_motion_capture_tells_it_too() -> None:
    """An accelerometer of 3 % too much: ignored it is a misfit, as an unknown it is found."""
    from dataclasses import replace

    from springback.logs.recording import SPECIFIC_FORCE

    full = 16.0 * 9.80665  # beyond the sensor's range it reads no more, whatever its scale
    tables = rig("quad", 1.4)
    read = recorded(tables)
    read = replace(read, channels=tuple(
        replace(one, values=np.clip(1.03 * one.values, -full, full))
        if one.quantity == SPECIFIC_FORCE else one
        for one in read.channels
    ))  # fmt: skip
    free = {STIFFNESS: "factor 4", LOSS: "factor 4"}
    errors = []
    for given in ({}, {"scale": 0.02, "misalignment": "1 deg"}):
        problem = problem_of(tables, read, free, sensors={"accelerometer": given})
        fit = fit_impact(problem, starts=1, seed=0)
        found = result_of(problem.plan, [fit])
        errors.append(abs(found.estimates[0].value / TRUE[STIFFNESS] - 1.0))
    assert errors[0] > 0.03
    assert errors[1] < 0.02
    assert not any(one.is_misfit for one in found.misfits)
    k = problem.place[SCALE]
    assert problem.unknowns[k].value(fit.point[k]) == pytest.approx(1.03, abs=0.004)
    low, high = found.estimates[0].low, found.estimates[0].high
    assert low < TRUE[STIFFNESS] < high


def test_the_force_at_a_depth_is_told_where_stiffness_and_exponent_are_not_apart() -> None:
    """Data of k δⁿ about 10 mm: the force to 1 %, the two apart by their correlation only."""
    stiffness = Unknown("s.stiffness", "free", np.log(2e5), np.log(2.0), True, "", "")
    exponent = Unknown("s.exponent", "free", 1.5, 0.3, False, "", "")
    seen = []
    for depth in (0.008, 0.01, 0.0125):
        row = np.array([np.log(2.0), 0.3 * np.log(depth)]) / 0.01
        seen.append(row)
    information = np.array(seen).T @ np.array(seen) + np.eye(2)
    covariance = np.linalg.inv(information)
    names = {"s.stiffness": 0, "s.exponent": 1}
    fields = [stiffness, exponent]
    fit: Any = SimpleNamespace(
        problem=SimpleNamespace(fields=fields, unknowns=fields, place=names),
        point=np.array([0.5, -0.4]), covariance=covariance, profiles={}, settled=True,
    )  # fmt: skip
    for fits in ([fit], [fit, fit, fit]):
        [found] = depth_forces(fits, scatter=False)
        wanted = float(stiffness.value(0.5)) * 0.01 ** float(exponent.value(-0.4))
        assert found.value == pytest.approx(wanted, rel=2e-3)
        error = 0.5 * np.log(found.high / found.low) / 1.96
        assert error == pytest.approx(0.01 / (3.0 * len(fits)) ** 0.5, rel=0.1)
    alone = np.log(2.0) * covariance[0, 0] ** 0.5
    assert alone > 10.0 * error

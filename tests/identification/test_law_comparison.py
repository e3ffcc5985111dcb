"""Laws compared by impacts left out: the true one predicts best, equal ones cannot be told apart."""

from __future__ import annotations

import copy
import json
import math
from typing import Any

import numpy as np
import pytest

from identification.rigs import LOSS, STIFFNESS, problem_of, recorded, rig
from springback.contact.laws.restitution import restitution
from springback.contact.parameters import SurfaceSettings
from springback.errors import InputError
from springback.identification.fits import FitResult, result_of
from springback.identification.law_comparison import (
    LawComparison,
    LawPredictions,
    compare_laws,
    equal_numbers,
    left_out_problem,
)
from springback.identification.solving.fitting import fit_impact
from springback.interfaces.cli.identify.fitting import fit_text
from springback.interfaces.reports.fit_tables import law_rows

SPEEDS = (1.2, 1.6, 2.0)


def fitted(compare: dict[str, Any], speeds: tuple[float, ...] = SPEEDS) -> FitResult:
    """Impacts of Quad on the wall, each fitted alone."""
    fits = []
    for k, speed in enumerate(speeds):
        tables = rig("quad", speed) | {"seed": k}
        free = {STIFFNESS: "factor 4", LOSS: "factor 4"}
        problem = problem_of(tables, recorded(copy.deepcopy(tables)), free, compare=compare)
        fits.append(fit_impact(problem, starts=1, seed=0, profiles=False))
    return result_of(fits[0].problem.plan, fits)


def test_an_elastic_law_predicts_worse_than_the_true_one_and_the_same_one_as_well() -> None:
    """The other model is the plan's own, its mass a hair different: nothing tells them apart."""
    twin = {"name": "twin", "change": ["vehicle.body.mass=1.8921"]}
    result = fitted({"laws": ["hertz", "hunt-crossley"], "others": [twin]})
    found = compare_laws(result)
    assert found is not None
    order = [one.name for one in found.models]
    assert sorted(order[:2]) == ["hunt-crossley", "twin"]
    assert order[2] == "hertz"
    assert found.is_worse(2)
    assert not found.is_worse(1)
    assert found.behind(2)[0] > 1000.0
    assert found.models[0].contact == pytest.approx(1.0, abs=0.15)
    assert found.models[2].contact > 5.0
    told = {name: value for name, value, _ in found.models[order.index("hunt-crossley")].estimates}
    assert told[STIFFNESS] == pytest.approx(2e5, rel=0.01)
    assert told[LOSS] == pytest.approx(0.432, rel=0.01)
    text = fit_text(result, found)
    assert "hertz predicts worse" in text
    assert "cannot be told from it" in text
    assert [row[0] for row in law_rows(found)] == order
    assert json.loads(json.dumps(found.as_data(), allow_nan=False))["models"][2]["worse"]


def test_two_impacts_are_too_few_and_none_is_asked_for_nothing() -> None:
    few = fitted({"laws": ["hertz"]}, SPEEDS[:2])
    with pytest.raises(InputError, match=r"compare: needs 3 impacts at least.*got 2"):
        compare_laws(few)
    plan = few.plan.model_copy(update={"compare": type(few.plan.compare)()})
    assert compare_laws(few._replace(plan=plan)) is None


def test_differences_have_the_error_of_their_scatter_over_impacts() -> None:
    """Two impacts of differences 3 and 5: their sum, and √2 times their standard deviation."""
    good = LawPredictions("good", (-10.0, -20.0), 1.0, (), "")
    bad = LawPredictions("bad", (-13.0, -25.0), 1.5, (), "")
    lost = LawPredictions("lost", (-math.inf, -math.inf), math.nan, (), "it diverges")
    found = LawComparison(("a", "b"), (good, bad, lost))
    assert found.behind(1) == pytest.approx((8.0, 2.0))
    assert found.is_worse(1)
    assert found.is_worse(2)
    assert found.sentences[2] == "lost could not be fitted: it diverges"
    rough = bad._replace(scores=(-13.0, -900.0))  # worse in both, by far in one
    assert LawComparison(("a", "b"), (good, rough)).is_worse(1)
    near = bad._replace(scores=(-11.0, -20.5))
    assert not LawComparison(("a", "b"), (good, near)).is_worse(1)


def test_another_law_begins_with_the_same_depth_and_restitution() -> None:
    """Of one mass at one speed: its energy at the depth, and what is left of its speed."""
    surface = SurfaceSettings(stiffness=2e5, dissipation=0.432)
    mass, speed = 1.892, 1.85
    energy = 0.5 * mass * speed**2
    depth = (2.5 * energy / 2e5) ** 0.4
    e = restitution(0.432, speed)
    linear = equal_numbers("kelvin-voigt", surface, {}, mass, speed)
    assert 0.5 * linear["stiffness"] * depth**2 == pytest.approx(energy)
    ratio = 0.5 * linear["viscosity"] / math.sqrt(linear["stiffness"] * mass)
    assert math.exp(-math.pi * ratio / math.sqrt(1.0 - ratio**2)) == pytest.approx(e)
    same = equal_numbers("hunt-crossley", surface, {}, mass, speed)
    assert same == pytest.approx({"stiffness": 2e5, "exponent": 1.5, "dissipation": 0.432})
    back = SurfaceSettings(law="kelvin-voigt", **linear)
    again = equal_numbers("hunt-crossley", back, {}, mass, speed)
    assert (again["stiffness"], again["dissipation"]) == pytest.approx((2e5, 0.432))
    constant = equal_numbers("constant-restitution", surface, {"dissipation": 0.2}, mass, speed)
    assert constant["restitution"] == pytest.approx(restitution(0.2, speed))
    assert np.isfinite(list(equal_numbers("hertz", surface, {}, mass, speed).values())).all()


def test_what_the_others_tell_together_predicts_the_one_left_out() -> None:
    """Stiffness and mass are told by their ratio: ln p rises as that of three normal densities.

    Each impact tells of both by N(m, Λ⁻¹).  With the prior alone, and with what the others tell
    besides, ln p differs by the ratio of two normal integrals; taken as independent, the same
    numbers would predict worse by 2.2 to 2.7 each.
    """
    fits = []
    for k, speed in enumerate(SPEEDS):
        tables = rig("quad", speed) | {"seed": k}
        free, known = {STIFFNESS: "factor 4"}, {"vehicle.body.mass": "+- 5 %", LOSS: "exact"}
        problem = problem_of(
            tables, recorded(copy.deepcopy(tables)), free, known=known, scatter="none",
            compare={"laws": ["hunt-crossley"]},
        )  # fmt: skip
        fits.append(fit_impact(problem, starts=1, seed=0, profiles=False))
    names = [STIFFNESS, "vehicle.body.mass"]
    which = [fits[0].problem.place[name] for name in names]
    precisions, points = [], []
    for one in fits:
        whole = np.linalg.inv(one.covariance[np.ix_(which, which)])
        precisions.append(whole - np.eye(2))
        points.append(whole @ one.point[which])
    found = compare_laws(result_of(fits[0].problem.plan, fits))
    assert found is not None

    def evidence(precision: np.ndarray, weighted: np.ndarray) -> float:
        """ln ∫ of a normal density's exponential, about 0."""
        square = float(weighted @ np.linalg.solve(precision, weighted))
        return 0.5 * (square - float(np.linalg.slogdet(precision)[1]))

    for k, fit in enumerate(fits):
        others = [j for j in range(3) if j != k]
        before = np.eye(2) + sum(precisions[j] for j in others)
        weighted = sum(points[j] for j in others)
        more = evidence(before + precisions[k], weighted + points[k]) - evidence(before, weighted)
        alone = evidence(np.eye(2) + precisions[k], points[k])
        slopes = fit.jacobian
        score = -0.5 * (fit.cost + float(np.linalg.slogdet(slopes.T @ slopes)[1]))
        assert found.models[0].scores[k] - score == pytest.approx(more - alone, abs=0.3)
        joint = left_out_problem(fit, [fits[j] for j in others], scatter=False).together
        assert joint is not None
        spread = joint.root @ joint.root.T
        assert spread[0, 1] / np.sqrt(spread[0, 0] * spread[1, 1]) > 0.9

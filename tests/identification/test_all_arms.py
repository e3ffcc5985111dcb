"""One free number of all arms, also where the vehicle has a list with one for each."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from identification.rigs import DAMPER, SPRING, problem_of, recorded, rig
from springback.errors import InputError
from springback.identification.fits import fields_of_plan, result_of
from springback.identification.report.assumptions import assumed_fields
from springback.identification.settings import FitPlan
from springback.identification.solving.fitting import fit_impact
from springback.identification.unknowns import field_unknown, with_values
from springback.scenario.scenario import Scenario, scenario_from

MASS = "vehicle.arms.mass"


def arms(**given: Any) -> dict[str, Any]:
    return rig("arq") | {"vehicle": {"preset": "arq-slider", "arms": given}}


def names(scenario: Scenario, known: dict[str, str], free: str = SPRING) -> list[str]:
    plan = FitPlan.model_validate(
        {"scenario": "rig.toml", "free": {free: "5 N/mm factor 3"}, "known": known}
    )
    return [one.name for one in fields_of_plan(plan, scenario)]


def test_one_number_is_set_in_all_arms_of_a_list() -> None:
    tables = arms(stiffness=[4e3] * 4)
    one = field_unknown(SPRING, "factor 3", "free", scenario_from(tables))
    assert one.value(0.0) == pytest.approx(4e3)  # the centre that no plan has to give
    changed = scenario_from(with_values(tables, [one], [2.0])).vehicle.arms
    assert [changed.at("stiffness", j) for j in range(4)] == pytest.approx([12e3] * 4)
    assert tables["vehicle"]["arms"]["stiffness"] == [4e3] * 4


def test_arms_that_differ_are_refused_in_one_line() -> None:
    scenario = scenario_from(arms(stiffness=[4e3, 4e3, 5e3, 4e3]))
    for text in ("factor 3", "4 N/mm factor 3"):
        with pytest.raises(InputError) as caught:
            field_unknown(SPRING, text, "free", scenario)
        assert caught.value.problems == (
            f"{SPRING}: is one number of all arms, and theirs differ (got 4000, 4000, 5000, 4000 "
            f"N/m); give {SPRING}.0 to {SPRING}.3, each with its uncertainty",
        )
    assert field_unknown(f"{SPRING}.2", "factor 3", "free", scenario).value(0.0) == pytest.approx(
        5e3
    )


def test_a_number_of_one_arm_beside_that_of_all_is_refused() -> None:
    scenario = scenario_from(arms(stiffness=[4e3] * 4))
    with pytest.raises(InputError, match=rf"^{SPRING}\.1: is part of {SPRING}, which is given"):
        names(scenario, {f"{SPRING}.1": "+- 5 %"})


def test_masses_of_arms_are_known_to_5_percent_also_as_a_list() -> None:
    """They were taken as exact."""
    own = [MASS, *(f"{MASS}.{k}" for k in range(4))]

    def found(tables: dict[str, Any], known: dict[str, str]) -> list[str]:
        return [one for one in names(scenario_from(tables), known) if one in own]

    assert found(arms(mass=[0.1] * 4), {}) == [MASS]
    assert found(arms(mass=[0.1, 0.1, 0.1, 0.12]), {}) == own[1:]
    assert sorted(found(arms(mass=[0.1] * 4), {f"{MASS}.1": "+- 1 %"})) == own[1:]
    assert found(arms(mass=[0.1] * 4), {MASS: "exact"}) == []
    assert found(arms(mass=[0.1] * 4), {MASS: "exact", own[2]: "+- 1 %"}) == [own[2]]


def test_spring_and_damper_of_all_arms_are_found() -> None:
    """Flown with 4 N/mm and 70 N s/m in lists, fitted from lists of 5 N/mm and 90 N s/m."""
    true = {SPRING: 4e3, DAMPER: 70.0}
    log = recorded(arms(stiffness=[4e3] * 4, damping=[70.0] * 4))
    believed = arms(stiffness=[5e3] * 4, damping=[90.0] * 4)
    problem = problem_of(believed, log, dict.fromkeys(true, "factor 3"))
    fit = fit_impact(problem, starts=1, seed=0)
    found = result_of(problem.plan, [fit])
    assert [one.unknown.name for one in found.estimates] == list(true)
    for one in found.estimates:
        error = 0.25 * np.log(one.high / one.low)
        assert error < 0.03
        assert abs(np.log(one.value / true[one.unknown.name])) < 3.0 * error
        assert one.verdict == "learned"
    assert not any(one.is_misfit for one in found.misfits)
    assumed = [one.name for part in assumed_fields(problem) for one in part]
    assert assumed
    assert not any(one.startswith((SPRING, DAMPER)) for one in assumed)

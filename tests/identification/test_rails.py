"""Dry friction of a slider's rail in fits: found with the wall's numbers, and missed without."""

import copy
from typing import Any

import numpy as np

from identification.rigs import LOSS, SPRING, STIFFNESS, TRUE, problem_of, recorded, rig
from springback.identification.fits import result_of
from springback.identification.solving.fitting import fit_impact

FRICTION = "model.slider_friction"
NEWTONS = 0.8


def rough(vehicle: str = "quad") -> dict[str, Any]:
    """The rig on a rail that takes some 0.6 m/s²."""
    tables = rig(vehicle)
    tables["model"]["slider_friction"] = NEWTONS
    return tables


def test_it_is_recovered_with_stiffness_and_loss() -> None:
    tables = rough()
    log, plan = recorded(tables), copy.deepcopy(tables)
    plan["model"]["slider_friction"] = 0.4
    free = {STIFFNESS: "factor 4", LOSS: "factor 4", FRICTION: "factor 5"}
    fit = fit_impact(problem_of(plan, log, free), starts=4, seed=0)
    told = result_of(fit.problem.plan, [fit])
    true = TRUE | {FRICTION: NEWTONS}
    for one in told.estimates:
        error = 0.25 * np.log(one.high / one.low)
        assert abs(np.log(one.value / true[one.unknown.name])) < 3.0 * error, one.unknown.name
    assert not any(one.is_misfit for one in told.misfits)
    [friction] = [one for one in told.estimates if one.unknown.name == FRICTION]
    assert friction.unknown.unit == "N"
    assert friction.high / friction.low < 1.3


def test_known_to_some_uncertainty_it_widens_the_rest_and_ignored_it_misleads() -> None:
    log, found = recorded(rough("arq")), {}
    free = {SPRING: "factor 4"}
    for name, known, newtons in (
        ("exact", {}, NEWTONS), ("known", {FRICTION: "0.7 N +- 30 %"}, 0.7), ("ignored", {}, 0.0),
    ):  # fmt: skip
        tables = rig("arq")
        tables["model"]["slider_friction"] = newtons
        fit = fit_impact(problem_of(tables, log, free, known=known), starts=2, seed=0)
        found[name] = result_of(fit.problem.plan, [fit]).estimates[0]
    for name in ("exact", "known"):
        assert found[name].low <= TRUE[SPRING] <= found[name].high
    widths = {name: np.log(one.high / one.low) for name, one in found.items()}
    assert widths["known"] > widths["exact"]
    off = {name: abs(np.log(one.value / TRUE[SPRING])) for name, one in found.items()}
    assert off["ignored"] > 5.0 * off["known"]
    assert not found["ignored"].low <= TRUE[SPRING] <= found["ignored"].high

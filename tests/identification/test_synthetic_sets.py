"""Synthetic sets of a coverage check: what is flown, and why a set cannot be used."""

from __future__ import annotations

import copy
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from springback.batch.sampled import sampled_flights
from springback.errors import InputError
from springback.identification.design.coverage import synthetic_fits, with_lead
from springback.identification.fits import base_scenario, fields_of_plan
from springback.identification.settings import FitPlan, read_fit_plan
from springback.identification.unknowns import at_centres
from springback.scenario.scenario import scenario_from

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def plan() -> FitPlan:
    return read_fit_plan(EXAMPLES / "fit.toml")


def test_a_start_near_to_touch_is_moved_back_in_time(plan: FitPlan) -> None:
    """The flight of the example passes through the start that the scenario has."""
    scenario, tables = base_scenario(plan, EXAMPLES)
    fields = fields_of_plan(plan, scenario)
    with pytest.raises(InputError, match=r"^set 1: impact at 0\.\d+ s: accelerometer has 0\."):
        synthetic_fits(plan, tables, fields, tables | {"sensors": {}}, "set 1")
    flown, lead = with_lead(plan, at_centres(tables, fields, scenario))
    assert 0.3 < lead < 0.55
    state = scenario.start_state()
    passed = sampled_flights([flown], [0.0, lead])
    assert passed.vectors("position")[0, 1] == pytest.approx(list(state.position), abs=2e-3)
    assert passed.vectors("velocity")[0, 1] == pytest.approx(list(state.velocity), abs=1e-2)
    again, none = with_lead(plan, flown)
    assert none == 0.0
    assert again == flown


def test_what_is_flown_has_the_middles_that_the_plan_gives(plan: FitPlan) -> None:
    """The example's loss has a centre of its own, 0.4 s/m, and the scenario's is another."""
    scenario, tables = base_scenario(plan, EXAMPLES)
    fields = fields_of_plan(plan, scenario)
    before = copy.deepcopy(tables)
    flown = scenario_from(at_centres(tables, fields, scenario))
    assert tables == before
    obstacle: Any = flown.world.obstacles[0]
    surface = obstacle.surface
    assert surface.dissipation == pytest.approx(0.4)
    assert surface.stiffness == pytest.approx(2e5)
    mean = np.mean(np.array(flown.vehicle.arms.directions))
    assert mean == pytest.approx(np.mean(np.array(scenario.vehicle.arms.directions)))


def test_a_start_that_hits_nothing_is_said(plan: FitPlan) -> None:
    scenario, tables = base_scenario(plan, EXAMPLES)
    away = tables | {"start": tables["start"] | {"velocity": [-1.0, 0.0, 0.0]}, "sensors": {}}
    with pytest.raises(InputError, match=r"^set 1: no impact was found: .* hits nothing$"):
        synthetic_fits(plan, tables, fields_of_plan(plan, scenario), away, "set 1")

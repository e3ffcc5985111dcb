"""The cost of an impact is smooth in what is fitted: events of the simulation do not show in it."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

import numpy as np

from springback.errors import InputError
from springback.identification.design.coverage import _believed_fields, at_centres, displaced_fields
from springback.identification.fits import base_scenario, fields_of_plan, read_flights
from springback.identification.observations.likelihood import ImpactProblem
from springback.identification.settings import read_fit_plan
from springback.random_streams import Purpose, stream
from springback.scenario.scenario import scenario_from

EXAMPLES = Path(__file__).parents[2] / "examples"
ARMS = "vehicle.arms.stiffness"


def test_arms_that_are_locked_do_not_jump_in_the_cost() -> None:
    """Locked at 1 mm/s, they changed one reading of an accelerometer, or its neighbour, by 0.9 σ."""
    plan = read_fit_plan(EXAMPLES / "fit.toml")
    scenario, _ = base_scenario(plan, EXAMPLES)
    [flight] = read_flights(plan, EXAMPLES)
    fields = fields_of_plan(plan, scenario)
    problem = ImpactProblem(plan, scenario, flight.tables, fields, flight.impacts[0])
    along = np.linspace(-2e-3, 2e-3, 161)
    points = np.zeros((len(along), len(problem.unknowns)))
    points[:, problem.place[ARMS]] = along
    costs = (problem(points) ** 2).sum(axis=1)
    smooth = np.polyval(np.polyfit(along / along[-1], costs, 4), along / along[-1])
    assert np.ptp(costs) > 1.0
    assert np.abs(costs - smooth).max() < 1e-2


def test_what_is_believed_is_of_a_vehicle_that_can_be() -> None:
    """Moments of inertia known to 30 %, each by itself, are of no body in some draws."""
    plan = read_fit_plan(EXAMPLES / "fit.toml")
    scenario, tables = base_scenario(plan, EXAMPLES)
    fields = [
        one._replace(deviation=0.3) if "inertia" in one.name else one
        for one in fields_of_plan(plan, scenario)
    ]
    impossible = 0
    for seed in range(20):
        drawn = _believed_fields(tables, fields, stream(0, Purpose.TRIAL, seed))
        scenario_from(at_centres(tables, drawn, scenario))
        first = displaced_fields(fields, stream(0, Purpose.TRIAL, seed))
        with suppress(InputError):
            scenario_from(at_centres(tables, first, scenario))
            continue
        impossible += 1
    assert impossible > 0

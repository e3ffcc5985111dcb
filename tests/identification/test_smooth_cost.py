"""The cost of an impact is smooth in what is fitted: events of the simulation do not show in it."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest

from builders.cases import nonempty
from springback.errors import InputError
from springback.identification.design import coverage
from springback.identification.design.coverage import _believed_fields, displaced_fields
from springback.identification.fits import base_scenario, fields_of_plan, read_flights
from springback.identification.observations.likelihood import ImpactProblem
from springback.identification.observations.noise import residuals_in_bins
from springback.identification.observations.windows import impact_window
from springback.identification.settings import read_fit_plan
from springback.identification.solving.fitting import fit_impact
from springback.identification.solving.least_squares import solve
from springback.identification.unknowns import FARTHEST, at_centres
from springback.logs.recording import Array
from springback.logs.segments import find_impacts
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


def test_bins_of_white_residuals_are_white() -> None:
    white = stream(1, Purpose.TRIAL, 0).standard_normal((4, 6001, 2))
    found = residuals_in_bins(white, 3)
    assert found.shape == (4, 2001, 2)
    assert np.var(found) == pytest.approx(1.0, rel=0.03)
    assert abs(np.mean(found[:, 1:] * found[:, :-1])) < 0.02
    assert found[0, -1] == pytest.approx(white[0, -1])  # a bin of one
    assert found[0, 0] * 3.0**0.5 == pytest.approx(white[0, :3].sum(axis=0))


def test_when_a_small_step_came_has_fewer_answers_in_bins() -> None:
    """A step of two deviations between samples: its time has an optimum at each likely sample."""
    generator, times = stream(2, Purpose.TRIAL, 0), np.arange(60.0)
    guesses = np.linspace(20.0, 40.0, 2001)
    steps = 2.0 * np.clip(times[None] - guesses[:, None], 0.0, 1.0)
    minima = {1: 0, 3: 0}
    for _ in nonempty(range(100)):
        read = 2.0 * np.clip(times - 30.3, 0.0, 1.0) + generator.standard_normal(60)
        for size in minima:
            costs = (residuals_in_bins((read - steps)[..., None], size) ** 2).sum(axis=(1, 2))
            least = (costs[1:-1] < costs[:-2]) & (costs[1:-1] < costs[2:])
            minima[size] += int((least & (costs[1:-1] < costs.min() + 8.0)).sum())
    assert minima[1] > 250
    assert minima[3] < 0.7 * minima[1]


def synthetic(seed: int) -> tuple[ImpactProblem, Array]:
    """Impact of a synthetic set of examples/fit.toml, and the true fields, the rest as logged."""
    plan = read_fit_plan(EXAMPLES / "fit.toml")
    scenario, tables = base_scenario(plan, EXAMPLES)
    fields = fields_of_plan(plan, scenario)
    flown, _ = coverage.with_lead(plan, at_centres(tables, fields, scenario))
    generator = stream(plan.seed, Purpose.TRIAL, seed)
    believed = _believed_fields(tables, fields, generator)
    recording = coverage._recorded(coverage._flown_tables(flown, seed, generator), "set")
    [impact] = find_impacts([recording])
    readings = impact_window(plan, scenario, [recording], impact)
    problem = ImpactProblem(plan, scenario, tables, believed, readings)
    true = np.zeros(len(problem.unknowns))
    for k, (one, original) in enumerate(zip(believed, fields, strict=True)):
        true[k] = one.coordinate(float(original.value(0.0)))
    return problem, true


def test_a_fit_ends_where_one_from_the_truth_does() -> None:
    """Compared one by one, readings gave this set two optima, 10.6 and 3 standard errors apart."""
    problem, true = synthetic(8)
    found = fit_impact(problem, starts=8, seed=0, profiles=False)
    from_truth = solve(problem, true[None], farthest=FARTHEST)
    assert float(from_truth.costs[0]) == pytest.approx(found.cost, abs=0.1)


def test_more_starts_are_tried_where_all_end_far_from_the_data() -> None:
    """Of this set, with these points, 4 starts end at 8 times the cost of noise or more."""
    problem, _ = synthetic(40)
    told: list[str] = []
    found = fit_impact(problem, starts=4, seed=3, profiles=False, tell=told.append)
    assert found.starts > 4
    assert any("search from 4 further starts, round 1 of" in words for words in told)
    assert found.cost < 1.2 * len(found.jacobian)


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

"""Optima at the edge of what a scenario accepts, and sensors that a scenario has without a table."""

from __future__ import annotations

import re
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from springback.errors import InputError
from springback.identification.fits import base_scenario, fields_of_plan, read_flights
from springback.identification.observations.likelihood import ImpactProblem, has_sensors
from springback.identification.settings import read_fit_plan
from springback.identification.solving.fitting import fit_impact
from springback.identification.unknowns import Unknown
from springback.logs.recording import SPECIFIC_FORCE, SensorChain
from springback.scenario.scenario import scenario_from

EXAMPLES = Path(__file__).parents[2] / "examples"


class Walled:
    """Readings a + b t, of which a scenario accepts no a above a bound."""

    def __init__(self, bound: float, wanted: float = 3.0) -> None:
        self.bound, t = bound, np.linspace(0.0, 1.0, 20)
        self.basis, self.data = np.stack([np.ones(20), t]), wanted + 0.5 * t
        self.impact = SimpleNamespace(name="log at 1.000 s")
        self.unknowns = [
            Unknown("a", "known", 0.0, 1.0, False, "kg", "+- 1 kg"),
            Unknown("b", "free", 0.0, 1.0, False, "kg", "+- 1 kg"),
        ]
        self.place = {"a": 0, "b": 1}
        self.flown = 0

    def __call__(self, u: np.ndarray) -> np.ndarray:
        self.flown += len(u)
        rest = np.concatenate([(u @ self.basis - self.data) / 0.01, u], axis=1)
        rest[u[:, 0] > self.bound] = np.nan
        return rest

    def refine_noise(self, u: np.ndarray) -> None:
        """Leave it."""

    def refusal(self, u: np.ndarray) -> str:
        return f"a: must be at most {self.bound:g}" if u[0] > self.bound else ""


def test_an_optimum_at_the_edge_of_what_can_be_flown_is_said() -> None:
    problem: Any = Walled(1.5)
    found = fit_impact(problem, starts=4, seed=0)
    assert found.point[0] == pytest.approx(1.5, abs=1e-3)
    [said] = found.bounds
    assert re.match(r"a is at the bound of what a scenario accepts, 1\.(4\d*|5) kg", said)
    assert said.endswith("and the data would have it beyond: a: must be at most 1.5")
    assert np.isfinite(found.profiles["b"].low)


def test_an_edge_that_nothing_presses_against_is_not_said() -> None:
    inside: Any = Walled(1.5, wanted=0.5)
    assert fit_impact(inside, starts=2, seed=0).bounds == ()
    at: Any = Walled(0.0, wanted=0.0)  # the middle of the prior, from which it cannot be larger
    assert fit_impact(at, starts=2, seed=0).bounds == ()


def test_a_start_that_cannot_be_flown_is_still_refused() -> None:
    problem: Any = Walled(-1.0)
    with pytest.raises(InputError, match=r"a: must be at most -1; check obstacle"):
        fit_impact(problem, starts=2, seed=0)


def test_the_usual_sensors_of_a_pilot_are_in_the_chain(tmp_path: Path) -> None:
    for name in ("fit.toml", "impact_log.toml", "impact_log.csv"):
        (tmp_path / name).write_bytes((EXAMPLES / name).read_bytes())
    text = (EXAMPLES / "arq_wall.toml").read_text()
    (tmp_path / "arq_wall.toml").write_text(
        text.replace('thrust = "hover"', "").replace("[[world", '[reference]\ntype="hold"\n[[world')
    )
    plan = read_fit_plan(tmp_path / "fit.toml")
    scenario, _ = base_scenario(plan, tmp_path)
    assert "sensors" not in scenario.model_fields_set
    assert has_sensors(scenario)
    [flight] = read_flights(plan, tmp_path)
    problem = ImpactProblem(
        plan, scenario, flight.tables, fields_of_plan(plan, scenario), flight.impacts[0]
    )
    [force] = [one for one in problem.readings if one.quantity == SPECIFIC_FORCE]
    chain = problem.chain(force._replace(chain=SensorChain()))  # a log that tells nothing
    part = scenario.sensors.imu.accelerometer
    assert (chain.full_scale, chain.low_pass) == (part.full_scale, part.bandwidth)
    assert None not in chain[:2]
    assert not has_sensors(scenario_from({"vehicle": "arq"}))

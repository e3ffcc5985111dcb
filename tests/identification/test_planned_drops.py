"""Drops that a plan proposes: from heights, at tilts, worth what a fit of them tells."""

from __future__ import annotations

import copy
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from springback.errors import InputError
from springback.identification.design.drops import drop_candidates, planned_drop
from springback.identification.design.experiments import plan_experiments
from springback.identification.fits import fields_of_plan
from springback.identification.observations.drop_start import fall_of
from springback.identification.observations.likelihood import ImpactProblem
from springback.identification.observations.windows import impact_window
from springback.identification.settings import FitPlan
from springback.identification.solving.fitting import fit_impact
from springback.logs.segments import find_impacts
from springback.logs.writing.flight_recording import flight_recording
from springback.results.flight import fly
from springback.scenario.overrides import apply_overrides
from springback.scenario.scenario import scenario_from

STIFFNESS, SPRING = "world.obstacles.0.surface.stiffness", "vehicle.arms.stiffness"
DROP: dict[str, Any] = {
    "vehicle": "arq",
    "thrust": 0.0,
    "world": {"obstacles": [{"type": "ground", "surface": "wall"}]},
    "start": {"position": [0.0, 0.0, 1.0], "roll": "45 deg", "pitch": "45 deg"},
    "simulation": {"duration": 1.2},
    "seed": 2,
    "sensors": {"imu": {"rate": "1 kHz", "accelerometer": {"full_scale": "200 gn"}}},
}
TOML = """
thrust = 0.0
vehicle = "arq"
[start]
position = [0, 0, "1 m"]
roll = "45 deg"
pitch = "45 deg"
[[world.obstacles]]
type = "ground"
surface = "wall"
[sensors.imu]
rate = "1 kHz"
[sensors.imu.accelerometer]
full_scale = "200 gn"
"""


def plan_of(**candidates: Any) -> FitPlan:
    known = {
        "vehicle.body.mass": "exact", "vehicle.arms.mass": "exact",
        "vehicle.arms.directions": "exact", "vehicle.body.inertia": "exact",
    }  # fmt: skip
    return FitPlan.model_validate({
        "scenario": "drop.toml", "experiment": "drop", "known": known,
        "free": {STIFFNESS: "factor 3", SPRING: "factor 3"},
        "candidates": {"sensors": ["imu"], **candidates},
    })  # fmt: skip


def test_candidates_fall_from_their_heights_at_their_tilts() -> None:
    plan = plan_of(heights=[0.3, "0.7 m"], rolls=[0.0, "45 deg"], pitches=["15 deg"])
    found = drop_candidates(plan, scenario_from(copy.deepcopy(DROP)), DROP)
    assert len(found) == 6  # the scenario's own tilt, too
    assert found[0][0] == "0.3 m, roll 45 deg, pitch 45 deg"
    for name, change in nonempty(found):
        fall = fall_of(scenario_from(apply_overrides(copy.deepcopy(DROP), change)))
        assert fall.height == pytest.approx(float(name.split()[0]), abs=1e-8), name


def test_a_slider_has_heights_alone_along_its_axis() -> None:
    tables = DROP | {
        "start": {"position": [0.0, 0.0, 0.8]}, "model": {"slider": [1.0, 0.0, -1.0]},
    }  # fmt: skip
    plan = plan_of(heights=[0.5])
    [(name, change)] = drop_candidates(plan, scenario_from(copy.deepcopy(tables)), tables)
    assert name == "0.5 m"
    moved = scenario_from(apply_overrides(copy.deepcopy(tables), change))
    assert fall_of(moved).height == pytest.approx(0.5, abs=1e-8)
    x, _, z = moved.start.position
    assert x == pytest.approx(0.8 - z)


def test_a_drop_is_used_from_its_fall_to_its_bounce() -> None:
    plan, scenario = plan_of(), scenario_from(copy.deepcopy(DROP))
    fall = fall_of(scenario)
    found = planned_drop(plan, scenario, DROP, 0.2)
    assert found.before == pytest.approx(min(plan.window.before, fall.duration))
    assert found.start.fallen == pytest.approx(fall.speed)
    assert found.start.velocity[2] == pytest.approx(-9.81 * (fall.duration - found.before))
    first, second, *_ = find_impacts(
        [flight_recording(fly(scenario_from(copy.deepcopy(DROP))), Path("drop"))], drops=True
    )
    assert 0.01 < found.after < second.touch - first.touch


def test_what_is_promised_is_what_a_fit_tells(tmp_path: Path) -> None:
    """Half widths to a third, of a drop that is flown, recorded and fitted."""
    (tmp_path / "drop.toml").write_text(TOML)
    plan = plan_of(heights=[0.757], rolls=[], pitches=[], count=1)
    found = plan_experiments(plan, tmp_path)
    [chosen], [(_, widths)] = found.chosen, found.alone
    assert chosen.name == "0.757 m, roll 45 deg, pitch 45 deg"
    assert "next best: 0.757 m" in found.sentence
    scenario = scenario_from(copy.deepcopy(DROP))
    log = flight_recording(fly(scenario_from(copy.deepcopy(DROP))), Path("drop"))
    kept = [one for one in log.channels if one.name in ("accelerometer", "gyroscope")]
    log = type(log)(log.path, log.format, tuple(kept))
    [impact] = [one for one in find_impacts([log], drops=True) if not one.refused]
    readings = impact_window(plan, scenario, [log], impact)
    fields = fields_of_plan(plan, scenario)
    fit = fit_impact(ImpactProblem(plan, scenario, DROP, fields, readings), starts=2, seed=0)
    told = [1.96 * one.deviation * fit.deviation(one.name) for one in fields if one.role == "free"]
    assert np.log(np.array(told) / widths) == pytest.approx(0.0, abs=0.3)


def test_what_does_not_fall_is_refused_in_one_line(tmp_path: Path) -> None:
    (tmp_path / "drop.toml").write_text(TOML.replace("thrust = 0.0", 'thrust = "hover"'))
    with pytest.raises(InputError, match=r"^thrust: must be 0 in the scenario of a drop"):
        plan_experiments(plan_of(), tmp_path)

"""Why a field is not told: by its own law a guard hides a wall, a stiff one is seen through."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from identification.rigs import LOSS, STIFFNESS, rig
from springback.identification.design.experiments import ExperimentPlan, plan_experiments
from springback.identification.sensitivity import (
    FieldSensitivity,
    field_sensitivities,
    hidden_behind,
    reason_untold,
)
from springback.identification.settings import FitPlan
from springback.identification.unknowns import Unknown, field_unknown
from springback.scenario.scenario import Scenario, scenario_from

FRICTION = "world.obstacles.0.surface.friction"


def scene(**hull: Any) -> Scenario:
    """Quad at a wall of 2e5 N/m^1.5 with a capsule in front, of some surface."""
    tables = rig()
    body = {"type": "capsule", "start": [0.2, -0.1, 0.0], "end": [0.2, 0.1, 0.0], "radius": 0.01}
    tables["vehicle"]["hulls"] = [body | ({"surface": hull} if hull else {})]
    del tables["model"]["contact_point"]
    return scenario_from(tables)


def field(name: str, scenario: Scenario) -> Unknown:
    return field_unknown(name, "factor 3", "free", scenario)


def test_a_guard_that_meets_everything_by_its_own_law_hides_the_wall() -> None:
    alone = scene(stiffness=400.0, in_series=False)
    why = hidden_behind(field(STIFFNESS, alone).path, alone)
    assert "vehicle.hulls.0.surface has in_series = false" in why
    assert "free vehicle.hulls.0.surface.stiffness" in why
    assert hidden_behind(field(LOSS, alone).path, alone) == why
    assert hidden_behind(field(FRICTION, alone).path, alone) == ""  # the wall's alone
    nothing = FieldSensitivity(0.0, "", 0.0)
    said = reason_untold(field(STIFFNESS, alone), nothing, alone)
    assert said == f"nothing that is flown depends on it: {why}"


def test_a_soft_guard_in_series_takes_nearly_all_of_the_depth() -> None:
    """Depths are as k^(-2/3): a thousandth of the stiffness leaves the wall a hundredth."""
    soft, stiff = scene(stiffness=200.0), scene(stiffness=2e5)
    why = hidden_behind(field(STIFFNESS, soft).path, soft)
    assert "takes 0.99 % of the depth" in why
    assert hidden_behind(field(STIFFNESS, stiff).path, stiff) == ""
    assert hidden_behind(field(STIFFNESS, scene()).path, scene()) == ""
    said = reason_untold(field(STIFFNESS, soft), FieldSensitivity(0.21, "", 0.0), soft)
    assert said.startswith("the sensors hardly see it: were all else known, 91 % of its")
    assert said.endswith(why)


def test_a_field_that_acts_like_another_is_told_with_its_name() -> None:
    """Residuals of a + b alone: each has its prior, and both a correlation of -1 in the limit."""
    names = [Unknown(name, "free", 0.0, 1.0, False, "", "") for name in ("a", "b", "c")]
    seen = np.array([[10.0, 10.0, 0.0], [0.0, 0.0, 0.5]])
    told = field_sensitivities(names, np.vstack([seen, np.eye(3)]), 3)
    assert [one.told for one in told] == pytest.approx([100.0, 100.0, 0.25])
    assert [one.rival for one in told] == ["b", "a", ""]
    assert told[0].correlation == pytest.approx(-100.0 / 101.0)
    said = reason_untold(names[0], told[0], scene())
    assert said.endswith("nearly what b does (correlation -0.99)")


def planned(tables: dict[str, Any], tmp_path: Any, free: dict[str, str]) -> ExperimentPlan:
    lines = [
        'vehicle = "navi"', "[start]", "velocity = [2.0, 0.0, 0.0]", "touch_distance = 0.2",
        "[[world.obstacles]]", 'type = "wall"', "distance = 3.0", 'surface = "wall"', "[sensors]",
    ]  # fmt: skip
    (tmp_path / "navi.toml").write_text("\n".join(lines))
    plan = FitPlan.model_validate({"scenario": "navi.toml", "free": free, **tables})
    return plan_experiments(plan, tmp_path)


def test_the_planner_says_that_navis_bumpers_hide_the_wall(tmp_path: Any) -> None:
    one = {"candidates": {"speeds": [2.0], "pitches": [0.0], "yaws": [0.0], "count": 1},
           "window": {"before": 0.1, "after": 0.05}}  # fmt: skip
    found = planned(one, tmp_path, {STIFFNESS: "factor 3", LOSS: "0.4 s/m factor 3"})
    assert found.sentence.startswith("no candidate tells more than is known")
    [said] = found.untold
    assert said.startswith(f"no candidate tells {STIFFNESS} (± 108 % now, ± 108 % after all) and ")
    assert "has in_series = false" in said
    bumper = {"vehicle.hulls.0.surface.stiffness": "factor 3", STIFFNESS: "factor 3"}
    helped = planned(one, tmp_path, bumper)
    assert helped.sentence.startswith("next best: ")
    assert len(helped.untold) == 1
    assert "vehicle.hulls.0.surface.stiffness (" not in helped.untold[0]

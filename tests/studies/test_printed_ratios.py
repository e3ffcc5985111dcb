"""Vehicles of headlines: masses, which arm is ahead, and what the page says of them."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

from springback.kernels.vectors import Vec, rotation
from springback.scenario.scenario import scenario_from
from springback.studies.recordings.printed_ratios import (
    FACTOR,
    FLEXIQUAD,
    FORCE_RATIO,
    FRAME_STIFFNESS,
    GLANCING,
    MASS_RATIO,
    PEAK_RATIO,
    SPEED,
    VehicleRatio,
    glancing_tables,
    hit_tables,
    locked_vehicle,
    one_arm_vehicle,
)
from springback.vehicle.library import VEHICLES

PAGE = Path(__file__).parents[2] / "docs" / "recordings.md"


def test_one_arm_slides_and_weighs_its_share_more() -> None:
    soft, rigid = (
        scenario_from({"vehicle": one_arm_vehicle(one), "thrust": 0.0}).vehicle
        for one in (True, False)
    )
    assert soft.mass == pytest.approx(MASS_RATIO * rigid.mass)
    assert [soft.arms.at("compliant", j) for j in range(4)] == [True, False, False, False]
    assert rigid.mass == VEHICLES["quad"].vehicle.mass
    assert not scenario_from({"vehicle": locked_vehicle("xplorer")}).vehicle.arms.compliant


@pytest.mark.parametrize("down", [False, True])
def test_the_sliding_arm_meets_the_obstacle_first(down: bool) -> None:
    yaw = -float(VEHICLES["quad"].vehicle.arms.directions[0])
    scenario = scenario_from(hit_tables(one_arm_vehicle(True), SPEED, down, yaw))
    state = scenario.start_state()
    arm = float(scenario.vehicle.arms.directions[0])
    ahead = rotation(state.attitude) @ Vec(math.cos(arm), math.sin(arm), 0.0)
    assert tuple(ahead) == pytest.approx((0.0, 0.0, -1.0) if down else (1.0, 0.0, 0.0), abs=1e-12)
    assert state.velocity @ ahead == pytest.approx(SPEED)


def test_a_glancing_hit_is_of_the_printed_mass_along_the_wall() -> None:
    scenario = scenario_from(glancing_tables(FRAME_STIFFNESS, GLANCING[0]))
    state = scenario.start_state()
    assert scenario.vehicle.mass == pytest.approx(FLEXIQUAD)
    assert math.hypot(*state.velocity) == pytest.approx(SPEED)
    assert math.atan2(state.velocity.x, state.velocity.y) == pytest.approx(GLANCING[0])


def test_the_page_divides_as_it_says() -> None:
    """Each row's ratio is that of its two numbers, and the verdict follows."""
    rows = re.findall(
        r"\| ([\d.]+) (?:N|m/s\S*) \| ([\d.]+) (N|m/s\S*) \| ([\d.]+) \| (.*?) \|$",
        PAGE.read_text(encoding="utf-8"), re.M,
    )  # fmt: skip
    assert len(rows) == 8
    for soft, rigid, unit, ratio, verdict in rows:
        found = VehicleRatio("", float(soft), float(rigid), "").value
        assert found == pytest.approx(float(ratio), rel=0.02)
        assert found < 1.0
        if verdict == "direction and factor":
            printed = FORCE_RATIO if unit == "N" else PEAK_RATIO
            assert printed / FACTOR <= found <= printed * FACTOR
    assert [verdict for *_, verdict in rows].count("direction and factor") == 5

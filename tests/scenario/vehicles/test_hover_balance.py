"""Vehicles that the equal thrusts of hover turn are warned of; balanced ones are not."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import springback
from builders.cases import nonempty
from springback.scenario.scenario import scenario_from
from springback.scenario.vehicles.hover_balance import balance_warnings, hover_turn
from springback.scenario.warnings import scenario_warnings
from springback.studies.scenario_check import check_warnings
from springback.vehicle.library import VEHICLES
from springback.vehicle.parameters import Vehicle


def tables(front: float, **more: Any) -> dict[str, Any]:
    """Four arms along the axes, one of them longer."""
    arms = {
        "directions": [0.0, "-90 deg", "180 deg", "90 deg"], "length": [front, 0.15, 0.15, 0.15],
        "mass": 0.02, "cage_radius": 0.07, "compliant": False, "torque_ratio": 0.013,
    }  # fmt: skip
    body = {"mass": 0.4, "inertia": [1.2e-3, 1.3e-3, 2e-3]}
    return {"vehicle": {"body": body, "arms": arms}, "thrust": "hover", **more}


def vehicle(front: float) -> Vehicle:
    return scenario_from(tables(front)).vehicle


def told(given: dict[str, Any]) -> list[str]:
    return [one for one in check_warnings(scenario_from(given)) if "leave a moment" in one]


def test_moment_and_turn_are_those_of_a_lever_and_point_masses() -> None:
    """Thrusts act at x = 0 on the mean; masses lie between: the moment is weight times offset."""
    moment, acceleration = hover_turn(vehicle(0.18), 9.81)
    offset = (0.03 / 4.0) - 0.02 * 0.03 / 0.48  # mean of the rotors, less the centre of mass [m]
    assert moment == pytest.approx([0.0, -0.48 * 9.81 * offset, 0.0], abs=1e-15)
    about = 1.3e-3 + 0.02 * (0.18**2 + 0.15**2) - 0.48 * (0.02 * 0.03 / 0.48) ** 2
    assert acceleration[1] == pytest.approx(moment[1] / about)


def test_a_flight_turns_as_fast_as_that() -> None:
    given = tables(0.18, simulation={"duration": 0.02}, start={"position": [0, 0, 5]})
    flight = springback.fly(given, executor="python")
    _, acceleration = hover_turn(vehicle(0.18), 9.81)
    rate = np.array([flight.columns[name][-1] for name in ("wx", "wy", "wz")])
    assert rate == pytest.approx(0.02 * acceleration, rel=1e-3, abs=1e-9)


def test_only_hover_without_a_pilot_is_told_of() -> None:
    [said] = told(tables(0.18))
    turn = 0.5 * math.degrees(abs(hover_turn(vehicle(0.18), 9.81)[1][1])) * 0.01
    assert said.startswith(
        'thrust: the equal thrusts of "hover" leave a moment of 0.0294 N m about'
    )
    assert f"about body y, by {turn:.3g} deg in the first 0.1 s" in said
    assert "[reference]" in said
    assert said in scenario_warnings(scenario_from(tables(0.18)))  # as a flight says it
    assert told(tables(0.15)) == []
    assert told(tables(0.152)) == []  # 0.4 deg
    assert told(tables(0.18) | {"thrust": [1.3, 1.0, 1.0, 1.4]}) == []
    assert told(tables(0.18, model={"slider": [1, 0, 0]})) == []
    piloted = tables(0.18, reference={"type": "hold"})
    piloted["vehicle"] |= {"propulsion": {"max_thrust": 3.0}}
    assert told(piloted) == []


def test_rotors_of_a_list_count_and_so_do_their_torques() -> None:
    spinning = tables(0.15)
    spinning["vehicle"]["arms"] |= {"spin": [1, 1, 1, -1], "torque_ratio": 0.013}
    [said] = told(spinning)
    assert "about body z" in said
    listed = tables(0.15)
    listed["vehicle"]["rotors"] = [{"on": j} for j in (1, 2, 4)]
    [said] = told(listed)
    assert "about body y" in said


def test_of_the_library_two_are_unbalanced() -> None:
    """One arm alone; rotors of Spiri 132 mm before and 121 mm behind the centre of mass."""
    found = {name: balance_warnings(one.vehicle, 9.81) for name, one in nonempty(VEHICLES.items())}
    assert {name for name, said in found.items() if said} == {"arq-lumped", "spiri"}
    [said] = found["spiri"]
    lever = 0.5 * (0.132 - 0.121)
    assert f"a moment of {0.933 * 9.81 * lever:.3g} N m" in said

"""Arms on joints that hover bends to their stops are warned of; others are not."""

from __future__ import annotations

import math
from typing import Any

import pytest
from click.testing import CliRunner

from builders.cases import nonempty
from springback.interfaces.cli.app import cli
from springback.scenario.scenario import scenario_from
from springback.scenario.vehicles.hover_rest import hover_warnings, resting_joints
from springback.scenario.warnings import scenario_warnings
from springback.vehicle.library import VEHICLES
from springback.vehicle.parameters import Vehicle

#: Mass of the whole and of an arm's end [kg], length of an arm [m], and hover's pull on it [N].
WHOLE, END, LENGTH = 1.0, 0.05, 0.15
PULL = 9.81 * (WHOLE / 4.0 - END)
UP = {"type": "slide", "direction": [0, 0, 1], "travel": [0, 0.02]}
FLAP = {"type": "hinge", "axis": [0, -1, 0], "travel": [-0.3, 0.3]}


def vehicle(joint: dict[str, Any], ratio: float = 0.0, **more: Any) -> Vehicle:
    """Four arms on a joint."""
    arms = {
        "directions": [0.7853981633974483, -0.7853981633974483, -2.356194490192345,
                       2.356194490192345],
        "length": LENGTH, "mass": END, "cage_radius": 0.08, "joint": joint, "torque_ratio": ratio,
    }  # fmt: skip
    body = {"mass": WHOLE - 4.0 * END, "inertia": [4e-3, 4e-3, 8e-3]}
    return Vehicle.model_validate({"body": body, "arms": arms, **more})


def rest(joint: dict[str, Any], ratio: float = 0.0, **more: Any) -> float:
    """Where the first joint of arm 1 rests [m] or [rad]."""
    return next(resting_joints(vehicle(joint, ratio, **more), 9.81)).pressed


def test_a_slide_up_rests_where_its_spring_holds_the_pull() -> None:
    assert rest({**UP, "stiffness": 500.0}) == pytest.approx(PULL / 500.0, abs=1e-7)
    assert rest({**UP, "stiffness": 500.0, "play": 0.004}) == pytest.approx(
        0.004 + PULL / 500.0, abs=1e-7
    )
    assert rest({**UP, "quadratic": 2e4}) == pytest.approx(math.sqrt(PULL / 2e4), abs=1e-7)
    held = {**UP, "table": [[0, 0], [0.01, PULL], [0.02, 3.0 * PULL]]}
    assert rest(held) == pytest.approx(0.01, abs=1e-6)
    # A preload takes its share, and holds the arm while it is the larger.
    assert rest({**UP, "stiffness": 500.0, "preload": 1.0}) == pytest.approx(
        (PULL - 1.0) / 500.0, abs=1e-6
    )
    assert rest({**UP, "stiffness": 500.0, "preload": PULL + 0.1}) == 0.0


def test_a_latch_holds_an_arm_or_lets_it_go() -> None:
    spring = {**UP, "stiffness": 110.0}
    strong = {**spring, "latch": {"force": PULL + 1.0, "travel": 0.002}}
    assert 0.0 < rest(strong) < 0.002
    weak = {**spring, "latch": {"force": 0.2 * PULL, "travel": 0.002}}
    assert 0.01 < rest(weak) < rest(spring)


def test_a_hinge_rests_where_torques_of_pull_and_spring_are_equal() -> None:
    """The thrust turns with the arm, its weight does not; about body z the rotor's torque acts."""
    angle = rest({**FLAP, "stiffness": 1.5})
    thrust = 9.81 * WHOLE / 4.0
    torque = LENGTH * (thrust - 9.81 * END * math.cos(angle))
    assert 1.5 * angle == pytest.approx(torque, rel=1e-5)
    level = {"type": "hinge", "axis": [0, 0, 1], "travel": [-0.5, 0.5], "stiffness": 0.1}
    assert abs(rest(level, ratio=0.01)) == pytest.approx(thrust * 0.01 / 0.1, rel=1e-5)


def test_rotors_that_are_listed_pull_the_arms_that_they_are_on() -> None:
    above = [{"on": j} for j in (1, 2, 3, 4)]
    assert rest({**UP, "stiffness": 500.0}, rotors=above) == pytest.approx(PULL / 500.0, abs=1e-7)
    spots = ((0.1, 0.1), (0.1, -0.1), (-0.1, -0.1), (-0.1, 0.1))
    inside = [{"on": "body", "position": [x, y, 0]} for x, y in spots]
    weight = {**UP, "travel": [-0.02, 0.02], "stiffness": 500.0}
    assert rest(weight, rotors=inside) == pytest.approx(-9.81 * END / 500.0, abs=1e-7)


def test_only_a_joint_at_its_stop_or_nearly_there_is_told() -> None:
    assert hover_warnings(vehicle({**UP, "stiffness": PULL / 0.017}), 9.81) == []
    [near] = hover_warnings(vehicle({**UP, "stiffness": PULL / 0.019}), 9.81)
    assert "vehicle.arms.joint: hover thrust moves arm 1" in near
    assert "by 19 mm, and its stop is at 20 mm" in near
    [beyond] = hover_warnings(vehicle({**UP, "stiffness": PULL / 0.025}), 9.81)
    assert "to its stop at 20 mm (its spring would hold it at 25 mm)" in beyond
    assert hover_warnings(vehicle({**UP, "stiffness": PULL / 0.025}), 1.62) == []  # on the moon
    rigid = vehicle({**UP, "stiffness": 1.0})
    rigid = rigid.model_copy(update={"arms": {"compliant": False}})
    assert hover_warnings(rigid, 9.81) == []


def test_of_the_library_morphy_alone_is_told_of() -> None:
    """Its rotors' torque turns the second hinges, whose law has no linear part, to their stops."""
    told = {name: hover_warnings(one.vehicle, 9.81) for name, one in nonempty(VEHICLES.items())}
    assert [name for name, said in told.items() if said] == ["morphy"]
    [said] = told["morphy"]
    assert "vehicle.arms.joint.second: hover thrust turns arm 1" in said
    assert "to its stop at 5.73 deg (its spring would hold it at 7.29 deg)" in said


def test_a_vehicle_that_hovers_is_told_of_and_one_that_falls_is_not() -> None:
    hovers = scenario_from({"vehicle": "morphy", "thrust": "hover"})
    assert any("hover thrust turns arm 1" in said for said in scenario_warnings(hovers))
    falls = scenario_from({"vehicle": "morphy", "start": {"position": [0, 0, 1]}})
    assert not any("hover thrust" in said for said in scenario_warnings(falls))
    shown = CliRunner().invoke(cli, ["show", "morphy", "--json"])
    assert "warning: vehicle.arms.joint.second: hover thrust" in shown.stderr
    assert shown.stdout.lstrip().startswith("{")
    assert CliRunner().invoke(cli, ["show", "xplorer"]).stderr == ""

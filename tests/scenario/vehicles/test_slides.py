"""Slides that lead outward are warned of; those through the vehicle's middle are refused."""

from __future__ import annotations

from typing import Any

import pytest

from builders.cases import nonempty
from springback.errors import InputError
from springback.scenario.scenario import scenario_from
from springback.scenario.vehicles.slides import slide_warnings
from springback.scenario.warnings import scenario_warnings
from springback.studies.scenario_check import check_warnings
from springback.vehicle.library import VEHICLES

LEGS = [0.2, 0, 1]


def tables(joint: dict[str, Any], **arms: Any) -> dict[str, Any]:
    """Four arms of 125 mm on a slide."""
    slide = {"type": "slide", "stiffness": "2 N/mm", "damping": 25.0, "travel": [0, "20 mm"]}
    own = {"length": "125 mm", "cage_radius": "70 mm", "joint": slide | joint}
    return {"vehicle": {"preset": "arq", "hull": {"radius": "30 mm"}, "arms": own | arms}}


def told(joint: dict[str, Any], **arms: Any) -> list[str]:
    return slide_warnings(scenario_from(tables(joint, **arms)).vehicle)


def test_a_slide_with_its_sign_turned_is_told_and_the_advised_one_is_not() -> None:
    given = scenario_from(tables({"direction": [1, 0, 0.5]}))
    [said] = slide_warnings(given.vehicle)
    assert said.startswith(
        "vehicle.arms.joint.direction: [1, 0, 0.5] leads outward, and travel, 0 m to 0.02 m, not "
        "inward: what meets the cage of arm 1 from outside presses it against its stop"
    )
    assert "[-1, 0, 0.5] leads inward" in said
    assert said in scenario_warnings(given)  # as a flight says it
    assert said in check_warnings(given)
    assert told({"direction": [-1, 0, 0.5]}) == []


@pytest.mark.parametrize(
    "joint",
    [
        {},  # along the arm, by default
        {"direction": [1, 0, 0.5], "travel": ["-10 mm", "20 mm"]},  # yields both ways
        {"direction": [0, 0, 1]},
        {"direction": LEGS},
        {"direction": [0.9, 0, 1]},
        {"direction": [0, 1, 0]},
        {"direction": [0.5, 1, 0]},
        {"direction": [-1, 0, -0.4]},  # along an arm that is raised
    ],
)
def test_slides_that_something_outside_presses_in_are_not_told(joint: dict[str, Any]) -> None:
    assert told(joint) == []
    assert told(joint, height="30 mm") == []


def test_arms_without_stops_or_that_are_rigid_are_not_told() -> None:
    assert told({"direction": [1, 0, 0.5]}, end_stops=False) == []
    assert told({"direction": [1, 0, 0.5]}, compliant=False) == []


def test_each_arm_and_each_joint_counts() -> None:
    ways = [[-1, 0, 0], [-1, 0, 0], [1, 0, 0], [-1, 0, 0]]
    [said] = told({"direction": ways})
    assert "[1, 0, 0] leads outward" in said
    assert "the cage of arm 3" in said
    carried = {"type": "slide", "direction": [1, 0, 0], "travel": [0, "9 mm"], "stiffness": 2e3}
    [said] = told({"direction": [0, 0, 1], "second": carried})
    assert said.startswith("vehicle.arms.joint.second.direction: [1, 0, 0] leads outward")


def test_no_preset_is_told() -> None:
    for name, entry in nonempty(VEHICLES.items()):
        assert slide_warnings(entry.vehicle) == [], name


@pytest.mark.parametrize(
    ("joint", "words"),
    [
        ({"direction": [-1, 0, 0], "travel": [0, "140 mm"]}, "less than 0.125 m, where the end of "
         "arm 1 comes to the vehicle's middle (got 0.14 m)"),
        ({"direction": [-2, 0, 1], "travel": [0, "140 mm"]}, "less than 0.139754 m"),
        ({"direction": [1, 0, 0], "travel": ["-130 mm", "20 mm"]}, "more than -0.125 m"),
        ({"direction": [1, 0, 0], "travel": [["-9 mm", "9 mm"]] * 3 + [["-0.13 m", "9 mm"]]},
         "the end of arm 4"),
    ],
)  # fmt: skip
def test_a_travel_beyond_the_middle_is_refused(joint: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError, match=r"vehicle\.arms\.joint\.travel: must be") as caught:
        scenario_from(tables(joint))
    assert words in str(caught.value)


def test_a_second_slide_beyond_the_middle_is_refused() -> None:
    carried = {"type": "slide", "travel": [0, "126 mm"], "stiffness": 2e3}
    with pytest.raises(InputError, match=r"\.joint\.second\.travel: must be less than"):
        scenario_from(tables({"direction": [0, 0, 1], "second": carried}))


@pytest.mark.parametrize(
    ("joint", "arms"),
    [
        ({"direction": [-1, 0, 0], "travel": [0, "124 mm"]}, {}),
        ({"direction": [-2, 0, 1], "travel": [0, "139 mm"]}, {}),
        ({"direction": [-0.2, 0, 1], "travel": [0, "700 mm"]}, {}),  # over it
        ({"direction": [-1, 0, 0], "travel": [0, "140 mm"]}, {"compliant": False}),
    ],
)
def test_a_travel_up_to_the_middle_is_flown(joint: dict[str, Any], arms: dict[str, Any]) -> None:
    assert scenario_from(tables(joint, **arms)).vehicle.arms.joint is not None

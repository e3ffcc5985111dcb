"""Vehicles that can be flown and are seldom meant: guards in each other, sizes and springs."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import springback
from builders.cases import nonempty
from springback.results.flight import as_scenario
from springback.scenario.vehicles.overlap import guard_overlaps
from springback.scenario.vehicles.range_check import opening_load, size_warnings
from springback.scenario.warnings import scenario_warnings
from springback.vehicle.parameters import Vehicle

HINGE = {
    "type": "hinge", "position": ["50 mm", 0, 0], "axis": [0, 0, 1], "travel": [0, "50 deg"],
    "stiffness": "1.5 N m/rad", "damping": 0.015,
}  # fmt: skip
STEP = 1e-4


def vehicle(*hulls: dict[str, Any], **more: Any) -> dict[str, Any]:
    """Arms forwards and to the left, 0.2 m long, their ends 0.283 m apart."""
    arms = {"directions": [0.0, "90 deg"], "length": 0.2, "mass": 0.03, "cage_radius": 0.07,
            "cages": not hulls, "compliant": False}  # fmt: skip
    arms |= more.pop("arms", {})
    return {
        "body": {"mass": 0.4, "inertia": [1e-3, 1e-3, 1.5e-3]}, "arms": arms, "hulls": [*hulls],
        **more,
    }  # fmt: skip


def made(*hulls: dict[str, Any], **more: Any) -> Vehicle:
    return Vehicle(**vehicle(*hulls, **more))


def ring(arm: int, radius: float, **more: Any) -> dict[str, Any]:
    return {"type": "ring", "on": arm, "radius": radius, **more}


APART = 0.2 * math.sqrt(2.0)
ALONG = np.array([-1.0, 1.0, 0.0]) / math.sqrt(2.0)
"""From the end of arm 1 to that of arm 2."""


@pytest.mark.parametrize(
    ("hulls", "depth"),
    [
        ((ring(1, 0.17), ring(2, 0.15)), 0.32 - APART),
        ((ring(1, 0.14), ring(2, 0.14)), None),  # 3 mm apart
        ((ring(1, 0.17), ring(2, 0.15, position=[0, 0, "8 mm"])), None),  # one above the other
        # Across each other: a plane along one of them is as far from the other's middle.
        ((ring(1, 0.17), ring(2, 0.15, axis=ALONG.tolist())), None),
        ((ring(1, 0.3), ring(2, 0.15, axis=ALONG.tolist())), 0.3 - APART),
        (({"type": "sphere", "on": 1, "radius": 0.2}, ring(2, 0.1)), 0.3 - APART),
        (
            (
                {"type": "sphere", "on": 1, "radius": 0.1},
                {"type": "capsule", "on": 2, "start": [0, 0, 0], "radius": 0.05,
                 "end": (-ALONG * 0.15).tolist()},
            ),
            0.15 + 0.15 - APART,
        ),
        (({"type": "sphere", "on": 1, "radius": 0.2}, {"type": "sphere", "on": 1, "radius": 0.2}), None),
        (({"type": "sphere", "on": 1, "radius": 0.2}, {"type": "sphere", "radius": 0.2}), None),
    ],
)  # fmt: skip
def test_guards_of_different_arms_are_as_deep_in_each_other_as_by_hand(
    hulls: tuple[dict[str, Any], ...], depth: float | None
) -> None:
    found = guard_overlaps(made(*hulls))
    if depth is None:
        assert found == []
    else:
        ((first, second, got),) = found
        assert got == pytest.approx(depth, rel=2e-3)
        assert f"the {hulls[0]['type']} on arm 1" in first
        assert f"the {hulls[1]['type']} on arm 2" in second


def test_a_hull_in_the_cage_of_another_arm_is_found() -> None:
    given = vehicle({"type": "sphere", "on": 1, "radius": 0.25}, arms={"cages": True})
    ((first, second, depth),) = guard_overlaps(Vehicle(**given))
    assert (first, second) == (
        "vehicle.hulls[0], the sphere on arm 1,", "the cage of arm 2",
    )  # fmt: skip
    assert depth == pytest.approx(0.32 - APART, rel=1e-3)


def test_two_balls_in_space_agree_with_their_radii() -> None:
    """Wherever they are: the depth is what the radii have more than the distance."""
    for height in nonempty((0.0, 0.05, -0.12)):
        low = {"type": "sphere", "on": 1, "radius": 0.17}
        high = {"type": "sphere", "on": 2, "radius": 0.16, "position": [0.01, -0.02, height]}
        ((_, _, depth),) = guard_overlaps(made(low, high))
        away = math.dist((0.2, 0.0, 0.0), (0.01, 0.18, height))
        assert depth == pytest.approx(0.33 - away, rel=1e-4)


def test_a_flight_and_its_check_name_the_deepest_pair() -> None:
    rings = [ring(1, 0.17), ring(2, 0.15), ring(2, 0.16)]
    scenario = as_scenario({"vehicle": vehicle(*rings), "second": {
        "vehicle": vehicle(*rings), "start": {"position": [0.0, 3.0, 1.0]},
    }})  # fmt: skip
    ours, theirs = scenario_warnings(scenario)
    assert ours.startswith(
        "vehicle.hulls[0], the ring on arm 1, and vehicle.hulls[2], the ring on arm 2, are 47.2 mm "
        "inside each other at rest, and 1 more pairs overlap: "
    )
    assert theirs == f"second: {ours}"


def test_nothing_in_the_library_is_seldom_meant() -> None:
    for name, entry in nonempty(springback.VEHICLES.items()):
        assert size_warnings(entry.vehicle, STEP) == [], name
        assert guard_overlaps(entry.vehicle) == [], name


def propelled(disc: float, *hulls: dict[str, Any], **more: Any) -> list[str]:
    propulsion = {"max_thrust": 9.0, "disk_radius": disc}
    return size_warnings(made(*hulls, propulsion=propulsion, **more), STEP)


def test_a_propeller_that_reaches_beyond_its_guard_is_told() -> None:
    assert propelled(0.07) == []
    (cage,) = propelled(0.09)
    assert cage.startswith(
        "vehicle.propulsion.disk_radius: propellers of 0.09 m reach 20 mm beyond the guard of arm 1 "
        "(vehicle.arms.cage_radius, 0.07 m)"
    )
    rings = [ring(1, 0.08), ring(2, 0.08, position=[0.01, 0, 0])]
    assert propelled(0.07, *rings) == []
    (moved,) = propelled(0.075, *rings)
    assert "reach 5 mm beyond the guard of arm 2 (vehicle.hulls[1].radius, 0.08 m)" in moved
    upright = [ring(1, 0.03, axis=[1, 0, 0]), ring(2, 0.08)]  # around no rotor
    assert propelled(0.07, *upright) == []
    listed = [{"on": 1, "position": [0.03, 0, 0]}, {"on": 2}]
    (aside,) = propelled(0.06, rotors=listed)
    assert "reach 20 mm beyond the guard of arm 1" in aside


def test_an_arm_longer_than_any_is_told() -> None:
    assert size_warnings(made(arms={"length": [0.2, 1.9]}), STEP) == []
    (said,) = size_warnings(made(arms={"length": [0.2, 17.0]}), STEP)
    assert said.startswith("vehicle.arms.length: 17 m of arm 2 is more than that of any micro")


def sprung(**joint: Any) -> list[str]:
    arms = {"compliant": True, "cage_radius": 0.05, "joint": {**HINGE, **joint}}
    return size_warnings(made(arms=arms), STEP)


def test_springs_in_another_unit_are_asked_about() -> None:
    assert sprung() == []
    (stiff,) = sprung(stiffness="1.5 N m/deg")
    assert "vehicle.arms.joint.stiffness: the spring of arm 1, 85.94 N m/rad to the end" in stiff
    assert "in N m/rad (85.94) or in N m/deg (1.5)?" in stiff
    (limp,) = sprung(stiffness=1.5 / 180.0 * math.pi)
    assert "gives way as if without a spring; is it meant in N m/rad (0.02618)" in limp
    slides = {"compliant": True, "stroke": 0.03}
    assert size_warnings(made(arms={**slides, "stiffness": "1 N/mm"}), STEP) == []
    (hard,) = size_warnings(made(arms={**slides, "stiffness": "1 MN/m"}), 1e-6)
    assert "vehicle.arms.stiffness: the spring of arm 1, 1e+06 N/m" in hard
    assert "in N/m (1e+06) or in N/mm (1000)?" in hard


def test_a_period_of_few_steps_is_told() -> None:
    arms = {"compliant": True, "stroke": 0.003, "mass": 1e-3, "stiffness": "50 N/mm"}
    period = math.tau * math.sqrt(1e-3 / 5e4)
    assert size_warnings(made(arms=arms), period / 20.1) == []
    (said,) = size_warnings(made(arms=arms), period / 10.0)
    assert said.startswith("vehicle.arms.stiffness: arm 1 swings on its spring, 5e+04 N/m, with a ")
    assert "10 of simulation.impact_step" in said


def test_an_arm_that_breaks_before_it_moves_is_told() -> None:
    latch = {"torque": "0.4 N m", "travel": "1 deg"}
    arms = {
        "compliant": True,
        "cage_radius": 0.05,
        "joint": {**HINGE, "latch": latch, "preload": 0.1},
    }
    opens = 0.5 + 1.5 * math.radians(1.0)
    limits = {"hinge_torque": opens + 1e-3}
    assert opening_load(made(arms=arms).arms, 0) == pytest.approx(opens)
    assert size_warnings(made(arms=arms, limits=limits), STEP) == []
    (said,) = size_warnings(made(arms=arms, limits={"hinge_torque": opens - 1e-3}), STEP)
    assert "vehicle.limits.hinge_torque: arm 1 does not move below 0.526 N m" in said
    assert opening_load(made(arms={**arms, "joint": HINGE}).arms, 0) == 0.0

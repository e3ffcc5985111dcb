"""A second joint on each arm from files: what is read, what is refused, what campaigns vary."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from springback.batch.scenarios import fly_scenarios
from springback.errors import InputError
from springback.results.flight import as_scenario, fly
from springback.vehicle.arms.bent import BentArm, BentCoordinates, bent_pose

SECOND = {
    "type": "hinge", "position": ["60 mm", 0, 0], "axis": [0, 1, 0], "travel": ["-30 deg", "40 deg"],
    "stiffness": "4 N m/rad", "damping": "0.01 N m s/rad",
}  # fmt: skip
HINGE = {
    "type": "hinge", "position": ["60 mm", 0, 0], "axis": [0, 0, 2], "travel": ["-30 deg", "60 deg"],
    "stiffness": "5 N m/rad", "damping": "0.02 N m s/rad", "second": SECOND,
}  # fmt: skip
SLIDE = {
    "type": "slide", "direction": [-1, 0, 0], "travel": [0, "20 mm"], "stiffness": "5 N/mm",
}  # fmt: skip


def tables(joint: dict[str, Any], **arms: Any) -> dict[str, Any]:
    return {
        "vehicle": {
            "body": {"mass": 1.0, "inertia": [8e-3, 9e-3, 16e-3]},
            "arms": {
                "directions": ["45 deg", "135 deg", "225 deg", "315 deg"], "length": 0.19,
                "mass": 0.05, "cage_radius": 0.11, "joint": joint, **arms,
            },
        },
        "world": {"obstacles": [{"type": "wall", "distance": 1.0, "surface": "wall"}]},
        "start": {"position": [0, 0, 1], "velocity": [2, 0, 0], "touch_distance": 1e-4},
        "simulation": {"duration": 0.003},
    }  # fmt: skip


def arms_of(joint: dict[str, Any], **arms: Any) -> tuple[BentArm, ...]:
    return as_scenario(tables(joint, **arms)).vehicle.airframe().arms


def test_both_hinges_are_springs_along_their_arcs() -> None:
    for arm in nonempty(arms_of(HINGE)):
        radius, second = 0.13, arm.second
        assert 1.0 / arm.joint.curvature == pytest.approx(radius)
        assert 1.0 / second.joint.curvature == pytest.approx(radius)
        assert arm.stiffness == pytest.approx(5.0 / radius**2)
        assert second.stiffness == pytest.approx(4.0 / radius**2)
        assert second.damping == pytest.approx(0.01 / radius**2)
        assert -second.shortest == pytest.approx(radius * math.radians(40.0))
        assert second.longest == pytest.approx(radius * math.radians(30.0))


def test_the_second_turns_by_the_right_hand_in_the_axes_of_the_first() -> None:
    """The first arm at 45 deg: by 30 deg about z, then by 20 deg about the axis to its left."""
    arm, radius = arms_of(HINGE)[0], 0.13
    pressed = BentCoordinates(
        arm.length - radius * math.radians(30.0), -radius * math.radians(20.0)
    )
    end = np.array(bent_pose(arm, pressed, 0.0).end)
    angle, down = math.radians(75.0), math.radians(20.0)
    along = np.array([math.cos(angle), math.sin(angle), 0.0]) * math.cos(down)
    hinge = 0.06 * np.array([math.cos(math.pi / 4), math.sin(math.pi / 4), 0.0])
    assert end == pytest.approx(hinge + radius * (along - np.array([0.0, 0.0, math.sin(down)])))


def test_a_stored_scenario_is_the_same() -> None:
    for joint in (HINGE, {**HINGE, "second": SLIDE}, {**SLIDE, "second": SECOND}):
        first = as_scenario(tables(joint))
        assert as_scenario(first.model_dump(mode="json")) == first


def test_each_arm_may_have_its_own_second_joint() -> None:
    """Numbers and vectors in lists, one for each arm."""
    axes = [[0, 1, 0], [0, 1, 0.2], [0, 1, 0.4], [0, 1, 0.6]]
    arms = arms_of({**HINGE, "second": {**SECOND, "axis": axes, "stiffness": [1, 2, 3, 4]}})
    ratio = [arm.second.stiffness / arm.second.joint.curvature**2 for arm in arms]
    assert ratio == pytest.approx([1.0, 2.0, 3.0, 4.0])
    tilt = [(arm.second.joint.direction ^ arm.second.joint.inward).z for arm in arms]
    assert tilt == pytest.approx([-math.sin(math.atan(x)) for x in (0.0, 0.2, 0.4, 0.6)], abs=1e-12)


def test_a_preload_holds_the_second_at_its_stop() -> None:
    held = {**SECOND, "travel": [0, "40 deg"], "preload": "0.6 N m"}
    given = tables({**HINGE, "second": held})
    given["start"].pop("touch_distance")
    given["model"] = {"arms": "always-free"}
    flight = fly(given, executor="python")
    strain = 0.6 / 0.13 / (2e5 + 4.0 / 0.13**2)
    assert flight.columns["bend1"][0] == pytest.approx(strain)
    assert np.ptp(flight.columns["bend1"]) < 1e-7


def test_a_campaign_varies_numbers_of_the_second_joint() -> None:
    """Traced in one pass, each flight is that of its own scenario, bit by bit."""
    made = []
    for k in range(3):
        more = {"stiffness": 3.0 + k, "travel": [f"-{20 + 5 * k} deg", "40 deg"]}
        made.append(tables({**HINGE, "second": {**SECOND, **more}}))
    together = fly_scenarios(made, threads=1)
    for k, one in enumerate(nonempty(made)):
        alone = fly(one, trajectory=False).measures
        for name in ("end_time", "arm_stroke", "peak_normal_force", "ledger_residual"):
            assert together.measures[name][k] == alone[name], name


@pytest.mark.parametrize(
    ("second", "message"),
    [
        ({**SECOND, "axis": [0, 0, 0]}, "joint.second.axis: must be of some length"),
        ({**SECOND, "axis": [0, 0, 1]}, "joint.second.axis: moves the end of arm 1 along itself or i"),
        ({**SECOND, "axis": [0, 0.05, 1]}, "joint.second.axis: moves the end of arm 1 along itself"),
        ({**SECOND, "travel": ["-30 deg", "89 deg"]}, "joint.second.axis: moves the end of arm 1 al"),
        ({**SECOND, "position": ["190 mm", 5, 0]}, "joint.second.position: must not lie on the end"),
        ({**SECOND, "travel": ["1 deg", "9 deg"]}, "joint.second.travel: must be from at most 0 to"),
        ({**SECOND, "travel": ["-200 deg", 1]}, "joint.second.travel: must be within half a turn"),
        ({**SECOND, "stiffness": "5 N/mm"}, "joint.second.stiffness: has the wrong unit (got '5 N"),
        ({**SECOND, "stiffness": 0}, "joint.second.stiffness: of arm 1 is missing: nothing would"),
        ({**SECOND, "stiffness": [1, 2]}, "joint.second.stiffness: has 2 entries for 4 arms"),
        ({**SECOND, "play": 2}, "joint.second.play: must be less than the travel, 40 deg"),
        ({**SECOND, "preload": 0.1}, "joint.second.preload: needs the end stop at the free positi"),
        ({**SECOND, "table": [[0, 0], [1, 2]]}, "joint.second.stiffness: cannot be combined with t"),
        (
            {**SECOND, "stiffness": 0, "table": [[0, 0], [0.1, 5], [0.2, 4]]},
            "joint.second.table[2]: must be at least 5 N m, the one before: a spring that gets weak",
        ),
        (
            {**SECOND, "latch": {"torque": 1, "travel": 0.1}},
            "joint.second.latch: needs the end stop at the free ",
        ),
        ({**SECOND, "type": "hing"}, "joint.second.type: must be slide or hinge (got 'hing'); did"),
        ({**SECOND, "stifness": 1}, "joint.second.stifness: unknown key; did you mean stiffness?"),
        ({**SECOND, "second": SECOND}, "joint.second.second: unknown key"),
        ({**SECOND, "rotors": "body"}, "joint.second.rotors: unknown key"),
        ({**SLIDE, "direction": [0, 1, 0]}, "joint.second.direction: moves the end of arm 1 along"),
    ],
)  # fmt: skip
def test_wrong_second_joints_are_refused_in_one_line(second: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError) as caught:
        as_scenario(tables({**HINGE, "second": second}))
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)

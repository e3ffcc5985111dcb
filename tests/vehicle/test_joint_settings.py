"""Joints of arms from files: what is read, what is refused, and what campaigns vary."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from springback.batch.scenarios import fly_scenarios
from springback.errors import InputError
from springback.results.flight import as_scenario, fly
from springback.vehicle.arms.joints import JointedArm, joint_pose
from springback.vehicle.arms.neighbours import neighbour_load

HINGE = {
    "type": "hinge", "position": ["60 mm", 0, 0], "axis": [0, 0, 2], "travel": ["-30 deg", "60 deg"],
    "stiffness": "5 N m/rad", "damping": "0.02 N m s/rad",
}  # fmt: skip
LATCHED = {**HINGE, "travel": [0, "60 deg"], "latch": {"torque": "2 N m", "travel": "1 deg"}}
SLIDE = {"type": "slide", "direction": [0, 0, 3], "travel": [0, "20 mm"], "stiffness": "5 N/mm"}


def vehicle(joint: dict[str, Any], **arms: Any) -> dict[str, Any]:
    return {
        "body": {"mass": 1.0, "inertia": [8e-3, 9e-3, 16e-3]},
        "arms": {
            "directions": ["45 deg", "135 deg", "225 deg", "315 deg"], "length": 0.19, "mass": 0.05,
            "cage_radius": 0.11, "joint": joint, **arms,
        },
    }  # fmt: skip


def tables(joint: dict[str, Any], **arms: Any) -> dict[str, Any]:
    wall = {"type": "wall", "distance": 1.0, "surface": "wall"}
    return {
        "vehicle": vehicle(joint, **arms),
        "world": {"obstacles": [wall]},
        "start": {"position": [0, 0, 1], "velocity": [2, 0, 0], "touch_distance": 1e-4},
        "simulation": {"duration": 0.004},
    }


def arms_of(joint: dict[str, Any], **arms: Any) -> tuple[JointedArm, ...]:
    return as_scenario(tables(joint, **arms)).vehicle.airframe().arms


def test_a_hinge_is_a_spring_along_the_arc_of_the_arms_end() -> None:
    for arm in nonempty(arms_of(HINGE)):
        radius = 0.13
        assert 1.0 / arm.joint.curvature == pytest.approx(radius)
        assert arm.stiffness == pytest.approx(5.0 / radius**2)
        assert arm.damping == pytest.approx(0.02 / radius**2)
        assert arm.length - arm.shortest == pytest.approx(radius * math.radians(60.0))
        assert arm.longest - arm.length == pytest.approx(radius * math.radians(30.0))


def test_pressed_in_it_turns_by_the_right_hand_about_its_axis() -> None:
    """The first arm, at 45 deg about z, pressed in by 30 deg: at 45 + 30 deg from the hinge."""
    arm = arms_of(HINGE)[0]
    pressed = arm.length - 0.13 * math.radians(30.0)
    end = joint_pose(arm, pressed, 0.0).end
    hinge = 0.06 * np.array([math.cos(math.pi / 4), math.sin(math.pi / 4), 0.0])
    angle = math.radians(75.0)
    assert np.array(end) == pytest.approx(
        hinge + 0.13 * np.array([math.cos(angle), math.sin(angle), 0])
    )


def test_a_slide_moves_where_it_says() -> None:
    for arm in nonempty(arms_of(SLIDE, height="-5 mm")):
        free, pressed = (joint_pose(arm, arm.length - s, 0.0).end for s in (0.0, 0.01))
        assert np.array(pressed - free) == pytest.approx([0.0, 0.0, 0.01])
        assert free.z == pytest.approx(-0.005)


def test_a_stored_scenario_is_the_same() -> None:
    for joint in (HINGE, SLIDE, {**SLIDE, "stiffness": 0, "table": [[0, 0], ["20 mm", "50 N"]]}):
        first = as_scenario(tables(joint))
        assert as_scenario(first.model_dump(mode="json")) == first


def test_a_preset_takes_a_joint() -> None:
    """Its stiffness, damping and stroke are of its slides, and do not stand in the way."""
    given = {**tables(HINGE), "vehicle": {"preset": "arq", "arms": {"joint": HINGE}}}
    [arm, *_] = as_scenario(given).vehicle.airframe().arms
    assert isinstance(arm, JointedArm)
    assert arm.damping == pytest.approx(0.02 / 0.13**2)


def test_raised_ends_alone_are_arms_on_joints() -> None:
    given = tables(HINGE)
    given["vehicle"]["arms"] |= {"joint": None, "height": "30 mm", "stiffness": "5 N/mm"}
    [arm, *_] = as_scenario(given).vehicle.airframe().arms
    assert isinstance(arm, JointedArm)
    assert arm.joint.curvature == 0.0
    flight = fly(given, executor="python")
    assert flight.columns["wy"][-1] < 0.0  # pushed above the centre of mass: the nose goes up
    assert abs(flight.measures["ledger_residual"] or 0.0) < 1e-6


def test_a_preload_holds_the_arm_at_its_stop() -> None:
    slide = {"type": "slide", "travel": [0, "20 mm"], "stiffness": "2 N/mm", "preload": "6 N"}
    given = tables(slide)
    given["start"].pop("touch_distance")
    given["model"] = {"arms": "always-free"}
    flight = fly(given, executor="python")
    assert np.ptp(flight.columns["l1"]) < 1e-9
    assert flight.columns["l1"][0] == pytest.approx(0.19 + 6.0 / 2.02e5)


@pytest.mark.parametrize(
    ("joint", "message"),
    [
        ({**HINGE, "axis": [0, 0, 0]}, "joint.axis: must be of some length (got [0.0, 0.0, 0.0])"),
        (
            {**HINGE, "axis": [[0, 0, 1], [0, 0, 1], [0, 0, 0], [0, 0, 1]]},
            "joint.axis: of arm 3 must be of some length (got [0.0, 0.0, 0.0])",
        ),
        (
            {**HINGE, "axis": [2, 0, 0]},
            "joint.axis: must not be along arm 1, through its end: the arm would turn about itself "
            "(got [2.0, 0.0, 0.0])",
        ),
        (
            {**HINGE, "position": ["190 mm", 0, 5]},
            "joint.position: must not lie on the end of arm 1, nor its axis go through it (got [0.19, "
            "0.0, 5.0] m)",
        ),
        ({**HINGE, "position": [0.19, 0, 0]}, "joint.position: must not lie on the end of arm 1"),
        ({**HINGE, "travel": ["10 deg", "60 deg"]}, "joint.travel: must be from at most 0 to more"),
        ({**HINGE, "travel": ["-200 deg", "60 deg"]}, "joint.travel: must be within half a turn"),
        ({**HINGE, "stiffness": "5 N/mm"}, "joint.stiffness: has the wrong unit (got '5 N/mm'); "),
        ({**LATCHED, "travel": ["-1 deg", "60 deg"]}, "joint.latch: needs the end stop at the free "),
        (
            {**LATCHED, "latch": {"torque": 1, "travel": "70 deg"}},
            "joint.latch.travel: must be less than the travel of the arm, 60 deg: it would meet",
        ),
        ({**LATCHED, "latch": {"force": 1, "travel": 0.1}}, "joint.latch.force: unknown key; known keys: torque, travel"),
        ({**LATCHED, "latch": {"torque": 0, "travel": 0.1}}, "joint.latch.torque: must be more than"),
        ({**HINGE, "stiffness": 0}, "joint.stiffness: of arm 1 is missing: nothing would bring it"),
        ({**HINGE, "stiffness": [1, 2]}, "joint.stiffness: has 2 entries for 4 arms"),
        ({**HINGE, "play": 2}, "joint.play: must be less than the travel, 60 deg"),
        ({**HINGE, "preload": 0.1}, "joint.preload: needs the end stop at the free position"),
        ({**HINGE, "one_sided": True}, "joint.travel: must begin at 0 rad with one_sided"),
        ({**HINGE, "table": [[0, 0], [1, 2]]}, "joint.stiffness: cannot be combined with table"),
        ({**HINGE, "type": "hing"}, "joint.type: must be slide or hinge (got 'hing'); did you mean"),
        ({**HINGE, "stifness": 1}, "joint.stifness: unknown key; did you mean stiffness?"),
        ({**SLIDE, "direction": [0, 0, 0]}, "joint.direction: must be of some length (got [0.0,"),
        (
            {**SLIDE, "stiffness": 0, "table": [[0, 0], [0.01, 5], [0.02, 4]]},
            "joint.table[2]: must be at least 5 N, the one before: a spring that gets weaker",
        ),
        (
            {**SLIDE, "stiffness": 0, "table": [[0, 0], [0.01, -5]]},
            "joint.table[1]: must be at least 0 N (got -5 N)",
        ),
    ],
)  # fmt: skip
def test_wrong_joints_are_refused_in_one_line(joint: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError) as caught:
        as_scenario(tables(joint))
    [line] = caught.value.problems
    assert f"vehicle.arms.{message}" in line


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ({"arms": {"stiffness": 100}}, "vehicle.arms.stiffness: cannot be combined with a joint"),
        ({"arms": {"cage_radius": 0.2}}, "lets their cages overlap: radii of 0.4 m together"),
        ({"model": {"contact_point": "paper"}}, "model.contact_point: must be ring for arms on"),
    ],
)
def test_what_joints_cannot_be_combined_with_is_said(more: dict[str, Any], message: str) -> None:
    given = tables(HINGE, **more.pop("arms", {})) | more
    with pytest.raises(InputError) as caught:
        as_scenario(given)
    assert any(message in line for line in caught.value.problems), caught.value.problems


def test_numbers_of_a_joint_can_be_varied() -> None:
    """Rows of other stiffness and axis are single flights, bit for bit."""
    rows = []
    for k in range(9):
        given = tables({**HINGE, "stiffness": 4.0 + k, "axis": [0.1 * k, 0, 1]})
        rows.append(given)
    together = fly_scenarios(rows, threads=1)
    found = np.asarray(together.measures["impact_arm_stroke"])
    assert len(set(found)) == len(rows)
    for k in (0, 4, 8):
        assert fly(rows[k], trajectory=False).measures["impact_arm_stroke"] == found[k]


def test_a_hinge_bears_a_torque() -> None:
    """The margin is that of a force at the end of the arm, of torque over radius."""
    given = tables(HINGE)
    margins = []
    for limit in ({"hinge_torque": "2.6 N m"}, {"arm_force": "20 N"}):
        given["vehicle"]["limits"] = limit
        margins.append(fly(given, trajectory=False).measures["arm_margin"])
    assert margins[0] is not None
    assert margins[0] == pytest.approx(margins[1], rel=1e-12)


@pytest.mark.parametrize(
    ("joint", "limits", "message"),
    [
        (SLIDE, {"hinge_torque": 2}, "vehicle.limits.hinge_torque: needs compliant arms on hinges"),
        (HINGE, {"hinge_torque": 2, "arm_force": 2}, "hinge_torque: cannot be combined with arm_f"),
        (HINGE, {"hinge_torque": "2 N"}, "hinge_torque: has the wrong unit"),
        (HINGE, {"hinge_torque": [1, 2]}, "hinge_torque: has 2 entries for 4 arms"),
    ],
)
def test_wrong_torques_are_refused(
    joint: dict[str, Any], limits: dict[str, Any], message: str
) -> None:
    given = tables(joint)
    given["vehicle"]["limits"] = limits
    with pytest.raises(InputError) as caught:
        as_scenario(given)
    assert message in caught.value.problems[0]


# -- springs between arms --------------------------------------------------------------------------

BETWEEN = {"stiffness": "2 N/mm", "damping": "5 N s/m"}


def test_springs_between_arms_are_free_at_rest() -> None:
    """Each as long as its ends are apart, and as many as there are arms."""
    airframe = as_scenario(tables(HINGE, neighbours=BETWEEN)).vehicle.airframe()
    springs = airframe.neighbours.springs
    assert [spring.stiffness for spring in springs] == [2e3] * 4
    assert [spring.distance for spring in springs] == pytest.approx([0.19 * math.sqrt(2.0)] * 4)
    lengths = tuple(arm.length for arm in airframe.arms)
    still = neighbour_load(airframe.neighbours, airframe.arms, lengths, (0.0,) * 4)
    assert np.abs(np.array(still.pulls)).max() < 1e-12
    assert still.loss == 0.0


def test_an_arm_that_is_pressed_in_is_pushed_out_by_its_neighbours() -> None:
    """And they are drawn in, as much as geometry says; forces on all add up to zero."""
    airframe = as_scenario(tables(SLIDE | {"direction": [-1, 0, 0]}, neighbours=BETWEEN)).vehicle
    airframe = airframe.airframe()
    lengths = (0.18, 0.19, 0.19, 0.19)
    pulls = np.array(neighbour_load(airframe.neighbours, airframe.arms, lengths, (0.0,) * 4).pulls)[
        :, 0
    ]
    slack = 0.19 * math.sqrt(2.0) - math.hypot(0.18, 0.19)
    first, second = np.array([math.sqrt(0.5)] * 2), np.array([-math.sqrt(0.5), math.sqrt(0.5)])
    away = 0.18 * first - 0.19 * second
    push = 2e3 * slack * away / np.linalg.norm(away)
    assert pulls[1][:2] == pytest.approx(-push)
    assert pulls[0][:2] @ first == pytest.approx(2.0 * push @ first)
    assert pulls[0][:2] @ first > 0.0
    assert np.abs(pulls[2]).max() < 1e-12
    assert pulls.sum(axis=0) == pytest.approx([0.0] * 3, abs=1e-12)


def test_two_arms_have_one_spring() -> None:
    two = {"directions": ["0 deg", "180 deg"], "neighbours": BETWEEN}
    springs = as_scenario(tables(SLIDE, **two)).vehicle.airframe().neighbours.springs
    assert [spring.stiffness for spring in springs] == [2e3, 0.0]


@pytest.mark.parametrize(
    ("arms", "message"),
    [
        ({"directions": [0.3]}, "arms.neighbours: needs two arms or more"),
        (
            {"directions": ["45 deg", "225 deg", "135 deg", "315 deg"]},
            "arms.directions: needs arms in their order around the body",
        ),
        ({"compliant": False}, "arms.neighbours: needs an arm that is compliant"),
        ({"neighbours": {"stiffness": 0}}, "arms.neighbours.stiffness: must be more than 0 N/m"),
    ],
    ids=["one arm", "order", "rigid", "stiffness"],
)
def test_springs_between_arms_that_cannot_be(arms: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message):
        as_scenario(tables(SLIDE, **{"neighbours": BETWEEN, **arms}))


def test_campaigns_vary_springs_between_arms_and_latches() -> None:
    """Rows of other numbers are single flights, bit for bit."""
    rows = [
        tables(
            {**LATCHED, "latch": {"torque": 1.0 + 0.5 * k, "travel": f"{1 + 0.1 * k} deg"}},
            neighbours={"stiffness": 1e3 + 500.0 * k, "damping": k},
        )
        for k in range(9)
    ]
    together = np.asarray(fly_scenarios(rows, threads=1).measures["impact_arm_stroke"])
    assert len(set(together)) == len(rows)
    for k in (0, 4, 8):
        assert fly(rows[k], trajectory=False).measures["impact_arm_stroke"] == together[k]

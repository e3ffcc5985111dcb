"""Arms that are unlike each other: travel, table, latch and one-sided springs of each its own."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from springback.batch.scenarios import fly_scenarios
from springback.errors import InputError
from springback.interfaces.replay.arm_shapes import arm_shapes
from springback.results.flight import Flight, as_scenario, fly

#: Of arq's arms: front left, front right, rear right, rear left.
DIRECTIONS = [0.25 * math.pi, -0.25 * math.pi, -0.75 * math.pi, 0.75 * math.pi]
MIRRORED = [1, 0, 3, 2]
SOFT = [[0.0, 0.0], [5e-3, 10.0], [30e-3, 90.0]]
#: Of each arm what `JOINT` has a list of.
EACH: list[dict[str, Any]] = [
    {"travel": [0.0, 0.02], "one_sided": True, "stiffness": 5e3, "damping": 30.0, "table": [],
     "latch": {"force": 20.0, "travel": 1e-3}},
    {"travel": [0.0, 0.03], "one_sided": False, "stiffness": 0.0, "damping": 40.0, "table": SOFT,
     "latch": {"force": 0.0, "travel": 1e-3}},
    {"travel": [-0.01, 0.025], "one_sided": False, "stiffness": 4e3, "damping": 20.0, "table": [],
     "latch": {"force": 0.0, "travel": 2e-3}},
    {"travel": [0.0, 0.04], "one_sided": True, "stiffness": 0.0, "damping": 10.0, "table": SOFT,
     "latch": {"force": 12.0, "travel": 2e-3}},
]  # fmt: skip
SLIDE = {"type": "slide", "direction": [-1.0, 0.0, 0.2]}


def listed(each: list[dict[str, Any]]) -> dict[str, Any]:
    """A joint with the lists of what each arm has."""
    found: dict[str, Any] = {key: [one[key] for one in each] for key in each[0] if key != "latch"}
    latch = {key: [one["latch"][key] for one in each] for key in ("force", "travel")}
    return {**SLIDE, **found, "latch": latch}


def alike(one: dict[str, Any]) -> dict[str, Any]:
    """A joint all of whose arms are like one, written as if there were no others."""
    joint = {**SLIDE, **one, "table": one["table"] or None}
    return {**joint, "latch": one["latch"] if one["latch"]["force"] else None}


def tables(joint: dict[str, Any], **more: Any) -> dict[str, Any]:
    """ARQ with other arms, into a wall at 2 m/s."""
    wall = {"type": "wall", "distance": 1.0, "surface": {"preset": "wall", "friction": 0.3}}
    return {
        "vehicle": {"preset": "arq", "arms": {"joint": joint}},
        "world": {"gravity": 0, "obstacles": [wall]},
        "thrust": 0.0,
        "start": {"position": [0, 0, 1], "velocity": [2.0, 0.2, 0.1], "touch_distance": 1e-4},
        "simulation": {"duration": 0.02},
        **more,
    }  # fmt: skip


def against_arm(k: int, joint: dict[str, Any]) -> Flight:
    """A hit with one arm ahead, which alone yields."""
    given = tables(joint)
    given["vehicle"]["arms"]["compliant"] = [j == k for j in range(4)]
    given["start"] |= {"yaw": -DIRECTIONS[k], "pitch": 0.1}
    return fly(given, executor="python")


@pytest.mark.parametrize("k", range(4))
def test_a_hit_of_one_arm_is_that_of_a_vehicle_whose_arms_are_all_like_it(k: int) -> None:
    """To rounding: an arm without table or latch beside others has one of no force."""
    one, other = against_arm(k, listed(EACH)), against_arm(k, alike(EACH[k]))
    for name, values in nonempty(one.columns.items()):
        assert values == pytest.approx(other.columns[name], rel=1e-11, abs=1e-11), name
    pressed = 0.19 - one.columns[f"l{k + 1}"].min()
    assert pressed > 2.0 * EACH[k]["latch"]["travel"]
    assert abs(one.measures["ledger_residual"] or 0.0) < 1e-6


def test_the_mirror_image_of_unlike_arms_flies_the_mirror_image() -> None:
    """In the plane of x and z: arms change places, and sideways and turns change sign."""
    given = tables(listed(EACH))
    given["start"] |= {"yaw": 0.1, "roll": -0.05, "pitch": 0.1}
    other = tables(listed([EACH[j] for j in MIRRORED]))
    other["start"] |= {"yaw": -0.1, "roll": 0.05, "pitch": 0.1, "velocity": [2.0, -0.2, 0.1]}
    one, two = (fly(each, executor="python") for each in (given, other))
    for j in nonempty(range(4)):
        mine, theirs = one.columns[f"l{j + 1}"], two.columns[f"l{MIRRORED[j] + 1}"]
        assert mine == pytest.approx(theirs, abs=1e-9)
    for name, sign in (("x", 1), ("y", -1), ("z", 1), ("wx", -1), ("wy", 1), ("wz", -1)):
        assert one.columns[name] == pytest.approx(sign * two.columns[name], abs=1e-6), name
    assert np.abs(one.columns["wz"]).max() > 0.5
    pressed = [0.19 - one.columns[f"l{j}"].min() for j in (1, 2)]
    assert min(pressed) > 2e-3
    assert abs(one.measures["ledger_residual"] or 0.0) < 1e-6


def test_compiled_and_among_others_it_is_the_same_flight() -> None:
    """Bit for bit what plain Python flies; what differs is set up in one pass."""
    cases = []
    for k in range(3):
        each = [{**one, "travel": [one["travel"][0], one["travel"][1] + 1e-3 * k]} for one in EACH]
        each[0]["latch"] = {"force": 20.0 + k, "travel": 1e-3}
        cases.append(tables(listed(each), simulation={"duration": 0.003}))
    plain = fly(cases[1], executor="python", trajectory=False).measures
    assert fly(cases[1], trajectory=False).measures == plain
    together = fly_scenarios(cases, threads=1).measures
    for k, case in enumerate(nonempty(cases)):
        alone = fly(case, trajectory=False).measures
        assert together["peak_acceleration"][k] == alone["peak_acceleration"]
        assert together["arm_stroke"][k] == alone["arm_stroke"]


def test_second_joints_have_lists_too() -> None:
    hinge = {"type": "hinge", "position": [0.06, 0, 0], "axis": [0, 1, 0], "travel": [-0.3, 0.6],
             "stiffness": 3.0}  # fmt: skip
    ways = [[-0.1 * k, 0.2 + 0.1 * k] for k in range(4)]
    second = {**hinge, "axis": [0, 0, 1], "travel": ways, "one_sided": [True, False, False, False]}
    arms = as_scenario(tables({**hinge, "second": second})).vehicle.airframe().arms
    for arm, (low, high) in nonempty(zip(arms, ways, strict=True)):
        assert arm.second.longest == pytest.approx(-0.13 * low)
        assert arm.second.shortest == pytest.approx(-0.13 * high)
    assert [arm.second.spring.both_sides for arm in arms] == [0.0, 1.0, 1.0, 1.0]


def test_latches_that_hold_nothing_are_not_drawn() -> None:
    vehicle = as_scenario(tables(listed(EACH))).vehicle
    shapes = arm_shapes(vehicle.airframe(), vehicle)
    assert [len(shape.latch) for shape in shapes] == [1, 0, 0, 1]
    assert vehicle.arms.joint is not None
    assert vehicle.arms.joint.differs


def test_a_stored_scenario_is_the_same() -> None:
    first = as_scenario(tables(listed(EACH)))
    assert as_scenario(first.model_dump(mode="json")) == first


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"travel": [[0, 0.01], [0, 0.02]]}, "travel: has 2 entries for 4 arms"),
        (
            {"travel": [[0, 0.02], [0, 0.02], [0.001, 0.02], [0, 0.02]]},
            "travel: of arm 3 must be from at most 0 to more than 0 m, the free position being 0",
        ),
        ({"travel": [[0, "1 N"], [0, 1], [0, 1], [0, 1]]}, "travel[0]: has the wrong unit"),
        ({"travel": [[0, 0.01], 3, 4, 5]}, "travel[1]: must be two numbers in m (got 3)"),
        ({"one_sided": True}, "travel: of arm 3 must begin at 0 m with one_sided"),
        ({"one_sided": [True]}, "one_sided: has 1 entries for 4 arms"),
        ({"one_sided": [1, 0, 0, 0]}, "one_sided: must be true or false, or a list of them"),
        ({"table": [[], SOFT]}, "table: has 2 entries for 4 arms"),
        ({"table": [[], SOFT, [], [[1, 2]]]}, "table[3]: must be 2 to 64 pairs in m and N"),
        ({"table": [[], SOFT, [], []]}, "stiffness: of arm 4 is missing: nothing would bring it"),
        ({"stiffness": 1e3}, "stiffness: cannot be combined with table; give only one"),
        ({"latch": {"force": [1, 0], "travel": 0.001}}, "latch.force: has 2 entries for 4 arms"),
        (
            {"latch": {"force": [0, 0, 0, 0], "travel": 0.001}},
            "latch.force: must be more than 0 N, for at least one arm (got 0)",
        ),
        ({"latch": {"force": [0, 0, 5, 0], "travel": 0.001}}, "latch: needs the end stop at the"),
        (
            {"latch": {"force": [5, 0, 0, 5], "travel": [0.001, 0.1, 0.1, 0.05]}},
            "latch.travel: must be less than the travel of the arm, 0.04 m: it would meet its stop",
        ),
    ],
)
def test_lists_that_cannot_be_are_refused_in_one_line(change: Any, message: str) -> None:
    with pytest.raises(InputError) as caught:
        as_scenario(tables({**listed(EACH), **change}))
    [line] = caught.value.problems
    assert line.startswith(f"vehicle.arms.joint.{message}"), line

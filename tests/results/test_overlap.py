"""Cages of one vehicle that come into each other are told."""

from typing import Any

import numpy as np
import pytest

import springback
from springback.errors import OverlapWarning
from springback.results.joints.overlap import end_positions
from springback.vehicle.arms.joints import path_point

FOLDING = {
    "type": "hinge", "position": [0.06, 0.0, 0.0], "axis": [0, 0, 1], "travel": [-1.5, 1.5],
    "stiffness": 0.1, "damping": 0.002,
}  # fmt: skip


def tables(stiffness: float) -> dict[str, Any]:
    return {
        "vehicle": {"preset": "arq", "arms": {"joint": FOLDING | {"stiffness": stiffness}}},
        "thrust": "hover",
        "start": {"position": [2.3, 0.0, 1.0], "velocity": [3.0, 0.0, 0.0]},
        "world": {"obstacles": [{"type": "wall", "distance": 2.75, "surface": "wall"}]},
        "simulation": {"duration": 0.2},
    }


def test_arms_that_fold_through_each_other_are_told() -> None:
    with pytest.warns(OverlapWarning, match=r"cages of arms \d and \d came [\d.]+ mm into each"):
        flight = springback.fly(tables(0.1))
    arms = flight.scenario.vehicle.arms
    ends = [
        end_positions(flight.scenario.vehicle, j, flight.columns[f"l{j + 1}"]) for j in range(4)
    ]
    for j, found in enumerate(ends):  # by the path that the kernels follow
        for k in (0, len(found) // 2, -1):
            way = float(flight.columns[f"l{j + 1}"][k]) - float(arms.at("length", j))
            np.testing.assert_allclose(found[k], path_point(arms.joint_of(j), way).end, atol=1e-12)


def test_stiff_arms_stay_apart() -> None:
    flight = springback.fly(tables(20.0))
    assert OverlapWarning not in flight.remarks


def test_cages_at_different_heights_pass_over_each_other() -> None:
    """In plan they overlap by 14 mm from the start; at one height such a vehicle is refused."""
    given = tables(20.0)
    arms = {"height": [0.0, 0.03, 0.0, 0.03], "cage_radius": 0.12, "length": 0.16}
    given["vehicle"]["arms"] = arms
    given["simulation"]["duration"] = 0.05
    flight = springback.fly(given)
    ends = [end_positions(flight.scenario.vehicle, j, flight.columns[f"l{j + 1}"]) for j in (0, 1)]
    assert np.hypot(*(ends[0] - ends[1]).T[:2]).min() < 0.24
    assert OverlapWarning not in flight.remarks

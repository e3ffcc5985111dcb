"""How far everything is: the gaps of the equations of motion, without their forces."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from springback.dynamics.clearance import clearance
from springback.dynamics.motion import rates
from springback.kernels.vectors import Quat, Vec
from springback.scenario.scenario import scenario_from
from springback.vehicle.state import State

WORLDS: dict[str, Any] = {
    "wall and ground": [
        {"type": "wall", "distance": 0.5, "surface": "wall"},
        {"type": "ground", "surface": "wall"},
    ],
    "mat": [
        {"type": "mat", "normal": [-1.0, 0.3, 0.2], "position": [0.4, 0.0, 0.5],
         "surface": "mat", "backing": "wall"},
    ],
    "nothing": [],
}  # fmt: skip


@pytest.mark.parametrize("point", ["ring", "paper"])
@pytest.mark.parametrize("world", WORLDS)
def test_it_is_the_smallest_gap_of_any_cage(world: str, point: str) -> None:
    tables = {
        "vehicle": "arq", "world": {"obstacles": WORLDS[world]}, "model": {"contact_point": point},
        "start": {"position": [-2.0, 0.0, 2.0]},
    }  # fmt: skip
    model = scenario_from(tables).flight_model()
    rng = np.random.default_rng(3)
    for _ in range(20):
        q = rng.normal(size=4)
        state = State(
            Vec(*map(float, rng.normal(size=3))),
            Quat(*map(float, q / np.linalg.norm(q))),
            Vec(*map(float, rng.normal(size=3))),
            Vec(*map(float, rng.normal(size=3))),
            tuple(map(float, rng.uniform(0.15, 0.19, 4))),
            tuple(map(float, rng.normal(size=4))),
        )
        m = model
        seen = rates(m, state, 1.0).seen
        told = clearance(m.airframe, m.world, m.contact_point, state)
        assert told == min(arm.gap for arm in seen.arms)

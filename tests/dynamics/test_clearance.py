"""How far everything is: the gaps of the equations of motion, without their forces."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from springback.dynamics.clearance import clearance, search_at
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


def test_a_scene_is_looked_at_again_before_anything_can_touch() -> None:
    """The last distance, less twice the way since, and eight steps more; planes at every step."""
    pole = {"type": "pole", "position": [3.0, 0.0, 0.0], "radius": 0.1, "surface": "wall"}
    scene = scenario_from({"vehicle": "arq", "world": {"obstacles": [pole]}}).flight_model()
    wall = scenario_from({"vehicle": "arq", "world": {"obstacles": WORLDS["mat"]}}).flight_model()
    fastest, step, room, looked = 3.0, 1e-4, 0.05, 0
    for way in range(100):  # steps since the last look
        found = search_at(scene.world.obstacles, room, fastest, step if way else 0.0, step)
        assert found.room <= 0.05 - 2.0 * fastest * step * way + 1e-12
        assert search_at(wall.world.obstacles, room, fastest, step, step).looks == 1.0
        if found.looks > 0.0:
            looked = way
            break
        room = found.room
    # 50 mm are 83 steps of 0.6 mm; it looks 8 steps and 1 mm before they are gone.
    assert looked == 74

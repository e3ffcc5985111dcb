"""What is found out in a short way is what the long way finds; and what parts are made of."""

from __future__ import annotations

import math

import numpy as np
import pytest

from builders.bodies import STILL, body
from springback.contact.loads import cage_contact
from springback.contact.obstacles import obstacle_in_body_frame
from springback.frames import attitude_from_euler
from springback.kernels.vectors import Quat, Vec, rotation
from springback.scenario.avionics import build_avionics
from springback.scenario.checks import is_clear
from springback.scenario.model import _is_positive
from springback.scenario.scenario import scenario_from
from springback.simulation.measuring.record import Model
from springback.vehicle.state import State, arm_pose


def least_gap(model: Model, state: State) -> float:
    r = rotation(state.attitude)
    return min(
        cage_contact(
            obstacle_in_body_frame(obstacle, state.position, r), model.contact_point, arm.cage_radius,
            arm_pose(arm, arm.length, 0.0, STILL), body(r),
        ).gap
        for obstacle in model.world.obstacles
        for arm in model.airframe.arms
    )  # fmt: skip


@pytest.mark.parametrize("point", ["ring", "paper"])
def test_who_is_out_of_reach_is_out_of_reach_however_turned(point: str) -> None:
    wall = {"type": "wall", "normal": [-1, 0.3, 0.2], "position": [2, 0, 0], "surface": "wall"}
    ground = {"type": "ground", "surface": "wall"}
    scenario = scenario_from(
        {
            "vehicle": "arq",
            "world": {"obstacles": [wall, ground]},
            "model": {"contact_point": point},
        }
    )
    model, start = scenario.flight_model(), scenario.start_state()
    noise_stream, clear, touching = np.random.default_rng(0), 0, 0
    for _ in range(400):
        place = Vec(*noise_stream.uniform([1.2, -0.5, 0.2], [2.0, 0.5, 0.6]).tolist())
        attitude = Quat(*attitude_from_euler(*noise_stream.uniform(-math.pi, math.pi, 3).tolist()))
        state = start._replace(position=place, attitude=attitude)
        if is_clear(model, state):
            clear += 1
            assert least_gap(model, state) > 0.0
        elif least_gap(model, state) < 0.0:
            touching += 1
    assert min(clear, touching) > 30


def test_a_positive_matrix_is_told_by_its_eigenvalues() -> None:
    noise_stream, positive = np.random.default_rng(1), 0
    for _ in range(2000):
        half = noise_stream.uniform(-0.5, 0.5, (3, 3))
        matrix = half + half.T + np.diag(noise_stream.uniform(0.0, 2.0, 3))
        wanted = bool(np.linalg.eigvalsh(matrix)[0] > 0.0)
        assert _is_positive(matrix) == wanted
        positive += wanted
    assert 200 < positive < 1800


@pytest.mark.parametrize(
    ("given", "home"), [({}, (0.1, 0.2, 1.3)), ({"home": [1, 2, 3]}, (1, 2, 3))]
)
def test_home_is_where_the_flight_starts_unless_told(
    given: dict[str, list[float]], home: tuple[float, ...]
) -> None:
    scenario = scenario_from(
        {
            "vehicle": "arq", "reference": {"type": "hold"}, "recovery": given,
            "start": {"position": [0.1, 0.2, 1.3]},
        }
    )  # fmt: skip
    built_avionics = build_avionics(scenario, scenario.flight_model(), scenario.start_state())
    assert built_avionics.avionics.systems.pilot.route.home == home
    assert built_avionics.avionics.onboard.pilot.recovery_state.goal == home

"""Hulls of every kind against what moves, and against shapes of the user's own."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from builders import user_obstacles
from builders.cases import nonempty
from builders.hull_scenes import NOSES, nose
from springback.batch.scenarios import fly_scenarios
from springback.contact.parameters import SurfaceSettings
from springback.kernels.vectors import Vec
from springback.results.flight import fly
from springback.scenario.scenario import scenario_from

SURFACE: dict[str, Any] = {
    "law": "hunt-crossley",
    "stiffness": 2e5,
    "dissipation": 0.3,
    "friction": 0.5,
}
PLACE = [2.8, 0.02, 1.0]
MOTIONS: dict[str, dict[str, Any]] = {
    "constant": {"type": "constant", "velocity": [-1.0, 0.2, 0.1], "turning": 2.0},
    "sine": {"type": "sine", "amplitude": [-0.1, 0.0, 0.0], "frequency": 3.0, "swing": 0.3},
    "table": {"type": "table", "time": [0.0, 0.1, 0.3], "angle": [0.0, 0.2, 0.0],
              "position": [[0.0, 0.0, 0.0], [-0.1, 0.0, 0.0], [-0.1, 0.1, 0.0]]},
    "free": {"type": "free", "mass": 0.3, "angular_velocity": [1.0, 2.0, 5.0]},
    "thrown": {"type": "free", "mass": 0.6, "velocity": [-2.0, 0.1, 1.0]},
    "pendulum": {"type": "pendulum", "mass": 1.0, "pivot": [2.8, 0.0, 2.0], "damping": 0.01},
    "hinge": {"type": "hinge", "mass": 3.0, "pivot": [2.8, 0.6, 1.0], "closer": 2.0,
              "damping": 0.5, "highest": "10 deg"},
}  # fmt: skip
FORMS: dict[str, dict[str, Any]] = {
    "box": {"type": "box", "position": PLACE, "size": [0.2, 0.3, 0.4], "yaw": 0.3, "roll": 0.2,
            "edge_radius": 0.02},
    "sphere": {"type": "sphere", "position": PLACE, "radius": 0.1},
    "pole": {"type": "pole", "position": [2.8, 0.02, 0.7], "radius": 0.08, "height": 0.6},
    "capsule": {"type": "capsule", "start": [2.75, -0.2, 0.95], "end": [2.75, 0.3, 1.05],
                "radius": 0.03},
}  # fmt: skip
#: Whatever moves has some form, and not always the same.
MOVERS = {
    f"{form}, {motion}": {**FORMS[form], "surface": SURFACE, "motion": MOTIONS[motion]}
    for k, motion in enumerate(MOTIONS)
    for form in (list(FORMS)[k % 4], list(FORMS)[(k + 1) % 4])
}


def scene(obstacle: dict[str, Any], kind: str, on: str, duration: float) -> dict[str, Any]:
    """A nose a hair in front of an obstacle, at 2 m/s."""
    return {
        "vehicle": {"preset": "arq", "hulls": [nose(kind, on)]},
        "world": {"obstacles": [obstacle]},
        "thrust": "hover",
        "start": {
            "position": [1.6, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0], "yaw": 0.1,
            "touch_distance": 3e-4,
        },
        "simulation": {"duration": duration},
    }  # fmt: skip


@pytest.mark.parametrize("kind", NOSES)
def test_every_hull_meets_everything_that_moves(kind: str) -> None:
    """It touches, the obstacle feels it, the ledger of both closes; in lanes as alone."""
    tables = [
        scene(obstacle, kind, ("body", "arm")[k % 2], 8e-3)
        for k, obstacle in enumerate(MOVERS.values())
    ]
    together = fly_scenarios(tables, threads=1)
    assert not any(together.problems)
    for k, (name, each) in enumerate(nonempty(zip(MOVERS, tables, strict=True))):
        alone = fly(each, trajectory=False).measures
        assert alone["contacts"], name
        assert alone["end_time"] == pytest.approx(8e-3), name
        assert abs(alone["ledger_residual"] or 0.0) < 1e-5, (name, alone["ledger_residual"])
        for measure, number in alone.items():
            row = together.measures[measure][k]
            assert np.isnan(row) if number is None else row == number, (name, measure)


@pytest.mark.parametrize("on", ["body", "arm"])
@pytest.mark.parametrize("kind", NOSES)
def test_a_hull_and_a_free_ball_keep_their_momentum(kind: str, on: str) -> None:
    """What the vehicle gains the ball loses, to rounding."""
    ball = {**FORMS["sphere"], "surface": SURFACE, "motion": MOTIONS["thrown"]}
    tables = scene(ball, kind, on, 0.02)
    tables["world"]["gravity"], tables["thrust"] = 0.0, [0.0] * 4
    flight = fly(tables)
    impulse = np.array([flight.work[f"impulse.{axis}"] for axis in "xyz"])
    speed = np.array([flight.columns[f"obstacle0_v{axis}"] for axis in "xyz"])
    assert np.abs(impulse).max() > 0.1
    assert np.abs(impulse + 0.6 * (speed - speed[:, :1])).max() < 1e-12


# -- shapes of the user's own ----------------------------------------------------------------------

OWN: dict[str, Any] = {
    "pole": user_obstacles.Pole(2.8, 0.02, 0.1),
    "ball": user_obstacles.Ball(Vec(*PLACE), 0.2),
    "box": user_obstacles.Box(Vec(0.1, 0.2, 0.2), Vec(*PLACE)),
}
#: The same by the package.
THE_SAME: dict[str, dict[str, Any]] = {
    "pole": {"type": "pole", "position": [2.8, 0.02, 0.0], "radius": 0.1},
    "ball": {"type": "sphere", "position": PLACE, "radius": 0.2},
    "box": {"type": "box", "position": PLACE, "size": [0.2, 0.4, 0.4], "edge_radius": 0.0},
}


@pytest.mark.parametrize("kind", NOSES)
def test_every_hull_meets_shapes_of_ones_own_as_the_packages(kind: str) -> None:
    """In plain Python, as there is a structure for each: the same peak, and the ledger closes."""
    for k, name in enumerate(nonempty(OWN)):
        on = ("body", "arm")[k % 2]
        tables = scene({**THE_SAME[name], "surface": SURFACE}, kind, on, 4e-4)
        place = scenario_from(tables).build().start.position
        tables["start"] = {"position": list(place), "velocity": [2.0, 0.0, 0.0], "yaw": 0.1}
        built_in = fly(tables, executor="python")
        tables["world"]["obstacles"] = []
        surface = SurfaceSettings(**SURFACE)
        own = fly(tables, executor="python", own=[(OWN[name], surface)])
        assert own.measures["contacts"] == 1.0
        assert abs(own.measures["ledger_residual"] or 0.0) < 1e-5, name
        for column in ("x", "z", "vx", "wy", "wz"):
            assert np.allclose(
                own.columns[column][-1], built_in.columns[column][-1], rtol=1e-6, atol=2e-6
            ), (name, column)

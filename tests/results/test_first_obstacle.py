"""What is touched first, and where: of one flight, and of each flight of a batch."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import springback
from builders.cases import nonempty
from builders.pairs import two
from builders.world_files import sdf, sdf_model
from springback.batch.scenarios import fly_scenarios
from springback.interfaces.replay.scene import scene_of
from springback.results.contacts.places import contact_places
from springback.results.contacts.spans import contact_spans

OWN = """
from springback import Vec
from springback.contact.obstacles import Plane


def wall(x):
    return Plane(Vec(-1.0, 0.0, 0.0), -x)
"""
WALL = {"type": "wall", "distance": 0.5, "surface": "wall"}
POLE = {"type": "pole", "position": [0.6, 0.0, 0.0], "radius": 0.05, "surface": "wall"}
BOX = {"type": "box", "name": "the box", "position": [0.6, 1.0, 1.0], "size": [0.2, 0.8, 2.0],
       "surface": "wall"}  # fmt: skip
BALL = {"type": "sphere", "name": "the ball", "position": [0.65, 1.0, 1.0], "radius": 0.3,
        "surface": "wall", "motion": {"type": "constant", "velocity": [-0.5, 0.0, 0.0]}}  # fmt: skip


def thrown(obstacles: list[dict[str, Any]], y: float) -> dict[str, Any]:
    """ARQ at 2 m/s along x, 1 m up and y to the left."""
    return {
        "vehicle": "arq",
        "thrust": "hover",
        "start": {"position": [0.0, y, 1.0], "velocity": [2.0, 0.0, 0.0], "yaw": 0.1},
        "world": {"obstacles": obstacles},
        "simulation": {"duration": 0.3},
    }


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder whose code is trusted."""
    monkeypatch.setenv("SPRINGBACK_TRUST", str(tmp_path))
    return tmp_path


def worlds(folder: Path) -> dict[str, tuple[list[dict[str, Any]], dict[float, str]]]:
    """Obstacles of each world, and what is touched first by the place of the start."""
    (folder / "mine.py").write_text(OWN)
    crate = sdf_model("crate", "<box><size>0.2 0.4 4</size></box>", "0.6 -1 0 0 0 0")
    (folder / "hall.sdf").write_text(sdf(crate))
    own = {"type": "own", "shape": f"{folder}/mine.py:wall", "parameters": {"x": 0.75},
           "surface": "wall"}  # fmt: skip
    hall = {"type": "import", "file": str(folder / "hall.sdf"), "surface": "wall"}
    ground = {"type": "ground", "surface": "wall"}
    box, ball = "world.obstacles[1], the box", "world.obstacles[1], the ball"
    mine, pole = "world.obstacles[0], a Plane", "world.obstacles[1], a pole"
    return {
        "planes": ([ground, WALL], {0.0: "world.obstacles[1], a wall"}),
        "solids": ([POLE, BOX], {0.0: "world.obstacles[0], a pole", 1.0: box, 3.0: ""}),
        "own": ([own, POLE], {0.0: pole, 1.0: mine}),
        "moving": ([POLE, BALL], {0.0: "world.obstacles[0], a pole", 1.0: ball, 3.0: ""}),
        "all": ([own, {**BALL, "name": "the ball"}, hall, POLE],
                {0.0: "world.obstacles[3], a pole", 1.0: ball, 3.0: mine,
                 -1.0: "world.obstacles[2], crate/link/collision"}),
    }  # fmt: skip


@pytest.mark.parametrize("name", ["planes", "solids", "own", "moving", "all"])
def test_it_is_named_alike_in_a_flight_and_in_a_batch(name: str, folder: Path) -> None:
    """It is what the contacts tell first, at the point where the first one begins."""
    obstacles, expected = worlds(folder)[name]
    tables = [thrown(obstacles, y) for y in expected]
    batch = fly_scenarios(tables)
    assert batch.first_obstacles == list(expected.values()), batch.problems
    for k, one in enumerate(nonempty(tables)):
        flight = springback.fly(one)
        assert flight.first_obstacle == batch.first_obstacles[k]
        point = [flight.measures[f"touch_{axis}"] for axis in "xyz"]
        in_row = [batch.measures[f"touch_{axis}"][k] for axis in "xyz"]
        assert in_row == [math.nan if x is None else x for x in point] or np.isnan(in_row).all()
        if not flight.first_obstacle:
            assert point == [None] * 3
            continue
        spans = sorted(contact_spans(flight), key=lambda one: one.begin)
        [first] = contact_places(flight, spans[:1])
        assert first is not None
        assert first.obstacle == flight.first_obstacle
        assert first.point == pytest.approx(point, abs=0.05)


def test_the_point_is_on_what_is_touched() -> None:
    """On the mantle of a pole and on a face of a box, before the contact has any depth."""
    flight = springback.fly(thrown([POLE, BOX], 0.0))
    assert flight.touch_x is not None
    assert flight.touch_y is not None
    assert math.hypot(flight.touch_x - 0.6, flight.touch_y) == pytest.approx(0.05, abs=1e-5)
    assert springback.fly(thrown([POLE, BOX], 1.0)).touch_x == pytest.approx(0.5, abs=1e-5)


def test_arms_on_hinges_and_hulls_tell_points_of_the_world() -> None:
    """Contacts at arms that turn are known in axes of these arms."""
    for vehicle in nonempty(("morphy", "caged-sphere", "navi")):
        flight = springback.fly({**thrown([BOX, WALL], -3.0), "vehicle": vehicle}, trajectory=False)
        assert flight.first_obstacle == "world.obstacles[1], a wall", vehicle
        assert flight.touch_x == pytest.approx(0.5, abs=1e-5), vehicle


@pytest.mark.parametrize("vehicle", ["morphy", "xplorer"])  # a pyramid's arms, and level ones
def test_arms_that_are_turned_at_touch_tell_points_of_the_world(vehicle: str) -> None:
    """Axes of an arm that begins pressed in are not those of the body: on the pole's mantle."""
    start = {"position": [0.0, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0], "yaw": 0.1,
             "compression": 0.02, "touch_distance": 0.005}  # fmt: skip
    flight = springback.fly({**thrown([POLE], 0.0), "vehicle": vehicle, "start": start})
    assert flight.touch_time == pytest.approx(0.0025, abs=1e-4)
    arm = flight.scenario.vehicle.airframe().arms[1]
    assert (arm.length - flight.columns["l2"][0]) * arm.joint.curvature > 0.1  # [rad]
    assert flight.touch_x is not None
    assert flight.touch_y is not None
    assert math.hypot(flight.touch_x - 0.6, flight.touch_y) == pytest.approx(0.05, abs=1e-6)


def test_two_vehicles_touch_each_other_first() -> None:
    """The first knows the point; the push on the second has none."""
    given = two()
    flight, batch = springback.fly(given), fly_scenarios([given])
    assert flight.second is not None
    assert flight.first_obstacle == batch.first_obstacles[0] == "the second vehicle"
    assert flight.second.first_obstacle == "the first vehicle"
    first = flight.obstacle_contacts[0].place
    assert [flight.touch_x, flight.touch_y, flight.touch_z] == pytest.approx(first, abs=0.05)
    assert flight.second.touch_x is None


def test_a_moving_obstacle_after_others_keeps_its_number(folder: Path) -> None:
    """Own shapes and the elements of an import come before it in the world."""
    obstacles, _ = worlds(folder)["all"]
    chosen = [obstacles[0], obstacles[2], obstacles[1]]
    flight = springback.fly(thrown(chosen, 1.0))
    assert flight.first_obstacle == "world.obstacles[2], the ball"
    assert flight.columns["obstacle2_x"][-1] < 0.65
    scene = scene_of(flight)
    [track] = scene.bodies
    assert track.obstacle == 2
    assert sum(one.track >= 0 for one in scene.obstacles) == 1

"""The obstacle that `springback check` says is met first, straight on from the start."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.forms import box_triangles
from springback.scenario.scenario import scenario_from
from springback.studies.approach import approach_ahead
from springback.studies.scenario_check import check_warnings, derived_numbers

#: A room with its ceiling listed first, a column in it and a table beside.
ROOM = [
    {"type": "ground", "surface": "wall"},
    {"type": "wall", "name": "ceiling", "position": [0, 0, 3], "normal": [0, 0, -1],
     "surface": "wall"},
    {"type": "wall", "name": "east wall", "position": [6, 0, 0], "normal": [-1, 0, 0],
     "surface": "wall"},
    {"type": "pole", "name": "column", "position": [2.6, -1.2, 0], "radius": 0.06, "height": 3.0,
     "surface": "wall"},
    {"type": "box", "name": "table", "position": [2.6, 1.0, 0.4], "size": [1, 1, 0.8],
     "surface": "wall", "motion": {"type": "constant", "velocity": [0, 0, 0]}},
]  # fmt: skip
FORWARDS = [2.0, 0.0, 0.0]


def scenario(position: Any, velocity: Any, yaw: float = 0.0, **more: Any) -> Any:
    start = {"position": position, "velocity": velocity, "yaw": yaw}
    given = {"vehicle": "arq", "start": start, "world": {"obstacles": ROOM}, **more}
    return scenario_from(given)


@pytest.mark.parametrize(
    ("position", "velocity", "met", "normal"),
    [
        ([0.8, 0.0, 1.2], FORWARDS, "world.obstacles[2], east wall", 1.0),
        ([0.8, 0.0, 1.2], [1.0, 0.0, 2.0], "world.obstacles[1], ceiling", 2.0 / math.sqrt(5.0)),
        ([0.8, 0.0, 1.2], [0.0, 0.0, -1.0], "world.obstacles[0], the ground", 1.0),
        ([0.8, 1.0, 0.5], FORWARDS, "world.obstacles[4], table", 1.0),
        ([0.8, 1.0, 1.2], FORWARDS, "world.obstacles[2], east wall", 1.0),  # over the table
        ([0.8, 0.0, 0.07], FORWARDS, "world.obstacles[2], east wall", 1.0),  # along the ground
    ],
)
def test_what_is_met_first_is_named_with_the_speed_into_it(
    position: Any, velocity: Any, met: str, normal: float
) -> None:
    found = approach_ahead(scenario(position, velocity))
    assert found is not None
    assert found.words == met
    assert found.speed == pytest.approx(math.hypot(*velocity) * normal, abs=1e-5)
    [speed] = [
        x for x in derived_numbers(scenario(position, velocity)) if x.name == "approach speed"
    ]
    assert met in speed.about
    assert speed.value == found.speed


def test_a_cage_straight_ahead_meets_a_column_at_its_face() -> None:
    """The way of the body is what its cage leaves of the distance to the column's face."""
    given = scenario([0.8, -1.2, 1.2], FORWARDS, yaw=math.pi / 4)
    found, arms = approach_ahead(given), given.vehicle.arms
    assert found is not None
    reach = arms.at("length", 0) + arms.at("cage_radius", 0)
    assert found.words.endswith("column")
    assert found.way == pytest.approx(2.54 - 0.8 - reach, abs=1e-5)
    assert tuple(found.place) == pytest.approx((2.54, -1.2, 1.2), abs=1e-4)
    assert found.along == pytest.approx(1.0, abs=1e-4)
    assert found.is_level


@pytest.mark.parametrize("velocity", [[0.0, 0.0, 0.0], [-1.0, 0.0, 0.0]])
def test_nothing_is_said_where_nothing_is_met(velocity: Any) -> None:
    given = scenario([0.8, 0.0, 1.2], velocity)
    assert approach_ahead(given) is None
    names = [one.name for one in derived_numbers(given)]
    assert not {"approach speed", "force along the foremost arm"} & set(names)
    assert not [line for line in check_warnings(given) if "met first" in line or "meets" in line]


def test_from_above_no_arm_is_foremost() -> None:
    given = scenario([0.8, 0.0, 1.2], [0.0, 0.0, -1.0])
    found = approach_ahead(given)
    assert found is not None
    assert not found.is_level
    names = [one.name for one in derived_numbers(given)]
    assert "approach speed" in names
    assert "force along the foremost arm" not in names


FOREMOST = "force along the foremost arm"


@pytest.mark.parametrize(
    ("vehicle", "yaw", "told"),
    [
        ("arq", 0.0, True),
        ("spiri", 0.0, True),  # bumpers on its arms
        ("caged-sphere", 0.0, False),
        ("caged-sphere-gimbal", 0.0, False),  # only the sphere touches
        (
            {"preset": "arq", "hull": {"radius": 0.189}, "arms": {"cage_radius": 0.1}},
            math.pi / 4,
            True,
        ),
        (
            {"preset": "arq", "hull": False, "hulls": [{"type": "sphere", "radius": 0.3}]},
            0.0,
            False,
        ),
        # Between two cages, which pass on both sides of the column, its main body meets it.
        ({"preset": "arq", "arms": {"length": 0.25, "cage_radius": 0.08}}, 0.0, False),
        ({"preset": "arq", "arms": {"length": 0.25, "cage_radius": 0.08}}, math.pi / 4, True),
    ],
)
def test_the_force_along_an_arm_is_told_where_an_arm_meets_the_obstacle(
    vehicle: Any, yaw: float, told: bool
) -> None:
    given = scenario([0.8, -1.2, 1.2], FORWARDS, yaw=yaw, vehicle=vehicle)
    names = {one.name for one in derived_numbers(given)}
    assert "approach speed" in names
    assert (FOREMOST in names) is told
    if not told:
        assert "least peak deceleration" not in names
        assert not [line for line in check_warnings(given) if "hardly slides" in line]


@pytest.mark.parametrize(("distance", "off"), [(2.54, ""), (3.0, "0.46 m before that")])
def test_a_run_up_is_told_of_the_obstacle_that_is_ahead_of_it(distance: float, off: str) -> None:
    """Not of the ceiling, which is the first wall of the list."""
    run_up = {
        "type": "run-up", "speed": 2.0, "wall_distance": distance, "start": [0.8, -1.2, 1.2],
        "yaw": math.pi / 4,
    }  # fmt: skip
    given = scenario([0.8, -1.2, 1.2], [0.0, 0.0, 0.0], reference=run_up)
    told = [line for line in check_warnings(given) if "wall_distance" in line]
    assert len(told) == bool(off)
    assert all("world.obstacles[3], column, is met first, 0.46 m before that" in x for x in told)


def test_of_an_imported_world_the_element_is_named_and_its_friction_counts() -> None:
    """As the flight names it; the first element, behind, has another surface."""
    tree = {"type": "pole", "position": [2.0, 0.0, 0.0], "radius": 0.1, "height": 3.0}
    elements = [
        {"name": "floor", "obstacle": {"type": "ground"}},
        {"name": "tree_0", "obstacle": tree | {"position": [5.0, 0.0, 0.0]}},
        {"name": "tree_1", "obstacle": tree, "friction": 0.7},
        {"name": "end", "obstacle": {"type": "wall", "position": [8, 0, 0], "normal": [-1, 0, 0]}},
    ]
    world = {
        "type": "import", "name": "wood", "file": "w.sdf", "surface": "wall", "elements": elements,
        "position": [1.0, 0.0, 0.0],
    }  # fmt: skip
    for place, named in (
        ([0.0, 0.0, 1.0], "wood/tree_1"), ([4.0, 0.0, 1.0], "wood/tree_0"),
        ([0.0, 2.0, 1.0], "wood/end"),
    ):  # fmt: skip
        given = scenario_from(
            {
                "vehicle": "arq", "world": {"obstacles": [world]},
                "start": {"position": place, "velocity": FORWARDS, "yaw": math.pi / 4},
            }
        )  # fmt: skip
        found = approach_ahead(given)
        assert found is not None
        assert found.words == f"world.obstacles[0], {named}"
        if named == "wood/tree_1":
            bend = math.sin(found.angle)
            assert found.along == pytest.approx(math.cos(found.angle) - 0.7 * bend, abs=1e-9)


def _upright(tmp_path: Path, **more: Any) -> Any:
    """A scenario with a wall of 1.8 m in the file, along its y, which is flown at in 1.5 m."""
    trimesh = pytest.importorskip("trimesh")
    wall = box_triangles(0.1, 1.8, 1.0)
    mesh = trimesh.Trimesh(wall.vertices + np.array([0.0, 0.9, 0.0]), wall.faces, process=False)
    file = tmp_path / "yup.glb"
    mesh.export(file)
    mine = {"type": "mesh", "file": str(file), "position": [3.0, 0.0, 0.0], "surface": "wall"}
    start = {"position": [0.0, 0.0, 1.5], "velocity": FORWARDS}
    entry = {key: value for key, value in (mine | more).items() if value is not None}
    return scenario_from({"vehicle": "arq", "start": start, "world": {"obstacles": [entry]}})


def test_a_wall_that_is_written_y_up_stands_by_the_roll_that_check_names(tmp_path: Path) -> None:
    flat = _upright(tmp_path)
    assert approach_ahead(flat) is None  # it lies below
    [told] = [line for line in check_warnings(flat) if "z-up" in line]
    assert told == (
        "world.obstacles[0]: yup.glb is read as z-up, 0.1 x 1.8 x 1 m along its x, y and z; "
        'if it was written y-up, as glTF defines, give roll = "90 deg"'
    )
    upright = _upright(tmp_path, roll="90 deg")
    found = approach_ahead(upright)
    assert found is not None
    assert found.place.x == pytest.approx(2.95, abs=1e-3)
    assert not [line for line in check_warnings(upright) if "z-up" in line]
    alone = _upright(tmp_path, type="import", position=None)
    assert any(
        line.endswith('make it an obstacle of type mesh with roll = "90 deg"')
        for line in check_warnings(alone)
    )

"""What a vehicle touched: the obstacle by its name, and the place."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import springback
from builders.cases import nonempty
from builders.pairs import two, vehicle
from builders.world_files import sdf, sdf_model
from springback.contact.obstacles import Plane
from springback.contact.parameters import SurfaceSettings
from springback.kernels.vectors import Vec
from springback.results.contacts.places import ObstacleContact, contact_places
from springback.results.contacts.spans import contact_spans
from springback.results.flight import Flight
from springback.results.pair.contacts import loads_on_first

#: Of the poles [m].
RADIUS = 0.05
#: Deeper than any of these contacts [m].
DEEPEST = 0.02


def pole(x: float, y: float, **others: Any) -> dict[str, Any]:
    return {"type": "pole", "position": [x, y, 0.0], "radius": RADIUS, "surface": "wall"} | others


def thrown(*obstacles: dict[str, Any], duration: float = 0.25, **start: Any) -> dict[str, Any]:
    """ARQ at 2 m/s along x, hovering."""
    return {
        "vehicle": "arq",
        "thrust": "hover",
        "start": {"position": [0.0, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0]} | start,
        "world": {"obstacles": list(obstacles)},
        "simulation": {"duration": duration},
    }


def only(flight: Flight) -> ObstacleContact:
    [found] = flight.obstacle_contacts
    assert f"normal force up to {found.force:.3g} N on {found.part}" in found.text
    return found


def test_one_of_many_poles_is_told_and_where() -> None:
    ground = {"type": "ground", "surface": "wall"}
    others = [pole(0.6, 0.8), ground, pole(0.7, -0.7), pole(0.45, 0.0), pole(3.0, 0.0)]
    flight = springback.fly(thrown(*others))
    found = only(flight)
    assert found.obstacle == "world.obstacles[3], a pole"
    assert found.place is not None
    from_axis = math.hypot(found.place[0] - 0.45, found.place[1])
    assert RADIUS - DEEPEST < from_axis < RADIUS
    assert found.contacts == sum(event.kind == "contact" for event in flight.events)
    assert found.force == max(flight.columns[f"fn{j}"].max() for j in range(1, 5))
    touch = next(event for event in flight.events if event.kind == "touch")
    assert touch.obstacle == found.obstacle
    assert touch.text.endswith(", on world.obstacles[3], a pole")


def test_planes_are_told_apart() -> None:
    """The ground below the mat, which has two faces; then the wall behind it is touched."""
    mat = {"type": "mat", "distance": 9.0, "surface": "mat", "backing": "wall", "thickness": 0.05}
    ground = {"type": "ground", "surface": "wall"}
    falling = {"position": [0.0, 0.0, 0.2], "velocity": [0.0, 0.0, -2.0]}
    flight = springback.fly(thrown(mat, ground, **falling))
    found = only(flight)
    assert found.obstacle == "world.obstacles[1], the ground"
    assert found.place is not None
    assert -DEEPEST < found.place[2] <= 0.0
    wall = {"type": "wall", "distance": 0.4, "surface": "wall"}
    assert only(springback.fly(thrown(ground, wall))).obstacle == "world.obstacles[1], a wall"


def test_what_moves_is_told_where_it_is_then() -> None:
    """The second of two poles comes along; the place is on it as it stands at that instant."""
    motion = {"type": "constant", "velocity": [-1.0, 0.0, 0.0]}
    flight = springback.fly(thrown(pole(0.2, 0.9), pole(0.6, 0.0, motion=motion)))
    found = only(flight)
    assert found.obstacle == "world.obstacles[1], a pole"
    assert found.place is not None
    from_axis = math.hypot(found.place[0] - (0.6 - found.time), found.place[1])
    assert RADIUS - DEEPEST < from_axis < RADIUS


def test_own_shapes_are_told_by_their_type_and_from_a_folder_too(tmp_path: Path) -> None:
    own = [(Plane(Vec(-1.0, 0.0, 0.0), -0.6), SurfaceSettings(law="hertz"))]
    given = thrown(pole(0.0, 1.0), duration=0.1)
    given["start"] = {"position": [0.2, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0]}
    flight = springback.fly(given, own=own)
    assert only(flight).obstacle == "own[0], a Plane"
    flight.save(tmp_path / "results", figures=False)
    read = springback.load(tmp_path / "results")
    found, again = only(flight), only(read)
    assert again._replace(place=None) == found._replace(place=None)
    assert again.place == pytest.approx(found.place, abs=1e-9)
    assert [event.text for event in read.events] == [event.text for event in flight.events]
    assert replace(read, own_contacts={}).obstacle_contacts == ()  # of an earlier version


def test_own_shapes_and_others_are_told_apart_in_a_folder(tmp_path: Path) -> None:
    """It bounces from a pole, and back from a plane of the user's own."""
    own = [(Plane(Vec(1.0, 0.0, 0.0), -0.1), SurfaceSettings(law="hertz"))]
    given = thrown(pole(0.6, 0.0), duration=1.3)
    given["start"] = {"position": [0.2, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0]}
    flight = springback.fly(given, own=own)
    names = [one.obstacle for one in flight.obstacle_contacts]
    assert names == ["world.obstacles[0], a pole", "own[0], a Plane"]
    flight.save(tmp_path / "results", figures=False)
    read = springback.load(tmp_path / "results")
    assert [one.obstacle for one in read.obstacle_contacts] == names


def test_what_touches_the_ground_is_named() -> None:
    """A sphere that has no cages of its own was said to touch with one."""
    ground = {"type": "ground", "surface": "wall"}
    cases = ("caged-sphere", 0.0, "the main body touches"), ("arq", 0.9, "cage 2 and cage 3 touch")
    for robot, roll, parts in cases:
        falling = {"position": [0.0, 0.0, 0.5], "velocity": [0.0, 0.0, -1.0], "roll": roll}
        given = thrown(ground, duration=0.6, **falling)
        flight = springback.fly(given | {"vehicle": robot})
        [event] = [event for event in flight.events if event.kind == "ground"]
        assert event.text == f"{parts} the ground"


def test_two_vehicles_name_each_other(tmp_path: Path) -> None:
    flight = springback.fly(two())
    assert flight.second is not None
    first, second = only(flight), only(flight.second)
    assert first.obstacle == "the second vehicle"
    assert second.obstacle == "the first vehicle"
    assert first.force == pytest.approx(second.force, rel=1e-3)
    assert first.place is not None
    assert second.place == pytest.approx(first.place, abs=1e-3)  # the points of one step
    assert second.time == pytest.approx(first.time, abs=1e-3)
    flight.save(tmp_path / "results", figures=False)
    again = springback.load(tmp_path / "results")
    assert again.second is not None
    for one in nonempty(again.obstacle_contacts):
        assert one == first
    assert only(again.second) == second
    summary = json.loads((tmp_path / "results/summary.json").read_text())
    [told] = summary["second"]["obstacle_contacts"]
    assert told["obstacle"] == "the first vehicle"
    assert told["place"] == list(second.place or ())


def test_a_second_vehicle_tells_a_wall_and_the_first_apart() -> None:
    """It flies off backwards after the meeting, and into a pole with a name."""
    given = two(vehicle(0.62, 0.0), simulation={"duration": 0.5})
    given["world"] = {"gravity": 0.0, "obstacles": [pole(1.0, 0.0, name="the mast")]}
    flight = springback.fly(given)
    assert flight.second is not None
    names = [one.obstacle for one in flight.second.obstacle_contacts]
    assert names == ["the first vehicle", "world.obstacles[0], the mast"]
    for one in nonempty(flight.second.obstacle_contacts):
        assert one.place is not None
    mast = flight.second.obstacle_contacts[1].place
    assert mast is not None
    assert RADIUS - DEEPEST < math.hypot(mast[0] - 1.0, mast[1]) < RADIUS


def test_a_pair_flies_in_an_imported_world(tmp_path: Path) -> None:
    """It ended with an error of Python."""
    crate = sdf_model("crate", "<box><size>0.2 1 1</size></box>", "0.6 0 0 0 0 0")
    (tmp_path / "hall.sdf").write_text(sdf(crate))
    given = two(vehicle(0.0, 0.0, y=2.0), simulation={"duration": 0.2})
    hall = {"type": "import", "file": str(tmp_path / "hall.sdf"), "surface": "wall", "name": "hall"}
    given["world"] = {"gravity": 0.0, "obstacles": [hall]}
    found = only(springback.fly(given))
    assert found.obstacle.startswith("world.obstacles[0], hall/crate/")
    assert found.place is not None
    assert 0.5 <= found.place[0] < 0.5 + DEEPEST


def test_touch_speed_of_a_pair_is_that_of_both_along_the_normal() -> None:
    """Two glancing meetings: the force without friction shows the normal."""
    for y in (0.22, 0.35):
        flight = springback.fly(two(vehicle(0.6, -1.0, yaw=2.6, y=y)))
        second = flight.second
        assert second is not None
        assert flight.touch_time is not None
        row = int(np.searchsorted(flight.t, flight.touch_time))
        given = flight.scenario, flight.columns, second.columns, np.arange(row, row + 2)
        loads = loads_on_first(*given)
        push = loads.force[-1].sum(axis=0) - loads.rubbing[-1].sum(axis=0)
        into = -push / np.linalg.norm(push)
        v, w = (np.array([one.columns[f"v{a}"][row] for a in "xyz"]) for one in (flight, second))
        assert into @ (v - w) < 0.99 * np.linalg.norm(v - w)  # glancing
        assert flight.touch_speed == pytest.approx(into @ (v - w), rel=5e-3)
        assert second.touch_speed == pytest.approx(into @ (v - w), rel=5e-3)


def test_a_flight_without_contact_touched_nothing() -> None:
    assert springback.fly(thrown(pole(9.0, 0.0))).obstacle_contacts == ()


def test_a_union_is_told_by_its_name() -> None:
    shapes = [{**pole(0.45, 0.0), "surface": "wall"}]
    union = {"type": "union", "shapes": shapes}
    assert only(springback.fly(thrown(union))).obstacle == "world.obstacles[0], a union"
    named = only(springback.fly(thrown({**union, "name": "the table"})))
    assert named.obstacle == "world.obstacles[0], the table"


def test_every_obstacle_is_told_by_its_name() -> None:
    """Of a pole, of planes alone, and of what moves; a ground of any name is the ground."""
    motion = {"type": "constant", "velocity": [-1.0, 0.0, 0.0]}
    flight = springback.fly(thrown(pole(0.2, 0.9), pole(0.6, 0.0, name="the ball", motion=motion)))
    assert only(flight).obstacle == "world.obstacles[1], the ball"
    floor = {"type": "ground", "surface": "wall", "name": "the gym's floor"}
    wall = {"type": "wall", "distance": 9.0, "surface": "wall", "name": "a wall, the ground"}
    falling = {"position": [0.0, 0.0, 0.5], "velocity": [0.0, 0.0, -1.0]}
    flight = springback.fly(thrown(wall, floor, duration=0.6, **falling))
    assert only(flight).obstacle == "world.obstacles[1], the gym's floor"
    [event] = [event for event in flight.events if event.kind == "ground"]
    assert event.text == "the main body touches the ground"


def test_a_wall_by_the_name_of_the_ground_is_not_the_ground() -> None:
    wall = {"type": "wall", "distance": 0.4, "surface": "wall", "name": "the ground"}
    flight = springback.fly(thrown(wall))
    spans = list(contact_spans(flight))
    for place in nonempty(contact_places(flight, spans)):
        assert place is not None
        assert not place.is_ground

"""Latches and springs between arms where they are drawn: scene, film and page show what holds."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from interfaces.browsing import browser, complaints, needs_browser
from interfaces.replay.pages import TABLES, opened, pose
from springback.interfaces.animation import bodies
from springback.interfaces.animation.frame import Frame
from springback.interfaces.animation.timing import timing
from springback.interfaces.replay.scene import Scene, plain, scene_of
from springback.interfaces.replay.viewer import export_page, replay_of
from springback.results.flight import Flight, fly
from springback.vehicle.arms.bent import BentCoordinates, bent_pose
from springback.vehicle.arms.joints import joint_pose

SOFT = {"stiffness": "0.4 N/mm", "damping": "5 N s/m"}
HINGE = {
    "type": "hinge", "position": [0.06, 0.0, 0.0], "axis": [0.0, 0.0, 1.0], "travel": [0.0, 1.0],
    "stiffness": "0.5 N m/rad", "damping": 0.02, "latch": {"torque": 2.0, "travel": "1 deg"},
}  # fmt: skip
SLIDE = {
    "type": "slide", "direction": [-1.0, 0.0, 0.2], "travel": [0.0, 0.03], "stiffness": "3 N/mm",
    "damping": 30.0, "latch": {"force": 30.0, "travel": "1 mm"},
}  # fmt: skip
#: It turns down, and carries another about the same point that turns to the side.
UNIVERSAL = {
    **HINGE, "axis": [0.0, 1.0, 0.0],
    "second": {**HINGE, "latch": {"torque": 0.5, "travel": "2 deg"}},
}  # fmt: skip
ARMS: dict[str, dict[str, Any]] = {
    "hinges": {"joint": HINGE, "neighbours": SOFT},
    "slides": {"joint": SLIDE},
    "in the plane": {"neighbours": SOFT},
    "two joints": {"joint": UNIVERSAL},
}


@pytest.fixture(scope="module")
def flights() -> dict[str, Flight]:
    wall = {"type": "wall", "distance": 2.75, "surface": "paper-wall"}  # lets cages slip
    start = {"position": [2.3, 0.0, 1.0], "velocity": [2.5, 0.1, 0.0], "pitch": 0.2}
    return {
        name: fly(
            {
                **TABLES,
                "world": {"obstacles": [wall]},
                "start": start,
                "vehicle": {"preset": "arq", "arms": arms},
            }
        )
        for name, arms in ARMS.items()
    }


@pytest.fixture(scope="module")
def scenes(flights: dict[str, Flight]) -> dict[str, Scene]:
    return {name: scene_of(flight) for name, flight in flights.items()}


def most_bent(scene: Scene) -> int:
    given = np.abs(scene.arm_length - [arm.length for arm in scene.arms]).max(axis=1)
    return int(np.argmax(given))


@pytest.mark.parametrize("name", ["hinges", "slides"])
def test_faces_of_a_latch_part_as_the_arm_moves(
    name: str, flights: dict[str, Flight], scenes: dict[str, Scene]
) -> None:
    """One stays on the body, the other turns and slides with the arm, from where both meet."""
    scene = scenes[name]
    arms = flights[name].scenario.flight_model().airframe.arms
    at_rest = bodies.latches(scene.arms, bodies.pose(scene, float(scene.t[0])))
    assert not any(latch.is_open for latch in at_rest)
    for latch in nonempty(at_rest):
        assert latch.on_arm == pytest.approx(latch.on_body, abs=1e-12)
    k = most_bent(scene)
    now = bodies.pose(scene, float(scene.t[k]))
    found = bodies.latches(scene.arms, now)
    assert {latch.is_open for latch in found} == {True, False}
    for latch, arm, length in nonempty(zip(found, arms, scene.arm_length[k], strict=True)):
        free, there = joint_pose(arm, arm.length, 0.0), joint_pose(arm, float(length), 0.0)
        lever = (latch.on_body - now.position) @ now.rotation - free.end
        moved = np.array(there.end) + np.array(there.turn) @ lever
        assert (latch.on_arm - now.position) @ now.rotation == pytest.approx(moved, abs=1e-12)
        [held] = arm.spring.latch
        assert latch.is_open == (arm.length - length > held.travel)
        along = (latch.on_arm - latch.on_body) @ now.rotation @ np.array(arm.joint.direction)
        assert along <= 1e-9  # away from the body's face, which is on the other side


def test_the_latch_of_a_second_joint_is_on_what_the_first_carries(
    flights: dict[str, Flight], scenes: dict[str, Scene]
) -> None:
    """One face turns with the first joint alone, the other with both; it opens by the second's way."""
    scene = scenes["two joints"]
    arms = flights["two joints"].scenario.flight_model().airframe.arms
    k = int(np.argmin(scene.bends.min(axis=1)))
    now = bodies.pose(scene, float(scene.t[k]))
    found = bodies.latches(scene.arms, now)
    assert len(found) == 2 * len(arms)
    assert {latch.is_open for latch in found[1::2]} == {True, False}
    for j, (arm, drawn) in enumerate(nonempty(zip(arms, scene.arms, strict=True))):
        first, second = drawn.latch
        length, bend = float(scene.arm_length[k, j]), float(scene.bends[k, j])
        lever = np.array(second.face) - np.array(arm.joint.end)
        alone = joint_pose(arm, length, 0.0)
        both = bent_pose(arm, BentCoordinates(length, bend), BentCoordinates(0.0, 0.0))
        latch = found[2 * j + 1]
        for face, there in ((latch.on_body, alone), (latch.on_arm, both)):
            place = np.array(there.end) + np.array(there.turn) @ lever
            assert (face - now.position) @ now.rotation == pytest.approx(place, abs=1e-12)
        [held] = arm.second.spring.latch
        assert latch.is_open == (-bend > held.travel)
        assert found[2 * j].is_open == (arm.length - length > arm.spring.latch[0].travel)
        # Both hinges are in one point; their latches are not.
        assert np.linalg.norm(np.subtract(first.face, second.face)) > 0.01


@pytest.mark.parametrize("name", ["hinges", "in the plane"])
def test_springs_between_arms_end_where_arms_do(name: str, scenes: dict[str, Scene]) -> None:
    scene = scenes[name]
    now = bodies.pose(scene, float(scene.t[most_bent(scene)]))
    tips = bodies.ends(scene.arms, now)
    lines = bodies.neighbour_lines(scene.neighbours, scene.arms, now)
    assert [(one.first, one.second) for one in scene.neighbours] == [(0, 1), (1, 2), (2, 3), (3, 0)]
    for one, line in nonempty(zip(scene.neighbours, lines, strict=True)):
        assert line[0] == pytest.approx(tips[one.first])
        assert line[-1] == pytest.approx(tips[one.second])
        away = line[-1] - line[0]
        off = np.linalg.norm(np.cross(line - line[0], away), axis=1) / np.linalg.norm(away)
        assert 1e-3 < off.max() <= 2.0 * bodies.NEIGHBOUR_COILS * bodies.COIL_RADIUS + 1e-12
    free = bodies.ends(scene.arms, now, free=True)
    assert scene.neighbours[0].distance == pytest.approx(np.linalg.norm(free[1] - free[0]))


def test_a_film_has_lines_for_them_and_colours_open_latches(scenes: dict[str, Scene]) -> None:
    for name, springs, latches in (
        ("hinges", 4, 4), ("slides", 0, 4), ("in the plane", 4, 0), ("two joints", 0, 8),
    ):  # fmt: skip
        scene = scenes[name]
        when = timing([scene], slow=20.0, begin=None, end=None, fps=25.0)
        frame = Frame([scene], when, (300, 270))
        k = int(np.argmin(np.abs(when.t + scene.impacts[0][0] - scene.t[most_bent(scene)])))
        frame.at(k)
        (robot,) = frame.panels[0][0].robots
        assert (len(robot.neighbours), len(robot.latches)) == (springs, latches)
        now = bodies.pose(scene, scene.impacts[0][0] + float(when.t[k]))
        for line, latch in zip(robot.latches, bodies.latches(scene.arms, now), strict=True):
            shown = np.array(line.get_data()).T
            assert shown == pytest.approx(robot.view(np.array([latch.on_body, latch.on_arm])))
            assert (line.get_markerfacecolor() == line.get_markeredgecolor()) != latch.is_open
        for line, one in zip(robot.neighbours, scene.neighbours, strict=True):
            first = np.array(line.get_data()).T[0]
            assert first == pytest.approx(robot.view(bodies.ends(scene.arms, now)[one.first]))


def test_the_page_knows_them_as_numbers(scenes: dict[str, Scene]) -> None:
    data = plain(scenes["hinges"])
    [latch] = data["arms"][2]["latch"]
    assert latch["travel"] == scenes["hinges"].arms[2].latch[0].travel
    assert data["neighbours"][3] == {
        "first": 3, "second": 0, "distance": scenes["hinges"].neighbours[3].distance,
    }  # fmt: skip
    assert plain(scenes["slides"])["neighbours"] == []


@pytest.fixture(scope="module")
def driver(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    with browser(tmp_path_factory.mktemp("profile")) as found:
        yield found


@needs_browser
@pytest.mark.parametrize("name", ARMS)
def test_the_page_draws_them_where_films_do(
    name: str, driver: Any, flights: dict[str, Flight], scenes: dict[str, Scene], tmp_path: Path
) -> None:
    """Both ends of springs, and both faces of latches, which lie side by side when closed."""
    page, scene = tmp_path / "latches.html", scenes[name]
    export_page(replay_of([flights[name]]), page)
    k = most_bent(scene)
    opened(driver, page, f"#t={float(scene.t[k])}")
    (shown,) = pose(driver)["connections"]
    now = bodies.pose(scene, float(scene.t[k]))
    lines = bodies.neighbour_lines(scene.neighbours, scene.arms, now)
    for line, drawn in zip(lines, shown["springs"], strict=True):
        assert np.array(drawn) == pytest.approx(line[[0, -1]], abs=1e-6)
    latches = bodies.latches(scene.arms, now)
    for latch, drawn in zip(latches, shown["latches"], strict=True):
        assert drawn["open"] == latch.is_open
        assert drawn["moving"] == pytest.approx(latch.on_arm, abs=1e-6)
        assert 0.0 < np.linalg.norm(np.subtract(drawn["held"], latch.on_body)) < 0.01
    assert len(lines) + len(latches) >= 4
    assert complaints(driver) == []


@pytest.mark.parametrize("name", ["hinges", "slides", "two joints"])
def test_a_latch_that_opens_is_an_event_when_the_picture_shows_it(
    name: str, flights: dict[str, Flight], scenes: dict[str, Scene]
) -> None:
    """Of each arm as often as its faces part, and with the force or torque that it is given."""
    flight, scene = flights[name], scenes[name]
    opened = [event for event in flight.events if event.kind == "latch_open"]
    closed = [event for event in flight.events if event.kind == "latch_close"]
    places = [bodies.latches(scene.arms, bodies.pose(scene, float(t))) for t in scene.t]
    shown = np.array([[latch.is_open for latch in row] for row in places])
    assert len(opened) == int((shown[1:] & ~shown[:-1]).sum()) > 0
    assert len(closed) == int((~shown[1:] & shown[:-1]).sum())
    texts = {"hinges": ["2 N m"], "slides": ["30 N"], "two joints": ["2 N m", "0.5 N m"]}[name]
    assert all(any(text in event.text for text in texts) for event in opened)
    assert not [event for event in flights["in the plane"].events if event.kind == "latch_open"]

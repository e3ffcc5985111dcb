"""Arms on two joints where they are drawn: scene, film and page show what the physics says."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from interfaces.browsing import browser, complaints, needs_browser
from interfaces.replay.pages import opened, pose
from springback.interfaces.animation import bodies
from springback.interfaces.animation.frame import Frame
from springback.interfaces.animation.timing import timing
from springback.interfaces.replay.scene import Scene, scene_of
from springback.interfaces.replay.viewer import export_page, replay_of
from springback.results.flight import Flight, fly
from springback.vehicle.arms.bent import BentCoordinates, bent_pose

HINGE = {
    "type": "hinge", "position": [0.06, 0.0, 0.0], "axis": [0.0, 0.0, 1.0],
    "travel": ["-60 deg", "60 deg"], "stiffness": "1.5 N m/rad", "damping": 0.01,
}  # fmt: skip
SECOND = {**HINGE, "position": [0.09, 0.0, 0.01], "axis": [0.2, 1.0, 0.0]}
SLIDE = {"type": "slide", "travel": [0.0, 0.05], "stiffness": "2 N/mm", "damping": 10.0}
JOINTS: dict[str, dict[str, Any]] = {
    "hinges": {**HINGE, "second": SECOND},
    "hinge on a slide": {**SLIDE, "second": SECOND},
    "slide on a hinge": {**HINGE, "second": SLIDE},
}


def flown(joint: dict[str, Any]) -> Flight:
    angles = ["45 deg", "135 deg", "225 deg", "315 deg"]
    arms = {"directions": angles, "length": 0.19, "mass": 0.05, "cage_radius": 0.11,
            "height": 0.02, "joint": joint}  # fmt: skip
    return fly({
        "vehicle": {"body": {"mass": 1.0, "inertia": [0.008, 0.009, 0.016]}, "arms": arms},
        "world": {"obstacles": [{"type": "wall", "distance": 1.0, "surface": "wall"}]},
        "start": {"position": [0.66, 0.0, 1.0], "velocity": [2.0, 0.1, 0.0],
                  "pitch": 0.2, "roll": 0.1},
        "thrust": 3.0, "simulation": {"duration": 0.06},
    })  # fmt: skip


@pytest.fixture(scope="module")
def flights() -> dict[str, Flight]:
    return {name: flown(joint) for name, joint in JOINTS.items()}


@pytest.fixture(scope="module")
def scenes(flights: dict[str, Flight]) -> dict[str, Scene]:
    return {name: scene_of(flight) for name, flight in flights.items()}


def most_bent(scene: Scene) -> int:
    return int(np.argmax(np.abs(scene.bends).max(axis=1)))


@pytest.mark.parametrize("name", JOINTS)
def test_cages_are_where_the_equations_have_them(
    name: str, flights: dict[str, Flight], scenes: dict[str, Scene]
) -> None:
    scene = scenes[name]
    k = most_bent(scene)
    now, arms = bodies.pose(scene, float(scene.t[k])), flights[name].scenario.flight_model()
    places, turned = bodies.end_places(scene.arms, now), 0.0
    lines = [
        bodies.arm_line(arm, now, float(now.lengths[j]), now.bend(j))
        for j, arm in enumerate(scene.arms)
    ]
    both = zip(scene.arm_length[k], scene.bends[k], strict=True)
    for arm, place, line, (length, bend) in nonempty(
        zip(arms.airframe.arms, places, lines, both, strict=True)
    ):
        there = bent_pose(arm, BentCoordinates(float(length), float(bend)), 0.0)
        end = now.position + now.rotation @ np.array(there.end)
        assert place.position == pytest.approx(end, abs=1e-12)
        assert place.rotation == pytest.approx(now.rotation @ np.array(there.turn), abs=1e-12)
        assert line[-1] == pytest.approx(end, abs=1e-12)
        turned = max(turned, abs(bend))
    assert turned > 2e-3
    assert [arm.yielding(0.19, 0.3) for arm in scene.arms] == pytest.approx([0.3] * 4)


def test_the_second_hinge_is_carried_by_the_first(scenes: dict[str, Scene]) -> None:
    """Its place keeps its distance from the first, and the end keeps its own from it."""
    scene = scenes["hinges"]
    now = bodies.pose(scene, float(scene.t[most_bent(scene)]))
    pins = bodies.hinges(scene.arms, now).reshape(4, 2, 3)
    for arm, (first, second), tip in nonempty(
        zip(scene.arms, pins, bodies.ends(scene.arms, now), strict=True)
    ):
        free = [np.array(one.anchor) for one in (*arm.joint, *arm.second)]
        end = np.array(arm.joint[0].path.end)
        assert np.linalg.norm(first - second) == pytest.approx(np.linalg.norm(free[0] - free[1]))
        assert np.linalg.norm(tip - second) == pytest.approx(np.linalg.norm(end - free[1]))


def test_a_film_shows_them(scenes: dict[str, Scene]) -> None:
    scene = scenes["hinges"]
    when = timing([scene], slow=20.0, begin=None, end=None, fps=25.0)
    frame = Frame([scene], when, (300, 270))
    k = int(np.argmin(np.abs(when.t + scene.impacts[0][0] - scene.t[most_bent(scene)])))
    frame.at(k)
    (robot,) = frame.panels[0][0].robots
    now = bodies.pose(scene, scene.impacts[0][0] + float(when.t[k]))
    assert robot.hinges is not None
    shown = np.array(robot.hinges.get_data()).T
    assert shown == pytest.approx(robot.view(bodies.hinges(scene.arms, now)))
    assert len(shown) == 8


@needs_browser
@pytest.mark.parametrize("name", JOINTS)
def test_the_page_draws_cages_where_the_equations_have_them(
    name: str, flights: dict[str, Flight], scenes: dict[str, Scene], tmp_path: Path
) -> None:
    page, scene = tmp_path / "joints.html", scenes[name]
    export_page(replay_of([flights[name]]), page)
    k = most_bent(scene)
    now = bodies.pose(scene, float(scene.t[k]))
    places = bodies.end_places(scene.arms, now)
    with browser(tmp_path / "profile") as driver:
        opened(driver, page, f"#t={float(scene.t[k])}")
        (shown,) = pose(driver)["ends"]
        for drawn, place in nonempty(zip(shown, places, strict=True)):
            assert drawn["centre"] == pytest.approx(place.position, abs=1e-6)
            assert drawn["normal"] == pytest.approx(place.rotation[:, 2], abs=1e-5)
            assert drawn["thrust"] == pytest.approx(place.rotation[:, 2], abs=1e-5)
        assert complaints(driver) == []

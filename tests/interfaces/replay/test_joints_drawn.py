"""Arms on joints where they are drawn: scene, film and page show what the physics says."""

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
from springback.interfaces.replay.scene import (
    Scene,
    arm_shapes,
    plain,
    rotor_shapes,
    scene_of,
)
from springback.interfaces.replay.viewer import export_page, replay_of
from springback.results.flight import Flight, fly
from springback.vehicle.arms.joints import joint_pose
from springback.vehicle.library import ARQ
from springback.vehicle.parameters import Vehicle

UP = {
    "type": "hinge", "position": [0.06, 0.0, 0.0], "axis": [0.0, 1.0, 0.0],
    "travel": ["-60 deg", "60 deg"], "stiffness": "1.5 N m/rad", "damping": 0.01,
}  # fmt: skip
JOINTS: dict[str, dict[str, Any]] = {
    "up": UP,
    "level": {**UP, "rotors": "body"},
    "odd": {**UP, "position": [0.06, 0.01, 0.01], "axis": [0.3, 0.5, 0.8]},
    "legs": {"type": "slide", "direction": [-1.0, 0.0, 1.0], "travel": [0.0, 0.05],
             "stiffness": "2 N/mm", "damping": 10.0},
}  # fmt: skip
HULL = {"type": "sphere", "on": 1, "position": [0.05, 0.0, 0.0], "radius": 0.02}


def vehicle(joint: dict[str, Any]) -> dict[str, Any]:
    angles = ["45 deg", "135 deg", "225 deg", "315 deg"]
    arms = {"directions": angles, "length": 0.19, "mass": 0.05, "cage_radius": 0.11,
            "height": 0.02, "joint": joint}  # fmt: skip
    return {"body": {"mass": 1.0, "inertia": [0.008, 0.009, 0.016]}, "arms": arms}


def flown(joint: dict[str, Any]) -> Flight:
    return fly({
        "vehicle": vehicle(joint),
        "world": {"obstacles": [{"type": "wall", "distance": 1.0, "surface": "wall"}]},
        "start": {"position": [0.66, 0.0, 1.0], "velocity": [2.0, 0.1, 0.0],
                  "pitch": 0.2, "roll": 0.1},
        "thrust": 3.0, "simulation": {"duration": 0.15},
    })  # fmt: skip


@pytest.fixture(scope="module")
def flights() -> dict[str, Flight]:
    return {name: flown(joint) for name, joint in JOINTS.items()}


@pytest.fixture(scope="module")
def scenes(flights: dict[str, Flight]) -> dict[str, Scene]:
    return {name: scene_of(flight) for name, flight in flights.items()}


def most_bent(scene: Scene) -> int:
    given = np.abs(scene.arm_length - [arm.length for arm in scene.arms]).max(axis=1)
    return int(np.argmax(given))


def told(flight: Flight, scene: Scene, k: int) -> list[tuple[Any, Any]]:
    """By the equations: place of each end and axes of what is there, world."""
    now, found = bodies.pose(scene, float(scene.t[k])), []
    arms = flight.scenario.flight_model().airframe.arms
    for arm, length in zip(arms, scene.arm_length[k], strict=True):
        there = joint_pose(arm, float(length), 0.0)
        end = now.position + now.rotation @ np.array(there.end)
        found.append((end, now.rotation @ np.array(there.turn)))
    return found


@pytest.mark.parametrize("name", ["up", "level", "odd", "legs"])
def test_cages_and_rotors_are_where_the_equations_have_them(
    name: str, flights: dict[str, Flight], scenes: dict[str, Scene]
) -> None:
    scene = scenes[name]
    k = most_bent(scene)
    now = bodies.pose(scene, float(scene.t[k]))
    places = bodies.end_places(scene.arms, now)
    rotors = bodies.rotor_places(scene.rotors, places, now)
    wanted = told(flights[name], scene, k)
    for place, rotor, (end, turn), tip in nonempty(
        zip(places, rotors, wanted, bodies.ends(scene.arms, now), strict=True)
    ):
        assert place.position == pytest.approx(end, abs=1e-12)
        assert place.rotation == pytest.approx(turn, abs=1e-12)
        assert rotor.thrust == pytest.approx((now.rotation if name == "level" else turn)[:, 2])
        assert rotor.position == pytest.approx(end, abs=1e-12)
        assert len(rotor.disc) == 0
        assert tip == pytest.approx(end, abs=1e-12)
    tilt = max(
        float(np.degrees(np.arccos(min(turn[:, 2] @ now.rotation[:, 2], 1.0))))
        for _, turn in wanted
    )
    assert (tilt > 5.0) == (name != "legs")


@pytest.mark.parametrize("name", ["up", "odd", "legs"])
def test_forces_act_on_the_cages_that_are_drawn(name: str, scenes: dict[str, Scene]) -> None:
    """Each point of contact of a cage is on its circle, but for how deep it is pressed in."""
    scene, away = scenes[name], []
    for k in np.flatnonzero(np.linalg.norm(scene.force, axis=2).max(axis=1) > 1.0):
        now = bodies.pose(scene, float(scene.t[k]))
        places = bodies.end_places(scene.arms, now)
        for force, point, part in zip(scene.force[k], scene.point[k], scene.part, strict=True):
            if np.linalg.norm(force) < 1.0:
                continue
            place, radius = places[part], scene.arms[part].cage_radius
            x, y, z = place.rotation.T @ (point - place.position)
            away.append(np.hypot(np.hypot(x, y) - radius, z))
    assert len(away) > 20
    assert max(away) < 2e-3


def test_a_hinged_arm_turns_as_a_whole_about_its_hinge(scenes: dict[str, Scene]) -> None:
    scene = scenes["odd"]
    now = bodies.pose(scene, float(scene.t[most_bent(scene)]))
    pins, places = bodies.hinges(scene.arms, now), bodies.end_places(scene.arms, now)
    free = bodies.end_places(scene.arms, now, free=True)
    for j, (arm, pin) in nonempty(enumerate(zip(scene.arms, pins, strict=True))):
        line = bodies.arm_line(arm, now, float(now.lengths[j]))
        assert line == pytest.approx(np.array([now.position, pin, places[j].position]))
        (joint,) = arm.joint
        lever = 1.0 / joint.path.curvature
        assert np.linalg.norm(line[2] - line[1]) == pytest.approx(lever)
        rigid = places[j].rotation.T @ (line[2] - line[1])
        assert rigid == pytest.approx(free[j].rotation.T @ (free[j].position - pin))
        axis = np.cross(joint.path.direction, joint.path.inward)
        given = np.array([0.06, 0.01, 0.01])  # of the axis, in the axes of the arm
        c, s = np.cos(np.pi / 4 * (1 + 2 * j)), np.sin(np.pi / 4 * (1 + 2 * j))
        from_given = np.array(joint.anchor) - [[c, -s, 0], [s, c, 0], [0, 0, 1]] @ given
        assert np.linalg.norm(np.cross(from_given, axis)) < 1e-12


def test_the_spring_of_a_slide_lies_along_it(scenes: dict[str, Scene]) -> None:
    scene = scenes["legs"]
    now = bodies.pose(scene, float(scene.t[most_bent(scene)]))
    assert len(bodies.hinges(scene.arms, now)) == 0
    for j, arm in nonempty(enumerate(scene.arms)):
        line = bodies.arm_line(arm, now, float(now.lengths[j]))
        (joint,) = arm.joint
        seat, along = np.array(joint.anchor), np.array(joint.path.direction)
        coils = (line[1:-1] - now.position) @ now.rotation - seat
        aside = np.linalg.norm(np.cross(coils, along), axis=1)
        assert aside.max() <= 2.0 * bodies.COIL_RADIUS + 1e-9
        assert (coils @ along).min() >= -1e-9
        end = (line[-1] - now.position) @ now.rotation - seat
        assert np.cross(end, along) == pytest.approx(np.zeros(3), abs=1e-9)


def test_hulls_turn_with_their_arm(scenes: dict[str, Scene]) -> None:
    scene, hulled = scenes["up"], Vehicle(**vehicle(UP), hulls=[HULL])
    now = bodies.pose(scene, float(scene.t[most_bent(scene)]))
    arms = arm_shapes(hulled.airframe(), hulled)
    place, (side, _) = bodies.end_places(arms, now)[0], bodies.views(scene)
    outline = bodies.outlines_of(arms[0].hulls, place.position, place.rotation, side)[:-1]
    middle = side(place.position + place.rotation @ np.array([0.05, 0.0, 0.0]))
    assert 0.5 * (outline.min(axis=0) + outline.max(axis=0)) == pytest.approx(middle, abs=1e-3)


def test_arms_in_the_plane_are_drawn_as_ever() -> None:
    """To the last bit: along their directions, with cages parallel to the main body."""
    arms = arm_shapes(ARQ.vehicle.airframe(), ARQ.vehicle)
    turn = np.array([[0.8, -0.6, 0.0], [0.6, 0.8, 0.0], [0.0, 0.0, 1.0]])
    lengths, none = np.array([0.15, 0.16, 0.17, 0.18]), np.zeros((4, 3))
    now = bodies.SceneInstant(np.array([1.0, 2.0, 3.0]), turn, lengths, lengths, none, none, ())
    directions = np.array([arm.direction for arm in arms])
    assert (bodies.ends(arms, now) == now.position + (lengths[:, None] * directions) @ turn.T).all()
    places = bodies.end_places(arms, now)
    rotors = bodies.rotor_places(rotor_shapes(ARQ.vehicle.airframe(), ARQ.vehicle), places, now)
    for place, rotor in nonempty(zip(places, rotors, strict=True)):
        assert place.rotation is turn
        assert (rotor.thrust == turn[:, 2]).all()
        assert rotor.position == pytest.approx(place.position)
    assert [arm.yielding(0.18) for arm in arms] == [arm.length - 0.18 for arm in arms]
    assert [arm.joint for arm in arms] == [()] * 4


def test_what_gives_way_to_either_side_is_told(scenes: dict[str, Scene]) -> None:
    arm = scenes["up"].arms[0]
    assert arm.yielding(0.20) == pytest.approx(0.01)
    assert arm.yielding(0.18) == pytest.approx(0.01)
    assert arm.reach == pytest.approx(np.hypot(0.19, 0.02))


def test_a_film_marks_hinges_and_nothing_else_is_new(scenes: dict[str, Scene]) -> None:
    for name, marked in (("up", True), ("legs", False)):
        scene = scenes[name]
        when = timing([scene], slow=20.0, begin=None, end=None, fps=25.0)
        frame = Frame([scene], when, (300, 270))
        k = int(np.argmin(np.abs(when.t + scene.impacts[0][0] - scene.t[most_bent(scene)])))
        frame.at(k)
        (robot,) = frame.panels[0][0].robots
        assert (robot.hinges is not None) == marked
        if robot.hinges is not None:
            now = bodies.pose(scene, scene.impacts[0][0] + float(when.t[k]))
            shown = np.array(robot.hinges.get_data()).T
            assert shown == pytest.approx(robot.view(bodies.hinges(scene.arms, now)))


# -- the page -------------------------------------------------------------------------------------


def test_the_page_knows_joints_as_numbers(scenes: dict[str, Scene]) -> None:
    (joint,) = plain(scenes["odd"])["arms"][1]["joint"]
    path = scenes["odd"].arms[1].joint[0].path
    assert joint["path"]["end"] == path.end._asdict()
    assert joint["path"]["curvature"] == path.curvature
    assert len(joint["anchor"]) == 3


@pytest.fixture(scope="module")
def driver(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    with browser(tmp_path_factory.mktemp("profile")) as found:
        yield found


@needs_browser
@pytest.mark.parametrize("name", ["up", "level", "odd", "legs"])
def test_the_page_draws_cages_where_the_equations_have_them(
    name: str, driver: Any, flights: dict[str, Flight], scenes: dict[str, Scene], tmp_path: Path
) -> None:
    page, scene = tmp_path / "joints.html", scenes[name]
    export_page(replay_of([flights[name]]), page)
    k = most_bent(scene)
    opened(driver, page, f"#t={float(scene.t[k])}")
    (shown,) = pose(driver)["ends"]
    now = bodies.pose(scene, float(scene.t[k]))
    for drawn, (end, turn) in nonempty(zip(shown, told(flights[name], scene, k), strict=True)):
        assert drawn["centre"] == pytest.approx(end, abs=1e-6)
        assert drawn["normal"] == pytest.approx(turn[:, 2], abs=1e-5)
        axis = (now.rotation if name == "level" else turn)[:, 2]
        assert drawn["thrust"] == pytest.approx(axis, abs=1e-5)
    assert complaints(driver) == []


@needs_browser
def test_the_page_draws_arms_in_the_plane_along_their_directions(
    driver: Any, tmp_path: Path
) -> None:
    flight, page = fly(TABLES), tmp_path / "plane.html"
    export_page(replay_of([flight]), page)
    scene = scene_of(flight)
    k = most_bent(scene)
    opened(driver, page, f"#t={float(scene.t[k])}")
    (shown,) = pose(driver)["ends"]
    now = bodies.pose(scene, float(scene.t[k]))
    for drawn, end in nonempty(zip(shown, bodies.ends(scene.arms, now), strict=True)):
        assert drawn["centre"] == pytest.approx(end, abs=1e-6)
        assert drawn["normal"] == pytest.approx(now.rotation[:, 2], abs=1e-5)
        assert drawn["thrust"] == pytest.approx(now.rotation[:, 2], abs=1e-5)
    assert complaints(driver) == []

"""What moves is drawn where it is, and every contact where it acts."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest
import scipy

from builders.cases import nonempty
from springback.interfaces.animation.bodies import at_instant, pose, views
from springback.interfaces.replay.geometry import drawables
from springback.interfaces.replay.scene import Scene, plain, scene_of
from springback.interfaces.replay.tracks import BodyTrack, relative_to, turned_by, way_of
from springback.results.flight import Flight, fly
from springback.simulation import playback

SURFACE = {"law": "hunt-crossley", "stiffness": 4e5, "dissipation": 0.3, "friction": 0.5}
#: A ball on a rod and a wall that moves back and forth: both begin elsewhere than they are placed.
OBSTACLES = [
    {"type": "sphere", "position": [0.42, 0.0, 0.0], "radius": 0.1, "surface": SURFACE,
     "motion": {"type": "pendulum", "mass": 1.0, "pivot": [0.42, 0.0, 1.5],
                "angular_velocity": [0.0, 1.2, 0.0]}},
    {"type": "ground", "height": -1.0, "surface": SURFACE},
    {"type": "wall", "distance": 1.2, "surface": SURFACE,
     "motion": {"type": "sine", "amplitude": [0.2, 0.0, 0.0], "frequency": 2.0, "phase": 1.0}},
    {"type": "box", "position": [0.0, 1.0, 0.0], "size": [0.3, 0.2, 0.1], "yaw": 0.4,
     "surface": SURFACE,
     "motion": {"type": "constant", "turning": 4.0, "velocity": [0.0, 0.0, 0.3],
                "about": [0.1, 1.0, 0.0]}},
]  # fmt: skip
TABLES = {
    "vehicle": "arq",
    "thrust": "hover",
    "world": {"obstacles": OBSTACLES},
    "start": {"position": [0.0, 0.0, 0.0]},
    "simulation": {"duration": 0.2},
}


@pytest.fixture(scope="module")
def flight() -> Flight:
    """ARQ hovers, and a ball swings in between two of its cages."""
    return fly(TABLES)


@pytest.fixture(scope="module")
def scene(flight: Flight) -> Scene:
    return scene_of(flight)


def moving(scene: Scene, name: str) -> Any:
    """What is drawn of an obstacle that moves."""
    [thing] = [one for one in scene.obstacles if one.track >= 0 and one.name == name]
    return thing


def test_a_ball_is_drawn_about_its_centre_at_any_instant(flight: Flight, scene: Scene) -> None:
    """Its vertices are a radius from the place that the trajectory gives, and it turns with the rod."""
    ball = moving(scene, "sphere")
    for t in nonempty((0.0, 0.031, 0.1, 0.2)):
        now = pose(scene, t)
        centre = np.array([np.interp(t, flight.t, flight.columns[f"obstacle0_{a}"]) for a in "xyz"])
        shown = at_instant(ball, now)
        away = np.linalg.norm(shown.vertices - centre, axis=1)
        assert np.abs(away - 0.1).max() < 1e-4
        rod = now.bodies[ball.track].rod
        np.testing.assert_allclose(rod, [[0.42, 0.0, 1.5], centre], atol=1e-4)
        # The lowest vertex of the ball as it was placed stays in line with the rod.
        lowest = shown.vertices[int(np.argmin(ball.vertices[:, 2]))]
        along = (centre - rod[0]) / np.linalg.norm(centre - rod[0])
        np.testing.assert_allclose(lowest - centre, 0.1 * along, atol=2e-3)


def test_a_wall_and_a_box_are_where_their_motion_says(scene: Scene) -> None:
    """A sine with a phase begins beside the place that is given; a box turns about its point."""
    wall, box = moving(scene, "wall"), moving(scene, "box")
    for t in nonempty((0.0, 0.07, 0.2)):
        now = pose(scene, t)
        face = at_instant(wall, now)
        assert face.normal == pytest.approx((-1.0, 0.0, 0.0))
        wanted = 1.2 + 0.2 * np.sin(4.0 * np.pi * t + 1.0)
        assert np.dot(face.centre, [1.0, 0.0, 0.0]) == pytest.approx(wanted, abs=3e-4)
        turn = scipy.spatial.transform.Rotation.from_rotvec([0.0, 0.0, 4.0 * t])
        about = np.array([0.1, 1.0, 0.0])
        there = turn.apply(box.vertices - about) + np.add(about, [0.0, 0.0, 0.3 * t])
        np.testing.assert_allclose(at_instant(box, now).vertices, there, atol=3e-4)


def test_contact_forces_act_on_the_surface_of_the_moving_ball(flight: Flight, scene: Scene) -> None:
    """Points are as deep in it as the cages are, and normal forces point away from its centre."""
    pressed = 0
    for i, k in np.argwhere(np.linalg.norm(scene.force, axis=2) > 1.0):
        centre = scene.bodies[moving(scene, "sphere").track].position[i]
        away = scene.point[i, k] - centre
        assert 0.1 - 5e-3 < np.linalg.norm(away) < 0.1 + 1e-5
        # Friction has at most half of the normal force.
        cosine = scene.force[i, k] @ away / np.linalg.norm(away) / np.linalg.norm(scene.force[i, k])
        assert cosine > 1.0 / np.hypot(1.0, 0.5) - 1e-3
        pressed += 1
    assert pressed > 100
    assert {scene.part[k] for k in np.flatnonzero(np.abs(scene.force).max(axis=(0, 2)))} == {0, 1}
    impulse = np.trapezoid(scene.force.sum(axis=1), scene.t, axis=0)
    told = [flight.measures[f"impulse_{axis}"] for axis in "xyz"]
    np.testing.assert_allclose(impulse, told, atol=3e-3 * np.linalg.norm(told))


def test_forces_are_those_of_the_columns(flight: Flight, scene: Scene) -> None:
    """Contacts of a part together have the size that the trajectory has; no remark says otherwise."""
    at = np.searchsorted(flight.t, scene.t)
    loads = playback.load_history(flight.scenario.flight_model(), flight.columns, at)
    for j in range(4):
        np.testing.assert_allclose(loads.normal[:, j], flight.columns[f"fn{j + 1}"][at], atol=1e-9)
    assert scene.notes == ()
    assert scene.departure["obstacles"] < 2e-4


def test_the_page_has_the_tracks(scene: Scene) -> None:
    """Numbers of tracks are those of the obstacles; the ball alone hangs on a rod."""
    data = json.loads(json.dumps(plain(scene)))
    assert [len(one["rod"]) for one in data["bodies"]] == [3, 0, 0]
    assert sorted(one["track"] for one in data["obstacles"]) == [-1, 0, 1, 2]
    assert all(one["position"]["shape"] == [len(scene.t), 3] for one in data["bodies"])
    assert len(data["part"]) == scene.force.shape[1]


def test_two_contacts_of_a_cage_are_two_arrows() -> None:
    """A cage head-on between two poles: one force at each, both back and towards the middle."""
    poles = [
        {"type": "pole", "position": [0.35, y, 0.0], "radius": 0.03, "surface": SURFACE}
        for y in (-0.08, 0.08)
    ]
    start = {"position": [0.0, 0.0, 0.0], "velocity": [2.0, 0.0, 0.0], "yaw": "45 deg"}
    scene = scene_of(fly(TABLES | {"world": {"obstacles": poles}, "start": start}))
    acting = np.linalg.norm(scene.force, axis=2) > 1.0
    touched = {scene.part[k] for k in np.flatnonzero(acting.any(axis=0))}
    assert len(touched) == 1
    at_once = np.flatnonzero(acting.sum(axis=1) == 2)
    assert len(at_once) > 20
    for i in at_once:
        force, point = scene.force[i][acting[i]], scene.point[i][acting[i]]
        assert (force[:, 0] < 0.0).all()
        np.testing.assert_allclose(np.sort(point[:, 1]), [-0.063, 0.063], atol=5e-3)
        assert (force[:, 1] * point[:, 1] < 0.0).all()
    # Each stays the contact with its pole.
    y = scene.point[at_once][:, acting[at_once[0]], 1]
    assert (np.sign(y) == np.sign(y[0])).all()


def test_contacts_keep_their_places_when_faces_change_over() -> None:
    """Faces come in order of depth: forces must not jump from one point to the other."""
    faces = np.zeros((40, 3, 10))
    deeper = np.sin(np.arange(40) / 3.0) > 0.0
    for row in range(40):
        order = (0, 1) if deeper[row] else (1, 0)
        for place, which in enumerate(order):
            faces[row, place, :4] = [0.0, 0.0, 10.0 + which, 10.0 + which]
            faces[row, place, 7:] = [0.001 * row, 1.0 * which, 0.0]
    found = playback._contacts(faces)
    assert found.shape == (40, 2, 6)
    assert np.ptp(found[:, 0, 2]) == np.ptp(found[:, 1, 2]) == 0.0
    assert np.ptp(found[:, 0, 4]) == 0.0


def test_what_moves_is_drawn_near_the_flight_as_it_sees_it() -> None:
    """A wall that comes 30 m is drawn where the vehicle is beside it."""
    from springback.scenario.scenario import expand_presets
    from springback.scenario.tables import WorldSettings

    table = {"type": "wall", "position": [30.0, 0.0, 0.0], "normal": [-1.0, 0.0, 0.0],
             "surface": "wall", "motion": {"type": "constant", "velocity": [-10.0, -5.0, 0.0]}}  # fmt: skip
    world = expand_presets({"vehicle": "arq", "world": {"obstacles": [table]}})["world"]
    known = WorldSettings.model_validate(world).obstacles
    t = np.linspace(0.0, 3.0, 31)[:, None]
    track = BodyTrack(0, (30.0, 0.0, 0.0), (), np.array([30.0, 0.0, 0.0]) + t * [-10.0, -5.0, 0.0],
                      np.tile([1.0, 0.0, 0.0, 0.0], (31, 1)))  # fmt: skip
    flown = np.zeros((31, 3))
    [face] = drawables(known, (), flown, flown[:0], (), [track]).drawables
    assert face.track == 0
    assert face.centre[0] == pytest.approx(30.0)
    # At the end, when it is near, it has moved 15 m to the right: there it is drawn, from its place.
    assert face.centre[1] == pytest.approx(15.0, abs=0.5)


def test_a_track_turns_points_there_and_back() -> None:
    rng = np.random.default_rng(3)
    attitude = rng.normal(size=(7, 4))
    track = BodyTrack(0, (1.0, 2.0, 3.0), (), rng.normal(size=(7, 3)), attitude)
    point = np.array([[0.3, -0.2, 0.9]])
    there = way_of(track, point, range(7))
    np.testing.assert_allclose(relative_to(track, there), np.tile(point, (7, 1)), atol=1e-12)
    np.testing.assert_allclose(np.linalg.det(turned_by(attitude)), 1.0, atol=1e-12)


def test_a_film_looks_along_the_way_on_which_a_ball_comes(scene: Scene) -> None:
    """The robot hovers: the view is along the ball's way, not along a cage's normal."""
    side, above = views(scene)
    assert abs(side.right[0]) > 0.99
    assert above.outward() == pytest.approx([0.0, 0.0, 1.0])

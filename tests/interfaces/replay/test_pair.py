"""Two vehicles of one world in one scene: of the page, and of a film."""

from __future__ import annotations

import re

import numpy as np
import pytest

from builders.cases import nonempty
from builders.pairs import two, vehicle
from springback.errors import InputError
from springback.interfaces.animation import bodies, timing
from springback.interfaces.animation.frame import Frame, worlds_of
from springback.interfaces.replay.labels import scenes_of
from springback.interfaces.replay.scene import Scene
from springback.interfaces.replay.viewer import MOST, replay_of
from springback.results.flight import Flight, fly

SIZE = (400, 360)


@pytest.fixture(scope="module")
def flight() -> Flight:
    comes = {**vehicle(0.6, -1.0, yaw=2.6, y=0.22), "name": "comes"}
    return fly(two(comes, name="waits"))


@pytest.fixture(scope="module")
def scenes(flight: Flight) -> list[Scene]:
    return scenes_of([flight])


def test_each_vehicle_has_a_scene_of_the_same_world(scenes: list[Scene]) -> None:
    """Named by its scenario where both are one robot; one first touch for both."""
    assert [scene.label for scene in scenes] == ["waits", "comes"]
    assert [scene.world for scene in scenes] == [0, 0]
    touches = {scene.first_touch for scene in scenes}
    assert touches == {min(scene.impacts[0][0] for scene in scenes)}
    assert not any(scene.notes for scene in scenes)


def test_vehicles_go_by_the_names_of_the_scenario_not_by_their_presets(flight: Flight) -> None:
    """Where the second has one: an ARQ and a Quad, too, and beside other flights of both."""
    quad = vehicle(0.6, -1.0, yaw=2.6, y=0.22) | {"vehicle": "quad"}
    named = fly(two({**quad, "name": "comes"}, name="waits"))
    assert [scene.label for scene in scenes_of([named])] == ["waits", "comes"]
    assert [scene.label for scene in scenes_of([named, flight], ["a", "b"])] == [
        "waits (a)", "comes (a, second)", "waits (b)", "comes (b, second)",
    ]  # fmt: skip
    unnamed = fly(two(quad, name="waits"))
    assert [scene.label for scene in scenes_of([unnamed])] == ["ARQ", "Quad"]


def test_forces_are_drawn_on_both_opposite_at_one_point(scenes: list[Scene]) -> None:
    """At an instant in the contact, as interpolated for a film."""
    assert scenes[0].first_touch is not None
    when = scenes[0].first_touch + 0.01
    there = [bodies.pose(scene, when) for scene in scenes]
    sums = [now.force.sum(axis=0) for now in there]
    assert np.linalg.norm(sums[0]) > 5.0
    assert sums[0] == pytest.approx(-sums[1], rel=0.02, abs=0.2)
    acting = [now.point[np.abs(now.force).max(axis=1) > 1.0] for now in there]
    for point in nonempty(acting[0]):
        assert np.linalg.norm(acting[1] - point, axis=1).min() < 2e-3


def test_worlds_are_told_apart(flight: Flight) -> None:
    """Two flights of two vehicles each are four scenes of two worlds."""
    scenes = scenes_of([flight, flight], ["slow", "fast"])
    assert [scene.world for scene in scenes] == [0, 0, 1, 1]
    assert len({scene.label for scene in scenes}) == 4
    assert [len(world) for world in worlds_of(scenes)] == [2, 2]


def test_a_film_shows_both_in_each_view(scenes: list[Scene]) -> None:
    """One column, whose views look along the line between both from the side, and from above."""
    when = timing.timing(scenes, slow=20.0, fps=25.0)
    picture = Frame(scenes, when, SIZE)
    assert len(picture.panels) == 1
    side, above = picture.panels[0]
    assert [len(panel.robots) for panel in (side, above)] == [2, 2]
    assert scenes[0].first_touch is not None
    now = [bodies.pose(scene, scenes[0].first_touch) for scene in scenes]
    right = side.view(now[1].position) - side.view(now[0].position)
    assert right[0] > 0.3
    k = int(np.searchsorted(when.t, 0.01))
    shape = picture.at(k).shape
    assert shape == (360, 400, 3)
    arrows = [len(path.vertices) for path in side.forces.get_paths()]
    assert len(arrows) >= 2
    labels = {text.get_text() for text in picture.figure.texts}
    assert {"waits", "comes"} <= labels


def test_the_film_of_a_pair_differs_without_the_second(scenes: list[Scene]) -> None:
    """Its robot is in the picture."""
    when = timing.timing(scenes, slow=20.0, fps=25.0)
    both, one = Frame(scenes, when, SIZE).at(0), Frame(scenes[:1], when, SIZE).at(0)
    assert (both != one).any()


def test_a_page_holds_both_and_counts_vehicles(flight: Flight) -> None:
    page = replay_of([flight])
    assert len(re.findall(r'"signals": ?{"trajectory"', page.text)) == 2
    with pytest.raises(InputError, match=rf"at most {MOST} vehicles \(got {MOST + 2}\)"):
        replay_of([flight] * (MOST // 2 + 1))


def test_a_vehicle_alone_is_a_world_of_its_own() -> None:
    """As before there was a second one: films count from its own first impact."""
    [scene] = scenes_of([fly({key: table for key, table in two().items() if key != "second"})])
    assert scene.first_touch is None
    assert timing.origin(scene) == scene.t[0]

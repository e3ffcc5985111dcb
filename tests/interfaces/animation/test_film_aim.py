"""The views of a film hold the whole robot in every frame, the ground close by, and its name."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from matplotlib.patches import PathPatch

from builders.cases import nonempty
from builders.films import thrown
from springback.interfaces.animation import timing
from springback.interfaces.animation.aim import FLAT, NEAR_GROUND, STRIP, WIDEST
from springback.interfaces.animation.bodies import pose
from springback.interfaces.animation.frame import Frame
from springback.interfaces.replay.geometry import Drawable
from springback.interfaces.replay.scene import Scene, scene_of

SIZE = (600, 540)


@pytest.fixture(scope="module")
def flat() -> Scene:
    return scene_of(thrown())


def tumbling(scene: Scene, turns: float = 2.0) -> Scene:
    """The same flight, turning over about the y axis."""
    half = np.pi * turns * (scene.t - scene.t[0]) / (scene.t[-1] - scene.t[0])
    none = np.zeros_like(half)
    return replace(scene, attitude=np.stack([np.cos(half), none, np.sin(half), none], axis=1))


def flown_off(scene: Scene, speed: float, height: float = 0.0) -> Scene:
    """The same flight with a motion [m/s] along y, which crosses the view from the side, and up."""
    away = np.outer(scene.t - scene.t[0], [-4.0 * speed, speed, height])
    return replace(scene, position=scene.position + away)


def film(*scenes: Scene) -> Frame:
    return Frame(scenes, timing.timing(scenes, slow=20.0, fps=5.0), SIZE)


def shown(picture: Frame) -> Any:
    """Of each frame and view: its limits, and the points of what is drawn of each robot."""
    for k, when in enumerate(picture.timing.t.tolist()):
        picture.at(k)
        for panel in (panel for column in picture.panels for panel in column):
            box = np.stack([panel.ax.get_xlim(), panel.ax.get_ylim()], axis=1)
            for robot in panel.robots:
                now = pose(robot.scene, timing.origin(robot.scene) + when)
                yield k, panel, box, robot.points(now)


@pytest.mark.parametrize(
    "motion", ["flat", "tumbling", "far away", "climbing", "two worlds", "apart"]
)
def test_the_whole_robot_is_in_both_views_in_every_frame(flat: Scene, motion: str) -> None:
    scenes = {
        "flat": [flat],
        "tumbling": [tumbling(flat)],
        "far away": [flown_off(tumbling(flat), 6.0)],
        "climbing": [flown_off(tumbling(flat), 0.0, 4.0)],
        "two worlds": [flat, replace(tumbling(flat), world=1)],
        "apart": [flat, flown_off(tumbling(flat), 3.0)],
    }[motion]
    for _, _, (low, high), points in nonempty(list(shown(film(*scenes)))):
        assert np.isfinite(points).all()
        assert (points.min(axis=0) > low).all()
        assert (points.max(axis=0) < high).all()


def test_a_flat_flight_is_as_large_as_ever_and_one_that_tips_has_a_higher_side_view(
    flat: Scene,
) -> None:
    level, tipped = film(flat), film(tumbling(flat))
    assert level.aim.side_share() == FLAT
    assert tipped.aim.side_share() == pytest.approx(0.5, abs=0.03)
    for picture, share in nonempty([(level, FLAT), (tipped, tipped.aim.side_share())]):
        heights = [panel.ax.get_window_extent().height for panel in picture.panels[0]]
        assert heights[0] / sum(heights) == pytest.approx(share, abs=0.01)
    widths = [box[1, 0] - box[0, 0] for _, _, box, _ in shown(level)]
    assert 0.8 < min(widths) < 1.9
    assert max(widths) <= 2.0 * WIDEST


@pytest.mark.parametrize(("below", "is_near"), [(0.1, True), (NEAR_GROUND + 0.4, False)])
def test_ground_close_below_is_in_the_view(flat: Scene, below: float, is_near: bool) -> None:
    [(_, _, _, points), *_] = shown(film(flat))
    level = float(points[:, 1].min()) - below
    ground = Drawable("ground", "ground", (2.5, 0.0, level), (0.0, 0.0, 1.0),
                      (0.0, 9.0, 0.0), (9.0, 0.0, 0.0))  # fmt: skip
    seen = [
        box[0, 1] < level - 0.9 * STRIP
        for _, panel, box, _ in shown(film(replace(flat, obstacles=(ground,))))
        if panel.view.up[2] > 0.5
    ]
    assert len(seen) > 10
    assert all(seen) if is_near else not any(seen)


@pytest.mark.parametrize(
    ("label", "size", "lines"),
    [("ARQ", (760, 540), 1), ("a rather long name of a scenario", (760, 540), 2),
     ("an endless name of a scenario " * 4, (760, 540), 2), ("ARQ (softer)", (400, 360), 2)],
)  # fmt: skip
def test_a_name_is_beside_the_numbers_or_above_them(
    flat: Scene, label: str, size: tuple[int, int], lines: int
) -> None:
    """It was written over them where two flights are side by side."""
    named = [replace(flat, label=label, world=k) for k in (0, 1)]
    picture = Frame(named, timing.timing(named, slow=20.0, fps=25.0), size)
    picture.at(len(picture.timing.t) // 2)
    assert picture.lines == lines
    for k, ([name], [line], views) in enumerate(
        zip(picture.names, picture.said, picture.panels, strict=True)
    ):
        written, numbers = name.get_window_extent(), line.get_window_extent()
        assert name.get_text() == label or (len(label) > 100 and name.get_text().endswith("…"))
        assert written.x1 < (k + 1) * size[0] / 2
        assert written.x1 < numbers.x0 if lines == 1 else written.y0 > numbers.y1 - 2.0
        assert views[0].ax.get_window_extent().y1 < numbers.y0


def test_ground_is_below_a_robot_that_flies_far(flat: Scene) -> None:
    """In the side view of the last frame, farther from the first touch than a view is wide."""
    moved = flown_off(flat, 100.0)
    assert np.linalg.norm(moved.position[-1] - moved.position[0]) > 60.0
    ground = Drawable("ground", "ground", (0.0, 0.0, 0.5), (0.0, 0.0, 1.0), (0.0, -9.0, 0.0),
                      (9.0, 0.0, 0.0))  # fmt: skip
    picture = film(replace(moved, obstacles=(ground,)))
    picture.at(len(picture.timing.t) - 1)
    side, _ = picture.panels[0]
    [area] = [one for one in side.ax.patches if isinstance(one, PathPatch)]
    corners = [(x, 0.45) for x in side.ax.get_xlim()]
    assert all(area.get_path().contains_point(one) for one in nonempty(corners))


def test_impacts_after_the_end_of_a_film_are_told(flat: Scene) -> None:
    """By their number and when; a film up to the end that is told holds them."""
    [(begin, end)] = flat.impacts
    one = replace(flat, impacts=((begin, end), (begin + 0.9, end + 0.9)))
    two = replace(one, impacts=(*one.impacts, (begin + 2.0, begin + 2.1234)))
    within = replace(flat, impacts=((begin, end), (begin + 0.7, begin + 0.95)))
    assert timing.impacts_left_out([flat]) == timing.impacts_left_out([within]) == ""
    assert "a later impact, 0.9 s after the first touch, is not" in timing.impacts_left_out([one])
    told = timing.impacts_left_out([two])
    assert told == (
        "2 later impacts, from 0.9 s after the first touch on, are not in it: --to 2.16 shows them"
    )

"""The views of a film hold the whole robot in every frame, the ground close by, and its name."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

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


def test_a_long_name_ends_before_the_numbers(flat: Scene) -> None:
    """It was written over them where two flights are side by side."""
    named = [replace(flat, label="a rather long name of a scenario", world=k) for k in (0, 1)]
    picture = Frame(named, timing.timing(named, slow=20.0, fps=25.0), (760, 540))
    picture.at(len(picture.timing.t) // 2)
    names = [text for text in picture.figure.texts if text.get_text().startswith("a rat")]
    assert len(names) == 2
    for name, [line] in zip(names, picture.said, strict=True):
        assert name.get_text().endswith("…")
        assert name.get_window_extent().x1 < line.get_window_extent().x0

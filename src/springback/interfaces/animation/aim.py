"""Where the views of a film look: at whole robots, in every frame, at any attitude."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.interfaces.animation.bodies import SceneInstant, pose
from springback.interfaces.animation.panel import ScenePanel
from springback.interfaces.animation.timing import EARLY, LATE, FilmTiming, origin
from springback.interfaces.replay.scene import Scene

Array = np.ndarray[Any, np.dtype[np.float64]]

ROOM = 1.15
"""Chosen: half the width or height of a view, over the reach of the robot in it."""
WIDEST = 1.4
"""Chosen: largest half width of a view [m]; on longer flights the view follows the robot."""
NEAR_GROUND, STRIP = 0.15, 0.04
"""Chosen: ground closer than this below a robot is in the view, with a strip this deep [m]."""
ZOOMING = 0.12
"""Chosen: flight time in which the view zooms in [s]."""
FLAT, TIPPED = 0.38, 0.55
"""Chosen: smallest and largest fraction of the views' height given to the side view."""
SIDEWAYS = 0.5
"""A view is from the side if the vertical component of its way up exceeds this."""


class ViewBox(NamedTuple):
    """What a view must hold in each frame; right and up, in the view's plane [m]."""

    low: Array  # corner of the box around the robots, shape (frames, 2)
    high: Array
    reach: Array  # largest distance from a main body of what is drawn of its robot, shape (2,)
    low_way: Array  # corner of the box around the robots in all frames, shape (2,)
    high_way: Array


class FilmAim:
    """Centres and scale of the views in every frame."""

    def __init__(self, columns: Sequence[Sequence[ScenePanel]], timing: FilmTiming) -> None:
        """Measure what is drawn of the robots in all frames.

        Args:
            columns: Views of each world: from the side and from above.
            timing: Of the film.
        """
        self.columns, self.timing = columns, timing
        self.extents = [[_extent(panel, timing) for panel in column] for column in columns]

    def side_share(self) -> float:
        """Fraction of the views' height for the side view: more if a robot tips over."""
        side, above = (max(float(each[k].reach[1]) for each in self.extents) for k in (0, 1))
        return min(max(side / (side + above), FLAT), TIPPED)

    def turn(self, k: int, poses: Sequence[Sequence[SceneInstant]]) -> None:
        """Set one scale for all views: zoomed in around impacts, following on long flights.

        Args:
            k: Frame.
            poses: State of each scene of each world in it.
        """
        when = float(self.timing.t[k])
        centres = [np.mean([now.position for now in each], axis=0) for each in poses]
        way = close = 0.0
        for centre, now, column, extents in zip(
            centres, poses, self.columns, self.extents, strict=True
        ):
            for panel, extent in zip(column, extents, strict=True):
                tall = panel.shape()
                way = max(way, _half_width(0.5 * (extent.high_way - extent.low_way), tall))
                close = max(close, _half_width(_around(panel, centre, now, extent), tall))
        follow, half = way > WIDEST, max(min(way, WIDEST), close)
        share = max((_nearness(when, a, b) for a, b in self.timing.slow), default=0.0)
        half = float(np.exp((1 - share) * np.log(half) + share * np.log(min(half, close))))
        for centre, column, extents in zip(centres, self.columns, self.extents, strict=True):
            for panel, extent in zip(column, extents, strict=True):
                here = panel.view(centre)
                middle = 0.5 * (extent.low_way + extent.high_way)
                middle = here if follow else (1 - share) * middle + share * here
                panel.look(_held(middle, extent.low[k], extent.high[k], half, panel), half)


def instants_of(scene: Scene, begin: float, end: float) -> Any:
    """Which of a scene's instants are between two instants of a film; at least one.

    Args:
        scene: Of a flight.
        begin: From first touch [s].
        end: From first touch [s].
    """
    t = scene.t - origin(scene)
    inside = (t >= begin) & (t <= end)
    if not inside.any():
        inside[int(np.argmin(np.abs(t - begin)))] = True
    return inside


def _extent(panel: ScenePanel, timing: FilmTiming) -> ViewBox:
    """What a view must hold of the robots, and of the ground close below."""
    count, grounds = len(timing.t), _grounds(panel)
    low, high, reach = np.full((count, 2), np.inf), np.full((count, 2), -np.inf), np.zeros(2)
    for robot in panel.robots:
        start = origin(robot.scene)
        for k, when in enumerate(timing.t.tolist()):
            now = pose(robot.scene, start + when)
            points = robot.points(now)
            begin, end = points.min(axis=0), points.max(axis=0)
            near = [z - STRIP for z in grounds if abs(begin[1] - z) < NEAR_GROUND]
            begin[1] = min(begin[1], *near, np.inf)
            middle = panel.view(now.position)
            reach = np.maximum(reach, np.maximum(middle - begin, end - middle))
            low[k], high[k] = np.minimum(low[k], begin), np.maximum(high[k], end)
    return ViewBox(low, high, reach, low.min(axis=0), high.max(axis=0))


def _grounds(panel: ScenePanel) -> list[float]:
    """Heights of the ground in a view from the side [m]."""
    faces = [thing for thing in panel.scene.obstacles if thing.kind == "ground"]
    return [thing.centre[2] for thing in faces if panel.view.up[2] > SIDEWAYS]


def _around(
    panel: ScenePanel, centre: Array, now: Sequence[SceneInstant], extent: ViewBox
) -> Array:
    """Half the size of a box around a point that holds the robots at any time, shape (2,) [m]."""
    away = [np.abs(panel.view(one.position) - panel.view(centre)) for one in now]
    return np.asarray(np.max(away, axis=0) + extent.reach)


def _half_width(size: Array, shape: float) -> float:
    """Half the width of a view of some ratio of height to width that holds half a size [m]."""
    return ROOM * max(float(size[0]), float(size[1]) / shape)


def _held(middle: Array, low: Array, high: Array, half: float, panel: ScenePanel) -> Array:
    """Centre of a view, moved no farther than the robots need to be in it."""
    inside = half * np.array([1.0, panel.shape()]) / (0.5 * (1.0 + ROOM))
    least, most = high - inside, low + inside
    return np.where(least > most, 0.5 * (low + high), np.clip(middle, least, most))


def _nearness(when: float, begin: float, end: float) -> float:
    """Zoom from 0 to 1: 1 in slow motion, eased at its ends."""
    away = max(0.0, begin + EARLY - when, when - (end - LATE))
    share = min(max(1.0 - away / ZOOMING, 0.0), 1.0)
    return share * share * (3.0 - 2.0 * share)

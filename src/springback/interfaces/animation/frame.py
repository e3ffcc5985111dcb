"""Frames of a film: robots from the side and from above, a clock, and the acceleration."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from springback.interfaces.animation.aim import FilmAim, instants_of
from springback.interfaces.animation.bodies import SceneInstant, pose, views
from springback.interfaces.animation.panel import ScenePanel
from springback.interfaces.animation.timing import FilmTiming, origin
from springback.interfaces.figures.style import escape
from springback.interfaces.output.robots import GREY, INK, ROBOTS, RobotStyle
from springback.interfaces.replay.scene import Scene

Array = np.ndarray[Any, np.dtype[np.float64]]
LOOKS = tuple(ROBOTS.values())
"""Looks of the first and of the second flight."""
ARROW = 0.28
"""Chosen: length of the arrow of the largest contact force [m]."""
CURVE, HEAD, GAP = 0.25, 0.07, 0.004
"""Chosen: heights of curve and clock and gap between the views, as fractions of the figure."""
MOST_GIVEN, SPACE, LARGE, SMALL = 0.0888, 8.0, 12.0, 9.0
"""Chosen: compression for which there is room [m], room after a name [px], its type sizes [pt]."""
ROW = 0.042
"""Chosen: height of a line above the views with a robot's name or numbers, likewise."""


class Frame:
    """A figure of its scenes at any instant."""

    def __init__(self, scenes: Sequence[Scene], timing: FilmTiming, size: tuple[int, int]) -> None:
        """Create the figure.

        Args:
            scenes: Of one world, or of two side by side; each has one vehicle or two.
            timing: Of the film.
            size: Width and height [px].
        """
        self.scenes, self.timing, self.worlds = tuple(scenes), timing, worlds_of(scenes)
        self.unit = min(size[0] / 720, size[1] / 540)
        self.figure = Figure(figsize=(size[0] / 100, size[1] / 100), dpi=100, facecolor="white")
        self.canvas = _canvas(self.figure)
        self.newton = ARROW / max(1.0, *(float(_size(s.force).max(initial=0.0)) for s in scenes))
        self.names: list[list[Any]] = []
        """Names of the robots of each world."""
        self.said: list[list[Any]] = []
        """Lines with numbers, of each robot of each world."""
        self.panels = [self._column(k) for k in range(len(self.worlds))]
        self.lines = self._place_words()
        """Lines above the views for each robot: 1, or 2 where names are above the numbers."""
        self.aim = FilmAim(self.panels, timing)
        self._place_views()
        self.curve = _Curve(self)
        self.words = [self._word(0.012, "left"), self._word(0.988, "right")]
        self.canvas.draw()
        self.still = self.canvas.copy_from_bbox(self.figure.bbox)

    def at(self, k: int) -> Array:
        """Pixels of frame ``k``, shape (height, width, 3), 8 bits."""
        when, slowness = float(self.timing.t[k]), float(self.timing.slowness[k])
        poses = [[pose(scene, origin(scene) + when) for scene in each] for each in self.worlds]
        self.aim.turn(k, poses)
        for scenes, now, column, said in zip(
            self.worlds, poses, self.panels, self.said, strict=True
        ):
            pasts = [one.position[instants_of(one, self.timing.begin, when)] for one in scenes]
            for panel in column:
                panel.turn(now, pasts, self.newton)
            for line, scene, there in zip(said, scenes, now, strict=True):
                line.set_text(_caption(scene, there))
        self.curve.turn(when)
        sign = "+" if when >= 0.0 else "−"
        self.words[0].set_text(f"t = {sign}{1e3 * abs(when):.0f} ms")
        self.words[1].set_text(f"slow motion 1/{slowness:.0f}")
        return self._background()

    def look_of(self, k: int) -> RobotStyle:
        """Look of the robot of a scene."""
        found = [
            LOOKS[(world + row) % 2]
            for world, scenes in enumerate(self.worlds)
            for row, _ in enumerate(scenes)
        ]
        return found[k]

    def _background(self) -> Array:
        """Pixels of the static artists, drawn once; moving ones are drawn on top."""
        self.canvas.restore_region(self.still)
        for panel in (panel for column in self.panels for panel in column):
            for artist in panel.moving:
                panel.ax.draw_artist(artist)
        for artist in self.curve.moving:
            self.curve.ax.draw_artist(artist)
        for word in (*self.words, *(line for said in self.said for line in said)):
            self.figure.draw_artist(word)
        return np.asarray(self.canvas.buffer_rgba())[:, :, :3].copy()

    def _word(self, x: float, side: Any) -> Any:
        weight = "bold" if side == "left" else "normal"
        size = 12 * self.unit
        return self.figure.text(
            x, 0.985, "", ha=side, va="top", fontsize=size, weight=weight, color=INK, animated=True
        )

    def _column(self, k: int) -> tuple[ScenePanel, ScenePanel]:
        """Draw a scene from the side and, below, from above."""
        scenes, width = self.worlds[k], 1.0 / len(self.worlds)
        side, above = views(*scenes)
        upper = self._panel(k, side, "from the side")
        lower = self._panel(k, above, "from above")
        self.names.append([])
        self.said.append([])
        for row, scene in enumerate(scenes):  # beside the views, where they cover nothing
            self.names[-1].append(
                self.figure.text(
                    k * width + 0.012, 0.0, escape(scene.label), va="center", weight="bold",
                    color=LOOKS[(k + row) % 2].colour,
                )
            )  # fmt: skip
            self.said[-1].append(
                self.figure.text(
                    (k + 1) * width - 0.012, 0.0, "", ha="right", va="center", color=INK,
                    fontsize=10 * self.unit, animated=True,
                )
            )  # fmt: skip
        return upper, lower

    def _place_words(self) -> int:
        """Write robots' names beside their numbers, in smaller type or else above them.

        Returns:
            Lines of each robot.
        """
        column = self.figure.bbox.width * (1.0 / len(self.worlds) - 0.024)
        each = [
            (name, scene, column - self._widest(line, scene) - SPACE * self.unit)
            for names, said, scenes in zip(self.names, self.said, self.worlds, strict=True)
            for name, line, scene in zip(names, said, scenes, strict=True)
        ]
        beside = any(
            all(_fits(name, room, size * self.unit) for name, _, room in each)
            for size in (LARGE, SMALL)
        )
        if not beside:
            for name, scene, _ in each:
                _shorten(name, scene.label, column, self.unit)
        lines = 1 if beside else 2
        for names, said in zip(self.names, self.said, strict=True):
            for row, (name, line) in enumerate(zip(names, said, strict=True)):
                name.set_y(1.0 - HEAD - ROW * (lines * row + 0.5))
                line.set_y(1.0 - HEAD - ROW * (lines * (row + 1) - 0.5))
        return lines

    def _widest(self, line: Any, scene: Scene) -> float:
        """Width of the longest line of numbers of a robot [px]."""
        line.set_text(_words(scene, float(_size(scene.force.sum(axis=1)).max()), MOST_GIVEN))
        width = float(line.get_window_extent().width)
        line.set_text("")
        return width

    def _place_views(self) -> None:
        """Give the views their places: the side view is as high as its robots need."""
        rows, width = self.lines * max(map(len, self.worlds)), 1.0 / len(self.worlds)
        height = 1.0 - CURVE - HEAD - ROW * rows
        share = self.aim.side_share()
        for k, (upper, lower) in enumerate(self.panels):
            for panel, low, tall in (
                (upper, (1.0 - share) * height, share * height),
                (lower, 0.0, (1.0 - share) * height),
            ):
                x, y = k * width + GAP, CURVE + low + GAP
                panel.ax.set_position((x, y, width - 2 * GAP, tall - 2 * GAP))

    def _panel(self, k: int, view: Any, words: str) -> ScenePanel:
        ax = self.figure.add_axes((0.0, 0.0, 1.0, 1.0))
        ax.set(xticks=[], yticks=[], facecolor="#FBFBFC")
        for spine in ax.spines.values():
            spine.set(color="#D5D9DE", linewidth=0.8)
        size = 9 * self.unit
        ax.text(0.015, 0.03, words, transform=ax.transAxes, fontsize=size, color="#5B6067")
        colours = [LOOKS[(k + row) % 2].colour for row in range(len(self.worlds[k]))]
        return ScenePanel(ax, view, self.worlds[k], colours, self.unit)


def worlds_of(scenes: Sequence[Scene]) -> list[list[Scene]]:
    """Scenes by their worlds, in order."""
    found: dict[int, list[Scene]] = {}
    for scene in scenes:
        found.setdefault(scene.world, []).append(scene)
    return list(found.values())


def _canvas(figure: Figure) -> Any:
    """Canvas of a figure; its methods have no type hints."""
    return FigureCanvasAgg(figure)


def _fits(name: Any, room: float, size: float) -> bool:
    """True if a name of a type size [pt] is no wider than ``room`` [px]."""
    name.set_fontsize(size)
    return bool(name.get_window_extent().width <= room)


def _shorten(name: Any, label: str, room: float, unit: float) -> None:
    """Write a name in the largest type in which it fits into ``room`` [px], or its beginning."""
    if not _fits(name, room, LARGE * unit) and not _fits(name, room, SMALL * unit):
        while label and not _fits(name, room, SMALL * unit):
            label = label[:-1]
            name.set_text(escape(f"{label.rstrip()}…"))


def _size(vectors: Array) -> Array:
    """Norms of vectors along the last axis."""
    return np.asarray(np.linalg.norm(vectors, axis=-1))


def _caption(scene: Scene, now: SceneInstant) -> str:
    """Sum of all contact forces, and compression of the arms, in one line."""
    given = enumerate(zip(scene.arms, now.lengths, strict=True))
    pressed = [arm.yielding(v, now.bend(j)) for j, (arm, v) in given]
    return _words(scene, float(_size(now.force.sum(axis=0))), max(*pressed, 0.0))


def _words(scene: Scene, force: float, pressed: float) -> str:
    """A force [N] and, of arms that give, the largest compression [m], in one line."""
    gives = any(arm.compliant for arm in scene.arms)
    return f"contact, sum {force:.0f} N{f', arms give {1e3 * pressed:.1f} mm' * gives}"


class _Curve:
    """Plot of the main bodies' acceleration up to the present instant."""

    def __init__(self, picture: Frame) -> None:
        """Create the axes, and curves without points.

        Args:
            picture: Frame that the plot belongs to.
        """
        timing, unit = picture.timing, picture.unit
        self.ax = picture.figure.add_axes((0.105, 0.095, 0.875, CURVE - 0.125))
        begin, end = timing.begin, timing.end
        self.curves: list[tuple[Line2D, Line2D, Array, Array]] = []
        self.moving: list[Artist] = [self.ax.axvline(begin, color=GREY, lw=0.9 * unit)]
        top = 1.0
        for k, scene in enumerate(picture.scenes):
            values = next(s.values for s in scene.series if s.panel == "Acceleration")
            t = scene.t - origin(scene)
            top = max(top, float(values[(t >= begin) & (t <= end)].max(initial=0.0)))
            look = picture.look_of(k)
            name = escape(scene.label)
            (line,) = self.ax.plot([], [], lw=1.8 * unit, label=name, **look.curve)
            (dot,) = self.ax.plot([], [], "o", ms=5 * unit, color=look.colour)
            self.curves.append((line, dot, 1e3 * t, values))
            self.moving += [line, dot]
        for artist in self.moving:
            artist.set_animated(True)
        self.ax.set(xlim=(1e3 * begin, 1e3 * end), ylim=(0.0, 1.08 * top))
        self._label(picture)

    def _label(self, picture: Frame) -> None:
        ax, unit = self.ax, picture.unit
        ax.set_ylabel("acceleration\n[m/s²]", fontsize=9 * unit, color=INK)
        zero = "first touch" if any(s.impacts for s in picture.scenes) else "the start"
        ax.set_xlabel(f"time from {zero} [ms]", fontsize=9 * unit, color=INK, labelpad=1.0)
        ax.tick_params(labelsize=8.5 * unit, colors=INK, length=2.5)
        ax.locator_params(axis="y", nbins=4)
        ax.spines[["top", "right"]].set_visible(False)
        ax.grid(color="#E2E5E9", lw=0.6)
        if len(picture.scenes) > 1:
            ax.legend(loc="upper right", fontsize=9 * unit, frameon=False, handlelength=2.2)

    def turn(self, when: float) -> None:
        """Show the curves up to an instant.

        Args:
            when: Time from first touch [s].
        """
        now = 1e3 * when
        for line, dot, t, values in self.curves:
            past, level = t <= now, float(np.interp(now, t, values))
            line.set_data(np.append(t[past], now), np.append(values[past], level))
            dot.set_data([now], [level])
        cursor: Any = self.moving[0]
        cursor.set_xdata([now, now])

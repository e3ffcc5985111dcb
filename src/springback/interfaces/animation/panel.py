"""One view of a robot in a film, or of two in one world."""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from itertools import cycle
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import to_hex, to_rgb
from matplotlib.lines import Line2D
from matplotlib.patches import PathPatch, Polygon
from matplotlib.path import Path
from scipy.spatial import ConvexHull

from springback.interfaces.animation.bodies import (
    MAST,
    SceneInstant,
    ViewPlane,
    arm_line,
    at_instant,
    body_outline,
    end_places,
    half_plane,
    hinges,
    hull_outline,
    is_hinged,
    latches,
    neighbour_lines,
    outlines_of,
    ring,
    rotor_places,
    section_outlines,
    silhouette,
)
from springback.interfaces.animation.user_surfaces import cut, smooth
from springback.interfaces.output.robots import GREEN, GREY, INK, ORANGE
from springback.interfaces.replay.geometry import Drawable
from springback.interfaces.replay.scene import ArmShape, Scene

Array = np.ndarray[Any, np.dtype[np.float64]]
Outlines = Callable[[Drawable, ViewPlane], list[Array]]
"""Outlines of an obstacle in a view [m]."""

MATTER = {"wall": "#B9C0C8", "mat": "#C9D8C4", "ground": "#CFC9BE"}
RIM = "#AEB5BD"
SHADES = ("#B9C0C8", "#CDBFAF", "#B3C6BA", "#C6BBCE", "#B2C6D1", "#D3BFBD")
"""Quiet colours of obstacles cut by the plane of a view, each kind its own, the first of walls."""
LIGHTER = 0.6
"""Chosen: share of white in the colour of bodies in front of and behind that plane."""
FAR = 30.0
"""Size of half planes beyond the flight, larger than any view [m]."""
THRUST_BAR = 0.10
"""Chosen: length of the bar of a rotor's maximum thrust [m]."""
SHAFT, BARB, HEAD = 0.006, 0.018, 0.035
"""Chosen: half the width of an arrow's shaft and head, and the length of its head [m]."""
PRESSED = 1e-3
"""Chosen: compression above which a cage is also drawn at its free length, dotted [m]."""
FAINT = 0.004
"""Chosen: length below which an arrow is not drawn [m]."""


class ScenePanel:
    """A view of the vehicles of a world; ``moving`` holds its artists in drawing order."""

    def __init__(
        self,
        ax: Axes,
        view: ViewPlane,
        scenes: Sequence[Scene],
        colours: Sequence[str],
        unit: float,
    ) -> None:
        """Create all lines and areas.

        Args:
            ax: Axes to draw in.
            view: The plane.
            scenes: Of a flight, and of a second vehicle in its world if there is one.
            colours: Colours of the robots.
            unit: Scale of type and line widths.
        """
        self.ax, self.view, self.scenes, self.scene = ax, view, tuple(scenes), scenes[0]
        self.moving: list[Artist] = []
        self.changing: list[tuple[Any, Drawable, Outlines]] = []
        self._obstacles(unit)
        rod: dict[str, Any] = {"color": GREY, "lw": 1.0 * unit}
        self.rods = [self.line(**rod) for _ in self.scene.bodies]
        self.robots = [
            RobotLines(self, scene, colour, unit)
            for scene, colour in zip(scenes, colours, strict=True)
        ]
        look: dict[str, Any] = {"facecolors": ORANGE, "edgecolors": INK, "linewidths": 0.5 * unit}
        self.forces = PolyCollection([], **look)
        self.animate(ax.add_collection(self.forces))
        self.scale = self.line(color=INK, lw=2.0 * unit, solid_capstyle="butt")
        self.length = ax.text(0.0, 0.0, "", fontsize=9 * unit, ha="center", va="bottom", color=INK)
        self.animate(self.length)

    def animate(self, artist: Any) -> None:
        """Draw an artist in every frame."""
        artist.set_animated(True)
        self.moving.append(artist)

    def line(self, **look: Any) -> Line2D:
        """A new line that is drawn in every frame."""
        line = self.ax.add_line(Line2D([], [], solid_joinstyle="round", **look))
        self.animate(line)
        return line

    def _obstacles(self, unit: float) -> None:
        """Outlines of bodies, faces, sections of bodies, and the ground, which hides their feet."""
        edge: dict[str, Any] = {"ec": "#7B838C", "lw": 0.8 * unit}
        shades = shades_of(self.scene.obstacles)
        meshes = [thing for thing in self.scene.obstacles if thing.vertices is not None]
        bodies = [smooth(thing) for thing in meshes]
        for thing in bodies:
            fill = lighter(shades[kind_of(thing)])
            if thing.normals is None:
                self._area(thing, silhouette, fc=fill, ec=RIM, lw=0.6 * unit)
            else:  # its outline has folds, which the area covers
                self._area(thing, silhouette, fc="none", ec=RIM, lw=1.2 * unit)
                self._area(thing, silhouette, fc=fill, ec="none")
        walls = [thing for thing in self.scene.obstacles if thing.normal]
        for thing in walls:
            if thing.kind != "ground":
                self._face(thing, shades[kind_of(thing)], edge)
        for thing in bodies:
            if thing.normals is None:
                self._area(thing, section_outlines, fc=shades[kind_of(thing)], **edge)
            else:  # it may be a piece of a surface
                areas, lines = cut(thing, self.view)
                self._area(thing, lambda *_, areas=areas: areas, fc=shades[kind_of(thing)], **edge)
                ends = LineCollection(lines, colors=GREY, linewidths=1.6 * unit)
                self.animate(self.ax.add_collection(ends))
        for thing in walls:
            if thing.kind == "ground":
                self._face(thing, MATTER["ground"], edge)

    def _face(self, thing: Drawable, colour: str, edge: dict[str, Any]) -> None:
        depths = (0.0, thing.thickness) if thing.thickness else (0.0,)
        for depth, fill in zip(depths, (colour, MATTER["wall"]), strict=False):
            self._area(thing, functools.partial(_behind, depth, self._far()), fc=fill, **edge)

    def _far(self) -> float:
        """Size of half planes: they are under all of the flight [m]."""
        away = [np.abs(scene.position - self.view.through).max() for scene in self.scenes]
        return FAR + 2.0 * float(max(away))

    def _area(self, thing: Drawable, outlines: Outlines, **look: Any) -> None:
        """Area within the outlines of an obstacle, which change if it moves."""
        found = outlines(thing, self.view)
        if found or thing.track >= 0:
            patch = self.ax.add_patch(PathPatch(_path(found), **look))
            self.animate(patch)
            if thing.track >= 0:
                self.changing.append((patch, thing, outlines))

    def shape(self) -> float:
        """Ratio of height to width."""
        box = self.ax.get_window_extent()
        return float(box.height / box.width)

    def look(self, middle: Array, half: float) -> None:
        """Centre the view on a point, with a scale bar.

        Args:
            middle: Point in the plane [m].
            half: Half the width [m].
        """
        tall = half * self.shape()
        self.ax.set_xlim(middle[0] - half, middle[0] + half)
        self.ax.set_ylim(middle[1] - tall, middle[1] + tall)
        bar = 0.1 if half < 0.9 else 0.5
        right, y = middle[0] + 0.95 * half, middle[1] - 0.9 * tall
        self.scale.set_data((right - bar, right), (y, y))
        self.length.set_position((right - 0.5 * bar, y + 0.02 * half))
        self.length.set_text(f"{bar:g} m")

    def turn(self, poses: Sequence[SceneInstant], pasts: Sequence[Array], newton: float) -> None:
        """Move all artists to an instant.

        Args:
            poses: The instant of each scene.
            pasts: Positions of each main body up to now [m].
            newton: Length of an arrow per force [m/N].
        """
        view, now = self.view, poses[0]
        there = {id(thing): at_instant(thing, now) for _, thing, _ in self.changing}
        for patch, thing, outlines in self.changing:
            patch.set_path(_path(outlines(there[id(thing)], view)))
        for line, body in zip(self.rods, now.bodies, strict=True):
            line.set_data(*view(body.rod).T)
        for robot, pose, past in zip(self.robots, poses, pasts, strict=True):
            robot.turn(pose, past)
        self.forces.set_verts([
            arrow(view(pose.point[j] - newton * force), view(pose.point[j]))
            for pose in poses
            for j, force in enumerate(pose.force)
            if np.linalg.norm(force) * newton > FAINT
        ])  # fmt: skip


def kind_of(thing: Drawable) -> str:
    """Name of what an obstacle is drawn as, each in one colour."""
    moving = ", moving" if thing.track >= 0 else ""
    return f"{thing.name}{moving}" if thing.vertices is not None else thing.kind


def shades_of(obstacles: Sequence[Drawable]) -> dict[str, str]:
    """Colours of obstacles by their kinds: mat and ground have their own, a wall the first."""
    kinds = list(dict.fromkeys(map(kind_of, obstacles)))
    others = sorted((kind for kind in kinds if kind not in ("mat", "ground")), key="wall".__ne__)
    return MATTER | dict(zip(others, cycle(SHADES), strict=False))


def lighter(colour: str) -> str:
    """A colour mixed with white."""
    mixed = (1.0 - LIGHTER) * np.array(to_rgb(colour)) + LIGHTER
    return str(to_hex(mixed.tolist()))


class RobotLines:
    """Lines and areas of one robot in a view."""

    def __init__(self, panel: ScenePanel, scene: Scene, colour: str, unit: float) -> None:
        """Create them.

        Args:
            panel: View that they are in.
            scene: Scene of the robot.
            colour: Its colour.
            unit: Scale of line widths.
        """
        self.view, self.scene = panel.view, scene
        self.trail = panel.line(color=colour, lw=1.2 * unit, alpha=0.55)
        arms = range(len(scene.arms))
        dotted: dict[str, Any] = {"color": GREY, "lw": 0.9 * unit, "ls": (0, (2, 2))}
        self.free = [panel.line(**dotted) for _ in arms]
        self.cages = [panel.line(color=INK, lw=1.5 * unit) for _ in arms]
        self.arms = [panel.line(color=colour, lw=width_of(arm) * unit) for arm in scene.arms]
        bar: dict[str, Any] = {"color": GREEN, "lw": 2.6 * unit, "solid_capstyle": "butt"}
        self.discs = [panel.line(color=GREEN, lw=0.8 * unit) for _ in scene.rotors]
        self.thrusts = [panel.line(**bar) for _ in scene.rotors]
        self.hull = [panel.line(color=INK, lw=0.9 * unit, alpha=0.6) for _ in scene.hull]
        self.at_ends = [panel.line(color=INK, lw=0.9 * unit, alpha=0.6) for _ in arms]
        pin: dict[str, Any] = {"color": INK, "ls": "none", "marker": "o", "ms": 4.0 * unit}
        self.hinges = panel.line(**pin) if any(map(is_hinged, scene.arms)) else None
        coil: dict[str, Any] = {"color": GREY, "lw": 1.0 * unit}
        self.neighbours = [panel.line(**coil) for _ in scene.neighbours]
        face: dict[str, Any] = {"lw": 2.2 * unit, "marker": "s", "ms": 4.5 * unit, "mec": INK}
        self.latches = [panel.line(**face) for arm in scene.arms for _ in arm.latch]
        self.mast = panel.line(color=INK, lw=1.4 * unit)
        self.body = Polygon(np.zeros((3, 2)), fc=colour, ec=INK, lw=0.8 * unit)
        panel.animate(panel.ax.add_patch(self.body))
        pins = [] if self.hinges is None else [self.hinges]
        self.own = [
            *self.free, *self.cages, *self.arms, *self.discs, *self.thrusts, *self.hull,
            *self.at_ends, *pins, *self.neighbours, *self.latches, self.mast,
        ]  # fmt: skip

    def points(self, now: SceneInstant) -> Array:
        """Points of all lines and areas of the robot itself at an instant, without its trail [m].

        Args:
            now: The instant.

        Returns:
            In the plane of the view, shape (points, 2).
        """
        self.turn(now, np.zeros((0, 3)))
        lines = np.vstack([*(line.get_xydata() for line in self.own), self.body.get_xy()])
        return np.asarray(lines[~np.isnan(lines[:, 0])])

    def turn(self, now: SceneInstant, past: Array) -> None:
        """Move all to an instant.

        Args:
            now: The instant.
            past: Positions of the main body up to now [m].
        """
        view, scene = self.view, self.scene
        self.trail.set_data(*view(np.vstack([past, now.position])).T)
        places = end_places(scene.arms, now)
        free = end_places(scene.arms, now, free=True)
        for j, (arm, tip) in enumerate(zip(scene.arms, places, strict=True)):
            points = None if arm.caged else 0
            rest = ring(free[j].position, arm.cage_radius, free[j].rotation)[:points]
            pressed = max(abs(arm.length - now.lengths[j]), abs(now.bend(j))) > PRESSED
            self.free[j].set_data(*view(rest if pressed else rest[:0]).T)
            cage = ring(tip.position, arm.cage_radius, tip.rotation)[:points]
            self.cages[j].set_data(*view(cage).T)
            self.arms[j].set_data(*view(arm_line(arm, now, now.lengths[j], now.bend(j))).T)
        rotors = rotor_places(scene.rotors, places, now)
        for line, circle, thrust, rotor in zip(
            self.thrusts, self.discs, now.thrust, rotors, strict=True
        ):
            circle.set_data(*view(rotor.disc).T)
            bar = THRUST_BAR * thrust / max(scene.max_thrust, 1e-9) * rotor.thrust
            line.set_data(*view(np.array([rotor.position, rotor.position + bar])).T)
        for line, shape in zip(self.hull, scene.hull, strict=True):
            line.set_data(*hull_outline(shape, now, view).T)
        for line, arm, tip in zip(self.at_ends, scene.arms, places, strict=True):
            line.set_data(*outlines_of(arm.hulls, tip.position, tip.rotation, view).T)
        if self.hinges is not None:
            self.hinges.set_data(*view(hinges(scene.arms, now)).T)
        coils = neighbour_lines(scene.neighbours, scene.arms, now)
        for line, coil_points in zip(self.neighbours, coils, strict=True):
            line.set_data(*view(coil_points).T)
        for line, latch in zip(self.latches, latches(scene.arms, now), strict=True):
            line.set_data(*view(np.array([latch.on_body, latch.on_arm])).T)
            line.set(color="none" if latch.is_open else INK, mfc=ORANGE if latch.is_open else INK)
        mast = np.array([now.position, now.position + MAST * now.rotation[:, 2]])
        self.mast.set_data(*view(mast).T)
        rims = view(np.vstack(body_outline(now)))
        self.body.set_xy(rims[ConvexHull(rims).vertices])


def width_of(arm: ArmShape) -> float:
    """Width of the line of an arm: a spring is thin, a strut is not."""
    return 1.2 if arm.compliant and not is_hinged(arm) else 3.0


def _behind(depth: float, far: float, thing: Drawable, view: ViewPlane) -> list[Array]:
    """Outline of what is behind a face by more than a depth [m]; none if it is seen flat on."""
    area = half_plane(thing, view, depth, far)
    return [] if area is None else [np.vstack([area, area[:1]])]


def _path(outlines: list[Array]) -> Path:
    if not outlines:
        return Path(np.zeros((0, 2)))
    return Path.make_compound_path(*(Path(one, closed=True) for one in outlines))


def arrow(tail: Array, tip: Array) -> Array:
    """Outline of an arrow, shape (7, 2).

    Args:
        tail: Start [m].
        tip: End [m].
    """
    long = float(np.linalg.norm(tip - tail))
    along = (tip - tail) / max(long, 1e-12)
    across, neck = np.array([-along[1], along[0]]), tip - min(HEAD, 0.6 * long) * along
    return np.array([
        tail - SHAFT * across, neck - SHAFT * across, neck - BARB * across, tip,
        neck + BARB * across, neck + SHAFT * across, tail + SHAFT * across,
    ])  # fmt: skip

"""Pictures of window, doorway, forest, drop tower and two vehicles, from the examples.

python docs/figures/scenes.py [FOLDER [NAME ...]]
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np

mpl.use("Agg")
import matplotlib.pyplot as plt

import springback
from springback.interfaces.animation.bodies import (
    ViewPlane,
    arm_line,
    body_outline,
    ends,
    pose,
    ring,
    section_outlines,
)
from springback.interfaces.figures.style import STYLE
from springback.interfaces.output.robots import ROBOTS
from springback.interfaces.replay.labels import scenes_of
from springback.interfaces.replay.scene import Scene, scene_of

HERE = Path(__file__).parent
EXAMPLES = HERE.parents[1] / "examples"
INK, STONE, EDGE, FORCE = "#22262b", "#c9ced6", "#7b838c", "#c6511c"
#: Colours of the first and the second vehicle.
BODIES = (ROBOTS["arq"].colour, ROBOTS["quad"].colour)
X, Y, Z = np.eye(3)


def above(height: float) -> ViewPlane:
    """View from above, through a height [m]."""
    return ViewPlane(X, Y, height * Z)


def draw_world(ax: Any, scene: Scene, view: ViewPlane) -> None:
    """Sections of all bodies with the plane of a view."""
    for thing in scene.obstacles:
        for outline in section_outlines(thing, view):
            ax.fill(*outline.T, fc=STONE, ec=EDGE, lw=0.6)


def draw_robot(ax: Any, scene: Scene, view: ViewPlane, t: float, look: dict[str, Any]) -> None:
    """A robot at an instant, with a dot where something pushes it."""
    now, thin = pose(scene, t), look.get("thin", 1.0)
    body = {"color": look["colour"], "alpha": look.get("alpha", 1.0)}
    tips = ends(scene.arms, now)
    for j, (arm, tip, length) in enumerate(zip(scene.arms, tips, now.lengths, strict=True)):
        cage = ring(tip, arm.cage_radius, now.rotation)
        ax.plot(*view(cage).T, color=INK, lw=0.9 * thin, alpha=body["alpha"])
        ax.plot(*view(arm_line(arm, now, length, now.bend(j))).T, lw=0.7 * thin, **body)
    for rim in body_outline(now):
        ax.fill(*view(rim).T, lw=0.0, **body)
    for force, point in zip(now.force, now.point, strict=True):
        if np.linalg.norm(force) > 1.0:
            ax.plot(*view(point), "o", ms=4.0 * thin, color=FORCE, zorder=5)


def draw_path(ax: Any, scene: Scene, view: ViewPlane, colour: str, until: float) -> None:
    """Way of the main body until an instant."""
    ax.plot(*view(scene.position[scene.t <= until]).T, color=colour, lw=0.8, alpha=0.6)


def frame(ax: Any, across: tuple[float, float], along: tuple[float, float], bar: float) -> None:
    """Limits of a panel, and a scale bar below on the right."""
    ax.set(aspect="equal", xlim=across, ylim=along, xticks=[], yticks=[])
    for side in ax.spines.values():
        side.set_visible(False)
    right = across[1] - 0.06 * (across[1] - across[0])
    y = along[0] + 0.05 * (along[1] - along[0])
    ax.plot((right - bar, right), (y, y), color=INK, lw=1.6, solid_capstyle="butt")
    ax.text(right - 0.5 * bar, y, f"{bar:g} m", ha="center", va="bottom", fontsize=8)


def passages(name: str, cases: dict[str, str], instants: Sequence[float], wall: float) -> Any:
    """The robot at several instants, later ones darker, seen from above, a panel for each case.

    Args:
        name: Of the example.
        cases: Titles, and what is overridden.
        instants: From when the robot's middle is 0.7 m before the wall's [s].
        wall: X of the wall's middle [m].
    """
    tall = 6.2 / len(cases) + 0.3
    figure, axes = plt.subplots(1, len(cases), figsize=(10.0, tall), layout="constrained")
    for ax, (title, override) in zip(axes, cases.items(), strict=True):
        scene = scene_of(springback.fly(EXAMPLES / f"{name}.toml", override))
        near = scene.t[int(np.argmax(scene.position[:, 0] > wall - 0.7))]
        times = [min(near + t, scene.t[-1]) for t in instants]
        view = above(1.0)
        draw_world(ax, scene, view)
        draw_path(ax, scene, view, BODIES[0], times[-1])
        for k, t in enumerate(times):
            alpha = 0.3 + 0.7 * k / (len(times) - 1)
            draw_robot(ax, scene, view, t, {"colour": BODIES[0], "alpha": alpha})
        frame(ax, (wall - 1.05, wall + 1.35), (-0.75, 0.75), 0.2)
        ax.set_title(title, fontsize=10)
    return figure


def window() -> Any:
    """A window wide enough, and one that is not."""
    cases = {
        "opening of 60 cm": "world.obstacles.0.opening=[0.6, 0.6]",
        "opening of 46 cm": "world.obstacles.0.opening=[0.46, 0.6]",
    }
    return passages("window", cases, (0.05, 0.3, 0.7), 2.75)


def doorway() -> Any:
    """A door straight ahead, and two farther aside."""
    cases = {
        "door straight ahead": "world.obstacles.0.position=[3, 0, 0]",
        "door 10 cm aside": "world.obstacles.0.position=[3, 0.1, 0]",
        "door 20 cm aside": "world.obstacles.0.position=[3, 0.2, 0]",
    }
    return passages("doorway", cases, (0.0, 0.25, 0.5, 0.85), 3.0)


def forest() -> Any:
    """Flights through trunks, few and many, from above."""
    figure, axes = plt.subplots(2, 1, figsize=(10.0, 4.9), layout="constrained")
    view = above(1.0)
    for ax, density in zip(axes, (0.2, 0.5), strict=True):
        override = f"world.obstacles.0.density={density}"
        scene = scene_of(springback.fly(EXAMPLES / "forest.toml", override))
        draw_world(ax, scene, view)
        draw_path(ax, scene, view, BODIES[0], scene.t[-1])
        inside = scene.t[int(np.argmax(scene.position[:, 0] > 2.3))]
        for t in np.arange(inside, scene.t[-1], 0.45):
            draw_robot(ax, scene, view, t, {"colour": BODIES[0], "alpha": 0.8, "thin": 0.8})
        frame(ax, (1.8, 13.2), (-1.3, 1.3), 0.5)
        ax.set_title(f"{density} trunks per square metre", fontsize=10)
    return figure


def drop() -> Any:
    """A fall, from the side."""
    scene = scene_of(springback.fly(EXAMPLES / "drop.toml"))
    touch = scene.impacts[0][0]
    instants = (-0.08, 0.003, 0.02, 0.06, 0.3)
    figure, axes = plt.subplots(1, len(instants), figsize=(10.0, 2.7), layout="constrained")
    view = ViewPlane(X, Z, np.zeros(3))
    for ax, when in zip(axes, instants, strict=True):
        ax.axhspan(-1.0, 0.0, fc=STONE, lw=0.0)
        draw_robot(ax, scene, view, touch + when, {"colour": BODIES[0]})
        x = float(pose(scene, touch + when).position[0])
        frame(ax, (x - 0.45, x + 0.45), (-0.16, 0.9), 0.1)
        ax.set_title(f"{1e3 * when:+.0f} ms", fontsize=10)
    return figure


def pair() -> Any:
    """Two vehicles that meet, from above."""
    scenes = scenes_of([springback.fly(EXAMPLES / "pair.toml")])
    touch = scenes[0].impacts[0][0]
    instants = (-0.15, 0.015, 0.4, 0.875, 1.5)
    figure, axes = plt.subplots(1, len(instants), figsize=(10.0, 1.8), layout="constrained")
    view = above(2.0)
    for ax, when in zip(axes, instants, strict=True):
        for scene, colour in zip(scenes, BODIES, strict=True):
            draw_path(ax, scene, view, colour, touch + when)
            draw_robot(ax, scene, view, touch + when, {"colour": colour})
        frame(ax, (-0.85, 1.05), (-0.6, 0.75), 0.2)
        ax.set_title(f"{1e3 * when:+.0f} ms", fontsize=10)
    return figure


PICTURES = {one.__name__: one for one in (window, doorway, forest, drop, pair)}


def main(folder: Path, names: Sequence[str]) -> None:
    """Draw those named, or all."""
    with plt.style.context(STYLE[-1]):
        for name in names or PICTURES:
            figure = PICTURES[name]()
            figure.savefig(folder / f"{name}.png", dpi=110)
            plt.close(figure)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else HERE, sys.argv[2:])

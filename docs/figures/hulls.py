"""Picture of a robot with a box for a body that falls on stairs, from the example.

python docs/figures/hulls.py
"""

from __future__ import annotations

from pathlib import Path

import matplotlib as mpl
import numpy as np

mpl.use("Agg")
import matplotlib.pyplot as plt

from springback.interfaces.animation.bodies import (
    ViewPlane,
    ends,
    hull_outline,
    pose,
    ring,
    silhouette,
)
from springback.interfaces.figures.style import STYLE
from springback.interfaces.replay.scene import scene_of
from springback.results.flight import fly
from springback.scenario.files import read_scenario

HERE = Path(__file__).parent
EXAMPLE = HERE.parents[1] / "examples" / "box_on_stairs.toml"
INSTANTS = (0.0, 0.4, 0.55, 0.8, 1.2)
INK, STONE = "#22262b", "#c9ced6"


def main() -> None:
    """Write hulls.png beside this file."""
    scene = scene_of(fly(read_scenario(EXAMPLE)))
    view = ViewPlane(np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0]), np.zeros(3))
    with plt.style.context(STYLE[-1]):
        fig, axes = plt.subplots(1, len(INSTANTS), figsize=(10.0, 2.9), sharey=True)
        for ax, t in zip(axes, INSTANTS, strict=True):
            now = pose(scene, t)
            ax.axhline(-0.5, color=STONE, lw=3.0)
            for thing in scene.obstacles:
                for outline in silhouette(thing, view):
                    ax.fill(*outline.T, color=STONE, lw=0.0)
            for arm, tip in zip(scene.arms, ends(scene.arms, now), strict=True):
                ax.plot(*view(ring(tip, arm.cage_radius, now.rotation)).T, color=INK, lw=0.9)
                ax.plot(*view(np.array([now.position, tip])).T, color=INK, lw=0.7)
            for shape in scene.hull:
                ax.plot(*hull_outline(shape, now, view).T, color="#c6511c", lw=1.6)
            for force, point in zip(now.force, now.point, strict=True):
                if np.linalg.norm(force) > 0.0:
                    x, z = view(point)
                    ax.plot(x, z, "o", ms=3.0, color="#2b7a4b")
            ax.set(aspect="equal", xlim=(-1.15, 0.65), ylim=(-0.55, 1.15), title=f"{t:.2f} s")
            ax.axis("off")
        fig.savefig(HERE / "hulls.png", dpi=130)


if __name__ == "__main__":
    main()

"""Picture of the swinging ball of docs/howto/moving_obstacle.md, from its example.

python docs/figures/swinging_ball.py
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np

mpl.use("Agg")
import matplotlib.pyplot as plt

import springback
from springback.interfaces.animation.bodies import pose, views
from springback.interfaces.animation.panel import ScenePanel
from springback.interfaces.figures.style import STYLE as STYLES
from springback.interfaces.output.robots import ROBOTS
from springback.interfaces.replay.scene import scene_of

HERE = Path(__file__).parent
EXAMPLE = HERE.parents[1] / "examples" / "swinging_ball.toml"
#: Instants from first touch [s]; half the width of the views [m], and how far they look ahead.
INSTANTS, HALF, AHEAD = (-0.25, 0.009, 0.3, 0.8), 0.74, 0.0
#: Length of the arrow of the largest force [m].
ARROW = 0.3


def sequence(flight: Any) -> Any:
    """The flight at some instants, from the side and from above."""
    scene = scene_of(flight)
    touch = scene.impacts[0][0]
    newton = ARROW / float(np.linalg.norm(scene.force, axis=2).max())
    size = {"figsize": (2.5 * len(INSTANTS), 4.0), "layout": "constrained"}
    figure, rows = plt.subplots(2, len(INSTANTS), **size)
    for axes, view in zip(rows, views(scene), strict=True):
        middle = np.add(view(scene.position[0]), [AHEAD, 0.0])
        for ax, when in zip(axes, INSTANTS, strict=True):
            ax.set(xticks=[], yticks=[])
            panel = ScenePanel(ax, view, [scene], [ROBOTS["arq"].colour], 0.75)
            figure.canvas.draw()
            past = scene.position[scene.t <= touch + when]
            panel.turn([pose(scene, touch + when)], [past], newton)
            panel.look(middle, HALF)
    for ax, when in zip(rows[0], INSTANTS, strict=True):
        ax.set_title(f"{1e3 * when:+.0f} ms", fontsize=9)
    for ax, words in zip(rows[:, 0], ("from the side", "from above"), strict=True):
        ax.set_ylabel(words)
    return figure


def main() -> None:
    """Write the picture beside this file, or into the folder given."""
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else HERE
    with plt.style.context(STYLES):
        figure = sequence(springback.fly(EXAMPLE))
        figure.savefig(folder / "swinging_ball.png", dpi=110)


if __name__ == "__main__":
    main()

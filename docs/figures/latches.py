"""Picture of arms with latches and of springs between arms, for docs/howto/vehicle.md.

python docs/figures/latches.py
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
HINGE = {
    "type": "hinge", "position": [0.06, 0, 0], "axis": [0, 0, 1], "travel": [0, "60 deg"],
    "stiffness": "0.5 N m/rad", "damping": "0.02 N m s/rad",
    "latch": {"torque": "2 N m", "travel": "1 deg"},
}  # fmt: skip
ARMS: dict[str, dict[str, Any]] = {
    "hinges with latches": {"joint": HINGE},
    "springs between arms": {"neighbours": {"stiffness": "2 N/mm", "damping": "5 N s/m"}},
    "both, softer between": {
        "joint": HINGE, "neighbours": {"stiffness": "0.4 N/mm", "damping": "5 N s/m"},
    },
}  # fmt: skip
#: Half the width of a view, how far it looks ahead of the robot, and the largest force's arrow [m].
HALF, AHEAD, ARROW = 0.36, 0.03, 0.15
#: Instant that is drawn, from first touch [s].
WHEN = 0.015


def scenario(arms: dict[str, Any]) -> dict[str, Any]:
    """ARQ with other arms, flown askew against a wall at 2.5 m/s."""
    return {
        "vehicle": {"preset": "arq", "arms": arms}, "thrust": "hover",
        "world": {"obstacles": [{"type": "wall", "distance": 1.0, "surface": "paper-wall"}]},
        "start": {"position": [0.62, 0, 1], "velocity": [2.5, 0.1, 0], "pitch": 0.1},
        "simulation": {"duration": 0.15},
    }  # fmt: skip


def main() -> None:
    """Write latches.png beside this file, or into the folder given."""
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else HERE
    with plt.style.context(STYLES):
        figure, axes = plt.subplots(1, len(ARMS), figsize=(9.0, 3.2), layout="constrained")
        for ax, (words, arms) in zip(axes, ARMS.items(), strict=True):
            scene = scene_of(springback.fly(scenario(arms)))
            ax.set(xticks=[], yticks=[])
            ax.set_title(words, fontsize=9)
            _, above = views(scene)
            panel = ScenePanel(ax, above, [scene], [ROBOTS["arq"].colour], 0.9)
            figure.canvas.draw()
            now = pose(scene, scene.impacts[0][0] + WHEN)
            newton = ARROW / float(np.linalg.norm(scene.force, axis=2).max())
            panel.turn([now], [scene.position[:0]], newton)
            panel.look(np.add(above(now.position), [AHEAD, 0.0]), HALF)
            for artist in panel.moving:
                artist.set_animated(False)
        figure.savefig(folder / "latches.png", dpi=110)


if __name__ == "__main__":
    main()

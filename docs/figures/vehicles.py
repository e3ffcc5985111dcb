"""Picture of the published vehicles of the library, from above and from the side, to scale.

python docs/figures/vehicles.py
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np

mpl.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.transforms import Affine2D

from springback.interfaces.animation.bodies import (
    SceneInstant,
    ViewPlane,
    ends,
    hull_outline,
    latches,
    neighbour_lines,
    outlines_of,
    ring,
)
from springback.interfaces.figures.style import STYLE
from springback.interfaces.replay.scene import arm_shapes, hull_shapes, neighbour_shapes
from springback.vehicle.library import OF_OTHERS
from springback.vehicle.parameters import Vehicle

HERE = Path(__file__).parent
INK, TOUCHES, ROTOR = "#22262b", "#c6511c", "#9aa3ad"
X, Y, Z = np.eye(3)
#: From above, and lower by some metres from the side: in one frame, so that both have one scale.
VIEWS = ((ViewPlane(X, Y, np.zeros(3)), 0.0), (ViewPlane(X, Z, np.zeros(3)), 0.47))


def main() -> None:
    """Write vehicles.png beside this file."""
    across = (len(OF_OTHERS) + 1) // 2
    with plt.style.context(STYLE[-1]):
        fig, axes = plt.subplots(2, across, figsize=(2.2 * across, 8.2))
        for ax in axes.flat:
            ax.set(aspect="equal", xlim=(-0.27, 0.27), ylim=(-0.69, 0.27))
            ax.axis("off")
        for ax, entry in zip(axes.flat, OF_OTHERS, strict=False):
            draw(ax, entry.vehicle)
        axes[0, 0].plot([-0.25, -0.15], [-0.66, -0.66], color=INK, lw=1.5)
        axes[0, 0].text(-0.2, -0.65, "0.1 m", ha="center", va="bottom", fontsize=7)
        fig.savefig(HERE / "vehicles.png", dpi=120)


def draw(ax: Axes, vehicle: Vehicle) -> None:
    """A vehicle from above and from the side.

    Arms that yield are thick, from their hinges on; a shell that turns by itself is dashed.
    """
    arms = arm_shapes(vehicle.airframe(), vehicle)
    lengths = np.array([arm.length for arm in arms])
    still = np.zeros((len(arms), 3))
    now = SceneInstant(np.zeros(3), np.eye(3), lengths, lengths, still, still, ())
    tips = ends(arms, now)
    for view, lower in VIEWS:
        put: Any = {"transform": Affine2D().translate(0.0, -lower) + ax.transData}
        for j, (arm, tip) in enumerate(zip(arms, tips, strict=True)):
            width = 2.4 if vehicle.arms.at("compliant", j) else 0.8
            hinge = np.array(arm.joint[0].anchor) if arm.joint else np.zeros(3)
            ax.plot(*view(np.array([np.zeros(3), hinge])).T, color=INK, lw=0.8, **put)
            ax.plot(*view(np.array([hinge, tip])).T, color=INK, lw=width, **put)
            if arm.joint:
                ax.plot(*view(hinge[None]).T, ".", color=INK, ms=5, **put)
            look = {"color": TOUCHES, "lw": 1.4} if arm.caged else {"color": ROTOR, "lw": 0.7}
            ax.plot(*view(ring(tip, arm.cage_radius, np.eye(3))).T, **look, **put)
            outlines = outlines_of(arm.hulls, tip, now.rotation, view)
            ax.plot(*outlines.T, color=TOUCHES, lw=1.4, **put)
        for points in neighbour_lines(neighbour_shapes(vehicle.airframe()), arms, now):
            ax.plot(*view(points).T, color=INK, lw=0.6, **put)
        for latch in latches(arms, now):
            ax.plot(*view(latch.on_body[None]).T, "s", color=INK, ms=3, **put)
        for shape in hull_shapes(vehicle.airframe(), vehicle):
            line = "--" if vehicle.has_shell else "-"
            ax.plot(*hull_outline(shape, now, view).T, line, color=TOUCHES, lw=1.4, **put)
    ax.set_title(f"{vehicle.name}\n{1e3 * vehicle.mass:.0f} g", fontsize=9)


if __name__ == "__main__":
    main()

"""Picture of the imported warehouse; cartons, with a surface of their own, are orange.

python docs/figures/imported_world.py
"""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib as mpl
import numpy as np

mpl.use("Agg")
import matplotlib.pyplot as plt
import shapes

from springback import read_world
from springback.interfaces.figures.style import STYLE as STYLES
from springback.interfaces.replay.geometry import drawables

HERE = Path(__file__).parent
WORLD = HERE.parents[1] / "examples" / "warehouse.sdf"
WIDE, TALL = 800, 520
NAMED = (0.88, 0.62, 0.38)
#: Where a vehicle flies: what has no end is cut off around it [m].
FLOWN = np.array([[0.0, 0.05, 1.3], [4.6, 0.05, 1.3]])


def picture() -> shapes.Array:
    """Pixels of the world, shape (height, width, 3)."""
    world = read_world(WORLD, surfaces={"rack_*/shelf_*/carton_*": "mat"})
    named = {True: [], False: []}
    for part in world.parts:
        named["carton" in part.name].append(part.obstacle)
    none = np.zeros((0, 3))
    groups = [
        (drawables(named[False], (), FLOWN, none).drawables, shapes.SHAPE),
        (drawables(named[True], (), FLOWN, none).drawables, NAMED),
    ]
    corners = np.concatenate([
        shapes.triangles(one) for things, _ in groups for one in things if one.kind != "ground"
    ])  # fmt: skip
    flat = np.stack([corners @ shapes.RIGHT, corners @ shapes.UP], axis=-1).reshape(-1, 2)
    low, high = flat.min(axis=0), flat.max(axis=0)
    size = np.array([WIDE, TALL]) * shapes.FINER
    scale = float(((1.0 - 2.0 * shapes.MARGIN) * size / (high - low)).min())
    shift = 0.5 * size - 0.5 * scale * (low + high)
    canvas = np.ones((size[1], size[0], 3))
    depth = np.full(canvas.shape[:2], -np.inf)
    normals = np.zeros_like(canvas)
    for things, colour in groups:
        for thing in things:
            own = np.array(shapes.FLOOR if thing.kind == "ground" else colour)
            for one in shapes.triangles(thing):
                shapes.paint(one, own, scale, shift, (canvas, depth, normals))
    shapes.outlines(canvas, depth, normals)
    fine = canvas.reshape(TALL, shapes.FINER, WIDE, shapes.FINER, 3).mean(axis=(1, 3))
    return np.asarray(fine[::-1])


def main(folder: Path) -> None:
    """Draw it."""
    with plt.style.context(STYLES[-1]):
        figure = plt.figure(figsize=(8.0, 5.2), layout="none")
        ax = figure.add_axes((0.0, 0.0, 1.0, 1.0))
        ax.imshow(picture())
        ax.axis("off")
        figure.savefig(folder / "imported_world.png", dpi=100)
        plt.close(figure)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else HERE)

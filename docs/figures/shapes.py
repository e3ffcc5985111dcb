"""Picture of the built-in shapes, from the examples of docs/howto/obstacle.md.

python docs/figures/shapes.py
"""

from __future__ import annotations

import re
import sys
import tomllib
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np

mpl.use("Agg")
import matplotlib.pyplot as plt

from springback.interfaces.figures.style import STYLE as STYLES
from springback.interfaces.replay.geometry import Drawable, drawables
from springback.scenario.scenario import expand_presets
from springback.scenario.tables import WorldSettings

HERE = Path(__file__).parent
PAGE = HERE.parent / "howto" / "obstacle.md"
WIDE, TALL, FINER, MARGIN = 250, 205, 2, 0.06
SHAPE, FLOOR, LINE = (0.62, 0.68, 0.76), (0.93, 0.935, 0.94), 0.45
LIGHT = np.array([-0.45, -0.55, 0.85])
#: Directions to the right, up and towards who looks, world.
AWAY = np.array([-0.62, -0.66, 0.42]) / np.linalg.norm([-0.62, -0.66, 0.42])
RIGHT = np.cross([0.0, 0.0, 1.0], AWAY) / np.linalg.norm(np.cross([0.0, 0.0, 1.0], AWAY))
UP = np.cross(AWAY, RIGHT)
#: Where a vehicle would be, around which what has no end is cut off [m].
FLOWN = np.array([[2.6, 0.0, 1.0], [3.4, 0.0, 1.2]])

Array = np.ndarray[Any, np.dtype[np.float64]]


def examples() -> dict[str, Any]:
    """The worlds of the page, one obstacle each, by type."""
    [text] = re.findall(r"```toml\n(\[world\].*?)```", PAGE.read_text(encoding="utf-8"), re.S)
    made = {}
    for one in tomllib.loads(text)["world"]["obstacles"]:
        world = {"obstacles": [one, {"type": "ground", "surface": "wall"}]}
        table = expand_presets({"vehicle": "arq", "world": world})["world"]
        made[one["type"]] = WorldSettings.model_validate(table).obstacles
    return made


def triangles(thing: Drawable) -> Array:
    """Corners of the triangles of a mesh or rectangle, shape (triangles, 3, 3)."""
    if thing.vertices is not None and thing.triangles is not None:
        return thing.vertices[thing.triangles]
    c, u, v = (np.array(part) for part in (thing.centre, thing.across, thing.along))
    a, b, d, e = c - u - v, c + u - v, c + u + v, c - u + v
    return np.array([[a, b, d], [a, d, e]])


def picture(obstacles: Any) -> Array:
    """Pixels of an obstacle on a floor, shape (height, width, 3)."""
    things = drawables(obstacles, (), FLOWN, np.zeros((0, 3))).drawables
    grounds = [one for one in things if one.kind == "ground"]
    bodies = [one for one in things if one.kind != "ground"]
    corners = np.concatenate([triangles(one) for one in bodies])
    flat = np.stack([corners @ RIGHT, corners @ UP], axis=-1).reshape(-1, 2)
    low, high = flat.min(axis=0), flat.max(axis=0)
    size = np.array([WIDE, TALL]) * FINER
    scale = float(((1.0 - 2.0 * MARGIN) * size / (high - low)).min())
    shift = 0.5 * size - 0.5 * scale * (low + high)
    canvas = np.ones((size[1], size[0], 3))
    depth = np.full(canvas.shape[:2], -np.inf)
    normals = np.zeros_like(canvas)
    for group, colour in ((grounds, FLOOR), (bodies, SHAPE)):
        for thing in group:
            for one in triangles(thing):
                paint(one, np.array(colour), scale, shift, (canvas, depth, normals))
    outlines(canvas, depth, normals)
    smooth = canvas.reshape(TALL, FINER, WIDE, FINER, 3).mean(axis=(1, 3))
    return np.asarray(smooth[::-1])


def paint(one: Array, colour: Array, scale: float, shift: Array, onto: Any) -> None:
    """Draw a triangle where nothing is nearer."""
    canvas, depth, normals = onto
    normal = np.cross(one[1] - one[0], one[2] - one[0])
    size = float(np.linalg.norm(normal))
    if size == 0.0:
        return
    normal = normal / size
    p = scale * np.stack([one @ RIGHT, one @ UP], axis=1) + shift
    first = np.maximum(np.floor(p.min(axis=0)).astype(int), 0)
    last = np.minimum(np.ceil(p.max(axis=0)).astype(int), [canvas.shape[1], canvas.shape[0]])
    area = (p[1, 0] - p[0, 0]) * (p[2, 1] - p[0, 1]) - (p[1, 1] - p[0, 1]) * (p[2, 0] - p[0, 0])
    if abs(area) < 1e-9 or (last <= first).any():
        return
    x, y = np.meshgrid(*(np.arange(a, b) + 0.5 for a, b in zip(first, last, strict=True)))
    v = ((x - p[0, 0]) * (p[2, 1] - p[0, 1]) - (y - p[0, 1]) * (p[2, 0] - p[0, 0])) / area
    w = ((p[1, 0] - p[0, 0]) * (y - p[0, 1]) - (p[1, 1] - p[0, 1]) * (x - p[0, 0])) / area
    near = one @ AWAY
    height = near[0] + v * (near[1] - near[0]) + w * (near[2] - near[0])
    place = np.s_[first[1] : last[1], first[0] : last[0]]
    seen = (v >= 0.0) & (w >= 0.0) & (v + w <= 1.0) & (height > depth[place])
    shade = 0.62 + 0.38 * max(float(normal @ LIGHT) / float(np.linalg.norm(LIGHT)), 0.0)
    canvas[place][seen] = shade * colour
    depth[place][seen] = height[seen]
    normals[place][seen] = normal


def outlines(canvas: Array, depth: Array, normals: Array) -> None:
    """Draw lines where faces meet at an angle, or one begins in front of another."""
    for axis in (0, 1):
        before, after = (np.s_[:-1], np.s_[1:]) if axis == 0 else (np.s_[:, :-1], np.s_[:, 1:])
        with np.errstate(invalid="ignore"):
            jump = ~(np.abs(depth[after] - depth[before]) < 0.06)
        bend = (normals[before] * normals[after]).sum(axis=-1) < 0.85
        both = np.isfinite(depth[after]) | np.isfinite(depth[before])
        canvas[before][(jump | bend) & both] *= LINE


def main(folder: Path) -> None:
    """Draw all."""
    with plt.style.context(STYLES[-1]):
        shown = examples()
        figure, axes = plt.subplots(-(-len(shown) // 5), 5, figsize=(9.0, 5.2), layout="none")
        for ax in axes.flat:
            ax.axis("off")
        for ax, (name, obstacles) in zip(axes.flat, shown.items(), strict=False):
            ax.imshow(picture(obstacles))
            ax.set_title(name, fontsize=10)
        figure.subplots_adjust(0.005, 0.005, 0.995, 0.95, wspace=0.03, hspace=0.14)
        figure.savefig(folder / "shapes.png", dpi=150)
        plt.close(figure)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else HERE)

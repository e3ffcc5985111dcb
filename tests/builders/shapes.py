"""One of every built-in shape."""

from __future__ import annotations

from typing import Any

from springback.contact.library import WALL
from springback.contact.openings import Doorway, Window
from springback.contact.shapes import (
    Ball,
    Box,
    Capsule,
    Cone,
    Edge,
    Hoop,
    Pole,
    ShapeSettings,
    Slope,
    Stairs,
)

TURNED = {"roll": 0.4, "pitch": -0.3, "yaw": 1.1}


def shapes() -> dict[str, ShapeSettings]:
    """One of every built-in shape."""
    s: dict[str, Any] = {"surface": WALL}
    here = (0.3, -0.2, 1.1)
    return {
        "box": Box(type="box", position=here, size=(0.4, 0.3, 0.2), edge_radius=0.02, **TURNED, **s),
        "edge": Edge(type="edge", position=here, length=0.5, width=0.3, edge_radius=0.01, **TURNED, **s),
        "sphere": Ball(type="sphere", position=here, radius=0.2, **s),
        "pole": Pole(type="pole", position=here, radius=0.1, height=0.5, axis=(1, 2, 3), **s),
        "endless": Pole(type="pole", position=here, radius=0.1, axis=(0, 1, 2), **s),
        "capsule": Capsule(type="capsule", start=here, end=(0.6, 0.1, 1.0), radius=0.05, **s),
        "cone": Cone(type="cone", position=here, height=0.4, radius=0.2, edge_radius=0.01, **s),
        "trunk": Cone(type="cone", position=here, height=0.5, radius=0.2, top_radius=0.1,
                      axis=(1, 0, 1), **s),
        "hoop": Hoop(type="hoop", position=here, radius=0.3, tube_radius=0.05, axis=(1, 1, 0), **s),
        "window": Window(type="window", position=here, size=(1.0, 0.8), opening=(0.4, 0.3),
                         opening_height=0.1, thickness=0.1, edge_radius=0.02, **TURNED, **s),
        "round": Window(type="window", position=here, size=(1.0, 0.8), opening_radius=0.25,
                        thickness=0.1, **s),
        "doorway": Doorway(type="doorway", position=here, size=(1.0, 0.8), opening=(0.3, 0.5), **s),
        "slope": Slope(type="slope", position=here, angle=0.5, uphill=0.7, **s),
        "stairs": Stairs(type="stairs", position=here, steps=3, yaw=0.5, width=0.4, **s),
    }  # fmt: skip


SHAPES = shapes()

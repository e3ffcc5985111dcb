"""Every built-in shape, ahead of a robot that flies along x at a height of 1 m."""

from __future__ import annotations

from typing import Any

HERE = [2.7, 0.02, 1.0]
SHAPES: dict[str, dict[str, Any]] = {
    "box": {"position": [3.25, 0.0, 1.0], "size": [1.0, 1.0, 1.0]},
    "edge": {"position": HERE},
    "sphere": {"position": [3.0, 0.02, 1.0], "radius": 0.3},
    "pole": {"position": HERE, "radius": 0.15},
    "capsule": {"start": [2.6, -1.0, 0.8], "end": [2.6, 1.0, 1.3], "radius": 0.02},
    "cone": {"position": [2.8, 0.0, 0.5], "height": 1.0, "radius": 0.4},
    "hoop": {"position": [2.6, 0.0, 1.0], "radius": 0.17, "tube_radius": 0.03},
    "window": {"position": [2.6, 0.0, 1.0], "opening": [0.3, 0.5]},
    "doorway": {"position": [2.6, 0.0, 0.0], "opening": [0.3, 2.0], "size": [4.0, 3.0]},
    "slope": {"position": [2.5, 0.0, 0.5], "angle": "60 deg"},
    "stairs": {"position": [2.3, 0.0, 0.2]},
    "forest": {"position": [2.3, 0.0, 0.0], "density": 4.0, "spacing": 0.1},
}

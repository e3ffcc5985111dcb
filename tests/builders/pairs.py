"""Scenarios of two vehicles that meet head-on or at a glance, without gravity and without pilots."""

from __future__ import annotations

from typing import Any

import numpy as np


def vehicle(x: float, speed: float, **more: Any) -> dict[str, Any]:
    """Tables of one vehicle on the X axis: ``y``, ``z``, ``yaw``, ``pitch``, and other tables."""
    place = [x, more.pop("y", 0.0), more.pop("z", 0.0)]
    angles = {name: more.pop(name, 0.0) for name in ("yaw", "pitch")}
    start = {"position": place, "velocity": [speed, 0.0, 0.0], **angles}
    return {"vehicle": "arq", "start": start, **more}


def two(second: dict[str, Any] | None = None, **more: Any) -> dict[str, Any]:
    """Tables of a scenario with two vehicles; by default they glance off each other."""
    comes = vehicle(0.6, -1.0, yaw=2.6, y=0.22) if second is None else second
    world = {"gravity": 0.0, "obstacles": []}
    shared = {"world": world, "simulation": {"duration": 0.08}}
    return {**vehicle(0.0, 1.5), **shared, "second": comes, **more}


def turn(attitude: Any) -> Any:
    """Rotation matrix of a quaternion wxyz, by the formula of Rodrigues."""
    w, *v = attitude
    x, y, z = v
    across = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + 2.0 * w * across + 2.0 * across @ across

"""Obstacles of the impact lab besides its wall and mat: built-in shapes in front of the robot."""

from __future__ import annotations

from typing import Any

from springback.interfaces.lab.settings import LabSettings, digits

Table = dict[str, Any]

#: Length of the edge and width of its faces; width of the frame of a window and its thickness [m]
#: (chosen: so small that two robots can be shown side by side).
EDGE_LENGTH, EDGE_WIDTH, FRAME, THICKNESS = 2.0, 0.5, 0.25, 0.1
#: Width and height of a net [m] (chosen).
NET = (2.0, 1.0)


def obstacle_of(settings: LabSettings) -> str:
    """Word of what is hit: ``wall`` for a wall or mat, and for whatever is in the user's file."""
    return "wall" if settings.mode == "file" else settings.obstacle


def is_on_slider(settings: LabSettings) -> bool:
    """True for an impact on the paper's slider, which only a wall ends."""
    impact = settings.mode == "impact" and settings.guide == "slider"
    return impact and obstacle_of(settings) == "wall"


def shape_table(s: LabSettings, face: float, height: float, surface: Any, turned: float) -> Table:
    """A shape whose foremost point is at a distance, as a raw obstacle.

    Args:
        s: Settings, with a shape for an obstacle.
        face: Distance of its foremost point along the X axis [m].
        height: Of its middle [m].
        surface: Raw surface.
        turned: Angle by which it is turned about the vertical, beside its own [deg].
    """
    aside, radius = 1e-3 * s.offset, 1e-3 * s.radius
    made: Table = {"type": s.obstacle, "surface": surface}
    yaw = f"{digits(s.turn + turned)} deg"
    if s.obstacle == "slope":
        angle, uphill = f"{digits(s.incline)} deg", f"{digits(turned)} deg"
        return made | {"position": [face, 0.0, height], "angle": angle, "uphill": uphill}
    if s.obstacle == "net":
        where = {"position": [face, aside, height], "size": list(NET), "yaw": yaw}
        return {"type": "net", **where, "tension": s.tension}
    if s.obstacle == "edge":
        sizes = {"length": EDGE_LENGTH, "width": EDGE_WIDTH}
        return made | {"position": [face, aside, height], **sizes, "yaw": yaw}
    if s.obstacle == "window":
        opening = 1e-3 * s.opening
        return made | {
            "position": [face + 0.5 * THICKNESS, aside, height], "thickness": THICKNESS,
            "size": [opening + 2.0 * FRAME] * 2, "opening": [opening] * 2, "yaw": yaw,
        }  # fmt: skip
    foot = 0.0 if s.obstacle == "pole" else height
    return made | {"position": [face + radius, aside, foot], "radius": radius}

"""Obstacles of the impact lab besides its wall and mat: built-in shapes in front of the robot."""

from __future__ import annotations

import math
from typing import Any

from springback.interfaces.lab.settings import LabSettings, digits

Table = dict[str, Any]

#: Length of the edge and width of its faces; width of the frame of a window and its thickness [m]
#: (chosen: so small that two robots can be shown side by side).
EDGE_LENGTH, EDGE_WIDTH, FRAME, THICKNESS = 2.0, 0.5, 0.25, 0.1
#: Obstacles that move.
MOVING = ("ball", "door")
#: Length of the rod of the ball [m]; width, height and thickness of the door [m], its closer
#: [N m/rad] and its damping [N m s/rad] (chosen: a light door of a room).
ROD = 1.5
DOOR, CLOSER, DOOR_DAMPING = (0.9, 2.0, 0.04), 5.0, 2.0
#: Steps with which a swing is followed back.
SWING_STEPS = 200


#: Shapes of obstacles that have another name here, and words for what is hit where it is no shape.
SHAPES = {"ball": "sphere", "door": "box"}
WORDS = {"robot": "other robot"}
#: What is hit, with its article.
WITH_ARTICLE = {
    "wall": "a wall", "pole": "a pole", "edge": "an edge", "sphere": "a sphere",
    "window": "a window", "slope": "a slope", "net": "a net", "ball": "a swinging ball",
    "door": "a door", "robot": "another robot",
}  # fmt: skip
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
    made: Table = {"type": SHAPES.get(s.obstacle, s.obstacle), "surface": surface}
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
    if s.obstacle == "door":
        return made | _door(s, face, turned)
    foot = 0.0 if s.obstacle == "pole" else height
    return made | {"position": [face + radius, aside, foot], "radius": radius}


def _door(s: LabSettings, face: float, turned: float) -> Table:
    """A door that opens away from the robot, hinged on its left."""
    width, high, thick = DOOR
    yaw = math.radians(turned)
    middle = [face + 0.5 * thick, 1e-3 * s.offset]
    pivot = [middle[0] - 0.5 * width * math.sin(yaw), middle[1] + 0.5 * width * math.cos(yaw)]
    return {
        "position": [*middle, 0.5 * high], "size": [thick, width, high],
        "yaw": f"{digits(turned)} deg",
        "motion": {
            "type": "hinge", "mass": s.door_mass, "pivot": [*pivot, 0.5 * high], "closer": CLOSER,
            "damping": DOOR_DAMPING, "lowest": 0.0, "highest": "100 deg",
        },
    }  # fmt: skip


def swinging(ball: Table, s: LabSettings, gravity: float, before: float, beyond: float) -> Table:
    """A ball on a rod that arrives with the speed of the settings, as a raw obstacle.

    Its swing is followed back from there: θ̈ = −(g/L) sin θ / (1 + 2/5 (r/L)²), without damping.

    Args:
        ball: Where it arrives, as a sphere at rest.
        s: Settings.
        gravity: g [m/s²].
        before: Time at which it starts, before it arrives [s].
        beyond: Distance along X at which it would hang at rest, behind where it arrives [m].
    """
    x, y, z = ball["position"]
    pivot = [x + beyond, y, z + math.sqrt(ROD**2 - beyond**2)]
    pull = gravity / ROD / (1.0 + 0.4 * (ball["radius"] / ROD) ** 2)
    step = -before / SWING_STEPS
    angle, rate = -math.asin(beyond / ROD), -s.speed / ROD

    def change(angle: float, rate: float) -> tuple[float, float]:
        return rate, -pull * math.sin(angle)

    for _ in range(SWING_STEPS):  # the midpoint rule
        turning, pulling = change(angle, rate)
        turning, pulling = change(angle + 0.5 * step * turning, rate + 0.5 * step * pulling)
        angle, rate = angle + step * turning, rate + step * pulling
    start = [pivot[0] + ROD * math.sin(angle), y, pivot[2] - ROD * math.cos(angle)]
    motion = {
        "type": "pendulum", "mass": s.ball_mass, "pivot": pivot,
        "angular_velocity": [0.0, -rate, 0.0],
    }  # fmt: skip
    return ball | {"position": start, "motion": motion}

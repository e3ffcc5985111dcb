"""Labels and looks of the robots, the same on every page and in every figure.

Colours are those of Okabe and Ito, which colour-blind readers can distinguish; robots also differ
in line and marker, so that they can be told apart in black and white.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from itertools import cycle
from typing import Any, NamedTuple

INK, BLUE, ORANGE, GREEN = "#222222", "#0072B2", "#E69F00", "#009E73"
PINK, SKY, RED, GREY = "#CC79A7", "#56B4E9", "#D55E00", "#8C8C8C"
SHADE = "#E4E8EE"
"""Colour of areas behind curves."""
Dashes = str | tuple[float, tuple[float, ...]]
"""Line style: its symbol, or offset and lengths of dashes and gaps [points]."""


class RobotStyle(NamedTuple):
    """Label and look of a robot."""

    label: str
    colour: str
    line: Dashes
    marker: str

    @property
    def curve(self) -> dict[str, Any]:
        """Keywords for a curve in matplotlib."""
        return {"color": self.colour, "ls": self.line}


ROBOTS = {
    "arq": RobotStyle("ARQ", BLUE, "-", "o"),
    "quad": RobotStyle("Quad", RED, (0, (5, 1.5)), "s"),
}
"""Styles by the name of the preset."""
_OTHERS = (
    RobotStyle("", GREEN, (0, (5, 1.5, 1, 1.5)), "^"),
    RobotStyle("", PINK, (0, (1.2, 1)), "v"),
)


def robot_label(name: str) -> str:
    """Label of a preset, on the slider or not; any other name unchanged."""
    robot, slider, _ = name.partition("-slider")
    known = ROBOTS.get(robot)
    return name if known is None else f"{known.label} on slider" if slider else known.label


def robot_styles(names: Iterable[str]) -> dict[str, RobotStyle]:
    """Styles of robots; those without one of their own get the others in turn."""
    free = cycle(_OTHERS)
    return {name: ROBOTS.get(name) or next(free)._replace(label=name) for name in names}


def with_labels(text: str) -> str:
    """Text with names of presets replaced by their labels."""
    return re.sub(rf"\b({'|'.join(ROBOTS)})\b", lambda name: ROBOTS[name[0]].label, text)

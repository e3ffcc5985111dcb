"""Walls with an opening: user input, converted to solids."""

from __future__ import annotations

from abc import abstractmethod
from typing import Literal

import numpy as np
from pydantic import model_validator

from springback.contact.scene.solids import ROUND_WINDOW, WINDOW
from springback.contact.shapes import (
    EDGE,
    Array,
    AttitudeShape,
    NotNegative,
    Place,
    SolidShape,
    Widths,
)
from springback.quantities import Length, Position
from springback.settings import problem

#: Depth to which the opening of a doorway goes on below its lintel [m] (chosen: keeps 1e-13 m).
BELOW = 1e3


class WallOpening(AttitudeShape):
    """An upright wall with an opening; it faces along its own x."""

    size: Widths = (4.0, 3.0)
    thickness: Length = 0.1
    edge_radius: NotNegative = EDGE

    def _panel_axes(self) -> Array:
        """Axes of the solid: to the left, upwards, and through the wall."""
        x, y, z = self.axes()
        return np.array([y, z, x])

    @abstractmethod
    def frame(self) -> float:
        """Width of the wall beside the opening, where it is narrowest [m]."""

    def thinnest(self) -> float:
        """Thickness of the wall, or width of its frame [m]."""
        return min(self.frame(), self.thickness)

    def _halves(self) -> tuple[float, float, float]:
        """Half width, height and thickness before the edges are rounded."""
        edge, (width, height) = self.edge_radius, self.size
        return 0.5 * width - edge, 0.5 * height - edge, 0.5 * self.thickness - edge


class Window(WallOpening):
    """A wall with a window, rectangular or round."""

    type: Literal["window"]
    position: Place
    """Centre of the wall, halfway through it."""
    opening: Widths | None = None
    """Width and height of a rectangular window."""
    opening_height: Position = 0.0
    """Height of the centre of a rectangular window above that of the wall."""
    opening_radius: Length | None = None
    """Radius of a round window, in the middle of the wall."""

    @model_validator(mode="after")
    def _one_opening(self) -> Window:
        if (self.opening is None) == (self.opening_radius is None):
            raise problem("needs either opening, width and height, or opening_radius")
        width, height = self.size
        if self.opening is not None:
            w, h = self.opening
            room = 0.5 * (height - h) - abs(self.opening_height)
            if w >= width or room <= 0.0:
                raise problem(
                    f"must lie within the wall, {width:g} m x {height:g} m (got {w:g} m x {h:g} m, "
                    f"{self.opening_height:g} m above its centre)",
                    "opening",
                )
        elif 2.0 * (self.opening_radius or 0.0) >= min(width, height):
            raise problem(
                f"must be less than {0.5 * min(width, height):g} m, half of the wall (got "
                f"{self.opening_radius:g} m)",
                "opening_radius",
            )
        return self

    def frame(self) -> float:
        """Width of the wall beside the opening, where it is narrowest [m]."""
        width, height = self.size
        if self.opening is None:
            return 0.5 * min(width, height) - (self.opening_radius or 0.0)
        w, h = self.opening
        return min(0.5 * (width - w), 0.5 * (height - h) - abs(self.opening_height))

    def bodies(self) -> list[SolidShape]:
        """Its solids."""
        edge, halves = self.edge_radius, self._halves()
        centre, axes = np.array(self.position), self._panel_axes()
        if self.opening is not None:
            w, h = self.opening
            hole = (0.5 * w + edge, 0.5 * h + edge, self.opening_height)
            return [SolidShape(WINDOW, centre, axes, (*halves, *hole), edge)]
        radius = (self.opening_radius or 0.0) + edge
        return [SolidShape(ROUND_WINDOW, centre, axes, (*halves, radius), edge)]


class Doorway(WallOpening):
    """A wall with an open door."""

    type: Literal["doorway"]
    position: Place
    """Middle of the threshold: on the floor, halfway through the wall."""
    opening: Widths = (0.9, 2.0)
    """Width and height."""

    @model_validator(mode="after")
    def _is_within(self) -> Doorway:
        (width, height), (w, h) = self.size, self.opening
        if w >= width or h >= height:
            raise problem(
                f"must be smaller than the wall, {width:g} m x {height:g} m "
                f"(got {w:g} m x {h:g} m)",
                "opening",
            )
        return self

    def frame(self) -> float:
        """Width of the wall beside the opening, where it is narrowest [m]."""
        (w, h), (width, height) = self.opening, self.size
        return min(0.5 * (width - w), height - h)

    def bodies(self) -> list[SolidShape]:
        """Its solids."""
        axes, (w, h), height = self._panel_axes(), self.opening, self.size[1]
        halves, edge = self._halves(), self.edge_radius
        centre = np.array(self.position) + 0.5 * height * axes[1]
        # The opening goes on below the floor, so far that its own end is never the nearest.
        top = -0.5 * height + h + edge
        hole = (0.5 * w + edge, 0.5 * BELOW, top - 0.5 * BELOW)
        return [SolidShape(WINDOW, centre, axes, (*halves, *hole), edge)]

"""Unions: several shapes as one obstacle, with a pose of the whole."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field, model_validator

from springback.contact.forest import Forest
from springback.contact.grids.measured_shapes import HeightMap, MeshBody, OccupancyGrid
from springback.contact.nets import Net
from springback.contact.openings import Doorway, Window
from springback.contact.parameters import SurfaceSettings
from springback.contact.shapes import (
    AttitudeSettings,
    Ball,
    Box,
    Capsule,
    Cone,
    Edge,
    Hoop,
    Place,
    Pole,
    ShapeSettings,
    Slope,
    SolidPart,
    SolidShape,
    Stairs,
)
from springback.errors import shown_value
from springback.settings import problem

#: Most shapes of a union (chosen: as of a world).
MOST_SHAPES = 10_000
#: Shapes that a file can name, alone or in a union.
SingleShape = (
    Box | Edge | Ball | Pole | Capsule | Cone | Hoop | Window | Doorway | Slope | Stairs | Forest
    | HeightMap | MeshBody | OccupancyGrid | Net
)  # fmt: skip


class ShapeUnion(AttitudeSettings, ShapeSettings):
    """Several shapes as one obstacle; contact is with the nearest of them."""

    type: Literal["union"]
    position: Place = (0.0, 0.0, 0.0)
    """Position of the whole: positions and angles of its shapes are in its own axes."""
    surface: SurfaceSettings | None = None
    """Surface of the shapes that have none of their own."""
    shapes: tuple[Annotated[SingleShape, Field(discriminator="type")], ...]
    """Its parts, placed within it."""

    @model_validator(mode="before")
    @classmethod
    def _with_surfaces(cls, given: Any) -> Any:
        """Give the union's surface to the shapes without one."""
        if not isinstance(given, Mapping) or given.get("surface") is None:
            return given
        entries = given.get("shapes")
        if not isinstance(entries, list | tuple):
            return given
        return {**given, "shapes": [_with_surface(one, given["surface"]) for one in entries]}

    @model_validator(mode="after")
    def _has_shapes(self) -> ShapeUnion:
        if not 0 < len(self.shapes) <= MOST_SHAPES:
            raise problem(f"must be 1 to {MOST_SHAPES} (got {len(self.shapes)})", "shapes")
        for k, shape in enumerate(self.shapes):
            if shape.motion is not None:
                raise problem(
                    "cannot be given: the shapes of a union move together; give it to the union, "
                    "or make the shape an obstacle of its own",
                    f"shapes[{k}].motion",
                )
            if shape.name:
                raise problem(
                    "cannot be given: contacts are with the union as a whole; give it to the "
                    "union, or make the shape an obstacle of its own (got "
                    f"{shown_value(shape.name)})",
                    f"shapes[{k}].name",
                )
        return self

    def law(self) -> SurfaceSettings:
        """Surface of the first of its shapes."""
        return self.shapes[0].law()

    def middle_depth(self) -> float:
        """The least of its shapes [m]."""
        return min(shape.middle_depth() for shape in self.shapes)

    def bodies(self) -> list[SolidShape]:
        """Its solids."""
        return [part.body for part in self.parts()]

    def parts(self) -> list[SolidPart]:
        """Its solids, each with its surface, in world axes."""
        axes, place = self.axes(), np.array(self.position)
        return [
            SolidPart(body._replace(centre=place + body.centre @ axes, axes=body.axes @ axes), law)
            for shape in self.shapes
            for body, law in shape.parts()
        ]


def _with_surface(shape: Any, surface: Any) -> Any:
    takes = isinstance(shape, Mapping) and "surface" not in shape and shape.get("type") != "net"
    return {**shape, "surface": surface} if takes else shape

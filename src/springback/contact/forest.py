"""Forests: trunks at random places, by density."""

from __future__ import annotations

import math
from typing import Annotated, Literal

import numpy as np
from pydantic import Field, model_validator

from springback.contact.scene.solids import CAPSULE
from springback.contact.scene.table import ENDLESS
from springback.contact.shapes import NotNegative, Place, SolidShape, SurfacedShape, Widths
from springback.quantities import Length, Unit
from springback.random_streams import Purpose, stream
from springback.settings import problem

#: Most trunks (chosen).
MOST_TRUNKS = 20_000
#: Trials to place a trunk that keeps its distance from the others (chosen: as usual).
TRIALS = 30


class Forest(SurfacedShape):
    """Upright trunks without end, at random places that keep a distance from each other."""

    type: Literal["forest"]
    position: Place = (0.0, 0.0, 0.0)
    """Middle of the nearer side of the area."""
    size: Widths = (20.0, 20.0)
    """Depth along X and width along Y."""
    density: Annotated[float, Unit("1/m^2", least=0.0)]
    """Trunks per area; where no more fit, fewer."""
    radius: Length = 0.1
    """Mean radius of a trunk."""
    radius_spread: Annotated[float, Unit("", least=0.0, most=0.9)] = 0.0
    """Radii are even between 1 − this and 1 + this times the mean."""
    spacing: NotNegative = 0.5
    """Least distance between the bark of two trunks."""
    seed: Annotated[int, Field(ge=0)] = 0

    @model_validator(mode="after")
    def _countable(self) -> Forest:
        count = self.density * self.size[0] * self.size[1]
        if count > MOST_TRUNKS:
            raise problem(
                f"must be at most {MOST_TRUNKS / (self.size[0] * self.size[1]):g} 1/m^2 for this "
                f"area (got {self.density:g} 1/m^2, {count:.0f} trunks)",
                "density",
            )
        return self

    def bodies(self) -> list[SolidShape]:
        """Its solids."""
        random = stream(self.seed, Purpose.FOREST)
        depth, width = self.size
        count = round(self.density * depth * width)
        trunks = _spread_out(random, count, (depth, width), self)
        found = []
        for x, y, radius in trunks:
            foot = np.array(self.position) + np.array([x, y - 0.5 * width, 0.0])
            found.append(SolidShape(CAPSULE, foot, np.eye(3), (ENDLESS, radius), 0.0))
        return found


def _spread_out(
    random: np.random.Generator, count: int, area: tuple[float, float], forest: Forest
) -> list[tuple[float, float, float]]:
    """Places and radii by dart throwing: a trial too close to an earlier trunk is dropped."""
    low, high = 1.0 - forest.radius_spread, 1.0 + forest.radius_spread
    cell = 2.0 * forest.radius * high + forest.spacing
    cells: dict[tuple[int, int], list[tuple[float, float, float]]] = {}
    found: list[tuple[float, float, float]] = []
    for _ in range(count * TRIALS):
        if len(found) == count:
            break
        x, y = float(random.uniform(0.0, area[0])), float(random.uniform(0.0, area[1]))
        radius = forest.radius * float(random.uniform(low, high))
        i, j = int(x // cell), int(y // cell)
        near = (
            one for a in (-1, 0, 1) for b in (-1, 0, 1) for one in cells.get((i + a, j + b), ())
        )
        if all(math.hypot(x - u, y - v) >= radius + r + forest.spacing for u, v, r in near):
            found.append((x, y, radius))
            cells.setdefault((i, j), []).append((x, y, radius))
    return found

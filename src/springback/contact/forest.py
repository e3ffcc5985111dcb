"""Forests: trunks at random places, by density."""

from __future__ import annotations

import math
from functools import lru_cache
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
#: Share of an area that discs dropped at random cover when no more fit (Feder, J. Theor. Biol. 87,
#: 1980: 0.547).
JAMMED = 0.547
#: Trials to place a trunk that keeps its distance from the others (chosen: as usual).
TRIALS = 30


class Forest(SurfacedShape):
    """Upright trunks of infinite height, at random places that keep a distance from each other."""

    type: Literal["forest"]
    position: Place = (0.0, 0.0, 0.0)
    """Middle of the nearer side of the area."""
    size: Widths = (20.0, 20.0)
    """Depth along X and width along Y."""
    density: Annotated[float, Unit("1/m^2", least=0.0)]
    """Trunks per area; a density that does not fit with the spacing is refused."""
    radius: Length = 0.1
    """Mean radius of a trunk."""
    radius_spread: Annotated[float, Unit("", least=0.0, most=0.9)] = 0.0
    """Radii are spread evenly between 1 − this and 1 + this times the mean."""
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
        wide = 2.0 * self.radius + self.spacing
        around = (self.size[0] + wide) * (self.size[1] + wide) / self.area
        jammed = around * JAMMED / (0.25 * math.pi * wide * wide)
        is_hopeless = self.density > 2.0 * jammed  # planting it would take long
        fits = jammed if is_hopeless else len(self.trunks()) / self.area
        if round(fits * self.area) < round(count):
            raise problem(
                f"must be less: only some {fits:.3g} 1/m^2 fit where trunks of radius "
                f"{self.radius:g} m keep the spacing of {self.spacing:g} m (got "
                f"{self.density:g} 1/m^2)",
                "density",
            )
        return self

    @property
    def area(self) -> float:
        """Of its ground [m²]."""
        return self.size[0] * self.size[1]

    def trunks(self) -> tuple[tuple[float, float, float], ...]:
        """Place of each trunk from the middle of the nearer side, x and y, and its radius [m]."""
        count = round(self.density * self.area)
        return _spread_out(
            self.seed, count, self.size, self.radius, self.radius_spread, self.spacing
        )

    def bodies(self) -> list[SolidShape]:
        """Its solids."""
        found = []
        for x, y, radius in self.trunks():
            foot = np.array(self.position) + np.array([x, y, 0.0])
            found.append(SolidShape(CAPSULE, foot, np.eye(3), (ENDLESS, radius), 0.0))
        return found


@lru_cache(maxsize=16)
def _spread_out(
    seed: int, count: int, area: tuple[float, float], mean: float, spread: float, spacing: float
) -> tuple[tuple[float, float, float], ...]:
    """Places and radii by dart throwing: a trial too close to an earlier trunk is dropped."""
    random = stream(seed, Purpose.FOREST)
    low, high = 1.0 - spread, 1.0 + spread
    cell = 2.0 * mean * high + spacing
    cells: dict[tuple[int, int], list[tuple[float, float, float]]] = {}
    found: list[tuple[float, float, float]] = []
    for _ in range(count * TRIALS):
        if len(found) == count:
            break
        x, y = float(random.uniform(0.0, area[0])), float(random.uniform(0.0, area[1]))
        radius = mean * float(random.uniform(low, high))
        i, j = int(x // cell), int(y // cell)
        near = (
            one for a in (-1, 0, 1) for b in (-1, 0, 1) for one in cells.get((i + a, j + b), ())
        )
        if all(math.hypot(x - u, y - v) >= radius + r + spacing for u, v, r in near):
            found.append((x, y, radius))
            cells.setdefault((i, j), []).append((x, y, radius))
    return tuple((x, y - 0.5 * area[1], radius) for x, y, radius in found)

"""How a number from 0 to 1 becomes a value of a field."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Protocol

from springback.experiments.campaign.sampling import normal_quantile


class Law(Protocol):
    """What a dimension of a plan does with its number."""

    @property
    def levels(self) -> int:
        """How many there are; 0 for a law without."""

    def at(self, u: float) -> Any:
        """The value that belongs to a number from [0, 1); of levels, which one."""


@dataclass(frozen=True)
class Levels:
    """Values, all alike likely."""

    values: tuple[Any, ...]

    @property
    def levels(self) -> int:
        """Number of values."""
        return len(self.values)

    def at(self, u: float) -> int:
        """Index of the value."""
        return min(int(u * len(self.values)), len(self.values) - 1)


@dataclass(frozen=True)
class Even:
    """Evenly between two values."""

    first: float
    last: float
    logarithmic: bool = False

    levels: int = 0

    def at(self, u: float) -> float:
        """Linear in u, or its logarithm is."""
        if self.logarithmic:
            return self.first * math.exp(u * math.log(self.last / self.first))
        return self.first + u * (self.last - self.first)


@dataclass(frozen=True)
class Bell:
    """Normally distributed about a value; about zero, what is added to it."""

    mean: float
    deviation: float

    levels: int = 0

    def at(self, u: float) -> float:
        """By the inverse of the distribution function."""
        return self.mean + self.deviation * normal_quantile(u)


@dataclass(frozen=True)
class BellFactor:
    """A factor whose logarithm is normally distributed about zero."""

    deviation: float

    levels: int = 0

    def at(self, u: float) -> float:
        """Median 1."""
        return math.exp(self.deviation * normal_quantile(u))

"""Distributions of fields: maps of numbers from 0 to 1 to values."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Protocol

from springback.campaign.design.sampling import Numbers, normal_quantiles


class Distribution(Protocol):
    """Distribution of a dimension of a plan."""

    @property
    def levels(self) -> int:
        """Number of levels; 0 if it is continuous."""

    def of(self, us: Numbers) -> list[Any]:
        """Values at numbers from [0, 1); for levels their indices.

        Each is computed separately, so that its bits do not depend on its neighbours.
        """


@dataclass(frozen=True)
class LevelSet:
    """Discrete values of equal probability."""

    values: tuple[Any, ...]

    @property
    def levels(self) -> int:
        """Number of values."""
        return len(self.values)

    def of(self, us: Numbers) -> list[Any]:
        """Indices of the values."""
        last = len(self.values) - 1
        return [min(int(u * (last + 1)), last) for u in us.tolist()]


@dataclass(frozen=True)
class PosteriorColumn:
    """Draws of one field of a posterior; all its fields are given the same numbers."""

    draws: tuple[float, ...]

    levels: int = 0

    def of(self, us: Numbers) -> list[Any]:
        """Values of the rows at numbers from [0, 1)."""
        last = len(self.draws) - 1
        return [self.draws[min(int(u * (last + 1)), last)] for u in us.tolist()]


@dataclass(frozen=True)
class UniformDistribution:
    """Uniform between two values, or in their logarithm."""

    first: float
    last: float
    logarithmic: bool = False

    levels: int = 0

    def at(self, u: float) -> float:
        """Value at u."""
        if self.logarithmic:
            return self.first * math.exp(u * math.log(self.last / self.first))
        return self.first + u * (self.last - self.first)

    def of(self, us: Numbers) -> list[Any]:
        """Values at numbers from [0, 1)."""
        return [self.at(u) for u in us.tolist()]


@dataclass(frozen=True)
class NormalDistribution:
    """Normal distribution; with mean zero if it is added to the scenario's own value."""

    mean: float
    deviation: float

    levels: int = 0

    def of(self, us: Numbers) -> list[Any]:
        """Values by the inverse of the cumulative distribution."""
        return [self.mean + self.deviation * z for z in normal_quantiles(us)]


@dataclass(frozen=True)
class NormalFactor:
    """Log-normal factor with median 1."""

    deviation: float

    levels: int = 0

    def of(self, us: Numbers) -> list[Any]:
        """Factors at numbers from [0, 1)."""
        return [math.exp(self.deviation * z) for z in normal_quantiles(us)]

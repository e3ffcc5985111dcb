"""Distributions: from a number in [0, 1) to a value of a field."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Protocol

from springback.campaign.design.sampling import Numbers, normal_quantiles


class Distribution(Protocol):
    """Distribution of a dimension of a plan."""

    @property
    def levels(self) -> int:
        """Number of levels; 0 for a distribution without."""

    def of(self, us: Numbers) -> list[Any]:
        """Values for numbers from [0, 1); for levels, their indices.

        Each is computed alone, so that it does not depend on the others.
        """


@dataclass(frozen=True)
class LevelSet:
    """Values of equal probability."""

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
class UniformDistribution:
    """Uniform between two values."""

    first: float
    last: float
    logarithmic: bool = False

    levels: int = 0

    def at(self, u: float) -> float:
        """Linear in u, or its logarithm is."""
        if self.logarithmic:
            return self.first * math.exp(u * math.log(self.last / self.first))
        return self.first + u * (self.last - self.first)

    def of(self, us: Numbers) -> list[Any]:
        """One by one."""
        return [self.at(u) for u in us.tolist()]


@dataclass(frozen=True)
class NormalDistribution:
    """Normally distributed about a value; about zero, what is added to it."""

    mean: float
    deviation: float

    levels: int = 0

    def of(self, us: Numbers) -> list[Any]:
        """By the inverse of the distribution function."""
        return [self.mean + self.deviation * z for z in normal_quantiles(us)]


@dataclass(frozen=True)
class NormalFactor:
    """A factor whose logarithm is normally distributed about zero."""

    deviation: float

    levels: int = 0

    def of(self, us: Numbers) -> list[Any]:
        """Median 1."""
        return [math.exp(self.deviation * z) for z in normal_quantiles(us)]

"""Distribution of a measure over the flights of a campaign."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from springback.campaign.access import Campaign
from springback.campaign.analysis.marginals import MeasureColumn, measure_column
from springback.campaign.analysis.statistics import ordered_values
from springback.errors import InputError
from springback.intervals import IntervalEstimate, Values, quantile
from springback.results.database import identifier

#: Shares of flights below the quantiles of a measure.
PARTS = (0.05, 0.5, 0.95)


@dataclass(frozen=True)
class MeasureDistribution:
    """A measure over all flights of each robot."""

    measure: MeasureColumn
    values: dict[str, Values]
    """Values of the flights that have it, by robot, ascending, in SI."""
    flown: dict[str, int]
    """Number of flights that were not refused, by robot."""

    def quantiles(self, robot: str) -> tuple[IntervalEstimate, ...]:
        """Quantiles at `PARTS`, with their intervals."""
        return tuple(quantile(self.values[robot], part) for part in PARTS)

    def without(self, robot: str) -> int:
        """Number of flights that do not have the measure."""
        return self.flown[robot] - len(self.values[robot])

    def as_dict(self) -> dict[str, Any]:
        """Plain data."""
        robots = {
            robot: {
                "flights": len(values), "without": self.without(robot),
                "least": float(values[0]) if len(values) else None,
                "most": float(values[-1]) if len(values) else None,
                **{
                    f"{part:g}": found._asdict()
                    for part, found in zip(PARTS, self.quantiles(robot), strict=True)
                },
            }
            for robot, values in self.values.items()
        }  # fmt: skip
        return {**self.measure._asdict(), "robots": robots}


def distribution(campaign: Campaign, name: str) -> MeasureDistribution:
    """Distribution of a measure.

    Args:
        campaign: Any.
        name: Name of its column.

    Raises:
        InputError: If there is no such measure, no flight has it, or a value is one that no flight
            has.
    """
    what, values, flown = measure_column(campaign, name), {}, {}
    for robot in campaign.robots:
        sql = f"""SELECT {identifier(what.name)}::DOUBLE AS value FROM flights
                  WHERE robot = ? AND outcome <> 'refused'"""
        found = campaign.arrays(sql, [robot])["value"]
        flown[robot] = len(found)
        known = ordered_values(campaign, {what.name: found})
        values[robot] = known.get(what.name, np.empty(0))
    if not any(len(found) for found in values.values()):
        raise InputError(f"{name}: no flight of this campaign has it")
    return MeasureDistribution(what, values, flown)

"""Flights of a campaign that are worth a look: failures, the hardest and kept ones."""

from __future__ import annotations

import shlex
from dataclasses import dataclass
from typing import Any

from springback.campaign.access import Campaign
from springback.campaign.analysis.thin_flights import in_doubt, thin_flights
from springback.results.database import identifier

#: Most flights that are listed, and most fields that describe each (chosen).
MOST, FIELDS = 20, 4
#: Measure of the hardest flights.
PEAK = "impact_peak_acceleration"


@dataclass(frozen=True)
class FailureList:
    """Hardest flights without success, hardest of all, and kept ones.

    Rows have flight, robot, outcome, success, the largest acceleration (`PEAK`), the values of
    fields, whether the trajectory is kept, and ``in_doubt``, whether a contact may have reached the
    other side of a thin obstacle.  Those of larger peaks are first, those without the measure last.
    """

    campaign: Campaign
    failed: int
    """Number of flights that were flown without success."""
    fields: tuple[str, ...]
    """Columns of fields in the rows."""
    rows: tuple[dict[str, Any], ...]
    """Flights without success."""
    hardest: tuple[dict[str, Any], ...]
    """Flights with and without success."""
    kept: tuple[dict[str, Any], ...]
    """Flights with kept trajectories."""

    def command(self, flight: int) -> str:
        """Command that replays a flight."""
        return shlex.join(["springback", "view", str(self.campaign.folder), str(flight)])

    def sentence(self) -> str:
        """Text of one sentence; empty if there is nothing to replay."""
        if self.failed:
            return (
                f"{self.failed} flights without success; replay the one with the largest {PEAK}: "
                f"{self.command(self.rows[0]['flight'])}"
            )
        if self.kept:
            first = self.kept[0]["flight"]
            return f"all flights succeed; replay a kept one: {self.command(first)}"
        return ""

    def as_dict(self) -> dict[str, Any]:
        """Plain data."""
        lists = {"listed": self.rows, "hardest": self.hardest, "kept": self.kept}
        return {"failed": self.failed} | {
            name: [row | {"replay": self.command(row["flight"])} for row in rows]
            for name, rows in lists.items()
        }


def failures(campaign: Campaign, most: int = MOST) -> FailureList:
    """Flights without success, the hardest and kept ones.

    Args:
        campaign: Any.
        most: Largest number of flights of each list.
    """
    stored = campaign.stored_flights()
    fields = tuple(one.column for one in campaign.design.dimensions if not one.scatter)[:FIELDS]
    listed = ", ".join(["flight", "robot", "outcome", "success", PEAK, *map(identifier, fields)])
    is_kept = f"flight IN ({', '.join(map(str, stored or [-1]))})"
    doubt = in_doubt(campaign, thin_flights(campaign))

    def rows(condition: str) -> tuple[dict[str, Any], ...]:
        sql = f"""SELECT {listed}, {is_kept} AS kept, {doubt} AS in_doubt FROM flights
                  WHERE outcome <> 'refused' AND {condition}
                  ORDER BY {PEAK} DESC NULLS LAST, flight LIMIT {int(most)}"""
        return tuple(campaign.query(sql).as_dicts())

    [(failed,)] = campaign.query("SELECT count(*) FROM flights WHERE success = 0").rows
    return FailureList(
        campaign, int(failed), fields, rows("success = 0"), rows("true"), rows(is_kept)
    )

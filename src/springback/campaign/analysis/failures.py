"""Flights of a campaign that did not succeed or were kept, to be replayed one by one."""

from __future__ import annotations

import shlex
from dataclasses import dataclass
from typing import Any

from springback.campaign.access import Campaign
from springback.results.database import identifier

#: Most flights that are listed, and most fields that describe each (chosen).
MOST, FIELDS = 20, 4


@dataclass(frozen=True)
class FailureList:
    """First flights without success, those with kept trajectories before others."""

    campaign: Campaign
    failed: int
    """Number of flights that were flown without success."""
    fields: tuple[str, ...]
    """Columns of fields in `rows`."""
    rows: tuple[dict[str, Any], ...]
    """Flight, robot, outcome, success, kept, and the values of fields."""

    def command(self, flight: int) -> str:
        """Command that replays a flight."""
        return shlex.join(["springback", "view", str(self.campaign.folder), str(flight)])

    def sentence(self) -> str:
        """Text of one sentence; empty if there is nothing to replay."""
        if not self.rows:
            return ""
        first = self.rows[0]["flight"]
        if not self.failed:
            return f"all flights succeed; replay a kept one: {self.command(first)}"
        return f"{self.failed} flights without success; replay one: {self.command(first)}"

    def as_dict(self) -> dict[str, Any]:
        """Plain data."""
        return {
            "failed": self.failed,
            "listed": [row | {"replay": self.command(row["flight"])} for row in self.rows],
        }


def failures(campaign: Campaign, most: int = MOST) -> FailureList:
    """Flights without success and kept ones.

    Args:
        campaign: Any.
        most: Largest number of flights listed.
    """
    kept = campaign.stored_flights()
    fields = tuple(one.column for one in campaign.design.dimensions if not one.scatter)[:FIELDS]
    listed = ", ".join(["flight", "robot", "outcome", "success", *map(identifier, fields)])
    is_kept = f"flight IN ({', '.join(map(str, kept or [-1]))})"
    sql = f"""SELECT {listed} FROM flights WHERE outcome <> 'refused' AND (success = 0 OR {is_kept})
              ORDER BY {is_kept} DESC, flight LIMIT {int(most)}"""
    rows = campaign.query(sql).as_dicts()
    [(failed,)] = campaign.query("SELECT count(*) FROM flights WHERE success = 0").rows
    return FailureList(
        campaign, int(failed), fields, tuple(row | {"kept": row["flight"] in kept} for row in rows)
    )

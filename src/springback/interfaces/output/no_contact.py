"""A line on flights that touch nothing, where there is something to touch: what to change."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from springback.campaign.access import Campaign
    from springback.results.flight import Flight

_LONGER = "or fly longer (simulation.duration)"
_TO_CHANGE = {
    True: f"let the reference lead to an obstacle, start nearer to it (start.position), {_LONGER}",
    False: "start nearer to an obstacle (start.position) and towards it (start.velocity), "
    f"{_LONGER}; start.touch_distance = 0 begins at the first touch",
}
"""By whether a pilot flies."""


def untouched_flight(flight: Flight, own: bool = False) -> str:
    """Line on a flight that touches nothing; empty for others.

    Args:
        flight: Any.
        own: True if a pilot flew it that the scenario does not name.
    """
    s = flight.scenario
    if flight.outcome.word != "no_contact" or not _can_touch(s.model_dump(include=_ASKED)):
        return ""
    piloted = own or s.reference is not None or s.pilot is not None
    return f"nothing was touched (no_contact): {_TO_CHANGE[piloted]}"


def untouched_line(campaign: Campaign) -> str:
    """Line on a campaign most of whose flights touch nothing; empty for others.

    It is empty, too, where the plan's own rule makes a success of that.
    """
    sql = """SELECT count(*) FILTER (outcome = 'no_contact'), count(*),
             coalesce(sum(success) FILTER (outcome = 'no_contact'), 0)
             FROM flights WHERE outcome <> 'refused'"""
    [(untouched, flown, won)] = campaign.query(sql).rows
    design = campaign.design
    is_wanted = design.plan.success is not None and 2 * won > untouched
    if 2 * untouched <= flown or is_wanted or not any(map(_can_touch, design.bases)):
        return ""
    piloted = any(base.get("reference") or base.get("pilot") for base in design.bases)
    return (
        f"{untouched} of {flown} flights touched nothing (no_contact): {_TO_CHANGE[bool(piloted)]}"
    )


#: Tables of a scenario that say what there is to touch.
_ASKED = {"world", "second"}


def _can_touch(tables: Mapping[str, Any]) -> bool:
    """True if there is something to touch besides the ground."""
    world = tables.get("world")
    entries = world.get("obstacles") if isinstance(world, Mapping) else None
    listed = entries if isinstance(entries, list | tuple) else ()
    kinds = [entry.get("type") for entry in listed if isinstance(entry, Mapping)]
    return tables.get("second") is not None or any(kind != "ground" for kind in kinds)

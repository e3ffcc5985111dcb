"""Flights of a campaign that came deeper than forces on the thin obstacle that they met hold."""

from __future__ import annotations

import shlex
from typing import Any, NamedTuple

from springback.campaign.access import Campaign
from springback.campaign.design.layout import Design
from springback.campaign.design.success import word_literal
from springback.contact.thin_obstacles import PIERCED, ThinObstacle, thin_obstacles
from springback.errors import InputError
from springback.results.database import identifier
from springback.scenario.scenario import scenario_from
from springback.scenario.worlds.imported import (
    Imported,
    named_obstacles,
    obstacle_words,
    part_words,
)

#: Columns by which flights are told; campaigns of earlier versions lack the first.
FIRST, DEPTH = "first_obstacle", "penetration"


class ThinFlights(NamedTuple):
    """Flights whose contacts may have reached the other side of an obstacle."""

    obstacle: ThinObstacle
    first: str
    """Obstacle that they touched first, as in the rows; empty if that is not known."""
    flights: int
    deepest: float
    """Largest depth of them in anything [m]."""
    condition: str
    """Condition in words that they meet."""

    def as_dict(self) -> dict[str, Any]:
        """Plain data."""
        return {
            "obstacle": self.obstacle.name, "first": self.first or None,
            "depth": self.obstacle.depth, "flights": self.flights, "deepest": self.deepest,
            "condition": self.condition,
        }  # fmt: skip


def _first_names(obstacles: Any) -> list[str]:
    """Names of obstacles as in the rows, those of imported worlds one by one."""
    found = []
    for k, entry in enumerate(obstacles):
        if isinstance(entry, Imported):
            found += [part_words(k, entry, part) for part in entry.parts]
        else:
            found.append(obstacle_words(k, entry))
    return found


#: Thin obstacles of the latest designs, by identity: forms of meshes take a while.
_LATEST: list[tuple[Design, tuple[dict[str, ThinObstacle], int]]] = []


def _thin_of(design: Design) -> tuple[dict[str, ThinObstacle], int]:
    """Thin obstacles of a design by their names in the rows, and the number of all obstacles.

    Where fields of obstacles vary, those of the scenario count; of several scenarios the thinnest.
    """
    for design_of, known_of in _LATEST:
        if design_of is design:
            return known_of
    found, every = dict[str, ThinObstacle](), set[str]()
    for base in design.bases:
        try:
            obstacles = scenario_from(base).world.obstacles
        except InputError:  # fields of the plan complete it
            continue
        names = _first_names(obstacles)
        every.update(names)
        every.update(["another"] if base.get("second") is not None else [])
        for name, of_name in zip(names, named_obstacles(obstacles), strict=True):
            for one in thin_obstacles([of_name]):
                known = found.setdefault(name, one)
                found[name] = min(known, one, key=lambda each: each.depth)
    _LATEST.insert(0, (design, (found, len(every))))
    del _LATEST[4:]
    return found, len(every)


def thin_flights(campaign: Campaign) -> list[ThinFlights]:
    """Flights that came deeper than forces on a thin obstacle hold, those of most flights first.

    A flight counts for the obstacle that it touched first, which is known; it may have come so deep
    into what it met later.  A campaign with one obstacle, or of a version whose rows do not name
    the first, has one entry: flights that came deeper than its thinnest obstacle allows, into
    anything.

    Args:
        campaign: Any.
    """
    thin, obstacles = _thin_of(campaign.design)
    if not thin:
        return []
    named = obstacles > 1 and FIRST in campaign.query("FROM flights LIMIT 0").columns
    if not named:
        thin = {"": min(thin.values(), key=lambda one: one.depth)}
    found = []
    for first, one in thin.items():
        condition = f"{DEPTH} > {1e3 * PIERCED * one.depth:.4g} mm"
        if first:
            condition = f"{FIRST} = {word_literal(first)} and {condition}"
        met = campaign.design.condition(condition)
        counted = f"SELECT count(*), max({DEPTH}) FROM flights WHERE {met}"
        [(count, deepest)] = campaign.query(counted).rows
        if count:
            found.append(ThinFlights(one, first, int(count), float(deepest), condition))
    return sorted(found, key=lambda one: -one.flights)


def without_command(campaign: Campaign, found: list[ThinFlights]) -> str:
    """Command that sums up a campaign without some flights.

    Args:
        campaign: Any.
        found: Those to leave out.
    """
    return summary_command(campaign, *(f"not ({one.condition})" for one in found))


def summary_command(campaign: Campaign, *more: str) -> str:
    """Command that sums up a campaign under more conditions.

    Args:
        campaign: Any.
        *more: Conditions in words, besides those that it has.
    """
    conditions = [*campaign.conditions, *more]
    words = " ".join(f"--where {_typed(text)}" for text in conditions)
    return f"springback summary {shlex.quote(str(campaign.folder))} {words}"


def _typed(text: str) -> str:
    """A condition as an argument of a shell, in double quotes if that does."""
    return shlex.quote(text) if set(text) & set('"$`\\!') else f'"{text}"'


def in_doubt(campaign: Campaign, found: list[ThinFlights]) -> str:
    """SQL of what flights meet that are not to be trusted; ``false`` without any.

    Args:
        campaign: Any.
        found: As of `thin_flights`.
    """
    return " OR ".join(f"({campaign.design.condition(one.condition)})" for one in found) or "false"


def largest_in_doubt(campaign: Campaign, name: str) -> dict[str, int]:
    """Robots whose largest value of a measure is of a flight not to be trusted, with its number.

    Args:
        campaign: Any.
        name: Name of the measure's column.
    """
    found = thin_flights(campaign)
    if not found:
        return {}
    largest = f"PARTITION BY robot ORDER BY {identifier(name)} DESC, flight"
    sql = f"""SELECT robot, flight, {in_doubt(campaign, found)} FROM flights
              WHERE {identifier(name)} IS NOT NULL AND outcome <> 'refused'
              QUALIFY row_number() OVER ({largest}) = 1 ORDER BY robot"""
    return {robot: int(flight) for robot, flight, is_so in campaign.query(sql).rows if is_so}

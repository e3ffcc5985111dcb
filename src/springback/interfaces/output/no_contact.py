"""Lines on flights that touch nothing, end in contact, or go through: what to change."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from springback.campaign.analysis.statistics import UNTOUCHED
from springback.campaign.analysis.thin_flights import (
    ThinFlights,
    largest_in_doubt,
    summary_command,
    thin_flights,
    without_command,
)
from springback.campaign.analysis.worst_case import WorstCase, WorstCaseMap
from springback.errors import InputError

if TYPE_CHECKING:
    from springback.campaign.access import Campaign
    from springback.campaign.analysis.statistics import RobotSummary, Summary
    from springback.results.flight import Flight

_LONGER = "or fly longer (simulation.duration)"
_TO_CHANGE = {
    True: f"let the reference lead to an obstacle, start nearer to it (start.position), {_LONGER}",
    False: "start nearer to an obstacle (start.position) and towards it (start.velocity), "
    f"{_LONGER}; start.touch_distance = 0 begins at the first touch",
}
"""By whether a pilot flies."""
_WAYS = {
    "constant": ("velocity", "turning"), "sine": ("amplitude", "swing"),
    "table": ("position", "angle"), "free": ("velocity", "angular_velocity"),
    "pendulum": ("angular_velocity",), "hinge": ("turning",),
}  # fmt: skip
"""What decides where an obstacle moves to, by the type of its motion."""
#: Most instants of a flight, times obstacles, at which distances are asked for (chosen: 1 s).
MOST_ASKED = 400_000
#: Most thin obstacles of a campaign that have a line each (chosen).
MOST_TOLD = 3


class NearestApproach(NamedTuple):
    """The smallest distance between a vehicle and obstacles during a flight."""

    obstacle: int
    """Its index in the scenario."""
    distance: float
    """Negative in penetration [m]."""
    time: float
    """[s]."""
    is_last: bool
    """True if it is that at the end of the flight: they are still coming nearer."""


def nearest_approach(flight: Flight, among: Iterable[int]) -> NearestApproach | None:
    """The smallest distance of a flight's cages and hull from obstacles.

    Args:
        flight: Any.
        among: Indices of built-in obstacles; those of the user's own count as unknown.

    Returns:
        None if it is unknown: the flight has no trajectory, or too much is asked for.
    """
    asked = list(among)
    if not 0 < len(asked) * len(flight.t) <= MOST_ASKED:
        return None
    kinds = [entry.type for entry in flight.scenario.world.obstacles]
    found = []
    for k in asked:
        if kinds[k] == "own":
            return None
        try:
            gaps = flight.gap(k - kinds[:k].count("own")).min(axis=1)
        except InputError:  # it was flown without a trajectory
            return None
        at = int(gaps.argmin())
        found.append(NearestApproach(k, float(gaps[at]), float(flight.t[at]), at == len(gaps) - 1))
    return min(found, key=lambda one: one.distance)


def untouched_flight(flight: Flight, own: bool = False) -> str:
    """Line on a flight that touches nothing; empty for others.

    Args:
        flight: Any.
        own: True if a pilot flew it that the scenario does not name.
    """
    s = flight.scenario
    if flight.outcome.word != "no_contact" or not _can_touch(s.model_dump(include=_ASKED)):
        return ""
    entries = s.world.obstacles
    solid = [k for k, entry in enumerate(entries) if entry.type != "ground"]
    near = nearest_approach(flight, solid)
    said, advice = "", _TO_CHANGE[own or s.reference is not None or s.pilot is not None]
    if near is not None:
        name = entries[near.obstacle].name
        called = f", {name}," if name else ""
        said = (
            f"world.obstacles[{near.obstacle}]{called} was nearest, {near.distance:.3g} m away at "
            f"{near.time:.3g} s{', the end' if near.is_last else ''}; "
        )
        if getattr(entries[near.obstacle], "motion", None) is not None:
            advice = _to_move(near.obstacle, entries[near.obstacle], near.is_last)
    return f"nothing was touched (no_contact): {said}{advice}"


def _to_move(number: int, entry: Any, comes_nearer: bool) -> str:
    """What to change for an obstacle that moves to meet the vehicle."""
    path, motion = f"world.obstacles[{number}]", entry.motion
    given = [key for key in ("distance", "position") if getattr(entry, key, None) is not None]
    keys = given[:1] or ["start", "end"]  # of a capsule
    start = f"where it starts ({_paths(path, keys)})"
    fields = type(motion).model_fields
    moved = [key for key in _WAYS[motion.type] if getattr(motion, key) != fields[key].default]
    way = f"how it moves ({_paths(f'{path}.motion', moved)})" if moved else ""
    if comes_nearer:
        return f"fly longer (simulation.duration), or change {start}{' or ' if way else ''}{way}"
    own = "where the vehicle is (start.position)"
    return f"change {start}{', ' if way else ''}{way} or {own}, {_LONGER}"


def _paths(table: str, keys: Iterable[str]) -> str:
    return ", ".join(f"{table}.{key}" for key in keys)


def idle_suction(flight: Flight) -> str:
    """Line on a flight whose rotors no wall can have drawn, though walls were to; else empty.

    Only what is known for certain is said: the distance of a disc's middle from an obstacle is at
    least that of the vehicle, less the disc's height and the radius of the cage around it.
    """
    vehicle, s = flight.scenario.vehicle, flight.scenario
    effects = () if vehicle.propulsion is None else vehicle.propulsion.effect()
    if not effects or not effects[0].suction > 0.0 or s.second is not None or vehicle.rotors:
        return ""
    [effect] = effects
    solid = [k for k, entry in enumerate(s.world.obstacles) if entry.type != "ground"]
    near = nearest_approach(flight, solid)
    arms = range(len(vehicle.arms.directions))
    inside = max((vehicle.arms.at("cage_radius", k) for k in arms), default=math.inf)
    if near is None or near.distance - abs(effect.height) - inside <= effect.reach:
        return ""
    return (
        f"vehicle.propulsion.surface_effect.wall_suction did nothing: it reaches "
        f"{effect.reach:.3g} m (wall_reach), and world.obstacles[{near.obstacle}], the nearest but "
        f"for the ground, came no nearer than {near.distance:.3g} m"
    )


def untouched_line(campaign: Campaign) -> str:
    """Line on a campaign most of whose flights touch nothing; empty for others.

    It is empty, too, where the plan's own rule makes a success of that.
    """
    sql = "SELECT count(*) FILTER (outcome = 'no_contact'), count(*) FROM flights"
    [(untouched, flown)] = campaign.query(f"{sql} WHERE outcome <> 'refused'").rows
    if 2 * untouched <= flown or not _is_to_touch(campaign):
        return ""
    design = campaign.design
    piloted = any(base.get("reference") or base.get("pilot") for base in design.bases)
    return (
        f"{untouched} of {flown} flights touched nothing (no_contact): {_TO_CHANGE[bool(piloted)]}"
    )


def _is_to_touch(campaign: Campaign) -> bool:
    """True if there is something to touch, and the plan's own rule wants no flight to miss it."""
    sql = "SELECT count(*), coalesce(sum(success), 0) FROM flights WHERE outcome = 'no_contact'"
    [(untouched, won)] = campaign.query(sql).rows
    design = campaign.design
    is_wanted = design.plan.success is not None and 2 * won > untouched
    return not is_wanted and any(map(_can_touch, design.bases))


def has_misses(found: Summary) -> bool:
    """True if some flights of a campaign touch nothing, and others touch what is there."""
    missed = any(one.misses for one in found.robots)
    return missed and any(one.touches for one in found.robots) and _is_to_touch(found.campaign)


def missed_lines(found: Summary) -> list[str]:
    """Lines on flights that touch nothing but count in the share of successes.

    One for each robot that has such flights, and one on how to leave them out; see `has_misses`.
    """
    if not has_misses(found):
        return []
    lines = [_missed(one) for one in found.robots if one.misses]
    command = summary_command(found.campaign, f"not {UNTOUCHED}")
    return [*lines, f"shares, maps and indices of those that touch alone: {command}"]


def _missed(one: RobotSummary) -> str:
    """Line on a robot's flights that touch nothing, and how they count."""
    flown, won_misses = one.flights - one.refused, one.successes - one.touch_successes
    counted = (
        "none of which is a success" if not won_misses
        else "all of them successes by the rule" if won_misses == one.misses
        else f"{won_misses} of them successes by the rule"
    )  # fmt: skip
    said = f"{one.robot}: {one.misses} of {flown} flights touched nothing (no_contact), {counted}"
    if not one.touches:
        return said
    return f"{said}; of the {one.touches} that touched something, {one.touch_successes} succeed"


def pressing_line(campaign: Campaign) -> str:
    """Line on flights that end in contact and are successes by the usual rule; else empty."""
    if campaign.design.plan.success is not None:
        return ""
    sql = """SELECT count(*) FILTER (outcome = 'in_contact'), count(*)
             FROM flights WHERE success = 1"""
    [(pressing, won)] = campaign.query(sql).rows
    if not pressing:
        return ""
    return (
        f"{pressing} of {won} successes ended in contact with an obstacle (in_contact), which the "
        'usual rule allows; success = ["separated or no_contact"] leaves them out'
    )


def pierced_lines(campaign: Campaign) -> list[str]:
    """Lines on flights whose contacts may have reached the other side of an obstacle.

    The last is the command that leaves them out, after a colon; there is none without such flights.
    """
    found = thin_flights(campaign)
    if not found:
        return []
    lines = [_pierced(one) for one in found[:MOST_TOLD]]
    if more := found[MOST_TOLD:]:
        count = sum(one.flights for one in more)
        lines.append(
            f"{count} more flights came deeper into the thin obstacle that they touched first, one "
            f"of {len(more)} others, than forces on it are valid"
        )
    if found[0].first:
        lines[-1] += "; flights that met a thin obstacle after another one are not counted"
    return [*lines, f"without these flights: {without_command(campaign, found)}"]


def doubt_lines(campaign: Campaign, name: str) -> list[str]:
    """Lines on a measure whose largest value is of a flight not to be trusted.

    Args:
        campaign: Any.
        name: Name of the measure's column.
    """
    return [
        f"the largest {name} of {robot} is not to be trusted: flight {flight} came deeper "
        "into the thin obstacle that it met first than forces on it are valid"
        for robot, flight in largest_in_doubt(campaign, name).items()
    ]


def worst_doubt_lines(campaign: Campaign, found: WorstCase | WorstCaseMap) -> list[str]:
    """Lines on worst values that are of flights not to be trusted; see `doubt_lines`."""
    whole = found if isinstance(found, WorstCase) else found.whole
    measures = {one.measure.name for one in whole.limits if one.measure and not one.least}
    return [line for name in sorted(measures) for line in doubt_lines(campaign, name)]


def _pierced(one: ThinFlights) -> str:
    """Sentence on flights that came too deep."""
    flights = "1 flight" if one.flights == 1 else f"{one.flights} flights"
    deep, known = f"{1e3 * one.deepest:.3g} mm deep", one.obstacle.sentence
    if not one.first:
        return (
            f"{flights} came up to {deep}, and {known}; those that touched it are "
            f"not to be trusted ({one.condition})"
        )
    return (
        f"{flights} whose first obstacle was {one.first}, came up to {deep}, and {known}; those "
        f"that came so deep into it are not to be trusted ({one.condition.rpartition(' and ')[2]})"
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

"""Columns of a campaign's rows: names, units and meanings."""

from __future__ import annotations

from springback.results.recovery_measures import RECOVERY_MEASURES
from springback.results.saved import SECOND
from springback.simulation.measuring.measures import MEASURES

#: Unit and meaning of the columns of every flight.
FLIGHT = {
    "flight": ("", "number of the flight, from 0"),
    "sample": ("", "number of the point of the design"),
    "repeat": ("", "number of the flight within the sample"),
    "robot": ("", "name of the vehicle and, if the plan has several, of the pilot"),
    "seed": ("", "seed of the noise"),
}
RESULT = {
    "outcome": ("", "how the flight ended; refused: it could not be flown"),
    "success": ("", "as the plan has it; empty for refused flights"),
    "problem": ("", "why a flight was refused"),
    "first_obstacle": ("", "what was touched first, such as world.obstacles[0], a pole; or empty"),
}


#: Unit and meaning of the outcome of a second vehicle.
SECOND_OUTCOME = {SECOND + "outcome": ("", "how the flight of the second vehicle ended")}


def measured_columns(*, second: bool) -> dict[str, tuple[str, str]]:
    """Unit and meaning of the measures of a flight.

    Args:
        second: True if there are those of a second vehicle, too.
    """
    found = {**MEASURES, **RECOVERY_MEASURES}
    more = {
        SECOND + name: (unit, f"of the second vehicle: {about}")
        for name, (unit, about) in found.items()
    }
    return {**found, **more} if second else found


def known_columns(*, second: bool = True) -> dict[str, tuple[str, str]]:
    """Unit and meaning of the columns of all campaigns.

    Args:
        second: True for those of campaigns of two vehicles, too.
    """
    outcome = SECOND_OUTCOME if second else {}
    return {**FLIGHT, **RESULT, **outcome, **measured_columns(second=second)}

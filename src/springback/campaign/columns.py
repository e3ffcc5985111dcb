"""Columns of a campaign's rows: names, units and meanings."""

from __future__ import annotations

from springback.results.recovery_measures import RECOVERY_MEASURES
from springback.simulation.measures import MEASURES

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
}


def known_columns() -> dict[str, tuple[str, str]]:
    """Unit and meaning of the columns of all campaigns."""
    return {**FLIGHT, **RESULT, **MEASURES, **RECOVERY_MEASURES}

"""Columns of a campaign's rows: names, units, meanings."""

from __future__ import annotations

from springback.results.recovery_measures import RECOVERY_MEASURES
from springback.simulation.measures import MEASURES

#: Of every flight: unit and meaning.
FLIGHT = {
    "flight": ("", "number of the flight, from 0"),
    "sample": ("", "which point of the design"),
    "repeat": ("", "which flight of the sample"),
    "robot": ("", "preset of the vehicle"),
    "seed": ("", "of the noise"),
}
RESULT = {
    "outcome": ("", "how the flight ended; refused: it could not be flown"),
    "success": ("", "as the plan has it; empty for refused flights"),
    "problem": ("", "why a flight was refused"),
}


def known_columns() -> dict[str, tuple[str, str]]:
    """Unit and meaning of all columns that every campaign has."""
    return {**FLIGHT, **RESULT, **MEASURES, **RECOVERY_MEASURES}

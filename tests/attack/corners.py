"""Corners of a scenario: each of its numbers at zero, a thousand times larger, and the largest that is read."""

from __future__ import annotations

import math
import warnings
from typing import Any

from attack.inputs import WHOLE, check_lines, paths_of, put, value_at
from springback.errors import FlightWarning, InputError
from springback.results.flight import fly
from springback.simulation.measuring.measures import Outcome

#: An impact at once.
IMPACT = put(
    put(WHOLE[0], ("simulation", "duration"), 0.02), ("start", "position"), [2.44, 0.0, 1.0]
)
#: A run-up with a recovering pilot, for some ticks.
PILOTED = put(WHOLE[3], ("simulation", "duration"), 0.02)
Corner = tuple[tuple[str | int, ...], float]


def corners(tables: dict[str, Any]) -> list[Corner]:
    """Every number of a scenario with every value that is tried."""
    found: list[Corner] = []
    for path in paths_of(tables):
        number = value_at(tables, path)
        if type(number) in (int, float):
            found += [(path, value) for value in (0 * number, 1000 * (number or 1), 1e30)]
    return found


def is_flown(tables: dict[str, Any], corner: Corner) -> bool:
    """Whether a corner is accepted; its flight has an end with finite measures.

    Raises:
        AssertionError: If it has not, or is refused in words that cannot be understood.
    """
    try:
        with warnings.catch_warnings():  # that a flight is not to be trusted is well said
            warnings.simplefilter("ignore", FlightWarning)
            flight = fly(put(tables, *corner), trajectory=False)
    except InputError as error:
        check_lines(error)
        return False
    known = {name: value for name, value in flight.measures.items() if value is not None}
    if flight.outcome is not Outcome.NOT_FINITE:
        assert all(map(math.isfinite, known.values())), (corner, known)
    return True

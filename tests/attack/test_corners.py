"""The corners of every setting: each number that is accepted makes a flight with an end.

Numbers of a scenario that is written out are set to zero, made a thousand times larger, and set to
the largest that is read, one at a time.
"""

from __future__ import annotations

import math
import warnings
from typing import Any

from attack.inputs import WHOLE, check_lines, paths_of, put, scenario_tables, timed, value_at
from springback.errors import InputError, LedgerWarning
from springback.experiments.result import fly
from springback.simulation.measures import Outcome

#: An impact at once, and a pilot aboard.
IMPACT = put(
    put(WHOLE[0], ("simulation", "duration"), 0.02), ("start", "position"), [2.44, 0.0, 1.0]
)
PILOTED = WHOLE[1]
Corner = tuple[tuple[str | int, ...], float]


def corners(tables: dict[str, Any]) -> list[Corner]:
    """Every number of a scenario with every value that is tried."""
    found: list[Corner] = []
    for path in paths_of(tables):
        number = value_at(tables, path)
        if type(number) in (int, float):
            found += [(path, value) for value in (0 * number, 1000 * (number or 1), 1e30)]
    return found


def test_every_corner_is_flown_or_refused() -> None:
    """Refused in lines, or flown to an end with finite measures."""
    flown, refused = 0, 0
    for path, value in corners(IMPACT):
        try:
            with (
                warnings.catch_warnings()
            ):  # a flight that says that it is not to be trusted is fine
                warnings.simplefilter("ignore", LedgerWarning)
                flight = fly(put(IMPACT, path, value), trajectory=False)
        except InputError as error:
            check_lines(error)
            refused += 1
            continue
        flown += 1
        if flight.outcome is not Outcome.NOT_FINITE:
            known = {k: v for k, v in flight.measures.items() if v is not None}
            assert all(math.isfinite(v) for v in known.values()), (path, value, known)
    assert flown > 100
    assert refused > 100


def test_every_corner_is_made_ready_or_refused() -> None:
    """With a pilot: sensors, estimator and controllers are set up in plain Python."""
    accepted = [timed(scenario_tables, put(PILOTED, *corner)) for corner in corners(PILOTED)]
    assert 100 < sum(accepted) < len(accepted) - 100

"""The corners of every setting, flown: each number that is accepted makes a flight with an end.

Numbers of a scenario that is written out are set to zero, made a thousand times larger, and set to
the largest that is read, one at a time.
"""

from __future__ import annotations

import math
from typing import Any

import pytest

from attacks.inputs import WHOLE, check_lines, paths_of, put, value_at
from springback.errors import InputError
from springback.experiments.result import fly
from springback.simulation.measures import Outcome

#: An impact at once, and a pilot aboard; short, for there are some hundreds of each.
BASES: dict[str, dict[str, Any]] = {
    "impact": put(
        put(WHOLE[0], ("simulation", "duration"), 0.02), ("start", "position"), [2.44, 0.0, 1.0]
    ),
    "piloted": put(WHOLE[1], ("simulation", "duration"), 0.03),
}
#: In proportion to the number, or to 1 where it is 0.
FACTORS = (0.0, 1e3)
ENDS = (1e30,)
#: Exchanged for what would only make the test slow.
SLOW = {("simulation", "duration"), ("clock",)}


def corners(tables: dict[str, Any]) -> list[tuple[tuple[str | int, ...], float]]:
    """Every number of a scenario with every value that is tried."""
    found = []
    for path in paths_of(tables):
        number = value_at(tables, path)
        if type(number) not in (int, float) or path in SLOW or path[0] in ("seed",):
            continue
        if path[:2] == ("vehicle", "body") and len(path) > 3 and path[3] != path[-1]:
            continue
        tried = [(number or 1.0) * factor for factor in FACTORS] + list(ENDS)
        found += [
            (path, type(number)(value) if type(number) is int and abs(value) < 1e9 else value)
            for value in tried
        ]
    return found


@pytest.mark.parametrize("name", BASES)
def test_every_corner_is_flown_or_refused(name: str) -> None:
    """Refused in a line that names the field, or flown to an end with finite measures."""
    flown, refused = 0, 0
    for path, value in corners(BASES[name]):
        at = f"{'.'.join(map(str, path))} = {value!r}"
        try:
            flight = fly(put(BASES[name], path, value), trajectory=False)
        except InputError as error:
            check_lines(error)
            refused += 1
            continue
        flown += 1
        if flight.outcome is Outcome.NOT_FINITE:
            continue
        wrong = [k for k, v in flight.measures.items() if v is not None and not math.isfinite(v)]
        assert not wrong, f"{at}: {wrong}"
    assert flown > 100
    assert refused > 100

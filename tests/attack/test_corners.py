"""The corners of every setting: each number that is accepted makes a flight with an end.

Numbers of a scenario that is written out are set to zero, made a thousand times larger, and set to
the largest that is read, one at a time.
"""

from __future__ import annotations

import pytest

from attack.corners import IMPACT, PILOTED, corners, is_flown


@pytest.mark.parametrize("base", ["impact", "piloted"])
def test_every_corner_is_flown_or_refused(base: str) -> None:
    """With a pilot each number has one of its three corners; `make attack` flies all."""
    tables = {"impact": IMPACT, "piloted": PILOTED}[base]
    tried = corners(tables)
    if base == "piloted":
        tried = [corner for k, corner in enumerate(tried) if k % 3 == k // 3 % 3]
    flown = [is_flown(tables, corner) for corner in tried]
    assert len(tried) / 4 < sum(flown) < len(tried) * 3 / 4

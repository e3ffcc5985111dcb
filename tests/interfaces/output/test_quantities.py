"""Quantities for people: prefixes, and the digits of an interval."""

from __future__ import annotations

import math

import pytest

from springback.interfaces.output.quantities import (
    display_unit,
    estimate_text,
    interval_text,
    quantity_text,
)
from springback.intervals import IntervalEstimate


@pytest.mark.parametrize(
    ("unit", "largest", "symbol", "factor"),
    [
        ("m", 0.0097, "mm", 1e3), ("m", 0.35, "m", 1.0), ("m", 2e-5, "µm", 1e6),
        ("s", -0.03, "ms", 1e3), ("N", 2e4, "kN", 1e-3), ("N", 200.0, "N", 1.0),
        ("m/s^2", 0.01, "m/s²", 1.0), ("", 0.01, "-", 1.0), ("rad", 0.01, "deg", math.degrees(1.0)),
        ("m", 0.0, "m", 1.0), ("m", math.nan, "m", 1.0),
    ],
)  # fmt: skip
def test_units_have_the_prefix_of_their_values(
    unit: str, largest: float, symbol: str, factor: float
) -> None:
    assert display_unit(unit, [None, 0.0, largest]) == (symbol, pytest.approx(factor))


@pytest.mark.parametrize(
    ("low", "value", "high", "interval", "estimate"),
    [
        (8.796, 9.2, 9.718, "8.8 to 9.7", "9.2"),
        (214.5, 226.7, 239.1, "214 to 239", "227"),
        (2.12, 2.183, 2.249, "2.12 to 2.25", "2.18"),
        (None, 1234.56, None, "-", "1230"),
        (8.796, 9.2, None, "from 8.80", "9.20"),
        (None, 9.2, 9.718, "up to 9.72", "9.20"),
        (0.0, 0.0, 0.0, "0 to 0", "0"),
        (-0.04, 0.0, 0.04, "-0.04 to 0.04", "0.00"),
        (1e6, 1.5e6, 2e6, "1000000 to 2000000", "1500000"),
    ],
)
def test_digits_are_those_of_the_interval(
    low: float | None, value: float, high: float | None, interval: str, estimate: str
) -> None:
    found = IntervalEstimate(value, low, high)
    assert (interval_text(found), estimate_text(found)) == (interval, estimate)


def test_numbers_without_an_interval_have_three_digits() -> None:
    shown = [quantity_text(v) for v in (None, 0.0, 237.4, 8.796, 0.04567, 12345.0)]
    assert shown == ["-", "0", "237", "8.80", "0.0457", "12345"]

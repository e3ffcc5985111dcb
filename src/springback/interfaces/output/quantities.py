"""Quantities for people: units with prefixes, and no more digits than an interval allows."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import NamedTuple

from springback.intervals import IntervalEstimate

#: Units that take a prefix, and the prefixes with the largest magnitudes that they serve.
PREFIXED = ("m", "s", "N", "J")
PREFIXES = (("µ", 1e6, 1e-4), ("m", 1e3, 0.1), ("", 1.0, 1e4), ("k", 1e-3, math.inf))
#: Digits of numbers without an interval, and most digits of any (chosen).
USUAL, MOST = 3, 5
#: A width that begins with less than this is worth a second digit (the Particle Data Group's).
SECOND = 3.55


class DisplayUnit(NamedTuple):
    """Unit in which a quantity is shown."""

    symbol: str
    """The unit; - for plain numbers."""
    factor: float
    """From SI to this unit."""


def display_unit(unit: str, values: Iterable[float | None] = ()) -> DisplayUnit:
    """Unit for values of an SI unit: degrees for angles, a prefix for what is small or large.

    Args:
        unit: SI unit.
        values: Values to be shown; without any the unit has no prefix.
    """
    if unit == "rad":
        return DisplayUnit("deg", math.degrees(1.0))
    shown = unit.replace("^2", "²") or "-"
    largest = max((abs(v) for v in values if v is not None and math.isfinite(v)), default=0.0)
    if unit not in PREFIXED or not largest:
        return DisplayUnit(shown, 1.0)
    prefix, factor, _ = next(one for one in PREFIXES if largest < one[2])
    return DisplayUnit(prefix + shown, factor)


def decimals(low: float, high: float) -> int:
    """Decimals of the bounds of an interval: those of one or two digits of its width.

    Args:
        low: Lower bound.
        high: Upper bound.
    """
    width, largest = abs(high - low), max(abs(low), abs(high))
    if not largest:
        return 0
    most = MOST - 1 - _power(largest)
    if not width:
        return USUAL - 1 - _power(largest)
    power = _power(width)
    return min(most, (1 if width / 10.0**power < SECOND else 0) - power)


def _power(value: float) -> int:
    """Power of ten of a number's first digit."""
    return math.floor(math.log10(value)) if value else 0


def number_text(value: float | None, places: int) -> str:
    """Number with decimals, of which a negative number rounds to tens, hundreds and so on."""
    return "-" if value is None else f"{round(value, places) + 0.0:.{max(0, places)}f}"


def quantity_text(value: float | None) -> str:
    """Number of three digits, without an exponent."""
    return number_text(value, 0 if not value else max(0, USUAL - 1 - _power(abs(value))))


def interval_text(found: IntervalEstimate, factor: float = 1.0) -> str:
    """Bounds of an interval, such as ``8.8 to 9.7``; a dash if too few values give it none.

    Args:
        found: The interval, in SI.
        factor: From SI to the unit shown.
    """
    places = _places(found, factor)
    bounds = (None if bound is None else bound * factor for bound in found[1:])
    low, high = (None if bound is None else number_text(bound, places) for bound in bounds)
    if low is None or high is None:
        known = f"from {low}" if low else f"up to {high}" if high else ""
        return known or "-"
    return f"{low} to {high}"


def estimate_text(found: IntervalEstimate, factor: float = 1.0) -> str:
    """The estimate, with the digits of its interval."""
    value = None if found.value is None else found.value * factor
    return number_text(value, _places(found, factor))


def _places(found: IntervalEstimate, factor: float) -> int:
    known = [v * factor for v in found if v is not None]
    if found.low is None or found.high is None:
        return USUAL - 1 - _power(max(map(abs, known), default=0.0))
    return decimals(found.low * factor, found.high * factor)
